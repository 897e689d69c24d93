//! The picture under the canvas, on the screen: it is loaded on another thread, and belongs to the open document as
//! [`crate::editor::backdrop`] describes.

use std::path::Path;
use std::sync::Arc;

use egui::{Color32, ColorImage, Context, Painter, Rect, TextureHandle, TextureOptions, pos2, vec2};

use super::view::View;
use crate::editor::backdrop::{Backdrop, LONGEST, Pixels, Placement};
use crate::editor::session::Session;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::machine::fs::File;
use crate::photo;

/// A corner of the picture that is dragged, or all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it: it is moved.
    Whole,
    /// A corner: it is scaled about the opposite one. Whether it is the right one, and the lower one.
    Corner([bool; 2]),
}

/// A picture that is being read.
struct Loading {
    task: Task<Result<Pixels, String>>,
    /// Its file's name.
    name: String,
    /// Whether it is a part of the document that was just opened, and no step that can be undone.
    is_opened: bool,
}

/// The picture under the canvas, as it is shown.
pub struct Reference {
    picture: Option<(Backdrop, TextureHandle)>,
    /// Its opacity, 0..1.
    pub opacity: f32,
    /// Whether it is shown.
    pub shown: bool,
    /// Whether it is locked, so that the pointer cannot move it.
    pub locked: bool,
    loading: Option<Loading>,
}

impl Default for Reference {
    fn default() -> Self {
        Self { picture: None, opacity: 0.5, shown: true, locked: true, loading: None }
    }
}

impl Reference {
    /// Whether there is one.
    #[must_use]
    pub fn is_there(&self) -> bool {
        self.picture.is_some()
    }

    /// Whether one is being read.
    #[must_use]
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// Its file's name; empty where there is none.
    #[must_use]
    pub fn name(&self) -> &str {
        self.picture.as_ref().map_or("", |(backdrop, _)| &backdrop.pixels.name)
    }

    /// Loads a picture on another thread; it replaces the present one.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn load(&mut self, path: &Path, tasks: &Tasks) -> Result<(), StartError> {
        let file = path.to_owned();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let work = {
            let name = name.clone();
            move |worker: &Worker<_>| worker.send(read(&file, name))
        };
        let task = tasks.start("loading a picture", work)?;
        self.loading = Some(Loading { task, name, is_opened: false });
        Ok(())
    }

    /// Takes a picture that was pasted, or one with which a document was opened (`is_opened`). It is reduced on another thread.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn take_picture(
        &mut self,
        picture: Arc<ColorImage>,
        name: &str,
        is_opened: bool,
        tasks: &Tasks,
    ) -> Result<(), StartError> {
        let own = name.to_owned();
        let work = move |worker: &Worker<_>| worker.send(pasted(&picture, own));
        let task = tasks.start("loading a picture", work)?;
        self.loading = Some(Loading { task, name: name.to_owned(), is_opened });
        Ok(())
    }

    /// Forgets a picture that is being read, because another document was opened.
    pub fn document_opened(&mut self) {
        self.loading = None;
    }

    /// Gives a loaded picture to the document, and shows the picture of the document; never waits.
    ///
    /// # Errors
    /// Why the picture could not be read.
    pub fn follow(&mut self, ctx: &Context, session: &mut Session) -> Result<(), String> {
        let listened = self.listen(session);
        self.show(ctx, session);
        listened
    }

    fn listen(&mut self, session: &mut Session) -> Result<(), String> {
        let Some(Loading { task, .. }) = &mut self.loading else { return Ok(()) };
        let loaded = task.poll();
        if loaded.is_none() && !task.has_ended() {
            return Ok(());
        }
        let Some(Loading { name, is_opened, .. }) = self.loading.take() else { return Ok(()) };
        let pixels = loaded.unwrap_or_else(|| Err(format!("{name}: reading it failed")))?;
        let backdrop = Some(Backdrop::new(pixels));
        if is_opened {
            session.open_backdrop(backdrop);
        } else {
            session.set_backdrop(backdrop);
        }
        (self.shown, self.locked) = (true, true);
        Ok(())
    }

    /// Shows the picture of the document, which an undo may have changed.
    fn show(&mut self, ctx: &Context, session: &Session) {
        match (session.backdrop(), &mut self.picture) {
            (None, picture) => *picture = None,
            (Some(backdrop), Some((shown, _))) if Arc::ptr_eq(&backdrop.pixels, &shown.pixels) => {
                shown.clone_from(backdrop);
            }
            (Some(backdrop), picture) => {
                let Pixels { size, rgba, .. } = &*backdrop.pixels;
                let image = ColorImage::from_rgba_unmultiplied(*size, rgba);
                let texture = ctx.load_texture("reference", image, TextureOptions::LINEAR);
                *picture = Some((backdrop.clone(), texture));
            }
        }
    }

    /// Where it lies on a canvas of `size` px; `None` where there is none.
    #[must_use]
    pub fn placement(&self, size: [u32; 2]) -> Option<Placement> {
        self.picture.as_ref().map(|(backdrop, _)| backdrop.placement(size))
    }

    /// Moves the picture of the document; `None` = to the centre of the canvas, as large as it fits.
    pub fn place(&mut self, session: &mut Session, placement: Option<Placement>) {
        let Some((backdrop, _)) = &mut self.picture else { return };
        *backdrop = backdrop.placed(placement, session.document().size);
        session.set_backdrop(Some(backdrop.clone()));
    }

    /// The placement `before`, changed by dragging `part` from `from` to `to`, px of the canvas.
    #[must_use]
    pub fn dragged(&self, before: Placement, part: Part, [from, to]: [[f64; 2]; 2]) -> Placement {
        let size = self.picture.as_ref().map_or([0; 2], |(backdrop, _)| backdrop.pixels.size);
        dragged(size, before, part, [from, to])
    }

    /// The place of the picture on the screen, where the canvas is shown by `view` in `room`; `None` where the picture
    /// is not shown.
    #[must_use]
    pub fn rect(&self, view: View, room: Rect, size: [u32; 2]) -> Option<Rect> {
        let (backdrop, _) = self.picture.as_ref().filter(|_| self.shown)?;
        let Placement { center, scale } = backdrop.placement(size);
        let half = backdrop.pixels.size.map(|side| 0.5 * side as f64 * scale);
        let corner = |sign: f64| view.to_screen(room, [0, 1].map(|axis| center[axis] + sign * half[axis]));
        Some(Rect::from_min_max(corner(-1.0), corner(1.0)))
    }

    /// The colour of the picture at a point of the canvas, px; `None` where the picture is not shown or is fully
    /// transparent.
    #[must_use]
    pub fn colour_at(&self, at: [f64; 2], size: [u32; 2]) -> Option<[u8; 3]> {
        let (backdrop, _) = self.picture.as_ref().filter(|_| self.shown)?;
        backdrop.colour_at(at, size)
    }

    /// Paints it.
    pub fn paint(&self, painter: &Painter, view: View, room: Rect, size: [u32; 2]) {
        let (Some((_, texture)), Some(rect)) = (&self.picture, self.rect(view, room, size)) else { return };
        let whole = Rect::from_min_size(pos2(0.0, 0.0), vec2(1.0, 1.0));
        painter.image(texture.id(), rect, whole, Color32::WHITE.gamma_multiply(self.opacity));
    }
}

