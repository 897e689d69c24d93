//! Linear interpolation between scattered rows.
//!
//! Of all ways to write the question q as a weighted mean of rows xᵢ, the one with the nearest rows,
//!
//! ```text
//! minimise Σ wᵢ |xᵢ − q|²   with   Σ wᵢ xᵢ = q,   Σ wᵢ = 1,   wᵢ ≥ 0
//! ```
//!
//! uses the corners of the Delaunay simplex that contains q: |x|² lifts the triangulation to a lower convex
//! hull (Brown, Information Processing Letters 9, 1979). So no triangulation in five dimensions is stored; a small linear
//! program for each question (simplex method in a tableau, Bland's rule) is enough.

use super::local::{Local, Sample};
use super::tree::Place;
use crate::learn::small_vector::{MOST, SmallVector};

/// Number of nearest rows among which the simplex is searched: at first, and if it is not found.
const AROUND: [usize; 2] = [60, 240];
/// Smaller numbers count as rounding errors.
const ROUNDING: f64 = 1e-9;
/// Most pivots; some twenty are usual.
const PIVOTS: usize = 2_000;

/// The sample nearest to `q`, where there is one: features and outputs.
pub(super) fn nearest(local: &Local, q: &SmallVector) -> Option<Sample> {
    local.nearest(q, None)
}

/// The interpolated sample at `q`; the nearest sample where `q` is not between samples.
pub(super) fn linear(local: &Local, q: &SmallVector) -> Option<Sample> {
    linear_in(local, q, local.dims(), |place, _| *place)
}

/// The interpolated sample where the last two features are cos and sin of one angle: a mean of points on a cylinder does not lie
/// on it, so angles are replaced by the sine of their difference from the question's.
pub(super) fn linear_on_a_cylinder(local: &Local, q: &SmallVector) -> Option<Sample> {
    let plain = local.dims() - 2;
    linear_in(local, q, plain + 1, |x, q| {
        let mut place = [0.0; MOST];
        place[..plain].copy_from_slice(&x[..plain]);
        place[plain] = x[plain + 1] * q[plain] - x[plain] * q[plain + 1];
        place
    })
}

/// The interpolated sample in `dims` coordinates, which `chart` computes from a place and the question.
fn linear_in(
    local: &Local,
    q: &SmallVector,
    dims: usize,
    chart: impl Fn(&Place, &Place) -> Place,
) -> Option<Sample> {
    let place = local.standardised(q);
    let near = local.near(&place, AROUND[1], None);
    let mut around = AROUND.map(|count| &near[..count.min(near.len())]).into_iter();
    let found = around.find_map(|near| {
        let places: Vec<Place> = near.iter().map(|near| chart(&local.known(*near)[0], &place)).collect();
        Some((near, weights(&places, &chart(&place, &place), dims)?))
    });
    let Some((near, weights)) = found else { return nearest(local, q) };
    let mut gives = [0.0; MOST];
    for (near, weight) in near.iter().zip(weights) {
        let [_, y] = local.known(*near);
        gives.iter_mut().zip(y).for_each(|(sum, y)| *sum += weight * y);
    }
    Some(Sample { at: *q, gives: SmallVector::new(gives.into_iter().take(local.outputs())) })
}

/// The weights wᵢ of `points` by their first `dims` coordinates; `None` where `q` is not between them.
pub(super) fn weights(points: &[Place], q: &Place, dims: usize) -> Option<Vec<f64>> {
    let mut tableau = Tableau::new(points, q, dims)?;
    for _ in 0..PIVOTS {
        let Some(entering) = tableau.entering() else { return tableau.weights() };
        let leaving = tableau.leaving(entering)?;
        tableau.pivot(leaving, entering);
    }
    None
}

/// The linear program: an equation for each coordinate and Σ w = 1, each with an artificial unknown that must become 0.
struct Tableau {
    unknowns: usize,
    /// Coefficients of the unknowns; the right side last.
    equations: Vec<Vec<f64>>,
    /// The change of the sum of the artificial unknowns, and of the objective, for each unit of an unknown.
    costs: [Vec<f64>; 2],
    /// The basic unknown of each equation; indices from `unknowns` on are artificial ones.
    basis: Vec<usize>,
}

