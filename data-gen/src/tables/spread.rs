//! How much spots vary, compared with the variation that was asked for.

use dapple::document::{Document, Layer, LayerOptions, SpreadChoice, Stroke, SystemChoice};
use dapple_engine::attributes::{Attribute, Spread};
use dapple_engine::grid::Edges;
use dapple_engine::marks::Ellipse;
use dapple_engine::measure::SpotErrors;
use dapple_engine::rd::System;
use dapple_engine::synth::Measured;

use super::layers;
use crate::say;

/// Spots of 300 px² at 30°: their system, aspect and area ÷ spacing².
#[derive(Clone, Copy)]
struct Spots {
    name: &'static str,
    system: SystemChoice,
    aspect: f64,
    packing: f64,
}

const KINDS: [Spots; 4] = [
    Spots {
        name: "Meinhardt, aspect 0.8, area/spacing² 0.12",
        system: SystemChoice::Of(System::MEINHARDT_SPOTS.description()),
        aspect: 0.8,
        packing: 0.12,
    },
    Spots {
        name: "Meinhardt, aspect 0.5, area/spacing² 0.16",
        system: SystemChoice::Of(System::MEINHARDT_SPOTS.description()),
        aspect: 0.5,
        packing: 0.16,
    },
    Spots {
        name: "Meinhardt, aspect 0.7, area/spacing² 0.05",
        system: SystemChoice::Of(System::MEINHARDT_SPOTS.description()),
        aspect: 0.7,
        packing: 0.05,
    },
    Spots {
        name: "Turing, aspect 0.5",
        system: SystemChoice::Of(System::TURING_SPOTS.description()),
        aspect: 0.5,
        packing: 0.22,
    },
];

/// The variation that is asked for, of each attribute: relative to the mean; of angles degrees.
const ASKED: [(Attribute, [f64; 6]); 4] = [
    (Attribute::Area, [0.05, 0.1, 0.2, 0.3, 0.4, 0.6]),
    (Attribute::Angle, [3.0, 6.0, 12.0, 20.0, 30.0, 45.0]),
    (Attribute::Aspect, [0.02, 0.04, 0.08, 0.12, 0.16, 0.2]),
    (Attribute::Spacing, [0.1, 0.12, 0.14, 0.16, 0.18, 0.2]),
];

/// Prints asked → grown, for each attribute alone.
pub fn print() -> Result<(), String> {
    for spots in KINDS {
        say(spots.name)?;
        for (attribute, values) in ASKED {
            let cells: Result<Vec<String>, String> =
                values.into_iter().map(|value| cell(spots, attribute, value)).collect();
            say(&format!("  {attribute}: {}", cells?.join("; ")))?;
        }
    }
    Ok(())
}

/// Asked → mean over four seeds ± largest deviation, and the number of merged marks.
fn cell(spots: Spots, attribute: Attribute, value: f64) -> Result<String, String> {
    let part = |of: Attribute| if of == attribute { value } else { 0.0 };
    let asked = Spread {
        area: part(Attribute::Area),
        angle: part(Attribute::Angle),
        aspect: part(Attribute::Aspect),
        spacing: part(Attribute::Spacing),
    };
    let (mut got, mut merged) = (Vec::new(), 0);
    for seed in 1..=4 {
        let (found, touching) = grown(spots, asked, seed)?;
        let spread = found.spread.ok_or("nothing has grown")?;
        got.extend(spread.named().into_iter().find(|(of, _)| *of == attribute).map(|(_, got)| got));
        merged += touching;
    }
    let mean = got.iter().sum::<f64>() / got.len() as f64;
    let off = got.iter().map(|one| (one - mean).abs()).fold(0.0, f64::max);
    let merged = if merged > 0 { format!(" ({merged} merged)") } else { String::new() };
    Ok(format!("{value} → {mean:.3} ± {off:.3}{merged}"))
}

/// Grows 130 to 200 spots with this spread on a seamless canvas: the measured variation, and the number of merged
/// marks.
fn grown(spots: Spots, spread: Spread, seed: u64) -> Result<(SpotErrors, usize), String> {
    let spacing = (300.0 / spots.packing).sqrt();
    let ellipse = |x: f64| Stroke::Ellipse(Ellipse::from_area([x, 200.0], 300.0, spots.aspect, 30.0));
    let layer = Layer {
        system: spots.system,
        strokes: vec![ellipse(200.0), ellipse(200.0 + spacing)],
        options: LayerOptions {
            spread: SpreadChoice::Given(spread),
            keep: Some(false),
            ..LayerOptions::default()
        },
        ..Layer::default()
    };
    let side = ((150.0 * 0.75f64.sqrt()).sqrt() * spacing) as u32;
    let document =
        Document { size: [side, side], edges: Edges::Wrap, seed, layers: vec![layer], ..Document::default() };
    let grown = layers(&document)?.remove(0);
    let Measured::Spots { errors, marks } = &grown.measured else { return Err("no spots".to_owned()) };
    Ok((errors[0], marks.iter().filter(|mark| mark.endless || mark.fill < 0.93).count()))
}
