//! At the centre of a region, the map has the attributes of the region; between centres, they stay within those of the
//! four regions around the point.

use crate::cases;
use dapple_engine::attributes::regions::RegionMap;
use dapple_engine::attributes::{Attributes, Spots};
use dapple_engine::document::Edges;
use dapple_engine::marks::{Ellipse, Line, Mark};
use proptest::prelude::*;

const SIZE: [f64; 2] = [300.0, 200.0];

fn point() -> impl Strategy<Value = [f64; 2]> {
    (0.0..=SIZE[0], 0.0..=SIZE[1]).prop_map(<[f64; 2]>::from)
}

fn ellipse() -> impl Strategy<Value = Mark> {
    (point(), 0.01..300.0, 0.01..300.0, -1e4..1e4_f64)
        .prop_map(|(center, r, q, angle)| Mark::Ellipse(Ellipse { center, radii: [r, q], angle }))
}

fn line() -> impl Strategy<Value = Mark> {
    let towards = (0.0..360.0_f64, 0.02..150.0_f64);
    (point(), towards, 0.01..300.0).prop_map(|(from, (degrees, length), width)| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let to = [from[0] + length * cos, from[1] + length * sin];
        Mark::Line(Line { from, to, width })
    })
}

/// A map of marks, all ellipses or all lines; the midpoint of a line may lie outside the canvas.
fn map() -> impl Strategy<Value = RegionMap> {
    let marks = prop_oneof![prop::collection::vec(ellipse(), 1..30), prop::collection::vec(line(), 1..30),];
    let edges = prop::sample::select(vec![Edges::Closed, Edges::Wrap]);
    (marks, 1..=9_usize, 1..=9_usize, edges).prop_map(|(marks, columns, rows, edges)| {
        RegionMap::from_marks(&marks, SIZE, [columns, rows], edges).unwrap()
    })
}

/// The attributes that are blended linearly.
fn plain(attributes: &Attributes) -> Vec<Option<f64>> {
    match attributes {
        Attributes::Spots(Spots { area, aspect, spacing, .. }) => vec![Some(*area), Some(*aspect), *spacing],
        Attributes::Stripes(stripes) => vec![Some(stripes.width), stripes.wavelength],
    }
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn the_map_has_the_attributes_of_a_region_at_its_centre(map in map()) {
        let layout = map.layout();
        for (place, region) in map.regions() {
            let center = layout.center(place);
            for (there, own) in plain(&map.at(center)).into_iter().zip(plain(&region.filled)) {
                // Here rounding may give a neighbour with a free spacing a weight of 1e-16.
                let Some((there, own)) = there.zip(own) else { continue };
                prop_assert!((there / own - 1.0).abs() < 1e-9, "{there}, not {own}, at {center:?}");
            }
        }
    }

    #[test]
    fn the_map_stays_within_its_corners(map in map(), points in prop::collection::vec(point(), 8)) {
        let layout = map.layout();
        for point in points {
            let corners = layout.corners(point);
            let weights: f64 = corners.iter().map(|(_, weight)| weight).sum();
            prop_assert!((weights - 1.0).abs() < 1e-12 && corners.iter().all(|(_, weight)| *weight >= 0.0));
            let around = corners.iter().filter(|(_, weight)| *weight > 0.0);
            let around: Vec<Vec<Option<f64>>> =
                around.map(|(region, _)| plain(&map.region(layout.place(*region)).filled)).collect();
            for (attribute, value) in plain(&map.at(point)).into_iter().enumerate() {
                // A spacing is free wherever the spacing of one of the corners is free.
                let held: Option<Vec<f64>> = around.iter().map(|corner| corner[attribute]).collect();
                prop_assert_eq!(value.is_some(), held.is_some(), "attribute {} at {:?}", attribute, point);
                let Some((value, held)) = value.zip(held) else { continue };
                let low = held.iter().copied().fold(f64::INFINITY, f64::min);
                let high = held.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                prop_assert!(value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9), "{value} of {low}–{high}");
            }
            let [x, y] = map.double_angle_at(point);
            prop_assert!(x.is_finite() && y.is_finite() && x.hypot(y) <= 1.0 + 1e-9, "{x} {y}");
        }
    }
}
