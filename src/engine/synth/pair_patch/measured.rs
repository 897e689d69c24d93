//! Measurements of a grown patch: numbers by the names of their columns, and errors.

use super::{Named, PERIOD, PairPatch, PairReason};
use crate::measure::{Spot, StripeErrors, blotch_width, spots, stripes};
use crate::rd::pairs::polygons::{distance, size};
use crate::rd::pairs::{PairKind, Threads};
use crate::synth::areas::OwnPolygons;
use crate::synth::areas::grown::GrownAreas;
use crate::synth::areas::plan::AreaForm;
use crate::synth::areas::plan::polygons::PolygonForm;
use crate::synth::pairs::grown::GrownPairs;
use crate::synth::pairs::plan::thread_map::ThreadMap;
use crate::synth::pairs::plan::{Crossed, PairForm, crossed, least_between};

/// Range of the width relative to the drawn one in which a patch is used as training data.
const WIDTHS: [f64; 2] = [0.5, 1.7];
/// Range of the period relative to the drawn one in which a patch is used as training data.
const PERIODS: [f64; 2] = [0.75, 1.3];
/// Lines that deviate from the drawn direction by more than this belong to another direction, degrees.
const TURNED: f64 = 15.0;
/// Least share of the laid cells that have an area of their own.
const OWN_CELLS: f64 = 0.9;

impl PairPatch {
    /// The numbers of lines or blotches, by the names of their columns.
    pub(super) fn pairs(&self, grown: &GrownPairs) -> Result<Vec<Named>, PairReason> {
        match &grown.plan.form {
            PairForm::Weave(weave) => self.weave(grown, weave.thresholds[0]),
            PairForm::Stucco(_) => self.stucco(grown),
            PairForm::Maze(_) | PairForm::Stripes => self.lines(grown),
        }
    }

    /// The first direction of a weave.
    fn weave(&self, grown: &GrownPairs, threshold: f64) -> Result<Vec<Named>, PairReason> {
        let angles = self.angles();
        let mut got = Vec::new();
        for (index, errors) in grown.measured.iter().enumerate() {
            let lost = PairReason::LostDirection { angle: angles[index] };
            let found = errors.got.ok_or_else(|| lost.clone())?;
            if errors.angle.is_some_and(|angle| angle.abs() > TURNED) {
                return Err(lost);
            }
            let period = found.wavelength.ok_or(lost)?;
            got.push(checked(&grown.plan.threads[index], Threads { width: found.width, period })?);
        }
        let Crossed { others, unequal } = crossed(&got, 0);
        let mut named = self.first_line(grown, got[0], grown.plan.by_law(&got, &vec![1.0; got.len()])[0]);
        named.extend([
            ("directions", got.len() as f64),
            ("between", least_between(&angles)),
            ("others", others),
            ("unequal", unequal),
            ("threshold", threshold),
        ]);
        Ok(named)
    }

    /// All lines of a maze, or stripes with tips.
    fn lines(&self, grown: &GrownPairs) -> Result<Vec<Named>, PairReason> {
        let angles = self.angles();
        if self.kind() == Some(PairKind::Maze) {
            let lost = |errors: &StripeErrors| {
                errors.got.is_none() || errors.angle.is_some_and(|angle| angle.abs() > TURNED)
            };
            if let Some(index) = grown.measured.iter().position(lost) {
                return Err(PairReason::LostDirection { angle: angles[index] });
            }
        }
        let level =
            grown.levels[0] * if self.kind() == Some(PairKind::Maze) { self.drawn.level as f32 } else { 1.0 };
        let found = stripes(&grown.differences[0], level).ok_or(PairReason::Blank("no lines".to_owned()))?;
        let got = Threads { width: found.width, period: found.wavelength };
        if self.kind() == Some(PairKind::Stripes) {
            checked(&grown.plan.threads[0], got)?;
        } else {
            periods_are_like(got.period / PERIOD)?;
        }
        let mut named = self.first_line(grown, got, grown.plan.by_law(&[got], &[1.0])[0]);
        named.extend([
            ("angle", found.angle),
            ("directions", angles.len() as f64),
            ("between", least_between(&angles)),
            ("long", grown.plan.length_of_pieces() / PERIOD),
            ("level", self.drawn.level),
        ]);
        Ok(named)
    }

