//! Parameters of every cell: how size, shape, direction and spacing vary over the grid.

use bytemuck::{Zeroable, zeroed_vec};
use rayon::prelude::*;

use crate::grid::{Cutout, Domain, Edges, Grid};

/// Parameters at one point, in cells.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Zeroable)]
pub struct Parameters {
    /// Reaction rate ÷ diffusion, 1/cell²: s/√(DₐD_b) for spots and lines (with Dₐ across the line), s/Dₐ for stripes. Lengths are
    /// proportional to 1/√rate.
    pub rate: f32,
    /// R = D_b/Dₐ of Meinhardt's spots and lines; other systems have a fixed ratio and ignore it.
    pub ratio: f32,
    /// Minor ÷ major axis of the ellipse that the diffusion tensor makes of a circle, [`super::selling::MIN_STRETCH`]..1.
    pub stretch: f32,
    /// Direction of the long axis, degrees from the first axis of the frame (on a grid +x) towards the second (+y).
    pub direction: f32,
    /// Distance at which spots or lines begin ÷ the system's own at this rate and ratio; 1 = its own.
    pub pitch: f32,
}

/// Up to this value the pitch is only a correction of the spacing, and all lengths in pitches scale with it.
const CORRECTED: f32 = 1.2;

impl Parameters {
    /// A vector for the parameters of `cells` cells, all 0, to be written later.
    #[must_use]
    pub fn unwritten(cells: usize) -> Vec<Self> {
        zeroed_vec(cells)
    }

    /// Factor by which spots are laid farther apart than they need, ≥ 1. The initial size of a spot and its distance from walls do
    /// not scale with it.
    #[must_use]
    pub fn apart(&self) -> f64 {
        f64::from((self.pitch / CORRECTED).max(1.0))
    }

    /// These parameters with the direction in another frame: see [`Domain::transport_angle`].
    #[must_use]
    pub fn turned(self, degrees: f64) -> Self {
        if degrees == 0.0 {
            return self;
        }
        Self { direction: (f64::from(self.direction) + degrees) as f32, ..self }
    }
}

/// A domain and the [`Parameters`] of each of its cells.
#[derive(Clone, Debug)]
pub struct ParameterField<D = Grid> {
    /// The cells. Of the size of a grid's cells in px only the ratio of the sides matters here.
    pub domain: D,
    /// One a cell, by its number.
    pub parameters: Vec<Parameters>,
    /// Cells covered by the marks of other layers, by number; empty = none. These cells do not change.
    pub obstacles: Vec<bool>,
    /// Difference of the decay β of Turing's spots from its usual 12, by cell; empty = 0 everywhere.
    pub decay_noise: Vec<f32>,
    /// The parameter G of [`System::with_growth`](super::System::with_growth), 17.5–27.5, by cell; empty = the usual one.
    pub g: Vec<f32>,
    /// The decay β used with `g`; `None` = the usual one, 20. Other values are for the map of G and β.
    pub decay: Option<f32>,
    /// Curves along which lines begin; `None` = everywhere.
    pub curves: Option<GuideCurves>,
    /// Whether the domain is the flat map of a curved surface: shortest ways on the surface are then curved on the map.
    pub is_curved: bool,
}

/// Curves along which lines begin, by cell.
#[derive(Clone, Debug)]
pub struct GuideCurves {
    /// Distance to the nearest curve, cells.
    pub distance: Vec<f32>,
    /// Inhibitor in obstacle cells: lines lean towards low values of it.
    pub inhibitor: Vec<f32>,
}

impl<D: Domain> ParameterField<D> {
    /// These parameters, one a cell of `domain`, without obstacles.
    #[must_use]
    pub fn new(domain: D, parameters: Vec<Parameters>) -> Self {
        Self {
            domain,
            parameters,
            obstacles: Vec::new(),
            decay_noise: Vec::new(),
            g: Vec::new(),
            decay: None,
            curves: None,
            is_curved: false,
        }
    }

    /// The parameters of the cell that a place lies in; beyond the border those of the nearest.
    #[must_use]
    pub fn at(&self, place: D::Place) -> Parameters {
        self.parameters[self.domain.cell_at(place)]
    }

