//! Maps of weaves, mazes, pair stripes and stucco: each part of a ramp has the values that the map asks for there.

use dapple::document::{PairKind, SystemChoice};
use dapple::lookup::{Attributes, Stripes};
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::tone::ToneImage;
use dapple::{Document, Field, GrownPairs, Layer, Stroke};
use dapple_engine::measure::{Regions, StripeErrors, Target, blotch_width, stripe_errors};

/// Parts of the canvas that are measured, from left to right.
const PARTS: usize = 3;
/// The side of the canvas, px.
const SIDE: f64 = 480.0;

fn part([x, _]: [f64; 2]) -> usize {
    ((x / SIDE * PARTS as f64) as usize).min(PARTS - 1)
}

/// A map whose value goes from the first number at the left to the second at the right; it replaces what was drawn or
/// multiplies it.
fn ramp(factor: bool, range: [f64; 2]) -> LayerMap {
    let image = ToneImage::new([256, 1], (0..=255).collect()).expect("256 px");
    LayerMap { source: MapSource::Image { image, factor }, range }
}

/// A layer with three lines 7 px wide and 24 px apart at each of these angles.
fn lines(kind: PairKind, angles: &[f64]) -> Layer {
    wide_lines(kind, angles, 7.0)
}

/// A layer like that of [`lines`], with lines of `width` px.
fn wide_lines(kind: PairKind, angles: &[f64], width: f64) -> Layer {
    let mut all = Vec::new();
    for angle in angles {
        let (s, c) = angle.to_radians().sin_cos();
        for off in [-24.0, 0.0, 24.0] {
            let end = |along: f64| [240.0 + along * c - off * s, 240.0 + along * s + off * c];
            all.push(Stroke::line(end(-90.0), end(90.0), width));
        }
    }
    Layer::new(all).with_system(SystemChoice::Of(kind.description()))
}

fn grown(layer: Layer) -> GrownPairs {
    let document = Document::new([SIDE as u32; 2]).with_layer(layer);
    let grown = document.grow().unwrap_or_else(|error| panic!("{error}"));
    grown.layers[0].pairs().expect("pairs").clone()
}

/// For each part of the canvas: the errors of the threads of each direction.
fn threads(pairs: &GrownPairs) -> Vec<Vec<StripeErrors>> {
    let directions = pairs.plan.threads.iter().zip(&pairs.differences).zip(&pairs.levels);
    let of = directions.map(|((threads, difference), level)| {
        let wanted = |at: [f64; 2]| Attributes::Stripes(threads.at(at));
        let bounds = pairs.plan.canvas();
        let target = Target {
            bounds,
            regions: Regions::Any(PARTS, &part),
            covered: &|_| false,
            wanted: &wanted,
            surface: None,
        };
        stripe_errors(difference, *level, &target)
    });
    of.collect()
}

/// Asserts that errors were measured and are within a bound.
#[track_caller]
fn within(found: &[StripeErrors], error: fn(&StripeErrors) -> Option<f64>, bound: f64) {
    let met = found.iter().all(|of| error(of).is_some_and(|error| error.abs() <= bound));
    assert!(met && found.len() == PARTS, "{found:#?}");
}

fn got(found: &[StripeErrors], value: fn(&Stripes) -> f64) -> Vec<f64> {
    found.iter().map(|of| value(&of.got.expect("threads"))).collect()
}

#[test]
fn the_threads_of_a_weave_have_the_width_and_distance_of_the_map_at_their_place() {
    for found in threads(&grown(
        lines(PairKind::Weave, &[0.0, 90.0]).with_map(MapKey::Spacing, ramp(true, [0.8, 1.3])),
    )) {
        within(&found, |of| of.width, 0.12);
        within(&found, |of| of.wavelength, 0.12);
        let widths = got(&found, |stripes| stripes.width);
        assert!(widths[2] > 1.2 * widths[0], "{widths:?}");
    }
}

#[test]
fn the_threads_of_a_weave_and_the_lines_of_a_maze_cover_the_share_of_the_map_at_their_place() {
    let mapped = |kind| {
        let layer = wide_lines(kind, &[0.0, 90.0], 8.0).with_map(MapKey::Duty, ramp(false, [0.2, 0.45]));
        grown(layer)
    };
    for found in threads(&mapped(PairKind::Weave)) {
        within(&found, |of| of.width, 0.12);
        within(&found, |of| of.wavelength, 0.08);
        let duties = got(&found, Stripes::duty);
        assert!(duties[2] - duties[0] > 0.11, "{duties:?}");
    }
    let maze = widths(&mapped(PairKind::Maze));
    assert!(maze[2] > 1.5 * maze[0], "{maze:?}");
}

