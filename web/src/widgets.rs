//! The places of the window's widgets, for tests that click where a visitor would.

use std::cell::RefCell;

use egui::accesskit::{Node, NodeId};
use egui::{Context, FullOutput, Plugin};
use js_sys::Array;
use wasm_bindgen::prelude::*;

thread_local! {
    static SEEN: RefCell<Vec<(NodeId, Node)>> = const { RefCell::new(Vec::new()) };
}

struct Follower;

impl Plugin for Follower {
    fn debug_name(&self) -> &'static str {
        "widgets"
    }

    fn output_hook(&mut self, _: &Context, output: &mut FullOutput) {
        if let Some(update) = &output.platform_output.accesskit_update {
            SEEN.set(update.nodes.clone());
        }
    }
}

/// Records the widgets of each frame.
pub fn follow(context: &Context) {
    context.enable_accesskit();
    context.add_plugin(Follower);
}

/// The widgets of the last frame: role, name, left, top, right, bottom (points), and whether the widget can be used.
#[wasm_bindgen]
#[must_use]
pub fn widgets() -> Array {
    SEEN.with_borrow(|seen| {
        let named = seen.iter().filter_map(|(_, node)| {
            let bounds = node.bounds()?;
            let name = node.label().or_else(|| node.value()).unwrap_or_default();
            let row = Array::new();
            row.push(&format!("{:?}", node.role()).into());
            row.push(&name.into());
            for edge in [bounds.x0, bounds.y0, bounds.x1, bounds.y1] {
                row.push(&edge.into());
            }
            row.push(&(!node.is_disabled()).into());
            Some(row)
        });
        named.collect()
    })
}
