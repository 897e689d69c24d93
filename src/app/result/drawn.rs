//! What has grown of each drawn mark of the present sketch.

use super::{LayerResult, Outcome, finished_layer};
use crate::app::growth::Growth;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::synth::report::DrawnMark;

/// What has grown of the drawn marks of a sketch, by layer of the document that is grown: while the texture grows, only
/// the marks for which there is no room; once it is measured, all.
#[derive(Clone, Debug, Default)]
pub struct Drawn<'a> {
    marks: Vec<&'a [DrawnMark]>,
    layers: &'a [LayerResult],
}

impl<'a> Drawn<'a> {
    /// From the `outcome` of the sketch, else from its `growth`.
    #[must_use]
    pub fn new(outcome: Option<&'a Outcome>, growth: &'a Growth) -> Self {
        match outcome {
            Some(outcome) => Self {
                marks: outcome.layers.iter().map(|layer| &layer.drawn[..]).collect(),
                layers: &outcome.layers,
            },
            None => Self { marks: growth.left_out.iter().map(|layer| &layer[..]).collect(), layers: &[] },
        }
    }

    /// The marks of a layer of the session.
    #[must_use]
    pub fn of_layer(&self, session: &Session, layer: usize) -> &'a [DrawnMark] {
        finished_layer(session, layer).and_then(|layer| self.marks.get(layer).copied()).unwrap_or_default()
    }

    /// Where two spots of a layer of the session grew together, px.
    #[must_use]
    pub fn merged(&self, session: &Session, layer: usize) -> &'a [[f64; 2]] {
        let layer = finished_layer(session, layer).and_then(|layer| self.layers.get(layer));
        layer.map_or(&[], |layer| &layer.merged)
    }

    /// What has grown of one mark; `None` where the mark itself is not part of the texture.
    #[must_use]
    pub fn mark(&self, session: &Session, place: Place) -> Option<&'a DrawnMark> {
        self.of_layer(session, place.layer).iter().find(|mark| mark.mark == place.stroke)
    }

    /// Why a mark does not grow; `None` where it does.
    #[must_use]
    pub fn lost(&self, session: &Session, place: Place) -> Option<&'static str> {
        self.mark(session, place).filter(|mark| !mark.there)?.reason
    }
}
