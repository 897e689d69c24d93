//! Random sketches like those that users draw: a few irregular marks in each region, loosely arranged.
//!
//! The attributes asked are those measured on the drawn marks, not those that the sketch was generated from. A sketch whose
//! measured attributes leave the [`RANGES`](ranges) is drawn again.

mod lines;
mod ranges;
mod spots;

use super::dice::Dice;
use dapple::document::Edges;
use dapple::document::{Document, DutyChoice, Layer, LayerOptions, Stroke};
use dapple_engine::attributes::regions::RegionGrid;

pub use ranges::within;

/// The seed of the sketches in the project's published table: the year of Phan & Grimm's paper.
pub const SEED: u64 = 2006;

/// One sketch out of this number has stripes.
const STRIPES_EVERY: u64 = 4;
/// The share of seamless tiles.
const SEAMLESS: f64 = 0.1;
/// The share of canvases with the usual size.
const USUAL: f64 = 0.5;
/// Sides of the other canvases, px.
const SIDES: [f64; 2] = [384.0, 640.0];
/// The most sketches that are thrown away before one is kept; usually it is a few dozen.
const TRIES: usize = 100_000;

/// Sketch `index` for `seed`; it does not depend on other sketches.
///
/// # Errors
/// None of very many attempts stayed within the ranges.
pub fn sketch(seed: u64, index: u64) -> Result<Document, String> {
    let mut dice = Dice::from_seed(seed.wrapping_mul(1_000_000).wrapping_add(index));
    let stripes = index % STRIPES_EVERY == STRIPES_EVERY - 1;
    let edges = if dice.chance(SEAMLESS) { Edges::Wrap } else { Edges::Closed };
    for _ in 0..TRIES {
        let strokes = |dice: &mut Dice, layout: &RegionGrid| {
            if stripes { lines::draw(dice, layout) } else { spots::draw(dice, layout) }
        };
        let layout = canvas(&mut dice, edges);
        let Some(strokes) = strokes(&mut dice, &layout) else { continue };
        let document = document(index, &layout, strokes);
        if within(&document) {
            return Ok(document);
        }
    }
    Err(format!("sketch {index} of seed {seed}: none of {TRIES} attempts stayed within the ranges"))
}

fn canvas(dice: &mut Dice, edges: Edges) -> RegionGrid {
    let usual = dice.chance(USUAL);
    let size = [0, 1].map(|_| if usual { 512.0 } else { dice.between(SIDES).round() });
    RegionGrid { size, grid: [0, 1].map(|_| dice.whole([1, 3])), edges }
}

fn document(index: u64, layout: &RegionGrid, strokes: Vec<Stroke>) -> Document {
    // Stripes as wide as the gaps between them, as in the paper.
    let options = LayerOptions { duty: DutyChoice::Given(LayerOptions::DUTY), ..LayerOptions::default() };
    Document {
        name: format!("random sketch {index}"),
        size: layout.size.map(|side| side as u32),
        regions: Some(layout.grid.map(|n| n as u32)),
        edges: layout.edges,
        seed: index + 1,
        layers: vec![Layer { name: "marks".to_owned(), strokes, options, ..Layer::default() }],
        ..Document::default()
    }
}

/// Upper left corner and size of a region, px.
fn rectangle(layout: &RegionGrid, index: usize) -> ([f64; 2], [f64; 2]) {
    let size = [0, 1].map(|axis| layout.size[axis] / layout.grid[axis] as f64);
    let place = layout.place(index);
    ([0, 1].map(|axis| place[axis] as f64 * size[axis]), size)
}

#[cfg(test)]
mod tests;
