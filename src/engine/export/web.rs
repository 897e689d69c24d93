//! JPEG and lossless WebP: 8-bit colours for the web.

use std::cell::RefCell;
use std::io::{self, Write};
use std::ops::Range;

use image::codecs::jpeg::{JpegEncoder, PixelDensity};
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, GenericImageView, ImageError, Rgb};

use super::Stopped;
use super::png::{Header, Samples};

/// Number of rows that the JPEG encoder reads at a time: blocks of 8 × 8 px.
const BLOCK_ROWS: usize = 8;
/// Number of rows of one band, enough for all threads.
const BAND_ROWS: usize = 16 * BLOCK_ROWS;

/// Work that cannot be interrupted.
pub type Work = Box<dyn FnOnce() -> io::Result<Vec<u8>> + Send>;

/// Runs work that cannot be interrupted, and meanwhile asks repeatedly whether to continue. If the answer is an error, this error
/// is returned at once, and the work ends by itself later. Such a function needs a thread and a clock, which the caller provides;
/// [`at_once`] needs neither.
pub type Aside = fn(Work, &mut dyn FnMut() -> Result<(), Stopped>) -> Result<Vec<u8>, Stopped>;

/// Asks once whether to continue, and then runs the work.
///
/// # Errors
/// The errors of the work and of the answer.
pub fn at_once(work: Work, goes_on: &mut dyn FnMut() -> Result<(), Stopped>) -> Result<Vec<u8>, Stopped> {
    goes_on()?;
    Ok(work()?)
}

/// Writes a picture as a JPEG of `quality` 1 to 100, band by band like [`super::png::write()`]; only [`Samples::Rgb8`].
///
/// JPEG File Interchange Format 1.02; colours at half the resolution across (4:2:2).
///
/// # Errors
/// The errors of `out` and `fill`; a side of more than 65535 px.
pub fn jpeg(
    out: impl Write,
    header: Header,
    quality: u8,
    mut fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let band = RefCell::new(Band { top: 0, rgb: Vec::new(), stopped: None });
    let out = Until { out, band: &band };
    let mut encoder = JpegEncoder::new_with_quality(out, quality.clamp(1, 100));
    if let Some(dpi) = header.dpi {
        encoder.set_pixel_density(PixelDensity::dpi(dpi.round().clamp(1.0, 65_535.0) as u16));
    }
    let size = header.sides()?;
    let bands = Bands { size, fill: RefCell::new(&mut fill), band: &band };
    let written = encoder.encode_image(&bands);
    // Not an `into_inner`: the encoder borrows it.
    let stopped = band.borrow_mut().stopped.take();
    match stopped {
        Some(stopped) => Err(stopped),
        None => Ok(written.map_err(into_io)?),
    }
}

/// A file whose writes fail after `fill` has stopped, which ends the encoder.
struct Until<'a, W> {
    out: W,
    band: &'a RefCell<Band>,
}

impl<W: Write> Write for Until<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.band.borrow().stopped {
            Some(_) => Err(io::Error::other("stopped")),
            None => self.out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

type Fill<'a> = dyn FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped> + 'a;

/// The current rows, and the reason why `fill` stopped.
struct Band {
    top: usize,
    rgb: Vec<u8>,
    stopped: Option<Stopped>,
}

/// A picture of which only the current rows are in memory.
struct Bands<'a> {
    size: [u32; 2],
    fill: RefCell<&'a mut Fill<'a>>,
    band: &'a RefCell<Band>,
}

impl GenericImageView for Bands<'_> {
    type Pixel = Rgb<u8>;

    fn dimensions(&self) -> (u32, u32) {
        (self.size[0], self.size[1])
    }

    fn get_pixel(&self, x: u32, y: u32) -> Rgb<u8> {
        let [width, height] = self.size.map(|side| side as usize);
        let (x, y) = (x as usize, y as usize);
        let mut band = self.band.borrow_mut();
        if !(band.top..band.top + band.rgb.len() / (3 * width)).contains(&y) {
            let top = y / BAND_ROWS * BAND_ROWS;
            let rows = top..height.min(top + BAND_ROWS);
            band.top = top;
            band.rgb.resize(3 * width * rows.len(), 0);
            // After an error the encoder may read some more px, until it writes.
            if band.stopped.is_none() {
                band.stopped = (self.fill.borrow_mut())(rows, &mut band.rgb).err();
            }
        }
        let px = 3 * ((y - band.top) * width + x);
        Rgb([band.rgb[px], band.rgb[px + 1], band.rgb[px + 2]])
    }
}

