//! `dapple film`: a growth, the change from one document to another, or a model that turns, as a film.

mod turn;

use super::estimate::{Estimate, Underway};
use super::flat::check_flat;
use super::limits::Limits;
use super::paths::check_apart;
use super::progress::Bar;
use super::settings::Settings;
use super::{Error, values};
use crate::document::Document;
use crate::export::motion::Kind;
use crate::files::{self, ReadFile, SaveFilm, film_kind};
use crate::finish::Finish;
use crate::machine::{free_memory, this_machine, threads};
use crate::synth::estimate::Task;
use crate::synth::render::clip::{self, Clip, ClipError};
use crate::synth::render::film::Scene;
use crate::synth::render::morph::{Morph, MorphError};
use crate::synth::{Options, Watch, memory};
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// Arguments of `dapple film`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document to film while it grows
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Where to write the film: .gif, .png or .apng (animated PNG), or a new folder for numbered PNG
    #[arg(short, long, value_name = "OUT.gif")]
    pub output: PathBuf,
    /// Change the document into this one instead of growing it
    #[arg(long, value_name = "OTHER.dapple")]
    pub to: Option<PathBuf>,
    /// Grow a document on a model, then turn it once about its upward axis
    #[arg(long, conflicts_with = "to")]
    pub turn: bool,
    /// The longer side of a frame, px [default: that of the canvas, at most 480]
    #[arg(long, value_name = "PX", value_parser = values::whole(clip::SIDES))]
    pub side: Option<u32>,
    /// Duration without the hold at the end, seconds
    #[arg(long, value_name = "S", default_value_t = 4.0, value_parser = values::positive)]
    pub seconds: f64,
    /// Frames per second
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = values::whole(clip::RATES))]
    pub fps: u16,
    /// Stop at the last frame [default: repeat]
    #[arg(long)]
    pub once: bool,
    #[arg(
        long, value_name = "S", value_parser = values::seconds,
        help = format!("Extra seconds for the last frame before the film repeats [default: {}]", Clip::default().hold)
    )]
    pub hold: Option<f64>,
    /// Use this seed instead of that of the document
    #[arg(long, value_name = "N", value_parser = values::seed)]
    pub seed: Option<u64>,
    /// Use the parameters as looked up; do not correct them by what has grown
    #[arg(long, conflicts_with = "to")]
    pub no_refine: bool,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    pub training: Option<PathBuf>,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    #[command(flatten)]
    pub settings: Settings,
    #[command(flatten)]
    pub limits: Limits,
    /// Show no progress
    #[arg(short, long)]
    pub quiet: bool,
}

impl Args {
    /// Checks the arguments; returns the kind of film.
    fn check(&self) -> Result<Kind, Error> {
        for (name, file) in [("FILE", Some(&self.file)), ("--to", self.to.as_ref())] {
            file.map_or(Ok(()), |file| check_apart(name, file, &self.output))?;
        }
        let kind = film_kind(&self.output).map_err(Error::step)?;
        self.clip().frames(kind).map_err(film_error)?;
        Ok(kind)
    }

    fn clip(&self) -> Clip {
        let Self { side, seconds, fps, once, hold, .. } = *self;
        Clip { side, seconds, fps, once, hold: hold.unwrap_or(Clip::default().hold) }
    }

    /// Checks that the finish of a frame of `documents` fits into memory, before anything grows.
    fn check_finish(&self, documents: &[&Document]) -> Result<(), Error> {
        if documents.iter().all(|document| document.finish.is_none()) {
            return Ok(());
        }
        // Frames that are smaller than the canvas are finished at its size.
        let frame = self.clip().film(documents, 0).size;
        let sides = [0, 1].map(|axis| frame[axis].max(documents[0].size[axis] as usize) as f64);
        let needed = sides[0] * sides[1] * Finish::BYTES_A_PX;
        memory::check_export("the finish", needed, "choose a smaller --side", Some(free_memory()))
            .map_err(Error::step)
    }

    /// Says which given options do nothing.
    fn say_idle(&self, kind: Kind) {
        if !self.quiet {
            self.idle(kind).iter().for_each(|line| super::note(line));
        }
    }

