//! Spots that differ from each other by the spread that is asked for.
//!
//! ```text
//!  asked spread ─▶ possible spread ─▶ a deviation a spot ─▶ places with the room each needs ─▶ parameters of each cell
//!  (region map)    (limits)           (deviations)          (rd: relax_places)            (rd: Shepard interpolation)
//! ```
//!
//! Each spot grows with parameters of its own, those of a texture that has this spot as its mean: a system depends on the local
//! parameters, not on the mean. The deviations of a region have mean 0, so that its means do not change; pinned spots have
//! parameters of their own. Distances are determined by the initial places of spots, which change only by the repulsion of
//! neighbours.

pub mod deviations;
mod far_spots;
mod laid;
mod own_parameters;

use std::ops::Range;

use crate::grid::{Domain, Grid};
use crate::rd::{self, Kernel, ParameterField, Parameters, System};
use crate::synth::marks::plan::cell_parameters::CellParameters;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::lattice::{Node, NodeOffset, WeightedNode};
use crate::synth::marks::plan::layer_lookup::Lookup;
use crate::synth::marks::plan::mark_cells::largest_mark;
use crate::synth::profile::{Section, during};
use deviations::Scores;
use far_spots::far_spots;
pub use laid::ROOM_REACH;
use laid::{Spaced, lay_spaced, own_rng};
use own_parameters::own_of_all;

/// Spots with parameters of their own, the pinned ones first.
#[derive(Clone, Debug)]
pub struct VariedSpots {
    /// Starting places, cells.
    pub places: Vec<[f64; 2]>,
    /// Differences between the parameters of each and those of its place.
    offsets: Vec<NodeOffset>,
    /// Parameters of the room of each spot.
    own: Vec<Parameters>,
    /// Reach of the parameters of each spot.
    kernels: Vec<Kernel>,
    /// Factors of the pitch, by region.
    pitch: Vec<f64>,
    /// Cells that the largest spot would cover if none differed from its region's mean.
    pub largest: f64,
}

/// Spots closer than this to one that does not grow, in its pitches, may be the reason: the first ring of neighbours and a margin.
/// Not tuned.
const BESIDE: f64 = 1.6;
/// The spots of `plan` one by one; `None` if none differs from its neighbours, and none is pinned.
pub fn vary(plan: &Plan, seed: u64) -> Option<VariedSpots> {
    let Lookup { system, map, .. } = &plan.lookup;
    if system.is_striped() || map.is_without_spread() && plan.pinned_spots().is_empty() {
        return None;
    }
    let maps = plan.unpitched_maps();
    if let Some(places) = plan.places() {
        // Given places are not corrected.
        return Some(given(plan, &maps, places, seed));
    }
    let spaced = match far_spots(plan, seed) {
        Some(far) => far.with_marks(plan, &maps, seed),
        None => lay_spaced(plan, &maps, seed),
    };
    let Spaced { laid, places, pitch, .. } = spaced;
    Some(varied(plan, &laid.maps, &places, &pitch, &laid.scores))
}

/// Spots at given `places`, px.
fn given(plan: &Plan, maps: &ParameterField, places: &[[f64; 2]], seed: u64) -> VariedSpots {
    let pitch = vec![1.0; plan.lookup.map.layout().len()];
    let places = plan.lookup.all_to_cells(places);
    let scores = Scores::new(plan, &plan.lookup.all_to_px(&places), &mut own_rng(seed));
    varied(plan, maps, &places, &pitch, &scores)
}

/// Spots at `places`, cells; some may have moved into another region.
fn varied(
    plan: &Plan,
    maps: &ParameterField,
    places: &[[f64; 2]],
    pitch: &[f64],
    scores: &Scores,
) -> VariedSpots {
    let (offsets, own) = own_of_all(plan, places, pitch, scores);
    let system = plan.lookup.system;
    let largest = largest_mark(system, maps);
    let kernel =
        |(at, own): (&[f64; 2], &Parameters)| Kernel::new(system, &maps.domain, *at, own, &maps.at(*at));
    let kernels = places.iter().zip(&own).map(kernel).collect();
    VariedSpots { places: places.to_vec(), offsets, own, kernels, pitch: pitch.to_vec(), largest }
}

impl VariedSpots {
    /// Parameters of every cell of `plan`.
    #[must_use]
    pub fn maps(&self, plan: &Plan) -> ParameterField {
        let grid = plan.lookup.grid;
        let mut parameters = Parameters::unwritten(grid.cells());
        during(Section::Parameters, || self.interpolate(plan, &|_| true, &mut parameters));
        ParameterField { obstacles: plan.obstacles.clone(), ..ParameterField::new(grid, parameters) }
    }

