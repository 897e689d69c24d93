//! What differs between the two grown documents of a pair.

use std::fmt;

use super::grown::Grown;
use super::quantity::Quantity;

/// The measured effect of a key.
pub struct Effect {
    /// Quantities with their values before and after.
    changes: Vec<(&'static Quantity, [Option<f64>; 2])>,
    /// The share of px that differ, per cent; `None` where the pictures differ in size.
    differ: Option<f64>,
}

/// A px differs if a colour of it does by more than this, of 255.
const SEEN: u8 = 16;
/// The least share of px that differ, per cent: pictures with less look equal.
const LEAST: f64 = 1.0;

impl Effect {
    /// Measures the quantities of these names on a layer of both.
    ///
    /// # Errors
    /// The pictures look equal, or something cannot be measured.
    pub fn new(names: &[String], layer: usize, pair: &[Grown; 2]) -> Result<Self, String> {
        let change = |name: &String| {
            let quantity = Quantity::named(name)?;
            let values = pair.each_ref().map(|grown| quantity.of(grown, layer));
            match values {
                [None, None] => Err(format!("there is no {name} to measure")),
                _ => Ok((quantity, values)),
            }
        };
        let changes = names.iter().map(change).collect::<Result<_, String>>()?;
        let differ = differ(pair);
        match differ {
            Some(share) if share < LEAST => Err(format!("only {share:.2} % of the px differ")),
            _ => Ok(Self { changes, differ }),
        }
    }
}

/// The share of px that differ, per cent.
fn differ([a, b]: &[Grown; 2]) -> Option<f64> {
    let pairs = a.rgb.chunks_exact(3).zip(b.rgb.chunks_exact(3));
    let differs = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > SEEN);
    (a.size == b.size).then(|| 100.0 * pairs.filter(differs).count() as f64 / (a.rgb.len() / 3) as f64)
}

impl fmt::Display for Effect {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (quantity, values) in &self.changes {
            let [before, after] = values.map(|value| value.map_or("–".to_owned(), digits));
            write!(f, "{} {before} → {after}{}; ", quantity.name, quantity.unit)?;
        }
        match self.differ {
            Some(share) => write!(f, "{share:.0} % of px differ"),
            None => write!(f, "the pictures differ in size"),
        }
    }
}

/// A number with three digits; whole numbers as they are.
fn digits(value: f64) -> String {
    match value.abs() {
        _ if value.fract() == 0.0 => value.to_string(),
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}
