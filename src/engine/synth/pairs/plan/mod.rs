//! Plans of layers that systems of pairs grow.

mod cut;
mod learnt;
mod maze;
pub(in crate::synth) mod stripes;
mod stucco;
pub mod thread_map;
mod weave;

pub use learnt::{Crossed, crossed, least_between};
pub use maze::MazeForm;
pub use stucco::StuccoForm;
pub use weave::WeaveForm;

use rayon::prelude::*;

use crate::attributes::direction_groups::{direction_groups, directions_of};
use crate::attributes::free::FreeMap;
use crate::attributes::periods::PeriodRules;
use crate::attributes::regions::RegionGrid;
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{Document, DocumentError, DutyChoice, Kind, LayerOptions, Over, Problem, SystemChoice};
use crate::grid::{Bounds, Domain, Field, Grid};
use crate::learn::PairSet;
use crate::marks::{Mark, Path};
use crate::rd::pairs::work::{Sizes, updates};
use crate::rd::pairs::{
    Blurs, Combination as Reaction, Course, MOST_PAIRS, PairField, PairKind, PairModel, PairParameterField,
    Threads,
};
use crate::synth::drawn::maps::modulation;
use crate::synth::drawn::sketch_targets::marks;
pub(in crate::synth) use cut::GROUND;
use cut::cut_by_duty;
use thread_map::ThreadMap;

/// Cells per smallest size s: with fewer than 1.5, edges stick to the grid (`facts.md` T).
const CELLS: f64 = 1.75;
/// d: 1.5 gives clean lines (`facts.md` H).
pub(in crate::synth) const RATIO: f32 = 1.5;
/// Time of pair stripes and stucco, which grow from noise, in 1/b.
pub const FROM_NOISE: f64 = 14.0;
/// Nodes along the longer side at which sizes are looked up where they vary: widths and periods change slowly.
const NODES: usize = 16;

/// A layer of pairs that is ready to grow.
#[derive(Clone, Debug)]
pub struct PairPlan {
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// The wanted threads of each direction; for pair stripes and stucco there is one.
    pub threads: Vec<ThreadMap>,
    /// Nodes at whose centres sizes are computed.
    nodes: RegionGrid,
    /// Factor between the size and its law for each pair at each node, from training rows.
    learnt: Vec<Vec<f64>>,
    /// Cells that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
    /// Increase of the threshold at each cell, in K₀; empty = 0 everywhere.
    pub raised: Vec<f32>,
    /// Notes for the user.
    pub notes: Vec<String>,
    /// The kind of pattern, with what is particular to it.
    pub form: PairForm,
    /// Rule that tells which threads of a weave lie over the others.
    pub over: Over,
}

/// The kind of pattern of pairs, with what is particular to it.
#[derive(Clone, Debug)]
pub enum PairForm {
    /// Threads that cross.
    Weave(WeaveForm),
    /// Lines of several directions that do not cross.
    Maze(MazeForm),
    /// Lines of one direction, with tips.
    Stripes,
    /// Blotches without a direction.
    Stucco(StuccoForm),
}

