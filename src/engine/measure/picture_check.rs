//! Checks whether the marks measured in a picture form a texture of spots or stripes, unlike those in photographs of other things.
//!
//! Measured on 75 textures and 30 other pictures (photographs of coins, a clock, faces, a cat, grass; a chessboard, text, a
//! silhouette): the contrast along the edges varies by 0.12–0.45 in textures, most in those of several layers, and by
//! 0.55–1.0 in photographs. The other pictures have too few marks, no direction, all widths, or broken ground.

use super::Picture;
use super::spots::{Spot, census};
use crate::grid::Field;
use crate::grid::distance::{length, nearest};

/// The reason why a picture is not a texture of spots or stripes.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NotTexture {
    /// Too few whole spots.
    #[error("{marks} whole spots are too few for a texture, at least {SPOTS} are needed")]
    TooFewSpots {
        /// Whole spots.
        marks: usize,
    },
    /// Too few stripes side by side.
    #[error("{wavelengths:.1} stripes side by side are too few for a texture, at least {STRIPES} are needed")]
    TooFewStripes {
        /// Wavelengths along the shorter side.
        wavelengths: f64,
    },
    /// The contrast differs from place to place, as it does between objects in a photograph.
    #[error(
        "the contrast along the edges varies by {variation:.2} of its mean, in a texture by at most {CONTRAST}"
    )]
    Contrast {
        /// Coefficient of variation.
        variation: f64,
    },
    /// Bands of all widths.
    #[error("the bands vary in width by {variation:.2} of the mean, stripes by at most {WIDTHS}")]
    Widths {
        /// Coefficient of variation.
        variation: f64,
    },
    /// Bands without a direction, even locally.
    #[error("the bands have no direction: coherence {coherence:.2}, of stripes at least {COHERENCE}")]
    NoDirection {
        /// Mean coherence.
        coherence: f64,
    },
    /// The ground is as broken up as the marks: a chessboard.
    #[error("the ground is not connected: its largest part is {:.0} % of it; between spots it is at least {:.0} %", 100.0 * share, 100.0 * GROUND)]
    BrokenGround {
        /// Share of the ground that is its largest part.
        share: f64,
    },
}

/// Fewer whole spots are no texture.
const SPOTS: usize = 3;
/// Fewer stripes side by side are no texture.
const STRIPES: f64 = 3.0;
/// Largest coefficient of variation of the gradient along the edges. Along the edges of random waves it is 0.52
/// (√(4/π − 1), of Rayleigh's distribution).
const CONTRAST: f64 = 0.48;
/// Largest coefficient of variation of the widths of bands: 0.1–0.35 in textures of one layer, up to 0.75 of several,
/// 1–3 in most photographs.
const WIDTHS: f64 = 0.85;
/// Least mean coherence: 0.54 was measured for a web, less than 0.3 for text and for a chessboard.
const COHERENCE: f64 = 0.4;
/// A region that fills more than this share of the ellipse with its second moments counts as an ellipse; a rectangle fills 0.955.
const ELLIPSE: f64 = 0.97;
/// Least share of the ground between spots in its largest part: 0.97 and more in textures, 0.03 for a chessboard.
const GROUND: f64 = 0.4;

/// Checks that `found`, measured above `level` in `field`, belongs to a texture.
///
/// # Errors
/// The first [`NotTexture`] that applies.
pub fn check_picture(field: &Field, level: f32, found: &Picture) -> Result<(), NotTexture> {
    let variation = contrast_variation(field, level);
    if variation > CONTRAST {
        return Err(NotTexture::Contrast { variation });
    }
    match found {
        Picture::Spots { marks, .. } => {
            if *marks < SPOTS {
                return Err(NotTexture::TooFewSpots { marks: *marks });
            }
            let share = largest_ground(field, level);
            if share < GROUND {
                return Err(NotTexture::BrokenGround { share });
            }
        }
        Picture::Stripes { got, .. } => {
            if got.coherence < COHERENCE && !is_web(field, level) {
                return Err(NotTexture::NoDirection { coherence: got.coherence });
            }
            let [width, height] = field.extent();
            let wavelengths = width.min(height) / got.wavelength;
            if wavelengths < STRIPES {
                return Err(NotTexture::TooFewStripes { wavelengths });
            }
            let variation = width_variation(field, level);
            if variation > WIDTHS {
                return Err(NotTexture::Widths { variation });
            }
        }
    }
    Ok(())
}