    /// Removes the spots `away`, by their indices, and sets the `offsets` of the parameters of the pinned ones, which come first.
    /// Writes the `parameters` of the cells that this changes.
    pub fn correct(
        &mut self,
        plan: &Plan,
        away: &[usize],
        offsets: impl Iterator<Item = NodeOffset>,
        parameters: &mut [Parameters],
    ) {
        let grid = &plan.lookup.grid;
        let mut changed: Vec<Kernel> = away.iter().map(|index| self.kernels[*index]).collect();
        self.remove(away);
        let spots = self.offsets.iter_mut().zip(&self.kernels);
        for ((offset, kernel), corrected) in spots.zip(offsets) {
            if *offset != corrected {
                *offset = corrected;
                changed.push(*kernel);
            }
        }
        let changes = |cells: &Range<usize>| changed.iter().any(|kernel| kernel.may_reach(grid, cells));
        self.interpolate(plan, &changes, parameters);
    }

    /// The nearest spot `among` those with these indices, within 1.6 pitches of spot `index`, which is not one of them.
    #[must_use]
    pub fn nearest_beside(
        &self,
        index: usize,
        among: Range<usize>,
        system: System,
        grid: &Grid,
    ) -> Option<usize> {
        let distance = |other: usize| {
            let [x, y] = grid.displacement(self.places[index], self.places[other]);
            (x * x + y * y).sqrt()
        };
        let others = among.filter(|other| *other != index).map(|other| (other, distance(other)));
        let nearest = others.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.filter(|near| near.1 < BESIDE * system.spacing(&self.own[index])).map(|near| near.0)
    }

    fn remove(&mut self, surplus: &[usize]) {
        fn without<T: Copy>(values: &[T], surplus: &[usize]) -> Vec<T> {
            let stays = values.iter().enumerate().filter(|(index, _)| !surplus.contains(index));
            stays.map(|(_, value)| *value).collect()
        }
        self.places = without(&self.places, surplus);
        self.offsets = without(&self.offsets, surplus);
        self.own = without(&self.own, surplus);
        self.kernels = without(&self.kernels, surplus);
    }

    /// Writes the parameters of the cells in the parts that `changes`. Those of a spot are constant around it, even where the
    /// wanted attributes change within its length.
    fn interpolate(
        &self,
        plan: &Plan,
        changes: &(dyn Fn(&Range<usize>) -> bool + Sync),
        parameters: &mut [Parameters],
    ) {
        let Self { places, offsets, kernels, pitch, .. } = self;
        let lookup = &plan.lookup;
        let node = |(at, offset): (&[f64; 2], &NodeOffset)| {
            lookup.lattice.at(lookup.to_px(*at)).plus(*offset).weighted()
        };
        let nodes: Vec<WeightedNode> = places.iter().zip(offsets).map(node).collect();
        let cells = CellParameters::new(&lookup.lattice, &lookup.grid);
        let pitches = lookup.at_cells(pitch);
        let vary = |first: usize, weighted: &[WeightedNode], made: &mut [Parameters]| {
            let among = |cell: usize, ground: Node| Node::among(weighted[cell - first], &ground);
            cells.write(first, &pitches, among, made);
        };
        rd::interpolate_parameters(
            &lookup.grid,
            kernels,
            &nodes,
            Node::turned_weighted,
            &vary,
            changes,
            parameters,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::synth::drawn::sketch_targets;
    use crate::synth::marks::plan::look_up;
    use crate::synth::training::Training;

    /// Nine round spots of different areas in a corner of a canvas of several parts of cells.
    fn planned() -> Plan {
        let spot = |k: usize| {
            let (x, y, r) = (60 + 100 * (k % 3), 60 + 100 * (k / 3), 7 + k % 4);
            format!(r#"{{"kind": "ellipse", "center": [{x}, {y}], "radii": [{r}, {r}], "angle": 0}}"#)
        };
        let marks: Vec<String> = (0..9).map(spot).collect();
        let text = format!(
            r#"{{"format": "dapple", "version": 1, "size": [640, 960], "layers": [{{"strokes": [{}]}}]}}"#,
            marks.join(", ")
        );
        let document = Document::parse(&text, "spots").expect("a document");
        let map = sketch_targets::region_map(&document, 0, "spots").expect("spots");
        look_up(&Training::default(), document.layers[0].system, &map).expect("parameters").rough(Vec::new())
    }

    #[test]
    fn parameters_without_some_spots_are_those_of_the_others_alone() {
        let plan = planned();
        let mut spots = vary(&plan, 3).expect("they differ");
        let all = spots.maps(&plan).parameters;
        let mut corrected = all.clone();
        spots.correct(&plan, &[1, 4], std::iter::empty(), &mut corrected);
        let mut alone = Parameters::unwritten(corrected.len());
        spots.interpolate(&plan, &|_| true, &mut alone);
        assert!(corrected == alone && corrected != all);
    }
}
