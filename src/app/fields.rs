//! Fields that several panels and pages share: size of the canvas, regions, resolution.

use egui::{DragValue, Ui, vec2};

use super::icons::Icon;
use super::units::number_field;
use crate::document::limits;
use crate::editor::units::Ruler;

/// Sides that a canvas can have here, px.
pub const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;

/// The tooltip of regions.
pub const REGIONS: &str = "Off: each mark sets what grows around it. On: the canvas is divided into columns \
                           and rows, and the average of the marks in a region sets what grows there; from \
                           region to region the texture changes gradually.";
/// The tooltip of *Seamless*.
pub const SEAMLESS: &str = "The left edge continues at the right one, the top at the bottom: copies of the texture can be put \
                            side by side without a seam.";

/// The tooltip of the resolution field.
pub const DPI: &str =
    "Dots per inch: how large one px is in print, and in mm. The texture does not depend on it.";

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
    unit: &'static str,
) -> bool {
    let mut changed = false;
    for (index, (value, name)) in values.iter_mut().zip(names).enumerate() {
        if index > 0 {
            ui.weak("×");
        }
        let field = number_field(DragValue::new(value).range(range.clone()), unit);
        changed |= ui.add(field).accessible_name(name).changed();
    }
    changed
}

/// A switch for regions; where it is on, also fields for their columns and rows. `names` are the accessible names of
/// all three. Returns whether one of them changed.
pub fn regions(ui: &mut Ui, regions: &mut Option<[u32; 2]>, names: [&str; 3]) -> bool {
    let mut on = regions.is_some();
    let text = if on { "" } else { "divide the canvas" };
    let mut changed = ui.checkbox(&mut on, text).accessible_name(names[0]).on_hover_text(REGIONS).changed();
    if changed {
        *regions = on.then_some(NEW_REGIONS);
    }
    if let Some(grid) = regions {
        changed |= pair(ui, grid, 1..=limits::MAX_REGIONS, [names[1], names[2]], "");
    }
    changed
}

/// Columns and rows of regions that are switched on.
const NEW_REGIONS: [u32; 2] = [2, 2];

/// A field for dots an inch.
pub fn resolution(ui: &mut Ui, dpi: &mut f64, name: &str) -> bool {
    let range = limits::DPI.low..=limits::DPI.high;
    let field = number_field(DragValue::new(dpi).range(range).max_decimals(1), " dpi");
    ui.add(field).accessible_name(name).changed()
}

/// The button that restores the default; an empty space where the value is the default.
pub fn reset(ui: &mut Ui, name: &str, default: bool) -> bool {
    if default {
        ui.allocate_space(vec2(20.0, 20.0));
        return false;
    }
    let button = Icon::Undo.sized_button(ui, &format!("{name}: default"), false, vec2(20.0, 22.0));
    button.on_hover_text(format!("{name}: back to its default")).clicked()
}
