//! The relation `inside`: one smaller mark grows at each place of the layer beneath, and nothing else of that layer is
//! shown.

use super::{after, cascade, covered, grown, patterns, spots, stripes, try_grow};
use dapple::document::Edges;
use dapple::document::Spread;
use dapple::document::{After, Document, Layer, SpreadChoice, SystemChoice};
use dapple_engine::measure::Spot;
use dapple_engine::rd::System;
use dapple_engine::synth::drawn::is_replaced;
use dapple_engine::synth::{Grown, Measured};

fn inside(layer: Layer) -> Layer {
    after(After::Inside, layer)
}

fn marks(grown: &Grown, layer: usize) -> &[Spot] {
    match &grown.layers[layer].marks().expect("marks").measured {
        Measured::Spots { marks, .. } => marks,
        Measured::Stripes(_) => panic!("spots"),
    }
}

/// For each mark of the layer beneath: the number of marks of the next layer that are nearest to it, and their largest
/// distance, in radii of the marks beneath. With `wrap`, distances go across the border.
fn hits(grown: &Grown, layer: usize, edges: Edges) -> (Vec<usize>, f64) {
    let side = grown.size.map(f64::from);
    let apart = |a: [f64; 2], b: [f64; 2]| {
        let along = |axis: usize| {
            let d = (a[axis] - b[axis]).abs();
            if edges == Edges::Wrap { d.min(side[axis] - d) } else { d }
        };
        (along(0) * along(0) + along(1) * along(1)).sqrt()
    };
    let places: Vec<[f64; 2]> = marks(grown, layer - 1).iter().map(|mark| mark.ellipse.center).collect();
    let Measured::Spots { errors, .. } = &grown.layers[layer - 1].marks().expect("marks").measured else {
        panic!("spots")
    };
    let radius = (errors[0].got.expect("spots").area / std::f64::consts::PI).sqrt();
    let (mut hits, mut farthest) = (vec![0; places.len()], 0.0f64);
    for mark in marks(grown, layer) {
        let far = |place: &usize| apart(places[*place], mark.ellipse.center);
        let nearest = (0..places.len()).min_by(|a, b| far(a).total_cmp(&far(b))).expect("a place");
        hits[nearest] += 1;
        farthest = farthest.max(far(&nearest) / radius);
    }
    (hits, farthest)
}

#[track_caller]
fn assert_one_each(grown: &Grown, layer: usize, edges: Edges, of: &str) {
    let (hits, farthest) = hits(grown, layer, edges);
    assert!(hits.len() > 12 && hits.iter().all(|hits| *hits == 1), "{of}: {hits:?}");
    assert!(farthest < 0.75, "{of}: {farthest} radii from its place");
}

/// Asserts that area, aspect, angle and spacing of a layer are the drawn ones, within 5 % and 3°.
#[track_caller]
fn assert_as_drawn(grown: &Grown, layer: usize, of: &str) {
    let Measured::Spots { errors, .. } = &grown.layers[layer].marks().expect("marks").measured else {
        panic!("spots")
    };
    let aspect = |index: usize| errors[index].wanted.expect("wanted").aspect;
    for (index, error) in errors.iter().enumerate() {
        let shape = error.aspect.map(|off| off / aspect(index));
        for (name, off, allowed) in [
            ("area", error.area, 0.05),
            ("aspect", shape, 0.05),
            ("angle", error.angle, 3.0),
            ("spacing", error.spacing, 0.05),
        ] {
            // Round spots have no direction.
            let unmeasured = name == "angle" && aspect(index) > 0.85;
            let good = off.map_or(unmeasured, |off| off.abs() < allowed);
            assert!(good, "{of}: {name} is off by {off:?} in region {index}");
        }
    }
    assert!(grown.layers[layer].marks().expect("marks").settled, "{of} is still moving");
}

#[test]
fn each_place_has_one_mark_and_no_mark_is_elsewhere_with_ten_seeds() {
    for edges in [Edges::Wrap, Edges::Closed] {
        for seed in 1..=10 {
            let of = format!("{edges:?}, seed {seed}");
            let layers = vec![spots(800.0, 0.9, 20.0, 62.0), inside(spots(150.0, 0.5, 70.0, 30.0))];
            let grown = grown(&cascade(edges, seed, layers));
            assert_one_each(&grown, 1, edges, &of);
            assert_as_drawn(&grown, 1, &of);
        }
    }
}

