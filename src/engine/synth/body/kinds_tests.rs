//! Growths on small bodies of other kinds than round spots: stripes, layers above each other, drawn marks in their places.

use super::{BodyGrowth, BodyLayer, GrownBody};
use crate::attributes::{Attribute, Spread};
use crate::document::{
    After, Body, BodyEllipse, BodyMark, BodySource, Document, DutyChoice, Layer, RaggedChoice, SpreadChoice,
    Stroke,
};
use crate::grid::Domain;
use crate::marks::Line;
use crate::measure::surface_stripes;
use crate::rd::System;
use crate::surface::distances;
use crate::synth::Options;
use crate::synth::body::beneath::carried;
use crate::synth::pattern::EDGE;

/// Layers on a built-in body of so many px.
pub fn on(name: &'static str, px: f64, layers: Vec<Layer>) -> Document {
    let model = Some(Body { px, ..Body::new(BodySource::BuiltIn(name)) });
    Document { model, seed: 3, layers, ..Document::new([300, 260]) }
}

pub fn grown(document: &Document) -> GrownBody {
    let growth = BodyGrowth::begin(document, None, &Options::default()).expect("it grows on models");
    growth.run().expect("it grows")
}

/// Round spots of this radius, so many px apart.
pub fn spots(radius: f64, apart: f64) -> Layer {
    let at = |i: i32| {
        let shift = 0.5 * f64::from(i / 4 % 2);
        [20.0 + apart * (f64::from(i % 4) + shift), 20.0 + 0.866 * apart * f64::from(i / 4)]
    };
    Layer::new((0..16).map(|i| Stroke::ellipse(at(i), [radius; 2], 0.0)))
}

/// Stripes of this width across the canvas.
fn stripes(width: f64) -> Layer {
    let line = |i: i32| {
        let x = 20.0 + 2.0 * width * f64::from(i);
        Stroke::from(Line { from: [x, 20.0], to: [x, 140.0], width })
    };
    Layer::new((0..5).map(line))
}

/// Errors of width and wavelength, and the root mean square of the errors of direction, degrees.
fn stripe_errors(grown: &GrownBody) -> [f64; 3] {
    let report = grown.report("test", 0.0);
    let region = &report.layers[0].regions[0];
    let error = |attribute: Attribute| region.error[&attribute];
    [error(Attribute::Width), error(Attribute::Wavelength), region.direction.expect("directions").rms]
}

#[test]
fn stripes_on_a_torus_have_the_width_the_wavelength_and_the_direction_that_are_asked() {
    let [width, wavelength, direction] = stripe_errors(&grown(&on("torus", 220.0, vec![stripes(9.0)])));
    assert!(width.abs() < 0.01 && wavelength.abs() < 0.02, "{width} {wavelength}");
    assert!(direction < 9.0, "{direction}");
}

#[test]
fn lines_and_gaps_on_a_torus_have_the_period_that_is_asked() {
    for duty in [0.3, 0.7] {
        let mut layer = stripes(18.0 * duty);
        layer.options.duty = DutyChoice::Given(duty);
        let [width, wavelength, direction] = stripe_errors(&grown(&on("torus", 180.0, vec![layer])));
        assert!(width.abs() < 0.01 && wavelength.abs() < 0.02, "{duty}: {width} {wavelength}");
        assert!(direction < 9.0, "{duty}: {direction}");
    }
}

/// How far each vertex of one layer's surface is from the marks of another, px.
pub fn from_marks(layer: &BodyLayer, other: &BodyLayer) -> Vec<f64> {
    let surface = layer.plan.surface();
    let covered: Vec<bool> = carried(other, surface).iter().map(|value| *value >= EDGE).collect();
    let away = surface.distances(&covered).expect("marks");
    away.into_iter().map(|away| away * surface.unit()).collect()
}

#[test]
fn spots_of_a_second_layer_keep_away_from_those_of_the_first() {
    let grown = grown(&on("sphere", 200.0, vec![spots(15.0, 62.0), spots(5.0, 21.0)]));
    let [large, small] = &grown.layers[..] else { panic!("two layers") };
    let away = from_marks(small, large);
    let vertex = |spot: &crate::measure::SurfaceSpot| small.plan.surface().vertex_of(spot.place);
    let nearest =
        small.levelled.measured.spots.iter().map(|spot| away[vertex(spot)]).fold(f64::INFINITY, f64::min);
    assert!(large.spots() > 20 && small.spots() > 60, "{} {}", large.spots(), small.spots());
    assert_eq!([large.laid, small.laid], [large.spots(), small.spots()]);
    assert!(nearest >= 0.6 * 21.0, "{nearest}");
}

