//! Spots: connected regions above a level, with their exact areas and moments.

use std::f64::consts::PI;

use crate::grid::{Edges, Field, UnionFind};
use crate::marks::{Ellipse, Moments, axial};
use crate::measure::marching_squares::parts;
use crate::measure::node_mask::{self, Squares, mask, runs};
use crate::measure::supersampled_grid::SupersampledGrid;

/// A connected region above the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Area of the region, px²; aspect, direction and centre of the ellipse that has its second moments.
    /// `radii[0]` is the larger. On a wrapped field the centre is folded into the canvas.
    pub ellipse: Ellipse,
    /// Whether all of it was measured: it touches no closed edge and is not endless.
    pub whole: bool,
    /// Whether it meets itself across a wrapped border: a stripe around the tile, not an ellipse.
    pub endless: bool,
    /// Length of its outline, holes included, without the frame, px.
    pub contour: f64,
    /// Area ÷ (π·r₁·r₂), where 2√λ are the radii of an ellipse of second moments λ: 1 for an ellipse, 0.955
    /// for a rectangle, below 0.93 for merged or bent marks.
    pub fill: f64,
    /// Its highest value.
    pub peak: f32,
}

/// The spots of a field, and the number of specks that were left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Census {
    /// In reading order of their first row.
    pub spots: Vec<Spot>,
    /// Regions under 2 cells of the field, or under 5 % of the usual area: that of the region at which half of the total
    /// area is reached, counted from the smallest.
    pub specks: usize,
    /// The area of the specks, px².
    pub speck_area: f64,
    /// The area below which regions are specks, px².
    pub least: f64,
}

/// A region of fewer cells of the field than this is a speck: noise, or a corner of something at the border.
pub(super) const SPECK_CELLS: f64 = 2.0;

/// A region of less than this share of the area at which half of the total area is reached is a speck too.
pub(super) const SPECK_SHARE: f64 = 0.05;

/// The regions above `level`, specks left out; see [`census`].
///
/// ```
/// use dapple_engine::grid::{Edges, Field};
/// use dapple_engine::measure::spots;
///
/// let disc = Field::from_fn([48, 48], [1.0, 1.0], Edges::Closed, |[x, y]| {
///     10.0 - (x - 20.0).hypot(y - 24.0) as f32
/// });
/// let found = spots(&disc, 0.0);
/// assert_eq!(found.len(), 1);
/// assert!((found[0].ellipse.area() / (100.0 * std::f64::consts::PI) - 1.0).abs() < 0.02);
/// ```
#[must_use]
pub fn spots(field: &Field, level: f32) -> Vec<Spot> {
    census(field, level).spots
}

/// The regions above `level`, with specks left out; regions of at least `least` px² are no specks, however large others are.
#[must_use]
pub fn spots_of_at_least(field: &Field, level: f32, least: f64) -> Vec<Spot> {
    spots_on_nodes(field, level, least, nodes_a_cell(field, level))
}

/// The regions of at least `least` px² above `level`, measured on `nodes` nodes per cell along each side: [`nodes_a_cell`] of the
/// field, or of one with nearly the same spots.
#[must_use]
pub fn spots_on_nodes(field: &Field, level: f32, least: f64, nodes: usize) -> Vec<Spot> {
    without_specks(&regions(field, level, nodes), field, least).spots
}

/// The regions of at least `least` px² above `level`, measured from the values of the cells alone: centres are accurate to a
/// hundredth of a radius for spots of 12 cells and more, and areas to 6 %. Takes a fifth of the time of [`spots_of_at_least`].
#[must_use]
pub fn rough_spots_of_at_least(field: &Field, level: f32, least: f64) -> Vec<Spot> {
    without_specks(&regions(field, level, 1), field, least).spots
}

