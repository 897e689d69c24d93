//! Stripes that start from segments or initiators instead of noise.

use dapple::document::Line;
use dapple::document::{Document, Layer, LayerOptions, Seeding, Stroke};
use dapple_engine::attributes::{Attributes, Stripes};
use dapple_engine::grid::{Bounds, Edges, Field};
use dapple_engine::measure::{self, Regions, StripeErrors, Target};
use dapple_engine::synth::Growth;
use dapple_engine::synth::{Measured, Options};

/// The document of lines 8 px wide.
fn grown(
    lines: &[Line],
    regions: [u32; 2],
    size: u32,
    options: LayerOptions,
    seed: u64,
) -> (Field, Vec<StripeErrors>) {
    let strokes = lines.iter().map(|line| Stroke::Line(*line)).collect();
    let layers = vec![Layer { strokes, options, ..Layer::default() }];
    let document = Document { size: [size; 2], regions: Some(regions), seed, layers, ..Document::default() };
    let grown = Growth::begin(&document, &Options::default(), None).run().unwrap();
    let layer = grown.layers[0].marks().expect("marks");
    let Measured::Stripes(errors) = &layer.measured else { panic!("lines were drawn") };
    (layer.pattern().field(size as usize, size as usize), errors.clone())
}

fn seeded(seeding: Seeding) -> LayerOptions {
    LayerOptions { seeding, keep: Some(false), ..LayerOptions::default() }
}

/// A line through the centre of each region of `size` px, at these directions, degrees.
fn lines(directions: &[&[f64]], size: f64) -> Vec<Line> {
    let rows = directions.len() as f64;
    let line = |row: usize, column: usize, degrees: f64| {
        let place = |k: usize| (k as f64 + 0.5) * size / rows;
        let (s, c) = degrees.to_radians().sin_cos();
        let end = |sign: f64| [place(column) + sign * 20.0 * c, place(row) + sign * 20.0 * s];
        Line { from: end(-1.0), to: end(1.0), width: 8.0 }
    };
    let all = directions.iter().enumerate();
    all.flat_map(|(row, columns)| {
        columns.iter().enumerate().map(move |(column, degrees)| line(row, column, *degrees))
    })
    .collect()
}

fn rms(errors: &[StripeErrors]) -> f64 {
    let squares = errors.iter().map(|error| error.angle_rms.unwrap() * error.angle_rms.unwrap());
    (squares.sum::<f64>() / errors.len() as f64).sqrt()
}

#[test]
fn stripes_from_segments_have_the_width_and_roughly_the_direction_of_the_lines() {
    let (_, segments) = grown(&lines(&[&[30.0]], 300.0), [1, 1], 300, seeded(Seeding::Segments), 1);
    let (_, noise) = grown(&lines(&[&[30.0]], 300.0), [1, 1], 300, seeded(Seeding::Noise), 1);
    assert!(segments[0].width.unwrap().abs() < 0.003, "{segments:?}");
    assert!(segments[0].angle.unwrap().abs() < 4.0, "{segments:?}");
    let (loose, strict) = (rms(&segments), rms(&noise));
    assert!((12.0..28.0).contains(&loose) && strict < 0.4 * loose, "{loose} {strict}");
}

#[test]
fn stripes_radiate_from_initiators_in_regular_order() {
    let line = Line { from: [90.0, 130.0], to: [200.0, 160.0], width: 8.0 };
    let (pattern, _) = grown(&[line], [1, 1], 300, seeded(Seeding::Initiators), 1);
    // Parallel to the line beside it, and around its ends beyond these.
    let wanted = |at: [f64; 2]| {
        let way = [line.to[0] - line.from[0], line.to[1] - line.from[1]];
        let off = [at[0] - line.from[0], at[1] - line.from[1]];
        let share = ((off[0] * way[0] + off[1] * way[1]) / (line.length() * line.length())).clamp(0.0, 1.0);
        let out = [off[0] - share * way[0], off[1] - share * way[1]];
        let angle = out[1].atan2(out[0]).to_degrees() + 90.0;
        Attributes::Stripes(Stripes { width: 8.0, angle: angle.rem_euclid(180.0), wavelength: None })
    };
    let target = Target {
        bounds: Bounds { size: [300.0; 2], edges: Edges::Closed },
        regions: Regions::ONE,
        covered: &|_| false,
        wanted: &wanted,
        surface: None,
    };
    let error = measure::stripe_errors(&pattern, 0.5, &target)[0];
    assert!(error.width.unwrap().abs() < 0.01 && error.angle_rms.unwrap() < 4.0, "{error:?}");
    // The period is twice the width, because stripes and gaps alternate outwards.
    let dark = |k: usize| pattern.values[(145 + 16 * k) * 300 + 145 - 4 * k] > 0.5;
    let light = |k: usize| pattern.values[(153 + 16 * k) * 300 + 143 - 4 * k] < 0.5;
    assert!((0..6).filter(|k| dark(*k)).count() >= 5 && (0..6).filter(|k| light(*k)).count() >= 5);
}

#[test]
fn the_seed_moves_segments_and_not_initiators() {
    let field = |seeding, seed| grown(&lines(&[&[30.0]], 160.0), [1, 1], 160, seeded(seeding), seed).0.values;
    assert!(field(Seeding::Segments, 1) != field(Seeding::Segments, 2));
    assert!(field(Seeding::Initiators, 1) == field(Seeding::Initiators, 2));
}
