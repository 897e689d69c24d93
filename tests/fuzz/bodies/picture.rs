//! Fuzz body for pictures to be measured: they have spots, stripes or neither, in px of their size.

use dapple_engine::measure::Picture;
use dapple_engine::synth::import::measured_picture::{Framing, measure_stream};
use image::ImageReader;
use std::io::Cursor;
use std::path::Path;

use crate::refusal::assert_readable;

const FILE: &str = "bad.png";
/// The most px of a picture that is measured; larger ones are only read, because measuring takes time in proportion to
/// the px.
const MEASURED: u64 = 1 << 16;
/// No reader may decode a picture with this many px.
const BOMB: u64 = 1 << 29;
/// The memory that a picture may take, bytes: less than a picture of that many px takes.
const MEMORY: Option<f64> = Some(4e9);

/// `bytes` are a picture, or are refused.
pub fn holds(bytes: &[u8]) {
    let Ok(reader) = ImageReader::new(Cursor::new(bytes)).with_guessed_format() else { return };
    let px = reader.into_dimensions().map_or(0, |(width, height)| u64::from(width) * u64::from(height));
    if (MEASURED..BOMB).contains(&px) {
        return;
    }
    for invert in [false, true] {
        match measure_stream(
            Cursor::new(bytes),
            Path::new(FILE),
            &Framing { invert, ..Framing::default() },
            MEMORY,
        ) {
            Ok(found) => {
                assert!(px < BOMB, "{px} px were unpacked from {} bytes", bytes.len());
                fits(&found.picture, px as f64);
            }
            Err(error) => assert_readable(&error.to_string(), FILE),
        }
    }
}

/// What was found fits on a picture of `px` px.
fn fits(found: &Picture, px: f64) {
    match found {
        Picture::Spots { marks, got, .. } => {
            assert!(*marks > 0 && *marks as f64 <= px, "{found:?}");
            assert!(got.area > 0.0 && got.area <= px, "{found:?}");
            assert!(got.aspect > 0.0 && got.aspect <= 1.0 + 1e-9, "{found:?}");
            assert!((0.0..180.0).contains(&got.angle), "{found:?}");
            assert!(got.spacing.is_none_or(|spacing| spacing > 0.0 && spacing < px + 2.0), "{found:?}");
        }
        Picture::Stripes { marks, got } => {
            assert!(*marks > 0 && *marks as f64 <= px, "{found:?}");
            assert!(got.width > 0.0 && got.width <= 2.0 * px, "{found:?}");
            assert!(got.wavelength > 0.0 && got.wavelength.is_finite(), "{found:?}");
            assert!((0.0..180.0).contains(&got.angle), "{found:?}");
            assert!((0.0..=1.0 + 1e-9).contains(&got.coherence), "{found:?}");
        }
    }
}
