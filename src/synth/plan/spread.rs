//! Spots that differ from each other as much as is asked.
//!
//! ```text
//!  asked spread ─▶ what can be had ─▶ a draw for each spot ─▶ places with the room that each needs ─▶ parameters
//!  (region map)    (limits)           (draws)                 (rd: relax_places)             of each cell (rd: Shepard interpolation)
//! ```
//!
//! Each spot grows in parameters of its own, those of a texture whose mean it would be: a system answers to where a
//! spot is, not to the mean. The draws of a region have mean 0, so that its means stay. Distances are in the places
//! where spots begin, which they keep but for what neighbours push them.

mod draws;
mod limits;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::attributes::{Attributes, Spots, Spread};
use crate::measure::spot_errors;
use crate::rd::{self, Maps, Parameters, Places};
use crate::synth::grow::multigrid_levels;
use crate::synth::plan::Plan;
use crate::synth::plan::lattice::Node;
use crate::synth::plan::spacing_correction::{MANY, ROUNDS, corrected, spots_at};
pub use draws::Draw;
use draws::Scores;
pub use limits::{ASPECTS, limited, most};

/// What a layer of varied spots grows from.
pub struct Varied {
    /// Parameters of every cell.
    pub maps: Maps,
    /// Where the spots begin, cells.
    pub places: Vec<[f64; 2]>,
    /// Cells that the largest spot would cover if none differed from its region's mean.
    pub largest: f64,
}

/// Rounds of repulsion after which spots have the room that they need.
const ROOM_ROUNDS: usize = 30;
/// Pushed apart from this distance on, in pitches: the first ring of neighbours, as where spots are laid.
const ROOM_REACH: f64 = 1.25;
/// How far the room that a spot takes has its own shape and direction, not those of its surroundings: of 1,160 spots
/// turned by 10° (aspect 0.4, area/spacing² 0.2) seven merged at 0, none at 0.5, six at 1.
const OWN_SHAPE: f64 = 0.6;
/// Once shaken, only spots nearer than this share of the pitch are pushed apart, in so many rounds. Nearer ones merge
/// or die: of 200 dense spots (area/spacing² 0.19) five were lost at 0.75, none at 0.85.
const SHAKEN_REACH: f64 = 0.85;
/// See [`SHAKEN_REACH`].
const SHAKEN_ROUNDS: usize = 40;
/// Share of the variance of the distances beyond their own that is left when spots have settled: patches of
/// area/spacing² 0.04, 0.12, 0.19 kept 0.74, 0.5, 0.54 of it.
const KEPT: f64 = 0.55;
/// Standard deviation of the distances (÷ mean) that shaking by one pitch adds; as these.
const SHAKING: f64 = 0.27;
/// Shaken by more pitches than this, spots stand as at random.
const MOST_SHAKEN: f64 = 1.2;

/// The spots of `plan`; `None` where none is to differ from its neighbours, and none is kept.
pub fn vary(plan: &Plan, seed: u64) -> Option<Varied> {
    if plan.system.is_striped() || plan.map.is_even() && plan.kept.is_empty() {
        return None;
    }
    let regions = plan.map.layout().len();
    let mut pitch = vec![1.0; regions];
    let mut shaking = vec![Shaking::default(); regions];
    if plan.places.is_some() {
        // They are where they are.
        return Some(Laid::new(plan, &pitch, &shaking, seed).grown_from(plan, &pitch));
    }
    let mut round = 0;
    loop {
        let laid = Laid::new(plan, &pitch, &shaking, seed);
        if round == ROUNDS || laid.places.len() > MANY {
            return Some(laid.grown_from(plan, &pitch));
        }
        let spots = spots_at(plan, &laid.places);
        let found = plan.on_canvas(|canvas| spot_errors(&spots, canvas));
        for (index, found) in found.iter().enumerate() {
            pitch[index] = corrected(pitch[index], found.spacing);
            let asked = plan.spread(index).spacing;
            shaking[index] = shaking[index].towards(asked, found.spread.map_or(0.0, |spread| spread.spacing));
        }
        round += 1;
    }
}

/// How much the places of a region are shaken.
#[derive(Clone, Copy, Debug, Default)]
struct Shaking {
    /// Pitches.
    by: f64,
    /// Coefficient of variation of the distances without it, once known.
    own: Option<f64>,
}

impl Shaking {
    /// As much as makes a coefficient of variation `asked` of settled spots, where the places now have `got`.
    fn towards(self, asked: f64, got: f64) -> Self {
        let Some(own) = self.own else {
            let excess = ((asked * asked - got * got).max(0.0) / KEPT).sqrt();
            return Self { by: (excess / SHAKING).min(MOST_SHAKEN), own: Some(got) };
        };
        let excess = |total: f64| (total * total - own * own).max(0.0).sqrt();
        let (wanted, reached) = (excess(asked) / KEPT.sqrt(), excess(got));
        let factor = if reached > 0.0 { (wanted / reached).clamp(0.5, 2.0) } else { 1.0 };
        Self { by: (self.by * factor).min(MOST_SHAKEN), ..self }
    }
}

/// Spots in their places, cells.
struct Laid {
    maps: Maps,
    places: Vec<[f64; 2]>,
    /// How the parameters of each differ from those of its region.
    offsets: Vec<[f64; 3]>,
    /// Parameters of the room that each takes.
    own: Vec<Parameters>,
}

