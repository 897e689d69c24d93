//! The settings of a film: of a growth, or of one document that becomes another.

use crate::document::Document;
use crate::export::ExportError;
use crate::export::motion::{COLOURS, Film, Kind};
use crate::synth::error::GrowError;
use crate::synth::render::film::fitted;
use crate::synth::render::palette::palette;

/// Default number of px of the longer side of a frame: films are usually watched small.
pub const SIDE: u32 = 480;
/// Allowed sides of a frame, px.
pub const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;
/// Allowed frames a second.
pub const RATES: std::ops::RangeInclusive<u16> = 1..=120;
/// Most frames a second of a GIF: its unit is a hundredth of a second, and browsers show one hundredth as ten.
pub const FASTEST_GIF: u16 = 50;
/// Frames of the longest film.
const MOST: f64 = 20_000.0;

/// Settings of a film.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Clip {
    /// px of the longer side of a frame; `None` = the canvas's, at most [`SIDE`].
    pub side: Option<u32>,
    /// Seconds, without the hold at the end.
    pub seconds: f64,
    /// Frames a second.
    pub fps: u16,
    /// Whether the film stops at the last frame instead of repeating.
    pub once: bool,
    /// Seconds that the last frame is held before it repeats.
    pub hold: f64,
}

impl Default for Clip {
    fn default() -> Self {
        Self { side: None, seconds: 4.0, fps: 20, once: false, hold: 1.5 }
    }
}

/// The reason why there is no film.
#[derive(Debug, thiserror::Error)]
pub enum ClipError {
    /// More frames a second than a GIF shows.
    #[error(
        "--fps: found {0}; allowed: 1 to {FASTEST_GIF} in a .gif, which browsers show no faster; .png takes 120"
    )]
    TooFast(u16),
    /// Too few frames, or too many.
    #[error("--seconds {seconds} at --fps {fps}: make {frames} frames; allowed: 2 to {MOST}")]
    Frames {
        /// Length of the film, seconds.
        seconds: f64,
        /// Frames a second.
        fps: u16,
        /// Frames.
        frames: f64,
    },
    /// The growth failed.
    #[error(transparent)]
    Grow(#[from] GrowError),
    /// The file cannot be written.
    #[error(transparent)]
    Export(#[from] ExportError),
}

impl Clip {
    /// Number of frames of a film of this `kind`.
    ///
    /// # Errors
    /// [`ClipError::TooFast`], [`ClipError::Frames`].
    pub fn frames(&self, kind: Kind) -> Result<usize, ClipError> {
        let Self { seconds, fps, .. } = *self;
        if kind == Kind::Gif && fps > FASTEST_GIF {
            return Err(ClipError::TooFast(fps));
        }
        let frames = (seconds * f64::from(fps)).round();
        if !(2.0..=MOST).contains(&frames) {
            return Err(ClipError::Frames { seconds, fps, frames });
        }
        Ok(frames as usize)
    }

    /// The header of a film of these documents: everything but its frames.
    #[must_use]
    pub fn film(&self, documents: &[&Document], frames: usize) -> Film {
        let canvas = documents[0].size;
        let side = self.side.unwrap_or(SIDE.min(canvas[0].max(canvas[1])));
        Film {
            size: fitted(canvas, side as usize),
            frames,
            fps: self.fps,
            hold: self.hold,
            once: self.once,
            palette: palette(documents, COLOURS),
        }
    }
}
