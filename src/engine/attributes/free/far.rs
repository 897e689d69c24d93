//! What is wanted far from all marks.
//!
//! Near marks the spacing follows what was drawn there. Far from all of them nothing was drawn, and one spacing in round steps is as
//! good a guess as any between them: it stays the same while single marks are moved, and so can the spots that stand there.

use super::regression::weighted_median;
use crate::attributes::Spots;
use crate::grid::{Bounds, PointBuckets};

/// Up to this distance from a mark, in spacings, what is wanted follows the marks. Not tuned.
const NEAR: f64 = 1.25;
/// Beyond this distance from all marks, in spacings, what is wanted does not follow them. Not tuned: room for a ring of spots or
/// two between them.
const BEYOND: f64 = 2.5;
/// About how far logarithms of the distances of marks that are drawn by hand differ from their mean. That of n marks is known to this ÷ √n.
const DRAWN: f64 = 0.15;
/// Steps to which the logarithm of the spacing is rounded, in [`DRAWN`] ÷ √n.
const STEP: f64 = 2.0;
/// Largest step: a twentieth more or less is hardly seen.
const LARGEST_STEP: f64 = 0.1;
/// A spacing that was wanted before the last change stays while the logarithm of what is drawn is no farther from its own, in
/// [`DRAWN`] ÷ √n: two standard deviations.
const KEPT: f64 = 2.0;
/// However few the marks are, it stays no longer once it is farther off than this. Not tuned: one and a half of the largest steps.
const FARTHEST_KEPT: f64 = 0.15;
/// Where the logarithms of spacings and lengths far from marks differ from one value by less than this, in [`DRAWN`] ÷ √n, that value is
/// wanted: what is extrapolated from marks drawn by hand differs by as much by chance.
const SAME: f64 = 7.0;
/// Shapes −ln aspect · (cos 2θ, sin 2θ) that differ from their mean by less than this count as that mean. Not tuned.
const SAME_SHAPE: f64 = 0.25;

/// The places far from all marks, and the spots wanted there.
#[derive(Clone, Debug, PartialEq)]
pub struct Far {
    centers: PointBuckets,
    /// The spacing, px; infinite while it is free.
    spacing: f64,
}

impl Far {
    /// The places far from marks at `centers` whose distances have these logarithms and weights; without any the spacing is free.
    /// `before`: the spacing that was wanted before marks were changed, px.
    pub(super) fn new(
        bounds: Bounds,
        centers: &[[f64; 2]],
        distances: impl Iterator<Item = (f64, f64)>,
        before: Option<f64>,
    ) -> Self {
        let distances: Vec<(f64, f64)> = distances.collect();
        let spacing = if distances.is_empty() {
            f64::INFINITY
        } else {
            let drawn = weighted_median(distances.into_iter());
            let known_to = known_to(centers.len());
            let step = (STEP * known_to).min(LARGEST_STEP);
            let stays =
                |spacing: &f64| (libm::log(*spacing) - drawn).abs() <= (KEPT * known_to).min(FARTHEST_KEPT);
            before.filter(stays).unwrap_or_else(|| libm::exp(step * (drawn / step).round()))
        };
        Self { centers: PointBuckets::new(bounds, centers.to_vec()), spacing }
    }

    /// The spacing wanted there, px.
    #[must_use]
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// The centres of the marks, px.
    #[must_use]
    pub fn centers(&self) -> &[[f64; 2]] {
        self.centers.points()
    }

    /// Places farther than this from all marks, px, are far.
    #[must_use]
    pub fn reach(&self) -> f64 {
        BEYOND * self.spacing
    }

