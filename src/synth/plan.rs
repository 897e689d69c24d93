//! What will be grown: the system, the size of a cell, and the parameters at every place.

pub mod around;
mod auto;
pub mod inside;
mod lattice;
pub mod looked_up;
mod lookup;
pub mod obstacle_mask;
pub mod offset_curves;
pub mod pinned_marks;
pub mod sketch_targets;
pub mod spacing_correction;
pub mod spread;

pub use lookup::{ask, ask_placed, cell_for, exact_cell, free_spacing};

use super::training::Training;
use super::watch::Watch;
use crate::attributes::regions::RegionMap;
use crate::attributes::{Attributes, Spread};
use crate::document::SystemChoice;
use crate::grid::Grid;
use crate::learn::{Answer, AskError, TrainingError};
use crate::marks::Line;
use crate::measure::Canvas;
use crate::rd::{Maps, Parameters, Seeding, System};
use crate::synth::grow::probe;
use crate::synth::grow::probe::{Offset, ProbeError, Probed, When};
use crate::synth::plan::lattice::{Lattice, Node};
use crate::synth::plan::offset_curves::{Course, Way};
use crate::synth::plan::pinned_marks::Kept;
use crate::synth::plan::spread::limited;
use auto::auto;
use lookup::ask_among_sparse;
use rayon::prelude::*;

/// Why there is no plan.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// A training set could not be read.
    #[error(transparent)]
    Training(#[from] TrainingError),
    /// A question that no set takes.
    #[error(transparent)]
    Ask(#[from] AskError),
}

/// What will be grown on one layer.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The system.
    pub system: System,
    /// What is wanted where; free spacings filled in.
    pub map: RegionMap,
    /// px a cell, along x and y.
    pub cell: [f64; 2],
    /// Cells along x and y.
    pub grid: [usize; 2],
    /// Parameters (in cells) at every place.
    pub lattice: Lattice,
    /// How irregular its spots are to be, 0..1: Turing's can be.
    pub irregular: f64,
    /// Which cells the marks of the layers beneath have taken; empty = none.
    pub taken: Vec<bool>,
    /// What its lines do to the marks beneath, where they are such.
    pub way: Option<Way>,
    /// How they run, once that is known.
    pub course: Option<Course>,
    /// Where its marks begin, px, where that is not for its system to say.
    pub places: Option<Vec<[f64; 2]>>,
    /// Drawn marks that grow where they were drawn.
    pub kept: Vec<Kept>,
    /// What stripes begin from; other seeds than noise grow without a tensor.
    pub seeding: Seeding,
    /// Drawn lines along which stripes run.
    pub crests: Vec<Line>,
    /// What was looked up for each region, lengths in px but parameters in cells.
    pub answers: Vec<Answer>,
    /// What there is to say beside the notes of the answers, by region.
    pub remarks: Vec<Vec<String>>,
    /// What probes found about it, by region.
    pub probed: Vec<Probed>,
    /// How much the spots of each region will vary: as wanted, as far as that can be.
    spreads: Vec<Spread>,
}

/// Looks up attributes (px) for a grid of so many px a cell.
type Asked<'a> = &'a (dyn Fn(&Attributes, f64) -> Result<Answer, PlanError> + Sync);

/// Plans a layer with these wanted attributes. The canvas is that of `map`.
///
/// # Errors
/// As [`ask()`].
pub fn plan(training: &Training, choice: SystemChoice, map: &RegionMap) -> Result<Plan, PlanError> {
    let mut map = map.clone();
    let system = match choice {
        SystemChoice::TuringSpots => System::TuringSpots,
        SystemChoice::MeinhardtSpots => System::MeinhardtSpots,
        SystemChoice::MeinhardtStripes => System::MeinhardtStripes,
        SystemChoice::MeinhardtLines => System::MeinhardtLines,
        SystemChoice::Auto => auto(training, &map)?,
    };
    map.fill_free_spacing(|spots| free_spacing(training, system, spots));
    let sparse = |(place, _)| {
        let wanted = map.at(map.layout().center(place));
        Ok(ask(training, system, &wanted, cell_for(&wanted))?.pitch > 1.0)
    };
    let sparse = map.regions().map(sparse).collect::<Result<Vec<_>, PlanError>>()?.contains(&true);
    let asked = if sparse { ask_among_sparse } else { ask };
    planned(system, map, &|wanted, cell| asked(training, system, wanted, cell))
}

/// Plans a layer of `system` with these wanted attributes, no spacing free, whose parameters are `asked`.
pub(crate) fn planned(system: System, map: RegionMap, asked: Asked) -> Result<Plan, PlanError> {
    let cell = finest_cell(&map);
    planned_on(system, map, cell, asked)
}

