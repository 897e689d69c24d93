//! Allowed combinations of marks, `after`, system and options of a layer: one table.
//!
//! [`RULES`] lists every combination that cannot be grown, with the reason. The reader of documents, `check`, growing,
//! the window's choices and the random documents of the tests all ask it, and `docs/format.md` shows it. Rules about single
//! systems are derived from their [descriptions](Description).
//!
//! Of two things that do not go together, one has to change: `after` follows the marks and the layer beneath, the system
//! follows the marks and `after`, and the options follow all of these.

mod shown;
mod table;

pub use table::RULES;

use Condition::Marks;
use Kind::{Ellipse, Line};

use crate::attributes::system::{Description, Family};
use crate::document::{After, Kind, Layer, LayerOptions, MapKey, OptionKey, Problem, SystemChoice};

/// A combination that cannot be grown.
#[derive(Debug)]
pub struct Rule {
    /// The key of the value that has to change.
    pub key: Key,
    /// The condition under which the key is refused.
    pub condition: Condition,
    /// Why, as a sentence without its full stop.
    pub reason: &'static str,
    /// Whether reading a document that breaks the rule fails. The other rules are left to `check` and `grow`, so that the window
    /// can open such a document and its user can mend it.
    pub on_reading: bool,
}

/// The key of a layer that a rule is about, with the values that it refuses.
#[derive(Debug)]
pub enum Key {
    /// `after` with one of these values.
    After(&'static [After]),
    /// `system` with one that grows this kind of marks.
    SystemGrowing(Kind),
    /// `system` of this description.
    System(&'static Description),
    /// `system` without this property, `auto` included.
    SystemLacking(fn(&Description) -> bool),
    /// `system` without this property; `auto` has every one.
    SystemWithout(fn(&Description) -> bool),
    /// An option that has another value than [`OptionKey::always_allowed`].
    Option(OptionKey),
    /// A `tone`.
    Tone,
    /// `points`.
    Points,
    /// Maps of these attributes.
    Maps(Vec<MapKey>),
}

/// A condition with which a key cannot be combined.
#[derive(Debug)]
pub enum Condition {
    /// The layer is the lowest.
    Lowest,
    /// There is a layer beneath.
    NotLowest,
    /// The layer beneath is of this kind.
    Above(Beneath),
    /// The layer's own marks are of this kind.
    Marks(Kind),
    /// The layer holds ellipses and lines.
    BothKinds,
    /// The layer grows this kind of marks.
    Grows(Kind),
    /// `after` has one of these values.
    After(&'static [After]),
    /// `system` grows this kind of marks and lacks this property.
    SystemWithout(Kind, fn(&Description) -> bool),
    /// The layer asks for this system.
    Of(&'static Description),
    /// The system is none of those that [own](Description::own_keys) this key.
    NotOwned(&'static str),
    /// The system does not take this option.
    NotTaken(OptionKey),
    /// This option has another value than [`OptionKey::always_allowed`].
    Option(OptionKey),
    /// The layer has a `tone`.
    Driven,
    /// A field of points whose labels have no probability.
    WithoutChance,
}

/// The kind of the layer beneath.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beneath {
    /// Unknown: rules about the layer beneath are skipped.
    Unknown,
    /// Nothing: the layer is the lowest.
    Nothing,
    /// A layer that grows this kind of marks; rings and webs are lines.
    Grows(Kind),
    /// A layer that a system of pairs grows.
    Pairs,
    /// A layer of patches, cells, streaks, cracks or a field of points.
    Areas,
    /// A layer with a tone, or of Turing's growth.
    Tone,
}

/// The properties of one layer that the rules depend on.
#[derive(Clone, Copy, Debug)]
pub struct Combination {
    /// The kind of its marks; `None` = it has none, or only freehand strokes that have not been fitted yet.
    pub marks: Option<Kind>,
    /// Whether the layer holds lines beside ellipses, as far as is known before freehand strokes are fitted.
    pub holds_both: bool,
    /// The kind of the layer beneath.
    pub beneath: Beneath,
    /// Position of its marks relative to the marks beneath.
    pub after: After,
    /// The system that is asked for; areas where `"auto"` takes these.
    pub system: SystemChoice,
    /// Its options.
    pub options: LayerOptions,
    /// Whether a picture drives it.
    pub driven: bool,
    /// Whether it has `points`.
    pub pointed: bool,
    /// Whether its points are dark or light with a probability.
    pub by_chance: bool,
    /// For each attribute, whether the layer has a map of it, in the order of [`MapKey::ALL`].
    pub mapped: [bool; MapKey::ALL.len()],
}

impl Combination {
    /// The properties of `layer`, whose marks are of the kind `marks`.
    #[must_use]
    pub fn new(layer: &Layer, marks: Option<Kind>, beneath: Beneath) -> Self {
        let system = layer.areas().map_or(layer.system, |areas| SystemChoice::Of(areas.description()));
        let driven = layer.tone.is_some();
        let (mapped, pointed) = (layer.maps.present(), layer.points.is_some());
        let by_chance = layer.point_field().is_some_and(|points| points.labels.are_by_chance());
        let (after, options) = (layer.after, layer.options);
        let holds = |kind| layer.strokes.iter().any(|stroke| stroke.kind() == Some(kind));
        let holds_both = holds(Ellipse) && holds(Line);
        Self { marks, holds_both, beneath, after, system, options, driven, pointed, by_chance, mapped }
    }

    /// The kind of marks that the layer grows: given by its system, or by `after`, or by its own marks.
    #[must_use]
    pub fn grows(&self) -> Option<Kind> {
        self.system.grows().or(self.after.grows()).or(self.marks)
    }

    /// The first rule that the layer breaks.
    #[must_use]
    pub fn broken_rule(&self) -> Option<&'static Rule> {
        RULES.iter().find(|rule| rule.refuses(self))
    }

    /// The rule that keeps the layer from this `after`.
    #[must_use]
    pub fn against_after(&self, after: After) -> Option<&'static Rule> {
        let with = Self { after, ..*self };
        RULES.iter().find(|rule| matches!(rule.key, Key::After(_)) && rule.refuses(&with))
    }

    /// The rule that keeps the layer from this system.
    #[must_use]
    pub fn against_system(&self, system: SystemChoice) -> Option<&'static Rule> {
        let with = Self { system, ..*self };
        let about_systems = |rule: &Rule| {
            matches!(
                rule.key,
                Key::SystemGrowing(_) | Key::System(_) | Key::SystemLacking(_) | Key::SystemWithout(_)
            )
        };
        RULES.iter().find(|rule| about_systems(rule) && rule.refuses(&with))
    }

    /// The rule that keeps the layer from setting this option.
    #[must_use]
    pub fn against_option(&self, option: OptionKey) -> Option<&'static Rule> {
        let about = |rule: &Rule| matches!(rule.key, Key::Option(key) if key == option);
        RULES.iter().find(|rule| about(rule) && rule.condition.holds(self))
    }

