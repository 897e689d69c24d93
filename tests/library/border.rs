//! Marks that the border of the canvas cuts, also those whose centre is outside: their part on the canvas grows there,
//! and on a seamless canvas the rest appears at the other side.

use dapple::document::{AreaKind, Document, Edges, Ellipse, Kind, Layer, LineKind, Outline, PairKind};
use dapple::document::{Stroke, System, SystemChoice};
use dapple_engine::grid::Field;
use dapple_engine::synth::{Grown, Growth, Options};

const SIZE: [u32; 2] = [160, 120];

/// Centres and radii of spots; the centres of the first four are beyond the border.
const SPOTS: [([f64; 2], [f64; 2]); 7] = [
    ([-5.0, 40.0], [14.0, 9.0]),
    ([165.0, 80.0], [14.0, 9.0]),
    ([90.0, 125.0], [14.0, 10.0]),
    ([-7.0, -4.0], [16.0, 14.0]),
    ([60.0, 50.0], [14.0, 9.0]),
    ([110.0, 56.0], [14.0, 9.0]),
    ([52.0, 94.0], [14.0, 9.0]),
];

fn spots() -> Vec<Stroke> {
    SPOTS.iter().map(|(center, radii)| Stroke::ellipse(*center, *radii, 20.0)).collect()
}

fn outlines() -> Vec<Stroke> {
    let square = |[x, y]: [f64; 2], half: f64| {
        [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]
    };
    [[-6.0, 40.0], [165.0, 80.0], [70.0, 60.0]].map(|at| Stroke::outline(square(at, 16.0))).to_vec()
}

fn lines() -> Vec<Stroke> {
    vec![
        Stroke::line([-120.0, 40.0], [30.0, 44.0], 8.0),
        Stroke::line([30.0, 82.0], [130.0, 84.0], 8.0),
        Stroke::path([[100.0, 14.0], [170.0, 18.0], [170.0, 200.0]], 8.0),
    ]
}

fn crossing() -> Vec<Stroke> {
    let across =
        [Stroke::line([40.0, -60.0], [46.0, 70.0], 8.0), Stroke::line([100.0, 50.0], [106.0, 230.0], 8.0)];
    lines()[..2].iter().cloned().chain(across).collect()
}

fn document(strokes: Vec<Stroke>, system: SystemChoice, edges: Edges) -> Document {
    Document::new(SIZE).with_edges(edges).with_layer(Layer::new(strokes).with_system(system))
}

/// A document of each kind of marks.
fn documents(edges: Edges) -> Vec<Document> {
    let areas = |kind: AreaKind| SystemChoice::Of(kind.description());
    let pairs = |kind: PairKind| SystemChoice::Of(kind.description());
    let of_lines = |kind: LineKind| SystemChoice::Of(kind.description());
    let auto = SystemChoice::Auto;
    let fitted = SPOTS.map(|(center, radii)| {
        let [low, high] = [-1.0, 1.0].map(|side| [0, 1].map(|axis| center[axis] + 0.8 * side * radii[axis]));
        let points = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
        let ellipse = Ellipse { center, radii, angle: 0.0 };
        Stroke::Fitted { ellipse, outline: Outline { points } }
    });
    [
        (spots(), auto),
        (spots(), SystemChoice::Of(System::TURING_SPOTS.description())),
        (spots(), areas(AreaKind::Patches)),
        (fitted.to_vec(), areas(AreaKind::Patches)),
        (fitted.to_vec(), areas(AreaKind::Polygons)),
        (outlines(), auto),
        (outlines(), areas(AreaKind::Polygons)),
        (lines(), auto),
        (lines(), pairs(PairKind::Stripes)),
        (lines(), of_lines(LineKind::Streaks)),
        (lines(), of_lines(LineKind::Cracks)),
        (crossing(), auto),
        (crossing(), pairs(PairKind::Maze)),
        (spots(), pairs(PairKind::Stucco)),
    ]
    .map(|(strokes, system)| document(strokes, system, edges))
    .to_vec()
}

fn grown_on(document: &Document, size: [u32; 2]) -> Grown {
    document.check("a test").unwrap_or_else(|error| panic!("{error}"));
    let options = Options { source: "a test", size: Some(size), ..Options::default() };
    Growth::begin(document, &options, None).run().unwrap_or_else(|error| panic!("{error}"))
}

