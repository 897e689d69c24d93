//! A patch of spots, with equal places on meshes and grids of any fineness.

use std::sync::Arc;

use dapple_engine::grid::{Domain, UnionFind};
use dapple_engine::rd::{Operators, ParameterField, Parameters, SurfaceGrowth, System, from_places, nuclei};

use dapple_engine::measure::{SurfaceSpot, surface_spots};
use dapple_engine::surface::Surface;

use super::lattice::Lattice;

/// Side of a patch, in spacings (42 spots).
const SIDE: f64 = 6.0;
/// Vertices per spacing on the mesh where the places of spots are chosen.
const LAID: f64 = 12.0;
/// Normalised time: areas are then within 0.1 % of their limit.
const TIME: f64 = 60.0;
/// The share of the peak that is the edge of a spot.
const LEVEL: f32 = 0.5;

/// Spots of one kind, and the places where their growth starts.
#[derive(Clone, Debug)]
pub struct Patch {
    system: System,
    /// The parameters; the rate follows from the fineness.
    parameters: Parameters,
    /// Places of the spots as shares of the side, 0..1.
    places: Vec<[f64; 2]>,
}

/// The result of a growth.
#[derive(Clone, Copy, Debug)]
pub struct Grown {
    /// Spacing, in units of √(mean area of a cell).
    pub fineness: f64,
    /// The number of separate spots.
    pub spots: usize,
    /// Area of a spot ÷ spacing², with linear interpolation between vertices; only if all spots are there.
    pub area: f64,
    /// Area of a spot ÷ spacing², as dapple measures it.
    pub smooth: f64,
    /// The mean aspect, as dapple measures it.
    pub aspect: f64,
}

impl Patch {
    /// Spots with these parameters, whose rate is not used.
    pub fn new(system: System, parameters: Parameters, seed: u64) -> Self {
        let lattice = Lattice::new(SIDE * LAID);
        let own = with_fineness(system, parameters, lattice.side / SIDE);
        let maps = ParameterField::new(lattice, vec![own; lattice.cells()]);
        let inside = nuclei(system, &maps, seed, &[]).inside;
        let places = inside.iter().map(|at| at.map(|along| along / lattice.side)).collect();
        Self { system, parameters, places }
    }

    /// The number of spots at the start.
    pub fn laid(&self) -> usize {
        self.places.len()
    }

    /// Grows the spots on triangles, with about this number of vertices per spacing.
    pub fn on_triangles(&self, fineness: f64) -> Option<Grown> {
        let lattice = Lattice::new(SIDE * fineness);
        let fineness = lattice.side / SIDE;
        let own = with_fineness(self.system, self.parameters, fineness);
        let maps = ParameterField::new(lattice, vec![own; lattice.cells()]);
        let laplacian = lattice.laplacian(f64::from(own.stretch), f64::from(own.direction));
        let operators = Arc::new(Operators::of(&[(laplacian, vec![1.0; lattice.cells()])], 1.0));
        let places: Vec<[f64; 2]> =
            self.places.iter().map(|at| at.map(|along| along * lattice.side)).collect();
        let begin = from_places(self.system, &maps, &places, &|_| false);
        let mut growth = SurfaceGrowth::new(self.system, &maps, operators, &begin)?;
        growth.advance(growth.steps_in(TIME));
        let (marks, triangle) = (growth.marks(), 0.5);
        let grown = self.measured(&marks, &lattice.faces(), triangle, fineness);
        Some(by_the_ruler(&lattice, &marks, grown))
    }

    /// The spots of these values, over triangles of the same area.
    fn measured(&self, marks: &[f32], faces: &[[u32; 3]], triangle: f64, fineness: f64) -> Grown {
        let mut pieces = UnionFind::new(marks.len());
        let mut area = 0.0;
        for face in faces {
            let over = face.map(|vertex| f64::from(marks[vertex as usize] - LEVEL));
            area += triangle * share_above(over);
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                if over[a] > 0.0 && over[b] > 0.0 {
                    pieces.join(face[a], face[b], [0; 2]);
                }
            }
        }
        let is_first = |i: &usize| marks[*i] > LEVEL && pieces.root(*i as u32).0 == *i as u32;
        let spots = (0..marks.len()).filter(is_first).count();
        let square = SIDE * SIDE * fineness * fineness;
        // For a hexagonal lattice with this number of spots, (area of the patch ÷ spots) ÷ spacing² = √¾.
        let area = area / square * 0.75f64.sqrt();
        Grown { fineness, spots, area, smooth: area, aspect: 1.0 }
    }
}