    /// The rule that keeps the layer from a map of this attribute.
    #[must_use]
    pub fn against_map(&self, key: MapKey) -> Option<&'static Rule> {
        let about = |rule: &Rule| matches!(&rule.key, Key::Maps(refused) if refused.contains(&key));
        RULES.iter().find(|rule| about(rule) && rule.condition.holds(self))
    }

    /// Whether the system and the `after` of the layer allow marks of `kind`.
    #[must_use]
    pub fn takes(&self, kind: Kind) -> bool {
        let with = Self { marks: Some(kind), ..*self };
        let about_marks = |rule: &&Rule| matches!(rule.condition, Marks(_));
        if (self.marks, kind) == (Some(Ellipse), Line) && self.system.takes_lines_beside() {
            return true;
        }
        self.marks.is_none_or(|held| held == kind)
            && !RULES.iter().filter(about_marks).any(|rule| rule.refuses(&with))
    }

    /// The first problem of the layer at `place` (such as `layers[0]`) by the rules that are checked on reading.
    #[must_use]
    pub fn problem_on_reading(&self, place: &str) -> Option<Problem> {
        let rule = RULES.iter().find(|rule| rule.on_reading && rule.refuses(self))?;
        Some(rule.problem(self, place))
    }

    /// The first problem of the layer at `place` (such as `layers[0]`) by all rules.
    #[must_use]
    pub fn problem(&self, place: &str) -> Option<Problem> {
        Some(self.broken_rule()?.problem(self, place))
    }
}

impl Rule {
    /// Whether a layer breaks this rule.
    fn refuses(&self, layer: &Combination) -> bool {
        let has_value = match &self.key {
            Key::After(refused) => refused.contains(&layer.after),
            Key::SystemGrowing(kind) => layer.system.grows() == Some(*kind),
            Key::System(system) => layer.system == SystemChoice::Of(system),
            Key::SystemLacking(property) => !layer.system.is_known(property),
            Key::SystemWithout(property) => !layer.system.allows(property),
            Key::Option(option) => option.is_set(&layer.options),
            Key::Tone => layer.driven,
            Key::Points => layer.pointed,
            Key::Maps(refused) => refused.iter().any(|key| layer.mapped[*key as usize]),
        };
        has_value && self.condition.holds(layer)
    }

