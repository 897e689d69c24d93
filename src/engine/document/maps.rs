//! Pictures and noise that vary the attributes of a layer over the canvas (`"maps"`).

use crate::document::Problem;
use crate::document::limits::{self, Range};
use crate::document::node::Node;
use crate::document::shape::{Key, Object, Shape};
use crate::document::tone::{self, ToneImage};

/// The attribute that a map varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapKey {
    /// The area of spots, px².
    Area,
    /// The distance of spots or the period of stripes, px; the width of stripes changes with their period.
    Spacing,
    /// The direction, degrees.
    Direction,
    /// Minor ÷ major radius of spots.
    Aspect,
    /// Width ÷ period of stripes.
    Duty,
    /// The place in the gradient of the layer's colours.
    Colour,
    /// The parameter G of Turing's growth.
    Growth,
    /// The share of the second colour of the ground.
    Ground,
}

impl MapKey {
    /// All keys, in the order in which documents write them.
    pub const ALL: [Self; 8] = [
        Self::Area,
        Self::Spacing,
        Self::Direction,
        Self::Aspect,
        Self::Duty,
        Self::Colour,
        Self::Growth,
        Self::Ground,
    ];
    /// The keys for attributes of marks.
    pub const OF_MARKS: [Self; 5] = [Self::Area, Self::Spacing, Self::Direction, Self::Aspect, Self::Duty];

    /// Its name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Spacing => "spacing",
            Self::Direction => "direction",
            Self::Aspect => "aspect",
            Self::Duty => "duty",
            Self::Colour => "colour",
            Self::Growth => "growth",
            Self::Ground => "ground",
        }
    }

    /// Whether it changes colours only, not what grows.
    #[must_use]
    pub fn is_painted(self) -> bool {
        matches!(self, Self::Colour | Self::Ground)
    }

    /// The unit of its values; empty for ratios.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Area => "px²",
            Self::Spacing => "px",
            Self::Direction => "degrees",
            Self::Aspect | Self::Duty | Self::Colour | Self::Growth | Self::Ground => "",
        }
    }

    /// The way in which a map of this key changes values; `factor` tells whether the map is a factor.
    #[must_use]
    pub fn change(self, factor: bool) -> MapChange {
        match (self, factor) {
            (Self::Ground, _) => MapChange::Replace,
            (Self::Direction, true) | (Self::Colour, false) => MapChange::Add,
            (_, true) => MapChange::Multiply,
            (_, false) => MapChange::Replace,
        }
    }

    /// A range with a clearly visible effect.
    #[must_use]
    pub fn usual(self, change: MapChange) -> [f64; 2] {
        match (self, change) {
            (Self::Direction, MapChange::Replace) => [0.0, 90.0],
            (Self::Direction, _) => [-25.0, 25.0],
            (Self::Ground, _) => [-1.0, 1.5],
            (Self::Colour, MapChange::Add | MapChange::Replace) => [-0.25, 0.25],
            (Self::Area, MapChange::Replace) => [150.0, 600.0],
            (Self::Spacing, MapChange::Replace) => [25.0, 50.0],
            (Self::Aspect, MapChange::Replace) => [0.4, 1.0],
            (Self::Duty, MapChange::Replace) => [0.25, 0.6],
            (Self::Growth, MapChange::Replace) => [18.3, 27.3],
            (Self::Growth, MapChange::Multiply | MapChange::Add) => [0.85, 1.2],
            (Self::Area, MapChange::Multiply | MapChange::Add) => [0.5, 1.6],
            (_, MapChange::Multiply | MapChange::Add) => [0.7, 1.3],
        }
    }

    /// The values that are allowed for the two numbers of `range`.
    #[must_use]
    pub fn allowed(self, change: MapChange) -> Range {
        match (self, change) {
            (Self::Direction, _) => limits::MAP_DIRECTION,
            (Self::Ground, _) => limits::MAP_SHARE,
            (Self::Colour, MapChange::Add | MapChange::Replace) => limits::MAP_SHIFT,
            (_, MapChange::Multiply) => limits::MAP_FACTOR,
            (Self::Area, _) => limits::MAP_AREA,
            (Self::Spacing, _) => limits::MAP_SPACING,
            (Self::Aspect, _) => limits::MAP_ASPECT,
            (Self::Duty, _) => limits::DUTY,
            (Self::Growth, _) => limits::MAP_GROWTH,
        }
    }
}

