//! Pictures.

use egui::{Slider, Ui, WidgetInfo};

use super::About;
use super::{layer, named, one_of, rows, size, yes};
use crate::app::exporting::choices::FORMATS;
use crate::app::exporting::{Choices, Shows};
use crate::export::Format;

/// The choices.
pub fn page(ui: &mut Ui, choices: &mut Choices, about: &About) {
    rows(ui, "picture", |ui| {
        named(ui, "Shows", "What the picture is of");
        let texts = [
            (Shows::Texture, "The texture"),
            (Shows::Pattern, "The pattern, 0 to 1"),
            (Shows::Labels, "Labels, a number a layer"),
            (Shows::Concentrations, "Concentrations"),
        ];
        let texts = texts.map(|(shows, text)| (shows, text.to_owned()));
        one_of(ui, "Shows", &mut choices.picture.shows, &texts, |_| true);
        ui.end_row();
        if choices.picture.shows == Shows::Pattern {
            let explained = "The pattern of the layer that painted each px, or of one layer alone";
            layer(ui, choices, about, "The one on top", explained);
        }
        named(ui, "Format", "Numbers are only written where nothing is lost");
        let formats = FORMATS.map(|format| (format, format.name().to_owned()));
        let content = choices.picture.content();
        one_of(ui, "Format", &mut choices.picture.format, &formats, |format| format.holds(content));
        ui.end_row();
        size(ui, choices, about);
        if choices.picture.shows == Shows::Texture {
            colours(ui, choices);
        }
        if choices.picture.format == Format::Png {
            named(ui, "Document", "What the PNG holds beside its px");
            let explained = "The PNG can be opened here and grown again; who has it has your sketch, too";
            yes(ui, "kept in the picture", &mut choices.picture.document, true, explained);
            ui.end_row();
        }
    });
    ui.add_space(6.0);
    ui.weak(told(choices));
}

fn colours(ui: &mut Ui, choices: &mut Choices) {
    let picture = &mut choices.picture;
    if picture.format.is_deep() {
        named(ui, "Depth", "Bits of each colour: more for later changes of the colours");
        ui.horizontal(|ui| {
            ui.radio_value(&mut picture.deep, false, "8 bit");
            ui.radio_value(&mut picture.deep, true, "16 bit");
        });
        ui.end_row();
    }
    if picture.format == Format::Jpeg {
        named(ui, "Quality", "Higher is larger and truer");
        let slider = ui.add(Slider::new(&mut picture.quality, 1..=100));
        slider.widget_info(|| WidgetInfo::slider(true, f64::from(picture.quality), "Quality"));
        ui.end_row();
    } else {
        named(ui, "Ground", "What lies between the marks");
        let explained = "One sees through the ground; laid over its colour again, it is the same picture";
        yes(ui, "transparent", &mut picture.transparent, true, explained);
        ui.end_row();
    }
}

fn told(choices: &Choices) -> &'static str {
    match (choices.picture.shows, choices.picture.format) {
        (Shows::Texture, Format::Exr) => "32 bit a channel, colours as light.",
        (Shows::Texture, Format::Tiff) => "Not compressed, not changed.",
        (Shows::Texture, Format::Png | Format::Webp) => "Nothing is lost.",
        (Shows::Texture, Format::Jpeg) => "Small; fine edges blur.",
        (Shows::Pattern, Format::Exr) => "0 = ground, 0.5 = a mark's edge, 1 = its middle; 32 bit.",
        (Shows::Pattern, _) => "0 = ground, half = a mark's edge, white = its middle; 16 bit.",
        (Shows::Labels, _) => "0 = none, 1 = the lowest layer, and so on: looks black to the eye.",
        (Shows::Concentrations, _) => {
            "A channel a chemical of each layer, as the solver left it. It is grown once more."
        }
    }
}
