//! Progress of a growth, and cancelling it.

/// The stages of the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Looking up parameters, laying out the grid and the initial places of marks.
    Plan,
    /// Reaction and diffusion.
    Grow,
    /// Measuring the pattern and correcting its thresholds.
    Refine,
    /// Writing pictures.
    Write,
}

/// Callbacks of a long computation: one receives its progress, the other one can cancel it.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Called with the stage and the share of it that is done, 0..1.
    pub progress: &'a (dyn Fn(Stage, f64) + Sync),
    /// Called every few milliseconds; the computation stops if it returns true.
    pub cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// The computation was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cancelled")]
pub struct Cancelled;

impl Watch<'_> {
    /// Ignores progress and never cancels.
    pub const NONE: Watch<'static> = Watch { progress: &|_, _| {}, cancelled: &|| false };

    /// Reports progress.
    ///
    /// # Errors
    /// [`Cancelled`] if the computation should stop.
    pub fn step(&self, stage: Stage, share: f64) -> Result<(), Cancelled> {
        (self.progress)(stage, share.clamp(0.0, 1.0));
        if (self.cancelled)() { Err(Cancelled) } else { Ok(()) }
    }
}

impl Default for Watch<'_> {
    fn default() -> Self {
        Self::NONE
    }
}
