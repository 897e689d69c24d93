//! Access to the grown layer of one kind, for tests, tables and comparisons.

use crate::synth::areas::GrownAreas;
use crate::synth::layer::GrownLayer;
use crate::synth::lines::GrownLines;
use crate::synth::marks::GrownMarks;
use crate::synth::pairs::GrownPairs;
use crate::synth::points::GrownPoints;
use crate::synth::tone::GrownTone;

impl GrownLayer {
    /// Its spots or stripes; `None` for any other layer.
    #[must_use]
    pub fn marks(&self) -> Option<&GrownMarks> {
        self.own().downcast_ref()
    }

    /// Its spots or stripes, mutable; `None` for any other layer.
    #[must_use]
    pub fn marks_mut(&mut self) -> Option<&mut GrownMarks> {
        self.own_mut().downcast_mut()
    }

    /// Its spots or stripes, by value; `None` for any other layer.
    #[must_use]
    pub fn into_marks(self) -> Option<GrownMarks> {
        self.into_own().downcast().ok().map(|marks| *marks)
    }

    /// Its pattern of pairs; `None` for any other layer.
    #[must_use]
    pub fn pairs(&self) -> Option<&GrownPairs> {
        self.own().downcast_ref()
    }

    /// Its patches or cells; `None` for any other layer.
    #[must_use]
    pub fn areas(&self) -> Option<&GrownAreas> {
        self.own().downcast_ref()
    }

    /// Its streaks or cracks; `None` for any other layer.
    #[must_use]
    pub fn lines(&self) -> Option<&GrownLines> {
        self.own().downcast_ref()
    }

    /// Its field of points; `None` for any other layer.
    #[must_use]
    pub fn points(&self) -> Option<&GrownPoints> {
        self.own().downcast_ref()
    }

    /// Its pattern driven by a picture; `None` for any other layer.
    #[must_use]
    pub fn tone(&self) -> Option<&GrownTone> {
        self.own().downcast_ref()
    }
}
