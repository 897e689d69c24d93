//! Which marks, `after`, system and options of a layer go together: one table.
//!
//! [`RULES`] lists every combination that cannot be grown, with the reason. The reader of documents, `check`, growing,
//! the window's choices and the random documents of the tests all ask it, and `docs/format.md` shows it.
//!
//! Of two things that do not go together, one has to change: `after` follows the marks and the layer beneath, the system
//! follows the marks and `after`, and the options follow all of these.

mod shown;

use Condition::{
    Above, AboveAreas, AbovePairs, AboveTone, Driven, Grows, Lowest, Marks, NotLowest, NotTaken, Without,
    WithoutChance, WithoutPoints,
};
use Kind::{Ellipse, Line};

use crate::attributes::system::Description;
use crate::document::{
    After, AreaKind, Kind, Layer, LayerOptions, LineKind, MapKey, OptionKey, PairKind, Problem, SystemChoice,
};

/// A combination that cannot be grown.
#[derive(Debug)]
pub struct Rule {
    /// What has to change.
    pub key: Key,
    /// What it does not go with.
    pub condition: Condition,
    /// Why, as a sentence without its full stop.
    pub reason: &'static str,
    /// Whether a document that breaks the rule is refused when it is read. The other rules are left to `check` and
    /// `grow`, so that the window can open such a document and its user can mend it.
    pub on_reading: bool,
}

