//! Free marks: what marks want around them, without regions.

mod ellipses;
mod far;
mod kernel;
mod nodes;
mod notes;
mod plane;
mod plane_sums;
mod regression;
mod strokes;

use super::periods::PeriodRules;
use super::regions::{RegionGrid, RegionsError};
use super::{Attributes, Spots, Spread};
use crate::grid::{Bounds, Edges};
use crate::marks::{Ellipse, Mark, Path};
use ellipses::EllipseMap;
use strokes::StrokeMap;

pub use far::Far;
pub use notes::Note;

/// What is wanted where the marks alone do not say it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRules {
    /// Which periods strokes can want.
    pub periods: PeriodRules,
    /// The spacing that was wanted far from all ellipses before they were changed, px. It stays while what is drawn agrees with it.
    pub far_spacing: Option<f64>,
}

impl Default for FreeRules {
    fn default() -> Self {
        Self { periods: PeriodRules::STRIPES, far_spacing: None }
    }
}

/// The spacing that ellipses at `centers` want far from all of them, px, where they want one there; `None` of fewer than two. `before`:
/// the one that was wanted before they were changed, see [`FreeRules`].
#[must_use]
pub fn far_spacing(centers: &[[f64; 2]], size: [f64; 2], edges: Edges, before: Option<f64>) -> Option<f64> {
    ellipses::far_spacing(centers, Bounds { size, edges }, before)
}

/// Attributes at any point of the canvas, as the marks drawn around it want them.
///
/// Ellipses: size, aspect and spacing are regressed between the marks, directions as double angles. Lines and paths: direction and
/// width agree with each stroke along it and blend between the strokes, the period is the distance of strokes side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMap(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Ellipses(EllipseMap),
    Strokes(StrokeMap),
}

impl FreeMap {
    /// The map of `marks` on a canvas of `size` px.
    ///
    /// # Errors
    /// Without marks, with ellipses and lines mixed, and for a canvas without extent.
    pub fn from_marks(marks: &[Mark], size: [f64; 2], edges: Edges) -> Result<Self, RegionsError> {
        Self::with_rules(marks, size, edges, FreeRules::default())
    }

    /// The map of `marks` on a canvas of `size` px, by these `rules` for periods.
    ///
    /// # Errors
    /// Those of [`Self::from_marks`].
    pub fn with_rules(
        marks: &[Mark],
        size: [f64; 2],
        edges: Edges,
        rules: FreeRules,
    ) -> Result<Self, RegionsError> {
        let canvas = RegionGrid { size, grid: [1, 1], edges };
        if !size.iter().all(|side| side.is_normal() && *side > 0.0) {
            return Err(RegionsError::Layout { size, grid: canvas.grid });
        }
        let ellipses: Vec<Ellipse> = marks.iter().filter_map(Mark::ellipse).collect();
        let lines: Vec<Path> = marks.iter().filter_map(Mark::path).collect();
        if !ellipses.is_empty() && !lines.is_empty() {
            return Err(RegionsError::Mixed { ellipses: ellipses.len(), lines: lines.len() });
        }
        let spots = EllipseMap::new(&ellipses, &canvas, rules.far_spacing).map(Kind::Ellipses);
        let stripes = || StrokeMap::new(&lines, &canvas, rules.periods).map(Kind::Strokes);
        spots.or_else(stripes).map(Self).ok_or(RegionsError::NoMarks)
    }

