//! The keys of a layer's `options`: one table for the reader, the writer, the rules and the window.

use serde_json::{Map, Value, json};

use crate::attributes::Spread;
use crate::document::choices::{SEEDINGS, name_in, names};
use crate::document::limits::{self, Range};
use crate::document::node::{Node, number};
use crate::document::shape::{Key, Object, Shape};
use crate::document::{DrawnOr, LayerOptions, Over, Problem, Seeding, SpreadChoice};
use crate::points::rosettes::Rosettes;

/// One key of a layer's `options`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptionKey {
    /// Random differences between spots.
    Spread,
    /// Irregularity of the shapes of spots.
    Irregular,
    /// Width of the stripes ÷ their period.
    Duty,
    /// Initial state of stripes.
    Seeding,
    /// The share of each ring that is open.
    Broken,
    /// The distance at which marks near those beneath become rare.
    Near,
    /// Whether the drawn marks are among those that grow.
    Keep,
    /// How much the width of stripes varies along them.
    Vary,
    /// The share of stripes that open into two.
    Double,
    /// Raggedness of edges.
    Ragged,
    /// Points a patch or a streak.
    Detail,
    /// Width of the lines between cells.
    Gap,
    /// What patches are as rosettes.
    Rosette,
    /// Decrease of the gain of stucco.
    Decay,
    /// Rule that tells which threads lie over the others.
    Over,
}

/// One option in a document.
struct Entry {
    /// Its key.
    name: &'static str,
    /// The values that every layer allows, as JSON.
    always_allowed: &'static [&'static str],
    read: fn(&Node, &mut LayerOptions) -> Result<(), Problem>,
    /// Its value, as JSON.
    json: fn(&LayerOptions) -> Value,
    /// Puts it back to its default.
    reset: fn(&mut LayerOptions),
}

/// The entry of the field `$name`, which has the name of its key.
macro_rules! entry {
    ($name:ident, $always_allowed:expr, $read:expr, $json:expr) => {
        Entry {
            name: stringify!($name),
            always_allowed: $always_allowed,
            read: |node, options| {
                options.$name = $read(node)?;
                Ok(())
            },
            json: |options| $json(options.$name),
            reset: |options| options.$name = LayerOptions::default().$name,
        }
    };
}

impl OptionKey {
    /// All keys, in the order in which they are shown, checked and written.
    pub const ALL: [Self; 15] = [
        Self::Spread,
        Self::Irregular,
        Self::Duty,
        Self::Seeding,
        Self::Broken,
        Self::Near,
        Self::Keep,
        Self::Vary,
        Self::Double,
        Self::Ragged,
        Self::Detail,
        Self::Gap,
        Self::Rosette,
        Self::Decay,
        Self::Over,
    ];

    fn entry(self) -> Entry {
        type Read<'a, 'b> = &'a Node<'b>;
        match self {
            Self::Spread => entry!(spread, &["\"drawn\""], spread, spread_json),
            Self::Irregular => {
                entry!(irregular, &["0"], |node: Read| node.number(&limits::IRREGULAR), number)
            }
            Self::Duty => {
                entry!(duty, &["\"drawn\"", "0.5"], |node| drawn_or(node, &limits::DUTY), given_json)
            }
            Self::Seeding => {
                entry!(seeding, &["\"noise\""], |node: Read| node.choice(&SEEDINGS), seeding_json)
            }
            Self::Broken => entry!(broken, &["0"], |node: Read| node.number(&limits::BROKEN), number),
            Self::Near => entry!(near, &["24"], |node: Read| node.number(&limits::NEAR), number),
            Self::Keep => entry!(keep, &["false"], |node: Read| node.flag().map(Some), |keep| json!(keep)),
            Self::Vary => entry!(vary, &["0"], |node: Read| node.number(&limits::VARY), number),
            Self::Double => entry!(double, &["0"], |node: Read| node.number(&limits::DOUBLE), number),
            Self::Ragged => {
                entry!(ragged, &["\"drawn\""], |node| drawn_or(node, &limits::RAGGED), given_json)
            }
            Self::Detail => entry!(detail, &["24"], |node: Read| node.number(&limits::DETAIL), number),
            Self::Gap => entry!(gap, &["\"drawn\""], |node| drawn_or(node, &limits::GAP), given_json),
            Self::Rosette => entry!(rosette, &[], |node| rosette(node).map(Some), rosette_json),
            Self::Decay => entry!(decay, &["0.8"], |node: Read| node.number(&limits::DECAY), number),
            Self::Over => entry!(over, &["\"level\""], |node: Read| node.choice(&Over::NAMES), over_json),
        }
    }

