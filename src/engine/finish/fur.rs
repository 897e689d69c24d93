//! Fur: layers of hairs, each a bent strand with a root, a tip and the colour of the pattern beneath it.
//!
//! ```text
//! four layers ─▶ a lattice of cells in each ─▶ one hair a cell ─▶ the px that it covers, later hairs over earlier ones
//! ```
//! At t along a hair of length L, from its root (0) to its tip (1), and v px off its middle line:
//! half width h·min(1, 4(1 − t))·(.55 + .45·min(1, 6t)); middle line bent by b·L·t²; brightness (.72 + .4t)·(1 − .3(v ÷ h)²).
//! Colours are taken at .36 L along the hair, so that marks do not move in the mean, and from nearer where marks are small.

use std::ops::Range;

use rayon::prelude::*;

use super::flow::turned;
use super::noise::{Noise, Random, floor, part_seed, whole_cells, wrapped};
use super::surfel::{Source, Surfel};
use crate::grid::Edges;

/// Layers of hairs, the lowest first.
const LAYERS: usize = 4;
/// The mean number of hairs over a place.
const COVER: f32 = 4.0;
/// Opacity of a hair.
const OPACITY: f32 = 0.92;
/// Along a hair, the place whose colour it has.
const ANCHOR: f32 = 0.36;
/// The longest and the shortest hair ÷ their mean length.
const LENGTHS: [f32; 2] = [0.55, 1.55];
/// The widest hair ÷ the mean width.
const WIDEST: f32 = 1.4;
/// The largest bend ÷ length.
const BEND: f32 = 0.16;
/// Brightness of the skin beneath the hairs.
const SKIN: f32 = 0.45;
/// Rows of the document that one thread paints at a time; the result does not depend on it.
const ROWS: f32 = 64.0;

/// Hairs of a mean length and width, px of the document.
#[derive(Clone, Debug)]
pub struct Fur<'a> {
    source: &'a Source<'a>,
    length: f32,
    width: f32,
    /// Cells of the lattice.
    cells: [usize; 2],
    /// Width and height of a cell, px of the document.
    cell: [f32; 2],
    /// Directions: over a third of the canvas, of locks, of single strands.
    sway: [Noise; 3],
    /// Brightness: of locks, of the coat.
    shade: [Noise; 2],
    seeds: [u32; LAYERS],
}

/// One hair; lengths in px of the document.
#[derive(Clone, Copy, Debug)]
struct Hair {
    root: [f32; 2],
    along: [f32; 2],
    length: f32,
    half_width: f32,
    bend: f32,
    tint: f32,
    light: f32,
    /// How far light that the surface of the hair mirrors makes it white, which shows on dark hair.
    sheen: f32,
    roughness: f32,
    /// Height of the root, and by how much the tip is higher.
    height: f32,
    rise: f32,
    opacity: f32,
    /// 1 ÷ length, 1 ÷ half width².
    per_length: f32,
    per_half_width_squared: f32,
    /// The place along it whose colour it has.
    anchor: f32,
    /// How far the colour is carried ÷ length: 1 = the whole hair has one colour.
    carried: f32,
    colour: [f32; 4],
}

/// A place on a hair.
#[derive(Clone, Copy, Debug)]
struct OnHair {
    /// From the root, 0, to the tip, 1.
    t: f32,
    /// Off its middle line, px of the document.
    off: f32,
    /// Along and across the straight line through its root.
    local: [f32; 2],
    cover: f32,
}

impl<'a> Fur<'a> {
    /// Fur of hairs with this mean `length`, px of the document.
    #[must_use]
    pub fn new(source: &'a Source<'a>, length: f32) -> Self {
        let width = 0.75 + 0.02 * length;
        let cell = (0.8 * LAYERS as f32 * length * width / COVER).sqrt();
        let cells = whole_cells(source.canvas, cell);
        let part = |index| part_seed(source.seed, index);
        let noise = |size: f32, index| Noise::new(source.canvas, size, part(index));
        let third = source.canvas[0].max(source.canvas[1]) / 3.0;
        Self {
            source,
            length,
            width,
            cells,
            cell: [0, 1].map(|axis| source.canvas[axis] / cells[axis] as f32),
            sway: [noise(third, 1), noise(2.2 * length, 2), noise(0.7 * length, 3)],
            shade: [noise(1.3 * length, 4), noise(6.0 * length, 5)],
            seeds: [0, 1, 2, 3].map(|layer| part(16 + layer)),
        }
    }

