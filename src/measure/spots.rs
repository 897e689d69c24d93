//! Spots: connected regions above a level, with their exact areas and moments.

use std::f64::consts::PI;

use crate::grid::{Edges, Field};
use crate::marks::{Ellipse, axial};
use crate::measure::marching_squares::{Moments, parts};
use crate::measure::supersampled_grid::Nodes;
use crate::measure::union_find::Pieces;

/// A connected region above the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Area of the region, px²; aspect, direction and centre of the ellipse that has its second moments.
    /// `radii[0]` is the larger. On a wrapped field the centre is folded into the canvas.
    pub ellipse: Ellipse,
    /// It touches no closed edge and is not endless: all of it was measured.
    pub whole: bool,
    /// It meets itself across a wrapped border: a stripe round the tile, no ellipse.
    pub endless: bool,
    /// Length of its outline, holes included, without the frame, px.
    pub contour: f64,
    /// Area ÷ (π·r₁·r₂), where 2√λ are the radii of an ellipse of second moments λ: 1 for an ellipse, 0.955
    /// for a rectangle, below 0.93 for what has merged or is bent.
    pub fill: f64,
    /// Its highest value.
    pub peak: f32,
}

/// The spots of a field, and how many specks were left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Census {
    /// In reading order of their first row.
    pub spots: Vec<Spot>,
    /// Regions under 2 cells of the field, or under 5 % of the usual area (that at which half of all that is
    /// inside has been reached).
    pub specks: usize,
}

/// A region of fewer cells of the field than this is a speck: noise, or a corner of something at the border.
const SPECK_CELLS: f64 = 2.0;

/// So is one of less than this share of the area that half of all that is inside has reached.
const SPECK_SHARE: f64 = 0.05;

/// The regions above `level`, specks left out; see [`census`].
#[must_use]
pub fn spots(field: &Field, level: f32) -> Vec<Spot> {
    census(field, level).spots
}

/// The regions above `level`.
///
/// The field is read on a grid so fine that the numbers are those of the smooth surface through it
/// ([`crate::grid::resample::Spline`]): area to 0.1 % for spots over 5 cells. Neighbours belong together where
/// they share a side, or the mean of the four around a corner is above the level. On closed edges the field
/// ends half a cell beyond its outermost centres; on wrapped ones regions are joined across the border and
/// measured in one piece.
///
/// Memory: besides the field, its spline (as much again) and a band of 4 MB.
#[must_use]
pub fn census(field: &Field, level: f32) -> Census {
    let coarse = regions(field, level, 1);
    let cell = field.cell[0] * field.cell[1];
    // What is cut may be small without its marks being so, and what is tiny is a speck.
    let counts = |region: &&Region| region.moments.area > SPECK_CELLS * cell && !region.touches;
    let mut areas: Vec<f64> = coarse.iter().filter(counts).map(|region| region.moments.area / cell).collect();
    areas.sort_by(f64::total_cmp);
    // Without any, two nodes a cell show what may be between the cells.
    let factor = areas.get(areas.len() / 10).map_or(2, |small| factor(*small));
    sift(&regions(field, level, factor), field)
}

/// Nodes a cell (each way) that measure regions of `area` cells well.
///
/// With nodes h cells apart, chords and linear crossings cost an area A of the order h² ÷ A; 0.0012 of that was
/// found to leave errors under 0.1 % (`tests/ruler.rs`).
fn factor(area: f64) -> usize {
    ((1.0 / (0.0012 * area)).sqrt().ceil() as usize).clamp(2, 8)
}

/// What is known of a region once all rows were seen.
#[derive(Clone, Copy, Debug)]
struct Region {
    moments: Moments,
    contour: f64,
    peak: f32,
    touches: bool,
    endless: bool,
}

const NOTHING: Region = Region {
    moments: Moments { area: 0.0, x: 0.0, y: 0.0, xx: 0.0, xy: 0.0, yy: 0.0 },
    contour: 0.0,
    peak: f32::NEG_INFINITY,
    touches: false,
    endless: false,
};

/// Not inside.
const OUT: u32 = u32::MAX;

/// Gathers regions while rows of nodes come by.
struct Gatherer<'a> {
    xs: &'a [f64],
    level: f32,
    edges: Edges,
    /// Is the first row the border of the field?
    top: bool,
    pieces: Pieces,
    known: Vec<Region>,
    /// The row above: its y, values and labels.
    y: f64,
    values: Vec<f32>,
    labels: Vec<u32>,
    first: Vec<u32>,
}

