//! The parameters that grow each drawn spot with the size, shape and direction that it was drawn with.
//!
//! ```text
//!  drawn ellipse ─▶ the room that its drawn neighbours leave ─▶ attributes of its own ─▶ parameters of its own
//! ```

use crate::attributes::{Attributes, Spots};
use crate::grid::{Bounds, PointBuckets, turned};
use crate::marks::Ellipse;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Ask;
use crate::synth::marks::plan::lattice::Node;
use crate::synth::marks::plan::offset::Offset;

/// A spot as it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnSpot {
    /// Its index among the marks of its layer.
    pub mark: usize,
    /// The drawn ellipse, on the canvas that is grown, px.
    pub ellipse: Ellipse,
    /// The parameters that grow it.
    pub own: Node,
}

/// The largest area ÷ spacing² with which spots are looked up: denser ones merge.
const DENSEST: f64 = 0.3;
/// Distance to the nearest drawn neighbour × this factor is the spacing with which a spot is looked up, if that is less than the
/// spacing of its surroundings: the other neighbours are farther away.
const NEAREST: f64 = 1.2;

/// The surroundings of drawn spots, by which they are looked up.
pub(super) struct Around<'a> {
    /// The canvas with its edges.
    pub bounds: Bounds,
    /// px a cell.
    pub cell: f64,
    /// The spots wanted at a point, px.
    pub wanted: &'a dyn Fn([f64; 2]) -> Spots,
    /// The offset that is subtracted from the questions at a point, px.
    pub offset: &'a dyn Fn([f64; 2]) -> Offset,
}

/// The drawn spots of a layer, by the index of their mark, looked up one by one among the `standing` ones.
pub(super) fn drawn_spots(
    ellipses: &[(usize, Ellipse)],
    standing: &[(usize, Ellipse)],
    around: &Around,
    ask: Ask,
) -> Result<Vec<DrawnSpot>, PlanError> {
    let near = Standing::new(standing, around.bounds);
    let drawn = |(mark, ellipse): &(usize, Ellipse)| {
        let wanted = own_attributes((around.wanted)(ellipse.center), ellipse, near.room(*mark, ellipse));
        let asked = (around.offset)(ellipse.center).applied(-1.0, &Attributes::Spots(wanted));
        let own = Node::from_setting(&ask(&asked, around.cell)?.setting());
        Ok(DrawnSpot { mark: *mark, ellipse: *ellipse, own })
    };
    ellipses.iter().map(drawn).collect()
}

/// The attributes of a drawn spot among spots like `around`: with their density, or with the one that follows from its `room`, px.
fn own_attributes(around: Spots, ellipse: &Ellipse, room: f64) -> Spots {
    let area = ellipse.area();
    let usual = around.spacing.map_or(f64::INFINITY, |spacing| spacing * (area / around.area).sqrt());
    let spacing = usual.min(NEAREST * room).max((area / DENSEST).sqrt());
    Spots {
        area,
        aspect: ellipse.aspect(),
        angle: ellipse.major_angle(),
        spacing: Some(spacing).filter(|spacing| spacing.is_finite()),
    }
}

/// √(r₁r₂), px.
fn radius(ellipse: &Ellipse) -> f64 {
    (ellipse.radii[0] * ellipse.radii[1]).sqrt()
}

/// The spots among which others are looked up, by the index of their mark.
struct Standing<'a> {
    spots: &'a [(usize, Ellipse)],
    centers: PointBuckets,
    /// The largest radius √(r₁r₂), px.
    largest: f64,
}

impl<'a> Standing<'a> {
    fn new(spots: &'a [(usize, Ellipse)], bounds: Bounds) -> Self {
        let centers = PointBuckets::new(bounds, spots.iter().map(|spot| spot.1.center).collect());
        let largest = spots.iter().map(|spot| radius(&spot.1)).fold(0.0, f64::max);
        Self { spots, centers, largest }
    }

    /// The distance of the spot of a `mark` to the nearest other spot, px, converted as if both had this spot's size; infinite
    /// without any.
    ///
    /// It is measured in the metric in which the spot is round: neighbours in the direction of a long spot, in which its tensor
    /// spreads faster, count as nearer.
    fn room(&self, mark: usize, ellipse: &Ellipse) -> f64 {
        let own = radius(ellipse);
        let distance = |index: usize| {
            let other = &self.spots[index].1;
            let way =
                self.centers.bounds().shortest([0, 1].map(|axis| other.center[axis] - ellipse.center[axis]));
            let away = turned(way, -ellipse.angle);
            let [x, y] = [0, 1].map(|axis| away[axis] * own / ellipse.radii[axis]);
            (x * x + y * y).sqrt() * 2.0 * own / (own + radius(other))
        };
        let is_other = |index: usize| self.spots[index].0 != mark;
        let Some(square) = self.centers.nearest(ellipse.center, 1, is_other).pop() else {
            return f64::INFINITY;
        };
        let nearest_within = |reach: f64| {
            let near = self.centers.within(ellipse.center, reach).into_iter().map(|index| index as usize);
            near.filter(|index| is_other(*index)).map(distance).fold(f64::INFINITY, f64::min)
        };
        // This search finds a spot; a spot that is nearer by that measure cannot be farther away than this.
        let found = nearest_within(square.sqrt());
        let longest = ellipse.radii[0].max(ellipse.radii[1]);
        nearest_within(found * longest / own * (own + self.largest) / (2.0 * own))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn neighbours_along_a_long_spot_are_nearer_than_those_beside_it() {
        let bounds = Bounds { size: [400.0, 400.0], edges: Edges::Closed };
        let spot = |x: f64, y: f64| Ellipse { center: [x, y], radii: [20.0, 5.0], angle: 0.0 };
        let to = |other: Ellipse| Standing::new(&[(1, other)], bounds).room(0, &spot(100.0, 100.0));
        assert!((to(spot(150.0, 100.0)) - 25.0).abs() < 1e-9);
        assert!((to(spot(100.0, 150.0)) - 100.0).abs() < 1e-9);
        // A larger one leaves less room.
        let large = Ellipse { radii: [60.0, 15.0], ..spot(150.0, 100.0) };
        assert!((to(large) - 12.5).abs() < 1e-9);
    }

    #[test]
    fn the_nearest_of_many_is_that_of_a_full_search() {
        let spots: Vec<(usize, Ellipse)> = (0..300)
            .map(|i| {
                let at = |step: f64, side: f64| (0.5 + step * f64::from(i)).fract() * side;
                let (long, short) = (3.0 + at(0.37, 20.0), 2.0 + at(0.73, 9.0));
                let center = [at(0.754_877_7, 400.0), at(0.569_840_3, 300.0)];
                (i as usize, Ellipse { center, radii: [long, short], angle: at(0.11, 180.0) })
            })
            .collect();
        for edges in [Edges::Closed, Edges::Wrap] {
            let bounds = Bounds { size: [400.0, 300.0], edges };
            let all = Standing::new(&spots, bounds);
            for (mark, ellipse) in &spots {
                let one_by_one = spots.iter().filter(|(other, _)| other != mark);
                let nearest = one_by_one
                    .map(|other| Standing::new(std::slice::from_ref(other), bounds).room(*mark, ellipse));
                assert_eq!(all.room(*mark, ellipse), nearest.fold(f64::INFINITY, f64::min), "{edges:?}");
            }
        }
    }
}
