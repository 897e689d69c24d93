//! Patches and cells that grow on small bodies.

use crate::attributes::{Attribute, Attributes, Spread};
use crate::document::{AreaKind, Document, GapChoice, Layer, RaggedChoice, SpreadChoice, SystemChoice};
use crate::measure::surface_stripes;
use crate::synth::body::BodyLayer;
use crate::synth::body::area_form::AreaForm;
use crate::synth::body::kinds_tests::{from_marks, grown, on, spots};
use crate::synth::pattern::EDGE;

/// Areas of this kind from round marks of this radius, so many px apart.
fn areas(kind: AreaKind, radius: f64, apart: f64) -> Layer {
    Layer { system: SystemChoice::Of(kind.description()), ..spots(radius, apart) }
}

fn on_sphere(layers: Vec<Layer>) -> Document {
    on("sphere", 110.0, layers)
}

/// The mean width of the ground, px, by 2 × area ÷ contour length, and the length of the contour, px.
fn ground(layer: &BodyLayer) -> [f64; 2] {
    let inverse: Vec<f32> = layer.levelled.pattern.iter().map(|value| 1.0 - value).collect();
    let stripes = surface_stripes(layer.plan.surface(), &inverse, EDGE, 1, &|_| 0);
    [stripes[0].width().expect("edges"), stripes[0].contour]
}

#[test]
fn cells_have_the_area_that_is_asked_and_lines_of_one_width() {
    for (radius, gap) in [(9.0, 4.0), (9.0, 6.0)] {
        let mut layer = areas(AreaKind::Polygons, radius, 22.0);
        layer.options.gap = GapChoice::Given(gap);
        let grown = grown(&on_sphere(vec![layer]));
        let report = grown.report("test", 0.0);
        let [layer] = &grown.layers[..] else { panic!("one layer") };
        assert_eq!((report.layers[0].system, layer.spots()), ("cells", layer.laid));
        assert!(layer.laid > 60, "{}", layer.laid);
        let area = report.layers[0].regions[0].error[&Attribute::Area];
        assert!(area.abs() < 2e-3, "{area}");
        let [width, _] = ground(layer);
        assert!((width / gap - 1.0).abs() < 0.08, "{width} for {gap}");
    }
}

#[test]
fn long_cells_have_the_aspect_and_the_direction_that_are_asked() {
    let long = |mark: &mut crate::document::Stroke| {
        *mark = crate::document::Stroke::ellipse(mark.mark().expect("an ellipse").center(), [14.0, 7.0], 0.0);
    };
    let mut layer = areas(AreaKind::Polygons, 10.0, 26.0);
    layer.strokes.iter_mut().for_each(long);
    layer.options.gap = GapChoice::Given(3.5);
    let grown = grown(&on("torus", 180.0, vec![layer]));
    let region = &grown.report("test", 0.0).layers[0].regions[0];
    assert!(region.error[&Attribute::Aspect].abs() < 0.08, "{:?}", region.error);
    assert!(region.error[&Attribute::Angle].abs() < 5.0, "{:?}", region.error);
}

#[test]
fn patches_have_the_area_the_spacing_and_the_raggedness_that_are_asked() {
    let mut found = Vec::new();
    for sigma in [0.0, 0.3] {
        let mut layer = areas(AreaKind::Patches, 11.0, 33.0);
        layer.options.ragged = RaggedChoice::Given(sigma);
        let grown = grown(&on("sphere", 170.0, vec![layer]));
        let region = &grown.report("test", 0.0).layers[0].regions[0];
        let [layer] = &grown.layers[..] else { panic!("one layer") };
        assert_eq!(layer.spots(), layer.laid);
        assert!(region.error[&Attribute::Area].abs() < 2e-3, "{:?}", region.error);
        assert!(region.error[&Attribute::Spacing].abs() < 0.04, "{:?}", region.error);
        let [_, contour] = ground(layer);
        let Some(AreaForm::Patches(form)) = layer.plan.choice.areas else { panic!("patches") };
        let asked = form.wanted(&layer.plan.wanted[0], Spread::ZERO).expect("a patch").raggedness;
        let Attributes::Spots(wanted) = layer.plan.wanted[0] else { panic!("spots") };
        let mean = contour / layer.spots() as f64;
        let ragged = mean * mean / (4.0 * std::f64::consts::PI * wanted.area);
        assert!((ragged / asked - 1.0).abs() < 0.15, "{ragged} for {asked}");
        found.push(ragged);
    }
    assert!(found[1] > found[0] + 0.25, "{found:?}");
}

#[test]
fn patches_vary_as_much_as_is_asked() {
    let mut layer = areas(AreaKind::Patches, 11.0, 33.0);
    layer.options.spread = SpreadChoice::Given(Spread { area: 0.4, ..Spread::ZERO });
    let grown = grown(&on("sphere", 170.0, vec![layer]));
    let areas: Vec<f64> = grown.layers[0].levelled.measured.spots.iter().map(|spot| spot.area).collect();
    let mean = areas.iter().sum::<f64>() / areas.len() as f64;
    let squares = areas.iter().map(|area| (area / mean - 1.0) * (area / mean - 1.0)).sum::<f64>();
    let spread = (squares / areas.len() as f64).sqrt();
    assert!((spread - 0.4).abs() < 0.08, "{spread}");
}

#[test]
fn areas_do_not_touch_the_marks_beneath() {
    for kind in AreaKind::ALL {
        let mut above = areas(kind, 9.0, 24.0);
        if kind == AreaKind::Polygons {
            above.options.gap = GapChoice::Given(4.0);
        }
        let grown = grown(&on_sphere(vec![spots(10.0, 55.0), above]));
        let [spots, areas] = &grown.layers[..] else { panic!("two layers") };
        let away = from_marks(areas, spots);
        let touching =
            away.iter().zip(&areas.levelled.pattern).filter(|(away, value)| **away == 0.0 && **value >= EDGE);
        assert_eq!(touching.count(), 0, "{kind:?}");
        assert!(areas.spots() > 20, "{kind:?}: {}", areas.spots());
    }
}
