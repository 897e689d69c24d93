//! Spots that differ from each other as much as is asked.
//!
//! ```text
//!  asked spread ─▶ possible spread ─▶ a deviation a spot ─▶ places with the room each needs ─▶ parameters of each cell
//!  (region map)    (limits)           (deviations)          (rd: relax_places)            (rd: Shepard interpolation)
//! ```
//!
//! Each spot grows in parameters of its own, those of a texture whose mean it would be: a system answers to where a
//! spot is, not to the mean. The deviations of a region have mean 0, so that its means stay; pinned spots have parameters
//! of their own. Distances are in the places where spots begin, which they keep but for what neighbours push them.

mod deviations;

use std::borrow::Cow;
use std::ops::Range;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::grid::{Domain, Grid};
use crate::measure::{SpotErrors, spot_errors};
use crate::rd::{self, Kernel, Maps, Parameters, Places, System};
use crate::synth::plan::cell_parameters::CellParameters;
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::lattice::{Node, NodeOffset, WeightedNode};
use crate::synth::plan::layer_lookup::Lookup;
use crate::synth::plan::mark_cells::largest_mark;
use crate::synth::plan::one_spot::{deviating, room_of};
use crate::synth::plan::spacing_correction::{corrected, corrections, spots_at};
use deviations::Scores;

/// What a layer of varied spots grows from.
#[derive(Clone, Debug)]
pub struct Varied {
    /// Parameters of every cell.
    pub maps: Maps,
    /// The spots, the pinned ones first.
    pub spots: VariedSpots,
    /// Cells that the largest spot would cover if none differed from its region's mean.
    pub largest: f64,
}

/// Spots with parameters of their own.
#[derive(Clone, Debug)]
pub struct VariedSpots {
    /// Where they begin, cells.
    pub places: Vec<[f64; 2]>,
    /// How the parameters of each differ from those of its place.
    offsets: Vec<NodeOffset>,
    /// Parameters of the room that each takes.
    own: Vec<Parameters>,
    /// How far the parameters of each reach.
    kernels: Vec<Kernel>,
    /// Factors of the pitch, by region.
    pitch: Vec<f64>,
}

/// Numbers of rounds of repulsion.
struct RepulsionRounds {
    /// Until spots stand evenly enough to get the room that each needs.
    first: usize,
    /// Until they have that room.
    room: usize,
    /// Once they are jittered.
    jittered: usize,
}

/// The usual ones.
const USUAL: RepulsionRounds = RepulsionRounds { first: rd::ROUNDS, room: 30, jittered: 40 };
/// Those of many spots, whose mean distance hardly depends on single ones. Two documents with 2,800 and 3,100 spots have the same
/// errors with them, over six seeds: spacing 0.35 and 1.48 % instead of 0.36 and 1.48 %. Of a hundred random sketches of few spots, 95 %
/// of the regions were within 3.8 % of their spacing with ten first rounds, with thirty within 3.0 %.
const OF_MANY: RepulsionRounds = RepulsionRounds { first: 10, room: 20, jittered: 25 };
/// So many spots are many. Not tuned.
const MANY: usize = 2_000;

impl RepulsionRounds {
    /// Those of so many spots.
    fn of(spots: usize) -> Self {
        if spots < MANY { USUAL } else { OF_MANY }
    }
}

/// Spots nearer than this are pushed apart, in pitches: the first ring of neighbours, as for nuclei.
const ROOM_REACH: f64 = 1.25;
/// Once jittered, only spots nearer than this share of the pitch are pushed apart. Nearer ones merge or die: of 200 dense spots
/// (area/spacing² 0.19) five were lost at 0.75, none at 0.85.
const JITTERED_REACH: f64 = 0.85;
/// Spots nearer than this to one that does not grow may be why, in its pitches: the first ring of neighbours and a margin. Not
/// tuned.
const BESIDE: f64 = 1.6;
/// Share of the variance of the distances beyond their own that is left when spots have settled. With it 0.12, 0.14, 0.16
/// grow as 0.12, 0.13, 0.15 at area/spacing² 0.12, and 0.14, 0.16 as 0.14, 0.17 at 0.05.
const LEFT_VARIANCE: f64 = 0.38;
/// Standard deviation of the distances (÷ mean) that a jitter of one pitch adds; a first guess, which is corrected.
const JITTER_EFFECT: f64 = 0.25;
/// Jittered by more pitches than this, spots stand as at random.
const MOST_JITTER: f64 = 1.2;

