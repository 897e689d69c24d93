use super::*;
use crate::grid::Edges;
use crate::points::noise::Noise;

fn field<'a>(labelling: Labelling<'a>, distance: ByPlace<'a>) -> PointField<'a> {
    PointField {
        grid: Grid::unit([120, 90], Edges::Wrap),
        distance,
        distances: [10.0; 2],
        labelling,
        nearest: false,
        axis: 1.0,
        strength: 0.0,
        shift: Shift::Random,
        octaves: 1,
        fold: false,
        blocked: None,
        seed: 5,
    }
}

fn mean(field: &Field) -> f64 {
    field.values.iter().map(|value| f64::from(*value)).sum::<f64>() / field.values.len() as f64
}

const HALF: ByPlace = &|_| 0.5;
const ALL: [Labelling; 9] = [
    Labelling::Values(1),
    Labelling::Values(3),
    Labelling::Random(HALF),
    Labelling::Reference(HALF, 3),
    Labelling::SpaceGiraffe([10, 20]),
    Labelling::BreadthFirst(6),
    Labelling::DepthFirst(6),
    Labelling::RoundRobin(20, 0),
    Labelling::Connected(0.1, 0),
];

#[test]
fn single_values_over_octaves_are_noise() {
    let ours = PointField { octaves: 3, fold: true, ..field(Labelling::Values(1), &|_| 10.0) };
    let noise = Noise { radius: 10.0, octaves: 3, fold: true, seed: 5 }.field(&ours.grid);
    let (grown, points) = ours.grow();
    let off = grown.values.iter().zip(&noise.values).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(off < 1e-5 && points > 1_000, "{off}, {points}");
}

#[test]
fn every_labelling_stays_between_0_and_1_and_has_both_sides() {
    for labelling in ALL {
        for nearest in [false, true] {
            let (grown, _) = PointField { nearest, ..field(labelling, &|_| 6.0) }.grow();
            assert!(grown.values.iter().all(|value| (0.0..=1.0).contains(value)));
            let dark = grown.values.iter().filter(|value| **value > 0.5).count() as f64;
            let share = dark / grown.values.len() as f64;
            assert!((0.05..0.98).contains(&share), "{share}");
        }
    }
}

#[test]
fn points_beside_each_other_share_the_value_of_their_group() {
    let distinct = |size: usize| {
        let ours = PointField { nearest: true, ..field(Labelling::Values(size), &|_| 10.0) };
        let mut values: Vec<u32> = ours.grow().0.values.iter().map(|value| value.to_bits()).collect();
        values.sort_unstable();
        values.dedup();
        values.len()
    };
    let [single, triple] = [1, 3].map(distinct);
    assert!(2 * triple < single && 3 * triple >= single, "{single}, {triple}");
}

#[test]
fn nothing_is_dark_where_it_is_blocked() {
    let blocked = |at: [f64; 2]| at[0] > 60.0;
    for labelling in ALL.into_iter().skip(2) {
        let grid = Grid::unit([120, 90], Edges::Closed);
        let ours = PointField { grid, blocked: Some(&blocked), ..field(labelling, &|_| 6.0) };
        let (grown, _) = ours.grow();
        let most = grown.values.chunks(120).flat_map(|row| &row[85..]).copied().fold(0.0, f32::max);
        assert!(most < 1e-6 && mean(&grown) > 0.01, "{most}");
    }
}

#[test]
fn points_appear_one_after_the_other() {
    let ours = field(Labelling::Random(&|_| 1.0), &|_| 10.0);
    let mut shares = Vec::new();
    let mut growth = FieldGrowth::new(&ours);
    while !growth.advance(&ours, 5) {
        shares.extend(growth.appearing(&ours).iter().map(&mean));
    }
    let (grown, _) = growth.complete(&ours);
    shares.push(mean(&grown));
    assert_eq!(shares.len(), 5);
    assert!(shares.windows(2).all(|pair| pair[0] < pair[1]), "{shares:?}");
    assert!((shares[4] - 1.0).abs() < 1e-6);
}

#[test]
fn more_passes_make_a_longer_border() {
    let disc = |at: [f64; 2]| (2.0 - libm::hypot(at[0] - 60.0, at[1] - 45.0) / 18.0).clamp(0.0, 1.0);
    let border = |passes: u32| {
        let ours = field(Labelling::Reference(&disc, passes), &|_| 10.0);
        let grown = ours.grow().0;
        let above = |x: usize, y: usize| grown.get(x as isize, y as isize) > 0.5;
        (0..90)
            .flat_map(|y| (0..120).map(move |x| (x, y)))
            .filter(|(x, y)| above(*x, *y) != above(x + 1, *y))
            .count()
    };
    let [one, five] = [1, 5].map(border);
    assert!(five > one, "{one}, {five}");
}

#[test]
fn weights_are_shifted_in_the_given_direction() {
    let with = |strength: f64, shift: Shift| {
        let ours = PointField { nearest: true, strength, shift, ..field(Labelling::Values(1), &|_| 10.0) };
        ours.grow().0.values
    };
    let none = with(0.0, Shift::Outward);
    for shift in [Shift::Random, Shift::Outward, Shift::Along(0.0)] {
        let moved = with(0.5, shift).iter().zip(&none).filter(|(a, b)| a != b).count() as f64;
        let share = moved / none.len() as f64;
        assert!((0.05..0.35).contains(&share), "{shift:?}: {share}");
    }
}

#[test]
fn the_number_of_points_is_estimated_in_advance() {
    let distance: ByPlace = &|at| 5.0 + 0.05 * at[0];
    let ours = PointField { distances: [5.0, 11.0], octaves: 2, ..field(Labelling::Values(1), distance) };
    let (_, points) = ours.grow();
    let expected = expected_points(&ours.grid.bounds_px(), distance, 2);
    assert!((points as f64 / expected - 1.0).abs() < 0.12, "{points}, {expected}");
}