    /// The key in a document.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The values that every layer allows, as JSON.
    #[must_use]
    pub fn always_allowed(self) -> &'static [&'static str] {
        self.entry().always_allowed
    }

    /// Whether `options` give this key a value that not every layer allows.
    #[must_use]
    pub fn is_set(self, options: &LayerOptions) -> bool {
        !self.is_default(options)
            && !self.always_allowed().contains(&(self.entry().json)(options).to_string().as_str())
    }

    /// Whether `options` hold exactly the default of this key.
    #[must_use]
    pub fn is_default(self, options: &LayerOptions) -> bool {
        let json = self.entry().json;
        json(options) == json(&LayerOptions::default())
    }

    /// Puts this key back to its default.
    pub fn reset(self, options: &mut LayerOptions) {
        (self.entry().reset)(options);
    }

    /// The value in `options`, as it stands in a message.
    #[must_use]
    pub fn value(self, options: &LayerOptions) -> String {
        match ((self.entry().json)(options), options.spread) {
            (Value::Null, _) => "nothing".to_owned(),
            (Value::Object(_), SpreadChoice::Given(spread)) if self == Self::Spread => {
                let parts = spread.named().map(|(name, value)| format!("{name} {value}"));
                format!("a spread of {}", parts.join(", "))
            }
            (value, _) => value.to_string(),
        }
    }
}

const DRAWN: Shape = Shape::Choice(|| vec!["drawn"]);

pub(super) static OPTIONS: Object = Object {
    name: "Options",
    keys: &[
        Key::new(
            "spread",
            Shape::AnyOf(&[DRAWN, Shape::Number(limits::SPREAD_AREA), Shape::Object(&SPREAD)]),
            "\"drawn\"",
            "how much spots vary: as the drawn ones of their region (at least six), by this much in area, or by numbers",
        ),
        Key::new(
            "irregular",
            Shape::Number(limits::IRREGULAR),
            "0",
            "how irregular the shapes of spots are: 0 grows ellipses, 1 beans, bars and drops",
        ),
        Key::new(
            "duty",
            Shape::AnyOf(&[DRAWN, Shape::Number(limits::DUTY)]),
            "\"drawn\"",
            "width ÷ period of stripes: that of the drawn lines that lie side by side, with regions of those of each (0.5 where none do; of streaks 0.4, of cracks 0.1), or this",
        ),
        Key::new(
            "seeding",
            Shape::Choice(|| names(&SEEDINGS)),
            "\"noise\"",
            "what stripes begin from: noise of their direction, short segments, the drawn lines alone",
        ),
        Key::new("broken", Shape::Number(limits::BROKEN), "0", "the share of each ring that is open"),
        Key::new(
            "near",
            Shape::Number(limits::NEAR),
            "24",
            "the distance from the marks beneath at which marks near them are 1/e as frequent as beside them",
        ),
        Key::new(
            "keep",
            Shape::Flag,
            Key::NONE,
            "whether the drawn marks are among those that grow; without it they are where there are no regions or one, and `irregular` is 0; marks on a model are kept unless it is false",
        ),
        Key::new(
            "vary",
            Shape::Number(limits::VARY),
            "0",
            "how much the width of stripes varies along them, standard deviation ÷ mean: they swell, taper, and above 0.4 end in points. The covered area stays",
        ),
        Key::new(
            "double",
            Shape::Number(limits::DOUBLE),
            "0",
            "the share of the stripes that open into two, as on a tiger. The covered area stays",
        ),
        Key::new(
            "ragged",
            Shape::AnyOf(&[DRAWN, Shape::Number(limits::RAGGED)]),
            "\"drawn\"",
            "how ragged the edges of patches, spots and stripes are: of patches as the drawn outlines (ellipses are smooth), of spots and stripes as they grow, or by this σ: the standard deviation of the logarithm of the distance by which patches claim their points, and on spots and stripes what adds as much to the raggedness",
        ),
        Key::new(
            "detail",
            Shape::Number(limits::DETAIL),
            "24",
            "points from which a patch is made, at least: the more, the finer its fringes; of streaks the points along one, at most: the more, the longer it is",
        ),
        Key::new(
            "gap",
            Shape::AnyOf(&[DRAWN, Shape::Number(limits::GAP)]),
            "\"drawn\"",
            "width of the lines between cells: the mean of the lines drawn beside the ellipses, else that of the gaps between drawn outlines that nearly touch (0.2 of √area of the smallest where none do); or this",
        ),
        Key::new(
            "rosette",
            Shape::Object(&ROSETTE),
            Key::NONE,
            "patches become rosettes: their rims break up into blotches, their centres are tinted. Areas, spacings and raggedness are those of the whole rosettes; `{}` has the defaults below",
        ),
        Key::new(
            "decay",
            Shape::Number(limits::DECAY),
            "0.8",
            "how far the gain of stucco falls, 1 − the last ÷ the first: the more, the fewer worms beside dots",
        ),
        Key::new(
            "over",
            Shape::Choice(|| names(&Over::NAMES)),
            "\"level\"",
            "which threads of a weave lie over the others where they cross: none; one over and one under; two over and one or two under; random",
        ),
    ],
};

