//! The pattern of a settled layer, whose thresholds are moved until areas (widths) are those asked for.
//!
//! Size, shape and spacing follow from the concentrations. The last per cents of the area come from the threshold of the edge: one
//! in each region, interpolated between regions (`facts.md` K).

use std::sync::Arc;

use crate::attributes::{Attributes, Polarity};
use crate::grid::Field;
use crate::measure::{self, Spot, Tally};
use crate::synth::marks::grow::level_steps::{level_steps, within_regions};
use crate::synth::marks::grow::measured::{
    Measured, measured, measured_size, spots_measured, stripes_measured,
};
use crate::synth::marks::grow::pattern::{Levels, Pattern};
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::passes::Thresholds;

/// Factors of the thresholds are kept in this range. Beyond it the parameters are wrong, and a threshold would hide that.
const RANGE: [f64; 2] = [0.6, 1.5];

/// A settled pattern whose thresholds can be moved.
pub struct Levelled {
    plan: Arc<Plan>,
    /// Px at which it is measured.
    size: [usize; 2],
    levels: Levels,
    concentration: Vec<f32>,
    field: Field,
    ruler: Ruler,
    errors: Vec<Option<f64>>,
    found: Found,
}

impl Levelled {
    /// Measures `marks`, the concentration as a share of the local peak, for the first time: with these `factors` of the thresholds
    /// by region, if they are known. Spots smaller than `least_area`, px², are specks.
    #[must_use]
    pub fn new(plan: &Arc<Plan>, marks: &Field, factors: Option<Vec<f64>>, least_area: f64) -> Self {
        let canvas = plan.lookup.map.layout().size.map(|side| side as usize);
        let size = measured_size(plan, canvas);
        let mut pattern = Pattern::new(&plan.lookup, marks);
        pattern.correction = factors.unwrap_or(pattern.correction);
        let concentration = pattern.concentration(size);
        let field = pattern.levelled(&concentration, size);
        let levels = pattern.into_levels();
        let ruler = Ruler::new(plan, least_area, &field);
        let (errors, found) = ruler.errors(plan, &field);
        Self { plan: Arc::clone(plan), size, levels, concentration, field, ruler, errors, found }
    }

    /// The number of px that are measured.
    #[must_use]
    pub fn px(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// The spots of the last measurement; none for stripes.
    #[must_use]
    pub fn spots(&self) -> &[Spot] {
        if let Found::All(measured) = &self.found { measured.spots() } else { &[] }
    }

    /// Gives every cell a further factor of its threshold, see [`Pattern::own`], and measures again.
    pub fn set_own(&mut self, own: Vec<f64>) {
        self.levels.own = own;
        self.level_again();
        self.found = Found::All(self.ruler.measured(&self.plan, &self.field));
    }

    /// The thresholds, and all measurements with them.
    #[must_use]
    pub fn complete(self) -> (Levels, Measured) {
        let measured = self.found.of(&self.plan, &self.field);
        (self.levels, measured)
    }

    fn level_again(&mut self) {
        let pattern = Pattern::of_levels(&self.plan.lookup, std::mem::take(&mut self.levels));
        pattern.level_again(&self.concentration, &mut self.field);
        self.levels = pattern.into_levels();
    }
}

impl Thresholds for Levelled {
    fn thresholds(&self) -> &[f64] {
        &self.levels.correction
    }

    fn range(&self) -> [f64; 2] {
        RANGE
    }

    fn slopes(&self) -> Vec<f64> {
        level_slopes(&self.plan)
    }

    fn size_errors(&self) -> &[Option<f64>] {
        &self.errors
    }

    fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64> {
        let plan = Arc::clone(&self.plan);
        let layout = plan.lookup.map.layout();
        let before = self.levels.correction.clone();
        for (factor, step) in self.levels.correction.iter_mut().zip(level_steps(layout, wanted)) {
            *factor = (*factor * libm::exp(step)).clamp(RANGE[0], RANGE[1]);
        }
        self.level_again();
        (self.errors, self.found) = self.ruler.errors(&plan, &self.field);
        let moved = self.levels.correction.iter().zip(&before).map(|(now, before)| libm::log(now / before));
        within_regions(layout, &moved.collect::<Vec<f64>>())
    }
}

/// d ln size / d ln threshold, by region, before it is measured. A higher threshold makes lines thinner, and stripes in the gaps
/// between lines wider by as much.
fn level_slopes(plan: &Plan) -> Vec<f64> {
    let (polarity, slope) = (plan.lookup.polarity, plan.lookup.system.definition().level_slope);
    let of_region = |wanted: &Attributes| match (polarity, wanted, polarity.lines(wanted)) {
        (Polarity::Negative, Attributes::Stripes(stripes), Attributes::Stripes(lines)) => {
            -slope * lines.width / stripes.width
        }
        _ => slope,
    };
    plan.lookup.wanted().iter().map(of_region).collect()
}

/// The kind of measurement while thresholds are corrected.
enum Ruler {
    /// All attributes of spots.
    Spots {
        /// Nodes per cell along each side.
        nodes: usize,
        /// Least area of a spot, px²; smaller ones are specks.
        least_area: f64,
    },
    /// Only widths of stripes, compared with these by region: measuring directions takes longer, and they hardly change.
    Stripes(Vec<f64>),
}

/// Measurements while thresholds are corrected.
enum Found {
    All(Measured),
    /// Tallies of stripes, with the rims that [`Plan::by_region`] leaves out.
    Tallies(Vec<Tally>),
}

impl Found {
    /// All measurements of `pattern`, completed from these.
    fn of(self, plan: &Plan, pattern: &Field) -> Measured {
        match self {
            Self::All(measured) => measured,
            Self::Tallies(tallies) => {
                stripes_measured(plan, |target| measure::stripe_errors_of(pattern, &tallies, target))
            }
        }
    }
}

impl Ruler {
    /// The measurement that suits `pattern`.
    fn new(plan: &Plan, least_area: f64, pattern: &Field) -> Self {
        if !plan.lookup.system.is_striped() {
            return Self::Spots { nodes: measure::nodes_a_cell(pattern, 0.5), least_area };
        }
        let layout = plan.lookup.map.layout();
        let width = |index: usize| {
            let [column, row] = layout.place(index);
            let share = |i: usize, k: usize, axis: usize| {
                (k as f64 + (i as f64 + 0.5) / POINTS as f64) / layout.grid[axis] as f64 * layout.size[axis]
            };
            let points = (0..POINTS * POINTS)
                .map(|i| [share(i % POINTS, column, 0), share(i / POINTS, row, 1)])
                .map(|point| match plan.lookup.map.at(point) {
                    Attributes::Stripes(stripes) => stripes.width,
                    Attributes::Spots(_) => 0.0,
                });
            points.sum::<f64>() / (POINTS * POINTS) as f64
        };
        Self::Stripes((0..layout.len()).map(width).collect())
    }

    /// All measurements of a pattern.
    fn measured(&self, plan: &Plan, pattern: &Field) -> Measured {
        match self {
            Self::Spots { nodes, least_area } => {
                spots_measured(plan, measure::spots_on_nodes(pattern, 0.5, *least_area, *nodes))
            }
            Self::Stripes(_) => measured(plan, f64::INFINITY, pattern),
        }
    }

    /// got ÷ wanted − 1 of area or width by region, and the measurements.
    fn errors(&self, plan: &Plan, pattern: &Field) -> (Vec<Option<f64>>, Found) {
        match self {
            Self::Spots { .. } => {
                let found = self.measured(plan, pattern);
                (
                    (0..plan.lookup.map.layout().len()).map(|i| found.size_error(i)).collect(),
                    Found::All(found),
                )
            }
            Self::Stripes(wanted) => {
                let mut tallies = Vec::new();
                let widths = plan.by_region(|target| {
                    tallies = measure::tallies(pattern, 0.5, target.regions);
                    tallies.iter().map(Tally::width).collect()
                });
                let got = |(index, got): (usize, Option<f64>)| match plan.curves() {
                    Some(curves) => Some(curves.width(index, got?)),
                    None => got,
                };
                let error = |(got, wanted): (Option<f64>, &f64)| Some(got? / wanted - 1.0);
                (
                    widths.into_iter().enumerate().map(got).zip(wanted).map(error).collect(),
                    Found::Tallies(tallies),
                )
            }
        }
    }
}

/// Points per region along each side at which the wanted width is sampled: an even number, so that the mean of a function that is
/// bilinear about the centre is exact.
const POINTS: usize = 16;
