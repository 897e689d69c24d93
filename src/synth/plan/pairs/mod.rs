//! Plans of layers that systems of pairs grow.

pub mod thread_map;

use rayon::prelude::*;

use crate::attributes::direction_groups::{direction_groups, directions_of};
use crate::attributes::regions::RegionGrid;
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{Document, DocumentError, Kind, LayerOptions, Problem};
use crate::grid::{Bounds, Domain, Field, Grid};
use crate::marks::{Mark, Path};
use crate::rd::pairs::{
    Blurs, Combination as Reaction, Course, MOST_PAIRS, PairField, PairKind, PairMaps, PairModel, Threads,
};
use crate::synth::plan::sketch_targets::marks;
use thread_map::ThreadMap;

/// Cells of the smallest size s: of fewer than 1.5, edges stick to the grid (`facts.md` T).
const CELLS: f64 = 1.75;
/// d: 1.5 gives clean lines (`facts.md` H).
const RATIO: f32 = 1.5;
/// e of the pair of a weave with the largest size: with 2, three directions merged to pebbles (`facts.md` H). The blurs of the others are as long,
/// up to the second e.
const ELONGATIONS: [f64; 2] = [3.0, 8.0];
/// e of the pairs of a maze, of two directions and of more: with 2 three directions are twisted, and with 3 two make long pieces that
/// their neighbours turn (`facts.md` H).
const MAZE_ELONGATIONS: [f32; 2] = [2.0, 3.0];
/// Distance of the lines of a maze ÷ Λ: lines of one direction, from noise, are .935 Λ apart (`facts.md` H).
const MAZE_PERIOD: f64 = 0.935;
/// w/K₀ of a maze: softer steps let pieces of one direction grow at the cost of others.
const MAZE_SOFTNESS: f32 = 0.02;
/// By how much max Dᵢ + min Dᵢ of a maze is raised, in K₀: in the middle of the ground it is about −0.5 K₀.
const MAZE_RAISED: f32 = 0.5;
/// Nodes along the longer side at which sizes are looked up where they vary: widths and periods change slowly.
const NODES: usize = 16;
/// Highest θ/K₀ of two directions, near 0.25 threads were lost, and of more, where they died at 0.2 (`facts.md` T).
const HIGHEST: [f64; 2] = [0.2, 0.12];
/// θ/K₀ of threads for which none is found.
const LOWEST: f64 = 0.03;
/// The share that three and more directions leave free, at least: at .33 threads were a tenth too wide and gaps became round, at .44
/// widths were right within two hundredths.
const LEAST_FREE: f64 = 0.4;
/// The periods of threads that cover too much are widened in these steps, up to this factor.
const WIDENED: [f64; 2] = [1.04, 4.0];

/// A weave or a maze that is ready to grow.
#[derive(Clone, Debug)]
pub struct PairPlan {
    /// What it grows.
    pub kind: PairKind,
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// What is wanted of each direction.
    pub threads: Vec<ThreadMap>,
    /// θ/K₀ of each direction.
    pub thresholds: Vec<f64>,
    /// Places at which sizes are known, by their centres.
    nodes: RegionGrid,
    /// Cells that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
    /// By how much the threshold is raised at each cell, in K₀; empty = nowhere.
    pub raised: Vec<f32>,
    /// Of a maze, the direction that each cell is to have, by its number among `threads`; empty until it is laid out.
    pub pieces: Vec<u8>,
    /// What the user should know.
    pub notes: Vec<String>,
}

