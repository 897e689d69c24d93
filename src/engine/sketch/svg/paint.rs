//! The colours of shapes.

use usvg::{Color, Paint};

/// Red, green, blue of a paint, sRGB: of a gradient the mean of its stops; `None` of a pattern.
pub(super) fn colour(paint: &Paint) -> Option<[u8; 3]> {
    let stops = match paint {
        Paint::Color(colour) => return Some(rgb(*colour)),
        Paint::LinearGradient(gradient) => gradient.stops(),
        Paint::RadialGradient(gradient) => gradient.stops(),
        Paint::Pattern(_) => return None,
    };
    let mean = |channel: usize| {
        let sum: f64 = stops.iter().map(|stop| f64::from(rgb(stop.color())[channel])).sum();
        (sum / stops.len().max(1) as f64).round() as u8
    };
    Some([mean(0), mean(1), mean(2)])
}

fn rgb(colour: Color) -> [u8; 3] {
    [colour.red, colour.green, colour.blue]
}

/// A colour of this opacity, 0 to 1, over a ground.
pub(super) fn over(colour: [u8; 3], opacity: f32, ground: [u8; 3]) -> [u8; 3] {
    let mixed = |k: usize| opacity * f32::from(colour[k]) + (1.0 - opacity) * f32::from(ground[k]);
    [0, 1, 2].map(|k| mixed(k).round() as u8)
}

/// The colour that occurs most often, of equally many the first.
pub fn commonest(colours: &[[u8; 3]]) -> Option<[u8; 3]> {
    let count = |colour: &[u8; 3]| colours.iter().filter(|other| *other == colour).count();
    let mut distinct: Vec<[u8; 3]> = Vec::new();
    colours.iter().for_each(|colour| {
        if !distinct.contains(colour) {
            distinct.push(*colour);
        }
    });
    distinct.into_iter().rev().max_by_key(count)
}
