//! Curves around discs.

use crate::grid::Edges;
use crate::grid::{Domain, Grid};
use crate::rd::System;
use crate::synth::marks::plan::offset_curves::copies::Copies;
use crate::synth::marks::plan::offset_curves::*;

/// Discs of radius `radius` px about `places`, on cells of half a px.
fn discs(side: usize, edges: Edges, places: &[[f64; 2]], radius: f64) -> (Grid, Vec<bool>) {
    let grid = Grid { size: [2 * side; 2], cell: [0.5; 2], edges };
    let side = side as f64;
    let covers = |cell: usize| {
        places.iter().any(|place| {
            let [dx, dy] = [0, 1].map(|axis| {
                let d = (grid.center_px(cell)[axis] - place[axis]).abs();
                if edges == Edges::Wrap { d.min(side - d) } else { d }
            });
            dx * dx + dy * dy < radius * radius
        })
    };
    let taken = (0..grid.cells()).map(covers).collect();
    (grid, taken)
}

fn lay(kind: CurveKind, grid: &Grid, taken: &[bool], width: f32, broken: f64) -> Result<Curves, CurvesError> {
    let width = vec![width; grid.cells()];
    let laws = System::ALL.into_iter().find_map(|system| system.definition().along_curves).unwrap();
    let request = CurveRequest { kind, laws, obstacles: taken, width: &width, broken, seed: 3 };
    Curves::lay(&request, grid, 1, &|_| 0)
}

fn pieces(set: &[bool], grid: &Grid) -> usize {
    let copies = Copies::connect(set, grid);
    (0..set.len()).filter(|cell| set[*cell] && copies.find(*cell).0 == *cell).count()
}

const FOUR: [[f64; 2]; 4] = [[20.0, 20.0], [60.0, 22.0], [18.0, 58.0], [61.0, 60.0]];

#[test]
fn each_mark_has_a_ring_along_its_outline() {
    let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
    let curves = lay(CurveKind::Rings, &grid, &taken, 4.0, 0.0).unwrap();
    assert_eq!(pieces(&curves.curve, &grid), 4);
    assert!(curves.remarks.is_empty());
    for cell in (0..grid.cells()).filter(|cell| curves.curve[*cell]) {
        let [x, y] = grid.center_px(cell);
        let [cx, cy] =
            FOUR.into_iter().min_by_key(|[cx, cy]| ((x - cx).abs() + (y - cy).abs()) as i64).unwrap();
        let across = libm::atan2(y - cy, x - cx).to_degrees();
        let turned = crate::marks::turn(f64::from(curves.directions[cell].direction), across + 90.0);
        assert!(turned.abs() < 6.0, "{turned} at {x} {y}");
    }
}

#[test]
fn broken_rings_are_pieces_and_another_seed_breaks_them_elsewhere() {
    let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
    let curves = lay(CurveKind::Rings, &grid, &taken, 3.0, 0.4).unwrap();
    assert!((9..=20).contains(&pieces(&curves.curve, &grid)), "{}", pieces(&curves.curve, &grid));
    // Arcs have ends, so that 2 area ÷ contour is too small.
    assert!(curves.width(0, 2.5) > 2.6);
}

#[test]
fn a_web_is_connected_on_a_tile_and_between_closed_edges() {
    for edges in [Edges::Wrap, Edges::Closed] {
        let (grid, taken) = discs(80, edges, &FOUR, 8.0);
        let curves = lay(CurveKind::Web, &grid, &taken, 4.0, 0.0).unwrap();
        assert_eq!(pieces(&curves.curve, &grid), 1, "{edges:?}");
    }
}

#[test]
fn marks_that_are_near_to_each_other_are_surrounded_together() {
    let places = [[20.0, 20.0], [60.0, 20.0], [20.0, 60.0], [60.0, 60.0], [60.0, 43.0]];
    let (grid, taken) = discs(80, Edges::Wrap, &places, 7.0);
    let curves = lay(CurveKind::Web, &grid, &taken, 4.0, 0.0).unwrap();
    assert!(curves.remarks[0].contains("surrounded together"), "{:?}", curves.remarks);
    // Midway between the last two, which are 3 px apart, there is no line; between the others there is one.
    let off = |x: usize, y: usize| curves.distance[2 * y * grid.size[0] + 2 * x];
    assert!(off(60, 51) > 8.0 && off(40, 20) < 2.0, "{} {}", off(60, 51), off(40, 20));
}

#[test]
fn curves_without_room_or_without_marks_are_refused() {
    let (grid, nothing) = discs(40, Edges::Wrap, &[], 1.0);
    for kind in [CurveKind::Rings, CurveKind::Web] {
        assert!(matches!(lay(kind, &grid, &nothing, 4.0, 0.0), Err(CurvesError::Nothing(_))));
        let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
        let refused = lay(kind, &grid, &taken, 20.0, 0.0);
        assert!(matches!(refused, Err(CurvesError::TooNarrow { share, .. }) if share > 0.9));
    }
    let (grid, one) = discs(40, Edges::Closed, &[[20.0, 20.0]], 6.0);
    assert!(matches!(lay(CurveKind::Web, &grid, &one, 4.0, 0.0), Err(CurvesError::Single)));
    assert!(lay(CurveKind::Rings, &grid, &one, 4.0, 0.0).is_ok());
}

#[test]
fn the_level_of_a_curve_follows_the_nearby_peak() {
    let (grid, taken) = discs(80, Edges::Wrap, &FOUR, 8.0);
    let curves = lay(CurveKind::Web, &grid, &taken, 4.0, 0.0).unwrap();
    // A web twice as high on one side as on the other.
    let height = |cell: usize| 0.7 + 0.35 * f64::from(libm::sinf(grid.center_px(cell)[0] as f32 * 0.0785));
    let bell = |cell: usize| libm::exp(-f64::from(curves.distance[cell] * curves.distance[cell]) / 24.0);
    let marks: Vec<f32> = (0..grid.cells()).map(|cell| (height(cell) * bell(cell)) as f32).collect();
    let levelled = curves.levelled(&marks, &grid, &vec![4.0; grid.cells()]);
    for cell in (0..grid.cells()).filter(|cell| curves.distance[*cell] < 0.2) {
        assert!((levelled[cell] - 1.0).abs() < 0.12, "{}", levelled[cell]);
    }
}
