//! What has grown on a model.

use crate::document::Document;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::placed::Placed;

/// The layers that have grown on a model.
pub struct GrownBody {
    /// The document that was grown.
    pub document: Document,
    /// The model, px.
    pub placed: Placed,
    /// Its layers, the lowest first. Each has grown on a mesh of its own.
    pub layers: Vec<BodyLayer>,
}

impl GrownBody {
    /// The layer with the finest mesh; the highest of equal ones.
    #[must_use]
    pub fn finest(&self) -> &BodyLayer {
        let vertices = |layer: &&BodyLayer| layer.plan.surface().mesh.positions.len();
        self.layers.iter().max_by_key(vertices).expect("a body that has grown has a layer")
    }
}
