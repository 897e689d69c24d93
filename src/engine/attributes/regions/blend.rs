//! Interpolation between two region maps.

use super::RegionGrid;
use super::map::{ROUND, RegionMap};
use crate::attributes::{Attributes, Spots, Stripes};
use crate::marks::axial;

impl RegionMap {
    /// The map on the way from this one (`share` 0) to `other` (1), region by region, on the canvas of this one: area,
    /// spacing, width and wavelength by ratio (a + (b − a)·share of their logarithms), the aspect by difference, the
    /// angle the short way round; where only one of the two has a direction, that one. A spacing is free where one of
    /// the two is. With other columns or rows, the regions are those of the finer. The result has no spread.
    ///
    /// `None` where one has spots and the other stripes.
    #[must_use]
    pub fn blended(&self, other: &Self, share: f64) -> Option<Self> {
        let (here, there) = (*self.layout(), other.layout());
        let layout = RegionGrid { grid: [0, 1].map(|axis| here.grid[axis].max(there.grid[axis])), ..here };
        let other = other.resized(here.size);
        let between = |index: usize| {
            let center = layout.center(layout.place(index));
            blend(&self.at(center), &other.at(center), share)
        };
        let attributes: Option<Vec<Attributes>> = (0..layout.len()).map(between).collect();
        Some(Self::from_attributes(layout, attributes?.into_iter()))
    }
}

fn blend(a: &Attributes, b: &Attributes, share: f64) -> Option<Attributes> {
    let ratio = |a: f64, b: f64| libm::exp((1.0 - share) * libm::log(a) + share * libm::log(b));
    let both = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| ratio(a, b));
    match (a, b) {
        (Attributes::Spots(a), Attributes::Spots(b)) => Some(Attributes::Spots(Spots {
            area: ratio(a.area, b.area),
            aspect: (1.0 - share) * a.aspect + share * b.aspect,
            angle: match [a.aspect > ROUND, b.aspect > ROUND] {
                [false, true] => a.angle,
                [true, false] => b.angle,
                _ => turned(a.angle, b.angle, share),
            },
            spacing: both(a.spacing, b.spacing),
        })),
        (Attributes::Stripes(a), Attributes::Stripes(b)) => Some(Attributes::Stripes(Stripes {
            width: ratio(a.width, b.width),
            angle: turned(a.angle, b.angle, share),
            wavelength: both(a.wavelength, b.wavelength),
        })),
        _ => None,
    }
}

/// From one axial angle to another, degrees, by at most 90.
fn turned(from: f64, to: f64, share: f64) -> f64 {
    let way = axial(to - from);
    let way = if way > 90.0 { way - 180.0 } else { way };
    axial(from + share * way)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::{Ellipse, Line, Mark};

    fn spots(radii: [f64; 2], angle: f64, regions: [usize; 2]) -> RegionMap {
        let marks = [Mark::Ellipse(Ellipse { center: [20.0, 20.0], radii, angle })];
        let mut map = RegionMap::from_marks(&marks, [100.0, 80.0], regions, Edges::Closed).expect("a spot");
        map.fill_free_spacing(|spots| 3.0 * spots.area.sqrt());
        map
    }

    fn at(map: &RegionMap) -> Spots {
        match map.at([30.0, 30.0]) {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(_) => panic!("spots were drawn"),
        }
    }

    #[test]
    fn half_way_lengths_are_the_geometric_mean_and_the_angle_goes_the_short_way() {
        let (a, b) = (spots([4.0, 2.0], 170.0, [1, 1]), spots([16.0, 8.0], 20.0, [1, 1]));
        let half = at(&a.blended(&b, 0.5).expect("both are spots"));
        let area = core::f64::consts::PI * 32.0;
        assert!((half.area / area - 1.0).abs() < 1e-12, "{half:?}");
        assert!((half.spacing.expect("filled") / (3.0 * area.sqrt()) - 1.0).abs() < 1e-12);
        assert!((half.angle - 5.0).abs() < 1e-9 && (half.aspect - 0.5).abs() < 1e-12, "{half:?}");
    }

    #[test]
    fn the_ends_are_the_maps_themselves_though_one_has_more_regions() {
        let (a, b) = (spots([4.0, 2.0], 10.0, [1, 1]), spots([9.0, 3.0], 80.0, [3, 2]));
        for (share, end) in [(0.0, &a), (1.0, &b)] {
            let (blended, end) = (at(&a.blended(&b, share).expect("both are spots")), at(end));
            assert!((blended.area - end.area).abs() < 1e-9 && (blended.angle - end.angle).abs() < 1e-9);
        }
        assert_eq!(a.blended(&b, 0.5).expect("both are spots").layout().grid, [3, 2]);
    }

    #[test]
    fn round_spots_take_the_direction_of_the_others() {
        let (round, long) = (spots([4.0, 4.0], 0.0, [1, 1]), spots([8.0, 4.0], 60.0, [1, 1]));
        assert!((at(&round.blended(&long, 0.1).expect("both are spots")).angle - 60.0).abs() < 1e-9);
        assert!((at(&long.blended(&round, 0.9).expect("both are spots")).angle - 60.0).abs() < 1e-9);
    }

    #[test]
    fn spots_and_stripes_cannot_be_blended() {
        let line = Mark::Line(Line { from: [5.0, 5.0], to: [50.0, 5.0], width: 6.0 });
        let stripes = RegionMap::from_marks(&[line], [100.0, 80.0], [1, 1], Edges::Closed).expect("a line");
        assert!(stripes.blended(&spots([4.0, 2.0], 0.0, [1, 1]), 0.5).is_none());
    }
}
