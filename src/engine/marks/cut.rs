//! Marks cut at the sides of a rectangle.

use super::{Ellipse, Line, Mark, Path};

impl Mark {
    /// The mark without what of it lies beyond the rectangle from `low` to `high`, px: a line is cut there, a path goes along its
    /// border, an ellipse has its centre in it. A line that lies wholly beyond goes along the border, too.
    #[must_use]
    pub fn cut(self, [low, high]: [[f64; 2]; 2]) -> Self {
        let nearest = |point: [f64; 2]| [0, 1].map(|axis| point[axis].clamp(low[axis], high[axis]));
        let is_inside = |point: &[f64; 2]| nearest(*point) == *point;
        match self {
            Self::Ellipse(ellipse) => Self::Ellipse(Ellipse { center: nearest(ellipse.center), ..ellipse }),
            Self::Line(line) if ![line.from, line.to].iter().all(is_inside) => {
                let points = broken([line.from, line.to], [low, high]);
                let middle = |pair: &[[f64; 2]]| [0, 1].map(|axis| 0.5 * (pair[0][axis] + pair[1][axis]));
                let mut inside = points.windows(2).filter(|pair| is_inside(&middle(pair)));
                let first = inside.next();
                let last = inside.next_back().or(first);
                let ends = first.zip(last).map_or([line.from, line.to], |(first, last)| [first[0], last[1]]);
                let [from, to] = ends.map(nearest);
                Self::Line(Line { from, to, ..line })
            }
            Self::Path(path) if !path.points.iter().all(is_inside) => {
                let pieces = path.points.windows(2).flat_map(|pair| broken([pair[0], pair[1]], [low, high]));
                let mut points: Vec<[f64; 2]> = pieces.map(nearest).collect();
                points.dedup();
                Self::Path(Path { points, ..path })
            }
            Self::Line(_) | Self::Path(_) => self,
        }
    }
}

/// The ends of a segment, and between them the points at which one of its coordinates is that of a side.
fn broken([from, to]: [[f64; 2]; 2], sides: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let mut shares = vec![0.0, 1.0];
    for axis in 0..2 {
        let share = |side: [f64; 2]| (side[axis] - from[axis]) / (to[axis] - from[axis]);
        shares.extend(sides.map(share).into_iter().filter(|share| *share > 0.0 && *share < 1.0));
    }
    shares.sort_by(f64::total_cmp);
    shares.iter().map(|share| [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDES: [[f64; 2]; 2] = [[-100.0, -100.0], [200.0, 200.0]];

    #[test]
    fn a_line_keeps_its_direction_where_it_is_cut() {
        let line = |from, to| Mark::Line(Line { from, to, width: 4.0 });
        let cut = line([-300.0, -260.0], [50.0, 90.0]).cut(SIDES);
        assert_eq!(cut, line([-100.0, -60.0], [50.0, 90.0]));
        let through = line([-300.0, 0.0], [300.0, 100.0]).cut(SIDES);
        let Mark::Line(through) = through else { panic!("a line stays a line") };
        assert_eq!((through.from[0], through.to[0]), (-100.0, 200.0));
        assert!((through.from[1] - 100.0 / 3.0).abs() < 1e-9 && (through.to[1] - 250.0 / 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_path_goes_along_the_border_where_it_is_beyond_and_comes_back_where_it_was_drawn() {
        let round = vec![[50.0, 50.0], [-400.0, 50.0], [-400.0, 500.0], [50.0, 500.0], [50.0, 90.0]];
        let Mark::Path(path) = Mark::Path(Path { points: round, width: 4.0 }).cut(SIDES) else {
            panic!("a path stays a path")
        };
        let cut = [[50.0, 50.0], [-100.0, 50.0], [-100.0, 200.0], [50.0, 200.0], [50.0, 90.0]];
        assert_eq!(path.points, cut);
    }
}
