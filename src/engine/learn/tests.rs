//! Known laws of scale, learnt from rows that follow them.

use proptest::prelude::*;

use super::laws::{
    EXACT, LINES, MEASURED, MEINHARDT, STRIPES, TURING, area_of, line_duty, lines, meinhardt,
    meinhardt_by_level, meinhardt_density, meinhardt_law, size_by_level, stripe_law, stripes, turing,
    turing_law,
};
use super::*;
use crate::attributes::{Attribute, Attributes, Spots, Stripes};
use crate::marks::turn;

fn spots(area: f64, aspect: f64, angle: f64, spacing: Option<f64>) -> Attributes {
    Attributes::Spots(Spots { area, aspect, angle, spacing })
}

fn seen(attributes: &Attributes) -> Spots {
    match attributes {
        Attributes::Spots(spots) => *spots,
        Attributes::Stripes(stripes) => panic!("{stripes:?}"),
    }
}

fn close(got: f64, wanted: f64, by: f64) {
    assert!((got / wanted - 1.0).abs() < by, "{got} is not {wanted} to {by}");
}

/// The answer of `set` to `wanted`, with the predicted attributes; all lengths are cells.
fn answered(set: &TrainingSet, wanted: &Attributes) -> Answer {
    set.ask(&InCells(*wanted)).expect("an answer").predict(set).0
}

#[test]
fn the_law_of_turing_spots_is_learnt() {
    let set = TrainingSet::from_rows(&TURING, turing(500, EXACT)).unwrap();
    for (area, aspect, angle) in
        [(25.0, 0.5, 10.0), (60.0, 0.4, 100.0), (60.0, 0.7, 33.0), (130.0, 0.6, 170.0)]
    {
        let answer = answered(&set, &spots(area, aspect, angle, None));
        let p = answer.parameters;
        close(area_of(p.rate, turing_law), area, 0.01);
        let (w, floor) = (libm::log(p.stretch), libm::log(0.88));
        assert!((libm::exp(-(w * w + floor * floor).sqrt()) - aspect).abs() < 0.01, "{p:?}");
        assert!(turn(laws::pulled(p.direction, area), angle).abs() < 0.3, "{p:?}");
        assert_eq!((p.ratio, p.level), (Some(1.0 / 3.8), Some(0.5)));

        let predicted = seen(&answer.predicted);
        close(predicted.area, area, 0.01);
        close(predicted.spacing.unwrap(), 2.1 * area.sqrt(), 0.01);
        assert!((predicted.aspect - aspect).abs() < 0.01);
        assert!(turn(predicted.angle, angle).abs() < 0.3);
        assert_eq!(answer.coverage, Coverage::Inside, "{:?}", answer.notes);
    }
}

#[test]
fn the_law_of_meinhardt_spots_with_spacing_is_learnt() {
    for (noise, by) in [(EXACT, 0.01), (MEASURED, 0.02)] {
        let set = TrainingSet::from_rows(&MEINHARDT, meinhardt(500, noise)).unwrap();
        for (area, ratio, angle) in [(40.0, 15.0, 20.0), (60.0, 30.0, 95.0), (120.0, 60.0, 150.0)] {
            let spacing = (area / meinhardt_density(ratio)).sqrt();
            let answer = answered(&set, &spots(area, 0.55, angle, Some(spacing)));
            let p = answer.parameters;
            close(p.ratio.unwrap(), ratio, 2.0 * by);
            close(area_of(p.rate, |area| meinhardt_law(area, p.ratio.unwrap())), area, by);
            close(0.99 * p.stretch, 0.55, by);
            let predicted = seen(&answer.predicted);
            close(predicted.area, area, by);
            close(predicted.spacing.unwrap(), spacing, by);
            close(predicted.aspect, 0.55, by);
            assert!(turn(predicted.angle, angle).abs() < 0.5);
        }
    }
}

#[test]
fn a_set_that_reaches_high_densities_by_the_level_is_followed_where_ratio_and_level_change_over() {
    let set = TrainingSet::from_rows(&MEINHARDT, meinhardt_by_level(500, MEASURED)).unwrap();
    let corner = meinhardt_density(12.0);
    for share in [0.3, 0.6, 0.8, 0.95, 1.0, 1.05, 1.2, 1.4, 1.7] {
        let wanted = spots(60.0, 0.6, 30.0, Some((60.0 / (share * corner)).sqrt()));
        let answer = answered(&set, &wanted);
        let p = answer.parameters;
        let (ratio, by_level) = (p.ratio.unwrap(), size_by_level(p.level.unwrap()));
        close(meinhardt_density(ratio) * by_level, share * corner, 0.04);
        close(area_of(p.rate, |area| meinhardt_law(area, ratio) * by_level), 60.0, 0.03);
        close(seen(&answer.predicted).area, 60.0, 0.02);
        assert_eq!(answer.coverage, Coverage::Inside, "{:?}", answer.notes);
    }
}

