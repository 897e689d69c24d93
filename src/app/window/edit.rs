//! Actions on marks: delete, copy, paste, select the next, turn, insert.

use egui::Ui;

use super::Window;
use super::examples::ExampleUse;
use crate::app::action::Beginning;
use crate::app::canvas::tool::Tool;
use crate::app::canvas::{FROZEN, starter};
use crate::document::Layer;
use crate::editor::edit::Edit;
use crate::editor::selection::{Place, Selection};
use crate::grid::Edges;
use crate::marks::{Ellipse, Line, Mark};

/// The smallest and largest width of new lines, and radius of new ellipses, px.
const NIB: [f64; 2] = [0.5, 400.0];
/// The offset of a copy from the original, px of the screen.
const ASIDE: f64 = 14.0;

impl Window {
    /// Carries out a change of the document.
    pub(super) fn edit(&mut self, edit: Edit) {
        match edit {
            Edit::Size(_) => {
                self.canvas.view.fitted = true;
                self.texture.view.fitted = true;
            }
            Edit::Edges(edges) => self.texture.tiled &= edges == Edges::Wrap,
            _ => {}
        }
        self.session.change(edit);
    }

    pub(super) fn select_all(&mut self) {
        self.session.select_all();
        self.use_select();
    }

    pub(super) fn select_marks(&mut self, places: Vec<Place>) {
        if let Some(first) = places.first() {
            self.session.active_layer = first.layer;
        }
        self.session.selection = Selection::new(places);
        self.use_select();
    }

    /// Changes to the tool *Select* while marks are selected.
    pub(super) fn use_select(&mut self) {
        if self.canvas.tool != Tool::Select {
            self.tool_before = Some(std::mem::replace(&mut self.canvas.tool, Tool::Select));
        }
    }

    /// Returns to the earlier tool, once nothing is selected any more.
    pub(super) fn use_tool_before(&mut self) {
        if self.session.selection.is_empty()
            && let Some(tool) = self.tool_before.take()
        {
            self.canvas.tool = tool;
        }
    }

    pub(super) fn delete(&mut self) {
        self.session.delete_selected();
        self.use_tool_before();
    }

    /// Changes the width of the selected lines and the size of the selected ellipses; where nothing is selected, the
    /// size of new marks.
    pub(super) fn widen(&mut self, factor: f64) {
        let nib = &mut self.canvas.nib;
        if !self.session.selection.is_empty() {
            self.session.widen(factor);
        } else if self.canvas.tool == Tool::Ellipse {
            nib.radii = nib.radii.map(|radius| (factor * radius).clamp(NIB[0], NIB[1]));
        } else {
            nib.width = (factor * nib.width).clamp(NIB[0], NIB[1]);
        }
    }

    pub(super) fn duplicate(&mut self) {
        self.session.duplicate(self.copy_offset());
    }

    pub(super) fn select_next(&mut self, step: isize) {
        if self.session.select_next(step) {
            self.use_select();
        }
    }

    /// Whether marks can be added to the active layer; where they cannot, shows why.
    pub(super) fn can_add(&mut self) -> bool {
        let is_frozen = self.session.is_active_frozen();
        if is_frozen {
            self.notices.done(FROZEN);
        }
        !is_frozen
    }

    pub(super) fn insert(&mut self, ellipse: bool) {
        if !self.can_add() {
            return;
        }
        let nib = self.canvas.nib;
        let size = self.session.document().size;
        let center = [0, 1].map(|axis| self.canvas.view.center[axis].clamp(0.0, f64::from(size[axis])));
        let mark = if ellipse {
            Mark::Ellipse(Ellipse { center, radii: nib.radii, angle: 0.0 })
        } else {
            let half = 0.1 * f64::from(size[0]);
            let [from, to] = [-half, half].map(|by| [center[0] + by, center[1]]);
            Mark::Line(Line { from, to, width: nib.width })
        };
        self.session.add(&[mark]);
        self.use_select();
    }

    /// Puts the marks or the layer that the user chose to begin with on an empty canvas.
    pub(super) fn begin_with(&mut self, ui: &Ui, beginning: Beginning) {
        let size = self.session.document().size;
        match beginning {
            Beginning::Spots => self.session.add(&starter(size, true)),
            Beginning::Stripes => self.session.add(&starter(size, false)),
            Beginning::Example(name) => self.read_example(ui, name, ExampleUse::Begin),
            Beginning::Coat(name) => self.read_example(ui, name, ExampleUse::Tile),
            Beginning::Cow => self.session.edit(|document| document.layers = vec![Layer::cow()]),
        }
        self.session.selection.clear();
    }

    pub(super) fn another_seed(&mut self) {
        // Consecutive seeds are independent (see `Document::layer_seed`).
        self.session.edit(|document| document.seed = document.seed.wrapping_add(1));
    }

    /// The offset of a copy from the original, px of the canvas.
    pub(super) fn copy_offset(&self) -> [f64; 2] {
        [ASIDE / f64::from(self.canvas.view.zoom); 2]
    }
}
