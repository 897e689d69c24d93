//! Marks, drawn or measured: ellipses, lines and paths, fitted to points.

mod cut;
mod ellipse;
pub mod fit;
mod line;
mod moments;
mod outline;
mod overlap;
mod path;

pub use ellipse::Ellipse;
pub use line::Line;
pub use moments::Moments;
pub use outline::{ellipse_of_outline, largest_loop};
pub use overlap::polygon_is_on;
pub use path::{Path, PathSample, distance_to_segment};

use crate::grid::{Bounds, Edges};

/// An ellipse, a line or a path, drawn or measured.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A spot.
    Ellipse(Ellipse),
    /// A straight piece of a stripe.
    Line(Line),
    /// A piece of a stripe that may bend.
    Path(Path),
}

impl Mark {
    /// The centre of the ellipse, or the point halfway along the line or path, px.
    #[must_use]
    pub fn center(&self) -> [f64; 2] {
        match self {
            Self::Ellipse(ellipse) => ellipse.center,
            Self::Line(line) => line.center(),
            Self::Path(path) => path.center(),
        }
    }

    /// The ellipse; `None` of lines and paths.
    #[must_use]
    pub fn ellipse(&self) -> Option<Ellipse> {
        if let Self::Ellipse(ellipse) = self { Some(*ellipse) } else { None }
    }

    /// The path, of a line that of its two ends; `None` of an ellipse.
    #[must_use]
    pub fn path(&self) -> Option<Path> {
        match self {
            Self::Ellipse(_) => None,
            Self::Line(line) => Some(Path::from(*line)),
            Self::Path(path) => Some(path.clone()),
        }
    }

    /// The image of it whose centre is on the tile, where `canvas` is one and the centre beyond it; else the mark itself.
    #[must_use]
    pub fn on_tile(self, canvas: &Bounds) -> Self {
        let center = self.center();
        let is_on = |axis: usize| (0.0..=canvas.size[axis]).contains(&center[axis]);
        if canvas.edges == Edges::Closed || (0..2).all(is_on) {
            return self;
        }
        let tiles = |axis: usize| if is_on(axis) { 0.0 } else { (center[axis] / canvas.size[axis]).floor() };
        self.shifted([0, 1].map(|axis| -tiles(axis) * canvas.size[axis]))
    }

    /// The mark moved `by` px along x and y.
    #[must_use]
    pub fn shifted(&self, by: [f64; 2]) -> Self {
        let shift = |point: [f64; 2]| [point[0] + by[0], point[1] + by[1]];
        match self {
            Self::Ellipse(ellipse) => Self::Ellipse(Ellipse { center: shift(ellipse.center), ..*ellipse }),
            Self::Line(line) => Self::Line(Line { from: shift(line.from), to: shift(line.to), ..*line }),
            Self::Path(path) => Self::Path(path.shifted(by)),
        }
    }
}

/// Any finite angle, degrees, as an axial one: reduced to [0, 180).
///
/// ```
/// use dapple_engine::marks::axial;
///
/// assert_eq!([190.0, -30.0, 180.0].map(axial), [10.0, 150.0, 0.0]);
/// ```
#[must_use]
pub fn axial(degrees: f64) -> f64 {
    let angle = degrees.rem_euclid(180.0);
    if angle >= 180.0 { 0.0 } else { angle }
}

/// The difference of two axial angles, `a` − `b`, degrees in −90..90.
///
/// ```
/// use dapple_engine::marks::turn;
///
/// assert_eq!(turn(10.0, 170.0), 20.0);
/// ```
#[must_use]
pub fn turn(a: f64, b: f64) -> f64 {
    axial(a - b + 90.0) - 90.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_a_tile_a_mark_comes_back_by_whole_tiles() {
        let line = Mark::Line(Line { from: [-70.0, 10.0], to: [-50.0, 64.0], width: 4.0 });
        let tile = Bounds { size: [50.0, 30.0], edges: Edges::Wrap };
        let back = Mark::Line(Line { from: [30.0, -20.0], to: [50.0, 34.0], width: 4.0 });
        assert_eq!(line.clone().on_tile(&tile), back);
        assert_eq!(back.clone().on_tile(&tile), back);
        assert_eq!(line.clone().on_tile(&Bounds { edges: Edges::Closed, ..tile }), line);
    }

    #[test]
    fn angles_are_axial() {
        assert_eq!(axial(-10.0), 170.0);
        assert_eq!(axial(540.0), 0.0);
        assert_eq!(axial(-1e-18), 0.0);
        assert_eq!(turn(175.0, 5.0), -10.0);
        assert_eq!(turn(5.0, 175.0), 10.0);
    }
}
