//! Lines of points: ragged streaks along a direction, and nets of cracks (after the paper's figures 23, and 19 and 20).
//!
//! 1. Poisson discs whose radius follows from the wanted width (or period) at their place.
//! 2. Streaks: chains along the direction ([`streaks()`]). Cracks: coarse discs are the knots of a net, and the fine points on the
//!    shortest paths between neighbouring knots are dark ([`net()`]).
//! 3. Labels 0 and 1, interpolated with L = 1.2. The level determines the share of the canvas that the lines cover, and the scale
//!    of all discs their width; the caller finds both.

mod description;
mod laid;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::centers::largest;
use super::delaunay::Delaunay;
use super::discs::{Laying, poisson_discs};
use super::extent::Extent;
use super::labels::{net, streaks};
use super::metric::Metric;
use crate::grid::{Field, Grid};
pub use description::{CRACKS, STREAKS};
pub use laid::LaidLines;
use laid::middles;

/// The wanted properties of the lines around a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WantedLines {
    /// Width, px.
    pub width: f64,
    /// The share of the canvas that they cover, 0..1.
    pub share: f64,
    /// Direction, degrees; not used for cracks.
    pub angle: f64,
}

/// The kind of lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Along the wanted direction, with this number of points each.
    Streaks(f64),
    /// Round the meshes of a net.
    Cracks,
}

/// Lines over a canvas.
pub struct Lines<'a> {
    /// The canvas and the cells of the field.
    pub grid: Grid,
    /// The wanted lines at a place, px, also beyond a closed border.
    pub wanted: &'a (dyn Fn([f64; 2]) -> WantedLines + Sync),
    /// Places, px, where no line may be: the places of the layers beneath.
    pub blocked: Option<&'a (dyn Fn([f64; 2]) -> bool + Sync)>,
    /// The kind of lines.
    pub course: Course,
    /// Factor of the radii of all discs.
    pub scale: f64,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Period of streaks ÷ radius of their points, if streaks cover `.45`: one row of light points lies between two chains.
const PERIOD: f64 = 2.7;
/// Width of cracks ÷ radius of their points: for single lines, and the increase by knots for a covered share of 1 (1.28–1.66 at
/// shares of .14–.39).
const CRACK: [f64; 2] = [1.1, 1.4];
/// Radius of the knots' discs × share ÷ radius of the points, at the level ½ (2.45–1.97 at shares of .14–.39).
const MESH: f64 = 2.2;
/// Least clearance at which neighbouring knots are joined: the net is then a quarter shorter than the net of all triangles, and
/// some meshes have four and five sides.
const JOINED: f64 = 0.3;
/// One of this number of knots is a start of the cracks in a film. With fewer starts the canvas is half empty for most of the film;
/// with more it fills everywhere at the same time.
const KNOTS_A_START: usize = 12;
/// Width of the frame beyond closed borders, in radii of the points of streaks, or of the knots.
const FRAMES: [f64; 2] = [6.0, 2.0];

impl Lines<'_> {
    /// The interpolated labels, 0..1: lines above a level.
    #[must_use]
    pub fn field(&self) -> Field {
        self.laid().field(&self.grid)
    }

    /// The labelled points of the lines.
    #[must_use]
    pub fn laid(&self) -> LaidLines {
        let extent = Extent::from(self.grid.bounds_px());
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed);
        let (fine, frame) = (|at: [f64; 2]| self.fine(at), self.frame(&extent));
        let is_blocked = |at: [f64; 2]| self.blocked.is_some_and(|blocked| blocked(at));
        match self.course {
            Course::Streaks(points) => {
                let graph = Delaunay::new(&poisson_discs(&extent, frame, &fine, &[], &mut rng), extent);
                let size = |at: [f64; 2]| if is_blocked(at) { 0 } else { points.round() as usize };
                let owner = streaks(&graph, size, |at| (self.wanted)(at).angle, &mut rng);
                let values = owner.iter().map(|owner| f32::from(u8::from(owner.is_some()))).collect();
                LaidLines { starts: middles(&graph, &owner), graph, values }
            }
            Course::Cracks => {
                let coarse = |at: [f64; 2]| Metric::circle(self.mesh(&(self.wanted)(at)));
                let knots = poisson_discs(&extent, frame, &coarse, &[], &mut rng);
                let points = poisson_discs(&extent, frame, &fine, &knots, &mut rng);
                let graph = Delaunay::new(&points, extent);
                let ends: Vec<usize> = (0..knots.len()).collect();
                let dark = net(&graph, &ends, JOINED);
                let value = |(at, dark): (&[f64; 2], bool)| f32::from(u8::from(dark && !is_blocked(*at)));
                let values = graph.points.iter().zip(dark).map(value).collect();
                LaidLines { starts: ends.into_iter().step_by(KNOTS_A_START).collect(), graph, values }
            }
        }
    }

    /// The cost of laying the points.
    #[must_use]
    pub fn laying(&self) -> Laying {
        let extent = Extent::from(self.grid.bounds_px());
        Laying::new(&extent, self.frame(&extent), &|at| self.fine(at))
    }

    /// The disc of a point at a place, px.
    fn fine(&self, at: [f64; 2]) -> Metric {
        Metric::circle(self.radius(&(self.wanted)(at)))
    }

    /// Width of the frame beyond closed borders, px.
    fn frame(&self, extent: &Extent) -> f64 {
        match self.course {
            Course::Streaks(_) => FRAMES[0] * largest(extent, self.wanted, |wanted| self.radius(wanted)),
            Course::Cracks => FRAMES[1] * largest(extent, self.wanted, |wanted| self.mesh(wanted)),
        }
    }

    fn radius(&self, wanted: &WantedLines) -> f64 {
        self.scale * radius(self.course, wanted)
    }

    fn mesh(&self, wanted: &WantedLines) -> f64 {
        self.scale * mesh(wanted)
    }
}