impl PairPlan {
    /// Reads layer `index` of a document named `source`, on a canvas of `size` px.
    ///
    /// # Errors
    /// Its marks are no lines, its lines have one direction or more than [`MOST_PAIRS`], or a rule of layers is broken: file, place,
    /// what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        size: [f64; 2],
    ) -> Result<Self, DocumentError> {
        let kind = document.pairs(index).unwrap_or(PairKind::Weave);
        let marks = marks(document, index, source)?;
        let below = if index == 0 { Beneath::Nothing } else { Beneath::Unknown };
        let combination = Combination::new(&document.layers[index], Some(Kind::Line), below);
        if let Some(problem) = combination.problem(&format!("layers[{index}]")) {
            return Err(problem.in_file(source));
        }
        let lines: Vec<Path> = marks.iter().filter_map(Mark::path).collect();
        let own = Bounds { size: document.size.map(f64::from), edges: document.edges };
        let groups = match kind {
            PairKind::Weave => direction_groups(&lines, &own),
            PairKind::Maze => directions_of(&lines),
        };
        if !(2..=MOST_PAIRS).contains(&groups.len()) {
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
        let options = &document.layers[index].options;
        let threads = groups.iter().filter_map(|group| {
            let lines: Vec<(usize, Path)> = group.iter().map(|line| (*line, lines[*line].clone())).collect();
            let alone = match kind {
                PairKind::Weave => thread_map::OWN_DUTY[usize::from(groups.len() > 2)],
                PairKind::Maze => LayerOptions::DUTY,
            };
            ThreadMap::new(document, options, &lines, alone, size)
        });
        let canvas = Bounds { size, edges: document.edges };
        Ok(match kind {
            PairKind::Weave => Self::of_weave(threads.collect(), canvas),
            PairKind::Maze => Self::of_maze(threads.collect(), canvas),
        })
    }

    /// The plan of a maze with lines like these threads.
    fn of_maze(threads: Vec<ThreadMap>, canvas: Bounds) -> Self {
        let nodes = nodes(&threads, &canvas);
        let thresholds = vec![0.0; threads.len()];
        Self::on_grid(PairKind::Maze, threads, thresholds, nodes, canvas, Vec::new())
    }

    /// The plan of a weave of these threads: how far apart they can be, the threshold and the grid.
    fn of_weave(mut threads: Vec<ThreadMap>, canvas: Bounds) -> Self {
        let nodes = nodes(&threads, &canvas);
        let (mut widened, mut notes) = (1.0, Vec::new());
        let found = loop {
            if let Some(found) = thresholds(&nodes, &threads) {
                break found;
            }
            widened *= WIDENED[0];
            threads.iter_mut().for_each(|threads| threads.widened = widened);
            if widened > WIDENED[1] {
                break vec![LOWEST; threads.len()];
            }
        };
        if widened > 1.0 {
            let covered: f64 = threads.iter().map(|threads| threads.mean().duty() * widened).sum();
            notes.push(format!(
                "threads that cover {:.0} % of the canvas together leave no gaps: they are {widened:.2} times as far apart as drawn",
                100.0 * covered
            ));
        }
        Self::on_grid(PairKind::Weave, threads, found, nodes, canvas, notes)
    }

    /// The plan on the grid that its sizes need.
    fn on_grid(
        kind: PairKind,
        threads: Vec<ThreadMap>,
        thresholds: Vec<f64>,
        nodes: RegionGrid,
        canvas: Bounds,
        notes: Vec<String>,
    ) -> Self {
        let unit = Grid { size: [1, 1], cell: canvas.size, edges: canvas.edges };
        let mut plan = Self {
            kind,
            grid: unit,
            threads,
            thresholds,
            nodes,
            obstacles: Vec::new(),
            raised: Vec::new(),
            pieces: Vec::new(),
            notes,
        };
        let widths = vec![1.0; plan.threads.len()];
        let sizes = plan.sizes(&widths);
        let least = sizes.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let cells = canvas.size.map(|side| (CELLS * side / least).round().max(1.0) as usize);
        plan.grid = Grid {
            size: cells,
            cell: [0, 1].map(|axis| canvas.size[axis] / cells[axis] as f64),
            edges: canvas.edges,
        };
        plan
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

    /// The direction that a maze is to have at a point, px, by its number among the threads.
    #[must_use]
    pub fn piece_at(&self, point: [f64; 2]) -> usize {
        self.pieces.get(self.grid.cell_at(self.grid.to_cells(point))).map_or(0, |piece| usize::from(*piece))
    }

    /// Have marks of the layers beneath taken this place, px?
    #[must_use]
    pub fn is_taken(&self, point: [f64; 2]) -> bool {
        self.obstacles.get(self.grid.cell_at(self.grid.to_cells(point))).copied().unwrap_or(false)
    }

    /// The level of each [shown](Self::shown) field at which the edges of its threads lie.
    #[must_use]
    pub fn levels(&self) -> Vec<f32> {
        match self.kind {
            PairKind::Weave => {
                self.thresholds.iter().map(|threshold| *threshold as f32 * base_model().peak_gain()).collect()
            }
            PairKind::Maze => vec![MAZE_RAISED * base_model().peak_gain()],
        }
    }

    /// The fields that show what has grown: of a weave the `differences` of all pairs; of a maze max Dᵢ + min Dᵢ, whose sign is that
    /// of the reaction's X, raised so that the ground is 0.
    #[must_use]
    pub fn shown(&self, differences: Vec<Field>) -> Vec<Field> {
        if self.kind == PairKind::Weave {
            return differences;
        }
        let Some((first, others)) = differences.split_first() else { return differences };
        let raised = MAZE_RAISED * base_model().peak_gain();
        let value = |(cell, first): (usize, &f32)| {
            let all = others.iter().map(|other| other.values[cell]);
            let [low, high] = all.fold([*first; 2], |[low, high], value| [low.min(value), high.max(value)]);
            (low + high + raised).max(0.0)
        };
        vec![Field { values: first.values.iter().enumerate().map(value).collect(), ..first.clone() }]
    }

    /// The size s of each pair at each node, px, for threads `widths` times as wide as they are wanted.
    fn sizes(&self, widths: &[f64]) -> Vec<Vec<f64>> {
        let of_node = |index: usize| {
            let all = threads_at(&self.threads, self.nodes.center(self.nodes.place(index)));
            let size = |(pair, threads): (usize, &Threads)| {
                if self.kind == PairKind::Maze {
                    return threads.period / (MAZE_PERIOD * base_model().wavelength());
                }
                let asked = Threads { width: threads.width * widths[pair], ..*threads };
                let fits = asked.size(&base_model(), self.thresholds[pair], uncovered(&all, pair));
                // Threads that keep no width at this threshold: the size at which their period has the largest gain.
                fits.unwrap_or(threads.period / base_model().wavelength())
            };
            all.iter().enumerate().map(size).collect::<Vec<f64>>()
        };
        let nodes: Vec<Vec<f64>> = (0..self.nodes.len()).into_par_iter().map(of_node).collect();
        (0..self.threads.len()).map(|pair| nodes.iter().map(|sizes| sizes[pair]).collect()).collect()
    }

    /// Directions and sizes at each cell, for threads `widths` times as wide as they are wanted, by direction.
    #[must_use]
    pub fn maps(&self, widths: &[f64]) -> PairMaps {
        let sizes = self.sizes(widths);
        let longest = sizes.iter().flatten().copied().fold(0.0, f64::max) * ELONGATIONS[0];
        let pairs = self.threads.iter().zip(&sizes).map(|(threads, sizes)| {
            let largest = sizes.iter().copied().fold(0.0, f64::max);
            let elongation = match self.kind {
                PairKind::Weave => (longest / largest).clamp(ELONGATIONS[0], ELONGATIONS[1]) as f32,
                PairKind::Maze => MAZE_ELONGATIONS[usize::from(self.threads.len() > 2)],
            };
            PairField { blurs: Blurs::Along(elongation), ..self.field(threads, sizes) }
        });
        PairMaps {
            grid: self.grid,
            pairs: pairs.collect(),
            obstacles: self.obstacles.clone(),
            raised: self.raised.clone(),
        }
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
    pub fn model(&self, maps: &PairMaps) -> PairModel {
        if self.kind == PairKind::Maze {
            let combination = Reaction::DifferenceOfAbsolutes;
            return PairModel { combination, softness: MAZE_SOFTNESS, ..base_model() };
        }
        let sizes = maps.pairs.iter().flat_map(|pair| &pair.size);
        let least = sizes.copied().fold(f32::INFINITY, f32::min);
        let highest = self.thresholds.iter().copied().fold(LOWEST, f64::max);
        let threshold = highest as f32;
        let mut weights = [1.0; MOST_PAIRS];
        for (weight, own) in weights.iter_mut().zip(&self.thresholds) {
            *weight = (highest / own) as f32;
        }
        PairModel {
            threshold: Course::Constant(threshold),
            softness: PairModel::softness_for(least, threshold),
            weights,
            ..base_model()
        }
    }
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

/// The threads of all directions at a point, px.
fn threads_at(threads: &[ThreadMap], point: [f64; 2]) -> Vec<Threads> {
    threads.iter().map(|threads| threads.threads_at(point)).collect()
}

/// The share of thread `pair` that the others leave free.
fn uncovered(all: &[Threads], pair: usize) -> f64 {
    let others = all.iter().enumerate().filter(|(other, _)| *other != pair);
    others.map(|(_, threads)| 1.0 - threads.duty()).product()
}

/// The places at which threads are looked up: one where all are even.
fn nodes(threads: &[ThreadMap], canvas: &Bounds) -> RegionGrid {
    let [width, height] = canvas.size;
    let even = threads.iter().all(|threads| threads.map().nodes().len() == 1 || threads.is_even());
    let side = |side: f64| (NODES as f64 * side / width.max(height)).ceil() as usize;
    let grid = if even { [1, 1] } else { [side(width), side(height)] };
    RegionGrid { size: canvas.size, grid, edges: canvas.edges }
}

/// The highest threshold θ/K₀ of each direction that suits its threads at every node; `None` where there is none.
fn thresholds(nodes: &RegionGrid, threads: &[ThreadMap]) -> Option<Vec<f64>> {
    let of_node = |index: usize| {
        let all = threads_at(threads, nodes.center(nodes.place(index)));
        let free: f64 = all.iter().map(|threads| 1.0 - threads.duty()).product();
        if all.len() > 2 && free < LEAST_FREE {
            return None;
        }
        let most = HIGHEST[usize::from(all.len() > 2)];
        let own = |(pair, threads): (usize, &Threads)| {
            let (threshold, _) = threads.threshold(&base_model(), uncovered(&all, pair), most)?;
            Some(threshold)
        };
        all.iter().enumerate().map(own).collect::<Option<Vec<f64>>>()
    };
    let all: Option<Vec<Vec<f64>>> = (0..nodes.len()).into_par_iter().map(of_node).collect();
    let all = all?;
    let lowest = |pair: usize| all.iter().map(|node| node[pair]).fold(f64::INFINITY, f64::min);
    Some((0..threads.len()).map(lowest).collect())
}