#[test]
fn marks_of_any_smaller_size_and_shape_stand_at_their_places() {
    for (of, beneath, own) in [
        ("hardly smaller", spots(800.0, 0.9, 0.0, 66.0), spots(650.0, 0.9, 0.0, 30.0)),
        ("tiny", spots(800.0, 0.7, 110.0, 62.0), spots(16.0, 0.6, 40.0, 30.0)),
        ("across", spots(800.0, 0.5, 0.0, 66.0), spots(150.0, 0.5, 90.0, 30.0)),
        ("long", spots(800.0, 0.95, 0.0, 62.0), spots(120.0, 0.3, 70.0, 30.0)),
        ("far apart", spots(150.0, 0.9, 0.0, 75.0), spots(40.0, 0.6, 30.0, 30.0)),
    ] {
        let grown = grown(&cascade(Edges::Wrap, 4, vec![beneath, inside(own)]));
        assert_one_each(&grown, 1, Edges::Wrap, of);
        assert_as_drawn(&grown, 1, of);
    }
}

#[test]
fn turings_spots_can_give_the_places_too() {
    let beneath = Layer {
        system: SystemChoice::Of(System::TURING_SPOTS.description()),
        ..spots(800.0, 0.9, 0.0, 60.0)
    };
    let grown = grown(&cascade(Edges::Wrap, 2, vec![beneath, inside(spots(120.0, 0.6, 30.0, 30.0))]));
    assert_one_each(&grown, 1, Edges::Wrap, "Turing's");
    assert_as_drawn(&grown, 1, "Turing's");
}

#[test]
fn marks_that_differ_keep_their_places() {
    let mut own = spots(150.0, 0.6, 30.0, 30.0);
    own.options.spread = SpreadChoice::Given(Spread { area: 0.3, angle: 20.0, ..Spread::ZERO });
    let grown = grown(&cascade(Edges::Wrap, 2, vec![spots(800.0, 0.9, 0.0, 62.0), inside(own)]));
    assert_one_each(&grown, 1, Edges::Wrap, "varied");
    let Measured::Spots { errors, .. } = &grown.layers[1].marks().expect("marks").measured else {
        panic!("spots")
    };
    let spread = errors[0].spread.expect("many spots");
    assert!((0.22..0.38).contains(&spread.area) && (14.0..26.0).contains(&spread.angle), "{spread:?}");
}

#[test]
fn the_next_layer_keeps_away_from_the_small_marks_and_not_from_those_that_gave_the_places() {
    let layers = vec![
        spots(800.0, 0.9, 0.0, 62.0),
        inside(spots(150.0, 0.6, 30.0, 30.0)),
        spots(60.0, 0.8, 0.0, 22.0),
    ];
    let grown = grown(&cascade(Edges::Wrap, 3, layers));
    let patterns = patterns(&grown);
    let [hidden, small, next] = [0, 1, 2].map(|layer| covered(&patterns[layer]));
    let both = |a: &[bool], b: &[bool]| a.iter().zip(b).filter(|(a, b)| **a && **b).count();
    assert_eq!(both(&small, &next), 0);
    assert!(both(&hidden, &next) > 1_000, "{} px", both(&hidden, &next));
    assert_one_each(&grown, 1, Edges::Wrap, "beneath another");
}

#[test]
fn small_marks_stand_inside_those_that_stand_between_others() {
    let layers = vec![
        spots(850.0, 0.83, 30.0, 80.0),
        spots(200.0, 0.8, 30.0, 35.0),
        inside(spots(40.0, 0.6, 30.0, 30.0)),
    ];
    let document = cascade(Edges::Wrap, 3, layers);
    assert!([false, true, false] == [0, 1, 2].map(|layer| is_replaced(&document, layer)));
    let grown = grown(&document);
    assert_one_each(&grown, 2, Edges::Wrap, "between");
    let patterns = patterns(&grown);
    let [large, small] = [0, 2].map(|layer| covered(&patterns[layer]));
    assert!(!large.iter().zip(&small).any(|(large, small)| *large && *small));
}

#[track_caller]
fn refused(layers: Vec<Layer>, words: &[&str]) {
    let document: Document = cascade(Edges::Closed, 1, layers);
    let error = try_grow(&document).err().expect("refused").to_string();
    for word in words {
        assert!(error.contains(word), "{word} in {error}");
    }
}

#[test]
fn impossible_layers_inside_others_are_refused_with_the_reason() {
    let (large, small) = (spots(800.0, 0.9, 0.0, 62.0), spots(150.0, 0.6, 30.0, 30.0));
    let at = "layers[1].";
    refused(
        vec![stripes(8.0, 30.0), inside(small.clone())],
        &["layers[1].after", "the layer beneath grows stripes"],
    );
    refused(vec![large.clone(), inside(stripes(8.0, 30.0))], &["layers[1].after", "this layer holds lines"]);
    refused(vec![small.clone(), inside(large.clone())], &[at, "800 px²", "150 px²", "smaller"]);
    let turing = Layer { system: SystemChoice::Of(System::TURING_SPOTS.description()), ..small.clone() };
    refused(vec![large, inside(turing)], &["layers[1].system", "meinhardt-spots"]);
    refused(vec![inside(small)], &["layers[0].after", "beneath"]);
}
