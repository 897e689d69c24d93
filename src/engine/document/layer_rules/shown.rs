//! The rules in words, as `docs/format.md` shows them.

use super::{Condition, Key};
use crate::document::{After, Kind, OptionKey, SystemChoice};
use std::fmt;

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::After(refused) => write!(f, "`after` {}", any_of(refused.iter().map(|after| after.name()))),
            Self::SystemGrowing(kind) => write!(f, "`system` that grows {}", grown(*kind)),
            Self::System(system) => write!(f, "`system` {}", any_of([system.name()].into_iter())),
            Self::SystemOtherThan(system) => {
                write!(f, "`system` other than {}", any_of([system.name()].into_iter()))
            }
            Self::SystemWithout(property) => {
                let allowed = SystemChoice::NAMES.iter().filter(|(_, system)| system.allows(property));
                write!(f, "`system` other than {}", any_of(allowed.map(|(name, _)| *name)))
            }
            Self::Option(option) => {
                write!(f, "`options.{}` other than {}", option.name(), either(*option))
            }
            Self::Tone => write!(f, "`tone`"),
            Self::Points => write!(f, "`points`"),
            Self::Maps(refused) => {
                let names: Vec<String> = refused.iter().map(|key| format!("`maps.{}`", key.name())).collect();
                write!(f, "{}", names.join(" or "))
            }
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Lowest => write!(f, "the lowest layer"),
            Self::Above(kind) => write!(f, "a layer above {}", grown(*kind)),
            Self::AboveAreas => {
                write!(f, "a layer above patches, cells, streaks, cracks or a field of points")
            }
            Self::Without(system) => write!(f, "a layer without {}", system.name()),
            Self::WithoutPoints => write!(f, "a layer of neither patches nor streaks"),
            Self::Driven => write!(f, "a layer with a `tone`"),
            Self::AboveTone => write!(f, "a layer above one with a `tone` or of Turing's growth"),
            Self::NotLowest => write!(f, "a layer above another"),
            Self::Of(system) => write!(f, "`system` `\"{}\"`", system.name()),
            Self::WithoutChance => {
                write!(f, "a field of points with other labels than `random` and `image`")
            }
            Self::AbovePairs => write!(f, "a layer above a weave, a maze, pair stripes or stucco"),
            Self::Marks(kind) => write!(f, "a layer of {}s", kind.name()),
            Self::BothKinds => write!(f, "a layer of ellipses and lines"),
            Self::Grows(kind) => write!(f, "a layer that grows {}", grown(*kind)),
            Self::After(after) => {
                write!(f, "`after` {}", any_of(after.iter().map(|after| After::name(*after))))
            }
            Self::SystemWithout(kind, property) => {
                let without = SystemChoice::NAMES
                    .iter()
                    .filter(|(_, system)| system.grows() == Some(*kind) && !system.allows(property));
                write!(f, "`system` {}", any_of(without.map(|(name, _)| *name)))
            }
            Self::NotTaken(option) => write!(f, "a `system` that does not take `{}`", option.name()),
            Self::Option(option) => {
                write!(f, "`options.{}` other than {}", option.name(), either(*option))
            }
        }
    }
}

fn grown(kind: Kind) -> &'static str {
    match kind {
        Kind::Ellipse => "spots",
        Kind::Line => "stripes",
    }
}

fn either(option: OptionKey) -> String {
    option.always_allowed().iter().map(|value| format!("`{value}`")).collect::<Vec<_>>().join(" or ")
}

fn any_of<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(|name| format!("`\"{name}\"`")).collect::<Vec<_>>().join(" or ")
}