/// The spots of `plan` one by one; `None` where none differs from its neighbours, and none is pinned.
pub fn vary(plan: &Plan, seed: u64) -> Option<Varied> {
    let Lookup { system, map, .. } = &plan.lookup;
    if system.is_striped() || map.is_without_spread() && plan.pinned_spots().is_empty() {
        return None;
    }
    let maps = plan.unpitched_maps();
    let mut pitch = vec![1.0; map.layout().len()];
    if let Some(places) = plan.places() {
        // Given places are not corrected.
        return Some(given(plan, &maps, places, &pitch, seed));
    }
    let mut jitter = vec![Jitter::default(); pitch.len()];
    let (mut round, mut rounds) = (0, usize::MAX);
    while round < rounds {
        let laid = Laid::new(plan, plan.lookup.repitched(&maps, &pitch), &pitch, seed);
        let places = laid.jittered(plan, &jitter);
        if round == 0 {
            // Their number changes a little from round to round: the first one decides.
            rounds = corrections(places.len());
            if rounds == 0 {
                return Some(laid.varied(plan, &places, &pitch));
            }
        }
        let mut found = errors_at(plan, &places);
        correct_jitter(plan, &mut jitter, &found);
        if rounds == 1 && is_jittered(&jitter) {
            // Many spots keep their mean distance when they are laid again, so that the jitter can be tried on these.
            found = errors_at(plan, &laid.jittered(plan, &jitter));
            correct_jitter(plan, &mut jitter, &found);
        }
        for (pitch, found) in pitch.iter_mut().zip(&found) {
            *pitch = corrected(*pitch, found.spacing);
        }
        round += 1;
    }
    let laid = Laid::new(plan, Cow::Owned(plan.lookup.repitch(maps, &pitch)), &pitch, seed);
    let places = laid.jittered(plan, &jitter);
    Some(laid.varied(plan, &places, &pitch))
}

/// How spots at these places, cells, differ from what is asked, by region.
fn errors_at(plan: &Plan, places: &[[f64; 2]]) -> Vec<SpotErrors> {
    let spots = spots_at(plan, places);
    plan.on_canvas(|target| spot_errors(&spots, target))
}

/// Corrects the jitter of each region by what was found with it.
fn correct_jitter(plan: &Plan, jitter: &mut [Jitter], found: &[SpotErrors]) {
    for (index, (jitter, found)) in jitter.iter_mut().zip(found).enumerate() {
        let asked = plan.lookup.spread(index).spacing;
        *jitter = jitter.towards(asked, found.spread.map_or(0.0, |spread| spread.spacing));
    }
}

fn is_jittered(jitter: &[Jitter]) -> bool {
    jitter.iter().any(|jitter| jitter.by > 0.0)
}

/// Random displacement of the places of a region.
#[derive(Clone, Copy, Debug, Default)]
struct Jitter {
    /// Pitches.
    by: f64,
    /// Coefficient of variation of the distances without it, once known.
    own: Option<f64>,
}

impl Jitter {
    /// As much as makes a coefficient of variation `asked` of settled spots, where the places now have `got`.
    fn towards(self, asked: f64, got: f64) -> Self {
        let Some(own) = self.own else {
            let excess = ((asked * asked - got * got).max(0.0) / LEFT_VARIANCE).sqrt();
            return Self { by: (excess / JITTER_EFFECT).min(MOST_JITTER), own: Some(got) };
        };
        let excess = |total: f64| (total * total - own * own).max(0.0).sqrt();
        let (wanted, reached) = (excess(asked) / LEFT_VARIANCE.sqrt(), excess(got));
        let factor = if reached > 0.0 { (wanted / reached).clamp(0.5, 2.0) } else { 1.0 };
        Self { by: (self.by * factor).min(MOST_JITTER), ..self }
    }
}

