//! How well the map finds what marks with random departures were drawn from.

use super::sketches::{Random, SIDE, ellipse};
use super::{Edges, FreeMap, Mark, map, spots};
use crate::attributes::regions::RegionMap;

/// Root mean square errors of the log area, of the free map and of 3 × 3 regions: marks that scatter by .25 about `field`
/// (of the canvas 0..1), in eight sketches.
fn errors(count: usize, field: impl Fn(f64, f64) -> f64) -> [f64; 2] {
    let (mut squares, mut total) = ([0.0; 2], 0.0);
    for seed in 0..8 {
        let mut random = Random::new(seed);
        let places = random.scatter(count);
        let mut mark = |place: [f64; 2]| {
            let log = field(place[0] / SIDE, place[1] / SIDE) + 0.25 * random.normal();
            ellipse(place, 400.0 * libm::exp(log), 0.7, 0.0)
        };
        let marks: Vec<Mark> = places.into_iter().map(&mut mark).collect();
        let free = map(&marks);
        let regions = RegionMap::from_marks(&marks, [SIDE; 2], [3, 3], Edges::Closed).expect("ellipses");
        for i in 0..20 * 20 {
            let [x, y] = [(f64::from(i % 20) + 0.5) / 20.0, (f64::from(i / 20) + 0.5) / 20.0];
            let point = [x * SIDE, y * SIDE];
            for (square, found) in squares.iter_mut().zip([free.at(point), regions.at(point)]) {
                let error = libm::log(spots(found).area / 400.0) - field(x, y);
                *square += error * error;
            }
            total += 1.0;
        }
    }
    squares.map(|sum| (sum / total).sqrt())
}

fn ramp(x: f64, y: f64) -> f64 {
    1.4 * (x - 0.5) + 0.4 * (y - 0.5)
}

#[test]
fn forty_marks_tell_a_ramp_a_hill_and_a_wave_better_than_three_by_three_regions_do() {
    let hill = |x: f64, y: f64| 1.5 * libm::exp(-8.0 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)));
    let wave = |x: f64, _: f64| 0.6 * libm::sin(std::f64::consts::TAU * x);
    let found = [errors(40, ramp), errors(40, hill), errors(40, wave)];
    for ([free, regions], most) in found.into_iter().zip([0.111, 0.165, 0.202]) {
        assert!(free <= most && free < 0.9 * regions, "{found:?}");
    }
}

#[test]
fn twelve_marks_tell_a_ramp() {
    let [free, regions] = errors(12, ramp);
    assert!(free <= 0.144 && free < regions, "{free} {regions}");
}

#[test]
fn marks_that_only_scatter_leave_the_map_nearly_even_and_are_its_spread() {
    let mut random = Random::new(5);
    let marks: Vec<Mark> = (random.scatter(40).into_iter())
        .map(|place| {
            ellipse(place, 400.0 * libm::exp(0.4 * random.normal()), 0.6, 20.0 + 15.0 * random.normal())
        })
        .collect();
    let map: FreeMap = map(&marks);
    let spread = map.spread();
    assert!((0.25..0.5).contains(&spread.area) && (9.0..18.0).contains(&spread.angle), "{spread:?}");
    let mean = spots(map.mean()).area;
    for i in 0..64 {
        let there = spots(map.at([64.0 * (f64::from(i % 8) + 0.5), 64.0 * (f64::from(i / 8) + 0.5)]));
        assert!((there.area / mean - 1.0).abs() < 0.3, "{there:?} {mean}");
    }
}
