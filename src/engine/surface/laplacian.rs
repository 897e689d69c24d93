//! The Laplacian of a surface in a metric, by cotangents: Σⱼ wᵢⱼ (uⱼ − uᵢ) ÷ mᵢ ≈ ∇·D∇u, for the tensor D whose inverse is the metric.
//!
//! Pinkall & Polthier (1993); Meyer, Desbrun, Schröder & Barr (2003); on intrinsic Delaunay triangles Bobenko & Springborn (2007).
//! The weights are ≥ 0, like those of the stencils on grids: concentrations stay positive, and explicit steps are stable.

use super::intrinsic_delaunay::{Triangulation, area4, cotangent, edges};
use super::mesh::Mesh;
use super::metric::{Stretch, hold_triangle_inequality, lengths};

/// A symmetric matrix without its diagonal, row by row, and the area of each vertex. Lengths are in units of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Laplacian {
    /// Start of each row, and the end of the last.
    pub starts: Vec<u32>,
    /// By entry, the other vertex; ascending in each row.
    pub columns: Vec<u32>,
    /// Weights by entry, > 0.
    pub weights: Vec<f64>,
    /// Areas by vertex, > 0.
    pub mass: Vec<f64>,
}

/// The Laplacian of a mesh with a stretch in the frame of each vertex.
#[must_use]
pub fn laplacian(mesh: &Mesh, frames: &[[[f64; 3]; 2]], stretch: &[Stretch]) -> Laplacian {
    let (ends, sides) = edges(&mesh.faces);
    let mut lengths = lengths(mesh, frames, stretch, &ends);
    hold_triangle_inequality(&sides, &mut lengths);
    let triangles = Triangulation::new(mesh.faces.clone(), sides, lengths);
    let ratios: Vec<f64> = stretch.iter().map(|stretch| f64::from(stretch.ratio)).collect();
    laplacian_of_lengths(triangles, &ratios)
}

/// The Laplacian of triangles that are given by the lengths of their edges in a metric. `ratios`: the ratio of the [`Stretch`] of
/// each vertex.
#[must_use]
pub fn laplacian_of_lengths(mut triangles: Triangulation, ratios: &[f64]) -> Laplacian {
    triangles.flip_to_delaunay();
    let mut halves = Vec::with_capacity(6 * triangles.corners.len());
    let (mut circumcentric, mut barycentric) = (vec![0.0; ratios.len()], vec![0.0; ratios.len()]);
    for (face, corners) in triangles.corners.iter().enumerate() {
        let sides = triangles.of(face);
        let area = 0.25 * area4(sides);
        for k in 0..3 {
            // The side from corner k to the next, and its share of the cells of both: half of the triangle with the circumcentre.
            let [from, to] = [corners[k], corners[(k + 1) % 3]];
            let half = 0.5 * cotangent(sides[k], [sides[(k + 1) % 3], sides[(k + 2) % 3]]);
            halves.push((from, to, half));
            halves.push((to, from, half));
            let share = 0.25 * sides[k] * sides[k] * half;
            circumcentric[from as usize] += share;
            circumcentric[to as usize] += share;
            barycentric[from as usize] += area / 3.0;
        }
    }
    let mass = circumcentric.iter().zip(&barycentric).map(|(cell, third)| cell.max(LEAST_CELL * third));
    let mass = mass.collect();
    Laplacian::of_entries(halves, mass).with_lifted_mass(ratios)
}

/// The least area of a cell ÷ a third of the triangles around it. At a border the circumcentric cell may have no area.
const LEAST_CELL: f64 = 0.3;

/// The largest diagonal entry × the mean area of the cells around, for isotropic diffusion. A lattice of regular triangles has
/// 3.46, a remeshed surface up to 7.5; the largest value of all vertices determines the time step. With this limit about 7 % of the
/// vertices get a larger area, which saves 37 % of the steps; areas of spots change by −0.3 %.
const LARGEST_DIAGONAL: f64 = 4.8;

