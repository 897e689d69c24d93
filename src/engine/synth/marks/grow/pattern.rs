//! The pattern: a grown layer on the canvas. 0 = ground, ½ = a mark's edge, 1 = the centre of a mark.

use std::ops::Range;

use multiversion::multiversion;
use rayon::prelude::*;

use crate::attributes::Polarity;
use crate::attributes::regions::RegionGrid;
use crate::grid::resample::{Spline, resample};
use crate::grid::{Cutout, Field};
use crate::synth::marks::plan::layer_lookup::Lookup;
use crate::synth::pattern::{PatternRows, share};

/// A layer's grown concentration, and the thresholds of the edges of its marks.
pub struct Pattern<'a> {
    lookup: &'a Lookup,
    spline: Spline,
    /// Factors of the looked-up thresholds, by region.
    pub correction: Vec<f64>,
    /// Further factors of single spots, one a cell of the planned grid; empty = none.
    pub own: Vec<f64>,
    /// The field that is added to make its edges ragged.
    pub(in crate::synth::marks) added: Option<Spline>,
    /// The pattern over the canvas of marks that hide it.
    pub(in crate::synth::marks) crossed: Option<Spline>,
}

/// The concentrations of a pattern and the factors of its thresholds, without the lookup.
#[derive(Clone, Default)]
pub struct Levels {
    spline: Spline,
    /// Factors of the looked-up thresholds, by region.
    pub correction: Vec<f64>,
    /// Further factors of single spots, see [`Pattern::own`].
    pub own: Vec<f64>,
}

/// Thresholds beyond these cut a spot at its foot or its tip, where its outline depends on noise.
const CUTS: [f64; 2] = [0.15, 0.8];

impl<'a> Pattern<'a> {
    /// `marks` is the concentration as a share of the local peak, on a grid over the canvas.
    #[must_use]
    pub fn new(lookup: &'a Lookup, marks: &Field) -> Self {
        let regions = lookup.map.layout().len();
        Self {
            lookup,
            spline: Spline::new(marks),
            correction: vec![1.0; regions],
            own: Vec::new(),
            added: None,
            crossed: None,
        }
    }

    /// The pattern of `lookup` with these thresholds.
    #[must_use]
    pub fn of_levels(lookup: &'a Lookup, levels: Levels) -> Self {
        let Levels { spline, correction, own } = levels;
        Self { lookup, spline, correction, own, added: None, crossed: None }
    }

    /// The concentrations and the factors of the thresholds.
    #[must_use]
    pub fn into_levels(self) -> Levels {
        Levels { spline: self.spline, correction: self.correction, own: self.own }
    }

    /// Cells along x and y of the planned grid.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.lookup.grid.size
    }

    /// The concentration as a share of the local peak, at `width` × `height` px: the input of [`Self::levelled`].
    #[must_use]
    pub fn concentration(&self, [width, height]: [usize; 2]) -> Vec<f32> {
        self.spline.rows(0..height, width, height)
    }

    /// The pattern of a `concentration` from [`Self::concentration`].
    #[must_use]
    pub fn levelled(&self, concentration: &[f32], [width, height]: [usize; 2]) -> Field {
        let mut pattern = self.on_canvas(concentration.to_vec(), width, height);
        self.level_off(&mut pattern.values, [0.0; 2], pattern.cell, width);
        pattern
    }

    /// The pattern of the concentrations `marks` in the cells of `cutout`, on about `finer` px a cell along each side. Its edges are
    /// closed.
    #[must_use]
    pub fn in_cutout(&self, cutout: &Cutout, marks: Vec<f32>, finer: f64) -> Field {
        let [width, height] = cutout.grid.size.map(|cells| (finer * cells as f64) as usize);
        let mut pattern = resample(&Field::new(&cutout.grid, marks), width, height);
        let first =
            [0, 1].map(|axis| cutout.first[axis] as f64 * cutout.grid.cell[axis] / pattern.cell[axis]);
        self.level_off(&mut pattern.values, first, pattern.cell, width);
        pattern
    }

    /// Writes the pattern with other thresholds over a `pattern`.
    pub fn level_again(&self, concentration: &[f32], pattern: &mut Field) {
        pattern.values.copy_from_slice(concentration);
        self.level_off(&mut pattern.values, [0.0; 2], pattern.cell, pattern.width);
    }

    fn on_canvas(&self, values: Vec<f32>, width: usize, height: usize) -> Field {
        let layout = self.lookup.map.layout();
        Field { width, height, cell: self.px(width, height), edges: layout.edges, values }
    }

    /// Sides of a px, of `width` × `height` on the canvas.
    fn px(&self, width: usize, height: usize) -> [f64; 2] {
        let size = self.lookup.map.layout().size;
        [size[0] / width as f64, size[1] / height as f64]
    }

    /// Rows `rows` of the pattern at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let mut values = self.spline.rows(rows.clone(), width, height);
        self.level_off(&mut values, [0.0, rows.start as f64], self.px(width, height), width);
        if let Some(added) = &self.added {
            let added = added.rows(rows.clone(), width, height);
            values.iter_mut().zip(added).for_each(|(value, added)| *value = (*value + added).clamp(0.0, 1.0));
        }
        if let Some(crossed) = &self.crossed {
            let hidden = crossed.rows(rows, width, height);
            values
                .iter_mut()
                .zip(hidden)
                .for_each(|(value, hidden)| *value = value.min(1.0 - hidden).max(0.0));
        }
        values
    }

    /// Maps the concentrations of rows of `width` px of the sides `px` to the pattern. The first of them lies `first` px from the corner
    /// of the canvas.
    fn level_off(&self, values: &mut [f32], first: [f64; 2], px: [f64; 2], width: usize) {
        let columns = |layout| Columns::new(layout, first[0], px[0], width);
        let (level, correction) = (columns(&self.lookup.lattice.layout), columns(self.lookup.map.layout()));
        let cells = RegionGrid { grid: self.lookup.grid.size, ..*self.lookup.map.layout() };
        let own = (!self.own.is_empty()).then(|| columns(&cells));
        let levels: Vec<f64> = self.lookup.lattice.nodes.iter().map(|node| node.level).collect();
        let negative = self.lookup.polarity == Polarity::Negative;
        values.par_chunks_mut(width).enumerate().for_each_init(
            || vec![0.0; width],
            |product, (y, row)| {
                let y = (first[1] + y as f64 + 0.5) * px[1];
                level.row(&levels, y, |product, level| *product = level, product);
                correction.row(&self.correction, y, |product, factor| *product *= factor, product);
                if let Some(own) = &own {
                    own.row(&self.own, y, |product, factor| *product *= factor, product);
                }
                shares(row, product, negative);
            },
        );
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        self.on_canvas(self.rows(0..height, width, height), width, height)
    }
}

