//! Examples, grown small: what their outlines enclose, and how an SVG library paints them.

use dapple::export::outline::svg::{self, Sheet, Unit};
use dapple::export::outline::{Group, Smallest, Style};
use dapple::synth::outlining::{Outlining, outlines};
use dapple::synth::painting::Painting;
use dapple::synth::recipe::Document;
use dapple::synth::{Grown, Options, Training, Watch, grow};
use rayon::prelude::*;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg;
use std::path::Path;

/// Spots, stripes, tiles, and layers on layers.
const EXAMPLES: [&str; 7] = [
    "cheetah-run",
    "zebra",
    "tile-petals",
    "tile-waves",
    "poppy-seeds",
    "gallery/phan-grimm-13-leopard",
    "gallery/turk-2-lower-left-cheetah",
];
/// Side of the canvas that they are grown on, px.
const SIDE: u32 = 200;

fn grown(name: &str) -> (Document, Grown) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"));
    let document = Document::read(file).unwrap();
    let options = Options { size: Some([SIDE; 2]), refine: Some(false), ..Options::default() };
    let grown = grow(&document, name, &Training::default(), options, &Watch::NOBODY).unwrap();
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
    outlines(document, grown, &wanted, &Watch::NOBODY).unwrap().0
}

/// Which layer's mark covers each px, at `scale` times the px.
fn labels(document: &Document, grown: &Grown, scale: usize) -> Vec<u8> {
    let painting = Painting::of(document, grown, scale);
    let mut labels = vec![0; painting.size[0] * painting.size[1]];
    painting.band(0..painting.size[1]).labels(&mut labels);
    labels
}

/// The share of the canvas on which marks are painted by resvg.
fn painted(groups: &[Group]) -> Vec<bool> {
    let sheet = Sheet { title: String::new(), size: [f64::from(SIDE); 2], unit: Unit::Px, stroke_width: 1.0 };
    let mut text = Vec::new();
    svg::write(&mut text, &sheet, groups).unwrap();
    let tree = usvg::Tree::from_data(&text, &usvg::Options::default()).unwrap();
    let mut pixmap = Pixmap::new(SIDE, SIDE).unwrap();
    resvg::render(&tree, Transform::identity(), &mut pixmap.as_mut());
    pixmap.pixels().iter().map(|px| px.alpha() >= 128).collect()
}

#[test]
fn outlines_enclose_the_area_of_the_pattern_and_are_painted_as_it() {
    let complaints: Vec<String> = EXAMPLES.par_iter().flat_map(|name| complaints(name)).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

fn complaints(name: &str) -> Vec<String> {
    let (document, grown) = grown(name);
    let groups = outlined(&document, &grown, 0.5);
    let mut complaints = Vec::new();
    let fine = labels(&document, &grown, 6);
    for (index, layer) in document.layers.iter().enumerate() {
        let count = fine.iter().filter(|label| usize::from(**label) == index + 1).count();
        let wanted = count as f64 / 36.0;
        let found: f64 = groups
            .iter()
            .filter(|group| group.name == layer.name)
            .map(|group| group.areas.iter().map(dapple::export::outline::Shape::area).sum::<f64>())
            .sum();
        println!("{name}, {}: {found:.1} px² of {wanted:.1}: {:+.4}", layer.name, found / wanted - 1.0);
        if (found - wanted).abs() > 0.005 * wanted {
            complaints.push(format!("{name}, {}: {found} px² of {wanted}", layer.name));
        }
    }
    let seen = labels(&document, &grown, 1);
    let painted = painted(&groups);
    let differ = seen.iter().zip(&painted).filter(|(label, painted)| (**label > 0) != **painted).count();
    println!("{name}: {differ} px of {} differ", seen.len());
    // A px at an edge is painted by how much of it is covered, and labelled by its middle; of thin stripes half of all
    // are at one.
    if differ * 100 > seen.len() {
        complaints.push(format!("{name}: {differ} px differ"));
    }
    complaints
}

#[test]
fn a_higher_level_lies_within_a_lower_one() {
    let (document, grown) = grown("tile-petals");
    let area = |level| -> f64 {
        outlined(&document, &grown, level)[0].areas.iter().map(dapple::export::outline::Shape::area).sum()
    };
    let areas = [0.05, 0.3, 0.5, 0.8, 0.999].map(area);
    assert!(areas.windows(2).all(|pair| pair[0] > pair[1]), "{areas:?}");
}