/// The placement `before` of a picture of `size` px, changed by dragging `part` from `from` to `to`, px of the canvas.
fn dragged(size: [usize; 2], before: Placement, part: Part, [from, to]: [[f64; 2]; 2]) -> Placement {
    match part {
        Part::Whole => {
            let center = [0, 1].map(|axis| before.center[axis] + to[axis] - from[axis]);
            Placement { center, ..before }
        }
        Part::Corner(sides) => {
            let half = size.map(|side| 0.5 * side as f64 * before.scale);
            let sign = sides.map(|is_far| if is_far { 1.0 } else { -1.0 });
            let fixed = [0, 1].map(|axis| before.center[axis] - sign[axis] * half[axis]);
            let along = |point: [f64; 2]| {
                (0..2).map(|axis| sign[axis] * half[axis] * (point[axis] - fixed[axis])).sum::<f64>()
            };
            let factor = (along(to) / along(from).max(1e-9)).max(1e-3);
            let center = [0, 1].map(|axis| fixed[axis] + factor * sign[axis] * half[axis]);
            Placement { center, scale: factor * before.scale }
        }
    }
}

fn read(path: &Path, name: String) -> Result<Pixels, String> {
    let wrong =
        |error: &dyn std::fmt::Display| format!("{}: cannot be read as a picture: {error}", path.display());
    let mut file = File::open(path).map(std::io::BufReader::new).map_err(|error| wrong(&error))?;
    // Turned as its EXIF data say, like a photograph that becomes a sketch.
    let picture = photo::decode(&mut file).map_err(|error| wrong(&error))?.image;
    let picture = picture.thumbnail(LONGEST.min(picture.width()), LONGEST.min(picture.height())).into_rgba8();
    let size = [picture.width() as usize, picture.height() as usize];
    Ok(Pixels { name, size, rgba: picture.into_raw() })
}

/// A pasted picture, reduced where it is larger than the largest picture that is kept.
fn pasted(picture: &ColorImage, name: String) -> Result<Pixels, String> {
    let longest = picture.size[0].max(picture.size[1]);
    if longest == 0 {
        return Err("The pasted picture is empty.".to_owned());
    }
    let rgba = picture.pixels.iter().flat_map(Color32::to_srgba_unmultiplied).collect();
    if longest <= LONGEST as usize {
        return Ok(Pixels { name, size: picture.size, rgba });
    }
    let [width, height] = picture.size.map(|side| side as u32);
    let whole = image::RgbaImage::from_raw(width, height, rgba)
        .ok_or_else(|| "The pasted picture is damaged.".to_owned())?;
    let size = picture.size.map(|side| (side * LONGEST as usize / longest).max(1));
    let small = image::imageops::thumbnail(&whole, size[0] as u32, size[1] as u32);
    Ok(Pixels { name, size, rgba: small.into_raw() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dragged_corner_scales_about_the_opposite_one() {
        // On a canvas of 200 × 100 px, the lower right corner is at (150, 100), the upper left one at (50, 0).
        let before = Placement { center: [100.0, 50.0], scale: 25.0 };
        let after = dragged([4; 2], before, Part::Corner([true; 2]), [[150.0, 100.0], [100.0, 50.0]]);
        assert!((after.scale - 12.5).abs() < 1e-9 && after.center == [75.0, 25.0], "{after:?}");
        let moved = dragged([4; 2], after, Part::Whole, [[0.0, 0.0], [5.0, -4.0]]);
        assert_eq!((moved.center, moved.scale), ([80.0, 21.0], after.scale));
    }

    #[test]
    fn a_pasted_picture_is_kept_or_reduced() {
        let pasted = |size: [usize; 2]| pasted(&ColorImage::filled(size, Color32::GREEN), "a".to_owned());
        let small = pasted([3, 2]).unwrap();
        assert_eq!((small.size, small.rgba.len(), &small.rgba[..4]), ([3, 2], 24, &[0, 255, 0, 255][..]));
        let reduced = pasted([4096, 16]).unwrap();
        assert_eq!((reduced.size, &reduced.rgba[..4]), ([2048, 8], &[0, 255, 0, 255][..]));
        assert!(pasted([0, 0]).is_err());
    }
}
