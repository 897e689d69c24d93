use super::{Folder, tile};
use exr::prelude::{ReadChannels, ReadLayers};
use serde_json::{Value, json};

#[test]
fn every_ending_gives_its_format_with_the_same_colours() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple -o a.png");
    let png = folder.picture("a.png").into_rgb8();
    for name in ["a.tif", "a.TIFF", "a.webp"] {
        folder.does(&format!("grow a.dapple -o {name}"));
        assert!(folder.picture(name).into_rgb8() == png, "{name}");
    }
    folder.does("grow a.dapple -o a.jpg --quality 95");
    let jpeg = folder.picture("a.jpg").into_rgb8();
    let off: i64 = jpeg.iter().zip(png.iter()).map(|(a, b)| (i64::from(*a) - i64::from(*b)).abs()).sum();
    assert!(off < 3 * jpeg.len() as i64 && folder.bytes("a.jpg")[..2] == [0xff, 0xd8], "{off}");
}

#[test]
fn colours_of_16_bit_are_finer_and_round_to_those_of_8_bit() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple -o a.png");
    folder.does("grow a.dapple -o b.png --depth 16");
    folder.does("grow a.dapple -o b.tif --depth 16");
    let (eight, deep) = (folder.picture("a.png").into_rgb8(), folder.picture("b.png"));
    assert_eq!(deep.color(), image::ColorType::Rgb16);
    assert!(folder.picture("b.tif") == deep);
    let deep = deep.into_rgb16();
    assert!(deep.iter().zip(eight.iter()).all(|(a, b)| (f64::from(*a) / 257.0 - f64::from(*b)).abs() < 0.51));
    assert!(deep.iter().any(|value| value % 257 != 0));
}

#[test]
fn a_transparent_picture_over_its_ground_looks_the_same() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple -o a.png");
    for name in ["t.png", "t.webp", "t.tif"] {
        folder.does(&format!("grow a.dapple -o {name} --transparent"));
        let through = folder.picture(name).into_rgba8();
        for (seen, px) in folder.picture("a.png").into_rgb8().pixels().zip(through.pixels()) {
            let [red, _, _, opacity] = px.0.map(f64::from);
            let over = (opacity * red + (255.0 - opacity) * 255.0) / 255.0;
            assert!((over - f64::from(seen.0[0])).abs() < 1.5, "{name}: {px:?} {seen:?}");
            // Black marks on white have no gray rim.
            assert!(red < 1.0, "{name}: {px:?}");
        }
        let opacity = |least: bool| {
            through
                .pixels()
                .map(|px| px.0[3])
                .fold(u8::from(least) * 255, |a, b| if least { a.min(b) } else { a.max(b) })
        };
        assert!(opacity(true) < 60 && opacity(false) > 250);
    }
    folder.refuses(
        "grow a.dapple -o x.jpg --transparent",
        1,
        &["x.jpg", "JPEG", "transparent", ".png, .tif"],
    );
    folder.refuses("grow a.dapple -o x.webp --depth 16", 1, &["WebP", "16-bit", ".png, .tif"]);
}

/// A document whose only layer is half-transparent red on the ground and opaque blue in the marks.
fn see_through() -> Folder {
    let mut document = tile();
    document["layers"][0]["colours"] = json!({"stops": [
        {"at": 0.5, "colour": "#ff000080"}, {"at": 0.5, "colour": "#0000ff"}]});
    Folder::with(&document)
}

#[test]
fn the_opacity_of_stops_is_written_where_the_format_can_hold_it() {
    let folder = see_through();
    for name in ["a.png", "a.tif", "a.webp"] {
        folder.does(&format!("grow a.dapple -o {name}"));
        let picture = folder.picture(name);
        assert!(picture.color().has_alpha(), "{name}");
        let picture = picture.into_rgba8();
        let count = |colour: [u8; 4]| picture.pixels().filter(|px| px.0 == colour).count();
        let (ground, marks) = (count([255, 0, 0, 128]), count([0, 0, 255, 255]));
        assert_eq!(ground + marks, 120 * 96, "{name}");
        assert!(ground > 1000 && marks > 1000, "{name}: {ground} {marks}");
    }
    folder.does("grow a.dapple -o a.jpg --quality 100");
    let lightest = folder.picture("a.jpg").into_rgb8().pixels().map(|px| px.0[1]).max();
    assert!(lightest.is_some_and(|green| green.abs_diff(127) < 25), "over white: {lightest:?}");
    folder.does("grow a.dapple -o plain.png --material maps");
    assert!(folder.names().iter().any(|name| name == "maps"));
    let maps = std::fs::read_dir(folder.path("maps")).unwrap();
    assert!(maps.flatten().any(|file| file.file_name().to_string_lossy().contains("Opacity")));
}

