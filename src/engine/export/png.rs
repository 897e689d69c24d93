//! PNG: 8 and 16 bit, gray, colour and opacity, with px an inch and texts.
//!
//! PNG Specification, third edition (W3C).

use std::io::{self, Write};
use std::ops::Range;

use png::{
    BitDepth, ColorType, Compression, Encoder, EncodingError, Filter, PixelDimensions, SrgbRenderingIntent,
    StreamWriter, Unit,
};

use super::Stopped;
use crate::grid::{Field, to_u16};

/// The samples of a px.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Samples {
    /// One byte, such as a label.
    Gray8,
    /// Two bytes, big-endian, such as a pattern value.
    Gray16,
    /// Red, green, blue, a byte each: 8-bit sRGB.
    Rgb8,
    /// Red, green, blue, opacity, a byte each; the colours are not multiplied by the opacity.
    Rgba8,
    /// Red, green, blue, two bytes each, big-endian: 16-bit sRGB.
    Rgb16,
    /// Red, green, blue, opacity, two bytes each, big-endian.
    Rgba16,
}

impl Samples {
    /// Colours of 16 bits if `deep`, with opacity if `transparent`.
    #[must_use]
    pub fn colours(deep: bool, transparent: bool) -> Self {
        match (deep, transparent) {
            (false, false) => Self::Rgb8,
            (false, true) => Self::Rgba8,
            (true, false) => Self::Rgb16,
            (true, true) => Self::Rgba16,
        }
    }

    /// Bytes a px.
    #[must_use]
    pub fn bytes(self) -> usize {
        match self {
            Self::Gray8 => 1,
            Self::Gray16 => 2,
            Self::Rgb8 => 3,
            Self::Rgba8 => 4,
            Self::Rgb16 => 6,
            Self::Rgba16 => 8,
        }
    }
}

/// The properties of a picture file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Header<'a> {
    /// Width and height, px; each at least 1.
    pub size: [usize; 2],
    /// The samples of a px.
    pub samples: Samples,
    /// px an inch along both axes; `None` = not written.
    pub dpi: Option<f64>,
    /// Texts with their keys of 1 to 79 Latin-1 characters (iTXt chunks); written in PNG only.
    pub texts: &'a [(&'static str, String)],
    /// Whether red, green and blue are a colour. If not, they are numbers, and the file is not marked as sRGB.
    pub colours: bool,
}

impl Header<'_> {
    /// Properties without px an inch and without texts.
    #[must_use]
    pub fn new(size: [usize; 2], samples: Samples) -> Self {
        Self { size, samples, dpi: None, texts: &[], colours: true }
    }

    /// Width and height as 32-bit numbers.
    pub(super) fn sides(&self) -> Result<[u32; 2], Stopped> {
        let side = |px: usize| {
            let whole = u32::try_from(px).ok().filter(|px| *px > 0);
            whole.ok_or_else(|| io::Error::other(format!("a picture cannot have a side of {px} px")))
        };
        Ok([side(self.size[0])?, side(self.size[1])?])
    }
}

/// Bytes of one band of rows: enough for all threads, few compared with the picture.
const BAND: usize = 8 << 20;
/// Bytes of one IDAT chunk.
const CHUNK: usize = 256 << 10;

/// Writes a picture of any height without holding it in memory: `fill` is called for band after band, from the top, and writes the
/// bytes of the given rows into the slice, `size[0] * samples.bytes()` a row.
///
/// Equal rows give equal files.
///
/// # Errors
/// The errors of `out` and `fill`; a size that PNG cannot hold.
pub fn write(
    out: impl Write,
    header: Header,
    mut fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let [width, height] = header.size;
    let mut file = Started::new(out, header)?;
    let mut rows_out = file.rows()?;
    let row = (width * header.samples.bytes()).max(1);
    let rows_a_band = (BAND / row).clamp(1, height.max(1));
    let mut band = vec![0; rows_a_band * row];
    for top in (0..height).step_by(rows_a_band) {
        let rows = top..height.min(top + rows_a_band);
        let bytes = &mut band[..rows.len() * row];
        fill(rows, bytes)?;
        rows_out.push(bytes)?;
    }
    rows_out.finish()?;
    file.finish()
}

