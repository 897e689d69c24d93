//! Stripes that cross stripes of a layer beneath pass under these.

use super::{cascade, covered, grown, patterns, stripes};
use dapple::document::{Ellipse, Layer, Line, Stroke};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::synth::Measured;
use dapple_engine::synth::layer_report::report;

/// Of the places where a column of the canvas crosses a stripe of the layer below, the share at which the layer above
/// is the same on both sides: stripe or ground.
fn in_line(below: &Field, above: &Field) -> f64 {
    let [beneath, own] = [below, above].map(covered);
    let (width, height) = (above.width, above.height);
    let (mut same, mut all) = (0, 0);
    for x in 0..width {
        let free = |y: usize| !beneath[y * width + x];
        let mut y = 1;
        while y < height {
            if free(y - 1) && !free(y) {
                let start = y;
                while y < height && !free(y) {
                    y += 1;
                }
                // Two points from each edge.
                if start >= 2 && y + 1 < height {
                    all += 1;
                    same += usize::from(own[(start - 2) * width + x] == own[(y + 1) * width + x]);
                }
            }
            y += 1;
        }
    }
    assert!(all > 8 * width, "{all} of {width}");
    f64::from(same as u32) / f64::from(all as u32)
}

#[test]
fn stripes_that_cross_those_beneath_continue_in_line_on_both_sides() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let grown = grown(&cascade(edges, 1, vec![stripes(14.0, 0.0), stripes(8.0, 90.0)]));
        let [below, above] = patterns(&grown).try_into().expect("two layers");
        let Measured::Stripes(errors) = &grown.layers[1].marks().expect("marks").measured else {
            panic!("stripes")
        };
        assert!(errors[0].angle.unwrap().abs() < 3.0, "{edges:?}: {errors:?}");
        let [beneath, own] = [&below, &above].map(covered);
        assert!(own.iter().zip(&beneath).all(|(own, beneath)| !own || !beneath), "{edges:?}: overlap");
        let in_line = in_line(&below, &above);
        assert!(in_line > 0.85, "{edges:?}: {in_line}");
    }
}

#[test]
fn stripes_along_those_beneath_find_room_between_them() {
    let grown = grown(&cascade(Edges::Closed, 1, vec![stripes(24.0, 20.0), stripes(4.0, 30.0)]));
    assert!(
        grown.layers[1].marks().expect("marks").crossed.is_none()
            && grown.layers[1].marks().expect("marks").plan.obstacles.contains(&true)
    );
}

#[test]
fn a_drawn_line_grows_where_no_stripe_covers_it_and_a_wholly_covered_one_is_reported() {
    let line = |from: [f64; 2], to: [f64; 2], width: f64| Stroke::Line(Line { from, to, width });
    let layer = |strokes: Vec<Stroke>| Layer { strokes, ..Layer::default() };
    let spot = Stroke::Ellipse(Ellipse { center: [180.0, 150.0], radii: [40.0, 30.0], angle: 0.0 });
    let across = line([40.0, 150.0], [320.0, 150.0], 8.0);
    let beneath = line([165.0, 140.0], [195.0, 140.0], 8.0);
    let document = cascade(Edges::Closed, 1, vec![layer(vec![spot]), layer(vec![across, beneath])]);
    let report = report(&document, "lines", &grown(&document), 0.0);
    let told: Vec<_> = report.layers[1].drawn.iter().map(|mark| (mark.there, mark.reason)).collect();
    let wanted = [(true, None), (false, Some("on marks of a layer beneath, or outside of the canvas"))];
    assert_eq!(told, wanted);
}