/// The key of a layer that a rule is about, with the values that it refuses.
#[derive(Debug)]
pub enum Key {
    /// `after` with one of these values.
    After(&'static [After]),
    /// `system` with one that grows this kind of marks.
    SystemGrowing(Kind),
    /// `system` of this name.
    System(SystemChoice),
    /// `system` other than this one, `auto` included.
    SystemOtherThan(SystemChoice),
    /// `system` without this property; `auto` has every one.
    SystemWithout(fn(&Description) -> bool),
    /// An option with any other value than [`OptionKey::always_allowed`].
    Option(OptionKey),
    /// A `tone`.
    Tone,
    /// `points`.
    Points,
    /// Maps of these attributes.
    Maps(&'static [MapKey]),
}

/// What a key does not go with.
#[derive(Debug)]
pub enum Condition {
    /// The layer is the lowest.
    Lowest,
    /// The layer beneath grows this kind of marks.
    Above(Kind),
    /// A system of pairs grows the layer beneath.
    AbovePairs,
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
    /// The system does not take this option.
    NotTaken(OptionKey),
    /// This option has another value than [`OptionKey::always_allowed`].
    Option(OptionKey),
    /// Patches, cells, streaks, cracks or a field of points grow on the layer beneath.
    AboveAreas,
    /// The layer asks for another system.
    Without(SystemChoice),
    /// The layer grows neither patches nor streaks.
    WithoutPoints,
    /// The layer has a `tone`.
    Driven,
    /// A picture or a growth drives the layer beneath.
    AboveTone,
    /// There is a layer beneath.
    NotLowest,
    /// The layer asks for this system.
    Of(SystemChoice),
    /// A field of points whose labels have no probability.
    WithoutChance,
}

/// What lies beneath a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beneath {
    /// Not known here: rules about it are passed over.
    Unknown,
    /// Nothing: the layer is the lowest.
    Nothing,
    /// A layer that grows this kind of marks; rings and webs are lines.
    Grows(Kind),
    /// A layer that a system of pairs grows.
    Pairs,
    /// A layer of patches, cells, streaks, cracks or a field of points.
    Areas,
    /// A layer that a picture or a growth drives.
    Tone,
}

/// What the rules have to know of one layer.
#[derive(Clone, Copy, Debug)]
pub struct Combination {
    /// The kind of its marks; `None` = it has none, or only freehand strokes that have not been fitted yet.
    pub marks: Option<Kind>,
    /// Whether it holds lines beside ellipses, as far as is known before freehand strokes are fitted.
    pub holds_both: bool,
    /// What lies beneath it.
    pub beneath: Beneath,
    /// How it meets the marks beneath.
    pub after: After,
    /// The system that is asked for; areas where `"auto"` takes these.
    pub system: SystemChoice,
    /// Its options.
    pub options: LayerOptions,
    /// Whether a picture drives it.
    pub driven: bool,
    /// Whether it says what its points are.
    pub pointed: bool,
    /// Whether its points are dark with a probability.
    pub by_chance: bool,
    /// Which attributes it has maps of, in the order of [`MapKey::ALL`].
    pub mapped: [bool; MapKey::ALL.len()],
}

/// A rule that is checked when a document is read.
const fn read(key: Key, condition: Condition, reason: &'static str) -> Rule {
    Rule { key, condition, reason, on_reading: true }
}

/// A rule that is checked when a document is checked or grown.
const fn grown(key: Key, condition: Condition, reason: &'static str) -> Rule {
    Rule { key, condition, reason, on_reading: false }
}

const AROUND: &[After] = &[After::Around, After::Net];
const INSIDE: &[After] = &[After::Inside];
const PLACED: &[After] = &[After::Around, After::Net, After::Inside];

/// Of an option that a system does not list among those it takes.
const NOT_TAKEN: &str = "This system does not take this option";

/// Of the options of layers that a picture drives.
const TONE_DECIDES: &str = "The tone of the picture says how large marks are";

/// Of ragged edges.
const NO_RAGGED: &str = "Only patches and the spots and stripes of reaction and diffusion have ragged edges";

/// Of ragged edges of what a picture drives.
const DRIVEN_EDGES: &str = "The edges of marks that a picture drives carry its details";

/// Of the points of patches and streaks.
const ONLY_POINTS: &str =
    "Only patches and streaks are made from a number of points: set \"system\" to one of these";

/// Of the options of cells.
const ONLY_CELLS: &str = "Only cells have this option: set \"system\" to \"cells\"";

/// All rules, in the order in which they are checked.
pub static RULES: [Rule; 61] = [
    grown(Key::After(PLACED), Lowest, "The lowest layer has no other beneath it whose marks it could meet"),
    grown(
        Key::After(AROUND),
        Marks(Ellipse),
        "Rings and webs are drawn as lines, whose width is that of the rings or the web; this layer holds ellipses",
    ),
    grown(
        Key::After(INSIDE),
        Marks(Line),
        "A spot grows inside each spot beneath, so it is drawn as an ellipse; this layer holds lines",
    ),
    grown(
        Key::After(INSIDE),
        Above(Line),
        "A spot grows inside each spot beneath; the layer beneath grows stripes, rings or a web",
    ),
    grown(
        Key::After(PLACED),
        AbovePairs,
        "Rings, webs and spots inside follow marks that stand apart; those of pairs of morphogens meet",
    ),
    grown(
        Key::After(PLACED),
        AboveAreas,
        "Rings, webs and spots inside follow the spots of a reaction-diffusion system; scattered points make the layer beneath",
    ),
    grown(
        Key::After(PLACED),
        AboveTone,
        "Rings, webs and spots inside follow marks of the sizes that are asked for; a picture gives those of the layer beneath all sizes",
    ),
    grown(Key::Tone, NotLowest, "A picture drives the lowest layer, which has the whole canvas"),
    grown(
        Key::System(SystemChoice::Growth),
        NotLowest,
        "Turing's growth makes the lowest layer, which has the whole canvas",
    ),
    read(Key::SystemGrowing(Line), Marks(Ellipse), "This system grows stripes; this layer holds ellipses"),
    read(Key::SystemGrowing(Ellipse), Marks(Line), "This system grows spots; this layer holds lines"),
    read(
        Key::SystemOtherThan(SystemChoice::Areas(AreaKind::Cells)),
        Condition::BothKinds,
        "A layer holds ellipses or lines; only cells have lines beside them, which say how wide the lines between cells are",
    ),
    grown(
        Key::SystemWithout(|system| system.along_curves),
        Condition::After(AROUND),
        "Rings and webs are grown by Meinhardt's lines",
    ),
    grown(
        Key::SystemWithout(|system| system.fixed_places),
        Condition::After(INSIDE),
        "Only Meinhardt's spots stay at given places; other systems fill the space between the places, too",
    ),
    read(
        Key::SystemWithout(|system| system.tone),
        Driven,
        "A picture drives Meinhardt's stripes and spots, pair stripes and Turing's growth, whose marks can be any share of their distance",
    ),
    read(Key::Option(OptionKey::Spread), Driven, TONE_DECIDES),
    read(Key::Option(OptionKey::Spread), Grows(Line), "Only spots have a spread"),
    read(Key::Option(OptionKey::Spread), NotTaken(OptionKey::Spread), NOT_TAKEN),
    read(Key::Option(OptionKey::Irregular), Driven, TONE_DECIDES),
    read(Key::Option(OptionKey::Irregular), Grows(Line), "Only spots can be irregular"),
    read(Key::Option(OptionKey::Irregular), NotTaken(OptionKey::Irregular), NOT_TAKEN),
    read(
        Key::Option(OptionKey::Irregular),
        Condition::After(INSIDE),
        "A spot inside another one begins and stays as an ellipse",
    ),
    read(
        Key::Option(OptionKey::Irregular),
        Condition::SystemWithout(Ellipse, |system| system.irregular),
        "The spots of Meinhardt's system stay ellipses; Turing's can be irregular",
    ),
    read(Key::Option(OptionKey::Seeding), Driven, "Stripes that a picture drives begin from noise"),
    read(Key::Option(OptionKey::Seeding), Grows(Ellipse), "Only stripes have a seeding"),
    read(
        Key::Option(OptionKey::Seeding),
        Condition::After(PLACED),
        "The marks of the layer beneath say where these grow",
    ),
    read(
        Key::Option(OptionKey::Seeding),
        NotTaken(OptionKey::Seeding),
        "This system begins from noise alone",
    ),
    read(
        Key::Option(OptionKey::Seeding),
        Condition::Option(OptionKey::Duty),
        "Stripes of any other duty than 0.5 (50 %) begin from noise alone",
    ),
    read(Key::Option(OptionKey::Duty), Driven, TONE_DECIDES),
    read(
        Key::Option(OptionKey::Duty),
        Grows(Ellipse),
        "Only stripes have a duty; spots are as far apart as they are drawn",
    ),
    read(Key::Option(OptionKey::Duty), NotTaken(OptionKey::Duty), NOT_TAKEN),
    grown(
        Key::Option(OptionKey::Duty),
        Condition::After(AROUND),
        "The marks of the layer beneath say how far apart rings and webs are",
    ),
    read(
        Key::Option(OptionKey::Duty),
        Condition::SystemWithout(Line, |system| system.free_spacing),
        "Meinhardt's stripes are as wide as their gaps; Meinhardt's lines and automatic grow thinner and wider ones",
    ),
    read(
        Key::Option(OptionKey::Duty),
        Condition::Option(OptionKey::Seeding),
        "Stripes that do not begin from noise are as wide as their gaps",
    ),
    read(
        Key::Option(OptionKey::Broken),
        Condition::After(&[After::Between, After::Net, After::Inside]),
        "Only rings can be broken",
    ),
    read(Key::Option(OptionKey::Keep), Driven, "The picture says where marks grow, and how large"),
    read(
        Key::Option(OptionKey::Keep),
        Condition::After(PLACED),
        "The marks of the layer beneath say where these grow",
    ),
    read(Key::Option(OptionKey::Keep), NotTaken(OptionKey::Keep), NOT_TAKEN),
    read(
        Key::Maps(&MapKey::OF_MARKS),
        Driven,
        "The picture says how large marks are, where, and in which direction",
    ),
    grown(
        Key::Maps(&MapKey::OF_MARKS),
        Condition::After(PLACED),
        "The marks of the layer beneath say where these grow, and in which size",
    ),
    read(
        Key::Maps(&[MapKey::Area, MapKey::Direction, MapKey::Aspect, MapKey::Duty]),
        Condition::Of(SystemChoice::Pairs(PairKind::Stucco)),
        "Blotches of stucco have no direction, and `options.decay` says how much they cover; their spacing can have a map",
    ),
    read(
        Key::Maps(&[MapKey::Direction, MapKey::Aspect, MapKey::Duty]),
        Condition::Of(SystemChoice::Points),
        "Of a field of points the spacing of the points can have a map, and the area of what is dark",
    ),
    read(
        Key::Maps(&[MapKey::Area]),
        WithoutChance,
        "Only labels that are random or by a picture have a probability that a map of the area could vary",
    ),
    read(
        Key::Maps(&MapKey::OF_MARKS),
        Condition::Of(SystemChoice::Growth),
        "Of Turing's growth the growth can have a map, and the colour",
    ),
    read(
        Key::Maps(&[MapKey::Spacing]),
        Condition::Of(SystemChoice::Areas(AreaKind::Cells)),
        "The distance of cells follows from their area, which can have a map, and from the width of the lines between them",
    ),
    read(
        Key::Maps(&[MapKey::Direction]),
        Condition::Of(SystemChoice::Lines(LineKind::Cracks)),
        "Cracks run in all directions; their spacing and duty can have maps",
    ),
    read(
        Key::Maps(&[MapKey::Growth]),
        Without(SystemChoice::Growth),
        "Only Turing's growth follows such a map: set \"system\" to \"turing-growth\"",
    ),
    read(Key::Maps(&[MapKey::Growth]), Driven, "The growth follows the tone of the picture"),
    read(
        Key::Maps(&[MapKey::Area, MapKey::Aspect]),
        Grows(Line),
        "Stripes have neither area nor aspect; their spacing and duty can have maps",
    ),
    read(
        Key::Maps(&[MapKey::Duty]),
        Grows(Ellipse),
        "Only stripes have a duty; area and spacing of spots can have maps",
    ),
    read(
        Key::Maps(&[MapKey::Spacing]),
        Condition::SystemWithout(Ellipse, |system| system.free_spacing),
        "The spacing of Turing's spots goes with their area, which can have a map",
    ),
    read(
        Key::Maps(&[MapKey::Duty]),
        Condition::SystemWithout(Line, |system| system.free_spacing),
        "Meinhardt's stripes are as wide as their gaps; Meinhardt's lines and automatic grow thinner and wider ones",
    ),
    read(
        Key::Maps(&[MapKey::Spacing]),
        Condition::Option(OptionKey::Irregular),
        "The spacing of irregular spots goes with their area, which can have a map",
    ),
    read(
        Key::Maps(&[MapKey::Duty]),
        Condition::Option(OptionKey::Seeding),
        "Stripes that do not begin from noise are as wide as their gaps",
    ),
    read(
        Key::Points,
        Without(SystemChoice::Points),
        "Only fields of points have this: set \"system\" to \"points\"",
    ),
    read(Key::Option(OptionKey::Ragged), Driven, DRIVEN_EDGES),
    read(Key::Option(OptionKey::Ragged), NotTaken(OptionKey::Ragged), NO_RAGGED),
    read(Key::Option(OptionKey::Detail), WithoutPoints, ONLY_POINTS),
    read(Key::Option(OptionKey::Gap), Without(SystemChoice::Areas(AreaKind::Cells)), ONLY_CELLS),
    read(
        Key::Option(OptionKey::Decay),
        Without(SystemChoice::Pairs(PairKind::Stucco)),
        "Only stucco has this option: set \"system\" to \"stucco\"",
    ),
    read(
        Key::Option(OptionKey::Over),
        Without(SystemChoice::Pairs(PairKind::Weave)),
        "Only threads of a weave lie over others: set \"system\" to \"weave\"",
    ),
];

impl Combination {
    /// What `layer` says, whose marks are of the kind `marks`.
    #[must_use]
    pub fn new(layer: &Layer, marks: Option<Kind>, beneath: Beneath) -> Self {
        let system = layer.areas().map_or(layer.system, SystemChoice::Areas);
        let driven = layer.tone.is_some();
        let (mapped, pointed) = (layer.maps.present(), layer.points.is_some());
        let by_chance = layer.point_field().is_some_and(|points| points.labels.are_by_chance());
        let (after, options) = (layer.after, layer.options);
        let holds = |kind| layer.strokes.iter().any(|stroke| stroke.kind() == Some(kind));
        let holds_both = holds(Ellipse) && holds(Line);
        Self { marks, holds_both, beneath, after, system, options, driven, pointed, by_chance, mapped }
    }