impl PatternRows for Pattern<'_> {
    fn grid(&self) -> [usize; 2] {
        self.grid()
    }

    /// Whether the outlines of marks may have corners: spots and stripes of one system have none.
    fn has_corners(&self) -> bool {
        false
    }

    fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        self.rows(rows, width, height)
    }

    fn field(&self, width: usize, height: usize) -> Field {
        self.field(width, height)
    }
}

/// The columns of a layout between which the px of a row lie, for interpolation.
struct Columns<'a> {
    layout: &'a RegionGrid,
    /// Ranges of px between two columns, and the two columns.
    spans: Vec<(Range<usize>, [usize; 2])>,
    /// The share of the second column at each px.
    shares: Vec<f64>,
}

impl<'a> Columns<'a> {
    /// Columns for `width` px; the `first` px is at this distance from the edge.
    fn new(layout: &'a RegionGrid, first: f64, px: f64, width: usize) -> Self {
        let mut spans: Vec<(Range<usize>, [usize; 2])> = Vec::new();
        let mut shares = Vec::with_capacity(width);
        for x in 0..width {
            let (left, right, share) = layout.between(0, (first + x as f64 + 0.5) * px);
            shares.push(share);
            match spans.last_mut() {
                Some((span, columns)) if *columns == [left, right] => span.end = x + 1,
                _ => spans.push((x..x + 1, [left, right])),
            }
        }
        Self { layout, spans, shares }
    }

    /// Interpolates `values` (by index of the layout) at each px of the row at height `y`, px, and calls `put` with the px of
    /// `out` and that value.
    fn row(&self, values: &[f64], y: f64, put: impl Fn(&mut f64, f64), out: &mut [f64]) {
        let columns = self.layout.grid[0];
        let (upper, lower, share) = self.layout.between(1, y);
        let at = |column: usize| {
            (1.0 - share) * values[upper * columns + column] + share * values[lower * columns + column]
        };
        for (span, columns) in &self.spans {
            let [left, right] = columns.map(at);
            interpolate(&mut out[span.clone()], &self.shares[span.clone()], [left, right], &put);
        }
    }
}

/// Writes interpolated values by `put` to each of `out`, by its share of the way from the first value to the second.
#[multiversion(targets("x86_64+avx2"))]
fn interpolate(out: &mut [f64], shares: &[f64], [left, right]: [f64; 2], put: &impl Fn(&mut f64, f64)) {
    out.iter_mut().zip(shares).for_each(|(out, share)| put(out, (1.0 - share) * left + share * right));
}

/// Converts concentrations to the pattern of lines with these thresholds, or of the gaps between lines if `negative`.
#[multiversion(targets("x86_64+avx2"))]
fn shares(values: &mut [f32], levels: &[f64], negative: bool) {
    for (value, level) in values.iter_mut().zip(levels) {
        let lines = share(*value, level.clamp(CUTS[0], CUTS[1]) as f32);
        *value = if negative { 1.0 - lines } else { lines };
    }
}
