//! A picture file → the attributes of the spots or stripes in it.

use std::fs::File;
use std::io::{BufRead, BufReader, Seek};
use std::path::{Path, PathBuf};

use image::DynamicImage;

use crate::grid::{Edges, Field};
use crate::measure::{Picture, level_between_phases, picture};
use crate::synth::memory;

/// Why a picture could not be measured.
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    /// It cannot be read.
    #[error("{path}: cannot be read as a picture: {}", one_line(source))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The decoder's error.
        source: image::ImageError,
    },
    /// It has more px than fit into memory.
    #[error(
        "{path}: {}×{} px need about {:.1} GB of memory to be measured, {:.1} GB are free; allowed: a smaller part of it",
        size[0], size[1], needed / 1e9, free / 1e9
    )]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Width and height, px.
        size: [usize; 2],
        /// Bytes needed.
        needed: f64,
        /// Bytes free.
        free: f64,
    },
    /// It has no contrast.
    #[error(
        "{path}: neither spots nor stripes: lightness spans {span:.3} of 1, at least {MIN_SPAN} is needed"
    )]
    Blank {
        /// The file.
        path: PathBuf,
        /// Highest minus lowest lightness.
        span: f32,
    },
    /// It has contrast but no marks.
    #[error(
        "{path}: neither spots nor stripes: nothing above 2 px, only noise, or no whole spot; try --invert"
    )]
    Neither {
        /// The file.
        path: PathBuf,
    },
}

/// Most bytes a px in memory while a picture is read and measured. Measured: 13 to 14 at 1024² to 4096² px with a spot per
/// 1024 px.
const BYTES_PER_PX: f64 = 16.0;
/// Less contrast than this is compression noise.
const MIN_SPAN: f32 = 0.05;

/// The decoder's message on one line: some end with a line break or quote control characters of the file.
fn one_line(error: &image::ImageError) -> String {
    let shown = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    error.to_string().trim_end().chars().map(shown).collect()
}

/// Measures the marks in the picture file `path`: the smaller phase, or the larger one if `invert`.
///
/// # Errors
/// It cannot be read as a picture, or has neither spots nor stripes.
pub fn measure_file(path: &Path, invert: bool) -> Result<Picture, MeasureError> {
    let unreadable = |source| MeasureError::Unreadable { path: path.to_owned(), source };
    let file = File::open(path).map_err(|error| unreadable(error.into()))?;
    measure_stream(BufReader::new(file), path, invert)
}

/// As [`measure_file`], for a stream; `path` is its name in messages.
///
/// # Errors
/// It cannot be read as a picture, or has neither spots nor stripes.
pub fn measure_stream(
    mut stream: impl BufRead + Seek,
    path: &Path,
    invert: bool,
) -> Result<Picture, MeasureError> {
    let unreadable = |source| MeasureError::Unreadable { path: path.to_owned(), source };
    let head = image::ImageReader::new(&mut stream).with_guessed_format();
    let head = head.map_err(|error| unreadable(error.into()))?;
    let (width, height) = head.into_dimensions().map_err(unreadable)?;
    // The head of a damaged file can give any size: check it before allocating.
    if let Err(error) = memory::check_picture([width as usize, height as usize], BYTES_PER_PX) {
        let memory::TooLargePicture { size, needed, free } = error;
        return Err(MeasureError::TooLarge { path: path.to_owned(), size, needed, free });
    }
    stream.rewind().map_err(|error| unreadable(error.into()))?;
    let reader = image::ImageReader::new(stream).with_guessed_format();
    let reader = reader.map_err(|error| unreadable(error.into()))?;
    let image = reader.decode().map_err(unreadable)?;
    // A 16-bit gray picture is a pattern of `grow --pattern`: its marks' edge is at 0.5.
    let pattern = matches!(image, DynamicImage::ImageLuma16(_));
    let mut field = lightness(&image);
    let low = field.values.iter().copied().fold(1.0, f32::min);
    let high = field.values.iter().copied().fold(0.0, f32::max);
    if high - low < MIN_SPAN {
        return Err(MeasureError::Blank { path: path.to_owned(), span: (high - low).max(0.0) });
    }
    let level = if pattern && low < 0.5 && high > 0.5 { 0.5 } else { level_between_phases(&field.values) };
    let above = field.values.iter().filter(|value| **value > level).count();
    let light = 2 * above <= field.values.len();
    let level = if light == invert {
        field.values.iter_mut().for_each(|value| *value = 1.0 - *value);
        1.0 - level
    } else {
        level
    };
    picture(&field, level).ok_or_else(|| MeasureError::Neither { path: path.to_owned() })
}