/// The regions above `level`.
///
/// The field is read on a grid so fine that the results are those of the smooth surface through it
/// ([`crate::grid::resample::Spline`]): areas are accurate to 0.1 % for spots of more than 5 cells. Neighbouring nodes are
/// connected if they share a side, or if the mean of the four around a corner is above the level. On closed edges the field ends
/// half a cell beyond its outermost centres; on wrapped ones regions are joined across the border and measured in one piece.
///
/// Memory: besides the field, its spline (as much again) and a band of 4 MB.
#[must_use]
pub fn census(field: &Field, level: f32) -> Census {
    without_specks(&regions(field, level, nodes_a_cell(field, level)), field, f64::INFINITY)
}

/// The regions above `level`, see [`census`], where exactly the regions below `least` px² are specks, whatever the other areas are.
#[must_use]
pub fn census_of_at_least(field: &Field, level: f32, least: f64) -> Census {
    of_at_least(&regions(field, level, nodes_a_cell(field, level)), field, least)
}

/// Nodes per cell along each side, as many as the small regions above `level` need.
///
/// With nodes h cells apart, chords and linear crossings cause a relative error of an area A of the order of h² ÷ A; a value of
/// 0.0012 keeps errors under 0.1 % (`tests/ruler`).
#[must_use]
pub fn nodes_a_cell(field: &Field, level: f32) -> usize {
    // Cut regions may be small although their marks are not, and tiny regions are specks.
    let counts = |region: &&Region| region.moments.area > SPECK_CELLS && !region.touches;
    let rough = collected(field, level, 1, Detail::Nodes);
    let mut areas: Vec<f64> = rough.iter().filter(counts).map(|region| region.moments.area).collect();
    areas.sort_by(f64::total_cmp);
    let nodes = |small: &f64| (1.0 / (0.0012 * small)).sqrt().ceil() as usize;
    // Without any, two nodes per cell show regions that may lie between the cells.
    areas.get(areas.len() / 10).map_or(2, nodes).clamp(2, 8)
}

/// Sums over a region.
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

/// The label of nodes that are not inside.
const OUT: u32 = u32::MAX;

/// Collects regions row by row of nodes.
struct Collector<'a> {
    xs: &'a [f64],
    detail: Detail,
    level: f32,
    edges: Edges,
    /// Whether the first row is at the border of the field.
    top: bool,
    sets: UnionFind,
    known: Vec<Region>,
    /// The row above: its y and labels.
    y: f64,
    labels: Vec<u32>,
    /// Bits of the nodes above the level.
    inside: Vec<u64>,
    first: Vec<u32>,
}

/// The quantities that are added up for a region.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Detail {
    /// The number of nodes inside, as its area: less accurate, and faster.
    Nodes,
    /// All quantities, within the outlines between the nodes.
    Outlines,
}

fn regions(field: &Field, level: f32, factor: usize) -> Vec<Region> {
    collected(field, level, factor, Detail::Outlines)
}

/// The regions above `level`, with the quantities of `detail`.
fn collected(field: &Field, level: f32, factor: usize, detail: Detail) -> Vec<Region> {
    let nodes = SupersampledGrid::new(field, factor);
    let collector = |top| Collector {
        xs: &nodes.xs,
        detail,
        level,
        edges: field.edges,
        top,
        sets: UnionFind::default(),
        known: Vec::new(),
        y: 0.0,
        labels: Vec::new(),
        inside: Vec::new(),
        first: Vec::new(),
    };
    let bands = nodes.bands(|ys, values, top| {
        let mut collector = collector(top);
        let mut above: &[f32] = &[];
        for (y, values) in ys.iter().zip(values.chunks_exact(nodes.xs.len())) {
            collector.row(*y, values, above);
            above = values;
        }
        collector
    });
    let mut bands = bands.into_iter();
    let Some(mut all) = bands.next() else { return Vec::new() };
    bands.for_each(|band| all.append(band));
    all.finish(field.extent())
}