/// The way in which a map changes the value of the sketch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapChange {
    /// The value of the map replaces it.
    Replace,
    /// The attribute is multiplied by the value.
    Multiply,
    /// The value is added to the attribute.
    Add,
}

/// One map of a layer.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerMap {
    /// Source of its values.
    pub source: MapSource,
    /// The values at black and at white, or at the lowest and the highest of the noise: see [`MapKey::allowed`].
    pub range: [f64; 2],
}

/// Source of the values of a map.
#[derive(Clone, Debug, PartialEq)]
pub enum MapSource {
    /// A picture, stretched over the canvas.
    Image {
        /// Each px as it is stored: 0 = black, 255 = white.
        image: ToneImage,
        /// Whether the map multiplies the values of the sketch instead of replacing them. For directions it adds to them; for
        /// colours it tells whether places in the gradient are multiplied or shifted.
        factor: bool,
    },
    /// Noise: it multiplies values, but is added to directions and to places of colours, and is itself the share of a colour.
    Noise {
        /// Distance from a light place to the next dark one, px: [`limits::MAP_SIZE`].
        size: f64,
        /// Octaves, 1–[`limits::MAP_OCTAVES`]: each of half the size and half the weight of the one before it.
        octaves: u32,
    },
}

impl LayerMap {
    /// The octaves of a noise for which the document gives no number: the second octave breaks up the round shapes of the first.
    pub const OCTAVES: u32 = 2;

    /// Size of a new noise, px: several times the distance of marks in a usual sketch.
    const SIZE: f64 = 140.0;

    /// A new noise that varies `key`.
    #[must_use]
    pub fn noise(key: MapKey) -> Self {
        let source = MapSource::Noise { size: Self::SIZE, octaves: Self::OCTAVES };
        let map = Self { source, range: [0.0; 2] };
        Self { range: key.usual(map.change(key)), ..map }
    }

    /// A new map by which a picture changes the values of the sketch; colours are shifted.
    #[must_use]
    pub fn picture(key: MapKey, image: ToneImage) -> Self {
        let factor = !matches!(key, MapKey::Colour | MapKey::Ground);
        let map = Self { source: MapSource::Image { image, factor }, range: [0.0; 2] };
        Self { range: key.usual(map.change(key)), ..map }
    }

    /// The way in which the map changes the values of `key`.
    #[must_use]
    pub fn change(&self, key: MapKey) -> MapChange {
        match self.source {
            MapSource::Image { factor, .. } => key.change(factor),
            MapSource::Noise { .. } => key.change(key != MapKey::Colour),
        }
    }
}

/// The maps of a layer, at most one of each attribute.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LayerMaps([Option<LayerMap>; MapKey::ALL.len()]);

impl LayerMaps {
    /// The map of `key`.
    #[must_use]
    pub fn get(&self, key: MapKey) -> Option<&LayerMap> {
        self.0[key as usize].as_ref()
    }

    /// Sets or removes the map of `key`.
    pub fn set(&mut self, key: MapKey, map: Option<LayerMap>) {
        self.0[key as usize] = map;
    }

    /// The maps that are set.
    pub fn iter(&self) -> impl Iterator<Item = (MapKey, &LayerMap)> {
        MapKey::ALL.into_iter().zip(&self.0).filter_map(|(key, map)| Some((key, map.as_ref()?)))
    }

    /// Whether no map is set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(Option::is_none)
    }

    /// The maps that change what grows, not only the colours.
    pub fn growing(&self) -> impl Iterator<Item = (MapKey, &LayerMap)> {
        self.iter().filter(|(key, _)| !key.is_painted())
    }

    /// Whether one of the maps influences the growth.
    #[must_use]
    pub fn change_growth(&self) -> bool {
        self.growing().next().is_some()
    }

    /// For each attribute, whether it has a map, in the order of [`MapKey::ALL`].
    #[must_use]
    pub fn present(&self) -> [bool; MapKey::ALL.len()] {
        MapKey::ALL.map(|key| self.get(key).is_some())
    }
}

