//! Lines around the marks beneath, and a net between them.

use crate::grow::folder::{AREA, Folder, SPACING, hexagon};
use dapple::document::Edges;
use serde_json::{Value, json};
use std::f64::consts::PI;

/// 150 px of spots, with the marks `upper` on a layer above them.
fn layers(edges: &str, spacing: f64, upper: &[Value]) -> Value {
    let factor = spacing / SPACING;
    let mut strokes = hexagon([75.0, 75.0], 30.0);
    for stroke in &mut strokes {
        for axis in [0, 1] {
            let from_middle = stroke["center"][axis].as_f64().unwrap() - 75.0;
            stroke["center"][axis] = json!(75.0 + factor * from_middle);
        }
    }
    let mut layers = vec![json!({"strokes": strokes})];
    layers.extend_from_slice(upper);
    json!({"format": "dapple", "version": 1, "size": [150, 150], "edges": edges, "layers": layers})
}

fn line(width: f64) -> Value {
    json!([{"kind": "line", "from": [50, 50], "to": [100, 60], "width": width}])
}

fn around(width: f64, broken: f64) -> Value {
    json!({"strokes": line(width), "after": "around", "options": {"broken": broken}})
}

fn net(width: f64) -> Value {
    json!({"strokes": line(width), "after": "net"})
}

/// The labels of a picture with twice the px.
struct Labels {
    side: usize,
    wrap: bool,
    values: Vec<u8>,
}

const SCALE: f64 = 2.0;

impl Labels {
    fn grow(document: &Value) -> (Self, Folder) {
        let folder = Folder::with(document);
        folder.grow("--scale 2 --labels l.png --report r.json");
        let ([side, _], values) = folder.gray8("l.png");
        (Self { side, wrap: document["edges"] == "wrap", values }, folder)
    }

    fn neighbours(&self, px: usize) -> impl Iterator<Item = usize> + '_ {
        let n = self.side as isize;
        let (x, y) = ((px % self.side) as isize, (px / self.side) as isize);
        [[1, 0], [-1, 0], [0, 1], [0, -1]].into_iter().filter_map(move |[dx, dy]| {
            let (x, y) = (x + dx, y + dy);
            let inside = (0..n).contains(&x) && (0..n).contains(&y);
            (self.wrap || inside).then(|| (y.rem_euclid(n) * n + x.rem_euclid(n)) as usize)
        })
    }

    /// The connected pieces of the px for which `belongs` is true.
    fn pieces(&self, belongs: impl Fn(u8) -> bool) -> Vec<Vec<usize>> {
        let mut seen: Vec<bool> = self.values.iter().map(|value| !belongs(*value)).collect();
        let mut pieces = Vec::new();
        for start in 0..seen.len() {
            if std::mem::replace(&mut seen[start], true) {
                continue;
            }
            let (mut piece, mut at) = (vec![start], 0);
            while at < piece.len() {
                let new: Vec<usize> = self.neighbours(piece[at]).filter(|px| !seen[*px]).collect();
                for px in new {
                    seen[px] = true;
                    piece.push(px);
                }
                at += 1;
            }
            pieces.push(piece);
        }
        pieces
    }

    fn touches_border(&self, piece: &[usize]) -> bool {
        let last = self.side - 1;
        let on = |px: &usize| [px % self.side, px / self.side].iter().any(|at| *at == 0 || *at == last);
        !self.wrap && piece.iter().any(on)
    }

    /// The marks of the first layer that do not touch closed edges.
    fn marks(&self) -> Vec<Vec<usize>> {
        self.pieces(|value| value == 1).into_iter().filter(|piece| !self.touches_border(piece)).collect()
    }

    /// The share of the outline of a mark that has the second layer within 1.5 of its radii.
    fn ringed(&self, mark: &[usize]) -> f64 {
        let reach = (1.5 * SCALE * (AREA / PI).sqrt()) as isize;
        let outline: Vec<&usize> =
            mark.iter().filter(|px| self.neighbours(**px).any(|next| self.values[next] != 1)).collect();
        let n = self.side as isize;
        let near = |px: &&&usize| {
            let (x, y) = ((***px % self.side) as isize, (***px / self.side) as isize);
            (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy))).any(|(dx, dy)| {
                let (x, y) = (x + dx, y + dy);
                let inside = self.wrap || (0..n).contains(&x) && (0..n).contains(&y);
                inside
                    && dx * dx + dy * dy <= reach * reach
                    && self.values[(y.rem_euclid(n) * n + x.rem_euclid(n)) as usize] == 2
            })
        };
        outline.iter().filter(near).count() as f64 / outline.len() as f64
    }

    /// Whether no px of layer `a` has a neighbour of layer `b`.
    fn keeps_apart(&self, a: u8, b: u8) -> bool {
        (0..self.values.len())
            .filter(|px| self.values[*px] == a)
            .all(|px| self.neighbours(px).all(|next| self.values[next] != b))
    }
}

