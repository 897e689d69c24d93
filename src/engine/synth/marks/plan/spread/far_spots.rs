//! Spots far from all drawn marks: they are laid without these, so that they do not change when single marks are moved.
//!
//! ```text
//!  what is wanted far from marks, rounded ─▶ spots over the whole canvas (laid) ─▶ those far from marks stay
//!                                                    drawn marks, spots around them (rd: nuclei_among) ─▶ all
//! ```

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::attributes::free::Far;
use crate::attributes::{AttributeMap, Attributes, Spots, Spread};
use crate::grid::{Domain, Grid};
use crate::rd::{self, NucleiBefore, ParameterField, Parameters, Places};
use crate::synth::marks::plan::laid_out::{Arrangement, Plan};
use crate::synth::marks::plan::lattice::{Lattice, Node};
use crate::synth::marks::plan::layer_grid::{finest_cell, grid_of};
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};
use crate::synth::marks::plan::setting::Setting;
use crate::synth::marks::plan::spread::deviations::Scores;
use crate::synth::marks::plan::spread::laid::{Jitter, Laid, Spaced, lay_spaced, pinned_spots};

/// Steps to which the logarithm of areas is rounded, and −ln of the ratio by which the room of a spot is stretched: small changes
/// of the marks do not change the result.
const LN_STEP: f64 = 0.1;
/// Step to which the logarithm of the pitch is rounded; it matters only for spots that are far apart.
const LN_PITCH_STEP: f64 = 0.25;
/// Step to which the aspect is rounded.
const ASPECT_STEP: f64 = 0.05;
/// Step to which directions are rounded, degrees.
const ANGLE_STEP: f64 = 7.5;
/// Steps to which the spread is rounded. With finer steps (0.1, 5°, 0.05, 0.03) many moves of one of ten marks changed the result.
/// The spacing of spots varies by about 0.1 by itself.
const SPREAD_STEP: Spread = Spread { area: 0.2, angle: 15.0, aspect: 0.1, spacing: 0.12 };

/// The ratio of the layout; it only changes the rate that gives the spacing.
const USUAL_RATIO: f64 = 20.0;

/// Spots that have been laid over the whole canvas without the drawn ones.
pub struct FarSpots {
    /// Places, cells.
    places: Vec<[f64; 2]>,
    /// Their places without jitter, and those of the points beyond the edges, cells.
    even: Places,
    scores: Scores,
    jitter: Vec<Jitter>,
    /// The parameters with which they were laid.
    parameters: Parameters,
    /// By cell, whether it is near a mark.
    near: Vec<bool>,
}

/// Lays the spots far from the drawn ones of `plan`; `None` if no place is far from these, or if the wanted attributes vary there.
pub fn far_spots(plan: &Plan, seed: u64) -> Option<FarSpots> {
    let lookup = &plan.lookup;
    if plan.pinned_spots().is_empty() || !plan.obstacles.is_empty() || lookup.map.is_modulated() {
        return None;
    }
    let far = lookup.map.free()?.far()?;
    let near = near_cells(far, &lookup.grid);
    if !near.contains(&false) {
        return None;
    }
    let alone = without_marks(plan, far)?;
    let maps = alone.unpitched_maps();
    let Spaced { laid, places, jitter, pitch } = lay_spaced(&alone, &maps, seed);
    let on_plan = |at: Vec<[f64; 2]>| lookup.all_to_cells(&alone.lookup.all_to_px(&at));
    let places = on_plan(places);
    let even = Places { inside: on_plan(laid.places.inside), beyond: on_plan(laid.places.beyond), pinned: 0 };
    let mut parameters = alone.lookup.lattice.nodes[0].parameters(pitch[0]);
    parameters.rate *= (lookup.px_a_cell() / alone.lookup.px_a_cell()).powi(2) as f32;
    Some(FarSpots { places, even, scores: laid.scores, jitter, parameters, near })
}

/// By cell, whether it is near a mark.
fn near_cells(far: &Far, grid: &Grid) -> Vec<bool> {
    let mut near = vec![false; grid.cells()];
    let [wide, high] = grid.cell;
    for center in far.centers() {
        for (cell, [x, y]) in grid.near(grid.to_cells(*center), far.reach() / wide.min(high), 0..grid.cells())
        {
            let [x, y] = [x * wide, y * high];
            near[cell] |= x * x + y * y < far.reach() * far.reach();
        }
    }
    near
}

