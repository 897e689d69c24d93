//! Directions, widths and periods of strokes.

use super::sketches::{SIDE, STROKES, curve, line, polar, random_strokes};
use super::{Edges, FreeMap, Mark, Note, map, stripes, turn};
use crate::marks::Path;

/// Quantile of values that are not empty.
fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * share) as usize]
}

#[test]
fn the_map_agrees_with_every_stroke_along_it() {
    for (kind, name) in STROKES.iter().enumerate() {
        let (mut turns, mut widths) = (Vec::new(), Vec::new());
        for seed in 0..3 {
            let marks = random_strokes(8 * seed + kind as u64);
            let map = map(&marks);
            for path in marks.iter().filter_map(Mark::path) {
                for sample in path.samples(50) {
                    let there = stripes(map.at(sample.point));
                    turns.push(turn(there.angle, sample.direction).abs());
                    widths.push((there.width / path.width - 1.0).abs());
                }
            }
        }
        let [median, most, width] =
            [quantile(&mut turns, 0.5), quantile(&mut turns, 0.95), quantile(&mut widths, 0.95)];
        assert!(median <= 2.0 && most <= 10.0 && width <= 0.1, "{name}: {median}° {most}° {width}");
    }
}

#[test]
fn between_concentric_rings_the_directions_are_concentric_and_between_rays_they_are_rays() {
    let rings: Vec<Mark> =
        (1..6).map(|k| curve(48, 8.0, move |t| polar(40.0 * f64::from(k), 360.0 * t))).collect();
    let rays: Vec<Mark> = (0..12)
        .map(|k| line(polar(50.0, 30.0 * f64::from(k)), polar(220.0, 30.0 * f64::from(k)), 8.0))
        .collect();
    let [rings, rays] = [map(&rings), map(&rays)];
    for i in 0..200 {
        let degrees = 7.3 * f64::from(i);
        let point = polar(70.0 + 0.7 * f64::from(i), degrees);
        let [ring, ray] = [&rings, &rays].map(|map| stripes(map.at(point)).angle);
        assert!(turn(ring, degrees + 90.0).abs() < 3.0 && turn(ray, degrees).abs() < 8.0, "{point:?}");
    }
}

#[test]
fn the_direction_beyond_an_arc_is_that_of_its_nearest_end() {
    let map = map(&[curve(24, 10.0, |t| polar(150.0, 180.0 + 90.0 * t))]);
    assert!(turn(stripes(map.at([106.0, 400.0])).angle, 90.0).abs() < 25.0);
    assert!(turn(stripes(map.at([400.0, 106.0])).angle, 0.0).abs() < 25.0);
}

#[test]
fn the_distance_of_lines_side_by_side_is_the_period_wanted_and_a_line_alone_has_twice_its_width() {
    let beside: Vec<Mark> = (0..5)
        .map(|i| f64::from(24 * i))
        .map(|y| line([100.0, 100.0 + y], [300.0, 110.0 + y], 8.0))
        .collect();
    let there = stripes(map(&beside).at([200.0, 150.0]));
    assert!((there.wavelength.expect("always") / 23.97 - 1.0).abs() < 0.01, "{there:?}");
    let alone = stripes(map(&beside[..1]).at([200.0, 150.0]));
    assert!((alone.wavelength.expect("always") - 16.0).abs() < 1e-9 && (alone.width - 8.0).abs() < 1e-9);
    let even = stripes(map(&beside).with_duty(0.4).at([200.0, 150.0]));
    assert!((even.wavelength.expect("always") - 20.0).abs() < 1e-9, "{even:?}");
}

#[test]
fn between_two_lines_the_period_is_their_own_distance() {
    let map = map(&[20.0, 40.0, 80.0].map(|y| line([60.0, 100.0 + y], [450.0, 100.0 + y], 10.0)));
    let period = |y| stripes(map.at([256.0, y])).wavelength.expect("always");
    assert!((period(130.0) / 20.0 - 1.0).abs() < 0.06, "{}", period(130.0));
    assert!((period(160.0) / 40.0 - 1.0).abs() < 0.06, "{}", period(160.0));
    assert!((22.0..36.0).contains(&period(140.0)), "{}", period(140.0));
}

