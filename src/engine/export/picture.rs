//! Rows of colours → a file in any format.

use std::io::{self, Seek, Write};
use std::ops::Range;

use super::png::{Header, Samples};
use super::web::{Aside, at_once};
use super::{Format, Stopped, exr, png, tiff, web};

/// Default quality of a JPEG, 1 to 100: no blocks are visible in a smooth pattern at twice its size.
pub const QUALITY: u8 = 92;

/// Settings of lossy and slow encoders.
#[derive(Clone, Copy, Debug)]
pub struct Encoding {
    /// Quality of a JPEG, 1 to 100.
    pub quality: u8,
    /// Encodes a WebP, which cannot be interrupted.
    pub aside: Aside,
}

impl Default for Encoding {
    /// The default quality, and a WebP encoded at once.
    fn default() -> Self {
        Self { quality: QUALITY, aside: at_once }
    }
}

/// Writes a picture of any height; for all formats but WebP it is not held in memory. `fill` is called for band after band, from
/// the top, and writes the bytes of the given rows into the slice, `size[0] * samples.bytes()` a row.
///
/// In OpenEXR gray is channel `Y`, and colours are linear and multiplied by the opacity, as its readers expect.
///
/// # Errors
/// The errors of `out` and `fill`; a size or samples that the format cannot hold.
pub fn write(
    out: impl Write + Seek,
    format: Format,
    encoding: Encoding,
    header: Header,
    fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let eight_bit = matches!(header.samples, Samples::Rgb8 | Samples::Rgba8);
    match format {
        Format::Png => png::write(out, header, fill),
        Format::Tiff => tiff::write(out, header, fill),
        Format::Exr => linear_exr(out, header, fill),
        Format::Jpeg if header.samples == Samples::Rgb8 => web::jpeg(out, header, encoding.quality, fill),
        Format::Webp if eight_bit => web::webp(out, header, encoding.aside, fill),
        Format::Jpeg | Format::Webp => {
            Err(io::Error::other(format!("{} cannot hold {:?}", format.name(), header.samples)).into())
        }
    }
}

/// Writes a painted picture of three bytes a px.
///
/// ```
/// use std::io::Cursor;
///
/// use dapple_engine::export::{Format, picture};
///
/// let mut file = Cursor::new(Vec::new());
/// picture::rgb8(&mut file, Format::Jpeg, [8, 8], &[200; 3 * 64])?;
/// assert_eq!(file.into_inner()[..2], [0xff, 0xd8]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The errors of [`write()`]; `rgb` too short for `size`.
pub fn rgb8(out: impl Write + Seek, format: Format, size: [usize; 2], rgb: &[u8]) -> Result<(), Stopped> {
    write(out, format, Encoding::default(), Header::new(size, Samples::Rgb8), |rows, band| {
        let source = rgb.get(3 * rows.start * size[0]..3 * rows.end * size[0]);
        let source =
            source.ok_or_else(|| io::Error::other("the picture has fewer px than its size needs"))?;
        band.copy_from_slice(source);
        Ok(())
    })
}

/// sRGB → linear OpenEXR.
fn linear_exr(
    out: impl Write + Seek,
    header: Header,
    mut fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let (channels, deep) = match header.samples {
        Samples::Gray8 => (1, false),
        Samples::Gray16 => (1, true),
        Samples::Rgb8 => (3, false),
        Samples::Rgb16 => (3, true),
        Samples::Rgba8 => (4, false),
        Samples::Rgba16 => (4, true),
    };
    let names = if channels == 1 { &["Y"][..] } else { &["R", "G", "B", "A"][..channels] };
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    let mut bytes = Vec::new();
    exr::write(out, header.size, &names, header.dpi, |rows, planes| {
        bytes.resize(rows.len() * header.size[0] * header.samples.bytes(), 0);
        fill(rows, &mut bytes)?;
        for (px, samples) in bytes.chunks_exact(header.samples.bytes()).enumerate() {
            let value = |channel: usize| match deep {
                true => {
                    f64::from(u16::from_be_bytes([samples[2 * channel], samples[2 * channel + 1]])) / 65535.0
                }
                false => f64::from(samples[channel]) / 255.0,
            };
            let opacity = if channels == 4 { value(3) } else { 1.0 };
            for (channel, plane) in planes.iter_mut().enumerate() {
                let colour = channels > 1 && channel < 3;
                let value = value(channel);
                plane[px] = if colour { opacity * linear(value) } else { value } as f32;
            }
        }
        Ok(())
    })
}

