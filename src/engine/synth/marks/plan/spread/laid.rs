//! Initial places of spots that differ from each other: each with the room for its own parameters, at the distances and with the
//! unevenness asked for.

use std::borrow::Cow;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::measure::{SpotErrors, spot_errors};
use crate::rd::{self, ParameterField, Parameters, Places};
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::spacing_correction::{corrected, corrections, spots_at};
use crate::synth::marks::plan::spread::deviations::Scores;
use crate::synth::marks::plan::spread::own_parameters::own_of_all;

/// Numbers of rounds of repulsion.
struct RepulsionRounds {
    /// Before each spot gets its own room: until spots are spaced evenly enough.
    first: usize,
    /// With its own room for each spot.
    room: usize,
    /// After the jitter.
    jittered: usize,
}

/// The usual numbers.
const USUAL: RepulsionRounds = RepulsionRounds { first: rd::ROUNDS, room: 30, jittered: 40 };
/// Rounds for many spots, whose mean distance hardly depends on single ones. Two documents with 2,800 and 3,100 spots have equal
/// errors with them, over six seeds: spacing 0.35 and 1.48 % instead of 0.36 and 1.48 %. Of a hundred random sketches of few spots,
/// 95 % of the regions were within 3.8 % of their spacing with ten first rounds, with thirty within 3.0 %.
const OF_MANY: RepulsionRounds = RepulsionRounds { first: 10, room: 20, jittered: 25 };
/// Number of spots from which on [`OF_MANY`] is used. Not tuned.
const MANY: usize = 2_000;

impl RepulsionRounds {
    /// The numbers of rounds for this number of spots.
    fn of(spots: usize) -> Self {
        if spots < MANY { USUAL } else { OF_MANY }
    }
}

/// Spots closer than this are pushed apart, in pitches: the first ring of neighbours, as for nuclei.
pub const ROOM_REACH: f64 = 1.25;
/// After the jitter, only spots closer than this are pushed apart, in pitches. Closer ones merge or vanish: of 200 dense spots
/// (area/spacing² 0.19) five were lost at 0.75, none at 0.85.
const JITTERED_REACH: f64 = 0.85;
/// Share of the added variance of the distances that is left when spots have settled. With it 0.12, 0.14, 0.16 become 0.12, 0.13,
/// 0.15 at area/spacing² 0.12, and 0.14, 0.16 become 0.14, 0.17 at 0.05.
const LEFT_VARIANCE: f64 = 0.38;
/// Standard deviation of the distances (÷ mean) that a jitter of one pitch adds; a first guess, which is corrected.
const JITTER_EFFECT: f64 = 0.25;
/// Largest jitter, pitches: with more, the places are practically random.
const MOST_JITTER: f64 = 1.2;

/// Spots with the distances and the unevenness asked for.
pub struct Spaced<'a> {
    /// The spots before the jitter.
    pub laid: Laid<'a>,
    /// Their places, cells.
    pub places: Vec<[f64; 2]>,
    /// Random displacement, by region.
    pub jitter: Vec<Jitter>,
    /// Factors of the pitch, by region.
    pub pitch: Vec<f64>,
}

/// Lays the spots of `plan`, whose parameters are `maps`, corrects their pitch and their jitter, and lays them again.
pub fn lay_spaced<'a>(plan: &Plan, maps: &'a ParameterField, seed: u64) -> Spaced<'a> {
    let mut pitch = vec![1.0; plan.lookup.map.layout().len()];
    let mut jitter = vec![Jitter::default(); pitch.len()];
    let (mut round, mut rounds) = (0, usize::MAX);
    while round < rounds {
        let laid = Laid::new(plan, plan.lookup.repitched(maps, &pitch), &pitch, seed);
        let places = laid.jittered(plan, &jitter);
        if round == 0 {
            // Their number changes a little from round to round: that of the first round is used.
            rounds = corrections(places.len());
            if rounds == 0 {
                return Spaced { laid, places, jitter, pitch };
            }
        }
        let mut found = errors_at(plan, &places);
        correct_jitter(plan, &mut jitter, &found);
        if rounds == 1 && is_jittered(&jitter) {
            // Many spots keep their mean distance when they are laid again, so that the jitter can be tested with these.
            found = errors_at(plan, &laid.jittered(plan, &jitter));
            correct_jitter(plan, &mut jitter, &found);
        }
        for (pitch, found) in pitch.iter_mut().zip(&found) {
            *pitch = corrected(*pitch, found.spacing);
        }
        round += 1;
    }
    let laid = Laid::new(plan, plan.lookup.repitched(maps, &pitch), &pitch, seed);
    let places = laid.jittered(plan, &jitter);
    Spaced { laid, places, jitter, pitch }
}

