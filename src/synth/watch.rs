//! Looking on while something grows, and stopping it.

/// What is being done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Looking up parameters, laying out the grid and where spots begin.
    Plan,
    /// Reaction and diffusion.
    Grow,
    /// Measuring what has grown and correcting it.
    Refine,
    /// Writing pictures.
    Write,
}

/// Told how far the work is, and asked whether to go on.
pub struct Watch<'a> {
    /// Is told the stage and the share of it that is done, 0..1.
    pub progress: &'a (dyn Fn(Stage, f64) + Sync),
    /// Says whether to stop.
    pub cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// Was asked to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cancelled")]
pub struct Cancelled;

impl Watch<'_> {
    /// Nobody looks on.
    pub const NOBODY: Watch<'static> = Watch { progress: &|_, _| {}, cancelled: &|| false };

    /// Tells how far the work is.
    ///
    /// # Errors
    /// [`Cancelled`] where it should stop.
    pub fn step(&self, stage: Stage, share: f64) -> Result<(), Cancelled> {
        (self.progress)(stage, share.clamp(0.0, 1.0));
        if (self.cancelled)() { Err(Cancelled) } else { Ok(()) }
    }
}
