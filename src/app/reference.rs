//! A picture under the canvas, to draw over. It is not part of the document.

use std::path::Path;
use std::sync::mpsc::{self, Receiver};
use std::thread;

use egui::{Color32, ColorImage, Context, Painter, Rect, TextureHandle, TextureOptions, pos2, vec2};

/// The longest side that is kept, px: enough to draw over.
const LONGEST: u32 = 2048;

/// A picture under the canvas.
pub struct Reference {
    texture: Option<TextureHandle>,
    /// Its file's name.
    pub name: String,
    /// How much of it is seen, 0..1.
    pub opacity: f32,
    /// Is it shown?
    pub shown: bool,
    coming: Option<Receiver<Result<ColorImage, String>>>,
}

impl Default for Reference {
    fn default() -> Self {
        Self { texture: None, name: String::new(), opacity: 0.5, shown: true, coming: None }
    }
}

impl Reference {
    /// Is there one?
    #[must_use]
    pub fn is_there(&self) -> bool {
        self.texture.is_some()
    }

    /// Loads a picture on a thread of its own.
    pub fn load(&mut self, path: &Path, ctx: &Context) {
        let (tell, coming) = mpsc::channel();
        self.name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        self.coming = Some(coming);
        let (path, ctx) = (path.to_owned(), ctx.clone());
        thread::spawn(move || {
            // The window may have gone.
            let _ = tell.send(read(&path));
            ctx.request_repaint();
        });
    }

    /// Takes in what was loaded.
    ///
    /// # Errors
    /// Why the picture could not be read.
    pub fn listen(&mut self, ctx: &Context) -> Result<(), String> {
        let Some(come) = self.coming.as_ref().and_then(|coming| coming.try_recv().ok()) else {
            return Ok(());
        };
        self.coming = None;
        self.texture = Some(ctx.load_texture("reference", come?, TextureOptions::LINEAR));
        self.shown = true;
        Ok(())
    }

    /// Takes it away.
    pub fn clear(&mut self) {
        (self.texture, self.coming) = (None, None);
    }

    /// Paints it into the middle of the canvas, as large as it fits.
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
