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
//! κ² was tuned on patches of 86 spots of 12 (Turing: 21) cells against the same of 48, stretch 1, 0.6, 0.35.

use super::System;
use super::maps::Parameters;
use super::selling::{OFFSETS, Tensor};
use crate::grid::atan2;

impl System {
    /// The parameters on coarse cells, each of which covers `area` (f²) cells of the planned grid; `p` are already in units of
    /// the coarse cells.
    #[must_use]
    pub fn compensated(self, p: &Parameters, area: f64) -> Parameters {
        let share = self.definition().compensation / (12.0 * self.cells(p)) * (1.0 - 1.0 / area);
        if share <= 0.0 {
            return *p;
        }
        let stretch = f64::from(p.stretch);
        let d = Tensor::oriented(1.0 / stretch, stretch, f64::from(p.direction));
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

#[cfg(test)]
mod tests {
    use super::*;

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
    fn a_quarter_turn_of_the_tensor_turns_the_result() {
        for direction in [0.0, 17.0, 45.0, 80.0] {
            let [a, b] = [direction, direction + 90.0]
                .map(|angle| System::MEINHARDT_SPOTS.compensated(&spots(13.6, 0.4, angle), 4.0));
            assert!((a.rate - b.rate).abs() < 1e-4 && (a.stretch - b.stretch).abs() < 1e-5, "{a:?} {b:?}");
            let turn = (b.direction - a.direction).rem_euclid(180.0);
            assert!((turn - 90.0).abs() < 0.01, "{a:?} {b:?}");
        }
    }
}
