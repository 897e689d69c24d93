//! Stripes that cross those of a layer beneath pass under them.

use super::{cascade, covered, grown, patterns, stripes};
use dapple::internals::grid::{Edges, Field};
use dapple::internals::synth::Measured;

/// Rows of the canvas in the middles of the gaps between the horizontal stripes of a layer that reach from border to border.
fn gaps(stripes: &Field) -> Vec<usize> {
    let free = |y: usize| stripes.values[y * stripes.width..][..stripes.width].iter().all(|v| *v < 0.25);
    let mut gaps = Vec::new();
    let mut first = None;
    for y in 0..stripes.height {
        match (free(y), first) {
            (true, None) => first = Some(y),
            (false, Some(start)) => {
                gaps.push(usize::midpoint(start, y));
                first = None;
            }
            _ => {}
        }
    }
    gaps
}

#[test]
fn stripes_that_cross_those_beneath_continue_in_line_on_both_sides() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let grown = grown(&cascade(edges, 1, vec![stripes(14.0, 0.0), stripes(8.0, 90.0)]));
        let [below, above] = patterns(&grown).try_into().expect("two layers");
        let Measured::Stripes(errors) = &grown.layers[1].measured else { panic!("stripes") };
        assert!(errors[0].angle.unwrap().abs() < 3.0, "{edges:?}: {errors:?}");
        let [beneath, own] = [&below, &above].map(covered);
        assert!(own.iter().zip(&beneath).all(|(own, beneath)| !own || !beneath), "{edges:?}: overlap");
        let gaps = gaps(&below);
        assert!(gaps.len() > 8, "{edges:?}: {gaps:?}");
        let row = |y: usize| &own[y * above.width..][..above.width];
        for pair in gaps.windows(2) {
            let same = row(pair[0]).iter().zip(row(pair[1])).filter(|(a, b)| a == b).count();
            assert!(same as f64 > 0.9 * above.width as f64, "{edges:?}: {same} of {}", above.width);
        }
    }
}

#[test]
fn stripes_along_those_beneath_find_room_between_them() {
    let grown = grown(&cascade(Edges::Closed, 1, vec![stripes(24.0, 20.0), stripes(4.0, 30.0)]));
    assert!(grown.layers[1].crossed.is_none() && grown.layers[1].plan.obstacles.contains(&true));
}
