//! Fields that several panels and pages share: size of the canvas, regions, resolution.

use egui::{DragValue, Ui};

use crate::document::limits;
use crate::editor::units::Ruler;

/// Sides that a canvas can have here, px.
pub const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;

/// The tooltip of regions.
pub const REGIONS: &str = "The canvas is cut into columns and rows. The marks in a region set what grows there; \
                           between regions their size, shape and direction change smoothly.";
/// The tooltip of *Seamless*.
pub const SEAMLESS: &str = "The left edge continues at the right one, the top at the bottom: copies of the texture can be put \
                            side by side without a seam.";

/// The tooltip of the resolution.
pub const DPI: &str =
    "Dots per inch: the size of a px in print, and of a px in mm. The texture does not depend on it.";

/// Fields for width and height of a canvas, shown in the units of `ruler`. Gives whether one changed.
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

/// Fields for two whole numbers. Gives whether one changed.
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