impl Laid {
    fn new(plan: &Plan, pitch: &[f64], shaking: &[Shaking], seed: u64) -> Self {
        let maps = plan.maps(pitch);
        // Another stream than the one that laid them.
        let mut rng = Pcg64Mcg::seed_from_u64(seed ^ 0x7370_7265_6164);
        if let Some(places) = plan.places_in_cells() {
            let scores = Scores::new(plan, &plan.px(&places), &mut rng);
            let (offsets, own) = drawn(plan, &places, pitch, &scores);
            return Self { maps, places, offsets, own };
        }
        let first = rd::nuclei(plan.system, &maps, seed, &kept(plan, pitch));
        let scores = Scores::new(plan, &plan.px(&first.inside), &mut rng);
        let (_, own) = drawn(plan, &first.inside, pitch, &scores);
        let room = |laid: &Places, own: &[Parameters], reach: f64, rounds: usize| {
            rd::relax_places(plan.system, &maps, laid, own, reach, rounds)
        };
        let mut places = room(&first, &own, ROOM_REACH, ROOM_ROUNDS);
        if shaking.iter().any(|shaking| shaking.by > 0.0) {
            shake(plan, &mut places, &own, shaking, &mut rng);
            let shaken = Places { inside: places, ..first };
            places = room(&shaken, &own, SHAKEN_REACH, SHAKEN_ROUNDS);
        }
        // Some have moved into another region.
        let (offsets, own) = drawn(plan, &places, pitch, &scores);
        Self { maps, places, offsets, own }
    }

    fn grown_from(self, plan: &Plan, pitch: &[f64]) -> Varied {
        let Self { maps, places, offsets, own } = self;
        let largest = multigrid_levels::largest(plan.system, &maps);
        let nx = plan.grid[0];
        let vary = |cell: usize, offset: [f64; 3]| {
            let point = plan.place([(cell % nx) as f64 + 0.5, (cell / nx) as f64 + 0.5]);
            plan.lattice.at(point).plus(offset).parameters(plan.between_regions(pitch, point))
        };
        let parameters = rd::interpolate_parameters(plan.system, &maps, &places, &own, &offsets, &vary);
        Varied { maps: Maps { parameters, ..maps }, places, largest }
    }
}

/// The spots that are kept, with the parameters of the room that they take.
fn kept(plan: &Plan, pitch: &[f64]) -> Vec<rd::PinnedSpot> {
    plan.kept.iter().map(|kept| kept.laid(plan, pitch)).collect()
}

/// What the draws do to the parameters of the spots at `places` (cells), and the parameters of the room that these take.
fn drawn(
    plan: &Plan,
    places: &[[f64; 2]],
    pitch: &[f64],
    scores: &Scores,
) -> (Vec<[f64; 3]>, Vec<Parameters>) {
    let px = plan.px(places);
    let draws = scores.draws(plan, &px);
    px.iter().zip(&draws).map(|(px, draw)| own(plan, *px, pitch, draw)).unzip()
}

/// What a draw does to the parameters of a spot at a place (px), and the parameters of the room that it takes.
pub fn own(plan: &Plan, px: [f64; 2], pitch: &[f64], draw: &Draw) -> ([f64; 3], Parameters) {
    let node: Node = plan.lattice.at(px);
    let wanted = wanted(plan, px);
    let rounder = libm::log((wanted.aspect + draw.aspect) / wanted.aspect);
    let offset = node.offset(-libm::log(draw.area), rounder, draw.turn);
    let [rate, c, s] = offset;
    let room = node.plus([rate, OWN_SHAPE * c, OWN_SHAPE * s]);
    (offset, room.parameters(plan.between_regions(pitch, px)))
}

/// Moves spots at random: the mean of two even numbers from −1 to 1 along either axis, times the shaking of the place.
fn shake(plan: &Plan, places: &mut [[f64; 2]], own: &[Parameters], shaking: &[Shaking], rng: &mut Pcg64Mcg) {
    let kept = plan.kept.len();
    let by: Vec<f64> = shaking.iter().map(|shaking| shaking.by).collect();
    for (at, own) in places.iter_mut().zip(own).skip(kept) {
        let [along, across] = [(); 2].map(|()| rng.random::<f64>() + rng.random::<f64>() - 1.0);
        let reach = plan.between_regions(&by, plan.place(*at)) * plan.system.spacing(own);
        let longer = f64::from(own.stretch).sqrt();
        let (along, across) = (along * reach / longer, across * reach * longer);
        let direction = f64::from(own.direction).to_radians();
        let (s, c) = (libm::sin(direction), libm::cos(direction));
        at[0] += along * c - across * s;
        at[1] += along * s + across * c;
    }
}

/// The spots wanted at a point, px.
pub fn wanted(plan: &Plan, point: [f64; 2]) -> Spots {
    match plan.map.at(point) {
        Attributes::Spots(spots) => spots,
        Attributes::Stripes(_) => unreachable!("stripes do not vary"),
    }
}

/// How much spots that are wanted at a point (px) vary.
fn spread_at(plan: &Plan, point: [f64; 2]) -> Spread {
    let corners = plan.map.layout().corners(point);
    corners
        .iter()
        .fold(Spread::ZERO, |sum, &(i, weight)| sum.with(&plan.spread(i), |sum, one| sum + weight * one))
}
