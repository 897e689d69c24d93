//! Ragged edges on a surface: noise in space is added where the pattern has its edges, as [`crate::points::roughened`] does on canvases, until
//! the contour is as long as is asked.

use crate::attributes::Attributes;
use crate::grid::{Domain, UnionFind};
use crate::measure::{SurfaceSpot, surface_stripes};
use crate::points::roughened::{SCALE, Sums, modes};
use crate::points::solid_noise::SolidNoise;
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::threshold::Levelled;
use crate::synth::edge_search::EdgeSearch;
use crate::synth::marks::grow::ragged::SEED;
use crate::synth::marks::plan::raggedness::excess;
use crate::synth::pattern::{EDGE, share};

/// Makes the deviation of the noise ½, as on canvases: noise in space has 0.22.
const NORMALISED: f64 = 0.5 / 0.22;
/// How far from its centre a spot is roughened, in its larger radius.
const REACH: f64 = 2.0;
/// Halvings of the range of levels: to 0.001.
const HALVINGS: usize = 10;
/// Pieces smaller than this share of a mark are removed, and holes of this size are filled.
const PIECE: f64 = 0.5;

/// The pattern of `levelled` with edges of this σ; levels `correct` its marks again. The plan gets the levels of what is returned.
#[must_use]
pub fn roughened(plan: &mut BodyPlan, levelled: Levelled, sigma: f64, seed: u64, corrects: bool) -> Levelled {
    let wanted: Vec<Attributes> = plan.anchors.iter().map(|anchor| anchor.wanted).collect();
    let asked = wanted.iter().map(|wanted| excess(wanted, sigma)).sum::<f64>() / wanted.len().max(1) as f64;
    if asked <= 0.0 {
        return levelled;
    }
    let noise = noise(plan, &levelled, seed ^ SEED);
    let smooth = contour(plan, &levelled.pattern);
    plan.levels = vec![EDGE; plan.levels.len()];
    let mut search = EdgeSearch::new(asked);
    loop {
        let mut rough = with_noise(&levelled.pattern, &noise, search.amount() as f32);
        tidy(plan, &mut rough);
        let found = if plan.choice.system.is_striped() {
            with_area(plan, &rough, &levelled)
        } else {
            Levelled { before: levelled.before.clone(), ..Levelled::new(plan, &rough, corrects) }
        };
        let length = contour(plan, &found.pattern) / smooth;
        if !search.tried(found, length * length - 1.0) {
            return search.best().unwrap_or(levelled);
        }
    }
}

/// Stripes of the area that they had. Their width is that of before: edges that are longer would make it smaller.
fn with_area(plan: &BodyPlan, rough: &[f32], smooth: &Levelled) -> Levelled {
    let area = |pattern: &[f32]| surface_stripes(plan.surface(), pattern, EDGE, 1, &|_| 0)[0].area;
    let wanted = area(&smooth.pattern);
    let at = |level: f32| -> Vec<f32> { rough.iter().map(|value| share(*value, level)).collect() };
    let [mut low, mut high] = [0.2, 0.8];
    for _ in 0..HALVINGS {
        let level = 0.5 * (low + high);
        if area(&at(level)) > wanted { low = level } else { high = level }
    }
    Levelled {
        pattern: at(0.5 * (low + high)),
        before: smooth.before.clone(),
        measured: smooth.measured.clone(),
    }
}

/// The length of the edges, px.
fn contour(plan: &BodyPlan, pattern: &[f32]) -> f64 {
    surface_stripes(plan.surface(), pattern, EDGE, 1, &|_| 0)[0].contour
}

/// Half of the width of marks, px.
fn radius(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => (spots.area / std::f64::consts::PI).sqrt(),
        Attributes::Stripes(stripes) => 0.5 * stripes.width,
    }
}

