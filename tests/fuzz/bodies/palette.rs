//! Palettes: both kinds of file, read, written and read back.

use dapple::document::palette::Palette;

use crate::refusal::assert_readable;

/// `bytes` are a palette, or are refused.
pub fn holds(bytes: &[u8]) {
    if let Ok(text) = std::str::from_utf8(bytes) {
        match Palette::parse_json(text, "bad.json") {
            Ok(palette) => {
                let read =
                    Palette::parse_json(&palette.to_json(), "own.json").expect("what is written is read");
                assert_eq!(read, palette);
            }
            Err(error) => assert_readable(&error.to_string(), "bad.json"),
        }
    }
    // Read in the same way as the bytes of a file: GIMP writes no declaration of its encoding.
    match Palette::parse_gpl(&String::from_utf8_lossy(bytes), "bad.gpl") {
        Ok(palette) => {
            let read = Palette::parse_gpl(&palette.to_gpl(), "own.gpl").expect("what is written is read");
            assert_eq!(read.colours.stops, palette.colours.stops);
            assert_eq!(read.to_gpl(), palette.to_gpl(), "what is read is written as it was");
        }
        Err(error) => assert_readable(&error.to_string(), "bad.gpl"),
    }
}
