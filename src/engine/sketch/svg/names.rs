//! Which groups of an SVG are layers, and their names.

use std::collections::BTreeMap;

use usvg::roxmltree::{Document, Node};

/// Namespace of the labels and modes that Inkscape gives layers.
pub(super) const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
/// So many groups with names may hold one shape each and be layers all the same.
const FEW: usize = 12;

/// The groups of an SVG, by id.
pub(super) struct Names(BTreeMap<String, Named>);

struct Named {
    name: String,
    /// Whether it is a layer inside of another one, too.
    is_layer: bool,
}

impl Names {
    /// Of all groups with an id.
    pub(super) fn of(xml: &Document) -> Self {
        let illustrator = xml.descendants().any(|node| node.is_comment() && is_illustrator(node));
        let groups = || xml.descendants().filter(|node| node.tag_name().name() == "g");
        let is_mode = |group: &Node| group.attribute((INKSCAPE, "groupmode")) == Some("layer");
        let is_inner = |group: &Node| group.ancestors().skip(1).any(|above| above.tag_name().name() == "g");
        let is_named = |group: &Node| {
            is_mode(group)
                || label(group).is_some()
                || group.attribute("id").is_some_and(|id| !is_generated(id))
        };
        // Where each shape has a group with a name, such groups are no layers.
        let single = |group: &Node| group.descendants().filter(|node| super::is_shape(node)).count() < 2;
        let by_name =
            groups().filter(|group| is_inner(group) && is_named(group) && single(group)).count() <= FEW;
        let named = |group: Node| {
            let id = group.attribute("id")?;
            let name = label(&group).map_or_else(|| shown(id, illustrator), str::to_owned);
            Some((id.to_owned(), Named { name, is_layer: is_mode(&group) || by_name && is_named(&group) }))
        };
        Self(groups().filter_map(named).collect())
    }

    /// The name of the group with this id.
    pub(super) fn name(&self, id: &str) -> Option<&str> {
        self.0.get(id).map(|named| named.name.as_str()).filter(|name| !name.trim().is_empty())
    }

    /// Whether the group with this id is a layer although it lies in another group.
    pub(super) fn is_layer(&self, id: &str) -> bool {
        self.0.get(id).is_some_and(|named| named.is_layer)
    }
}

/// What drawing programs show as the name of a group: the label of Inkscape, the name of Illustrator.
fn label<'a>(group: &Node<'a, '_>) -> Option<&'a str> {
    let label = group.attribute((INKSCAPE, "label")).or_else(|| group.attribute("data-name"));
    label.filter(|label| !label.trim().is_empty())
}

fn is_illustrator(comment: Node) -> bool {
    comment.text().is_some_and(|text| text.contains("Adobe Illustrator"))
}

/// Whether an id is one that programs make: `g12`, `group-3`, `Group 3`, `_12`, `SVGID_1_`.
fn is_generated(id: &str) -> bool {
    let word = id.trim_end_matches(|c: char| c.is_ascii_digit() || "_- .".contains(c));
    let word = word.trim_start_matches('_').to_ascii_lowercase();
    ["", "g", "group", "svgid", "path", "use"].contains(&word.as_str())
}

/// The name that an id stands for. Illustrator writes `_x0020_` and `_x31_` for characters that an id may not hold, `_` for spaces, and
/// `_1_` behind a name that occurs twice.
fn shown(id: &str, illustrator: bool) -> String {
    let mut id = id;
    if illustrator
        && let Some(number) =
            id.strip_suffix('_').map(|rest| rest.trim_end_matches(|c: char| c.is_ascii_digit()))
    {
        let is_number = number.len() + 1 < id.len();
        id = number
            .strip_suffix('_')
            .filter(|name| is_number && !name.is_empty() && !ends_with_code(id))
            .unwrap_or(id);
    }
    let mut name = String::new();
    while let Some(at) = id.find("_x") {
        let code = &id[at + 2..];
        let coded = code.split_once('_').filter(|(hex, _)| (2..=6).contains(&hex.len()));
        let decoded = coded.and_then(|(hex, rest)| {
            let all = hex.bytes().all(|byte| byte.is_ascii_digit() || (b'A'..=b'F').contains(&byte));
            Some((char::from_u32(u32::from_str_radix(hex, 16).ok().filter(|_| all)?)?, rest))
        });
        let (before, rest) = (&id[..at], decoded.map_or(code, |(_, rest)| rest));
        name += &spaced(before, illustrator);
        match decoded {
            Some((c, _)) => name.push(c),
            None => name += "_x",
        }
        id = rest;
    }
    name + &spaced(id, illustrator)
}

/// Whether an id ends with the code of a character, such as `_x31_`.
fn ends_with_code(id: &str) -> bool {
    let code = id.strip_suffix('_').and_then(|rest| rest.rsplit('_').next());
    code.is_some_and(|code| code.starts_with('x') && code.len() > 2)
}

fn spaced(part: &str, illustrator: bool) -> String {
    if illustrator { part.replace('_', " ") } else { part.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_illustrator_are_decoded() {
        for (id, name) in [
            ("Big_x0020_spots", "Big spots"),
            ("_x31_st_layer", "1st layer"),
            ("L_xF6_we", "Löwe"),
            ("a_x5F_b", "a_b"),
            ("spots_1_", "spots"),
            ("_x31_", "1"),
            ("Layer_1", "Layer 1"),
        ] {
            assert_eq!(shown(id, true), name, "{id}");
        }
        assert_eq!([shown("big_spots", false), shown("fur_x0020_a", false)], ["big_spots", "fur a"]);
        assert_eq!(shown("_xylem", false), "_xylem");
    }
}
