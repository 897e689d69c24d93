//! The keys of a layer's `options`.

use crate::document::choices::{SEEDINGS, name_in};
use crate::document::{DutyChoice, GapChoice, LayerOptions, Over, RaggedChoice, SpreadChoice};

/// One key of a layer's `options`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptionKey {
    /// How much the spots differ from each other.
    Spread,
    /// How irregular the shapes of the spots are.
    Irregular,
    /// Width of the stripes ÷ their period.
    Duty,
    /// What stripes begin from.
    Seeding,
    /// The share of each ring that is open.
    Broken,
    /// Whether the drawn marks are among those that grow.
    Keep,
    /// How ragged edges are.
    Ragged,
    /// Points a patch or a streak.
    Detail,
    /// Width of the lines between cells.
    Gap,
    /// How far the gain of stucco falls.
    Decay,
    /// Which threads lie over the others.
    Over,
}

impl OptionKey {
    /// All keys, in the order in which they are shown and checked.
    pub const ALL: [Self; 11] = [
        Self::Spread,
        Self::Irregular,
        Self::Duty,
        Self::Seeding,
        Self::Broken,
        Self::Keep,
        Self::Ragged,
        Self::Detail,
        Self::Gap,
        Self::Decay,
        Self::Over,
    ];

    /// The key in a document.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Spread => "spread",
            Self::Irregular => "irregular",
            Self::Duty => "duty",
            Self::Seeding => "seeding",
            Self::Broken => "broken",
            Self::Keep => "keep",
            Self::Ragged => "ragged",
            Self::Detail => "detail",
            Self::Gap => "gap",
            Self::Decay => "decay",
            Self::Over => "over",
        }
    }

    /// Whether `options` give this key a value that not every layer allows: any but the default, a `duty` of 0.5 and a
    /// `keep` of `false`.
    #[must_use]
    pub fn is_set(self, options: &LayerOptions) -> bool {
        let default = LayerOptions::default();
        match self {
            Self::Spread => options.spread != default.spread,
            Self::Irregular => options.irregular != default.irregular,
            Self::Duty => options.duty.given().is_some_and(|duty| duty != LayerOptions::DUTY),
            Self::Seeding => options.seeding != default.seeding,
            Self::Broken => options.broken != default.broken,
            Self::Keep => options.keep == Some(true),
            Self::Ragged => options.ragged != default.ragged,
            Self::Detail => options.detail != default.detail,
            Self::Gap => options.gap != default.gap,
            Self::Decay => options.decay != default.decay,
            Self::Over => options.over != default.over,
        }
    }

    /// Whether `options` hold exactly the default of this key.
    #[must_use]
    pub fn is_default(self, options: &LayerOptions) -> bool {
        match self {
            Self::Keep => options.keep.is_none(),
            Self::Duty => options.duty == DutyChoice::Drawn,
            _ => !self.is_set(options),
        }
    }

    /// Puts this key back to its default.
    pub fn reset(self, options: &mut LayerOptions) {
        let default = LayerOptions::default();
        match self {
            Self::Spread => options.spread = default.spread,
            Self::Irregular => options.irregular = default.irregular,
            Self::Duty => options.duty = default.duty,
            Self::Seeding => options.seeding = default.seeding,
            Self::Broken => options.broken = default.broken,
            Self::Keep => options.keep = default.keep,
            Self::Ragged => options.ragged = default.ragged,
            Self::Detail => options.detail = default.detail,
            Self::Gap => options.gap = default.gap,
            Self::Decay => options.decay = default.decay,
            Self::Over => options.over = default.over,
        }
    }

    /// The values that every layer allows, as JSON.
    #[must_use]
    pub fn always_allowed(self) -> &'static [&'static str] {
        match self {
            Self::Spread => &["\"drawn\""],
            Self::Irregular | Self::Broken => &["0"],
            Self::Duty => &["\"drawn\"", "0.5"],
            Self::Seeding => &["\"noise\""],
            Self::Keep => &["false"],
            Self::Ragged | Self::Gap => &["\"drawn\""],
            Self::Detail => &["24"],
            Self::Decay => &["0.8"],
            Self::Over => &["\"level\""],
        }
    }

    /// The value in `options`, as it stands in a message.
    #[must_use]
    pub fn value(self, options: &LayerOptions) -> String {
        match self {
            Self::Spread => match options.spread {
                SpreadChoice::Drawn => "\"drawn\"".to_owned(),
                SpreadChoice::Given(spread) => {
                    let parts = spread.named().map(|(name, value)| format!("{name} {value}"));
                    format!("a spread of {}", parts.join(", "))
                }
            },
            Self::Irregular => options.irregular.to_string(),
            Self::Duty => options.duty.given().map_or("\"drawn\"".to_owned(), |duty| duty.to_string()),
            Self::Seeding => format!("\"{}\"", name_in(&SEEDINGS, options.seeding)),
            Self::Broken => options.broken.to_string(),
            Self::Keep => options.keep.map_or("nothing".to_owned(), |keep| keep.to_string()),
            Self::Ragged => match options.ragged {
                RaggedChoice::Drawn => "\"drawn\"".to_owned(),
                RaggedChoice::Given(sigma) => sigma.to_string(),
            },
            Self::Detail => options.detail.to_string(),
            Self::Decay => options.decay.to_string(),
            Self::Over => format!("\"{}\"", name_in(&Over::NAMES, options.over)),
            Self::Gap => match options.gap {
                GapChoice::Drawn => "\"drawn\"".to_owned(),
                GapChoice::Given(gap) => gap.to_string(),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_unset() {
        let options = LayerOptions::default();
        for key in OptionKey::ALL {
            assert!(key.is_default(&options) && !key.is_set(&options), "{}", key.name());
        }
        assert_eq!(OptionKey::Duty.always_allowed()[1], LayerOptions::DUTY.to_string());
        assert_eq!(OptionKey::Detail.always_allowed(), [options.detail.to_string()]);
        assert_eq!(OptionKey::Decay.always_allowed(), [options.decay.to_string()]);
    }

    #[test]
    fn a_reset_touches_one_key() {
        let mut options = LayerOptions {
            duty: DutyChoice::Given(0.3),
            irregular: 0.5,
            keep: Some(false),
            ..LayerOptions::default()
        };
        OptionKey::Duty.reset(&mut options);
        assert!(OptionKey::Duty.is_default(&options));
        assert!(OptionKey::Irregular.is_set(&options) && !OptionKey::Keep.is_default(&options));
    }
}
