//! How far stripes are from the drawn directions, for each kind of start.

use dapple::document::{Document, Layer, LayerOptions, Seeding, Stroke};
use dapple_engine::marks::Line;
use dapple_engine::measure;
use dapple_engine::synth::Measured;

use super::layers;
use crate::say;

/// The kinds of start, and whether drawn lines are kept.
const WAYS: [(&str, Seeding, bool); 4] = [
    ("noise", Seeding::Noise, false),
    ("noise, lines kept", Seeding::Noise, true),
    ("segments", Seeding::Segments, false),
    ("segments, lines kept", Seeding::Segments, true),
];

/// Rms and mean deviation, degrees, and coherence in one region; rms in four.
pub fn print() -> Result<(), String> {
    say("| begins from | rms | mean | coherence | four regions, rms |")?;
    for (name, seeding, keep) in WAYS {
        let options = LayerOptions { seeding, keep: Some(keep), ..LayerOptions::default() };
        let mut sums = [0.0; 4];
        for seed in 1..=6 {
            let [rms, mean, coherence] = grown(&[&[25.0 * seed as f64]], options, seed)?;
            let [four, ..] = grown(&[&[20.0, 70.0], &[40.0, 100.0]], options, seed)?;
            for (sum, one) in sums.iter_mut().zip([rms, mean, coherence, four]) {
                *sum += one / 6.0;
            }
        }
        let [rms, mean, coherence, four] = sums;
        say(&format!("| {name} | {rms:.1} | {mean:.1} | {coherence:.3} | {four:.1} |"))?;
    }
    Ok(())
}

/// Rms deviation, mean deviation in the first region, and coherence of stripes 8 px wide on 320 × 320 px.
fn grown(directions: &[&[f64]], options: LayerOptions, seed: u64) -> Result<[f64; 3], String> {
    let side = directions.len() as u32;
    let strokes = lines(directions).into_iter().map(Stroke::Line).collect();
    let layers_of_it = vec![Layer { strokes, options, ..Layer::default() }];
    let document = Document {
        size: [320; 2],
        regions: Some([side; 2]),
        seed,
        layers: layers_of_it,
        ..Document::default()
    };
    let layer = layers(&document)?.remove(0);
    let Measured::Stripes(errors) = &layer.measured else { return Err("no stripes".to_owned()) };
    let nothing = || "no stripes have grown".to_owned();
    let squares: Option<Vec<f64>> = errors.iter().map(|error| error.angle_rms.map(|rms| rms * rms)).collect();
    let squares = squares.ok_or_else(nothing)?;
    let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    let mean = errors[0].angle.ok_or_else(nothing)?.abs();
    let found = measure::stripes(&layer.pattern().field(320, 320), 0.5).ok_or_else(nothing)?;
    Ok([rms, mean, found.coherence])
}

/// A line through the centre of each region, at these directions, degrees.
fn lines(directions: &[&[f64]]) -> Vec<Line> {
    let place = |k: usize| (k as f64 + 0.5) * 320.0 / directions.len() as f64;
    let line = |row: usize, column: usize, degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        let end = |sign: f64| [place(column) + sign * 20.0 * c, place(row) + sign * 20.0 * s];
        Line { from: end(-1.0), to: end(1.0), width: 8.0 }
    };
    let rows = directions.iter().enumerate();
    rows.flat_map(|(row, columns)| {
        (0..).zip(*columns).map(move |(column, degrees)| line(row, column, *degrees))
    })
    .collect()
}
