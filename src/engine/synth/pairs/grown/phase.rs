//! A phase whose crests are lines of given directions and distances, without ends or forks.
//!
//! ```text
//! Σ (φⱼ − φᵢ − kᵢⱼ·(xⱼ − xᵢ))² + Σ w (φᵢ − 2πn)² → least,  k = 2π/p · (−sin θ, cos θ)
//! ```
//!
//! The first sum is over neighbouring nodes: the gradient of φ approximates the wave vector of the lines with direction θ and
//! distance p. The second sum is over the nodes at drawn lines, each of which gets a crest of its own, number n. Solved by
//! conjugate gradients (Hestenes and Stiefel, "Methods of conjugate gradients for solving linear systems", 1952).
//!
//! If directions rotate once around a point, or if lines spread like rays at an even distance, no such phase exists: the result
//! then differs from the wanted directions and is refused.

use std::collections::BinaryHeap;
use std::f64::consts::TAU;
use std::ops::Range;

use rayon::prelude::*;

use crate::attributes::regions::RegionGrid;
use crate::grid::resample::Spline;
use crate::grid::{Bounds, Domain, Edges, Field, Grid};
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// Nodes along the longer side.
const NODES: f64 = 128.0;
/// w: the weight of a drawn line's crest, larger than that of the directions.
const HOLD: f64 = 1.0;
/// The conjugate gradients end where the residual is this share of the first one.
const RESIDUAL: f64 = 1e-7;
/// Square of a residual that counts as zero at a node, (10⁻⁵ radians)².
const LEAST: f64 = 1e-10;
/// Most steps of the conjugate gradients.
const STEPS: usize = 2_000;
/// Largest relative difference between the gradient of the phase and the wave vector, in the median of the nodes.
const OFF_MEDIAN: f64 = 0.12;
/// Largest relative difference at 95 % of the nodes.
const OFF_95: f64 = 0.4;
/// Largest root mean square distance of drawn lines from their crests, in periods.
const BESIDE: f64 = 0.12;

/// Largest number of neighbours with opposite wave vectors: those around the centre of rings. Where directions rotate by half a
/// turn around a point, a whole row of nodes has them.
const CENTRE: usize = 12;

/// The phase of the threads of one direction.
#[derive(Clone, Debug)]
pub struct ThreadPhase {
    /// The part that is not a plane wave.
    bent: Spline,
    /// The plane wave, radians a px.
    wave: [f64; 2],
    /// The canvas, px.
    size: [f64; 2],
    edges: Edges,
}

impl ThreadPhase {
    /// The phase of `threads` on the canvas; `None` if no phase has their directions and distances.
    #[must_use]
    pub fn new(threads: &ThreadMap, canvas: &Bounds) -> Option<Self> {
        let nodes = Nodes::new(threads, canvas)?;
        let wave = nodes.mean_wave();
        let links = nodes.links(wave);
        let free = solve(&nodes.grid, &links, &[]);
        let crests = nodes.crests(threads, &free, wave);
        let phase = solve(&nodes.grid, &links, &crests);
        let fits = nodes.fits(&phase, wave) && beside(&phase, &crests) <= BESIDE;
        let values = phase.iter().map(|phase| *phase as f32).collect();
        fits.then(|| Self {
            bent: Spline::new(&Field::new(&nodes.grid, values)),
            wave,
            size: canvas.size,
            edges: canvas.edges,
        })
    }

    /// Number of threads that cross the borders of a tile along x and y; `None` if edges are closed.
    #[must_use]
    pub fn periods_round_tile(&self) -> Option<[i64; 2]> {
        let periods = [0, 1].map(|axis| (self.wave[axis] * self.size[axis] / TAU).round() as i64);
        (self.edges == Edges::Wrap).then_some(periods)
    }

    /// The phase of rows `rows` at `width` × `height` px over the whole canvas, in periods.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let mut all = self.bent.rows(rows.clone(), width, height);
        let px = [self.size[0] / width as f64, self.size[1] / height as f64];
        all.par_chunks_mut(width.max(1)).zip(rows).for_each(|(line, y)| {
            let before = self.wave[1] * (y as f64 + 0.5) * px[1];
            for (x, value) in line.iter_mut().enumerate() {
                let plane = before + self.wave[0] * (x as f64 + 0.5) * px[0];
                *value = ((plane + f64::from(*value)) / TAU) as f32;
            }
        });
        all
    }

    /// The phase at a point, px, in periods: a whole number on a crest.
    #[must_use]
    pub fn periods_at(&self, point: [f64; 2]) -> f64 {
        let plane = self.wave[0] * point[0] + self.wave[1] * point[1];
        (plane + f64::from(self.bent.at(point))) / TAU
    }
}

