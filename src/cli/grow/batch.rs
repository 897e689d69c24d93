//! Many documents, or one with many seeds, into a folder. A failure does not stop the other growths.

use super::{Args, Error, Source, grow_one};
use crate::cli::escaped;
use crate::cli::estimate::{Estimate, Underway};
use crate::cli::paths::same_place;
use crate::cli::sheet::{self, Contact};
use crate::document::with_causes;
use crate::export::material;
use crate::files;
use crate::machine::this_machine;
use crate::synth::Training;
use crate::synth::estimate;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// Longer side of a picture on the contact sheet, px.
const THUMBNAIL: usize = 256;

/// Whether more than one picture is requested.
pub fn is_requested(args: &Args) -> bool {
    !args.more.is_empty() || args.variations.is_some()
}

/// One picture of a batch.
struct Task {
    file: PathBuf,
    output: PathBuf,
    seed: Option<u64>,
}

impl Task {
    /// The arguments that grow this picture alone.
    fn of(&self, args: &Args) -> Args {
        let (file, output) = (self.file.clone(), Some(self.output.clone()));
        Args { file, more: Vec::new(), variations: None, output, seed: self.seed, ..args.clone() }
    }
}

/// Grows all pictures into the folder.
///
/// # Errors
/// Invalid arguments, before anything is grown; [`Error::Batch`] if some pictures were not grown.
pub fn run(args: &Args) -> Result<(), Error> {
    let folder = check(args)?;
    let tasks = tasks(args, folder)?;
    tasks.iter().try_for_each(|task| task.of(args).check_outputs())?;
    files::make_folder(folder).map_err(Error::step)?;
    let training = files::training(args.training.clone());
    let announced = announce_time(args, &tasks, &training);
    let underway = Underway::begin(tasks.len(), args.quiet || announced);
    let mut contact = args.variations.map(|_| Contact::new(Some(stem(&args.file)), THUMBNAIL));
    let mut why = Vec::new();
    for (index, task) in tasks.iter().enumerate() {
        let thumbnail = contact.as_ref().map(|_| THUMBNAIL);
        let source = Source { training: &training, thumbnail, of_batch: Some(&underway) };
        match grow_one(&task.of(args), &source) {
            Ok(thumbnail) => {
                if shows_progress(args) && tasks.len() > 1 {
                    let path = escaped(&task.output.display().to_string());
                    // If stderr is closed, the line is lost.
                    let _ = writeln!(io::stderr(), "{} of {}: {path}", index + 1, tasks.len());
                }
                if let (Some(contact), Some(thumbnail)) = (&mut contact, thumbnail) {
                    contact.add(format!("seed {}", task.seed.unwrap_or_default()), thumbnail);
                }
            }
            Err(Error::Interrupted) => return Err(Error::Interrupted),
            Err(error) => why.push(reason(task, &error)),
        }
    }
    if let Some(contact) = contact.filter(|contact| !contact.is_empty()) {
        sheet::write(&contact, &folder.join(format!("{}-sheet.png", stem(&args.file))))?;
    }
    let all = tasks.len();
    if shows_progress(args) && why.is_empty() {
        // If stderr is closed, the line is lost.
        let _ = writeln!(
            io::stderr(),
            "{all} of {all} pictures are in {}",
            escaped(&folder.display().to_string())
        );
    }
    if why.is_empty() { Ok(()) } else { Err(Error::Batch { all, why }) }
}

/// Whether progress is shown: only on terminals.
fn shows_progress(args: &Args) -> bool {
    !args.quiet && io::stderr().is_terminal()
}