    /// The attributes wanted at a point, px.
    ///
    /// Never outside the range of the drawn values. The spacing of a single ellipse is free (`None`); stripes have
    /// a wavelength.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Attributes {
        match &self.0 {
            Kind::Ellipses(map) => Attributes::Spots(map.at(point)),
            Kind::Strokes(map) => Attributes::Stripes(map.at(point)),
        }
    }

    /// How far the marks around a point (px) agree on a direction, 0..1: the squared length of the mean double-angle vector,
    /// as the coherence of structure tensors by Jähne ("Digital Image Processing", 2005).
    #[must_use]
    pub fn coherence_at(&self, point: [f64; 2]) -> f64 {
        let [c, s] = self.direction_at(point);
        c * c + s * s
    }

    /// (cos 2θ, sin 2θ) of the angle θ that [`Self::at`] has there, found without a transcendental function.
    #[must_use]
    pub fn double_angle_at(&self, point: [f64; 2]) -> [f64; 2] {
        let [c, s] = self.direction_at(point);
        let length = (c * c + s * s).sqrt();
        if length > 0.0 { [c / length, s / length] } else { [1.0, 0.0] }
    }

    fn direction_at(&self, point: [f64; 2]) -> [f64; 2] {
        match &self.0 {
            Kind::Ellipses(map) => map.direction_at(point),
            Kind::Strokes(map) => map.direction_at(point),
        }
    }

    /// A mark's own size, aspect and direction, with the spacing or period wanted at it. `mark` is its index among the
    /// marks that the map was made from.
    ///
    /// # Panics
    /// Without such a mark.
    #[must_use]
    pub fn own(&self, mark: usize) -> Attributes {
        match &self.0 {
            Kind::Ellipses(map) => Attributes::Spots(map.own(mark)),
            Kind::Strokes(map) => Attributes::Stripes(map.own(mark)),
        }
    }

    /// Mean attributes of all marks.
    #[must_use]
    pub fn mean(&self) -> Attributes {
        match &self.0 {
            Kind::Ellipses(map) => Attributes::Spots(map.mean),
            Kind::Strokes(map) => Attributes::Stripes(map.mean),
        }
    }

    /// What ellipses want far from all of them; `None` of lines, where all places are near some ellipse, and where what is wanted
    /// changes far from them too.
    #[must_use]
    pub fn far(&self) -> Option<&Far> {
        if let Kind::Ellipses(map) = &self.0 { map.far.as_ref() } else { None }
    }

    /// How much the marks depart from the map; [`Spread::ZERO`] under six ellipses.
    #[must_use]
    pub fn spread(&self) -> Spread {
        match &self.0 {
            Kind::Ellipses(map) => map.spread,
            Kind::Strokes(_) => Spread::ZERO,
        }
    }

    /// What of lines and paths cannot be as it was drawn, and where: crossings, strokes from which the directions depart,
    /// periods out of reach. None of ellipses.
    #[must_use]
    pub fn notes(&self) -> &[Note] {
        match &self.0 {
            Kind::Ellipses(_) => &[],
            Kind::Strokes(map) => &map.notes,
        }
    }

    /// [`Self::notes`] other than crossings as sentences without a full stop: the first few, and how many more there are.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        notes::sentences(self.notes())
    }

    /// The [`Self::remarks`] that name periods out of reach.
    #[must_use]
    pub fn remarks_on_periods(&self) -> Vec<String> {
        let periods = self.notes().iter().filter(|note| matches!(note, Note::Period { .. }));
        notes::sentences(&periods.copied().collect::<Vec<_>>())
    }

    /// Nodes over the canvas at which parameters can be looked up and between which they can be interpolated.
    ///
    /// Sizes, aspects, spacings and periods vary little from node to node; directions may turn faster: read them by
    /// [`Self::double_angle_at`]. One node where nothing varies.
    #[must_use]
    pub fn nodes(&self) -> RegionGrid {
        match &self.0 {
            Kind::Ellipses(map) => map.nodes(),
            Kind::Strokes(map) => map.nodes(),
        }
    }

    /// This map stretched over another canvas of `size` px: places move with it, sizes and spacings stay.
    #[must_use]
    pub fn resized(&self, size: [f64; 2]) -> Self {
        Self(match &self.0 {
            Kind::Ellipses(map) => Kind::Ellipses(map.resized(size)),
            Kind::Strokes(map) => Kind::Strokes(map.resized(size)),
        })
    }

    /// Gives a free spacing the one (px) that `spacing` returns for the spots.
    pub fn fill_free_spacing(&mut self, spacing: impl FnMut(&Spots) -> f64) {
        if let Kind::Ellipses(map) = &mut self.0 {
            map.fill_free_spacing(spacing);
        }
    }

    /// Widens the spacing of spots where area ÷ spacing² is more than this. Returns whether it was anywhere.
    pub fn limit_density(&mut self, most: f64) -> bool {
        match &mut self.0 {
            Kind::Ellipses(map) => map.limit_density(most),
            Kind::Strokes(_) => false,
        }
    }

    /// This map with one spacing of spots everywhere, px; `None` = unchanged.
    #[must_use]
    pub fn with_spacing(mut self, spacing: Option<f64>) -> Self {
        if let (Kind::Ellipses(map), Some(spacing)) = (&mut self.0, spacing) {
            map.set_spacing(spacing);
        }
        self
    }

    /// This map with stripes of one duty cycle: width ÷ wavelength, 0..1.
    #[must_use]
    pub fn with_duty(mut self, duty: f64) -> Self {
        if let Kind::Strokes(map) = &mut self.0 {
            map.set_duty(duty);
        }
        self
    }
}

#[cfg(test)]
mod tests;
