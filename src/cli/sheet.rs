//! `dapple sheet`: many documents → one picture with all textures and their names.

mod contact;
mod layout;
mod paper;
mod text;

pub use contact::{Contact, Thumbnail, write};

use super::estimate::Underway;
use super::flat::check_flat;
use super::paths::check_apart;
use super::progress;
use super::settings::Settings;
use super::{Error, values};
use crate::document::{Document, with_causes};
use crate::export::maps::Surface;
use crate::export::{Content, downscale, picture};
use crate::files;
use crate::machine::{free_memory, threads};
use crate::synth::Growth;
use crate::synth::render::painting::Painting;
use crate::synth::time::TimeLimit;
use crate::synth::{Options, Stage, Training, Watch};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use layout::{Layout, Shape, Spot};
use paper::Paper;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use text::Pen;

/// Pictures are painted with this many times the px of their thumbnails along each side, then scaled down.
pub(super) const SUPERSAMPLING: usize = 3;
/// Largest sheet, px. It takes 400 MB while it is made.
const MAX_PX: usize = 1 << 27;
/// Most lines of a name.
const NAME_LINES: usize = 3;
/// Steps of the progress bar for each picture.
const STEPS: f64 = 100.0;

/// Arguments of `dapple sheet`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The documents to grow, in the order of the sheet
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Where to write the sheet
    #[arg(short, long, value_name = "SHEET.png")]
    pub output: PathBuf,
    /// Documents in a row [default: chosen so that the sheet is slightly wider than high]
    #[arg(long, value_name = "N", value_parser = values::count)]
    pub columns: Option<usize>,
    /// The longer side of each picture, px
    #[arg(long, value_name = "PX", default_value_t = 256, value_parser = values::whole(32..=4096u32))]
    pub thumb: u32,
    /// Grow each document with K seeds, side by side: its own and the next ones
    #[arg(long, value_name = "K", default_value = "1", value_parser = values::count)]
    pub seeds: usize,
    /// Show reliefs, lit from the upper left, with marks of this height above the ground (negative: below it) [default:
    /// 4]
    #[arg(
        long, value_name = "PX", num_args = 0..=1, require_equals = true, default_missing_value = "4",
        value_parser = values::relief
    )]
    pub lit: Option<f64>,
    #[command(flatten)]
    pub settings: Settings,
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

/// A document, or why it cannot be read.
struct Entry {
    file: String,
    name: String,
    document: Result<Document, String>,
}

impl Entry {
    fn read(path: &Path, settings: &Settings) -> Self {
        let file = path.display().to_string();
        let document = settings.read(path).map_err(|error| with_causes(&error));
        let named = document.as_ref().ok().map(|document| document.name.trim().to_owned());
        let stem = || files::stem(path).unwrap_or_else(|| file.clone());
        let name = named.filter(|name| !name.is_empty()).unwrap_or_else(stem);
        Self { file, name, document }
    }

    /// Size of its pictures, px, with the proportions of the canvas.
    fn picture_size(&self, thumb: usize) -> [usize; 2] {
        let Ok(document) = &self.document else { return [thumb; 2] };
        let longest = f64::from(document.size[0].max(document.size[1]));
        document.size.map(|side| ((f64::from(side) / longest * thumb as f64).round() as usize).max(1))
    }

    fn seed(&self, picture: usize) -> u64 {
        self.document.as_ref().map_or(0, |document| document.seed).wrapping_add(picture as u64)
    }

    /// Grows picture number `picture` of `size` px, lit with marks `lit` px high: red, green, blue for each px.
    fn grow(
        &self,
        picture: usize,
        size: [usize; 2],
        lit: Option<f64>,
        training: &Training,
        watch: &Watch,
    ) -> Result<Vec<u8>, Error> {
        let document = self.document.as_ref().map_err(|reason| Error::step(reason.clone()))?;
        check_flat(document, Path::new(&self.file), "a sheet")?;
        let document = Document { seed: self.seed(picture), ..document.clone() };
        let options = Options {
            source: &self.file,
            training,
            memory: Some(free_memory()),
            time: TimeLimit::Usual,
            watch: *watch,
            ..Options::default()
        };
        let grown = Growth::begin(&document, &options, None).run().map_err(Error::grown)?;
        let fine = size.map(|side| SUPERSAMPLING * side);
        let painting = Painting::sized(&document, &grown, fine);
        let rgb = match lit {
            None => painting.rgb(),
            Some(relief) => {
                let scale = fine[0] as f64 / f64::from(document.size[0]);
                let surface = Surface { relief: vec![scale * relief], ..Surface::default() };
                painting.lit(&surface, document.edges, watch)
            }
        };
        Ok(downscale(&rgb, fine, size))
    }
}

