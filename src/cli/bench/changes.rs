//! Measures, for changes of a sketch: how soon a change is shown, and whether grown marks far from it keep their
//! places.
//!
//! The growth of the window is measured without the window, with its thread, its pictures and its number of threads.

use super::check_interrupt;
use super::kernels::median;
use crate::app::growth::{Growth, GrowthState};
use crate::attributes::{Attributes, Spots};
use crate::cli::Error;
use crate::document::{Document, Layer, Stroke, SystemChoice};
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::task::Tasks;
use crate::machine::threads;
use crate::rd::System;
use crate::synth::{Grown, GrownLayer};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::fmt::Write;
use std::sync::Arc;
use std::time::Duration;

/// Side of the canvas, px.
const SIDE: u32 = 512;
/// Area of each mark, px².
const AREA: f64 = 300.0;
/// Marks that are moved; in most sketches there are no others.
const MARKS: usize = 10;
/// Minor ÷ major radius.
const ASPECT: f64 = 0.75;
/// Distance of the drawn marks, px: a tenth of the ground is marks.
const APART: f64 = 54.0;
/// How far a mark is moved, px.
const MOVED: [f64; 2] = [14.0, -9.0];
/// Marks that are farther than this from the moved mark count as far, spacings.
const FAR: f64 = 5.0;
/// A mark counts as moved if it is farther than this from its earlier place, radii.
const STAYS: f64 = 0.2;

/// What is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Sketch {
    /// A few marks that are part of the texture; the others grow around them.
    Free,
    /// A few marks that only set the attributes of four regions.
    Regions,
    /// A few marks that only set the attributes of four regions, with irregular outlines.
    Irregular,
    /// Marks all over the canvas that are part of the texture.
    AllOver,
}

impl Sketch {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Free, Self::Regions, Self::Irregular, Self::AllOver];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Free => "free marks",
            Self::Regions => "2 × 2 regions",
            Self::Irregular => "irregular, 2 × 2 regions",
            Self::AllOver => "marks all over",
        }
    }

    /// The document.
    fn document(self) -> Document {
        let major = (AREA / PI / ASPECT).sqrt();
        let spot = |index: usize| {
            let radii = [major, ASPECT * major];
            Stroke::ellipse(self.center(index), radii, 30.0 + 4.0 * (index % MARKS) as f64)
        };
        let mut layer = Layer::new((0..self.marks()).map(spot));
        if let Self::Irregular = self {
            let system = System::first(|system| system.irregular);
            layer.system = system.map_or(SystemChoice::Auto, |system| SystemChoice::Of(system.description()));
            layer.options.irregular = 0.6;
        }
        let regions = if let Self::Free | Self::AllOver = self { None } else { Some([2, 2]) };
        Document { regions, ..Document::new([SIDE; 2]).with_layer(layer) }
    }

    /// The document after mark `moved` was dragged to another place in the window.
    fn after_move(self, moved: usize) -> Document {
        let mut session = Session::open(self.document(), None);
        session.selection = Selection::new(vec![Place { layer: 0, stroke: moved }]);
        session.nudge(MOVED);
        session.finished()
    }

    /// The number of drawn marks.
    fn marks(self) -> usize {
        if let Self::AllOver = self { 9 * 11 } else { MARKS }
    }

    /// The place of drawn mark `index`, px: in rows, every second one shifted. In `AllOver` the places are less even,
    /// like a drawing by hand: each is shifted by up to a tenth of the distance of the marks.
    fn center(self, index: usize) -> [f64; 2] {
        let (in_a_row, first, uneven) = match self {
            Self::AllOver => (9, 26.0, 0.1),
            Self::Free | Self::Regions | Self::Irregular => (3, 60.0, 0.0),
        };
        let [column, row] = [index % in_a_row, index / in_a_row];
        let shift = if row % 2 == 0 { 0.0 } else { 0.5 };
        // Evenly distributed numbers, 0..1: multiples of the golden ratio and of √2.
        let off = [0.618_034, 0.414_214].map(|step| uneven * (2.0 * (step * index as f64).fract() - 1.0));
        [first + APART * (column as f64 + shift + off[0]), first + APART * (0.87 * row as f64 + off[1])]
    }
}

/// The measurement of one sketch.
#[derive(Clone, Debug)]
pub struct Changes {
    sketch: Sketch,
    /// Median time from a change to its first picture, seconds.
    first: f64,
    /// Median time from a change to the settled picture, seconds.
    settled: f64,
    /// For each change: the share of the far marks that have moved too.
    moved: Vec<f64>,
}

/// Moves the first `changes` marks of `sketch`, each once.
///
/// # Errors
///
/// [`Error::Interrupted`]; the sketch cannot be grown.
pub fn measure(sketch: Sketch, changes: usize) -> Result<Changes, Error> {
    let mut growth = Growth::new(Tasks::default());
    let before = grow(&mut growth, &sketch.document())?.grown;
    let (mut first, mut settled, mut moved) = (Vec::new(), Vec::new(), Vec::new());
    for index in (0..MARKS).cycle().take(changes) {
        // All over the sketch.
        let index = index * sketch.marks() / MARKS;
        let times = grow(&mut growth, &sketch.after_move(index))?;
        first.push(times.first);
        settled.push(times.settled);
        moved.push(share_moved(sketch.center(index), &before, &times.grown));
    }
    Ok(Changes { sketch, first: median(first), settled: median(settled), moved })
}