/// A writer that keeps failing after its first error. `png` 0.18 does not report an error while it writes the last rows, but it
/// reports one at the end of the file.
struct Fused<W> {
    out: W,
    failed: Option<io::ErrorKind>,
}

impl<W> Fused<W> {
    fn try_once<T>(&mut self, act: impl FnOnce(&mut W) -> io::Result<T>) -> io::Result<T> {
        if let Some(kind) = self.failed {
            return Err(kind.into());
        }
        let done = act(&mut self.out);
        if let Err(error) = &done
            && error.kind() != io::ErrorKind::Interrupted
        {
            self.failed = Some(error.kind());
        }
        done
    }
}

impl<W: Write> Write for Fused<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.try_once(|out| out.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.try_once(W::flush)
    }
}

/// A PNG with its head written, for writing several files at once.
pub struct Started<W: Write>(png::Writer<Fused<W>>);

impl<W: Write> Started<W> {
    /// Writes the head.
    ///
    /// # Errors
    /// The error of `out`; a size that PNG cannot hold.
    pub fn new(out: W, header: Header) -> Result<Self, Stopped> {
        let out = Fused { out, failed: None };
        Ok(Self(encoder(out, header)?.write_header().map_err(into_io)?))
    }

    /// Starts to write the rows, from the top. Called once.
    ///
    /// # Errors
    /// The error of the file.
    pub fn rows(&mut self) -> Result<Rows<'_, W>, Stopped> {
        Ok(Rows(self.0.stream_writer_with_size(CHUNK).map_err(into_io)?))
    }

    /// Ends the file after all rows.
    ///
    /// # Errors
    /// The error of the file.
    pub fn finish(self) -> Result<(), Stopped> {
        Ok(self.0.finish().map_err(into_io)?)
    }
}

/// The rows of a PNG.
pub struct Rows<'a, W: Write>(StreamWriter<'a, Fused<W>>);

impl<W: Write> Rows<'_, W> {
    /// Writes the bytes of the next rows.
    ///
    /// # Errors
    /// The error of the file; more rows than the head says.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), Stopped> {
        Ok(self.0.write_all(bytes)?)
    }

    /// Ends the file after all rows.
    ///
    /// # Errors
    /// The error of the file; fewer rows than the head says.
    pub fn finish(self) -> Result<(), Stopped> {
        Ok(self.0.finish().map_err(into_io)?)
    }
}

/// Writes a painted picture: three bytes a px, red, green, blue.
///
/// ```
/// use dapple_engine::export::png;
///
/// let mut file = Vec::new();
/// png::rgb8(&mut file, [2, 1], Some(300.0), &[255, 0, 0, 0, 0, 255])?;
/// assert_eq!(file[..4], *b"\x89PNG");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The errors of [`write()`]; `rgb` too short for `size`.
pub fn rgb8(out: impl Write, size: [usize; 2], dpi: Option<f64>, rgb: &[u8]) -> Result<(), Stopped> {
    whole(out, Header { dpi, ..Header::new(size, Samples::Rgb8) }, rgb)
}

/// Writes a label picture of one byte a px.
///
/// # Errors
/// The errors of [`write()`]; `labels` too short for `size`.
pub fn gray8(out: impl Write, size: [usize; 2], dpi: Option<f64>, labels: &[u8]) -> Result<(), Stopped> {
    whole(out, Header { dpi, ..Header::new(size, Samples::Gray8) }, labels)
}

/// Writes a pattern: 0..1 becomes 0..65535, rounded; values outside are clipped.
///
/// # Errors
/// The errors of [`write()`].
pub fn gray16(out: impl Write, pattern: &Field, dpi: Option<f64>) -> Result<(), Stopped> {
    let size = [pattern.width, pattern.height];
    write(out, Header { dpi, ..Header::new(size, Samples::Gray16) }, |rows, bytes| {
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
        let source = bytes.get(rows.start * row..rows.end * row);
        let source =
            source.ok_or_else(|| io::Error::other("the picture has fewer px than its size needs"))?;
        band.copy_from_slice(source);
        Ok(())
    })
}

