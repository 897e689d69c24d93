//! Growth as a value: begun from parameters, advanced, looked at.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::coefficients::Coefficients;
use super::diffusion::Diffusion;
use super::kinetics::Kinetics;
use super::maps::{Maps, Parameters};
use super::meinhardt_lines::{self, MeinhardtLines};
use super::meinhardt_spots::{self, MeinhardtSpots};
use super::meinhardt_stripes::{self, MeinhardtStripes};
use super::plane::{Grid, Plane};
use super::problem::Problem;
use super::selling::{MIN_STRETCH, Tensor};
use super::slide::{Slide, slid};
use super::turing_spots::{self, TuringSpots, UnevenTuringSpots};
use super::wavefront::{self, Instructions, Scratch, Tiling};
use super::{System, begin, explicit};
use crate::field::{Edges, Field};

/// dt·D·Σw that a step may not exceed. ½ is where it stops being monotone; 0.45 is what `facts.md` A found
/// free of noise with reactions on top.
const DIFFUSION_LIMIT: f32 = 0.45;

/// A pattern being grown.
#[derive(Clone, Debug)]
pub struct Growth {
    system: System,
    problem: Problem,
    cell: [f64; 2],
    chemicals: Chemicals,
    scratch: Scratch,
    /// Cells whose concentrations are those of other marks, not of this pattern's.
    masked: Vec<bool>,
    /// Normalised time that one step takes where the reactions are slowest.
    time_a_step: f64,
    steps: u64,
}

#[derive(Clone, Debug)]
enum Chemicals {
    Two(Box<[[Plane; 2]; 2]>),
    /// Two, and the decay of each cell.
    Three(Box<[[Plane; 3]; 2]>),
    Five(Box<[[Plane; 5]; 2]>),
}

impl Chemicals {
    fn count(&self) -> usize {
        match self {
            Self::Two(_) => 2,
            Self::Three(_) => 3,
            Self::Five(_) => 5,
        }
    }

    fn two(planes: [Plane; 2]) -> Self {
        Self::Two(Box::new([planes.clone(), planes]))
    }

    /// These two of Turing's with the decay that `maps` gives each cell.
    fn with_decay([a, b]: [Plane; 2], maps: &Maps, grid: Grid) -> Self {
        let mut decay = Plane::flat(grid, turing_spots::BETA);
        for (y, row) in maps.uneven.chunks_exact(maps.nx).enumerate() {
            let row: Vec<f32> = row.iter().map(|off| turing_spots::BETA + off).collect();
            decay.set_row(y, &row);
        }
        let planes = [a, b, decay];
        Self::Three(Box::new([planes.clone(), planes]))
    }

    fn five(planes: [Plane; 5]) -> Self {
        Self::Five(Box::new([planes.clone(), planes]))
    }
}

impl System {
    /// What tells the height of a mark's middle from the ratio, of Meinhardt's two chemicals.
    fn peak(self) -> fn(f32) -> f32 {
        if self == Self::MeinhardtLines { meinhardt_lines::peak } else { meinhardt_spots::peak }
    }
}

impl Growth {
    /// Lays out the grid, its coefficients and what the growth begins from.
    #[must_use]
    pub fn new(system: System, maps: &Maps, edges: Edges, seed: u64) -> Self {
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        let chemicals = match system {
            System::MeinhardtStripes => Chemicals::five(begin::stripes(maps, edges, &mut rng)),
            System::MeinhardtLines => Chemicals::two(begin::lines(maps, edges, &mut rng)),
            _ => Chemicals::two(begin::spots(system, maps, edges, &mut rng)),
        };
        Self::of(system, maps, edges, chemicals)
    }

    /// Goes on from saved `concentrations` (as [`Self::concentrations`] gives them) instead of a fresh start.
    ///
    /// `None` where their number or length does not fit the system and the grid.
    #[must_use]
    pub fn resumed(system: System, maps: &Maps, edges: Edges, concentrations: &[Vec<f32>]) -> Option<Self> {
        let planes: Vec<Plane> = concentrations
            .iter()
            .map(|cells| Plane::from_cells(Grid { nx: maps.nx, ny: maps.ny, edges }, cells))
            .collect::<Option<_>>()?;
        let chemicals = match system {
            System::MeinhardtStripes => Chemicals::five(planes.try_into().ok()?),
            _ => Chemicals::two(planes.try_into().ok()?),
        };
        Some(Self::of(system, maps, edges, chemicals))
    }