/// Errors of spots at these places, cells, against the wanted attributes, by region.
fn errors_at(plan: &Plan, places: &[[f64; 2]]) -> Vec<SpotErrors> {
    let spots = spots_at(plan, places);
    plan.on_canvas(|target| spot_errors(&spots, target))
}

/// Corrects the jitter of each region by the errors found with it.
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
pub struct Jitter {
    /// Largest displacement, pitches.
    by: f64,
    /// Coefficient of variation of the distances without jitter, once it is known.
    own: Option<f64>,
}

impl Jitter {
    /// The jitter that gives settled spots a coefficient of variation of `asked`, if the places now have `got`.
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

/// Spots with the room that they need.
pub struct Laid<'a> {
    /// Parameters of every cell.
    pub maps: Cow<'a, ParameterField>,
    /// Their places without jitter, cells.
    pub places: Places,
    /// Parameters of the room of each spot.
    own: Vec<Parameters>,
    pub scores: Scores,
    rng: Pcg64Mcg,
}

impl<'a> Laid<'a> {
    fn new(plan: &Plan, maps: Cow<'a, ParameterField>, pitch: &[f64], seed: u64) -> Self {
        let lookup = &plan.lookup;
        let mut rng = own_rng(seed);
        let pinned = pinned_spots(plan, pitch);
        let first =
            rd::nuclei_after(lookup.system, &maps, seed, &pinned, |spots| RepulsionRounds::of(spots).first);
        let scores = Scores::new(plan, &lookup.all_to_px(&first.inside), &mut rng);
        Self::with_room(plan, maps, pitch, first, scores, rng)
    }

    /// Gives the spots that were laid `first` the room that each needs with these `scores`.
    pub fn with_room(
        plan: &Plan,
        maps: Cow<'a, ParameterField>,
        pitch: &[f64],
        first: Places,
        scores: Scores,
        rng: Pcg64Mcg,
    ) -> Self {
        let (_, own) = own_of_all(plan, &first.inside, pitch, &scores);
        let rounds = RepulsionRounds::of(first.inside.len()).room;
        let inside = rd::relax_places(plan.lookup.system, &maps, &first, &own, ROOM_REACH, rounds);
        Self { maps, places: Places { inside, ..first }, own, scores, rng }
    }

    /// Their places with jitter, cells.
    pub fn jittered(&self, plan: &Plan, jitter: &[Jitter]) -> Vec<[f64; 2]> {
        let Self { maps, places, own, .. } = self;
        if !is_jittered(jitter) {
            return places.inside.clone();
        }
        let mut jittered = places.clone();
        displace(plan, &mut jittered, own, jitter, &mut self.rng.clone());
        let rounds = RepulsionRounds::of(jittered.inside.len()).jittered;
        rd::relax_places(plan.lookup.system, maps, &jittered, own, JITTERED_REACH, rounds)
    }
}

/// The pinned spots of `plan` with their room among the others; `pitch` is by region.
pub fn pinned_spots(plan: &Plan, pitch: &[f64]) -> Vec<rd::PinnedSpot> {
    plan.pinned_spots().iter().map(|spot| spot.among_others(&plan.lookup, pitch)).collect()
}

/// A random stream different from that of the places.
pub fn own_rng(seed: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed ^ 0x7370_7265_6164)
}

/// Displaces spots at random, except pinned ones: along either axis by the mean of two uniform random numbers from −1 to 1, times
/// the jitter of the place.
fn displace(plan: &Plan, places: &mut Places, own: &[Parameters], jitter: &[Jitter], rng: &mut Pcg64Mcg) {
    let lookup = &plan.lookup;
    let by: Vec<f64> = jitter.iter().map(|jitter| jitter.by).collect();
    for (at, own) in places.inside.iter_mut().zip(own).skip(places.pinned) {
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
