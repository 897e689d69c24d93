//! The texture of the frozen layers, dimmed under the strokes of the active layer.

use std::sync::Arc;

use egui::{Color32, Painter, Rect, TextureHandle, TextureOptions, Ui, pos2};

use super::growth::{Growth, Picture, Texture, essence};
use crate::document::Document;
use crate::editor::session::Session;
use crate::editor::task::{StartError, Task, Tasks, Worker};

/// The longest side of the picture, px: enough for a dimmed background.
const LONGEST: usize = 1024;
/// Its opacity.
const OPACITY: f32 = 0.42;

/// A number of the lowest layers, and the document to which they belong.
type Lowest = (usize, Arc<Document>);

/// The picture under the canvas.
#[derive(Default)]
pub struct Underlay {
    texture: Option<TextureHandle>,
    /// The layers that the picture shows, or will show once it is painted.
    painted: Option<Lowest>,
    painting: Option<Task<Picture>>,
    /// The session's revision and number of frozen layers at the last comparison.
    seen: Option<(u64, usize)>,
}

impl Underlay {
    /// Updates the picture after layers were frozen or a texture has settled. The picture is painted on another thread.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn follow(
        &mut self,
        ui: &Ui,
        session: &Session,
        growth: &Growth,
        tasks: &Tasks,
    ) -> Result<(), StartError> {
        if session.frozen() == 0 {
            *self = Self::default();
            return Ok(());
        }
        if let Some(picture) = self.painting.as_mut().and_then(Task::poll) {
            self.texture = Some(ui.ctx().load_texture("beneath", picture.image, TextureOptions::LINEAR));
            self.painting = None;
        }
        // Empty layers are not grown.
        let frozen = session.document().layers.iter().take(session.frozen());
        let count = frozen.filter(|layer| !layer.is_blank()).count();
        if self.seen != Some((session.revision(), count)) {
            self.seen = Some((session.revision(), count));
            let finished = session.finished();
            let same =
                |(painted, document): &Lowest| *painted == count && grows_alike(&finished, document, count);
            if !self.painted.as_ref().is_some_and(same) {
                (self.texture, self.painted, self.painting) = (None, None, None);
            }
        }
        if let (1.., Some(settled)) = (count, &growth.texture) {
            let known = |(painted, of): &Lowest| *painted == count && Arc::ptr_eq(of, &settled.document);
            if !self.painted.as_ref().is_some_and(known) && settled.document.layers.len() >= count {
                return self.paint_anew(settled, count, tasks);
            }
        }
        Ok(())
    }

    fn paint_anew(&mut self, settled: &Texture, count: usize, tasks: &Tasks) -> Result<(), StartError> {
        // Set also where no thread starts: this is reported once, and tried again for the next texture.
        self.painted = Some((count, Arc::clone(&settled.document)));
        let settled = settled.clone();
        let work = move |worker: &Worker<_>| worker.send(Picture::lowest(&settled, count, LONGEST));
        self.painting = Some(tasks.start("painting the frozen layers", work)?);
        Ok(())
    }

    /// Whether there is a picture of frozen layers.
    #[must_use]
    pub fn is_there(&self) -> bool {
        self.texture.is_some()
    }

    /// Whether a new picture is being painted.
    #[must_use]
    pub const fn is_being_painted(&self) -> bool {
        self.painting.is_some()
    }

    /// Paints the picture over the area of the canvas.
    pub fn paint(&self, painter: &Painter, paper: Rect) {
        if let Some(texture) = &self.texture {
            let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), paper, uv, Color32::WHITE.gamma_multiply(OPACITY));
        }
    }
}

/// Whether the lowest `count` layers of both documents grow the same pattern.
fn grows_alike(one: &Document, other: &Document, count: usize) -> bool {
    let lowest = |document: &Document| {
        let layers = document.layers.get(..count)?.to_vec();
        Some(essence(&Document { layers, ..document.clone() }))
    };
    lowest(one).is_some_and(|one| lowest(other) == Some(one))
}