impl Tableau {
    /// `None` where `q` lies beyond the points in some coordinate.
    fn new(points: &[Place], q: &Place, dims: usize) -> Option<Self> {
        let unknowns = points.len();
        let mut equations = Vec::with_capacity(dims + 1);
        for j in 0..dims {
            let low = points.iter().map(|x| x[j]).fold(f64::INFINITY, f64::min);
            let high = points.iter().map(|x| x[j]).fold(f64::NEG_INFINITY, f64::max);
            if q[j] < low || q[j] > high {
                return None;
            }
            // Shifted so that the right side is positive, which avoids degenerate pivots.
            let moved = |x: f64| x - low + 1.0;
            equations.push(points.iter().map(|x| moved(x[j])).chain([moved(q[j])]).collect());
        }
        equations.push(vec![1.0; unknowns + 1]);
        let infeasible = (0..=unknowns).map(|i| -equations.iter().map(|e: &Vec<f64>| e[i]).sum::<f64>());
        let far = points.iter().map(|x| super::tree::squared(x, q));
        let basis = (unknowns..=unknowns + dims).collect();
        Some(Self { unknowns, costs: [infeasible.collect(), far.chain([0.0]).collect()], equations, basis })
    }

    /// The first unknown whose increase lowers the sum of the artificial ones, or leaves it and lowers the objective.
    fn entering(&self) -> Option<usize> {
        let [infeasible, far] = &self.costs;
        (0..self.unknowns)
            .find(|&i| infeasible[i] < -ROUNDING || infeasible[i] <= ROUNDING && far[i] < -ROUNDING)
    }

    /// The equation that limits the increase of unknown `entering`; of several the one whose basic unknown comes first.
    fn leaving(&self, entering: usize) -> Option<usize> {
        let share = |row: usize| self.equations[row][self.unknowns] / self.equations[row][entering];
        (0..self.equations.len())
            .filter(|row| self.equations[*row][entering] > ROUNDING)
            .min_by(|a, b| share(*a).total_cmp(&share(*b)).then(self.basis[*a].cmp(&self.basis[*b])))
    }

    /// Solves equation `row` for unknown `entering`.
    fn pivot(&mut self, row: usize, entering: usize) {
        let divisor = self.equations[row][entering];
        self.equations[row].iter_mut().for_each(|x| *x /= divisor);
        let pivot = self.equations[row].clone();
        let others = self.equations.iter_mut().enumerate().filter(|(i, _)| *i != row).map(|(_, other)| other);
        for other in others.chain(&mut self.costs) {
            let factor = other[entering];
            if factor != 0.0 {
                other.iter_mut().zip(&pivot).for_each(|(x, pivot)| *x -= factor * pivot);
            }
        }
        self.basis[row] = entering;
    }

