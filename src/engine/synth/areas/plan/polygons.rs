//! The part of a plan that only cells have: the width of the lines between them, and the distances and sizes that follow from it.

use super::{AreaPlan, spots};
use crate::attributes::{AttributeMap, Attributes, Spots, Spread};
use crate::document::GapChoice;
use crate::grid::{Bounds, Domain};
use crate::learn::PairSet;
use crate::marks::{Ellipse, Line, Mark, Path};
use crate::points::centers::{self, Effort, Pitch};
use crate::points::discs::Laying;
use crate::points::extent::Extent;
use crate::points::patches::Wanted;
use crate::rd::pairs::HELD;
use crate::rd::pairs::polygons::{BLURS, SMOOTHING, TIME, distance, model, size, widest_gap};
use crate::rd::pairs::work::{Sizes, updates};

/// Cells of the grid per size of the pair: with fewer than 1.5, edges stick to the grid (`facts.md` T).
const CELLS: f64 = 1.75;
/// Width of the lines ÷ √area if no two drawn outlines nearly touch: that of a giraffe.
pub const USUAL: f64 = 0.2;
/// Two outlines nearly touch where the gap between them is at most this share of √area of the smaller one.
const NEAR: f64 = 0.5;
/// √(canvas ÷ cells) ÷ the distance of neighbours, in a hexagonal lattice.
const DISTANCE: f64 = 0.930_604_859_102_099_6;

/// Accuracy with which points are laid: an error of their distance causes an error of the gap that is several times as large.
pub const EFFORT: Effort = Effort { tries: 16, close: 0.002 };
/// Mean elongation −ln aspect of cells with an isotropic metric, without relaxation: an aspect of 0.84.
const OWN_ELONGATION: f64 = 0.174;
/// Steps of Lloyd's relaxation where the drawn cells are round.
const MOST_RELAXED: f64 = 12.0;

/// The part of a plan that only cells have.
#[derive(Clone, Debug)]
pub struct PolygonForm {
    /// Width of the lines between them, px.
    pub gap: f64,
    /// Steps of Lloyd's relaxation: more for rounder drawn cells.
    pub relaxed: usize,
    /// Correction of the laws for the size of the pair and the distance of the cells, from training rows.
    pub learnt: LearntFactors,
}

/// Factors between the laws and grown cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LearntFactors {
    /// Factor of the size of the pair.
    pub size: f64,
    /// Factor of the distance of the cells.
    pub distance: f64,
}

impl LearntFactors {
    /// No correction.
    pub const NONE: Self = Self { size: 1.0, distance: 1.0 };
}

impl PolygonForm {
    /// The form of the cells, with the gap, px, from the option or the `drawn` gap. Fills in the spacings of `map`, and adds to
    /// `notes` what differs from the sketch.
    pub(super) fn new(
        choice: GapChoice,
        drawn: Option<f64>,
        map: &mut AttributeMap,
        rows: Option<&PairSet>,
        notes: &mut Vec<String>,
    ) -> Self {
        let wanted = map.samples();
        let smallest = wanted.iter().filter_map(spots).map(|of| of.area.sqrt()).fold(f64::INFINITY, f64::min);
        let asked = match choice {
            GapChoice::Given(gap) => gap,
            GapChoice::Drawn => drawn.unwrap_or(USUAL * smallest),
        };
        let most = widest_gap(smallest);
        let gap = asked.min(most);
        if asked > most {
            notes.push(format!(
                "lines of {asked:.1} px leave no room for cells of {:.0} px²: they are {gap:.1} px wide",
                smallest * smallest
            ));
        }
        let elongations: Vec<f64> = wanted.iter().filter_map(spots).map(|of| -libm::log(of.aspect)).collect();
        let mean = elongations.iter().sum::<f64>() / elongations.len().max(1) as f64;
        let relaxed = (MOST_RELAXED * (1.0 - mean / OWN_ELONGATION).max(0.0)).round() as usize;
        let learnt = rows.map_or(LearntFactors::NONE, |rows| {
            let area = libm::exp(mean_of(&wanted, |spots| libm::log(spots.area)));
            let aspect = mean_of(&wanted, |spots| spots.aspect);
            let answer = rows.ask(1, &[area.sqrt() / gap, aspect]);
            LearntFactors { size: answer.values[0], distance: answer.values[1] }
        });
        let form = Self { gap, relaxed, learnt };
        map.fill_free_spacing(|spots| form.wanted(spots).spacing);
        form
    }

    /// The wanted attributes where the map gives `spots`: the spacing follows from the area and the lines.
    #[must_use]
    pub fn wanted(&self, spots: &Spots) -> Wanted {
        let Spots { area, aspect, angle, .. } = *spots;
        let aspect = libm::exp(-elongation_of_metric(-libm::log(aspect)));
        // The gap reduces both sides by what it takes from the mean side.
        let taken = self.learnt.distance * distance(area.sqrt(), self.gap) - area.sqrt();
        let [major, minor] = [(area / aspect).sqrt(), (area * aspect).sqrt()].map(|side| side + taken);
        Wanted {
            area,
            spacing: (major * minor).sqrt() / DISTANCE,
            aspect: minor / major,
            angle,
            raggedness: 1.0,
            spread: Spread::ZERO,
        }
    }

    /// √(canvas ÷ cells) of such cells, px.
    #[must_use]
    pub fn distance_of(wanted: &Wanted) -> f64 {
        DISTANCE * wanted.spacing
    }

    /// The size s of the pair that grows such cells, px.
    #[must_use]
    pub fn size(&self, wanted: &Wanted) -> f64 {
        self.learnt.size * size(self.gap, Self::distance_of(wanted))
    }

