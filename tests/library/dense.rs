//! Marks that are drawn denser than spots of reaction-diffusion systems can grow.

use dapple::document::{AreaKind, Document, Edges, Layer, Stroke, SystemChoice};
use dapple_engine::grid::Field;
use dapple_engine::measure::{Spot, spots};
use dapple_engine::synth::{Grown, Growth, Options};

/// Distance of the drawn marks, px.
const APART: f64 = 24.0;

/// Discs that cover the share `coverage` of the plane, in a hexagonal lattice about the middle of the canvas, with
/// `rings` rings around the first disc. Every other disc is larger by the factor `more`, its neighbours smaller by this
/// factor.
fn sheet(coverage: f64, rings: i32, more: f64) -> Document {
    let radius = APART * (coverage * 0.75f64.sqrt() / std::f64::consts::PI).sqrt();
    let mut strokes = Vec::new();
    for row in -rings..=rings {
        for column in -rings..=rings {
            if (row + column).abs() > rings {
                continue;
            }
            let [column, up] = [f64::from(column), f64::from(row)];
            let center = [128.0 + APART * (column + 0.5 * up), 128.0 + APART * 0.75f64.sqrt() * up];
            let factor = if strokes.len() % 2 == 0 { more } else { 1.0 / more };
            strokes.push(Stroke::ellipse(center, [radius * factor, radius * factor], 0.0));
        }
    }
    Document::new([256, 256]).with_edges(Edges::Wrap).with_layer(Layer::new(strokes))
}

fn grown(document: &Document) -> Grown {
    Growth::begin(document, &Options::default(), None).run().expect("it grows")
}

/// The pattern on the canvas, and its spots.
fn pattern(grown: &Grown) -> (Field, Vec<Spot>) {
    let field = grown.layers[0].pattern().field(256, 256);
    let spots = spots(&field, 0.5);
    (field, spots)
}

#[test]
fn dense_marks_grow_where_they_were_drawn_and_the_rest_has_the_same_density() {
    for coverage in [0.31, 0.5, 0.65] {
        let document = sheet(coverage, 2, 1.0);
        let grown = grown(&document);
        assert_eq!(grown.layers[0].system().name, "patches");
        let (field, spots) = pattern(&grown);
        let share = field.values.iter().filter(|value| **value > 0.5).count() as f64 / 65_536.0;
        assert!((share / coverage - 1.0).abs() < 0.08, "{coverage}: {share}");
        for stroke in &document.layers[0].strokes {
            let drawn = stroke.mark().and_then(|mark| mark.ellipse()).expect("an ellipse");
            let own = spots.iter().filter(|spot| {
                let way = [0, 1].map(|axis| spot.ellipse.center[axis] - drawn.center[axis]);
                way[0].hypot(way[1]) < 1.0
            });
            let areas: Vec<f64> = own.map(|spot| spot.ellipse.area() / drawn.area()).collect();
            assert!(areas.len() == 1 && (areas[0] - 1.0).abs() < 0.03, "{coverage}: {areas:?}");
        }
    }
}

#[test]
fn dense_marks_that_differ_have_neighbours_that_differ_as_much() {
    let varies = |more: f64| {
        let document = sheet(0.45, 2, more);
        let (_, spots) = pattern(&grown(&document));
        let drawn = |spot: &&Spot| (0..2).any(|axis| (spot.ellipse.center[axis] - 128.0).abs() > 70.0);
        let areas: Vec<f64> = spots.iter().filter(drawn).map(|spot| spot.ellipse.area()).collect();
        let mean = areas.iter().sum::<f64>() / areas.len() as f64;
        (areas.iter().map(|area| (area - mean) * (area - mean)).sum::<f64>() / areas.len() as f64).sqrt()
            / mean
    };
    let [even, uneven] = [1.0, 1.15].map(varies);
    assert!(even < 0.08 && (0.18..0.4).contains(&uneven), "{even} {uneven}");
}

#[test]
fn smooth_marks_have_smooth_neighbours() {
    let (_, spots) = pattern(&grown(&sheet(0.4, 2, 1.0)));
    let ragged = |spot: &Spot| {
        let round = 4.0 * std::f64::consts::PI * spot.ellipse.area();
        spot.contour * spot.contour / round
    };
    let worst = spots.iter().filter(|spot| spot.whole).map(ragged).fold(0.0, f64::max);
    assert!(worst < 1.12, "{worst}");
}

#[test]
fn the_report_says_what_was_chosen_and_a_chosen_system_is_not_changed() {
    let document = sheet(0.5, 2, 1.0);
    let report = dapple_engine::synth::layer_report::report(&document, "sheet", &grown(&document), 0.0);
    let notes = &report.layers[0].regions[0].notes;
    assert_eq!(report.layers[0].system, "patches");
    assert!(notes.iter().any(|note| note.contains("denser than spots grow")), "{notes:?}");
    let spots = SystemChoice::Of(dapple::document::System::MEINHARDT_SPOTS.description());
    let mut chosen = document;
    chosen.layers[0].system = spots;
    assert_eq!(chosen.areas(0), None);
}

#[test]
fn marks_that_touch_are_cells_where_they_cover_most_of_the_plane() {
    assert_eq!(sheet(0.88, 2, 1.0).areas(0), Some(AreaKind::Polygons));
    assert_eq!(sheet(0.25, 2, 1.0).areas(0), None);
}
