//! Examples on small canvases: the area that their outlines enclose, and how an SVG library paints them.

use crate::some;
use dapple::ReadFile;
use dapple::document::Document;
use dapple_engine::export::outline::path::{end, start};
use dapple_engine::export::outline::svg::{self, Sheet, Unit};
use dapple_engine::export::outline::{Group, Hatch, Smallest, Style};
use dapple_engine::synth::Growth;
use dapple_engine::synth::render::outlining::{Outlining, outlines};
use dapple_engine::synth::render::painting::Painting;
use dapple_engine::synth::{Grown, Options, Watch};
use rayon::prelude::*;
use resvg::tiny_skia::{PathSegment, Pixmap, Transform};
use resvg::usvg::{self, Node, tiny_skia_path};
use std::path::Path;

/// Side of the canvas that they are grown on, px.
const SIDE: u32 = 200;
/// Samples per px along each side, with which the outlines are compared.
const FINE: usize = 6;

/// All examples, those of the gallery too.
fn examples() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut names = Vec::new();
    for (folder, before) in [(root.clone(), ""), (root.join("gallery"), "gallery/")] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "dapple") {
                names.push(format!("{before}{}", path.file_stem().unwrap().to_str().unwrap()));
            }
        }
    }
    names.sort();
    names
}

fn grown(name: &str) -> (Document, Grown) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"));
    let document = Document::read(file).unwrap();
    let options = Options { size: Some([SIDE; 2]), refine: Some(false), source: name, ..Options::default() };
    let grown = Growth::begin(&document, &options, None).run().unwrap();
    (document, grown)
}

fn outlined(document: &Document, grown: &Grown, level: f64) -> Vec<Group> {
    let wanted = Outlining {
        size: [SIDE as usize; 2],
        level,
        only: None,
        smallest: Smallest::default(),
        style: Style::default(),
    };
    outlines(document, grown, &wanted, &Watch::NONE).unwrap().0
}

/// The layer whose mark covers each px, at `scale` times the px.
fn labels(document: &Document, grown: &Grown, scale: usize) -> Vec<u8> {
    let painting = Painting::new(document, grown, scale);
    let mut labels = vec![0; painting.size[0] * painting.size[1]];
    painting.band(0..painting.size[1]).labels(&mut labels);
    labels
}

/// The groups as an SVG library reads them.
fn read(groups: &[Group]) -> usvg::Tree {
    let sheet = Sheet {
        title: String::new(),
        size: [f64::from(SIDE); 2],
        unit: Unit::Px,
        stroke_width: 1.0,
        ground: None,
    };
    let mut text = Vec::new();
    svg::write(&mut text, &sheet, groups).unwrap();
    usvg::Tree::from_data(&text, &usvg::Options::default()).unwrap()
}

/// The share of each px that the marks cover as painted by resvg, 0..1.
fn painted(groups: &[Group]) -> Vec<f64> {
    let mut pixmap = Pixmap::new(SIDE, SIDE).unwrap();
    resvg::render(&read(groups), Transform::identity(), &mut pixmap.as_mut());
    pixmap.pixels().iter().map(|px| f64::from(px.alpha()) / 255.0).collect()
}

/// The area that the paths of an SVG enclose, px²; holes have the opposite direction.
pub fn enclosed(group: &usvg::Group) -> f64 {
    let each = |node: &Node| match node {
        Node::Group(group) => enclosed(group),
        Node::Path(path) => {
            let mut area = 0.0;
            let mut last = [0.0; 2];
            let mut first = last;
            let at = |point: tiny_skia_path::Point| [f64::from(point.x), f64::from(point.y)];
            for segment in path.data().clone().transform(path.abs_transform()).unwrap().segments() {
                let ends = match segment {
                    PathSegment::MoveTo(to) => {
                        first = at(to);
                        last = first;
                        vec![]
                    }
                    PathSegment::LineTo(to) => vec![at(to)],
                    PathSegment::QuadTo(..) => panic!("none is written"),
                    PathSegment::CubicTo(a, b, c) => {
                        let control = [last, at(a), at(b), at(c)];
                        (1..=64).map(|i| bezier(control, f64::from(i) / 64.0)).collect()
                    }
                    PathSegment::Close => vec![first],
                };
                for end in ends {
                    area += 0.5 * (last[0] * end[1] - last[1] * end[0]);
                    last = end;
                }
            }
            area
        }
        _ => 0.0,
    };
    group.children().iter().map(each).sum()
}

/// A point of a Bézier curve, by de Casteljau's algorithm.
fn bezier(control: [[f64; 2]; 4], t: f64) -> [f64; 2] {
    let mut points = control.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|p| [0, 1].map(|axis| p[0][axis] + t * (p[1][axis] - p[0][axis])))
            .collect();
    }
    points[0]
}

