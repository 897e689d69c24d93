//! A picture under the canvas, to draw over. It is not part of the document.

use std::path::Path;

use egui::{Color32, ColorImage, Context, Painter, Rect, TextureHandle, TextureOptions, pos2, vec2};

use crate::editor::task::{StartError, Task, Tasks, Worker};

/// The longest side that is kept, px: enough to draw over.
const LONGEST: u32 = 2048;

/// A picture under the canvas.
pub struct Reference {
    texture: Option<TextureHandle>,
    /// Its file's name.
    pub name: String,
    /// Its opacity, 0..1.
    pub opacity: f32,
    /// Whether it is shown.
    pub shown: bool,
    loading: Option<Task<Result<ColorImage, String>>>,
}

impl Default for Reference {
    fn default() -> Self {
        Self { texture: None, name: String::new(), opacity: 0.5, shown: true, loading: None }
    }
}

impl Reference {
    /// Whether there is one.
    #[must_use]
    pub fn is_there(&self) -> bool {
        self.texture.is_some()
    }

    /// Loads a picture beside the window; it replaces the one before.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn load(&mut self, path: &Path, tasks: &Tasks) -> Result<(), StartError> {
        let file = path.to_owned();
        let work = move |worker: &Worker<_>| worker.send(read(&file));
        self.loading = Some(tasks.start("loading a picture", work)?);
        self.name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(())
    }

    /// Receives the loaded picture; never waits.
    ///
    /// # Errors
    /// Why the picture could not be read.
    pub fn listen(&mut self, ctx: &Context) -> Result<(), String> {
        let Some(task) = &mut self.loading else { return Ok(()) };
        let loaded = task.poll();
        if loaded.is_none() && !task.has_ended() {
            return Ok(());
        }
        self.loading = None;
        let picture = loaded.unwrap_or_else(|| Err(format!("{}: reading it failed", self.name)))?;
        self.texture = Some(ctx.load_texture("reference", picture, TextureOptions::LINEAR));
        self.shown = true;
        Ok(())
    }

    /// Removes it.
    pub fn clear(&mut self) {
        (self.texture, self.loading) = (None, None);
    }

    /// Paints it at the centre of the canvas, as large as it fits.
    pub fn paint(&self, painter: &Painter, paper: Rect) {
        let Some(texture) = self.texture.as_ref().filter(|_| self.shown) else { return };
        let size = texture.size_vec2();
        let scale = (paper.width() / size.x).min(paper.height() / size.y);
        let rect = Rect::from_center_size(paper.center(), size * scale);
        let whole = Rect::from_min_size(pos2(0.0, 0.0), vec2(1.0, 1.0));
        painter.image(texture.id(), rect, whole, Color32::WHITE.gamma_multiply(self.opacity));
    }
}

fn read(path: &Path) -> Result<ColorImage, String> {
    let wrong =
        |error: &dyn std::fmt::Display| format!("{}: cannot be read as a picture: {error}", path.display());
    let reader = image::ImageReader::open(path).map_err(|error| wrong(&error))?;
    let picture = reader.with_guessed_format().map_err(|error| wrong(&error))?;
    let picture = picture.decode().map_err(|error| wrong(&error))?;
    let picture = picture.thumbnail(LONGEST.min(picture.width()), LONGEST.min(picture.height())).into_rgba8();
    let size = [picture.width() as usize, picture.height() as usize];
    Ok(ColorImage::from_rgba_unmultiplied(size, picture.as_raw()))
}
