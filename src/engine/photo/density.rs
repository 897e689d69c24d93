//! px an inch of a picture file, if it states them.

use std::io::{Read, Seek, SeekFrom};

/// px an inch, from the file or its EXIF data; `None` if they are not stated, or not within 1..100 000.
#[must_use]
pub fn dpi(stream: &mut (impl Read + Seek), exif: Option<&[u8]>) -> Option<f64> {
    let exif = exif.and_then(|bytes| of_tags(&mut std::io::Cursor::new(bytes)));
    let found = exif.or_else(|| {
        stream.rewind().ok()?;
        let mut head = Vec::new();
        stream.by_ref().take(HEAD).read_to_end(&mut head).ok()?;
        match head.get(..4)? {
            [0xff, 0xd8, ..] => of_jfif(&head),
            [0x89, b'P', b'N', b'G'] => of_png(&head),
            b"II*\0" | b"MM\0*" => of_tags(stream),
            _ => None,
        }
    });
    found.filter(|dpi| (1.0..=100_000.0).contains(dpi))
}

/// Bytes in which a JPEG or PNG states it: before the px, after a colour profile at most.
const HEAD: u64 = 1 << 16;
/// Metres and centimetres an inch.
const INCH: [f64; 2] = [0.0254, 2.54];

fn number(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0, |number, byte| number << 8 | u32::from(*byte))
}

/// JPEG File Interchange Format 1.02: the first segment, with unit 1 (inch) or 2 (cm).
fn of_jfif(head: &[u8]) -> Option<f64> {
    let segment =
        head.get(2..18).filter(|segment| segment[..2] == [0xff, 0xe0] && &segment[4..9] == b"JFIF\0")?;
    let density = f64::from(number(&segment[12..14]));
    match segment[11] {
        1 => Some(density),
        2 => Some(density * INCH[1]),
        _ => None,
    }
}

/// The chunk pHYs of a PNG: px a metre along x and y, unit 1.
fn of_png(head: &[u8]) -> Option<f64> {
    let mut at = 8;
    while let Some(start) = head.get(at..at + 8) {
        let data = at + 8;
        if &start[4..] == b"pHYs" {
            let chunk = head.get(data..data + 9)?;
            return (chunk[8] == 1).then(|| f64::from(number(&chunk[..4])) * INCH[0]);
        }
        at = data + number(&start[..4]) as usize + 4;
    }
    None
}

/// XResolution (282) and ResolutionUnit (296: 2 = inch, 3 = cm) of the first directory of a TIFF, whose form EXIF data have.
fn of_tags(stream: &mut (impl Read + Seek)) -> Option<f64> {
    let mut start = [0; 8];
    stream.rewind().ok()?;
    stream.read_exact(&mut start).ok()?;
    let little = &start[..2] == b"II";
    let number = |bytes: &[u8]| {
        let mut bytes = bytes.to_vec();
        if little {
            bytes.reverse();
        }
        number(&bytes)
    };
    let mut read = |at: u32, count: usize| {
        let mut bytes = vec![0; count];
        stream.seek(SeekFrom::Start(u64::from(at))).ok()?;
        stream.read_exact(&mut bytes).ok()?;
        Some(bytes)
    };
    let directory = number(&start[4..]);
    let count = number(&read(directory, 2)?);
    let entries = read(directory.checked_add(2)?, 12 * count as usize)?;
    let entry = |tag: u32| entries.chunks_exact(12).find(|entry| number(&entry[..2]) == tag);
    let ratio = read(number(&entry(282)?[8..]), 8)?;
    let resolution = f64::from(number(&ratio[..4])) / f64::from(number(&ratio[4..]).max(1));
    match entry(296).map_or(2, |entry| number(&entry[8..10])) {
        2 => Some(resolution),
        3 => Some(resolution * INCH[1]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    /// A TIFF's first directory: resolution and unit.
    fn tags(resolution: [u32; 2], unit: u16) -> Vec<u8> {
        let mut bytes = b"II*\0\x08\0\0\0\x02\0".to_vec();
        for (tag, kind, value) in [(282_u16, 5_u16, 38_u32), (296, 3, u32::from(unit))] {
            bytes.extend(
                tag.to_le_bytes()
                    .iter()
                    .chain(&kind.to_le_bytes())
                    .chain(&1_u32.to_le_bytes())
                    .chain(&value.to_le_bytes()),
            );
        }
        bytes.extend([0; 4]);
        resolution.iter().for_each(|part| bytes.extend(part.to_le_bytes()));
        bytes
    }

    #[test]
    fn each_format_states_it_in_its_own_way() {
        let of = |bytes: &[u8], exif: Option<&[u8]>| dpi(&mut Cursor::new(bytes), exif);
        assert_eq!(of(&tags([3000, 10], 2), None), Some(300.0));
        assert_eq!(of(&tags([100, 1], 3), None), Some(254.0));
        assert_eq!(of(b"", Some(&tags([72, 1], 2))), Some(72.0));
        let jfif = |unit: u8| {
            [b"\xff\xd8\xff\xe0\0\x10JFIF\0\x01\x02".as_slice(), &[unit, 0, 240, 0, 240, 0, 0]].concat()
        };
        assert_eq!((of(&jfif(1), None), of(&jfif(0), None)), (Some(240.0), None));
        let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
        png.extend(b"\0\0\0\x01zzzz\0\0\0\0\0\0\0\0\x09pHYs\0\0\x2e\x23\0\0\x2e\x23\x01");
        assert!((of(&png, None).unwrap() - 300.0).abs() < 0.1);
    }

    #[test]
    fn damaged_and_senseless_files_give_no_resolution() {
        for bytes in
            [&b""[..], b"II*\0\xff\xff\xff\xff", b"\x89PNG\r\n\x1a\n\xff\xff\xff\xffpHYs", &tags([0, 0], 2)]
        {
            assert_eq!(dpi(&mut Cursor::new(bytes), None), None);
        }
    }
}