impl FarSpots {
    /// The drawn spots of `plan`, whose parameters are `maps`, with these spots far from them, and others between.
    pub fn with_marks<'a>(self, plan: &Plan, maps: &'a ParameterField, seed: u64) -> Spaced<'a> {
        let pitch = vec![self.pitch_near(plan)];
        let Self { places, even, scores, jitter, parameters, near } = self;
        let Lookup { system, grid, .. } = plan.lookup;
        let maps = plan.lookup.repitched(maps, &pitch);
        let is_near = |at: &[f64; 2]| near[grid.cell_at(*at)];
        let (giving_way, staying): (Vec<usize>, Vec<usize>) =
            (0..places.len()).partition(|index| is_near(&places[*index]));
        let (near_beyond, kept_beyond): (Vec<_>, Vec<_>) = even.beyond.into_iter().partition(is_near);
        let kept = [staying.iter().map(|index| places[*index]).collect(), kept_beyond];
        let giving = giving_way.iter().map(|index| even.inside[*index]).chain(near_beyond).collect();
        let before = NucleiBefore { kept, near: giving, open: near, parameters };
        let pinned = pinned_spots(plan, &pitch);
        let (first, from) = rd::nuclei_among(system, &maps, seed, &pinned, &before);
        let was = |near: Option<usize>| giving_way.get(near?).copied();
        let others: Vec<Option<usize>> =
            staying.into_iter().map(Some).chain(from.into_iter().map(was)).collect();
        // A random stream different from that of the spots laid before.
        let mut rng = Pcg64Mcg::seed_from_u64(seed ^ 0x6e65_6172);
        let scores = scores.among(pinned.len(), &others, &mut rng);
        let laid = Laid::with_room(plan, maps, &pitch, first, scores, rng);
        let places = laid.jittered(plan, &jitter);
        Spaced { laid, places, jitter, pitch }
    }

    /// The factor of the pitch for spots near marks: far from marks it would give the distance of these spots.
    fn pitch_near(&self, plan: &Plan) -> f64 {
        let Lookup { system, grid, lattice, .. } = &plan.lookup;
        let far = self.near.iter().position(|near| !near).unwrap_or(0);
        let own = lattice.at(grid.center_px(far)).parameters(1.0);
        system.spacing(&self.parameters) / system.spacing(&own)
    }
}

/// The plan for spots over the whole canvas that have the attributes wanted far from the drawn ones, without the drawn ones.
fn without_marks(plan: &Plan, far: &Far) -> Option<Plan> {
    let lookup = &plan.lookup;
    let Attributes::Spots(mean) = lookup.map.of_region([0, 0]) else { return None };
    let wanted = Spots {
        area: libm::exp(rounded(libm::log(mean.area), LN_STEP)),
        aspect: rounded(mean.aspect, ASPECT_STEP),
        angle: rounded(mean.angle, ANGLE_STEP),
        spacing: Some(far.spacing()),
    };
    let spread = lookup.spread(0).with(&SPREAD_STEP, rounded);
    let map = AttributeMap::uniform(lookup.map.layout(), Attributes::Spots(wanted)).with_spread(spread);
    // The plan has its own grid: the grid of the growth depends on the smallest drawn spot.
    let grid = grid_of(&map, finest_cell((lookup.system, lookup.polarity), &map));
    let node = laying(lookup, &wanted, far.spacing() / grid.px_a_cell());
    let lattice = Lattice { layout: *map.layout(), nodes: vec![node] };
    let lookup =
        Lookup { map, grid, lattice, start: Start::NATURAL, spreads: vec![spread], ..lookup.clone() };
    Some(Plan { lookup, arrangement: Arrangement::Natural, ..plan.clone() })
}

/// The parameters for laying spots `spacing` cells apart, with the room of the `wanted` spots; spots grow with other parameters.
fn laying(lookup: &Lookup, wanted: &Spots, spacing: f64) -> Node {
    let mean = Node::from_setting(&Setting::of(&lookup.answers[0]));
    let [c, s] = mean.shape;
    let long = rounded((c * c + s * s).sqrt(), LN_STEP);
    let (s, c) = libm::sincos((2.0 * wanted.angle).to_radians());
    let ln_ratio = libm::log(USUAL_RATIO);
    let ln_pitch = rounded(mean.ln_pitch, LN_PITCH_STEP);
    let unit = Node { ln_rate: 0.0, ln_ratio, shape: [long * c, long * s], ln_pitch, level: mean.level };
    // Lengths are proportional to 1/√rate.
    let ln_rate = 2.0 * libm::log(lookup.system.spacing(&unit.parameters(1.0)) / spacing);
    Node { ln_rate, ..unit }
}

/// The nearest multiple of `step`.
fn rounded(value: f64, step: f64) -> f64 {
    step * (value / step).round()
}
