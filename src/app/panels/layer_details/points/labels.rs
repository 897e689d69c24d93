//! The rows about what gives the points of a field their values: the kind of labels, and the numbers of that kind.

use egui::{ComboBox, Response, Ui};

use super::fields::row;
use super::{CONTROL, LIST, between, fields, whole};
use crate::app::action::Action;
use crate::app::assets;
use crate::app::panels::layer_details::{picture_row, small_picture};
use crate::document::{Labels, limits};
use crate::editor::picture_use::PictureUse;

/// Kinds of labels by their names in documents: their label here, and their tooltip.
const KINDS: [(&str, &str, &str); 8] = [
    ("random", "Dark or light", "Each point is dark or light at random: the blotches of a cow"),
    ("values", "Grays", "Each point has a random gray: noise, clouds, stone; sharp borders make cells"),
    ("space-giraffe", "Space giraffe", "A dark cell with uneven edges for each point"),
    ("breadth-first", "Breadth first", "Compact clusters of points: the plates of a giraffe"),
    ("depth-first", "Depth first", "Winding clusters of points"),
    ("round-robin", "Round robin", "Clusters that grow in turns until they meet: plates with thin borders"),
    ("connected", "Connected", "A net: some points, and the shortest paths between them"),
    ("image", "A picture…", "Dark where a picture is dark. Asks for the picture"),
];

/// The rows about labels; changes `labels`, and asks for a picture where one is needed.
pub(super) fn labels(ui: &mut Ui, labels: &mut Labels) -> Option<Action> {
    let help = "How each point gets its value, from light to dark";
    let default = matches!(labels, Labels::Random { .. });
    let mut asked = false;
    let reset = row(ui, "Values", help, default, |ui| kind(ui, labels, &mut asked));
    if reset {
        *labels = Labels::Random { dark: [Labels::DARK; 2] };
    }
    numbers(ui, labels);
    asked.then_some(Action::ChoosePicture(PictureUse::PointLabels))
}

fn kind(ui: &mut Ui, labels: &mut Labels, asked: &mut bool) -> Response {
    let now = labels.name();
    let shown = KINDS.iter().find(|(name, ..)| *name == now);
    let (text, help) = shown.map_or((now, ""), |(_, text, help)| (*text, *help));
    let combo = ComboBox::from_id_salt("labels").selected_text(text).width(CONTROL).height(LIST).truncate();
    let combo = combo.show_ui(ui, |ui| {
        for (name, text, help) in KINDS {
            let picture = small_picture::of_labels(name).and_then(|asset| assets::texture(ui.ctx(), asset));
            let row = picture_row(ui, picture, text, name == now).on_hover_text(help);
            if !row.clicked() {
                continue;
            }
            match Labels::of_name(name) {
                Some(chosen) if name != now => *labels = chosen,
                Some(_) => {}
                None => *asked = true,
            }
        }
    });
    combo.response.accessible_name("Values").on_hover_text(help)
}

/// The numbers of this kind of labels.
fn numbers(ui: &mut Ui, labels: &mut Labels) {
    let size_help = "Number of points in a cluster";
    match labels {
        Labels::Values { group } => {
            let help = "Number of neighbouring points that share a value: more points make larger cells";
            whole(ui, "Points a group", help, group, Labels::GROUP, limits::GROUP);
        }
        Labels::Random { dark } => {
            let help = "The probability that a point is dark, at the two ends of the canvas";
            between(ui, "Dark", help, dark, [Labels::DARK; 2], fields::probability);
        }
        Labels::Image { passes, .. } => {
            let help = "Each pass uses the result of the pass before as its picture, with finer points: the \
                        outlines become uneven, like a coast";
            whole(ui, "Passes", help, passes, Labels::PASSES, [1, limits::PASSES]);
        }
        Labels::SpaceGiraffe { rays } => {
            let help = "The fewest and the most rays around a cell: with fewer rays its edge is more uneven";
            between(ui, "Rays", help, rays, Labels::RAYS, fields::rays);
        }
        Labels::BreadthFirst { size } | Labels::DepthFirst { size } => {
            whole(ui, "Cluster", size_help, size, Labels::SIZE, limits::CLUSTER);
        }
        Labels::RoundRobin { size, rings } => {
            whole(ui, "Cluster", size_help, size, Labels::SIZE, limits::CLUSTER);
            thicker(ui, "By how many points the borders between clusters are thicker", rings);
        }
        Labels::Connected { start, rings } => {
            let help = "The share of points at which the paths of the net meet";
            let default = Labels::START.to_bits() == start.to_bits();
            if row(ui, "Nodes", help, default, |ui| fields::nodes(ui, start)) {
                *start = Labels::START;
            }
            thicker(ui, "By how many points the net is thicker", rings);
        }
    }
}

fn thicker(ui: &mut Ui, help: &str, rings: &mut u32) {
    whole(ui, "Thicker by", help, rings, 0, [0, limits::RINGS]);
}
