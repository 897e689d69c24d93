//! Drawn marks that do not grow. They are shown as hollow marks on the sketch.

use egui::{Color32, Stroke};

use super::ink::Ink;
use crate::app::theme::Palette;
use crate::marks::Mark;

/// A dashed outline without a fill; a full outline where the mark is selected.
pub fn paint(ink: &Ink, mark: &Mark, is_selected: bool, colours: &Palette) {
    if is_selected {
        ink.mark(mark, Color32::TRANSPARENT, Stroke::new(2.0, colours.accent));
    }
    ink.dashed_outline(mark, Stroke::new(1.5, colours.wrong));
}