/// Whether the marks surround ellipses: most of the ground is in ellipses.
fn is_web(field: &Field, level: f32) -> bool {
    let negative = Field { values: field.values.iter().map(|value| -value).collect(), ..field.clone() };
    let holes = census(&negative, -level).spots;
    let area = |counts: &dyn Fn(&&Spot) -> bool| -> f64 {
        holes.iter().filter(counts).map(|hole| hole.ellipse.area()).sum()
    };
    area(&|hole| hole.whole && hole.fill > ELLIPSE) > 0.5 * area(&|_| true)
}

/// Coefficient of variation of the gradient (Sobel's operator) in the cells beside the edges.
fn contrast_variation(field: &Field, level: f32) -> f64 {
    let [width, height] = [field.width as isize, field.height as isize];
    let (mut count, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for y in 0..height {
        for x in 0..width {
            let above = field.get(x, y) > level;
            let sides = [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)];
            if sides.iter().all(|(x, y)| (field.get(*x, *y) > level) == above) {
                continue;
            }
            let at = |dx: isize, dy: isize| f64::from(field.get(x + dx, y + dy));
            let across = at(1, -1) + 2.0 * at(1, 0) + at(1, 1) - at(-1, -1) - 2.0 * at(-1, 0) - at(-1, 1);
            let down = at(-1, 1) + 2.0 * at(0, 1) + at(1, 1) - at(-1, -1) - 2.0 * at(0, -1) - at(1, -1);
            let square = across * across + down * down;
            count += 1.0;
            sum += square.sqrt();
            squares += square;
        }
    }
    variation(count, sum, squares)
}

/// Standard deviation ÷ mean; 0 without values.
fn variation(weight: f64, sum: f64, squares: f64) -> f64 {
    if weight <= 0.0 || sum <= 0.0 {
        return 0.0;
    }
    let mean = sum / weight;
    (squares / weight - mean * mean).max(0.0).sqrt() / mean
}

/// Coefficient of variation of the half widths of the regions above the level. The half widths are the distances to the ground of
/// the cells that are farther from it than their neighbours; each is weighted by itself, in proportion to the area that it
/// represents.
fn width_variation(field: &Field, level: f32) -> f64 {
    let ground: Vec<bool> = field.values.iter().map(|value| *value <= level).collect();
    let grid = field.grid();
    let Some(offsets) = nearest(&ground, &grid) else { return 0.0 };
    let [width, height] = [field.width as isize, field.height as isize];
    let far = |x: isize, y: isize| {
        let [x, y] = [field.edges.index(x, field.width), field.edges.index(y, field.height)];
        length(offsets[y * field.width + x], &grid)
    };
    let (mut weight, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for y in 0..height {
        for x in 0..width {
            let own = far(x, y);
            let ridge = |k: isize| far(x + k % 3 - 1, y + k / 3 - 1) <= own;
            if own > 0.0 && (0..9).all(ridge) {
                weight += own;
                sum += own * own;
                squares += own * own * own;
            }
        }
    }
    variation(weight, sum, squares)
}

/// The share of the ground in its largest connected part; cells are neighbours if they share a side.
fn largest_ground(field: &Field, level: f32) -> f64 {
    let mut open: Vec<bool> = field.values.iter().map(|value| *value <= level).collect();
    let all = open.iter().filter(|open| **open).count();
    let [width, height] = [field.width, field.height];
    let (mut largest, mut next) = (0, Vec::new());
    for start in 0..open.len() {
        if !std::mem::replace(&mut open[start], false) {
            continue;
        }
        let mut count = 0;
        next.push(start);
        while let Some(at) = next.pop() {
            count += 1;
            let [x, y] = [(at % width) as isize, (at / width) as isize];
            for (x, y) in [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)] {
                let near = field.edges.index(y, height) * width + field.edges.index(x, width);
                if std::mem::replace(&mut open[near], false) {
                    next.push(near);
                }
            }
        }
        largest = largest.max(count);
    }
    if all == 0 { 0.0 } else { largest as f64 / all as f64 }
}

#[cfg(test)]
mod tests;
