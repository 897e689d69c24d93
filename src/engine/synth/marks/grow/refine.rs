//! Measures the pattern, and corrects its levels until areas (widths) are those that were asked for.
//!
//! Size, shape and spacing are in the concentrations; the last per cents of area come from the level of the edge: one level
//! a region, interpolated between regions (`facts.md` K).

use crate::attributes::{Attributes, Polarity};
use crate::grid::Field;
use crate::measure::{self, MERGED_FILL, Spot, SpotErrors, StripeErrors, Tally, Target};
use crate::synth::marks::grow::level_steps::{level_steps, within_regions};
use crate::synth::marks::grow::own_levels::own_levels;
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::pinned_correction::matches;
use crate::synth::marks::plan::laid_out::Plan;

/// What was measured on a layer, by region.
#[derive(Clone, Debug)]
pub enum Measured {
    /// A layer of spots.
    Spots {
        /// Errors by region.
        errors: Vec<SpotErrors>,
        /// All marks, cut ones too.
        marks: Vec<Spot>,
    },
    /// A layer of stripes.
    Stripes(Vec<StripeErrors>),
}

/// Measurements and corrections at most. Two corrections are mostly enough: after them none of four regions of cheetah-run and zebra
/// differed by more than 0.01 % (area) or 0.06 % (width).
const ROUNDS: usize = 8;
/// Areas and widths nearer than this to what was asked are not corrected: half the error of the measurement.
const NEAR: f64 = 0.001;
/// Factors of the level are kept in this range. Beyond it the parameters are wrong, and a level would hide that.
const CORRECTIONS: [f64; 2] = [0.6, 1.5];

/// Corrections of the levels of single spots.
const OWN_ROUNDS: usize = 3;

/// Measured points a cell of the grid along each side, where the canvas has more px than that: a spot of 48 cells then has
/// 108 points, from which its area is measured to 0.1 %.
const FINER: f64 = 1.5;

/// Measures `pattern`, a field of the canvas of `plan`, against what was asked.
#[must_use]
pub fn measured(plan: &Plan, pattern: &Field) -> Measured {
    if plan.lookup.system.is_striped() {
        return stripes_measured(plan, |target| measure::stripe_errors(pattern, 0.5, target));
    }
    spots_measured(plan, measure::spots_of_at_least(pattern, 0.5, plan.least_area()))
}

/// Spots with their errors.
pub(super) fn spots_measured(plan: &Plan, marks: Vec<Spot>) -> Measured {
    Measured::Spots { errors: plan.on_canvas(|target| measure::spot_errors(&marks, target)), marks }
}

/// Stripes with the errors that `measure` finds.
fn stripes_measured(plan: &Plan, measure: impl FnOnce(&Target) -> Vec<StripeErrors>) -> Measured {
    let mut errors = plan.by_region(measure);
    if let Some(curves) = plan.curves() {
        errors.iter_mut().enumerate().for_each(|(index, errors)| curves.correct(index, errors));
    }
    Measured::Stripes(errors)
}

impl Measured {
    /// got ÷ wanted − 1 of area or width in region `index`.
    fn size_error(&self, index: usize) -> Option<f64> {
        match self {
            Self::Spots { errors, .. } => errors[index].area,
            Self::Stripes(errors) => errors[index].width,
        }
    }

    /// All spots, cut ones too; none of stripes.
    #[must_use]
    pub fn spots(&self) -> &[Spot] {
        match self {
            Self::Spots { marks, .. } => marks,
            Self::Stripes(_) => &[],
        }
    }

    /// The whole spots of a layer grown from `plan` that are two grown together; none of stripes.
    pub fn merged_spots(&self, plan: &Plan) -> impl Iterator<Item = &Spot> {
        // Irregular outlines fill less of their ellipses.
        let regular = plan.lookup.irregular == 0.0;
        self.spots().iter().filter(move |spot| regular && spot.whole && spot.fill < MERGED_FILL)
    }

    /// What has grown in region `index`.
    #[must_use]
    pub fn got(&self, index: usize) -> Option<Attributes> {
        match self {
            Self::Spots { errors, .. } => errors[index].got.map(Attributes::Spots),
            Self::Stripes(errors) => errors[index].got.map(Attributes::Stripes),
        }
    }
}

/// Px at which a pattern on a canvas of `size` px is measured.
pub(super) fn measured_size(plan: &Plan, size: [usize; 2]) -> [usize; 2] {
    [0, 1].map(|axis| size[axis].min((FINER * plan.lookup.grid.size[axis] as f64).ceil() as usize))
}

/// Levels that are corrected round by round, until areas (widths) are right.
pub struct Refinement {
    /// Px at which the pattern is measured.
    size: [usize; 2],
    correct: bool,
    concentration: Vec<f32>,
    levelled: Field,
    ruler: Ruler,
    errors: Vec<Option<f64>>,
    found: Option<Found>,
    /// d ln size / d ln level, by region; better known after the first correction.
    slope: Vec<f64>,
    /// Rounds that have been made.
    round: usize,
    /// The levels of single spots: their factors, what was measured last, and the rounds that have been made.
    own: Option<(OwnFactors, Measured, usize)>,
}