#[test]
fn outlines_enclose_the_area_of_the_pattern_and_are_painted_like_it() {
    let examples = examples();
    assert!(examples.len() >= 53, "{}", examples.len());
    let complaints: Vec<String> = some(examples, 3).par_iter().flat_map(|name| complaints(name)).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

fn complaints(name: &str) -> Vec<String> {
    let (document, grown) = grown(name);
    let groups = outlined(&document, &grown, 0.5);
    let mut complaints = Vec::new();
    let fine = labels(&document, &grown, FINE);
    let samples = (FINE * FINE) as f64;
    let mut shown = groups.iter();
    for (index, layer) in document.layers.iter().enumerate() {
        let count = fine.iter().filter(|label| usize::from(**label) == index + 1).count();
        let wanted = count as f64 / samples;
        // A hidden layer has no group and covers no px.
        if wanted == 0.0 {
            continue;
        }
        let group = shown.next().unwrap();
        let found = enclosed(read(std::slice::from_ref(group)).root());
        println!("{name}, {}: {found:.1} px² of {wanted:.1}: {:+.4}", layer.name, found / wanted - 1.0);
        if (found - wanted).abs() > 0.005 * wanted {
            complaints.push(format!("{name}, {}: {found} px² of {wanted}", layer.name));
        }
    }
    let side = SIDE as usize;
    let mut covered = vec![0.0; side * side];
    for (i, label) in fine.iter().enumerate() {
        let [x, y] = [i % (side * FINE), i / (side * FINE)];
        covered[y / FINE * side + x / FINE] += f64::from(u8::from(*label > 0)) / samples;
    }
    let painted = painted(&groups);
    let off: Vec<f64> = covered.iter().zip(&painted).map(|(a, b)| (a - b).abs()).collect();
    let cut = covered.iter().filter(|cover| (0.001..0.999).contains(*cover)).count().max(1);
    let [mean, most] = [off.iter().sum::<f64>() / cut as f64, off.iter().copied().fold(0.0, f64::max)];
    let worst = off.iter().position(|off| *off == most).unwrap_or(0);
    let output = format!(
        "{name}: cover of a px at an edge differs by {mean:.5} in the mean, {most:.3} at most, at {:?}",
        [worst % side, worst / side]
    );
    println!("{output}");
    // Both are sampled: here by 6 × 6 points, by resvg on 4 lines per px. Half a step of both is 1/12 + 1/8, which is
    // the error at an edge along the rows of all px. A corner has two edges: where a thread ends at another one, a px
    // or two may differ by twice as much.
    let corners = off.iter().filter(|off| **off > 0.25).count();
    if mean > 0.1 || corners > 2 || most > 0.42 {
        complaints.push(output);
    }
    complaints
}

/// The positions of points along the border at `place` of an axis.
fn along(points: &[[f64; 2]], axis: usize, place: f64) -> Vec<f64> {
    points.iter().filter(|point| (point[axis] - place).abs() < 1e-6).map(|point| point[1 - axis]).collect()
}

#[test]
fn the_hatch_of_a_tile_continues_across_its_seams() {
    let (document, grown) = grown("tile-petals");
    let side = f64::from(SIDE);
    let mut all = 0;
    for (spacing, angle) in [(1.3, 0.0), (2.1, 45.0), (1.7, -20.0), (2.0, 90.0)] {
        let style = Style { fill: true, hatch: Some(Hatch { spacing, angle }), ..Style::default() };
        let wanted = Outlining {
            size: [SIDE as usize; 2],
            level: 0.5,
            only: None,
            smallest: Smallest::default(),
            style,
        };
        let groups = outlines(&document, &grown, &wanted, &Watch::NONE).unwrap().0;
        let strokes = groups[0].strokes.iter();
        let ends: Vec<[f64; 2]> =
            strokes.flat_map(|stroke| [start(stroke), end(stroke)]).map(|point| [point.x, point.y]).collect();
        let outlines = groups[0].areas.iter().flat_map(dapple_engine::export::outline::Shape::paths);
        let knots: Vec<[f64; 2]> = outlines
            .flat_map(|path| path.elements().iter().filter_map(kurbo::PathEl::end_point))
            .map(|point| [point.x, point.y])
            .collect();
        let mut met = 0;
        for axis in [0, 1] {
            // Where a stroke ends at one side, another one begins at the opposite side. Exception: a stroke may be too
            // short to be drawn where the edge of a mark meets the border.
            let [low, high] = [0.0, side].map(|place| along(&ends, axis, place));
            let corners: Vec<f64> =
                [0.0, side].iter().flat_map(|place| along(&knots, axis, *place)).collect();
            let near =
                |at: f64, others: &[f64], far: f64| others.iter().any(|other| (other - at).abs() < far);
            for (here, there) in [(&low, &high), (&high, &low)] {
                for at in here {
                    let meets = near(*at, there, 0.01) || near(*at, &corners, 0.3);
                    assert!(meets, "{angle}: {at} of {here:?}, {there:?}, {corners:?}");
                }
            }
            met += low.iter().filter(|at| near(**at, &high, 0.01)).count();
        }
        println!("{angle}: {met} strokes go on");
        all += met;
    }
    assert!(all > 60, "{all}");
}

#[test]
fn a_higher_level_lies_within_a_lower_one() {
    let (document, grown) = grown("tile-petals");
    let area = |level| -> f64 {
        outlined(&document, &grown, level)[0]
            .areas
            .iter()
            .map(dapple_engine::export::outline::Shape::area)
            .sum()
    };
    let areas = [0.05, 0.3, 0.5, 0.8, 0.999].map(area);
    assert!(areas.windows(2).all(|pair| pair[0] > pair[1]), "{areas:?}");
}