    fn of(system: System, maps: &Maps, edges: Edges, chemicals: Chemicals) -> Self {
        let chemicals = match chemicals {
            Chemicals::Two(two) if system == System::TuringSpots && !maps.uneven.is_empty() => {
                let [planes, _] = *two;
                Chemicals::with_decay(planes, maps, Grid { nx: maps.nx, ny: maps.ny, edges })
            }
            others => others,
        };
        let mut problem = problem(system, maps, edges);
        if !maps.taken.is_empty() {
            problem.freeze(&|cell: usize| maps.taken[cell]);
        }
        let time_a_step = f64::from(problem.slowest) * f64::from(system.decay());
        let scratch = Scratch::default();
        let masked = masked(system, maps, edges);
        Self { masked, system, problem, cell: maps.cell, chemicals, scratch, time_a_step, steps: 0 }
    }

    /// Leaves the cells that `frozen` names (`y · nx + x`) as they are from now on, while their neighbours still see
    /// them. Their concentrations must be such that the reaction stays finite.
    pub fn freeze(&mut self, frozen: impl Fn(usize) -> bool + Sync) {
        self.problem.freeze(&frozen);
    }

    /// Moves spots of the pattern that grows in `maps`.
    pub fn slide(&mut self, maps: &Maps, slides: &[Slide]) {
        let grid = self.problem.grid;
        let moved = |plane: &mut Plane| {
            let cells = slid(self.system, maps, grid.edges, &plane.cells(), slides);
            cells.chunks_exact(grid.nx).enumerate().for_each(|(y, row)| plane.set_row(y, row));
        };
        match &mut self.chemicals {
            Chemicals::Two(two) => two[0].iter_mut().for_each(moved),
            // β stays where it is.
            Chemicals::Three(three) => three[0][..2].iter_mut().for_each(moved),
            Chemicals::Five(five) => five[0].iter_mut().for_each(moved),
        }
    }

    /// Takes `steps` explicit steps.
    pub fn advance(&mut self, steps: u64) {
        let threads = rayon::current_num_threads();
        let tiling = Tiling::suited(&self.problem, self.chemicals.count(), threads);
        let instructions = Instructions::best();
        self.advance_as(steps, tiling, instructions);
    }