/// Checks the arguments; returns the output folder.
fn check(args: &Args) -> Result<&Path, Error> {
    let single = [
        ("--pattern", args.pattern.is_some()),
        ("--labels", args.labels.is_some()),
        ("--mask", args.mask.is_some()),
        ("--concentrations", args.concentrations.is_some()),
        ("--report", args.report.is_some()),
        ("--svg", args.outlines.svg.is_some()),
        ("--dxf", args.outlines.dxf.is_some()),
        ("--layer", args.layer.is_some()),
    ];
    if let Some((name, _)) = single.iter().find(|(_, found)| *found) {
        return Err(Error::Usage(format!("{name}: allowed with one FILE and without --variations")));
    }
    if args.variations.is_some() && !args.more.is_empty() {
        return Err(Error::Usage(
            "--variations: allowed with one FILE; for several, see dapple sheet --seeds".to_owned(),
        ));
    }
    if args.variations.is_some() && args.material.material.is_some() {
        return Err(Error::Usage(
            "--material: not allowed with --variations, as all would write the same files".to_owned(),
        ));
    }
    if std::iter::once(&args.file).chain(&args.more).any(|file| files::as_link(file).is_some()) {
        return Err(Error::Usage(
            "FILE: found a link, which has no name for its picture; allowed: one link, without --variations"
                .to_owned(),
        ));
    }
    let Some(folder) = args.output.as_deref() else {
        return Err(Error::Usage("--output: missing; it names the folder for the pictures".to_owned()));
    };
    if files::is_standard_output(folder) {
        return Err(Error::Usage(
            "--output: found standard output, which takes one picture; allowed: a folder, as there is more than one"
                .to_owned(),
        ));
    }
    if folder.is_file() || folder.extension().is_some_and(|ending| ending != "d") && !folder.is_dir() {
        let found = folder.display();
        return Err(Error::Usage(format!(
            "--output: found {found}; allowed: a folder, as there is more than one picture"
        )));
    }
    Ok(folder)
}

fn tasks(args: &Args, folder: &Path) -> Result<Vec<Task>, Error> {
    if let Some(variations) = args.variations {
        let first =
            args.seed.map_or_else(|| args.settings.read(&args.file).map(|document| document.seed), Ok)?;
        let task = |k: u64| {
            let seed = first.wrapping_add(k);
            let output = folder.join(format!("{}-{seed}.png", stem(&args.file)));
            Task { file: args.file.clone(), output, seed: Some(seed) }
        };
        return Ok((0..variations as u64).map(task).collect());
    }
    let files: Vec<&PathBuf> = std::iter::once(&args.file).chain(&args.more).collect();
    for (index, file) in files.iter().enumerate() {
        let named = |file: &Path| match args.material.material {
            Some(_) => material::name(&stem(file)),
            None => stem(file),
        };
        if let Some(other) = files[..index].iter().find(|other| named(other) == named(file)) {
            let same = if same_place(other, file) {
                "the same file"
            } else {
                "whose pictures would have the same name"
            };
            return Err(Error::Usage(format!(
                "FILE: found {} and {}, {same}; allowed: documents of different names",
                other.display(),
                file.display()
            )));
        }
    }
    let output = |file: &PathBuf| folder.join(format!("{}.png", stem(file)));
    let task = |file: &PathBuf| Task { file: file.clone(), output: output(file), seed: args.seed };
    Ok(files.into_iter().map(task).collect())
}

/// The file name without folder and ending.
fn stem(file: &Path) -> String {
    files::stem(file).unwrap_or_else(|| "texture".to_owned())
}

/// Returns whether the time was announced.
fn announce_time(args: &Args, tasks: &[Task], training: &Training) -> bool {
    let mut documents = Vec::new();
    for task in tasks {
        // A document that cannot be read gives its error later.
        if let Ok(document) = args.settings.read(&task.file) {
            documents.push((document, task.file.display().to_string()));
        }
    }
    let scale = args.scale.unwrap_or(1);
    let tasks: Vec<_> = documents
        .iter()
        .map(|(document, source)| {
            let size = args.size.unwrap_or(document.size);
            estimate::Task { document, size, source, scale, machine: this_machine() }
        })
        .collect();
    Estimate { training, quiet: args.quiet }.announce(&tasks, 1.0, 1.0)
}

/// Why a picture is missing, with the file's name once.
fn reason(task: &Task, error: &Error) -> String {
    let (file, message) = (task.file.display().to_string(), with_causes(error));
    let file = if message.contains(&file) { String::new() } else { format!("{file}: ") };
    let seed = task.seed.map_or_else(String::new, |seed| format!("seed {seed}: "));
    format!("{seed}{file}{message}")
}
