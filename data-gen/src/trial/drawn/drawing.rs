//! A picture of the sketch beside the texture, with the drawn outlines over both.

use dapple::document::{Document, Stroke};
use dapple_engine::export::downscale;
use dapple_engine::marks::{Ellipse, Path as Curve};
use dapple_engine::synth::Grown;
use dapple_engine::synth::render::painting::Painting;

use super::geometry::{distance, outline, turned};
use super::{paths, spots};

/// Sides of one picture, px.
pub const SIDE: usize = 256;
/// Gap between the two pictures, px.
pub const GAP: usize = 4;

const PAPER: [u8; 3] = [255, 255, 255];
const INK: [u8; 3] = [50, 50, 55];
/// The colour of outlines of marks that are there.
const THERE: [u8; 3] = [0, 130, 255];
/// The colour of outlines of marks that are missing.
const MISSING: [u8; 3] = [235, 20, 30];

/// The ellipses and the strokes of the lowest layer.
pub fn drawn(document: &Document) -> (Vec<Ellipse>, Vec<Curve>) {
    let (mut ellipses, mut curves) = (Vec::new(), Vec::new());
    for stroke in &document.layers[0].strokes {
        match stroke {
            Stroke::Ellipse(ellipse) | Stroke::Fitted { ellipse, .. } => ellipses.push(*ellipse),
            Stroke::Line(line) => curves.push(Curve::from(*line)),
            Stroke::Path(path) => curves.push(path.clone()),
            Stroke::Outline(_) => {}
            Stroke::Freehand { points, width } => {
                curves.push(Curve { points: points.clone(), width: *width });
            }
        }
    }
    (ellipses, curves)
}

/// A sketch beside its texture.
pub struct Drawing {
    /// Red, green, blue of each px.
    pub rgb: Vec<u8>,
}

impl Drawing {
    /// The picture of a sketch and its texture. Marks that are missing according to the comparison are red.
    pub fn new(document: &Document, grown: &Grown, spots: &[spots::Spot], strokes: &[paths::Stroke]) -> Self {
        let fine = [3 * SIDE; 2];
        let rgb = downscale(&Painting::sized(document, grown, fine).rgb(), fine, [SIDE; 2]);
        let spots: Vec<bool> = spots.iter().map(|spot| spot.there).collect();
        let strokes: Vec<bool> = strokes.iter().map(|stroke| stroke.covered >= paths::COVERED).collect();
        Self::compose(document, rgb, &spots, &strokes)
    }

    /// The picture of a sketch that did not grow.
    pub fn without_texture(document: &Document) -> Self {
        Self::compose(document, PAPER.repeat(SIDE * SIDE), &[], &[])
    }

    fn compose(document: &Document, texture: Vec<u8>, spots: &[bool], strokes: &[bool]) -> Self {
        let scale = SIDE as f64 / f64::from(document.size[0].max(document.size[1]));
        let (ellipses, lines) = drawn(document);
        let mut sketch = Canvas { rgb: PAPER.repeat(SIDE * SIDE), scale };
        let mut texture = Canvas { rgb: texture, scale };
        let colour = |there: Option<&bool>| if there == Some(&true) { THERE } else { MISSING };
        for (k, ellipse) in ellipses.iter().enumerate() {
            sketch.fill(ellipse, INK);
            let mut around = outline(ellipse);
            around.extend(around.first().copied());
            texture.trace(&around, 1.2 / scale, colour(spots.get(k)));
        }
        for (k, Curve { points, width }) in lines.iter().enumerate() {
            sketch.trace(points, *width, INK);
            texture.trace(points, 1.6 / scale, colour(strokes.get(k)));
        }
        let gap = PAPER.repeat(GAP);
        let rows = sketch.rgb.chunks(3 * SIDE).zip(texture.rgb.chunks(3 * SIDE));
        Self { rgb: rows.flat_map(|(left, right)| [left, &gap, right].concat()).collect() }
    }
}

/// A picture to draw on; lengths are px of the document.
struct Canvas {
    rgb: Vec<u8>,
    scale: f64,
}

impl Canvas {
    /// Draws a line through points.
    fn trace(&mut self, points: &[[f64; 2]], width: f64, colour: [u8; 3]) {
        let half = 0.5 * width * self.scale;
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|point| point.map(|x| x * self.scale));
            let length = distance(a, b).max(1e-9);
            let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
            self.each(a, b, half + 1.0, colour, |point| {
                let from = [point[0] - a[0], point[1] - a[1]];
                let t = (from[0] * along[0] + from[1] * along[1]).clamp(0.0, length);
                half + 0.5 - distance(from, [t * along[0], t * along[1]])
            });
        }
    }

    /// Draws a filled ellipse.
    fn fill(&mut self, ellipse: &Ellipse, colour: [u8; 3]) {
        let radii = ellipse.radii.map(|radius| radius * self.scale);
        let center = ellipse.center.map(|x| x * self.scale);
        let reach = radii[0].max(radii[1]) + 1.0;
        self.each(center, center, reach, colour, |point| {
            let from = [point[0] - center[0], point[1] - center[1]];
            let [x, y] = turned(from, -ellipse.angle.to_radians());
            let out = libm::hypot(x / radii[0], y / radii[1]);
            0.5 + (1.0 - out) * radii[0].min(radii[1])
        });
    }

    /// Mixes the colour into each px by its share, within the box around `a` and `b` with a margin.
    fn each(
        &mut self,
        a: [f64; 2],
        b: [f64; 2],
        margin: f64,
        colour: [u8; 3],
        share: impl Fn([f64; 2]) -> f64,
    ) {
        let range = |axis: usize| {
            let low = (a[axis].min(b[axis]) - margin).max(0.0) as usize;
            let high = (a[axis].max(b[axis]) + margin).clamp(0.0, SIDE as f64) as usize;
            low..high.min(SIDE)
        };
        for y in range(1) {
            for x in range(0) {
                let share = share([x as f64 + 0.5, y as f64 + 0.5]).clamp(0.0, 1.0);
                let px = 3 * (y * SIDE + x);
                for (under, over) in self.rgb[px..px + 3].iter_mut().zip(colour) {
                    let mixed = f64::from(*under) + share * (f64::from(over) - f64::from(*under));
                    *under = mixed.round() as u8;
                }
            }
        }
    }
}
