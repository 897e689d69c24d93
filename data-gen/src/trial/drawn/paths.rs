//! Compares drawn strokes with the pattern: its direction, period and width along them.

use dapple_engine::marks::{Path, turn};

use super::geometry::distance;
use super::shapes::Shapes;

/// A stroke counts as there if this share of its length is inside a stripe.
pub const COVERED: f64 = 0.9;
/// Strokes count as side by side up to this distance, in widths.
const SIDE_BY_SIDE: f64 = 6.0;
/// Strokes count as side by side up to this difference of direction, degrees.
const PARALLEL: f64 = 20.0;
/// Strokes count as side by side where they overlap over at least this share of the shorter one.
const OVERLAP: f64 = 0.5;
/// Radius of the window of the structure tensor, periods.
const WINDOW: f64 = 0.35;

/// The comparison of a drawn stroke with the pattern.
#[derive(Clone, Debug, Default)]
pub struct Stroke {
    /// The share of its length that is inside a stripe.
    pub covered: f64,
    /// Differences between the direction of the pattern and that of the stroke, degrees, at points along the stroke.
    pub directions: Vec<f64>,
    /// Mean width of the stripe along it ÷ drawn − 1.
    pub width: Option<f64>,
    /// For each stroke side by side with it: the distance from its stripe to the next ÷ drawn distance − 1.
    pub periods: Vec<f64>,
}

/// A place on a stroke: a point, and the unit vector along the stroke.
#[derive(Clone, Copy)]
struct Place {
    at: [f64; 2],
    along: [f64; 2],
}

impl Place {
    /// The point this far to the left, px.
    fn beside(&self, by: f64) -> [f64; 2] {
        [self.at[0] - by * self.along[1], self.at[1] + by * self.along[0]]
    }
}

/// The comparison of each of the `drawn` strokes.
pub fn compare(drawn: &[Path], shapes: &Shapes) -> Vec<Stroke> {
    let places: Vec<Vec<Place>> = drawn.iter().map(places).collect();
    (0..drawn.len()).map(|stroke| one(stroke, drawn, &places, shapes)).collect()
}

fn one(stroke: usize, drawn: &[Path], places: &[Vec<Place>], shapes: &Shapes) -> Stroke {
    let width = drawn[stroke].width;
    let others = neighbours(stroke, drawn, places);
    let nearest = others.iter().flat_map(|other| &other.apart).map(|(_, apart)| apart.abs());
    let period = nearest.fold(2.0 * width, f64::min);
    // Near the border, only one side of the pattern is there to compare.
    let inner: Vec<Place> =
        places[stroke].iter().copied().filter(|place| shapes.holds(place.at, 0.5 * period)).collect();
    let on: Vec<&Place> = inner.iter().filter(|place| shapes.value(place.at) >= 0.5).collect();
    let widths = on.iter().filter_map(|place| stripe(place, 0.0, 3.0 * width, shapes));
    let widths: Vec<f64> = widths.map(|[low, high]| high - low).collect();
    Stroke {
        covered: on.len() as f64 / inner.len().max(1) as f64,
        directions: inner.iter().map(|place| deviation(place, WINDOW * period, shapes)).collect(),
        width: mean(&widths).map(|got| got / width - 1.0),
        periods: others.iter().filter_map(|other| other.period(&places[stroke], shapes)).collect(),
    }
}

fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// Places along a stroke, half a width apart; the ends are left out.
fn places(path: &Path) -> Vec<Place> {
    let step = (0.5 * path.width).max(2.0);
    let mut gone = vec![0.0];
    for pair in path.points.windows(2) {
        gone.push(gone[gone.len() - 1] + distance(pair[0], pair[1]));
    }
    let length = gone[gone.len() - 1];
    let at = |along: f64| {
        let next = gone.partition_point(|gone| *gone < along).clamp(1, gone.len() - 1);
        let share = ((along - gone[next - 1]) / (gone[next] - gone[next - 1]).max(1e-9)).clamp(0.0, 1.0);
        let [a, b] = [path.points[next - 1], path.points[next]];
        [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
    };
    let count = ((length - path.width) / step).floor().max(0.0) as usize;
    let place = |k: usize| {
        let along = 0.5 * path.width + (k as f64 + 0.5) * (length - path.width) / count as f64;
        let [before, after] = [at(along - 0.5 * step), at(along + 0.5 * step)];
        let far = distance(before, after).max(1e-9);
        Place { at: at(along), along: [0, 1].map(|axis| (after[axis] - before[axis]) / far) }
    };
    (0..count).map(place).collect()
}

/// A stroke side by side with another one: the index of places of that one, and the distance there; negative to the
/// right.
struct Neighbour {
    apart: Vec<(usize, f64)>,
}

/// The strokes side by side with `stroke` that have no other stroke in between.
fn neighbours(stroke: usize, drawn: &[Path], places: &[Vec<Place>]) -> Vec<Neighbour> {
    // For each place, the nearest other strokes to the left and to the right.
    let reach = SIDE_BY_SIDE * drawn[stroke].width;
    let mut found: Vec<Neighbour> = drawn.iter().map(|_| Neighbour { apart: Vec::new() }).collect();
    for (k, place) in places[stroke].iter().enumerate() {
        for left in [true, false] {
            let crossing = |other: usize| Some((other, crossed(place, &places[other], reach, left)?));
            let others = (0..drawn.len()).filter(|other| *other != stroke);
            let nearest = others.filter_map(crossing).min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            if let Some((other, apart)) = nearest {
                found[other].apart.push((k, apart));
            }
        }
    }
    let enough = |(other, neighbour): &(usize, Neighbour)| {
        let shorter = places[stroke].len().min(places[*other].len());
        neighbour.apart.len() as f64 >= OVERLAP * shorter as f64 && !neighbour.apart.is_empty()
    };
    found.into_iter().enumerate().filter(enough).map(|(_, neighbour)| neighbour).collect()
}

/// The point where the normal of a place crosses a parallel stroke, at most `reach` px away on that side.
fn crossed(place: &Place, other: &[Place], reach: f64, left: bool) -> Option<f64> {
    let crossing = |pair: &[Place]| {
        let [(a, before), (b, after)] = [pair[0], pair[1]].map(|other| {
            let from = [other.at[0] - place.at[0], other.at[1] - place.at[1]];
            let along = from[0] * place.along[0] + from[1] * place.along[1];
            (along, place.along[0] * from[1] - place.along[1] * from[0])
        });
        let share = a / (a - b);
        let apart = before + share * (after - before);
        let parallel = turn(angle(pair[0].along), angle(place.along)).abs() <= PARALLEL;
        let near = apart.abs() <= reach && (apart > 0.0) == left;
        ((a <= 0.0) != (b <= 0.0) && parallel && near).then_some(apart)
    };
    other.windows(2).filter_map(crossing).min_by(|a, b| a.abs().total_cmp(&b.abs()))
}

fn angle(along: [f64; 2]) -> f64 {
    libm::atan2(along[1], along[0]).to_degrees()
}

impl Neighbour {
    /// The mean distance from the stroke's stripe to the next one, on the side of the neighbour, ÷ the drawn distance −
    /// 1.
    fn period(&self, places: &[Place], shapes: &Shapes) -> Option<f64> {
        let ratio = |(k, apart): &(usize, f64)| {
            let (place, side) = (&places[*k], apart.signum());
            if !shapes.holds(place.beside(1.5 * apart), 0.0) {
                return None;
            }
            let own = stripe(place, 0.0, apart.abs(), shapes)?;
            let edge = if side > 0.0 { own[1] } else { own[0] };
            let step = 0.1 * apart.abs().min(10.0);
            let outside = edge + side * 0.2;
            // The next stripe begins where the pattern rises again.
            let ahead = (0..400).map(|k| outside + side * step * f64::from(k));
            let inside = ahead
                .take_while(|by| by.abs() < 3.0 * apart.abs())
                .find(|by| shapes.value(place.beside(*by)) >= 0.5)?;
            let next = stripe(place, inside, apart.abs(), shapes)?;
            let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
            Some((middle(next) - middle(own)).abs() / apart.abs())
        };
        let ratios: Vec<f64> = self.apart.iter().filter_map(ratio).collect();
        mean(&ratios).map(|ratio| ratio - 1.0)
    }
}

/// The stripe across a place: its beginning and end on the normal, px, if it contains the point `from` px to the left
/// and is at most `most` px wide on either side of that point.
fn stripe(place: &Place, from: f64, most: f64, shapes: &Shapes) -> Option<[f64; 2]> {
    const STEP: f64 = 0.25;
    let value = |by: f64| shapes.value(place.beside(by)) - 0.5;
    let edge = |side: f64| {
        let (mut by, mut here) = (from, value(from));
        while (by - from).abs() <= most {
            let (next, there) = (by + side * STEP, value(by + side * STEP));
            if !shapes.holds(place.beside(next), 0.0) {
                return None;
            }
            if there < 0.0 {
                return Some(by + side * STEP * here / (here - there));
            }
            (by, here) = (next, there);
        }
        None
    };
    (value(from) >= 0.0).then(|| Some([edge(-1.0)?, edge(1.0)?]))?
}

/// The direction of the pattern at a place minus that of the stroke, degrees, from the structure tensor in a Gaussian
/// window of `radius` px; 90 where the pattern has no direction.
fn deviation(place: &Place, radius: f64, shapes: &Shapes) -> f64 {
    let step = (0.25 * radius).max(0.5);
    let reach = (2.0 * radius / step).ceil() as i32;
    let mut sum = [0.0; 2];
    for row in -reach..=reach {
        for column in -reach..=reach {
            let [dx, dy] = [column, row].map(|k| f64::from(k) * step);
            let weight = libm::exp(-0.5 * (dx * dx + dy * dy) / (radius * radius));
            let at = [place.at[0] + dx, place.at[1] + dy];
            let [gx, gy] = [[0.5, 0.0], [0.0, 0.5]]
                .map(|[x, y]| shapes.value([at[0] + x, at[1] + y]) - shapes.value([at[0] - x, at[1] - y]));
            sum = [sum[0] + weight * (gy * gy - gx * gx), sum[1] - weight * 2.0 * gx * gy];
        }
    }
    if sum == [0.0, 0.0] {
        return 90.0;
    }
    turn(0.5 * libm::atan2(sum[1], sum[0]).to_degrees(), angle(place.along))
}

#[cfg(test)]
mod tests {
    use super::super::shapes::FINE;
    use super::*;
    use dapple_engine::grid::{Edges, Field};

    /// Rings about (−40, 60), a `period` from one to the next, of which `duty` is stripe, on 120 × 120 px; one goes through
    /// (60, 60).
    fn rings(period: f64, duty: f64) -> Shapes {
        let cell = 1.0 / FINE as f64;
        Shapes::find(Field::from_fn([120 * FINE; 2], [cell; 2], Edges::Closed, |point| {
            let phase = (distance(point, [-40.0, 60.0]) - 100.0) / period;
            let apart = (phase - phase.round()).abs() * period;
            (0.5 + 0.2 * (0.5 * duty * period - apart)).clamp(0.0, 1.0) as f32
        }))
    }

    /// An arc of this radius about the same point.
    fn arc(radius: f64, width: f64) -> Path {
        let point = |k: i32| {
            let t = f64::from(k) / 40.0;
            [-40.0 + radius * libm::cos(t), 60.0 + radius * libm::sin(t)]
        };
        Path { points: (-15..=15).map(point).collect(), width }
    }

    #[test]
    fn arcs_that_grew_as_drawn_have_no_errors() {
        let drawn = [arc(88.0, 5.0), arc(100.0, 5.0), arc(112.0, 5.0)];
        for stroke in compare(&drawn, &rings(12.0, 5.0 / 12.0)) {
            assert_eq!(stroke.covered, 1.0);
            assert!(stroke.directions.len() > 10 && stroke.directions.iter().all(|off| off.abs() < 1.5));
            assert!(stroke.width.unwrap().abs() < 0.01, "{stroke:?}");
            assert!(
                !stroke.periods.is_empty() && stroke.periods.iter().all(|off| off.abs() < 0.01),
                "{stroke:?}"
            );
        }
    }

    #[test]
    fn twice_as_many_stripes_as_drawn_halve_the_period() {
        let drawn = [arc(88.0, 5.0), arc(100.0, 5.0), arc(112.0, 5.0)];
        let strokes = compare(&drawn, &rings(6.0, 0.5));
        assert!(
            strokes.iter().all(|stroke| stroke.periods.iter().all(|off| (off + 0.5).abs() < 0.02)),
            "{strokes:?}"
        );
        assert!((strokes[1].width.unwrap() + 0.4).abs() < 0.02, "{strokes:?}");
    }

    #[test]
    fn lone_strokes_have_no_period_and_those_across_the_stripes_are_not_covered() {
        let lone = &compare(&[arc(100.0, 5.0)], &rings(12.0, 0.5))[0];
        assert!(lone.periods.is_empty() && lone.covered == 1.0);
        let across = Path { points: vec![[10.0, 60.0], [110.0, 60.0]], width: 5.0 };
        let across = &compare(&[across], &rings(12.0, 0.5))[0];
        assert!(across.covered < 0.7 && across.directions.iter().all(|off| off.abs() > 80.0), "{across:?}");
    }
}
