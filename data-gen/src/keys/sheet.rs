//! Two pictures side by side in a small file.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;

use dapple::files;
use dapple_engine::export::downscale;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, Filter};

use super::grown::Grown;

/// Px between the pictures.
const GAP: usize = 8;
/// The colour there.
const PAPER: u8 = 255;
/// Four px of a file stand for five of a picture.
const SCALE: [usize; 2] = [4, 5];
/// The distance of the values of a colour. Each divides 255; with the first one most pictures have fewer colours than a palette holds.
const STEPS: [u8; 3] = [17, 51, 85];
/// Colours in a palette.
const PALETTE: usize = 256;

/// Writes the pictures of a pair as a PNG.
pub fn write(path: &Path, pair: &[Grown; 2]) -> Result<(), String> {
    let (size, rgb) = beside(pair);
    let (palette, px) = with_palette(&rgb).ok_or("there are too many colours")?;
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

/// A palette, and the index of each px in it.
fn with_palette(rgb: &[u8]) -> Option<(Vec<[u8; 3]>, Vec<u8>)> {
    STEPS.iter().find_map(|step| {
        let rounded = |value: u8| (value / step + u8::from(value % step > step / 2)) * step;
        let px: Vec<[u8; 3]> = rgb.chunks_exact(3).map(|px| [px[0], px[1], px[2]].map(rounded)).collect();
        let palette: Vec<[u8; 3]> = px.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        let index = |px: &[u8; 3]| palette.partition_point(|colour| colour < px) as u8;
        let indices = px.iter().map(index).collect();
        (palette.len() <= PALETTE).then_some((palette, indices))
    })
}

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
