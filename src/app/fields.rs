//! Fields that several panels and pages have: the size of a canvas, its regions, its resolution.

use egui::{DragValue, Ui};

use crate::document::limits;
use crate::editor::units::Ruler;

/// Sides that a canvas can have here, px.
pub const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;

/// What regions are.
pub const REGIONS: &str = "The canvas is cut into columns and rows. The marks in a region say what grows there; \
                           between regions their size, shape and direction change smoothly.";
/// What seamless means.
pub const SEAMLESS: &str = "What leaves on one side comes in on the other: the texture can be laid side by side \
                            without a seam.";

/// What dots an inch are.
pub const DPI: &str = "Dots an inch: how large a px is when it is printed, and a px in mm. What grows does not depend \
                       on it.";

/// Width and height of a canvas side by side, px told as `ruler` does.
pub fn sides(
    ui: &mut Ui,
    values: &mut [u32; 2],
    ruler: Ruler,
    range: std::ops::RangeInclusive<u32>,
    names: [&str; 2],
) -> bool {
    let mut changed = false;
    for (index, (value, name)) in values.iter_mut().zip(names).enumerate() {
        if index > 0 {
            ui.weak("×");
        }
        let field = ruler.side(value, range.clone()).suffix(ruler.unit());
        changed |= ui.add(field).accessible_name(name).changed();
    }
    changed
}

/// Two whole numbers side by side.
pub fn pair(
    ui: &mut Ui,
    values: &mut [u32; 2],
    range: std::ops::RangeInclusive<u32>,
    names: [&str; 2],
    unit: &str,
) -> bool {
    let mut changed = false;
    for (index, (value, name)) in values.iter_mut().zip(names).enumerate() {
        if index > 0 {
            ui.weak("×");
        }
        let field = DragValue::new(value).range(range.clone()).suffix(unit).update_while_editing(false);
        changed |= ui.add(field).accessible_name(name).changed();
    }
    changed
}

/// A field for dots an inch.
pub fn resolution(ui: &mut Ui, dpi: &mut f64, name: &str) -> bool {
    let range = limits::DPI.low..=limits::DPI.high;
    let field = DragValue::new(dpi).range(range).max_decimals(1).suffix(" dpi").update_while_editing(false);
    ui.add(field).accessible_name(name).changed()
}
