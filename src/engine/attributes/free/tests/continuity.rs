//! A mark that moves a little changes the map a little, anywhere but where the spacing is rounded: far from all marks.

use super::super::Far;
use super::sketches::{Random, SIDE, random_ellipses, random_strokes};
use super::{Attributes, Edges, FreeMap, Mark, turn};

/// Coherence below which directions may turn at once.
const UNDECIDED: f64 = 0.3;

/// Largest changes anywhere: of log lengths, aspect, direction (degrees).
#[derive(Debug, Default)]
struct Change {
    length: f64,
    aspect: f64,
    direction: f64,
    /// Whether the spacing far from all marks has changed by a step.
    steps: bool,
}

/// The changes of the map where one mark is moved by .001 of the side.
fn change(marks: &[Mark], edges: Edges, seed: u64) -> Change {
    let mut random = Random::new(1000 + seed);
    let (index, angle) = (random.count(0, marks.len() - 1), random.between(0.0, std::f64::consts::TAU));
    let (s, c) = libm::sincos(angle);
    let mut moved = marks.to_vec();
    moved[index] = marks[index].shifted([0.001 * SIDE * c, 0.001 * SIDE * s]);
    let [before, after] =
        [marks, &moved[..]].map(|marks| FreeMap::from_marks(marks, [SIDE; 2], edges).expect("marks"));
    let [was_far, is_far] = [&before, &after].map(|map| map.far());
    let steps = was_far.map(Far::spacing) != is_far.map(Far::spacing);
    let follows =
        |point| !steps || [was_far, is_far].into_iter().flatten().all(|far| far.nearness(point) == 1.0);
    let mut most = Change { steps, ..Change::default() };
    for i in 0..48 * 48 {
        let point = [SIDE * (f64::from(i % 48) + 0.3) / 48.0, SIDE * (f64::from(i / 48) + 0.7) / 48.0];
        let ratio = |a: Option<f64>, b: Option<f64>| a.zip(b).map_or(0.0, |(a, b)| libm::log(a / b).abs());
        let (a, b) = (before.at(point), after.at(point));
        let [length, aspect] = match (&a, &b) {
            (Attributes::Spots(a), Attributes::Spots(b)) => {
                let size = 0.5 * libm::log(a.area / b.area).abs();
                let spacing = if follows(point) { ratio(a.spacing, b.spacing) } else { 0.0 };
                [size.max(spacing), (a.aspect - b.aspect).abs()]
            }
            (Attributes::Stripes(a), Attributes::Stripes(b)) => {
                [libm::log(a.width / b.width).abs().max(ratio(a.wavelength, b.wavelength)), 0.0]
            }
            _ => panic!("the kind does not change"),
        };
        most.length = most.length.max(length);
        most.aspect = most.aspect.max(aspect);
        if before.coherence_at(point).min(after.coherence_at(point)) >= UNDECIDED {
            most.direction = most.direction.max(turn(a.angle(), b.angle()).abs());
        }
    }
    most
}

/// All but `steps` of these sketches change little anywhere, and those near the marks.
fn assert_continuous(sketch: impl Fn(u64) -> Vec<Mark>, seeds: std::ops::Range<u64>, steps: usize) {
    let mut found = 0;
    for seed in seeds {
        let edges = if seed % 5 == 0 { Edges::Wrap } else { Edges::Closed };
        let change = change(&sketch(seed), edges, seed);
        let Change { length, aspect, direction, steps } = change;
        found += usize::from(steps);
        assert!(length <= 0.05 && aspect <= 0.03 && direction <= 2.0, "sketch {seed}, {edges:?}: {change:?}");
    }
    assert!(found <= steps, "{found} take another step");
}

#[test]
fn an_ellipse_that_moves_by_a_thousandth_of_the_side_changes_the_map_little_anywhere() {
    assert_continuous(random_ellipses, 0..200, 2);
}

#[test]
fn a_stroke_that_moves_by_a_thousandth_of_the_side_changes_the_map_little_anywhere() {
    assert_continuous(random_strokes, 0..24, 0);
}
