//! A patch of a system of pairs, grown from a few drawn marks by the laws alone: what its training rows are made of.

use std::f64::consts::PI;

use crate::attributes::system::Description;
use crate::document::{
    AreaKind, Document, DutyChoice, Edges, GapChoice, Layer, LayerOptions, Stroke, SystemChoice,
};
use crate::learn::PairRow;
use crate::measure::{blotch_width, spots, stripes};
use crate::rd::pairs::cells::{distance, size};
use crate::rd::pairs::{PairKind, Threads};
use crate::synth::grow::areas::GrownAreas;
use crate::synth::grow::cascade::grow;
use crate::synth::grow::layer::{GrowError, GrownLayer};
use crate::synth::grow::pairs::GrownPairs;
use crate::synth::options::Options;
use crate::synth::plan::areas::AreaForm;
use crate::synth::plan::pairs::thread_map::ThreadMap;
use crate::synth::plan::pairs::{Crossed, PairForm, crossed, least_between};
use crate::synth::training::Training;
use crate::synth::watch::{Cancelled, Watch};

/// What is drawn for a patch; what a system does not have is not used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// Number of directions.
    pub directions: usize,
    /// Width ÷ period.
    pub duty: f64,
    /// Width ÷ period of the other directions of a weave.
    pub others: f64,
    /// Period of the others ÷ that of the first direction.
    pub unequal: f64,
    /// Angle between two directions, degrees.
    pub between: f64,
    /// The first direction, degrees.
    pub angle: f64,
    /// Length of the lines of a maze ÷ their period.
    pub long: f64,
    /// Level of the edges of a maze ÷ the level where the reaction is half.
    pub level: f64,
    /// Decay of stucco.
    pub decay: f64,
    /// √area of a cell ÷ the width of the lines.
    pub sparse: f64,
    /// Aspect of a cell.
    pub aspect: f64,
}

impl Default for Drawn {
    fn default() -> Self {
        Self {
            directions: 2,
            duty: LayerOptions::DUTY,
            others: LayerOptions::DUTY,
            unequal: 1.0,
            between: 90.0,
            angle: 0.0,
            long: 4.0,
            level: 1.0,
            decay: LayerOptions::default().decay,
            sparse: 5.0,
            aspect: 0.7,
        }
    }
}

/// A patch that is to be grown.
#[derive(Clone, Copy, Debug)]
pub struct PairPatch {
    /// One of [`crate::synth::training::PAIRS`].
    pub system: &'static Description,
    /// What is drawn.
    pub drawn: Drawn,
    /// Periods along a side, of the widest; of cells how many.
    pub periods: f64,
    /// Of fewer than these nothing is learnt.
    pub least: f64,
    /// Seed of all that is random.
    pub seed: u64,
}

/// Why a patch is not learnt from.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PairReason {
    /// Nothing grew.
    #[error("no pattern: {0}")]
    Blank(String),
    /// The lines are not as they were drawn.
    #[error("the {what} is {got:.2} times what was drawn")]
    Blotchy {
        /// What differs.
        what: &'static str,
        /// What grew ÷ what was drawn.
        got: f64,
    },
    /// Lines have gaps: they are farther apart than drawn.
    #[error("lines are broken: they are {got:.2} times as far apart as drawn")]
    Broken {
        /// Period ÷ what was drawn.
        got: f64,
    },
    /// Lines of a direction died.
    #[error("the direction {angle:.0}° died")]
    LostDirection {
        /// The direction, degrees.
        angle: f64,
    },
    /// Too few lines or cells to take means over.
    #[error("{found:.1} periods or cells are too few, at least {least} are needed")]
    TooFew {
        /// Periods along a side, or cells.
        found: f64,
        /// The least number.
        least: f64,
    },
    /// Cells merged.
    #[error("{own} of {laid} cells have an area of their own")]
    Merged {
        /// Cells with an area of their own.
        own: usize,
        /// Cells that were laid.
        laid: usize,
    },
}

impl PairReason {
    /// All values of [`Self::kind`].
    pub const KINDS: [&'static str; 6] =
        ["no-pattern", "too-few", "blotchy", "broken", "lost-direction", "merged"];

    /// The reason in one word, for counting.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        let [no_pattern, too_few, blotchy, broken, lost, merged] = Self::KINDS;
        match self {
            Self::Blank(_) => no_pattern,
            Self::TooFew { .. } => too_few,
            Self::Blotchy { .. } => blotchy,
            Self::Broken { .. } => broken,
            Self::LostDirection { .. } => lost,
            Self::Merged { .. } => merged,
        }
    }
}

/// Period of the first direction, px; the grid is as fine as its pair needs, whatever it is.
const PERIOD: f64 = 24.0;
/// Width of the lines between cells, px.
const GAP: f64 = 8.0;
/// Widths within these factors of what was drawn are learnt from.
const WIDTHS: [f64; 2] = [0.5, 1.7];
/// Periods within these are.
const PERIODS: [f64; 2] = [0.75, 1.3];
/// Lines that run this far from the direction that was drawn are others, degrees.
const TURNED: f64 = 15.0;
/// The share of the laid cells that have an area of their own, least.
const OWN_CELLS: f64 = 0.9;

