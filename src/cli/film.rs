//! `dapple film`: a growth, or the way from one document to another, as a clip.

use super::estimate::{Estimate, Task};
use super::grow::{place, progress::Bar};
use super::{Error, values};
use crate::export::motion::{self, COLOURS, Film, Kind};
use crate::export::{ExportError, Stopped};
use crate::synth::film::{FilmError, Scene, Takes, fitted, palette};
use crate::synth::morph::{Morph, MorphError};
use crate::synth::recipe::Document;
use crate::synth::{GrowError, Options, Training, Watch};
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// px of the longer side of a frame, unless it is said: clips are looked at small.
const SIDE: u32 = 480;
/// Hundredths of a second are what a GIF counts in, and browsers take one for ten.
const FASTEST_GIF: u16 = 50;
/// Frames of the longest film.
const MOST: f64 = 20_000.0;

/// What to film, and how.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document to film while it grows
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Where to write the film: .gif, .png or .apng (animated PNG), or a new folder for numbered PNG
    #[arg(short, long, value_name = "OUT.gif")]
    pub output: PathBuf,
    /// Do not grow the document but turn it into this one
    #[arg(long, value_name = "OTHER.dapple")]
    pub to: Option<PathBuf>,
    /// The longer side of a frame, px [default: the canvas's, at most 480]
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(16..=8192))]
    pub side: Option<u32>,
    /// How long it is, without the hold at the end
    #[arg(long, value_name = "S", default_value_t = 4.0, value_parser = values::positive)]
    pub seconds: f64,
    /// Frames a second
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u16).range(1..=120))]
    pub fps: u16,
    /// Stay at the last frame [default: begin again]
    #[arg(long)]
    pub once: bool,
    /// Show the last frame so many seconds longer before it begins again
    #[arg(long, value_name = "S", default_value_t = 1.5, value_parser = values::seconds)]
    pub hold: f64,
    /// Use this seed instead of the document's
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Take the parameters as looked up; do not correct them by what has grown
    #[arg(long, conflicts_with = "to")]
    pub no_refine: bool,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    pub training: Option<PathBuf>,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    /// Show no progress
    #[arg(short, long)]
    pub quiet: bool,
}

impl Args {
    /// What kind of film it is, where all can be as it is asked for.
    fn check(&self) -> Result<(Kind, usize), Error> {
        for (name, file) in [("FILE", Some(&self.file)), ("--to", self.to.as_ref())] {
            if file.is_some_and(|file| place(file) == place(&self.output)) {
                let file = self.output.display();
                return Err(Error::Usage(format!(
                    "{name} and --output: found {file} twice; allowed: two files"
                )));
            }
        }
        let kind = Kind::of(&self.output).map_err(Error::step)?;
        if kind == Kind::Gif && self.fps > FASTEST_GIF {
            let fps = self.fps;
            return Err(Error::Usage(format!(
                "--fps: found {fps}; allowed: 1 to {FASTEST_GIF} in a .gif, which browsers show no faster; .png takes 120"
            )));
        }
        let frames = (self.seconds * f64::from(self.fps)).round();
        if !(2.0..=MOST).contains(&frames) {
            return Err(Error::Usage(format!(
                "--seconds {} at --fps {}: make {frames} frames; allowed: 2 to {MOST}",
                self.seconds, self.fps
            )));
        }
        Ok((kind, frames as usize))
    }

    fn film(&self, documents: &[&Document], frames: usize) -> Film {
        let canvas = documents[0].size;
        let side = self.side.unwrap_or(SIDE.min(canvas[0].max(canvas[1])));
        Film {
            size: fitted(canvas, side as usize),
            frames,
            fps: self.fps,
            hold: self.hold,
            once: self.once,
            palette: palette(documents, COLOURS),
        }
    }
}

/// Films a growth, or the way from one document to another.
///
/// # Errors
/// Where a document is not valid or cannot be grown, the two do not fit, or the film cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    let (kind, frames) = args.check()?;
    let document = Document::read(&args.file)?;
    let document = Document { seed: args.seed.unwrap_or(document.seed), ..document };
    let other = args.to.as_deref().map(Document::read).transpose()?;
    if let Some(threads) = args.threads {
        // Fails only where the pool exists already, and nothing has used it yet.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    }
    let cancelled = super::install();
    let cancelled = || cancelled.load(Ordering::Relaxed);
    let training = Training::from(args.training.clone());
    let estimate = Estimate { training: &training, quiet: args.quiet };
    let bar = Bar::new(args.quiet);
    let watch = Watch { progress: &|stage, share| bar.show(stage, share), cancelled: &cancelled };
    let source = args.file.display().to_string();
    let prepared = if let (Some(other), Some(path)) = (&other, &args.to) {
        let there = path.display().to_string();
        let morph = Morph::new((&document, &source), (other, &there), &training, &watch);
        let morph = morph.map_err(|error| match error {
            MorphError::Grow(error) => Error::grown(error),
            unlike @ MorphError::Unlike { .. } => Error::step(unlike),
        })?;
        estimate.tell_seconds(morph.seconds());
        let film = args.film(&[&document, other], frames);
        written(args, kind, &film, &|show| morph.clone().play(frames, film.size, &watch, show))
    } else {
        // It is grown twice: once to see how much each moment changes.
        estimate.tell(&[Task { document: &document, source: &source, scale: 1 }], 2.0);
        let options = Options { refine: args.no_refine.then_some(false), ..Options::default() };
        let scene = Scene { document: &document, source: &source, training: &training, options };
        let takes = Takes::of(&scene, frames, &watch).map_err(Error::grown)?;
        let film = args.film(&[&document], takes.frames());
        written(args, kind, &film, &|show| takes.play(&scene, film.size, &watch, show))
    };
    bar.clear();
    prepared?.keep().map_err(Error::step)
}

/// What shows all frames, one after the other.
type Play<'a> = &'a dyn Fn(motion::Show) -> Result<(), FilmError>;

/// Writes the film, which does not have its name yet.
fn written(args: &Args, kind: Kind, film: &Film, play: Play) -> Result<motion::PreparedFilm, Error> {
    let mut failed: Option<GrowError> = None;
    let written = motion::write(&args.output, kind, film, |show| match play(show) {
        Ok(()) => Ok(()),
        Err(FilmError::Stopped(stopped)) => Err(stopped),
        Err(FilmError::Grow(error)) => {
            failed = Some(error);
            Err(Stopped::Cancelled)
        }
    });
    match (written, failed) {
        (_, Some(error)) => Err(Error::grown(error)),
        (Err(ExportError::Cancelled { .. }), None) => Err(Error::Interrupted),
        (written, None) => written.map_err(Error::step),
    }
}
