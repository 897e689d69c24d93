//! Lines that represent the stripes of a photograph in a sketch.
//!
//! For a region: three straight lines side by side, with its width, direction and period. For all marks: the centre line of each
//! band, followed along the local direction.

use super::representatives::Bounds;
use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::marks::Path;
use crate::measure::Directions;

/// The mean stripes of a region.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    /// Width of the lines, px.
    pub width: f64,
    /// Direction of the lines, degrees.
    pub angle: f64,
    /// Distance from one line to the next, px.
    pub period: f64,
}

/// Length of a region's lines, in periods: long enough to show a direction.
const LONG: f64 = 3.0;
/// Longest lines of a region, as a share of its shorter side.
const MOST: f64 = 0.6;

/// Three lines side by side in the middle of a region; one if three do not fit. The middle one lies on a stripe.
#[must_use]
pub fn of_region(field: &Field, band: Band, bounds: Bounds) -> Vec<Path> {
    let surface = Spline::new(field);
    let sides = [0, 1].map(|k| bounds.high[k] - bounds.low[k]);
    let shorter = sides[0].min(sides[1]);
    let (sin, cos) = libm::sincos(band.angle.to_radians());
    let middle = [0, 1].map(|k| 0.5 * (bounds.low[k] + bounds.high[k]));
    let across = |place: [f64; 2], by: f64| [place[0] - by * sin, place[1] + by * cos];
    // The middle of a stripe: where the pattern is highest within half a period on either side.
    let steps = (-STEPS..=STEPS).map(|step| 0.5 * band.period * f64::from(step) / f64::from(STEPS));
    let high = |by: &f64| surface.at(across(middle, *by));
    let on = steps.max_by(|a, b| high(a).total_cmp(&high(b))).unwrap_or(0.0);
    let count = if 2.4 * band.period <= shorter { 1 } else { 0 };
    let half = 0.5 * (LONG * band.period).min(MOST * shorter);
    (-count..=count)
        .map(|k| {
            let center = across(middle, on + f64::from(k) * band.period);
            let center = [0, 1].map(|k| center[k].clamp(bounds.low[k], bounds.high[k]));
            let end = |by: f64| [center[0] + by * cos, center[1] + by * sin];
            Path { points: vec![end(-half), end(half)], width: band.width }
        })
        .collect()
}

/// Number of places on either side at which the pattern is compared.
const STEPS: i32 = 16;

/// A step along a band, in wavelengths.
const STEP: f64 = 0.2;
/// Largest distance by which a line is moved back to the middle of its band, on either side, in wavelengths.
const ASIDE: f64 = 0.22;
/// Least distance of centre lines, in wavelengths; closer ones follow the same band.
const APART: f64 = 0.4;
/// Least length of a line, in wavelengths; shorter ones are no bands.
const SHORTEST: f64 = 0.8;
/// Points whose removal moves the line by less than this are left out, in wavelengths.
const TOLERANCE: f64 = 0.03;
/// Most steps of one line: enough to go around a large picture many times.
const MOST_STEPS: usize = 20_000;

/// The centre lines of all bands above `level`; `width` gives their width at a place, px.
#[must_use]
pub fn all(field: &Field, level: f32, wavelength: f64, width: impl Fn([f64; 2]) -> f64) -> Vec<Path> {
    let mut tracer = Tracer::new(field, level, wavelength);
    let extent = field.extent();
    let seeds = extent.map(|side| (side / (STEP * wavelength)).ceil().max(1.0) as usize);
    let mut paths = Vec::new();
    for seed in 0..seeds[0] * seeds[1] {
        let place = [(seed % seeds[0]) as f64 + 0.5, (seed / seeds[0]) as f64 + 0.5];
        let place = [0, 1].map(|k| place[k] * extent[k] / seeds[k] as f64);
        if let Some(points) = tracer.trace(place) {
            let path = Path { points, width: 1.0 }.simplified(TOLERANCE * wavelength);
            let width = width(path.center());
            paths.push(Path { width, ..path });
        }
    }
    paths
}

