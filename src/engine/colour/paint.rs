//! Layers of patterns → one picture.

use std::ops::Range;

use rayon::prelude::*;

use super::{Ground, Table};
use crate::grid::Field;

/// One layer to paint.
#[derive(Clone, Copy, Debug)]
pub struct Painted<'a> {
    /// Its pattern, one value a px of the picture.
    pub pattern: &'a Field,
    /// Cells where the layer was free to grow, one flag for each px; `None` = everywhere.
    pub free: Option<&'a [bool]>,
    /// Its colours.
    pub table: &'a Table,
    /// The second colour of its ground, and its share, one value a px of the picture; `None` = it has one colour.
    pub ground: Option<(&'a Ground, &'a Field)>,
    /// Whether it is shown.
    pub visible: bool,
}

impl Painted<'_> {
    /// Its colour at a px.
    fn colour(&self, px: usize) -> [u8; 3] {
        let value = self.pattern.values[px];
        let colour = self.table.colour(value);
        match self.ground {
            Some((ground, shares)) => ground.tinted(colour, value, shares.values[px]),
            None => colour,
        }
    }
}

/// The layer that paints the px at `y * width + x`: the last visible one that was free to grow there.
/// `None` where no visible layer was free, as over the marks of a hidden one.
#[must_use]
pub fn painter(layers: &[Painted], px: usize) -> Option<usize> {
    layers.iter().rposition(|layer| layer.visible && layer.free.is_none_or(|free| free[px]))
}

/// `top` over `below` (T. Porter, T. Duff, 1984): red, green, blue, alpha, 0..1 each, not multiplied by alpha.
///
/// ```
/// use dapple_engine::colour::over;
///
/// let opaque = [0.2, 0.4, 0.6, 1.0];
/// assert_eq!(over(opaque, [1.0, 1.0, 1.0, 1.0]), opaque);
/// ```
#[must_use]
pub fn over(top: [f32; 4], below: [f32; 4]) -> [f32; 4] {
    let behind = (1.0 - top[3]) * below[3];
    let alpha = top[3] + behind;
    if alpha <= 0.0 {
        return top;
    }
    let mixed = |channel: usize| (top[3] * top[channel] + behind * below[channel]) / alpha;
    [mixed(0), mixed(1), mixed(2), alpha]
}

/// The whole picture: red, green, blue for each px (8-bit sRGB), row by row from the top.
///
/// Each px has the colour of its [`painter`]. A px without one has the ground colour of the last visible layer, or of the last
/// layer if none is visible, or white if there are no layers.
///
/// # Panics
/// If a pattern or a `free` holds fewer than `width * height` values.
#[must_use]
pub fn paint(layers: &[Painted], width: usize, height: usize) -> Vec<u8> {
    let mut rgb = vec![0; 3 * width * height];
    paint_rows(layers, width, 0..height, &mut rgb);
    rgb
}

/// Paints the given rows of the picture of [`paint()`], for pictures that are written band by band.
/// `rgb` holds `3 * width` bytes a row. Rows are painted in parallel.
///
/// # Panics
/// If a pattern or a `free` does not reach to the last of the rows.
pub fn paint_rows(layers: &[Painted], width: usize, rows: Range<usize>, rgb: &mut [u8]) {
    if width == 0 {
        return;
    }
    let ground = layers.iter().rfind(|layer| layer.visible).or(layers.last());
    let ground = ground.map_or([255; 3], |layer| layer.table.colour(0.0));
    rgb.par_chunks_mut(3 * width).zip(rows.into_par_iter()).for_each(|(row, y)| {
        for (x, out) in row.chunks_exact_mut(3).enumerate() {
            let px = y * width + x;
            let colour = match painter(layers, px) {
                Some(k) => layers[k].colour(px),
                None => ground,
            };
            out.copy_from_slice(&colour);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::super::{Gradient, Stop};
    use super::*;
    use crate::grid::Edges;

    const T: bool = true;
    const F: bool = false;

    fn table(ground: [u8; 3], mark: [u8; 3]) -> Table {
        let hard_step = [(0.0, ground), (0.5, ground), (0.5, mark)];
        let stops = hard_step.map(|(at, colour)| Stop::opaque(at, colour)).to_vec();
        Gradient { stops, bends: vec![] }.table()
    }

    /// A letter for each px: the ground of a layer is a small letter, its marks are capitals.
    fn letters(rgb: &[u8]) -> String {
        rgb.chunks(3).map(|px| char::from(px[0])).collect()
    }

    fn strip(values: &[f32]) -> Field {
        Field { values: values.to_vec(), ..Field::flat(values.len(), 1, Edges::Closed, 0.0) }
    }

    #[test]
    fn each_px_belongs_to_the_last_visible_layer_that_was_free_there() {
        let [a, b] = [table([b'a'; 3], [b'A'; 3]), table([b'b'; 3], [b'B'; 3])];
        let below = strip(&[0.9, 0.5, 0.4, 0.1, 0.0]);
        let above = strip(&[0.9, 0.9, 0.2, 0.7, 0.5]);
        let free = [F, F, T, T, T];
        let layers = |shown: [bool; 2]| {
            [
                Painted { pattern: &below, free: None, table: &a, ground: None, visible: shown[0] },
                Painted { pattern: &above, free: Some(&free), table: &b, ground: None, visible: shown[1] },
            ]
        };
        let seen = |shown| letters(&paint(&layers(shown), 5, 1));
        assert_eq!(seen([T, T]), "AAbBB");
        assert_eq!(seen([T, F]), "AAaaa");
        assert_eq!(seen([F, T]), "bbbBB", "hidden marks look like the ground around them");
        assert_eq!(seen([F, F]), "bbbbb");
        assert_eq!(paint(&[], 2, 1), [255; 6]);
    }

    #[test]
    fn bands_together_are_the_picture() {
        let colours = Gradient::default_for_layer(0).table();
        let pattern =
            Field::from_fn([31, 17], [1.0; 2], Edges::Wrap, |[x, y]| ((x * y) % 10.0 / 10.0) as f32);
        let layers =
            [Painted { pattern: &pattern, free: None, table: &colours, ground: None, visible: true }];
        let mut banded = vec![0; 31 * 17 * 3];
        for (band, rgb) in banded.chunks_mut(31 * 3 * 4).enumerate() {
            paint_rows(&layers, 31, 4 * band..(4 * band + 4).min(17), rgb);
        }
        assert_eq!(banded, paint(&layers, 31, 17));
        let expected: Vec<u8> = pattern.values.iter().flat_map(|&v| colours.colour(v)).collect();
        assert_eq!(banded, expected);
    }
}