    /// How far a hair reaches from its root, px of the document.
    fn farthest(&self) -> f32 {
        LENGTHS[1] * self.length * (1.0 + BEND) + WIDEST * self.width + 2.0
    }

    /// The hair of a cell; outside the lattice the hairs of a tile repeat.
    fn hair(&self, layer: usize, [column, row]: [i32; 2]) -> Hair {
        let place = [wrapped(column, self.cells[0]), wrapped(row, self.cells[1])];
        let mut random = Random::of(self.seeds[layer], place.map(|place| place as u32));
        let jitter = [random.number(), random.number()];
        let root = [column as f32 + jitter[0], row as f32 + jitter[1]];
        let root = [root[0] * self.cell[0], root[1] * self.cell[1]];
        let [slow, lock, strand] = [0, 1, 2].map(|k| self.sway[k].at(root));
        let turn = 0.3 * slow + 0.3 * lock + 0.22 * strand + 0.1 * random.signed();
        let along = turned(self.source.flow.at(root), turn);
        let [shortest, longest] = LENGTHS;
        let length = self.length * (shortest + (longest - shortest) * random.number());
        let half_width = 0.5 * self.width * (0.6 + (WIDEST - 0.6) * random.number());
        let bend = BEND * length * random.signed();
        let anchor = [0, 1].map(|axis| root[axis] + ANCHOR * length * along[axis]);
        let carried = self.source.reach.at(anchor, length) / length;
        // From the upper left; hairs across the light are the brightest.
        let across = std::f32::consts::FRAC_1_SQRT_2 * (along[0] - along[1]).abs();
        let hair = 1.0 + 0.3 * random.signed();
        let glossy = random.number();
        let locks = 1.0 + 0.2 * self.shade[0].at(root);
        let coat = 1.0 + 0.1 * self.shade[1].at(root);
        Hair {
            root,
            along,
            length,
            half_width,
            bend,
            tint: hair * locks * coat,
            light: 0.82 + 0.28 * across,
            sheen: 0.16 * glossy * glossy * (0.4 + 0.6 * across),
            roughness: 0.55 + 0.2 * random.number(),
            height: 0.7 * layer as f32,
            rise: 0.12 * length,
            // A hair that is thinner than a px covers a part of it.
            opacity: OPACITY * (2.0 * half_width * self.source.scale()[0]).min(1.0),
            per_length: 1.0 / length,
            per_half_width_squared: 1.0 / (half_width * half_width),
            anchor: ANCHOR * length,
            carried,
            colour: self.source.at(anchor),
        }
    }
}

/// The smaller of two numbers; unlike the library's function not for numbers that are undefined, and so faster.
#[inline(always)]
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

impl Hair {
    /// The place on the hair that is [dx, dy] from its root, if it covers any of the px there; `scale` px of the picture are one of
    /// the document.
    #[inline(always)]
    fn at(&self, [dx, dy]: [f32; 2], scale: f32) -> Option<OnHair> {
        let along = dx * self.along[0] + dy * self.along[1];
        let across = dy * self.along[0] - dx * self.along[1];
        let t = along * self.per_length;
        let off = across - self.bend * t * t;
        let half = self.half_width * least(4.0 - 4.0 * t, 1.0) * (0.55 + 0.45 * least(6.0 * t, 1.0));
        let inside = (half - off.abs()) * scale + 0.5;
        if !((0.0..=1.0).contains(&t) && inside > 0.0) {
            return None;
        }
        Some(OnHair { t, off, local: [along, across], cover: self.opacity * least(inside, 1.0) })
    }

