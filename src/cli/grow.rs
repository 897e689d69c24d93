//! `dapple grow`: document → texture.

mod batch;
mod body;
mod body_picture;
mod finish;
mod idle;
mod look;
mod material;
mod outlines;
mod pictures;
mod textured;

use super::estimate::{Estimate, Underway};
use super::json::known;
use super::limits::Limits;
use super::map_argument::{MapArgument, read_map};
use super::paths::same_place;
use super::progress::Bar;
use super::settings::Settings;
use super::sheet::Thumbnail;
use super::{Error, values};
use crate::document;
use crate::document::{Document, Extent};
use crate::export::{Format, outline};
use crate::files::{self, Prepared, read_tone};
use crate::machine::clock::Instant;
use crate::machine::{free_memory, this_machine, threads};
use crate::synth::Growth;
use crate::synth::estimate::Task;
use crate::synth::import::tone::drive;
use crate::synth::layer_report::report;
use crate::synth::profile::{Section, during};
use crate::synth::report::{LayerReport, Report};
use crate::synth::{Options, Training, Watch};
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

/// Arguments that name files to read.
const INPUTS: [&str; 3] = ["FILE", "--tone", "--map"];
/// The most different notes of a layer that are listed on a terminal.
const MOST_NOTES: usize = 8;

/// Arguments of `dapple grow`.
#[derive(clap::Args, Clone, Debug)]
pub struct Args {
    /// The document to grow, or a PNG written by dapple, which grows the same picture again
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// More documents to grow: --output is then the folder for their pictures
    #[arg(value_name = "FILE")]
    pub more: Vec<PathBuf>,
    /// Grow the document with N seeds, its own and the next ones, into the folder --output, with a sheet of all pictures
    #[arg(long, value_name = "N", value_parser = values::count)]
    pub variations: Option<usize>,
    /// Where to write the picture (.png, .tif, .exr, .jpg, .webp) or its outlines (.svg, .dxf); for many pictures a folder
    #[arg(short, long, value_name = "OUT.png", required_unless_present_any = ["material", "svg", "dxf"])]
    pub output: Option<PathBuf>,
    /// Grow a canvas of W x H px, with marks of the same size
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    pub size: Option<[u32; 2]>,
    /// Write K times the px along each side; the texture stays the same [default: 1]
    #[arg(long, value_name = "K", value_parser = values::whole(1..=document::embedded::MAX_SCALE))]
    pub scale: Option<u32>,
    /// Let the lowest layer follow the picture IMG (JPEG, PNG, WebP, TIFF): more ink where it is darker, lines along
    /// its edges. The picture OUT.png holds the document with IMG in it
    #[arg(long, value_name = "IMG")]
    pub tone: Option<PathBuf>,
    /// Vary the lowest layer by a picture or by noise: WHAT=IMG:LOW:HIGH, the values at black and at white in place of the drawn ones;
    /// WHAT=IMG:LOW:HIGH:factor; WHAT=noise:SIZE:LOW:HIGH, factors. WHAT is area, spacing, direction, aspect, duty, colour or growth. The picture
    /// OUT.png holds the document with the maps in it
    #[arg(long = "map", value_name = "WHAT=IMG:LOW:HIGH")]
    pub maps: Vec<MapArgument>,
    /// Use this seed instead of that of the document
    #[arg(long, value_name = "N", value_parser = values::seed)]
    pub seed: Option<u64>,
    #[command(flatten)]
    pub look: look::Look,
    /// Also write the pattern: 16-bit gray (.png, .tif) or floating point (.exr); 0 = ground, half = the edge of a mark
    #[arg(long, value_name = "P.png")]
    pub pattern: Option<PathBuf>,
    /// Write only the pattern or the outlines of layer K (1 = the lowest)
    #[arg(long, value_name = "K", value_parser = values::whole(1..=255u32))]
    pub layer: Option<u32>,
    /// Also write the layer whose mark covers each px: 8-bit gray, 0 = none
    #[arg(long, value_name = "L.png")]
    pub labels: Option<PathBuf>,
    /// Also write the layer whose mark covers each px after the finish: 8-bit gray, 0 = none; without a finish as --labels
    #[arg(long, value_name = "M.png")]
    pub mask: Option<PathBuf>,
    /// Also write the concentrations of all chemicals: floating point, one channel each
    #[arg(long, value_name = "C.exr")]
    pub concentrations: Option<PathBuf>,
    #[command(flatten)]
    pub material: material::Material,
    /// Also write what was asked for and what has grown, as JSON; - prints it
    #[arg(long, value_name = "R.json")]
    pub report: Option<PathBuf>,
    /// Use the parameters as looked up; do not correct them by what has grown
    #[arg(long)]
    pub no_refine: bool,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    pub training: Option<PathBuf>,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    #[command(flatten)]
    pub body: body::BodyArgs,
    #[command(flatten)]
    pub limits: Limits,
    #[command(flatten)]
    pub settings: Settings,
    /// Show no progress
    #[arg(short, long)]
    pub quiet: bool,
    /// How outlines are drawn
    #[command(flatten)]
    pub outlines: outlines::OutlineArgs,
}

