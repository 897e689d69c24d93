//! PNG: 8-bit colour, 8- and 16-bit gray, with the px an inch.
//!
//! PNG Specification, third edition (W3C).

use std::io::{self, Write};
use std::ops::Range;

use png::{
    BitDepth, ColorType, Compression, Encoder, EncodingError, Filter, PixelDimensions, SrgbRenderingIntent,
    Unit,
};

use super::Stopped;
use crate::field::{Field, to_u16};

/// What a px consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Samples {
    /// One byte: a label.
    Gray8,
    /// Two bytes, the higher first: a pattern value.
    Gray16,
    /// Red, green, blue, a byte each: 8-bit sRGB.
    Rgb8,
}

impl Samples {
    /// Bytes a px.
    #[must_use]
    pub fn bytes(self) -> usize {
        match self {
            Self::Gray8 => 1,
            Self::Gray16 => 2,
            Self::Rgb8 => 3,
        }
    }
}

/// What stands at the head of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Header {
    /// Width and height, px; each at least 1.
    pub size: [usize; 2],
    /// What a px consists of.
    pub samples: Samples,
    /// px an inch, both ways; `None` leaves it open.
    pub dpi: Option<f64>,
}

/// Bytes that are asked for at once: enough rows to be filled by all threads, little beside the picture.
const BAND: usize = 8 << 20;
/// Bytes of one IDAT chunk.
const CHUNK: usize = 256 << 10;

/// Writes a picture of any height without holding it: `fill` is asked for band after band, from the top, and
/// puts the bytes of the rows that it is given into the slice, `size[0] * samples.bytes()` a row.
///
/// The same rows give the same bytes, whatever filled them.
///
/// # Errors
/// What `out` or `fill` fails with; a size that PNG cannot hold.
pub fn write(
    out: impl Write,
    header: Header,
    mut fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let [width, height] = header.size;
    let mut writer = encoder(out, header)?.write_header().map_err(into_io)?;
    let mut stream = writer.stream_writer_with_size(CHUNK).map_err(into_io)?;
    let row = (width * header.samples.bytes()).max(1);
    let rows_a_band = (BAND / row).clamp(1, height.max(1));
    let mut band = vec![0; rows_a_band * row];
    for top in (0..height).step_by(rows_a_band) {
        let rows = top..height.min(top + rows_a_band);
        let bytes = &mut band[..rows.len() * row];
        fill(rows, bytes)?;
        stream.write_all(bytes)?;
    }
    stream.finish().map_err(into_io)?;
    Ok(writer.finish().map_err(into_io)?)
}

/// A painted picture: three bytes a px, as [`crate::colour`] makes it.
///
/// # Errors
/// As [`write()`]; `rgb` too short for `size`.
pub fn rgb8(out: impl Write, size: [usize; 2], dpi: Option<f64>, rgb: &[u8]) -> Result<(), Stopped> {
    whole(out, Header { size, samples: Samples::Rgb8, dpi }, rgb)
}

/// A label picture: one byte a px.
///
/// # Errors
/// As [`write()`]; `labels` too short for `size`.
pub fn gray8(out: impl Write, size: [usize; 2], dpi: Option<f64>, labels: &[u8]) -> Result<(), Stopped> {
    whole(out, Header { size, samples: Samples::Gray8, dpi }, labels)
}

/// A pattern: 0..1 becomes 0..65535, rounded; values outside are clipped.
///
/// # Errors
/// As [`write()`].
pub fn gray16(out: impl Write, pattern: &Field, dpi: Option<f64>) -> Result<(), Stopped> {
    let size = [pattern.width, pattern.height];
    write(out, Header { size, samples: Samples::Gray16, dpi }, |rows, bytes| {
        let values = &pattern.values[rows.start * pattern.width..rows.end * pattern.width];
        for (pair, &value) in bytes.chunks_exact_mut(2).zip(values) {
            pair.copy_from_slice(&to_u16(value).to_be_bytes());
        }
        Ok(())
    })
}

fn whole(out: impl Write, header: Header, bytes: &[u8]) -> Result<(), Stopped> {
    let row = header.size[0] * header.samples.bytes();
    write(out, header, |rows, band| {
        let there = bytes.get(rows.start * row..rows.end * row);
        let there = there.ok_or_else(|| io::Error::other("the picture holds fewer px than its size says"))?;
        band.copy_from_slice(there);
        Ok(())
    })
}