    /// The work of laying the points of `plan`.
    #[must_use]
    pub fn laying(&self, plan: &AreaPlan) -> Laying {
        centers::laying(&Extent::from(plan.canvas()), &|at| Pitch::from(plan.wanted(at)))
    }

    /// Upper bound of the comparisons of two points in laying those of `plan`.
    #[must_use]
    pub fn compared(&self, plan: &AreaPlan) -> f64 {
        centers::compared(&Extent::from(plan.canvas()), &|at| Pitch::from(plan.wanted(at)), EFFORT)
    }

    /// Updates of one morphogen in one cell of the grid of `plan` during the growth.
    #[must_use]
    pub fn updates(&self, plan: &AreaPlan) -> f64 {
        let sizes: Vec<f64> = plan.samples().map(|wanted| self.size(&wanted) / plan.px_a_cell()).collect();
        let range = [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| sizes.iter().copied().reduce(pick).unwrap_or(CELLS));
        let pair = Sizes { range, blurs: BLURS };
        updates(plan.grid.cells() as f64, &[pair], f64::from(model().ratio), HELD + TIME + SMOOTHING, true)
    }

    /// Cell of the grid that such cells need, px.
    pub(super) fn cell(&self, wanted: &Wanted) -> f64 {
        self.size(wanted) / CELLS
    }
}

/// The mean of a number of all spots.
fn mean_of(wanted: &[Attributes], number: impl Fn(&Spots) -> f64) -> f64 {
    let numbers: Vec<f64> = wanted.iter().filter_map(spots).map(|of| number(&of)).collect();
    mean(&numbers).unwrap_or(1.0)
}

/// The elongation −ln aspect e of the metric that gives cells a mean elongation of `wanted`. Voronoi cells have a random elongation
/// r of their own, in random directions, which adds to it. The mean of |e + r| is about e + <r²> ÷ 4e, and <r²> is 4/π of the
/// square of the mean of |r|.
fn elongation_of_metric(wanted: f64) -> f64 {
    let square = 4.0 / std::f64::consts::PI * OWN_ELONGATION * OWN_ELONGATION;
    0.5 * (wanted + (wanted * wanted - square).max(0.0).sqrt())
}

/// The drawn width of the lines between cells, px: the mean width of the lines beside the ellipses, or else the mean gap between
/// ellipses that nearly touch; `None` without either.
pub(in crate::synth) fn drawn_gap(marks: &[Mark], canvas: &Bounds) -> Option<f64> {
    let width = |mark: &Mark| match mark {
        Mark::Ellipse(_) => None,
        Mark::Line(Line { width, .. }) | Mark::Path(Path { width, .. }) => Some(*width),
    };
    mean(&marks.iter().filter_map(width).collect::<Vec<_>>()).or_else(|| gap_between_ellipses(marks, canvas))
}

fn gap_between_ellipses(marks: &[Mark], canvas: &Bounds) -> Option<f64> {
    let ellipses: Vec<Ellipse> = marks.iter().filter_map(Mark::ellipse).collect();
    let gap = |of: &Ellipse, other: &Ellipse| {
        let gap = of.gap_to(other, canvas);
        let near = NEAR * of.area().min(other.area()).sqrt();
        (0.0..near).contains(&gap).then_some(gap)
    };
    let pairs = ellipses
        .iter()
        .enumerate()
        .flat_map(|(index, of)| ellipses[..index].iter().filter_map(move |other| gap(of, other)));
    Some(mean(&pairs.collect::<Vec<_>>())?.max(1.0))
}

/// The mean; `None` without values.
fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn lines_beside_the_ellipses_give_the_gap_whatever_lies_between_these() {
        let disc = |x: f64| Mark::Ellipse(Ellipse { center: [x, 50.0], radii: [10.0, 10.0], angle: 0.0 });
        let line = |width: f64| Mark::Line(Line { from: [10.0, 80.0], to: [60.0, 80.0], width });
        let path = Mark::Path(Path { points: vec![[80.0, 80.0], [90.0, 70.0], [120.0, 80.0]], width: 9.0 });
        let canvas = Bounds { size: [200.0, 100.0], edges: Edges::Closed };
        assert_eq!(drawn_gap(&[disc(20.0), line(3.0), disc(44.0), path], &canvas), Some(6.0));
        assert_eq!(drawn_gap(&[disc(20.0), line(3.0)], &canvas), Some(3.0));
    }

    #[test]
    fn the_gap_is_that_of_outlines_that_nearly_touch() {
        let disc =
            |x: f64, y: f64| Mark::Ellipse(Ellipse { center: [x, y], radii: [10.0, 10.0], angle: 0.0 });
        let canvas = Bounds { size: [200.0, 100.0], edges: Edges::Closed };
        // Gaps of 4 px and 6 px, and a mark far away.
        let found =
            drawn_gap(&[disc(20.0, 50.0), disc(44.0, 50.0), disc(44.0, 76.0), disc(150.0, 50.0)], &canvas);
        assert!((found.expect("two gaps") - 5.0).abs() < 0.7, "{found:?}");
        assert_eq!(drawn_gap(&[disc(20.0, 50.0), disc(90.0, 50.0)], &canvas), None);
        // The gap crosses the border of a tile.
        let tile = Bounds { edges: Edges::Wrap, ..canvas };
        let across = drawn_gap(&[disc(11.0, 50.0), disc(186.0, 50.0)], &tile);
        assert!((across.expect("across") - 5.0).abs() < 1e-9, "{across:?}");
    }
}