/// Wave vectors at the nodes of a grid over the canvas, radians per px, all oriented to one side.
struct Nodes {
    grid: Grid,
    waves: Vec<[f64; 2]>,
}

/// The wanted difference of the phases of two neighbouring nodes, radians.
struct Link {
    from: usize,
    to: usize,
    difference: f64,
}

/// The phase wanted at a node on a drawn line, radians.
struct Crest {
    node: usize,
    phase: f64,
}

impl Nodes {
    /// `None` if the wave vectors cannot be oriented consistently.
    fn new(threads: &ThreadMap, canvas: &Bounds) -> Option<Self> {
        let longer = canvas.size[0].max(canvas.size[1]);
        let size = canvas.size.map(|side| ((NODES * side / longer).round() as usize).max(4));
        let layout = RegionGrid { size: canvas.size, grid: size, edges: canvas.edges };
        let grid = Grid {
            size,
            cell: [0, 1].map(|axis| canvas.size[axis] / size[axis] as f64),
            edges: canvas.edges,
        };
        let wave = |index: usize| {
            let point = layout.center(layout.place(index));
            let [c, s] = threads.double_angle_at(point);
            let angle = 0.5 * libm::atan2(s, c);
            let turn = TAU / threads.threads_at(point).period;
            [-libm::sin(angle) * turn, libm::cos(angle) * turn]
        };
        let mut waves: Vec<[f64; 2]> = (0..grid.cells()).map(wave).collect();
        orient(&grid, &mut waves).then_some(Self { grid, waves })
    }

    /// The mean wave vector; on a tile the nearest one with a whole number of periods.
    fn mean_wave(&self) -> [f64; 2] {
        [0, 1].map(|axis| {
            let mean = self.waves.iter().map(|wave| wave[axis]).sum::<f64>() / self.waves.len() as f64;
            match self.grid.edges {
                Edges::Closed => mean,
                Edges::Wrap => {
                    let unit = TAU / (self.grid.size[axis] as f64 * self.grid.cell[axis]);
                    (mean / unit).round() * unit
                }
            }
        })
    }

    /// The wanted differences of the part of the phase that is not the plane `wave`.
    fn links(&self, wave: [f64; 2]) -> Vec<Link> {
        let mut links = Vec::with_capacity(2 * self.waves.len());
        for from in 0..self.waves.len() {
            for (axis, step) in [[1, 0], [0, 1]].into_iter().enumerate() {
                let Some((to, _)) = self.grid.step(from, step) else { continue };
                if !same_side(self.waves[from], self.waves[to]) {
                    continue;
                }
                let mean = 0.5 * (self.waves[from][axis] + self.waves[to][axis]);
                links.push(Link { from, to, difference: (mean - wave[axis]) * self.grid.cell[axis] });
            }
        }
        links
    }

    /// The crests at the drawn lines, if these are kept: each line takes the crest that is nearest to it in a phase without the
    /// lines.
    fn crests(&self, threads: &ThreadMap, free: &[f64], wave: [f64; 2]) -> Vec<Crest> {
        if !threads.keeps_lines() {
            return Vec::new();
        }
        let plane = |point: [f64; 2]| wave[0] * point[0] + wave[1] * point[1];
        // A point of a line → the nearest node, and the free phase at the point.
        let at = |point: [f64; 2]| {
            let node = self.grid.cell_at(self.grid.to_cells(point));
            let center = self.grid.center_px(node);
            let own = self.waves[node];
            let apart = [0, 1].map(|axis| point[axis] - center[axis]);
            let rest = (own[0] - wave[0]) * apart[0] + (own[1] - wave[1]) * apart[1];
            (node, rest, plane(point) + free[node] + rest)
        };
        let bounds = self.grid.bounds_px();
        let spacing = self.grid.cell[0].max(self.grid.cell[1]);
        let lines = threads.lines.iter().map(|(_, line)| {
            let count = (line.length() / spacing).ceil().max(2.0) as usize;
            let points = line.samples(count).into_iter().map(|sample| sample.point);
            points.filter(|point| bounds.contains(*point)).collect::<Vec<_>>()
        });
        let lines: Vec<Vec<[f64; 2]>> = lines.collect();
        let (mut c, mut s) = (0.0, 0.0);
        for point in lines.iter().flatten() {
            c += libm::cos(at(*point).2);
            s += libm::sin(at(*point).2);
        }
        let offset = libm::atan2(s, c);
        let mut crests = Vec::new();
        for points in lines.iter().filter(|points| !points.is_empty()) {
            let mean = points.iter().map(|point| at(*point).2 - offset).sum::<f64>() / points.len() as f64;
            let number = (mean / TAU).round() * TAU;
            crests.extend(points.iter().map(|point| {
                let (node, rest, _) = at(*point);
                Crest { node, phase: number - plane(*point) - rest }
            }));
        }
        crests
    }

