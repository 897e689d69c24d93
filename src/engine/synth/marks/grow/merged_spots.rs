//! Spots that have merged.

use crate::attributes::regions::RegionGrid;
use crate::grid::PointBuckets;
use crate::measure::{MERGED_FILL, Spot};
use crate::synth::marks::plan::pinned_marks::displacement;
use crate::synth::passes::MergedSpots;

/// A place belongs to the nearest grown spot if it is within this multiple of its radii from the centre: spots of a dense pattern move
/// by up to a radius.
const REACH: f64 = 1.5;

/// Compares the `grown` spots with the `places`, px, at which they began. The first `pinned` spots are never surplus.
#[must_use]
pub fn merged_spots(places: &[[f64; 2]], pinned: usize, grown: &[Spot], layout: &RegionGrid) -> MergedSpots {
    let mut begun = vec![Vec::new(); grown.len()];
    let merged = |spot: &&Spot| spot.fill < MERGED_FILL;
    if !grown.iter().any(|spot| merged(&spot)) {
        return MergedSpots::default();
    }
    let centers = grown.iter().map(|spot| spot.ellipse.center).collect();
    let centers = PointBuckets::new(layout.bounds(), centers);
    let longest = grown.iter().map(|spot| spot.ellipse.radii[0]).fold(0.0, f64::max);
    for (index, place) in places.iter().enumerate() {
        let near = centers.within(*place, REACH * longest).into_iter().map(|spot| spot as usize);
        let near = near.map(|spot| (spot, radii_away(*place, &grown[spot], layout)));
        let near: Vec<(usize, f64)> = near.filter(|(_, radii)| *radii < REACH).collect();
        // Places far from spots that may have merged belong to other spots.
        if near.iter().any(|(spot, _)| merged(&&grown[*spot]))
            && let Some((spot, _)) = near.iter().min_by(|a, b| a.1.total_cmp(&b.1))
        {
            begun[*spot].push(index);
        }
    }
    let mut found = MergedSpots::default();
    for (spot, begun) in grown.iter().zip(&begun) {
        if merged(&spot) && begun.len() > 1 {
            let keep = begun.iter().filter(|index| **index < pinned).count().max(1);
            found.kept.extend(&begun[..keep]);
            found.crowded.extend(&begun[1..keep]);
            found.surplus.extend(&begun[keep..]);
        }
    }
    found
}

/// Distance of a place, px, from the centre of a spot, in radii: 1 on the outline of its ellipse.
fn radii_away(place: [f64; 2], spot: &Spot, layout: &RegionGrid) -> f64 {
    let away = displacement(place, spot.ellipse.center, layout);
    let [along, across] = crate::grid::turned(away, -spot.ellipse.angle);
    let [a, b] = spot.ellipse.radii;
    ((along / a) * (along / a) + (across / b) * (across / b)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::Ellipse;

    fn spot(x: f64, radii: [f64; 2], fill: f64) -> Spot {
        let ellipse = Ellipse { center: [x, 50.0], radii, angle: 0.0 };
        Spot { ellipse, whole: true, endless: false, contour: 0.0, fill, peak: 1.0 }
    }

    fn found(places: &[f64], pinned: usize, grown: &[Spot]) -> MergedSpots {
        let layout = RegionGrid { size: [200.0, 100.0], grid: [1, 1], edges: Edges::Closed };
        let places: Vec<[f64; 2]> = places.iter().map(|x| [*x, 50.0]).collect();
        merged_spots(&places, pinned, grown, &layout)
    }

    #[test]
    fn of_two_merged_spots_the_first_is_kept() {
        let grown = [spot(40.0, [20.0, 8.0], 0.85), spot(90.0, [10.0, 9.0], 0.99)];
        assert_eq!(
            found(&[30.0, 50.0, 91.0], 0, &grown),
            MergedSpots { surplus: vec![1], kept: vec![0], crowded: vec![] }
        );
    }

    #[test]
    fn pinned_spots_are_never_surplus() {
        let grown = [spot(40.0, [30.0, 8.0], 0.85)];
        let three = [20.0, 40.0, 60.0];
        let two = MergedSpots { surplus: vec![2], kept: vec![0, 1], crowded: vec![1] };
        assert_eq!(found(&three, 2, &grown), two);
        let all = MergedSpots { surplus: vec![], kept: vec![0, 1, 2], crowded: vec![1, 2] };
        assert_eq!(found(&three, 3, &grown), all);
    }

    #[test]
    fn a_long_spot_and_one_that_moved_over_another_place_are_not_merged() {
        assert_eq!(found(&[30.0, 50.0], 0, &[spot(40.0, [20.0, 8.0], 0.99)]), MergedSpots::default());
        let bent = [spot(40.0, [12.0, 8.0], 0.9)];
        assert_eq!(found(&[40.0, 90.0], 0, &bent), MergedSpots::default());
    }
}
