//! The rules in words, as `docs/format.md` shows them.

use super::{Beneath, Condition, Key};
use crate::attributes::system::Family;
use crate::document::systems::SYSTEMS;
use crate::document::{After, Kind, OptionKey, SystemChoice};
use std::fmt;

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::After(refused) => write!(f, "`after` {}", any_of(refused.iter().map(|after| after.name()))),
            Self::SystemGrowing(kind) => write!(f, "`system` that grows {}", grown(*kind)),
            Self::System(system) => write!(f, "`system` {}", any_of([system.name].into_iter())),
            Self::SystemLacking(property) => {
                let allowed = SYSTEMS.iter().filter(|system| property(system));
                write!(f, "`system` other than {}", any_of(allowed.map(|system| system.name)))
            }
            Self::SystemWithout(property) => {
                let all = SystemChoice::names();
                let allowed = all.iter().filter(|(_, system)| system.allows(property));
                write!(f, "`system` other than {}", any_of(allowed.map(|(name, _)| *name)))
            }
            Self::Option(option) => {
                write!(f, "{}", other_than_allowed(*option))
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
            Self::NotLowest => write!(f, "a layer above another"),
            Self::Above(beneath) => write!(f, "a layer above {beneath}"),
            Self::Marks(kind) => write!(f, "a layer of {}s", kind.name()),
            Self::BothKinds => write!(f, "a layer of ellipses and lines"),
            Self::Grows(kind) => write!(f, "a layer that grows {}", grown(*kind)),
            Self::After(after) => {
                write!(f, "`after` {}", any_of(after.iter().map(|after| After::name(*after))))
            }
            Self::SystemWithout(kind, property) => {
                let lacks = |system: &SystemChoice| system.grows() == Some(*kind) && !system.allows(property);
                let all = SystemChoice::names();
                let without = all.iter().filter(|(_, system)| lacks(system));
                write!(f, "`system` {}", any_of(without.map(|(name, _)| *name)))
            }
            Self::Of(system) => write!(f, "`system` `\"{}\"`", system.name),
            Self::NotOwned(key) => {
                let owners = SYSTEMS.iter().filter(|system| system.owns(key)).map(|system| system.name);
                match owners.collect::<Vec<_>>().as_slice() {
                    [one] => write!(f, "a layer without {one}"),
                    several => write!(f, "a layer of neither {}", several.join(" nor ")),
                }
            }
            Self::NotTaken(option) => write!(f, "a `system` that does not take `{}`", option.name()),
            Self::Option(option) => {
                write!(f, "{}", other_than_allowed(*option))
            }
            Self::Driven => write!(f, "a layer with a `tone`"),
            Self::WithoutChance => {
                write!(f, "a field of points with other labels than `random` and `image`")
            }
        }
    }
}

impl fmt::Display for Beneath {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Unknown => write!(f, "any other"),
            Self::Nothing => write!(f, "none"),
            Self::Grows(kind) => write!(f, "{}", grown(*kind)),
            Self::Pairs => write!(f, "{}", one_of(|kind| kind == Family::Pairs)),
            Self::Areas => write!(f, "{}", one_of(Family::is_scattered)),
            Self::Tone => {
                write!(f, "one with a `tone` or of {}", one_of(|kind| kind == Family::Growth))
            }
        }
    }
}

/// The names of the systems of some families, as a part of a sentence.
fn one_of(is_meant: impl Fn(Family) -> bool) -> String {
    let nouns = SYSTEMS.iter().filter(|system| is_meant(system.kind)).map(|system| system.noun);
    let nouns: Vec<&str> = nouns.collect();
    match nouns.as_slice() {
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
        [] => String::new(),
    }
}

fn grown(kind: Kind) -> &'static str {
    match kind {
        Kind::Ellipse => "spots",
        Kind::Line => "stripes",
    }
}

/// An option with a value that not every layer allows.
fn other_than_allowed(option: OptionKey) -> String {
    let allowed = option.always_allowed().iter().map(|value| format!("`{value}`")).collect::<Vec<_>>();
    let name = option.name();
    if allowed.is_empty() {
        return format!("`options.{name}`");
    }
    format!("`options.{name}` other than {}", allowed.join(" or "))
}

fn any_of<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(|name| format!("`\"{name}\"`")).collect::<Vec<_>>().join(" or ")
}