    /// How the hair looks there; `point` is the place on the canvas.
    #[inline(always)]
    fn surfel(&self, on: &OnHair, point: [f32; 2], source: &Source) -> Surfel {
        let [red, green, blue, ink] = match self.carried >= 1.0 {
            true => self.colour,
            false => {
                let along = self.carried * (self.anchor - on.local[0]);
                let across = -self.carried * on.local[1];
                let [x, y] = self.along;
                source.at([point[0] + along * x - across * y, point[1] + along * y + across * x])
            }
        };
        let round = least(on.off * on.off * self.per_half_width_squared, 1.0);
        Surfel {
            colour: [red, green, blue].map(|channel| channel + self.sheen * (1.0 - channel)),
            tint: self.tint * (0.72 + 0.4 * on.t) * (1.0 - 0.3 * round),
            light: self.light,
            height: self.height + self.rise * on.t,
            roughness: self.roughness,
            ink,
        }
    }

    /// Where the middle line of the hair crosses the row or column that is `line` px from its root, px from the root. `axis` is that
    /// along which it mostly lies, and `per_run` 1 ÷ the part of its direction along it.
    #[inline(always)]
    fn span(&self, line: f32, axis: usize, per_run: f32) -> f32 {
        let (run, rise) = (self.along[axis], self.along[1 - axis]);
        // Across is positive to the right of a hair, seen along it: the sign differs between the axes.
        let bend = if axis == 0 { self.bend } else { -self.bend };
        let bent = |along: f32| {
            let t = along * self.per_length;
            bend * t * t
        };
        let straight = line * per_run;
        let once = (line + bent(straight) * rise) * per_run;
        let twice = (line + bent(once) * rise) * per_run;
        let along = (line + bent(twice) * rise) * per_run;
        along * rise + bent(along) * run
    }
}

/// The finished px of the whole picture.
#[must_use]
pub fn paint(source: &Source, length: f32) -> Vec<Surfel> {
    let fur = Fur::new(source, length);
    let mut picture = skin(source);
    let width = source.size[0];
    let rows = ((ROWS * source.scale()[1]) as usize).max(1);
    picture.par_chunks_mut(rows * width).enumerate().for_each(|(strip, px)| fur.paint_rows(strip * rows, px));
    picture
}

/// The skin beneath all hairs.
fn skin(source: &Source) -> Vec<Surfel> {
    let px = |px: usize| {
        let [red, green, blue, ink] = source.px(px);
        Surfel { colour: [red, green, blue], tint: SKIN, light: 1.0, height: 0.0, roughness: 0.8, ink }
    };
    (0..source.size[0] * source.size[1]).into_par_iter().map(px).collect()
}

/// The finished px, one after the other, each with all hairs near it: what [`paint`] is compared with.
#[cfg(test)]
pub fn paint_plainly(source: &Source, length: f32) -> Vec<Surfel> {
    let fur = Fur::new(source, length);
    let mut picture = skin(source);
    let (width, scale) = (source.size[0], source.scale());
    let around = |at: f32, axis: usize| {
        floor((at - fur.farthest()) / fur.cell[axis])..=floor((at + fur.farthest()) / fur.cell[axis]) + 1
    };
    for (px, surfel) in picture.iter_mut().enumerate() {
        let place = [px % width, px / width];
        let point = [0, 1].map(|axis| (place[axis] as f32 + 0.5) * (1.0 / scale[axis]));
        for layer in 0..LAYERS {
            for row in around(point[1], 1) {
                // In the order of the columns of the tile; beyond its border the hairs of the other side.
                let wraps = source.edges == Edges::Wrap;
                let mut columns: Vec<i32> = around(point[0], 0).collect();
                columns.sort_by_key(
                    |column| if wraps { wrapped(*column, fur.cells[0]) as i32 } else { *column },
                );
                for column in columns {
                    let tiles = if wraps { column.div_euclid(fur.cells[0] as i32) } else { 0 };
                    let hair = fur.hair(layer, [column - tiles * fur.cells[0] as i32, row]);
                    let x = place[0] as i32 - tiles * width as i32;
                    let point = [(x as f32 + 0.5) * (1.0 / scale[0]), point[1]];
                    let from_root = [point[0] - hair.root[0], point[1] - hair.root[1]];
                    if let Some(on) = hair.at(from_root, scale[0]) {
                        *surfel = surfel.covered(&hair.surfel(&on, point, source), on.cover);
                    }
                }
            }
        }
    }
    picture
}

