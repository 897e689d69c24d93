//! The training cloud of a region: the grown examples, what is asked for, and the neighbours from which its parameters
//! were interpolated; of a layer of Turing's growth, the map of what grows at each growth and decay.

mod growth;
mod plot;
mod points;

pub use points::{Axis, Points};

use std::sync::Arc;

use egui::{ComboBox, Context, Id, Ui, Window as Floating, vec2};

use super::result::RegionResult;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::rd::System;
use crate::synth::Training;
use growth::GrowthView;

/// A region: layer of the finished document, (column, row).
pub type RegionId = (usize, [usize; 2]);

/// The cloud and its axes.
#[derive(Default)]
pub struct Cloud {
    /// The region; `None` = the cloud is not shown.
    pub asked: Option<RegionId>,
    /// The quantities along x and y; `None` = the default.
    axes: [Option<Axis>; 2],
    points: Option<Arc<Points>>,
    pending: Option<Task<Option<Points>>>,
    failed: bool,
    /// The map of growth and decay that is shown instead.
    growth: Option<GrowthView>,
    /// Counts the requests: each resets the visible range of the plot.
    question: u64,
}

impl Cloud {
    /// Computes the cloud of a region that was grown with `system`, on another thread.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn ask(
        &mut self,
        tasks: &Tasks,
        asked: RegionId,
        system: System,
        region: &RegionResult,
        training: &Arc<Training>,
    ) -> Result<(), StartError> {
        let (training, report) = (Arc::clone(training), region.report.clone());
        let work = move |worker: &Worker<_>| worker.send(Points::for_region(&training, system, &report));
        self.pending = Some(tasks.start("the training cloud", work)?);
        self.question += 1;
        self.failed = false;
        self.growth = None;
        self.asked = Some(asked);
        Ok(())
    }

    /// Shows the map of growth and decay for a layer that was grown with these growths.
    pub fn ask_growth(&mut self, asked: RegionId, range: [f32; 2]) {
        self.question += 1;
        self.growth = Some(GrowthView::new(range));
        self.asked = Some(asked);
    }

    /// The range of growths that is marked in the map, where the map is shown.
    #[must_use]
    pub fn growth(&self) -> Option<[f32; 2]> {
        self.growth.as_ref().filter(|_| self.asked.is_some()).map(|view| view.range)
    }

    /// Closes the cloud, because another document was opened.
    pub fn forget(&mut self) {
        *self = Self { axes: self.axes, question: self.question, ..Self::default() };
    }

    /// The points that are shown.
    #[must_use]
    pub fn points(&self) -> Option<&Points> {
        self.points.as_deref().filter(|_| self.asked.is_some())
    }

    /// Shows the cloud where there is one; never waits.
    pub fn ui(&mut self, ctx: &Context) {
        if let Some(task) = &mut self.pending {
            let points = task.poll();
            if points.is_some() || task.has_ended() {
                self.points = points.flatten().map(Arc::new);
                self.failed = self.points.is_none();
                self.pending = None;
            }
        }
        let Some((_, [column, row])) = self.asked else { return };
        let mut open = true;
        let title = match &self.growth {
            Some(_) => "Growth map".to_owned(),
            None => format!("Training data: region {}, {}", column + 1, row + 1),
        };
        let window = Floating::new(title).id(Id::unique("cloud")).open(&mut open).collapsible(false);
        window.default_pos([120.0, 110.0]).default_size(vec2(560.0, 470.0)).show(ctx, |ui| self.content(ui));
        if !open {
            self.asked = None;
        }
    }

    fn content(&mut self, ui: &mut Ui) {
        if let Some(view) = &mut self.growth {
            view.ui(ui, self.question);
            return;
        }
        let Some(points) = self.points.clone().filter(|_| self.pending.is_none()) else {
            ui.weak(if self.failed {
                "There are no examples of this system."
            } else {
                "Reading the examples …"
            });
            return;
        };
        let first = [0, points.second].map(|index| points.quantities[index].0);
        let known = |axis: &Axis| points.quantities.iter().any(|(of, _)| of == axis);
        let mut axes = [0, 1].map(|axis| self.axes[axis].filter(known).unwrap_or(first[axis]));
        ui.horizontal(|ui| {
            for (axis, label) in ["Along x", "Along y"].into_iter().enumerate() {
                let shown = points.title(axes[axis]);
                ComboBox::from_label(label).selected_text(shown).width(150.0).show_ui(ui, |ui| {
                    for (quantity, title) in points.quantities {
                        if ui.selectable_value(&mut axes[axis], *quantity, *title).clicked() {
                            self.axes[axis] = Some(*quantity);
                        }
                    }
                });
            }
        });
        ui.weak(format!(
            "{} grown examples of {}; the parameters are interpolated from {} of them, drawn larger the more they weigh. \
             Lengths are scaled to these marks.",
            points.rows.len(),
            points.system,
            points.neighbours.len()
        ));
        plot::plot(ui, &points, axes, self.question);
    }
}
