//! Grown layers, and why a document does not grow.

use crate::document::{Document, DocumentError};
use std::sync::Arc;

use crate::attributes::system::Description;
use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::points::fields::POINTS;
use crate::synth::grow::areas::GrownAreas;
use crate::synth::grow::layer_pattern::LayerPattern;
use crate::synth::grow::pairs::GrownPairs;
use crate::synth::grow::pattern::Pattern;
use crate::synth::grow::point_fields::GrownPoints;
use crate::synth::grow::point_lines::GrownLines;
use crate::synth::grow::probe::ProbeError;
use crate::synth::grow::ragged_edges::Ragged;
use crate::synth::grow::refine::Measured;
use crate::synth::grow::tone::GrownTone;
use crate::synth::memory::TooLarge;
use crate::synth::options::Settings;
use crate::synth::plan::error::{LayOutError, PlanError};
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::offset_curves::CurvesError;
use crate::synth::plan::tone::TonePlanError;
use crate::synth::watch::Cancelled;

impl From<ProbeError> for GrowError {
    fn from(error: ProbeError) -> Self {
        match error {
            ProbeError::Plan(error) => Self::Plan(error),
            ProbeError::Cancelled(cancelled) => Self::Cancelled(cancelled),
        }
    }
}

impl From<TonePlanError> for GrowError {
    fn from(error: TonePlanError) -> Self {
        match error {
            TonePlanError::Document(error) => Self::Document(error),
            TonePlanError::Plan(error) => Self::Plan(error),
            TonePlanError::TooLarge(error) => Self::TooLarge(error),
        }
    }
}

impl GrowError {
    /// Why layer number `layer` could not be laid out.
    pub(super) fn laying_out(layer: usize, error: LayOutError) -> Self {
        match error {
            LayOutError::NoRoom => Self::NoRoom { layer },
            LayOutError::Curves(reason) => Self::Curves { layer, reason },
        }
    }
}

/// A grown layer.
#[derive(Clone)]
pub enum GrownLayer {
    /// Spots or stripes, by a system with training rows.
    Marks(Box<GrownMarks>),
    /// By a system of pairs.
    Pairs(Box<GrownPairs>),
    /// Patches or cells.
    Areas(Box<GrownAreas>),
    /// Streaks or cracks.
    Lines(Box<GrownLines>),
    /// A field of points.
    Points(Box<GrownPoints>),
    /// Spots or stripes that a picture drives.
    Tone(Box<GrownTone>),
}

impl GrownLayer {
    /// The pattern at any size, without what passes under stripes that it crosses.
    #[must_use]
    pub fn pattern(&self) -> LayerPattern<'_> {
        match self {
            Self::Marks(marks) => LayerPattern::Marks(marks.pattern()),
            Self::Pairs(pairs) => LayerPattern::Pairs(pairs.pattern()),
            Self::Areas(patches) => LayerPattern::Areas(patches.pattern()),
            Self::Lines(lines) => LayerPattern::Areas(lines.pattern()),
            Self::Points(points) => LayerPattern::Areas(points.pattern()),
            Self::Tone(tone) => LayerPattern::Tone(tone.pattern()),
        }
    }

    /// Its spots or stripes; `None` of any other layer.
    #[must_use]
    pub fn marks(&self) -> Option<&GrownMarks> {
        if let Self::Marks(marks) = self { Some(marks) } else { None }
    }

    /// As [`Self::marks`].
    #[must_use]
    pub fn into_marks(self) -> Option<GrownMarks> {
        if let Self::Marks(marks) = self { Some(*marks) } else { None }
    }

    /// What pairs have grown; `None` of spots and stripes.
    #[must_use]
    pub fn pairs(&self) -> Option<&GrownPairs> {
        if let Self::Pairs(pairs) = self { Some(pairs) } else { None }
    }

    /// Its patches or cells; `None` of any other layer.
    #[must_use]
    pub fn areas(&self) -> Option<&GrownAreas> {
        if let Self::Areas(patches) = self { Some(patches) } else { None }
    }

    /// Its streaks or cracks; `None` of any other layer.
    #[must_use]
    pub fn lines(&self) -> Option<&GrownLines> {
        if let Self::Lines(lines) = self { Some(lines) } else { None }
    }

    /// Its field of points; `None` of any other layer.
    #[must_use]
    pub fn points(&self) -> Option<&GrownPoints> {
        if let Self::Points(points) = self { Some(points) } else { None }
    }

    /// What a picture drives; `None` of any other layer.
    #[must_use]
    pub fn tone(&self) -> Option<&GrownTone> {
        if let Self::Tone(tone) = self { Some(tone) } else { None }
    }

    /// The system that has grown it.
    #[must_use]
    pub fn system(&self) -> &'static Description {
        match self {
            Self::Marks(marks) => marks.plan.lookup.system.description(),
            Self::Pairs(pairs) => pairs.plan.kind().description(),
            Self::Areas(areas) => areas.plan.kind().description(),
            Self::Lines(lines) => lines.plan.kind.description(),
            Self::Points(_) => &POINTS,
            Self::Tone(tone) => tone.plan.system.description(),
        }
    }

    /// Cells along x and y of the grid that it grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        match self {
            Self::Marks(marks) => marks.plan.lookup.grid.size,
            Self::Pairs(pairs) => pairs.plan.grid.size,
            Self::Areas(patches) => patches.plan.grid.size,
            Self::Lines(lines) => lines.plan.grid.size,
            Self::Points(points) => points.plan.grid.size,
            Self::Tone(tone) => tone.plan.grid.size,
        }
    }

    /// px a cell of that grid.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        match self {
            Self::Marks(marks) => marks.plan.lookup.px_a_cell(),
            Self::Pairs(pairs) => pairs.plan.px_a_cell(),
            Self::Areas(patches) => patches.plan.px_a_cell(),
            Self::Lines(lines) => lines.plan.px_a_cell(),
            Self::Points(points) => points.plan.px_a_cell(),
            Self::Tone(tone) => tone.plan.px_a_cell(),
        }
    }

    /// Whether its pattern settled within its time. Pairs have a time after which they have, and so have areas.
    #[must_use]
    pub fn settled(&self) -> bool {
        match self {
            Self::Marks(marks) => marks.settled,
            Self::Tone(tone) => tone.settled,
            Self::Pairs(_) | Self::Areas(_) | Self::Lines(_) | Self::Points(_) => true,
        }
    }

    /// Steps taken; none where nothing reacts.
    #[must_use]
    pub fn steps(&self) -> u64 {
        match self {
            Self::Marks(marks) => marks.steps,
            Self::Pairs(pairs) => pairs.steps,
            Self::Areas(areas) => areas.steps,
            Self::Lines(_) | Self::Points(_) => 0,
            Self::Tone(tone) => tone.steps,
        }
    }
}

