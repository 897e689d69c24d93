//! Compares the attributes that were asked for with those that have grown, on another thread: the numbers of `dapple
//! grow --report`.

mod drawn;
mod reach;
mod verdict;

pub use drawn::Drawn;
pub use reach::Reach;
pub use verdict::Verdict;

use std::sync::Arc;

use super::growth::Texture;
use crate::attributes::system::Description;
use crate::editor::session::Session;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::rd::System;
use crate::synth::layer_report::layer_reports;
use crate::synth::marks::plan::Lookup;
use crate::synth::report::{DrawnMark, GrowthReport, LayerReport, RegionReport, ThreadReport, WidthReport};
use crate::synth::{Grown, GrownLayer, Training};

/// The result of a region.
#[derive(Clone, Debug)]
pub struct RegionResult {
    /// Its numbers.
    pub report: RegionReport,
    /// How well it meets what was asked for.
    pub verdict: Verdict,
    /// A change of the sketch after which the region can be reached; `None` where it can be reached already, or where
    /// no change was found.
    pub reach: Option<Reach>,
}

/// The result of a layer.
#[derive(Clone, Debug)]
pub struct LayerResult {
    /// Its name.
    pub name: String,
    /// Its system.
    pub system: &'static Description,
    /// The system to which its training rows belong; `None` for pairs and patches.
    pub trained: Option<System>,
    /// Its regions, row by row; none for a weave.
    pub regions: Vec<RegionResult>,
    /// The growth parameter, for a layer of Turing's growth.
    pub growth: Option<GrowthReport>,
    /// The threads of each direction of a weave.
    pub threads: Vec<ThreadReport>,
    /// What the user should know; regions have notes of their own.
    pub notes: Vec<String>,
    /// What has grown of each drawn mark, in the order in which they were drawn; empty where the marks themselves are
    /// not part of the texture.
    pub drawn: Vec<DrawnMark>,
    /// Where two spots grew together, px.
    pub merged: Vec<[f64; 2]>,
}

impl LayerResult {
    /// How many drawn marks did not grow.
    #[must_use]
    pub fn lost(&self) -> usize {
        self.drawn.iter().filter(|mark| !mark.there).count()
    }
}

/// The result of a texture.
#[derive(Clone)]
pub struct Outcome {
    /// The texture.
    pub grown: Arc<Grown>,
    /// Its layers, the lowest first.
    pub layers: Vec<LayerResult>,
    /// Whether the search for changes of the unreachable regions has ended.
    pub complete: bool,
}

impl Outcome {
    /// Whether a region was missed, or a drawn mark did not grow.
    #[must_use]
    pub fn is_missed(&self) -> bool {
        let is_missed = |region: &RegionResult| region.verdict == Verdict::Missed;
        self.layers.iter().any(|layer| {
            let is_dead = layer.threads.iter().any(|threads| threads.got.is_none());
            layer.lost() > 0 || is_dead || layer.regions.iter().any(is_missed)
        })
    }
}

enum News {
    Layers(Vec<LayerResult>),
    Reach {
        layer: usize,
        region: usize,
        reach: Reach,
    },
    /// Whether changes were sought for all unreachable regions.
    End {
        complete: bool,
    },
}

/// A computation that is running; without a task where no thread could be started.
struct Job {
    grown: Arc<Grown>,
    task: Option<Task<News>>,
}

/// The latest result, and the one that is being computed.
#[derive(Default)]
pub struct Results {
    /// The training sets, read when first needed.
    pub training: Arc<Training>,
    outcome: Option<Outcome>,
    job: Option<Job>,
}

impl Results {
    /// Receives results and starts to compute those of a new texture; never blocks. The changes after which unreachable
    /// regions can be reached take longer; they are computed only where `all` is true. Returns an error once where no
    /// thread can be started.
    pub fn follow(&mut self, tasks: &Tasks, texture: Option<&Texture>, all: bool) -> Option<StartError> {
        while let Some(news) = self.job.as_mut().and_then(|job| job.task.as_mut()?.poll()) {
            self.take(news);
        }
        let Some(texture) = texture else {
            self.job = None;
            return None;
        };
        let same = |grown: &Arc<Grown>| Arc::ptr_eq(grown, &texture.grown);
        let is_enough = |outcome: &Outcome| (outcome.complete || !all) && same(&outcome.grown);
        let known = self.job.as_ref().is_some_and(|job| same(&job.grown))
            || self.outcome.as_ref().is_some_and(is_enough);
        if !known {
            return self.begin(&texture.grown, tasks, all).err();
        }
        None
    }

    fn begin(&mut self, grown: &Arc<Grown>, tasks: &Tasks, all: bool) -> Result<(), StartError> {
        let (textured, training) = (Arc::clone(grown), Arc::clone(&self.training));
        let started = tasks.start("the result", move |worker| work(&textured, &training, all, worker));
        let (task, outcome) = match started {
            Ok(task) => (Some(task), Ok(())),
            Err(error) => (None, Err(error)),
        };
        self.job = Some(Job { grown: Arc::clone(grown), task });
        outcome
    }

