//! Notes about answers, in words and numbers.

use std::fmt;

use super::in_cells::{InCells, Lengths};
use crate::attributes::{Attribute, Unit};

/// An attribute with its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// The attribute.
    pub attribute: Attribute,
    /// Its number.
    pub value: f64,
}

impl Quantity {
    pub(super) fn new(attribute: Attribute, value: f64) -> Self {
        Self { attribute, value }
    }

    /// The number with its unit; `units` are those of lengths and areas.
    fn number(&self, units: Units) -> String {
        let unit = match self.attribute.unit() {
            Unit::Share => "",
            Unit::Angle => "°",
            Unit::Length => units[0],
            Unit::Area => units[1],
        };
        format!("{}{unit}", brief(self.value))
    }
}

/// The units of lengths and of areas, with a blank before them.
type Units = [&'static str; 2];
const PX: Units = [" px", " px²"];
const CELLS: Units = [" cells", " cells"];

impl Lengths for Quantity {
    fn scaled(self, factor: f64) -> Self {
        Self { value: self.value * self.attribute.unit().scale(factor), ..self }
    }
}

/// A note about an answer; `Display` is the sentence. Its lengths are px.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// An attribute is outside the range that the system grows.
    Beyond {
        /// The attribute that was asked for.
        asked: Quantity,
        /// The attribute that is grown instead.
        reached: Quantity,
        /// The kind of excess, with the limit, such as "too small: the smallest possible is".
        called: &'static str,
    },
    /// Each attribute can be reached, but not all together.
    Together {
        /// The attributes that were asked for.
        asked: Vec<Quantity>,
        /// The attributes that are grown instead.
        reached: Vec<Quantity>,
    },
    /// The spacing was left free: area ÷ spacing² that is used.
    FreeSpacing(f64),
    /// Spots are placed farther apart than the natural spacing of their system.
    Apart {
        /// Area ÷ spacing² that was asked for, and will be grown.
        asked: Quantity,
        /// The lowest natural density of the system.
        sparsest: Quantity,
        /// Spacing ÷ the natural spacing.
        pitch: f64,
    },
}

impl Note {
    /// Whether an attribute cannot be reached.
    #[must_use]
    pub fn is_beyond(&self) -> bool {
        matches!(self, Self::Beyond { .. } | Self::Together { .. })
    }

    /// The sentence; `units` are those of lengths and areas.
    fn write(&self, f: &mut fmt::Formatter<'_>, units: Units) -> fmt::Result {
        let named = |quantity: &Quantity| format!("{} {}", quantity.attribute, quantity.number(units));
        let listed = |list: &[Quantity]| list.iter().map(named).collect::<Vec<_>>().join(", ");
        match self {
            Self::Beyond { asked, reached, called } => {
                write!(f, "{} is {called} {}, which grows instead", named(asked), reached.number(units))
            }
            Self::Together { asked, reached } => {
                let (asked, reached) = (listed(asked), listed(reached));
                write!(f, "{asked} cannot be grown together; the nearest possible grows instead: {reached}")
            }
            Self::FreeSpacing(_) => {
                f.write_str("no spacing is given: spots get the usual one for their size")
            }
            Self::Apart { asked, sparsest, pitch } => {
                let pitch = brief(*pitch);
                let placed = format!(
                    "spots are placed one by one, {pitch} times as far apart as they would stand by themselves"
                );
                if asked.value < sparsest.value {
                    f.write_str(&placed)
                } else {
                    write!(f, "{placed}, as in the sparser regions around")
                }
            }
        }
    }
}

impl Lengths for Note {
    fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Beyond { asked, reached, called } => {
                Self::Beyond { asked: asked.scaled(factor), reached: reached.scaled(factor), called }
            }
            Self::Together { asked, reached } => {
                Self::Together { asked: asked.scaled(factor), reached: reached.scaled(factor) }
            }
            Self::Apart { asked, sparsest, pitch } => {
                Self::Apart { asked: asked.scaled(factor), sparsest: sparsest.scaled(factor), pitch }
            }
            Self::FreeSpacing(density) => Self::FreeSpacing(density),
        }
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, PX)
    }
}

impl fmt::Display for InCells<Note> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.write(f, CELLS)
    }
}

/// A number in a sentence: three significant digits.
fn brief(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    if (1e-4..1e7).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_says_what_the_system_cannot_reach_with_its_numbers() {
        let share = |value| Quantity::new(Attribute::Aspect, value);
        let note = Note::Beyond {
            asked: share(0.1),
            reached: share(0.1504),
            called: "too narrow: the narrowest possible is",
        };
        assert_eq!(
            note.to_string(),
            "aspect 0.1 is too narrow: the narrowest possible is 0.15, which grows instead"
        );
        assert_eq!(InCells(note.clone()).to_string(), note.to_string());
    }

    #[test]
    fn lengths_in_notes_are_converted_to_px() {
        let area = |value| Quantity::new(Attribute::Area, value);
        let width = |value| Quantity::new(Attribute::Width, value);
        let called = "too small: the smallest possible is";
        let note = InCells(Note::Beyond { asked: area(2.0), reached: area(18.0), called });
        assert_eq!(
            note.to_string(),
            "area 2 cells is too small: the smallest possible is 18 cells, which grows instead"
        );
        assert_eq!(
            note.in_px(0.5).to_string(),
            "area 0.5 px² is too small: the smallest possible is 4.5 px², which grows instead"
        );
        let angle = Quantity::new(Attribute::Angle, 33.0);
        let note =
            InCells(Note::Together { asked: vec![width(4.0), angle], reached: vec![width(5.0), angle] });
        assert_eq!(
            note.in_px(2.0).to_string(),
            "width 8 px, angle 33° cannot be grown together; the nearest possible grows instead: width 10 px, angle 33°"
        );
    }

    #[test]
    fn numbers_in_notes_have_three_digits() {
        let seen: Vec<String> = [0.0, 1.0, 0.123_456, 12_345.0, 1e300, 3e-9].map(brief).into();
        assert_eq!(seen, ["0", "1", "0.123", "12300", "1e300", "3e-9"]);
    }
}
