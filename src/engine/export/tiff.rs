//! TIFF: uncompressed strips of 8 or 16 bit, with px an inch.
//!
//! TIFF Revision 6.0 (Adobe, 1992); BigTIFF above 4 GB.

use std::io::{self, Seek, Write};
use std::ops::Range;

use tiff::TiffError;
use tiff::encoder::colortype::{ColorType, Gray8, Gray16, RGB8, RGB16, RGBA8, RGBA16};
use tiff::encoder::{Rational, TiffEncoder, TiffKind, TiffValue};
use tiff::tags::{ResolutionUnit, Tag};

use super::Stopped;
use super::png::{Header, Samples};

/// Most bytes of px in a file with 32-bit offsets, with a margin for the tags.
const CLASSIC: u64 = (u32::MAX - (1 << 20)) as u64;
/// Bytes of the largest strip; one row may be larger.
const STRIP: usize = 8 << 20;

/// Writes a picture as a TIFF, band by band like [`super::png::write()`]; texts are not written.
///
/// # Errors
/// The errors of `out` and `fill`; a size that TIFF cannot hold.
pub fn write(
    out: impl Write + Seek,
    header: Header,
    fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let bytes = (header.size[0] * header.samples.bytes()) as u64 * header.size[1] as u64;
    if bytes > CLASSIC {
        write_samples(TiffEncoder::new_big(out).map_err(into_io)?, header, fill)
    } else {
        write_samples(TiffEncoder::new(out).map_err(into_io)?, header, fill)
    }
}

fn write_samples<W: Write + Seek, K: TiffKind>(
    encoder: TiffEncoder<W, K>,
    header: Header,
    fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let byte = |bytes: &[u8], values: &mut Vec<u8>| values.extend_from_slice(bytes);
    let two = |bytes: &[u8], values: &mut Vec<u16>| {
        values.extend(bytes.chunks_exact(2).map(|two| u16::from_be_bytes([two[0], two[1]])));
    };
    match header.samples {
        Samples::Gray8 => strips::<Gray8, _, _>(encoder, header, byte, fill),
        Samples::Gray16 => strips::<Gray16, _, _>(encoder, header, two, fill),
        Samples::Rgb8 => strips::<RGB8, _, _>(encoder, header, byte, fill),
        Samples::Rgb16 => strips::<RGB16, _, _>(encoder, header, two, fill),
        Samples::Rgba8 => strips::<RGBA8, _, _>(encoder, header, byte, fill),
        Samples::Rgba16 => strips::<RGBA16, _, _>(encoder, header, two, fill),
    }
}

fn strips<C: ColorType, W: Write + Seek, K: TiffKind>(
    mut encoder: TiffEncoder<W, K>,
    header: Header,
    read: impl Fn(&[u8], &mut Vec<C::Inner>),
    mut fill: impl FnMut(Range<usize>, &mut [u8]) -> Result<(), Stopped>,
) -> Result<(), Stopped>
where
    [C::Inner]: TiffValue,
{
    let [width, height] = header.size;
    let [w, h] = header.sides()?;
    let mut image = encoder.new_image::<C>(w, h).map_err(into_io)?;
    let row = width * header.samples.bytes();
    let rows_a_strip = (STRIP / row).clamp(1, height);
    image.rows_per_strip(u32::try_from(rows_a_strip).unwrap_or(h)).map_err(into_io)?;
    if let Some(dpi) = header.dpi {
        // In thousandths, so that 72.27 is not rounded to 72.
        let density = Rational { n: (1000.0 * dpi).round() as u32, d: 1000 };
        image.resolution(ResolutionUnit::Inch, density);
    }
    if matches!(header.samples, Samples::Rgba8 | Samples::Rgba16) {
        // 2 = the colours are not multiplied by the opacity.
        image.encoder().write_tag(Tag::ExtraSamples, &[2_u16][..]).map_err(into_io)?;
    }
    let mut bytes = vec![0; rows_a_strip * row];
    let mut values = Vec::new();
    for top in (0..height).step_by(rows_a_strip) {
        let rows = top..height.min(top + rows_a_strip);
        let bytes = &mut bytes[..rows.len() * row];
        fill(rows, bytes)?;
        values.clear();
        read(bytes, &mut values);
        image.write_strip(&values).map_err(into_io)?;
    }
    Ok(image.finish().map_err(into_io)?)
}

fn into_io(error: TiffError) -> io::Error {
    match error {
        TiffError::IoError(error) => error,
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tiff::decoder::{Decoder, DecodingResult};

    fn written(header: Header, shade: impl Fn(usize) -> u8) -> Decoder<io::Cursor<Vec<u8>>> {
        let mut out = io::Cursor::new(Vec::new());
        let row = header.size[0] * header.samples.bytes();
        write(&mut out, header, |rows, bytes| {
            bytes.iter_mut().enumerate().for_each(|(i, out)| *out = shade(rows.start * row + i));
            Ok(())
        })
        .unwrap();
        Decoder::new(io::Cursor::new(out.into_inner())).unwrap()
    }

    #[test]
    fn sixteen_bit_of_many_strips_are_read_back() {
        let header = Header { dpi: Some(72.27), ..Header::new([2100, 1203], Samples::Rgb16) };
        let shade = |i: usize| (i * 37 % 251) as u8;
        let mut read = written(header, shade);
        assert_eq!(read.dimensions().unwrap(), (2100, 1203));
        let density = read.get_tag(Tag::XResolution).unwrap();
        assert_eq!(format!("{density:?}"), "Rational(72270, 1000)");
        assert_eq!(read.get_tag_u32(Tag::ResolutionUnit).unwrap(), 2);
        let DecodingResult::U16(values) = read.read_image().unwrap() else { panic!("not 16 bit") };
        assert_eq!(values.len(), 3 * 2100 * 1203);
        let two = |i: usize| u16::from_be_bytes([shade(2 * i), shade(2 * i + 1)]);
        assert!(values.iter().enumerate().all(|(i, value)| *value == two(i)));
    }

    #[test]
    fn opacity_is_marked_as_unassociated() {
        let mut read = written(Header::new([3, 2], Samples::Rgba8), |i| i as u8);
        assert_eq!(read.get_tag_u32(Tag::ExtraSamples).unwrap(), 2);
        let DecodingResult::U8(values) = read.read_image().unwrap() else { panic!("not 8 bit") };
        assert_eq!(values, (0..24).collect::<Vec<u8>>());
    }
}