impl Laplacian {
    /// Sums up entries at equal places. Entries on the diagonal and weights ≤ 0 are left out.
    fn of_entries(mut entries: Vec<(u32, u32, f64)>, mass: Vec<f64>) -> Self {
        // Stable: equal entries are summed up in the order of the triangles, in both directions.
        entries.sort_by_key(|(row, column, _)| (*row, *column));
        let (mut starts, mut columns, mut weights) = (vec![0; mass.len() + 1], Vec::new(), Vec::new());
        for same in entries.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let (row, column, _) = same[0];
            let weight: f64 = same.iter().map(|(.., half)| half).sum();
            if row != column && weight > 0.0 {
                columns.push(column);
                weights.push(weight);
                starts[row as usize + 1] += 1;
            }
        }
        for row in 1..starts.len() {
            starts[row] += starts[row - 1];
        }
        Self { starts, columns, weights, mass }
    }

    /// The entries of a row.
    fn row(&self, row: usize) -> std::ops::Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    /// The sum of the weights of each row.
    fn sums(&self) -> Vec<f64> {
        (0..self.mass.len()).map(|row| self.weights[self.row(row)].iter().sum()).collect()
    }

    /// The mean of `values` over each vertex and its neighbours.
    fn mean_around(&self, values: &[f64]) -> Vec<f64> {
        let mean = |row: usize| {
            let around = &self.columns[self.row(row)];
            let sum: f64 = around.iter().map(|column| values[*column as usize]).sum();
            (values[row] + sum) / (around.len() + 1) as f64
        };
        (0..values.len()).map(mean).collect()
    }

    /// This operator with a larger area for cells that are too small for their weights.
    ///
    /// With a stretch ρ weights increase on average by (ρ + 1/ρ)/2. With an unchanged limit a quarter of the vertices would change,
    /// and spots would differ twice as much.
    fn with_lifted_mass(self, ratios: &[f64]) -> Self {
        // Mean over about three rings: the size of cells may follow that of the pattern.
        let cells = self.mean_around(&self.mean_around(&self.mass));
        let sums = self.sums();
        let lifted = |vertex: usize| {
            let ratio = ratios[vertex];
            let limit = LARGEST_DIAGONAL * 0.5 * (ratio + 1.0 / ratio);
            // A vertex without triangles has neither area nor weights.
            let mass = self.mass[vertex].max(sums[vertex] * cells[vertex] / limit);
            if mass > 0.0 { mass } else { 1.0 }
        };
        let mass = (0..self.mass.len()).map(lifted).collect();
        Self { mass, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::test_meshes::{even_plate, plate, sphere};
    use crate::surface::vector::{cross, dot, unit};

    const FLAT: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    /// Vertices of a plate that are as far as this from its border.
    fn inner(mesh: &Mesh, margin: f64) -> Vec<usize> {
        let [low, high] = mesh.bounds();
        let is_inner = |at: &[f64; 3]| (0..2).all(|i| at[i] > low[i] + margin && at[i] < high[i] - margin);
        (0..mesh.positions.len()).filter(|vertex| is_inner(&mesh.positions[*vertex])).collect()
    }

    /// Its value on a function of the place, at a vertex.
    fn applied(laplacian: &Laplacian, values: &[f64], row: usize) -> f64 {
        let terms = laplacian.row(row).map(|entry| {
            laplacian.weights[entry] * (values[laplacian.columns[entry] as usize] - values[row])
        });
        terms.sum::<f64>() / laplacian.mass[row]
    }

    fn on_plate(mesh: &Mesh, stretch: Stretch) -> Laplacian {
        laplacian(mesh, &vec![FLAT; mesh.positions.len()], &vec![stretch; mesh.positions.len()])
    }

    fn stretches() -> impl Iterator<Item = Stretch> {
        [1.0, 0.6, 0.3]
            .into_iter()
            .flat_map(|ratio| [0.0, 17.0, 75.0, 130.0].map(|degrees| Stretch { ratio, degrees }))
    }

    /// Regular triangles, and some that are moved by up to a fifth of their sides.
    fn plates() -> [Mesh; 2] {
        let even = even_plate([24.0, 20.0], 1.0);
        let mut uneven = even.clone();
        for (i, at) in uneven.positions.iter_mut().enumerate() {
            let i = i as f64;
            (at[0], at[1]) = (at[0] + 0.2 * libm::sin(12.9 * i), at[1] + 0.2 * libm::sin(78.2 * i));
        }
        [even, uneven]
    }

    #[test]
    fn it_is_0_for_a_linear_function_on_a_plate_whatever_the_stretch() {
        for mesh in plates() {
            for stretch in stretches() {
                let laplacian = on_plate(&mesh, stretch);
                let values: Vec<f64> =
                    mesh.positions.iter().map(|[x, y, _]| 3.0 * x - 2.0 * y + 7.0).collect();
                let far = inner(&mesh, 7.0).into_iter().map(|row| applied(&laplacian, &values, row).abs());
                let far = far.fold(0.0, f64::max);
                assert!(far < 1e-9, "{stretch:?}: {far}");
            }
        }
    }

    #[test]
    fn for_a_quadratic_function_it_equals_that_of_the_tensor_on_a_grid() {
        let mesh = &plates()[0];
        for stretch in stretches() {
            let laplacian = on_plate(mesh, stretch);
            let ratio = f64::from(stretch.ratio);
            let (along, across) = (1.0 / ratio, ratio);
            let (sin, cos) = crate::grid::sin_cos_degrees(f64::from(stretch.degrees));
            let xx = along * cos * cos + across * sin * sin;
            let yy = along * sin * sin + across * cos * cos;
            let xy = (along - across) * cos * sin;
            let quadratic = |[x, y, _]: &[f64; 3]| 0.5 * x * x + 0.25 * x * y - 1.5 * y * y;
            let values: Vec<f64> = mesh.positions.iter().map(quadratic).collect();
            let exact = xx + 0.5 * xy - 3.0 * yy;
            // The cells of a lattice are alike, so that it is exact where no area is changed.
            for row in inner(mesh, 7.0) {
                let found = applied(&laplacian, &values, row);
                assert!((found - exact).abs() < 0.02 * (xx + yy), "{stretch:?}: {found} of {exact}");
            }
        }
    }

    #[test]
    fn weights_are_positive_and_symmetric_and_masses_sum_up_to_the_area() {
        for mesh in plates().into_iter().chain([plate([9, 7], 0.5)]) {
            for stretch in stretches() {
                let found = on_plate(&mesh, stretch);
                for row in 0..found.mass.len() {
                    for entry in found.row(row) {
                        let back = found.row(found.columns[entry] as usize);
                        let back = back.into_iter().find(|other| found.columns[*other] as usize == row);
                        let back = back.map(|other| found.weights[other]);
                        assert!(
                            found.weights[entry] > 0.0 && back == Some(found.weights[entry]),
                            "{stretch:?}"
                        );
                    }
                }
                assert!(found.mass.iter().all(|mass| *mass > 0.0));
                let excess = found.mass.iter().sum::<f64>() / mesh.area() - 1.0;
                assert!(excess > -1e-9 && excess < 0.2, "{stretch:?}: {excess}");
            }
        }
    }

    #[test]
    fn on_a_sphere_spherical_harmonics_are_its_eigenvectors() {
        let mesh = sphere(24, 1.0);
        let frame = |at: &[f64; 3]| {
            let east = unit(cross([0.0, 0.0, 1.0], *at)).unwrap_or([1.0, 0.0, 0.0]);
            [east, cross(*at, east)]
        };
        let frames: Vec<_> = mesh.positions.iter().map(frame).collect();
        let laplacian = laplacian(&mesh, &frames, &vec![Stretch::NONE; frames.len()]);
        let axis = unit([0.3, -0.5, 0.8]).expect("it has a length");
        let legendre: [fn(f64) -> f64; 3] = [|z| z, |z| 1.5 * z * z - 0.5, |z| 2.5 * z * z * z - 1.5 * z];
        for (l, of) in legendre.iter().enumerate().map(|(i, of)| (i as f64 + 1.0, of)) {
            let values: Vec<f64> = mesh.positions.iter().map(|at| of(dot(*at, axis))).collect();
            // Rayleigh quotient.
            let product = |other: &dyn Fn(usize) -> f64| -> f64 {
                (0..values.len()).map(|row| laplacian.mass[row] * values[row] * other(row)).sum()
            };
            let found = -product(&|row| applied(&laplacian, &values, row)) / product(&|row| values[row]);
            assert!((found / (l * (l + 1.0)) - 1.0).abs() < 0.01, "{l}: {found}");
        }
    }

    #[test]
    fn a_diagonal_entry_is_bounded_where_a_cell_is_far_too_small() {
        let mut mesh = even_plate([12.0, 12.0], 1.0);
        // A vertex nearly on the next one.
        let [a, b] = inner(&mesh, 4.0)[..2] else { panic!("a plate has inner vertices") };
        mesh.positions[a][0] = mesh.positions[b][0] - 0.02;
        let laplacian = on_plate(&mesh, Stretch::NONE);
        let diagonals = laplacian.sums().into_iter().zip(&laplacian.mass).map(|(sum, mass)| sum / mass);
        let largest = diagonals.fold(0.0, f64::max);
        // The cells around are smaller, too, by up to half.
        assert!(largest < 2.0 * LARGEST_DIAGONAL / 0.866, "{largest}");
    }

    #[test]
    fn where_directions_turn_around_a_vertex_the_weights_stay_positive_and_finite() {
        let mesh = even_plate([20.0, 20.0], 1.0);
        let stretch = |at: &[f64; 3]| {
            let degrees = crate::grid::atan2(at[1] - 9.7, at[0] - 10.2).to_degrees() as f32;
            Stretch { ratio: 0.2, degrees }
        };
        let stretch: Vec<Stretch> = mesh.positions.iter().map(stretch).collect();
        let laplacian = laplacian(&mesh, &vec![FLAT; stretch.len()], &stretch);
        let all = laplacian.weights.iter().chain(&laplacian.mass);
        assert!(all.clone().all(|value| *value > 0.0 && value.is_finite()));
    }

    #[test]
    fn meshes_that_are_no_surfaces_give_finite_numbers() {
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [5.0; 3]];
        for faces in
            [vec![], vec![[0, 0, 1]], vec![[0, 1, 2]], vec![[0, 1, 2], [1, 0, 3], [0, 1, 3], [0, 2, 1]]]
        {
            let laplacian = on_plate(
                &Mesh { positions: positions.clone(), faces },
                Stretch { ratio: 0.5, degrees: 20.0 },
            );
            assert!(laplacian.weights.iter().all(|weight| weight.is_finite() && *weight > 0.0));
            assert!(laplacian.mass.iter().all(|mass| mass.is_finite() && *mass > 0.0));
        }
    }
}
