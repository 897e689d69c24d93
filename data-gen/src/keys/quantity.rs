//! The quantities that are measured on a grown document, by name.

use dapple_engine::attributes::Spread;
use dapple_engine::measure::{Picture, picture};
use serde_json::Value;

use super::grown::Grown;

/// Something that is measured.
pub struct Quantity {
    pub name: &'static str,
    /// Behind the number, with the space between.
    pub unit: &'static str,
    of: Of,
}

/// How it is measured.
enum Of {
    /// The attribute of this name that has grown: the mean over the regions, weighted by their marks; of threads that of the first direction.
    Attribute,
    /// The wavelength of stripes in the report, or measured on the pattern.
    Wavelength,
    /// The sum over the regions, at this place of their reports.
    Sum(&'static str),
    /// At this place of the report of the layer.
    Report(&'static str),
    /// The spread of the spots of the layer.
    Spread(fn(Spread) -> f64),
    /// On the picture.
    Picture(fn(&Grown) -> Option<f64>),
}

const fn new(name: &'static str, unit: &'static str, of: Of) -> Quantity {
    Quantity { name, unit, of }
}

static QUANTITIES: [Quantity; 24] = [
    new("marks", "", Of::Sum("/marks")),
    new("kept marks", "", Of::Sum("/kept/kept")),
    new("area", " px²", Of::Attribute),
    new("aspect", "", Of::Attribute),
    new("angle", "°", Of::Attribute),
    new("spacing", " px", Of::Attribute),
    new("width", " px", Of::Attribute),
    new("wavelength", " px", Of::Wavelength),
    new("raggedness", "", Of::Attribute),
    new("spread of area", "", Of::Spread(|spread| spread.area)),
    new("spread of angle", "°", Of::Spread(|spread| spread.angle)),
    new("spread of aspect", "", Of::Spread(|spread| spread.aspect)),
    new("spread of spacing", "", Of::Spread(|spread| spread.spacing)),
    new("gap", " px", Of::Report("/gap/got")),
    new("blotches", " px", Of::Report("/blotches/got")),
    new("points", "", Of::Report("/points/count")),
    new("correlation with the picture", "", Of::Report("/tone/correlation/0")),
    new("ink", " %", Of::Picture(ink)),
    new("ink at the left", " %", Of::Picture(|grown| ink_of_half(grown, 0))),
    new("ink at the right", " %", Of::Picture(|grown| ink_of_half(grown, 1))),
    new("luma", " %", Of::Picture(|grown| Some(100.0 * mean(&lumas(grown))))),
    new("contrast of neighbours", " %", Of::Picture(contrast)),
    new("direction", "°", Of::Picture(|grown| Some(tensor(grown).0))),
    new("coherence", "", Of::Picture(|grown| Some(tensor(grown).1))),
];

impl Quantity {
    /// The quantity of this name.
    pub fn named(name: &str) -> Result<&'static Self, String> {
        let known = || QUANTITIES.iter().map(|quantity| quantity.name).collect::<Vec<_>>().join(", ");
        let found = QUANTITIES.iter().find(|quantity| quantity.name == name);
        found.ok_or_else(|| format!("\"{name}\" is not measured; allowed: {}", known()))
    }

    /// Its value, of the layer with this index; `None` where there is nothing to measure.
    pub fn of(&self, grown: &Grown, layer: usize) -> Option<f64> {
        // Of hair, which does not grow, the lowest layer.
        let layers = grown.report["layers"].as_array()?;
        let report = layers.get(layer).or(layers.first())?;
        let measured = || picture(grown.patterns.get(layer)?, 0.5);
        match self.of {
            Of::Attribute => attribute(report, self.name),
            // Lines that were not drawn side by side have no wavelength in the report.
            Of::Wavelength => attribute(report, self.name).or_else(|| match measured()? {
                Picture::Stripes { got, .. } => Some(got.wavelength),
                Picture::Spots { .. } => None,
            }),
            Of::Sum(at) => sum(report, at),
            Of::Report(at) => report.pointer(at)?.as_f64(),
            Of::Spread(part) => match measured()? {
                Picture::Spots { spread, .. } => Some(part(spread)),
                Picture::Stripes { .. } => None,
            },
            Of::Picture(measure) => measure(grown),
        }
    }
}

/// The mean of an attribute that has grown.
fn attribute(report: &Value, name: &str) -> Option<f64> {
    let found: Vec<(f64, f64)> = regions(report)
        .filter_map(|region| Some((region["got"][name].as_f64()?, region["marks"].as_f64().unwrap_or(1.0))))
        .collect();
    if found.is_empty() {
        return report["threads"][0]["got"][name].as_f64();
    }
    let weight: f64 = found.iter().map(|(_, weight)| weight).sum();
    let mean = |part: fn(f64) -> f64| {
        found.iter().map(|(value, weight)| weight * part(*value)).sum::<f64>() / weight
    };
    if name == "angle" {
        return Some(axial(
            mean(|angle| libm::sin(2.0 * angle.to_radians())),
            mean(|angle| libm::cos(2.0 * angle.to_radians())),
        ));
    }
    Some(mean(|value| value))
}

fn sum(report: &Value, at: &str) -> Option<f64> {
    let found: Vec<f64> = regions(report).filter_map(|region| region.pointer(at)?.as_f64()).collect();
    (!found.is_empty()).then(|| found.iter().sum())
}

fn regions(report: &Value) -> impl Iterator<Item = &Value> {
    report["regions"].as_array().into_iter().flatten()
}

/// Degrees from 0 to 180 of the sine and cosine of the double angle.
fn axial(sin: f64, cos: f64) -> f64 {
    (0.5 * libm::atan2(sin, cos).to_degrees()).rem_euclid(180.0)
}

/// The share of px that marks cover, per cent.
fn ink(grown: &Grown) -> Option<f64> {
    share(grown.labels.iter())
}

/// That share of the left (0) or the right (1) half.
fn ink_of_half(grown: &Grown, half: usize) -> Option<f64> {
    let width = grown.size[0];
    let within = |px: &usize| px % width * 2 / width == half;
    share(grown.labels.iter().enumerate().filter(|(px, _)| within(px)).map(|(_, label)| label))
}

fn share<'a>(labels: impl Iterator<Item = &'a u8>) -> Option<f64> {
    let (mut covered, mut all) = (0, 0);
    for label in labels {
        covered += u32::from(*label > 0);
        all += 1;
    }
    (all > 0).then(|| 100.0 * f64::from(covered) / f64::from(all))
}