/// Writes a picture as a lossless WebP, with rows from `fill` as in [`super::png::write()`]; only [`Samples::Rgb8`] and
/// [`Samples::Rgba8`]. Its encoder needs the whole picture in memory, see [`super::Format::writer_bytes_per_px`]. `dpi` is not
/// written.
///
/// The encoder cannot be stopped, so it runs as [`Aside`] work. Meanwhile `fill` is called without rows, so that it can cancel.
///
/// # Errors
/// The errors of `out` and `fill`; a side of more than 16383 px.
pub fn webp(
    mut out: impl Write,
    header: Header,
    aside: Aside,
    mut fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let [width, height] = header.sides()?;
    let row = header.size[0] * header.samples.bytes();
    let mut px = vec![0; row * header.size[1]];
    for (band, bytes) in px.chunks_mut(row * BAND_ROWS).enumerate() {
        let top = band * BAND_ROWS;
        fill(top..top + bytes.len() / row, bytes)?;
    }
    let opaque = header.samples == Samples::Rgb8;
    let colours = if opaque { ExtendedColorType::Rgb8 } else { ExtendedColorType::Rgba8 };
    let work = move || {
        let mut encoded = Vec::new();
        WebPEncoder::new_lossless(&mut encoded).encode(&px, width, height, colours).map_err(into_io)?;
        Ok(encoded)
    };
    let encoded = aside(Box::new(work), &mut || fill(header.size[1]..header.size[1], &mut []))?;
    Ok(out.write_all(&encoded)?)
}

fn into_io(error: ImageError) -> io::Error {
    match error {
        ImageError::IoError(error) => error,
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::ImageFormat;

    /// A smooth picture, which JPEG changes little.
    fn shade(x: usize, y: usize, channel: usize) -> u8 {
        (128.0 + 100.0 * ((x as f64 / 40.0 + y as f64 / 57.0 + channel as f64).sin())) as u8
    }

    fn fill(size: [usize; 2], channels: usize) -> impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped> {
        move |rows, bytes| {
            for (i, out) in bytes.iter_mut().enumerate() {
                let px = i / channels;
                *out = shade(px % size[0], rows.start + px / size[0], i % channels);
            }
            Ok(())
        }
    }

    #[test]
    fn a_jpeg_of_many_bands_is_read_back_nearly_with_its_px_an_inch() {
        let size = [301, 403];
        let mut bytes = Vec::new();
        let header = Header { dpi: Some(300.0), ..Header::new(size, Samples::Rgb8) };
        jpeg(&mut bytes, header, 95, fill(size, 3)).unwrap();
        // JFIF: the unit is the inch, then the density both ways.
        assert_eq!(bytes[13..18], [1, 1, 44, 1, 44]);
        let read = image::load_from_memory_with_format(&bytes, ImageFormat::Jpeg).unwrap().into_rgb8();
        assert_eq!(read.dimensions(), (301, 403));
        for (x, y, px) in read.enumerate_pixels() {
            for channel in 0..3 {
                let off = i32::from(px.0[channel]) - i32::from(shade(x as usize, y as usize, channel));
                assert!(off.abs() <= 12, "{x},{y}: {off}");
            }
        }
    }

    #[test]
    fn a_webp_is_read_back_exactly() {
        for (samples, channels) in [(Samples::Rgb8, 3), (Samples::Rgba8, 4)] {
            let size = [131, 301];
            let mut bytes = Vec::new();
            webp(&mut bytes, Header::new(size, samples), at_once, fill(size, channels)).unwrap();
            let read = image::load_from_memory_with_format(&bytes, ImageFormat::WebP).unwrap();
            let mut expected = vec![0; size[0] * size[1] * channels];
            fill(size, channels)(0..size[1], &mut expected).unwrap();
            assert!(read.into_bytes() == expected);
        }
    }

    #[test]
    fn a_cancelled_jpeg_is_an_error() {
        let header = Header::new([9, 9], Samples::Rgb8);
        assert!(matches!(
            jpeg(io::sink(), header, 90, |_, _| Err(Stopped::Cancelled)),
            Err(Stopped::Cancelled)
        ));
    }
}
