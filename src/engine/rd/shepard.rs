//! Shepard interpolation: values of single spots, interpolated to every cell of a domain.
//!
//! v(x) = Σₖ wₖ vₖ ÷ (w₀ + Σₖ wₖ), wₖ = exp(−dₖ(x)² ÷ 2τ²), dₖ the distance from spot k in its own metric, in pitches of
//! the room that it needs itself. Far from all spots v is 0.
//!
//! The weights are Gaussians: each spot has its own value around it, and halfway to the next spot the value changes smoothly; the
//! smaller τ, the sharper the change.

use std::ops::Range;

use rayon::prelude::*;

use crate::grid::{Domain, exp};
use crate::rd::System;
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::Parameters;

/// τ of a spot among others of its size. A spot reaches to 0.2–0.28 pitches, where its own weight is still 100 times that of the
/// next spot. Of the values 0.15, 0.2, 0.25 and 0.3 the first two gave each spot its area, aspect and direction to 2 %; the
/// smoother one is used.
pub(super) const TAU: f64 = 0.2;
/// Contributions with exponents below this are omitted: less than a hundredth of w₀.
const LEAST: f64 = -22.0;
/// w₀: at a distance of 5.9 τ a spot and the ground have equal weights. This is farther than the middle of the holes between spots,
/// where the largest exponent is at least −8. A narrow spot splits in two if the ground within its reach lies across it: with w₀ at
/// 4 τ this happened in three of 60 sketches of sparse narrow spots in many directions.
const GROUND: f64 = 3e-8;
/// The edge of a spot at the highest density, pitches.
const EDGE: f64 = 0.3;
/// A spot and the ground have equal weights at this distance beyond the edge of the spot, in pitches of the ground.
const BEYOND: f64 = 0.5;

/// Writes the parameters of the cells from a given number on, by the interpolated values of each cell.
pub type Vary<'a, const N: usize> = &'a (dyn Fn(usize, &[[f64; N]], &mut [Parameters]) + Sync);

/// Interpolates values to all cells of a domain; `vary` writes the `parameters` from them, in the parts of the domain that the
/// values change.
///
/// `known` are the values at each spot, given in the frame of its place; `turned` gives values in a frame turned by some degrees, see
/// [`Domain::transport_angle`].
pub fn interpolate_parameters<D: Domain, const N: usize>(
    domain: &D,
    spots: &[Kernel<D::Place>],
    known: &[[f64; N]],
    turned: fn(&[f64; N], f64) -> [f64; N],
    vary: Vary<N>,
    changes: &(dyn Fn(&Range<usize>) -> bool + Sync),
    parameters: &mut [Parameters],
) {
    let part = domain.part();
    parameters.par_chunks_mut(part).enumerate().for_each(|(index, made)| {
        let first = index * part;
        let cells = first..first + made.len();
        if !changes(&cells) {
            return;
        }
        vary(first, &in_cells(domain, spots, known, turned, cells), made);
    });
}

/// The interpolated values of all cells of a domain; `known` and `turned` as in [`interpolate_parameters`].
#[must_use]
pub fn interpolate<D: Domain, const N: usize>(
    domain: &D,
    spots: &[Kernel<D::Place>],
    known: &[[f64; N]],
    turned: fn(&[f64; N], f64) -> [f64; N],
) -> Vec<[f64; N]> {
    let (part, count) = (domain.part(), domain.cells());
    let of_part = |first: usize| in_cells(domain, spots, known, turned, first..(first + part).min(count));
    let firsts: Vec<usize> = (0..count).step_by(part).collect();
    firsts.into_par_iter().map(of_part).collect::<Vec<_>>().concat()
}

