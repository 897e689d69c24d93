//! The model with cells of one size, made round by round.

use crate::document::Body;
use crate::surface::{Remeshing, Surface};
use crate::synth::body::placed::Placed;

/// The edge of an equilateral triangulation whose cells have an area of 1.
const EDGE: f64 = 1.074_569_931_823_542;

/// A model that gets cells of about one size.
pub struct Remeshed {
    remeshing: Remeshing,
    edge: f64,
}

impl Remeshed {
    /// Begins with a model that shall have cells of about `cell` px.
    #[must_use]
    pub fn begin(placed: &Placed, cell: f64) -> Self {
        let edge = EDGE * cell;
        Self { remeshing: Remeshing::new(&placed.mesh, &|_| edge), edge }
    }

    /// One round. Returns whether there is more to do.
    pub fn advance(&mut self) -> bool {
        let edge = self.edge;
        self.remeshing.advance(&|_| edge)
    }

    /// The share that is done, 0..1.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.remeshing.share()
    }

    /// The surface that was made, and before it one with edges twice as long.
    #[must_use]
    pub fn surfaces(self, body: &Body) -> [Surface; 2] {
        self.remeshing.into_meshes().map(|mesh| Surface::new(mesh, body.along.vector()))
    }
}
