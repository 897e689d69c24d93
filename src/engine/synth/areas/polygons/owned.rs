//! Assignment of every place to a cell.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::attributes::Attributes;
use crate::grid::{Edges, Grid};
use crate::points::centers::{self, Pitch};
use crate::points::extent::Extent;
use crate::points::metric::Metric;
use crate::points::patches::Outlines;
use crate::points::voronoi::owners;
use crate::synth::areas::plan::AreaPlan;
use crate::synth::areas::plan::polygons::{EFFORT, PolygonForm};

/// Largest scaling of points after relaxation: the frame beyond the border is larger by as much.
const MOST_SCALED: f64 = 0.04;
/// Cells of the grid per distance of cells while points are laid: areas are then accurate to one per cent.
const COARSE: f64 = 14.0;
/// The owner of places that marks of the layers beneath have taken.
pub(super) const TAKEN: u32 = u32::MAX;

/// The laid points, and the places that they own.
pub(super) struct Owned {
    /// By cell of the grid, the number of the laid point that it belongs to, or [`TAKEN`]. Drawn marks get their outlines later.
    pub(super) owners: Vec<u32>,
    /// The points with their metrics.
    points: Vec<([f64; 2], Metric)>,
    extent: Extent,
}

impl Owned {
    /// The distance of a place, px, from the border between the places of two points, on the side of the first one, and the
    /// direction away from the border. The border is where both are equally near: a straight line if their metrics are equal.
    /// `None` if one of the two is no laid point.
    pub(super) fn border(&self, at: [f64; 2], own: u32, other: u32) -> Option<(f64, [f64; 2])> {
        let square = |point: u32| {
            let ([x, y], metric) = self.points.get(point as usize)?;
            let way = self.extent.shortest([at[0] - x, at[1] - y]);
            Some((metric.square(way), metric.slope(way)))
        };
        let ((near, slope), (far, steeper)) = (square(own)?, square(other)?);
        let slope = [0, 1].map(|axis| steeper[axis] - slope[axis]);
        let length = libm::hypot(slope[0], slope[1]);
        (length > 0.0).then(|| ((far - near) / length, slope.map(|part| part / length)))
    }
}

/// Lays the points of the cells of `plan`, and gives each the places nearest to it.
pub(super) fn owned(plan: &AreaPlan, form: &PolygonForm, seed: u64) -> Owned {
    let extent = Extent::from(plan.canvas());
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let pitch = |at: [f64; 2]| {
        let wanted = plan.wanted(at);
        Pitch { spacing: wanted.spacing, aspect: wanted.aspect, angle: wanted.angle }
    };
    let metric = |at: [f64; 2]| {
        let Pitch { spacing, aspect, angle } = pitch(at);
        Metric::ellipse(spacing, aspect, angle)
    };
    let pinned: Vec<[f64; 2]> = plan.kept.iter().map(|(_, outline)| outline.center()).collect();
    let smallest = plan.map.samples().into_iter().filter_map(|wanted| match wanted {
        Attributes::Spots(spots) => Some(PolygonForm::distance_of(&form.wanted(&spots))),
        Attributes::Stripes(_) => None,
    });
    let cell = smallest.fold(f64::INFINITY, f64::min) / COARSE;
    let coarse =
        plan.grid.resized(extent.size.map(|side| (side / cell).ceil().clamp(1.0, MOST_COARSE) as usize));
    let ratio = |points: &[[f64; 2]]| {
        let owners = owners(points, &metric, &extent, &coarse);
        let cell = coarse.cell[0] * coarse.cell[1];
        let (mut areas, mut cut) = (vec![0.0; points.len()], vec![false; points.len()]);
        for (index, owner) in owners.iter().enumerate() {
            areas[*owner as usize] += cell;
            cut[*owner as usize] |= is_on_border(index, &coarse) && !extent.wrap[0];
        }
        let whole = (pinned.len()..points.len()).filter(|point| areas[*point] > 0.0 && !cut[*point]);
        let (mut asked, mut got) = (0.0, 0.0);
        for point in whole {
            asked += PolygonForm::distance_of(&plan.wanted(points[point])).powi(2);
            got += areas[point];
        }
        if asked > 0.0 { (got / asked).sqrt() } else { 1.0 }
    };
    let mut laid = centers::lay(&extent, &pitch, &pinned, &ratio, EFFORT, &mut rng);
    for _ in 0..form.relaxed {
        relax(&mut laid, &pinned, &metric, &extent, &coarse);
    }
    if plan.canvas().edges == Edges::Closed {
        // A tile keeps its number of points, and so their distance. Points near a closed border may have moved in or out.
        let all: Vec<[f64; 2]> = pinned.iter().chain(&laid).copied().collect();
        let factor = ratio(&all).clamp(1.0 - MOST_SCALED, 1.0 + MOST_SCALED);
        let middle = extent.size.map(|side| 0.5 * side);
        for at in &mut laid {
            *at = [0, 1].map(|axis| middle[axis] + (at[axis] - middle[axis]) / factor);
        }
    }
    // A drawn mark owns only its outline: its centre keeps other points away, but owns nothing.
    let kept = Outlines::new(plan.kept.iter().map(|(_, outline)| outline), &extent);
    let is_in_kept = |at: &[f64; 2]| kept.deepest(*at, 0.0).is_some_and(|(depth, _)| depth > 0.0);
    let clear: Vec<[f64; 2]> = laid.into_iter().filter(|at| !is_in_kept(at)).collect();
    let mut owned = owners(&clear, &metric, &extent, &plan.grid);
    if clear.is_empty() {
        owned.fill(0);
    }
    for (owner, taken) in owned.iter_mut().zip(&plan.obstacles) {
        if *taken {
            *owner = TAKEN;
        }
    }
    let points = clear.into_iter().map(|at| (at, metric(at))).collect();
    Owned { owners: owned, points, extent }
}

/// One step of Lloyd's relaxation: points move to the centres of their Voronoi cells, which makes these rounder and more alike. The
/// `pinned` points stay, and so do points whose cells are cut by the border.
fn relax(
    laid: &mut [[f64; 2]],
    pinned: &[[f64; 2]],
    metric: &(dyn Fn([f64; 2]) -> Metric + Sync),
    extent: &Extent,
    grid: &Grid,
) {
    let points: Vec<[f64; 2]> = laid.iter().chain(pinned).copied().collect();
    let mut sums = vec![([0.0; 2], 0.0); points.len()];
    let mut cut = vec![false; points.len()];
    for (cell, owner) in owners(&points, metric, extent, grid).into_iter().enumerate() {
        let (owner, [x, y]) = (owner as usize, grid.center_px(cell));
        let way = extent.shortest([x - points[owner][0], y - points[owner][1]]);
        let (sum, count) = &mut sums[owner];
        (*sum, *count) = ([sum[0] + way[0], sum[1] + way[1]], *count + 1.0);
        cut[owner] |= is_on_border(cell, grid) && !extent.wrap[0];
    }
    for (index, at) in laid.iter_mut().enumerate() {
        let ([x, y], count) = sums[index];
        if count > 0.0 && !cut[index] {
            *at = extent.folded([at[0] + x / count, at[1] + y / count]);
        }
    }
}

/// Whether a cell of a grid lies at its border.
fn is_on_border(cell: usize, grid: &Grid) -> bool {
    let [x, y] = grid.position(cell);
    x == 0 || y == 0 || x + 1 == grid.size[0] || y + 1 == grid.size[1]
}

/// Most cells along a side of the grid on which points are laid.
const MOST_COARSE: f64 = 700.0;
