//! Export in the background: pictures, materials, outlines, films.
//!
//! ```text
//!  choices ─▶ request ─▶ (grown) ─▶ files in a temporary folder ─▶ read back: the preview
//!               │                         │ copied, where the preview is the whole export
//!               └─────────▶ files ◀───────┘
//! ```

pub mod choices;
mod dialog;
mod job;
mod lit;
mod outline_picture;
mod pages;
mod preview;
mod preview_images;
mod request;
mod view;

pub use choices::{Choices, ExportKind, Film, Outlines, PictureContent, Size};
pub use dialog::Dialog;
pub use pages::{DialogAction, ExportContext};
pub use preview::FinishedPreview;
pub use preview_images::PreviewImages;
pub use request::ExportRequest;

use std::io::{self, BufReader};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use image::ImageFormat;

use crate::document::{io_in_words, with_causes};
use crate::editor::task::Tasks;
use crate::export::{Stopped, motion};
use crate::files;
use crate::machine::fs::{self, File};
use crate::synth::{Grown, Stage, Watch};
use job::Job;
use request::Pending;

/// An export that is being written.
pub struct Exporting {
    /// The file or the folder that is written.
    pub path: PathBuf,
    job: Job<Option<String>>,
}

impl Exporting {
    /// Starts the export. What `made` (the files of the preview) or `grown` (a finished texture) already holds is
    /// reused. The rest is grown with this number of `threads` (`None` = all cores), which does not change the result.
    #[must_use]
    pub fn new(
        path: &Path,
        request: ExportRequest,
        made: Option<Arc<FinishedPreview>>,
        grown: Option<Arc<Grown>>,
        threads: Option<usize>,
        tasks: &Tasks,
    ) -> Self {
        let made = made.filter(|made| made.request == request && made.whole);
        let writing = match (request.is_film() && made.is_none(), made.is_some() || grown.is_some()) {
            (true, _) => 0.5,
            (false, true) => 1.0,
            (false, false) => 0.1,
        };
        let to = path.to_owned();
        let work = move |watch: &Watch| write(&to, &request, made.as_deref(), grown.as_ref(), watch);
        Self { path: path.to_owned(), job: Job::start(tasks, threads, writing, work) }
    }

    /// The share that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.job.progress()
    }

    /// Cancels it; no files are left.
    pub fn cancel(&self) {
        self.job.cancel();
    }

    /// Whether it was cancelled.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.job.is_cancelled()
    }

    /// The result once the export has ended: a message about what was written, or the error.
    pub fn outcome(&mut self) -> Option<Result<Option<String>, String>> {
        self.job.outcome()
    }
}

/// Why a folder cannot be made.
fn folder_error(folder: &Path, error: &io::Error) -> String {
    format!("{}: the folder cannot be created: {}", folder.display(), io_in_words(error))
}

fn write(
    path: &Path,
    request: &ExportRequest,
    made: Option<&FinishedPreview>,
    grown: Option<&Arc<Grown>>,
    watch: &Watch,
) -> Result<Option<String>, String> {
    check(path, request)?;
    if let Some(made) = made {
        copied(path, request, made, watch)?.keep()?;
        return Ok(made.message.clone());
    }
    let began = fs::is_dir(path);
    let written = (|| {
        let grown = if request.is_film() { None } else { Some(request.grow(grown, watch)?) };
        let written = request.write(grown.as_deref(), path, request.size(), watch)?;
        written.pending.keep()?;
        Ok(written.message)
    })();
    if written.is_err() && !began && request.choices.what == ExportKind::Material {
        // Removes the folder only where it is empty.
        let _ = fs::remove_dir(path);
    }
    written
}

/// Checks before the work starts whether the export can be written there.
///
/// # Errors
///
/// Why it cannot be written.
pub fn check(path: &Path, request: &ExportRequest) -> Result<(), String> {
    let checked = match (request.choices.what, request.choices.ending()) {
        (ExportKind::Film, _) => files::film_kind(path).map(drop),
        (_, Some(ending)) => {
            let fits: &[&str] = match ending {
                "tif" => &["tif", "tiff"],
                "jpg" => &["jpg", "jpeg"],
                "png" => &["png"],
                "exr" => &["exr"],
                "webp" => &["webp"],
                "svg" => &["svg"],
                _ => &["dxf"],
            };
            files::check_ending(path, fits).and_then(|()| files::check_file(path))
        }
        (_, None) if fs::exists(path) && !fs::is_dir(path) => {
            return Err(format!("{}: a file has this name; choose a folder", path.display()));
        }
        (_, None) => Ok(()),
    };
    checked.map_err(|error| with_causes(&error))
}

/// Copies the files of the preview.
fn copied(
    path: &Path,
    request: &ExportRequest,
    made: &FinishedPreview,
    watch: &Watch,
) -> Result<Pending, String> {
    if let Some(film) = made.film.as_ref().filter(|_| request.choices.ending().is_none()) {
        // The frames of the preview are written again.
        let written = files::write_film(path, motion::Kind::Folder, film, |show| {
            let frame = |file: &PathBuf| {
                image::load(BufReader::new(File::open(file)?), ImageFormat::Png).map_err(io::Error::other)
            };
            made.files.iter().enumerate().try_for_each(|(index, file)| {
                let done = index as f64 / made.files.len() as f64;
                watch.step(Stage::Write, done).map_err(|_| Stopped::Cancelled)?;
                show(frame(file)?.into_rgb8().as_raw())
            })
        });
        let written = written.map_err(|error| error.to_string())?;
        return Ok(Pending::Film(written, film.clone()));
    }
    if request.choices.ending().is_none() && !fs::is_dir(path) {
        fs::create_dir(path).map_err(|error| folder_error(path, &error))?;
    }
    let copy = |(from, to): (&PathBuf, PathBuf)| {
        files::prepare(&to, |out| {
            io::copy(&mut File::open(from)?, out)?;
            Ok::<(), Stopped>(())
        })
    };
    let places = request.places(path, &made.files);
    let files = made.files.iter().zip(places).map(copy).collect::<Result<_, _>>();
    files.map(Pending::Files).map_err(|error| error.to_string())
}
