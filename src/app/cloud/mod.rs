//! Why these parameters: the grown examples from which they were learnt, the question, and the neighbours that
//! answered it.

mod plot;
mod points;

pub use points::Points;

use std::sync::Arc;
use std::sync::mpsc::{self, Receiver};
use std::thread;

use egui::{ComboBox, Context, Id, Ui, Window as Floating, vec2};

use super::result::RegionResult;
use crate::rd::System;
use crate::synth::Training;

/// The region that is asked about: layer, column and row.
pub type Asked = (usize, [usize; 2]);

/// The cloud and how it is looked at.
#[derive(Default)]
pub struct Cloud {
    /// Which region it is about; `None` = it is not shown.
    pub asked: Option<Asked>,
    /// What stands along x and y: names of attributes or parameters; `None` = the first two.
    axes: [Option<&'static str>; 2],
    points: Option<Arc<Points>>,
    pending: Option<Receiver<Option<Points>>>,
    failed: bool,
    /// Counts the questions, so that each is framed anew.
    question: u64,
}

impl Cloud {
    /// Asks for the cloud about a region, grown with `system`.
    pub fn ask(
        &mut self,
        ctx: &Context,
        asked: Asked,
        system: System,
        region: &RegionResult,
        training: &Arc<Training>,
    ) {
        let (tell, pending) = mpsc::channel();
        let (ctx, training) = (ctx.clone(), Arc::clone(training));
        let report = region.report.clone();
        // Without a thread the cloud stays empty.
        drop(thread::Builder::new().name("cloud".to_owned()).spawn(move || {
            // The window may have gone.
            let _ = tell.send(Points::about(&training, system, &report));
            ctx.request_repaint();
        }));
        self.question += 1;
        self.failed = false;
        self.pending = Some(pending);
        self.asked = Some(asked);
    }

    /// Another document is open.
    pub fn forget(&mut self) {
        *self = Self { axes: self.axes, question: self.question, ..Self::default() };
    }

    /// The cloud that is shown.
    #[must_use]
    pub fn points(&self) -> Option<&Points> {
        self.points.as_deref().filter(|_| self.asked.is_some())
    }

    /// Shows it, if it is asked for; never waits.
    pub fn ui(&mut self, ctx: &Context) {
        if let Some(points) = self.pending.as_ref().and_then(|pending| pending.try_recv().ok()) {
            self.failed = points.is_none();
            self.points = points.map(Arc::new);
            self.pending = None;
        }
        let Some((_, [column, row])) = self.asked else { return };
        let mut open = true;
        let title = format!("Training cloud: region {}, {}", column + 1, row + 1);
        let window = Floating::new(title).id(Id::unique("cloud")).open(&mut open).collapsible(false);
        window.default_pos([120.0, 110.0]).default_size(vec2(560.0, 470.0)).show(ctx, |ui| self.content(ui));
        if !open {
            self.asked = None;
        }
    }

    fn content(&mut self, ui: &mut Ui) {
        let Some(points) = self.points.clone().filter(|_| self.pending.is_none()) else {
            ui.weak(if self.failed { "There are no examples of this." } else { "Reading the examples …" });
            return;
        };
        let first =
            [points.names[0].0, points.names.iter().map(|name| name.0).nth(points.second).unwrap_or("area")];
        let known = |name: &'static str| points.names.iter().any(|(of, _)| *of == name);
        let mut axes = [0, 1].map(|axis| self.axes[axis].filter(|name| known(name)).unwrap_or(first[axis]));
        ui.horizontal(|ui| {
            for (axis, label) in ["Along x", "Along y"].into_iter().enumerate() {
                let shown = points.title(axes[axis]);
                ComboBox::from_label(label).selected_text(shown).width(150.0).show_ui(ui, |ui| {
                    for (name, title) in points.names {
                        if ui.selectable_value(&mut axes[axis], name, *title).clicked() {
                            self.axes[axis] = Some(name);
                        }
                    }
                });
            }
        });
        ui.weak(format!(
            "{} grown examples of {}; {} of them answered, the larger the more they weigh. px at this size of marks.",
            points.rows.len(),
            points.system,
            points.neighbours.len()
        ));
        plot::plot(ui, &points, axes, self.question);
    }
}
