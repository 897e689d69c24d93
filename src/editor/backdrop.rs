//! The picture under the canvas, to draw over. While a document is edited it belongs to it: its changes are steps that can
//! be undone. It is not saved.

use std::sync::Arc;

/// The longest side that is kept, px: enough for a picture to draw over.
pub const LONGEST: u32 = 2048;
/// The smallest side that it can be scaled to, px of the canvas, and the largest, as a multiple of the longer canvas side.
const SMALLEST: f64 = 8.0;
const LARGEST: f64 = 20.0;

/// The pixels of a picture.
pub struct Pixels {
    /// Its file's name.
    pub name: String,
    /// Width and height, px.
    pub size: [usize; 2],
    /// Red, green, blue, opacity of each px, row by row.
    pub rgba: Vec<u8>,
}

impl std::fmt::Debug for Pixels {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}, {} × {} px", self.name, self.size[0], self.size[1])
    }
}

/// Where a picture lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Its centre, px of the canvas.
    pub center: [f64; 2],
    /// Px of the canvas per px of the picture.
    pub scale: f64,
}

/// A picture, and where it lies.
#[derive(Clone, Debug)]
pub struct Backdrop {
    /// The picture.
    pub pixels: Arc<Pixels>,
    /// Where it was put; `None` = at the centre of the canvas, as large as it fits.
    placed: Option<Placement>,
}

impl PartialEq for Backdrop {
    /// Whether both are the picture that was loaded at one time, at one place.
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.pixels, &other.pixels) && self.placed == other.placed
    }
}

impl Backdrop {
    /// A picture at the centre of the canvas, as large as it fits.
    #[must_use]
    pub fn new(pixels: Pixels) -> Self {
        Self { pixels: Arc::new(pixels), placed: None }
    }

    /// Where it lies on a canvas of `size` px.
    #[must_use]
    pub fn placement(&self, size: [u32; 2]) -> Placement {
        self.placed.unwrap_or_else(|| {
            let size = size.map(f64::from);
            let fits = [0, 1].map(|axis| size[axis] / self.pixels.size[axis].max(1) as f64);
            Placement { center: size.map(|side| 0.5 * side), scale: fits[0].min(fits[1]) }
        })
    }

    /// The picture at another place on a canvas of `size` px (`None` = at its centre, as large as it fits). Its centre stays
    /// on the canvas.
    #[must_use]
    pub fn placed(&self, placement: Option<Placement>, size: [u32; 2]) -> Self {
        let longer = self.pixels.size[0].max(self.pixels.size[1]).max(1) as f64;
        let most = LARGEST * f64::from(size[0].max(size[1]));
        let limited = |placement: Placement| Placement {
            center: [0, 1].map(|axis| placement.center[axis].clamp(0.0, f64::from(size[axis]))),
            scale: placement.scale.clamp(SMALLEST / longer, most / longer),
        };
        Self { pixels: Arc::clone(&self.pixels), placed: placement.map(limited) }
    }

    /// The colour at a point of a canvas of `size` px; `None` where the picture is not, or is fully transparent.
    #[must_use]
    pub fn colour_at(&self, at: [f64; 2], size: [u32; 2]) -> Option<[u8; 3]> {
        let Placement { center, scale } = self.placement(size);
        let Pixels { size: own, rgba, .. } = &*self.pixels;
        let place = [0, 1].map(|axis| (at[axis] - center[axis]) / scale + 0.5 * own[axis] as f64);
        if (0..2).any(|axis| !(0.0..own[axis] as f64).contains(&place[axis])) {
            return None;
        }
        let [x, y] = place.map(|coordinate| coordinate as usize);
        let [red, green, blue, opacity] = rgba[4 * (y * own[0] + x)..].first_chunk().copied()?;
        (opacity > 0).then_some([red, green, blue])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 2] = [200, 100];

    /// A picture of 4 × 4 px whose left half is red and whose right half is blue.
    fn halves() -> Backdrop {
        let px = |px: usize| if px % 4 < 2 { [255, 0, 0, 255] } else { [0, 0, 255, 255] };
        Backdrop::new(Pixels { name: "a".to_owned(), size: [4; 2], rgba: (0..16).flat_map(px).collect() })
    }

    #[test]
    fn a_new_picture_fills_the_canvas_and_its_colours_are_where_it_is_shown() {
        let picture = halves();
        assert_eq!(picture.placement(SIZE), Placement { center: [100.0, 50.0], scale: 25.0 });
        assert_eq!(picture.colour_at([60.0, 50.0], SIZE), Some([255, 0, 0]));
        assert_eq!(picture.colour_at([140.0, 50.0], SIZE), Some([0, 0, 255]));
        assert_eq!(picture.colour_at([20.0, 50.0], SIZE), None);
    }

    #[test]
    fn a_picture_is_placed_within_limits_and_back_at_the_centre() {
        let far = Placement { center: [900.0, -5.0], scale: 1e9 };
        let moved = halves().placed(Some(far), SIZE);
        assert_eq!(moved.placement(SIZE), Placement { center: [200.0, 0.0], scale: 1000.0 });
        assert_eq!(moved.placed(None, SIZE).placement(SIZE), halves().placement(SIZE));
    }
}