impl Collector<'_> {
    /// Adds the next row of nodes; `above` are the values of the row before, empty if there was none.
    fn row(&mut self, y: f64, values: &[f32], above: &[f32]) {
        let mut inside = Vec::new();
        mask(values, self.level, &mut inside);
        let labels = self.label(values, &inside);
        if above.is_empty() {
            self.first.clone_from(&labels);
            if self.top {
                self.touch(&labels);
            }
        } else {
            match self.detail {
                Detail::Nodes => self.count(&inside, &labels),
                Detail::Outlines => self.strip(y, [above, values], &labels, &inside),
            }
        }
        self.y = y;
        self.labels = labels;
        self.inside = inside;
    }

    /// Appends the band below, whose first row is the last of this one.
    fn append(&mut self, mut below: Self) {
        let offset = self.known.len() as u32;
        for piece in 0..below.known.len() as u32 {
            self.sets.add();
            let (root, shift) = below.sets.find(piece);
            self.sets.join(offset + root, offset + piece, shift);
            if piece == root && below.sets.is_endless(root) {
                self.sets.mark_endless(offset + root);
            }
        }
        self.known.append(&mut below.known);
        for (above, below) in self.labels.iter().zip(&below.first).filter(|(above, _)| **above != OUT) {
            self.sets.join(*above, offset + below, [0, 0]);
        }
        let moved = |label: &u32| if *label == OUT { OUT } else { offset + label };
        self.labels = below.labels.iter().map(moved).collect();
    }

    /// Labels each run of inside nodes of a row: with the label of the node above its first one, or a new one; and joins it to the
    /// runs above it.
    fn label(&mut self, values: &[f32], inside: &[u64]) -> Vec<u32> {
        let mut labels = vec![OUT; values.len()];
        let Self { sets, known, labels: labels_above, inside: inside_above, .. } = self;
        let mut runs_above = runs(inside_above).peekable();
        for run in runs(inside) {
            let own = match labels_above.get(run.start) {
                Some(above) if *above != OUT => *above,
                _ => {
                    known.push(NOTHING);
                    sets.add()
                }
            };
            while runs_above.next_if(|above| above.end <= run.start).is_some() {}
            while let Some(above) = runs_above.peek().filter(|above| above.start < run.end) {
                let other = labels_above[above.start];
                if other != own {
                    sets.join(other, own, [0, 0]);
                }
                // The next run may lie below it too.
                if above.end > run.end {
                    break;
                }
                runs_above.next();
            }
            let peak = values[run.clone()].iter().copied().fold(f32::NEG_INFINITY, f32::max);
            known[own as usize].peak = known[own as usize].peak.max(peak);
            labels[run].fill(own);
        }
        drop(runs_above);
        let ends = [labels[0], labels[labels.len() - 1]];
        match self.edges {
            Edges::Closed => self.touch(&ends),
            Edges::Wrap if ends[0] != OUT => {
                self.sets.join(ends[1], ends[0], [1, 0]);
            }
            Edges::Wrap => {}
        }
        labels
    }

    /// Marks the regions of nodes on a closed border as cut.
    fn touch(&mut self, labels: &[u32]) {
        if self.edges == Edges::Closed {
            for label in labels.iter().filter(|label| **label != OUT) {
                self.known[*label as usize].touches = true;
            }
        }
    }

    /// Adds the nodes of this row to the areas.
    fn count(&mut self, inside: &[u64], labels: &[u32]) {
        runs(inside).for_each(|run| {
            self.known[labels[run.start] as usize].moments.area += run.len() as f64;
        });
    }

    /// Adds up the squares between the row above and this one.
    fn strip(&mut self, y: f64, rows: [&[f32]; 2], labels: &[u32], inside: &[u64]) {
        let xs = self.xs;
        let inside_above = std::mem::take(&mut self.inside);
        node_mask::squares(&inside_above, inside, xs.len(), |squares| match squares {
            Squares::Full(squares) => self.fill(squares.start, [xs[squares.start], xs[squares.end]], y),
            Squares::Cut(i) => self.cut(i, y, rows, labels),
        });
    }

    /// Adds the parts of square `i` of the strip that ends at `y`, which is neither all inside nor all outside.
    fn cut(&mut self, i: usize, y: f64, [above, below]: [&[f32]; 2], labels: &[u32]) {
        let (xs, top) = (self.xs, self.y);
        let four = [self.labels[i], self.labels[i + 1], labels[i + 1], labels[i]];
        let v = [above[i], above[i + 1], below[i + 1], below[i]];
        let v = v.map(|v| f64::from(v) - f64::from(self.level));
        parts([xs[i], top], [xs[i + 1] - xs[i], y - top], v, |part| {
            let region = &mut self.known[four[part.corner] as usize];
            region.moments.add(&part.moments);
            region.contour += part.contour;
            if let Some(across) = part.across {
                self.sets.join(four[part.corner], four[across], [0, 0]);
            }
        });
    }

    /// Adds squares from node `from` on, in the strip that ends at `y`, that are all inside.
    fn fill(&mut self, from: usize, x: [f64; 2], y: f64) {
        let region = &mut self.known[self.labels[from] as usize];
        region.moments.add(&Moments::rectangle(x, [self.y, y]));
    }

    fn finish(mut self, [width, height]: [f64; 2]) -> Vec<Region> {
        let last = std::mem::take(&mut self.labels);
        self.touch(&last);
        if self.edges == Edges::Wrap {
            for (low, high) in last.iter().zip(&self.first).filter(|(low, _)| **low != OUT) {
                self.sets.join(*low, *high, [0, 1]);
            }
        }
        let mut whole = vec![NOTHING; self.sets.len()];
        for piece in 0..self.sets.len() {
            let (root, [across, down]) = self.sets.find(piece as u32);
            let (seen, region) = (&self.known[piece], &mut whole[root as usize]);
            region.moments.add(&seen.moments.moved([f64::from(across) * width, f64::from(down) * height]));
            region.contour += seen.contour;
            region.peak = region.peak.max(seen.peak);
            region.touches |= seen.touches;
            region.endless = self.sets.is_endless(root);
        }
        whole.retain(|region| region.moments.area > 0.0);
        whole
    }
}