#[track_caller]
fn width_is_met(folder: &Folder, layer: usize) {
    for region in folder.json("r.json")["layers"][layer]["regions"].as_array().unwrap() {
        let error = region["error"]["width"].as_f64().unwrap();
        assert!(error.abs() < 0.02, "{region}");
        assert!(region["asked"].get("angle").is_none() && region["got"].get("angle").is_none(), "{region}");
    }
}

#[test]
fn rings_enclose_every_mark_without_touching_it() {
    for edges in ["closed", "wrap"] {
        let (labels, folder) = Labels::grow(&layers(edges, 31.0, &[around(4.0, 0.0)]));
        let marks = labels.marks();
        assert!(marks.len() > 9, "{}", marks.len());
        let outside = labels.pieces(|value| value != 2).into_iter().max_by_key(Vec::len).unwrap();
        for mark in &marks {
            assert!(labels.ringed(mark) >= 0.95, "{edges}");
            assert!(!outside.contains(&mark[0]), "{edges}: a ring is open");
        }
        assert!(labels.keeps_apart(1, 2), "{edges}");
        width_is_met(&folder, 1);
    }
}

#[test]
fn broken_rings_are_open_by_the_requested_share() {
    let area = |broken: f64| {
        let (labels, folder) = Labels::grow(&layers("wrap", 31.0, &[around(4.0, broken)]));
        assert!(labels.keeps_apart(1, 2));
        width_is_met(&folder, 1);
        let outside = labels.pieces(|value| value != 2).into_iter().max_by_key(Vec::len).unwrap();
        let open = labels.marks().iter().filter(|mark| outside.contains(&mark[0])).count();
        (open as f64 / labels.marks().len() as f64, labels.values.iter().filter(|value| **value == 2).count())
    };
    let (open, whole) = area(0.0);
    assert_eq!(open, 0.0);
    let (open, left) = area(0.35);
    let share = 1.0 - left as f64 / whole as f64;
    assert!(open == 1.0 && (0.25..0.45).contains(&share), "{open} {share}");
}

#[test]
fn a_net_is_connected_and_has_the_drawn_width() {
    for edges in ["closed", "wrap"] {
        for (spacing, width) in [(26.0, 5.0), (34.0, 3.5)] {
            let (labels, folder) = Labels::grow(&layers(edges, spacing, &[net(width)]));
            let pieces = labels.pieces(|value| value == 2);
            assert_eq!(pieces.len(), 1, "{edges} {spacing} {width}");
            assert!(labels.keeps_apart(1, 2), "{edges} {spacing} {width}");
            width_is_met(&folder, 1);
        }
    }
}

#[test]
fn a_tile_with_one_spot_has_a_net_too() {
    let spot = json!([{"kind": "ellipse", "center": [30, 30], "radii": [11, 11]}]);
    let document = json!({"format": "dapple", "version": 1, "size": [60, 60], "edges": "wrap",
        "layers": [{"strokes": spot}, {"strokes": [{"kind": "line", "from": [5, 5], "to": [20, 5], "width": 4}],
        "after": "net"}]});
    let (labels, folder) = Labels::grow(&document);
    assert_eq!([labels.pieces(|value| value == 2).len(), labels.pieces(|value| value == 0).len()], [1, 1]);
    width_is_met(&folder, 1);
}

#[test]
fn widths_follow_the_regions() {
    for after in ["around", "net"] {
        let lines = json!([
            {"kind": "line", "from": [20, 50], "to": [60, 50], "width": 3},
            {"kind": "line", "from": [100, 50], "to": [140, 50], "width": 4.5}
        ]);
        let mut document = layers("closed", 31.0, &[json!({"strokes": lines, "after": after})]);
        document["regions"] = json!([2, 1]);
        let (labels, folder) = Labels::grow(&document);
        width_is_met(&folder, 1);
        if after == "net" {
            assert_eq!(labels.pieces(|value| value == 2).len(), 1);
        }
    }
}

#[test]
fn the_same_document_has_the_same_bytes_and_another_seed_other_gaps() {
    let mut document = layers("wrap", 31.0, &[around(4.0, 0.3)]);
    let bytes = |document: &Value| Labels::grow(document).0.values;
    let first = bytes(&document);
    assert!(first == bytes(&document));
    document["layers"][1]["seed"] = json!(77);
    assert!(first != bytes(&document));
}

