//! The fonts of the window. The module holds the characters of its own texts; other characters that visitors may type
//! are loaded later.

use std::sync::Arc;

use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily};
use egui::{Context, FontData, FontDefinitions, FontFamily, FontTweak};
use epaint_default_fonts::{EGUI_ICONS, UBUNTU_LIGHT};

const FAMILIES: [FontFamily; 2] = [FontFamily::Proportional, FontFamily::Monospace];

/// The fonts that the window opens with.
pub fn first(context: &Context) {
    let mut fonts = FontDefinitions::empty();
    let icons = FontData::from_static(EGUI_ICONS).tweak(FontTweak { scale: 0.9, ..FontTweak::default() });
    for (name, data) in [("text", FontData::from_static(UBUNTU_LIGHT)), ("icons", icons)] {
        fonts.font_data.insert(name.to_owned(), Arc::new(data));
        for family in FAMILIES {
            fonts.families.entry(family).or_default().push(name.to_owned());
        }
    }
    context.set_fonts(fonts);
}

/// Adds a font for characters that the other fonts lack; `scale` is its size relative to them.
pub fn add(context: &Context, name: &str, bytes: Vec<u8>, scale: f32) {
    let data = FontData::from_owned(bytes).tweak(FontTweak { scale, ..FontTweak::default() });
    let last = |family| InsertFontFamily { family, priority: FontPriority::Lowest };
    context.add_font(FontInsert::new(name, data, FAMILIES.map(last).to_vec()));
}
