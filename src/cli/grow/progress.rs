//! The progress bar of a growth, on a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::synth::Stage;

/// Steps of the bar: finer than any terminal is wide.
const STEPS: f64 = 1000.0;

/// Shows how far a growth is, with the time left. Nothing is drawn where stderr is no terminal.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar; a hidden one where nobody wants it.
    pub fn new(quiet: bool) -> Self {
        let bar = if quiet {
            ProgressBar::hidden()
        } else {
            ProgressBar::with_draw_target(Some(STEPS as u64), ProgressDrawTarget::stderr())
        };
        let style =
            ProgressStyle::with_template("{msg:10} {bar:40} {percent:>3} %  {elapsed} gone, {eta} left");
        Self(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())))
    }

    /// Shows the share (0..1) of a stage.
    pub fn show(&self, stage: Stage, share: f64) {
        self.0.set_message(place(stage).0);
        self.0.set_position((STEPS * of_the_whole(stage, share)) as u64);
    }

    /// Takes the bar away.
    pub fn clear(&self) {
        self.0.finish_and_clear();
    }
}

/// A stage's name, and from where to where it goes in the whole, as seen on a canvas of 512 × 512 px.
fn place(stage: Stage) -> (&'static str, f64, f64) {
    match stage {
        Stage::Plan => ("planning", 0.0, 0.05),
        Stage::Grow => ("growing", 0.05, 0.9),
        Stage::Refine => ("refining", 0.9, 0.95),
        Stage::Write => ("writing", 0.95, 1.0),
    }
}

/// The share of a whole growth that is done with this share of a stage, both 0..1.
pub fn of_the_whole(stage: Stage, share: f64) -> f64 {
    let (_, from, to) = place(stage);
    from + (to - from) * share
}