    /// What the layer grows: its system says so, or `after`, or its marks.
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
                Key::SystemGrowing(_) | Key::System(_) | Key::SystemOtherThan(_) | Key::SystemWithout(_)
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
        let about = |rule: &Rule| matches!(rule.key, Key::Maps(refused) if refused.contains(&key));
        RULES.iter().find(|rule| about(rule) && rule.condition.holds(self))
    }

    /// Whether the layer could hold marks of `kind`, as far as its system and its `after` say.
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

    /// The problem that a document has whose layer at `place` (such as `layers[0]`) breaks a rule that is checked on
    /// reading.
    #[must_use]
    pub fn problem_on_reading(&self, place: &str) -> Option<Problem> {
        let rule = RULES.iter().find(|rule| rule.on_reading && rule.refuses(self))?;
        Some(rule.problem(self, place))
    }

    /// The problem that a document has whose layer at `place` (such as `layers[0]`) breaks any rule.
    #[must_use]
    pub fn problem(&self, place: &str) -> Option<Problem> {
        Some(self.broken_rule()?.problem(self, place))
    }
}

impl Rule {
    /// Whether a layer breaks it.
    fn refuses(&self, layer: &Combination) -> bool {
        let has_value = match &self.key {
            Key::After(refused) => refused.contains(&layer.after),
            Key::SystemGrowing(kind) => layer.system.grows() == Some(*kind),
            Key::System(system) => layer.system == *system,
            Key::SystemOtherThan(system) => layer.system != *system,
            Key::SystemWithout(property) => !layer.system.allows(property),
            Key::Option(option) => option.is_set(&layer.options),
            Key::Tone => layer.driven,
            Key::Points => layer.pointed,
            Key::Maps(refused) => refused.iter().any(|key| layer.mapped[*key as usize]),
        };
        has_value && self.condition.holds(layer)
    }