impl Refinement {
    /// Measures `pattern`, whose canvas is `size` px, for the first time. Without `correct` nothing more is done.
    #[must_use]
    pub fn new(plan: &Plan, pattern: &Pattern, size: [usize; 2], correct: bool) -> Self {
        let size = measured_size(plan, size);
        let concentration = pattern.concentration(size);
        let levelled = pattern.levelled(&concentration, size);
        let ruler = Ruler::new(plan, &levelled);
        let (errors, found) = ruler.errors(plan, &levelled);
        let slope = level_slopes(plan);
        let found = Some(found);
        Self { size, correct, concentration, levelled, ruler, errors, found, slope, round: 0, own: None }
    }

    /// The px that a round measures.
    #[must_use]
    pub fn px(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// The share of the rounds that are done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.round as f64 / ROUNDS as f64
    }

    /// Corrects the levels of `pattern` once and measures it again. Returns what was measured when the last correction is made.
    pub fn advance(&mut self, plan: &Plan, pattern: &mut Pattern) -> Option<Measured> {
        if let Some((factors, found, round)) = &mut self.own {
            let goes_on = *round < OWN_ROUNDS && self.correct && level_pinned(plan, pattern, factors, found);
            if goes_on {
                pattern.level_again(&self.concentration, &mut self.levelled);
                *found = self.ruler.measured(plan, &self.levelled);
                *round += 1;
                return None;
            }
            return self.own.take().map(|(_, found, _)| found);
        }
        let is_near = self.errors.iter().flatten().all(|error| error.abs() < NEAR);
        if self.round < ROUNDS && self.correct && !is_near {
            self.correct_levels(plan, pattern);
            self.round += 1;
        } else if let Some(found) = self.found.take() {
            self.own = Some((OwnFactors::new(plan), found.of(plan, &self.levelled), 0));
        }
        None
    }

    /// Corrects the levels of all regions, and measures again.
    fn correct_levels(&mut self, plan: &Plan, pattern: &mut Pattern) {
        let Self { errors, slope, .. } = self;
        let before = pattern.correction.clone();
        let wanted = |(i, error): (usize, &Option<f64>)| {
            let step = -libm::log1p((*error)?) / slope[i];
            // At the end of the range it stays, and those around it must not count on it.
            let end = if step < 0.0 { CORRECTIONS[0] } else { CORRECTIONS[1] };
            (pattern.correction[i] != end).then_some(step)
        };
        let wanted: Vec<Option<f64>> = errors.iter().enumerate().map(wanted).collect();
        for (correction, step) in
            pattern.correction.iter_mut().zip(level_steps(plan.lookup.map.layout(), &wanted))
        {
            *correction = (*correction * libm::exp(step)).clamp(CORRECTIONS[0], CORRECTIONS[1]);
        }
        pattern.level_again(&self.concentration, &mut self.levelled);
        let (new, measured) = self.ruler.errors(plan, &self.levelled);
        let moved: Vec<f64> =
            pattern.correction.iter().zip(&before).map(|(now, before)| libm::log(now / before)).collect();
        let moved = within_regions(plan.lookup.map.layout(), &moved);
        for i in 0..slope.len() {
            let (Some(old), Some(new)) = (errors[i], new[i]) else { continue };
            if moved[i].abs() > 1e-4 {
                let found_slope = (libm::log1p(new) - libm::log1p(old)) / moved[i];
                // Marks across a border are measured in one region; a slope of the wrong sign would diverge.
                let [low, high] = if slope[i] < 0.0 { [2.0, 0.5] } else { [0.5, 2.0] };
                slope[i] = found_slope.clamp(low * slope[i], high * slope[i]);
            }
        }
        *errors = new;
        self.found = Some(measured);
    }
}

/// d ln size / d ln level, by region, before it is known better. A higher level makes lines thinner, and stripes in the gaps
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

/// Factors of the levels where some spots are pinned.
struct OwnFactors {
    /// Of each pinned spot.
    pinned: Vec<f64>,
    /// Logarithm of the factor of each where it was measured last, and how much larger ln area was than wanted.
    before: Vec<Option<[f64; 2]>>,
    /// Of the other spots, by region.
    others: Vec<f64>,
}

impl OwnFactors {
    fn new(plan: &Plan) -> Self {
        let regions = plan.lookup.map.layout().len();
        let pinned = plan.pinned_spots().len();
        Self { pinned: vec![1.0; pinned], before: vec![None; pinned], others: vec![1.0; regions] }
    }

