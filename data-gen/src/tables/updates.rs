//! Cell updates of growths, expected and actual. They are equal on every machine.

use dapple::document::Document;
use dapple_engine::synth::marks::plan::Targets;
use dapple_engine::synth::{Engine, Growth, Options, Training};

use super::{example, golden};
use crate::say;

const EXAMPLES: [&str; 8] =
    ["zebra", "cheetah-run", "fallow-deer", "tiger", "poppy-seeds", "starry-sky", "dart-frog", "bongo"];

/// Millions of updates, expected ÷ actual, layer by layer, for the golden documents and some examples.
pub fn print() -> Result<(), String> {
    let mut all = golden()?;
    for name in EXAMPLES {
        all.push((name.to_owned(), example(name)?));
    }
    for (name, document) in all {
        let (expected, taken) = (expected(&document)?, taken(&document)?);
        let pairs = expected.iter().zip(&taken);
        let cells: Vec<String> =
            pairs.map(|(e, t)| format!("{:.1}/{:.1} = {:.2}", e / 1e6, t / 1e6, e / t)).collect();
        say(&format!("{name}: {}", cells.join(", ")))?;
    }
    Ok(())
}

fn expected(document: &Document) -> Result<Vec<f64>, String> {
    let mut beneath = None;
    let mut all = Vec::new();
    for index in 0..document.layers.len() {
        let size = document.size.map(f64::from);
        let targets = Targets::read(document, index, "document", size, beneath.as_ref())
            .map_err(|error| error.to_string())?;
        let lookup = targets.look_up(Training::built_in()).map_err(|error| error.to_string())?;
        let seed = document.layer_seed(index);
        let begun = lookup.rough(Vec::new()).begin(seed);
        all.push(Engine::new(&begun, seed).updates_left());
        beneath = Some(begun.plan.lookup);
    }
    Ok(all)
}

fn taken(document: &Document) -> Result<Vec<f64>, String> {
    let options = Options { refine: Some(false), ..Options::default() };
    let grown = Growth::begin(document, &options, None).run().map_err(|error| error.to_string())?;
    let updates = |grid: [usize; 2], steps: u64| steps as f64 * (grid[0] * grid[1]) as f64;
    Ok(grown.layers.iter().map(|layer| updates(layer.grid(), layer.steps())).collect())
}