#[test]
fn arcs_s_curves_and_the_turns_of_a_spiral_lie_side_by_side() {
    let arcs: Vec<Mark> =
        (0..4).map(|k| curve(24, 6.0, move |t| polar(120.0 + 26.0 * f64::from(k), 100.0 * t))).collect();
    let spiral = [curve(120, 8.0, |t| polar(60.0 + 120.0 * t, 4.0 * 360.0 * t))];
    for (marks, place, wanted) in [(&arcs[..], polar(160.0, 50.0), 26.0), (&spiral, polar(120.0, 10.0), 30.0)]
    {
        let period = stripes(map(marks).at(place)).wavelength.expect("always");
        assert!((period / wanted - 1.0).abs() < 0.04, "{period} instead of {wanted}");
    }
}

#[test]
fn lines_do_not_lie_side_by_side_with_a_third_between_or_with_little_overlap_or_at_an_angle_or_far_apart() {
    let flat = |x: [f64; 2], y: f64| line([x[0], y], [x[1], y], 8.0);
    let period = |marks: &[Mark], at| stripes(map(marks).at(at)).wavelength.expect("always");
    let third = [flat([100.0, 400.0], 200.0), flat([100.0, 400.0], 220.0), flat([100.0, 400.0], 240.0)];
    assert!((period(&third, [250.0, 220.0]) - 20.0).abs() < 0.1);
    let overlap = [flat([60.0, 240.0], 200.0), flat([200.0, 400.0], 230.0)];
    assert!((period(&overlap, [220.0, 215.0]) - 16.0).abs() < 0.1);
    let angle = [flat([100.0, 400.0], 200.0), line([100.0, 210.0], [400.0, 370.0], 8.0)];
    assert!((period(&angle, [150.0, 215.0]) - 16.0).abs() < 0.1);
    let far = [flat([100.0, 400.0], 200.0), flat([100.0, 400.0], 270.0)];
    assert!((period(&far, [250.0, 235.0]) - 16.0).abs() < 0.1);
}

#[test]
fn a_distance_that_stripes_of_the_width_cannot_have_is_noted_with_the_period_taken() {
    let near = map(&[line([60.0, 200.0], [450.0, 200.0], 20.0), line([60.0, 221.0], [450.0, 221.0], 20.0)]);
    let [Note::Period { marks, place, drawn, taken }] = near.notes() else { panic!("{:?}", near.notes()) };
    assert_eq!(*marks, [0, 1]);
    assert!((drawn - 21.0).abs() < 1e-6 && (taken - 20.0 / 0.82).abs() < 1e-6, "{drawn} {taken}");
    assert!((place[1] - 210.5).abs() < 1e-6, "{place:?}");
    assert!((stripes(near.at([256.0, 210.0])).duty() - 0.82).abs() < 1e-6);
    assert!(near.clone().with_duty(0.5).notes().is_empty());
    let stretched = near.resized([1024.0, SIDE]);
    assert!(matches!(stretched.notes(), [Note::Period { place: [x, _], .. }] if *x == 2.0 * place[0]));
    let [told] = &near.remarks()[..] else { panic!("{:?}", near.remarks()) };
    let text = "lines are 21 px apart, and stripes of their width can be at least 24 px apart: draw them farther apart, or thinner";
    assert!(told.ends_with(text), "{told}");
}