/// The usual value of these areas: smaller ones cover half of the total area; 0 without areas.
pub fn usual_area(areas: impl Iterator<Item = f64>) -> f64 {
    let mut areas: Vec<f64> = areas.collect();
    areas.sort_by(f64::total_cmp);
    let half = 0.5 * areas.iter().sum::<f64>();
    let mut reached = 0.0;
    let usual = areas.into_iter().find(|area| {
        reached += area;
        reached >= half
    });
    usual.unwrap_or(0.0)
}

/// The spots among regions, and the number of specks.
/// Regions of `least` px² and more are no specks.
fn without_specks(regions: &[Region], field: &Field, least: f64) -> Census {
    let usual = usual_area(regions.iter().map(|region| region.moments.area));
    of_at_least(regions, field, (SPECK_SHARE * usual).min(least))
}

/// The regions of at least `least` px² and two cells.
fn of_at_least(regions: &[Region], field: &Field, least: f64) -> Census {
    let least = least.max(SPECK_CELLS * field.cell[0] * field.cell[1]);
    let spots: Vec<Spot> = regions
        .iter()
        .filter(|region| region.moments.area >= least)
        .map(|region| spot(region, field))
        .collect();
    let all: f64 = regions.iter().map(|region| region.moments.area).sum();
    let of_spots: f64 = spots.iter().map(|spot| spot.ellipse.area()).sum();
    Census { specks: regions.len() - spots.len(), speck_area: (all - of_spots).max(0.0), spots, least }
}

fn spot(region: &Region, field: &Field) -> Spot {
    let area = region.moments.area;
    let ([cx, cy], [xx, xy, yy]) = region.moments.central();
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
