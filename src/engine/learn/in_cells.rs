//! A type for values in cells, as opposed to values in px.
//!
//! Training rows are measured on simulation grids, in cells; documents are drawn in px. A value in cells is an [`InCells`], so that
//! the compiler refuses one where the other is meant.

use crate::attributes::{Attribute, Attributes};

/// A value whose lengths are cells of a simulation grid. Without this wrapper, lengths are px.
///
/// ```
/// use dapple_engine::attributes::{Attributes, Stripes};
/// use dapple_engine::learn::InCells;
///
/// let wanted = Attributes::Stripes(Stripes { width: 12.0, angle: 30.0, wavelength: None });
/// let InCells(on_grid) = InCells::from_px(wanted, 2.0);
/// assert_eq!(on_grid, Attributes::Stripes(Stripes { width: 6.0, angle: 30.0, wavelength: None }));
/// assert_eq!(InCells(on_grid).in_px(2.0), wanted);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InCells<T>(pub T);

/// Values with lengths.
pub trait Lengths: Sized {
    /// The value with all lengths multiplied by `factor`, and areas by its square.
    #[must_use]
    fn scaled(self, factor: f64) -> Self;
}

impl<T: Lengths> InCells<T> {
    /// The value on a grid of `cell` px a cell.
    #[must_use]
    pub fn from_px(value: T, cell: f64) -> Self {
        Self(value.scaled(1.0 / cell))
    }

    /// The value in px, where a cell is `cell` px.
    #[must_use]
    pub fn in_px(self, cell: f64) -> T {
        self.0.scaled(cell)
    }
}

impl Lengths for Attributes {
    fn scaled(self, factor: f64) -> Self {
        Self::scaled(self, factor)
    }
}

/// A range of an attribute.
impl Lengths for (Attribute, [f64; 2]) {
    fn scaled(self, factor: f64) -> Self {
        let (attribute, range) = self;
        let factor = attribute.unit().scale(factor);
        (attribute, range.map(|end| end * factor))
    }
}

impl<T: Lengths> Lengths for Vec<T> {
    fn scaled(self, factor: f64) -> Self {
        self.into_iter().map(|value| value.scaled(factor)).collect()
    }
}