    /// The same, cut and vectorised as told: the same bits.
    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        let (problem, scratch) = (&self.problem, &mut self.scratch);
        let tiling = Tiling { levels: tiling.levels.max(1), ..tiling };
        for sweep in 0..steps.div_ceil(tiling.levels as u64) {
            let left = steps - sweep * tiling.levels as u64;
            let tiling = Tiling { levels: tiling.levels.min(left as usize), ..tiling };
            match (&mut self.chemicals, self.system) {
                (Chemicals::Two(two), System::TuringSpots) => {
                    sweep_and_swap::<2, TuringSpots>(problem, two, tiling, instructions, scratch);
                }
                (Chemicals::Two(two), System::MeinhardtLines) => {
                    sweep_and_swap::<2, MeinhardtLines>(problem, two, tiling, instructions, scratch);
                }
                (Chemicals::Two(two), _) => {
                    sweep_and_swap::<2, MeinhardtSpots>(problem, two, tiling, instructions, scratch);
                }
                (Chemicals::Three(three), _) => {
                    sweep_and_swap::<3, UnevenTuringSpots>(problem, three, tiling, instructions, scratch);
                }
                (Chemicals::Five(five), _) => {
                    sweep_and_swap::<5, MeinhardtStripes>(problem, five, tiling, instructions, scratch);
                }
            }
        }
        self.steps += steps;
    }

    /// The same with the plain solver, bit for bit, slowly: what the fast one is tested and measured against.
    pub fn advance_plain(&mut self, steps: u64) {
        for _ in 0..steps {
            match (&mut self.chemicals, self.system) {
                (Chemicals::Two(two), System::TuringSpots) => {
                    step_and_swap::<2, TuringSpots>(&self.problem, two);
                }
                (Chemicals::Two(two), System::MeinhardtLines) => {
                    step_and_swap::<2, MeinhardtLines>(&self.problem, two);
                }
                (Chemicals::Two(two), _) => step_and_swap::<2, MeinhardtSpots>(&self.problem, two),
                (Chemicals::Three(three), _) => step_and_swap::<3, UnevenTuringSpots>(&self.problem, three),
                (Chemicals::Five(five), _) => step_and_swap::<5, MeinhardtStripes>(&self.problem, five),
            }
        }
        self.steps += steps;
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps that make up `time` of normalised time (`facts.md` 0) where the reactions are slowest.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.time_a_step).ceil().max(1.0) as u64
    }

    /// Normalised time grown where the reactions are slowest.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.time_a_step
    }

    /// The concentration that shows the marks, high inside them: 0 about the ground, 1 about the middle of a
    /// mark that has the parameters there.
    #[must_use]
    pub fn marks(&self, maps: &Maps) -> Field {
        let nx = self.problem.grid.nx;
        let mut values = vec![0.0; nx * self.problem.grid.ny];
        values.par_chunks_mut(nx).enumerate().for_each(|(y, row)| match &self.chemicals {
            Chemicals::Two(two) if self.system == System::TuringSpots => {
                for (mark, a) in row.iter_mut().zip(two[0][0].row(y)) {
                    *mark = turing_spots::share(*a);
                }
            }
            Chemicals::Three(three) => {
                for (mark, a) in row.iter_mut().zip(three[0][0].row(y)) {
                    *mark = turing_spots::share(*a);
                }
            }
            Chemicals::Two(two) => {
                let peak_at = self.system.peak();
                let (mut ratio, mut peak) = (f32::NAN, 0.0);
                for ((mark, a), p) in row.iter_mut().zip(two[0][0].row(y)).zip(&maps.parameters[y * nx..]) {
                    // Mostly the same as beside it.
                    if p.ratio != ratio {
                        (ratio, peak) = (p.ratio, peak_at(p.ratio));
                    }
                    *mark = a / peak;
                }
            }
            Chemicals::Five(five) => {
                for ((mark, a), b) in row.iter_mut().zip(five[0][0].row(y)).zip(five[0][1].row(y)) {
                    *mark = a / (a + b);
                }
            }
        });
        for (value, masked) in values.iter_mut().zip(&self.masked) {
            if *masked {
                *value = 0.0;
            }
        }
        Field {
            width: self.problem.grid.nx,
            height: self.problem.grid.ny,
            cell: self.cell,
            edges: self.problem.grid.edges,
            values,
        }
    }

    /// The concentrations of each chemical, row by row; not the decay of uneven spots, which does not change.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        match &self.chemicals {
            Chemicals::Two(two) => two[0].iter().map(Plane::cells).collect(),
            Chemicals::Three(three) => three[0][..2].iter().map(Plane::cells).collect(),
            Chemicals::Five(five) => five[0].iter().map(Plane::cells).collect(),
        }
    }
}

/// Distance to taken cells ÷ spacing within which Turing's a is high only because it is held high there: half of where
/// its spots' edges are kept.
const RIM: f64 = 0.25;

/// Where the concentrations are those of the marks of other layers: on taken cells, and where Turing's a leaks out.
fn masked(system: System, maps: &Maps, edges: Edges) -> Vec<bool> {
    if system != System::TuringSpots {
        return maps.taken.clone();
    }
    let mut masked = maps.taken.clone();
    for cell in (0..maps.taken.len()).filter(|cell| maps.taken[*cell]) {
        let reach = (RIM * system.spacing(&maps.parameters[cell])).ceil() as isize;
        let (x, y) = ((cell % maps.nx) as isize, (cell / maps.nx) as isize);
        for (dy, dx) in (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dy, dx))) {
            if dx * dx + dy * dy <= reach * reach {
                masked[edges.index(y + dy, maps.ny) * maps.nx + edges.index(x + dx, maps.nx)] = true;
            }
        }
    }
    masked
}

