//! Fur: layers of hairs, each a bent strand with a root, a tip and the colour of the pattern beneath it.
//!
//! ```text
//! four layers ─▶ a lattice of cells in each ─▶ one hair a cell ─▶ the px that it covers, later hairs over earlier ones
//! ```
//! Colours are taken at .36 L along the hair, so that marks do not move in the mean, and from nearer where marks are small.

use std::ops::Range;

use rayon::prelude::*;

use super::flow::turned;
use super::hair::{self, BEND, Hair, LAYERS, LENGTHS, OnHair, WIDEST};
use super::noise::{Noise, Random, floor, part_seed, whole_cells, wrapped};
use super::surfel::{Source, Surfel};
use crate::grid::Edges;

/// Rows of the document that one thread paints at a time; the result does not depend on it.
const ROWS: f32 = 64.0;

/// Hairs of a mean length and width, px of the document.
#[derive(Clone, Debug)]
pub struct Fur<'a> {
    source: &'a Source<'a>,
    length: f32,
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

/// A hair on the canvas; lengths in px of the document.
#[derive(Clone, Copy, Debug)]
struct Rooted {
    hair: Hair,
    root: [f32; 2],
    along: [f32; 2],
    opacity: f32,
    /// The place along it whose colour it has.
    anchor: f32,
    /// How far the colour is carried ÷ length: 1 = the whole hair has one colour.
    carried: f32,
    colour: [f32; 4],
}

impl<'a> Fur<'a> {
    /// Fur of hairs with this mean `length`, px of the document.
    #[must_use]
    pub fn new(source: &'a Source<'a>, length: f32) -> Self {
        let cells = whole_cells(source.canvas, hair::area_a_hair(length).sqrt());
        let part = |index| part_seed(source.seed, index);
        let noise = |size: f32, index| Noise::new(source.canvas, size, part(index));
        let third = source.canvas[0].max(source.canvas[1]) / 3.0;
        Self {
            source,
            length,
            cells,
            cell: [0, 1].map(|axis| source.canvas[axis] / cells[axis] as f32),
            sway: [noise(third, 1), noise(2.2 * length, 2), noise(0.7 * length, 3)],
            shade: [noise(1.3 * length, 4), noise(6.0 * length, 5)],
            seeds: [0, 1, 2, 3].map(|layer| part(16 + layer)),
        }
    }

    /// How far a hair reaches from its root, px of the document.
    fn farthest(&self) -> f32 {
        LENGTHS[1] * self.length * (1.0 + BEND) + WIDEST * hair::mean_width(self.length) + 2.0
    }

    /// The hair of a cell; outside the lattice the hairs of a tile repeat.
    fn hair(&self, layer: usize, [column, row]: [i32; 2]) -> Rooted {
        let place = [wrapped(column, self.cells[0]), wrapped(row, self.cells[1])];
        let mut random = Random::of(self.seeds[layer], place.map(|place| place as u32));
        let jitter = [random.number(), random.number()];
        let root = [column as f32 + jitter[0], row as f32 + jitter[1]];
        let root = [root[0] * self.cell[0], root[1] * self.cell[1]];
        let turn = hair::turn([0, 1, 2].map(|k| self.sway[k].at(root)), &mut random);
        let along = turned(self.source.flow.at(root), turn);
        // From the upper left; hairs across the light are the brightest.
        let across = std::f32::consts::FRAC_1_SQRT_2 * (along[0] - along[1]).abs();
        let shade = [0, 1].map(|k| self.shade[k].at(root));
        let hair = Hair::new(&mut random, layer, self.length, across, shade);
        let anchor = [0, 1].map(|axis| root[axis] + hair.anchor() * along[axis]);
        Rooted {
            hair,
            root,
            along,
            opacity: hair.opacity(self.source.scale()[0]),
            anchor: hair.anchor(),
            carried: self.source.reach.at(anchor, hair.length) / hair.length,
            colour: self.source.at(anchor),
        }
    }
}

impl Rooted {
    /// The place on the hair that is [dx, dy] from its root, if it covers any of the px there; `scale` px of the picture are one of
    /// the document.
    #[inline(always)]
    fn at(&self, [dx, dy]: [f32; 2], scale: f32) -> Option<OnHair> {
        let along = dx * self.along[0] + dy * self.along[1];
        let across = dy * self.along[0] - dx * self.along[1];
        let on = self.hair.at([along, across], scale)?;
        Some(OnHair { cover: self.opacity * on.cover, ..on })
    }

    /// How the hair looks there; `point` is the place on the canvas.
    #[inline(always)]
    fn surfel(&self, on: &OnHair, point: [f32; 2], source: &Source) -> Surfel {
        let colour = match self.carried >= 1.0 {
            true => self.colour,
            false => {
                let along = self.carried * (self.anchor - on.local[0]);
                let across = -self.carried * on.local[1];
                let [x, y] = self.along;
                source.at([point[0] + along * x - across * y, point[1] + along * y + across * x])
            }
        };
        self.hair.surfel(on, colour)
    }

    /// Where the middle line of the hair crosses the row or column that is `line` px from its root, px from the root. `axis` is that
    /// along which it mostly lies, and `per_run` 1 ÷ the part of its direction along it.
    #[inline(always)]
    fn span(&self, line: f32, axis: usize, per_run: f32) -> f32 {
        let (run, rise) = (self.along[axis], self.along[1 - axis]);
        // Across is positive to the right of a hair, seen along it: the sign differs between the axes.
        let bend = if axis == 0 { self.hair.bend } else { -self.hair.bend };
        let bent = |along: f32| {
            let t = along * self.hair.per_length;
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
    (0..source.size[0] * source.size[1]).into_par_iter().map(|px| hair::skin(source.px(px))).collect()
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
                    let Hair { length, half_width, bend, .. } = hair.hair;
                    let tip = hair.root[1] + length * hair.along[1];
                    let margin = bend.abs() + half_width + 1.0;
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
    fn paint_hair(&self, hair: &Rooted, first: usize, rows: &mut [Surfel]) {
        let Hair { length, half_width, bend, per_length, .. } = hair.hair;
        let width = self.source.size[0];
        let scale = self.source.scale();
        let per_scale = scale.map(|scale| 1.0 / scale);
        let axis = usize::from(hair.along[0].abs() < hair.along[1].abs());
        let other = 1 - axis;
        let tip = length * hair.along[axis];
        let margin = (bend.abs() + half_width) * hair.along[other].abs() + 0.5 / scale[axis];
        let root = [0, 1].map(|axis| hair.root[axis] * scale[axis]);
        let (low, high) = if tip < 0.0 { (tip, 0.0) } else { (0.0, tip) };
        let per_run = 1.0 / hair.along[axis];
        // Along a row or column `off` changes at least by this much a px.
        let least = hair.along[axis].abs() - 2.0 * bend.abs() * per_length * hair.along[other].abs();
        let half = (half_width + 0.5 * per_scale[0] + 0.02 * bend.abs()) / least;
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
