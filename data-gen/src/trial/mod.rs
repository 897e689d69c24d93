//! Measures how well textures match what was drawn, over all examples and many random sketches.
//!
//! ```text
//!  examples/*.dapple ─┐
//!                     ├─▶ grown ─▶ the pattern picture ─▶ measured, judged ─▶ statistics ─▶ table, JSON, pictures
//!  sketches (seed)  ──┘
//! ```
//!
//! The picture that `dapple grow --pattern` writes, with its 16 bits, is measured as `docs/format.md` defines. Nothing
//! is taken from the report of the growth.

mod attribute;
mod dice;
mod drawn;
mod grown;
mod output;
mod pairs;
mod parallel;
mod passes;
mod patches;
mod pictures;
mod sketches;
mod statistics;
mod table;
mod verdict;

use std::path::{Path, PathBuf};
use std::time::Instant;

use dapple::ReadFile;
use dapple::document::Document;
use dapple_engine::synth::passes::Entry;

use grown::Task;
use passes::PassArgs;

/// The options of the trial.
#[derive(clap::Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Args {
    #[command(subcommand)]
    what: Option<What>,
    /// Random sketches
    #[arg(long, value_name = "N", default_value_t = 100)]
    sketches: u64,
    /// The index of the first random sketch
    #[arg(long, value_name = "N", default_value_t = 0)]
    from: u64,
    /// The seed of the random sketches
    #[arg(long, value_name = "N", default_value_t = sketches::SEED)]
    seed: u64,
    /// The folder of the examples; where it is missing, there are none
    #[arg(long, value_name = "DIR", default_value = "examples")]
    examples: PathBuf,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    training: Option<PathBuf>,
    #[command(flatten)]
    passes: PassArgs,
    /// Threads to use; each grows its own documents [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Also write each document, its texture and its pattern into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Also write the numbers of each region, as JSON; - prints them instead of the table
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Other trials.
#[derive(clap::Subcommand)]
enum What {
    /// Grow fixed sketches and look for each drawn mark at its place
    Drawn(drawn::Args),
    /// Grow random sketches of ragged outlines and measure the patches
    Patches(patches::Args),
    /// Grow random weaves of two and three directions and measure their threads
    Weaves(pairs::Args),
    /// Grow random mazes and measure their lines and directions
    Mazes(pairs::Args),
    /// Grow random cells and measure their areas, shapes and gaps
    Cells(pairs::Args),
    /// Grow random stripes with tips and measure them
    PairStripes(pairs::Args),
}

/// Grows and measures all documents, and prints the table. Returns whether all values are within the bounds and nothing
/// failed.
pub fn run(args: &Args) -> Result<bool, String> {
    match &args.what {
        None => {}
        Some(What::Drawn(args)) => return drawn::run(args),
        Some(What::Patches(args)) => return patches::run(args),
        Some(What::Weaves(args)) => return pairs::run(&pairs::WEAVES, args),
        Some(What::Mazes(args)) => return pairs::run(&pairs::MAZES, args),
        Some(What::Cells(args)) => return pairs::run(&pairs::CELLS, args),
        Some(What::PairStripes(args)) => return pairs::run(&pairs::PAIR_STRIPES, args),
    }
    let tasks = tasks(args)?;
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder)
            .map_err(|error| format!("cannot make the folder '{}': {error}", folder.display()))?;
    }
    let started = Instant::now();
    let threads = parallel::threads(args.threads);
    let training = dapple::files::training(args.training.clone());
    let out = args.out.as_deref();
    let outcomes = parallel::each(
        &tasks,
        threads,
        |task| task.name.clone(),
        |task| task.run(&training, &args.passes, out),
    )?;
    let (text, good) = table::table(&outcomes);
    let entries: Vec<Entry> = outcomes.iter().flat_map(|outcome| &outcome.passes).copied().collect();
    let text = text + &passes::table(&entries);
    if args.json.as_deref() == Some(Path::new("-")) {
        crate::say(&format!("{:#}", output::json(args.seed, &outcomes)))?;
        return Ok(good);
    }
    crate::say(&text)?;
    crate::say(&format!(
        "{} documents in {:.0} s on {threads} threads, sketches from seed {}",
        outcomes.len(),
        started.elapsed().as_secs_f64(),
        args.seed
    ))?;
    if let Some(path) = &args.json {
        output::numbers(path, args.seed, &outcomes)?;
    }
    Ok(good)
}

/// The examples by name, then the sketches.
fn tasks(args: &Args) -> Result<Vec<Task>, String> {
    let mut files = Vec::new();
    if args.examples.is_dir() {
        let unreadable = |error| format!("cannot read the folder '{}': {error}", args.examples.display());
        for entry in std::fs::read_dir(&args.examples).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            if path.extension().is_some_and(|ending| ending == "dapple") {
                files.push(path);
            }
        }
    }
    files.sort();
    let mut tasks = Vec::new();
    for path in files {
        let document = args.passes.reseeded(Document::read(&path).map_err(|error| error.to_string())?);
        let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        tasks.push(Task { name, random: false, document });
    }
    for index in args.from..args.from.saturating_add(args.sketches) {
        let document = args.passes.reseeded(sketches::sketch(args.seed, index)?);
        tasks.push(Task { name: format!("random-{index:03}"), random: true, document });
    }
    Ok(tasks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dapple_engine::synth::Training;

    #[test]
    fn two_sketches_have_the_same_results_with_one_thread_and_with_two() {
        // A sketch of round spots in one region, and one of stripes, made small.
        let mut tasks = Vec::new();
        for (name, stroke) in [
            ("spot", r#"{"kind": "ellipse", "center": [20, 20], "radii": [6, 4], "angle": 30}"#),
            ("stripe", r#"{"kind": "line", "from": [10, 10], "to": [60, 30], "width": 6}"#),
        ] {
            let text = format!(
                r#"{{"format": "dapple", "version": 1, "size": [80, 80], "layers": [{{"strokes": [{stroke}]}}]}}"#
            );
            let document = Document::parse(&text, name).unwrap();
            tasks.push(Task { name: name.to_owned(), random: true, document });
        }
        let training = Training::default();
        let numbers = |threads| {
            let name = |task: &Task| task.name.clone();
            let outcomes =
                parallel::each(&tasks, threads, name, |task| task.run(&training, &PassArgs::default(), None))
                    .unwrap();
            assert!(outcomes.iter().all(|outcome| outcome.regions.len() == 1), "nothing was measured");
            let errors: Vec<_> = outcomes.iter().map(|outcome| outcome.regions[0].errors).collect();
            (outcomes.iter().map(|outcome| outcome.name.clone()).collect::<Vec<_>>(), errors)
        };
        let one = numbers(1);
        assert_eq!(one, numbers(2));
        assert!(one.1[0][0].is_some() && one.1[1][0].is_none(), "{one:?}");
    }
}