    /// What is wrong with a layer that breaks it.
    fn problem(&self, layer: &Combination, place: &str) -> Problem {
        let (key, found, allowed) = match &self.key {
            Key::After(_) => {
                let allowed = After::NAMES.iter().filter(|(_, after)| layer.against_after(*after).is_none());
                ("after".to_owned(), format!("\"{}\"", layer.after.name()), listed(allowed))
            }
            Key::SystemGrowing(_) | Key::System(_) | Key::SystemOtherThan(_) | Key::SystemWithout(_) => {
                let allowed =
                    SystemChoice::NAMES.iter().filter(|(_, system)| layer.against_system(*system).is_none());
                ("system".to_owned(), format!("\"{}\"", layer.system.name()), listed(allowed))
            }
            Key::Option(option) => (
                format!("options.{}", option.name()),
                option.value(&layer.options),
                option.always_allowed().join(" or "),
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
            Self::Above(kind) => layer.beneath == Beneath::Grows(*kind),
            Self::AbovePairs => layer.beneath == Beneath::Pairs,
            Self::AboveAreas => layer.beneath == Beneath::Areas,
            Self::Without(system) => layer.system != *system,
            Self::WithoutPoints => !matches!(
                layer.system,
                SystemChoice::Areas(AreaKind::Patches) | SystemChoice::Lines(LineKind::Streaks)
            ),
            Self::Marks(kind) => layer.marks == Some(*kind),
            Self::BothKinds => layer.holds_both,
            Self::Grows(kind) => layer.grows() == Some(*kind),
            Self::After(after) => after.contains(&layer.after),
            Self::SystemWithout(kind, property) => {
                layer.system.grows() == Some(*kind) && !layer.system.allows(property)
            }
            Self::NotTaken(option) => {
                !layer.system.allows(|system| system.option_keys.contains(&option.name()))
            }
            Self::Option(other) => other.is_set(&layer.options),
            Self::Driven => layer.driven,
            Self::AboveTone => layer.beneath == Beneath::Tone,
            Self::Of(system) => layer.system == *system,
            Self::WithoutChance => layer.system == SystemChoice::Points && !layer.by_chance,
            Self::NotLowest => !matches!(layer.beneath, Beneath::Nothing | Beneath::Unknown),
        }
    }
}

/// The problem that the mark at `place` is of another kind than the `first` of its layer; `None` where it is of the same, and where
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

/// Puts back to its default whatever the rules refuse in `layer`, whose marks are of the kind `marks`: its system, its
/// options, its points, its maps. `after` stays.
pub fn tidy(layer: &mut Layer, marks: Option<Kind>) {
    if Combination::new(layer, marks, Beneath::Unknown).against_system(layer.system).is_some() {
        layer.system = SystemChoice::Auto;
    }
    layer.far_spacing = layer.far_spacing.filter(|_| marks == Some(Ellipse));
    for rule in &RULES {
        if !rule.refuses(&Combination::new(layer, marks, Beneath::Unknown)) {
            continue;
        }
        match rule.key {
            Key::Option(option) => option.reset(&mut layer.options),
            Key::Maps(refused) => refused.iter().for_each(|key| layer.maps.set(*key, None)),
            Key::Points => layer.points = None,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests;
