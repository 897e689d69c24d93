//! Geodesics (shortest ways) in a metric that varies.

use crate::grid::Domain;
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::{ParameterField, Parameters};

/// Derivatives of the metric are differences over this share of the reach of a point.
const DIFFERENCE: f64 = 0.3;

/// The Christoffel symbols Γᵏ of a metric at a point: Γᵏ_xx, Γᵏ_xy, Γᵏ_yy of k = x, y; 1 ÷ cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Christoffel([[f64; 3]; 2]);

impl Christoffel {
    /// The symbols of the metric g with these derivatives (each xx, xy, yy): Γᵏ_ij = ½ gᵏˡ (∂_i g_jl + ∂_j g_il − ∂_l g_ij).
    fn new([xx, xy, yy]: [f64; 3], along_x: [f64; 3], along_y: [f64; 3]) -> Self {
        let lowered = [
            [0.5 * along_x[0], 0.5 * along_y[0], along_y[1] - 0.5 * along_x[2]],
            [along_x[1] - 0.5 * along_y[0], 0.5 * along_x[2], 0.5 * along_y[2]],
        ];
        let determinant = xx * yy - xy * xy;
        let raised = |row: [f64; 2]| {
            [0, 1, 2].map(|part| (row[0] * lowered[0][part] + row[1] * lowered[1][part]) / determinant)
        };
        Self([raised([yy, -xy]), raised([-xy, xx])])
    }

    /// The symbols at a point of a parameter field whose system has this pitch.
    pub fn at<D: Domain>(
        field: &ParameterField<D>,
        pitch: &(dyn Fn(&Parameters) -> f64 + Sync),
        place: D::Place,
        point: &Nucleus<D::Place>,
    ) -> Self {
        let step = DIFFERENCE * point.reach;
        let metric = |way: [f64; 2]| Nucleus::at(field, field.domain.moved(place, way), pitch).metric;
        let slope = |ahead: [f64; 2]| {
            let [after, before] = [metric(ahead), metric(ahead.map(|part| -part))];
            [0, 1, 2].map(|part| (after[part] - before[part]) / (2.0 * step))
        };
        Self::new(point.metric, slope([step, 0.0]), slope([0.0, step]))
    }

    /// The initial direction of the geodesic to the point at `chord` from here: chord + ½ Γ(chord, chord).
    #[must_use]
    pub fn sets_out(&self, chord: [f64; 2]) -> [f64; 2] {
        let [x, y] = chord;
        [0, 1].map(|k| {
            let [xx, xy, yy] = self.0[k];
            chord[k] + 0.5 * (xx * x * x + 2.0 * xy * x * y + yy * y * y)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_a_sphere_the_shortest_way_leaves_a_parallel_towards_the_pole() {
        // Longitude x and latitude y: ds² = cos² y dx² + dy².
        let latitude = 0.6_f64;
        let (sin, cos) = libm::sincos(latitude);
        let symbols = Christoffel::new([cos * cos, 0.0, 1.0], [0.0; 3], [-2.0 * sin * cos, 0.0, 0.0]);
        let [x, y] = symbols.sets_out([0.2, 0.0]);
        // The great circle between two points .2 apart on the parallel: its bearing there.
        let exact = libm::atan(libm::tan(0.1) * sin);
        assert!((libm::atan2(y, x * cos) - exact).abs() < 1e-3, "{x} {y} {exact}");
    }

    #[test]
    fn in_polar_coordinates_the_shortest_way_is_straight() {
        // Angle x and radius y: ds² = y² dx² + dy².
        let radius = 3.0_f64;
        let symbols = Christoffel::new([radius * radius, 0.0, 1.0], [0.0; 3], [2.0 * radius, 0.0, 0.0]);
        let [x, y] = symbols.sets_out([0.1, 0.0]);
        let [ahead, out] = [radius * libm::sin(0.1), radius * libm::cos(0.1) - radius];
        assert!((radius * x - ahead).abs() < 1e-3 && (y - out).abs() < 1e-3, "{x} {y}");
    }
}
