//! Valid documents, and the defaults.

use super::*;

#[test]
fn the_shortest_document_has_the_defaults_of_the_format() {
    let document = accepted(&least());
    let ellipse = Ellipse { center: [64.0, 64.0], radii: [12.0, 6.0], angle: 30.0 };
    let layer = Layer { name: "layer 1".into(), strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
    let expected = Document {
        name: String::new(),
        size: [512, 256],
        regions: None,
        edges: Edges::Closed,
        seed: 1,
        dpi: 300.0,
        growth: Growth { refine: true },
        model: None,
        parametric: None,
        warp: None,
        finish: None,
        layers: vec![layer],
        starred: Vec::new(),
    };
    assert_eq!(document, expected);
    let layer = &document.layers[0];
    assert_eq!((layer.system, layer.after, layer.visible), (SystemChoice::Auto, After::Between, true));
    assert_eq!((layer.seed, &layer.colours), (None, &None));
}

#[test]
fn every_key_is_read() {
    let text = r##"{
      "format": "dapple", "version": 2, "name": "cheetah", "size": [512, 300], "regions": [2, 3],
      "edges": "wrap", "seed": 18446744073709551615, "dpi": 72.5, "growth": {"refine": false},
      "layers": [
        {"name": "spots", "system": "turing-spots", "after": "around", "visible": false, "seed": 7,
         "strokes": [{"kind": "ellipse", "center": [64, 64], "radii": [12, 6]}], "options": {},
         "colours": {"stops": [{"at": 0, "colour": "#F4e3c1"}, {"at": 1, "colour": "#fa0"}],
                     "bends": [[0.42, 0.0, 0.58, 1.0]]}},
        {"strokes": [{"kind": "line", "from": [10, 10], "to": [90, 60]},
                     {"kind": "path", "points": [[5, 5], [40, 9.5], [60, 20]]},
                     {"kind": "freehand", "points": [[1.5, 2], [3, 4]], "width": 4}]}
      ]}"##;
    let document = Document::parse(text, "x").unwrap();
    assert_eq!((document.edges, document.seed, document.dpi), (Edges::Wrap, u64::MAX, 72.5));
    assert_eq!((document.regions, document.growth.refine), (Some([2, 3]), false));
    let [spots, lines] = &document.layers[..] else { panic!("two layers") };
    assert_eq!((spots.after, spots.visible, spots.seed), (After::Around, false, Some(7)));
    let colours = spots.colours.clone().unwrap();
    assert_eq!(colours.stops.map_colours(), [[0xf4, 0xe3, 0xc1], [0xff, 0xaa, 0x00]]);
    assert_eq!(colours.bends, [[0.42, 0.0, 0.58, 1.0]]);
    let line = Line { from: [10.0, 10.0], to: [90.0, 60.0], width: Stroke::WIDTH };
    let freehand = Stroke::Freehand { points: vec![[1.5, 2.0], [3.0, 4.0]], width: 4.0 };
    let path = Stroke::path([[5.0, 5.0], [40.0, 9.5], [60.0, 20.0]], Stroke::WIDTH);
    assert_eq!(lines.strokes, [Stroke::Line(line), path, freehand]);
    assert_eq!(lines.name, "layer 2");
}

trait MapColours {
    fn map_colours(&self) -> Vec<[u8; 3]>;
}

impl MapColours for Vec<Stop> {
    fn map_colours(&self) -> Vec<[u8; 3]> {
        self.iter().map(|stop| stop.colour).collect()
    }
}

#[test]
fn a_byte_order_mark_is_skipped() {
    assert!(Document::parse(&format!("\u{feff}{}", least()), "x").is_ok());
}

#[test]
fn an_ellipse_may_reach_over_the_edge_as_long_as_some_part_of_it_is_on_the_canvas() {
    let ellipse = |x: f64| with_stroke(&json!({"kind": "ellipse", "center": [x, 64], "radii": [99, 6]}));
    for edges in ["closed", "wrap"] {
        for x in [0.0, 512.0, -98.9, 610.9] {
            let mut document = ellipse(x);
            document["edges"] = json!(edges);
            accepted(&document);
        }
        let mut beside = ellipse(-99.5);
        beside["edges"] = json!(edges);
        let found = "an ellipse about [-99.5, 64] that is wholly outside the canvas";
        refused(&beside, "layers[0].strokes[0]", found, ON_CANVAS);
    }
    let place = "layers[0].strokes[0].center[0]";
    refused(&ellipse(1024.5), place, "1024.5", "a number from -512 to 1024 px");
}

const ON_CANVAS: &str =
    "a stroke of which some part is on the canvas, from [0, 0] to [512, 256]: move it, or leave it out";

#[test]
fn a_line_may_leave_the_canvas_as_long_as_some_part_of_its_width_is_on_it() {
    let line = |x: f64| with_stroke(&json!({"kind": "line", "from": [-100, 10], "to": [x, 10], "width": 6}));
    accepted(&line(120.0));
    accepted(&line(-2.9));
    let found = "a line from [-100, 10] to [-3.1, 10] that is wholly outside the canvas";
    refused(&line(-3.1), "layers[0].strokes[0]", found, ON_CANVAS);
    let path = |x: f64| json!({"kind": "path", "points": [[-90, -90], [-90, 40], [x, 40]], "width": 4});
    accepted(&with_stroke(&path(-1.9)));
    let found = "a path about [-90, 15.5] that is wholly outside the canvas";
    refused(&with_stroke(&path(-9.0)), "layers[0].strokes[0].points", found, ON_CANVAS);
    let far = "layers[0].strokes[0].to[0]";
    refused(&line(1025.0), far, "1025.0", "a number from -512 to 1024 px");
}

#[test]
fn any_finite_angle_is_allowed() {
    let angle = |a: f64| with("/layers/0/strokes/0/angle", json!(a));
    accepted(&angle(-1e300));
    accepted(&angle(7200.0));
}

#[test]
fn a_whole_number_may_be_written_with_a_fraction_of_zero() {
    assert_eq!(accepted(&with("/size", json!([512.0, 256.0]))).size, [512, 256]);
}

#[test]
fn kept_textures_are_read_as_they_were_written_and_keep_none_themselves() {
    let plain = accepted(&least());
    let one = |seed| Starred { name: format!("Seed {seed}"), document: Document { seed, ..plain.clone() } };
    let document = Document { starred: vec![one(2), one(3)], ..plain.clone() };
    let text = document.to_json();
    assert_eq!(Document::parse(&text, "x").unwrap(), document);
    assert_eq!(text.matches("\"version\"").count(), 1, "format and version stand once");
    let nested = Starred { name: String::new(), document: document.clone() };
    let text = Document { starred: vec![nested], ..plain.clone() }.to_json();
    let error = Document::parse(&text, "x").unwrap_err().to_string();
    assert!(error.contains("starred[0].document: found the key \"starred\""), "{error}");
    let many = Document { starred: (0..65).map(one).collect(), ..plain };
    let error = Document::parse(&many.to_json(), "x").unwrap_err().to_string();
    assert!(error.contains("found 65 objects; allowed: a list of at most 64"), "{error}");
}