impl PairPlan {
    /// Reads layer `index` of a document named `source`, on a canvas of `size` px. `rows` hold the errors of the laws of its
    /// system.
    ///
    /// # Errors
    /// Its marks are no lines; or the lines of a weave or a maze have one direction or more than [`MOST_PAIRS`]; or a rule of
    /// layers is broken: file, place, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        size: [f64; 2],
        rows: Option<&PairSet>,
    ) -> Result<Self, DocumentError> {
        let kind = document.pairs(index).unwrap_or(PairKind::Weave);
        let marks = marks(document, index, source)?;
        let below = if index == 0 { Beneath::Nothing } else { Beneath::Unknown };
        let layer = &document.layers[index];
        let combination = Combination::new(layer, marks.first().map(Kind::from), below);
        // A weave that `auto` chooses because lines cross has smooth edges, too.
        let LayerOptions { vary, double, ragged, .. } = layer.options;
        let options = LayerOptions { vary, double, ragged, ..LayerOptions::default() };
        let of_pairs = Combination { system: SystemChoice::Of(kind.description()), options, ..combination };
        let place = format!("layers[{index}]");
        if let Some(problem) = combination.problem(&place).or_else(|| of_pairs.problem(&place)) {
            return Err(problem.in_file(source));
        }
        let canvas = Bounds { size, edges: document.edges };
        if kind == PairKind::Stucco {
            return Ok(Self::of_stucco(document, index, &marks, canvas, rows));
        }
        let lines: Vec<Path> = marks.iter().filter_map(Mark::path).collect();
        let own = Bounds { size: document.size.map(f64::from), edges: document.edges };
        let groups = match kind {
            PairKind::Weave => direction_groups(&lines, &own),
            PairKind::Maze => directions_of(&lines),
            PairKind::Stripes | PairKind::Stucco => vec![(0..lines.len()).collect()],
        };
        let crosses = matches!(kind, PairKind::Weave | PairKind::Maze);
        if crosses && !(2..=MOST_PAIRS).contains(&groups.len()) {
            let found = match groups.len() {
                1 => "lines of one direction".to_owned(),
                count => format!("lines of {count} directions in one place"),
            };
            let allowed = format!(
                "lines of two to {MOST_PAIRS} directions, for a {}; draw lines across these, or choose another system",
                kind.description().name
            );
            return Err(Problem::new(format!("layers[{index}].strokes"), found, allowed).in_file(source));
        }
        let rules = match kind {
            PairKind::Weave => PeriodRules::threads(thread_map::OWN_DUTY[usize::from(groups.len() > 2)]),
            PairKind::Stripes => PeriodRules::PAIR_STRIPES,
            PairKind::Maze | PairKind::Stucco => PeriodRules::threads(LayerOptions::DUTY),
        };
        let threads = groups.iter().filter_map(|group| {
            let lines: Vec<(usize, Path)> = group.iter().map(|line| (*line, lines[*line].clone())).collect();
            ThreadMap::new(document, &layer.options, &lines, rules, size)
        });
        let threads: Vec<ThreadMap> = threads.collect();
        let of_periods = threads.iter().filter_map(|threads| threads.map().free());
        let mut notes: Vec<String> = of_periods.flat_map(FreeMap::remarks_on_periods).collect();
        let threads = varied(threads, document, index, size);
        let plan = Self::of_threads(kind, threads, canvas, rows);
        notes.extend(plan.notes);
        Ok(Self { over: layer.options.over, notes, ..plan })
    }

    /// The plan of threads that were drawn as lines.
    fn of_threads(
        kind: PairKind,
        mut threads: Vec<ThreadMap>,
        canvas: Bounds,
        rows: Option<&PairSet>,
    ) -> Self {
        let (nodes, mut notes) = (nodes(&threads, &canvas), Vec::new());
        let form = match kind {
            PairKind::Weave => PairForm::Weave(WeaveForm::new(&mut threads, &nodes, rows, &mut notes)),
            PairKind::Maze => {
                notes.extend(threads.iter().filter_map(maze::note));
                PairForm::Maze(MazeForm::default())
            }
            PairKind::Stripes | PairKind::Stucco => PairForm::Stripes,
        };
        Self::by_laws(form, threads, nodes, canvas, notes).corrected_by(rows)
    }

    /// The plan of blotches as wide as these `marks` of layer `index`.
    fn of_stucco(
        document: &Document,
        index: usize,
        marks: &[Mark],
        canvas: Bounds,
        rows: Option<&PairSet>,
    ) -> Self {
        let options = document.layers[index].options;
        let form = StuccoForm { decay: options.decay };
        let lines: Vec<(usize, Path)> = marks.iter().map(stucco::line).enumerate().collect();
        let options = LayerOptions { duty: DutyChoice::Given(form.duty()), ..options };
        let threads =
            ThreadMap::new(document, &options, &lines, PeriodRules::threads(form.duty()), canvas.size);
        let threads = varied(threads.into_iter().collect(), document, index, canvas.size);
        let nodes = nodes(&threads, &canvas);
        Self::by_laws(PairForm::Stucco(form), threads, nodes, canvas, Vec::new()).corrected_by(rows)
    }

    /// The plan before its grid is known, by the laws alone.
    fn by_laws(
        form: PairForm,
        threads: Vec<ThreadMap>,
        nodes: RegionGrid,
        canvas: Bounds,
        notes: Vec<String>,
    ) -> Self {
        let grid = Grid { size: [1, 1], cell: canvas.size, edges: canvas.edges };
        let learnt = vec![vec![1.0; nodes.len()]; threads.len()];
        let (obstacles, raised) = (Vec::new(), Vec::new());
        Self { grid, threads, nodes, learnt, obstacles, raised, notes, form, over: Over::Level }
    }

    /// This plan with the corrections of its laws that `rows` give, on the grid that its sizes need.
    fn corrected_by(mut self, rows: Option<&PairSet>) -> Self {
        if let Some(rows) = rows {
            self.learnt = learnt::factors(&self, rows);
        }
        let canvas = self.canvas();
        let sizes = self.sizes(&vec![1.0; self.threads.len()]);
        let least = sizes.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let cells = canvas.size.map(|side| (CELLS * side / least).round().max(1.0) as usize);
        self.grid = Grid {
            size: cells,
            cell: [0, 1].map(|axis| canvas.size[axis] / cells[axis] as f64),
            edges: canvas.edges,
        };
        self
    }

    /// The kind of pattern that it grows.
    #[must_use]
    pub fn kind(&self) -> PairKind {
        match self.form {
            PairForm::Weave(_) => PairKind::Weave,
            PairForm::Maze(_) => PairKind::Maze,
            PairForm::Stripes => PairKind::Stripes,
            PairForm::Stucco(_) => PairKind::Stucco,
        }
    }

    /// Whether its threads have several directions, and begin along lines.
    #[must_use]
    pub fn crosses(&self) -> bool {
        matches!(self.kind(), PairKind::Weave | PairKind::Maze)
    }

    /// px a cell.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        (self.grid.cell[0] * self.grid.cell[1]).sqrt()
    }

    /// The canvas, px.
    #[must_use]
    pub fn canvas(&self) -> Bounds {
        self.grid.bounds_px()
    }

    /// The direction that is asked for at a point, px, as the index of a thread; for a maze that of its piece.
    #[must_use]
    pub fn piece_at(&self, point: [f64; 2]) -> usize {
        let PairForm::Maze(MazeForm { pieces }) = &self.form else { return 0 };
        pieces.get(self.grid.cell_at(self.grid.to_cells(point))).map_or(0, |piece| usize::from(*piece))
    }

    /// The size of the pieces of a maze, px.
    #[must_use]
    pub fn length_of_pieces(&self) -> f64 {
        maze::length_of_pieces(&self.threads, self.canvas().size)
    }

    /// The mean width with which these threads grow if it differs from the one asked for: for a maze the nearest possible one.
    #[must_use]
    pub fn reached(&self, threads: &ThreadMap) -> f64 {
        match self.form {
            PairForm::Maze(_) => maze::reached(threads),
            PairForm::Weave(_) | PairForm::Stripes | PairForm::Stucco(_) => threads.mean().width,
        }
    }

    /// Whether marks of the layers beneath have taken this place, px.
    #[must_use]
    pub fn is_taken(&self, point: [f64; 2]) -> bool {
        self.obstacles.get(self.grid.cell_at(self.grid.to_cells(point))).copied().unwrap_or(false)
    }

    /// Whether threads are cut out of the grown field with the width that a map gives.
    fn is_cut(&self) -> bool {
        self.threads.iter().any(|threads| threads.mean_duty().is_some())
    }

    /// The threshold of each [shown](Self::shown) field at the edges of its threads.
    #[must_use]
    pub fn levels(&self) -> Vec<f32> {
        match &self.form {
            PairForm::Weave(_) if self.is_cut() => vec![1.0; self.threads.len()],
            PairForm::Maze(_) if self.is_cut() => vec![1.0],
            PairForm::Weave(weave) => weave.levels(),
            PairForm::Maze(_) => vec![maze::level()],
            PairForm::Stripes | PairForm::Stucco(_) => vec![1.0],
        }
    }

    /// The fields that show the grown pattern, from the `differences` of all pairs: for a weave these differences, for other
    /// systems a single field.
    #[must_use]
    pub fn shown(&self, differences: Vec<Field>) -> Vec<Field> {
        match (&self.form, self.threads.first()) {
            // The reaction of pair stripes has the threshold 0, and half of the cells are above it. So all stripes are cut to the
            // wanted width.
            (PairForm::Stripes, Some(threads)) => vec![self.cut(&differences[0], |_| threads)],
            (PairForm::Maze(_), _) if self.is_cut() => {
                let piece = |point| &self.threads[self.piece_at(point)];
                maze::shown(&differences).iter().map(|shown| self.cut(shown, piece)).collect()
            }
            (PairForm::Maze(_), _) => maze::shown(&differences),
            (PairForm::Stucco(stucco), _) => vec![stucco.shown(&differences[0])],
            (PairForm::Weave(_), _) if self.is_cut() => {
                let own = differences.iter().zip(&self.threads);
                own.map(|(difference, threads)| self.cut(difference, |_| threads)).collect()
            }
            _ => differences,
        }
    }

    /// A field scaled so that a cut at 1 gives its lines the width of the threads that are wanted at each point, px.
    fn cut<'a>(&self, field: &Field, threads: impl Fn([f64; 2]) -> &'a ThreadMap + Sync) -> Field {
        let duty = |cell: usize| {
            let point = self.grid.center_px(cell);
            threads(point).threads_at(point).duty()
        };
        cut_by_duty(field, duty, self.threads.first().and_then(ThreadMap::mean_duty))
    }

    /// The size s of each pair at each node, px, see [`Self::maps`].
    fn sizes(&self, factors: &[f64]) -> Vec<Vec<f64>> {
        let of_node = |index: usize| {
            let by_law =
                self.by_law(&threads_at(&self.threads, self.nodes.center(self.nodes.place(index))), factors);
            let learnt = self.learnt.iter().map(|of| of[index]);
            by_law.into_iter().zip(learnt).map(|(size, learnt)| learnt * size).collect::<Vec<f64>>()
        };
        let nodes: Vec<Vec<f64>> = (0..self.nodes.len()).into_par_iter().map(of_node).collect();
        (0..self.threads.len()).map(|pair| nodes.iter().map(|sizes| sizes[pair]).collect()).collect()
    }

    /// The size s that the law gives to the pair of each of these threads, px, see [`Self::maps`].
    #[must_use]
    pub fn by_law(&self, all: &[Threads], factors: &[f64]) -> Vec<f64> {
        let size = |(pair, threads): (usize, &Threads)| match &self.form {
            PairForm::Weave(weave) => weave.size(all, pair, factors[pair]),
            PairForm::Maze(_) => maze::size(threads),
            PairForm::Stripes => stripes::size(threads, factors[pair]),
            PairForm::Stucco(_) => stucco::size(threads),
        };
        all.iter().enumerate().map(size).collect()
    }

    /// The size s of each pair in the middle of the canvas, px.
    #[must_use]
    pub fn usual_sizes(&self) -> Vec<f64> {
        let middle = self.nodes.len() / 2;
        self.sizes(&vec![1.0; self.threads.len()]).iter().map(|sizes| sizes[middle]).collect()
    }

    /// Directions and sizes at each cell, by direction: for threads of a weave with `factors` times the wanted width, for pair
    /// stripes with `factors` times the wanted period.
    #[must_use]
    pub fn maps(&self, factors: &[f64]) -> PairParameterField {
        let sizes = self.sizes(factors);
        let of_all = sizes.iter().map(|sizes| range(sizes)[1]).fold(0.0, f64::max);
        let pairs = self.threads.iter().zip(&sizes).map(|(threads, sizes)| PairField {
            blurs: self.blurs(range(sizes)[1], of_all),
            ..self.field(threads, sizes)
        });
        PairParameterField {
            grid: self.grid,
            pairs: pairs.collect(),
            obstacles: self.obstacles.clone(),
            raised: self.raised.clone(),
        }
    }

    /// The form of the blurs of a pair whose largest size is `largest`; `of_all` is the largest size of all pairs.
    fn blurs(&self, largest: f64, of_all: f64) -> Blurs {
        match self.form {
            PairForm::Weave(_) => Blurs::Along(WeaveForm::elongation(largest, of_all)),
            PairForm::Maze(_) => Blurs::Along(maze::elongation(self.threads.len())),
            PairForm::Stripes => Blurs::Along(stripes::elongation()),
            PairForm::Stucco(_) => Blurs::Round,
        }
    }

    /// Updates of one morphogen in one cell in a growth for `time`, in 1/b; on one grid if it is `above` other layers.
    #[must_use]
    pub fn updates(&self, time: f64, above: bool) -> f64 {
        let sizes = self.sizes(&vec![1.0; self.threads.len()]);
        let ranges: Vec<[f64; 2]> = sizes.iter().map(|sizes| range(sizes)).collect();
        let of_all = ranges.iter().map(|range| range[1]).fold(0.0, f64::max);
        let of_pair = |range: &[f64; 2]| Sizes {
            range: range.map(|size| size / self.px_a_cell()),
            blurs: self.blurs(range[1], of_all),
        };
        let pairs: Vec<Sizes> = ranges.iter().map(of_pair).collect();
        updates(self.grid.cells() as f64, &pairs, f64::from(RATIO), time, above)
    }

    fn field(&self, threads: &ThreadMap, sizes: &[f64]) -> PairField {
        let cells = self.grid.cells();
        let in_cells = |size: f64| (size / self.px_a_cell()) as f32;
        let direction = |point: [f64; 2]| {
            let [c, s] = threads.double_angle_at(point);
            (0.5 * libm::atan2(s, c).to_degrees()) as f32
        };
        if self.nodes.len() == 1 && threads.is_even() {
            let angle = direction(self.nodes.center([0, 0]));
            return PairField::uniform(cells, angle, in_cells(sizes[0]), Blurs::Along(1.0));
        }
        let size = |point: [f64; 2]| {
            self.nodes.corners(point).iter().map(|(node, weight)| weight * sizes[*node]).sum::<f64>()
        };
        let (direction, size) = (0..cells)
            .into_par_iter()
            .map(|cell| {
                let point = self.grid.center_px(cell);
                (direction(point), in_cells(size(point)))
            })
            .unzip();
        PairField { direction, size, blurs: Blurs::Along(1.0) }
    }

    /// The reaction, for pairs of these `maps`.
    #[must_use]
    pub fn model(&self, maps: &PairParameterField) -> PairModel {
        match &self.form {
            PairForm::Weave(weave) => weave.model(maps),
            PairForm::Maze(_) => maze::model(),
            PairForm::Stripes => stripes::model(maps.least_size()),
            PairForm::Stucco(stucco) => stucco.model(maps),
        }
    }
}

