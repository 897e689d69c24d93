//! Notes on a layer without a pattern, and on a picture of one colour.

use crate::document::Document;
use crate::synth::growth::Grown;
use crate::synth::layer::GrownLayer;
use crate::synth::pattern::EDGE;
use crate::synth::render::painting::Painting;

/// Least difference of pattern values that is visible in 8 bits.
const STEP: f32 = 1.0 / 255.0;
/// Rows that are tested together: in most patterns the first ones differ already.
const ROWS: usize = 32;

/// A note that a layer has no pattern, with what to change; `None` if it has one.
#[must_use]
pub fn note_on_layer(layer: &GrownLayer) -> Option<String> {
    let [width, height] = layer.planned().grid.bounds_px().size.map(|side| (side.round() as usize).max(1));
    let pattern = layer.pattern();
    let [mut least, mut most] = [f32::INFINITY, f32::NEG_INFINITY];
    for first in (0..height).step_by(ROWS) {
        let rows = pattern.rows(first..height.min(first + ROWS), width, height);
        least = rows.iter().copied().fold(least, f32::min);
        most = rows.iter().copied().fold(most, f32::max);
        if least < EDGE && most >= EDGE && most - least >= STEP {
            return None;
        }
    }
    let full = least >= EDGE;
    let what = match (most - least < STEP, full) {
        (true, _) => "it is of one value everywhere",
        (false, true) => "it is above the edge everywhere, without any ground",
        (false, false) => "it is below the edge everywhere, without any mark",
    };
    Some(format!("{what}: {}", layer.advice(full)))
}

/// A note that the picture of `document` has a single colour, with what to change; `None` if it has several.
#[must_use]
pub fn note_on_picture(document: &Document, grown: &Grown) -> Option<String> {
    let painting = Painting::new(document, grown, 1).unfinished();
    let [width, height] = painting.size;
    // The table of opaque colours is there already, or the picture needs it next.
    let channels = if painting.is_opaque() { 3 } else { 4 };
    let mut colour = None;
    for first in (0..height).step_by(ROWS) {
        let rows = first..height.min(first + ROWS);
        let mut bytes = vec![0; channels * width * rows.len()];
        match channels {
            3 => painting.band(rows).paint(&mut bytes),
            _ => bytes = painting.rgba_rows(rows),
        }
        let first = colour.get_or_insert_with(|| bytes[..channels].to_vec());
        if bytes.chunks_exact(channels).any(|px| px != &first[..]) {
            return None;
        }
    }
    Some(
        "the picture is of one colour everywhere: its layers have no pattern, are hidden, or have one colour; \
         see their notes, show them, or choose other colours"
            .to_owned(),
    )
}