    /// Whether the gradient of the phase is close to the wave vectors.
    fn fits(&self, phase: &[f64], wave: [f64; 2]) -> bool {
        let off = |node: usize| {
            let mut off = 0.0;
            for (axis, step) in [[1, 0], [0, 1]].into_iter().enumerate() {
                let Some((next, _)) = self.grid.step(node, step) else { continue };
                let gradient = wave[axis] + (phase[next] - phase[node]) / self.grid.cell[axis];
                let wanted = 0.5 * (self.waves[node][axis] + self.waves[next][axis]);
                off += (gradient - wanted) * (gradient - wanted);
            }
            let [x, y] = self.waves[node];
            (off / (x * x + y * y)).sqrt()
        };
        let mut all: Vec<f64> = (0..self.waves.len()).map(off).collect();
        all.sort_by(f64::total_cmp);
        let share = |share: f64| all[((all.len() - 1) as f64 * share) as usize];
        share(0.5) <= OFF_MEDIAN && share(0.95) <= OFF_95
    }
}

fn same_side(a: [f64; 2], b: [f64; 2]) -> bool {
    a[0] * b[0] + a[1] * b[1] >= 0.0
}

/// Reverses wave vectors so that they agree with their neighbours, the most similar ones first. Returns whether all agree then,
/// except at the centre of rings.
fn orient(grid: &Grid, waves: &mut [[f64; 2]]) -> bool {
    const STEPS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    let mut known = vec![false; waves.len()];
    // By similarity, at most 1, in millionths; then by node.
    let mut next = BinaryHeap::from([(0, 0, 0)]);
    while let Some((_, node, from)) = next.pop() {
        if std::mem::replace(&mut known[node], true) {
            continue;
        }
        if !same_side(waves[from], waves[node]) {
            waves[node] = waves[node].map(|part| -part);
        }
        for (other, _) in STEPS.into_iter().filter_map(|step| grid.step(node, step)) {
            if !known[other] {
                next.push(((1e6 * cosine(waves[node], waves[other]).abs()) as u32, other, node));
            }
        }
    }
    let differ = |node: usize| {
        let others = STEPS[..2].iter().filter_map(|step| grid.step(node, *step));
        others.filter(|(other, _)| !same_side(waves[node], waves[*other])).count()
    };
    (0..waves.len()).map(differ).sum::<usize>() <= CENTRE
}

fn cosine(a: [f64; 2], b: [f64; 2]) -> f64 {
    let square = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    square(a, b) / (square(a, a) * square(b, b)).sqrt()
}

/// Root mean square distance of crests from the lines that they belong to, in periods.
fn beside(phase: &[f64], crests: &[Crest]) -> f64 {
    let squares = crests.iter().map(|crest| ((phase[crest.node] - crest.phase) / TAU).powi(2)).sum::<f64>();
    (squares / crests.len().max(1) as f64).sqrt()
}

