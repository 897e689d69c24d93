//! Settings of a field of points (`"points"`).

mod labels;

use crate::document::choices::names;
use crate::document::limits::{self, Range};
use crate::document::node::Node;
use crate::document::shape::{Key, Object, Shape};
use crate::document::systems::POINTS;
use crate::document::tone::{self, ToneImage};
use crate::document::{Colours, Layer, Problem, SystemChoice};

/// Kind and distance of the points of a layer, and how their values become a field.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Radius of the discs, px, at the two ends of the progression: [`limits::POINT_DISTANCE`]. `None` = as the drawn ellipses, or
    /// [`Points::ACROSS`] along the longer side where there are none.
    pub distance: Option<[f64; 2]>,
    /// The way along which distances and probabilities change.
    pub progression: Progression,
    /// Rule that gives points their values.
    pub labels: Labels,
    /// Octaves, 1–[`limits::POINT_OCTAVES`]: each of half the distance and half the weight of the one before it.
    pub octaves: u32,
    /// Whether each octave is folded at ½.
    pub fold: bool,
    /// Interpolation of the values between points.
    pub interpolation: Interpolation,
    /// Length of the axes, in edges: [`limits::AXIS`].
    pub axis: f64,
    /// ε, how strongly weights are shifted: [`limits::SHIFT`].
    pub shift: f64,
    /// The direction in which they are shifted.
    pub towards: Towards,
    /// The share of the canvas above the edge: [`limits::POINT_SHARE`]. `None` = the share that the drawn ellipses cover; without
    /// ellipses the share that the labels ask for ([`Labels::share_is_asked`]), or the share that results.
    pub share: Option<f64>,
}

impl Points {
    /// Points along the longer side where nothing is drawn and no distance is given: their single blots are large enough to be seen.
    pub const ACROSS: f64 = 16.0;

    /// Whether the field has a threshold that can be moved until a given share of the canvas is above it. Cells of dark and light
    /// points have none.
    #[must_use]
    pub fn has_level(&self) -> bool {
        let is_cut = self.labels.are_dark_or_light() && self.octaves == 1;
        self.interpolation == Interpolation::Smooth || !is_cut
    }
}

impl Layer {
    /// The blotches of a cow, black on white: figure 11 of the paper.
    #[must_use]
    pub fn cow() -> Self {
        const WHITE: [u8; 3] = [0xf6, 0xf2, 0xea];
        const BLACK: [u8; 3] = [0x1c, 0x17, 0x14];
        let points = Points { axis: 1.5, share: Some(0.42), ..Points::default() };
        // So narrow a transition between the colours is about a px wide.
        let colours = Colours::new([(0.0, WHITE), (0.488, WHITE), (0.512, BLACK), (1.0, BLACK)]);
        Self {
            system: SystemChoice::Of(&POINTS),
            points: Some(points),
            colours: Some(colours),
            ..Self::default()
        }
    }
}

impl Default for Points {
    fn default() -> Self {
        Self {
            distance: None,
            progression: Progression::Across,
            labels: Labels::Random { dark: [Labels::DARK; 2] },
            octaves: 1,
            fold: false,
            interpolation: Interpolation::Smooth,
            axis: 1.0,
            shift: 0.0,
            towards: Towards::Random,
            share: None,
        }
    }
}

/// The way along which distances and probabilities change from their first value to their second.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Progression {
    /// From left to right; on a tile to its middle and back.
    #[default]
    Across,
    /// From top to bottom; on a tile to its middle and back.
    Down,
    /// From the middle to the corners.
    Outward,
    /// From black to white of a picture, stretched over the canvas.
    Image(ToneImage),
}

/// Rule that gives points their values.
#[derive(Clone, Debug, PartialEq)]
pub enum Labels {
    /// Random grays, one for each group of this number of neighbours: [`limits::GROUP`].
    Values {
        /// Points a group.
        group: u32,
    },
    /// Dark or light at random.
    Random {
        /// The probability of dark, 0–1, at the two ends of the progression.
        dark: [f64; 2],
    },
    /// Dark or light at random: the darker the picture, the more often dark.
    Image {
        /// The picture, stretched over the canvas: black is always dark, white never.
        image: ToneImage,
        /// Passes, [`limits::PASSES`]: each uses the field of the previous one as its picture, with finer points.
        passes: u32,
    },
    /// Cells with uneven edges, one for each disc.
    SpaceGiraffe {
        /// The fewest and the most rays round a cell: [`limits::RAYS`].
        rays: [u32; 2],
    },
    /// Compact clusters, parted by light points.
    BreadthFirst {
        /// Points a cluster: [`limits::CLUSTER`].
        size: u32,
    },
    /// Winding clusters, parted by light points.
    DepthFirst {
        /// Points a cluster.
        size: u32,
    },
    /// Clusters that grow in turn until they meet, with light borders.
    RoundRobin {
        /// Points a cluster, on average.
        size: u32,
        /// Rings of points by which borders are thickened: 0–[`limits::RINGS`].
        rings: u32,
    },
    /// A dark net: some points, and the shortest paths between them.
    Connected {
        /// The probability of being one of those points: [`limits::START`].
        start: f64,
        /// Rings of points by which the net is thickened: 0–[`limits::RINGS`].
        rings: u32,
    },
}