/// Spots that have the room that they need.
struct Laid<'a> {
    maps: Cow<'a, Maps>,
    /// Where they are without jitter, cells.
    places: Places,
    /// Parameters of the room that each takes.
    own: Vec<Parameters>,
    scores: Scores,
    rng: Pcg64Mcg,
}

impl<'a> Laid<'a> {
    fn new(plan: &Plan, maps: Cow<'a, Maps>, pitch: &[f64], seed: u64) -> Self {
        let lookup = &plan.lookup;
        let mut rng = own_rng(seed);
        let pinned: Vec<rd::PinnedSpot> =
            plan.pinned_spots().iter().map(|spot| spot.among_others(lookup, pitch)).collect();
        let first =
            rd::nuclei_after(lookup.system, &maps, seed, &pinned, |spots| RepulsionRounds::of(spots).first);
        let scores = Scores::new(plan, &lookup.all_to_px(&first.inside), &mut rng);
        let (_, own) = own_of_all(plan, &first.inside, pitch, &scores);
        let rounds = RepulsionRounds::of(first.inside.len()).room;
        let inside = rd::relax_places(lookup.system, &maps, &first, &own, ROOM_REACH, rounds);
        Self { maps, places: Places { inside, ..first }, own, scores, rng }
    }

    /// Their places with jitter, cells.
    fn jittered(&self, plan: &Plan, jitter: &[Jitter]) -> Vec<[f64; 2]> {
        let Self { maps, places, own, .. } = self;
        if !is_jittered(jitter) {
            return places.inside.clone();
        }
        let mut jittered = places.clone();
        displace(plan, &mut jittered.inside, own, jitter, &mut self.rng.clone());
        let rounds = RepulsionRounds::of(jittered.inside.len()).jittered;
        rd::relax_places(plan.lookup.system, maps, &jittered, own, JITTERED_REACH, rounds)
    }

    /// These spots at `places`, cells.
    fn varied(&self, plan: &Plan, places: &[[f64; 2]], pitch: &[f64]) -> Varied {
        varied(plan, &self.maps, places, pitch, &self.scores)
    }
}

/// Another random stream than the one of the places.
fn own_rng(seed: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed ^ 0x7370_7265_6164)
}

/// Spots at given `places`, px.
fn given(plan: &Plan, maps: &Maps, places: &[[f64; 2]], pitch: &[f64], seed: u64) -> Varied {
    let places = plan.lookup.all_to_cells(places);
    let scores = Scores::new(plan, &plan.lookup.all_to_px(&places), &mut own_rng(seed));
    varied(plan, maps, &places, pitch, &scores)
}

/// Spots at `places`, cells: some have moved into another region.
fn varied(plan: &Plan, maps: &Maps, places: &[[f64; 2]], pitch: &[f64], scores: &Scores) -> Varied {
    let (offsets, own) = own_of_all(plan, places, pitch, scores);
    let system = plan.lookup.system;
    let largest = largest_mark(system, maps);
    let kernel =
        |(at, own): (&[f64; 2], &Parameters)| Kernel::new(system, &maps.domain, *at, own, &maps.at(*at));
    let kernels = places.iter().zip(&own).map(kernel).collect();
    let spots = VariedSpots { places: places.to_vec(), offsets, own, kernels, pitch: pitch.to_vec() };
    let mut parameters = Parameters::unwritten(maps.parameters.len());
    spots.interpolate(plan, &|_| true, &mut parameters);
    Varied { maps: maps.with_parameters(parameters), spots, largest }
}

