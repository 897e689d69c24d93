//! The sketch of one region, and how it is changed toward what can be reached.

use super::spaced::{reach_of, spaced};
use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Spots, Stripes};
use crate::document::{Document, DutyChoice, limits};
use crate::editor::shape;
use crate::learn::Answer;
use crate::marks::{Ellipse, Line, Mark, Path, turn};
use crate::synth::drawn::sketch_targets;

/// How far a change goes beyond the most similar attributes that can be reached.
#[derive(Clone, Copy, Debug)]
pub(super) struct Farther {
    /// Factor on the change.
    pub(super) change: f64,
    /// Factor on the distances, where these must grow.
    pub(super) apart: f64,
}

/// The marks of one region and the duty of its layer.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sketch {
    /// Indices of strokes in the layer, and their marks.
    pub(super) marks: Vec<(usize, Mark)>,
    /// The duty of the layer.
    pub(super) duty: DutyChoice,
}

impl Sketch {
    /// The sketch of region `place` of a layer; `None` where its strokes cannot be read.
    pub(super) fn of_region(
        document: &Document,
        layer: usize,
        layout: &RegionGrid,
        place: [usize; 2],
    ) -> Option<Self> {
        let marks = sketch_targets::marks(document, layer, "").ok()?;
        let inside = |(_, mark): &(usize, Mark)| layout.region_of(mark.center()) == place;
        let duty = document.layers[layer].options.duty;
        Some(Self { marks: marks.into_iter().enumerate().filter(inside).collect(), duty })
    }

    /// Writes the sketch into the document.
    pub(super) fn write(self, document: &mut Document, layer: usize) {
        let layer = &mut document.layers[layer];
        layer.options.duty = self.duty;
        for (stroke, mark) in self.marks {
            layer.strokes[stroke] = layer.strokes[stroke].changed(mark);
        }
    }

    /// The sketch, changed from the attributes `asked` toward the nearest attributes in `answer`, and beyond them by
    /// `farther`.
    pub(super) fn toward(
        self,
        asked: &Attributes,
        answer: &Answer,
        farther: Farther,
        layout: &RegionGrid,
        place: [usize; 2],
    ) -> Option<Self> {
        match (asked, &answer.nearest) {
            (Attributes::Spots(asked), Attributes::Spots(to)) => {
                Some(self.spots_toward(asked, to, farther, layout, place))
            }
            (Attributes::Stripes(asked), Attributes::Stripes(to)) => {
                Some(self.lines_toward(asked, to, farther.change))
            }
            _ => None,
        }
    }

    fn spots_toward(
        self,
        asked: &Spots,
        to: &Spots,
        Farther { change: farther, apart: more }: Farther,
        layout: &RegionGrid,
        place: [usize; 2],
    ) -> Self {
        let by = |from: f64, to: f64| libm::pow(to / from, farther);
        let mut area = by(asked.area, to.area);
        let apart = asked.spacing.zip(to.spacing).map_or(1.0, |(from, to)| to / from);
        let apart = if apart > 1.0 { apart * more } else { apart };
        let centers: Vec<[f64; 2]> = self.marks.iter().map(|(_, mark)| mark.center()).collect();
        let reaches: Vec<[f64; 2]> = self.marks.iter().map(|(_, mark)| reach_of(mark, area.sqrt())).collect();
        let moved = spaced(&centers, &reaches, apart, layout, place).unwrap_or_else(|| {
            // Where there is no room to move them apart, smaller marks give the same density.
            area /= apart * apart;
            centers.clone()
        });
        let by_angle = farther * turn(to.angle, asked.angle);
        let aspect = |own: f64| {
            if to.aspect <= asked.aspect {
                own * by(asked.aspect, to.aspect)
            } else {
                1.0 - (1.0 - own) * by(1.0 - asked.aspect, (1.0 - to.aspect).max(0.0))
            }
        };
        let changed = |((stroke, mark), center): ((usize, Mark), [f64; 2])| match mark {
            Mark::Ellipse(e) => {
                let angle = e.major_angle() + by_angle;
                (
                    stroke,
                    Mark::Ellipse(Ellipse::from_area(
                        center,
                        e.area() * area,
                        aspect(e.aspect()).min(1.0),
                        angle,
                    )),
                )
            }
            Mark::Line(_) | Mark::Path(_) => (stroke, mark),
        };
        Self { marks: self.marks.into_iter().zip(moved).map(changed).collect(), ..self }
    }

    fn lines_toward(self, asked: &Stripes, to: &Stripes, farther: f64) -> Self {
        let width = libm::pow(to.width / asked.width, farther);
        let by_angle = farther * turn(to.angle, asked.angle);
        let duty = match to.wavelength {
            Some(_) if (to.duty() / asked.duty() - 1.0).abs() > 1e-6 => {
                let [low, high] = [limits::DUTY.low, limits::DUTY.high];
                let own = self.duty.given().unwrap_or(asked.duty());
                DutyChoice::Given((own * libm::pow(to.duty() / asked.duty(), farther)).clamp(low, high))
            }
            _ => self.duty,
        };
        let changed = |(stroke, mark)| match mark {
            Mark::Line(line) => {
                let line = Line { width: line.width * width, ..line };
                (stroke, shape::turned(&Mark::Line(line), by_angle, line.center()))
            }
            Mark::Path(path) => {
                let (center, path) = (path.center(), Path { width: path.width * width, ..path });
                (stroke, shape::turned(&Mark::Path(path), by_angle, center))
            }
            Mark::Ellipse(_) => (stroke, mark),
        };
        Self { marks: self.marks.into_iter().map(changed).collect(), duty }
    }
}
