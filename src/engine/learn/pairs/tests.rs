use super::*;
use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::pair_columns::PAIR_STRIPES;
use crate::attributes::system::{Description, LookupBy, MarkKind};

static STRIPES: Description = Description {
    name: "pair-stripes",
    marks: MarkKind::Stripes,
    free_spacing: true,
    lookup: LookupBy::Pairs(&Coordinates {
        by_directions: false,
        asked: &[("duty", Scale::Log), ("angle", Scale::Quarter)],
        answered: &[Coordinates::FACTOR],
        duty: [[0.2, 0.7]; 2],
    }),
    columns: &PAIR_STRIPES,
    ..Description::PLAIN
};

/// Rows whose factor follows the direction and the duty smoothly.
fn rows(count: u64) -> Vec<PairRow> {
    (0..count)
        .map(|seed| {
            let [duty, angle] =
                [0.2 + 0.5 * golden(seed, 0.754_877_666), 180.0 * golden(seed, 0.569_840_291)];
            let values = vec![16.0, 10.0 * duty, 10.0, duty, angle, 2.0, factor(duty, angle)];
            PairRow { seed, values }
        })
        .collect()
}

fn golden(index: u64, step: f64) -> f64 {
    (0.5 + index as f64 * step).fract()
}

fn factor(duty: f64, angle: f64) -> f64 {
    1.1 + 0.2 * duty + 0.03 * libm::cos(4.0 * angle.to_radians())
}

#[test]
fn a_smooth_factor_is_learnt_for_any_direction() {
    let set = PairSet::from_rows(&STRIPES, rows(300)).unwrap().unwrap();
    for (duty, angle) in [(0.3, 10.0), (0.5, 100.0), (0.65, -35.0), (0.4, 179.0)] {
        let answer = set.ask(1, &[duty, angle]);
        assert!(answer.inside, "{duty} {angle}");
        let wanted = factor(duty, angle);
        assert!((answer.values[0] / wanted - 1.0).abs() < 0.004, "{duty} {angle}: {answer:?}, {wanted}");
    }
}

#[test]
fn a_question_beyond_the_rows_is_moved_into_their_range() {
    let set = PairSet::from_rows(&STRIPES, rows(300)).unwrap().unwrap();
    let [beyond, end] = [0.95, 0.69].map(|duty| set.ask(1, &[duty, 20.0]));
    assert!(!beyond.inside && end.inside);
    assert!((beyond.values[0] / end.values[0] - 1.0).abs() < 0.004);
}

#[test]
fn what_is_held_out_is_predicted_better_than_by_the_law() {
    let set = PairSet::from_rows(&STRIPES, rows(300)).unwrap().unwrap();
    let held = held_out(&set, 5).unwrap();
    assert_eq!((held.len(), held[0].answered, held[0].errors[2].len()), (1, "factor", 60));
    let mean = |of: usize| held[0].errors[of].iter().sum::<f64>() / 60.0;
    assert!(mean(0) > 0.1 && mean(1) < 0.03 && mean(2) < 0.004, "{} {} {}", mean(0), mean(1), mean(2));
}

#[test]
fn few_rows_are_refused_and_none_are_no_set() {
    let error = PairSet::from_rows(&STRIPES, rows(29)).err().unwrap().to_string();
    assert!(error.contains("29 rows are too few"), "{error}");
    assert!(PairSet::from_rows(&STRIPES, Vec::new()).unwrap().is_none());
}

#[test]
fn a_row_is_written_with_six_digits_and_refused_out_of_range() {
    let mut row = rows(3).remove(2);
    row.values[1] = 1.0 / 3.0;
    let line = write_pair_row(&STRIPES, &row).unwrap();
    assert!(line.starts_with("2,16,0.333333,10,"), "{line}");
    row.values[3] = 7.0;
    let error = write_pair_row(&STRIPES, &row).unwrap_err().to_string();
    assert!(error.contains("duty 7 is not a share"), "{error}");
}
