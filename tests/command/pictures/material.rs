use super::{Folder, tile};
use serde_json::json;

const MAPS: [&str; 9] =
    ["AmbientOcclusion", "BaseColor", "Height", "ID", "MaskMap", "NormalDX", "NormalGL", "ORM", "Roughness"];

#[test]
fn a_set_has_the_file_names_of_game_engines_and_needs_no_picture() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple --material set");
    let mut names: Vec<String> = MAPS.map(|map| format!("a_{map}.png")).to_vec();
    names.extend(["a.bin".to_owned(), "a.gltf".to_owned()]);
    names.sort();
    let mut found: Vec<String> = std::fs::read_dir(folder.path("set"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    found.sort();
    assert_eq!(found, names);
    folder.does("grow a.dapple -o a.png");
    let base = folder.picture("set/a_BaseColor.png");
    assert!(base.into_rgb8() == folder.picture("a.png").into_rgb8());
}

#[test]
fn another_gltf_reader_opens_the_plane_with_all_its_pictures() {
    let folder = Folder::with(&tile());
    for (more, mode) in
        [("", gltf::material::AlphaMode::Opaque), ("--transparent", gltf::material::AlphaMode::Blend)]
    {
        folder.does(&format!("grow a.dapple --material set {more}"));
        let (document, buffers, images) = gltf::import(folder.path("set/a.gltf")).unwrap();
        assert_eq!((buffers[0].0.len() / 4 * 4, images.len()), (204, 3));
        assert!(images.iter().all(|image| (image.width, image.height) == (120, 96)));
        let material = document.materials().next().unwrap();
        assert_eq!(material.alpha_mode(), mode);
        assert!(material.normal_texture().is_some() && material.occlusion_texture().is_some());
        let sampler = document.samplers().next().unwrap();
        assert_eq!(sampler.wrap_s(), gltf::texture::WrappingMode::Repeat);
    }
    assert!(folder.path("set/a_Opacity.png").is_file());
}

#[test]
fn marks_are_raised_or_hollow_and_normals_point_away_from_high_places() {
    let folder = Folder::with(&tile());
    for (relief, sign) in [("5", 1.0), ("-5", -1.0)] {
        folder.does(&format!("grow a.dapple --material set --relief {relief} --pattern p.png"));
        let map = |name: &str| folder.picture(&format!("set/a_{name}.png"));
        let (height, pattern) = (map("Height").into_luma16(), folder.picture("p.png").into_luma16());
        for (h, p) in height.iter().zip(pattern.iter()) {
            let up = if sign > 0.0 { f64::from(*h) } else { 65535.0 - f64::from(*h) };
            // The profile of a mark is S(p) = p²(3 − 2p).
            let share = f64::from(*p) / 65535.0;
            assert!((up - 65535.0 * share * share * (3.0 - 2.0 * share)).abs() <= 2.0);
        }
        let (gl, dx) = (map("NormalGL").into_rgb8(), map("NormalDX").into_rgb8());
        for (x, y, normal) in
            gl.enumerate_pixels().filter(|(x, y, _)| (1..119).contains(x) && (1..95).contains(y))
        {
            let other = dx.get_pixel(x, y).0;
            assert_eq!((normal.0[0], normal.0[2]), (other[0], other[2]));
            assert!((i32::from(normal.0[1]) + i32::from(other[1]) - 255).abs() <= 1);
            let slope = |dx: u32, dy: u32| {
                let at = |x, y| f64::from(height.get_pixel(x, y).0[0]) / 65535.0 * 5.0;
                (at(x + dx, y + dy) - at(x - dx, y - dy)) / 2.0
            };
            // Red decreases where the height rises to the right; green increases where the height rises downwards.
            let [red, green] = [0, 1].map(|channel| f64::from(normal.0[channel]) / 127.5 - 1.0);
            let (across, down) = (slope(1, 0), slope(0, 1));
            let length = (across * across + down * down + 1.0).sqrt();
            assert!((red + across / length).abs() < 0.02 && (green - down / length).abs() < 0.02);
        }
    }
}

#[test]
fn packed_maps_hold_the_values_of_the_single_maps() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple --material set --roughness 0.9,0.2");
    let map = |name: &str| folder.picture(&format!("set/a_{name}.png"));
    let (open, rough) = (map("AmbientOcclusion").into_luma8(), map("Roughness").into_luma8());
    let (orm, mask) = (map("ORM").into_rgb8(), map("MaskMap").into_rgba8());
    for (((open, rough), orm), mask) in open.iter().zip(rough.iter()).zip(orm.pixels()).zip(mask.pixels()) {
        assert_eq!(orm.0, [*open, *rough, 0]);
        assert_eq!((mask.0[0], mask.0[1]), (0, *open));
        assert!((i32::from(mask.0[3]) + i32::from(*rough) - 255).abs() <= 1);
    }
    let ends =
        [rough.iter().min().unwrap(), rough.iter().max().unwrap()].map(|value| f64::from(*value) / 255.0);
    assert!((ends[0] - 0.2).abs() < 0.02 && (0.85..=0.91).contains(&ends[1]), "{ends:?}");
    assert!(open.iter().min().unwrap() < &240 && open.iter().max().unwrap() == &255);
}

#[test]
fn twice_the_scale_is_the_same_surface() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple --material one");
    folder.does("grow a.dapple --material two --scale 2");
    let map = |set: &str| folder.picture(&format!("{set}/a_NormalGL.png")).into_rgb8();
    let (one, two) = (map("one"), map("two"));
    for (x, y, px) in one.enumerate_pixels() {
        let four =
            [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| two.get_pixel(2 * x + dx, 2 * y + dy).0[0]);
        let mean: f64 = four.iter().map(|value| f64::from(*value)).sum::<f64>() / 4.0;
        assert!((mean - f64::from(px.0[0])).abs() < 12.0, "{mean} {px:?}");
    }
}

#[test]
fn invalid_surface_options_are_refused() {
    let folder = Folder::with(&tile());
    folder.refuses("grow a.dapple --material set --relief x", 2, &["--relief", "such as 6"]);
    folder.refuses("grow a.dapple --material set --roughness 2", 2, &["--roughness", "0 (mirror)"]);
    folder.refuses("grow a.dapple --material none/set", 1, &["none"]);
    folder.refuses("grow a.dapple --material a.dapple", 2, &["a.dapple", "folder"]);
    folder.refuses("grow a.dapple", 2, &["--output"]);
    let mut broken = tile();
    broken["layers"] = json!([]);
    std::fs::write(folder.path("b.dapple"), broken.to_string()).unwrap();
    folder.refuses("grow b.dapple --material set", 1, &["b.dapple", "layers"]);
}