struct Times {
    first: f64,
    settled: f64,
    grown: Arc<Grown>,
}

/// Grows a document as the window does.
fn grow(growth: &mut Growth, document: &Document) -> Result<Times, Error> {
    growth.grow(document);
    loop {
        check_interrupt()?;
        growth.listen();
        match (&growth.state, &growth.texture, growth.first_picture) {
            (GrowthState::Settled(settled), Some(texture), Some(first)) => {
                let [first, settled] = [first, *settled].map(|time| time.as_secs_f64());
                return Ok(Times { first, settled, grown: Arc::clone(&texture.grown) });
            }
            (GrowthState::Failed(why), ..) => return Err(Error::Usage(why.clone())),
            _ => threads::sleep(Duration::from_micros(500)),
        }
    }
}

/// Of the marks far from the one that was drawn at `center`, the share that is farther from any earlier mark than a
/// mark may move, or that has disappeared.
fn share_moved(center: [f64; 2], before: &Grown, after: &Grown) -> f64 {
    let places = |grown: &Grown| -> Vec<[f64; 2]> {
        let spots =
            grown.layers.first().and_then(GrownLayer::marks).map_or(&[][..], |layer| layer.measured.spots());
        spots.iter().map(|spot| spot.ellipse.center).collect()
    };
    let wanted = before.layers.first().and_then(GrownLayer::marks).map(|layer| layer.plan.lookup.wanted()[0]);
    let spacing = match wanted {
        Some(Attributes::Spots(Spots { spacing: Some(spacing), .. })) => spacing,
        _ => APART,
    };
    let away = |a: [f64; 2], b: [f64; 2]| ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
    let is_far = |at: &[f64; 2]| away(*at, center) > FAR * spacing;
    let [before, after] = [before, after].map(places);
    let radius = (AREA / PI).sqrt();
    let stays = |at: &[f64; 2], among: &[[f64; 2]]| among.iter().any(|one| away(*at, *one) < STAYS * radius);
    let lost = |from: &[[f64; 2]], among: &[[f64; 2]]| {
        let far: Vec<&[f64; 2]> = from.iter().filter(|at| is_far(at)).collect();
        let moved = far.iter().filter(|at| !stays(at, among)).count();
        moved as f64 / far.len().max(1) as f64
    };
    lost(&before, &after).max(lost(&after, &before))
}

impl Changes {
    /// JSON of the times, s, and shares.
    pub fn json(&self) -> Value {
        let Self { sketch, first, settled, moved } = self;
        json!({"sketch": sketch.name(), "first_picture": first, "settled": settled, "moved_far_away": moved})
    }
}

/// One line for each sketch.
pub fn table(measurements: &[Changes]) -> String {
    let mut text = format!(
        "\nTimes after one mark of {AREA} px² was moved on a canvas of {SIDE} × {SIDE} px, as in the window\n  {:26} {:>14} {:>12} {:>24}\n",
        "sketch", "first picture", "settled", "far marks that moved"
    );
    for Changes { sketch, first, settled, moved } in measurements {
        let most = moved.iter().copied().fold(0.0, f64::max);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  {:26} {:>11.0} ms {:>9.0} ms {:>11.1} %, at most {:.1} %",
            sketch.name(),
            1e3 * first,
            1e3 * settled,
            1e2 * median(moved.clone()),
            1e2 * most
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::Measured;

    #[test]
    fn only_marks_far_from_the_change_count_in_the_share_that_moved() {
        let first = Sketch::Regions.center(0);
        let grown = Sketch::Regions.document().grow().expect("a texture");
        let shifted = |by: f64, is_near: bool| {
            let mut grown = Grown {
                size: grown.size,
                layers: grown.layers.clone(),
                document: grown.document.clone(),
                settings: grown.settings,
            };
            let layer = grown.layers[0].marks_mut().expect("marks");
            let Measured::Spots { marks, .. } = &mut layer.measured else { panic!("spots") };
            for mark in marks {
                let [x, y] = mark.ellipse.center;
                if (x + y < 200.0) == is_near {
                    mark.ellipse.center = [x + by, y];
                }
            }
            grown
        };
        assert_eq!(share_moved(first, &grown, &shifted(9.0, true)), 0.0);
        assert_eq!(share_moved(first, &grown, &shifted(1.5, false)), 0.0);
        assert!(share_moved(first, &grown, &shifted(9.0, false)) > 0.9);
    }

    #[test]
    fn a_change_moves_one_mark() {
        let [before, after] = [Sketch::Free.document(), Sketch::Free.after_move(4)];
        let [before, after] = [before, after].map(|mut document| document.layers.remove(0).strokes);
        let changed: Vec<usize> = (0..MARKS).filter(|index| before[*index] != after[*index]).collect();
        assert_eq!(changed, [4]);
    }
}
