//! A film of a growth, with equal visible change between its frames.
//!
//! ```text
//!  grown once, painted small ──▶ change at each moment ──▶ moments of the frames ──▶ grown again, painted at these
//! ```
//!
//! With x(t) the small pictures (red, green and blue), C(t) = Σ |x(tᵢ) − x(tᵢ₋₁)| over the moments up to t is the visible change.
//! Frame k of n shows the first moment at which C ≥ C(end)·k/(n − 1). Patterns change little at first, then quickly, then slowly
//! for a long time, so that most frames at equal times would look like the end. No frame is stored: a growth can be repeated
//! exactly.

use crate::document::Document;
use crate::export::{Stopped, downscale};
use crate::synth::error::GrowError;
use crate::synth::growth::{Grown, Growth, Progress, Snapshot};
use crate::synth::options::Options;
use crate::synth::render::painting::Painting;
use crate::synth::watch::{Stage, Watch};

/// Normalised time between two moments: a growth takes 20–100 of it on its coarsest grid, and changes most within 10.
const EVERY: f64 = 0.1;
/// px of the longer side of the small pictures.
const SMALL: usize = 96;

/// The content of a film.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The document.
    pub document: &'a Document,
    /// Options of the growth.
    pub options: Options<'a>,
}

/// The reason why a film ended early.
#[derive(Debug, thiserror::Error)]
pub enum FilmError {
    /// The growth failed.
    #[error(transparent)]
    Grow(#[from] GrowError),
    /// The function that takes the frames stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

/// Called with each frame: red, green, blue a px.
pub type Show<'a> = &'a mut dyn FnMut(&[u8]) -> Result<(), Stopped>;

/// A scene that has grown once, with the moments of its frames.
pub struct Takes {
    grown: Grown,
    frames: Vec<Moment>,
}

/// A moment of a growth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Moment {
    /// The number of the growth: a layer may be grown twice.
    growth: usize,
    /// The number of the snapshot in it.
    look: usize,
}

/// Counts snapshots.
#[derive(Default)]
struct Clock {
    layer: usize,
    steps: u64,
    now: Option<Moment>,
}

impl Clock {
    /// The moment of this snapshot, and whether its layer has started again.
    fn tick(&mut self, look: &Snapshot) -> (Moment, bool) {
        let (layer, steps) = (look.beneath.len(), look.growing.steps);
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

/// The visible change of a growth.
#[derive(Default)]
struct Change {
    /// The moments, with the change up to each.
    moments: Vec<(Moment, u64)>,
    /// The number of moments and the picture at the start of the layer.
    begun: (usize, Vec<u8>),
    last: Vec<u8>,
}

impl Change {
    fn changed(&self) -> u64 {
        self.moments.last().map_or(0, |(_, changed)| *changed)
    }

    fn add(&mut self, moment: Moment, again: bool, picture: Vec<u8>) {
        if again {
            // The first growth of the layer is not shown.
            self.moments.truncate(self.begun.0);
            self.last.clone_from(&self.begun.1);
        } else if moment.look == 0 {
            self.begun = (self.moments.len(), self.last.clone());
        }
        let changed = self.changed() + difference(&self.last, &picture);
        self.moments.push((moment, changed));
        self.last = picture;
    }

    /// The moments of `frames` frames, except for the last one, which is the `settled` picture.
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

/// Σ|b − a|; 0 where there is no picture before.
fn difference(a: &[u8], b: &[u8]) -> u64 {
    a.iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum()
}

/// Continues the growth up to the next moment. Returns whether there is one.
fn moment(growth: &mut Growth, watch: &Watch) -> Result<bool, GrowError> {
    loop {
        let (stage, share) = growth.progress();
        watch.step(stage, share)?;
        match growth.advance(growth.updates_in(EVERY))? {
            Progress::Growing { seen: true } => return Ok(true),
            Progress::Growing { seen: false } => {}
            Progress::Done => return Ok(false),
        }
    }
}

impl Takes {
    /// Grows a scene and finds the moments of `frames` frames, at least two.
    ///
    /// # Errors
    /// Those of [`GrowError`].
    pub fn record(scene: &Scene, frames: usize) -> Result<Self, GrowError> {
        let Scene { document, options } = *scene;
        let small = fitted(options.size.unwrap_or(document.size), SMALL);
        let (mut clock, mut seen) = (Clock::default(), Change::default());
        let mut growth = Growth::begin(document, &options, None).filmed();
        while moment(&mut growth, &options.watch)? {
            if let Some(look) = growth.snapshot() {
                let (moment, again) = clock.tick(&look);
                seen.add(moment, again, Painting::growing(document, &look, small).rgb());
            }
        }
        let grown = growth.complete().expect("it has grown");
        let settled = Painting::sized(document, &grown, small).unfinished().rgb();
        let frames = seen.spread(frames, &settled);
        Ok(Self { grown, frames })
    }

    /// Number of frames.
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
        let quiet = Watch { progress: &|_, _| {}, cancelled: watch.cancelled };
        let (mut clock, mut shown) = (Clock::default(), 0);
        let mut growth = Growth::begin(document, &options, None).filmed();
        // The rest of the growth is not shown.
        while shown < self.frames.len() && moment(&mut growth, &quiet)? {
            let Some(look) = growth.snapshot() else { continue };
            let (moment, _) = clock.tick(&look);
            if self.frames[shown] != moment {
                continue;
            }
            let paint = |size| Painting::growing(document, &look, size).with_finish(document);
            let picture = painted(&paint, self.grown.size, size);
            while self.frames.get(shown) == Some(&moment) {
                show(&picture)?;
                shown += 1;
            }
            (watch.progress)(Stage::Write, shown as f64 / self.frames() as f64);
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

/// A picture of `size` px. If it is smaller than the canvas, it is painted finer and averaged, so that thin marks do not flicker.
pub(super) fn painted<'a>(
    paint: &dyn Fn([usize; 2]) -> Painting<'a>,
    canvas: [u32; 2],
    size: [usize; 2],
) -> Vec<u8> {
    let finer = (canvas[0].max(canvas[1]) as usize).div_ceil(size[0].max(size[1])).clamp(1, FINEST);
    if finer == 1 {
        return paint(size).rgb();
    }
    let fine = size.map(|side| side * finer);
    let painting = paint(fine);
    if !painting.has_finish() {
        return downscale(&painting.rgb(), fine, size);
    }
    // A finish is painted at the size of the canvas where the picture is smaller: no finer one is needed.
    let canvas = canvas.map(|side| side as usize);
    downscale(&paint(canvas).rgb(), canvas, size)
}

/// Largest factor by which small pictures are painted finer.
const FINEST: usize = 3;

/// The colour that is `share` of the way from `a` to `b`.
pub(super) fn mixed(a: [u8; 3], b: [u8; 3], share: f64) -> [u8; 3] {
    [0, 1, 2].map(|i| ((1.0 - share) * f64::from(a[i]) + share * f64::from(b[i])).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(growth: usize, look: usize) -> Moment {
        Moment { growth, look }
    }

    #[test]
    fn frames_differ_equally() {
        let mut seen = Change::default();
        for (look, value) in [0, 0, 0, 10, 20, 60, 90, 98].into_iter().enumerate() {
            seen.add(moment(0, look), false, vec![value]);
        }
        let frames = seen.spread(6, &[100]);
        assert_eq!(frames, [0, 4, 5, 5, 6].map(|look| moment(0, look)));
    }

    #[test]
    fn a_layer_that_starts_again_is_shown_once() {
        let mut seen = Change::default();
        seen.add(moment(0, 0), false, vec![0]);
        seen.add(moment(0, 1), false, vec![10]);
        seen.add(moment(1, 0), false, vec![10]);
        seen.add(moment(1, 1), false, vec![90]);
        seen.add(moment(2, 0), true, vec![12]);
        seen.add(moment(2, 1), false, vec![30]);
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
