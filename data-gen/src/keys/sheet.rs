//! Two pictures side by side in a file.

use std::path::Path;

use dapple::files;
use dapple_engine::export::{Format, picture};

use super::grown::Grown;

/// Px between the pictures.
const GAP: usize = 8;
/// The colour there.
const PAPER: u8 = 255;

/// Writes the pictures of a pair.
pub fn write(path: &Path, pair: &[Grown; 2]) -> Result<(), String> {
    let [a, b] = pair.each_ref().map(|grown| grown.size);
    let size = [a[0] + GAP + b[0], a[1].max(b[1])];
    let mut rgb = vec![PAPER; 3 * size[0] * size[1]];
    for (left, grown) in [(0, &pair[0]), (a[0] + GAP, &pair[1])] {
        for (row, px) in grown.rgb.chunks_exact(3 * grown.size[0]).enumerate() {
            let at = 3 * (row * size[0] + left);
            rgb[at..at + px.len()].copy_from_slice(px);
        }
    }
    files::save(path, |out| picture::rgb8(out, Format::Jpeg, size, &rgb)).map_err(|error| error.to_string())
}
