//! The map as a picture.

use std::fmt::Write;

use dapple::tone::ToneImage;
use dapple_engine::rd::GrowthMap;

use super::patch::{Kind, Patch, SIDE};

/// Margins of the patches, px: left, above, right, below.
const AROUND: [f64; 4] = [58.0, 30.0, 12.0, 46.0];
/// Width of the strips of the picture in the SVG, px.
const STRIP: usize = 16 * SIDE;
/// The colour of texts and axes: equally far from white and from black.
const GREY: &str = "#7a7a7a";
/// The colour of border lines and names (Okabe & Ito, 2008).
const BORDER: &str = "#d55e00";
/// The decay of layers.
const USUAL: f32 = 20.0;

/// All patches, ink black, and their size.
pub fn gray(map: &GrowthMap, patches: &[Patch]) -> ([usize; 2], Vec<u8>) {
    let [columns, rows] = map.patches;
    let size = [columns * SIDE, rows * SIDE];
    let px = |px: usize| {
        let [x, y] = [px % size[0], px / size[0]];
        let patch = &patches[(rows - 1 - y / SIDE) * columns + x / SIDE];
        let ink = patch.pattern[y % SIDE * SIDE + x % SIDE];
        // Steeper than b itself, so that edges are visible.
        (255.0 * (1.5 - 2.0 * ink).clamp(0.0, 1.0)).round() as u8
    };
    (size, (0..size[0] * size[1]).map(px).collect())
}

/// The picture of `size` px with axes, borders and names.
pub fn svg(map: &GrowthMap, patches: &[Patch], size: [usize; 2], values: &[u8]) -> String {
    let [left, top, right, below] = AROUND;
    let [width, height] = size.map(|px| px as f64);
    let side = SIDE as f64;
    let [columns, rows] = map.patches;
    let whole = [width + left + right, height + top + below];
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" font-family=\"sans-serif\">\n\
         <title>What Turing's growth makes at each growth and decay</title>\n",
        whole[0], whole[1]
    );
    svg += &strips(size, values);
    let at = |column: f64, row: f64| [left + column * side, top + height - row * side];
    for column in (0..columns).step_by(2) {
        let [x, y] = at(column as f64 + 0.5, 0.0);
        svg += &words([x, y + 18.0], "middle", 14, &map.growth(column).to_string());
    }
    for row in 0..rows {
        let [x, y] = at(0.0, row as f64 + 0.5);
        svg += &words([x - 6.0, y + 5.0], "end", 14, &map.decay(row).to_string());
    }
    svg += &words([left + 0.5 * width, top + height + 40.0], "middle", 16, "growth G");
    svg += &words([left - 6.0, top - 10.0], "end", 16, "decay");
    svg += &borders(map, patches, &at);
    svg += &names(map, patches, &at);
    svg + &usual(map, &at) + "</svg>\n"
}

/// The picture in vertical strips, which are as wide as pictures in documents may be.
fn strips([width, height]: [usize; 2], values: &[u8]) -> String {
    let strip = |from: usize| {
        let columns = from..width.min(from + STRIP);
        let rows = values.chunks(width).flat_map(|row| row[columns.clone()].iter().copied());
        let picture = ToneImage::new([columns.len(), height], rows.collect())?;
        Some(format!(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{height}\" href=\"data:image/png;base64,{}\"/>\n",
            AROUND[0] + from as f64,
            AROUND[1],
            columns.len(),
            picture.base64()
        ))
    };
    (0..width).step_by(STRIP).filter_map(strip).collect()
}

/// The place of the border `column`, `row` of a patch, px.
type At<'a> = &'a dyn Fn(f64, f64) -> [f64; 2];

/// Lines between patches of different kinds.
fn borders(map: &GrowthMap, patches: &[Patch], at: At) -> String {
    let [columns, rows] = map.patches;
    let kind = |column: usize, row: usize| patches[row * columns + column].kind;
    let mut path = String::new();
    let mut line = |[x, y]: [f64; 2], [to_x, to_y]: [f64; 2]| {
        // Writing to a String cannot fail.
        let _ = write!(path, "M{x} {y}L{to_x} {to_y}");
    };
    for row in 0..rows {
        for column in 0..columns {
            let [x, y] = [column, row].map(|k| k as f64);
            if column + 1 < columns && kind(column, row) != kind(column + 1, row) {
                line(at(x + 1.0, y), at(x + 1.0, y + 1.0));
            }
            if row + 1 < rows && kind(column, row) != kind(column, row + 1) {
                line(at(x, y + 1.0), at(x + 1.0, y + 1.0));
            }
        }
    }
    format!("<path d=\"{path}\" fill=\"none\" stroke=\"{BORDER}\" stroke-width=\"3\"/>\n")
}

/// The name of each kind, in the row where most of its patches are.
fn names(map: &GrowthMap, patches: &[Patch], at: At) -> String {
    let columns = map.patches[0];
    let kinds = [Kind::Empty, Kind::Dots, Kind::Worms, Kind::Holes, Kind::Full];
    let mut svg = String::new();
    for kind in kinds {
        let place = |(row, of_row): (usize, &[Patch])| {
            let found: Vec<usize> = (0..columns).filter(|column| of_row[*column].kind == kind).collect();
            (found.len(), row, found.get(found.len() / 2).copied().unwrap_or(0))
        };
        let rows = patches.chunks(columns).enumerate().map(place);
        let Some((count, row, middle)) = rows.max_by_key(|(count, row, _)| (*count, *row)) else { continue };
        if count > 0 {
            let [x, y] = at(middle as f64 + 0.5, row as f64 + 0.5);
            let width = 9.0 * kind.name().len() as f64 + 10.0;
            svg += &format!(
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{width}\" height=\"24\" rx=\"4\" fill=\"#ffffff\"/>\n\
                 <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" font-size=\"17\" fill=\"{BORDER}\">{}</text>\n",
                x - 0.5 * width,
                y - 12.0,
                y + 6.0,
                kind.name()
            );
        }
    }
    svg
}

/// A frame around the decay of layers.
fn usual(map: &GrowthMap, at: At) -> String {
    let Some(row) = (0..map.patches[1]).find(|row| map.decay(*row) == USUAL) else { return String::new() };
    let [x, y] = at(0.0, row as f64 + 1.0);
    let width = map.patches[0] * SIDE;
    format!(
        "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{SIDE}\" fill=\"none\" stroke=\"{GREY}\" stroke-width=\"2\" stroke-dasharray=\"7 5\"/>\n"
    )
}

fn words([x, y]: [f64; 2], anchor: &str, size: u32, text: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" fill=\"{GREY}\">{text}</text>\n"
    )
}