fn encoder<W: Write>(out: W, header: Header) -> Result<Encoder<'static, W>, Stopped> {
    let [width, height] = header.sides()?;
    let mut encoder = Encoder::new(out, width, height);
    let (colour, depth) = match header.samples {
        Samples::Gray8 => (ColorType::Grayscale, BitDepth::Eight),
        Samples::Gray16 => (ColorType::Grayscale, BitDepth::Sixteen),
        Samples::Rgb8 => (ColorType::Rgb, BitDepth::Eight),
        Samples::Rgb16 => (ColorType::Rgb, BitDepth::Sixteen),
        Samples::Rgba8 => (ColorType::Rgba, BitDepth::Eight),
        Samples::Rgba16 => (ColorType::Rgba, BitDepth::Sixteen),
    };
    encoder.set_color(colour);
    encoder.set_depth(depth);
    // Smooth patterns of 2048² px, RGB: fast takes 45 ms and 3.0 MB, balanced 450 ms and 1.3 MB. Choosing the best filter
    // for each row doubles the time of fast and saves nothing compared with Paeth's.
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Paeth);
    if header.colours && !matches!(header.samples, Samples::Gray8 | Samples::Gray16) {
        // Patterns and labels are numbers: colour management must not change them.
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    }
    if let Some(dpi) = header.dpi {
        // pHYs counts px a metre; an inch is 0.0254 m.
        let a_metre = (dpi / 0.0254).round() as u32;
        encoder.set_pixel_dims(Some(PixelDimensions { xppu: a_metre, yppu: a_metre, unit: Unit::Meter }));
    }
    for (key, text) in header.texts {
        encoder.add_itxt_chunk((*key).to_owned(), text.clone()).map_err(into_io)?;
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
    use crate::grid::Edges;

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
    fn a_painted_picture_is_read_back_with_its_px_an_inch() {
        let rgb: Vec<u8> = (0..3 * 7 * 5).map(|i| (i * 37 % 256) as u8).collect();
        let mut bytes = Vec::new();
        rgb8(&mut bytes, [7, 5], Some(300.0), &rgb).unwrap();
        let (pixels, info, a_metre) = read(&bytes);
        assert_eq!((pixels, info.width, info.height), (rgb, 7, 5));
        assert_eq!((info.color_type, info.bit_depth), (ColorType::Rgb, BitDepth::Eight));
        assert_eq!(a_metre, Some(11811));
    }

    #[test]
    fn a_pattern_is_rounded_to_the_nearest_16_bit_step() {
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
    fn labels_are_read_back() {
        let mut bytes = Vec::new();
        gray8(&mut bytes, [3, 2], Some(72.0), &[0, 1, 2, 255, 1, 0]).unwrap();
        let (pixels, info, a_metre) = read(&bytes);
        assert_eq!((pixels, info.color_type), (vec![0, 1, 2, 255, 1, 0], ColorType::Grayscale));
        assert_eq!(a_metre, Some(2835));
    }

    #[test]
    fn each_row_of_a_picture_of_many_bands_is_filled_once() {
        let size = [3000, 3001];
        let shade = |x: usize, y: usize| ((x * x + 3 * y * y) / 977 % 256) as u8;
        let mut next = 0;
        let mut bytes = Vec::new();
        write(&mut bytes, Header::new(size, Samples::Gray8), |rows, band| {
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
    fn impossible_pictures_are_errors() {
        assert!(rgb8(io::sink(), [2, 2], None, &[0; 11]).is_err());
        assert!(rgb8(io::sink(), [0, 2], None, &[]).is_err());
        let header = Header::new([2, 2], Samples::Rgb8);
        assert!(matches!(write(io::sink(), header, |_, _| Err(Stopped::Cancelled)), Err(Stopped::Cancelled)));
    }
}