/// sRGB value → linear light, both 0..1 (IEC 61966-2-1).
///
/// Not by palette: its results differ in the last bit of an f64, which changes 3 in 1.4·10⁹ products with an opacity.
fn linear(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    use ::exr::prelude::read_first_rgba_layer_from_file;

    #[test]
    fn open_exr_is_linear_and_multiplied_by_the_opacity() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.exr");
        let header = Header::new([2, 1], Samples::Rgba8);
        let out = std::fs::File::create(&path).unwrap();
        write(out, Format::Exr, Encoding::default(), header, |_, bytes| {
            bytes.copy_from_slice(&[255, 188, 0, 255, 255, 188, 0, 51]);
            Ok(())
        })
        .unwrap();
        let image = read_first_rgba_layer_from_file(
            &path,
            |size, _| vec![[0.0; 4]; size.area()],
            |px: &mut Vec<[f32; 4]>, at, (r, g, b, a): (f32, f32, f32, f32)| px[at.0] = [r, g, b, a],
        )
        .unwrap();
        // 188 of 255 is about half the light.
        let expected = [[1.0, 0.5029, 0.0, 1.0], [0.2, 0.1006, 0.0, 0.2]];
        for (found, expected) in image.layer_data.channel_data.pixels.iter().zip(expected) {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?}");
        }
    }

    #[test]
    fn a_jpeg_with_opacity_is_an_error() {
        let header = Header::new([2, 1], Samples::Rgba8);
        let out = io::Cursor::new(Vec::new());
        let error =
            write(out, Format::Jpeg, Encoding::default(), header, |_, _| Ok(())).unwrap_err().to_string();
        assert!(error.contains("JPEG") && error.contains("Rgba8"), "{error}");
    }

    /// Counts the bytes that are written after the cancellation.
    struct Counting<'a> {
        file: io::Cursor<Vec<u8>>,
        cancelled: &'a Cell<bool>,
        late: &'a Cell<usize>,
    }

    impl Write for Counting<'_> {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if self.cancelled.get() {
                self.late.set(self.late.get() + bytes.len());
            }
            self.file.write(bytes)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Seek for Counting<'_> {
        fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
            self.file.seek(to)
        }
    }

    #[test]
    fn after_it_is_cancelled_no_more_rows_are_painted_and_hardly_a_byte_is_written() {
        // Noise is not compressed: the whole picture is 24 MB.
        let size = [2048, 4096];
        for format in [Format::Png, Format::Tiff, Format::Exr, Format::Jpeg, Format::Webp] {
            let (cancelled, late, bands) = (Cell::new(false), Cell::new(0), Cell::new(0));
            let out = Counting { file: io::Cursor::new(Vec::new()), cancelled: &cancelled, late: &late };
            let ended =
                write(out, format, Encoding::default(), Header::new(size, Samples::Rgb8), |rows, bytes| {
                    assert!(!cancelled.get(), "{format:?}: painted after it was cancelled");
                    bands.set(bands.get() + 1);
                    if rows.end > size[1] / 2 {
                        cancelled.set(true);
                        return Err(Stopped::Cancelled);
                    }
                    let mut noise = rows.start as u32;
                    bytes.iter_mut().for_each(|byte| {
                        noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                        *byte = (noise >> 24) as u8;
                    });
                    Ok(())
                });
            assert!(matches!(ended, Err(Stopped::Cancelled)), "{format:?}");
            // Bytes still held by the compressor of a PNG: less than a hundredth.
            assert!(late.get() <= 1 << 18, "{format:?}: {} bytes", late.get());
            assert!(bands.get() >= 2, "{format:?}");
        }
    }

    #[test]
    fn a_webp_that_is_being_encoded_is_cancelled_and_nothing_is_written() {
        let (cancelled, late) = (Cell::new(false), Cell::new(0));
        let out = Counting { file: io::Cursor::new(Vec::new()), cancelled: &cancelled, late: &late };
        let size = [4096, 4096];
        let ended =
            write(out, Format::Webp, Encoding::default(), Header::new(size, Samples::Rgb8), |rows, bytes| {
                // All rows are painted: now it is encoded.
                if rows.is_empty() {
                    cancelled.set(true);
                    return Err(Stopped::Cancelled);
                }
                bytes.iter_mut().enumerate().for_each(|(i, byte)| *byte = ((i * i) >> 7) as u8);
                Ok(())
            });
        assert!(matches!(ended, Err(Stopped::Cancelled)) && late.get() == 0, "{}", late.get());
    }
}