    /// One note for each given option that has no effect on a film of this `kind`.
    fn idle(&self, kind: Kind) -> Vec<String> {
        let repeats = "it is for a film that repeats, a .gif, .png or .apng without --once";
        let given = [
            ("--once", self.once && kind == Kind::Folder, "it is for a .gif, .png or .apng"),
            ("--hold", self.hold.is_some() && (kind == Kind::Folder || self.once), repeats),
        ];
        let idle = given.into_iter().filter(|(_, is_idle, _)| *is_idle);
        idle.map(|(option, _, why)| format!("{option} has no effect here; {why}")).collect()
    }
}

/// Films a model that turns.
fn film_turn(args: &Args, document: &Document, kind: Kind) -> Result<(), Error> {
    turn::model(args, document)?;
    args.threads.into_iter().for_each(threads::set_shared);
    turn::run(args, document, kind)?;
    args.say_idle(kind);
    Ok(())
}

/// Films a growth, or the change from one document to another.
///
/// # Errors
/// A document is invalid or cannot be grown, the two do not fit together, or the film cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    let kind = args.check()?;
    let document = args.settings.read(&args.file)?;
    let document = Document { seed: args.seed.unwrap_or(document.seed), ..document };
    if args.turn {
        return film_turn(args, &document, kind);
    }
    check_flat(&document, &args.file, "a film without --turn")?;
    let other = args.to.as_deref().map(Document::read).transpose()?;
    if let (Some(other), Some(file)) = (&other, &args.to) {
        check_flat(other, file, "a film")?;
    }
    let documents: Vec<&Document> = [Some(&document), other.as_ref()].into_iter().flatten().collect();
    args.check_finish(&documents)?;
    args.threads.into_iter().for_each(threads::set_shared);
    let cancelled = super::install();
    let cancelled = || cancelled.load(Ordering::Relaxed);
    let training = files::training(args.training.clone());
    let estimate = Estimate { training: &training, quiet: args.quiet };
    let bar = Bar::new(args.quiet);
    let source = files::source(&args.file);
    // Each texture is grown twice: the first time measures how much each moment changes.
    let task =
        Task { document: &document, size: document.size, source: &source, scale: 1, machine: this_machine() };
    let finished_frames = args.clip().frames(kind).map_err(film_error)? as f64;
    let announced = other.is_none() && estimate.announce(&[task], 2.0, finished_frames);
    let underway = Underway::begin(2 * document.layers.len(), args.quiet || announced || other.is_some());
    let show = |stage, share| {
        bar.show(stage, share);
        bar.note(underway.show(stage, share));
    };
    let watch = Watch { progress: &show, cancelled: &cancelled };
    let written = if let (Some(other), Some(path)) = (&other, &args.to) {
        let there = path.display().to_string();
        let morph = Morph::new((&document, &source), (other, &there), (&training, this_machine()), &watch);
        let morph = morph.map_err(|error| match error {
            MorphError::Grow(error) => Error::grown(error),
            unlike @ MorphError::Unlike { .. } => Error::step(unlike),
        })?;
        estimate.announce_seconds(morph.seconds());
        args.clip().film_change([&document, other], &morph, &args.output, kind, &watch)
    } else {
        let refine = args.no_refine.then_some(false);
        let options = Options {
            refine,
            source: &source,
            training: &training,
            memory: Some(free_memory()),
            time: args.limits.time(),
            watch,
            ..Options::default()
        };
        let scene = Scene { document: &document, options };
        args.clip().film_growth(&scene, &args.output, kind)
    };
    bar.clear();
    let (prepared, _) = written.map_err(film_error)?;
    prepared.keep().map_err(Error::step)?;
    args.say_idle(kind);
    Ok(())
}

/// The error of this command for an error of the film.
fn film_error(error: ClipError) -> Error {
    match error {
        wrong @ (ClipError::TooFast(_) | ClipError::Frames { .. }) => Error::Usage(wrong.to_string()),
        ClipError::Grow(error) => Error::grown(error),
        ClipError::Export(error) => Error::exported(error),
    }
}