/// px a cell that suits the finest marks of `map`, no spacing of which is free.
#[must_use]
pub fn finest_cell(map: &RegionMap) -> f64 {
    let regions = map.regions().map(|(place, _)| map.at(map.layout().center(place)));
    regions.map(|wanted| cell_for(&wanted)).fold(f64::INFINITY, f64::min)
}

/// As [`plan()`], on a grid of about `cell` px a cell whatever suits the marks; no spacing of `map` may be free.
///
/// # Errors
/// As [`ask()`].
pub fn plan_on(training: &Training, system: System, map: &RegionMap, cell: f64) -> Result<Plan, PlanError> {
    planned_on(system, map.clone(), cell, &|wanted, cell| ask(training, system, wanted, cell))
}

fn planned_on(system: System, map: RegionMap, cell: f64, asked: Asked) -> Result<Plan, PlanError> {
    let regions: Vec<Attributes> =
        map.regions().map(|(place, _)| map.at(map.layout().center(place))).collect();
    let size = map.layout().size;
    let grid = size.map(|side| ((side / cell).round() as usize).max(8));
    let exact = [size[0] / grid[0] as f64, size[1] / grid[1] as f64];
    let cell = (exact[0] * exact[1]).sqrt();

    let answers = regions.iter().map(|wanted| asked(wanted, cell)).collect::<Result<Vec<_>, _>>()?;
    let probed = vec![Probed::default(); regions.len()];
    let mut remarks = vec![Vec::new(); regions.len()];
    let mut spreads = vec![Spread::ZERO; regions.len()];
    for (index, (place, region)) in map.regions().enumerate() {
        if let Attributes::Spots(wanted) = map.at(map.layout().center(place)) {
            let limited = limited(system, &wanted, &region.spread, map.spread_is_given());
            spreads[index] = limited.spread;
            remarks[index] = limited.notes;
        }
    }
    let lattice = lattice(&map, cell, &probed, asked)?;
    Ok(Plan {
        system,
        map,
        cell: exact,
        grid,
        lattice,
        irregular: 0.0,
        seeding: Seeding::Noise,
        taken: Vec::new(),
        way: None,
        course: None,
        places: None,
        kept: Vec::new(),
        crests: Vec::new(),
        answers,
        remarks,
        probed,
        spreads,
    })
}

/// Parameters at the nodes over the canvas of `map`: those looked up for what is wanted there, less what probes found
/// the regions around to be off by.
fn lattice(map: &RegionMap, cell: f64, probed: &[Probed], ask: Asked) -> Result<Lattice, PlanError> {
    let layout = Lattice::over(map.layout());
    let node = |index: usize| {
        let point = layout.center(layout.place(index));
        let corners = map.layout().corners(point);
        let offset = corners
            .iter()
            .fold(Offset::default(), |sum, &(region, weight)| sum.plus(weight, probed[region].offset));
        let asked = offset.applied(-1.0, &map.at(point));
        Ok(Node::of(&ask(&asked, cell)?))
    };
    let nodes = (0..layout.len()).into_par_iter().map(node).collect::<Result<Vec<_>, PlanError>>()?;
    Ok(Lattice { layout, nodes })
}