#[test]
fn the_law_of_stripes_is_learnt() {
    let set = TrainingSet::from_rows(&STRIPES, stripes(200, EXACT)).unwrap();
    for (width, angle) in [(4.0, 0.0), (8.0, 22.0), (8.0, 135.0), (15.0, 179.0)] {
        let answer = answered(&set, &Attributes::Stripes(Stripes { width, angle, wavelength: None }));
        let p = answer.parameters;
        close(p.rate, stripe_law(width) / (width * width), 0.015);
        assert!(turn(laws::pulled(p.direction, 3.0 * width), angle).abs() < 0.2, "{p:?}");
        close(p.stretch, 0.5, 1e-9);
        let Attributes::Stripes(predicted) = answer.predicted else { panic!() };
        close(predicted.width, width, 0.01);
        assert!(turn(predicted.angle, angle).abs() < 0.2);
        assert_eq!(
            (answer.coverage, answer.nearest),
            (Coverage::Inside, Attributes::Stripes(Stripes { width, angle, wavelength: None }))
        );
    }
}

#[test]
fn the_law_of_lines_is_learnt_and_a_duty_beyond_the_rows_is_moved_to_the_nearest() {
    let set = TrainingSet::from_rows(&LINES, lines(400, EXACT)).unwrap();
    let ask = |width, angle, duty: f64| {
        answered(&set, &Attributes::Stripes(Stripes { width, angle, wavelength: Some(width / duty) }))
    };
    for (width, angle, duty) in [(4.0, 0.0, 0.25), (8.0, 22.0, 0.4), (8.0, 135.0, 0.3), (15.0, 179.0, 0.48)] {
        let answer = ask(width, angle, duty);
        let p = answer.parameters;
        close(line_duty(p.ratio.unwrap()), duty, 0.02);
        close(p.stretch, 0.5, 1e-9);
        assert!(turn(laws::pulled(p.direction, 3.0 * width), angle).abs() < 0.3, "{p:?}");
        let Attributes::Stripes(predicted) = answer.predicted else { panic!() };
        close(predicted.width, width, 0.02);
        close(predicted.wavelength.unwrap(), width / duty, 0.02);
        assert_eq!(answer.coverage, Coverage::Inside, "{:?}", answer.notes);
        assert_eq!(
            answer.interval.iter().map(|(of, _)| *of).collect::<Vec<_>>(),
            [Attribute::Width, Attribute::Angle, Attribute::Wavelength]
        );
    }
    let answer = ask(8.0, 40.0, 0.1);
    assert_eq!(answer.coverage, Coverage::Outside);
    let note = answer.notes[0].to_string();
    assert!(note.starts_with("duty 0.1 is a smaller share") && note.contains("at least 0.18"), "{note}");
    let Attributes::Stripes(nearest) = answer.nearest else { panic!() };
    close(nearest.duty(), 0.185, 0.03);
    // A free wavelength is twice the width.
    let free = answered(&set, &Attributes::Stripes(Stripes { width: 8.0, angle: 40.0, wavelength: None }));
    assert_eq!(free.parameters, ask(8.0, 40.0, 0.5).parameters);
}

#[test]
fn a_mirrored_question_has_the_mirrored_answer() {
    let set = TrainingSet::from_rows(&MEINHARDT, meinhardt(100, MEASURED)).unwrap();
    let ask = |angle| answered(&set, &spots(60.0, 0.5, angle, Some(30.0))).parameters;
    let p = ask(20.0);
    for (angle, direction) in [(-20.0, -p.direction), (70.0, 90.0 - p.direction), (110.0, 90.0 + p.direction)]
    {
        let image = ask(angle);
        close(image.rate, p.rate, 1e-9);
        assert!(turn(image.direction, direction).abs() < 1e-9);
    }
}

