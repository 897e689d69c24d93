//! Compensation of the error of a coarse grid.
//!
//! The stencil Σₖ wₖ(u(x + eₖ) + u(x − eₖ) − 2u(x)) damps a wave of wave vector q less than the tensor D does:
//! by the factor 1 − (q·eₖ)²/12 along each offset. A spot of N cells is made of waves with qᵀDq ≈ κ²/N (det D = 1),
//! for which (q·e)² averages to κ²/N · eᵀD⁻¹e. Grown with
//!
//! D′ = D + κ²/(12 N) · (1 − 1/f²) · Σₖ wₖ (eₖᵀD⁻¹eₖ) eₖeₖᵀ
//!
//! on cells f times as long, spots have the size, shape and direction that they have on the fine grid.
//!
//! κ² was tuned on patches of 86 spots of 12 (Turing: 21) cells against patches with 48 cells a spot, stretch 1, 0.6, 0.35.

use multiversion::multiversion;

use super::System;
use super::parameter_field::Parameters;
use super::plane::{LANES, Lanes};
use super::selling::{OFFSETS, PrincipalAxes};
use super::stencil_lanes::StencilLanes;
use crate::grid::atan2;

impl System {
    /// Replaces the `parameters` of cells by those of [`Self::compensated`], up to rounding, except in the cells `left_out`.
    pub fn compensate(self, parameters: &mut [Parameters], area: f64, left_out: &[bool]) {
        if self.definition().compensation == 0.0 || area <= 1.0 {
            return;
        }
        let mut lanes = StencilLanes::new([1.0; 2]);
        let mut weights = [Lanes([0.0; LANES]); OFFSETS.len()];
        for (group, left_out) in parameters.chunks_mut(LANES).zip(left_out.chunks(LANES)) {
            // Lanes beyond the end repeat the last cell.
            let p: [Parameters; LANES] = std::array::from_fn(|lane| group[lane.min(group.len() - 1)]);
            let axes = p.map(|p| axes(&p));
            let used = lanes.write(&axes, &mut weights);
            let more = side_by_side(&axes, &p.map(|p| self.share(&p, area)), used, &weights);
            for (lane, (p, left_out)) in group.iter_mut().zip(left_out).enumerate() {
                if !left_out {
                    *p = more.of(lane, p);
                }
            }
        }
    }

    /// κ²/(12 N) · (1 − 1/f²).
    fn share(self, p: &Parameters, area: f64) -> f64 {
        self.definition().compensation / (12.0 * self.cells(p)) * (1.0 - 1.0 / area)
    }

    /// The parameters on coarse cells, each of which covers `area` (f²) cells of the planned grid; `p` are already in units of
    /// the coarse cells.
    #[must_use]
    pub fn compensated(self, p: &Parameters, area: f64) -> Parameters {
        let share = self.share(p, area);
        if share <= 0.0 {
            return *p;
        }
        let d = axes(p).tensor();
        let mut more = d;
        for (k, weight) in d.stencil() {
            let [x, y] = OFFSETS[k].map(|along| along as f64);
            let inverse = d.yy * x * x - 2.0 * d.xy * x * y + d.xx * y * y;
            let weight = share * f64::from(weight) * inverse;
            more.xx += weight * x * x;
            more.xy += weight * x * y;
            more.yy += weight * y * y;
        }
        // D′ = g·(a tensor of determinant 1): more diffusion is less rate.
        let g = (more.xx * more.yy - more.xy * more.xy).sqrt();
        let half = 0.5 * (more.xx - more.yy);
        let along = (0.5 * (more.xx + more.yy) + (half * half + more.xy * more.xy).sqrt()) / g;
        Parameters {
            rate: (f64::from(p.rate) / g) as f32,
            stretch: (1.0 / along) as f32,
            direction: (0.5 * atan2(more.xy, half)).to_degrees() as f32,
            ..*p
        }
    }
}

/// The axes of the tensor D, even if the stretch is below the limit of stencils.
fn axes(p: &Parameters) -> PrincipalAxes {
    let stretch = f64::from(p.stretch);
    PrincipalAxes { along: 1.0 / stretch, across: stretch, degrees: f64::from(p.direction) }
}

/// The tensor D′ of some cells.
struct Compensated {
    /// √det D′.
    g: [f64; LANES],
    /// The larger eigenvalue ÷ g.
    along: [f64; LANES],
    /// Its direction, radians.
    direction: [f64; LANES],
}

impl Compensated {
    fn of(&self, lane: usize, p: &Parameters) -> Parameters {
        Parameters {
            rate: (f64::from(p.rate) / self.g[lane]) as f32,
            stretch: (1.0 / self.along[lane]) as f32,
            direction: self.direction[lane].to_degrees() as f32,
            ..*p
        }
    }
}