/// Follows bands.
struct Tracer {
    surface: Spline,
    extent: [f64; 2],
    level: f32,
    wavelength: f64,
    /// (cos 2θ, sin 2θ) of the local direction, on a lattice.
    directions: Vec<[f64; 2]>,
    lattice: [usize; 2],
    /// Points of the lines so far, by square.
    taken: Vec<Vec<[f64; 2]>>,
}

impl Tracer {
    fn new(field: &Field, level: f32, wavelength: f64) -> Self {
        let extent = field.extent();
        // Squares of half a wavelength: directions change over longer distances.
        let lattice = extent.map(|side| (2.0 * side / wavelength).ceil().max(1.0) as usize);
        let directions = Directions::measure(field, wavelength);
        let square = |point: [f64; 2]| square(point, extent, lattice);
        let places = directions.at_places(|point| (square(point), [1.0, 0.0]));
        let means = directions.means(&places, lattice[0] * lattice[1]);
        let vector = |angle: Option<f64>| {
            let (sin, cos) = libm::sincos(2.0 * angle.unwrap_or(0.0).to_radians());
            angle.map_or([0.0; 2], |_| [cos, sin])
        };
        let directions = means.into_iter().map(vector).collect();
        let taken = vec![Vec::new(); lattice[0] * lattice[1]];
        Self { surface: Spline::new(field), extent, level, wavelength, directions, lattice, taken }
    }

    /// The line through the band at `place`; `None` if there is no band, or one that has been followed already.
    fn trace(&mut self, place: [f64; 2]) -> Option<Vec<[f64; 2]>> {
        if self.surface.at(place) <= self.level {
            return None;
        }
        let start = self.centered(place, self.direction(place))?;
        if self.is_taken(start) {
            return None;
        }
        let along = self.direction(start);
        let mut points = self.followed(start, [-along[0], -along[1]]);
        points.reverse();
        points.pop();
        points.extend(self.followed(start, along));
        let long = Path { points: points.clone(), width: 1.0 }.length() >= SHORTEST * self.wavelength;
        if !long || points.len() < 2 {
            return None;
        }
        for point in &points {
            self.taken[square(*point, self.extent, self.lattice)].push(*point);
        }
        Some(points)
    }

    /// Points from `start` on, towards `heading`, until the band ends, leaves the canvas or meets a line.
    fn followed(&self, start: [f64; 2], mut heading: [f64; 2]) -> Vec<[f64; 2]> {
        let mut points = vec![start];
        let mut at = start;
        let step = STEP * self.wavelength;
        while points.len() < MOST_STEPS {
            let next = [0, 1].map(|k| at[k] + step * heading[k]);
            let mut along = self.direction(next);
            if along[0] * heading[0] + along[1] * heading[1] < 0.0 {
                along = along.map(|x| -x);
            }
            let inside = (0..2).all(|k| (0.0..=self.extent[k]).contains(&next[k]));
            let Some(next) = self.centered(next, along).filter(|_| inside) else { break };
            // Back at the start: a ring.
            let back = points.len() > 6 && distance(next, start) < step;
            if self.is_taken(next) || back {
                points.extend(back.then_some(start));
                break;
            }
            let way = [0, 1].map(|k| next[k] - at[k]);
            let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
            // Turned back at a fork or an end.
            if length < 0.3 * step || way[0] * heading[0] + way[1] * heading[1] <= 0.0 {
                break;
            }
            points.push(next);
            (at, heading) = (next, along);
        }
        points
    }

    /// The middle of the band across `along` at `place`; `None` outside of bands.
    fn centered(&self, place: [f64; 2], along: [f64; 2]) -> Option<[f64; 2]> {
        let (mut sum, mut weight) = (0.0, 0.0);
        for step in -STEPS / 2..=STEPS / 2 {
            let by = ASIDE * self.wavelength * f64::from(2 * step) / f64::from(STEPS);
            let above =
                f64::from(self.surface.at([place[0] - by * along[1], place[1] + by * along[0]]) - self.level);
            sum += by * above.max(0.0);
            weight += above.max(0.0);
        }
        (weight > 0.0).then(|| [place[0] - sum / weight * along[1], place[1] + sum / weight * along[0]])
    }