impl Fur<'_> {
    /// Paints all hairs over some rows of the picture, the first of which is `first`.
    fn paint_rows(&self, first: usize, rows: &mut [Surfel]) {
        let height = rows.len() / self.source.size[0];
        let scale = self.source.scale()[1];
        let [top, bottom] = [first as f32, (first + height) as f32].map(|row| row / scale);
        for layer in 0..LAYERS {
            let from = ((top - self.farthest()) / self.cell[1]).floor() as i32;
            let to = ((bottom + self.farthest()) / self.cell[1]).ceil() as i32;
            for row in from..=to {
                for column in self.columns() {
                    let hair = self.hair(layer, [column, row]);
                    let tip = hair.root[1] + hair.length * hair.along[1];
                    let margin = hair.bend.abs() + hair.half_width + 1.0;
                    if hair.root[1].max(tip) + margin >= top && hair.root[1].min(tip) - margin <= bottom {
                        self.paint_hair(&hair, first, rows);
                    }
                }
            }
        }
    }

    /// Columns of the lattice whose hairs reach the picture. On a tile those of its own: they continue at the other side.
    fn columns(&self) -> Range<i32> {
        let columns = self.cells[0] as i32;
        match self.source.edges {
            Edges::Wrap => 0..columns,
            Edges::Closed => {
                let beyond = floor(self.farthest() / self.cell[0]) + 1;
                -beyond..columns + beyond
            }
        }
    }

    /// Paints one hair over some rows of the picture.
    fn paint_hair(&self, hair: &Hair, first: usize, rows: &mut [Surfel]) {
        let width = self.source.size[0];
        let scale = self.source.scale();
        let per_scale = scale.map(|scale| 1.0 / scale);
        let axis = usize::from(hair.along[0].abs() < hair.along[1].abs());
        let other = 1 - axis;
        let tip = hair.length * hair.along[axis];
        let margin = (hair.bend.abs() + hair.half_width) * hair.along[other].abs() + 0.5 / scale[axis];
        let root = [0, 1].map(|axis| hair.root[axis] * scale[axis]);
        let (low, high) = if tip < 0.0 { (tip, 0.0) } else { (0.0, tip) };
        let per_run = 1.0 / hair.along[axis];
        // Along a row or column `off` changes at least by this much a px.
        let least =
            hair.along[axis].abs() - 2.0 * hair.bend.abs() * hair.per_length * hair.along[other].abs();
        let half = (hair.half_width + 0.5 * per_scale[0] + 0.02 * hair.bend.abs()) / least;
        let strip = first as i32..(first + rows.len() / width) as i32;
        let across = match self.source.edges {
            Edges::Wrap => i32::MIN..i32::MAX,
            Edges::Closed => 0..width as i32,
        };
        let within = |range: Range<i32>, is_row: bool| {
            let allowed = if is_row { &strip } else { &across };
            range.start.max(allowed.start)..range.end.min(allowed.end)
        };
        let lines = floor(root[axis] + (low - margin) * scale[axis])
            ..floor(root[axis] + (high + margin) * scale[axis]) + 1;
        for line in within(lines, axis == 1) {
            let middle = hair.span((line as f32 + 0.5) * per_scale[axis] - hair.root[axis], axis, per_run);
            let ends = [middle - half, middle + half].map(|end| root[other] + end * scale[other] - 0.5);
            for place in within(floor(ends[0]) + 1..floor(ends[1]) + 1, axis == 0) {
                let [x, y] = if axis == 0 { [line, place] } else { [place, line] };
                let point = [(x as f32 + 0.5) * per_scale[0], (y as f32 + 0.5) * per_scale[1]];
                let from_root = [point[0] - hair.root[0], point[1] - hair.root[1]];
                if let Some(on) = hair.at(from_root, scale[0]) {
                    let px = &mut rows[(y as usize - first) * width + wrapped(x, width)];
                    *px = px.covered(&hair.surfel(&on, point, self.source), on.cover);
                }
            }
        }
    }
}
