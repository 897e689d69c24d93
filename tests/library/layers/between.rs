//! The relation `between`: marks keep away from the marks beneath, and each layer has the drawn attributes.

use super::{cascade, covered, grown, patterns, spots, stripes, try_grow};
use dapple::document::Spread;
use dapple::document::{Layer, SpreadChoice, SystemChoice};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::rd::System;
use dapple_engine::synth::{Grown, Measured};

/// Pairs of neighbouring points (of eight each) of which a lower layer covers one and a higher layer the other.
fn touching(patterns: &[Field]) -> usize {
    let mut beneath = vec![false; patterns[0].values.len()];
    let mut touching = 0;
    for pattern in patterns {
        let own = covered(pattern);
        let (nx, ny) = (pattern.width, pattern.height);
        for cell in (0..own.len()).filter(|cell| own[*cell]) {
            let (x, y) = ((cell % nx) as isize, (cell / nx) as isize);
            for (dy, dx) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dy, dx))) {
                let [x, y] = [pattern.edges.index(x + dx, nx), pattern.edges.index(y + dy, ny)];
                touching += usize::from(beneath[y * nx + x]);
            }
        }
        beneath.iter_mut().zip(own).for_each(|(beneath, own)| *beneath |= own);
    }
    touching
}

/// The aspect above which no direction is measured.
const ROUND: f64 = 0.85;

/// Asserts that every layer is within 5 % of its area (width), within 5.5 % of its spacing (where there is room for
/// only one row of spots, the spacing is that of the row), and within 3° of its angle.
fn assert_as_drawn(grown: &Grown, of: &str) {
    for (index, layer) in grown.layers.iter().enumerate() {
        let of = format!("{of}, layer {}", index + 1);
        assert!(layer.settled(), "{of} is still moving");
        let errors: Vec<(&str, Option<f64>, f64)> = match &layer.marks().expect("marks").measured {
            Measured::Spots { errors, .. } => {
                let errors = &errors[0];
                assert!(errors.marks > 12, "{of}: {} marks", errors.marks);
                let round = errors.wanted.unwrap().aspect > ROUND;
                assert_eq!(errors.angle.is_none(), round, "{of}: round spots have no direction");
                let angle = errors.angle.or(round.then_some(0.0));
                vec![("area", errors.area, 0.05), ("spacing", errors.spacing, 0.055), ("angle", angle, 3.0)]
            }
            Measured::Stripes(errors) => {
                vec![("width", errors[0].width, 0.05), ("angle", errors[0].angle, 3.0)]
            }
        };
        for (name, error, allowed) in errors {
            assert!(error.is_some_and(|error| error.abs() < allowed), "{of}: {name} is off by {error:?}");
        }
    }
}

fn large() -> Layer {
    spots(850.0, 0.83, 30.0, 80.0)
}

fn small() -> Layer {
    spots(63.0, 0.8, 60.0, 24.0)
}

fn assert_between(of: &str, layers: &[Layer], edges: Edges) {
    for seed in [1, 2] {
        let document = cascade(edges, seed, layers.to_vec());
        let grown = grown(&document);
        let of = format!("{of}, seed {seed}");
        assert_as_drawn(&grown, &of);
        assert_eq!(touching(&patterns(&grown)), 0, "{of}: touching");
    }
}

#[test]
fn spots_grow_between_spots() {
    assert_between("cheetah", &[large(), small()], Edges::Closed);
    assert_between("cheetah tile", &[large(), small()], Edges::Wrap);
}

#[test]
fn turings_spots_grow_between_spots() {
    let turing = Layer {
        system: SystemChoice::Of(System::TURING_SPOTS.description()),
        ..spots(115.0, 0.75, 60.0, 23.0)
    };
    assert_between("Turing", &[large(), turing], Edges::Closed);
}

#[test]
fn thin_stripes_grow_between_stripes() {
    assert_between("lionfish", &[stripes(24.0, 20.0), stripes(4.0, 20.0)], Edges::Closed);
}

#[test]
fn spots_grow_between_stripes() {
    assert_between("lanes", &[stripes(24.0, 20.0), small()], Edges::Closed);
}

#[test]
fn stripes_grow_around_spots() {
    assert_between("stream", &[large(), stripes(5.0, 20.0)], Edges::Wrap);
}

#[test]
fn three_layers_grow_between_each_other() {
    let middle = spots(176.0, 0.875, 0.0, 36.0);
    assert_between("three", &[large(), middle, spots(28.3, 1.0, 0.0, 16.0)], Edges::Closed);
}

#[test]
fn neighbouring_spots_stay_apart_where_marks_beneath_leave_little_room() {
    for seed in 3..7 {
        let document = cascade(Edges::Closed, seed, vec![large(), small()]);
        let grown = grown(&document);
        let Measured::Spots { marks, .. } = &grown.layers[1].marks().expect("marks").measured else {
            panic!("spots")
        };
        let merged = marks.iter().filter(|mark| mark.whole && mark.ellipse.area() > 1.6 * 63.0).count();
        assert_eq!(merged, 0, "seed {seed}, of {} marks", marks.len());
    }
}

#[test]
fn marks_too_large_for_what_is_left_are_refused_before_they_are_grown() {
    let mut varied = spots(5000.0, 1.0, 0.0, 150.0);
    varied.options.spread = SpreadChoice::Given(Spread { area: 0.2, ..Spread::ZERO });
    for too_large in [spots(5000.0, 1.0, 0.0, 150.0), varied, stripes(120.0, 20.0)] {
        let document = cascade(Edges::Closed, 1, vec![large(), too_large]);
        let error = try_grow(&document).err().expect("no room").to_string();
        assert!(error.starts_with("test: layer 2 finds no room"), "{error}");
    }
}