fn encoder<W: Write>(out: W, header: Header) -> Result<Encoder<'static, W>, Stopped> {
    let side = |px: usize| {
        u32::try_from(px).map_err(|_| io::Error::other(format!("{px} px a side are more than PNG can hold")))
    };
    let mut encoder = Encoder::new(out, side(header.size[0])?, side(header.size[1])?);
    let (colour, depth) = match header.samples {
        Samples::Gray8 => (ColorType::Grayscale, BitDepth::Eight),
        Samples::Gray16 => (ColorType::Grayscale, BitDepth::Sixteen),
        Samples::Rgb8 => (ColorType::Rgb, BitDepth::Eight),
    };
    encoder.set_color(colour);
    encoder.set_depth(depth);
    // Smooth patterns of 2048² px, RGB: fast 45 ms and 3.0 MB, balanced 450 ms and 1.3 MB; picking the best
    // filter row by row doubles the time of fast and saves nothing over Paeth's.
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Paeth);
    if header.samples == Samples::Rgb8 {
        // Patterns and labels are numbers: no viewer's colour management should touch them.
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    }
    if let Some(dpi) = header.dpi {
        // pHYs counts px a metre; an inch is 0.0254 m.
        let a_metre = (dpi / 0.0254).round() as u32;
        encoder.set_pixel_dims(Some(PixelDimensions { xppu: a_metre, yppu: a_metre, unit: Unit::Meter }));
    }
    Ok(encoder)
}

fn into_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Edges;

    /// Decoded bytes and the head's px a metre.
    fn read(bytes: &[u8]) -> (Vec<u8>, png::OutputInfo, Option<u32>) {
        let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        let a_metre = reader.info().pixel_dims.map(|dims| {
            assert_eq!((dims.xppu, dims.unit), (dims.yppu, Unit::Meter));
            dims.xppu
        });
        (pixels, info, a_metre)
    }

    #[test]
    fn a_painted_picture_comes_back_with_its_px_an_inch() {
        let rgb: Vec<u8> = (0..3 * 7 * 5).map(|i| (i * 37 % 256) as u8).collect();
        let mut bytes = Vec::new();
        rgb8(&mut bytes, [7, 5], Some(300.0), &rgb).unwrap();
        let (pixels, info, a_metre) = read(&bytes);
        assert_eq!((pixels, info.width, info.height), (rgb, 7, 5));
        assert_eq!((info.color_type, info.bit_depth), (ColorType::Rgb, BitDepth::Eight));
        assert_eq!(a_metre, Some(11811));
    }

    #[test]
    fn a_pattern_comes_back_to_the_nearest_16_bit_step() {
        let values = [-0.5, 0.0, 0.5, 1.0, 1.5, 0.25 / 65535.0, 0.75 / 65535.0, 258.0 / 65535.0];
        let pattern = Field { values: values.to_vec(), ..Field::flat(4, 2, Edges::Closed, 0.0) };
        let mut bytes = Vec::new();
        gray16(&mut bytes, &pattern, None).unwrap();
        let (pixels, info, a_metre) = read(&bytes);
        assert_eq!((info.color_type, info.bit_depth), (ColorType::Grayscale, BitDepth::Sixteen));
        assert_eq!(a_metre, None);
        let steps: Vec<u16> = pixels.chunks(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect();
        assert_eq!(steps, [0, 0, 32768, 65535, 65535, 0, 1, 258]);
    }

    #[test]
    fn labels_come_back() {
        let mut bytes = Vec::new();
        gray8(&mut bytes, [3, 2], Some(72.0), &[0, 1, 2, 255, 1, 0]).unwrap();
        let (pixels, info, a_metre) = read(&bytes);
        assert_eq!((pixels, info.color_type), (vec![0, 1, 2, 255, 1, 0], ColorType::Grayscale));
        assert_eq!(a_metre, Some(2835));
    }

    #[test]
    fn a_picture_of_many_bands_is_asked_for_once_a_row_and_comes_back() {
        let size = [3000, 3001];
        let shade = |x: usize, y: usize| ((x * x + 3 * y * y) / 977 % 256) as u8;
        let mut next = 0;
        let mut bytes = Vec::new();
        write(&mut bytes, Header { size, samples: Samples::Gray8, dpi: None }, |rows, band| {
            assert_eq!((rows.start, band.len()), (next, rows.len() * size[0]));
            next = rows.end;
            for (row, y) in band.chunks_mut(size[0]).zip(rows) {
                row.iter_mut().enumerate().for_each(|(x, px)| *px = shade(x, y));
            }
            Ok(())
        })
        .unwrap();
        assert_eq!(next, size[1]);
        let (pixels, ..) = read(&bytes);
        assert!(pixels.iter().enumerate().all(|(i, &px)| px == shade(i % size[0], i / size[0])));
    }

    #[test]
    fn what_cannot_be_a_picture_is_an_error() {
        assert!(rgb8(io::sink(), [2, 2], None, &[0; 11]).is_err());
        assert!(rgb8(io::sink(), [0, 2], None, &[]).is_err());
        let header = Header { size: [2, 2], samples: Samples::Rgb8, dpi: None };
        assert!(matches!(write(io::sink(), header, |_, _| Err(Stopped::Cancelled)), Err(Stopped::Cancelled)));
    }
}