    /// The unit vector along the bands: that of the square, blended with those of its neighbours.
    fn direction(&self, place: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|k| (place[k] / self.extent[k] * self.lattice[k] as f64 - 0.5).max(0.0));
        let (left, top) = ((x as usize).min(self.lattice[0] - 1), (y as usize).min(self.lattice[1] - 1));
        let (right, bottom) = ((left + 1).min(self.lattice[0] - 1), (top + 1).min(self.lattice[1] - 1));
        let (u, v) = ((x - left as f64).min(1.0), (y - top as f64).min(1.0));
        let mut sum = [0.0; 2];
        for (column, row, weight) in [
            (left, top, (1.0 - u) * (1.0 - v)),
            (right, top, u * (1.0 - v)),
            (left, bottom, (1.0 - u) * v),
            (right, bottom, u * v),
        ] {
            let [c, s] = self.directions[row * self.lattice[0] + column];
            sum = [sum[0] + weight * c, sum[1] + weight * s];
        }
        let (sin, cos) = libm::sincos(0.5 * libm::atan2(sum[1], sum[0]));
        [cos, sin]
    }

    /// Whether another line passes near.
    fn is_taken(&self, place: [f64; 2]) -> bool {
        let at = square(place, self.extent, self.lattice);
        let (x, y) = ((at % self.lattice[0]) as isize, (at / self.lattice[0]) as isize);
        (0..9).any(|k| {
            let (x, y) = (x + k % 3 - 1, y + k / 3 - 1);
            let inside = x >= 0 && y >= 0 && x < self.lattice[0] as isize && y < self.lattice[1] as isize;
            inside && {
                let points = &self.taken[y as usize * self.lattice[0] + x as usize];
                points.iter().any(|point| distance(*point, place) < APART * self.wavelength)
            }
        })
    }
}

/// The square of a lattice that a point lies in.
fn square(point: [f64; 2], extent: [f64; 2], lattice: [usize; 2]) -> usize {
    let [x, y] =
        [0, 1].map(|k| ((point[k] / extent[k] * lattice[k] as f64).max(0.0) as usize).min(lattice[k] - 1));
    y * lattice[0] + x
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [x, y] = [0, 1].map(|k| a[k] - b[k]);
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::{axial, turn};

    /// The axial direction from end to end, degrees.
    fn chord(path: &Path) -> f64 {
        let (a, b) = (path.points[0], path.points[path.points.len() - 1]);
        axial(libm::atan2(b[1] - a[1], b[0] - a[0]).to_degrees())
    }

    /// Stripes of 8 px every 20 px along 30°.
    fn stripes() -> Field {
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        Field::from_fn([240, 200], [1.0; 2], Edges::Closed, |[x, y]| {
            let out = ((y * cos - x * sin).rem_euclid(20.0) - 10.0).abs();
            (0.5 + 0.5 * (4.0 - out)).clamp(0.0, 1.0) as f32
        })
    }

    #[test]
    fn a_region_gets_three_lines_on_its_stripes() {
        let field = stripes();
        let bounds = Bounds { low: [0.0; 2], high: [240.0, 200.0] };
        let lines = of_region(&field, Band { width: 8.0, angle: 30.0, period: 20.0 }, bounds);
        assert_eq!(lines.len(), 3);
        for line in &lines {
            assert!(turn(chord(line), 30.0).abs() < 1e-9);
            assert!(Spline::new(&field).at(line.center()) > 0.9, "{line:?}");
        }
    }

    #[test]
    fn each_band_is_followed_from_end_to_end_once() {
        let paths = all(&stripes(), 0.5, 20.0, |_| 8.0);
        // The diagonal across the stripes is 240·sin 30° + 200·cos 30° = 293 px long: 14 or 15 of them.
        assert!((13..=16).contains(&paths.len()), "{}", paths.len());
        for path in &paths {
            // At the border, where values are mirrored, ends are bent.
            assert!(path.length() < 80.0 || turn(chord(path), 30.0).abs() < 1.5, "{path:?}");
        }
        let length: f64 = paths.iter().map(Path::length).sum();
        assert!((length / (240.0 * 200.0 / 20.0) - 1.0).abs() < 0.06, "{length}");
    }
}
