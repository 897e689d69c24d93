//! A growth as a film: frames as far apart as they look.
//!
//! ```text
//!  grown once, seen small ──▶ how much each moment changes ──▶ the moments of the frames ──▶ grown again, painted there
//! ```
//!
//! With x(t) the small pictures, red, green and blue, C(t) = Σ |x(tᵢ) − x(tᵢ₋₁)| over the moments up to t is how much has
//! been seen to change. Frame k of n shows the first moment at which C ≥ C(end)·k/(n − 1): nothing happens for long at
//! first, then all at once, and at last hardly anything again, and a film in steps of time shows little but the last. No
//! frame is kept: a growth is the same each time.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::document::Document;
use crate::export::{Stopped, downscale};
use crate::synth::grow::cascade::grow_seen;
use crate::synth::grow::layer::{GrowError, Grown};
use crate::synth::grow::snapshot::Snapshot;
use crate::synth::options::Options;
use crate::synth::render::painting::{Painting, gradient_of};
use crate::synth::watch::{Stage, Watch};

/// Normalised time from moment to moment: a growth takes 20–100 of it on its coarsest grid, where most of what is seen
/// happens within 10.
const EVERY: f64 = 0.1;
/// px of the longer side of the small pictures.
const SMALL: usize = 96;

/// What is filmed.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The document.
    pub document: &'a Document,
    /// How it is grown.
    pub options: Options<'a>,
}

/// Why a film ended early.
#[derive(Debug, thiserror::Error)]
pub enum FilmError {
    /// The growth.
    #[error(transparent)]
    Grow(#[from] GrowError),
    /// Whoever takes the frames.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

/// Takes a frame: red, green, blue a px.
pub type Show<'a> = &'a mut dyn FnMut(&[u8]) -> Result<(), Stopped>;

/// A scene that has been seen once: what has grown, and which moments are frames.
pub struct Takes {
    grown: Grown,
    frames: Vec<Moment>,
}

/// A look at a growth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Moment {
    /// Which growth: a layer may take two.
    growth: usize,
    /// Which look at it.
    look: usize,
}

/// Counts the looks.
#[derive(Default)]
struct Clock {
    layer: usize,
    steps: u64,
    now: Option<Moment>,
}

impl Clock {
    /// The moment of this look; and whether its layer began anew.
    fn tick(&mut self, look: &Snapshot) -> (Moment, bool) {
        let (layer, steps) = (look.beneath.len(), look.engine.steps());
        let again = layer == self.layer && steps < self.steps;
        let next = layer != self.layer || again;
        let now = match self.now {
            None => Moment { growth: 0, look: 0 },
            Some(Moment { growth, .. }) if next => Moment { growth: growth + 1, look: 0 },
            Some(Moment { growth, look }) => Moment { growth, look: look + 1 },
        };
        (self.layer, self.steps, self.now) = (layer, steps, Some(now));
        (now, again)
    }
}

/// What has been seen of a growth.
#[derive(Default)]
struct Seen {
    /// The moments, with how much has been seen to change up to each.
    moments: Vec<(Moment, u64)>,
    /// How many moments there were, and the picture, when the layer began.
    begun: (usize, Vec<u8>),
    last: Vec<u8>,
}

impl Seen {
    fn changed(&self) -> u64 {
        self.moments.last().map_or(0, |(_, changed)| *changed)
    }

    fn see(&mut self, moment: Moment, again: bool, picture: Vec<u8>) {
        if again {
            // What stood there is not what will stand there.
            self.moments.truncate(self.begun.0);
            self.last.clone_from(&self.begun.1);
        } else if moment.look == 0 {
            self.begun = (self.moments.len(), self.last.clone());
        }
        let changed = self.changed() + difference(&self.last, &picture);
        self.moments.push((moment, changed));
        self.last = picture;
    }

    /// The moments of `frames` frames, the last of which is that of the `settled` picture and not among them.
    fn spread(&self, frames: usize, settled: &[u8]) -> Vec<Moment> {
        let all = self.changed() + difference(&self.last, settled);
        let ways = frames.max(2) as u64 - 1;
        let frame = |k: u64| {
            let first = self.moments.partition_point(|(_, changed)| changed * ways < all * k);
            self.moments.get(first).or(self.moments.last()).map(|(moment, _)| *moment)
        };
        (0..ways).filter_map(frame).collect()
    }
}

/// Σ|b − a|; nothing where there is no picture before.
fn difference(a: &[u8], b: &[u8]) -> u64 {
    a.iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum()
}

impl Takes {
    /// Grows a scene and finds the moments of `frames` frames, at least two.
    ///
    /// # Errors
    /// See [`GrowError`].
    pub fn of(scene: &Scene, frames: usize) -> Result<Self, GrowError> {
        let Scene { document, options } = *scene;
        let small = fitted(options.size.unwrap_or(document.size), SMALL);
        let (mut clock, mut seen) = (Clock::default(), Seen::default());
        let grown = grow_seen(document, &options, EVERY, &mut |look| {
            let (moment, again) = clock.tick(look);
            seen.see(moment, again, Painting::growing(document, look, small).rgb());
        })?;
        let settled = Painting::sized(document, &grown, small).rgb();
        let frames = seen.spread(frames, &settled);
        Ok(Self { grown, frames })
    }

    /// How many frames there are.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames.len() + 1
    }

