//! Pictures and materials: the preview equals the written file and the file of `dapple grow`.

use super::*;

#[test]
fn pictures_of_every_format_equal_the_preview_and_those_of_the_command_line() {
    for (format, name, options) in [
        ("PNG", "x.png", &[][..]),
        ("TIFF", "x.tif", &[]),
        ("JPEG", "x.jpg", &[]),
        ("WebP", "x.webp", &[]),
        ("OpenEXR", "x.exr", &[]),
    ] {
        let (mut hand, folder) = small();
        open(&mut hand, "Picture");
        if format != "PNG" {
            take(&mut hand, "Format", format);
        }
        let made = seen(&mut hand);
        let path = folder.path().join(name);
        write(&mut hand, &path);
        if format != "OpenEXR" {
            same(&made.pictures()[0].1, &path);
        }
        let other = grown(folder.path(), &format!("cli-{name}"), options);
        assert!(fs::read(&path).unwrap() == fs::read(other).unwrap(), "{format}");
    }
}

#[test]
fn a_transparent_picture_of_16_bit_equals_the_preview_and_an_exr_looks_like_it() {
    let (mut hand, folder) = small();
    open(&mut hand, "Picture");
    hand.press("16 bit");
    hand.press("transparent");
    let made = seen(&mut hand);
    let image = made.pictures()[0].1.clone();
    assert!(image.pixels.iter().any(|px| px.a() == 0) && image.pixels.iter().any(|px| px.a() == 255));
    let path = folder.path().join("x.png");
    write(&mut hand, &path);
    same(&image, &path);
    let other = grown(folder.path(), "cli.png", &["--depth", "16", "--transparent"]);
    assert_eq!(fs::read(&path).unwrap(), fs::read(other).unwrap());

    hand.key(Modifiers::COMMAND, Key::E);
    take(&mut hand, "Format", "OpenEXR");
    let light = seen(&mut hand).pictures()[0].1.clone();
    let near = |(a, b): (&egui::Color32, &egui::Color32)| {
        a.to_array().into_iter().zip(b.to_array()).all(|(a, b)| a.abs_diff(b) <= 2)
    };
    assert!(light.pixels.iter().zip(&image.pixels).all(near));
}

#[test]
fn patterns_labels_and_concentrations_are_written_from_the_dialog() {
    let (mut hand, folder) = small();
    for (shows, name, option) in [
        ("The pattern, 0 to 1", "p.png", "--pattern"),
        ("Labels: the number of the layer", "l.png", "--labels"),
        ("Concentrations", "c.exr", "--concentrations"),
    ] {
        open(&mut hand, "Picture");
        take(&mut hand, "Shows", shows);
        if option == "--concentrations" {
            hand.press("Show preview");
        }
        let made = seen(&mut hand);
        let path = folder.path().join(name);
        write(&mut hand, &path);
        if name.ends_with("png") {
            same(&made.pictures()[0].1, &path);
        } else {
            assert!(made.pictures().len() >= 2, "a picture a chemical");
        }
        let other = folder.path().join(format!("cli-{name}"));
        grown(folder.path(), "t.png", &[option, other.to_str().unwrap()]);
        assert!(decoded_or_bytes(&path) == decoded_or_bytes(&other), "{shows}");
    }
}

/// The px of a PNG, which may also contain a document; of other files, all bytes.
fn decoded_or_bytes(path: &Path) -> Vec<u8> {
    match image::open(path) {
        Ok(image) => image.into_bytes(),
        Err(_) => fs::read(path).unwrap(),
    }
}

#[test]
fn larger_pictures_have_a_smaller_preview_and_are_written_in_full_size() {
    let (mut hand, folder) = small();
    open(&mut hand, "Picture");
    hand.type_into("Scale", "30");
    let made = seen(&mut hand);
    assert!(!made.whole && made.pictures()[0].1.size[0] < 30 * 96);
    let path = folder.path().join("x.png");
    write(&mut hand, &path);
    assert_eq!(decoded(&path).size, [30 * 96, 30 * 80]);
}

#[test]
fn a_larger_canvas_is_grown_for_the_preview_and_not_again_for_the_file() {
    let (mut hand, folder) = small();
    open(&mut hand, "Picture");
    hand.press("Larger canvas");
    hand.press("Show preview");
    let made = seen(&mut hand);
    assert_eq!(made.pictures()[0].1.size, [192, 160]);
    let path = folder.path().join("x.png");
    write(&mut hand, &path);
    same(&made.pictures()[0].1, &path);
    let other = grown(folder.path(), "cli.png", &["--size", "192x160"]);
    assert_eq!(fs::read(&path).unwrap(), fs::read(other).unwrap());
}

#[test]
fn every_map_of_a_material_equals_its_preview() {
    let (mut hand, folder) = small();
    open(&mut hand, "Material");
    hand.type_into("Relief of spots", "9");
    let made = seen(&mut hand);
    let path = folder.path().join("maps");
    write(&mut hand, &path);
    assert!(made.pictures().len() >= 9);
    for (name, image) in made.pictures() {
        same(image, &path.join(format!("a_{name}.png")));
    }
    let (plane, _, images) = gltf::import(path.join("a.gltf")).unwrap();
    assert_eq!((plane.meshes().len(), images.len()), (1, 3));
    let other = folder.path().join("cli");
    grown(folder.path(), "", &["--material", other.to_str().unwrap(), "--relief", "9"]);
    for file in fs::read_dir(&other).unwrap().flatten() {
        let written = fs::read(path.join(file.file_name())).unwrap();
        assert!(written == fs::read(file.path()).unwrap(), "{:?}", file.file_name());
    }
}
