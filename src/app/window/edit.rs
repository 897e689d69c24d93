//! Actions on marks: delete, copy, paste, select the next, turn, insert.

use egui::Ui;

use super::Window;
use crate::app::canvas::tool::Tool;
use crate::editor::edit::Edit;
use crate::grid::Edges;
use crate::marks::{Ellipse, Line, Mark};

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
        self.canvas.tool = Tool::Select;
    }

    pub(super) fn duplicate(&mut self) {
        self.session.duplicate(self.copy_offset());
    }

    pub(super) fn select_next(&mut self, step: isize) {
        if self.session.select_next(step) {
            self.canvas.tool = Tool::Select;
        }
    }

    pub(super) fn insert(&mut self, ellipse: bool) {
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
        self.canvas.tool = Tool::Select;
    }

    pub(super) fn another_seed(&mut self) {
        // Consecutive seeds are independent (see `Document::layer_seed`).
        self.session.edit(|document| document.seed = document.seed.wrapping_add(1));
    }

    /// Copies the selected marks to the system's clipboard.
    pub(super) fn copy(&mut self, ui: &Ui) {
        if let Some(text) = self.session.copy() {
            ui.ctx().copy_text(text);
        }
    }

    pub(super) fn paste(&mut self, text: &str) {
        if self.session.paste(text, self.copy_offset()).is_err() {
            self.notices
                .wrong("The clipboard holds no marks; copy some from dapple, or the text of a document.");
            return;
        }
        self.canvas.tool = Tool::Select;
    }

    /// The offset of a copy from the original, px of the canvas.
    fn copy_offset(&self) -> [f64; 2] {
        [ASIDE / f64::from(self.canvas.view.zoom); 2]
    }
}