impl VariedSpots {
    /// Takes the spots `away`, by their indices, and the parameters of the pinned ones from `plan`, where they have been corrected.
    /// Writes the `parameters` of the cells that this changes.
    pub fn correct(&mut self, plan: &Plan, away: &[usize], parameters: &mut [Parameters]) {
        let grid = &plan.lookup.grid;
        let mut changed: Vec<Kernel> = away.iter().map(|index| self.kernels[*index]).collect();
        self.remove(away);
        let spots = self.offsets.iter_mut().zip(&self.kernels);
        for ((offset, kernel), pinned) in spots.zip(plan.pinned_spots()) {
            let corrected = pinned.corrected_offset();
            if *offset != corrected {
                *offset = corrected;
                changed.push(*kernel);
            }
        }
        let changes = |cells: &Range<usize>| changed.iter().any(|kernel| kernel.may_reach(grid, cells));
        self.interpolate(plan, &changes, parameters);
    }

    /// The nearest spot of those `among`, by their indices, within 1.6 pitches of spot `index`, which is none of them.
    #[must_use]
    pub fn nearest_beside(
        &self,
        index: usize,
        among: Range<usize>,
        system: System,
        grid: &Grid,
    ) -> Option<usize> {
        let distance = |other: usize| {
            let [x, y] = grid.way(self.places[index], self.places[other]);
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

    /// Writes the parameters of the cells of those parts that `changes`: those of each spot are the same all around it, also where
    /// what is wanted changes within its length.
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

/// By how much the parameters of the spots at `places` (cells) differ, and the parameters of the room that these take.
fn own_of_all(
    plan: &Plan,
    places: &[[f64; 2]],
    pitch: &[f64],
    scores: &Scores,
) -> (Vec<NodeOffset>, Vec<Parameters>) {
    let lookup = &plan.lookup;
    let px = lookup.all_to_px(places);
    let pinned = plan.pinned_spots();
    let deviations = scores.deviations(plan, &px);
    let own = |(index, px): (usize, &[f64; 2])| match pinned.get(index) {
        Some(pinned) => {
            let room = room_of(lookup, pinned.drawn.center, pitch, pinned.offset);
            (pinned.corrected_offset(), room)
        }
        None => {
            let offset = deviating(lookup, *px, &deviations[index]);
            (offset, room_of(lookup, *px, pitch, offset))
        }
    };
    px.iter().enumerate().map(own).unzip()
}

/// Moves spots at random, pinned ones excepted: along either axis by the mean of two uniform random numbers from −1 to 1,
/// times the jitter of the place.
fn displace(plan: &Plan, places: &mut [[f64; 2]], own: &[Parameters], jitter: &[Jitter], rng: &mut Pcg64Mcg) {
    let lookup = &plan.lookup;
    let pinned = plan.pinned_spots().len();
    let by: Vec<f64> = jitter.iter().map(|jitter| jitter.by).collect();
    for (at, own) in places.iter_mut().zip(own).skip(pinned) {
        let [along, across] = [(); 2].map(|()| rng.random::<f64>() + rng.random::<f64>() - 1.0);
        let reach = lookup.between_regions(&by, lookup.to_px(*at)) * lookup.system.spacing(own);
        let longer = f64::from(own.stretch).sqrt();
        let (along, across) = (along * reach / longer, across * reach * longer);
        let direction = f64::from(own.direction).to_radians();
        let (s, c) = (libm::sin(direction), libm::cos(direction));
        at[0] += along * c - across * s;
        at[1] += along * s + across * c;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::synth::plan::{look_up, sketch_targets};
    use crate::synth::training::Training;

    /// Nine round spots of different areas in a corner of a canvas that takes several parts of cells.
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
        let Varied { maps, mut spots, .. } = vary(&plan, 3).expect("they differ");
        let mut corrected = maps.parameters.clone();
        spots.correct(&plan, &[1, 4], &mut corrected);
        let mut alone = Parameters::unwritten(corrected.len());
        spots.interpolate(&plan, &|_| true, &mut alone);
        assert!(corrected == alone && corrected != maps.parameters);
    }
}