impl PairPatch {
    /// What is drawn, as a document.
    #[must_use]
    pub fn document(&self) -> Document {
        let Drawn { duty, decay, .. } = self.drawn;
        let lines = |angles: &[f64], long: f64| -> Vec<Stroke> {
            angles.iter().enumerate().flat_map(|(index, angle)| self.two_lines(index, *angle, long)).collect()
        };
        let long = 0.6 * self.side();
        let (strokes, options) = match self.kind() {
            Some(PairKind::Weave) => (lines(&self.angles(), long), LayerOptions::default()),
            Some(PairKind::Maze) => {
                (lines(&self.angles(), self.drawn.long * PERIOD), LayerOptions::default())
            }
            Some(PairKind::Stripes) => (
                lines(&[self.drawn.angle], long),
                LayerOptions { duty: DutyChoice::Given(duty), ..LayerOptions::default() },
            ),
            Some(PairKind::Stucco) => {
                let middle = 0.5 * self.side();
                let disc = Stroke::ellipse([middle; 2], [0.2 * PERIOD; 2], 0.0);
                (vec![disc], LayerOptions { decay, ..LayerOptions::default() })
            }
            None => self.one_cell(),
        };
        let system = self.kind().map_or(SystemChoice::Areas(AreaKind::Cells), SystemChoice::Pairs);
        let layer = Layer::new(strokes).with_system(system).with_options(options);
        Document::new([self.side().round() as u32; 2])
            .with_edges(Edges::Closed)
            .with_seed(self.seed)
            .with_layer(layer)
    }

    /// The system of pairs; `None` of cells.
    fn kind(&self) -> Option<PairKind> {
        PairKind::ALL.into_iter().find(|kind| kind.description().name == self.system.name)
    }

    /// Side of the patch, px.
    fn side(&self) -> f64 {
        match self.kind() {
            None => self.periods.sqrt() * distance(self.drawn.sparse * GAP, GAP),
            Some(PairKind::Weave) => self.periods * PERIOD * self.drawn.unequal.max(1.0),
            Some(_) => self.periods * PERIOD,
        }
    }

    /// The directions that are drawn, degrees.
    fn angles(&self) -> Vec<f64> {
        let Drawn { directions, between, angle, .. } = self.drawn;
        match directions {
            2 => vec![angle, angle + between],
            // Two of the three angles are the same.
            3 if self.kind() == Some(PairKind::Weave) => {
                vec![angle, angle + between, angle + 0.5 * (180.0 + between)]
            }
            _ => (0..directions).map(|k| angle + k as f64 * 180.0 / directions as f64).collect(),
        }
    }

    /// What is drawn of direction number `index`.
    fn threads(&self, index: usize) -> Threads {
        let Drawn { duty, others, unequal, .. } = self.drawn;
        let (duty, period) = match self.kind() {
            Some(PairKind::Weave) if index > 0 => (others, unequal * PERIOD),
            _ => (duty, PERIOD),
        };
        Threads { width: duty * period, period }
    }

    /// Two lines side by side, about the middle; of a maze about a place of their own.
    fn two_lines(&self, index: usize, angle: f64, long: f64) -> [Stroke; 2] {
        let threads = self.threads(index);
        let mut center = [0.5 * self.side(); 2];
        if self.kind() == Some(PairKind::Maze) {
            let turn = std::f64::consts::TAU * index as f64 / self.drawn.directions as f64;
            let away = 0.25 * self.side();
            center = [center[0] + away * libm::cos(turn), center[1] + away * libm::sin(turn)];
        }
        side_by_side(center, angle, threads, long)
    }

    /// One ellipse and the width of the lines.
    fn one_cell(&self) -> (Vec<Stroke>, LayerOptions) {
        let Drawn { sparse, aspect, angle, .. } = self.drawn;
        let major = sparse * GAP / (PI * aspect).sqrt();
        let cell = Stroke::ellipse([0.5 * self.side(); 2], [major, aspect * major], angle);
        let gap = GapChoice::Given(GAP);
        (vec![cell], LayerOptions { keep: Some(false), gap, ..LayerOptions::default() })
    }