/// The noise at each vertex, without what would change the area of a spot, move it, stretch it or turn it.
fn noise(plan: &BodyPlan, levelled: &Levelled, seed: u64) -> Vec<f32> {
    let surface = plan.surface();
    let mean = plan.wanted.iter().map(radius).sum::<f64>() / plan.wanted.len().max(1) as f64;
    let solid = SolidNoise::new(SCALE * mean, 2, seed);
    let mut noise: Vec<f64> =
        surface.mesh.positions.iter().map(|at| NORMALISED * (solid.at(*at) - 0.5)).collect();
    let spots = &levelled.measured.spots;
    let owner = owners(plan, spots);
    let mut sums = vec![Sums::default(); spots.len()];
    for (vertex, owner) in owner.iter().enumerate() {
        let p = f64::from(levelled.pattern[vertex].clamp(0.0, 1.0));
        // Large at the edge and nearly 0 elsewhere.
        let weight = libm::pow(4.0 * p * (1.0 - p), 8.0);
        if let Some((spot, away)) = owner.filter(|_| weight > 1e-3) {
            let modes = modes(away);
            sums[spot].square += weight * modes * modes.transpose();
            sums[spot].product += weight * noise[vertex] * modes;
        }
    }
    let found: Vec<_> = sums.iter().map(|sums| sums.solved(true)).collect();
    for (noise, owner) in noise.iter_mut().zip(&owner) {
        if let Some((spot, away)) = owner {
            *noise -= found[*spot].dot(&modes(*away));
        }
    }
    noise.into_iter().map(|noise| noise as f32).collect()
}

/// The nearest spot of each vertex that is near to one, and the displacement from its centre.
fn owners(plan: &BodyPlan, spots: &[SurfaceSpot]) -> Vec<Option<(usize, [f64; 2])>> {
    let surface = plan.surface();
    let mut owner: Vec<Option<(usize, [f64; 2])>> = vec![None; surface.cells()];
    for (index, spot) in spots.iter().enumerate() {
        let reach = REACH * spot.radii[0] / surface.unit();
        for (vertex, away) in surface.near(spot.place, reach, 0..surface.cells()) {
            let square = |[x, y]: [f64; 2]| x * x + y * y;
            if owner[vertex].is_none_or(|(_, known)| square(away) < square(known)) {
                owner[vertex] = Some((index, away));
            }
        }
    }
    owner
}

fn with_noise(pattern: &[f32], noise: &[f32], amount: f32) -> Vec<f32> {
    let at = |(value, noise): (&f32, &f32)| {
        let p = value.clamp(0.0, 1.0);
        (p + amount * noise * 4.0 * p * (1.0 - p)).clamp(0.0, 1.0)
    };
    pattern.iter().zip(noise).map(at).collect()
}

/// Removes pieces of less than half of a mark, and fills such holes.
fn tidy(plan: &BodyPlan, pattern: &mut [f32]) {
    let surface = plan.surface();
    let is_mark: Vec<bool> = pattern.iter().map(|value| *value >= EDGE).collect();
    let mut pieces = UnionFind::new(pattern.len());
    for (vertex, mark) in is_mark.iter().enumerate() {
        for other in surface.ring(vertex).filter(|other| is_mark[*other] == *mark) {
            pieces.join(vertex as u32, other as u32, [0, 0]);
        }
    }
    let roots: Vec<usize> = (0..pattern.len()).map(|vertex| pieces.root(vertex as u32).0 as usize).collect();
    let mut areas = vec![0.0; pattern.len()];
    roots.iter().enumerate().for_each(|(vertex, root)| areas[*root] += surface.cell_area(vertex));
    for (vertex, value) in pattern.iter_mut().enumerate() {
        let radius = radius(&plan.wanted[vertex]);
        if areas[roots[vertex]] < PIECE * std::f64::consts::PI * radius * radius {
            // As far on the other side of the edge.
            *value = (1.0 - *value).clamp(0.0, 1.0);
        }
    }
}