/// A map of any key. The values that one key allows are those of [`MapKey::allowed`]: a part of these.
const ANY_MAP: Shape = Shape::AnyOf(&[Shape::Object(&MAP), Shape::Object(&OF_NOISE)]);
const VALUES: Shape =
    Shape::Numbers(&[Range { low: limits::MAP_DIRECTION.low, high: limits::MAP_AREA.high, unit: "" }; 2]);

pub(super) static MAPS: Object = Object {
    name: "Maps",
    keys: &[
        Key::new(
            "area",
            ANY_MAP,
            Key::NONE,
            "the area of spots, px²: 1 to 10⁸. Where nothing says how far apart spots are, their spacing goes with √area. Of a field of points the probability of dark points goes with it",
        ),
        Key::new(
            "spacing",
            ANY_MAP,
            Key::NONE,
            "the spacing of spots; the period of stripes and threads, whose width goes with it; the distance of points, px: 1 to 10,000",
        ),
        Key::new(
            "direction",
            ANY_MAP,
            Key::NONE,
            "the direction, degrees: −720 to 720; of a weave or a maze that of the threads drawn first, to which the others keep their angle",
        ),
        Key::new("aspect", ANY_MAP, Key::NONE, "the aspect of spots: 0.2 to 1"),
        Key::new(
            "duty",
            ANY_MAP,
            Key::NONE,
            "width ÷ period of stripes and threads, whose period stays: 0.18 to 0.82",
        ),
        Key::new(
            "colour",
            ANY_MAP,
            Key::NONE,
            "the place in the gradient of `colours` at which a pattern value is painted: the ends of ground (0) and marks (1) are shifted by −0.5 to 0.5, and less towards the edge (0.5), which stays",
        ),
        Key::new(
            "growth",
            ANY_MAP,
            Key::NONE,
            "the growth of `\"system\": \"turing-growth\"`: 17.5 (dots) to 27.5 (holes); 22 (worms) without a map",
        ),
        Key::new(
            "ground",
            ANY_MAP,
            Key::NONE,
            "the share of the second colour of the ground, `colours.ground`, in the first one: −5 to 5, of which less than 0 counts as 0 and more than 1 as 1. Marks keep their colours",
        ),
    ],
};

static MAP: Object = Object {
    name: "Map",
    keys: &[
        Key::new("image", Shape::Object(&tone::IMAGE), Key::REQUIRED, "the picture, as that of a tone"),
        Key::new(
            "range",
            VALUES,
            Key::REQUIRED,
            "the values where it is black, and where it is white, in place of what the sketch asks for",
        ),
        Key::new(
            "factor",
            Shape::Flag,
            "false",
            "whether what the sketch asks for is multiplied instead, by 0.1 to 10. Directions are turned by −720 to 720 degrees. Of places in the gradient, which are shifted otherwise, the distance from the edge (0.5) is multiplied. Not of `ground`",
        ),
    ],
};

static OF_NOISE: Object = Object {
    name: "Map of noise",
    keys: &[Key::new(
        "noise",
        Shape::Object(&NOISE),
        Key::REQUIRED,
        "random values at scattered points, interpolated",
    )],
};

static NOISE: Object = Object {
    name: "Map noise",
    keys: &[
        Key::new(
            "size",
            Shape::Number(limits::MAP_SIZE),
            Key::REQUIRED,
            "the distance from a light place to the next dark one; less than 1/64 of the longer side of the canvas counts as that",
        ),
        Key::new(
            "octaves",
            Shape::Whole([1, limits::MAP_OCTAVES as u64]),
            "2",
            "how many noises are added, each of half the size and half the weight of the one before it",
        ),
        Key::new(
            "range",
            Shape::Numbers(&[limits::MAP_DIRECTION; 2]),
            Key::REQUIRED,
            "the values at the lowest and the highest: factors 0.1 to 10, turns −720 to 720 degrees, shifts −0.5 to 0.5, shares of `ground` −5 to 5",
        ),
    ],
};