/// The smallest and the largest of some sizes.
fn range(sizes: &[f64]) -> [f64; 2] {
    let fold = |from, pick: fn(f64, f64) -> f64| sizes.iter().copied().fold(from, pick);
    [fold(f64::INFINITY, f64::min), fold(0.0, f64::max)]
}

/// The reaction without its threshold.
fn base_model() -> PairModel {
    PairModel {
        combination: Reaction::Maximum,
        ratio: RATIO,
        threshold: Course::Constant(0.0),
        softness: 1.0,
        weights: [1.0; MOST_PAIRS],
        gain: Course::Constant(1.0),
    }
}

/// Threads varied by the maps of layer `index`. A direction that replaces the drawn one applies to the first threads; the others
/// keep their angle to these.
fn varied(threads: Vec<ThreadMap>, document: &Document, index: usize, size: [f64; 2]) -> Vec<ThreadMap> {
    let Some(by) = modulation(document, index, size) else { return threads };
    let first = threads.first().map_or(0.0, |threads| threads.mean().angle);
    let vary = |threads: ThreadMap| {
        let turned = threads.mean().angle - first;
        threads.varied(&by, turned)
    };
    threads.into_iter().map(vary).collect()
}

/// The threads of all directions that are grown at a point, px.
fn threads_at(threads: &[ThreadMap], point: [f64; 2]) -> Vec<Threads> {
    threads.iter().map(|threads| threads.grown_at(point)).collect()
}

/// The places at which threads are looked up: a single one if they are equal everywhere.
fn nodes(threads: &[ThreadMap], canvas: &Bounds) -> RegionGrid {
    let [width, height] = canvas.size;
    let even = threads.iter().all(|threads| threads.map().nodes().len() == 1 || threads.is_even());
    let side = |side: f64| (NODES as f64 * side / width.max(height)).ceil() as usize;
    let grid = if even { [1, 1] } else { [side(width), side(height)] };
    RegionGrid { size: canvas.size, grid, edges: canvas.edges }
}