    /// Whether this cell is covered by the marks of other layers.
    #[must_use]
    pub fn is_obstacle(&self, cell: usize) -> bool {
        self.obstacles.get(cell).copied().unwrap_or(false)
    }
}

impl ParameterField {
    /// Maps with one set of parameters everywhere, on `size` = [columns, rows] square cells.
    ///
    /// ```
    /// use dapple_engine::grid::Edges;
    /// use dapple_engine::rd::{ParameterField, Parameters};
    ///
    /// let parameters = Parameters { rate: 0.02, ratio: 30.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    /// let maps = ParameterField::uniform([16, 8], Edges::Closed, parameters);
    /// assert_eq!(maps.parameters.len(), 128);
    /// assert!(!maps.is_obstacle(0));
    /// ```
    #[must_use]
    pub fn uniform(size: [usize; 2], edges: Edges, parameters: Parameters) -> Self {
        let grid = Grid::unit(size, edges);
        Self::new(grid, vec![parameters; grid.cells()])
    }

    /// These maps in the cells of `cutout` alone.
    #[must_use]
    pub fn cut(&self, cutout: &Cutout) -> Self {
        let curves = self.curves.as_ref().map(|curves| GuideCurves {
            distance: cutout.of(&curves.distance),
            inhibitor: cutout.of(&curves.inhibitor),
        });
        Self {
            domain: cutout.grid,
            parameters: cutout.of(&self.parameters),
            obstacles: cutout.of(&self.obstacles),
            decay_noise: cutout.of(&self.decay_noise),
            g: cutout.of(&self.g),
            decay: self.decay,
            curves,
            is_curved: self.is_curved,
        }
    }

    /// Mean of [`Self::decay_noise`] over a rectangle with these sides about a point.
    fn decay_noise_at(&self, [x, y]: [f64; 2], [wide, high]: [f64; 2]) -> f32 {
        const SHIFTS: [f64; 4] = [-0.375, -0.125, 0.125, 0.375];
        let at = |dx: f64, dy: f64| self.decay_noise[self.domain.cell_at([x + dx * wide, y + dy * high])];
        SHIFTS.iter().flat_map(|dy| SHIFTS.map(|dx| at(dx, *dy))).sum::<f32>() / 16.0
    }

    /// These maps of one canvas on `size` = [columns, rows] cells: lengths in cells change, the pattern does not (except for the
    /// error of the grid).
    #[must_use]
    pub fn on_grid(&self, size: [usize; 2]) -> Self {
        let grid = self.domain.resized(size);
        let [wide, high] = [0, 1].map(|axis| self.domain.size[axis] as f64 / size[axis] as f64);
        let finer = (wide * high) as f32;
        let at = |cell: usize| {
            let [x, y] = grid.center(cell);
            [x * wide, y * high]
        };
        let there = |cell: usize| self.domain.cell_at(at(cell));
        let cells_unless = |empty: bool| 0..if empty { 0 } else { grid.cells() };
        let obstacles = cells_unless(self.obstacles.is_empty()).map(|i| self.is_obstacle(there(i))).collect();
        let curves = self.curves.as_ref().map(|curves| {
            let sampled = |values: &[f32], factor: f32| -> Vec<f32> {
                (0..grid.cells()).map(|i| factor * values[there(i)]).collect()
            };
            GuideCurves {
                distance: sampled(&curves.distance, 1.0 / finer.sqrt()),
                inhibitor: sampled(&curves.inhibitor, 1.0),
            }
        });
        let decay_noise = cells_unless(self.decay_noise.is_empty());
        let decay_noise = decay_noise.map(|i| self.decay_noise_at(at(i), [wide, high])).collect();
        let g = cells_unless(self.g.is_empty()).map(|i| self.g[there(i)]).collect();
        let finer_rate = |i: usize| {
            let p = self.parameters[there(i)];
            Parameters { rate: p.rate * finer, ..p }
        };
        let parameters = (0..grid.cells()).into_par_iter().map(finer_rate).collect();
        let Self { decay, is_curved, .. } = *self;
        Self { domain: grid, parameters, obstacles, decay_noise, g, decay, curves, is_curved }
    }
}