impl Args {
    /// Checks that a flat document has the layer --layer, and that no option is for models.
    fn check_layer(&self, document: &Document) -> Result<(), Error> {
        body::check_flat(self)?;
        let layers = document.layers.len();
        match self.layer {
            Some(layer) if layer as usize > layers => {
                let file = self.file.display();
                Err(Error::Usage(format!(
                    "--layer: found {layer}; allowed: 1 to {layers}, the layers of {file}"
                )))
            }
            _ => Ok(()),
        }
    }

    /// Checks that all outputs are different files, that none is the document, and that --layer has an output.
    ///
    /// # Errors
    /// [`Error::Usage`] or [`Error::WriteOver`] with the file's name.
    pub fn check_outputs(&self) -> Result<(), Error> {
        if let Some(layer) = self.layer
            && self.pattern.is_none()
            && !outlines::requested(self)
        {
            return Err(Error::Usage(format!(
                "--layer: found {layer} without an output for one layer; allowed: with --pattern, --svg, --dxf or -o OUT.svg"
            )));
        }
        let named = [
            ("FILE", Some(&self.file)),
            ("--tone", self.tone.as_ref()),
            ("--output", self.output.as_ref()),
            ("--pattern", self.pattern.as_ref()),
            ("--labels", self.labels.as_ref()),
            ("--mask", self.mask.as_ref()),
            ("--concentrations", self.concentrations.as_ref()),
            ("--report", self.report.as_ref()),
            ("--svg", self.outlines.svg.as_ref()),
            ("--dxf", self.outlines.dxf.as_ref()),
        ];
        let material = self.material.files(&self.file);
        let maps = self.maps.iter().filter_map(MapArgument::picture).map(|path| ("--map", path));
        let named = named.into_iter().filter_map(|(name, path)| Some((name, path?)));
        let named = maps.chain(named);
        let paths: Vec<_> = named.chain(material.iter().map(|path| ("--material", path))).collect();
        for (i, (name, path)) in paths.iter().enumerate() {
            // The same picture may be read for several maps.
            let same = |(other, at): &&(&str, &PathBuf)| {
                // `-` means standard input or standard output, which are not the same file.
                let is_input = INPUTS.contains(other);
                let piped = is_input && (files::is_pipe(at) || INPUTS.contains(name));
                (*name, *other) != ("--map", "--map") && !piped && same_place(at, path)
            };
            if let Some((other, _)) = paths[..i].iter().find(same) {
                if INPUTS.contains(other) {
                    let (name, file) = (other.to_string(), path.to_path_buf());
                    return Err(Error::WriteOver { name, output: paths[i].0, file });
                }
                let file = path.display();
                return Err(Error::Usage(format!(
                    "{name} and {other}: found {file} twice; allowed: two files"
                )));
            }
        }
        Ok(())
    }
}

/// Grows one document or many.
///
/// # Errors
/// A document is invalid or cannot be grown, or a file cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    if batch::is_requested(args) {
        batch::run(args)?;
    } else {
        let training = files::training(args.training.clone());
        grow_one(args, &Source { training: &training, thumbnail: None, of_batch: None })?;
    }
    if !args.quiet {
        idle::notes(args).iter().for_each(|line| super::note(line));
    }
    Ok(())
}

/// The common inputs of all growths of a command.
struct Source<'a> {
    training: &'a Training,
    /// Longer side of the thumbnail to return, px; `None` = no thumbnail.
    thumbnail: Option<usize>,
    /// The batch that the growth is part of.
    of_batch: Option<&'a Underway>,
}

