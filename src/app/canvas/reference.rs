//! A picture under the canvas, to draw over. It is not part of the document.

use std::path::Path;
use std::sync::Arc;

use egui::{Color32, ColorImage, Context, Painter, Rect, TextureHandle, TextureOptions, pos2, vec2};

use super::view::View;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::machine::fs::File;
use crate::photo;

/// The longest side that is kept, px: enough for a picture to draw over.
const LONGEST: u32 = 2048;
/// The smallest side that it can be scaled to, px of the canvas, and the largest, as a multiple of the longer canvas side.
const SMALLEST: f64 = 8.0;
const LARGEST: f64 = 20.0;

/// Where a picture lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Its centre, px of the canvas.
    pub center: [f64; 2],
    /// Px of the canvas per px of the picture.
    pub scale: f64,
}

/// A corner of the picture that is dragged, or all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it: it is moved.
    Whole,
    /// A corner: it is scaled about the opposite one. Whether it is the right one, and the lower one.
    Corner([bool; 2]),
}

/// A picture under the canvas.
pub struct Reference {
    picture: Option<(Arc<ColorImage>, TextureHandle)>,
    /// Its file's name.
    pub name: String,
    /// Its opacity, 0..1.
    pub opacity: f32,
    /// Whether it is shown.
    pub shown: bool,
    /// Whether it is locked, so that the pointer cannot move it.
    pub locked: bool,
    /// Where it lies; `None` = at the centre of the canvas, as large as it fits.
    placement: Option<Placement>,
    loading: Option<Task<Result<ColorImage, String>>>,
}

impl Default for Reference {
    fn default() -> Self {
        Self {
            picture: None,
            name: String::new(),
            opacity: 0.5,
            shown: true,
            locked: true,
            placement: None,
            loading: None,
        }
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

    /// Loads a picture on another thread; it replaces the present one.
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

    /// Takes a picture that was pasted. It is reduced on another thread.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn take_picture(
        &mut self,
        picture: Arc<ColorImage>,
        name: &str,
        tasks: &Tasks,
    ) -> Result<(), StartError> {
        let work = move |worker: &Worker<_>| worker.send(pasted(&picture));
        self.loading = Some(tasks.start("loading a picture", work)?);
        name.clone_into(&mut self.name);
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
        let picture = Arc::new(picture);
        let texture = ctx.load_texture("reference", Arc::clone(&picture), TextureOptions::LINEAR);
        self.picture = Some((picture, texture));
        (self.shown, self.locked, self.placement) = (true, true, None);
        Ok(())
    }

    /// Removes the reference picture.
    pub fn clear(&mut self) {
        (self.picture, self.loading) = (None, None);
    }

    /// Where it lies on a canvas of `size` px; `None` where there is none.
    #[must_use]
    pub fn placement(&self, size: [u32; 2]) -> Option<Placement> {
        let (picture, _) = self.picture.as_ref()?;
        Some(self.placement.unwrap_or_else(|| {
            let size = size.map(f64::from);
            let fits = [0, 1].map(|axis| size[axis] / picture.size[axis].max(1) as f64);
            Placement { center: size.map(|side| 0.5 * side), scale: fits[0].min(fits[1]) }
        }))
    }

    /// Moves the picture on a canvas of `size` px; its centre stays on the canvas.
    pub fn place(&mut self, placement: Placement, size: [u32; 2]) {
        let Some((picture, _)) = &self.picture else { return };
        let longer = picture.size[0].max(picture.size[1]).max(1) as f64;
        let most = LARGEST * f64::from(size[0].max(size[1]));
        let scale = placement.scale.clamp(SMALLEST / longer, most / longer);
        let center = [0, 1].map(|axis| placement.center[axis].clamp(0.0, f64::from(size[axis])));
        self.placement = Some(Placement { center, scale });
    }

    /// Moves the picture to the centre of the canvas, as large as it fits.
    pub fn fit(&mut self) {
        self.placement = None;
    }