    fn take(&mut self, news: News) {
        match (news, &mut self.outcome) {
            (News::Layers(layers), outcome) => {
                if let Some(job) = &self.job {
                    *outcome = Some(Outcome { grown: Arc::clone(&job.grown), layers, complete: false });
                }
            }
            (News::Reach { layer, region, reach }, Some(outcome)) => {
                if let Some(region) = outcome.layers.get_mut(layer).and_then(|of| of.regions.get_mut(region))
                {
                    region.reach = Some(reach);
                }
            }
            (News::End { complete }, Some(outcome)) => {
                outcome.complete = complete;
                self.job = None;
            }
            (_, None) => {}
        }
    }

    /// Whether a texture is being measured, or changes of the sketch are being sought.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        let task = self.job.as_ref().and_then(|job| job.task.as_ref());
        task.is_some_and(|task| !task.has_ended())
    }

    /// Removes the results, because another document was opened.
    pub fn forget(&mut self) {
        *self = Self { training: Arc::clone(&self.training), ..Self::default() };
    }

    /// The result of the latest texture that was measured.
    #[must_use]
    pub fn outcome(&self) -> Option<&Outcome> {
        self.outcome.as_ref()
    }

    /// The result, if it is that of `texture`.
    #[must_use]
    pub fn for_texture(&self, texture: Option<&Texture>) -> Option<&Outcome> {
        self.outcome()
            .filter(|outcome| texture.is_some_and(|texture| Arc::ptr_eq(&texture.grown, &outcome.grown)))
    }
}

/// The index in the finished document of a layer of the session; `None` where it is empty.
#[must_use]
pub fn finished_layer(session: &Session, layer: usize) -> Option<usize> {
    let layers = &session.document().layers;
    let drawn = |layer: &crate::document::Layer| !layer.is_blank();
    layers.get(layer).is_some_and(drawn).then(|| layers[..layer].iter().filter(|layer| drawn(layer)).count())
}

/// The index in the session of a layer of the finished document: the inverse of [`finished_layer`].
#[must_use]
pub fn session_layer(session: &Session, layer: usize) -> Option<usize> {
    let drawn = session.document().layers.iter().enumerate().filter(|(_, layer)| !layer.is_blank());
    drawn.map(|(index, _)| index).nth(layer)
}

/// The result of a layer of what has grown.
fn result_of(grown: &Grown, layer: &GrownLayer, report: LayerReport) -> LayerResult {
    let LayerReport { name, regions, growth, threads, notes, note_on_drawn, blotches, drawn, merged, .. } =
        report;
    let is_wrong = |mark: &&DrawnMark| !mark.there || mark.reason.is_some();
    let wrong: Vec<[f64; 2]> = drawn.iter().filter(is_wrong).map(|mark| mark.place).collect();
    let result = |report: RegionReport| {
        // A tick says that all is as it was drawn.
        let is_here = |place: &[f64; 2]| region_at(grown, *place) == report.place;
        let has_wrong = wrong.iter().chain(&merged).any(is_here);
        let verdict = if has_wrong { Verdict::Missed } else { Verdict::for_region(&report) };
        RegionResult { verdict, report, reach: None }
    };
    // The drawn marks are listed separately.
    let mut notes: Vec<String> =
        notes.into_iter().filter(|note| Some(note) != note_on_drawn.as_ref()).collect();
    if let Some(WidthReport { asked, got: Some(got) }) = blotches {
        notes.insert(0, format!("Blotches are {got:.1} px wide; {asked:.1} px were asked for"));
    }
    let trained = layer.marks().map(|marks| marks.plan.lookup.system);
    let regions: Vec<RegionResult> = regions.into_iter().map(result).collect();
    LayerResult { name, system: layer.system(), trained, regions, growth, threads, notes, drawn, merged }
}

/// The region of a place, px: (column, row).
fn region_at(grown: &Grown, place: [f64; 2]) -> [usize; 2] {
    let (size, grid) = (grown.size.map(f64::from), grown.document.region_grid());
    [0, 1].map(|axis| {
        let at = place[axis] / size[axis] * grid[axis] as f64;
        (at.max(0.0) as usize).min(grid[axis].saturating_sub(1))
    })
}

fn work(grown: &Grown, training: &Training, all: bool, worker: &Worker<News>) {
    let reports = layer_reports(&grown.document, grown);
    let layers = grown.layers.iter().zip(reports).map(|(layer, report)| result_of(grown, layer, report));
    let layers: Vec<LayerResult> = layers.collect();
    let beyond = |layer: &LayerResult| {
        let regions = layer.regions.iter().enumerate();
        regions.filter(|(_, region)| !region.report.beyond.is_empty()).map(|(index, _)| index).collect()
    };
    let wanted: Vec<Vec<usize>> = layers.iter().map(beyond).collect();
    worker.send(News::Layers(layers));
    if !all {
        worker.send(News::End { complete: wanted.iter().all(Vec::is_empty) });
        return;
    }
    let marks = grown.layers.iter().map(GrownLayer::marks);
    let plans: Vec<Option<&Lookup>> = marks.map(|marks| Some(&marks?.plan.lookup)).collect();
    for (layer, regions) in wanted.into_iter().enumerate() {
        for region in regions {
            if worker.is_cancelled() {
                return;
            }
            if let Some(reach) = reach::reach(training, &grown.document, &plans, layer, region) {
                worker.send(News::Reach { layer, region, reach });
            }
        }
    }
    worker.send(News::End { complete: true });
}
