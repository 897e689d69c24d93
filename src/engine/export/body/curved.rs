//! Values between vertices: cubic triangles with the slopes at the vertices (as the normals of Vlachos et al. 2001). Level lines
//! are therefore smooth curves although the triangles are flat.

use super::vector::{Vector, cross, dot, minus, plus};
use crate::surface::Mesh;

/// The slope of a field at each vertex: the mean of the slopes on the triangles around it, weighted by their areas.
pub fn slopes(mesh: &Mesh, values: &[f32]) -> Vec<Vector> {
    let mut sums = vec![([0.0; 3], 0.0); mesh.positions.len()];
    for face in &mesh.faces {
        let [a, b, c] = face.map(|vertex| mesh.positions[vertex as usize]);
        let normal = cross(minus(b, a), minus(c, a));
        let twice_area = dot(normal, normal).sqrt();
        if !(twice_area > 0.0 && twice_area.is_finite()) {
            continue;
        }
        // Twice the area times the slope: the sum of the values times the opposite sides, rotated by a right angle.
        let sides = [minus(c, b), minus(a, c), minus(b, a)];
        let slope = (0..3).fold([0.0; 3], |sum, at| {
            plus(sum, f64::from(values[face[at] as usize]) / twice_area, cross(normal, sides[at]))
        });
        for vertex in face {
            let (sum, area) = &mut sums[*vertex as usize];
            *sum = plus(*sum, 1.0, slope);
            *area += twice_area;
        }
    }
    sums.into_iter().map(|(sum, area)| if area > 0.0 { sum.map(|value| value / area) } else { sum }).collect()
}

/// The ten control values of a cubic Bézier triangle: the corners, the six on the sides, the middle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cubic([f32; 10]);

impl Cubic {
    pub fn new(places: [Vector; 3], values: [f32; 3], slopes: [Vector; 3]) -> Self {
        let side = |from: usize, to: usize| {
            values[from] + (dot(slopes[from], minus(places[to], places[from])) / 3.0) as f32
        };
        let sides = [side(0, 1), side(0, 2), side(1, 0), side(1, 2), side(2, 0), side(2, 1)];
        let mean = sides.iter().sum::<f32>() / 6.0;
        let corners = (values[0] + values[1] + values[2]) / 3.0;
        let [a, b, c] = values;
        let [d, e, f, g, h, i] = sides;
        Self([a, b, c, d, e, f, g, h, i, mean + 0.5 * (mean - corners)])
    }

    pub fn at(&self, [u, v, w]: [f32; 3]) -> f32 {
        let [a, b, c, d, e, f, g, h, i, middle] = self.0;
        let first = u * u * (u * a + 3.0 * (v * d + w * e));
        let second = v * v * (v * b + 3.0 * (u * f + w * g));
        let third = w * w * (w * c + 3.0 * (u * h + v * i));
        first + second + third + 6.0 * u * v * w * middle
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice of triangles in the plane, 12 × 12.
    fn plane() -> Mesh {
        let side = 12_u32;
        let positions =
            (0..side * side).map(|at| [f64::from(at % side), f64::from(at / side), 0.0]).collect();
        let squares = (0..side * (side - 1)).filter(|at| at % side < side - 1);
        let faces =
            squares.flat_map(|at| [[at, at + 1, at + side + 1], [at, at + side + 1, at + side]]).collect();
        Mesh { positions, faces }
    }

    #[test]
    fn a_linear_field_stays_linear() {
        let mesh = plane();
        let values: Vec<f32> = mesh.positions.iter().map(|[x, y, _]| (2.0 * x - y + 1.0) as f32).collect();
        let slopes = slopes(&mesh, &values);
        assert!(
            slopes.iter().all(|[x, y, z]| (x - 2.0).abs() < 1e-5 && (y + 1.0).abs() < 1e-5 && z.abs() < 1e-9)
        );
        let face = mesh.faces[50].map(|vertex| vertex as usize);
        let cubic = Cubic::new(
            face.map(|vertex| mesh.positions[vertex]),
            face.map(|vertex| values[vertex]),
            face.map(|vertex| slopes[vertex]),
        );
        let mean = face.iter().map(|vertex| values[*vertex]).sum::<f32>() / 3.0;
        assert!((cubic.at([1.0 / 3.0; 3]) - mean).abs() < 1e-4);
    }

    #[test]
    fn a_round_hill_is_followed_four_times_as_closely_as_by_flat_triangles() {
        let mesh = plane();
        let hill = |[x, y, _]: Vector| libm::exp(-((x - 5.4) * (x - 5.4) + (y - 5.7) * (y - 5.7)) / 12.0);
        let values: Vec<f32> = mesh.positions.iter().map(|place| hill(*place) as f32).collect();
        let slopes = slopes(&mesh, &values);
        let inner = |vertex: usize| mesh.positions[vertex][..2].iter().all(|at| (2.0..=9.0).contains(at));
        let mut errors = [0.0_f64; 2];
        for face in mesh
            .faces
            .iter()
            .map(|face| face.map(|vertex| vertex as usize))
            .filter(|face| face.iter().all(|vertex| inner(*vertex)))
        {
            let places = face.map(|vertex| mesh.positions[vertex]);
            let corners = face.map(|vertex| values[vertex]);
            let middle = [0, 1, 2].map(|axis| places.iter().map(|place| place[axis]).sum::<f64>() / 3.0);
            let cubic = Cubic::new(places, corners, face.map(|vertex| slopes[vertex])).at([1.0 / 3.0; 3]);
            let flat = corners.iter().sum::<f32>() / 3.0;
            for (error, found) in errors.iter_mut().zip([flat, cubic]) {
                *error += (f64::from(found) - hill(middle)).abs();
            }
        }
        assert!(errors[1] < errors[0] / 4.0, "{errors:?}");
    }
}