/// Grown spots or stripes.
#[derive(Clone)]
pub struct GrownMarks {
    /// How it was planned.
    pub plan: Plan,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
    /// Factors of the looked-up levels, by region.
    pub correction: Vec<f64>,
    /// Further factors of single spots, see [`Pattern::own`].
    pub own_levels: Vec<f64>,
    /// What was measured, by region.
    pub measured: Measured,
    /// The concentration that shows the marks as a share of the local peak, on the grid.
    pub marks: Field,
    /// The concentrations of each chemical on the grid, where the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
    /// How its edges were roughened, where that was asked for.
    pub ragged: Option<Arc<Ragged>>,
    /// The pattern of the stripes beneath that its own pass under, if they cross any.
    pub crossed: Option<Arc<Field>>,
}

impl GrownMarks {
    /// The pattern at any size, without what passes under stripes that it crosses.
    #[must_use]
    pub fn pattern(&self) -> Pattern<'_> {
        let mut pattern = self.whole_pattern();
        pattern.crossed = self.crossed.as_deref().map(Spline::new);
        pattern
    }

    /// The pattern at any size, with what passes under stripes that it crosses.
    #[must_use]
    pub fn whole_pattern(&self) -> Pattern<'_> {
        let mut pattern = Pattern::new(&self.plan.lookup, &self.marks);
        pattern.correction.clone_from(&self.correction);
        pattern.own.clone_from(&self.own_levels);
        pattern.added = self.ragged.as_deref().map(|ragged| Spline::new(&ragged.added));
        pattern
    }
}

/// A grown texture.
pub struct Grown {
    /// Canvas, px.
    pub size: [u32; 2],
    /// Its layers, the lowest first.
    pub layers: Vec<GrownLayer>,
    /// The document that was grown.
    pub document: Document,
    /// The options that it was grown with.
    pub settings: Settings,
}

/// Why a document was not grown.
#[derive(Debug, thiserror::Error)]
pub enum GrowError {
    /// The document is not valid.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Its parameters could not be looked up.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// It does not fit into memory.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The marks beneath leave no place for any of its own.
    #[error(
        "layer {layer} finds no room: none of its marks fits between those of the layers beneath; draw smaller ones, or those beneath farther apart"
    )]
    NoRoom {
        /// 1 = the lowest.
        layer: usize,
    },
    /// Rings or a web find nothing to go round, or no room.
    #[error("layer {layer} cannot be grown: {reason}")]
    Curves {
        /// 1 = the lowest.
        layer: usize,
        /// Why.
        reason: CurvesError,
    },
    /// Nothing grew, or no ground was left.
    #[error(
        "layer {layer} grew {what}: its marks are too large for the canvas or merged; draw smaller marks, or farther apart"
    )]
    Blank {
        /// 1 = the lowest.
        layer: usize,
        /// What it is instead of a pattern.
        what: &'static str,
    },
    /// All points have the same value.
    #[error(
        "layer {layer} is of one value everywhere: all its points are dark, or all are light; take another probability or size of labels, or a smaller distance"
    )]
    Flat {
        /// 1 = the lowest.
        layer: usize,
    },
    /// The pattern left the range in which its system works.
    #[error(
        "layer {layer} grew no pattern: its concentrations are not finite; try another seed or larger marks"
    )]
    NoPattern {
        /// 1 = the lowest.
        layer: usize,
    },
}
