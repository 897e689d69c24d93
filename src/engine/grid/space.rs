//! Where points of a pattern are laid: a domain, a margin beyond its border, and buckets of points.

use std::ops::Range;

use rand::Rng;

/// A domain with a margin beyond its border, so that a pattern can be laid as if it went on there. Its places have
/// coordinates of their own.
pub trait Space: Sync {
    /// A point of the space, as of the domain.
    type Place: Copy + Send + Sync + PartialEq;
    /// A part of the border of the domain.
    type Wall: Wall<Self::Place>;

    /// The place of the space at a place of the domain or of the margin.
    fn to_space(&self, place: Self::Place) -> Self::Place;

    /// The reverse of [`Self::to_space`].
    fn to_domain(&self, place: Self::Place) -> Self::Place;

    /// Whether a place, given as by [`Self::to_domain`], lies in the domain, not in the margin.
    fn is_inside(&self, place: Self::Place) -> bool;

    /// Whether a place, given as by [`Self::to_domain`], lies in the domain or the margin.
    fn covers(&self, place: Self::Place) -> bool;

    /// The place at the end of a displacement, in the frame of its start.
    fn moved(&self, from: Self::Place, displacement: [f64; 2]) -> Self::Place;

    /// How many points a density has, in points a mean cell of the domain, that is the same everywhere.
    fn points(&self, density: f64) -> f64;

    /// The integral of a density, by cell of the domain; the margin has the density of the border beside it.
    fn integral(&self, density: impl Fn(usize) -> f64) -> f64;

    /// A uniformly random place.
    fn random(&self, rng: &mut impl Rng) -> Self::Place;

    /// Number of cells, those of the margin too.
    fn cells(&self) -> usize;

    /// The place in `cell` that is nearest to `at`, see [`super::Domain::place_in`].
    fn place_in(&self, cell: usize, at: [f64; 2]) -> Self::Place;

    /// The walls of the domain.
    fn walls(&self) -> Vec<Self::Wall>;

    /// Buckets for places of the space, about `side` wide.
    fn buckets(&self, side: f64) -> impl Buckets<Place = Self::Place>;
}

/// A part of a closed border, in a space whose points are `P`.
pub trait Wall<P>: Sync {
    /// How far inside the wall a place is; negative beyond it.
    fn depth(&self, place: P) -> f64;

    /// The unit vector inwards, in the frame of the place.
    fn inward(&self, place: P) -> [f64; 2];

    /// The place that is nearest to `place` among those so far inside the wall.
    fn at_depth(&self, place: P, depth: f64) -> P;

    /// Whether the domain lies between this wall and the other.
    fn faces(&self, other: &Self) -> bool;
}

/// Buckets that sort places so that neighbours are found without asking all.
pub trait Buckets: Clone + Sync {
    /// What is sorted.
    type Place: Copy;

    /// Number of buckets.
    fn count(&self) -> usize;

    /// The bucket of a place.
    fn bucket(&self, place: Self::Place) -> usize;

    /// Runs of buckets with all places that lie within `reach` of a place. For every place in one of them the function beside
    /// it gives the displacement there, in the frame of the first place; `None` where that is the same place, or a farther one.
    fn near(
        &self,
        place: Self::Place,
        reach: f64,
    ) -> impl Iterator<Item = (Range<usize>, impl Fn(Self::Place) -> Option<[f64; 2]>)>;

    /// Whether a displacement between two places leads to the mirror image of the second, beyond a border.
    fn is_to_image(&self, from: Self::Place, to: Self::Place, displacement: [f64; 2]) -> bool;

    /// Degrees by which the frame of cell `to` is rotated against that of `from`, see [`super::Domain::transport_angle`].
    fn transport_angle(&self, from: usize, to: usize) -> f64;
}