#[test]
fn the_layer_beneath_is_visible_through_transparent_colours() {
    let spot = |x: f64, y: f64, r: f64| json!({"kind": "ellipse", "center": [x, y], "radii": [r, r]});
    let layer = |x: f64, r: f64, ground: &str, mark: &str| {
        json!({"strokes": [spot(40.0 + x, 40.0, r), spot(90.0 + x, 40.0, r), spot(65.0 + x, 80.0, r)], "colours": {"stops": [
            {"at": 0.5, "colour": ground}, {"at": 0.5, "colour": mark}]}})
    };
    let of = |upper: Value| {
        let lower = layer(0.0, 9.0, "#00ff00", "#ffffff");
        let folder =
            Folder::with(&json!({"format": "dapple", "version": 2, "size": [160, 128], "regions": [1, 1],
            "layers": [lower, upper]}));
        folder.does("grow a.dapple -o a.png");
        folder.picture("a.png")
    };
    let clear = of(layer(25.0, 4.0, "#ff000000", "#0000ff80"));
    let opaque = of(layer(25.0, 4.0, "#ff0000", "#0000ff"));
    assert!(clear.color().has_alpha() && !opaque.color().has_alpha());
    for (clear, opaque) in clear.into_rgba8().pixels().zip(opaque.into_rgb8().pixels()) {
        let expected = match opaque.0 {
            [255, 0, 0] => [0, 255, 0, 255],
            [0, 0, 255] => [0, 127, 128, 255],
            [red, green, blue] => [red, green, blue, 255],
        };
        assert_eq!(clear.0, expected);
    }
}

#[test]
fn numbers_are_written_to_lossless_formats_only() {
    let folder = Folder::with(&tile());
    folder.refuses("grow a.dapple -o a.gif", 1, &["a.gif", ".png, .tif, .tiff, .exr, .jpg, .jpeg, .webp"]);
    folder.refuses(
        "grow a.dapple -o a.png --pattern p.jpg",
        1,
        &["p.jpg", "JPEG", ".png, .tif, .tiff, .exr"],
    );
    folder.refuses("grow a.dapple -o a.png --labels l.exr", 1, &["l.exr", ".png, .tif, .tiff"]);
    folder.refuses("grow a.dapple -o a.png --concentrations c.png", 1, &["c.png", ".exr"]);
    folder.refuses(
        "grow a.dapple -o a.webp --scale 64 --size 400x400",
        1,
        &["a.webp", "16383", "25600×25600"],
    );
}

#[test]
fn patterns_and_concentrations_are_floating_point_channels_with_names() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple -o a.png --pattern p.exr --concentrations c.exr --scale 2");
    folder.does("grow a.dapple -o a.png --pattern p.png --scale 2");
    let channels = |name: &str| {
        let reading = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
        let image = reading.first_valid_layer().all_attributes().from_file(folder.path(name)).unwrap();
        let list = image.layer_data.channel_data.list.into_iter();
        let values = |channel: exr::prelude::AnyChannel<exr::prelude::FlatSamples>| {
            (channel.name.to_string(), channel.sample_data.values_as_f32().collect::<Vec<f32>>())
        };
        list.map(values).collect::<Vec<_>>()
    };
    let pattern = channels("p.exr");
    assert_eq!((pattern.len(), pattern[0].0.as_str()), (1, "Y"));
    let gray = folder.picture("p.png").into_luma16();
    assert!(pattern[0].1.iter().zip(gray.iter()).all(|(a, b)| (65535.0 * a - f32::from(*b)).abs() <= 0.51));
    let chemicals = channels("c.exr");
    let names: Vec<&str> = chemicals.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["dots.a", "dots.b"]);
    // The pattern increases with the first chemical: both have their maximum at the same px.
    let highest =
        |values: &[f32]| (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap();
    assert_eq!(chemicals[0].1.len(), 240 * 192);
    assert!(pattern[0].1[highest(&chemicals[0].1)] > 0.95);
}