fn regions(field: &Field, level: f32, factor: usize) -> Vec<Region> {
    let nodes = Nodes::new(field, factor);
    let gatherer = |top| Gatherer {
        xs: &nodes.xs,
        level,
        edges: field.edges,
        top,
        pieces: Pieces::default(),
        known: Vec::new(),
        y: 0.0,
        values: Vec::new(),
        labels: Vec::new(),
        first: Vec::new(),
    };
    let stretches = nodes.stretches(|ys, values, top| {
        let mut gatherer = gatherer(top);
        for (y, values) in ys.iter().zip(values.chunks_exact(nodes.xs.len())) {
            gatherer.row(*y, values);
        }
        gatherer
    });
    let mut stretches = stretches.into_iter();
    let Some(mut all) = stretches.next() else { return Vec::new() };
    stretches.for_each(|stretch| all.append(stretch));
    all.finish(field.extent())
}

impl Gatherer<'_> {
    fn row(&mut self, y: f64, values: &[f32]) {
        let labels = self.label(values);
        if self.values.is_empty() {
            self.first.clone_from(&labels);
            if self.top {
                self.touch(&labels);
            }
        } else {
            self.strip(y, values, &labels);
        }
        self.y = y;
        self.values.clear();
        self.values.extend_from_slice(values);
        self.labels = labels;
    }

    /// Goes on with what was gathered of the rows below, from the last row of this on.
    fn append(&mut self, mut below: Self) {
        let offset = self.known.len() as u32;
        for piece in 0..below.known.len() as u32 {
            self.pieces.add();
            let (root, shift) = below.pieces.find(piece);
            self.pieces.join(offset + root, offset + piece, shift);
            if piece == root && below.pieces.is_endless(root) {
                self.pieces.close(offset + root);
            }
        }
        self.known.append(&mut below.known);
        for (above, below) in self.labels.iter().zip(&below.first).filter(|(above, _)| **above != OUT) {
            self.pieces.join(*above, offset + below, [0, 0]);
        }
        let moved = |label: &u32| if *label == OUT { OUT } else { offset + label };
        self.labels = below.labels.iter().map(moved).collect();
    }

    /// Gives each inside node of a row a piece: its left neighbour's, the one's above, or a new one.
    fn label(&mut self, values: &[f32]) -> Vec<u32> {
        let mut labels = vec![OUT; values.len()];
        let (mut left, mut peak) = (OUT, f32::NEG_INFINITY);
        for (i, value) in values.iter().enumerate() {
            if *value > self.level {
                let above = self.labels.get(i).copied().unwrap_or(OUT);
                if left == OUT {
                    left = if above == OUT { self.begin() } else { above };
                } else if above != OUT && above != left {
                    self.pieces.join(above, left, [0, 0]);
                }
                labels[i] = left;
                peak = peak.max(*value);
            } else if left != OUT {
                self.reach(left, peak);
                (left, peak) = (OUT, f32::NEG_INFINITY);
            }
        }
        if left != OUT {
            self.reach(left, peak);
        }
        let ends = [labels[0], labels[labels.len() - 1]];
        match self.edges {
            Edges::Closed => self.touch(&ends),
            Edges::Wrap if ends[0] != OUT => self.pieces.join(ends[1], ends[0], [1, 0]),
            Edges::Wrap => {}
        }
        labels
    }

    fn reach(&mut self, piece: u32, peak: f32) {
        let region = &mut self.known[piece as usize];
        region.peak = region.peak.max(peak);
    }

    fn begin(&mut self) -> u32 {
        self.known.push(NOTHING);
        self.pieces.add()
    }

    /// These nodes are on a border: on a closed one, what they belong to is cut.
    fn touch(&mut self, labels: &[u32]) {
        if self.edges == Edges::Closed {
            for label in labels.iter().filter(|label| **label != OUT) {
                self.known[*label as usize].touches = true;
            }
        }
    }

    /// Adds up the squares between the row above and this one.
    fn strip(&mut self, y: f64, values: &[f32], labels: &[u32]) {
        let (xs, top) = (self.xs, self.y);
        let mut full = None;
        let mut right = u8::from(self.labels[0] != OUT) + u8::from(labels[0] != OUT);
        for i in 0..xs.len() - 1 {
            let left = right;
            right = u8::from(self.labels[i + 1] != OUT) + u8::from(labels[i + 1] != OUT);
            if left + right == 4 {
                full.get_or_insert(i);
                continue;
            }
            if let Some(from) = full.take() {
                self.fill(from, [xs[from], xs[i]], y);
            }
            if left + right == 0 {
                continue;
            }
            let four = [self.labels[i], self.labels[i + 1], labels[i + 1], labels[i]];
            let v = [self.values[i], self.values[i + 1], values[i + 1], values[i]];
            let v = v.map(|v| f64::from(v) - f64::from(self.level));
            parts([xs[i], top], [xs[i + 1] - xs[i], y - top], v, |part| {
                let region = &mut self.known[four[part.corner] as usize];
                region.moments.add(&part.moments);
                region.contour += part.contour;
                if let Some(across) = part.across {
                    self.pieces.join(four[part.corner], four[across], [0, 0]);
                }
            });
        }
        if let Some(from) = full {
            self.fill(from, [xs[from], xs[xs.len() - 1]], y);
        }
    }

    /// Squares from node `from` on, in the strip that ends at `y`, that are all inside.
    fn fill(&mut self, from: usize, x: [f64; 2], y: f64) {
        let region = &mut self.known[self.labels[from] as usize];
        region.moments.add(&Moments::rectangle(x, [self.y, y]));
    }

    fn finish(mut self, [width, height]: [f64; 2]) -> Vec<Region> {
        let last = std::mem::take(&mut self.labels);
        self.touch(&last);
        if self.edges == Edges::Wrap {
            for (low, high) in last.iter().zip(&self.first).filter(|(low, _)| **low != OUT) {
                self.pieces.join(*low, *high, [0, 1]);
            }
        }
        let mut whole = vec![NOTHING; self.pieces.len()];
        for piece in 0..self.pieces.len() {
            let (root, [across, down]) = self.pieces.find(piece as u32);
            let (seen, region) = (&self.known[piece], &mut whole[root as usize]);
            region.moments.add(&seen.moments.moved([f64::from(across) * width, f64::from(down) * height]));
            region.contour += seen.contour;
            region.peak = region.peak.max(seen.peak);
            region.touches |= seen.touches;
            region.endless = self.pieces.is_endless(root);
        }
        whole.retain(|region| region.moments.area > 0.0);
        whole
    }
}

