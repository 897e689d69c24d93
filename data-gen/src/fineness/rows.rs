//! The rows of all patches.

use std::fmt::Write;

use dapple_engine::rd::{Parameters, System};

use super::patch::{Grown, Patch};

/// Values of the ratio D_b/Dₐ.
const RATIOS: [f32; 6] = [12.0, 15.0, 20.0, 30.0, 42.0, 60.0];
/// Values of minor ÷ major axis of the tensor.
const STRETCHES: [f32; 5] = [1.0, 0.8, 0.6, 0.45, 0.35];
/// Values of the vertices per spacing. The limit is extrapolated from the last two.
const FINENESS: [f64; 7] = [8.0, 10.0, 12.0, 16.0, 20.0, 28.0, 40.0];
/// Patches for each combination.
const PATCHES: u64 = 2;
/// Rotation from one patch to the next, degrees, so that the directions relative to the lattice vary. Those of the
/// lattice are 60° apart.
const TURN: f32 = 37.0;

/// The names of the columns.
pub const HEADER: &str = "seed,ratio,stretch,direction,fineness,spots,area,factor,smooth,aspect\n";

/// The spots of all patches: seed and parameters.
pub fn patches() -> impl Iterator<Item = (u64, Parameters)> {
    let kinds = RATIOS.into_iter().flat_map(|ratio| STRETCHES.map(|stretch| (ratio, stretch)));
    let all = kinds.flat_map(|kind| (0..PATCHES).map(move |_| kind));
    all.zip(1..).map(|((ratio, stretch), seed)| {
        let direction = (TURN * seed as f32) % 180.0;
        (seed, Parameters { rate: 1.0, ratio, stretch, direction, pitch: 1.0 })
    })
}

/// The rows of one patch on which all spots are there; `None` where none of them grow on surfaces.
pub fn of_patch((seed, parameters): (u64, Parameters)) -> Option<String> {
    let system = System::ALL.into_iter().find(|system| system.definition().fineness.is_some())?;
    let patch = Patch::new(system, parameters, seed);
    let grown: Vec<Grown> =
        FINENESS.iter().map(|fineness| patch.on_triangles(*fineness)).collect::<Option<_>>()?;
    let [linear, smooth, aspect]: [fn(&Grown) -> f64; 3] =
        [|grown| grown.area, |grown| grown.smooth, |grown| grown.aspect];
    let limits = [limit(&grown, linear), limit(&grown, smooth), limit(&grown, aspect)];
    let mut rows = String::new();
    let Parameters { ratio, stretch, direction, .. } = parameters;
    for grown in grown.iter().filter(|grown| grown.spots == patch.laid()) {
        let Grown { fineness, spots, area, .. } = grown;
        let factor = linear(grown) / limits[0];
        let (smooth, aspect) = (smooth(grown) / limits[1], aspect(grown) / limits[2]);
        let _ = writeln!(
            rows,
            "{seed},{ratio},{stretch},{direction},{fineness:.3},{spots},{area:.6},{factor:.5},{smooth:.5},{aspect:.5}"
        );
    }
    Some(rows)
}

/// A value in the limit of an infinitely fine mesh: the error is proportional to 1/fineness², and follows from the two
/// finest meshes.
fn limit(grown: &[Grown], value: fn(&Grown) -> f64) -> f64 {
    let [.., a, b] = grown else { return f64::NAN };
    let [coarse, fine] = [a, b].map(|grown| 1.0 / (grown.fineness * grown.fineness));
    value(b) + (value(b) - value(a)) * fine / (coarse - fine)
}
