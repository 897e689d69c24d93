//! Initial conditions of a growth: places that do not depend on the grid.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::attributes::Polarity;
use crate::grid::{Domain, Space};
use crate::rd::bells::{bell_reach, bells};
use crate::rd::definition::{Begin, System};
use crate::rd::line_noise::GuideLine;
use crate::rd::nuclei::{
    LaidAmong, LaidBefore, LaidSpots, PinnedSpot, Places, ROUNDS, density_of, lay, lay_among, thinned,
};
use crate::rd::nucleus::Nucleus;
use crate::rd::oriented_waves::{GuideSegment, wave_values};
use crate::rd::parameter_field::{ParameterField, Parameters};
use crate::rd::seeding::{Seeding, segments};
use crate::rd::start::{Start, by_cell};

/// The starting places of the spots of this growth, in cells, the `pinned` ones first. Without pinned ones these are the places of
/// [`crate::rd::Growth::new`]. Empty for stripes and lines.
#[must_use]
pub fn nuclei<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    seed: u64,
    pinned: &[PinnedSpot<D::Place>],
) -> Places<D::Place> {
    nuclei_after(system, maps, seed, pinned, |_| ROUNDS)
}

/// The places of [`nuclei`] after `rounds(n)` rounds of relaxation for n spots. With fewer rounds than usual the places are less
/// even, to save time before a call of [`crate::rd::relax_places`].
#[must_use]
pub fn nuclei_after<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    seed: u64,
    pinned: &[PinnedSpot<D::Place>],
    rounds: fn(usize) -> usize,
) -> Places<D::Place> {
    let fixed: Vec<Nucleus<D::Place>> =
        pinned.iter().map(|pinned| pinned.nucleus(system, &maps.domain)).collect();
    let Some(LaidSpots { inside, beyond }) = laid(system, maps, seed, &fixed, rounds) else {
        return Places::default();
    };
    let at = |laid: Vec<Nucleus<D::Place>>| laid.iter().map(|nucleus| nucleus.at).collect();
    Places { inside: at(inside), beyond: at(beyond), pinned: pinned.len() }
}

/// Places of spots that were laid without pinned ones, cells.
#[derive(Clone, Debug)]
pub struct NucleiBefore<P = [f64; 2]> {
    /// Nuclei that stay where they are, on the domain and beyond its closed edges. There must be at least one.
    pub kept: [Vec<P>; 2],
    /// Nuclei that give way to pinned ones, on the domain or beyond its edges.
    pub near: Vec<P>,
    /// By cell, whether the nuclei `near` may lie there.
    pub open: Vec<bool>,
    /// The parameters, equal everywhere, of the layout without pinned ones.
    pub parameters: Parameters,
}

/// The starting places of spots around `pinned` ones and among spots that were laid `before`, without obstacles: the pinned ones
/// first, then the kept ones, which do not move, then others on the open cells. The others have their indices in `near`; `None` for
/// new ones.
#[must_use]
pub fn nuclei_among<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    seed: u64,
    pinned: &[PinnedSpot<D::Place>],
    before: &NucleiBefore<D::Place>,
) -> (Places<D::Place>, Vec<Option<usize>>) {
    let pitch = |p: &Parameters| system.spacing(p);
    let pinned: Vec<Nucleus<D::Place>> =
        pinned.iter().map(|pinned| pinned.nucleus(system, &maps.domain)).collect();
    let laid_in = system.spacing(&before.parameters);
    let stays = |at: &D::Place| {
        Nucleus::new(&before.parameters, &maps.domain, maps.domain.cell_at(*at), *at, laid_in)
    };
    let laid = LaidBefore {
        kept: before.kept.each_ref().map(|kept| kept.iter().map(stays).collect()),
        near: before.near.iter().map(|at| Nucleus::at(maps, *at, &pitch)).collect(),
        density: density_of(laid_in),
        open: &before.open,
    };
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let near = lay_among(maps, &pitch, &pinned, &laid, &mut rng);
    let [inside, beyond] = before.kept.clone();
    let all = pinned.iter().map(|nucleus| nucleus.at).chain(inside).collect::<Vec<_>>();
    let mut places = Places { pinned: all.len(), inside: all, beyond };
    let space = maps.domain.space(0.0);
    let mut from = Vec::new();
    for LaidAmong { was, point } in near {
        if space.is_inside(point.at) {
            places.inside.push(point.at);
            from.push(was);
        } else {
            places.beyond.push(point.at);
        }
    }
    (places, from)
}

/// Spots over the domain around those that are `fixed`; `None` for stripes and lines.
fn laid<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    seed: u64,
    fixed: &[Nucleus<D::Place>],
    rounds: fn(usize) -> usize,
) -> Option<LaidSpots<D::Place>> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    (!system.is_striped()).then(|| lay(maps, &|p| system.spacing(p), fixed, rounds, &mut rng))
}