/// Radius of the discs for such lines, px.
#[must_use]
pub fn radius(course: Course, wanted: &WantedLines) -> f64 {
    match course {
        Course::Streaks(_) => wanted.width / wanted.share / PERIOD,
        Course::Cracks => wanted.width / (CRACK[0] + CRACK[1] * wanted.share),
    }
}

/// Radius of the discs of the knots for such cracks, px.
#[must_use]
pub fn mesh(wanted: &WantedLines) -> f64 {
    radius(Course::Cracks, wanted) * MESH / wanted.share
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::points::level::relevel;

    fn grown(course: Course, share: f64) -> (Field, f32) {
        let wanted = |_| WantedLines { width: 8.0, share, angle: 30.0 };
        let grid = Grid::unit([240, 200], Edges::Wrap);
        let lines = Lines { grid, wanted: &wanted, blocked: None, course, scale: 1.0, seed: 4 };
        let mut field = lines.field();
        let level = relevel(&mut field, share);
        (field, level)
    }

    #[test]
    fn lines_of_a_usual_share_are_cut_near_the_middle() {
        for (course, share) in [(Course::Streaks(24.0), 0.4), (Course::Cracks, 0.25)] {
            let (_, level) = grown(course, share);
            assert!((level - 0.5).abs() < 0.2, "{course:?} {share}: {level}");
        }
    }

    /// Number of steps between differing cells, along x and along y.
    fn steps(field: &Field) -> [usize; 2] {
        let above = |x: usize, y: usize| field.get(x as isize, y as isize) > 0.5;
        let cells = (0..field.height).flat_map(|y| (0..field.width).map(move |x| (x, y)));
        cells.fold([0, 0], |[across, down], (x, y)| {
            let differ = |x2, y2| usize::from(above(x, y) != above(x2, y2));
            [across + differ(x + 1, y), down + differ(x, y + 1)]
        })
    }

    #[test]
    fn streaks_run_along_their_direction_and_cracks_along_none() {
        // For straight lines at 30° the ratio is tan 30° = .58.
        let ratio = |[across, down]: [usize; 2]| across as f64 / down as f64;
        let streaks = ratio(steps(&grown(Course::Streaks(24.0), 0.4).0));
        let cracks = ratio(steps(&grown(Course::Cracks, 0.2).0));
        assert!(streaks < 0.8 && (0.8..1.25).contains(&cracks), "{streaks}, {cracks}");
    }

    #[test]
    fn no_line_lies_where_it_is_blocked() {
        for course in [Course::Streaks(24.0), Course::Cracks] {
            let wanted = |_| WantedLines { width: 6.0, share: 0.3, angle: 0.0 };
            let blocked = |at: [f64; 2]| at[0] > 100.0;
            let grid = Grid::unit([200, 120], Edges::Closed);
            let lines = Lines { grid, wanted: &wanted, blocked: Some(&blocked), course, scale: 1.0, seed: 4 };
            let field = lines.field();
            let most = |from: usize, to: usize| {
                let rows = field.values.chunks(200);
                rows.flat_map(|row| &row[from..to]).copied().fold(0.0, f32::max)
            };
            assert!(most(125, 200) == 0.0, "{course:?}");
        }
    }
}
