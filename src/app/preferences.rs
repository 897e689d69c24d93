//! The page of preferences: settings for all documents.

use egui::{Checkbox, ComboBox, DragValue, Grid, RichText, TextEdit, ThemePreference, Ui, vec2};

use super::fields::{DPI, REGIONS, SEAMLESS, SIDES, regions, resolution, sides};
use super::settings::{SCALES, Settings};
use super::small_screen::fit_width;
use crate::editor::pens::Pens;
use crate::editor::units::{Ruler, Units};
use crate::editor::wheel::Wheel;
use crate::machine::threads;

/// Shows the page. Changes take effect at once.
pub fn page(ui: &mut Ui, settings: &mut Settings) {
    fit_width(ui, 430.0);
    ui.heading("Preferences");
    ui.add_space(6.0);
    let grid = |name| Grid::new(name).num_columns(2).min_col_width(96.0).spacing(vec2(16.0, 10.0));
    grid("window").show(ui, |ui| {
        look(ui, settings);
        scale(ui, &mut settings.scale);
        units(ui, &mut settings.units);
        wheel(ui, &mut settings.wheel);
        threads(ui, &mut settings.threads);
        pens(ui, &mut settings.pens);
        site(ui, &mut settings.site);
    });
    ui.add_space(10.0);
    ui.label(RichText::new("New documents").strong());
    let units = settings.units;
    let new = &mut settings.new;
    grid("new documents").show(ui, |ui| {
        ui.label("Size").on_hover_text("Width and height of the canvas");
        let ruler = Ruler { units, dpi: new.dpi };
        ui.horizontal(|ui| {
            let names = ["Width of new documents", "Height of new documents"];
            sides(ui, &mut new.size, ruler, SIDES, names)
        });
        ui.end_row();
        ui.label("Regions").on_hover_text(REGIONS);
        let names = ["Regions of new documents", "Columns of new documents", "Rows of new documents"];
        ui.horizontal(|ui| regions(ui, &mut new.regions, names));
        ui.end_row();
        ui.label("Seamless").on_hover_text(SEAMLESS);
        ui.add(Checkbox::new(&mut new.seamless, "tiles without a seam"));
        ui.end_row();
        ui.label("Resolution").on_hover_text(DPI);
        resolution(ui, &mut new.dpi, "Resolution of new documents");
        ui.end_row();
    });
}

fn look(ui: &mut Ui, settings: &mut Settings) {
    ui.label("Theme");
    let before = settings.theme;
    ui.horizontal(|ui| {
        for (text, theme) in [
            ("System theme", ThemePreference::System),
            ("Light", ThemePreference::Light),
            ("Dark", ThemePreference::Dark),
        ] {
            ui.radio_value(&mut settings.theme, theme, text);
        }
    });
    ui.end_row();
    if settings.theme != before {
        ui.ctx().set_theme(settings.theme);
    }
}

fn scale(ui: &mut Ui, scale: &mut f32) {
    ui.label("Scale").on_hover_text("Size of texts and controls; 100 % is the size that the system asks for");
    let before = *scale;
    let percent = |scale: f32| format!("{:.0} %", 100.0 * scale);
    let combo = ComboBox::from_id_salt("scale").selected_text(percent(before)).show_ui(ui, |ui| {
        for one in SCALES {
            ui.selectable_value(scale, one, percent(one));
        }
    });
    combo.response.accessible_name("Scale of the interface");
    ui.end_row();
    if *scale != before {
        ui.ctx().set_zoom_factor(*scale);
    }
}

fn wheel(ui: &mut Ui, wheel: &mut Wheel) {
    ui.label("Wheel")
        .on_hover_text("What the wheel, or two fingers on a touchpad, do over sketch and texture");
    ui.horizontal(|ui| {
        ui.radio_value(wheel, Wheel::Pan, "moves the view").on_hover_text("With Ctrl it zooms");
        ui.radio_value(wheel, Wheel::Zoom, "zooms")
            .on_hover_text("The middle button, or Space and a drag, move the view");
    });
    ui.end_row();
}

fn units(ui: &mut Ui, units: &mut Units) {
    ui.label("Lengths")
        .on_hover_text("The unit in which lengths and areas are shown and typed; files hold px");
    ui.horizontal(|ui| {
        ui.radio_value(units, Units::Px, "px").on_hover_text("Px of the canvas");
        ui.radio_value(units, Units::Mm, "mm").on_hover_text("Millimetres, by the document's resolution");
    });
    ui.end_row();
}

fn pens(ui: &mut Ui, pens: &mut Pens) {
    ui.label("Pens").on_hover_text("For graphics tablets, if the system reports the pressure of the pen");
    ui.vertical(|ui| {
        ui.checkbox(&mut pens.pressure, "pressure sets the width")
            .on_hover_text("The width of lines, and the size of ellipses that a tap adds");
        ui.checkbox(&mut pens.erases, "barrel button erases").on_hover_text(
            "A drag with the barrel button (the secondary button) erases; otherwise it moves the view",
        );
    });
    ui.end_row();
}

fn site(ui: &mut Ui, site: &mut String) {
    ui.label("Links").on_hover_text("The address of the page that copied links open");
    ui.add(TextEdit::singleline(site).desired_width(280.0)).accessible_name("Address of links");
    ui.end_row();
}

fn threads(ui: &mut Ui, threads: &mut Option<usize>) {
    let cores = threads::cores();
    ui.label("Threads")
        .on_hover_text("How many processor cores grow textures. The result is always the same");
    ui.horizontal(|ui| {
        if ui.radio(threads.is_none(), "All").on_hover_text("As many as there are cores").clicked() {
            *threads = None;
        }
        let mut number = threads.unwrap_or(cores);
        if ui.radio(threads.is_some(), "This many").clicked() {
            *threads = Some(number);
        }
        let most = cores.max(number);
        let field = DragValue::new(&mut number).range(1..=most).speed(0.05);
        if ui.add(field.update_while_editing(false)).accessible_name("Number of threads").changed() {
            *threads = Some(number);
        }
        ui.weak(format!("of {cores}"));
    });
    ui.end_row();
}
