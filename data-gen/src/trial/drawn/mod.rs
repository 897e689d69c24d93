//! Checks, mark by mark, whether a drawn mark grows at the place where it was drawn.
//!
//! ```text
//!  scattered (a, b, c) ─┐              ┌─▶ shapes ─▶ spots, paths ─▶ table, CSV
//!  curved (d, e) ───────┴─▶ documents ─▶ grown
//!                                      └─▶ sheets: drawn beside grown
//! ```
//!
//! The sketches come from a fixed seed. The pattern is measured by separate code ([`shapes`]). Of the growth's report
//! only the list of drawn marks is read, to check whether it names the missing ones correctly.

mod attempt;
mod csv;
mod curved;
mod drawing;
mod geometry;
mod limits;
mod named;
mod paths;
mod scattered;
mod shapes;
mod sheets;
mod spots;
mod table;

use std::path::PathBuf;
use std::time::Instant;

use clap::ValueEnum;
use dapple::document::{Document, Layer, Stroke};
use dapple_engine::marks::Path;
use dapple_engine::synth::passes::Entry;

use super::dice::Dice;
use super::parallel;
use super::passes::{self, PassArgs};
use attempt::Task;
use scattered::Rules;

/// The seed of all sketches: the year of Turk's paper.
const SEED: u64 = 1991;
/// Sides of the canvas, px.
const SIDE: f64 = 512.0;

/// The options of this trial.
#[derive(clap::Args)]
pub struct Args {
    /// Kinds of sketches
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["a", "b", "c", "d"])]
    kinds: Vec<Kind>,
    /// Only this number of sketches of each kind
    #[arg(long, value_name = "N")]
    take: Option<u64>,
    /// The spread to grow with; with both, the default is measured and the other one is only timed
    #[arg(long, value_enum, default_value = "both")]
    spread: Spread,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    training: Option<PathBuf>,
    #[command(flatten)]
    passes: PassArgs,
    /// Threads to use; each grows its own documents [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Write documents, textures, reports and contact sheets into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write a row for each drawn mark
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// A kind of sketch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Scattered ellipses that keep apart
    A,
    /// Ellipses at independent uniform places
    B,
    /// Narrow ellipses that keep apart
    C,
    /// Curved strokes
    D,
    /// Curved strokes that are wider than the gaps between them
    E,
}

/// The spread with which documents are grown.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Spread {
    /// The spread of the drawn marks
    Default,
    /// No spread
    #[value(name = "0")]
    Zero,
    /// The default spread, and once more without spread
    Both,
}

impl Kind {
    /// Whether its sketches are strokes; otherwise they are ellipses.
    fn is_striped(self) -> bool {
        matches!(self, Self::D | Self::E)
    }

    /// Its letter.
    fn letter(self) -> &'static str {
        match self {
            Self::A => "a",
            Self::B => "b",
            Self::C => "c",
            Self::D => "d",
            Self::E => "e",
        }
    }

    /// A description of its sketches.
    fn title(self) -> &'static str {
        match self {
            Self::A => "scattered ellipses, kept apart",
            Self::B => "ellipses at uniform random places",
            Self::C => "narrow ellipses, kept apart",
            Self::D => "curved strokes",
            Self::E => "curved strokes, wider than their gaps",
        }
    }

    /// The number of sketches.
    fn count(self) -> u64 {
        match self {
            Self::A => 200,
            Self::B | Self::D => 100,
            Self::C => 60,
            Self::E => 42,
        }
    }

    /// The strokes of sketch `index`, which do not depend on other sketches.
    fn strokes(self, index: u64) -> Vec<Stroke> {
        let mut dice = Dice::from_seed(SEED * 10_000 + self as u64 * 1_000 + index);
        let ellipses = |dice: &mut Dice, rules| {
            scattered::draw(dice, index, rules).into_iter().map(Stroke::Ellipse).collect()
        };
        let paths = |paths: Vec<Path>| paths.into_iter().map(Stroke::Path).collect();
        let usual = Rules { aspect: [0.35, 1.0], apart: true, arranged: true };
        match self {
            Self::A => ellipses(&mut dice, usual),
            Self::B => ellipses(&mut dice, Rules { apart: false, arranged: false, ..usual }),
            Self::C => ellipses(&mut dice, Rules { aspect: [0.15, 0.35], ..usual }),
            Self::D => paths(curved::draw(&mut dice, index, curved::THIN)),
            Self::E => paths(curved::draw(&mut dice, index, curved::WIDE)),
        }
    }

    /// Sketch `index`.
    fn sketch(self, index: u64) -> Task {
        let name = format!("{}-{index:03}", self.letter());
        let layer = Layer { name: "marks".to_owned(), strokes: self.strokes(index), ..Layer::default() };
        let document =
            Document { name: name.clone(), seed: index + 1, layers: vec![layer], ..Document::default() };
        Task { kind: self, name, document }
    }
}