    /// The placement `before`, changed by dragging `part` from `from` to `to`, px of the canvas.
    #[must_use]
    pub fn dragged(&self, before: Placement, part: Part, [from, to]: [[f64; 2]; 2]) -> Placement {
        match part {
            Part::Whole => {
                let center = [0, 1].map(|axis| before.center[axis] + to[axis] - from[axis]);
                Placement { center, ..before }
            }
            Part::Corner(sides) => {
                let Some((picture, _)) = &self.picture else { return before };
                let half = picture.size.map(|side| 0.5 * side as f64 * before.scale);
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

    /// The place of the picture on the screen, where the canvas is shown by `view` in `room`; `None` where the picture
    /// is not shown.
    #[must_use]
    pub fn rect(&self, view: View, room: Rect, size: [u32; 2]) -> Option<Rect> {
        let (picture, _) = self.picture.as_ref().filter(|_| self.shown)?;
        let Placement { center, scale } = self.placement(size)?;
        let half = picture.size.map(|side| 0.5 * side as f64 * scale);
        let corner = |sign: f64| view.to_screen(room, [0, 1].map(|axis| center[axis] + sign * half[axis]));
        Some(Rect::from_min_max(corner(-1.0), corner(1.0)))
    }

    /// The colour of the picture at a point of the canvas, px; `None` where the picture is not shown or is fully
    /// transparent.
    #[must_use]
    pub fn colour_at(&self, at: [f64; 2], size: [u32; 2]) -> Option<[u8; 3]> {
        let (picture, _) = self.picture.as_ref().filter(|_| self.shown)?;
        let Placement { center, scale } = self.placement(size)?;
        let place = [0, 1].map(|axis| (at[axis] - center[axis]) / scale + 0.5 * picture.size[axis] as f64);
        if (0..2).any(|axis| !(0.0..picture.size[axis] as f64).contains(&place[axis])) {
            return None;
        }
        let [x, y] = place.map(|coordinate| coordinate as usize);
        let [red, green, blue, opacity] = picture.pixels[y * picture.size[0] + x].to_srgba_unmultiplied();
        (opacity > 0).then_some([red, green, blue])
    }

    /// Paints it.
    pub fn paint(&self, painter: &Painter, view: View, room: Rect, size: [u32; 2]) {
        let (Some((_, texture)), Some(rect)) = (&self.picture, self.rect(view, room, size)) else { return };
        let whole = Rect::from_min_size(pos2(0.0, 0.0), vec2(1.0, 1.0));
        painter.image(texture.id(), rect, whole, Color32::WHITE.gamma_multiply(self.opacity));
    }
}

fn read(path: &Path) -> Result<ColorImage, String> {
    let wrong =
        |error: &dyn std::fmt::Display| format!("{}: cannot be read as a picture: {error}", path.display());
    let mut file = File::open(path).map(std::io::BufReader::new).map_err(|error| wrong(&error))?;
    // Turned as its EXIF data say, like a photograph that becomes a sketch.
    let picture = photo::decode(&mut file).map_err(|error| wrong(&error))?.image;
    let picture = picture.thumbnail(LONGEST.min(picture.width()), LONGEST.min(picture.height())).into_rgba8();
    let size = [picture.width() as usize, picture.height() as usize];
    Ok(ColorImage::from_rgba_unmultiplied(size, picture.as_raw()))
}

/// A pasted picture, reduced where it is larger than the largest picture that is kept.
fn pasted(picture: &ColorImage) -> Result<ColorImage, String> {
    let longest = picture.size[0].max(picture.size[1]);
    if longest == 0 {
        return Err("The pasted picture is empty.".to_owned());
    }
    if longest <= LONGEST as usize {
        return Ok(picture.clone());
    }
    let bytes = picture.pixels.iter().flat_map(Color32::to_array).collect();
    let [width, height] = picture.size.map(|side| side as u32);
    let whole = image::RgbaImage::from_raw(width, height, bytes)
        .ok_or_else(|| "The pasted picture is damaged.".to_owned())?;
    let size = picture.size.map(|side| (side * LONGEST as usize / longest).max(1));
    let small = image::imageops::thumbnail(&whole, size[0] as u32, size[1] as u32);
    Ok(ColorImage::from_rgba_premultiplied(size, small.as_raw()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 2] = [200, 100];

    /// A picture of 4 × 4 px whose left half is red and whose right half is blue.
    fn halves() -> Reference {
        let ctx = Context::default();
        let pixel = |px: usize| if px % 4 < 2 { Color32::RED } else { Color32::BLUE };
        let picture = Arc::new(ColorImage::new([4, 4], (0..16).map(pixel).collect()));
        let texture = ctx.load_texture("test", Arc::clone(&picture), TextureOptions::LINEAR);
        Reference { picture: Some((picture, texture)), ..Reference::default() }
    }

    #[test]
    fn a_new_picture_fills_the_canvas_and_its_colours_are_where_it_is_shown() {
        let picture = halves();
        let placement = picture.placement(SIZE).unwrap();
        assert_eq!(placement, Placement { center: [100.0, 50.0], scale: 25.0 });
        assert_eq!(picture.colour_at([60.0, 50.0], SIZE), Some([255, 0, 0]));
        assert_eq!(picture.colour_at([140.0, 50.0], SIZE), Some([0, 0, 255]));
        assert_eq!(picture.colour_at([20.0, 50.0], SIZE), None);
        assert_eq!(Reference { shown: false, ..picture }.colour_at([60.0, 50.0], SIZE), None);
    }

    #[test]
    fn a_dragged_corner_scales_about_the_opposite_one() {
        let mut picture = halves();
        let before = picture.placement(SIZE).unwrap();
        // The lower right corner is at (150, 100), the upper left one at (50, 0).
        let after = picture.dragged(before, Part::Corner([true; 2]), [[150.0, 100.0], [100.0, 50.0]]);
        assert!((after.scale - 12.5).abs() < 1e-9 && after.center == [75.0, 25.0], "{after:?}");
        let moved = picture.dragged(after, Part::Whole, [[0.0, 0.0], [5.0, -4.0]]);
        assert_eq!((moved.center, moved.scale), ([80.0, 21.0], after.scale));
        picture.place(Placement { center: [900.0, -5.0], scale: 1e9 }, SIZE);
        let limited = picture.placement(SIZE).unwrap();
        assert_eq!((limited.center, limited.scale), ([200.0, 0.0], 1000.0));
    }

    #[test]
    fn a_pasted_picture_is_kept_or_reduced() {
        let small = ColorImage::filled([3, 2], Color32::GREEN);
        assert_eq!(pasted(&small).unwrap(), small);
        let large = ColorImage::filled([4096, 16], Color32::GREEN);
        let reduced = pasted(&large).unwrap();
        assert_eq!((reduced.size, reduced.pixels[0]), ([2048, 8], Color32::GREEN));
        assert!(pasted(&ColorImage::filled([0, 0], Color32::GREEN)).is_err());
    }
}