/// The `kind` of labels, by their names in documents.
const KINDS: [(&str, Kind); 8] = [
    ("values", Kind::Values),
    ("random", Kind::Random),
    ("image", Kind::Image),
    ("space-giraffe", Kind::SpaceGiraffe),
    ("breadth-first", Kind::BreadthFirst),
    ("depth-first", Kind::DepthFirst),
    ("round-robin", Kind::RoundRobin),
    ("connected", Kind::Connected),
];

#[derive(Clone, Copy)]
enum Kind {
    Values,
    Random,
    Image,
    SpaceGiraffe,
    BreadthFirst,
    DepthFirst,
    RoundRobin,
    Connected,
}

impl Labels {
    /// The names of all kinds in documents.
    pub const NAMES: [&'static str; KINDS.len()] = {
        let mut names = [""; KINDS.len()];
        let mut index = 0;
        while index < names.len() {
            names[index] = KINDS[index].0;
            index += 1;
        }
        names
    };
    /// The probability of dark points.
    pub const DARK: f64 = 0.5;
    /// Points a group of [`Labels::Values`]: cells of one point.
    pub const GROUP: u32 = 1;
    /// Passes by a picture.
    pub const PASSES: u32 = 1;
    /// Rays of a space giraffe, as in the paper.
    pub const RAYS: [u32; 2] = [10, 20];
    /// Points a cluster: those of a patch.
    pub const SIZE: u32 = 24;
    /// The probability of the ends of a net (`facts.md` U: a cracked net).
    pub const START: f64 = 0.04;

    /// The labels of this name with their defaults; `None` for labels by a picture, which has no default, and for unknown names.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        let size = Self::SIZE;
        let all = [
            Self::Values { group: Self::GROUP },
            Self::Random { dark: [Self::DARK; 2] },
            Self::SpaceGiraffe { rays: Self::RAYS },
            Self::BreadthFirst { size },
            Self::DepthFirst { size },
            Self::RoundRobin { size, rings: 0 },
            Self::Connected { start: Self::START, rings: 0 },
        ];
        all.into_iter().find(|labels| labels.name() == name)
    }

    /// Its name in documents.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Values { .. } => "values",
            Self::Random { .. } => "random",
            Self::Image { .. } => "image",
            Self::SpaceGiraffe { .. } => "space-giraffe",
            Self::BreadthFirst { .. } => "breadth-first",
            Self::DepthFirst { .. } => "depth-first",
            Self::RoundRobin { .. } => "round-robin",
            Self::Connected { .. } => "connected",
        }
    }

    /// Whether the labels themselves ask for a share: the mean of the probability or of the picture.
    #[must_use]
    pub fn share_is_asked(&self) -> bool {
        matches!(self, Self::Random { .. } | Self::Image { passes: 1, .. })
    }

    /// Whether points are dark with a probability.
    #[must_use]
    pub fn are_by_chance(&self) -> bool {
        matches!(self, Self::Random { .. } | Self::Image { .. })
    }

    /// Whether points are dark or light, not gray.
    #[must_use]
    pub fn are_dark_or_light(&self) -> bool {
        !matches!(self, Self::Values { .. })
    }
}

/// Interpolation of the values between points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// The weighted mean of the points around it: smooth edges.
    #[default]
    Smooth,
    /// The value of the point of the highest weight: cells with sharp corners.
    Nearest,
}