/// The concentrations at the start of [`crate::rd::Growth::new`].
pub fn fresh(system: System, maps: &ParameterField, seed: u64) -> Vec<Vec<f32>> {
    match system.definition().begin {
        Begin::Bells { .. } => {
            let nuclei = laid(system, maps, seed, &[], |_| ROUNDS).map_or_else(Vec::new, |laid| laid.inside);
            from_nuclei(system, maps, &nuclei)
        }
        Begin::Waves { on_grid: begin, .. } => {
            let (seeding, polarity) = (Seeding::Noise, Polarity::Positive);
            begin(&Start { seed, lines: &[], curves: None, seeding, polarity }, maps)
        }
    }
}

/// The concentrations of spots that begin at these places, one vector a chemical; none for stripes and lines.
///
/// Where marks are smaller than the cells can show (`lost`, by cell), `maps` holds larger ones, and only as many spots begin as
/// have room. Neighbours may vanish there.
#[must_use]
pub fn from_places<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    places: &[D::Place],
    lost: &dyn Fn(usize) -> bool,
) -> Vec<Vec<f32>> {
    let pitch = |p: &Parameters| system.spacing(p);
    let laid = places.iter().map(|at| Nucleus::at(maps, *at, &pitch)).collect();
    let nuclei = thinned(laid, maps, &|nucleus| lost(nucleus.cell));
    with_obstacle_state(system, maps, from_nuclei(system, maps, &nuclei))
}

/// Concentrations with a bell on each nucleus; none for stripes and lines.
fn from_nuclei<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    nuclei: &[Nucleus<D::Place>],
) -> Vec<Vec<f32>> {
    match system.definition().begin {
        Begin::Bells { radius, fill } => {
            by_cell(maps, system.chemicals().len(), &bells(maps, nuclei, &radius), fill)
        }
        Begin::Waves { .. } => Vec::new(),
    }
}

/// The initial waves of stripes on any domain, by cell, for [`from_wave_values`]. They follow the `guides`. `None` of spots, and
/// of systems that grow on grids alone.
#[must_use]
pub fn initial_waves<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    seed: u64,
    guides: &[GuideSegment<D::Place>],
) -> Option<Vec<f32>> {
    let Begin::Waves { on_any: Some(start), .. } = &system.definition().begin else { return None };
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    Some(wave_values(maps, &|p| system.spacing(p), start, guides, &mut rng))
}

/// The concentrations of stripes that begin from these values of [`initial_waves`], or of [`crate::rd::waves_from`], one vector a
/// chemical. `None` where that does.
#[must_use]
pub fn from_wave_values<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    values: &[f32],
) -> Option<Vec<Vec<f32>>> {
    let Begin::Waves { on_any: Some(start), .. } = &system.definition().begin else { return None };
    let concentrations = by_cell(maps, system.chemicals().len(), values, start.fill);
    Some(with_obstacle_state(system, maps, concentrations))
}

/// What a growth begins from, for any grid over its canvas: spots at the same places, stripes from the same waves.
#[derive(Clone, Debug)]
pub struct InitialConditions {
    system: System,
    seed: u64,
    /// Starting places of spots, as shares of the canvas' sides.
    places: Vec<[f64; 2]>,
    /// Lines along which stripes run.
    lines: Vec<GuideLine>,
    seeding: Seeding,
    /// Whether the stripes along `lines` are the marks, or the gaps between the marks.
    polarity: Polarity,
}

impl InitialConditions {
    /// The initial conditions of [`crate::rd::Growth::new`].
    #[must_use]
    pub fn new(system: System, maps: &ParameterField, seed: u64) -> Self {
        Self::at_places(system, maps, seed, &nuclei(system, maps, seed, &[]).inside)
    }

    /// Initial conditions of spots at these `places`, cells of `maps`.
    #[must_use]
    pub fn at_places(system: System, maps: &ParameterField, seed: u64, places: &[[f64; 2]]) -> Self {
        Self {
            system,
            seed,
            places: Vec::new(),
            lines: Vec::new(),
            seeding: Seeding::Noise,
            polarity: Polarity::Positive,
        }
        .with_places(maps, places)
    }

    /// These initial conditions with spots at other `places`, cells of `maps`.
    #[must_use]
    pub fn with_places(self, maps: &ParameterField, places: &[[f64; 2]]) -> Self {
        let [nx, ny] = maps.domain.size.map(|n| n as f64);
        Self { places: places.iter().map(|[x, y]| [x / nx, y / ny]).collect(), ..self }
    }