/// Regions → spots, without the specks.
fn sift(regions: &[Region], field: &Field) -> Census {
    let mut areas: Vec<f64> = regions.iter().map(|region| region.moments.area).collect();
    areas.sort_by(f64::total_cmp);
    let half = 0.5 * areas.iter().sum::<f64>();
    let mut reached = 0.0;
    let usual = areas.iter().find(|area| {
        reached += **area;
        reached >= half
    });
    let least = (SPECK_CELLS * field.cell[0] * field.cell[1]).max(SPECK_SHARE * usual.unwrap_or(&0.0));
    let spots: Vec<Spot> = regions
        .iter()
        .filter(|region| region.moments.area >= least)
        .map(|region| spot(region, field))
        .collect();
    Census { specks: regions.len() - spots.len(), spots }
}

fn spot(region: &Region, field: &Field) -> Spot {
    let Moments { area, x, y, xx, xy, yy } = region.moments;
    let [cx, cy] = [x / area, y / area];
    let [xx, xy, yy] = [xx / area - cx * cx, xy / area - cx * cy, yy / area - cy * cy];
    // Eigenvalues of the covariance: those of an ellipse are r² ÷ 4.
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let apart = (half * half + xy * xy).sqrt();
    let (major, minor) = (mean + apart, (mean - apart).max(0.0));
    let aspect = (minor / major).sqrt().clamp(1e-6, 1.0);
    let angle = axial(0.5 * libm::atan2(xy, half).to_degrees());
    let mut center = [cx, cy];
    if field.edges == Edges::Wrap {
        let extent = field.extent();
        center = [cx.rem_euclid(extent[0]), cy.rem_euclid(extent[1])];
    }
    Spot {
        ellipse: Ellipse::from_area(center, area, aspect, angle),
        whole: !region.touches && !region.endless,
        endless: region.endless,
        contour: region.contour,
        fill: area / (4.0 * PI * (major * minor).sqrt()).max(f64::MIN_POSITIVE),
        peak: region.peak,
    }
}

#[cfg(test)]
mod tests;
