//! The finish of what has grown on a model.

use crate::export::bake::Fields;
use crate::export::srgb_from_linear;
use crate::finish::body::{SurfaceFinish, SurfaceSource};
use crate::surface::SurfacePoint;
use crate::synth::body::coat::Coat;
use crate::synth::body::flow;
use crate::synth::body::grown::GrownBody;
use crate::synth::pattern::EDGE;
use crate::synth::watch::Watch;

impl GrownBody {
    /// The finish of its document on the mesh of the finest layer; `None` if the document has none, or it was cancelled.
    #[must_use]
    pub fn finish(&self, watch: &Watch) -> Option<SurfaceFinish<'_>> {
        let finishing = self.document.finish.as_ref()?;
        let surface = self.finest().plan.surface();
        let patterns = self.painted();
        let raised = self.raised();
        // Marks beneath keep their place.
        let label = |vertex: usize| {
            let mark = raised.iter().find(|layer| patterns[**layer][vertex] >= EDGE);
            mark.map_or(0, |layer| *layer as u8 + 1)
        };
        let labels = (0..surface.mesh.positions.len()).map(label).collect();
        let flow = match finishing.finish.kind.has_flow() {
            true => flow::of(self, &finishing.flow),
            false => vec![[0.0; 3]; surface.mesh.positions.len()],
        };
        let coat = Coat::new(&self.document);
        let fields = Fields::new(surface, &patterns.iter().map(Vec::as_slice).collect::<Vec<_>>());
        let paint = move |point: SurfacePoint| {
            let values = fields.values(point);
            let [red, green, blue] =
                coat.light(&values).map(|light| srgb_from_linear(f64::from(light)) as f32);
            let is_mark = raised.iter().any(|layer| values[*layer] >= EDGE);
            [red, green, blue, f32::from(u8::from(is_mark))]
        };
        let source =
            SurfaceSource { surface, paint: Box::new(paint), labels, flow, seed: self.document.seed };
        SurfaceFinish::new(finishing.finish, source, watch.cancelled)
    }
}