/// The interpolated values of some cells that follow each other.
fn in_cells<D: Domain, const N: usize>(
    domain: &D,
    spots: &[Kernel<D::Place>],
    known: &[[f64; N]],
    turned: fn(&[f64; N], f64) -> [f64; N],
    cells: Range<usize>,
) -> Vec<[f64; N]> {
    let mut sums = vec![(0.0, [0.0; N]); cells.len()];
    for (spot, known) in spots.iter().zip(known).filter(|(spot, _)| spot.may_reach(domain, &cells)) {
        add(&mut sums, cells.clone(), domain, spot, known, turned);
    }
    let mean = |(sum, all): (f64, [f64; N])| {
        let share = 1.0 / (GROUND + sum);
        all.map(|all| share * all)
    };
    sums.into_iter().map(mean).collect()
}

/// The weights of a spot.
#[derive(Clone, Copy, Debug)]
pub struct Kernel<P = [f64; 2]> {
    spot: Nucleus<P>,
    tau: f64,
}

impl<P: Copy> Kernel<P> {
    /// The kernel of a spot at a place, cells, with its `own` parameters; the `ground` has other ones. Both are in the frame of
    /// that place.
    #[must_use]
    pub fn new<D: Domain<Place = P>>(
        system: System,
        domain: &D,
        at: P,
        own: &Parameters,
        ground: &Parameters,
    ) -> Self {
        let spot = Nucleus::new(own, domain, domain.cell_at(at), at, system.spacing(own)).alone();
        Self { spot, tau: tau(system, own, ground) }
    }

    /// Whether some of these cells may depend on the spot.
    #[must_use]
    pub fn may_reach<D: Domain<Place = P>>(&self, domain: &D, cells: &Range<usize>) -> bool {
        domain.may_reach(self.spot.at, self.far(), cells)
    }

    /// Distance, cells, beyond which the weights are omitted.
    fn far(&self) -> f64 {
        self.tau * (-2.0 * LEAST).sqrt() * self.spot.reach
    }
}

/// τ of a spot with its `own` parameters among others with the parameters of the `ground`. A spot much larger than its neighbours
/// has its own value up to its edge, but not at the places of its neighbours, which would vanish by its slow reactions.
fn tau(system: System, own: &Parameters, ground: &Parameters) -> f64 {
    let [pitch, around] = [own, ground].map(|p| system.spacing(p) / p.apart());
    TAU * ((EDGE * pitch + BEYOND * around) / ((EDGE + BEYOND) * pitch)).min(1.0)
}

/// Adds the contribution of a spot to the cells of a range: wₖ and wₖ vₖ.
fn add<D: Domain, const N: usize>(
    sums: &mut [(f64, [f64; N])],
    cells: Range<usize>,
    domain: &D,
    kernel: &Kernel<D::Place>,
    known: &[f64; N],
    turned: fn(&[f64; N], f64) -> [f64; N],
) {
    let Kernel { spot, tau } = kernel;
    let first = cells.start;
    let sharpness = -0.5 / (tau * tau);
    domain.runs_near(spot.at, kernel.far(), cells).for_each(|(run, displacement)| {
        let turn = domain.transport_angle(spot.cell, run.start);
        let known = if turn == 0.0 { *known } else { turned(known, turn) };
        let (inner, weights) = along(spot.metric.map(|part| sharpness * part), displacement, run.len());
        let cells = run.start - first + inner.start..run.start - first + inner.end;
        for ((sum, all), weight) in sums[cells].iter_mut().zip(weights) {
            *sum += weight;
            all.iter_mut().zip(&known).for_each(|(all, known)| *all += weight * known);
        }
    });
}

