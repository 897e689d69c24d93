//! The coordinates of a colour in the models in which people pick colours.

use palette::convert::FromColorUnclamped;
use palette::{FromColor, Hsv, LinSrgb, Oklch, Srgb};

/// A model of colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ColourModel {
    /// Red, green, blue: 0..255 each.
    #[default]
    Rgb,
    /// Hue 0..360 degrees, saturation and value 0..100 %.
    Hsv,
    /// Lightness 0..100 %, chroma 0..0.4, hue 0..360 degrees, of OKLab: equal steps look equal.
    Oklch,
}

/// A coordinate: its letter, its name, its range, its unit.
pub struct Coordinate {
    /// A letter.
    pub letter: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The largest value; the smallest is 0.
    pub most: f64,
    /// The unit that is written behind it.
    pub unit: &'static str,
    /// Digits behind the decimal point.
    pub decimals: usize,
}

const fn coordinate(
    letter: &'static str,
    name: &'static str,
    most: f64,
    unit: &'static str,
    decimals: usize,
) -> Coordinate {
    Coordinate { letter, name, most, unit, decimals }
}

const RGB: [Coordinate; 3] = [
    coordinate("R", "Red", 255.0, "", 0),
    coordinate("G", "Green", 255.0, "", 0),
    coordinate("B", "Blue", 255.0, "", 0),
];
const HSV: [Coordinate; 3] = [
    coordinate("H", "Hue", 360.0, "°", 1),
    coordinate("S", "Saturation", 100.0, " %", 1),
    coordinate("V", "Value", 100.0, " %", 1),
];
const OKLCH: [Coordinate; 3] = [
    coordinate("L", "Lightness", 100.0, " %", 1),
    coordinate("C", "Chroma", 0.4, "", 3),
    coordinate("H", "Hue", 360.0, "°", 1),
];

impl ColourModel {
    /// All models and their names, in order.
    pub const ALL: [(Self, &'static str); 3] =
        [(Self::Rgb, "RGB"), (Self::Hsv, "HSV"), (Self::Oklch, "OKLCH")];

    /// Its three coordinates.
    #[must_use]
    pub fn coordinates(self) -> &'static [Coordinate; 3] {
        match self {
            Self::Rgb => &RGB,
            Self::Hsv => &HSV,
            Self::Oklch => &OKLCH,
        }
    }

    /// The coordinates of a colour (8-bit sRGB). Grays have the hue 0.
    ///
    /// ```
    /// use dapple_engine::colour::ColourModel;
    ///
    /// let [hue, chroma, lightness] = ColourModel::Hsv.of([255, 0, 0]);
    /// assert_eq!(ColourModel::Hsv.colour([hue, chroma, lightness]), [255, 0, 0]);
    /// ```
    #[must_use]
    pub fn of(self, colour: [u8; 3]) -> [f64; 3] {
        let srgb = Srgb::from(colour).into_format::<f64>();
        match self {
            Self::Rgb => colour.map(f64::from),
            Self::Hsv => {
                let hsv = Hsv::from_color(srgb);
                [hsv.hue.into_positive_degrees(), 100.0 * hsv.saturation, 100.0 * hsv.value]
            }
            Self::Oklch => {
                let lch = Oklch::from_color(srgb.into_linear());
                // A gray has no hue beyond rounding errors.
                let hue = if lch.chroma < 1e-5 { 0.0 } else { lch.hue.into_positive_degrees() };
                [100.0 * lch.l, lch.chroma, hue]
            }
        }
    }

    /// The colour (8-bit sRGB) with these coordinates. If sRGB has none of this chroma, the colour of equal lightness and hue with
    /// the highest chroma.
    #[must_use]
    pub fn colour(self, [a, b, c]: [f64; 3]) -> [u8; 3] {
        match self {
            Self::Rgb => [a, b, c].map(|channel| channel.round().clamp(0.0, 255.0) as u8),
            Self::Hsv => to_bytes(Srgb::from_color(Hsv::new(a, 0.01 * b, 0.01 * c))),
            Self::Oklch => {
                let at = |chroma: f64| {
                    Srgb::from_linear(LinSrgb::from_color_unclamped(Oklch::new(0.01 * a, chroma, c)))
                };
                to_bytes(at(most_chroma(b, |chroma| is_in_gamut(at(chroma)))))
            }
        }
    }
}

/// The largest chroma up to `wanted` for which `fits` is true.
fn most_chroma(wanted: f64, fits: impl Fn(f64) -> bool) -> f64 {
    if fits(wanted) {
        return wanted;
    }
    let (mut low, mut high) = (0.0, wanted);
    for _ in 0..24 {
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Whether all channels are within 0..1, up to half a step of 8 bits.
fn is_in_gamut(colour: Srgb<f64>) -> bool {
    const SLACK: f64 = 0.5 / 255.0;
    let (red, green, blue) = colour.into_components();
    [red, green, blue].iter().all(|channel| (-SLACK..=1.0 + SLACK).contains(channel))
}

fn to_bytes(colour: Srgb<f64>) -> [u8; 3] {
    let (red, green, blue) = colour.into_components();
    [red, green, blue].map(|channel| (255.0 * channel.clamp(0.0, 1.0)).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_unchanged_by_conversion_to_any_model_and_back() {
        for step in 0..4096_u32 {
            let colour = [step * 37, step * 101, step * 7].map(|channel| (channel % 256) as u8);
            for (model, name) in ColourModel::ALL {
                let there = model.of(colour);
                assert_eq!(model.colour(there), colour, "{name} {there:?}");
                for (value, coordinate) in there.iter().zip(model.coordinates()) {
                    assert!((0.0..=coordinate.most).contains(value), "{name} {colour:?} {there:?}");
                }
            }
        }
    }

    #[test]
    fn known_colours_have_known_coordinates() {
        let near = |found: [f64; 3], expected: [f64; 3]| {
            let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.06);
            assert!(is_near, "{found:?} {expected:?}");
        };
        near(ColourModel::Hsv.of([255, 128, 0]), [30.1, 100.0, 100.0]);
        near(ColourModel::Hsv.of([128, 128, 128]), [0.0, 0.0, 50.2]);
        // B. Ottosson's table of OKLab: red.
        near(ColourModel::Oklch.of([255, 0, 0]), [62.8, 0.258, 29.2]);
        near(ColourModel::Oklch.of([255, 255, 255]), [100.0, 0.0, 0.0]);
    }

    #[test]
    fn a_chroma_that_srgb_does_not_have_is_lowered_and_the_hue_kept() {
        let vivid = ColourModel::Oklch.colour([70.0, 0.4, 150.0]);
        let [lightness, chroma, hue] = ColourModel::Oklch.of(vivid);
        assert!((lightness - 70.0).abs() < 1.0 && (hue - 150.0).abs() < 2.0, "{vivid:?}");
        assert!((0.1..0.3).contains(&chroma), "{chroma}");
    }
}
