//! Shapes that cover the canvas: what marks lie on.

use usvg::FillRule;

use super::strokes::Drawn;
use super::visibility::inside;

/// The least share of an area that a shape which covers it fills: grounds are drawn a little smaller than the page, too.
const COVERS: f64 = 0.95;
/// Points along each side of the area that are tested.
const POINTS: usize = 40;

/// An area: a corner, and its two sides as vectors.
#[derive(Clone, Copy)]
pub(super) struct Area {
    pub(super) corner: [f64; 2],
    pub(super) sides: [[f64; 2]; 2],
}

impl Area {
    /// A canvas of `size` px.
    pub(super) fn canvas(size: [f64; 2]) -> Self {
        Self { corner: [0.0; 2], sides: [[size[0], 0.0], [0.0, size[1]]] }
    }

    /// The place at these shares of its sides.
    fn place(&self, [s, t]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.corner[axis] + s * self.sides[0][axis] + t * self.sides[1][axis])
    }

    /// Whether what is drawn covers it, where it `shows`.
    pub(super) fn is_covered(
        &self,
        drawn: &[&Drawn],
        rule: FillRule,
        shows: impl Fn([f64; 2]) -> bool,
    ) -> bool {
        // Most shapes are far smaller: they do not reach to three corners.
        let near = |share: f64| if share < 0.5 { 0.06 } else { 0.94 };
        let outlines: Vec<&[[f64; 2]]> = drawn.iter().map(|drawn| &drawn.points[..]).collect();
        let covers = |place: [f64; 2]| inside(&outlines, rule, place) && shows(place);
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        if corners.iter().filter(|corner| covers(self.place(corner.map(near)))).count() < 3 {
            return false;
        }
        let share = |k: usize| (k as f64 + 0.5) / POINTS as f64;
        let places = (0..POINTS * POINTS).map(|k| self.place([share(k % POINTS), share(k / POINTS)]));
        places.filter(|place| covers(*place)).count() as f64 >= COVERS * (POINTS * POINTS) as f64
    }
}
