//! Maps of patches, cells, streaks and cracks: each part of a ramp has the values that the map asks for there.

use dapple::document::{AreaKind, LineKind, SystemChoice};
use dapple::lookup::Attributes;
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::tone::ToneImage;
use dapple::{Document, Grown, Layer, Stroke};
use dapple_engine::grid::Bounds;
use dapple_engine::measure::{Regions, SpotErrors, StripeErrors, Target, spot_errors, stripe_errors};

/// Parts of the canvas that are measured, from left to right.
const PARTS: usize = 3;
/// The side of the canvas, px.
const SIDE: f64 = 600.0;

fn part([x, _]: [f64; 2]) -> usize {
    ((x / SIDE * PARTS as f64) as usize).min(PARTS - 1)
}

/// A map whose value goes from the first number at the left to the second at the right; it replaces what was drawn or
/// multiplies it.
fn ramp(factor: bool, range: [f64; 2]) -> LayerMap {
    let image = ToneImage::new([256, 1], (0..=255).collect()).expect("256 px");
    LayerMap { source: MapSource::Image { image, factor }, range }
}

/// A layer with ellipses of 400 px² and aspect 0.7, 40 px apart.
fn ellipses(kind: AreaKind) -> Layer {
    let at = |x: f64, y: f64| Stroke::ellipse([300.0 + x, 300.0 + y], [13.5, 9.45], 20.0);
    let row = 40.0 * 0.75f64.sqrt();
    let layer = Layer::new([at(0.0, 0.0), at(40.0, 0.0), at(20.0, row), at(-20.0, row)]);
    Layer { system: SystemChoice::Of(kind.description()), ..layer }
}

/// A layer with two lines 7 px wide, 20 px apart.
fn lines(kind: LineKind) -> Layer {
    let line = |y: f64| Stroke::line([200.0, y], [400.0, y], 7.0);
    Layer { system: SystemChoice::Of(kind.description()), ..Layer::new([line(290.0), line(310.0)]) }
}

fn grown(layer: Layer) -> Grown {
    Document::new([SIDE as u32; 2]).with_layer(layer).grow().expect("it grows")
}

/// The parts of the canvas, each with the attributes that are asked for at its places.
fn by_part(bounds: Bounds, wanted: &(dyn Fn([f64; 2]) -> Attributes + Sync)) -> Target<'_> {
    Target { bounds, regions: Regions::Any(PARTS, &part), covered: &|_| false, wanted, surface: None }
}

fn areas(layer: Layer) -> Vec<SpotErrors> {
    let grown = grown(layer);
    let areas = grown.layers[0].areas().expect("areas");
    let plan = &areas.plan;
    let wanted = |at: [f64; 2]| plan.asked(at);
    let target = by_part(plan.canvas(), &wanted);
    spot_errors(&areas.spots, &target)
}

fn stripes(layer: Layer) -> Vec<StripeErrors> {
    let grown = grown(layer);
    let lines = grown.layers[0].lines().expect("lines");
    let plan = &lines.plan;
    let wanted = |at: [f64; 2]| plan.asked(at);
    let target = by_part(plan.canvas(), &wanted);
    stripe_errors(&lines.field, 0.5, &target)
}

/// Asserts that errors were measured and are within a bound, and that the grown values rise from part to part.
#[track_caller]
fn met(errors: &[Option<f64>], got: &[f64], bound: f64) {
    let within = errors.iter().all(|error| error.is_some_and(|error| error.abs() <= bound));
    assert!(within && got.is_sorted() && got.len() == PARTS, "{errors:?}, {got:?}");
}

#[test]
fn patches_have_the_area_spacing_and_direction_of_the_map_at_their_place() {
    let found = areas(ellipses(AreaKind::Patches).with_map(MapKey::Area, ramp(false, [200.0, 500.0])));
    let got = |of: &SpotErrors| of.got.expect("whole patches");
    met(
        &found.iter().map(|of| of.area).collect::<Vec<_>>(),
        &found.iter().map(|of| got(of).area).collect::<Vec<_>>(),
        0.06,
    );
    let found = areas(ellipses(AreaKind::Patches).with_map(MapKey::Spacing, ramp(false, [34.0, 60.0])));
    let spacing: Vec<f64> = found.iter().filter_map(|of| got(of).spacing).collect();
    met(&found.iter().map(|of| of.spacing).collect::<Vec<_>>(), &spacing, 0.06);
    let found = areas(ellipses(AreaKind::Patches).with_map(MapKey::Direction, ramp(false, [10.0, 70.0])));
    met(
        &found.iter().map(|of| of.angle).collect::<Vec<_>>(),
        &found.iter().map(|of| got(of).angle).collect::<Vec<_>>(),
        8.0,
    );
}

#[test]
fn cells_have_the_area_of_the_map_at_their_place() {
    let found = areas(ellipses(AreaKind::Polygons).with_map(MapKey::Area, ramp(true, [0.8, 2.4])));
    let got: Vec<f64> = found.iter().map(|of| of.got.expect("whole cells").area).collect();
    met(&found.iter().map(|of| of.area).collect::<Vec<_>>(), &got, 0.08);
}

#[test]
fn streaks_have_the_direction_and_width_of_the_map_at_their_place() {
    let got = |of: &StripeErrors| of.got.expect("streaks");
    let found = stripes(lines(LineKind::Streaks).with_map(MapKey::Direction, ramp(true, [0.0, 60.0])));
    met(
        &found.iter().map(|of| of.angle).collect::<Vec<_>>(),
        &found.iter().map(|of| got(of).angle).collect::<Vec<_>>(),
        6.0,
    );
    let found = stripes(lines(LineKind::Streaks).with_map(MapKey::Spacing, ramp(true, [0.8, 1.6])));
    met(
        &found.iter().map(|of| of.width).collect::<Vec<_>>(),
        &found.iter().map(|of| got(of).width).collect::<Vec<_>>(),
        0.12,
    );
}

#[test]
fn cracks_have_the_width_of_the_map_at_their_place() {
    let found = stripes(lines(LineKind::Cracks).with_map(MapKey::Spacing, ramp(true, [0.8, 1.6])));
    let got: Vec<f64> = found.iter().map(|of| of.got.expect("cracks").width).collect();
    met(&found.iter().map(|of| of.width).collect::<Vec<_>>(), &got, 0.12);
}
