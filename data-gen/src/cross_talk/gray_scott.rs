//! The Gray–Scott model by plain steps, for comparison: J. E. Pearson, "Complex patterns in a simple system", Science 261 (1993).
//!
//! u' = Dᵤ ∇²u − u v² + F (1 − u),  v' = D_v ∇²v + u v² − (F + k) v

use dapple_engine::attributes::Spots;
use dapple_engine::grid::{Edges, Field};
use dapple_engine::measure::{Picture, picture};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

/// A parameter, the factors by which it is multiplied, and the effects of that on the attributes of spots.
pub struct Row {
    pub name: &'static str,
    pub factors: [f64; 2],
    /// Of each of [`ATTRIBUTES`], the change of its logarithm ÷ that of the parameter, averaged over the seeds; `None` where there are no
    /// spots to measure.
    pub effects: Option<[f64; ATTRIBUTES.len()]>,
}

/// What is measured.
pub const ATTRIBUTES: [&str; 3] = ["area", "spacing", "aspect"];

/// Spots that divide until the canvas is full, and then rest.
const USUAL: Parameters = Parameters { feed: 0.0367, kill: 0.0649, diffusion: 1.0 };

#[derive(Clone, Copy)]
struct Parameters {
    feed: f64,
    kill: f64,
    /// Multiplies both coefficients of diffusion.
    diffusion: f64,
}

/// Cells along each side, and the steps that are taken.
const SIDE: usize = 160;
const STEPS: usize = 12_000;
/// Dᵤ and D_v, cells² a step.
const DIFFUSION: [f64; 2] = [0.16, 0.08];

/// A parameter, its two factors, and what follows from such a factor.
type Knob = (&'static str, [f64; 2], fn(f64) -> Parameters);

/// The parameters, one after the other.
pub fn matrix(seeds: u64) -> Vec<Row> {
    let knobs: [Knob; 5] = [
        ("F", [0.8, 1.2], |by| Parameters { feed: USUAL.feed * by, ..USUAL }),
        ("F", [0.95, 1.05], |by| Parameters { feed: USUAL.feed * by, ..USUAL }),
        ("k", [0.8, 1.2], |by| Parameters { kill: USUAL.kill * by, ..USUAL }),
        ("k", [0.99, 1.01], |by| Parameters { kill: USUAL.kill * by, ..USUAL }),
        ("D", [0.8, 1.2], |by| Parameters { diffusion: USUAL.diffusion * by, ..USUAL }),
    ];
    knobs.map(|(name, factors, of)| Row { name, factors, effects: effects(factors, of, seeds) }).into()
}

fn effects(factors: [f64; 2], of: fn(f64) -> Parameters, seeds: u64) -> Option<[f64; ATTRIBUTES.len()]> {
    let change = |seed: u64| {
        let [low, high] = factors.map(|factor| measured(of(factor), seed));
        let (low, high, asked) = (low?, high?, (factors[1] / factors[0]).ln());
        Some([0, 1, 2].map(|index| (high[index] / low[index]).ln() / asked))
    };
    let changes: Option<Vec<_>> = (1..=seeds).into_par_iter().map(change).collect();
    let changes = changes?;
    Some(
        [0, 1, 2].map(|index| changes.iter().map(|change| change[index]).sum::<f64>() / changes.len() as f64),
    )
}

/// Area, spacing and aspect of the spots, cells; `None` if there are none.
fn measured(parameters: Parameters, seed: u64) -> Option<[f64; 3]> {
    let values = simulated(parameters, seed);
    let highest = values.iter().copied().fold(0.0, f32::max);
    let field = Field { width: SIDE, height: SIDE, cell: [1.0, 1.0], edges: Edges::Wrap, values };
    match picture(&field, 0.5 * highest)? {
        Picture::Spots { got: Spots { area, aspect, spacing: Some(spacing), .. }, .. } => {
            Some([area, spacing, aspect])
        }
        _ => None,
    }
}

/// The concentration of v after all steps.
fn simulated(Parameters { feed, kill, diffusion }: Parameters, seed: u64) -> Vec<f32> {
    let mut dice = Pcg64Mcg::seed_from_u64(seed);
    let (mut u, mut v) = (vec![1.0_f32; SIDE * SIDE], vec![0.0_f32; SIDE * SIDE]);
    for _ in 0..40 {
        let [x, y] = [0, 1].map(|_| dice.random_range(0..SIDE));
        for at in (0..36).map(|cell| (y + cell / 6) % SIDE * SIDE + (x + cell % 6) % SIDE) {
            (u[at], v[at]) = (0.5, 0.25);
        }
    }
    let [du, dv] = DIFFUSION.map(|coefficient| (coefficient * diffusion) as f32);
    let (feed, loss) = (feed as f32, (feed + kill) as f32);
    let (mut next_u, mut next_v) = (u.clone(), v.clone());
    for _ in 0..STEPS {
        for y in 0..SIDE {
            let rows = [(y + SIDE - 1) % SIDE, y, (y + 1) % SIDE].map(|row| row * SIDE..(row + 1) * SIDE);
            let [above_u, here_u, below_u] = rows.clone().map(|row| &u[row]);
            let [above_v, here_v, below_v] = rows.clone().map(|row| &v[row]);
            for x in 0..SIDE {
                let (left, right) = ((x + SIDE - 1) % SIDE, (x + 1) % SIDE);
                let spread = |above: &[f32], here: &[f32], below: &[f32]| {
                    above[x] + below[x] + here[left] + here[right] - 4.0 * here[x]
                };
                let (a, b) = (here_u[x], here_v[x]);
                let made = a * b * b;
                next_u[y * SIDE + x] = a + du * spread(above_u, here_u, below_u) - made + feed * (1.0 - a);
                next_v[y * SIDE + x] = b + dv * spread(above_v, here_v, below_v) + made - loss * b;
            }
        }
        (u, next_u) = (next_u, u);
        (v, next_v) = (next_v, v);
    }
    v
}
