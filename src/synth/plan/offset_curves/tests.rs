//! Courses round discs.

use crate::grid::Edges;
use crate::synth::plan::offset_curves::copies::Copies;
use crate::synth::plan::offset_curves::*;

/// Discs of radius `radius` px about `places`, on cells of half a px.
fn discs(side: usize, edges: Edges, places: &[[f64; 2]], radius: f64) -> (Grid, Vec<bool>) {
    let grid = Grid { size: [2 * side; 2], cell: [0.5; 2], edges };
    let side = side as f64;
    let covers = |cell: usize| {
        places.iter().any(|place| {
            let [dx, dy] = [0, 1].map(|axis| {
                let d = (grid.middle(cell)[axis] - place[axis]).abs();
                if edges == Edges::Wrap { d.min(side - d) } else { d }
            });
            dx * dx + dy * dy < radius * radius
        })
    };
    let taken = (0..grid.cells()).map(covers).collect();
    (grid, taken)
}

fn lay(way: Way, grid: &Grid, taken: &[bool], width: f32, broken: f64) -> Result<Course, CourseError> {
    let width = vec![width; grid.cells()];
    Course::lay(&Wanted { way, taken, width: &width, broken, seed: 3 }, grid, 1, &|_| 0)
}

fn pieces(set: &[bool], grid: &Grid) -> usize {
    let copies = Copies::of(set, grid);
    (0..set.len()).filter(|cell| set[*cell] && copies.find(*cell).0 == *cell).count()
}

const FOUR: [[f64; 2]; 4] = [[20.0, 20.0], [60.0, 22.0], [18.0, 58.0], [61.0, 60.0]];

#[test]
fn a_ring_runs_round_each_mark_along_its_outline() {
    let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
    let course = lay(Way::Rings, &grid, &taken, 4.0, 0.0).unwrap();
    assert_eq!(pieces(&course.curve, &grid), 4);
    assert!(course.remarks.is_empty());
    for cell in (0..grid.cells()).filter(|cell| course.curve[*cell]) {
        let [x, y] = grid.middle(cell);
        let [cx, cy] =
            FOUR.into_iter().min_by_key(|[cx, cy]| ((x - cx).abs() + (y - cy).abs()) as i64).unwrap();
        let across = libm::atan2(y - cy, x - cx).to_degrees();
        let turned = crate::marks::turn(f64::from(course.along[cell].direction), across + 90.0);
        assert!(turned.abs() < 6.0, "{turned} at {x} {y}");
    }
}

#[test]
fn broken_rings_are_pieces_and_another_seed_breaks_them_elsewhere() {
    let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
    let course = lay(Way::Rings, &grid, &taken, 3.0, 0.4).unwrap();
    assert!((9..=20).contains(&pieces(&course.curve, &grid)), "{}", pieces(&course.curve, &grid));
    // Arcs have ends: 2 area ÷ contour reads too little.
    assert!(course.width(0, 2.5) > 2.6);
}

#[test]
fn a_web_is_one_on_a_tile_and_between_walls() {
    for edges in [Edges::Wrap, Edges::Closed] {
        let (grid, taken) = discs(80, edges, &FOUR, 8.0);
        let course = lay(Way::Web, &grid, &taken, 4.0, 0.0).unwrap();
        assert_eq!(pieces(&course.curve, &grid), 1, "{edges:?}");
    }
}

#[test]
fn marks_that_are_near_to_each_other_are_surrounded_together() {
    let places = [[20.0, 20.0], [60.0, 20.0], [20.0, 60.0], [60.0, 60.0], [60.0, 43.0]];
    let (grid, taken) = discs(80, Edges::Wrap, &places, 7.0);
    let course = lay(Way::Web, &grid, &taken, 4.0, 0.0).unwrap();
    assert!(course.remarks[0].contains("surrounded together"), "{:?}", course.remarks);
    // Midway between the last two, 3 px apart, runs nothing; between the others something does.
    let off = |x: usize, y: usize| course.off[2 * y * grid.size[0] + 2 * x];
    assert!(off(60, 51) > 8.0 && off(40, 20) < 2.0, "{} {}", off(60, 51), off(40, 20));
}

#[test]
fn what_has_no_room_or_nothing_to_go_round_is_refused() {
    let (grid, nothing) = discs(40, Edges::Wrap, &[], 1.0);
    for way in [Way::Rings, Way::Web] {
        assert!(matches!(lay(way, &grid, &nothing, 4.0, 0.0), Err(CourseError::Nothing(_))));
        let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
        let refused = lay(way, &grid, &taken, 20.0, 0.0);
        assert!(matches!(refused, Err(CourseError::TooNarrow { share, .. }) if share > 0.9));
    }
    let (grid, one) = discs(40, Edges::Closed, &[[20.0, 20.0]], 6.0);
    assert!(matches!(lay(Way::Web, &grid, &one, 4.0, 0.0), Err(CourseError::Single)));
    assert!(lay(Way::Rings, &grid, &one, 4.0, 0.0).is_ok());
}

#[test]
fn a_course_is_levelled_to_the_peak_nearby() {
    let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
    let course = lay(Way::Web, &grid, &taken, 4.0, 0.0).unwrap();
    // A web twice as high on one side as on the other.
    let height = |cell: usize| 0.7 + 0.35 * f64::from(libm::sinf(grid.middle(cell)[0] as f32 * 0.0785));
    let bell = |cell: usize| libm::exp(-f64::from(course.off[cell] * course.off[cell]) / 24.0);
    let marks: Vec<f32> = (0..grid.cells()).map(|cell| (height(cell) * bell(cell)) as f32).collect();
    let levelled = course.levelled(&marks, &grid, &vec![4.0; grid.cells()]);
    for cell in (0..grid.cells()).filter(|cell| course.off[*cell] < 0.2) {
        assert!((levelled[cell] - 1.0).abs() < 0.12, "{}", levelled[cell]);
    }
}
