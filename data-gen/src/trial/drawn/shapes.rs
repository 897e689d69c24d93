//! The connected shapes of a grown pattern, counted px by px.
//!
//! This measurement shares no code with the one that corrects and reports a growth. The pattern is resampled to
//! [`FINE`] × [`FINE`] points per px, and each point with a value of at least 0.5 belongs to a shape.

use dapple_engine::grid::Field;
use dapple_engine::marks::Ellipse;

/// Points per px, along each side: with these, an area of 60 px² is exact to 0.5 %.
pub const FINE: usize = 3;
/// Shapes with a smaller area, px², are not marks.
const SPECK: f64 = 4.0;

/// A connected shape.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// The ellipse with its area, centre and second moments.
    pub ellipse: Ellipse,
    /// Its area ÷ that of the ellipse with the same second moments: 1 for ellipses, less for two that grew together.
    pub fill: f64,
    /// Whether it touches the border of the canvas.
    pub cut: bool,
}

/// All shapes of a pattern.
pub struct Shapes {
    /// The shapes.
    pub all: Vec<Shape>,
    /// The share of the canvas that is inside shapes.
    pub share: f64,
    pattern: Field,
    /// The shape of each point, by its place in `all`.
    labels: Vec<Option<u32>>,
}

/// Sums over the points of a shape.
#[derive(Default)]
struct Sums {
    count: f64,
    first: [f64; 2],
    second: [f64; 3],
    cut: bool,
}

impl Shapes {
    /// The shapes of `pattern`, which has [`FINE`] points per px along each side.
    pub fn find(pattern: Field) -> Self {
        let [width, height] = [pattern.width, pattern.height];
        let mut found = vec![false; pattern.values.len()];
        let mut labels = vec![None; pattern.values.len()];
        let mut all = Vec::new();
        let mut inside = 0;
        for start in 0..pattern.values.len() {
            if found[start] || pattern.values[start] < 0.5 {
                continue;
            }
            let (mut sums, mut members, mut next) = (Sums::default(), Vec::new(), vec![start]);
            found[start] = true;
            while let Some(at) = next.pop() {
                let [x, y] = [at % width, at / width];
                sums.add([x, y], [width, height]);
                members.push(at);
                let near = [
                    (x > 0, -1),
                    (x + 1 < width, 1),
                    (y > 0, -(width as isize)),
                    (y + 1 < height, width as isize),
                ];
                for at in near.into_iter().filter(|(on, _)| *on).map(|(_, by)| at.strict_add_signed(by)) {
                    if !found[at] && pattern.values[at] >= 0.5 {
                        found[at] = true;
                        next.push(at);
                    }
                }
            }
            inside += members.len();
            if sums.count * pattern.cell[0] * pattern.cell[1] >= SPECK {
                members.into_iter().for_each(|at| labels[at] = Some(all.len() as u32));
                all.push(sums.shape(pattern.cell));
            }
        }
        let share = inside as f64 / pattern.values.len() as f64;
        Self { all, share, pattern, labels }
    }

    /// The shape at a point of the canvas, px, by its place in `all`.
    pub fn at(&self, point: [f64; 2]) -> Option<u32> {
        let Field { width, height, cell, .. } = self.pattern;
        let [x, y] = [(point[0] / cell[0]) as usize, (point[1] / cell[1]) as usize];
        self.labels[y.min(height - 1) * width + x.min(width - 1)]
    }

    /// The pattern at a point of the canvas, px: linear between the four points around it.
    pub fn value(&self, point: [f64; 2]) -> f64 {
        let Field { width, height, cell, .. } = self.pattern;
        let place = |axis: usize, n: usize| {
            let at = (point[axis] / cell[axis] - 0.5).clamp(0.0, n as f64 - 1.0);
            let low = at as usize;
            (low, (low + 1).min(n - 1), at - low as f64)
        };
        let ((left, right, x), (top, bottom, y)) = (place(0, width), place(1, height));
        let read = |column: usize, row: usize| f64::from(self.pattern.values[row * width + column]);
        (1.0 - y) * ((1.0 - x) * read(left, top) + x * read(right, top))
            + y * ((1.0 - x) * read(left, bottom) + x * read(right, bottom))
    }

