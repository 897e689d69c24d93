//! What will be grown: the system, the size of a cell, and the parameters at every place.

use super::course::{Course, Way};
use super::keep::Kept;
use super::lattice::{Lattice, Node};
use super::probe::{self, Offset, ProbeError, Probed, When};
use super::recipe::SystemChoice;
use super::spread::limited;
use super::training::Training;
use super::watch::Watch;
use crate::attributes::regions::RegionMap;
use crate::attributes::{Attributes, Spots, Spread, Stripes};
use crate::learn::{Answer, AskError, Note, TrainingError};
use crate::marks::Line;
use crate::measure::Canvas;
use crate::rd::{Maps, Parameters, Seeding, System};
use rayon::prelude::*;

/// Cells that the smallest spot of a texture covers at half its peak. `facts.md` rule 1: below 25 the grid
/// distorts, above only time is lost (it grows with the square).
const CELLS: f64 = 48.0;
/// Cells across the thinnest stripe (`facts.md` C: wavelength 12–20).
const CELLS_ACROSS: f64 = 8.0;
/// Cells across the thinnest line: the grid takes 1.5 % of its width, of 4 cells 3 %.
const CELLS_ACROSS_A_LINE: f64 = 5.0;
/// From this size on a spot's size in cells no longer matters: parameters scale exactly (`facts.md` A, B), so
/// that a larger one is looked up at this size. The sets reach to 160.
const EXACT_CELLS: f64 = 120.0;
/// The same for the width of a stripe, cells. The set reaches to 16.
const EXACT_ACROSS: f64 = 14.0;
/// The same of a line. The set reaches to 9.
const EXACT_ACROSS_A_LINE: f64 = 8.0;
/// px a cell below which a pattern could not be seen on the canvas anyway.
const FINEST: f64 = 0.35;
/// area ÷ spacing² of a spot whose spacing is free: what Meinhardt's system packs at its smallest ratio, where
/// its spots are evenest.
const FREE_MEINHARDT: f64 = 0.12;

/// Spots sparser than what is reached by less than this are as good as met.
const NOTICED: f64 = 0.02;
/// From this pitch on spots among sparse ones are laid apart: they stand alone at their usual level.
const ALONE: f64 = 1.7;
/// What is asked counts as met where area, spacing and aspect together are nearer than this.
const MET: f64 = 0.05;

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

/// px a cell that suits these attributes.
#[must_use]
pub fn cell_for(wanted: &Attributes) -> f64 {
    let cell = match wanted {
        Attributes::Stripes(Stripes { width, wavelength: None, .. }) => width / CELLS_ACROSS,
        Attributes::Stripes(line) => line.width / CELLS_ACROSS_A_LINE,
        Attributes::Spots(spots) => {
            // Denser spots are read at a lower level, and so are larger than the peak that must be resolved.
            let dense =
                spots.spacing.map_or(1.0, |s| (spots.area / (s * s) / FREE_MEINHARDT).clamp(1.0, 2.0));
            (spots.area / dense / CELLS).sqrt()
        }
    };
    cell.max(FINEST)
}

/// px a cell of the coarsest grid, no finer than `cell`, on which such marks are no larger than their size in cells
/// matters.
#[must_use]
pub fn exact_cell(wanted: &Attributes, cell: f64) -> f64 {
    cell.max(match wanted {
        Attributes::Spots(spots) => (spots.area / EXACT_CELLS).sqrt(),
        Attributes::Stripes(Stripes { width, wavelength: None, .. }) => width / EXACT_ACROSS,
        Attributes::Stripes(line) => line.width / EXACT_ACROSS_A_LINE,
    })
}

/// Looks up attributes (px) for a grid of `cell` px a cell. The answer's attributes are px, its parameters
/// those of the grid. Spots sparser than any that their system packs by itself are laid farther apart, if they can.
///
/// # Errors
/// The training set cannot be read, or does not take such attributes.
pub fn ask(training: &Training, system: System, wanted: &Attributes, cell: f64) -> Result<Answer, PlanError> {
    let exact = exact_cell(wanted, cell);
    let (set, asked) = (training.of(system)?, wanted.scaled(1.0 / exact));
    let answer = set.ask(&asked)?;
    let apart = if is_sparser(&asked, &answer.nearest) { set.ask_apart(&asked, 1.0)? } else { None };
    Ok(on_grid(apart.unwrap_or(answer), cell, exact))
}

/// As [`ask`], on a canvas where some spots are laid apart: others are, too, where they have the room. On the way from
/// dense regions to sparse ones parameters else went through those of the sparsest that one run packs, which take twenty
/// times the steps.
fn ask_among_sparse(
    training: &Training,
    system: System,
    wanted: &Attributes,
    cell: f64,
) -> Result<Answer, PlanError> {
    let exact = exact_cell(wanted, cell);
    let apart = training.of(system)?.ask_apart(&wanted.scaled(1.0 / exact), 1.0)?;
    match apart.filter(|answer| answer.pitch >= ALONE) {
        Some(answer) => Ok(on_grid(answer, cell, exact)),
        None => ask(training, system, wanted, cell),
    }
}