    /// Shows the frames, `size` px, the settled texture last.
    ///
    /// # Errors
    /// [`FilmError`].
    pub fn play(&self, scene: &Scene, size: [usize; 2], show: Show) -> Result<(), FilmError> {
        let Scene { document, options } = *scene;
        let watch = options.watch;
        let over = AtomicBool::new(self.frames.is_empty());
        let cancelled = || over.load(Ordering::Relaxed) || (watch.cancelled)();
        let quiet = Options { watch: Watch { progress: &|_, _| {}, cancelled: &cancelled }, ..options };
        let (mut clock, mut shown, mut stopped) = (Clock::default(), 0, None);
        let again = match over.load(Ordering::Relaxed) {
            true => Ok(()),
            false => grow_seen(document, &quiet, EVERY, &mut |look| {
                let (moment, _) = clock.tick(look);
                if self.frames.get(shown) != Some(&moment) || stopped.is_some() {
                    return;
                }
                let picture = painted(&|size| Painting::growing(document, look, size), self.grown.size, size);
                while self.frames.get(shown) == Some(&moment) && stopped.is_none() {
                    stopped = show(&picture).err();
                    shown += 1;
                }
                (watch.progress)(Stage::Write, shown as f64 / self.frames() as f64);
                // What is left of the growth has been seen.
                over.store(stopped.is_some() || shown == self.frames.len(), Ordering::Relaxed);
            })
            .map(drop),
        };
        if let Some(stopped) = stopped {
            return Err(stopped.into());
        }
        if shown < self.frames.len() {
            again?;
        }
        if (watch.cancelled)() {
            return Err(Stopped::Cancelled.into());
        }
        let settled = painted(&|size| Painting::sized(document, &self.grown, size), self.grown.size, size);
        Ok(show(&settled)?)
    }
}

/// The size of frames of `canvas` whose longer side is `side` px.
#[must_use]
pub fn fitted(canvas: [u32; 2], side: usize) -> [usize; 2] {
    let longest = f64::from(canvas[0].max(canvas[1]));
    canvas.map(|length| ((f64::from(length) / longest * side as f64).round() as usize).max(1))
}

/// A picture of `size` px: one smaller than the canvas is painted finer and averaged, so that thin marks do not flicker.
pub(crate) fn painted<'a>(
    paint: &dyn Fn([usize; 2]) -> Painting<'a>,
    canvas: [u32; 2],
    size: [usize; 2],
) -> Vec<u8> {
    let finer = (canvas[0].max(canvas[1]) as usize).div_ceil(size[0].max(size[1])).clamp(1, FINEST);
    if finer == 1 {
        return paint(size).rgb();
    }
    let fine = size.map(|side| side * finer);
    downscale(&paint(fine).rgb(), fine, size)
}

/// Times finer at most that a small picture is painted.
const FINEST: usize = 3;

/// Up to `most` colours that films of these documents need: evenly along the colours of their visible layers, and on the
/// way from the first document's to the last's.
#[must_use]
pub fn palette(documents: &[&Document], most: usize) -> Vec<[u8; 3]> {
    let tables = |document: &Document| {
        let layers = document.layers.iter().enumerate().filter(|(_, layer)| layer.visible);
        layers.map(|(index, layer)| gradient_of(layer, index).table()).collect::<Vec<_>>()
    };
    let (Some(first), Some(last)) = (documents.first(), documents.last()) else { return Vec::new() };
    let (first, last) = (tables(first), tables(last));
    let stations = if documents.len() > 1 { STATIONS } else { 1 };
    let layers = first.len().max(1);
    let shades = (most / (layers * stations)).max(2);
    let mut colours = Vec::with_capacity(most);
    for (a, b) in first.iter().zip(&last) {
        for station in 0..stations {
            let share = station as f64 / (stations.max(2) - 1) as f64;
            let shade = |k: usize| k as f32 / (shades - 1) as f32;
            colours.extend((0..shades).map(|k| mixed(a.colour(shade(k)), b.colour(shade(k)), share)));
        }
    }
    colours.sort_unstable();
    colours.dedup();
    colours.truncate(most);
    colours
}

/// Colours on the way from one document's to another's.
const STATIONS: usize = 8;

/// A colour on the way from `a` to `b`.
pub(crate) fn mixed(a: [u8; 3], b: [u8; 3], share: f64) -> [u8; 3] {
    [0, 1, 2].map(|i| ((1.0 - share) * f64::from(a[i]) + share * f64::from(b[i])).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(growth: usize, look: usize) -> Moment {
        Moment { growth, look }
    }

    #[test]
    fn frames_are_as_far_apart_as_they_look() {
        let mut seen = Seen::default();
        for (look, value) in [0, 0, 0, 10, 20, 60, 90, 98].into_iter().enumerate() {
            seen.see(moment(0, look), false, vec![value]);
        }
        let frames = seen.spread(6, &[100]);
        assert_eq!(frames, [0, 4, 5, 5, 6].map(|look| moment(0, look)));
    }

    #[test]
    fn a_layer_that_begins_anew_is_seen_once() {
        let mut seen = Seen::default();
        seen.see(moment(0, 0), false, vec![0]);
        seen.see(moment(0, 1), false, vec![10]);
        seen.see(moment(1, 0), false, vec![10]);
        seen.see(moment(1, 1), false, vec![90]);
        seen.see(moment(2, 0), true, vec![12]);
        seen.see(moment(2, 1), false, vec![30]);
        let growths: Vec<_> =
            seen.moments.iter().map(|(moment, changed)| (moment.growth, *changed)).collect();
        assert_eq!(growths, [(0, 0), (0, 10), (2, 12), (2, 30)]);
    }

    #[test]
    fn frames_keep_the_shape_of_the_canvas() {
        assert_eq!(fitted([512, 256], 100), [100, 50]);
        assert_eq!(fitted([1, 4000], 100), [1, 100]);
    }
}
