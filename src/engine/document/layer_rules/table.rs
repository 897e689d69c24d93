//! The table of rules: rules about kinds of layers, and rules that follow from the descriptions of systems.

use std::sync::LazyLock;

use super::Condition::{Above, Driven, Grows, Lowest, Marks, NotLowest, NotOwned, NotTaken, WithoutChance};
use super::{Beneath, Condition, Key, Rule};
use crate::attributes::system::{Description, Keys};
use crate::document::Kind::{Ellipse, Line};
use crate::document::systems::SYSTEMS;
use crate::document::{After, MapKey, OptionKey};

/// All rules, in the order in which they are checked.
pub static RULES: LazyLock<Vec<Rule>> = LazyLock::new(|| {
    let lists = [
        about_after(),
        about_systems(),
        about_options_of_spots(),
        about_options_of_stripes(),
        about_shapes_of_stripes(),
        about_drawn_marks(),
        about_maps(),
        owned("points").into_iter().collect(),
        about_edges(),
        OptionKey::ALL.iter().filter_map(|key| owned(&format!("options.{}", key.name()))).collect(),
    ];
    lists.into_iter().flatten().collect()
});

/// A rule that is checked when a document is read.
fn read(key: Key, condition: Condition, reason: &'static str) -> Rule {
    Rule { key, condition, reason, on_reading: true }
}

/// A rule that is checked when a document is checked or grown.
fn grown(key: Key, condition: Condition, reason: &'static str) -> Rule {
    Rule { key, condition, reason, on_reading: false }
}

const AROUND: &[After] = &[After::Around, After::Net];
const INSIDE: &[After] = &[After::Inside];
/// All that need a layer beneath.
const ABOVE: &[After] = &[After::Near, After::Around, After::Net, After::Inside];
const PLACED: &[After] = &[After::Around, After::Net, After::Inside];

/// Reason for options that are not in the list of a system.
const NOT_TAKEN: &str = "This system does not take this option";

/// Reason for options of layers that a picture drives.
const TONE_DECIDES: &str = "The tone of the picture determines the size of marks";

/// Reason for ragged edges of other marks.
const NO_RAGGED: &str =
    "Only patches, streaks, and the spots and stripes of reaction and diffusion have ragged edges";

/// Reason for ragged edges of layers that a picture drives.
const DRIVEN_EDGES: &str = "The edges of marks that a picture drives carry its details";

/// Rules about `after`, by the layer's marks and the layer beneath, and about keys that only the lowest layer has.
fn about_after() -> Vec<Rule> {
    vec![
        grown(
            Key::After(ABOVE),
            Lowest,
            "The lowest layer has no other beneath it whose marks it could meet",
        ),
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
            Above(Beneath::Grows(Line)),
            "A spot grows inside each spot beneath; the layer beneath grows stripes, rings or a web",
        ),
        grown(
            Key::After(PLACED),
            Above(Beneath::Pairs),
            "Rings, webs and spots inside need separate marks beneath; marks of pairs of morphogens touch each other",
        ),
        grown(
            Key::After(PLACED),
            Above(Beneath::Areas),
            "Rings, webs and spots inside need the spots of a reaction-diffusion system beneath; that layer is made from scattered points",
        ),
        grown(
            Key::After(PLACED),
            Above(Beneath::Tone),
            "Rings, webs and spots inside need marks of given sizes beneath; a picture gives the marks of that layer all sizes",
        ),
        grown(Key::Tone, NotLowest, "A picture needs the whole canvas, which only the lowest layer has"),
    ]
}

/// Rules for systems with certain marks and `after`; the reasons are in the descriptions of single systems.
fn about_systems() -> Vec<Rule> {
    let lowest_alone =
        SYSTEMS.iter().filter_map(|system| Some(grown(Key::System(system), NotLowest, system.lowest_alone?)));
    let lines_beside = SYSTEMS.iter().find_map(|system| system.lines_beside);
    let lines_beside = lines_beside.map(|reason| {
        read(Key::SystemLacking(|system| system.lines_beside.is_some()), Condition::BothKinds, reason)
    });
    let rules = [
        read(
            Key::SystemGrowing(Line),
            Marks(Ellipse),
            "This system grows stripes; this layer holds ellipses",
        ),
        read(Key::SystemGrowing(Ellipse), Marks(Line), "This system grows spots; this layer holds lines"),
    ];
    let by_property = [
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
    ];
    lowest_alone.chain(rules).chain(lines_beside).chain(by_property).collect()
}

/// The options of layers of spots.
fn about_options_of_spots() -> Vec<Rule> {
    vec![
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
    ]
}