/// The picture's luma, 0..1; opacity is ignored.
fn lightness(image: &DynamicImage) -> Field {
    let luma = image.to_luma16();
    let (width, height) = (luma.width() as usize, luma.height() as usize);
    let values = luma.into_raw().into_iter().map(|value| f32::from(value) / 65535.0).collect();
    Field { width, height, cell: [1.0, 1.0], edges: Edges::Closed, values }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(name: &str, picture: &DynamicImage) -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        picture.save(&path).unwrap();
        (folder, path)
    }

    /// Ellipses of radii 9 and 6 along 30° on a lattice of 32 px, `out` → tone.
    fn dots(tone: impl Fn(f64) -> f64) -> image::ImageBuffer<image::Luma<u16>, Vec<u16>> {
        image::ImageBuffer::from_fn(256, 256, |x, y| {
            let near = |x: u32| (f64::from(x) + 0.5).rem_euclid(32.0) - 16.0;
            let (sin, cos) = 30_f64.to_radians().sin_cos();
            let (x, y) = (near(x), near(y));
            let out = ((x * cos + y * sin) / 9.0).hypot((y * cos - x * sin) / 6.0);
            image::Luma([(65535.0 * tone(out)) as u16])
        })
    }

    #[test]
    fn a_pattern_is_measured_at_one_half_and_other_pictures_between_their_tones() {
        let soft = |out: f64| (0.5 + 0.7 * (1.0 - out)).clamp(0.0, 1.0);
        let ink = |out: f64| 0.9 - 0.6 * (0.5 + 3.0 * (1.0 - out)).clamp(0.0, 1.0);
        let colour = DynamicImage::ImageLuma16(dots(ink)).to_rgb8();
        for (name, image) in [
            ("pattern.png", DynamicImage::ImageLuma16(dots(soft))),
            ("ink.png", DynamicImage::ImageRgb8(colour.clone())),
            ("ink.bmp", DynamicImage::ImageRgb8(colour)),
        ] {
            let (_folder, path) = written(name, &image);
            let Picture::Spots { marks, got, .. } = measure_file(&path, false).unwrap() else {
                panic!("{name}")
            };
            assert_eq!(marks, 64, "{name}");
            assert!((got.area / (54.0 * std::f64::consts::PI) - 1.0).abs() < 0.01, "{name} {got:?}");
            assert!((got.aspect - 2.0 / 3.0).abs() < 0.005, "{name} {got:?}");
            assert!((got.angle - 30.0).abs() < 0.3, "{name} {got:?}");
            assert!((got.spacing.unwrap() / 32.0 - 1.0).abs() < 0.01, "{name} {got:?}");
        }
    }

    #[test]
    fn inverted_the_ground_is_measured() {
        let disc = |out: f64| (0.5 + 0.7 * (1.0 - out)).clamp(0.0, 1.0);
        let (_folder, path) = written("net.png", &DynamicImage::ImageLuma16(dots(disc)));
        let Picture::Stripes { marks, .. } = measure_file(&path, true).unwrap() else { panic!() };
        assert_eq!(marks, 1);
    }

    #[test]
    fn stripes_of_a_picture_have_width_wavelength_and_direction() {
        let image = image::ImageBuffer::from_fn(200, 300, |x, y| {
            let (sin, cos) = 20_f64.to_radians().sin_cos();
            let across = (f64::from(y) + 0.5) * cos - (f64::from(x) + 0.5) * sin;
            let inside = 3.0 - (across.rem_euclid(18.0) - 9.0).abs();
            image::Luma([(40.0 + 180.0 * (0.5 + inside).clamp(0.0, 1.0)) as u8])
        });
        let (_folder, path) = written("stripes.png", &DynamicImage::ImageLuma8(image));
        let Picture::Stripes { got, .. } = measure_file(&path, false).unwrap() else { panic!() };
        assert!((got.width - 6.0).abs() < 0.06, "{got:?}");
        assert!((got.wavelength - 18.0).abs() < 0.3, "{got:?}");
        assert!((got.angle - 20.0).abs() < 0.2, "{got:?}");
        assert!(got.coherence > 0.9, "{got:?}");
    }

    /// The head of a gray TIFF with this size, without px.
    fn head_of_tiff(width: u32, height: u32) -> Vec<u8> {
        let mut bytes = b"II*\0\x08\0\0\0".to_vec();
        let tags =
            [(256, width), (257, height), (258, 8), (259, 1), (262, 1), (273, 8), (278, height), (279, 1)];
        bytes.extend_from_slice(&(tags.len() as u16).to_le_bytes());
        for (tag, value) in tags {
            // A LONG, one of it.
            for number in [tag | 4 << 16, 1, value] {
                bytes.extend_from_slice(&u32::to_le_bytes(number));
            }
        }
        bytes.extend_from_slice(&[0; 4]);
        bytes
    }

    #[test]
    fn a_picture_larger_than_memory_is_refused_before_it_is_decoded() {
        let bytes = head_of_tiff(1_000_000, 1_000_000);
        let error = measure_stream(std::io::Cursor::new(bytes), Path::new("bomb.tiff"), false).unwrap_err();
        let message = error.to_string();
        assert!(
            message.starts_with("bomb.tiff: 1000000×1000000 px need about 16000.0 GB of memory"),
            "{message}"
        );
    }

    /// Found by fuzzing: the JPEG decoder's message ends with a line break.
    #[test]
    fn messages_are_on_one_line() {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let picture = DynamicImage::new_luma8(16, 16);
        picture.write_to(&mut bytes, image::ImageFormat::Jpeg).unwrap();
        let whole = bytes.into_inner();
        for length in 3..whole.len() {
            let cut = std::io::Cursor::new(&whole[..length]);
            let message = measure_stream(cut, Path::new("a.jpg"), false).unwrap_err().to_string();
            assert!(!message.contains(char::is_control), "{message:?}");
        }
    }

    #[test]
    fn a_picture_without_marks_is_an_error() {
        let blank = DynamicImage::ImageLuma8(image::ImageBuffer::from_pixel(50, 50, image::Luma([7])));
        let (_folder, path) = written("blank.png", &blank);
        assert!(matches!(measure_file(&path, false), Err(MeasureError::Blank { .. })));
        let mut state = 1_u32;
        let noise = image::ImageBuffer::from_fn(200, 200, |_, _| {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            image::Luma([(state >> 24) as u8])
        });
        let (_folder, path) = written("noise.png", &DynamicImage::ImageLuma8(noise));
        assert!(
            matches!(measure_file(&path, false), Err(MeasureError::Neither { .. })),
            "{:?}",
            measure_file(&path, false)
        );
        let none = measure_file(Path::new("no such picture.png"), false).unwrap_err().to_string();
        assert!(none.starts_with("no such picture.png: cannot be read"), "{none}");
    }
}