fn pattern(grown: &Grown) -> Field {
    let [width, height] = grown.size.map(|side| side as usize);
    grown.layers[0].pattern().field(width, height)
}

#[test]
fn marks_that_the_border_cuts_grow_in_every_kind_of_layer_and_equal_each_time() {
    for edges in [Edges::Closed, Edges::Wrap] {
        for document in documents(edges) {
            let grown = grown_on(&document, SIZE);
            let system = document.layers[0].system.name();
            assert_eq!(
                pattern(&grown).values,
                pattern(&grown_on(&document, SIZE)).values,
                "{system} {edges:?}"
            );
            let is_of_lines = document.layers[0].strokes[0].kind() == Some(Kind::Line);
            for mark in grown.layers[0].drawn() {
                // Few px of a line are on the canvas, and around a seamless canvas it may be oblique to other lines.
                let nearly = is_of_lines && (edges == Edges::Wrap || mark.off.is_some_and(|off| off < 0.2));
                assert!(mark.there || nearly, "{system} {edges:?}: {mark:?}");
            }
        }
    }
}

/// The number of px of the canvas inside the ellipse of a mark, and how many of these the pattern covers.
fn covered(pattern: &Field, center: [f64; 2], radii: [f64; 2]) -> [usize; 2] {
    let (s, c) = 20f64.to_radians().sin_cos();
    let mut found = [0; 2];
    for (px, value) in pattern.values.iter().enumerate() {
        let [x, y] = [px % pattern.width, px / pattern.width].map(|at| at as f64 + 0.5);
        let [x, y] = [x - center[0], y - center[1]];
        if ((c * x + s * y) / radii[0]).hypot((c * y - s * x) / radii[1]) <= 1.0 {
            found[0] += 1;
            found[1] += usize::from(*value >= 0.5);
        }
    }
    found
}

#[test]
fn the_part_of_a_spot_that_is_on_the_canvas_grows_where_it_was_drawn() {
    for (size, [x, y]) in [(SIZE, [0.0, 0.0]), ([240, 160], [80.0, 40.0])] {
        let document = document(spots(), SystemChoice::Auto, Edges::Closed);
        let pattern = pattern(&grown_on(&document, size));
        for (center, radii) in SPOTS {
            // On a canvas of another size, the mark has the same distance from the border.
            let moved = |at: f64, side: u32, by: f64| at + by * (at / f64::from(side)).clamp(0.0, 1.0);
            let at = [moved(center[0], SIZE[0], x), moved(center[1], SIZE[1], y)];
            let [drawn, grown] = covered(&pattern, at, radii);
            assert!(
                drawn > 40 && grown as f64 > 0.75 * drawn as f64,
                "{center:?} {size:?}: {grown} of {drawn}"
            );
        }
    }
}

#[test]
fn a_mark_beyond_the_border_of_a_tile_is_the_one_at_the_other_side() {
    let moved = |stroke: &Stroke| {
        let mark = stroke.mark().expect("a mark");
        let center = mark.center();
        let by = [0, 1].map(|axis| -f64::from(SIZE[axis]) * (center[axis] / f64::from(SIZE[axis])).floor());
        stroke.changed(mark.shifted(by))
    };
    let areas = SystemChoice::Of(AreaKind::Patches.description());
    for (strokes, system) in [(spots(), SystemChoice::Auto), (lines(), SystemChoice::Auto), (spots(), areas)]
    {
        let inside: Vec<Stroke> = strokes.iter().map(moved).collect();
        assert_ne!(inside, strokes);
        let [beyond, inside] = [strokes, inside]
            .map(|strokes| pattern(&grown_on(&document(strokes, system, Edges::Wrap), SIZE)));
        assert_eq!(beyond.values, inside.values, "{}", system.name());
    }
}

#[test]
fn a_mark_whose_centre_is_beyond_the_border_belongs_to_the_nearest_region() {
    let regions = |center: [f64; 2]| {
        let strokes =
            [Stroke::ellipse(center, [14.0, 9.0], 20.0), Stroke::ellipse([120.0, 90.0], [8.0, 8.0], 0.0)];
        let document = Document::new(SIZE).with_regions([2, 2]).with_layer(Layer::new(strokes));
        document.check("a test").expect("it can be read");
        let map =
            dapple_engine::synth::drawn::sketch_targets::region_map(&document, 0, "a test").expect("a map");
        map.of_region([0, 1])
    };
    assert_eq!(regions([-5.0, 124.0]), regions([5.0, 118.0]));
}
