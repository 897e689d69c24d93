//! Tables of the growths by which constants in the code and in `docs/` were chosen.

mod pinned;
mod seeding;
mod seeds;
mod spread;
mod updates;

use dapple::ReadFile;
use dapple::document::Document;
use dapple_engine::synth::{GrownLayer, GrownMarks, Growth, Options};

/// What to print.
#[derive(clap::Args)]
pub struct Args {
    /// The tables to print
    #[arg(required = true, value_enum)]
    tables: Vec<Table>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Table {
    /// How far drawn spots that are kept grow from their places: pairs close together, and marks near a closed edge
    Pairs,
    /// How many drawn lines of the examples lie in stripes, with and without keeping them
    Lines,
    /// How much spots vary, compared with the variation that was asked for
    Spread,
    /// How far stripes are from the drawn directions, for each kind of start
    Seeding,
    /// How much six other seeds change the attributes of golden textures: the tolerances of docs/golden.md
    Seeds,
    /// Cell updates, expected and actual: the shares in src/engine/synth/estimate.rs
    Updates,
}

/// Prints the tables; each line is printed as soon as it is grown.
pub fn run(args: &Args) -> Result<(), String> {
    args.tables.iter().try_for_each(|table| match table {
        Table::Pairs => pinned::pairs(),
        Table::Lines => pinned::lines(),
        Table::Spread => spread::print(),
        Table::Seeding => seeding::print(),
        Table::Seeds => seeds::print(),
        Table::Updates => updates::print(),
    })
}

/// The spots and stripes that grow from a document.
fn layers(document: &Document) -> Result<Vec<GrownMarks>, String> {
    let grown =
        Growth::begin(document, &Options::default(), None).run().map_err(|error| error.to_string())?;
    let marks = |layer: GrownLayer| layer.into_marks().ok_or_else(|| "a layer of pairs".to_owned());
    grown.layers.into_iter().map(marks).collect()
}

/// A document of the repository: `examples/NAME.dapple`.
fn example(name: &str) -> Result<Document, String> {
    Document::read(format!("examples/{name}.dapple")).map_err(|error| error.to_string())
}

/// The golden documents with their names, in order.
fn golden() -> Result<Vec<(String, Document)>, String> {
    let folder = "tests/golden/textures";
    let failed = |error: std::io::Error| format!("cannot read the folder '{folder}': {error}");
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|ending| ending == "dapple") {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            all.push((name, Document::read(&path).map_err(|error| error.to_string())?));
        }
    }
    all.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(all)
}