/// Grows one document; returns its thumbnail if requested.
fn grow_one(
    args: &Args,
    Source { training, thumbnail, of_batch }: &Source,
) -> Result<Option<Thumbnail>, Error> {
    args.check_outputs()?;
    // Wrong file names are reported before errors in the document.
    check_targets(args)?;
    let (document, was) = opened(args)?;
    if let Some(model) = &document.model {
        body::grow(args, &document, model, training)?;
        return Ok(None);
    }
    args.check_layer(&document)?;
    let extent = Extent { size: args.size.or(was.size), scale: args.scale.unwrap_or(was.scale) };
    outlines::check(args, &document, extent)?;
    let size = extent.size.unwrap_or(document.size).map(|side| side as usize * extent.scale as usize);
    pictures::check(args, size)?;
    finish::check(args, &document, size)?;
    args.material.check_memory(&document, size[0], extent)?;
    args.threads.into_iter().for_each(threads::set_shared);
    let cancelled = super::install();
    let cancelled = || cancelled.load(Ordering::Relaxed);
    let bar = Bar::new(args.quiet);
    let source = files::source(&args.file);
    let announced = of_batch.is_some()
        || Estimate { training, quiet: args.quiet }.announce(&[task(&document, extent, &source)], 1.0, 1.0);
    let alone = Underway::begin(document.layers.len(), args.quiet || announced);
    let underway = of_batch.unwrap_or(&alone);
    let show = |stage, share| {
        bar.show(stage, share);
        bar.note(underway.show(stage, share));
    };
    let watch = Watch { progress: &show, cancelled: &cancelled };
    let started = Instant::now();
    let options = Options {
        size: extent.size,
        refine: args.no_refine.then_some(false),
        concentrations: args.concentrations.is_some(),
        source: &source,
        training,
        memory: Some(free_memory()),
        time: args.limits.time(),
        watch,
    };
    let grown = Growth::begin(&document, &options, None).run().map_err(Error::grown)?;
    let prepared = during(Section::Write, || pictures::prepare(args, &document, &grown, extent, &watch));
    let outlined = outlines::prepare(args, &document, &grown, extent, &watch);
    bar.clear();
    let (mut prepared, outlined) = (prepared?, outlined?);
    let seconds = started.elapsed().as_secs_f64();
    let drawn = outlined.map(|(files, drawn)| {
        prepared.extend(files);
        drawn
    });
    let outlines = drawn.as_ref().map(outlines::Drawn::report);
    let report = WrittenReport { report: report(&document, &source, &grown, seconds), outlines };
    prepared.extend(prepare_report(args, &report)?);
    // Either all files get their final names or none does: every file is complete on disk before the first one is
    // renamed.
    during(Section::Write, || files::keep_all(prepared)).map_err(Error::step)?;
    if args.report.as_deref().is_some_and(is_stdout) {
        super::print(&report.text()?)?;
    }
    if !args.quiet {
        say_notes(&report.report.layers, drawn.as_ref(), finish::note(args, &document).as_deref());
    }
    Ok(thumbnail.map(|side| Thumbnail::new(&document, &grown, side)))
}

/// Writes the report under a temporary name, if it is to be a file.
fn prepare_report(args: &Args, report: &WrittenReport) -> Result<Option<Prepared>, Error> {
    let Some(path) = args.report.as_ref().filter(|path| !is_stdout(path)) else { return Ok(None) };
    let text = report.text()?;
    files::prepare(path, |out| Ok(out.write_all(text.as_bytes())?)).map(Some).map_err(Error::step)
}

/// What is grown, to be estimated.
fn task<'a>(document: &'a Document, extent: Extent, source: &'a str) -> Task<'a> {
    let size = extent.size.unwrap_or(document.size);
    Task { document, size, source, scale: extent.scale, machine: this_machine() }
}

/// Prints the notes on the layers, on the outlines that were `drawn`, and on the finish.
fn say_notes(layers: &[LayerReport], drawn: Option<&outlines::Drawn>, finish: Option<&str>) {
    notes(layers).iter().for_each(|line| super::note(line));
    if let Some(drawn) = drawn {
        super::note(&drawn.text());
    }
    finish.into_iter().for_each(super::note);
}

/// The document, with the seed and the pictures that the arguments name.
fn opened(args: &Args) -> Result<(Document, Extent), Error> {
    let (document, was) = args.settings.open(&args.file)?;
    let mut document = Document { seed: args.seed.unwrap_or(document.seed), ..document };
    if let Some(picture) = &args.tone {
        drive(&mut document, read_tone(picture).map_err(Error::step)?);
    }
    for map in &args.maps {
        read_map(&mut document, map).map_err(Error::step)?;
    }
    if args.tone.is_some() || !args.maps.is_empty() {
        document.check(&files::source(&args.file))?;
    }
    Ok((document, was))
}

/// Whether the path is `-`, which means stdout.
fn is_stdout(path: &Path) -> bool {
    files::is_standard_output(path)
}