    /// d ln area / d ln level of pinned spot `index`, whose ln area is too large by `error` now: `slope`, or steeper where the last
    /// correction was too large. A flatter one would lead to larger corrections, which can make neighbours touch. Unless the spot
    /// stands `alone`, the error tells nothing about the slope.
    fn slope(&mut self, index: usize, error: f64, alone: bool, slope: f64) -> f64 {
        let now = alone.then_some([libm::log(self.pinned[index]), error]);
        let before = std::mem::replace(&mut self.before[index], now);
        let (Some(now), Some(before)) = (now, before) else { return slope };
        let [factor, area] = [0, 1].map(|k| now[k] - before[k]);
        if factor.abs() > 1e-3 { (area / factor).clamp(2.0 * slope, slope) } else { slope }
    }
}

/// Fewer spots than this have no mean that could be corrected.
const OTHERS: f64 = 3.0;

/// Changes the factors of the spots that are not pinned, so that their mean areas are those that are wanted.
fn level_others(plan: &Plan, factors: &mut [f64], others: &[&Spot], slope: f64) {
    let layout = plan.lookup.map.layout();
    let mut sums = vec![[0.0; 3]; factors.len()];
    for spot in others.iter().filter(|spot| spot.whole) {
        if let Attributes::Spots(wanted) = plan.lookup.map.at(spot.ellipse.center) {
            let [count, got, asked] = &mut sums[layout.index(layout.region_of(spot.ellipse.center))];
            *count += 1.0;
            *got += spot.ellipse.area();
            *asked += wanted.area;
        }
    }
    for (factor, [count, got, asked]) in factors.iter_mut().zip(sums) {
        if count >= OTHERS {
            let error = libm::log(got / asked);
            *factor = (*factor * libm::exp(-error / slope)).clamp(CORRECTIONS[0], CORRECTIONS[1]);
        }
    }
}

/// Changes the levels of the pinned spots so that they get the areas that were drawn, and those of the others so that they
/// keep their mean. Returns whether one was changed.
fn level_pinned(plan: &Plan, pattern: &mut Pattern, factors: &mut OwnFactors, found: &Measured) -> bool {
    if factors.pinned.is_empty() {
        return false;
    }
    let (layout, slope) = (plan.lookup.map.layout(), plan.lookup.system.definition().level_slope);
    let own = matches(plan.pinned_spots(), layout, found.spots());
    let mut is_own = vec![false; found.spots().len()];
    own.iter().flatten().for_each(|spot| is_own[*spot] = true);
    let others: Vec<&Spot> =
        found.spots().iter().zip(&is_own).filter(|(_, is_own)| !**is_own).map(|(spot, _)| spot).collect();
    level_others(plan, &mut factors.others, &others, slope);
    let usual = |spot: &Spot| factors.others[layout.index(layout.region_of(spot.ellipse.center))];
    let mut spots: Vec<(&Spot, f64)> = found.spots().iter().map(|spot| (spot, usual(spot))).collect();
    let mut changed = false;
    for (index, (mark, spot)) in plan.pinned_spots().iter().zip(own).enumerate() {
        let Some(spot) = spot else { continue };
        let got = &found.spots()[spot];
        let error = libm::log(got.ellipse.area() / mark.visible.area);
        let slope = factors.slope(index, error, got.fill >= MERGED_FILL, slope);
        let factor = &mut factors.pinned[index];
        if error.abs() >= NEAR {
            *factor = (*factor * libm::exp(-error / slope)).clamp(CORRECTIONS[0], CORRECTIONS[1]);
            changed = true;
        }
        spots[spot].1 = *factor;
    }
    if changed {
        pattern.own = own_levels(&plan.lookup.grid, &spots);
    }
    changed
}

/// What is measured while levels are corrected.
enum Ruler {
    /// All attributes of spots, on so many nodes a cell each way.
    Spots(usize),
    /// Only widths of stripes, compared to these by region: directions take longer, and hardly change.
    Stripes(Vec<f64>),
}

/// What was measured while levels were corrected.
enum Found {
    All(Measured),
    /// Of stripes, with the rims that [`Plan::by_region`] leaves out.
    Tallies(Vec<Tally>),
}

impl Found {
    /// All that is measured of `pattern`, of which this was found.
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
    /// For patterns such as this one.
    fn new(plan: &Plan, pattern: &Field) -> Self {
        if !plan.lookup.system.is_striped() {
            return Self::Spots(measure::nodes_a_cell(pattern, 0.5));
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

    /// All that is measured of a pattern.
    fn measured(&self, plan: &Plan, pattern: &Field) -> Measured {
        match self {
            Self::Spots(nodes) => {
                spots_measured(plan, measure::spots_on_nodes(pattern, 0.5, plan.least_area(), *nodes))
            }
            Self::Stripes(_) => measured(plan, pattern),
        }
    }

    /// got ÷ wanted − 1 of area or width by region, and what was measured.
    fn errors(&self, plan: &Plan, pattern: &Field) -> (Vec<Option<f64>>, Found) {
        match self {
            Self::Spots(_) => {
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

/// Points a region along each side at which the wanted width is sampled: an even number, so that the mean of a function
/// that is bilinear about the centre is exact.
const POINTS: usize = 16;
