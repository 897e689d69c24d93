//! The preview: the files of the export, written into a temporary folder and read back. Where the preview is the whole
//! export, the export copies these files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::ColorImage;

use super::ExportKind;
use super::job::Job;
use super::lit;
use super::preview_images::PreviewImages;
use super::request::{ExportRequest, Pending};
use crate::document::Document;
use crate::editor::task::Tasks;
use crate::export::material::name;
use crate::export::motion::Film;
use crate::files::TemporaryFolder;
use crate::grid::Edges;
use crate::machine::fs;
use crate::machine::this_machine;
use crate::synth::estimate::{Needs, Task};
use crate::synth::render::lit::Maps;
use crate::synth::{Grown, Training, Watch};

/// Largest number of px of a preview; larger pictures are reduced.
const MOST: f64 = 4.2e6;
/// Longer side of the preview of outlines, px.
const DRAWN: usize = 1024;
/// Outlines of a canvas of more than this area are previewed only on request, px².
const LARGE: f64 = 1.7e7;

/// A preview that is finished.
pub struct FinishedPreview {
    /// What is exported.
    pub request: ExportRequest,
    /// Whether this is the whole export, not a reduced one.
    pub whole: bool,
    /// Its pictures or frames.
    pub images: PreviewImages,
    /// The maps of a material, to be seen lit.
    pub maps: Option<Arc<Maps>>,
    /// A message about it.
    pub message: Option<String>,
    /// Bytes of its files.
    pub bytes: u64,
    /// The grown texture; `None` for films.
    pub grown: Option<Arc<Grown>>,
    /// Its files, in order.
    pub files: Vec<PathBuf>,
    /// The properties of a film.
    pub film: Option<Film>,
    /// The temporary folder; it is deleted with the preview.
    _folder: TemporaryFolder,
}

/// The preview that is being made, and the last finished one.
#[derive(Default)]
pub struct Preview {
    job: Option<(ExportRequest, Job<FinishedPreview>)>,
    made: Option<Arc<FinishedPreview>>,
    /// The request that failed, and why.
    failed: Option<(ExportRequest, String)>,
    needs: Option<(Document, Option<Needs>)>,
    asking: Option<(Document, Job<Option<Needs>>)>,
}

impl Preview {
    /// Updates the preview after changed choices: starts quick previews at once, and estimates time and memory of the
    /// others.
    pub fn follow(
        &mut self,
        tasks: &Tasks,
        request: &ExportRequest,
        settled: Option<&Arc<Grown>>,
        threads: Option<usize>,
    ) {
        self.listen();
        if self.job.as_ref().is_some_and(|(of, _)| of != request) {
            self.job = None;
        }
        if !self.is_known(request) && self.is_quick(request, settled) {
            self.make(tasks, request, settled, threads);
        }
        let grown = self.sized(request);
        let known = self.needs.as_ref().is_some_and(|(of, _)| *of == grown)
            || self.asking.as_ref().is_some_and(|(of, _)| *of == grown);
        if !known && !self.is_ready(request, settled) {
            let (document, size) = (request.document.clone(), grown.size);
            let scale = request.choices.size.scale;
            let work = move |_: &Watch| {
                let task =
                    Task { document: &document, size, source: "the sketch", scale, machine: this_machine() };
                Ok(Needs::estimate(&task, Training::built_in()))
            };
            self.asking = Some((grown, Job::start(tasks, threads, 0.0, work)));
        }
    }

    fn sized(&self, request: &ExportRequest) -> Document {
        Document { size: request.options().size.unwrap_or(request.document.size), ..request.document.clone() }
    }

    fn listen(&mut self) {
        if let Some((of, outcome)) =
            self.job.as_mut().and_then(|(of, job)| Some((of.clone(), job.outcome()?)))
        {
            let given_up = self.job.take().is_some_and(|(_, job)| job.is_cancelled());
            match outcome {
                Ok(made) => (self.made, self.failed) = (Some(Arc::new(made)), None),
                Err(_) if given_up => {}
                Err(why) => self.failed = Some((of, why)),
            }
        }
        if let Some((of, needs)) =
            self.asking.as_mut().and_then(|(of, job)| Some((of.clone(), job.outcome()?)))
        {
            (self.needs, self.asking) = (Some((of, needs.ok().flatten())), None);
        }
    }

    /// Whether the preview of this request is finished, being made, or has failed.
    fn is_known(&self, request: &ExportRequest) -> bool {
        self.job.is_some() || self.finished(request).is_some() || self.failure(request).is_some()
    }

    /// The finished preview of this request.
    #[must_use]
    pub fn finished(&self, request: &ExportRequest) -> Option<&Arc<FinishedPreview>> {
        self.made.as_ref().filter(|made| made.request == *request)
    }

    /// Why the preview of this request failed.
    #[must_use]
    pub fn failure(&self, request: &ExportRequest) -> Option<&str> {
        self.failed.as_ref().filter(|(of, _)| of == request).map(|(_, why)| why.as_str())
    }

    /// The last finished preview, of any request.
    #[must_use]
    pub fn latest(&self) -> Option<&Arc<FinishedPreview>> {
        self.made.as_ref()
    }