/// Adds the mean area and aspect of the spots as dapple measures them on surfaces: on the lattice with a frame around
/// it, so that every spot is whole there.
fn by_the_ruler(lattice: &Lattice, marks: &[f32], grown: Grown) -> Grown {
    let (mesh, vertices) = lattice.unrolled(2.0 * grown.fineness);
    let values: Vec<f32> = vertices.iter().map(|vertex| marks[*vertex]).collect();
    let surface = Surface::new(mesh, [1.0, 0.0, 0.0]);
    let spots = surface_spots(&surface, &values, &vec![LEVEL; values.len()]);
    let is_inside = |spot: &&SurfaceSpot| {
        let [x, y, _] = surface.position(spot.place);
        [x, y].iter().all(|at| (0.0..lattice.side).contains(at))
    };
    let inside: Vec<&SurfaceSpot> = spots.iter().filter(is_inside).collect();
    let count = inside.len().max(1) as f64;
    let area = inside.iter().map(|spot| spot.area).sum::<f64>();
    let square = lattice.side * lattice.side;
    Grown {
        smooth: area / square * 0.75f64.sqrt(),
        aspect: inside.iter().map(|spot| spot.aspect()).sum::<f64>() / count,
        ..grown
    }
}

/// The parameters with which the spacing of the spots is this number of cells.
fn with_fineness(system: System, parameters: Parameters, fineness: f64) -> Parameters {
    let apart = system.spacing(&Parameters { rate: 1.0, ..parameters }) / fineness;
    Parameters { rate: (apart * apart) as f32, ..parameters }
}

/// The share of a triangle where a linear function with these values at its corners is above 0.
fn share_above(values: [f64; 3]) -> f64 {
    let above = values.iter().filter(|value| **value > 0.0).count();
    // The part at the corner that is alone on its side of 0.
    let alone = |k: usize| {
        let [own, next, last] = [values[k], values[(k + 1) % 3], values[(k + 2) % 3]];
        own / (own - next) * (own / (own - last))
    };
    let corner = |is_above: bool| (0..3).find(|k| (values[*k] > 0.0) == is_above).map_or(0.0, alone);
    match above {
        0 => 0.0,
        1 => corner(true),
        2 => 1.0 - corner(false),
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dapple_engine::grid::{Edges, Grid};
    use dapple_engine::rd::Growth;

    #[test]
    fn the_share_above_0_is_the_part_that_the_zero_line_cuts_off() {
        assert_eq!(share_above([-1.0, -2.0, -1.0]), 0.0);
        assert_eq!(share_above([1.0, 2.0, 1.0]), 1.0);
        assert_eq!(share_above([1.0, -1.0, -1.0]), 0.25);
        assert_eq!(share_above([-1.0, 1.0, 3.0]), 1.0 - 0.5 * 0.25);
    }

    /// Grows the spots on a grid, with about this number of cells per spacing.
    fn on_grid(patch: &Patch, fineness: f64) -> Option<Grown> {
        let side = (SIDE * fineness).round() as usize;
        let fineness = side as f64 / SIDE;
        let own = with_fineness(patch.system, patch.parameters, fineness);
        let maps = ParameterField::new(Grid::unit([side; 2], Edges::Wrap), vec![own; side * side]);
        let places: Vec<[f64; 2]> =
            patch.places.iter().map(|at| at.map(|along| along * side as f64)).collect();
        let begin = from_places(patch.system, &maps, &places, &|_| false);
        let mut growth = Growth::resumed(patch.system, &maps, begin)?;
        growth.advance(growth.steps_in(TIME));
        // Both ways to cut a square into triangles; each counts half of the area.
        let square = |i: usize| {
            let at = |x: usize, y: usize| ((y % side) * side + x % side) as u32;
            let (x, y) = (i % side, i / side);
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            [[a, b, c], [b, d, c], [a, b, d], [a, d, c]]
        };
        let faces: Vec<[u32; 3]> = (0..side * side).flat_map(square).collect();
        Some(patch.measured(&growth.marks().values, &faces, 0.25, fineness))
    }

    #[test]
    fn a_lattice_and_a_grid_grow_the_same_spots_where_they_are_fine() {
        let parameters = Parameters { rate: 1.0, ratio: 15.0, stretch: 0.7, direction: 20.0, pitch: 1.0 };
        let patch = Patch::new(System::MEINHARDT_SPOTS, parameters, 3);
        let [triangles, grid] =
            [patch.on_triangles(16.0), on_grid(&patch, 16.0)].map(|grown| grown.expect("it grows"));
        assert_eq!([triangles.spots, grid.spots], [patch.laid(); 2]);
        assert!((triangles.area / grid.area - 1.0).abs() < 0.02, "{triangles:?} {grid:?}");
    }
}