    /// Grows it by the laws alone, and measures it: a row with the seed of the patch, or why it is not learnt from.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn grow(&self, watch: &Watch) -> Result<Result<PairRow, PairReason>, Cancelled> {
        let training = Training::with_pairs(self.system, Vec::new()).unwrap_or_default();
        let grown = self.grown(&training, false, watch)?;
        Ok(grown.and_then(|named| self.enough(named)).map(|named| {
            let value =
                |name: &str| named.iter().find(|(of, _)| *of == name).map_or(0.0, |(_, value)| *value);
            let values = self.system.columns.iter().map(|column| value(column.name)).collect();
            PairRow { seed: self.seed, values }
        }))
    }

    /// Grows it as a document is grown, with what `training` says of the laws, corrected or not: how much larger than drawn what
    /// was measured is, relative, by name; or why it is no texture.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn errors(
        &self,
        training: &Training,
        corrects: bool,
        watch: &Watch,
    ) -> Result<Result<Vec<Named>, PairReason>, Cancelled> {
        let grown = self.grown(training, corrects, watch)?;
        Ok(grown.map(|named| {
            let errors = named.iter().filter_map(|(name, value)| Some((name.strip_prefix(ERROR)?, *value)));
            errors.collect()
        }))
    }

    /// What was measured, by the names of the columns, and errors by names that begin with [`ERROR`].
    fn grown(
        &self,
        training: &Training,
        corrects: bool,
        watch: &Watch,
    ) -> Result<Result<Vec<Named>, PairReason>, Cancelled> {
        let options = Options {
            refine: Some(corrects),
            source: "the patch",
            training,
            watch: *watch,
            ..Options::default()
        };
        let grown = match grow(&self.document(), &options) {
            Ok(grown) => grown,
            Err(GrowError::Cancelled(cancelled)) => return Err(cancelled),
            Err(error) => return Ok(Err(PairReason::Blank(error.to_string()))),
        };
        Ok(match grown.layers.first() {
            Some(GrownLayer::Pairs(pairs)) => self.pairs(pairs),
            Some(GrownLayer::Areas(areas)) => self.cells(areas),
            _ => Err(PairReason::Blank("no layer".to_owned())),
        })
    }

    /// What was measured, where there are enough periods or cells.
    fn enough(&self, named: Vec<Named>) -> Result<Vec<Named>, PairReason> {
        let found = named.iter().find(|(name, _)| ["periods", "cells"].contains(name)).map_or(0.0, |of| of.1);
        if found < self.least { Err(PairReason::TooFew { found, least: self.least }) } else { Ok(named) }
    }

    /// The numbers of lines or blotches, by the names of their columns.
    fn pairs(&self, grown: &GrownPairs) -> Result<Vec<Named>, PairReason> {
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
            let lost = |errors: &crate::measure::StripeErrors| {
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

    /// What rows of all lines have. `by_law` is the size that the law gives for what was measured, px.
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

    fn cells(&self, grown: &GrownAreas) -> Result<Vec<Named>, PairReason> {
        let AreaForm::Cells(form) = &grown.plan.form else {
            return Err(PairReason::Blank("no cells".to_owned()));
        };
        let [own, laid] = grown.own_cells.unwrap_or_default();
        if (own as f64) < OWN_CELLS * laid as f64 {
            return Err(PairReason::Merged { own, laid });
        }
        let whole: Vec<_> = spots(&grown.field, 0.5).into_iter().filter(|spot| spot.whole).collect();
        let gap = grown.gap.filter(|_| !whole.is_empty());
        let gap = gap.ok_or_else(|| PairReason::Blank("no whole cells".to_owned()))?;
        let mean = |value: &dyn Fn(&crate::measure::Spot) -> f64| {
            whole.iter().map(value).sum::<f64>() / whole.len() as f64
        };
        let area = mean(&|spot| spot.ellipse.area());
        let px = grown.plan.px_a_cell();
        let wanted = grown.plan.wanted([0.5 * self.side(); 2]);
        let asked = [form.size(&wanted), crate::synth::plan::areas::cells::CellForm::distance_of(&wanted)];
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

/// Two lines `long` px long side by side about `center`, in the direction `angle`, degrees.
#[must_use]
pub fn side_by_side(center: [f64; 2], angle: f64, threads: Threads, long: f64) -> [Stroke; 2] {
    let (s, c) = libm::sincos(angle.to_radians());
    [-0.5, 0.5].map(|side| {
        let off = side * threads.period;
        let at = |along: f64| [center[0] + along * c - off * s, center[1] + along * s + off * c];
        Stroke::line(at(-0.5 * long), at(0.5 * long), threads.width)
    })
}

/// A value by its name.
type Named = (&'static str, f64);

/// How names of errors begin.
const ERROR: &str = "error of ";

/// Lines where they are like what was asked for.
fn checked(asked: &ThreadMap, got: Threads) -> Result<Threads, PairReason> {
    let asked = asked.mean();
    periods_are_like(got.period / (asked.width / asked.duty()))?;
    let width = got.width / asked.width;
    if !(WIDTHS[0]..=WIDTHS[1]).contains(&width) {
        return Err(PairReason::Blotchy { what: "width", got: width });
    }
    Ok(got)
}

/// Whether a period is like the one that was drawn: `got` is their ratio.
fn periods_are_like(got: f64) -> Result<(), PairReason> {
    if got > PERIODS[1] {
        return Err(PairReason::Broken { got });
    }
    if got < PERIODS[0] {
        return Err(PairReason::Blotchy { what: "period", got });
    }
    Ok(())
}