/// Checks whether all files can be written, before the growth starts.
fn check_targets(args: &Args) -> Result<(), Error> {
    let pictures = Format::ENDINGS.iter().map(|(ending, _)| *ending);
    let endings: Vec<_> = pictures.chain(outline::FORMATS).chain(body::MODELS).collect();
    let output = args.output.as_deref().map(|path| files::check_ending(path, &endings));
    let report = args.report.as_deref().filter(|path| !is_stdout(path)).map(files::check_file);
    [output, report].into_iter().flatten().collect::<Result<(), _>>().map_err(Error::step)?;
    pictures::check(args, [1, 1])
}

/// The report as `--report` writes it: with the outlines, where they were drawn.
#[derive(Serialize)]
struct WrittenReport {
    #[serde(flatten)]
    report: Report,
    #[serde(skip_serializing_if = "Option::is_none")]
    outlines: Option<outlines::OutlineReport>,
}

impl WrittenReport {
    fn text(&self) -> Result<String, Error> {
        // Written as text first, so that numbers of single precision keep their few digits.
        let text = serde_json::to_string(self).map_err(Error::step)?;
        Ok(format!("{:#}\n", known(serde_json::from_str(&text).map_err(Error::step)?)))
    }
}

/// The notes of a report as lines for a terminal. A note that several regions share is one line; of each layer at most
/// [`MOST_NOTES`] are listed.
fn notes(layers: &[LayerReport]) -> Vec<String> {
    let mut lines = Vec::new();
    for LayerReport { name, regions, notes, settled, .. } in layers {
        lines.extend(notes.iter().map(|note| format!("{name}: {note}")));
        let mut found: Vec<(&str, Vec<[usize; 2]>)> = Vec::new();
        for region in regions {
            for note in &region.notes {
                match found.iter_mut().find(|(text, _)| text == note) {
                    Some((_, places)) => places.push(region.place),
                    None => found.push((note, vec![region.place])),
                }
            }
        }
        let more = found.len().saturating_sub(MOST_NOTES);
        for (text, places) in found.into_iter().take(MOST_NOTES) {
            let [column, row] = places[0];
            let places = match places.len() {
                1 => format!("region [{column},{row}]"),
                count => format!("{count} regions such as [{column},{row}]"),
            };
            lines.push(format!("{name}, {places}: {text}"));
        }
        if more > 0 {
            lines.push(format!("{name}: {more} more notes; --report writes them all"));
        }
        if !settled {
            lines.push(format!("{name}: did not settle within the step limit; its last state is used"));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::{Attributes, Polarity, Spots};
    use crate::synth::report::RegionReport;

    fn region(place: [usize; 2], notes: &[&str]) -> RegionReport {
        let spots = Attributes::Spots(Spots { area: 100.0, aspect: 1.0, angle: 0.0, spacing: None });
        RegionReport {
            merged: None,
            place,
            marks: Some(9),
            asked: spots,
            polarity: Polarity::Positive,
            directed: true,
            parameters: Vec::new(),
            predicted: Some(spots),
            raggedness: None,
            got: None,
            error: Vec::new(),
            spread: None,
            kept: None,
            beyond: Vec::new(),
            notes: notes.iter().map(|note| (*note).to_owned()).collect(),
        }
    }

    fn layer(settled: bool, regions: Vec<RegionReport>) -> LayerReport {
        let (name, system) = ("spots".to_owned(), "turing-spots");
        LayerReport {
            name,
            system,
            inverted: false,
            cell: 1.0,
            grid: [9, 9],
            steps: 1,
            settled,
            regions,
            threads: Vec::new(),
            points: None,
            tone: None,
            growth: None,
            drawn: Vec::new(),
            notes: Vec::new(),
            note_on_drawn: None,
            merged: Vec::new(),
            half_grown: Vec::new(),
            shown: None,
            gap: None,
            blotches: None,
            share: None,
        }
    }

    #[test]
    fn a_note_that_regions_share_is_one_line() {
        let regions =
            vec![region([0, 0], &["dense"]), region([1, 0], &["dense", "round"]), region([2, 0], &[])];
        assert_eq!(
            notes(&[layer(true, regions)]),
            ["spots, 2 regions such as [0,0]: dense", "spots, region [1,0]: round"]
        );
    }

    #[test]
    fn of_many_notes_the_first_are_listed_and_the_rest_counted() {
        let regions = (0..20).map(|i| region([i, 0], &[&format!("note {i}")])).collect();
        let lines = notes(&[layer(true, regions)]);
        assert_eq!(lines.len(), MOST_NOTES + 1);
        assert!(lines[MOST_NOTES].contains("12 more notes"), "{lines:?}");
    }

    #[test]
    fn a_layer_that_did_not_settle_is_noted() {
        let lines = notes(&[layer(false, Vec::new())]);
        assert!(lines.len() == 1 && lines[0].contains("did not settle within the step limit"), "{lines:?}");
    }
}