/// The weights e^q along a run of `length` places that begins at `displacement` and continues along the first axis, q = Δᵀ M Δ with
/// the negative `form` M. Returns the part of the run on which q is above [`LEAST`], and its weights.
///
/// The ratio of neighbouring weights is a geometric series, as q is quadratic: two products a place instead of an exponential
/// function. The relative error grows with the square of the places: 10⁻⁸ at the hundredth.
fn along(
    [xx, xy, yy]: [f64; 3],
    [x, y]: [f64; 2],
    length: usize,
) -> (Range<usize>, impl Iterator<Item = f64>) {
    // q(x + t) = LEAST at the ends of the part.
    let slope = 2.0 * (xx * x + xy * y);
    let here = xx * x * x + 2.0 * xy * x * y + yy * y * y;
    let square = slope * slope - 4.0 * xx * (here - LEAST);
    let root = square.max(0.0).sqrt();
    let [from, to] = [-slope + root, -slope - root].map(|end| end / (2.0 * xx));
    let end = length as f64;
    let inner =
        if square > 0.0 { from.ceil().clamp(0.0, end)..(to.floor() + 1.0).clamp(0.0, end) } else { 0.0..0.0 };
    let t = inner.start;
    let mut weight = exp(here + t * slope + t * t * xx);
    let mut ratio = exp(slope + (2.0 * t + 1.0) * xx);
    let quotient = exp(2.0 * xx);
    let weights = std::iter::repeat_with(move || {
        let now = weight;
        weight *= ratio;
        ratio *= quotient;
        now
    });
    (inner.start as usize..(inner.end as usize).max(inner.start as usize), weights)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::rd::parameter_field::ParameterField;

    const P: Parameters = Parameters { rate: 1.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };

    /// Values of spots at two places, interpolated on 72 × 40 cells as the rate.
    fn known(edges: Edges, places: [[f64; 2]; 2], known: [f64; 2]) -> ParameterField {
        let maps = ParameterField::uniform([72, 40], edges, P);
        let vary = |_: usize, rates: &[[f64; 1]], made: &mut [Parameters]| {
            made.iter_mut()
                .zip(rates)
                .for_each(|(made, [rate])| *made = Parameters { rate: *rate as f32, ..P });
        };
        let system = System::MEINHARDT_SPOTS;
        let spots = places.map(|at| Kernel::new(system, &maps.domain, at, &P, &P));
        let known = known.map(|one| [one]);
        let mut parameters = maps.parameters.clone();
        interpolate_parameters(
            &maps.domain,
            &spots,
            &known,
            |rate, _| *rate,
            &vary,
            &|_| true,
            &mut parameters,
        );
        ParameterField { parameters, ..maps }
    }

    #[test]
    fn weights_along_a_run_are_those_of_each_place() {
        let form = [-0.031, 0.012, -0.045];
        for y in [-12.5, -3.0, 0.25, 9.0, 40.0] {
            let q = |k: usize| {
                let x = -30.3 + k as f64;
                form[0] * x * x + 2.0 * form[1] * x * y + form[2] * y * y
            };
            let (inner, weights) = along(form, [-30.3, y], 70);
            let expected: Vec<usize> = (0..70).filter(|k| q(*k) > LEAST).collect();
            assert_eq!(inner.clone().collect::<Vec<_>>(), expected, "{y}");
            for (k, weight) in inner.zip(weights) {
                assert!((weight / libm::exp(q(k)) - 1.0).abs() < 1e-8, "{y} {k}");
            }
        }
    }

    #[test]
    fn a_spot_has_its_own_value_and_half_way_to_the_next_is_the_mean() {
        let maps = known(Edges::Closed, [[18.0, 20.0], [54.0, 20.0]], [2.0, 4.0]);
        let at = |x: f64| maps.at([x, 20.0]).rate;
        // A spot of this ratio reaches to a fifth of a pitch of 36 cells.
        assert!((at(18.0) - 2.0).abs() < 1e-3 && (at(26.0) - 2.0).abs() < 0.02, "{} {}", at(18.0), at(26.0));
        assert!((at(35.9) + at(36.1) - 6.0).abs() < 0.06);
        assert!((20..53).all(|x| at(f64::from(x) + 1.0) >= at(f64::from(x))));
    }

    #[test]
    fn values_cross_the_border_of_a_tile_but_not_closed_edges() {
        let [wrap, closed] =
            [Edges::Wrap, Edges::Closed].map(|edges| known(edges, [[2.0, 20.0], [40.0, 20.0]], [2.0, 0.0]));
        assert!((wrap.at([70.5, 20.0]).rate - 2.0).abs() < 2e-3, "{:?}", wrap.at([70.5, 20.0]));
        assert!(closed.at([70.5, 20.0]).rate.abs() < 1e-3, "{:?}", closed.at([70.5, 20.0]));
    }
}