/// As [`ask`], for spots that are laid at given places: as spots that stand alone where these are far enough apart for
/// it. `room` is the share of the spacing, 0..1, that is left to them where the places suit their shape least.
///
/// # Errors
/// As [`ask`].
pub fn ask_placed(
    training: &Training,
    system: System,
    wanted: &Attributes,
    room: f64,
    cell: f64,
) -> Result<Answer, PlanError> {
    let exact = exact_cell(wanted, cell);
    let (set, asked) = (training.of(system)?, wanted.scaled(1.0 / exact));
    let mut answer = match set.ask_apart(&asked, room)? {
        Some(answer) => answer,
        None => set.ask(&asked)?,
    };
    answer.notes.retain(|note| !matches!(note, Note::Apart { .. }));
    Ok(on_grid(answer, cell, exact))
}

/// An answer about cells of `exact` px for a grid of `cell` px a cell.
fn on_grid(mut answer: Answer, cell: f64, exact: f64) -> Answer {
    let shrink = cell / exact;
    answer.parameters.rate *= shrink * shrink;
    answer.in_px(exact)
}

/// Is what is asked sparser than what is reached?
fn is_sparser(asked: &Attributes, reached: &Attributes) -> bool {
    let packing = |attributes: &Attributes| match attributes {
        Attributes::Spots(Spots { area, spacing: Some(spacing), .. }) => Some(area / (spacing * spacing)),
        _ => None,
    };
    packing(asked).zip(packing(reached)).is_some_and(|(asked, reached)| asked < (1.0 - NOTICED) * reached)
}

/// Looks up attributes (px) for a grid of so many px a cell.
type Asked<'a> = &'a (dyn Fn(&Attributes, f64) -> Result<Answer, PlanError> + Sync);

/// Plans a layer with these wanted attributes. The canvas is that of `map`.
///
/// # Errors
/// As [`ask`].
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
pub(super) fn planned(system: System, map: RegionMap, asked: Asked) -> Result<Plan, PlanError> {
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
/// As [`ask`].
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
    let mut spreads = vec![Spread::EVEN; regions.len()];
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

/// Spacing, px, that the system gives such spots by itself.
#[must_use]
pub fn free_spacing(training: &Training, system: System, spots: &Spots) -> f64 {
    let free = Attributes::Spots(Spots { spacing: None, ..*spots });
    let given = match system {
        System::TuringSpots => ask(training, system, &free, cell_for(&free)).ok(),
        // Any spacing would do; evenest are the spots of its smallest ratio.
        _ => None,
    };
    match given.map(|answer| answer.predicted) {
        Some(Attributes::Spots(Spots { spacing: Some(spacing), .. })) => spacing,
        _ => (spots.area / FREE_MEINHARDT).sqrt(),
    }
}

/// Lines want stripes, thin ones on wide ground [`System::MeinhardtLines`]; ellipses want Meinhardt's system, whose spots are rounder and stand as far apart as
/// asked, unless Turing's meets what is asked and Meinhardt's does not.
fn auto(training: &Training, map: &RegionMap) -> Result<System, PlanError> {
    let mut miss = [0.0f64; 2];
    for (place, _) in map.regions() {
        let mut wanted = map.at(map.layout().center(place));
        let spots = match &mut wanted {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(Stripes { wavelength: None, .. }) => return Ok(System::MeinhardtStripes),
            Attributes::Stripes(_) => return Ok(System::MeinhardtLines),
        };
        if spots.spacing.is_none() {
            spots.spacing = Some(free_spacing(training, System::MeinhardtSpots, spots));
        }
        let cell = cell_for(&wanted);
        for (worst, system) in miss.iter_mut().zip([System::MeinhardtSpots, System::TuringSpots]) {
            let answer = ask(training, system, &wanted, cell)?;
            *worst = worst.max(distance(&wanted, &answer.predicted));
        }
    }
    let [meinhardt, turing] = miss;
    Ok(if turing < MET && MET < meinhardt { System::TuringSpots } else { System::MeinhardtSpots })
}

/// How far two sets of spots differ: |Δ ln area| + |Δ ln spacing| + |Δ aspect|.
fn distance(a: &Attributes, b: &Attributes) -> f64 {
    let (Attributes::Spots(a), Attributes::Spots(b)) = (a, b) else { return f64::INFINITY };
    let ln = |x: f64, y: f64| libm::log(x / y).abs();
    let spacing = a.spacing.zip(b.spacing).map_or(0.0, |(a, b)| ln(a, b));
    ln(a.area, b.area) + spacing + (a.aspect - b.aspect).abs()
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
        let maps = Maps { taken: self.taken.clone(), ..Maps::new([nx, ny], self.cell, parameters) };
        match &self.course {
            None => maps,
            Some(course) => course.told(maps),
        }
    }
}
