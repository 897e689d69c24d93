//! The written files, read by other libraries: SVG by roxmltree and usvg, DXF by the crate dxf.

use crate::outlines::bench::Bench;
use crate::outlines::grown::enclosed;
use dapple_engine::export::outline::svg::Unit;
use dapple_engine::export::outline::{Smallest, Style, draw, dxf as writer, outline_field};
use dapple_engine::grid::{Edges, Field};
use dxf::entities::EntityType;
use resvg::usvg::{self, Node};

/// The number of filled paths and of strokes in an SVG.
fn counts(text: &str) -> [usize; 2] {
    let xml = roxmltree::Document::parse(text).unwrap();
    let path = |path: &roxmltree::Node| path.has_tag_name(("http://www.w3.org/2000/svg", "path"));
    ["none", "#"].map(|stroke| {
        xml.descendants()
            .filter(path)
            .filter(|path| path.parent().unwrap().attribute("stroke").unwrap().starts_with(stroke))
            .count()
    })
}

#[test]
fn an_svg_has_a_group_for_each_layer_and_is_in_mm_by_default() {
    let bench = Bench::new();
    let printed = bench.does("grow a.dapple -o a.svg --no-refine --report r.json");
    assert!(printed.contains("in the air"), "{printed}");
    let text = bench.text("a.svg");
    let xml = roxmltree::Document::parse(&text).unwrap();
    let root = xml.root_element();
    // 128 × 96 px at 300 dpi.
    assert_eq!([root.attribute("width"), root.attribute("height")], [Some("10.837mm"), Some("8.128mm")]);
    assert_eq!(root.first_element_child().unwrap().text(), Some("a <b> & \"c\""));
    let group = root.children().find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "g"))).unwrap();
    assert_eq!(group.attribute("id"), Some("big-spots"));
    assert_eq!(group.attribute(("http://www.inkscape.org/namespaces/inkscape", "label")), Some("big spots"));
    assert!(text.contains("C") && text.contains('Z') && !text.contains("NaN") && !text.contains("inf"));
    let report: serde_json::Value = serde_json::from_str(&bench.text("r.json")).unwrap();
    let outlines = &report["outlines"];
    assert_eq!(outlines["unit"], "mm");
    assert!(outlines["pen_up"].as_f64() < outlines["pen_up_unordered"].as_f64(), "{outlines}");
    // The paths are separated by fill rule; the filled areas are the same.
    let tree = usvg::Tree::from_str(&text, &usvg::Options::default()).unwrap();
    let [Node::Group(root)] = tree.root().children() else { panic!("no group") };
    assert!(root.has_children());
}

#[test]
fn styles_line_ends_and_sizes_are_as_requested() {
    let bench = Bench::new();
    let drawn = |more: &str| {
        bench.does(&format!("grow a.dapple --svg b.svg --units px --no-refine --quiet {more}"));
        bench.text("b.svg")
    };
    let [areas, none] = counts(&drawn(""));
    assert!(areas > 8 && none == 0);
    let closed = drawn("--style stroke");
    let [_, strokes] = counts(&closed);
    assert!(strokes >= areas && !closed.contains("NaN"));
    assert_eq!(closed.matches('Z').count(), strokes);
    let cut = drawn("--style stroke --edges cut");
    assert!(cut.matches('Z').count() < counts(&cut)[1] && cut.matches('L').count() == 0);
    let both = counts(&drawn("--style fill,hatch:2:30"));
    assert!(both[0] == areas && both[1] > 2 * areas, "{both:?}");
    assert_eq!(counts(&drawn("--min-area 100000")), [0, 0]);
    let area = |text: &str| enclosed(usvg::Tree::from_str(text, &usvg::Options::default()).unwrap().root());
    let [usual, high] = [area(&drawn("")), area(&drawn("--level 0.97"))];
    assert!(0.0 < high && high < 0.5 * usual, "{high} of {usual} px²");
    assert!(drawn("--style stroke --pen 0.25").contains("stroke-width=\"0.25\""));
}