impl Interpolation {
    /// Both with their names in documents.
    pub const NAMES: [(&'static str, Self); 2] = [("smooth", Self::Smooth), ("nearest", Self::Nearest)];
}

/// The direction in which the weights of points are shifted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Towards {
    /// To a random side each.
    #[default]
    Random,
    /// Away from the middle of the canvas.
    Outward,
    /// Along this direction, degrees from +x toward +y.
    Angle(f64),
}

const DISTANCE: Shape = Shape::Number(limits::POINT_DISTANCE);
const WAYS: [&str; 3] = ["across", "down", "outward"];
const SIDES: [&str; 2] = ["random", "outward"];

pub(super) static FIELD: Object = Object {
    name: "Points",
    keys: &[
        Key::new(
            "distance",
            Shape::AnyOf(&[DISTANCE, Shape::Numbers(&[limits::POINT_DISTANCE; 2])]),
            Key::NONE,
            "the least distance of two points (the radius of Poisson discs); a larger canvas holds more of them. On `wrap` at most half the diagonal of the canvas, or one point would be all. In a progression each step is the same factor. Without it: the spacing of the drawn ellipses, and with none 1/16 of the longer side of the canvas or of the model",
        ),
        Key::new(
            "progression",
            Shape::AnyOf(&[Shape::Choice(|| WAYS.to_vec()), Shape::Object(&tone::IMAGE)]),
            "\"across\"",
            "the way from the first number of a list to the second: from left to right, from top to bottom, from the middle to the corners, or from black to white of a picture stretched over the canvas. On `wrap` the first two go to the middle and back. On a model `across` is along it and `down` from its top; the others are refused",
        ),
        Key::new(
            "labels",
            labels::SHAPE,
            "{\"kind\": \"random\", \"dark\": 0.5}",
            "what gives the points their values, see the next table",
        ),
        Key::new(
            "octaves",
            Shape::Whole([1, limits::POINT_OCTAVES as u64]),
            "1",
            "how many fields are added, each of half the distance and half the weight of the one before it; those finer than a cell are left out",
        ),
        Key::new(
            "fold",
            Shape::Flag,
            "false",
            "whether each octave is folded at its middle, 2·abs(T − ½): turbulence",
        ),
        Key::new(
            "interpolation",
            Shape::Choice(|| names(&Interpolation::NAMES)),
            "\"smooth\"",
            "whether a place between points takes the weighted mean of those around it, or the value of the one with the highest weight: cells with corners",
        ),
        Key::new(
            "axis",
            Shape::Number(limits::AXIS),
            "1",
            "how far the weight of a point reaches, in distances of its neighbours: with 2 fields are smoother",
        ),
        Key::new(
            "shift",
            Shape::Number(limits::SHIFT),
            "0",
            "how strongly points lean to one side (ε of the paper): moves the borders of cells",
        ),
        Key::new(
            "towards",
            Shape::AnyOf(&[Shape::Choice(|| SIDES.to_vec()), Shape::Number(Range::ANGLE)]),
            "\"random\"",
            "to which side: another one for each point, away from the middle of the canvas, or this direction",
        ),
        Key::new(
            "share",
            Shape::Number(limits::POINT_SHARE),
            Key::NONE,
            "the share of the canvas above the edge; the level is set for it. Not with cells of dark and light points, which have none. Without it: what the drawn ellipses cover; with none the mean probability of `random` and of `image` with one pass; of the others as it comes",
        ),
    ],
};

/// Reads the points of a layer.
pub(super) fn read(node: &Node) -> Result<Points, Problem> {
    node.is(&FIELD)?;
    let default = Points::default();
    let number = |key, default, range| node.get(key).map_or(Ok(default), |node| node.number(range));
    let points = Points {
        distance: node.get("distance").map(|node| one_or_two(&node, limits::POINT_DISTANCE)).transpose()?,
        progression: node.get("progression").map_or(Ok(default.progression), |node| progression(&node))?,
        labels: node.get("labels").map_or(Ok(default.labels), |node| labels::read(&node))?,
        octaves: whole(node, "octaves", default.octaves, [1, limits::POINT_OCTAVES])?,
        fold: node.get("fold").map_or(Ok(default.fold), |node| node.flag())?,
        interpolation: node
            .get("interpolation")
            .map_or(Ok(default.interpolation), |node| node.choice(&Interpolation::NAMES))?,
        axis: number("axis", default.axis, &limits::AXIS)?,
        shift: number("shift", default.shift, &limits::SHIFT)?,
        towards: node.get("towards").map_or(Ok(default.towards), |node| towards(&node))?,
        share: node.get("share").map(|node| node.number(&limits::POINT_SHARE)).transpose()?,
    };
    match node.get("share") {
        Some(share) if !points.has_level() => Err(share.wrong(
            "no share: cells of dark and light points have no level that could be moved; leave it out, or set \"interpolation\" to \"smooth\"",
        )),
        _ => Ok(points),
    }
}

/// A number, or a list of two.
fn one_or_two(node: &Node, range: Range) -> Result<[f64; 2], Problem> {
    if let Ok(both) = node.number(&range) {
        return Ok([both; 2]);
    }
    node.numbers([range; 2]).map_err(|_| node.wrong(format!("{range}, or a list of two such numbers")))
}

/// The whole number of `key`, between two.
fn whole(node: &Node, key: &str, default: u32, [low, high]: [u32; 2]) -> Result<u32, Problem> {
    // The cast is exact: the number is at most `high`.
    let read = |node: Node| node.whole(u64::from(low), u64::from(high)).map(|number| number as u32);
    node.get(key).map_or(Ok(default), read)
}

/// The remedy for a picture in another form.
const REMEDY: &str = "docs/points.md says how to make one";

fn progression(node: &Node) -> Result<Progression, Problem> {
    if node.is_object() {
        return tone::image(node, REMEDY).map(Progression::Image);
    }
    let allowed = "\"across\", \"down\", \"outward\", or {\"png\": a gray PNG in base64}";
    match node.text(allowed)? {
        "across" => Ok(Progression::Across),
        "down" => Ok(Progression::Down),
        "outward" => Ok(Progression::Outward),
        _ => Err(node.wrong(allowed)),
    }
}

/// `"random"`, `"outward"`, or degrees.
fn towards(node: &Node) -> Result<Towards, Problem> {
    let allowed = format!("\"random\", \"outward\", or {}", Range::ANGLE);
    match node.text(&allowed) {
        Ok("random") => Ok(Towards::Random),
        Ok("outward") => Ok(Towards::Outward),
        _ => node.number(&Range::ANGLE).map(Towards::Angle).map_err(|_| node.wrong(allowed)),
    }
}
