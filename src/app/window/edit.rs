//! Actions on marks: delete, copy, paste, select the next, turn, insert.

use egui::Ui;

use super::Window;
use crate::app::canvas::tool::Tool;
use crate::document::{Document, Layer};
use crate::editor::edit::Edit;
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::shape;
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
        self.session.selection = Selection::new(self.session.editable_marks().map(|(place, _)| place));
        self.canvas.tool = Tool::Select;
    }

    pub(super) fn delete(&mut self) {
        let places: Vec<Place> = self.session.selection.places().collect();
        self.session.remove(&places);
    }

    pub(super) fn duplicate(&mut self) {
        let by = ASIDE / f64::from(self.canvas.view.zoom);
        let marks: Vec<(Place, Mark)> = self.session.selected().collect();
        let by = self.session.limit_move(&marks, [by, by]);
        let copies: Vec<Mark> = marks.iter().map(|(_, mark)| shape::moved(mark, by)).collect();
        if !copies.is_empty() {
            self.session.add(&copies);
        }
    }

    pub(super) fn select_next(&mut self, step: isize) {
        let places: Vec<Place> = self.session.editable_marks().map(|(place, _)| place).collect();
        if places.is_empty() {
            return;
        }
        let now = self.session.selection.places().next();
        let index = now.and_then(|now| places.iter().position(|place| *place == now));
        let n = places.len() as isize;
        let next =
            index.map_or(if step > 0 { 0 } else { n - 1 }, |index| (index as isize + step).rem_euclid(n));
        self.session.selection = Selection::new([places[next as usize]]);
        self.session.active_layer = places[next as usize].layer;
        self.canvas.tool = Tool::Select;
    }

    /// Changes each selected mark about its own centre.
    pub(super) fn change_each(&mut self, change: impl Fn(&Mark, [f64; 2]) -> Mark) {
        let marks: Vec<_> = self.session.selected().collect();
        let changed: Vec<_> =
            marks.iter().map(|(place, mark)| (*place, change(mark, shape::center(mark)))).collect();
        self.session.replace(&changed);
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

    /// Copies the selected marks, as a document.
    pub(super) fn copy(&mut self, ui: &Ui) {
        let source = self.session.document();
        let mut document = Document { layers: Vec::new(), ..source.clone() };
        for (index, layer) in source.layers.iter().enumerate() {
            let held =
                |stroke: &usize| self.session.selection.contains(Place { layer: index, stroke: *stroke });
            let strokes: Vec<_> =
                (0..layer.strokes.len()).filter(held).map(|stroke| layer.strokes[stroke].clone()).collect();
            if !strokes.is_empty() {
                document.layers.push(Layer { strokes, ..layer.clone() });
            }
        }
        if !document.layers.is_empty() {
            ui.ctx().copy_text(document.to_json());
        }
    }

    pub(super) fn paste(&mut self, text: &str) {
        let document = match Document::parse(text, "the clipboard") {
            Ok(document) => document,
            Err(_) => {
                self.notices
                    .wrong("The clipboard holds no marks; copy some from dapple, or the text of a document.");
                return;
            }
        };
        let pasted = Session::open(document, None);
        let by = ASIDE / f64::from(self.canvas.view.zoom);
        let marks: Vec<Mark> = pasted.marks().map(|(_, mark)| shape::moved(&mark, [by, by])).collect();
        self.session.add(&marks);
        self.canvas.tool = Tool::Select;
    }
}