/// D′ for tensors with these stencil weights; only the `used` weights count.
#[multiversion(targets("x86_64+avx2"))]
fn side_by_side(
    axes: &[PrincipalAxes; LANES],
    shares: &[f64; LANES],
    used: u32,
    weights: &[Lanes; OFFSETS.len()],
) -> Compensated {
    let [mut xx, mut xy, mut yy] = [[0.0; LANES]; 3];
    for (lane, axes) in axes.iter().enumerate() {
        let d = axes.tensor();
        (xx[lane], xy[lane], yy[lane]) = (d.xx, d.xy, d.yy);
    }
    let mut more = [xx, xy, yy];
    for (k, offset) in OFFSETS.iter().enumerate().filter(|(k, _)| used & (1 << k) != 0) {
        let [x, y] = offset.map(|along| along as f64);
        for lane in 0..LANES {
            let inverse = yy[lane] * x * x - 2.0 * xy[lane] * x * y + xx[lane] * y * y;
            let weight = shares[lane] * f64::from(weights[k].0[lane]) * inverse;
            more[0][lane] += weight * x * x;
            more[1][lane] += weight * x * y;
            more[2][lane] += weight * y * y;
        }
    }
    let [xx, xy, yy] = more;
    let mut found = Compensated { g: [0.0; LANES], along: [0.0; LANES], direction: [0.0; LANES] };
    for lane in 0..LANES {
        let g = (xx[lane] * yy[lane] - xy[lane] * xy[lane]).sqrt();
        let half = 0.5 * (xx[lane] - yy[lane]);
        found.g[lane] = g;
        found.along[lane] = (0.5 * (xx[lane] + yy[lane]) + (half * half + xy[lane] * xy[lane]).sqrt()) / g;
        found.direction[lane] = 0.5 * atan2(xy[lane], half);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_side_by_side_are_compensated_as_one_by_one() {
        // Some neighbours are equal, others have directions of all kinds.
        for step in [0.3, 17.0] {
            let p = |k: usize| spots(3.0 + 0.02 * k as f32, 0.3 + 0.001 * k as f32, step * k as f32);
            let mut cells: Vec<Parameters> = (0..389).map(p).collect();
            let single: Vec<Parameters> =
                cells.iter().map(|p| System::MEINHARDT_SPOTS.compensated(p, 4.0)).collect();
            let left_out: Vec<bool> = (0..389).map(|k| k % 5 == 3).collect();
            System::MEINHARDT_SPOTS.compensate(&mut cells, 4.0, &left_out);
            for (k, (cell, single)) in cells.iter().zip(&single).enumerate() {
                let wanted = if left_out[k] { p(k) } else { *single };
                let near = |a: f32, b: f32| (a - b).abs() < 2e-6 * b.abs().max(1.0);
                let turn = (cell.direction - wanted.direction + 90.0).rem_euclid(180.0) - 90.0;
                assert!(
                    near(cell.rate, wanted.rate) && near(cell.stretch, wanted.stretch),
                    "{cell:?} {wanted:?}"
                );
                assert!(turn.abs() < 2e-4 && cell.ratio == wanted.ratio, "{k}: {cell:?} {wanted:?}");
            }
        }
    }

    fn spots(rate: f32, stretch: f32, direction: f32) -> Parameters {
        Parameters { rate, ratio: 12.0, stretch, direction, pitch: 1.0 }
    }

    #[test]
    fn nothing_is_compensated_on_the_planned_grid_or_for_spots_of_many_cells() {
        let p = spots(3.4, 0.5, 20.0);
        assert_eq!(System::MEINHARDT_SPOTS.compensated(&p, 1.0), p);
        let large = System::MEINHARDT_SPOTS.compensated(&spots(0.034, 0.5, 20.0), 4.0);
        assert!((large.rate / 0.034 - 1.0).abs() < 0.002 && (large.stretch - 0.5).abs() < 0.001, "{large:?}");
    }

    #[test]
    fn round_spots_only_get_a_lower_rate() {
        let p = System::MEINHARDT_SPOTS.compensated(&spots(13.6, 1.0, 0.0), 4.0);
        assert!((p.stretch - 1.0).abs() < 1e-5 && p.rate < 13.3 && p.rate > 12.5, "{p:?}");
    }

    #[test]
    fn rotating_the_tensor_by_90_degrees_rotates_the_result() {
        for direction in [0.0, 17.0, 45.0, 80.0] {
            let [a, b] = [direction, direction + 90.0]
                .map(|angle| System::MEINHARDT_SPOTS.compensated(&spots(13.6, 0.4, angle), 4.0));
            assert!((a.rate - b.rate).abs() < 1e-4 && (a.stretch - b.stretch).abs() < 1e-5, "{a:?} {b:?}");
            let turn = (b.direction - a.direction).rem_euclid(180.0);
            assert!((turn - 90.0).abs() < 0.01, "{a:?} {b:?}");
        }
    }
}