#[test]
fn round_spots_get_no_stretch_and_the_roundest_prediction() {
    let turing = TrainingSet::from_rows(&TURING, turing(500, MEASURED)).unwrap();
    let answer = answered(&turing, &spots(60.0, 1.0, 0.0, None));
    assert!(answer.parameters.stretch > 0.97, "{:?}", answer.parameters);
    assert_eq!(seen(&answer.nearest).angle, 0.0);
    assert!((seen(&answer.predicted).aspect - 0.88).abs() < 0.015);
    assert_eq!(answer.coverage, Coverage::Outside);
    assert!(
        answer.notes[0].to_string().starts_with("aspect 1 is too round: the roundest possible is 0.8"),
        "{:?}",
        answer.notes
    );

    let meinhardt = TrainingSet::from_rows(&MEINHARDT, meinhardt(500, MEASURED)).unwrap();
    let answer = answered(&meinhardt, &spots(60.0, 1.0, 0.0, Some(30.0)));
    assert!(seen(&answer.predicted).aspect > 0.97);
    assert_eq!(answer.coverage, Coverage::Inside, "{:?}", answer.notes);
}

#[test]
fn intervals_hold_nine_of_ten_new_rows() {
    let rows = meinhardt(700, MEASURED);
    let set = TrainingSet::from_rows(&MEINHARDT, rows[..500].to_vec()).unwrap();
    let attributes = [Attribute::Area, Attribute::Aspect, Attribute::Angle, Attribute::Spacing];
    for (at, attribute) in attributes.into_iter().enumerate() {
        let within = rows[500..].iter().filter(|row| {
            let InCells(prediction) = set.predict(&row.parameters);
            let (of, [low, high]) = prediction.interval[at];
            assert_eq!(of, attribute);
            let s = seen(&row.attributes.0);
            let mean = 0.5 * (low + high);
            let value = match attribute {
                Attribute::Area => s.area,
                Attribute::Aspect => s.aspect,
                Attribute::Angle => mean + turn(s.angle, mean),
                _ => s.spacing.unwrap(),
            };
            low <= value && value <= high
        });
        let share = within.count() as f64 / 200.0;
        assert!((0.82..=0.97).contains(&share), "{attribute}: {share}");
    }
}

#[test]
fn a_question_beyond_the_rows_gets_the_answer_to_the_nearest_one_within() {
    let set = TrainingSet::from_rows(&MEINHARDT, meinhardt(500, EXACT)).unwrap();
    let [area, density, aspect] = [0, 1, 2].map(|i| set.reach().0[i].1);
    // Denser than the densest, by a little and by a lot.
    let spacing = |density: f64| Some((60.0 / density).sqrt());
    let edge = answered(&set, &spots(60.0, 0.6, 0.0, spacing(density[1] * 1.04)));
    let outside = answered(&set, &spots(60.0, 0.6, 0.0, spacing(density[1] * 1.4)));
    assert_eq!((edge.coverage, outside.coverage), (Coverage::Edge, Coverage::Outside));
    assert!(outside.notes[0].to_string().starts_with("spacing 17."), "{:?}", outside.notes);
    assert!(outside.notes[0].to_string().contains("too small for spots of this size"), "{:?}", outside.notes);
    let nearest = seen(&outside.nearest);
    assert!(nearest.area / nearest.spacing.unwrap().powi(2) <= density[1] * 1.0001);
    close(edge.parameters.ratio.unwrap(), outside.parameters.ratio.unwrap(), 0.02);
    // Larger than the largest: the answer is the largest's.
    let answer = answered(&set, &spots(area[1] * 100.0, 0.6, 0.0, None));
    assert_eq!(answer.coverage, Coverage::Outside);
    assert!(seen(&answer.nearest).area <= area[1] * 1.0001);
    close(seen(&answer.predicted).area, seen(&answer.nearest).area, 0.05);
    // More elongated than any row.
    let answer = answered(&set, &spots(60.0, 0.01, 0.0, None));
    assert!(answer.parameters.stretch > 0.29 && seen(&answer.nearest).aspect >= aspect[0] * 0.9999);
    assert!(
        answer.notes.iter().any(|note| note.to_string().contains("too narrow: the narrowest possible is")),
        "{:?}",
        answer.notes
    );
}

#[test]
fn a_spacing_that_the_system_does_not_give_is_refused_with_a_message() {
    let set = TrainingSet::from_rows(&TURING, turing(500, MEASURED)).unwrap();
    let ask = |spacing| answered(&set, &spots(60.0, 0.5, 0.0, Some(spacing)));
    let natural = 2.1 * 60.0_f64.sqrt();
    assert_eq!(ask(natural).coverage, Coverage::Inside);
    let answer = ask(30.0);
    assert_eq!(answer.coverage, Coverage::Outside);
    assert!(answer.notes[0].to_string().starts_with("spacing 30"), "{:?}", answer.notes);
    close(seen(&answer.nearest).spacing.unwrap(), natural, 0.02);
}

