//! The choices that a person may want to correct.

use egui::{Button, Grid, RichText, Slider, Ui, WidgetInfo, vec2};

use super::job::Found;
use crate::app::fields::{pair, reset};
use crate::document::limits;
use crate::editor::units::Ruler;
use crate::finish::Kind as FinishKind;
use crate::measure::Picture;
use crate::photo::LEVELS;
use crate::synth::import::photo::PhotoOptions;

/// Widths of the sliders, points: a value and the button that resets it stand beside them.
const SLIDER: f32 = 84.0;

/// A grid with a column for names and one for values.
pub fn rows(ui: &mut Ui, name: &str, inside: impl FnOnce(&mut Ui)) {
    let grid = Grid::new(name).num_columns(2).min_col_width(62.0).min_row_height(16.0);
    grid.spacing(vec2(10.0, 5.0)).show(ui, inside);
}

/// The largest area that can be chosen for the smallest mark, px². Where the spots have two sizes, this is more than
/// the larger one.
#[must_use]
pub fn largest(picture: &Picture) -> f64 {
    match picture {
        Picture::Spots { got, .. } => 4.0 * got.area,
        Picture::Stripes { got, .. } => 4.0 * got.width * got.wavelength,
    }
}

/// Shows the fields. `last` is what was found with these options, or with the options before.
pub fn choices(ui: &mut Ui, options: &mut PhotoOptions, last: Option<&Found>, largest: f64, ruler: Ruler) {
    ui.spacing_mut().slider_width = SLIDER;
    rows(ui, "choices", |ui| {
        named(
            ui,
            "Marks",
            "Which part of the photograph the marks are: the one that covers less of it, or the one that \
             covers more. Where both cover nearly the same, the darker one counts as less",
        );
        ui.horizontal(|ui| {
            let invert = &mut options.framing.invert;
            ui.radio_value(invert, false, "cover less")
                .on_hover_text("Marks are the part that covers less of the photograph");
            ui.radio_value(invert, true, "cover more")
                .on_hover_text("Marks are the part that covers more of the photograph");
        });
        ui.end_row();
        level(ui, options, last);
        smallest(ui, options, last, largest, ruler);
        layers(ui, options, last);
        regions(ui, options, last);
        finish(ui, options);
    });
    ui.add_space(4.0);
    part(ui, options);
}

fn named(ui: &mut Ui, text: &str, explained: &str) {
    ui.label(text).on_hover_text(explained);
}

fn level(ui: &mut Ui, options: &mut PhotoOptions, last: Option<&Found>) {
    let value = &mut options.framing.limits.level;
    named(
        ui,
        "Level",
        "Where the edge of a mark lies, between the tone of the ground (0) and that of the marks (1). Lower: \
         larger marks",
    );
    ui.horizontal(|ui| {
        // The slider rounds the value that it shows; that is not a change.
        let rounded = |level: f32| (100.0 * level).round() / 100.0;
        let shown = rounded(value.or(last.map(|found| found.level)).unwrap_or(0.5));
        let mut level = shown;
        let slider = ui.add(Slider::new(&mut level, LEVELS[0]..=LEVELS[1]).fixed_decimals(2));
        slider.widget_info(|| WidgetInfo::slider(true, f64::from(level), "Level"));
        if rounded(level) != shown {
            *value = Some(rounded(level));
        }
        if reset(ui, "Level", value.is_none()) {
            *value = None;
        }
    });
    ui.end_row();
}

