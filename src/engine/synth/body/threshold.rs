//! The level at which spots have the area that is asked for, and stripes the width.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::grid::Domain;
use crate::measure::{SurfaceSpot, SurfaceStripes, surface_spots, surface_stripes};
use crate::synth::body::area_form::AreaForm;
use crate::synth::body::plan::BodyPlan;
use crate::synth::passes::{Levelling, Thresholds};
use crate::synth::pattern::{EDGE, share};

/// The lowest and the highest level that is used. Not tuned.
const RANGE: [f64; 2] = [0.08, 0.92];

/// The marks about each anchor.
#[derive(Clone)]
pub struct Measured {
    /// All spots; none of stripes.
    pub spots: Vec<SurfaceSpot>,
    /// The anchor that each spot is nearest to.
    pub anchor: Vec<usize>,
    /// The stripes about each anchor; none of spots.
    pub stripes: Vec<SurfaceStripes>,
    /// Sizes of the whole marks of each anchor.
    pub sums: Vec<Sums>,
}

/// Sums over whole spots: of their areas, px². Of stripes their mean width, px.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    /// How many spots; 1 of stripes, 0 where there are none.
    pub count: usize,
    /// What has grown.
    pub got: f64,
    /// What is wanted at their places.
    pub wanted: f64,
}

impl Measured {
    /// Measures the marks of a pattern.
    #[must_use]
    pub fn new(plan: &BodyPlan, pattern: &[f32]) -> Self {
        if let Some(AreaForm::Points(_)) = plan.choice.areas {
            // A field of points has no single marks.
            let sums = vec![Sums::default(); plan.anchors.len()];
            Self { spots: Vec::new(), anchor: Vec::new(), stripes: Vec::new(), sums }
        } else if plan.choice.system.is_striped() {
            Self::of_stripes(plan, pattern)
        } else {
            Self::of_spots(plan, pattern)
        }
    }

    fn of_spots(plan: &BodyPlan, pattern: &[f32]) -> Self {
        let spots = surface_spots(plan.surface(), pattern, &vec![EDGE; pattern.len()]);
        let at: Vec<usize> = spots.iter().map(|spot| plan.surface().vertex_of(spot.place)).collect();
        let anchor: Vec<usize> = at.iter().map(|vertex| plan.influence.nearest(*vertex)).collect();
        let mut sums = vec![Sums::default(); plan.anchors.len()];
        for ((spot, vertex), anchor) in spots.iter().zip(&at).zip(&anchor).filter(|((spot, _), _)| spot.whole)
        {
            sums[*anchor].count += 1;
            sums[*anchor].got += spot.area;
            if let Attributes::Spots(wanted) = &plan.wanted[*vertex] {
                sums[*anchor].wanted += wanted.area;
            }
        }
        Self { spots, anchor, stripes: Vec::new(), sums }
    }

    fn of_stripes(plan: &BodyPlan, pattern: &[f32]) -> Self {
        let nearest = |vertex: usize| plan.influence.nearest(vertex);
        let stripes = surface_stripes(plan.surface(), pattern, EDGE, plan.anchors.len(), &nearest);
        let wanted = wanted_widths(plan);
        let of_anchor = |(index, (found, wanted)): (usize, (&SurfaceStripes, f64))| match found.width() {
            Some(measured) => {
                let is_own = |vertex: usize| nearest(vertex) == index;
                let curves = plan.curves.as_ref();
                let got = curves.map_or(measured, |curves| curves.width(plan.surface(), measured, &is_own));
                Sums { count: 1, got, wanted }
            }
            None => Sums::default(),
        };
        let sums = stripes.iter().zip(wanted).enumerate().map(of_anchor).collect();
        Self { spots: Vec::new(), anchor: Vec::new(), stripes, sums }
    }

    /// got ÷ wanted − 1 of the size about each anchor; `None` where nothing is measured.
    fn errors(&self) -> Vec<Option<f64>> {
        self.sums.iter().map(|sums| (sums.count > 0).then(|| sums.got / sums.wanted - 1.0)).collect()
    }
}