static SPREAD: Object = Object {
    name: "Spread",
    keys: &[
        Key::new("area", Shape::Number(limits::SPREAD_AREA), "0", "coefficient of variation"),
        Key::new("angle", Shape::Number(limits::SPREAD_ANGLE), "0", "root mean square deviation"),
        Key::new("aspect", Shape::Number(limits::SPREAD_ASPECT), "0", "standard deviation"),
        Key::new("spacing", Shape::Number(limits::SPREAD_SPACING), "0", "coefficient of variation"),
    ],
};

static ROSETTE: Object = Object {
    name: "Rosette",
    keys: &[
        Key::new(
            "parts",
            Shape::Wholes(&[limits::ROSETTE_PARTS; 2]),
            "[3, 5]",
            "the least and the greatest number of blotches around a rosette, 1 to 12 each",
        ),
        Key::new(
            "solid",
            Shape::Number(limits::ROSETTE_SOLID),
            "0.25",
            "the share of the patches that stay solid, small ones rather than large ones",
        ),
        Key::new(
            "width",
            Shape::Number(limits::ROSETTE_WIDTH),
            Key::NONE,
            "how deep blotches are; without it 0.22 of √area of a mean patch",
        ),
        Key::new(
            "dots",
            Shape::Whole(limits::ROSETTE_DOTS),
            "0",
            "the greatest number of dots inside a rosette; each has at least one, unless it is 0",
        ),
        Key::new(
            "tint",
            Shape::Number(limits::ROSETTE_TINT),
            "0.3",
            "the pattern inside a rosette, which the colours show: 0 is that of the ground, 0.5 that of an edge. Each rosette has 0.45 to 1 times this",
        ),
    ],
};

/// The options in an object of a document.
pub(super) fn read(node: &Node) -> Result<LayerOptions, Problem> {
    node.is(&OPTIONS)?;
    let mut options = LayerOptions::default();
    for key in OptionKey::ALL {
        if let Some(value) = node.get(key.name()) {
            (key.entry().read)(&value, &mut options)?;
        }
    }
    Ok(options)
}

/// The options that are not at their defaults, as an object of a document.
pub(super) fn written(options: &LayerOptions) -> Value {
    let given = OptionKey::ALL.into_iter().filter(|key| !key.is_default(options));
    let named = given.map(|key| (key.name().to_owned(), (key.entry().json)(options)));
    Value::Object(named.collect())
}

/// `"drawn"`, or a number.
fn drawn_or(node: &Node, range: &Range) -> Result<DrawnOr<f64>, Problem> {
    let allowed = format!("\"drawn\", or {range}");
    if node.text(&allowed) == Ok("drawn") {
        return Ok(DrawnOr::Drawn);
    }
    node.number(range).map(DrawnOr::Given).map_err(|_| node.wrong(allowed))
}

fn given_json(choice: DrawnOr<f64>) -> Value {
    choice.given().map_or(json!("drawn"), number)
}

fn seeding_json(seeding: Seeding) -> Value {
    json!(name_in(&SEEDINGS, seeding))
}