    /// These initial conditions of stripes with another seeding. The stripes are to run along `lines`. Random segments are placed
    /// for `maps`.
    #[must_use]
    pub fn with_seeding(self, maps: &ParameterField, seeding: Seeding, lines: Vec<GuideLine>) -> Self {
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed);
        let wavelength = |p: &Parameters| self.system.spacing(p);
        let lines =
            if seeding == Seeding::Segments { segments(maps, &lines, &wavelength, &mut rng) } else { lines };
        Self { lines, seeding, ..self }
    }

    /// These initial conditions of stripes with this polarity. Negative: lines begin halfway between the stripes that are to run
    /// along the given lines.
    #[must_use]
    pub fn with_polarity(self, polarity: Polarity) -> Self {
        Self { polarity, ..self }
    }

    /// Whether any mark begins: spots need at least one place.
    #[must_use]
    pub fn has_marks(&self) -> bool {
        self.system.is_striped() || !self.places.is_empty()
    }

    /// Whether stripes begin as separate pieces that must join.
    #[must_use]
    pub fn starts_scattered(&self) -> bool {
        self.seeding == Seeding::Segments
    }

    /// The concentrations in some `cells` of `maps` that are no obstacles, one vector a chemical; equal to those of [`Self::on`].
    /// `near` tells whether any of these cells may be within a distance, cells, of a place: spots farther away do not matter.
    #[must_use]
    pub fn in_cells(
        &self,
        maps: &ParameterField,
        cells: &[usize],
        near: &dyn Fn([f64; 2], f64) -> bool,
    ) -> Vec<Vec<f32>> {
        let Begin::Bells { radius, fill } = self.system.definition().begin else {
            let all = self.on(maps, &|_| false);
            return all.iter().map(|chemical| cells.iter().map(|cell| chemical[*cell]).collect()).collect();
        };
        let size = maps.domain.size;
        let places = self.places.iter().map(|at| [at[0] * size[0] as f64, at[1] * size[1] as f64]);
        let nuclei = places.map(|at| Nucleus::at(maps, at, &|p: &Parameters| self.system.spacing(p)));
        let reach = |nucleus: &Nucleus| bell_reach(nucleus, radius(&maps.at(nucleus.at)));
        let nuclei: Vec<Nucleus> = nuclei.filter(|nucleus| near(nucleus.at, reach(nucleus))).collect();
        let bells = bells(maps, &nuclei, &radius);
        let values: Vec<f32> = cells.iter().map(|cell| bells[*cell]).collect();
        let parameters: Vec<Parameters> = cells.iter().map(|cell| maps.parameters[*cell]).collect();
        let mut found = vec![vec![0.0; cells.len()]; self.system.chemicals().len()];
        let mut chemicals: Vec<&mut [f32]> = found.iter_mut().map(Vec::as_mut_slice).collect();
        fill(&mut chemicals, &values, &parameters);
        found
    }

    /// The concentrations on the grid of `maps`, one vector a chemical; `lost` as in [`from_places`].
    #[must_use]
    pub fn on(&self, maps: &ParameterField, lost: &dyn Fn(usize) -> bool) -> Vec<Vec<f32>> {
        let size = maps.domain.size;
        match self.system.definition().begin {
            Begin::Bells { .. } => {
                let place = |at: &[f64; 2]| [at[0] * size[0] as f64, at[1] * size[1] as f64];
                let places: Vec<[f64; 2]> = self.places.iter().map(place).collect();
                from_places(self.system, maps, &places, lost)
            }
            Begin::Waves { on_grid: begin, .. } => {
                let Self { seed, seeding, polarity, ref lines, .. } = *self;
                let start = Start { seed, lines, curves: maps.curves.as_ref(), seeding, polarity };
                with_obstacle_state(self.system, maps, begin(&start, maps))
            }
        }
    }
}

/// Concentrations in which obstacle cells have the values of the marks of other layers.
#[must_use]
pub fn with_obstacle_state<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    mut chemicals: Vec<Vec<f32>>,
) -> Vec<Vec<f32>> {
    let values = system.definition().obstacle;
    for (cells, value) in chemicals.iter_mut().zip(values) {
        for (cell, obstacle) in cells.iter_mut().zip(&maps.obstacles) {
            if *obstacle {
                *cell = *value;
            }
        }
    }
    if let (Some(curves), [_, inhibitor, ..]) = (&maps.curves, &mut chemicals[..]) {
        for ((cell, obstacle), own) in inhibitor.iter_mut().zip(&maps.obstacles).zip(&curves.inhibitor) {
            if *obstacle {
                *cell = *own;
            }
        }
    }
    chemicals
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn some_cells_begin_as_they_do_among_all() {
        let cases =
            [(System::MEINHARDT_SPOTS, 3.0, Edges::Closed), (System::TURING_SPOTS, 0.09, Edges::Wrap)];
        for (system, rate, edges) in cases {
            let p = Parameters { rate, ratio: 20.0, stretch: 0.5, direction: 30.0, pitch: 1.0 };
            let maps = ParameterField::uniform([150, 90], edges, p);
            let start = InitialConditions::new(system, &maps, 4);
            // Cells in a corner, which on a tile has the other corners beside it.
            let cells: Vec<usize> = (0..150 * 90).filter(|cell| cell % 150 < 20 && cell / 150 < 15).collect();
            let near = |at: [f64; 2], distance: f64| {
                let [x, y] = maps.domain.displacement([10.0, 7.5], at);
                x.abs() <= 10.0 + distance && y.abs() <= 7.5 + distance
            };
            let (some, all) = (start.in_cells(&maps, &cells, &near), start.on(&maps, &|_| false));
            assert_eq!(some.len(), all.len());
            assert!(some[0].iter().any(|value| *value != some[0][0]), "{system:?}");
            for (some, all) in some.iter().zip(&all) {
                assert!(some.iter().zip(&cells).all(|(value, cell)| *value == all[*cell]), "{system:?}");
            }
        }
    }
}
