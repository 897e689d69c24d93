//! Files of other programs.

use super::*;
use std::io::Cursor;

/// Found by fuzzing: a damaged header can state any size.
#[test]
fn a_few_bytes_are_not_unpacked_to_gigabytes() {
    let mut file = Vec::new();
    let picture = image::RgbImage::new(4, 4);
    picture.write_to(&mut Cursor::new(&mut file), ImageFormat::Bmp).expect("a bitmap");
    assert!(decode(&mut Cursor::new(&file)).is_ok());
    // Width and height are at bytes 18 and 22.
    for at in [18, 22] {
        file[at..at + 4].copy_from_slice(&30_000u32.to_le_bytes());
    }
    let error = decode(&mut Cursor::new(&file)).expect_err("2.7 GB");
    assert_eq!(
        error.to_string(),
        format!("30000×30000 px are too many for a file of {} bytes: it is damaged", file.len())
    );
}

/// A TIFF in little endian of 4 × 2 px with these tags (and those of its size), and these bytes of px.
fn tiff_of(tags: &[(u16, u16, &[u16])], px: &[u8]) -> Vec<u8> {
    let strip: [(u16, u16, Vec<u32>); 6] = [
        (256, 3, vec![4]),
        (257, 3, vec![2]),
        (259, 3, vec![1]),
        (273, 4, vec![8]),
        (278, 3, vec![2]),
        (279, 4, vec![px.len() as u32]),
    ];
    let own = tags
        .iter()
        .map(|(tag, kind, values)| (*tag, *kind, values.iter().map(|value| u32::from(*value)).collect()));
    let mut all: Vec<(u16, u16, Vec<u32>)> = strip.into_iter().chain(own).collect();
    all.sort();
    let directory = 8 + px.len().next_multiple_of(2);
    let mut rest = Vec::new();
    let mut file = [&b"II*\0"[..], &(directory as u32).to_le_bytes(), px].concat();
    file.resize(directory, 0);
    file.extend((all.len() as u16).to_le_bytes());
    let behind = directory + 2 + 12 * all.len() + 4;
    for (tag, kind, values) in &all {
        let width = if *kind == 3 { 2 } else { 4 };
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()[..width].to_vec()).collect();
        file.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
        file.extend((values.len() as u32).to_le_bytes());
        if bytes.len() <= 4 {
            file.extend([&bytes[..], &[0; 4][bytes.len()..]].concat());
        } else {
            file.extend(((behind + rest.len()) as u32).to_le_bytes());
            rest.extend(bytes);
        }
    }
    file.extend([0; 4]);
    file.extend(rest);
    file
}

fn decoded(file: &[u8]) -> Decoded {
    decode(&mut Cursor::new(file)).expect("a picture")
}

#[test]
fn palettes_of_4_and_8_bits_are_read() {
    let mut map = vec![0_u16; 3 * 16];
    (map[3], map[16 + 5], map[32 + 5]) = (0xff00, 0x8000, 0x4000);
    let few =
        tiff_of(&[(258, 3, &[4]), (262, 3, &[3]), (277, 3, &[1]), (320, 3, &map)], &[0x35, 0x00, 0x00, 0x53]);
    let rgb = decoded(&few).image.to_rgb8();
    assert_eq!((rgb.get_pixel(0, 0).0, rgb.get_pixel(1, 0).0), ([255, 0, 0], [0, 128, 64]));
    assert_eq!((rgb.get_pixel(2, 1).0, rgb.get_pixel(3, 1).0), ([0, 128, 64], [255, 0, 0]));
    // Some programs write palettes of 8 bits.
    let mut map = vec![0_u16; 3 * 256];
    map[7] = 200;
    let tags: [(u16, u16, &[u16]); 4] = [(258, 3, &[8]), (262, 3, &[3]), (277, 3, &[1]), (320, 3, &map)];
    let rgb = decoded(&tiff_of(&tags, &[7, 0, 0, 0, 0, 0, 0, 7])).image.to_rgb8();
    assert_eq!((rgb.get_pixel(0, 0).0, rgb.get_pixel(3, 1).0), ([200, 0, 0], [200, 0, 0]));
}

/// Samples of three bits lie in two bytes, in the tests of the tiff package.
#[test]
fn gray_of_three_bits_is_read() {
    // 7, 0, 1, 2 and 3, 4, 5, 6.
    let file = tiff_of(
        &[(258, 3, &[3]), (262, 3, &[1]), (277, 3, &[1])],
        &[0b1110_0000, 0b1010_0000, 0b0111_0010, 0b1110_0000],
    );
    let steps: Vec<u8> = decoded(&file)
        .image
        .to_luma8()
        .into_raw()
        .iter()
        .map(|value| (f64::from(*value) * 7.0 / 255.0).round() as u8)
        .collect();
    assert_eq!(steps, [7, 0, 1, 2, 3, 4, 5, 6]);
}

#[test]
fn floating_point_and_signed_numbers_are_stretched_with_a_note() {
    let floats: Vec<u8> =
        [0.0_f32, 1.0, 2.0, 3.0, 4.0, 5.0, f32::NAN, 8.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let float = tiff_of(&[(258, 3, &[32]), (262, 3, &[1]), (277, 3, &[1]), (339, 3, &[3])], &floats);
    let found = decoded(&float);
    assert_eq!(found.image.to_luma8().as_raw(), &[64, 84, 104, 124, 144, 164, 64, 224]);
    assert_eq!(found.notes, ["its values lie between 0 and 8; this range was stretched"]);
    let numbers: Vec<u8> = (-4_i16..4).flat_map(i16::to_le_bytes).collect();
    let signed = tiff_of(&[(258, 3, &[16]), (262, 3, &[1]), (277, 3, &[1]), (339, 3, &[2])], &numbers);
    let found = decoded(&signed);
    assert_eq!((found.image.to_luma8().as_raw()[0], found.image.to_luma8().as_raw()[7]), (64, 224));
    assert_eq!(found.notes, ["its values lie between -4 and 3; this range was stretched"]);
}

#[test]
fn a_tiff_that_is_cut_short_or_of_an_unknown_kind_is_refused_with_the_remedy() {
    let gray = tiff_of(&[(258, 3, &[32]), (262, 3, &[1]), (277, 3, &[1]), (339, 3, &[3])], &[0; 32]);
    let refused = |file: &[u8]| decode(&mut Cursor::new(file)).expect_err("no picture").to_string();
    let cut = [&gray[..4], &gray[4..8], &gray[40..]].concat();
    assert!(decode(&mut Cursor::new(&cut)).is_err());
    let lab = tiff_of(&[(258, 3, &[8, 8, 8]), (262, 3, &[8]), (277, 3, &[3])], &[0; 24]);
    assert!(refused(&lab).contains("save it as RGB or gray of 8 or 16 bits"), "{}", refused(&lab));
}