/// The luma of each px, 0 to 1 (ITU-R BT.709).
fn lumas(grown: &Grown) -> Vec<f64> {
    let luma = |px: &[u8]| {
        let [red, green, blue] = [px[0], px[1], px[2]].map(f64::from);
        (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 255.0
    };
    grown.rgb.chunks_exact(3).map(luma).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The differences of luma to the px at the right and to the px below.
fn slopes(grown: &Grown) -> Vec<[f64; 2]> {
    let ([width, height], lumas) = (grown.size, lumas(grown));
    let at = |x: usize, y: usize| lumas[y * width + x];
    let slope = |x: usize, y: usize| [at(x + 1, y) - at(x, y), at(x, y + 1) - at(x, y)];
    (0..height - 1).flat_map(|y| (0..width - 1).map(move |x| (x, y))).map(|(x, y)| slope(x, y)).collect()
}

/// The slopes of luma at the corners between four px. Differences to the px at the right and to the px below have a px in common: noise
/// would have a direction.
fn corner_slopes(grown: &Grown) -> Vec<[f64; 2]> {
    let ([width, height], lumas) = (grown.size, lumas(grown));
    let slope = |[x, y]: [usize; 2]| {
        let at = y * width + x;
        let [a, b, c, d] = [at, at + 1, at + width, at + width + 1].map(|px| lumas[px]);
        [0.5 * (b + d - a - c), 0.5 * (c + d - a - b)]
    };
    (0..height - 1).flat_map(|y| (0..width - 1).map(move |x| [x, y])).map(slope).collect()
}

/// The root mean square difference of luma of neighbouring px, per cent.
fn contrast(grown: &Grown) -> Option<f64> {
    let squares: Vec<f64> = slopes(grown).iter().map(|[x, y]| 0.5 * (x * x + y * y)).collect();
    Some(100.0 * libm::sqrt(mean(&squares)))
}

/// Of the structure tensor of the whole picture: the direction along which luma changes least, degrees, and the coherence, from 0 (all
/// directions) to 1 (one direction).
fn tensor(grown: &Grown) -> (f64, f64) {
    let slopes = corner_slopes(grown);
    let sum = |part: fn(&[f64; 2]) -> f64| slopes.iter().map(part).sum::<f64>();
    let (sin, cos) = (sum(|[x, y]| 2.0 * x * y), sum(|[x, y]| x * x - y * y));
    (axial(-sin, -cos), libm::hypot(sin, cos) / sum(|[x, y]| x * x + y * y))
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// A picture of 64 × 64 px of this gray, 0 to 1, at each px.
    fn picture(gray: impl Fn(usize, usize) -> f64) -> Grown {
        let px = |index: usize| [(255.0 * gray(index % 64, index / 64)).round() as u8; 3];
        let rgb = (0..64 * 64).flat_map(px).collect();
        Grown { size: [64; 2], rgb, report: Value::Null, patterns: Vec::new(), labels: Vec::new() }
    }

    #[test]
    fn stripes_have_their_direction_and_noise_has_none() {
        for angle in [0.0, 30.0, 45.0, 100.0, 135.0] {
            let (s, c) = libm::sincos(f64::to_radians(angle));
            let stripes = |x: usize, y: usize| 0.5 + 0.4 * libm::sin(0.7 * (y as f64 * c - x as f64 * s));
            let (direction, coherence) = tensor(&picture(stripes));
            let off = (direction - angle + 90.0).rem_euclid(180.0) - 90.0;
            assert!(off.abs() < 1.0, "{direction}, drawn {angle}");
            assert!(coherence > 0.95, "{coherence}");
        }
        let mut dice = Pcg64Mcg::seed_from_u64(1);
        let noise: Vec<f64> = (0..64 * 64).map(|_| dice.random()).collect();
        let (_, coherence) = tensor(&picture(|x, y| noise[x + 64 * y]));
        assert!(coherence < 0.1, "{coherence}");
    }
}
