//! What has grown on a layer, for those who ask for one kind: tests, tables, and what a layer is compared with.

use crate::synth::areas::GrownAreas;
use crate::synth::layer::GrownLayer;
use crate::synth::lines::GrownLines;
use crate::synth::marks::GrownMarks;
use crate::synth::pairs::GrownPairs;
use crate::synth::points::GrownPoints;
use crate::synth::tone::GrownTone;

impl GrownLayer {
    /// Its spots or stripes; `None` of any other layer.
    #[must_use]
    pub fn marks(&self) -> Option<&GrownMarks> {
        self.own().downcast_ref()
    }

    /// Its spots or stripes; `None` of any other layer.
    #[must_use]
    pub fn marks_mut(&mut self) -> Option<&mut GrownMarks> {
        self.own_mut().downcast_mut()
    }

    /// Its spots or stripes; `None` of any other layer.
    #[must_use]
    pub fn into_marks(self) -> Option<GrownMarks> {
        self.into_own().downcast().ok().map(|marks| *marks)
    }

    /// What pairs have grown; `None` of any other layer.
    #[must_use]
    pub fn pairs(&self) -> Option<&GrownPairs> {
        self.own().downcast_ref()
    }

    /// Its patches or cells; `None` of any other layer.
    #[must_use]
    pub fn areas(&self) -> Option<&GrownAreas> {
        self.own().downcast_ref()
    }

    /// Its streaks or cracks; `None` of any other layer.
    #[must_use]
    pub fn lines(&self) -> Option<&GrownLines> {
        self.own().downcast_ref()
    }

    /// Its field of points; `None` of any other layer.
    #[must_use]
    pub fn points(&self) -> Option<&GrownPoints> {
        self.own().downcast_ref()
    }

    /// What a picture drives; `None` of any other layer.
    #[must_use]
    pub fn tone(&self) -> Option<&GrownTone> {
        self.own().downcast_ref()
    }
}