#[test]
fn strokes_that_ask_for_the_other_side_of_half_their_period_than_the_rest_are_noted() {
    let flat = |y: f64, width: f64| line([40.0, y], [470.0, y], width);
    let wide = [200.0, 224.0, 248.0, 272.0, 296.0].map(|y| flat(y, 16.0));
    assert!(map(&wide).notes().is_empty(), "{:?}", map(&wide).notes());
    let both = map(&[&wide[..], &[flat(60.0, 6.0), flat(80.0, 6.0)]].concat());
    let [Note::Duty { mark: 5, drawn, mean, .. }, Note::Duty { mark: 6, .. }] = both.notes() else {
        panic!("{:?}", both.notes())
    };
    assert!((drawn - 0.3).abs() < 0.03 && (0.5..0.67).contains(mean), "{drawn} {mean}");
    assert!(both.remarks()[0].contains("this line asks for stripes that cover 3"), "{:?}", both.remarks());
    assert!(both.with_duty(0.6).notes().is_empty());
}

#[test]
fn remarks_leave_out_crossings_and_count_what_is_too_much() {
    let cross = [line([100.0, 100.0], [400.0, 400.0], 10.0), line([100.0, 400.0], [400.0, 100.0], 10.0)];
    let cross = map(&cross);
    assert!(cross.notes().iter().any(|note| matches!(note, Note::Crossing { .. })));
    assert!(cross.remarks().iter().all(|told| !told.contains("cross")), "{:?}", cross.remarks());
    let near: Vec<Mark> =
        (0..8).map(|k| 40.0 + 21.0 * f64::from(k)).map(|y| line([60.0, y], [450.0, y], 20.0)).collect();
    let near = map(&near);
    assert!(near.notes().len() > 5, "{:?}", near.notes());
    let remarks = near.remarks();
    let more = format!("{} more places are like these", near.notes().len() - 4);
    assert_eq!((remarks.len(), remarks.last()), (5, Some(&more)));
}

#[test]
fn strokes_that_cross_are_noted_with_the_place_and_leave_no_direction_there() {
    let cross =
        map(&[line([100.0, 100.0], [400.0, 400.0], 10.0), line([100.0, 400.0], [400.0, 100.0], 10.0)]);
    let [Note::Crossing { marks: [0, 1], place, angle }] = cross.notes() else {
        panic!("{:?}", cross.notes())
    };
    assert!(
        (place[0] - 250.0).abs() < 1e-6 && (place[1] - 250.0).abs() < 1e-6 && (angle - 90.0).abs() < 1e-6
    );
    assert!(cross.coherence_at([250.0, 250.0]) < 0.05 && cross.coherence_at([130.0, 130.0]) > 0.7);
    let eight =
        Path { points: vec![[100.0, 100.0], [300.0, 300.0], [300.0, 100.0], [100.0, 300.0]], width: 8.0 };
    let crossings = map(&[Mark::Path(eight)]);
    assert!(matches!(crossings.notes()[0], Note::Crossing { marks: [0, 0], place: [200.0, 200.0], .. }));
}

#[test]
fn a_stroke_that_many_others_overrule_is_noted() {
    let mut marks: Vec<Mark> = (0..9)
        .map(|i| f64::from(60 + 12 * i))
        .map(|x| line([150.0 + x, 100.0], [150.0 + x, 190.0], 8.0))
        .collect();
    marks.push(line([180.0, 150.0], [340.0, 150.0], 8.0));
    let noted = map(&marks);
    let departs = |note: &Note| matches!(note, Note::Departure { mark: 9, angle, .. } if *angle > 20.0);
    assert!(noted.notes().iter().any(departs), "{:?}", noted.notes());
}

#[test]
fn on_a_tile_strokes_count_across_the_seam() {
    let rows = [10.0, 40.0, 500.0].map(|y| line([100.0, y], [400.0, y], 8.0));
    let tile = FreeMap::from_marks(&rows, [SIDE; 2], Edges::Wrap).expect("lines");
    let period = |y| stripes(tile.at([250.0, y])).wavelength.expect("always");
    assert!((period(511.0) / 22.0 - 1.0).abs() < 0.05, "{}", period(511.0));
    assert!((period(25.0) / 30.0 - 1.0).abs() < 0.05, "{}", period(25.0));
}