    /// How far what is wanted at a point, px, follows the marks, 0..1; 0 = it is far from all.
    #[must_use]
    pub fn nearness(&self, point: [f64; 2]) -> f64 {
        let nearest =
            self.centers.nearest(point, 1, |_| true).first().map_or(f64::INFINITY, |square| square.sqrt());
        let t = ((BEYOND - nearest / self.spacing) / (BEYOND - NEAR)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }

    /// Whether spots that are wanted there are those of one spacing and one shape, nearly: of this mean.
    pub(super) fn is_wanted(&self, wanted: &Spots, mean: &Spots) -> bool {
        let shape = |spots: &Spots| {
            let (s, c) = libm::sincos((2.0 * spots.angle).to_radians());
            let long = -libm::log(spots.aspect);
            [long * c, long * s]
        };
        let [a, b] = [wanted, mean].map(shape);
        let turned = ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt() < SAME_SHAPE;
        let same = |log: f64| log.abs() < SAME * known_to(self.centers.points().len());
        let apart = wanted.spacing.is_none_or(|spacing| same(libm::log(spacing / self.spacing)));
        let as_large = same(0.5 * libm::log(wanted.area / mean.area));
        turned && apart && as_large
    }

    /// These marks with this spacing, px.
    pub(super) fn with_spacing(&self, spacing: f64) -> Self {
        Self { spacing, centers: self.centers.clone() }
    }

    /// These marks on a canvas of another size, px: they move with it.
    pub(super) fn resized(&self, size: [f64; 2]) -> Self {
        let bounds = self.centers.bounds();
        let moved = |at: &[f64; 2]| [0, 1].map(|axis| at[axis] * size[axis] / bounds.size[axis]);
        let centers = self.centers.points().iter().map(moved).collect();
        Self { centers: PointBuckets::new(Bounds { size, ..bounds }, centers), spacing: self.spacing }
    }
}

/// How well the logarithm of a mean length of so many drawn marks is known.
fn known_to(marks: usize) -> f64 {
    DRAWN / (marks.max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::Attributes;
    use crate::attributes::free::{FreeMap, far_spacing};
    use crate::grid::Edges;
    use crate::marks::{Ellipse, Mark};

    const SIZE: [f64; 2] = [800.0, 800.0];

    /// Twelve ellipses in a corner, 40 px apart but for some px, `wider` by so much from one column to the next.
    fn corner(wider: f64) -> Vec<Ellipse> {
        let ellipse = |k: usize| {
            let (column, row) = ((k % 4) as f64, (k / 4) as f64);
            let off = |step: f64| 8.0 * (step * k as f64).fract() - 4.0;
            let larger = 1.0 + wider * column;
            let center =
                [60.0 + 40.0 * column * larger + off(0.618), 60.0 + 36.0 * row * larger + off(0.414)];
            Ellipse { center, radii: [9.0 * larger, 7.0 * larger], angle: 40.0 + off(0.732) }
        };
        (0..12).map(ellipse).collect()
    }

    fn map(ellipses: &[Ellipse]) -> FreeMap {
        let marks: Vec<Mark> = ellipses.iter().map(|ellipse| Mark::Ellipse(*ellipse)).collect();
        FreeMap::from_marks(&marks, SIZE, Edges::Closed).expect("ellipses")
    }

    fn centers(ellipses: &[Ellipse]) -> Vec<[f64; 2]> {
        ellipses.iter().map(|ellipse| ellipse.center).collect()
    }

    fn spacing(map: &FreeMap, at: [f64; 2]) -> f64 {
        let Attributes::Spots(Spots { spacing: Some(spacing), .. }) = map.at(at) else {
            panic!("twelve ellipses")
        };
        spacing
    }

    #[test]
    fn far_from_all_marks_the_spacing_stays_while_one_of_them_moves() {
        let before = map(&corner(0.0));
        let far = before.far().expect("one pattern").spacing();
        assert!(libm::log(far / 40.0).abs() < 0.1, "{far}");
        let mut stays = 0;
        for index in 0..12 {
            let mut moved = corner(0.0);
            moved[index].center[0] += 5.0;
            moved[index].center[1] -= 4.0;
            let after = map(&moved);
            let at = [[300.0, 300.0], [700.0, 100.0], [500.0, 760.0]];
            assert!(at.iter().all(|at| after.far().is_some_and(|far| far.nearness(*at) == 0.0)));
            let near = moved[index].center;
            assert!(spacing(&before, near) != spacing(&after, near));
            stays += usize::from(at.iter().all(|at| (spacing(&after, *at) / far - 1.0).abs() < 1e-9));
        }
        assert!(stays >= 10, "{stays} of 12");
    }

    #[test]
    fn a_spacing_from_before_stays_while_the_marks_agree_with_it() {
        let centers = centers(&corner(0.0));
        let of = |before: Option<f64>| far_spacing(&centers, SIZE, Edges::Closed, before).expect("distances");
        let alone = of(None);
        // Twelve marks: two standard deviations are 2 · 0.15 ÷ √12 = 0.087, and the rounded one is half a step of that off at most.
        for near in [0.96, 1.0, 1.04] {
            assert_eq!(of(Some(near * alone)), near * alone);
        }
        for far in [0.8, 1.2] {
            assert_eq!(of(Some(far * alone)), alone);
        }
    }

    #[test]
    fn with_the_spacing_from_before_no_single_mark_that_is_moved_changes_the_one_far_away() {
        let before = far_spacing(&centers(&corner(0.0)), SIZE, Edges::Closed, None);
        for index in 0..12 {
            for by in [[9.0, -8.0], [-9.0, 8.0], [12.0, 0.0]] {
                let mut moved = corner(0.0);
                moved[index].center = [0, 1].map(|axis| moved[index].center[axis] + by[axis]);
                assert_eq!(
                    far_spacing(&centers(&moved), SIZE, Edges::Closed, before),
                    before,
                    "{index} {by:?}"
                );
            }
        }
    }

    #[test]
    fn sizes_that_grow_across_the_marks_go_on_growing_beyond_them() {
        assert!(map(&corner(0.3)).far().is_none());
    }

    #[test]
    fn marks_that_are_drawn_too_near_each_other_change_nothing_far_away() {
        let mut near = corner(0.0);
        near[5].center = [near[6].center[0] - 17.0, near[6].center[1]];
        let mut limited = map(&near);
        let far = limited.far().expect("one pattern").spacing();
        // Spots of 200 px² and 38 px apart are a little less dense than that.
        assert!(limited.limit_density(0.145));
        assert_eq!(limited.far().map(Far::spacing), Some(far));
        assert!((spacing(&limited, [700.0, 700.0]) / far - 1.0).abs() < 1e-9);
        assert!(limited.limit_density(0.05) && limited.far().is_none());
    }

    #[test]
    fn no_place_is_far_where_only_few_spots_would_be() {
        let ellipses = corner(0.0);
        let marks: Vec<Mark> = ellipses.iter().map(|ellipse| Mark::Ellipse(*ellipse)).collect();
        let of = |side: f64| FreeMap::from_marks(&marks, [side; 2], Edges::Closed).expect("ellipses");
        assert!(of(250.0).far().is_none() && of(600.0).far().is_some());
    }

    #[test]
    fn the_places_far_from_a_single_mark_do_not_depend_on_where_it_is() {
        for x in [100.0, 400.0] {
            let one = Ellipse { center: [x, 400.0], radii: [9.0, 7.0], angle: 0.0 };
            let mut map = map(&[one]);
            map.fill_free_spacing(|_| 40.0);
            let far = map.far().expect("a wide canvas");
            assert_eq!((far.spacing(), far.nearness([x + 101.0, 400.0])), (40.0, 0.0));
        }
    }

    #[test]
    fn far_places_move_with_the_marks_when_the_canvas_is_stretched() {
        let map = map(&corner(0.0)).resized([1600.0, 800.0]);
        let far = map.far().expect("one pattern");
        let nearest = corner(0.0)[3].center;
        assert_eq!(far.nearness([2.0 * nearest[0], nearest[1]]), 1.0);
        assert_eq!(far.nearness([2.0 * nearest[0] + 2.6 * far.spacing(), nearest[1]]), 0.0);
    }
}