/// Grows and measures the sketches, and prints the table. Returns whether all limits hold and nothing failed.
pub fn run(args: &Args) -> Result<bool, String> {
    let mut kinds = args.kinds.clone();
    kinds.sort_by_key(|kind| *kind as u8);
    kinds.dedup();
    let count = |kind: Kind| args.take.map_or(kind.count(), |take| take.min(kind.count()));
    let reseeded = |task: Task| Task { document: args.passes.reseeded(task.document), ..task };
    let tasks: Vec<Task> = kinds
        .iter()
        .flat_map(|kind| (0..count(*kind)).map(|index| kind.sketch(index)))
        .map(reseeded)
        .collect();
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder)
            .map_err(|error| format!("cannot make the folder '{}': {error}", folder.display()))?;
    }
    let started = Instant::now();
    let threads = parallel::threads(args.threads);
    let training = dapple::files::training(args.training.clone());
    let name = |task: &Task| task.name.clone();
    let work = |task: &Task| task.run(args.spread, &training, &args.passes, args.out.as_deref());
    let attempts = parallel::each(&tasks, threads, name, work)?;
    let (text, good) = table::table(&kinds, &attempts);
    crate::say(&text)?;
    let entries: Vec<Entry> = attempts.iter().flat_map(|attempt| &attempt.passes).copied().collect();
    crate::say(&passes::table(&entries))?;
    let seconds = started.elapsed().as_secs_f64();
    crate::say(&format!("{} sketches in {seconds:.0} s on {threads} threads", attempts.len()))?;
    if let Some(path) = &args.csv {
        csv::write(path, &attempts)?;
    }
    if let Some(folder) = &args.out {
        sheets::write(folder, &kinds, &attempts)?;
    }
    Ok(good)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dapple_engine::marks::Ellipse;
    use geometry::{outline, well_apart};

    fn ellipses(kind: Kind, index: u64) -> Vec<Ellipse> {
        let ellipse =
            |stroke| if let Stroke::Ellipse(ellipse) = stroke { ellipse } else { panic!("{index}") };
        kind.strokes(index).into_iter().map(ellipse).collect()
    }

    #[test]
    fn a_sketch_depends_on_its_kind_and_index_alone() {
        assert_eq!(Kind::A.strokes(7), Kind::A.strokes(7));
        assert_ne!(Kind::A.strokes(7), Kind::A.strokes(8));
        assert_ne!(Kind::A.strokes(7), Kind::C.strokes(7));
    }

    #[test]
    fn sketches_are_valid_documents_within_their_ranges() {
        for (kind, aspect) in [(Kind::A, [0.35, 1.0]), (Kind::B, [0.35, 1.0]), (Kind::C, [0.15, 0.35])] {
            for index in 0..30 {
                let marks = ellipses(kind, index);
                assert!((8..=30).contains(&marks.len()), "{kind:?} {index}: {}", marks.len());
                for mark in &marks {
                    assert!((59.9..=1500.1).contains(&mark.area()), "{kind:?} {index}: {mark:?}");
                    assert!(mark.aspect() > aspect[0] - 1e-9 && mark.aspect() < aspect[1] + 1e-9);
                }
                let apart = |k: usize| marks[..k].iter().all(|other| well_apart(&marks[k], other));
                assert!(kind == Kind::B || (0..marks.len()).all(apart), "{kind:?} {index}");
                kind.sketch(index).document.check("sketch").unwrap();
            }
        }
    }

    #[test]
    fn most_marks_that_keep_apart_are_whole_and_some_are_cut() {
        let all: Vec<Ellipse> = (0..60).flat_map(|index| ellipses(Kind::A, index)).collect();
        let on = |mark: &&Ellipse| outline(mark).iter().flatten().all(|x| (0.0..=SIDE).contains(x));
        let whole = all.iter().filter(on).count() as f64 / all.len() as f64;
        assert!((0.9..0.999).contains(&whole), "{whole}");
    }

    #[test]
    fn curved_strokes_are_valid_documents_that_bend_no_more_than_two_periods_allow() {
        for (kind, index) in
            [Kind::D, Kind::E].into_iter().flat_map(|kind| (0..42).map(move |index| (kind, index)))
        {
            let most = if kind == Kind::D { curved::THIN[1] } else { curved::WIDE[1] };
            kind.sketch(index).document.check("sketch").unwrap();
            for stroke in kind.strokes(index) {
                let Stroke::Path(Path { points, width }) = stroke else { panic!("{index}") };
                assert!((3.8..=16.8).contains(&width) && points.len() > 5, "{index}");
                assert!(points.iter().flatten().all(|x| (0.0..=SIDE).contains(x)), "{index}");
                for three in points.windows(3) {
                    let [a, b, c] = [three[0], three[1], three[2]];
                    let way = |a: [f64; 2], b: [f64; 2]| libm::atan2(b[1] - a[1], b[0] - a[0]);
                    let bend = dapple_engine::marks::turn(
                        2.0 * way(b, c).to_degrees(),
                        2.0 * way(a, b).to_degrees(),
                    );
                    let length = 0.5 * (geometry::distance(a, b) + geometry::distance(b, c));
                    // The last point may be closer to the one before it than the other points are.
                    let radius = length / (0.5 * bend.abs()).to_radians().max(1e-9);
                    assert!(
                        radius > 1.6 * width / most,
                        "{index} {}: {radius} {width}",
                        curved::SHAPES[index as usize % 7]
                    );
                }
            }
        }
    }
}
