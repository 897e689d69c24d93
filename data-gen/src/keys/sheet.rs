//! Two pictures side by side in a small file.

use std::io::Write;
use std::path::Path;

use dapple::files;
use dapple_engine::export::downscale;
use dapple_engine::export::motion::median_cut;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, Filter};

use super::grown::Grown;

/// Px between the pictures.
const GAP: usize = 8;
/// The colour there.
const PAPER: u8 = 255;
/// Four px of a file stand for five of a picture.
const SCALE: [usize; 2] = [4, 5];
/// Colours of a file: with few of them it is small.
const COLOURS: usize = 24;

/// Writes the pictures of a pair as a PNG.
pub fn write(path: &Path, pair: &[Grown; 2]) -> Result<(), String> {
    let (size, rgb) = beside(pair);
    let palette = median_cut(&rgb, COLOURS);
    let px: Vec<u8> = rgb.chunks_exact(3).map(|px| nearest(&palette, px)).collect();
    let mut file = Vec::new();
    encode(&mut file, size, &palette, &px).map_err(|error| error.to_string())?;
    files::save(path, |out| Ok(out.write_all(&file)?)).map_err(|error| error.to_string())
}

/// Both pictures, smaller, side by side.
fn beside(pair: &[Grown; 2]) -> ([usize; 2], Vec<u8>) {
    let smaller = |grown: &Grown| grown.size.map(|side| side * SCALE[0] / SCALE[1]);
    let [a, b] = pair.each_ref().map(smaller);
    let size = [a[0] + GAP + b[0], a[1].max(b[1])];
    let mut rgb = vec![PAPER; 3 * size[0] * size[1]];
    for (grown, of, left) in [(&pair[0], a, 0), (&pair[1], b, a[0] + GAP)] {
        let px = downscale(&grown.rgb, grown.size, of);
        for (row, px) in px.chunks_exact(3 * of[0]).enumerate() {
            let at = 3 * (row * size[0] + left);
            rgb[at..at + px.len()].copy_from_slice(px);
        }
    }
    (size, rgb)
}

/// The index of the colour of a palette that is nearest to a px.
fn nearest(palette: &[[u8; 3]], px: &[u8]) -> u8 {
    let far = |colour: &[u8; 3]| -> u32 {
        colour.iter().zip(px).map(|(a, b)| u32::from(a.abs_diff(*b)).pow(2)).sum()
    };
    let indices = (0_u8..).zip(palette);
    indices.min_by_key(|(_, colour)| far(colour)).map_or(0, |(index, _)| index)
}

/// Writes indices of a palette as a PNG.
fn encode(
    out: &mut Vec<u8>,
    [width, height]: [usize; 2],
    palette: &[[u8; 3]],
    px: &[u8],
) -> Result<(), EncodingError> {
    let mut encoder = Encoder::new(out, width as u32, height as u32);
    encoder.set_color(ColorType::Indexed);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_palette(palette.concat());
    encoder.set_compression(Compression::High);
    // Indices of near places differ by any number.
    encoder.set_filter(Filter::NoFilter);
    let mut file = encoder.write_header()?;
    file.write_image_data(px)?;
    file.finish()
}