    /// Whether a point, px, is on the canvas and at least this far from its border.
    pub fn holds(&self, point: [f64; 2], margin: f64) -> bool {
        let extent = self.pattern.extent();
        (0..2).all(|axis| (margin..=extent[axis] - margin).contains(&point[axis]))
    }
}

impl Sums {
    fn add(&mut self, [x, y]: [usize; 2], [width, height]: [usize; 2]) {
        self.cut |= x == 0 || y == 0 || x + 1 == width || y + 1 == height;
        let [x, y] = [x as f64 + 0.5, y as f64 + 0.5];
        self.count += 1.0;
        self.first = [self.first[0] + x, self.first[1] + y];
        self.second = [self.second[0] + x * x, self.second[1] + x * y, self.second[2] + y * y];
    }

    fn shape(&self, cell: [f64; 2]) -> Shape {
        let [x, y] = self.first.map(|sum| sum / self.count);
        // A point stands for a square of side 1, whose own second moment is 1/12.
        let own = 1.0 / 12.0;
        let xx = (self.second[0] / self.count - x * x + own) * cell[0] * cell[0];
        let xy = (self.second[1] / self.count - x * y) * cell[0] * cell[1];
        let yy = (self.second[2] / self.count - y * y + own) * cell[1] * cell[1];
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let apart = libm::hypot(half, xy);
        let [major, minor] = [mean + apart, (mean - apart).max(f64::MIN_POSITIVE)];
        let angle = (0.5 * libm::atan2(xy, half).to_degrees()).rem_euclid(180.0);
        let area = self.count * cell[0] * cell[1];
        Shape {
            ellipse: Ellipse::from_area([x * cell[0], y * cell[1]], area, (minor / major).sqrt(), angle),
            fill: area / (4.0 * std::f64::consts::PI * (major * minor).sqrt()),
            cut: self.cut,
        }
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use dapple_engine::grid::Edges;

    /// A pattern that is 1 inside these ellipses, on a canvas of 60 × 40 px.
    pub fn of(marks: &[Ellipse]) -> Shapes {
        let cell = 1.0 / FINE as f64;
        let inside = |point| marks.iter().any(|mark| super::super::geometry::contains(mark, point));
        Shapes::find(Field::from_fn([60 * FINE, 40 * FINE], [cell; 2], Edges::Closed, |point| {
            f32::from(u8::from(inside(point)))
        }))
    }

    #[test]
    fn an_ellipse_is_found_with_its_own_measures() {
        let drawn = Ellipse { center: [24.3, 19.8], radii: [12.0, 5.0], angle: 35.0 };
        let shapes = of(&[drawn]);
        let [Shape { ellipse, fill, cut: false }] = shapes.all[..] else { panic!("{:?}", shapes.all) };
        assert!((ellipse.area() / drawn.area() - 1.0).abs() < 0.004);
        assert!((ellipse.aspect() - 5.0 / 12.0).abs() < 0.003 && (ellipse.angle - 35.0).abs() < 0.2);
        assert!(super::super::geometry::distance(ellipse.center, drawn.center) < 0.05);
        assert!((fill - 1.0).abs() < 0.01);
        assert_eq!((shapes.at([24.3, 19.8]), shapes.at([2.0, 2.0])), (Some(0), None));
    }

    #[test]
    fn two_that_touch_are_one_shape_that_fills_less_and_one_at_the_border_is_cut() {
        let disc = |x| Ellipse { center: [x, 20.0], radii: [6.0; 2], angle: 0.0 };
        let shapes = of(&[disc(20.0), disc(31.5), disc(58.0)]);
        assert_eq!(shapes.all.len(), 2);
        assert!(shapes.all.iter().all(|shape| shape.cut == (shape.ellipse.center[0] > 50.0)));
        let together = shapes.all.iter().find(|shape| !shape.cut).unwrap();
        assert!(together.fill < 0.93, "{together:?}");
    }
}
