//! The document from which a patch grows.

use std::f64::consts::PI;

use super::{Drawn, GAP, PERIOD, PairPatch};
use crate::document::{Document, DutyChoice, Edges, GapChoice, Layer, LayerOptions, Stroke, SystemChoice};
use crate::rd::pairs::polygons::distance;
use crate::rd::pairs::{PairKind, Threads};

impl PairPatch {
    /// The drawn marks of the patch, as a document.
    #[must_use]
    pub fn document(&self) -> Document {
        let Drawn { duty, decay, .. } = self.drawn;
        let lines = |angles: &[f64], long: f64| -> Vec<Stroke> {
            angles.iter().enumerate().flat_map(|(index, angle)| self.two_lines(index, *angle, long)).collect()
        };
        let long = 0.6 * self.side();
        let (strokes, options) = match self.kind() {
            Some(PairKind::Weave) => (lines(&self.angles(), long), LayerOptions::default()),
            Some(PairKind::Maze) => {
                (lines(&self.angles(), self.drawn.long * PERIOD), LayerOptions::default())
            }
            Some(PairKind::Stripes) => (
                lines(&[self.drawn.angle], long),
                LayerOptions { duty: DutyChoice::Given(duty), ..LayerOptions::default() },
            ),
            Some(PairKind::Stucco) => {
                let middle = 0.5 * self.side();
                let disc = Stroke::ellipse([middle; 2], [0.2 * PERIOD; 2], 0.0);
                (vec![disc], LayerOptions { decay, ..LayerOptions::default() })
            }
            None => self.one_cell(),
        };
        let layer = Layer::new(strokes).with_system(SystemChoice::Of(self.system)).with_options(options);
        Document::new([self.side().round() as u32; 2])
            .with_edges(Edges::Closed)
            .with_seed(self.seed)
            .with_layer(layer)
    }

    /// Side of the patch, px.
    pub(super) fn side(&self) -> f64 {
        match self.kind() {
            None => self.periods.sqrt() * distance(self.drawn.sparse * GAP, GAP),
            Some(PairKind::Weave) => self.periods * PERIOD * self.drawn.unequal.max(1.0),
            Some(_) => self.periods * PERIOD,
        }
    }

    /// The directions that are drawn, degrees.
    pub(super) fn angles(&self) -> Vec<f64> {
        let Drawn { directions, between, angle, .. } = self.drawn;
        match directions {
            2 => vec![angle, angle + between],
            // Two of the three angles are equal.
            3 if self.kind() == Some(PairKind::Weave) => {
                vec![angle, angle + between, angle + 0.5 * (180.0 + between)]
            }
            _ => (0..directions).map(|k| angle + k as f64 * 180.0 / directions as f64).collect(),
        }
    }

    /// The drawn threads of direction number `index`.
    fn threads(&self, index: usize) -> Threads {
        let Drawn { duty, others, unequal, .. } = self.drawn;
        let (duty, period) = match self.kind() {
            Some(PairKind::Weave) if index > 0 => (others, unequal * PERIOD),
            _ => (duty, PERIOD),
        };
        Threads { width: duty * period, period }
    }

    /// Two lines side by side, about the middle; for a maze about a place of their own.
    fn two_lines(&self, index: usize, angle: f64, long: f64) -> [Stroke; 2] {
        let threads = self.threads(index);
        let mut center = [0.5 * self.side(); 2];
        if self.kind() == Some(PairKind::Maze) {
            let turn = std::f64::consts::TAU * index as f64 / self.drawn.directions as f64;
            let away = 0.25 * self.side();
            center = [center[0] + away * libm::cos(turn), center[1] + away * libm::sin(turn)];
        }
        side_by_side(center, angle, threads, long)
    }

    /// One ellipse and the width of the lines.
    fn one_cell(&self) -> (Vec<Stroke>, LayerOptions) {
        let Drawn { sparse, aspect, angle, .. } = self.drawn;
        let major = sparse * GAP / (PI * aspect).sqrt();
        let cell = Stroke::ellipse([0.5 * self.side(); 2], [major, aspect * major], angle);
        let gap = GapChoice::Given(GAP);
        (vec![cell], LayerOptions { keep: Some(false), gap, ..LayerOptions::default() })
    }
}

/// Two lines `long` px long side by side about `center`, in the direction `angle`, degrees.
#[must_use]
pub fn side_by_side(center: [f64; 2], angle: f64, threads: Threads, long: f64) -> [Stroke; 2] {
    let (s, c) = libm::sincos(angle.to_radians());
    [-0.5, 0.5].map(|side| {
        let off = side * threads.period;
        let at = |along: f64| [center[0] + along * c - off * s, center[1] + along * s + off * c];
        Stroke::line(at(-0.5 * long), at(0.5 * long), threads.width)
    })
}