#[test]
fn a_free_spacing_gets_the_median_density_of_the_set_and_a_note() {
    let set = TrainingSet::from_rows(&MEINHARDT, meinhardt(500, EXACT)).unwrap();
    let answer = answered(&set, &spots(60.0, 0.6, 40.0, None));
    assert_eq!(answer.coverage, Coverage::Inside);
    assert!(answer.notes[0].to_string().starts_with("no spacing is given"), "{:?}", answer.notes);
    close(answer.parameters.ratio.unwrap(), libm::sqrt(1000.0), 0.15);
    close(seen(&answer.nearest).spacing.unwrap(), seen(&answer.predicted).spacing.unwrap(), 0.02);
}

#[test]
fn a_question_about_the_wrong_kind_of_marks_is_an_error() {
    let set = TrainingSet::from_rows(&TURING, turing(40, MEASURED)).unwrap();
    let stripes = Attributes::Stripes(Stripes { width: 8.0, angle: 0.0, wavelength: None });
    assert_eq!(
        set.ask(&InCells(stripes)).unwrap_err().to_string(),
        "turing-spots takes area, aspect, angle and perhaps spacing"
    );
    for wrong in [
        spots(0.0, 0.5, 0.0, None),
        spots(f64::NAN, 0.5, 0.0, None),
        spots(60.0, 1.5, 0.0, None),
        spots(60.0, 0.5, f64::INFINITY, None),
        spots(60.0, 0.5, 0.0, Some(-1.0)),
    ] {
        assert!(matches!(set.ask(&InCells(wrong)), Err(AskError::Value { .. })), "{wrong:?}");
    }
}

/// Asserts that every number of an answer is finite and every parameter within its range.
fn sound(answer: &Answer) {
    let p = answer.parameters;
    assert!(p.named().iter().all(|(_, value)| value.is_finite()), "{p:?}");
    assert!(p.rate > 0.0 && p.stretch > 0.0 && p.stretch <= 1.0 && (0.0..180.0).contains(&p.direction));
    for attributes in [answer.predicted, answer.nearest] {
        match attributes {
            Attributes::Spots(s) => {
                let lengths = [s.area, s.aspect, s.spacing.unwrap()];
                assert!(lengths.iter().all(|x| x.is_finite() && *x > 0.0), "{s:?}");
                assert!(s.aspect <= 1.0 && (0.0..180.0).contains(&s.angle), "{s:?}");
            }
            Attributes::Stripes(s) => assert!(s.width > 0.0 && (0.0..180.0).contains(&s.angle), "{s:?}"),
        }
    }
    for (name, [low, high]) in &answer.interval {
        assert!(low.is_finite() && high.is_finite() && low <= high, "{name}: {low} {high}");
    }
}

/// Positive numbers far below and far above possible values.
fn positive() -> impl Strategy<Value = f64> {
    prop_oneof![3.0..300.0_f64, (-300.0..300.0_f64).prop_map(|e| libm::pow(10.0, e)), Just(f64::MIN_POSITIVE)]
}

thread_local! {
    static SETS: [TrainingSet; 2] =
        [&TURING, &MEINHARDT].map(|system| TrainingSet::embedded(system).unwrap());
    static STRIPE_SET: TrainingSet = TrainingSet::embedded(&STRIPES).unwrap();
}

proptest! {
    #[test]
    fn any_spots_have_a_finite_answer(
        area in positive(),
        aspect in prop_oneof![1e-3..=1.0_f64, Just(1.0), Just(f64::MIN_POSITIVE)],
        angle in prop_oneof![-200.0..200.0_f64, any::<f64>().prop_filter("finite", |x| x.is_finite())],
        spacing in proptest::option::of(positive()),
    ) {
        SETS.with(|sets| {
            for set in sets {
                sound(&answered(set, &spots(area, aspect, angle, spacing)));
            }
        });
    }

    #[test]
    fn any_stripes_have_a_finite_answer(width in positive(), angle in -1e9..1e9_f64) {
        STRIPE_SET.with(|set| sound(&answered(set, &Attributes::Stripes(Stripes { width, angle, wavelength: None }))));
    }

    #[test]
    fn the_same_question_has_the_same_answer(area in 20.0..200.0_f64, angle in 0.0..180.0_f64) {
        SETS.with(|sets| {
            let ask = || answered(&sets[1], &spots(area, 0.5, angle, Some(30.0)));
            assert_eq!(ask().parameters, ask().parameters);
        });
    }
}
