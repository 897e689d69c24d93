//! `dapple film --turn`: a model that turns about its upward axis.

use std::sync::atomic::Ordering;

use super::Args;
use crate::cli::estimate::Estimate;
use crate::cli::progress::Bar;
use crate::cli::{self, Error};
use crate::document::{Body, Document};
use crate::export::Stopped;
use crate::export::body::View;
use crate::export::motion::{COLOURS, Film, Kind};
use crate::files::{self, read_model, write_film};
use crate::machine::free_memory;
use crate::synth::body::{BodyGrowth, Shown};
use crate::synth::render::clip::SIDE;
use crate::synth::{Options, Stage, Watch};

/// From where the first frame shows it: azimuth and elevation, degrees.
const VIEW: [f64; 2] = [-30.0, 18.0];

/// Refuses a turn of a document without a model, and of one into another.
///
/// # Errors
/// [`Error::Usage`] with what is allowed.
pub fn model<'a>(args: &Args, document: &'a Document) -> Result<&'a Body, Error> {
    let file = args.file.display();
    document.model.as_ref().ok_or_else(|| {
        Error::Usage(format!(
            "--turn: {file} grows on no model; allowed: a document that has a \"model\", or without --turn"
        ))
    })
}

/// Grows a document on a model and films it from all sides.
///
/// # Errors
/// It cannot be grown, or the film cannot be written.
pub fn run(args: &Args, document: &Document, kind: Kind) -> Result<(), Error> {
    let body = model(args, document)?;
    let model = read_model(&args.file, body, None)?;
    let cancelled = cli::install();
    let cancelled = || cancelled.load(Ordering::Relaxed);
    let bar = Bar::new(args.quiet);
    let watch = Watch { progress: &|stage, share| bar.show(stage, share), cancelled: &cancelled };
    let training = files::training(args.training.clone());
    let source = files::source(&args.file);
    let options = Options {
        refine: args.no_refine.then_some(false),
        source: &source,
        training: &training,
        memory: Some(free_memory()),
        time: args.limits.time(),
        watch,
        ..Options::default()
    };
    let bytes = model.as_ref().map(|model| model.bytes.as_slice());
    let mut growth = BodyGrowth::begin(document, bytes, &options)?;
    let seconds = loop {
        growth.advance(1).map_err(Error::grown)?;
        if let Some(seconds) = growth.seconds() {
            break seconds;
        }
    };
    let estimate = Estimate { training: &training, quiet: args.quiet };
    estimate.announce_seconds(seconds / rayon::current_num_threads() as f64);
    let grown = growth.run().map_err(Error::grown)?;
    let side = args.side.unwrap_or(SIDE);
    let view = View { turns: true, ..View::new(VIEW[0], VIEW[1], [side; 2]) };
    let shown = Shown::new(&grown, &view, &watch);
    let frames = args.clip().frames(kind).map_err(super::film_error)?;
    let mut palette = shown.palette(&view);
    palette.truncate(COLOURS);
    let film =
        Film { size: [side as usize; 2], frames, fps: args.fps, hold: hold(args), once: args.once, palette };
    let written = write_film(&args.output, kind, &film, |show| {
        for frame in 0..frames {
            let share = frame as f64 / frames as f64;
            watch.step(Stage::Write, share).map_err(|_| Stopped::Cancelled)?;
            let view = View { azimuth: VIEW[0] + 360.0 * share, ..view };
            show(&shown.picture(&view).rgb())?;
        }
        Ok(())
    });
    bar.clear();
    written.map_err(Error::exported)?.keep().map_err(Error::step)
}

/// Seconds for which the last frame stays: a turn goes on without a halt unless one is asked for.
fn hold(args: &Args) -> f64 {
    args.hold.unwrap_or(0.0)
}
