//! Attributes of several marks as numbers, and the changed marks when another number is typed.

use crate::editor::selection::Place;
use crate::editor::shape;
use crate::marks::{Ellipse, Line, Mark, Path, turn};

/// Marks with their places.
pub type Placed = [(Place, Mark)];

/// Lines within this angle of their mean direction are side by side, degrees.
const PARALLEL: f64 = 30.0;

/// The ellipses among the marks.
pub fn ellipses(marks: &Placed) -> impl Iterator<Item = (Place, Ellipse)> + '_ {
    marks.iter().filter_map(|(place, mark)| Some((*place, mark.ellipse()?)))
}

/// The mean of a property of the ellipses; `None` where there are no ellipses.
fn mean(marks: &Placed, of: impl Fn(&Ellipse) -> f64) -> Option<f64> {
    let values: Vec<f64> = ellipses(marks).map(|(_, ellipse)| of(&ellipse)).collect();
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The mean area of the ellipses, px².
#[must_use]
pub fn area(marks: &Placed) -> Option<f64> {
    mean(marks, Ellipse::area)
}

/// The ellipses scaled about their centres so that their mean area is `area` px².
#[must_use]
pub fn with_area(marks: &Placed, area: f64) -> Vec<(Place, Mark)> {
    let Some(before) = self::area(marks).filter(|before| *before > 0.0 && area > 0.0) else {
        return Vec::new();
    };
    let factor = (area / before).sqrt();
    let scaled = |(place, ellipse): (Place, Ellipse)| {
        (place, shape::scaled(&Mark::Ellipse(ellipse), factor, ellipse.center))
    };
    ellipses(marks).map(scaled).collect()
}

/// The mean aspect of the ellipses.
#[must_use]
pub fn aspect(marks: &Placed) -> Option<f64> {
    mean(marks, Ellipse::aspect)
}

/// The ellipse with this aspect and the same area.
#[must_use]
pub fn ellipse_with_aspect(ellipse: &Ellipse, aspect: f64) -> Ellipse {
    Ellipse::from_area(ellipse.center, ellipse.area(), aspect, ellipse.major_angle())
}

/// The ellipses with this aspect, and with unchanged areas.
#[must_use]
pub fn with_aspect(marks: &Placed, aspect: f64) -> Vec<(Place, Mark)> {
    let changed = |(place, one): (Place, Ellipse)| (place, Mark::Ellipse(ellipse_with_aspect(&one, aspect)));
    ellipses(marks).map(changed).collect()
}

/// The direction of a mark, and its weight in the mean: elongation of an ellipse, length of a line.
fn directed(mark: &Mark) -> (f64, f64) {
    match mark {
        Mark::Ellipse(ellipse) => (ellipse.major_angle(), 1.0 - ellipse.aspect()),
        Mark::Line(line) => (line.angle(), line.length()),
        Mark::Path(path) => {
            let [from, to] =
                [path.points.first(), path.points.last()].map(|end| end.copied().unwrap_or_default());
            let [x, y] = [to[0] - from[0], to[1] - from[1]];
            (y.atan2(x).to_degrees().rem_euclid(180.0), x.hypot(y))
        }
    }
}

/// The axial mean of the directions of the marks, degrees in 0..180; `None` where all are round, or there are none.
#[must_use]
pub fn direction(marks: &Placed) -> Option<f64> {
    let sum = marks.iter().map(|(_, mark)| directed(mark)).fold([0.0; 2], |[x, y], (angle, weight)| {
        let (sin, cos) = (2.0 * angle).to_radians().sin_cos();
        [x + weight * cos, y + weight * sin]
    });
    let is_directed = sum[0].hypot(sum[1]) > 1e-9;
    is_directed.then(|| (0.5 * sum[1].atan2(sum[0]).to_degrees()).rem_euclid(180.0))
}

/// The marks turned about their centres by the same angle, so that their mean direction is `angle` degrees.
#[must_use]
pub fn with_direction(marks: &Placed, angle: f64) -> Vec<(Place, Mark)> {
    let Some(before) = direction(marks) else { return Vec::new() };
    let by = turn(angle, before);
    marks.iter().map(|(place, mark)| (*place, shape::turned(mark, by, shape::center(mark)))).collect()
}

/// The mean distance of each ellipse to its nearest neighbour, from centre to centre, px; `None` for fewer than two
/// ellipses, or where all are at one place.
#[must_use]
pub fn spacing(marks: &Placed) -> Option<f64> {
    let centers: Vec<[f64; 2]> = ellipses(marks).map(|(_, ellipse)| ellipse.center).collect();
    let nearest = |index: usize| {
        let others = centers.iter().enumerate().filter(|(other, _)| *other != index);
        let far = |(_, at): (usize, &[f64; 2])| (at[0] - centers[index][0]).hypot(at[1] - centers[index][1]);
        others.map(far).fold(f64::INFINITY, f64::min)
    };
    let mean = (0..centers.len()).map(nearest).sum::<f64>() / centers.len() as f64;
    (mean.is_finite() && mean > 0.0).then_some(mean)
}

/// The ellipses moved apart or together about the mean of their centres, so that their spacing is `spacing` px.
#[must_use]
pub fn with_spacing(marks: &Placed, spacing: f64) -> Vec<(Place, Mark)> {
    let Some(before) = self::spacing(marks).filter(|_| spacing > 0.0) else { return Vec::new() };
    let factor = spacing / before;
    let all: Vec<(Place, Ellipse)> = ellipses(marks).collect();
    let middle =
        [0, 1].map(|axis| all.iter().map(|(_, one)| one.center[axis]).sum::<f64>() / all.len() as f64);
    let moved = |(place, one): &(Place, Ellipse)| {
        let by = [0, 1].map(|axis| (factor - 1.0) * (one.center[axis] - middle[axis]));
        (*place, shape::moved(&Mark::Ellipse(*one), by))
    };
    all.iter().map(moved).collect()
}

/// The width of a line or path, px.
#[must_use]
pub fn width_of(mark: &Mark) -> Option<f64> {
    match mark {
        Mark::Ellipse(_) => None,
        Mark::Line(line) => Some(line.width),
        Mark::Path(path) => Some(path.width),
    }
}

/// The mean width of the lines, px.
#[must_use]
pub fn width(marks: &Placed) -> Option<f64> {
    let widths: Vec<f64> = marks.iter().filter_map(|(_, mark)| width_of(mark)).collect();
    (!widths.is_empty()).then(|| widths.iter().sum::<f64>() / widths.len() as f64)
}

/// The lines and paths among the marks, with this width, px.
#[must_use]
pub fn with_width(marks: &Placed, width: f64) -> Vec<(Place, Mark)> {
    let with_width = |(place, mark): &(Place, Mark)| match mark {
        Mark::Line(line) => Some((*place, Mark::Line(Line { width, ..*line }))),
        Mark::Path(path) => Some((*place, Mark::Path(Path { width, ..path.clone() }))),
        Mark::Ellipse(_) => None,
    };
    marks.iter().filter_map(with_width).collect()
}

/// Lines and the distance of each centre across their direction, px.
type Across = Vec<(Place, Mark, f64)>;

/// The lines across their mean direction: the unit vector across that direction, and the position of each centre along
/// this vector, px. `None` for fewer than two lines, and where they are not side by side.
fn across(marks: &Placed) -> Option<([f64; 2], Across)> {
    let lines: Vec<(Place, Mark)> =
        marks.iter().filter(|(_, mark)| width_of(mark).is_some()).cloned().collect();
    let mean = direction(&lines).filter(|_| lines.len() > 1)?;
    if lines.iter().any(|(_, mark)| turn(directed(mark).0, mean).abs() > PARALLEL) {
        return None;
    }
    let (sin, cos) = mean.to_radians().sin_cos();
    let normal = [-sin, cos];
    let at = |mark: &Mark| {
        let center = mark.center();
        normal[0] * center[0] + normal[1] * center[1]
    };
    Some((normal, lines.into_iter().map(|(place, mark)| (place, mark.clone(), at(&mark))).collect()))
}

/// The mean distance of lines side by side, from the middle of one to the middle of the next, px; `None` for fewer than
/// two such lines.
#[must_use]
pub fn period(marks: &Placed) -> Option<f64> {
    let (_, lines) = across(marks)?;
    // Pieces of one stripe that lie one behind the other are not neighbours.
    let same = 0.5 * width(marks)?;
    let mut offsets: Vec<f64> = lines.iter().map(|(_, _, at)| *at).collect();
    offsets.sort_by(f64::total_cmp);
    let gaps: Vec<f64> = offsets.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > same).collect();
    (!gaps.is_empty()).then(|| gaps.iter().sum::<f64>() / gaps.len() as f64)
}

