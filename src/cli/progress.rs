//! The progress bar of a growth, on a terminal.

use std::io::{self, IsTerminal};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::synth::Stage;

/// Steps of the bar: more than any terminal has columns.
const STEPS: f64 = 1000.0;

/// A progress bar with the time left. Nothing is drawn if stderr is not a terminal.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar, hidden if `quiet`.
    pub fn new(quiet: bool) -> Self {
        let bar = if quiet {
            ProgressBar::hidden()
        } else {
            ProgressBar::with_draw_target(Some(STEPS as u64), ProgressDrawTarget::stderr())
        };
        let style =
            ProgressStyle::with_template("{msg:10} {bar:40} {percent:>3} %  {elapsed} elapsed, {eta} left");
        Self(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())))
    }

    /// Shows the share (0..1) of a stage.
    pub fn show(&self, stage: Stage, share: f64) {
        self.0.set_message(place(stage).0);
        self.0.set_position((STEPS * overall(stage, share)) as u64);
    }

    /// Writes a note on how long the work takes, if there is one, above the bar. It depends on what else the machine does, so that it goes to
    /// terminals only: elsewhere the same work writes the same lines.
    pub fn note(&self, text: Option<String>) {
        if let Some(text) = text.filter(|_| io::stderr().is_terminal()) {
            self.0.suspend(|| super::note(&text));
        }
    }

    /// Removes the bar.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}

/// The name of a stage, and its start and end as shares of the whole growth, measured on a canvas of 512 × 512 px.
fn place(stage: Stage) -> (&'static str, f64, f64) {
    match stage {
        Stage::Plan => ("planning", 0.0, 0.05),
        Stage::Grow => ("growing", 0.05, 0.9),
        Stage::Refine => ("refining", 0.9, 0.95),
        Stage::Write => ("writing", 0.95, 1.0),
    }
}

/// The share of the whole growth that is done after this share of a stage, both 0..1.
pub fn overall(stage: Stage, share: f64) -> f64 {
    let (_, from, to) = place(stage);
    from + (to - from) * share
}
