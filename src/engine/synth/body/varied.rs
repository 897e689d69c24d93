//! Spots that differ from each other as much as is asked, and drawn ones with their own size: each grows in parameters of its own, as on
//! canvases.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::attributes::{Attributes, Spots, Spread};
use crate::rd::{Kernel, Parameters, Places, interpolate, relax_places, selling::MIN_STRETCH};
use crate::surface::SurfacePoint;
use crate::synth::body::plan::BodyPlan;
use crate::synth::marks::plan::one_spot::OWN_SHAPE;
use crate::synth::marks::plan::spread::ROOM_REACH;
use crate::synth::marks::plan::spread::deviations::{areas, aspects, stratified, turns};

/// Spots whose area, aspect and angle vary by less than this are equal.
const LEAST: f64 = 1e-3;
/// Rounds of repulsion until spots have the room that each needs, as on a canvas with few spots.
const ROUNDS: usize = 30;
/// Mixed into the seed of the layer: deviations have random numbers of their own.
const SEED: u64 = 0x5052_4541_4400;

/// Gives each spot of `laid` parameters of its own, and moves those that are not pinned until each has the room that it needs. `pinned` are
/// the parameters of the drawn spots, which come first; the others vary. Nothing is changed where spots do not differ.
#[must_use]
pub fn vary(
    plan: &mut BodyPlan,
    laid: Places<SurfacePoint>,
    pinned: &[Parameters],
    seed: u64,
) -> Vec<SurfacePoint> {
    let varies = |Spread { area, aspect, angle, .. }: Spread| area.max(aspect).max(angle) > LEAST;
    let has_spread = plan.anchors.iter().any(|anchor| varies(anchor.spread));
    if laid.inside.is_empty() || !has_spread && pinned.is_empty() {
        return laid.inside;
    }
    let deviations = deviations(plan, &laid.inside[pinned.len()..], seed);
    let own = |places: &[SurfacePoint], share: f64| -> Vec<Parameters> {
        let free = places[pinned.len()..].iter().zip(&deviations);
        let free = free.map(|(at, deviation)| deviation.of(&plan.maps.at(*at), share));
        pinned.iter().copied().chain(free).collect()
    };
    let system = plan.choice.system;
    let room = own(&laid.inside, OWN_SHAPE);
    let places = relax_places(system, &plan.maps, &laid, &room, ROOM_REACH, ROUNDS);
    let own = own(&places, 1.0);
    let domain = plan.surface();
    let kernel =
        |(at, own): (&SurfacePoint, &Parameters)| Kernel::new(system, domain, *at, own, &plan.maps.at(*at));
    let kernels: Vec<Kernel<SurfacePoint>> = places.iter().zip(&own).map(kernel).collect();
    let known: Vec<Numbers> = own.iter().map(numbers).collect();
    let interpolated = interpolate(domain, &kernels, &known, turned);
    let ground = &plan.maps.parameters;
    let mixed: Vec<Parameters> =
        ground.iter().zip(&interpolated).map(|(ground, spots)| mixed(ground, spots)).collect();
    plan.maps.parameters = mixed;
    places
}

/// How a spot differs from what is wanted at its place.
struct Deviation {
    /// Its area ÷ the mean.
    area: f64,
    /// ln of its aspect ÷ the mean.
    rounder: f64,
    /// Degrees.
    turn: f64,
}

impl Deviation {
    /// The parameters of a spot that differs so, of whose shape this `share` is its own.
    fn of(&self, ground: &Parameters, share: f64) -> Parameters {
        let stretch = f64::from(ground.stretch) * libm::exp(share * self.rounder);
        Parameters {
            rate: (f64::from(ground.rate) / self.area) as f32,
            stretch: stretch.clamp(f64::from(MIN_STRETCH), 1.0) as f32,
            direction: (f64::from(ground.direction) + share * self.turn) as f32,
            ..*ground
        }
    }
}

/// The deviations of spots at these places, with the spread that is asked about each anchor.
fn deviations(plan: &BodyPlan, places: &[SurfacePoint], seed: u64) -> Vec<Deviation> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed ^ SEED);
    let vertices: Vec<usize> = places.iter().map(|at| plan.surface().vertex_of(*at)).collect();
    let mut all: Vec<Deviation> =
        places.iter().map(|_| Deviation { area: 1.0, rounder: 0.0, turn: 0.0 }).collect();
    for anchor in 0..plan.anchors.len() {
        // The spots about an anchor have its mean together.
        let group: Vec<usize> =
            (0..places.len()).filter(|spot| plan.influence.nearest(vertices[*spot]) == anchor).collect();
        let asked: Vec<Spots> = group
            .iter()
            .filter_map(|spot| match plan.wanted[vertices[*spot]] {
                Attributes::Spots(spots) => Some(spots),
                Attributes::Stripes(_) => None,
            })
            .collect();
        let spread = plan.anchors[anchor].spread;
        let mut scores = || stratified(group.len(), &mut rng).into_iter();
        let found_areas = areas(scores().map(|score| (score, spread.area)));
        let found_aspects = aspects(scores().map(|score| (score, spread.aspect)), &asked);
        let weights = asked.iter().zip(&found_aspects).map(|(wanted, aspect)| 1.0 - wanted.aspect - aspect);
        let found_turns =
            turns(scores().map(|score| (score, spread.angle)), weights.collect::<Vec<_>>().into_iter());
        for (k, spot) in group.into_iter().enumerate() {
            let rounder = libm::log((asked[k].aspect + found_aspects[k]) / asked[k].aspect);
            all[spot] = Deviation { area: found_areas[k], rounder, turn: found_turns[k] };
        }
    }
    all
}

/// 1, ln rate, ln ratio, ln pitch, and −ln stretch · (cos 2θ, sin 2θ).
type Numbers = [f64; 6];

fn numbers(p: &Parameters) -> Numbers {
    let [rate, ratio, pitch] = [p.rate, p.ratio, p.pitch].map(|value| libm::log(f64::from(value)));
    let (sin, cos) = libm::sincos(2.0 * f64::from(p.direction).to_radians());
    let long = -libm::log(f64::from(p.stretch));
    [1.0, rate, ratio, pitch, long * cos, long * sin]
}

/// The numbers in a frame that is turned by some degrees.
fn turned(numbers: &Numbers, degrees: f64) -> Numbers {
    let [one, rate, ratio, pitch, x, y] = *numbers;
    let (sin, cos) = libm::sincos(2.0 * degrees.to_radians());
    [one, rate, ratio, pitch, cos * x - sin * y, sin * x + cos * y]
}

/// The parameters among `spots`, and of the `ground` far from all.
fn mixed(ground: &Parameters, spots: &Numbers) -> Parameters {
    let of_ground = numbers(ground);
    let left = (1.0 - spots[0]).max(0.0);
    let [_, rate, ratio, pitch, x, y]: Numbers = std::array::from_fn(|k| spots[k] + left * of_ground[k]);
    let stretch = libm::exp(-(x * x + y * y).sqrt()).clamp(f64::from(MIN_STRETCH), 1.0);
    let direction = if x == 0.0 && y == 0.0 { 0.0 } else { 0.5 * libm::atan2(y, x).to_degrees() };
    Parameters {
        rate: libm::exp(rate) as f32,
        ratio: libm::exp(ratio) as f32,
        pitch: libm::exp(pitch) as f32,
        stretch: stretch as f32,
        direction: direction as f32,
    }
}