/// The mean width about each anchor, as 2 × area ÷ contour length measures it: ∫ w/λ ÷ ∫ 1/λ.
fn wanted_widths(plan: &BodyPlan) -> Vec<f64> {
    let mut sums = vec![[0.0; 2]; plan.anchors.len()];
    for (vertex, wanted) in plan.wanted.iter().enumerate() {
        if plan.maps.is_obstacle(vertex) {
            continue;
        }
        if let Attributes::Stripes(stripes) = wanted {
            let contour = plan.surface().area(vertex) / stripes.wavelength.unwrap_or(2.0 * stripes.width);
            let sum = &mut sums[plan.influence.nearest(vertex)];
            *sum = [sum[0] + contour * stripes.width, sum[1] + contour];
        }
    }
    sums.into_iter().map(|[width, contour]| width / contour).collect()
}

/// The pattern of concentrations with the looked-up levels times a factor for each anchor.
#[must_use]
pub fn levelled(plan: &BodyPlan, marks: &[f32], factors: &[f64]) -> Vec<f32> {
    let logarithms: Vec<f64> = factors.iter().map(|factor| libm::log(*factor)).collect();
    let at = |vertex: usize| {
        let factor = libm::exp(plan.influence.mean(vertex, &logarithms));
        let level = (f64::from(plan.levels[vertex]) * factor).clamp(RANGE[0], RANGE[1]);
        let pattern = share(marks[vertex], level as f32);
        if plan.is_inverted() { 1.0 - pattern } else { pattern }
    };
    (0..marks.len()).into_par_iter().map(at).collect()
}

/// A pattern whose marks have the size that is wanted about each anchor, on average.
pub struct Levelled {
    /// By vertex: 0 the ground, ½ an edge, 1 the middle of a mark.
    pub pattern: Vec<f32>,
    /// What is measured with the looked-up levels.
    pub before: Vec<Sums>,
    /// What is measured in the pattern.
    pub measured: Measured,
}

impl Levelled {
    /// Corrects the levels by the pass that canvases share; not at all unless it `corrects`.
    #[must_use]
    pub fn new(plan: &BodyPlan, marks: &[f32], corrects: bool) -> Self {
        let mut shown = Shown::new(plan, marks);
        let before = shown.measured.sums.clone();
        if corrects {
            let mut levelling = Levelling::new(&shown);
            while levelling.advance(&mut shown).is_some() {}
        }
        Self { pattern: shown.pattern, before, measured: shown.measured }
    }
}

/// Concentrations at thresholds that can be moved about each anchor.
struct Shown<'a> {
    plan: &'a BodyPlan,
    marks: &'a [f32],
    factors: Vec<f64>,
    pattern: Vec<f32>,
    measured: Measured,
    errors: Vec<Option<f64>>,
}

impl<'a> Shown<'a> {
    /// The pattern with the looked-up levels.
    fn new(plan: &'a BodyPlan, marks: &'a [f32]) -> Self {
        let factors = vec![1.0; plan.anchors.len()];
        let pattern = levelled(plan, marks, &factors);
        let measured = Measured::new(plan, &pattern);
        let errors = measured.errors();
        Self { plan, marks, factors, pattern, measured, errors }
    }
}

impl Thresholds for Shown<'_> {
    fn thresholds(&self) -> &[f64] {
        &self.factors
    }

    /// Levels themselves stay within a range, at each vertex.
    fn range(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }

    fn slopes(&self) -> Vec<f64> {
        let slope = self.plan.choice.system.definition().level_slope;
        let of_anchor = |wanted: &Attributes| match wanted {
            // Gaps become wider by as much as lines become thinner.
            Attributes::Stripes(gaps) if self.plan.is_inverted() => -slope * (1.0 / gaps.duty() - 1.0),
            wanted => self.plan.choice.areas.map_or(slope, |form| form.level_slope(wanted)),
        };
        self.plan.anchors.iter().map(|anchor| of_anchor(&anchor.wanted)).collect()
    }

    fn size_errors(&self) -> &[Option<f64>] {
        &self.errors
    }

    fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64> {
        let steps: Vec<f64> = wanted.iter().map(|step| step.unwrap_or(0.0)).collect();
        self.factors.iter_mut().zip(&steps).for_each(|(factor, step)| *factor *= libm::exp(*step));
        self.pattern = levelled(self.plan, self.marks, &self.factors);
        self.measured = Measured::new(self.plan, &self.pattern);
        self.errors = self.measured.errors();
        steps
    }
}