    /// The problem of a layer that breaks this rule.
    fn problem(&self, layer: &Combination, place: &str) -> Problem {
        let (key, found, allowed) = match &self.key {
            Key::After(_) => {
                let allowed = After::NAMES.iter().filter(|(_, after)| layer.against_after(*after).is_none());
                ("after".to_owned(), format!("\"{}\"", layer.after.name()), listed(allowed))
            }
            Key::SystemGrowing(_) | Key::System(_) | Key::SystemLacking(_) | Key::SystemWithout(_) => {
                let all = SystemChoice::names();
                let allowed = all.iter().filter(|(_, system)| layer.against_system(*system).is_none());
                ("system".to_owned(), format!("\"{}\"", layer.system.name()), listed(allowed))
            }
            Key::Option(option) => (
                format!("options.{}", option.name()),
                option.value(&layer.options),
                match option.always_allowed() {
                    [] => format!("no {}", option.name()),
                    values => values.join(" or "),
                },
            ),
            Key::Tone => ("tone".to_owned(), "a tone".to_owned(), "no tone".to_owned()),
            Key::Points => ("points".to_owned(), "points".to_owned(), "no points".to_owned()),
            Key::Maps(refused) => {
                let first = refused.iter().find(|key| layer.mapped[**key as usize]);
                let name = first.map_or("", |key| key.name());
                (format!("maps.{name}"), "a map".to_owned(), "no map".to_owned())
            }
        };
        Problem::new(format!("{place}.{key}"), found, format!("{allowed}. {}", self.reason))
    }
}

fn listed<'a, T: 'a>(names: impl Iterator<Item = &'a (&'static str, T)>) -> String {
    names.map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
}

impl Condition {
    fn holds(&self, layer: &Combination) -> bool {
        match self {
            Self::Lowest => layer.beneath == Beneath::Nothing,
            Self::NotLowest => !matches!(layer.beneath, Beneath::Nothing | Beneath::Unknown),
            Self::Above(beneath) => layer.beneath == *beneath,
            Self::Marks(kind) => layer.marks == Some(*kind),
            Self::BothKinds => layer.holds_both,
            Self::Grows(kind) => layer.grows() == Some(*kind),
            Self::After(after) => after.contains(&layer.after),
            Self::SystemWithout(kind, property) => {
                layer.system.grows() == Some(*kind) && !layer.system.allows(property)
            }
            Self::Of(system) => layer.system == SystemChoice::Of(system),
            Self::NotOwned(key) => !layer.system.is_known(|system| system.owns(key)),
            Self::NotTaken(option) => {
                !layer.system.allows(|system| system.option_keys.contains(&option.name()))
            }
            Self::Option(other) => other.is_set(&layer.options),
            Self::Driven => layer.driven,
            Self::WithoutChance => layer.system.kind() == Some(Family::Points) && !layer.by_chance,
        }
    }
}

/// The problem of a mark at `place` whose `kind` is not that of the `first` mark of its layer. `None` if the kinds are equal, or if
/// `system` takes lines beside ellipses.
///
/// Explicit strokes are checked when a document is read, freehand ones when they are fitted.
#[must_use]
pub fn mixed_marks(system: SystemChoice, kind: Kind, first: Kind, place: &str) -> Option<Problem> {
    let one = |kind| if kind == Ellipse { "an ellipse" } else { "a line" };
    (kind != first && !system.takes_lines_beside()).then(|| {
        let found = format!("{} in a layer of {}s", one(kind), first.name());
        let allowed = "(a layer holds ellipses or lines: give the others a layer of their own)";
        Problem::new(place, found, format!("{} {allowed}", one(first)))
    })
}

/// Resets the system, the options, the points and the maps of `layer` that the rules refuse to their defaults. `marks` is the kind
/// of its marks. `after` stays.
pub fn tidy(layer: &mut Layer, marks: Option<Kind>) {
    if Combination::new(layer, marks, Beneath::Unknown).against_system(layer.system).is_some() {
        layer.system = SystemChoice::Auto;
    }
    layer.far_spacing = layer.far_spacing.filter(|_| marks == Some(Ellipse));
    for rule in RULES.iter() {
        if !rule.refuses(&Combination::new(layer, marks, Beneath::Unknown)) {
            continue;
        }
        match &rule.key {
            Key::Option(option) => option.reset(&mut layer.options),
            Key::Maps(refused) => refused.iter().for_each(|key| layer.maps.set(*key, None)),
            Key::Points => layer.points = None,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests;