#[test]
fn a_ring_goes_round_each_mark_beneath() {
    let mut rings = stripes(6.0);
    rings.after = After::Around;
    let grown = grown(&on("sphere", 130.0, vec![spots(13.0, 62.0), rings]));
    let [inner, rings] = &grown.layers[..] else { panic!("two layers") };
    let away = from_marks(rings, inner);
    let covered = |low: f64, high: f64| {
        let there = away.iter().zip(&rings.levelled.pattern).filter(|(away, _)| (low..high).contains(*away));
        let [sum, count] =
            there.fold([0.0; 2], |[sum, count], (_, value)| [sum + f64::from(*value), count + 1.0]);
        sum / count
    };
    // The centre line is 0.8 widths off, and two widths off all is ground.
    assert!(
        covered(4.0, 5.6) > 0.6 && covered(14.0, 20.0) < 0.1,
        "{} {}",
        covered(4.0, 5.6),
        covered(14.0, 20.0)
    );
    let width = grown.report("test", 0.0).layers[1].regions[0].error[&Attribute::Width];
    assert!(width.abs() < 0.01, "{width}");
}

#[test]
fn a_net_is_one_piece_between_the_marks_beneath() {
    let mut net = stripes(6.0);
    net.after = After::Net;
    let grown = grown(&on("sphere", 130.0, vec![spots(15.0, 50.0), net]));
    let [inner, net] = &grown.layers[..] else { panic!("two layers") };
    let surface = net.plan.surface();
    let is_net: Vec<bool> = net.levelled.pattern.iter().map(|value| *value >= EDGE).collect();
    let start = is_net.iter().position(|is_net| *is_net).expect("a net");
    let (mut reached, mut left) = (vec![false; is_net.len()], vec![start]);
    while let Some(vertex) = left.pop() {
        if !std::mem::replace(&mut reached[vertex], true) {
            left.extend(surface.ring(vertex).filter(|next| is_net[*next] && !reached[*next]));
        }
    }
    let [one, all] = [&reached, &is_net].map(|set| set.iter().filter(|set| **set).count());
    assert!(all > 200 && one as f64 > 0.97 * all as f64, "{one} of {all}");
    let touching =
        from_marks(net, inner).iter().zip(&is_net).filter(|(away, is_net)| **away == 0.0 && **is_net).count();
    assert_eq!(touching, 0);
}

#[test]
fn a_smaller_spot_stands_inside_each_spot_of_the_layer_beneath() {
    let mut inside = spots(5.0, 20.0);
    inside.after = After::Inside;
    let grown = grown(&on("sphere", 200.0, vec![spots(11.0, 44.0), inside]));
    let [outer, inner] = &grown.layers[..] else { panic!("two layers") };
    assert!(outer.spots() > 40 && inner.spots() == outer.spots(), "{} {}", outer.spots(), inner.spots());
    let area = grown.report("test", 0.0).layers[1].regions[0].error[&Attribute::Area];
    assert!(area.abs() < 1e-3, "{area}");
}

#[test]
fn turings_spots_have_the_area_that_is_asked() {
    let mut layer = spots(5.0, 19.0);
    layer.system = crate::document::SystemChoice::Of(System::TURING_SPOTS.description());
    let grown = grown(&on("sphere", 140.0, vec![layer]));
    let error = &grown.report("test", 0.0).layers[0].regions[0].error;
    assert!(error[&Attribute::Area].abs() < 2e-3 && error[&Attribute::Spacing].abs() < 0.05, "{error:?}");
}

