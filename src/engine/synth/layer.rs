//! The list of the kinds of layers: the only place that tells them apart.
//!
//! A kind is a folder of this room with an implementation of [`Kind`], and a line in the list below. Everything else asks the plan,
//! the growth or the grown layer.

mod own;

use std::any::Any;
use std::sync::Arc;

use crate::attributes::system::Description;
use crate::document::{After, Document, tile};
use crate::grid::Field;
use crate::synth::areas::Areas;
use crate::synth::drawn::parametric;
use crate::synth::error::LayerError;
#[cfg(test)]
use crate::synth::flat::Flat;
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, GrownBeneath, Kind, Planned, Previewed, Request, Seen, Setting,
    Trial,
};
use crate::synth::lines::Lines;
use crate::synth::marks::Marks;
use crate::synth::memory::{self, TooLarge};
use crate::synth::pairs::Pairs;
use crate::synth::pattern::{AreaPattern, LayerPattern};
use crate::synth::points::Points;
use crate::synth::report::{DrawnMark, LayerReport};
use crate::synth::shaped::Shapes;
use crate::synth::thinned::Thinning;
use crate::synth::tone::Driven;
use crate::synth::watch::Stage;

/// Defines the plan, the growth and the grown layer of any kind, from the list of kinds.
macro_rules! kinds {
    ($($(#[doc = $doc:literal])* $(#[cfg($only:meta)])? $name:ident: $kind:ty),* $(,)?) => {
        /// A kind of layer.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum LayerKind {
            $($(#[doc = $doc])* $(#[cfg($only)])? $name),*
        }

        /// The plan of a layer.
        #[derive(Clone)]
        pub enum LayerPlan {
            $($(#[doc = $doc])* $(#[cfg($only)])? $name(Box<<$kind as Kind>::Plan>)),*
        }

        /// A layer that grows.
        pub enum LayerGrowth<'a> {
            $($(#[doc = $doc])* $(#[cfg($only)])? $name(Box<<$kind as Kind>::Growth<'a>>)),*
        }

        /// A grown layer, and the pattern that is shown instead of its own one, if there is such.
        #[derive(Clone)]
        pub enum GrownLayer {
            $($(#[doc = $doc])* $(#[cfg($only)])? $name(Box<<$kind as Kind>::Grown>, Option<Arc<Field>>)),*
        }

        impl LayerKind {
            /// The kind of layer `index` of `document`: the first of the list that takes it.
            #[must_use]
            pub fn of(document: &Document, index: usize) -> Self {
                let kinds = [$($(#[cfg($only)])? (Self::$name, <$kind as Kind>::takes as fn(&Document, usize) -> bool)),*];
                let found = kinds.into_iter().find(|(_, takes)| takes(document, index));
                found.map_or(Self::Marks, |(kind, _)| kind)
            }

            /// Plans a layer of this kind.
            ///
            /// # Errors
            /// Those of [`Kind::read`].
            pub fn read(self, request: &Request) -> Result<LayerPlan, LayerError> {
                match self {
                    $($(#[cfg($only)])? Self::$name => {
                        <$kind as Kind>::read(request).map(|plan| LayerPlan::$name(Box::new(plan)))
                    })*
                }
            }

            /// Whether a smaller canvas of the same texture takes the same time a px.
            #[must_use]
            pub fn scales(self) -> bool {
                match self {
                    $($(#[cfg($only)])? Self::$name => <$kind as Kind>::SCALES,)*
                }
            }

            /// The reason why no film can show how such a layer becomes another one; `None` if one can.
            #[must_use]
            pub fn no_morph(self, document: &Document, index: usize) -> Option<String> {
                match self {
                    $($(#[cfg($only)])? Self::$name => <$kind as Kind>::no_morph(document, index),)*
                }
            }
        }

        impl LayerPlan {
            /// The common part of all plans.
            #[must_use]
            pub fn planned(&self) -> Planned {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::planned(plan),)*
                }
            }

            /// Whether the layer grows as planned, independently of the layers beneath it.
            #[must_use]
            pub fn is_final(&self) -> bool {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::is_final(plan),)*
                }
            }

            /// Bytes of memory that it needs on a grid of this number of cells for a canvas of `size` px.
            #[must_use]
            pub fn bytes(&self, size: [f64; 2], grid: [usize; 2]) -> f64 {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::bytes(plan, size, grid),)*
                }
            }

            /// Seconds that it takes on one core, by laws.
            #[must_use]
            pub fn seconds(&self) -> f64 {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::seconds(plan),)*
                }
            }

            /// A part of the growth for measuring its speed; `None` if there is no room to begin.
            #[must_use]
            pub fn trial(&self, seed: u64) -> Option<Trial> {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::trial(plan, seed),)*
                }
            }

            /// The output of `check` for it, besides the `notes` on every kind of layer.
            #[must_use]
            pub fn describe(&self, request: &Request, notes: Vec<String>) -> Described {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::describe(plan, request, notes),)*
                }
            }

            /// A rough first picture of the growth above the layers `beneath`; `None` if the growth shows its own picture as soon.
            #[must_use]
            pub fn preview(&self, beneath: &Beneath, seed: u64) -> Option<Box<dyn Previewed>> {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => <$kind as Kind>::preview(plan, beneath, seed),)*
                }
            }

            /// The plan itself, for a layer above that tests whether it is of its own kind.
            #[must_use]
            pub fn own(&self) -> &dyn Any {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => &**plan,)*
                }
            }

            /// Begins the growth above the grown layers `beneath`.
            ///
            /// # Errors
            /// There is no room.
            pub fn begin<'a>(
                self,
                beneath: &Beneath,
                setting: Setting<'a>,
            ) -> Result<LayerGrowth<'a>, LayerError> {
                match self {
                    $($(#[cfg($only)])? Self::$name(plan) => {
                        let growth = <$kind as Kind>::begin(*plan, beneath, setting)?;
                        Ok(LayerGrowth::$name(Box::new(growth)))
                    })*
                }
            }
        }

        impl LayerGrowth<'_> {
            /// Does about `budget` cell updates of work.
            ///
            /// # Errors
            /// Why the layer does not grow.
            pub fn advance(&mut self, budget: u64) -> Result<Advanced, LayerError> {
                match self {
                    $($(#[cfg($only)])? Self::$name(growth) => <$kind as Kind>::advance(growth, budget),)*
                }
            }

            /// The current stage of the work, and the share of it that is done, 0..1.
            #[must_use]
            pub fn progress(&self) -> (Stage, f64) {
                match self {
                    $($(#[cfg($only)])? Self::$name(growth) => <$kind as Kind>::progress(growth),)*
                }
            }

            /// Cell updates of `time` of normalised time on the current grid.
            #[must_use]
            pub fn updates_in(&self, time: f64) -> u64 {
                match self {
                    $($(#[cfg($only)])? Self::$name(growth) => <$kind as Kind>::updates_in(growth, time),)*
                }
            }

            /// The current state of the layer; `None` while it is planned or measured.
            #[must_use]
            pub fn seen(&self) -> Option<Seen<'_>> {
                match self {
                    $($(#[cfg($only)])? Self::$name(growth) => <$kind as Kind>::seen(growth),)*
                }
            }

            /// The drawn marks without room, as far as they are known.
            #[must_use]
            pub fn left_out(&self) -> Vec<DrawnMark> {
                match self {
                    $($(#[cfg($only)])? Self::$name(growth) => <$kind as Kind>::left_out(growth),)*
                }
            }

            /// The grown layer; `None` before it is done.
            #[must_use]
            pub fn complete(self) -> Option<GrownLayer> {
                match self {
                    $($(#[cfg($only)])? Self::$name(growth) => {
                        <$kind as Kind>::complete(*growth).map(|grown| GrownLayer::$name(Box::new(grown), None))
                    })*
                }
            }
        }

        impl GrownLayer {
            /// The common part of the plan from which it grew.
            #[must_use]
            pub fn planned(&self) -> Planned {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => <$kind as Kind>::planned_of(grown),)*
                }
            }

            /// The way in which its growth ended.
            #[must_use]
            pub fn ending(&self) -> Ending {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => <$kind as Kind>::ending(grown),)*
                }
            }

            /// The pattern at any size, without the parts that pass under stripes that it crosses.
            #[must_use]
            pub fn pattern(&self) -> LayerPattern<'_> {
                match self {
                    $($(#[cfg($only)])? Self::$name(_, Some(shaped)) => Box::new(AreaPattern::new(shaped)),)*
                    $($(#[cfg($only)])? Self::$name(grown, None) => <$kind as Kind>::pattern(grown),)*
                }
            }

            /// For each drawn mark, how it has grown.
            #[must_use]
            pub fn drawn(&self) -> Vec<DrawnMark> {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => <$kind as Kind>::drawn(grown),)*
                }
            }

            /// The drawn marks that found no room.
            #[must_use]
            pub fn left_out(&self) -> Vec<DrawnMark> {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => <$kind as Kind>::left_out_of(grown),)*
                }
            }

            /// Fills in the particulars of its kind in the report of layer `index`.
            pub fn report(&self, document: &Document, index: usize, report: &mut LayerReport) {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => {
                        <$kind as Kind>::report(grown, document, index, report);
                    })*
                }
            }

            /// The advice for a layer with nothing but marks (`full`), or with none.
            #[must_use]
            pub fn advice(&self, full: bool) -> &'static str {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => <$kind as Kind>::advice(grown, full),)*
                }
            }

            /// The concentration of each chemical by its letter, where they were kept.
            #[must_use]
            pub fn chemicals(&self) -> Vec<(String, Field)> {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => <$kind as Kind>::chemicals(grown),)*
                }
            }

            /// The grown layer of a particular kind, by value, for callers that test for a kind.
            #[must_use]
            pub fn into_own(self) -> Box<dyn Any> {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => grown,)*
                }
            }

            /// The grown layer of a particular kind, mutable, for callers that test for a kind.
            #[must_use]
            pub fn own_mut(&mut self) -> &mut dyn Any {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => &mut **grown,)*
                }
            }

            /// The grown layer of a particular kind, for callers that test for a kind.
            #[must_use]
            pub fn own(&self) -> &dyn Any {
                match self {
                    $($(#[cfg($only)])? Self::$name(grown, _) => &**grown,)*
                }
            }

            /// Shows this field, 0..1 with its edges at ½, instead of the pattern that has grown.
            pub fn show(&mut self, field: Field) {
                match self {
                    $($(#[cfg($only)])? Self::$name(_, shaped) => *shaped = Some(Arc::new(field)),)*
                }
            }
        }
    };
}

kinds! {
    /// A layer that a picture or Turing's growth drives.
    Tone: Driven,
    /// A layer of a system of pairs of morphogens.
    Pairs: Pairs,
    /// Patches or cells.
    Areas: Areas,
    /// Streaks or cracks.
    Lines: Lines,
    /// A field of points.
    Points: Points,
    /// One flat colour.
    #[cfg(test)]
    Flat: Flat,
    /// Spots or stripes, by a system with training rows.
    Marks: Marks,
}

impl LayerPlan {
    /// Plans layer `index` of a document.
    ///
    /// # Errors
    /// It cannot be grown: file, place, value, what is allowed; or a training set cannot be read.
    pub fn read(request: &Request) -> Result<Self, LayerError> {
        tile::check(request.size, request.document.edges).map_err(|p| p.in_file(request.source))?;
        let kind = LayerKind::of(request.document, request.index);
        let checked = parametric::check(request.document, request.index, kind == LayerKind::Marks);
        checked.map_err(|problem| problem.in_file(request.source))?;
        kind.read(request)
    }

    /// Checks that it fits into the memory of the `request` that it was read by.
    ///
    /// # Errors
    /// [`TooLarge`] with the numbers.
    pub fn fits(&self, request: &Request) -> Result<(), TooLarge> {
        let Request { size, memory: free, .. } = *request;
        let grid = self.planned().grid.size;
        let later = matches!(self, Self::Pairs(_) | Self::Lines(_));
        let layer = &request.document.layers[request.index];
        let shapes = Shapes::of(&layer.options, later);
        let shaped = shapes.map_or(0.0, |_| Shapes::bytes(size));
        let thinned = if layer.after == After::Near { Thinning::bytes(grid) } else { 0.0 };
        memory::fits(self.bytes(size, grid) + shaped + thinned, size, grid, free)
    }
}

impl GrownLayer {
    /// The system that grew it.
    #[must_use]
    pub fn system(&self) -> &'static Description {
        self.planned().system
    }

    /// Whether its edges get their raggedness after its growth.
    #[must_use]
    pub fn is_made_ragged_later(&self) -> bool {
        matches!(self, Self::Pairs(..) | Self::Lines(..))
    }

    /// Cells along x and y of the grid that it grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.planned().grid.size
    }

    /// px a cell of that grid.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        self.planned().grid.px_a_cell()
    }

    /// Whether its pattern settled within its time.
    #[must_use]
    pub fn settled(&self) -> bool {
        self.ending().settled
    }

    /// Steps taken; none for kinds without reactions.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.ending().steps
    }
}

impl GrownBeneath for GrownLayer {
    fn pattern(&self) -> LayerPattern<'_> {
        self.pattern()
    }

    fn grid(&self) -> [usize; 2] {
        self.grid()
    }

    fn grown(&self) -> &dyn Any {
        self.own()
    }
}