    /// Whether nothing has to be grown for this request.
    #[must_use]
    pub fn is_ready(&self, request: &ExportRequest, settled: Option<&Arc<Grown>>) -> bool {
        !request.is_film() && self.grown(request, settled).is_some()
    }

    /// A grown texture that can be used for this request.
    #[must_use]
    pub fn grown(&self, request: &ExportRequest, settled: Option<&Arc<Grown>>) -> Option<Arc<Grown>> {
        let here = self.made.as_ref().and_then(|made| made.grown.as_ref());
        here.into_iter().chain(settled).find(|grown| request.takes(grown)).cloned()
    }

    fn is_quick(&self, request: &ExportRequest, settled: Option<&Arc<Grown>>) -> bool {
        let [width, height] = request.size().map(|side| side as f64);
        let drawn = request.choices.what == ExportKind::Outlines;
        self.is_ready(request, settled) && !(drawn && width * height > LARGE)
    }

    /// Starts to make the preview.
    pub fn make(
        &mut self,
        tasks: &Tasks,
        request: &ExportRequest,
        settled: Option<&Arc<Grown>>,
        threads: Option<usize>,
    ) {
        let grown = self.grown(request, settled);
        let writing = match (request.is_film(), grown.is_some()) {
            (true, _) => 0.5,
            (false, true) => 1.0,
            (false, false) => 0.1,
        };
        let work = request.clone();
        let job = Job::start(tasks, threads, writing, move |watch| make_preview(work, grown.as_ref(), watch));
        self.failed = None;
        self.job = Some((request.clone(), job));
    }

    /// Cancels the preview that is being made.
    pub fn stop(&mut self) {
        if let Some((_, job)) = &self.job {
            job.cancel();
        }
    }

    /// The share that is done, 0..1, while a preview is being made.
    #[must_use]
    pub fn progress(&self) -> Option<f32> {
        self.job.as_ref().map(|(_, job)| job.progress())
    }

    /// Time and memory to grow the request; `None` where they are not known, or where it cannot be planned.
    #[must_use]
    pub fn needs(&self, request: &ExportRequest) -> Option<Needs> {
        let grown = self.sized(request);
        self.needs.as_ref().filter(|(of, _)| *of == grown).and_then(|(_, needs)| *needs)
    }
}

/// Writes the files and reads them back.
fn make_preview(
    request: ExportRequest,
    grown: Option<&Arc<Grown>>,
    watch: &Watch,
) -> Result<FinishedPreview, String> {
    let folder = TemporaryFolder::new().map_err(|error| format!("the preview cannot be stored: {error}"))?;
    let grown = if request.is_film() { None } else { Some(request.grow(grown, watch)?) };
    let size = preview_size(&request);
    let file = match request.choices.ending() {
        Some(ending) => folder.path().join(name(&request.title)).with_extension(ending),
        None => folder.path().join("folder"),
    };
    let written = request.write(grown.as_deref(), &file, size, watch)?;
    let film = if let Pending::Film(_, film) = &written.pending { Some(film.clone()) } else { None };
    written.pending.keep()?;
    let files = if fs::is_dir(&file) { listed(&file)? } else { vec![file] };
    let bytes = files.iter().filter_map(|file| fs::metadata(file).ok()).map(|file| file.len()).sum();
    let seconds = film.as_ref().map_or(0.0, |film| 1.0 / f64::from(film.fps));
    let images = match &written.drawing {
        Some(drawing) => PreviewImages::Pictures(vec![(String::new(), drawing.picture(DRAWN))]),
        None => PreviewImages::read(&request, &files, seconds)?,
    };
    let maps = match &images {
        PreviewImages::Pictures(pictures) if request.choices.what == ExportKind::Material => {
            lit::maps(pictures, request.document.edges == Edges::Wrap).map(Arc::new)
        }
        _ => None,
    };
    let whole = size == request.size() || film.is_some() || written.drawing.is_some();
    Ok(FinishedPreview {
        whole,
        images,
        maps,
        message: written.message,
        bytes,
        grown,
        files,
        film,
        request,
        _folder: folder,
    })
}

/// The size of pictures in the preview, px.
fn preview_size(request: &ExportRequest) -> [usize; 2] {
    let size = request.size();
    let px = size[0] as f64 * size[1] as f64;
    let smaller = (MOST / px).sqrt().min(1.0);
    if smaller < 1.0 { size.map(|side| ((side as f64 * smaller) as usize).max(1)) } else { size }
}

fn listed(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let files = fs::read_dir(folder).map_err(|error| error.to_string())?;
    let mut files: Vec<PathBuf> = files.flatten().map(|file| file.path()).collect();
    files.sort();
    Ok(files)
}

impl FinishedPreview {
    /// Its pictures and their names; none for films.
    #[must_use]
    pub fn pictures(&self) -> &[(String, ColorImage)] {
        if let PreviewImages::Pictures(pictures) = &self.images { pictures } else { &[] }
    }

    /// The frames of a film, and how long each is shown, seconds.
    #[must_use]
    pub fn frames(&self) -> &[(ColorImage, f64)] {
        if let PreviewImages::Film(frames) = &self.images { frames } else { &[] }
    }
}