impl Plan {
    /// px a cell, where cells are as good as square.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        (self.cell[0] * self.cell[1]).sqrt()
    }

    /// The same plan with its parameters corrected by probes, one a region.
    ///
    /// # Errors
    /// The training set cannot be asked; or [`super::Cancelled`].
    pub fn probed(mut self, training: &Training, when: When, watch: &Watch) -> Result<Self, ProbeError> {
        if self.places.is_some() || self.way.is_some() {
            // Spots at places of their own are as their law says; a patch would stand at others.
            return Ok(self);
        }
        let wanted = self.wanted();
        let cell = self.px_a_cell();
        self.probed = probe::probed(training, self.system, &wanted, cell, when, watch)?;
        if self.probed.iter().all(|probed| probed.growths == 0) {
            return Ok(self);
        }
        self.follow(training, &wanted)?;
        Ok(self)
    }

    /// The same plan with what marks beneath do to its own subtracted: `found` grown, by region.
    ///
    /// # Errors
    /// The training set cannot be asked.
    pub fn against(mut self, training: &Training, found: &[Offset]) -> Result<Self, PlanError> {
        for (probed, found) in self.probed.iter_mut().zip(found) {
            probed.offset = probed.offset.plus(1.0, *found);
        }
        let wanted = self.wanted();
        self.follow(training, &wanted)?;
        Ok(self)
    }

    /// What is wanted at the centre of each region.
    fn wanted(&self) -> Vec<Attributes> {
        let layout = self.map.layout();
        (0..layout.len()).map(|i| self.map.at(layout.center(layout.place(i)))).collect()
    }

    /// Takes the offsets found into the parameters.
    fn follow(&mut self, training: &Training, wanted: &[Attributes]) -> Result<(), PlanError> {
        let cell = self.px_a_cell();
        let system = self.system;
        let asked = if self.answers.iter().any(|answer| answer.pitch > 1.0) { ask_among_sparse } else { ask };
        let ask_again = |wanted: &Attributes, cell| asked(training, system, wanted, cell);
        self.lattice = lattice(&self.map, cell, &self.probed, &ask_again)?;
        for ((answer, wanted), Probed { offset, .. }) in self.answers.iter_mut().zip(wanted).zip(&self.probed)
        {
            let corrected = ask_again(&offset.applied(-1.0, wanted), cell)?;
            answer.parameters = corrected.parameters;
            answer.predicted = offset.applied(1.0, &corrected.predicted);
        }
        Ok(())
    }

    /// Have the marks of the layers beneath taken this place, px?
    fn is_taken(&self, point: [f64; 2]) -> bool {
        let cell = |axis: usize| ((point[axis] / self.cell[axis]).max(0.0) as usize).min(self.grid[axis] - 1);
        self.taken.get(cell(1) * self.grid[0] + cell(0)).copied().unwrap_or(false)
    }

    /// Does `work` with the canvas that the ruler compares against: its regions, and what is wanted where.
    pub fn on_canvas<T>(&self, work: impl FnOnce(&Canvas) -> T) -> T {
        let layout = self.map.layout();
        work(&Canvas {
            size: layout.size,
            edges: layout.edges,
            regions: layout.len(),
            region_of: &|point| layout.index(layout.region_of(point)),
            covered: &|point| self.is_taken(point),
            wanted: &|point| self.map.at(point),
        })
    }

    /// How much the spots of region `index` will vary.
    #[must_use]
    pub fn spread(&self, index: usize) -> Spread {
        self.spreads[index]
    }

    /// Where a point of the grid, cells, lies on the canvas, px.
    #[must_use]
    pub fn place(&self, at: [f64; 2]) -> [f64; 2] {
        [at[0] * self.cell[0], at[1] * self.cell[1]]
    }

    /// The same of many.
    #[must_use]
    pub fn px(&self, at: &[[f64; 2]]) -> Vec<[f64; 2]> {
        at.iter().map(|at| self.place(*at)).collect()
    }

    /// Where its marks begin, cells, where that is not for its system to say.
    #[must_use]
    pub fn places_in_cells(&self) -> Option<Vec<[f64; 2]>> {
        let cells = |at: &[f64; 2]| [0, 1].map(|axis| at[axis] / self.cell[axis]);
        Some(self.places.as_ref()?.iter().map(cells).collect())
    }

    /// What is known by region of `map`, at a point, px.
    #[must_use]
    pub fn between_regions(&self, known: &[f64], point: [f64; 2]) -> f64 {
        self.map.layout().corners(point).iter().map(|&(i, weight)| weight * known[i]).sum()
    }

    /// What a cell is told that has these parameters by the lattice.
    fn told(&self, p: Parameters) -> Parameters {
        if self.seeding == Seeding::Noise { p } else { Parameters { stretch: 1.0, ..p } }
    }

    /// Parameters of every cell. `pitch` says how much farther apart than the system would the spots begin, by
    /// region of `map`.
    #[must_use]
    pub fn maps(&self, pitch: &[f64]) -> Maps {
        let [nx, ny] = self.grid;
        let uniform = self.lattice.nodes.len() == 1 && pitch.len() == 1;
        let parameters = if uniform {
            vec![self.told(self.lattice.nodes[0].parameters(pitch[0])); nx * ny]
        } else {
            let at = |cell: usize| {
                let point = self.place([(cell % nx) as f64 + 0.5, (cell / nx) as f64 + 0.5]);
                self.told(self.lattice.at(point).parameters(self.between_regions(pitch, point)))
            };
            (0..nx * ny).into_par_iter().map(at).collect()
        };
        let grid = Grid { size: self.grid, cell: self.cell, edges: self.map.layout().edges };
        let maps = Maps { obstacles: self.taken.clone(), ..Maps::new(grid, parameters) };
        match &self.course {
            None => maps,
            Some(course) => course.told(maps),
        }
    }
}
