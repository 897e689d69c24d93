//! Random fields of points.

use dapple_engine::document::limits::{CLUSTER, GROUP, POINT_DISTANCE, RAYS, RINGS, Range as Limits, START};
use dapple_engine::document::{Interpolation, Labels, Points, Progression, ToneImage, Towards};
use proptest::prelude::*;
use std::ops::Range;

fn picture() -> impl Strategy<Value = ToneImage> {
    prop::collection::vec(any::<u8>(), 6).prop_map(|values| ToneImage::new([3, 2], values).expect("six px"))
}

fn labels() -> impl Strategy<Value = Labels> {
    let cluster = || 1..60_u32;
    prop_oneof![
        (1..5_u32).prop_map(|group| Labels::Values { group }),
        (0.1..=0.9_f64, 0.1..=0.9_f64).prop_map(|(a, b)| Labels::Random { dark: [a, b] }),
        (picture(), 1..4_u32).prop_map(|(image, passes)| Labels::Image { image, passes }),
        (3..12_u32, 0..12_u32).prop_map(|(least, more)| Labels::SpaceGiraffe { rays: [least, least + more] }),
        cluster().prop_map(|size| Labels::BreadthFirst { size }),
        cluster().prop_map(|size| Labels::DepthFirst { size }),
        (cluster(), 0..2_u32).prop_map(|(size, rings)| Labels::RoundRobin { size, rings }),
        (0.01..=0.3_f64, 0..2_u32).prop_map(|(start, rings)| Labels::Connected { start, rings }),
    ]
}

/// Labels with any allowed numbers.
fn wild_labels() -> impl Strategy<Value = Labels> {
    let cluster = || prop_oneof![3 => 1..60_u32, 1 => CLUSTER[0]..=CLUSTER[1]];
    let rings = || 0..=RINGS;
    prop_oneof![
        (GROUP[0]..=GROUP[1]).prop_map(|group| Labels::Values { group }),
        (0.0..=1.0_f64, 0.0..=1.0_f64).prop_map(|(a, b)| Labels::Random { dark: [a, b] }),
        (picture(), 1..4_u32).prop_map(|(image, passes)| Labels::Image { image, passes }),
        (RAYS[0]..=RAYS[1], 0..=1_u32)
            .prop_map(|(rays, more)| { Labels::SpaceGiraffe { rays: [rays, (rays + more).min(RAYS[1])] } }),
        cluster().prop_map(|size| Labels::BreadthFirst { size }),
        cluster().prop_map(|size| Labels::DepthFirst { size }),
        (cluster(), rings()).prop_map(|(size, rings)| Labels::RoundRobin { size, rings }),
        (START.low..=START.high, rings()).prop_map(|(start, rings)| Labels::Connected { start, rings }),
    ]
}

/// Points of a field with any labels, at distances in this range. Points without labels follow the drawn marks.
pub fn points(distances: Range<f64>) -> impl Strategy<Value = Points> {
    let distance = (distances.clone(), distances).prop_map(<[f64; 2]>::from);
    points_of(distance.boxed(), labels().boxed())
}

/// Points of a field with any labels, mostly at the usual distances, and at any allowed distance.
pub fn wild_points(usual: Range<f64>) -> impl Strategy<Value = Points> {
    let Limits { low, high, .. } = POINT_DISTANCE;
    let any = (0.0..=1.0_f64).prop_map(move |share| (low * (high / low).powf(share)).clamp(low, high));
    let one = || prop_oneof![6 => usual.clone(), 1 => any.clone()];
    points_of((one(), one()).prop_map(<[f64; 2]>::from).boxed(), wild_labels().boxed())
}

fn points_of(
    distance: BoxedStrategy<[f64; 2]>,
    labels: BoxedStrategy<Labels>,
) -> impl Strategy<Value = Points> {
    let progression = prop_oneof![
        Just(Progression::Across),
        Just(Progression::Down),
        Just(Progression::Outward),
        picture().prop_map(Progression::Image),
    ];
    let towards = prop_oneof![
        Just(Towards::Random),
        Just(Towards::Outward),
        (-180.0..180.0_f64).prop_map(Towards::Angle)
    ];
    let shifted = (prop_oneof![2 => Just(0.0), 1 => 0.0..=1.0_f64], towards);
    let cut = (any::<bool>(), prop::option::of(0.1..=0.9_f64), 1.0..=2.0_f64);
    let made = (prop::option::of(distance), progression, labels, 1..4_u32, any::<bool>(), shifted, cut);
    made.prop_map(
        |(distance, progression, labels, octaves, fold, (shift, towards), (nearest, share, axis))| {
            let interpolation = if nearest { Interpolation::Nearest } else { Interpolation::Smooth };
            let share = share.filter(|_| !nearest);
            Points {
                distance,
                progression,
                labels,
                octaves,
                fold,
                interpolation,
                axis,
                shift,
                towards,
                share,
            }
        },
    )
}
