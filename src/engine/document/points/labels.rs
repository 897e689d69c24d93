//! The labels of a field of points (`"labels"`): their keys, and how they are read.

use super::{KINDS, Kind, Labels, REMEDY, one_or_two, whole};
use crate::document::limits;
use crate::document::node::Node;
use crate::document::shape::{Key, Object, Shape};
use crate::document::{Problem, tone};

/// Labels of any kind.
pub(super) const SHAPE: Shape = Shape::AnyOf(&[
    Shape::Object(&VALUES),
    Shape::Object(&RANDOM),
    Shape::Object(&IMAGE),
    Shape::Object(&SPACE_GIRAFFE),
    Shape::Object(&BREADTH_FIRST),
    Shape::Object(&DEPTH_FIRST),
    Shape::Object(&ROUND_ROBIN),
    Shape::Object(&CONNECTED),
]);

const fn pair([low, high]: [u32; 2]) -> [u64; 2] {
    [low as u64, high as u64]
}

const KIND: &str = "what gives the points their values";
const RAYS: [u64; 2] = pair(limits::RAYS);

static VALUES: Object = Object {
    name: "Labels values",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["values"]), Key::REQUIRED, KIND),
        Key::new(
            "group",
            Shape::Whole(pair(limits::GROUP)),
            "1",
            "random grays, one for each group of so many neighbours",
        ),
    ],
};

static RANDOM: Object = Object {
    name: "Labels random",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["random"]), Key::REQUIRED, KIND),
        Key::new(
            "dark",
            Shape::AnyOf(&[Shape::Number(limits::INK), Shape::Numbers(&[limits::INK; 2])]),
            "0.5",
            "dark with this probability, or light; with one probability and another `share`, with that share",
        ),
    ],
};

static IMAGE: Object = Object {
    name: "Labels image",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["image"]), Key::REQUIRED, KIND),
        Key::new(
            "image",
            Shape::Object(&tone::IMAGE),
            Key::REQUIRED,
            "the darker a picture is, the more likely dark: `{\"png\": …}` as that of a tone, stretched over the canvas",
        ),
        Key::new(
            "passes",
            Shape::Whole([1, limits::PASSES as u64]),
            "1",
            "each pass takes the field of the one before it for the picture, with points nearer by √2",
        ),
    ],
};

static SPACE_GIRAFFE: Object = Object {
    name: "Labels space-giraffe",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["space-giraffe"]), Key::REQUIRED, KIND),
        Key::new(
            "rays",
            Shape::Wholes(&[RAYS; 2]),
            "[10, 20]",
            "a cell round each point, with so many rays at least and at most",
        ),
    ],
};

static BREADTH_FIRST: Object = Object {
    name: "Labels breadth-first",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["breadth-first"]), Key::REQUIRED, KIND),
        Key::new(
            "size",
            Shape::Whole(pair(limits::CLUSTER)),
            "24",
            "compact clusters of so many points, parted by light ones",
        ),
    ],
};

static DEPTH_FIRST: Object = Object {
    name: "Labels depth-first",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["depth-first"]), Key::REQUIRED, KIND),
        Key::new("size", Shape::Whole(pair(limits::CLUSTER)), "24", "winding clusters"),
    ],
};

static ROUND_ROBIN: Object = Object {
    name: "Labels round-robin",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["round-robin"]), Key::REQUIRED, KIND),
        Key::new(
            "size",
            Shape::Whole(pair(limits::CLUSTER)),
            "24",
            "clusters that take turns until they meet, of so many points in the mean, with light borders",
        ),
        Key::new(
            "rings",
            Shape::Whole([0, limits::RINGS as u64]),
            "0",
            "by how many points the borders are thicker",
        ),
    ],
};

static CONNECTED: Object = Object {
    name: "Labels connected",
    keys: &[
        Key::new("kind", Shape::Choice(|| vec!["connected"]), Key::REQUIRED, KIND),
        Key::new(
            "start",
            Shape::Number(limits::START),
            "0.04",
            "a dark net of the shortest paths between points that are drawn with this probability",
        ),
        Key::new("rings", Shape::Whole([0, limits::RINGS as u64]), "0", "by how many points it is thicker"),
    ],
};

/// Reads the labels of a field of points.
pub(super) fn read(node: &Node) -> Result<Labels, Problem> {
    let kind = node.need("kind", &KINDS.map(|(name, _)| name).join(", "))?.choice(&KINDS)?;
    let size = |node: &Node| whole(node, "size", Labels::SIZE, limits::CLUSTER);
    let rings = |node: &Node| whole(node, "rings", 0, [0, limits::RINGS]);
    match kind {
        Kind::Values => {
            node.is(&VALUES)?;
            Ok(Labels::Values { group: whole(node, "group", Labels::GROUP, limits::GROUP)? })
        }
        Kind::Random => {
            node.is(&RANDOM)?;
            let dark =
                node.get("dark").map_or(Ok([Labels::DARK; 2]), |node| one_or_two(&node, limits::INK))?;
            Ok(Labels::Random { dark })
        }
        Kind::Image => {
            node.is(&IMAGE)?;
            let image = node.need("image", "an object {\"png\": a gray PNG in base64}")?;
            let passes = whole(node, "passes", Labels::PASSES, [1, limits::PASSES])?;
            Ok(Labels::Image { image: tone::image(&image, REMEDY)?, passes })
        }
        Kind::SpaceGiraffe => {
            node.is(&SPACE_GIRAFFE)?;
            let [low, high] = limits::RAYS;
            let allowed = format!("a list of two whole numbers from {low} to {high}, the second no less");
            let Some(list) = node.get("rays") else { return Ok(Labels::SpaceGiraffe { rays: Labels::RAYS }) };
            let rays = list.counts([high; 2]).map_err(|_| list.wrong(allowed.clone()))?;
            if rays[0] < low || rays[1] < rays[0] {
                Err(list.wrong(allowed))
            } else {
                Ok(Labels::SpaceGiraffe { rays })
            }
        }
        Kind::BreadthFirst => {
            node.is(&BREADTH_FIRST)?;
            Ok(Labels::BreadthFirst { size: size(node)? })
        }
        Kind::DepthFirst => {
            node.is(&DEPTH_FIRST)?;
            Ok(Labels::DepthFirst { size: size(node)? })
        }
        Kind::RoundRobin => {
            node.is(&ROUND_ROBIN)?;
            Ok(Labels::RoundRobin { size: size(node)?, rings: rings(node)? })
        }
        Kind::Connected => {
            node.is(&CONNECTED)?;
            let start = node.get("start").map_or(Ok(Labels::START), |node| node.number(&limits::START))?;
            Ok(Labels::Connected { start, rings: rings(node)? })
        }
    }
}
