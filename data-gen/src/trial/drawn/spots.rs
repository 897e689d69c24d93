//! Compares drawn ellipses with the grown shapes.

use dapple_engine::marks::{Ellipse, turn};

use super::geometry::{distance, radius, visible, well_apart};
use super::shapes::{Shape, Shapes};

/// A mark counts as being at its place within this distance, radii √(r₁r₂).
const PLACE: f64 = 0.5;
/// The aspect above which marks are too round to have a direction.
const ROUND: f64 = 0.8;

/// The comparison of a drawn ellipse with the grown shapes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spot {
    /// Whether exactly one grown shape is centred at its place, and this shape belongs to no other mark.
    pub there: bool,
    /// Distance of the centres, radii.
    pub distance: Option<f64>,
    /// Area grown ÷ drawn − 1.
    pub area: Option<f64>,
    /// Difference of the aspects.
    pub aspect: Option<f64>,
    /// Difference of the directions, degrees.
    pub angle: Option<f64>,
    /// For a missing ellipse: whether one that is there is nearer than a quarter of their mean diameter.
    pub too_near: bool,
}

/// The comparison of each of the `drawn` ellipses.
pub fn compare(drawn: &[Ellipse], shapes: &Shapes, size: [f64; 2]) -> Vec<Spot> {
    let seen: Vec<(f64, [f64; 2])> = drawn.iter().map(|mark| visible(mark, size)).collect();
    let off =
        |mark: usize, shape: &Shape| distance(seen[mark].1, shape.ellipse.center) / radius(&drawn[mark]);
    let grown = matches(drawn.len(), &shapes.all, off);
    let mut spots: Vec<Spot> = grown
        .iter()
        .enumerate()
        .map(|(mark, grown)| {
            grown.map_or_else(Spot::default, |grown| {
                let shape = &shapes.all[grown];
                errors(&drawn[mark], seen[mark].0, shape, off(mark, shape))
            })
        })
        .collect();
    for mark in 0..drawn.len() {
        let near = |other: usize| spots[other].there && !well_apart(&drawn[mark], &drawn[other]);
        spots[mark].too_near = !spots[mark].there && (0..drawn.len()).any(near);
    }
    spots
}

/// For each mark, the only shape at its place, if this shape is nearer to no other mark. `off` is the distance between
/// a mark and a shape, in radii of the mark.
fn matches(marks: usize, shapes: &[Shape], off: impl Fn(usize, &Shape) -> f64) -> Vec<Option<usize>> {
    let only = |mark: usize| {
        let mut at = (0..shapes.len()).filter(|shape| off(mark, &shapes[*shape]) <= PLACE);
        at.next().filter(|_| at.next().is_none())
    };
    let mut found: Vec<Option<usize>> = (0..marks).map(only).collect();
    for mark in 0..marks {
        let Some(shape) = found[mark] else { continue };
        let own = off(mark, &shapes[shape]);
        let nearer = |other: usize| {
            let its = off(other, &shapes[shape]);
            other != mark && found[other] == Some(shape) && (its, other) < (own, mark)
        };
        if (0..marks).any(nearer) {
            found[mark] = None;
        }
    }
    found
}

fn errors(drawn: &Ellipse, share: f64, shape: &Shape, distance: f64) -> Spot {
    // The part beyond the border is unknown, so neither shape nor direction can be compared.
    let whole = share == 1.0 && !shape.cut;
    let [asked, got] = [drawn.aspect(), shape.ellipse.aspect()];
    Spot {
        there: true,
        distance: Some(distance),
        area: Some(shape.ellipse.area() / (share * drawn.area()) - 1.0),
        aspect: whole.then_some(got - asked),
        angle: (whole && asked < ROUND).then(|| turn(shape.ellipse.major_angle(), drawn.major_angle())),
        too_near: false,
    }
}

/// Pairs of drawn ellipses, far enough from each other, that have grown together.
pub fn merged(drawn: &[Ellipse], shapes: &Shapes) -> usize {
    let at: Vec<Option<u32>> = drawn.iter().map(|mark| shapes.at(mark.center)).collect();
    let together = |a: usize, b: usize| at[a].is_some() && at[a] == at[b] && well_apart(&drawn[a], &drawn[b]);
    (0..drawn.len()).map(|a| (0..a).filter(|b| together(a, *b)).count()).sum()
}

#[cfg(test)]
mod tests {
    use super::super::shapes::tests::of;
    use super::*;

    const SIZE: [f64; 2] = [60.0, 40.0];

    fn mark(x: f64, y: f64) -> Ellipse {
        Ellipse { center: [x, y], radii: [7.0, 4.0], angle: 30.0 }
    }

    #[test]
    fn a_mark_that_grew_as_drawn_is_there_without_errors() {
        let drawn = [mark(15.0, 20.0), mark(45.0, 20.0)];
        for spot in compare(&drawn, &of(&drawn), SIZE) {
            assert!(
                spot.there && spot.distance.unwrap() < 0.02 && spot.area.unwrap().abs() < 0.01,
                "{spot:?}"
            );
            assert!(spot.aspect.unwrap().abs() < 0.01 && spot.angle.unwrap().abs() < 0.5, "{spot:?}");
        }
    }

    #[test]
    fn a_mark_that_is_missing_moved_or_there_twice_does_not_count_as_there() {
        let drawn = [mark(15.0, 20.0)];
        let there = |grown: &[Ellipse]| compare(&drawn, &of(grown), SIZE)[0].there;
        assert!(!there(&[]) && !there(&[mark(18.0, 20.0)]) && there(&[mark(16.5, 20.0)]));
        let half = |y| Ellipse { center: [15.0, y], radii: [6.0, 1.4], angle: 0.0 };
        assert!(!there(&[half(18.2), half(21.8)]));
    }

    #[test]
    fn one_grown_mark_counts_for_the_nearer_of_two_drawn_ones() {
        let drawn = [mark(15.0, 20.0), mark(16.5, 20.0)];
        let spots = compare(&drawn, &of(&[mark(16.2, 20.0)]), SIZE);
        assert_eq!(
            spots.iter().map(|spot| (spot.there, spot.too_near)).collect::<Vec<_>>(),
            [(false, true), (true, false)]
        );
    }

    #[test]
    fn two_that_grew_together_are_merged() {
        let drawn = [15.0, 35.0].map(|x| Ellipse { center: [x, 20.0], radii: [8.0; 2], angle: 0.0 });
        let bar = Ellipse { center: [25.0, 20.0], radii: [20.0, 6.0], angle: 0.0 };
        assert_eq!((merged(&drawn, &of(&drawn)), merged(&drawn, &of(&[bar]))), (0, 1));
    }

    #[test]
    fn a_mark_cut_by_the_border_is_compared_by_what_is_visible() {
        let drawn = [mark(1.0, 20.0)];
        let spot = compare(&drawn, &of(&drawn), SIZE)[0];
        assert!(spot.there && spot.distance.unwrap() < 0.05 && spot.area.unwrap().abs() < 0.03, "{spot:?}");
        assert!(spot.aspect.is_none() && spot.angle.is_none());
    }
}
