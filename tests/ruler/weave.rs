//! Measuring the threads of painted weaves.

use dapple_engine::synth::measured_weave::measure_weave;

use super::*;

/// A weave of straight threads: direction, width and period of each.
fn weave(side: usize, threads: &[[f64; 3]]) -> Field {
    const SAMPLES: [f64; 4] = [-0.375, -0.125, 0.125, 0.375];
    let is_thread = |[x, y]: [f64; 2]| {
        threads.iter().any(|[angle, width, period]| {
            let (sin, cos) = angle.to_radians().sin_cos();
            let across = (cos * y - sin * x) / period;
            (across - across.round()).abs() * period < 0.5 * width
        })
    };
    Field::from_fn([side, side], [1.0, 1.0], Edges::Closed, |[x, y]| {
        let samples = SAMPLES.iter().flat_map(|dy| SAMPLES.map(|dx| [x + dx, y + dy]));
        samples.filter(|at| is_thread(*at)).count() as f32 / 16.0
    })
}

#[test]
fn the_threads_of_a_weave_are_measured_as_they_were_drawn() {
    // The largest relative error of the widths; that of the periods is 2 %.
    for (threads, width_bound) in [
        (&[[20.0, 6.0, 24.0], [100.0, 8.0, 28.0]][..], 0.01),
        (&[[0.0, 4.0, 12.0], [90.0, 9.0, 50.0]], 0.02),
        (&[[141.0, 5.0, 16.0], [8.0, 5.0, 30.0]], 0.02),
        (&[[12.0, 5.0, 24.0], [72.0, 8.0, 40.0], [132.0, 4.0, 18.0]], 0.02),
    ] {
        let found = measure_weave(&weave(300, threads)).expect("a weave");
        assert_eq!(found.len(), threads.len());
        for [angle, width, period] in threads {
            let one = found.iter().find(|one| turn(one.angle, *angle).abs() < 5.0).expect("its direction");
            assert!(turn(one.angle, *angle).abs() < 0.3, "{one:?} for {angle}°");
            assert!((one.width / width - 1.0).abs() < width_bound, "{one:?} for {width}");
            assert!((one.period / period - 1.0).abs() < 0.02, "{one:?} for {period}");
        }
    }
}

#[test]
fn stripes_and_spots_are_no_weave() {
    assert_eq!(measure_weave(&weave(200, &[[30.0, 6.0, 20.0]])), None);
    let rings = Field::from_fn([200, 200], [1.0, 1.0], Edges::Closed, |[x, y]| {
        (0.5 + 0.5 * ((x - 100.0).hypot(y - 100.0) * std::f64::consts::TAU / 12.0).cos()) as f32
    });
    assert_eq!(measure_weave(&rings), None);
    assert_eq!(measure_weave(&draw([240, 249], Edges::Closed, Profile::Hard, &graded())), None);
    assert_eq!(measure_weave(&Field::from_fn([64, 64], [1.0, 1.0], Edges::Wrap, |_| 0.0)), None);
}
