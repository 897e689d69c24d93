//! The map of what the system Turing's growth makes at each growth and decay (Lawlor's figure 2): patches side by side,
//! with lines between the areas of blank, dots, worms and holes.

mod patch;
mod picture;

use std::io::Write;
use std::path::PathBuf;

use dapple::files;
use dapple_engine::export::gray_png;
use dapple_engine::rd::GrowthMap;
use rayon::prelude::*;

use patch::Patch;

/// Where to write the map.
#[derive(clap::Args)]
pub struct Args {
    /// The picture without texts; a second file with the ending svg has axes, border lines and names
    #[arg(short, long, value_name = "OUT.png", default_value = "assets/growth-map.png")]
    output: PathBuf,
}

/// Grows all patches, draws them and prints the kind of each.
pub fn run(args: &Args) -> Result<(), String> {
    let map = GrowthMap::SHOWN;
    let [columns, rows] = map.patches;
    let of = |index: usize| Patch::grown(map.growth(index % columns), map.decay(index / columns));
    let patches: Vec<Patch> = (0..columns * rows).into_par_iter().map(of).collect();
    crate::say("decay,growth,grows,ink")?;
    for (index, patch) in patches.iter().enumerate() {
        let (growth, decay) = (map.growth(index % columns), map.decay(index / columns));
        crate::say(&format!("{decay},{growth},{},{:.3}", patch.kind.name(), patch.ink))?;
    }
    let (size, values) = picture::gray(&map, &patches);
    let png = gray_png::encode(size, &values).map_err(|error| error.to_string())?;
    let svg = picture::svg(&map, &patches, size, &values);
    for (path, bytes) in [(args.output.clone(), png), (args.output.with_extension("svg"), svg.into_bytes())] {
        files::save(&path, |out| Ok(out.write_all(&bytes)?)).map_err(|error| error.to_string())?;
    }
    Ok(())
}
