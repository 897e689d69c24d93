//! How much smaller spots are on a coarse mesh: their area ÷ spacing² by the number of vertices a spacing.

mod lattice;
mod patch;

use std::io::Write;
use std::path::PathBuf;

use dapple::files;
use dapple_engine::rd::{Parameters, System};

use patch::{Grown, Patch};

/// Where to write it.
#[derive(clap::Args)]
pub struct Args {
    /// The rows
    #[arg(short, long, value_name = "OUT.csv", default_value = "training/fineness.csv")]
    output: PathBuf,
}

/// D_b/Dₐ of Meinhardt's spots.
const RATIOS: [f32; 6] = [12.0, 15.0, 20.0, 30.0, 42.0, 60.0];
/// Minor ÷ major axis of the tensor.
const STRETCHES: [f32; 5] = [1.0, 0.8, 0.6, 0.45, 0.35];
/// Vertices a spacing. The limit is that of the last two.
const FINENESS: [f64; 7] = [8.0, 10.0, 12.0, 16.0, 20.0, 28.0, 40.0];
/// Patches of each.
const SEEDS: u64 = 2;
/// Degrees from one patch to the next: any direction to the lattice, whose own are 60° apart.
const TURN: f32 = 37.0;

/// Grows all patches and writes their rows.
pub fn run(args: &Args) -> Result<(), String> {
    let mut rows = String::from("seed,ratio,stretch,direction,grid,fineness,spots,area,factor\n");
    let mut seed = 0;
    for ratio in RATIOS {
        for stretch in STRETCHES {
            for _ in 0..SEEDS {
                seed += 1;
                let direction = (TURN * seed as f32) % 180.0;
                let parameters = Parameters { rate: 1.0, ratio, stretch, direction, pitch: 1.0 };
                let patch = Patch::new(System::MEINHARDT_SPOTS, parameters, seed);
                let first = format!("{seed},{ratio},{stretch},{direction}");
                rows.push_str(&of_patch(&patch, &first)?);
                crate::say(&format!("{first}: {} spots", patch.laid()))?;
            }
        }
    }
    files::save(&args.output, |out| Ok(out.write_all(rows.as_bytes())?)).map_err(|error| error.to_string())
}

/// The rows of a patch on triangles and on a grid.
fn of_patch(patch: &Patch, first: &str) -> Result<String, String> {
    let on_triangles = FINENESS.map(|fineness| patch.on_triangles(fineness));
    let on_grid = FINENESS.map(|fineness| patch.on_grid(fineness));
    let mut rows = String::new();
    for (grid, grown) in [on_triangles, on_grid].iter().enumerate() {
        let grown: Vec<Grown> = grown.iter().copied().collect::<Option<_>>().ok_or("spots do not grow on surfaces")?;
        let limit = limit(&grown);
        for Grown { fineness, spots, area } in &grown {
            let factor = area / limit;
            rows.push_str(&format!("{first},{grid},{fineness:.3},{spots},{area:.6},{factor:.5}\n"));
        }
    }
    Ok(rows)
}

/// The area on an endlessly fine mesh: it differs by 1/fineness² from those of the two finest.
fn limit(grown: &[Grown]) -> f64 {
    let [.., a, b] = grown else { return f64::NAN };
    let [coarse, fine] = [a, b].map(|grown| 1.0 / (grown.fineness * grown.fineness));
    b.area + (b.area - a.area) * fine / (coarse - fine)
}