    /// The numbers that the rows of all lines have. `by_law` is the size that the law gives for the measured threads, px.
    fn first_line(&self, grown: &GrownPairs, got: Threads, by_law: f64) -> Vec<Named> {
        let px = grown.plan.px_a_cell();
        let (size, asked) = (grown.plan.usual_sizes()[0], grown.plan.threads[0].mean());
        vec![
            ("periods", self.side() / got.period),
            ("width", got.width / px),
            ("period", got.period / px),
            ("duty", got.duty()),
            ("size", size / px),
            ("factor", size / by_law),
            ("error of width", got.width / asked.width - 1.0),
            ("error of period", got.period * asked.duty() / asked.width - 1.0),
        ]
    }

    fn stucco(&self, grown: &GrownPairs) -> Result<Vec<Named>, PairReason> {
        let blank = || PairReason::Blank("no blotches".to_owned());
        let width = blotch_width(&grown.differences[0], grown.levels[0]).ok_or_else(blank)?;
        let drawn = grown.plan.threads[0].mean();
        let ratio = width / drawn.width;
        if !(WIDTHS[0]..=WIDTHS[1]).contains(&ratio) {
            return Err(PairReason::Blotchy { what: "width", got: ratio });
        }
        let (px, size) = (grown.plan.px_a_cell(), grown.plan.usual_sizes()[0]);
        Ok(vec![
            ("periods", self.periods),
            ("width", width / px),
            ("decay", self.drawn.decay),
            ("size", size / px),
            // The law is proportional to the width.
            ("factor", 1.0 / ratio),
            ("error of width", ratio - 1.0),
        ])
    }

    pub(super) fn cells(&self, grown: &GrownAreas) -> Result<Vec<Named>, PairReason> {
        let AreaForm::Polygons(form) = &grown.plan.form else {
            return Err(PairReason::Blank("no cells".to_owned()));
        };
        let OwnPolygons { own, laid } = grown.own_polygons.unwrap_or_default();
        if (own as f64) < OWN_CELLS * laid as f64 {
            return Err(PairReason::Merged { own, laid });
        }
        let whole: Vec<_> = spots(&grown.field, 0.5).into_iter().filter(|spot| spot.whole).collect();
        let gap = grown.gap.filter(|_| !whole.is_empty());
        let gap = gap.ok_or_else(|| PairReason::Blank("no whole cells".to_owned()))?;
        let mean = |value: &dyn Fn(&Spot) -> f64| whole.iter().map(value).sum::<f64>() / whole.len() as f64;
        let area = mean(&|spot| spot.ellipse.area());
        let px = grown.plan.px_a_cell();
        let wanted = grown.plan.wanted([0.5 * self.side(); 2]);
        let asked = [form.size(&wanted), PolygonForm::distance_of(&wanted)];
        let by_law = distance(area.sqrt(), gap);
        Ok(vec![
            ("cells", laid as f64),
            ("area", area / (px * px)),
            ("aspect", mean(&|spot| spot.ellipse.aspect())),
            ("gap", gap / px),
            ("sparse", area.sqrt() / gap),
            ("size", asked[0] / px),
            ("distance", asked[1] / px),
            ("factor", asked[0] / size(gap, by_law)),
            ("apart", asked[1] / by_law),
            ("error of area", area / wanted.area - 1.0),
            ("error of gap", gap / form.gap - 1.0),
        ])
    }
}

/// The measured lines, if they are close to those asked for.
fn checked(asked: &ThreadMap, got: Threads) -> Result<Threads, PairReason> {
    let asked = asked.mean();
    periods_are_like(got.period / (asked.width / asked.duty()))?;
    let width = got.width / asked.width;
    if !(WIDTHS[0]..=WIDTHS[1]).contains(&width) {
        return Err(PairReason::Blotchy { what: "width", got: width });
    }
    Ok(got)
}

/// Whether a period is close to the drawn one: `got` is their ratio.
fn periods_are_like(got: f64) -> Result<(), PairReason> {
    if got > PERIODS[1] {
        return Err(PairReason::Broken { got });
    }
    if got < PERIODS[0] {
        return Err(PairReason::Blotchy { what: "period", got });
    }
    Ok(())
}