/// Reads the maps of a layer.
pub(super) fn read(node: &Node) -> Result<LayerMaps, Problem> {
    node.is(&MAPS)?;
    let mut maps = LayerMaps::default();
    for key in MapKey::ALL {
        maps.set(key, node.get(key.name()).map(|node| map(&node, key)).transpose()?);
    }
    Ok(maps)
}

/// The remedy for a picture in another form.
const REMEDY: &str = "dapple grow --map embeds any picture so";

fn map(node: &Node, key: MapKey) -> Result<LayerMap, Problem> {
    const ALLOWED: &str = "an object {\"image\": …, \"range\": […]} or {\"noise\": …}, not both";
    if let Some(noise) = node.get("noise") {
        node.is(&OF_NOISE).map_err(|problem| Problem { allowed: ALLOWED.to_owned(), ..problem })?;
        noise.is(&NOISE)?;
        let size = noise.need("size", &limits::MAP_SIZE.to_string())?.number(&limits::MAP_SIZE)?;
        let octaves = noise
            .get("octaves")
            .map_or(Ok(LayerMap::OCTAVES.into()), |node| node.whole(1, limits::MAP_OCTAVES.into()))?;
        // The cast is exact: there are at most eight octaves.
        let map = LayerMap { source: MapSource::Noise { size, octaves: octaves as u32 }, range: [0.0; 2] };
        return ranged(&noise, key, map);
    }
    node.is(&MAP)?;
    let image = node.get("image").ok_or_else(|| node.found("no key \"image\"", ALLOWED))?;
    let image = tone::image(&image, REMEDY)?;
    let factor = match node.get("factor") {
        Some(node) if key == MapKey::Ground => {
            return Err(
                node.found("a factor of the ground", "none: the map is the share of the second colour")
            );
        }
        Some(node) => node.flag()?,
        None => false,
    };
    ranged(node, key, LayerMap { source: MapSource::Image { image, factor }, range: [0.0; 2] })
}

/// Returns `map` with the range in `node`.
fn ranged(node: &Node, key: MapKey, map: LayerMap) -> Result<LayerMap, Problem> {
    let allowed = key.allowed(map.change(key));
    let range = node.need("range", &format!("a list of 2 numbers, each {allowed}"))?.numbers([allowed; 2])?;
    Ok(LayerMap { range, ..map })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_stand_at_their_keys() {
        let mut maps = LayerMaps::default();
        let noise = |size| LayerMap { source: MapSource::Noise { size, octaves: 1 }, range: [0.5, 1.0] };
        for (index, key) in MapKey::ALL.into_iter().enumerate() {
            assert!(maps.get(key).is_none());
            maps.set(key, Some(noise(index as f64 + 1.0)));
        }
        let sizes = MapKey::ALL.map(|key| maps.get(key).cloned());
        assert_eq!(sizes, core::array::from_fn(|index| Some(noise(index as f64 + 1.0))));
        assert!(maps.change_growth());
        let growing = MapKey::ALL.into_iter().filter(|key| !key.is_painted());
        growing.for_each(|key| maps.set(key, None));
        assert!(!maps.change_growth() && !maps.is_empty());
    }

    #[test]
    fn usual_ranges_are_allowed() {
        for key in MapKey::ALL {
            for change in [false, true].map(|factor| key.change(factor)) {
                let Range { low, high, .. } = key.allowed(change);
                assert!(key.usual(change).iter().all(|one| (low..=high).contains(one)), "{key:?} {change:?}");
            }
        }
    }

    #[test]
    fn noise_turns_directions_shifts_colours_and_multiplies_the_rest() {
        let noise = LayerMap { source: MapSource::Noise { size: 9.0, octaves: 1 }, range: [0.5, 1.0] };
        let changes = MapKey::ALL.map(|key| noise.change(key));
        use MapChange::{Add, Multiply, Replace};
        assert_eq!(changes, [Multiply, Multiply, Add, Multiply, Multiply, Add, Multiply, Replace]);
    }
}
