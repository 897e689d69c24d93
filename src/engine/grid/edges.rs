//! What lies beyond the border, and the rectangle that has one.

use serde::{Deserialize, Serialize};

/// What lies beyond the border of the canvas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Edges {
    /// Nothing flows across the border (Neumann). Values read beyond it are mirrored.
    #[default]
    Closed,
    /// The right border meets the left one and the lower one the upper: a seamless tile.
    Wrap,
}

impl Edges {
    /// The index in `0..n` that stands for index `i`, which may lie outside, on a row of `n` values.
    ///
    /// `Closed` mirrors about the border itself (−1 → 0, −2 → 1), `Wrap` goes round.
    #[inline]
    #[must_use]
    pub fn index(self, i: isize, n: usize) -> usize {
        // Most are inside, and need no division.
        if (0..n as isize).contains(&i) {
            return i as usize;
        }
        let n = n as isize;
        let i = match self {
            Self::Wrap => i.rem_euclid(n),
            Self::Closed => {
                let folded = i.rem_euclid(2 * n);
                folded.min(2 * n - 1 - folded)
            }
        };
        i as usize
    }
}

/// A rectangle from (0, 0) to `size`, with what lies beyond its border. Lengths are in any one unit: px or cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Width and height, both positive.
    pub size: [f64; 2],
    /// What lies beyond the border.
    pub edges: Edges,
}

impl Bounds {
    /// `displacement`, from one point to another, by the shortest of the routes across the border where there are such.
    ///
    /// ```
    /// use dapple_engine::grid::{Bounds, Edges};
    ///
    /// let tile = Bounds { size: [100.0, 60.0], edges: Edges::Wrap };
    /// assert_eq!(tile.shortest([90.0, 10.0]), [-10.0, 10.0]);
    /// ```
    #[must_use]
    pub fn shortest(&self, displacement: [f64; 2]) -> [f64; 2] {
        match self.edges {
            Edges::Closed => displacement,
            Edges::Wrap => [0, 1].map(|axis| {
                let (displacement, side) = (displacement[axis], self.size[axis]);
                displacement - side * (displacement / side).round()
            }),
        }
    }

    /// Whether a point lies on the rectangle or its border; on a tile every point does, by one of its images.
    #[must_use]
    pub fn contains(&self, point: [f64; 2]) -> bool {
        self.edges == Edges::Wrap || (0..2).all(|axis| (0.0..=self.size[axis]).contains(&point[axis]))
    }

    /// The point inside or on the border that stands for `point`: the nearest one, on a tile the image of the point itself.
    ///
    /// ```
    /// use dapple_engine::grid::{Bounds, Edges};
    ///
    /// let tile = Bounds { size: [100.0, 60.0], edges: Edges::Wrap };
    /// assert_eq!(tile.inside([-5.0, 70.0]), [95.0, 10.0]);
    /// let canvas = Bounds { edges: Edges::Closed, ..tile };
    /// assert!(canvas.contains(canvas.inside([-5.0, 70.0])));
    /// ```
    #[must_use]
    pub fn inside(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| match self.edges {
            Edges::Wrap => point[axis].rem_euclid(self.size[axis]),
            Edges::Closed => point[axis].clamp(0.0, self.size[axis]),
        })
    }

    /// The point inside that stands for `point`: mirrored at closed edges, carried round on a tile.
    #[must_use]
    pub fn folded(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let side = self.size[axis];
            let at = match self.edges {
                Edges::Wrap => point[axis].rem_euclid(side),
                Edges::Closed => {
                    let at = point[axis].rem_euclid(2.0 * side);
                    if at > side { 2.0 * side - at } else { at }
                }
            };
            // Below the far side itself, so that the point lies in a cell.
            at.clamp(0.0, side * (1.0 - 1e-12))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_edges_mirror_and_wrapped_edges_go_round() {
        let seen = |edges: Edges| (-3..6).map(|i| edges.index(i, 3)).collect::<Vec<_>>();
        assert_eq!(seen(Edges::Closed), [2, 1, 0, 0, 1, 2, 2, 1, 0]);
        assert_eq!(seen(Edges::Wrap), [0, 1, 2, 0, 1, 2, 0, 1, 2]);
        let folded = |edges| Bounds { size: [3.0, 2.0], edges }.folded([-0.5, 2.5]);
        let inside = |edges| Bounds { size: [3.0, 2.0], edges }.inside([-0.5, 2.5]);
        assert_eq!((inside(Edges::Closed), inside(Edges::Wrap)), ([0.0, 2.0], [2.5, 0.5]));
        assert_eq!(folded(Edges::Closed), [0.5, 1.5]);
        assert_eq!(folded(Edges::Wrap), [2.5, 0.5]);
    }

    #[test]
    fn the_shortest_way_leads_across_the_border_of_a_tile() {
        let bounds = Bounds { size: [10.0, 6.0], edges: Edges::Wrap };
        assert_eq!(bounds.shortest([8.0, -5.0]), [-2.0, 1.0]);
        let closed = Bounds { edges: Edges::Closed, ..bounds };
        assert_eq!(closed.shortest([8.0, -5.0]), [8.0, -5.0]);
        assert!(
            bounds.contains([-3.0, 1.0]) && !closed.contains([-3.0, 1.0]) && closed.contains([10.0, 0.0])
        );
    }
}