#[test]
fn spots_grow_between_rosettes() {
    let dots = json!({"strokes": [
        {"kind": "ellipse", "center": [50, 50], "radii": [2, 2]},
        {"kind": "ellipse", "center": [59, 50], "radii": [2, 2]},
        {"kind": "ellipse", "center": [50, 59], "radii": [2, 2]}
    ]});
    let (labels, _) = Labels::grow(&layers("wrap", 40.0, &[around(4.0, 0.3), dots]));
    assert!(labels.keeps_apart(1, 2) && labels.keeps_apart(1, 3) && labels.keeps_apart(2, 3));
    assert!(labels.pieces(|value| value == 3).len() > 20);
}

#[test]
fn rings_without_marks_beneath_are_refused() {
    for after in ["around", "net"] {
        let document = json!({"format": "dapple", "version": 1, "size": [90, 90],
            "layers": [{"strokes": line(4.0), "after": after}]});
        let words = ["layers[0].after", after, "between", "no other beneath"];
        Folder::with(&document).refuses("grow a.dapple -o a.png", 1, &words);
        Folder::with(&document).refuses("check a.dapple", 1, &words);
    }
}

#[test]
fn rings_and_nets_refuse_options_that_lines_cannot_have() {
    let spots = json!(hexagon([60.0, 60.0], 30.0));
    for after in ["around", "net"] {
        let document = layers("wrap", 31.0, &[json!({"strokes": spots, "after": after})]);
        let words = ["layers[1].after", "ellipses", "lines", after];
        Folder::with(&document).refuses("grow a.dapple -o a.png", 1, &words);
        let stripes = json!({"strokes": line(4.0), "after": after, "system": "meinhardt-stripes"});
        let words = ["layers[1].system", "meinhardt-stripes", "auto"];
        Folder::with(&layers("wrap", 31.0, &[stripes])).refuses("grow a.dapple -o a.png", 1, &words);
    }
    for broken in
        [json!({"strokes": line(4.0), "after": "net", "options": {"broken": 0.2}}), around(4.0, 0.7)]
    {
        let words = ["layers[1].options", "broken"];
        Folder::with(&layers("wrap", 31.0, &[broken])).refuses("grow a.dapple -o a.png", 1, &words);
    }
}

#[test]
fn too_little_room_is_reported_with_the_numbers() {
    for (upper, lines) in [(around(8.0, 0.0), "rings 8.0 px"), (net(12.0), "12.0 px")] {
        let folder = Folder::with(&layers("wrap", 26.0, &[upper]));
        folder.refuses("grow a.dapple -o a.png", 1, &["layer 2", lines, "need", "farther apart"]);
        // `check` grows a document as small as this one, too.
        let output = folder.dapple("check a.dapple").assert().code(1).get_output().clone();
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.contains(lines) && text.contains("will most likely refuse it"), "{text}");
    }
}

#[test]
fn a_net_that_stripes_would_cut_into_parts_is_refused() {
    let stripes = json!([{"kind": "line", "from": [20, 75], "to": [130, 75], "width": 12}]);
    let document = json!({"format": "dapple", "version": 1, "size": [150, 150], "edges": "wrap",
        "layers": [{"strokes": stripes}, {"strokes": line(3.0), "after": "net"}]});
    Folder::with(&document).refuses("grow a.dapple -o a.png", 1, &["layer 2", "parts"]);
}

#[test]
fn rings_of_stripes_run_along_them() {
    let stripes = json!([{"kind": "line", "from": [20, 55], "to": [90, 55], "width": 18}]);
    let document = json!({"format": "dapple", "version": 1, "size": [110, 110], "edges": "wrap",
        "layers": [{"strokes": stripes}, {"strokes": line(4.0), "after": "around"}]});
    let (labels, folder) = Labels::grow(&document);
    assert!(labels.keeps_apart(1, 2));
    width_is_met(&folder, 1);
    let field = {
        folder.grow("--pattern p.png --layer 2");
        folder.pattern("p.png", Edges::Wrap)
    };
    // Three stripes, and two lines along each.
    let crossed = |x: usize| {
        let column: Vec<bool> = (0..110).map(|y| field.values[y * 110 + x] > 0.5).collect();
        (0..110).filter(|y| column[*y] && !column[(y + 1) % 110]).count()
    };
    let lines: Vec<usize> = (0..110).map(crossed).collect();
    assert!(lines.iter().filter(|lines| **lines == 6).count() > 90, "{lines:?}");
}