    /// The unknowns; `None` where an artificial one is not 0.
    fn weights(&self) -> Option<Vec<f64>> {
        let mut weights = vec![0.0; self.unknowns];
        for (equation, unknown) in self.equations.iter().zip(&self.basis) {
            let value = equation[self.unknowns];
            match weights.get_mut(*unknown) {
                Some(weight) => *weight = value.max(0.0),
                None if value > 1e-7 => return None,
                None => {}
            }
        }
        Some(weights)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::local::AS_IT_IS;
    use super::*;

    /// Points that fill a box of `dims` dimensions evenly (R sequence).
    fn points(n: usize, dims: usize) -> Vec<Place> {
        let ratios = [0.856_674_883, 0.733_891_855, 0.628_707_027, 0.538_597_254, 0.461_401_615];
        (0..n)
            .map(|i| {
                let mut place = [0.0; MOST];
                for (x, ratio) in place.iter_mut().zip(ratios).take(dims) {
                    *x = (0.5 + ratio * i as f64).fract();
                }
                place
            })
            .collect()
    }

    fn local(gives: impl Fn(&Place) -> f64) -> Local {
        let places = points(300, 3);
        let rows = places.iter().map(|x| Sample {
            at: SmallVector::new(x[..3].iter().copied()),
            gives: SmallVector::new([gives(x), 1.0]),
        });
        Local::with_neighbours(rows.collect(), AS_IT_IS, 12)
    }

    #[test]
    fn a_plane_is_interpolated_exactly() {
        let plane = |x: &Place| 3.0 + 2.0 * x[0] - x[1] + 5.0 * x[2];
        for q in [[0.5, 0.5, 0.5, 0.0, 0.0], [0.2, 0.7, 0.4, 0.0, 0.0], [0.8, 0.25, 0.6, 0.0, 0.0]] {
            let found = linear(&local(plane), &SmallVector::new(q.into_iter().take(3))).unwrap();
            assert!((found.gives[0] - plane(&q)).abs() < 1e-9, "{found:?}");
            assert!((found.gives[1] - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn beyond_the_rows_the_nearest_row_is_the_answer() {
        let local = local(|x| x[0] * x[1]);
        for q in [[2.0, 0.5, 0.5], [-0.1, -0.1, -0.1], [0.001, 0.999, 1.2]] {
            let q = SmallVector::new(q);
            assert_eq!(linear(&local, &q).unwrap().gives, nearest(&local, &q).unwrap().gives);
        }
    }

    #[test]
    fn a_question_at_a_row_gets_that_row() {
        let local = local(|x| libm::sin(9.0 * x[0]) + x[1]);
        let row = local.rows()[77];
        assert!((linear(&local, &row.at).unwrap().gives[0] - row.gives[0]).abs() < 1e-9);
    }

    #[test]
    fn angles_are_interpolated_on_a_cylinder() {
        let around =
            |i: usize, angle: f64| SmallVector::new([0.1 * i as f64, libm::cos(angle), libm::sin(angle)]);
        let rows = (0..200).map(|i| Sample {
            at: around(i % 10, 0.0314 * i as f64),
            gives: SmallVector::new([i as f64 % 10.0 + libm::sin(0.0314 * i as f64)]),
        });
        let local = Local::with_neighbours(rows.collect(), AS_IT_IS, 12);
        let q = SmallVector::new([0.45, libm::cos(1.0), libm::sin(1.0)]);
        let found = linear_on_a_cylinder(&local, &q).unwrap();
        assert!((found.gives[0] - 4.5 - libm::sin(1.0)).abs() < 0.02, "{found:?}");
        assert_eq!(linear(&local, &q).unwrap().gives, nearest(&local, &q).unwrap().gives);
    }

    #[test]
    fn the_triangle_of_a_square_that_contains_the_question_is_used() {
        let corner = |x: f64, y: f64| [x, y, 0.0, 0.0, 0.0];
        // A kite whose short diagonal is the Delaunay edge.
        let kite = [corner(0.0, 0.0), corner(2.0, 1.0), corner(4.0, 0.0), corner(2.0, -1.0)];
        let found = weights(&kite, &corner(1.0, 0.0), 2).unwrap();
        for (found, expected) in found.iter().zip([0.5, 0.25, 0.0, 0.25]) {
            assert!((found - expected).abs() < 1e-12, "{found} is not {expected}");
        }
    }

    /// Whether the ball through the corners of a simplex holds no other point: the Delaunay property.
    fn ball_is_empty(points: &[Place], corners: &[usize], dims: usize) -> bool {
        // Centre c: 2 (xᵢ − x₀)·c = |xᵢ|² − |x₀|².
        let n = corners.len() - 1;
        let first = points[corners[0]];
        let norm = |x: &Place| x.iter().map(|x| x * x).sum::<f64>();
        let a = nalgebra::DMatrix::from_fn(n, dims, |i, j| 2.0 * (points[corners[i + 1]][j] - first[j]));
        let b = nalgebra::DVector::from_fn(n, |i, _| norm(&points[corners[i + 1]]) - norm(&first));
        let Some(centre) = a.lu().solve(&b) else { return true };
        let far = |x: &Place| (0..dims).map(|j| (x[j] - centre[j]) * (x[j] - centre[j])).sum::<f64>();
        points.iter().all(|x| far(x) >= far(&first) - 1e-6)
    }

    proptest! {
        #[test]
        fn the_weighted_mean_of_delaunay_neighbours_is_the_question(
            dims in 2..=MOST,
            numbers in proptest::collection::vec(0.0..1.0_f64, 40 * MOST),
            q in proptest::collection::vec(0.25..0.75_f64, MOST),
        ) {
            let place = |numbers: &[f64]| {
                let mut place = [0.0; MOST];
                place[..dims].copy_from_slice(&numbers[..dims]);
                place
            };
            let points: Vec<Place> = numbers.chunks_exact(MOST).map(place).collect();
            let q = place(&q);
            let Some(weights) = weights(&points, &q, dims) else { return Ok(()) };
            prop_assert!(weights.iter().all(|w| *w >= 0.0));
            prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9);
            for j in 0..dims {
                let mean: f64 = weights.iter().zip(&points).map(|(w, x)| w * x[j]).sum();
                prop_assert!((mean - q[j]).abs() < 1e-8, "{} is not {}", mean, q[j]);
            }
            let corners: Vec<usize> = (0..points.len()).filter(|i| weights[*i] > 1e-9).collect();
            prop_assert!(corners.len() <= dims + 1);
            if corners.len() == dims + 1 {
                prop_assert!(ball_is_empty(&points, &corners, dims));
            }
        }
    }
}