fn step_and_swap<const N: usize, K: Kinetics<N>>(problem: &Problem, planes: &mut [[Plane; N]; 2]) {
    let [old, new] = planes;
    explicit::step::<N, K>(problem, old, new);
    planes.swap(0, 1);
}

fn sweep_and_swap<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    planes: &mut [[Plane; N]; 2],
    tiling: Tiling,
    instructions: Instructions,
    scratch: &mut Scratch,
) {
    let [old, new] = planes;
    wavefront::sweep::<N, K>(problem, old, new, tiling, instructions, scratch);
    planes.swap(0, 1);
}

/// Coefficients with the largest time step that is stable.
fn problem(system: System, maps: &Maps, edges: Edges) -> Problem {
    let tensor = |p: Parameters| {
        let stretch = f64::from(p.stretch.max(MIN_STRETCH));
        let [along, across] = match system {
            System::TuringSpots | System::MeinhardtSpots => [1.0 / stretch, stretch],
            System::MeinhardtStripes | System::MeinhardtLines => [1.0 / (stretch * stretch), 1.0],
        };
        Tensor::oriented(along, across, f64::from(p.direction)).on_cells(maps.cell)
    };
    let grid = Grid { nx: maps.nx, ny: maps.ny, edges };
    let at = |cell: usize| maps.parameters[cell];
    let diffusion = Diffusion::new(grid, at, tensor);
    let square = Tensor { xx: 1.0, xy: 0.0, yy: 1.0 }.on_cells(maps.cell);
    let isotropic = [square.xx as f32, square.yy as f32];
    let shares = |p: &Parameters| match system {
        System::TuringSpots => [turing_spots::RATIO.sqrt(), 1.0 / turing_spots::RATIO.sqrt()],
        System::MeinhardtSpots | System::MeinhardtLines => [1.0 / p.ratio.sqrt(), p.ratio.sqrt()],
        System::MeinhardtStripes => [1.0, meinhardt_stripes::RATIO],
    };
    let fastest = |p: &Parameters| {
        let [d0, d1] = shares(p);
        match system {
            System::MeinhardtStripes | System::MeinhardtLines => {
                (d0 * diffusion.largest).max(d1 * (isotropic[0] + isotropic[1]))
            }
            _ => d0.max(d1) * diffusion.largest,
        }
    };
    let of_all = |value: &(dyn Fn(&Parameters) -> f32 + Sync)| {
        maps.parameters.par_iter().map(value).reduce(|| 0.0, f32::max)
    };
    let by_diffusion = DIFFUSION_LIMIT / of_all(&fastest);
    let lowest = maps.parameters.par_iter().map(|p| p.rate).reduce(|| f32::INFINITY, f32::min);
    let scale = by_diffusion.min(system.reaction_limit() / of_all(&|p| p.rate));
    let mobility = Coefficients::new(grid, false, at, |p| shares(&p).map(|share| scale * share));
    let rate = Coefficients::new(grid, false, at, |p| [scale * p.rate]);
    Problem::new(grid, diffusion, isotropic, mobility, rate, scale * lowest)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// About 30 spots or 8 stripes on a small torus.
    fn small(system: System) -> (Maps, Growth) {
        let rate = match system {
            System::TuringSpots => 0.15,
            System::MeinhardtSpots => 2.0,
            System::MeinhardtLines => 6.0,
            System::MeinhardtStripes => 40.0,
        };
        let maps = Maps::uniform(
            90,
            84,
            Parameters { rate, ratio: 20.0, stretch: 0.6, direction: 30.0, pitch: 1.0 },
        );
        let growth = Growth::new(system, &maps, Edges::Wrap, 3);
        (maps, growth)
    }

    #[test]
    fn every_system_grows_its_pattern_from_a_seed() {
        for (system, cover) in [
            (System::TuringSpots, 0.10..0.45),
            (System::MeinhardtSpots, 0.05..0.12),
            (System::MeinhardtStripes, 0.45..0.55),
            (System::MeinhardtLines, 0.25..0.45),
        ] {
            let (maps, mut growth) = small(system);
            growth.advance(growth.steps_in(30.0));
            let marks = growth.marks(&maps).values;
            let share = marks.iter().filter(|v| **v > 0.5).count() as f64 / marks.len() as f64;
            let lowest = marks.iter().copied().fold(f32::INFINITY, f32::min);
            let highest = marks.iter().copied().fold(f32::NEG_INFINITY, f32::max);
            assert!(cover.contains(&share), "{system:?} covers {share}");
            // Where a line ends it is higher than along it.
            let ends = if system == System::MeinhardtLines { 1.3 } else { 1.15 };
            assert!((-0.1..0.15).contains(&lowest) && (0.85..ends).contains(&highest), "{lowest}..{highest}");
        }
    }

    #[test]
    fn a_grown_pattern_is_stationary() {
        for system in System::ALL {
            let (maps, mut growth) = small(system);
            growth.advance(growth.steps_in(60.0));
            let before = growth.marks(&maps).values;
            let mut again =
                Growth::resumed(system, &maps, Edges::Wrap, &growth.concentrations()).expect("fits");
            again.advance(again.steps_in(5.0));
            let after = again.marks(&maps).values;
            let moved: f32 = before.iter().zip(&after).map(|(b, a)| (b - a).abs()).sum();
            let total: f32 = before.iter().sum();
            assert!(moved < 0.02 * total, "{system:?} moved by {}", moved / total);
        }
    }

    #[test]
    fn resuming_goes_on_bit_for_bit() {
        for system in System::ALL {
            let (maps, mut growth) = small(system);
            growth.advance(40);
            let mut again =
                Growth::resumed(system, &maps, Edges::Wrap, &growth.concentrations()).expect("fits");
            growth.advance(25);
            again.advance(25);
            assert!(growth.concentrations() == again.concentrations(), "{system:?}");
        }
    }

    #[test]
    fn frozen_cells_stay_as_they_are_and_are_felt() {
        for system in System::ALL {
            let (_, mut growth) = small(system);
            growth.advance(50);
            let (before, mut free, mut plain) = (growth.concentrations(), growth.clone(), growth.clone());
            let frozen = |cell: usize| cell % 90 < 40 && cell / 90 > 20;
            growth.freeze(frozen);
            plain.freeze(frozen);
            growth.advance(30);
            plain.advance_plain(30);
            free.advance(30);
            assert!(growth.concentrations() == plain.concentrations(), "{system:?}");
            let beside = 90 * 50 + 40;
            for ((before, after), free) in
                before.iter().zip(growth.concentrations()).zip(free.concentrations())
            {
                for (cell, value) in before.iter().enumerate().filter(|(cell, _)| frozen(*cell)) {
                    assert_eq!(value.to_bits(), after[cell].to_bits(), "{system:?} {cell}");
                }
                assert!(before[beside] != after[beside] && free[beside] != after[beside], "{system:?}");
            }
        }
    }

    #[test]
    fn concentrations_of_another_grid_are_refused() {
        let (maps, growth) = small(System::TuringSpots);
        let mut concentrations = growth.concentrations();
        concentrations[0].pop();
        assert!(Growth::resumed(System::TuringSpots, &maps, Edges::Wrap, &concentrations).is_none());
        assert!(
            Growth::resumed(System::MeinhardtStripes, &maps, Edges::Wrap, &growth.concentrations()).is_none()
        );
    }

    #[test]
    fn the_number_of_threads_changes_no_bit() {
        let grown = |system: System, threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| {
                let p = Parameters { rate: 2.0, ratio: 15.0, stretch: 0.5, direction: 70.0, pitch: 1.0 };
                let maps = Maps::uniform(300, 260, p);
                let mut growth = Growth::new(system, &maps, Edges::Closed, 9);
                growth.advance(50);
                growth.concentrations()
            })
        };
        for system in [System::MeinhardtSpots, System::MeinhardtLines] {
            assert!(grown(system, 1) == grown(system, 4), "{system:?}");
        }
    }
}