/// The options of layers of stripes.
fn about_options_of_stripes() -> Vec<Rule> {
    vec![
        read(Key::Option(OptionKey::Seeding), Driven, "Stripes that a picture drives begin from noise"),
        read(Key::Option(OptionKey::Seeding), Grows(Ellipse), "Only stripes have a seeding"),
        read(
            Key::Option(OptionKey::Seeding),
            Condition::After(PLACED),
            "The marks of the layer beneath determine the places of these marks",
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
            "The marks of the layer beneath determine the distance of rings and webs",
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
    ]
}

/// The options of the shapes that stripes have along them.
fn about_shapes_of_stripes() -> Vec<Rule> {
    let rules = |key| {
        [
            read(Key::Option(key), Driven, TONE_DECIDES),
            read(
                Key::Option(key),
                Grows(Ellipse),
                "Only stripes vary in width along them, and open into two",
            ),
            read(Key::Option(key), NotTaken(key), NOT_TAKEN),
        ]
    };
    [OptionKey::Vary, OptionKey::Double].into_iter().flat_map(rules).collect()
}

/// Rules about options that concern the drawn marks.
fn about_drawn_marks() -> Vec<Rule> {
    vec![
        read(
            Key::Option(OptionKey::Broken),
            Condition::After(&[After::Between, After::Near, After::Net, After::Inside]),
            "Only rings can be broken",
        ),
        read(
            Key::Option(OptionKey::Near),
            Condition::After(&[After::Between, After::Around, After::Net, After::Inside]),
            "Only marks near those beneath become rarer with the distance from them",
        ),
        read(Key::Option(OptionKey::Keep), Driven, "The picture determines the places and sizes of marks"),
        read(
            Key::Option(OptionKey::Keep),
            Condition::After(PLACED),
            "The marks of the layer beneath determine the places of these marks",
        ),
        read(Key::Option(OptionKey::Keep), NotTaken(OptionKey::Keep), NOT_TAKEN),
    ]
}

/// Rules about maps, including the maps that single systems refuse or own.
fn about_maps() -> Vec<Rule> {
    let mut rules = vec![
        read(
            Key::Maps(MapKey::OF_MARKS.to_vec()),
            Driven,
            "The picture determines the size, place and direction of marks",
        ),
        grown(
            Key::Maps(MapKey::OF_MARKS.to_vec()),
            Condition::After(PLACED),
            "The marks of the layer beneath determine the places and sizes of these marks",
        ),
    ];
    rules.extend(SYSTEMS.iter().flat_map(|system| refused(system)));
    rules.push(read(
        Key::Maps(vec![MapKey::Area]),
        WithoutChance,
        "Only labels that are random or by a picture have a probability that a map of the area could vary",
    ));
    rules.extend(MapKey::ALL.iter().filter_map(|key| owned(&format!("maps.{}", key.name()))));
    rules.extend(about_maps_of_marks());
    rules
}

/// Rules about maps that do not go with the marks that the layer grows.
fn about_maps_of_marks() -> [Rule; 7] {
    [
        read(Key::Maps(vec![MapKey::Growth]), Driven, "The growth follows the tone of the picture"),
        read(
            Key::Maps(vec![MapKey::Area, MapKey::Aspect]),
            Grows(Line),
            "Stripes have neither area nor aspect; their spacing and duty can have maps",
        ),
        read(
            Key::Maps(vec![MapKey::Duty]),
            Grows(Ellipse),
            "Only stripes have a duty; area and spacing of spots can have maps",
        ),
        read(
            Key::Maps(vec![MapKey::Spacing]),
            Condition::SystemWithout(Ellipse, |system| system.free_spacing),
            "The spacing of Turing's spots follows from their area, which can have a map",
        ),
        read(
            Key::Maps(vec![MapKey::Duty]),
            Condition::SystemWithout(Line, |system| system.free_spacing),
            "Meinhardt's stripes are as wide as their gaps; Meinhardt's lines and automatic grow thinner and wider ones",
        ),
        read(
            Key::Maps(vec![MapKey::Spacing]),
            Condition::Option(OptionKey::Irregular),
            "The spacing of irregular spots follows from their area, which can have a map",
        ),
        read(
            Key::Maps(vec![MapKey::Duty]),
            Condition::Option(OptionKey::Seeding),
            "Stripes that do not begin from noise are as wide as their gaps",
        ),
    ]
}

/// Rules for the keys that `system` refuses.
fn refused(system: &'static Description) -> impl Iterator<Item = Rule> {
    let rules = move |refused: &'static Keys| {
        let keys = Key::all_of(refused.keys).into_iter();
        keys.map(move |key| read(key, Condition::Of(system), refused.reason))
    };
    system.refused_keys.iter().flat_map(rules)
}

/// The rule for the key of this name, if only some systems own it.
fn owned(name: &str) -> Option<Rule> {
    let mut own = SYSTEMS.iter().flat_map(|system| system.own_keys);
    let (name, reason) =
        own.find_map(|own| Some((*own.keys.iter().find(|key| **key == name)?, own.reason)))?;
    Some(read(Key::named(name)?, NotOwned(name), reason))
}

/// Rules about ragged edges.
fn about_edges() -> Vec<Rule> {
    vec![
        read(Key::Option(OptionKey::Ragged), Driven, DRIVEN_EDGES),
        read(Key::Option(OptionKey::Ragged), NotTaken(OptionKey::Ragged), NO_RAGGED),
    ]
}

impl Key {
    /// The key of this name, such as `options.gap`, `maps.area`, `points` or `tone`.
    fn named(name: &str) -> Option<Self> {
        let option = |name| OptionKey::ALL.into_iter().find(|key| key.name() == name).map(Self::Option);
        let map =
            |name| MapKey::ALL.into_iter().find(|key| key.name() == name).map(|key| Self::Maps(vec![key]));
        match name.split_once('.') {
            Some(("options", name)) => option(name),
            Some(("maps", name)) => map(name),
            None if name == "points" => Some(Self::Points),
            None if name == "tone" => Some(Self::Tone),
            _ => None,
        }
    }

    /// The keys of these names; all maps together are one key.
    fn all_of(names: &[&str]) -> Vec<Self> {
        let (mut maps, mut keys) = (Vec::new(), Vec::new());
        for key in names.iter().filter_map(|name| Self::named(name)) {
            match key {
                Self::Maps(named) => maps.extend(named),
                key => keys.push(key),
            }
        }
        keys.extend((!maps.is_empty()).then_some(Self::Maps(maps)));
        keys
    }
}
