//! What has grown → files, in the background: pictures, materials, outlines, films.
//!
//! ```text
//!  choices ─▶ order ─▶ (grown) ─▶ files in a passing folder ─▶ read back: the preview
//!               │                         │ copied, where all of it was made
//!               └─────────▶ files ◀───────┘
//! ```

pub mod choices;
mod dialog;
mod job;
mod order;
mod pages;
mod preview;
mod raster;
mod sight;
mod view;

pub use choices::{Choices, Film, Outlines, Shows, Size, What};
pub use dialog::Dialog;
pub use order::Order;
pub use pages::{About, Said};
pub use preview::Made;
pub use sight::Sight;

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::export::{self, Stopped, motion};
use crate::synth::{Grown, Watch};
use job::Job;
use order::Pending;

/// An export that is being written.
pub struct Exporting {
    /// Where to: a file or a folder.
    pub path: PathBuf,
    job: Job<Option<String>>,
}

impl Exporting {
    /// Begins. What has been `made` of it, or has `grown`, is taken as it is; the rest is grown by so many `threads` (`None`
    /// = all cores), which does not change it.
    #[must_use]
    pub fn new(
        path: &Path,
        order: Order,
        made: Option<Arc<Made>>,
        grown: Option<Arc<Grown>>,
        threads: Option<usize>,
    ) -> Self {
        let made = made.filter(|made| made.order == order && made.whole);
        let writing = match (order.is_film() && made.is_none(), made.is_some() || grown.is_some()) {
            (true, _) => 0.5,
            (false, true) => 1.0,
            (false, false) => 0.1,
        };
        let to = path.to_owned();
        let work = move |watch: &Watch| write(&to, &order, made.as_deref(), grown.as_ref(), watch);
        Self { path: path.to_owned(), job: Job::start(threads, writing, || {}, work) }
    }

    /// The share of it that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.job.progress()
    }

    /// Gives it up; nothing is left behind.
    pub fn cancel(&self) {
        self.job.cancel();
    }

    /// Was it given up?
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.job.is_cancelled()
    }

    /// What came of it, once it is over; what is to be told of it.
    #[must_use]
    pub fn outcome(&self) -> Option<Result<Option<String>, String>> {
        self.job.outcome()
    }
}

fn write(
    path: &Path,
    order: &Order,
    made: Option<&Made>,
    grown: Option<&Arc<Grown>>,
    watch: &Watch,
) -> Result<Option<String>, String> {
    check(path, order)?;
    if let Some(made) = made {
        copied(path, order, made)?.keep()?;
        return Ok(made.told.clone());
    }
    let began = path.is_dir();
    let written = (|| {
        let grown = if order.is_film() { None } else { Some(order.grow(grown, watch)?) };
        let written = order.write(grown.as_deref(), path, order.size(), watch)?;
        written.pending.keep()?;
        Ok(written.told)
    })();
    if written.is_err() && !began && order.choices.what == What::Material {
        // Only where it is empty.
        let _ = fs::remove_dir(path);
    }
    written
}

/// Looks whether it can be written there, before the work is done.
fn check(path: &Path, order: &Order) -> Result<(), String> {
    let checked = match (order.choices.what, order.choices.ending()) {
        (What::Film, _) => motion::Kind::from_path(path).map(drop),
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
            export::check_ending(path, fits).and_then(|()| export::check_file(path))
        }
        (_, None) if path.exists() && !path.is_dir() => {
            return Err(format!("{}: a file has this name; choose a folder", path.display()));
        }
        (_, None) => Ok(()),
    };
    checked.map_err(|error| error.to_string())
}

/// The files of the preview, once more.
fn copied(path: &Path, order: &Order, made: &Made) -> Result<Pending, String> {
    if let Some(film) = made.film.as_ref().filter(|_| order.choices.ending().is_none()) {
        // Frames that were written are what is written.
        let written = motion::write(path, motion::Kind::Folder, film, |show| {
            let frame = |file: &PathBuf| image::open(file).map_err(io::Error::other);
            made.files.iter().try_for_each(|file| show(frame(file)?.into_rgb8().as_raw()))
        });
        let written = written.map_err(|error| error.to_string())?;
        return Ok(Pending::Film(written, film.clone()));
    }
    if order.choices.ending().is_none() && !path.is_dir() {
        fs::create_dir(path)
            .map_err(|error| format!("{}: the folder cannot be made: {error}", path.display()))?;
    }
    let copy = |(from, to): (&PathBuf, PathBuf)| {
        export::prepare(&to, |out| {
            io::copy(&mut File::open(from)?, out)?;
            Ok::<(), Stopped>(())
        })
    };
    let places = order.places(path, &made.files);
    let files = made.files.iter().zip(places).map(copy).collect::<Result<_, _>>();
    files.map(Pending::Files).map_err(|error| error.to_string())
}