#[test]
fn irregular_spots_differ_from_each_other_and_keep_their_mean_area() {
    let spread = |irregular: f64| {
        let mut layer = spots(5.0, 19.0);
        layer.system = crate::document::SystemChoice::Of(System::TURING_SPOTS.description());
        layer.options.irregular = irregular;
        let grown = grown(&on("sphere", 140.0, vec![layer]));
        let error = grown.report("test", 0.0).layers[0].regions[0].error[&Attribute::Area];
        assert!(error.abs() < 2e-3, "{error}");
        let areas: Vec<f64> = grown.layers[0].levelled.measured.spots.iter().map(|spot| spot.area).collect();
        let mean = areas.iter().sum::<f64>() / areas.len() as f64;
        let squares = areas.iter().map(|area| (area / mean - 1.0) * (area / mean - 1.0)).sum::<f64>();
        (squares / areas.len() as f64).sqrt()
    };
    let [even, uneven] = [0.0, 0.8].map(spread);
    assert!(even < 0.12 && uneven > even + 0.12, "{even} {uneven}");
}

#[test]
fn ragged_marks_have_longer_edges_and_keep_their_number_and_size() {
    let edges = |layer: Layer, sigma: f64| {
        let mut layer = layer;
        layer.options.ragged = RaggedChoice::Given(sigma);
        let grown = grown(&on("sphere", 160.0, vec![layer]));
        let region = &grown.report("test", 0.0).layers[0].regions[0];
        let size = region.error.get(&Attribute::Area).or(region.error.get(&Attribute::Width)).copied();
        let layer = &grown.layers[0];
        let found = surface_stripes(layer.plan.surface(), &layer.levelled.pattern, EDGE, 1, &|_| 0);
        (found[0].contour, size.expect("a size"), layer.spots())
    };
    for make in [|| spots(9.0, 30.0), || stripes(9.0)] {
        let [(smooth, _, count), (rough, size, also)] = [0.0, 0.3].map(|sigma| edges(make(), sigma));
        // Of spots so far apart 0.55 more are asked, of such stripes 0.44.
        let excess = (rough / smooth) * (rough / smooth) - 1.0;
        assert!((0.35..0.75).contains(&excess), "{excess}");
        assert_eq!(also, count);
        if count > 0 {
            assert!(size.abs() < 0.01, "{size}");
        }
    }
}

#[test]
fn spots_that_are_drawn_on_the_model_grow_in_their_places_with_their_areas() {
    let at = [[0.0, 0.0, 1.0], [0.5, 0.5, 0.7], [-0.6, 0.3, 0.74]];
    let radii = [5.0, 4.4, 5.5];
    let mark = |(at, radius): ([f64; 3], f64)| {
        BodyMark::Ellipse(BodyEllipse { at, normal: None, radii: [radius; 2], angle: 0.0 })
    };
    let mut layer = spots(5.0, 24.0);
    layer.on_model = at.into_iter().zip(radii).map(mark).collect();
    let grown = grown(&on("sphere", 140.0, vec![layer]));
    let (layer, scale) = (&grown.layers[0], &grown.placed.scale);
    let surface = layer.plan.surface();
    for (at, radius) in at.into_iter().zip(radii) {
        let away = distances(surface, &[surface.closest(scale.to_px(at))]);
        let off = |spot: &&crate::measure::SurfaceSpot| away[surface.vertex_of(spot.place)];
        let spots = layer.levelled.measured.spots.iter();
        let nearest = spots.min_by(|a, b| off(a).total_cmp(&off(b))).expect("spots");
        assert!(off(&nearest) < 2.5, "{at:?}: {}", off(&nearest));
        let area = nearest.area / (std::f64::consts::PI * radius * radius);
        assert!((area - 1.0).abs() < 0.12, "{at:?}: {area}");
    }
}

#[test]
fn spots_vary_as_much_as_is_asked() {
    let mut layer = spots(5.0, 24.0);
    layer.options.spread = SpreadChoice::Given(Spread { area: 0.3, ..Spread::ZERO });
    let grown = grown(&on("sphere", 200.0, vec![layer]));
    let areas: Vec<f64> = grown.layers[0].levelled.measured.spots.iter().map(|spot| spot.area).collect();
    let mean = areas.iter().sum::<f64>() / areas.len() as f64;
    let squares = areas.iter().map(|area| (area / mean - 1.0) * (area / mean - 1.0)).sum::<f64>();
    let spread = (squares / areas.len() as f64).sqrt();
    assert!((spread - 0.3).abs() < 0.05, "{spread}");
    assert!((mean / 78.54 - 1.0).abs() < 2e-3, "{mean}");
}
