//! Free marks: when a mark is moved, spots far from it stay in their places.

use dapple::document::{Document, Layer, Stroke};
use dapple::editor::selection::{Place, Selection};
use dapple::editor::session::Session;
use dapple_engine::attributes::free::far_spacing;
use dapple_engine::measure::Spot;
use dapple_engine::synth::{Growth, Options};

/// Mean radius √(r₁r₂) of the marks of [`scattered`], px.
const RADIUS: f64 = 7.6;

/// Marks like those of a drawing by hand, about 44 px apart, four in a row, with different distances, sizes and
/// directions.
fn scattered(count: usize) -> Document {
    let off = |k: usize, step: f64| 2.0 * (step * k as f64).fract() - 1.0;
    let stroke = |k: usize| {
        let shift = if (k / 4).is_multiple_of(2) { 0.0 } else { 22.0 };
        let x = 70.0 + 44.0 * (k % 4) as f64 + shift + 6.0 * off(k, 0.618);
        let y = 70.0 + 38.0 * (k / 4) as f64 + 6.0 * off(k, 0.414);
        let larger = 1.0 + 0.08 * off(k, 0.732);
        Stroke::ellipse([x, y], [9.0 * larger, 6.5 * larger], 40.0 + 8.0 * off(k, 0.449))
    };
    Document::new([512, 512]).with_layer(Layer::new((0..count).map(stroke)))
}

/// The share of the spots of `before`, farther than five spacings from the moved mark, that are still there in `after`.
fn share_that_stays(before: &Document, after: &Document, moved: usize) -> f64 {
    let [spots, now] = [before, after].map(|document| {
        let grown = Growth::begin(document, &Options::default(), None).run().unwrap();
        grown.layers[0].marks().unwrap().measured.spots().to_vec()
    });
    let from = before.layers[0].strokes[moved].mark().unwrap().center();
    let away = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let far: Vec<&Spot> = spots.iter().filter(|spot| away(spot.ellipse.center, from) > 220.0).collect();
    assert!(far.len() > 50, "{}", far.len());
    let same = |spot: &&&Spot| {
        now.iter().any(|other| {
            away(spot.ellipse.center, other.ellipse.center) < 0.2 * RADIUS
                && (other.ellipse.area() / spot.ellipse.area() - 1.0).abs() < 0.05
        })
    };
    far.iter().filter(same).count() as f64 / far.len() as f64
}

#[test]
fn spots_far_from_a_mark_that_is_moved_stay_where_they_are() {
    let before = scattered(12);
    for moved in [1, 6, 11] {
        let mut after = before.clone();
        let mark = before.layers[0].strokes[moved].mark().unwrap();
        after.layers[0].strokes[moved] = Stroke::from(mark.shifted([9.0, -7.0]));
        let stays = share_that_stays(&before, &after, moved);
        assert!(stays >= 0.95, "{stays} beside mark {moved}");
    }
}

#[test]
fn in_the_window_far_spots_keep_their_spacing_where_the_marks_alone_would_change_it() {
    let before = scattered(8);
    let wanted = |document: &Document, before: Option<f64>| {
        let strokes = document.layers[0].strokes.iter();
        let centers: Vec<[f64; 2]> = strokes.map(|stroke| stroke.mark().unwrap().center()).collect();
        far_spacing(&centers, [512.0; 2], document.edges, before)
    };
    let after_move = |moved: usize, by: [f64; 2]| {
        let mut session = Session::open(before.clone(), None);
        session.selection = Selection::new(vec![Place { layer: 0, stroke: moved }]);
        session.nudge(by);
        session.finished()
    };
    let ways = [[9.0, 9.0], [-9.0, 9.0], [-9.0, -9.0], [9.0, -9.0]];
    let moves = (0..8).flat_map(|moved| ways.map(|by| (moved, after_move(moved, by))));
    let first = wanted(&before, None);
    let steps = |after: &Document| wanted(after, None) != first && wanted(after, first) == first;
    let mut moves = moves.filter(|(_, after)| steps(after));
    let (moved, after) = moves.next().expect("a step of the distance");
    assert_eq!(after.layers[0].far_spacing, first);
    let stays = share_that_stays(&before, &after, moved);
    // Here a few spots beside the other marks move as well.
    assert!(stays >= 0.9, "{stays} beside mark {moved}");
    let mut alone = after;
    alone.layers[0].far_spacing = None;
    assert!(share_that_stays(&before, &alone, moved) < 0.5);
}