/// The phases that satisfy the links and the crests best.
fn solve(grid: &Grid, links: &[Link], crests: &[Crest]) -> Vec<f64> {
    let cells = grid.cells();
    let apply = |x: &[f64]| {
        let mut sum = vec![0.0; cells];
        for link in links {
            let difference = x[link.to] - x[link.from];
            sum[link.to] += difference;
            sum[link.from] -= difference;
        }
        for crest in crests {
            sum[crest.node] += HOLD * x[crest.node];
        }
        sum
    };
    let mut residual = vec![0.0; cells];
    for link in links {
        residual[link.to] += link.difference;
        residual[link.from] -= link.difference;
    }
    for crest in crests {
        residual[crest.node] += HOLD * crest.phase;
    }
    if crests.is_empty() {
        // A phase is known up to a constant: without the constant part of the rounding errors, the errors stay small.
        let mean = residual.iter().sum::<f64>() / cells as f64;
        residual.iter_mut().for_each(|residual| *residual -= mean);
    }
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut phase = vec![0.0; cells];
    let mut way = residual.clone();
    let first = dot(&residual, &residual);
    let mut square = first;
    let least = (RESIDUAL * RESIDUAL * first).max(LEAST * cells as f64);
    for _ in 0..STEPS {
        if square <= least {
            break;
        }
        let applied = apply(&way);
        let share = square / dot(&way, &applied);
        for cell in 0..cells {
            phase[cell] += share * way[cell];
            residual[cell] -= share * applied[cell];
        }
        let next = dot(&residual, &residual);
        let kept = next / square;
        square = next;
        way.iter_mut().zip(&residual).for_each(|(way, residual)| *way = residual + kept * *way);
    }
    phase
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::periods::PeriodRules;
    use crate::document::{Document, LayerOptions};
    use crate::marks::Path;

    const CANVAS: Bounds = Bounds { size: [400.0, 300.0], edges: Edges::Closed };

    fn threads(lines: Vec<Vec<[f64; 2]>>, edges: Edges) -> ThreadMap {
        let document = Document { size: [400, 300], edges, ..Document::default() };
        let path = |points| Path { points, width: 8.0 };
        let lines: Vec<(usize, Path)> = lines.into_iter().map(path).enumerate().collect();
        ThreadMap::new(&document, &LayerOptions::default(), &lines, PeriodRules::threads(0.28), CANVAS.size)
            .expect("lines")
    }

    /// Largest distance of each line from a crest, in periods.
    fn off(phase: &ThreadPhase, threads: &ThreadMap) -> Vec<f64> {
        let of_point = |point| {
            let periods = phase.periods_at(point);
            (periods - periods.round()).abs()
        };
        let of_line = |line: &Path| line.samples(40).iter().map(|s| of_point(s.point)).fold(0.0, f64::max);
        threads.lines.iter().map(|(_, line)| of_line(line)).collect()
    }

    #[test]
    fn crests_run_through_wavy_lines_and_rings() {
        let wave = |y: f64| -> Vec<[f64; 2]> {
            (0..=36).map(|i| 20.0 + 10.0 * f64::from(i)).map(|x| [x, y + 20.0 * (x / 80.0).sin()]).collect()
        };
        let ring = |radius: f64| -> Vec<[f64; 2]> {
            let at = |i: i32| TAU * f64::from(i) / 48.0;
            (0..=48).map(|i| [200.0 + radius * at(i).cos(), 150.0 + radius * at(i).sin()]).collect()
        };
        let steep = |y: f64| -> Vec<[f64; 2]> {
            (0..=36).map(|i| 20.0 + 10.0 * f64::from(i)).map(|x| [x, y + 30.0 * (x / 80.0).sin()]).collect()
        };
        for lines in
            [[100.0, 128.0, 156.0].map(steep), [100.0, 128.0, 156.0].map(wave), [60.0, 90.0, 120.0].map(ring)]
        {
            let threads = threads(lines.to_vec(), Edges::Closed);
            let phase = ThreadPhase::new(&threads, &CANVAS).expect("a phase");
            let off = off(&phase, &threads);
            assert!(off.iter().all(|off| *off < 0.1), "{off:?}");
        }
    }

    #[test]
    fn straight_lines_have_an_even_phase_that_closes_on_a_tile() {
        let lines = vec![vec![[50.0, 100.0], [350.0, 130.0]], vec![[50.0, 126.0], [350.0, 156.0]]];
        let straight = threads(lines.clone(), Edges::Closed);
        let phase = ThreadPhase::new(&straight, &CANVAS).expect("a phase");
        let period = straight.threads_at([0.0; 2]).period;
        let across = [-(0.1f64.atan().sin()), 0.1f64.atan().cos()];
        for at in [[30.0, 40.0], [300.0, 200.0]] {
            let next = [at[0] + period * across[0], at[1] + period * across[1]];
            let periods = phase.periods_at(next) - phase.periods_at(at);
            assert!((periods.abs() - 1.0).abs() < 0.01, "{periods}");
        }
        let tile = threads(lines, Edges::Wrap);
        let phase = ThreadPhase::new(&tile, &Bounds { edges: Edges::Wrap, ..CANVAS }).expect("a phase");
        for at in [[0.0, 77.0], [0.0, 200.0]] {
            let periods = phase.periods_at([400.0, at[1]]) - phase.periods_at(at);
            assert!((periods - periods.round()).abs() < 1e-3, "{periods}");
        }
    }

    #[test]
    fn rays_at_an_even_distance_have_no_phase() {
        let ray = |i: i32| {
            let angle = TAU * f64::from(i) / 12.0;
            [40.0, 130.0].map(|radius| [200.0 + radius * angle.cos(), 150.0 + radius * angle.sin()]).to_vec()
        };
        assert!(ThreadPhase::new(&threads((0..12).map(ray).collect(), Edges::Closed), &CANVAS).is_none());
    }
}