/// The lines moved across their direction, about their middle, so that their period is `period` px.
#[must_use]
pub fn with_period(marks: &Placed, period: f64) -> Vec<(Place, Mark)> {
    let Some(before) = self::period(marks).filter(|_| period > 0.0) else { return Vec::new() };
    let Some((normal, lines)) = across(marks) else { return Vec::new() };
    let middle = lines.iter().map(|(_, _, at)| at).sum::<f64>() / lines.len() as f64;
    let moved = |(place, mark, at): &(Place, Mark, f64)| {
        let by = (period / before - 1.0) * (at - middle);
        (*place, shape::moved(mark, normal.map(|part| by * part)))
    };
    lines.iter().map(moved).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(marks: impl IntoIterator<Item = Mark>) -> Vec<(Place, Mark)> {
        let place = |stroke| Place { layer: 0, stroke };
        marks.into_iter().enumerate().map(|(stroke, mark)| (place(stroke), mark)).collect()
    }

    fn spots() -> Vec<(Place, Mark)> {
        let spot = |x: f64, radius: f64| {
            Mark::Ellipse(Ellipse { center: [x, 50.0], radii: [radius, 0.5 * radius], angle: 20.0 })
        };
        placed([spot(100.0, 10.0), spot(140.0, 12.0), spot(180.0, 8.0)])
    }

    /// Lines at 30°, 20 px apart, one of them in two pieces.
    fn lines() -> Vec<(Place, Mark)> {
        let (sin, cos) = 30f64.to_radians().sin_cos();
        let at = |along: f64, across: f64| {
            [200.0 + along * cos - across * sin, 200.0 + along * sin + across * cos]
        };
        let line = |from: f64, to: f64, across: f64| {
            Mark::Line(Line { from: at(from, across), to: at(to, across), width: 6.0 })
        };
        placed([
            line(-80.0, 80.0, 0.0),
            line(-80.0, -10.0, 20.0),
            line(10.0, 80.0, 20.0),
            line(-80.0, 80.0, 40.0),
        ])
    }

    #[test]
    fn marks_follow_each_number_that_is_typed_and_keep_the_others() {
        let marks = spots();
        let near = |a: Option<f64>, b: f64| assert!((a.unwrap() - b).abs() < 1e-9, "{a:?} {b}");
        let larger = with_area(&marks, 400.0);
        near(area(&larger), 400.0);
        near(aspect(&larger), 0.5);
        let rounder = with_aspect(&marks, 0.8);
        near(aspect(&rounder), 0.8);
        near(area(&rounder), area(&marks).unwrap());
        let turned = with_direction(&marks, 65.0);
        near(direction(&turned), 65.0);
        near(spacing(&turned), 40.0);
        let apart = with_spacing(&marks, 50.0);
        near(spacing(&apart), 50.0);
        assert_eq!(apart[1].1, marks[1].1, "the one in the middle stays");
        assert!(period(&marks).is_none() && width(&marks).is_none());
    }

    #[test]
    fn the_period_of_lines_is_the_distance_of_those_side_by_side() {
        let marks = lines();
        assert!((period(&marks).unwrap() - 20.0).abs() < 1e-9, "{:?}", period(&marks));
        assert!((direction(&marks).unwrap() - 30.0).abs() < 1e-9);
        let wider = with_period(&marks, 26.0);
        assert!((period(&wider).unwrap() - 26.0).abs() < 1e-9);
        assert!((direction(&wider).unwrap() - 30.0).abs() < 1e-9);
        assert_eq!(width(&with_width(&marks, 9.0)), Some(9.0));
        assert!(spacing(&marks).is_none());
        let crossing = Mark::Line(Line { from: [200.0, 100.0], to: [150.0, 300.0], width: 6.0 });
        let with_crossing: Vec<_> = marks.iter().map(|(_, mark)| mark.clone()).chain([crossing]).collect();
        assert!(period(&placed(with_crossing)).is_none(), "they are not side by side");
    }

    #[test]
    fn invalid_numbers_change_nothing() {
        assert!(with_area(&spots(), -1.0).is_empty() && with_spacing(&spots(), 0.0).is_empty());
        assert!(with_area(&lines(), 100.0).is_empty() && with_period(&spots(), 10.0).is_empty());
        assert!(direction(&[]).is_none() && spacing(&[]).is_none() && period(&[]).is_none());
    }
}
