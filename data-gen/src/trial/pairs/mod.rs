//! Measures how well weaves, mazes, cells and stripes with tips match what was drawn, with random sketches in complete
//! documents.
//!
//! ```text
//!  kind ─▶ sketch (seed, index) ─▶ grown ─▶ the pattern picture ─▶ rulers ─▶ median, 95 %, largest against bounds
//! ```
//!
//! The picture that `dapple grow --pattern` writes, with its 16 bits, is measured. From the growth itself only its
//! notes are read, and for cells which of the planned ones have grown separately.

mod cells;
mod edges;
mod mazes;
mod sketch;
mod stripes;
mod table;
mod weaves;

use std::path::PathBuf;
use std::time::Instant;

use dapple::document::SystemChoice;
use dapple_engine::grid::Field;
use dapple_engine::synth::{GrownLayer, Growth, Options, Training};

use super::dice::Dice;
use super::grown::written;
use super::{parallel, pictures};
use sketch::Sketch;

/// The seed of all sketches: the year of the paper of Witkin and Kass.
const SEED: u64 = 1991;

/// The options of the trial.
#[derive(clap::Args)]
pub struct Args {
    /// Random sketches [default: the number in the documentation, 40; for mazes 20]
    #[arg(long, value_name = "N")]
    sketches: Option<u64>,
    /// The index of the first random sketch
    #[arg(long, value_name = "N", default_value_t = 0)]
    from: u64,
    /// Threads to use; each grows its own documents [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Grow the same lines as Meinhardt's stripes instead, to compare both
    #[arg(long)]
    meinhardt: bool,
    /// Also print the errors of each sketch
    #[arg(long)]
    each: bool,
    /// Also write each document, its texture and its pattern into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// A figure that is compared.
pub(super) struct Figure {
    /// Its name, with the unit in which errors are printed.
    pub name: &'static str,
    /// The factor from an error to this unit.
    pub factor: f64,
    /// Bounds of the median and 95th percentile of |error|, in that unit.
    pub bounds: Option<[f64; 2]>,
}

/// The errors of each figure; the reason where nothing can be measured.
pub(super) type Errors = Result<Vec<Vec<f64>>, String>;

/// A kind of trial.
pub(super) struct Kind {
    /// Its name.
    pub name: &'static str,
    /// The default number of sketches.
    pub count: u64,
    /// The figures that are compared.
    pub figures: &'static [Figure],
    /// Makes a random sketch.
    sketch: fn(&mut Dice) -> Sketch,
    /// Measures the errors of a grown layer on its picture.
    measure: fn(&Sketch, &GrownLayer, &Field) -> Errors,
}

pub(super) static WEAVES: Kind = Kind {
    name: "weaves",
    count: 40,
    figures: weaves::FIGURES,
    sketch: weaves::sketch,
    measure: weaves::measure,
};
pub(super) static MAZES: Kind = Kind {
    name: "mazes",
    count: 20,
    figures: mazes::FIGURES,
    sketch: mazes::sketch,
    measure: mazes::measure,
};
pub(super) static CELLS: Kind = Kind {
    name: "cells",
    count: 40,
    figures: cells::FIGURES,
    sketch: cells::sketch,
    measure: cells::measure,
};
pub(super) static PAIR_STRIPES: Kind = Kind {
    name: "pair-stripes",
    count: 40,
    figures: stripes::FIGURES,
    sketch: stripes::sketch,
    measure: stripes::measure,
};

/// The outcome of a sketch.
pub(super) struct Outcome {
    /// Its kind with its number.
    pub name: String,
    /// A description of the sketch.
    pub drawn: String,
    /// Time of its growth on one thread, s.
    pub seconds: f64,
    /// Notes of the growth.
    pub notes: Vec<String>,
    /// What was measured.
    pub errors: Errors,
}

/// Grows and measures sketches of a kind, and prints the table. Returns whether all bounds hold and nothing failed.
pub(super) fn run(kind: &'static Kind, args: &Args) -> Result<bool, String> {
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder)
            .map_err(|error| format!("cannot make the folder '{}': {error}", folder.display()))?;
    }
    let count = args.sketches.unwrap_or(kind.count);
    let tasks: Vec<u64> = (args.from..args.from.saturating_add(count)).collect();
    let started = Instant::now();
    let threads = parallel::threads(args.threads);
    let name = |index: &u64| format!("{}-{index:03}", kind.name);
    let work = |index: &u64| outcome(kind, *index, &name(index), args);
    let outcomes = parallel::each(&tasks, threads, name, work)?;
    let (text, good) = table::table(kind, &outcomes, args.each);
    crate::say(&text)?;
    let seconds = started.elapsed().as_secs_f64();
    crate::say(&format!("{} sketches in {seconds:.0} s on {threads} threads", outcomes.len()))?;
    Ok(good)
}

/// Grows and measures one sketch.
fn outcome(kind: &Kind, index: u64, name: &str, args: &Args) -> Result<Outcome, String> {
    let mut dice = Dice::from_seed(SEED * 10_000 + index);
    let mut sketch = (kind.sketch)(&mut dice);
    if args.meinhardt {
        sketch.system = SystemChoice::Stripes;
    }
    let document = sketch.document(index + 1);
    let started = Instant::now();
    let training = Training::default();
    let grown =
        Growth::begin(&document, &Options { source: name, training: &training, ..Options::default() }, None)
            .run();
    let seconds = started.elapsed().as_secs_f64();
    let drawn = sketch.to_string();
    let unmeasured = |why: String| Outcome {
        name: name.to_owned(),
        drawn: drawn.clone(),
        seconds,
        notes: Vec::new(),
        errors: Err(why),
    };
    let grown = match grown {
        Ok(grown) => grown,
        Err(error) => return Ok(unmeasured(error.to_string())),
    };
    let Some(layer) = grown.layers.first() else { return Ok(unmeasured("nothing has grown".to_owned())) };
    let pattern = written(layer, document.size);
    let errors = (kind.measure)(&sketch, layer, &pattern);
    let notes = sketch::notes(layer);
    if let Some(folder) = &args.out {
        pictures::write(folder, name, &document, &[pattern])?;
    }
    Ok(Outcome { notes, errors, ..unmeasured(String::new()) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_sketches_are_valid_documents_that_depend_on_their_index_alone() {
        for kind in [&WEAVES, &MAZES, &CELLS, &PAIR_STRIPES] {
            for index in 0..40 {
                let document =
                    |_: u8| (kind.sketch)(&mut Dice::from_seed(SEED * 10_000 + index)).document(index + 1);
                document(0).check(kind.name).unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(document(0), document(1));
            }
        }
    }

    #[test]
    fn a_small_sketch_of_cells_is_grown_and_measured() {
        let mut dice = Dice::from_seed(3);
        let sketch = Sketch { side: 160.0, ..cells::of_area(&mut dice, 400.0, 5.0, 0.7) };
        let grown = Growth::begin(&sketch.document(1), &Options::default(), None).run().expect("cells");
        let layer = &grown.layers[0];
        let errors = cells::measure(&sketch, layer, &written(layer, [160, 160])).expect("measured");
        assert_eq!(errors.len(), cells::FIGURES.len());
        assert!(errors[0][0].abs() < 0.05 && errors[1][0].abs() < 0.2, "{errors:?}");
    }
}