/// Grows the documents and writes the sheet.
///
/// # Errors
/// The sheet cannot be written, or pictures are missing in it.
pub fn run(args: &Args) -> Result<(), Error> {
    args.files.iter().try_for_each(|file| check_apart("FILE", file, &args.output))?;
    let format = files::check_content(&args.output, Content::Colours).map_err(Error::step)?;
    if let Some(threads) = args.threads {
        threads::set_shared(threads);
    }
    let entries: Vec<Entry> = args.files.iter().map(|file| Entry::read(file, &args.settings)).collect();
    let pen = Pen::for_pictures_of(args.thumb as usize);
    let (layout, names) = lay_out(args, &entries, &pen)?;
    let mut paper = Paper::blank(layout.size);
    let missing = fill(args, &entries, &layout, &pen, &mut paper)?;
    for (spot, lines) in layout.spots.iter().zip(&names) {
        for (line, text) in lines.iter().enumerate() {
            pen.write(&mut paper, text, [spot.name[0], spot.name[1] + line * pen.line], text::INK);
        }
    }
    files::save(&args.output, |out| picture::rgb8(out, format, paper.size, &paper.rgb))
        .map_err(Error::exported)?;
    if missing.is_empty() {
        return Ok(());
    }
    let sheet = args.output.display().to_string();
    Err(Error::Tiles { sheet, all: entries.len() * args.seeds, why: missing })
}

/// The layout, and the lines of each name.
fn lay_out(args: &Args, entries: &[Entry], pen: &Pen) -> Result<(Layout, Vec<Vec<String>>), Error> {
    let thumb = args.thumb as usize;
    let columns = args.columns.unwrap_or_else(|| layout::columns(entries.len(), args.seeds));
    let width = layout::width(thumb, args.seeds);
    let names: Vec<_> = entries.iter().map(|entry| pen.wrap(&entry.name, width, NAME_LINES)).collect();
    let shape = |(entry, lines): (&Entry, &Vec<String>)| Shape {
        picture: entry.picture_size(thumb),
        name: lines.len() * pen.line,
    };
    let shapes: Vec<Shape> = entries.iter().zip(&names).map(shape).collect();
    let under = if args.seeds > 1 { pen.line } else { 0 };
    let layout = Layout::new(&shapes, columns, thumb, args.seeds, under);
    let [wide, high] = layout.size;
    if wide.saturating_mul(high) > MAX_PX {
        return Err(Error::Usage(format!(
            "the sheet would be {wide} × {high} px; allowed: {MAX_PX} px in all; choose a smaller --thumb, fewer \
             --seeds or fewer files"
        )));
    }
    Ok((layout, names))
}

/// Grows all pictures onto the paper; returns the reasons for those that are missing, one line each.
fn fill(
    args: &Args,
    entries: &[Entry],
    layout: &Layout,
    pen: &Pen,
    paper: &mut Paper,
) -> Result<Vec<String>, Error> {
    let cancelled = super::install();
    let cancelled = || cancelled.load(Ordering::Relaxed);
    let training = files::training(args.training.clone());
    let all = entries.len() * args.seeds;
    let bar = bar(args.quiet, all);
    let underway = Underway::begin(all, args.quiet);
    let mut missing = Vec::new();
    for (index, (entry, spot)) in entries.iter().zip(&layout.spots).enumerate() {
        for picture in 0..args.seeds {
            let done = index * args.seeds + picture;
            bar.set_message(format!("{} of {all}: {}", done + 1, entry.name));
            let show = |stage: Stage, share: f64| {
                if let Some(text) = underway.show(stage, share) {
                    bar.suspend(|| super::note(&text));
                }
                let share = progress::overall(stage, share);
                bar.set_position((STEPS * (done as f64 + share)) as u64);
            };
            let watch = Watch { progress: &show, cancelled: &cancelled };
            let at = [spot.pictures[picture], spot.top];
            match entry.grow(picture, spot.size, args.lit, &training, &watch) {
                Ok(rgb) => paper.place(&rgb, spot.size, at),
                Err(Error::Interrupted) => {
                    bar.finish_and_clear();
                    return Err(Error::Interrupted);
                }
                Err(error) => {
                    let reason = with_causes(&error);
                    draw_reason(paper, pen, &reason, spot, at);
                    missing.push(missing_line(entry, picture, args.seeds, &reason));
                }
            }
            if args.seeds > 1 && entry.document.is_ok() {
                let seed = format!("seed {}", entry.seed(picture));
                pen.write(paper, &seed, [at[0], spot.seeds], text::PALE);
            }
        }
    }
    bar.finish_and_clear();
    Ok(missing)
}

/// An empty tile with the reason in it.
fn draw_reason(paper: &mut Paper, pen: &Pen, reason: &str, spot: &Spot, at: [usize; 2]) {
    paper.fill(at, spot.size, paper::EMPTY);
    let inset = pen.line / 2;
    let [width, height] = spot.size.map(|side| side.saturating_sub(2 * inset));
    for (line, text) in pen.wrap(reason, width, height / pen.line).iter().enumerate() {
        pen.write(paper, text, [at[0] + inset, at[1] + inset + line * pen.line], text::RED);
    }
}

/// Why a picture is missing, with the file's name once.
fn missing_line(entry: &Entry, picture: usize, seeds: usize, reason: &str) -> String {
    let file = if reason.contains(&entry.file) { String::new() } else { format!("{}: ", entry.file) };
    let seed = if seeds > 1 && entry.document.is_ok() {
        format!("seed {}: ", entry.seed(picture))
    } else {
        String::new()
    };
    format!("{seed}{file}{reason}")
}

fn bar(quiet: bool, all: usize) -> ProgressBar {
    let bar = if quiet {
        ProgressBar::hidden()
    } else {
        ProgressBar::with_draw_target(Some(all as u64 * STEPS as u64), ProgressDrawTarget::stderr())
    };
    let style =
        ProgressStyle::with_template("{bar:40} {percent:>3} %  {elapsed} elapsed, {eta} left  {wide_msg}");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
