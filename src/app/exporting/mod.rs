//! The texture → a PNG, in the background.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread;

use super::growth::Texture;
use crate::export;
use crate::synth::painting::{Channel, Painting, Style};
use crate::synth::recipe::{Document, Extent, embedded};
use crate::synth::{Grown, Options, Stage, Training, Watch, grow};

/// How large the picture shall be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// More texture with features of the same size, px; `None` = the canvas.
    pub canvas: Option<[u32; 2]>,
    /// The same texture with so many times the px along each side.
    pub scale: u32,
}

impl Default for Size {
    fn default() -> Self {
        Self { canvas: None, scale: 1 }
    }
}

impl Size {
    /// Width and height of the picture of `document`, px.
    #[must_use]
    pub fn of(&self, document: &Document) -> [u64; 2] {
        self.canvas.unwrap_or(document.size).map(|side| u64::from(side) * u64::from(self.scale))
    }
}

/// A picture that is being written.
pub struct Exporting {
    /// Where to.
    pub path: PathBuf,
    done: Arc<AtomicU64>,
    cancelled: Arc<AtomicBool>,
    outcome: Receiver<Result<(), String>>,
}

impl Exporting {
    /// Begins. What has settled is taken as it is, where that is what is asked for; otherwise it is grown, by so many
    /// `threads` (`None` = all cores), which does not change it.
    #[must_use]
    pub fn new(
        path: &Path,
        document: &Document,
        size: Size,
        settled: Option<Texture>,
        threads: Option<usize>,
    ) -> Self {
        let (done, cancelled) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicBool::new(false)));
        let (tell, outcome) = mpsc::channel();
        let job = Job {
            path: path.to_owned(),
            document: document.clone(),
            size,
            settled: settled.filter(|texture| size.canvas.is_none() && *texture.document == *document),
            done: Arc::clone(&done),
            cancelled: Arc::clone(&cancelled),
        };
        thread::spawn(move || {
            // The window may have gone.
            let _ = tell.send(match pool(threads) {
                Some(pool) => pool.install(|| job.run()),
                None => job.run(),
            });
        });
        Self { path: path.to_owned(), done, cancelled, outcome }
    }

    /// The share of it that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.done.load(Ordering::Relaxed) as f32 / 1000.0
    }

    /// Gives it up; nothing is left behind.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Was it given up?
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// What came of it, once it is over.
    #[must_use]
    pub fn outcome(&self) -> Option<Result<(), String>> {
        match self.outcome.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(mpsc::TryRecvError::Empty) => None,
            Err(mpsc::TryRecvError::Disconnected) => {
                Some(Err(format!("'{}' was not written", self.path.display())))
            }
        }
    }
}

/// A pool of so many threads; `None` = the usual one does.
fn pool(threads: Option<usize>) -> Option<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new().num_threads(threads?).build().ok()
}

struct Job {
    path: PathBuf,
    document: Document,
    size: Size,
    settled: Option<Texture>,
    done: Arc<AtomicU64>,
    cancelled: Arc<AtomicBool>,
}

impl Job {
    fn run(self) -> Result<(), String> {
        export::check_target(&self.path).map_err(|error| error.to_string())?;
        let (from, done) = (if self.settled.is_some() { 0.0 } else { 0.9 }, &self.done);
        let progress = |stage, share: f64| {
            let all = match stage {
                Stage::Plan => 0.05 * share,
                Stage::Grow => 0.05 + 0.8 * share,
                Stage::Refine => 0.85 + 0.05 * share,
                Stage::Write => from + (1.0 - from) * share,
            };
            done.store((1000.0 * all) as u64, Ordering::Relaxed);
        };
        let watch = Watch { progress: &progress, cancelled: &|| self.cancelled.load(Ordering::Relaxed) };
        let grown: Arc<Grown> = match &self.settled {
            Some(texture) => Arc::clone(&texture.grown),
            None => {
                let options = Options { size: self.size.canvas, ..Options::default() };
                let grown = grow(&self.document, "the sketch", &Training::default(), options, &watch);
                Arc::new(grown.map_err(|error| error.to_string())?)
            }
        };
        let painting = Painting::of(&self.document, &grown, self.size.scale as usize);
        let extent = Extent { size: self.size.canvas, scale: self.size.scale };
        let style = Style {
            dpi: self.document.dpi * f64::from(self.size.scale),
            texts: embedded::embedded(&self.document, extent),
            ..Style::default()
        };
        let prepared = painting.prepare(&self.path, Channel::Texture, &style, &watch);
        prepared.and_then(export::Prepared::keep).map_err(|error| error.to_string())
    }
}