fn over_json(over: Over) -> Value {
    json!(name_in(&Over::NAMES, over))
}

/// `"drawn"`, the variation of the area, or an object.
fn spread(node: &Node) -> Result<SpreadChoice, Problem> {
    if node.is_object() {
        node.is(&SPREAD)?;
        let number = |key: &str, range| node.get(key).map_or(Ok(0.0), |node| node.number(range));
        return Ok(SpreadChoice::Given(Spread {
            area: number("area", &limits::SPREAD_AREA)?,
            angle: number("angle", &limits::SPREAD_ANGLE)?,
            aspect: number("aspect", &limits::SPREAD_ASPECT)?,
            spacing: number("spacing", &limits::SPREAD_SPACING)?,
        }));
    }
    let allowed = format!(
        "\"drawn\", {} (the areas' coefficient of variation), or an object with area, angle, aspect, spacing",
        limits::SPREAD_AREA
    );
    if node.text(&allowed) == Ok("drawn") {
        return Ok(SpreadChoice::Drawn);
    }
    match node.number(&limits::SPREAD_AREA) {
        Ok(area) => Ok(SpreadChoice::Given(Spread { area, ..Spread::ZERO })),
        Err(_) => Err(node.wrong(allowed)),
    }
}

fn spread_json(choice: SpreadChoice) -> Value {
    let Some(spread) = choice.given() else { return json!("drawn") };
    let named = spread.named().map(|(attribute, value)| (attribute.name().to_owned(), number(value)));
    Value::Object(Map::from_iter(named))
}

fn rosette(node: &Node) -> Result<Rosettes, Problem> {
    node.is(&ROSETTE)?;
    let usual = Rosettes::default();
    let number = |key: &str, range, usual| node.get(key).map_or(Ok(usual), |node| node.number(range));
    let [_, most] = limits::ROSETTE_PARTS;
    let mut parts = usual.parts;
    if let Some(node) = node.get("parts") {
        parts = node.counts([most as u32; 2])?;
        if parts[0] > parts[1] {
            return Err(node.wrong("the smaller number first"));
        }
    }
    let [fewest, most] = limits::ROSETTE_DOTS;
    // The casts are exact: the numbers are small.
    let dots = node.get("dots").map_or(Ok(u64::from(usual.dots)), |node| node.whole(fewest, most))? as u32;
    let width = node.get("width").map(|node| node.number(&limits::ROSETTE_WIDTH)).transpose()?;
    Ok(Rosettes {
        parts,
        solid: number("solid", &limits::ROSETTE_SOLID, usual.solid)?,
        width,
        dots,
        tint: number("tint", &limits::ROSETTE_TINT, usual.tint)?,
    })
}

/// What differs from the defaults.
fn rosette_json(choice: Option<Rosettes>) -> Value {
    let Some(of) = choice else { return Value::Null };
    let usual = Rosettes::default();
    let named = [("solid", of.solid, usual.solid), ("tint", of.tint, usual.tint)];
    let mut given: Map<String, Value> = Map::new();
    if of.parts != usual.parts {
        given.insert("parts".to_owned(), json!(of.parts));
    }
    given.extend(of.width.map(|width| ("width".to_owned(), number(width))));
    if of.dots != usual.dots {
        given.insert("dots".to_owned(), json!(of.dots));
    }
    let changed = named.into_iter().filter(|(_, value, usual)| value != usual);
    given.extend(changed.map(|(name, value, _)| (name.to_owned(), number(value))));
    Value::Object(given)
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
        assert_eq!(OptionKey::Near.always_allowed(), [options.near.to_string()]);
        assert_eq!(OptionKey::Detail.always_allowed(), [options.detail.to_string()]);
        assert_eq!(OptionKey::Decay.always_allowed(), [options.decay.to_string()]);
    }

    #[test]
    fn a_reset_touches_one_key() {
        let mut options = LayerOptions {
            duty: DrawnOr::Given(0.3),
            irregular: 0.5,
            keep: Some(false),
            ..LayerOptions::default()
        };
        OptionKey::Duty.reset(&mut options);
        assert!(OptionKey::Duty.is_default(&options));
        assert!(OptionKey::Irregular.is_set(&options) && !OptionKey::Keep.is_default(&options));
    }
}