#[test]
fn a_dxf_is_read_by_a_library_that_did_not_write_it() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.dxf --units px --no-refine --quiet --svg a.svg");
    let drawing = dxf::Drawing::load_file(bench.path("a.dxf").to_str().unwrap()).unwrap();
    assert!(drawing.layers().any(|layer| layer.name == "big_spots"));
    let mut count = 0;
    for entity in drawing.entities() {
        let EntityType::Polyline(line) = &entity.specific else { panic!("{:?}", entity.specific) };
        assert_eq!(entity.common.layer, "big_spots");
        assert!(line.is_closed());
        let on = |vertex: &dxf::entities::Vertex| {
            let at = &vertex.location;
            (-0.001..=128.001).contains(&at.x) && (-0.001..=96.001).contains(&at.y)
        };
        assert!(line.vertices().all(on) && line.vertices().count() > 2);
        count += 1;
    }
    let holes = bench.text("a.svg").matches('Z').count();
    assert_eq!(count, holes);
}

#[test]
fn a_dxf_keeps_areas_and_orientation() {
    // A disc in the upper left quarter.
    let field = Field::from_fn([64, 64], [1.0, 1.0], Edges::Closed, |[x, y]| {
        let r = ((x - 20.0) * (x - 20.0) + (y - 16.0) * (y - 16.0)).sqrt();
        (0.5 + 0.1 * (10.0 - r)) as f32
    });
    let shapes = outline_field(&field, 0.5, Smallest::default());
    let (groups, travel) = draw(vec![("ä/ö".to_owned(), [0; 3], shapes)], [64.0; 2], &Style::default());
    assert_eq!(travel.paths, 1);
    let mut text = Vec::new();
    writer::write(&mut text, [64.0; 2], Unit::Mm { dpi: 25.4 }, &groups).unwrap();
    let drawing = dxf::Drawing::load(&mut text.as_slice()).unwrap();
    let entities: Vec<_> = drawing.entities().collect();
    let [EntityType::Polyline(line)] = [&entities[0].specific] else { panic!("no polyline") };
    let points: Vec<[f64; 2]> = line.vertices().map(|v| [v.location.x, v.location.y]).collect();
    let n = points.len();
    let cross = |i: usize| points[i][0] * points[(i + 1) % n][1] - points[i][1] * points[(i + 1) % n][0];
    let area = 0.5 * (0..n).map(cross).sum::<f64>().abs();
    assert!((area / (100.0 * std::f64::consts::PI) - 1.0).abs() < 0.005, "{area}");
    let middle = points.iter().map(|p| p[1]).sum::<f64>() / n as f64;
    assert!((middle - 48.0).abs() < 0.5, "{middle}");
    assert!(points.iter().all(|p| (p[0] - 20.0).hypot(p[1] - 48.0) > 9.9));
}

#[test]
fn contradictory_options_are_refused_before_anything_grows() {
    let bench = Bench::new();
    bench.refuses("grow a.dapple -o a.gif", 1, &["a.gif", ".webp, .svg, .dxf"]);
    bench.refuses("grow a.dapple", 2, &["--output"]);
    bench.refuses("grow a.dapple --svg a.png", 1, &["a.png", "allowed: .svg"]);
    bench.refuses("grow a.dapple -o a.svg --svg a.svg", 2, &["a.svg", "twice"]);
    bench.refuses("grow a.dapple -o a.png --style stroke", 2, &["--style", "--svg"]);
    bench.refuses("grow a.dapple -o a.svg --edges cut", 2, &["--edges", "stroke"]);
    bench.refuses("grow a.dapple -o a.svg --style hatch:0.001", 2, &["--style", "at least"]);
    bench.refuses("grow a.dapple -o a.svg --style dots", 2, &["--style", "hatch:SPACING"]);
    bench.refuses("grow a.dapple -o a.svg --level 1.5", 2, &["--level", "below 1"]);
    bench.refuses("grow a.dapple -o a.png --layer 1", 2, &["--layer", "--pattern"]);
    // The hatch would have 2·10⁹ strokes.
    let dense = "--size 60000x60000 --units px --style hatch:0.1";
    bench.refuses(&format!("grow a.dapple -o a.svg {dense}"), 1, &["hatch", "GB are free", "larger spacing"]);
}