fn smallest(ui: &mut Ui, options: &mut PhotoOptions, last: Option<&Found>, largest: f64, ruler: Ruler) {
    let value = &mut options.framing.limits.smallest;
    named(ui, "Smallest", "The area of the smallest mark; smaller ones are left out");
    ui.horizontal(|ui| {
        let shown = value.or(last.map(|found| found.least)).unwrap_or(1.0).round().max(1.0);
        let mut least = shown;
        let most = largest.max(shown).max(2.0);
        let slider = Slider::new(&mut least, 1.0..=most).logarithmic(true);
        let slider = slider.custom_formatter(move |value, _| ruler.area(value));
        let factor = ruler.per_px() * ruler.per_px();
        let slider = slider.custom_parser(move |text| ruler.parse(text, factor));
        let slider = ui.add(slider);
        slider.widget_info(|| WidgetInfo::slider(true, least, "Smallest mark"));
        if least.round() != shown {
            *value = Some(least.round().max(1.0));
        }
        if reset(ui, "Smallest mark", value.is_none()) {
            *value = None;
        }
    });
    ui.end_row();
}

fn layers(ui: &mut Ui, options: &mut PhotoOptions, last: Option<&Found>) {
    let spotted = last.is_none_or(|found| matches!(found.picture, Picture::Spots { .. }));
    named(ui, "Layers", "Whether large and small spots become separate layers");
    ui.add_enabled_ui(spotted, |ui| {
        ui.horizontal(|ui| {
            let layers = &mut options.wanted.layers;
            for (value, text, explained) in [
                (None, "as needed", "Two where large and small spots are clearly apart"),
                (Some(1), "one", "All spots on one layer"),
                (Some(2), "two", "Large spots on one layer, small ones on another"),
            ] {
                ui.radio_value(layers, value, text).on_hover_text(explained);
            }
        });
    });
    ui.end_row();
}

fn regions(ui: &mut Ui, options: &mut PhotoOptions, last: Option<&Found>) {
    let wanted = &mut options.wanted;
    named(ui, "Regions", "In each region a few marks represent all of its marks");
    let by_itself = !wanted.all_marks && wanted.regions.is_none();
    let explained = "As few regions as explain how the marks change";
    if ui.radio(by_itself, "as few as needed").on_hover_text(explained).clicked() {
        (wanted.all_marks, wanted.regions) = (false, None);
    }
    ui.end_row();
    ui.label("");
    ui.horizontal(|ui| {
        let text = if wanted.regions.is_some() { "" } else { "by number" };
        let radio = ui.radio(wanted.regions.is_some(), text);
        if radio.on_hover_text("This number of columns and rows").clicked() {
            let found = last.and_then(|found| found.document.as_ref().ok()?.document.regions);
            let found = found.map_or([2, 2], |regions| regions.map(|count| count as usize));
            (wanted.all_marks, wanted.regions) = (false, Some(found));
        }
        if let Some(regions) = &mut wanted.regions {
            let mut counts = regions.map(|count| count as u32);
            if pair(ui, &mut counts, 1..=limits::MAX_REGIONS, ["Region columns", "Region rows"], "") {
                *regions = counts.map(|count| count as usize);
            }
        }
    });
    ui.end_row();
    ui.label("");
    let explained = "All whole spots, or the middle lines of all stripes, are drawn as free marks";
    if ui.radio(wanted.all_marks, "none: all marks are drawn").on_hover_text(explained).clicked() {
        (wanted.all_marks, wanted.regions) = (true, None);
    }
    ui.end_row();
}

fn finish(ui: &mut Ui, options: &mut PhotoOptions) {
    named(ui, "Finish", "What the texture is made of");
    ui.horizontal(|ui| {
        for (value, text, explained) in [
            (None, "none", "The texture is painted in flat colours"),
            (
                Some(FinishKind::Fur),
                "fur",
                "Hair lies as in the photograph, where its fine detail has a direction",
            ),
        ] {
            ui.radio_value(&mut options.finish, value, text).on_hover_text(explained);
        }
    });
    ui.end_row();
}

fn part(ui: &mut Ui, options: &mut PhotoOptions) {
    ui.label(
        RichText::new(
            "Drag the corners of the photograph to read a part of it as a rectangle; hold Shift to keep one.",
        )
        .small()
        .weak(),
    );
    let corners = &mut options.framing.corners;
    if ui.add_enabled(corners.is_some(), Button::new("Whole photograph").small()).clicked() {
        *corners = None;
    }
}