#[test]
fn all_threads_of_a_weave_turn_by_the_angle_of_the_map_or_with_the_first_threads() {
    // Once rotated by the map, and once set to a direction that the first threads take.
    for (factor, range) in [(true, [0.0, 25.0]), (false, [10.0, 35.0])] {
        let pairs =
            grown(lines(PairKind::Weave, &[10.0, 90.0]).with_map(MapKey::Direction, ramp(factor, range)));
        let found = threads(&pairs);
        for found in &found {
            within(found, |of| of.angle, 4.0);
        }
        let [first, second] = [&found[0], &found[1]].map(|found| got(found, |stripes| stripes.angle));
        let apart: Vec<f64> = first.iter().zip(&second).map(|(a, b)| (b - a).rem_euclid(180.0)).collect();
        assert!(first[2] - first[0] > 12.0, "{first:?}");
        assert!(apart.iter().all(|apart| (apart - 80.0).abs() < 8.0), "{apart:?}");
    }
}

#[test]
fn pair_stripes_have_the_spacing_duty_and_direction_of_the_map_at_their_place() {
    let stripes = |key, map| {
        let found = threads(&grown(lines(PairKind::Stripes, &[30.0]).with_map(key, map)));
        found.into_iter().next().expect("one direction")
    };
    let apart = stripes(MapKey::Spacing, ramp(false, [16.0, 28.0]));
    within(&apart, |of| of.wavelength, 0.12);
    let periods = got(&apart, |stripes| stripes.wavelength.expect("a period"));
    assert!(periods[2] > 1.25 * periods[0], "{periods:?}");
    let covering = stripes(MapKey::Duty, ramp(false, [0.25, 0.6]));
    within(&covering, |of| of.width, 0.12);
    let duties = got(&covering, Stripes::duty);
    assert!(duties[2] - duties[0] > 0.15, "{duties:?}");
    let turned = stripes(MapKey::Direction, ramp(false, [10.0, 70.0]));
    within(&turned, |of| of.angle, 4.0);
}

/// The mean width, in each part, of the areas above the level.
fn widths(pairs: &GrownPairs) -> Vec<f64> {
    let field = &pairs.differences[0];
    let columns = field.width / PARTS;
    let width = |part: usize| {
        let rows = field.values.chunks(field.width);
        let values = rows.flat_map(|row| row[part * columns..(part + 1) * columns].to_vec()).collect();
        let part = Field { width: columns, values, ..field.clone() };
        blotch_width(&part, pairs.levels[0]).expect("blotches")
    };
    (0..PARTS).map(width).collect()
}

#[test]
fn the_lines_of_a_maze_and_the_blotches_of_stucco_have_the_width_of_the_map_at_their_place() {
    for layer in [wide_lines(PairKind::Maze, &[0.0, 90.0], 11.0), lines(PairKind::Stucco, &[0.0])] {
        let pairs = grown(layer.with_map(MapKey::Spacing, ramp(true, [0.7, 1.4])));
        let wanted = |part: usize| {
            pairs.plan.threads[0].at([SIDE * (part as f64 + 0.5) / PARTS as f64, 0.5 * SIDE]).width
        };
        let found = widths(&pairs);
        let off: Vec<f64> = found.iter().enumerate().map(|(k, width)| width / wanted(k) - 1.0).collect();
        assert!(off.iter().all(|off| off.abs() < 0.12), "{found:?}, {off:?}");
    }
}

#[test]
fn drawn_threads_are_not_kept_where_a_map_varies_them() {
    let layer = lines(PairKind::Weave, &[0.0, 90.0]);
    let reported = |layer: Layer| {
        let grown = Document::new([SIDE as u32; 2]).with_layer(layer).grow().expect("it grows");
        grown.report().layers[0].drawn.len()
    };
    assert_eq!(reported(layer.clone()), 6);
    assert_eq!(reported(layer.with_map(MapKey::Direction, ramp(true, [0.0, 30.0]))), 0);
}
