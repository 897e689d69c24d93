//! Pictures.

use egui::{Slider, Ui, WidgetInfo};

use super::ExportContext;
use super::{layer, named, one_of, rows, size, yes};
use crate::app::exporting::choices::FORMATS;
use crate::app::exporting::{Choices, PictureContent};
use crate::export::Format;

/// The choices.
pub fn page(ui: &mut Ui, choices: &mut Choices, context: &ExportContext) {
    rows(ui, "picture", |ui| {
        named(ui, "Shows", "The content of the picture");
        let texts = [
            (PictureContent::Texture, "The texture"),
            (PictureContent::Pattern, "The pattern, 0 to 1"),
            (PictureContent::Labels, "Labels: the number of the layer"),
            (PictureContent::Concentrations, "Concentrations"),
        ];
        let texts = texts.map(|(shows, text)| (shows, text.to_owned()));
        one_of(ui, "Shows", &mut choices.picture.shows, &texts, |_| true);
        ui.end_row();
        if choices.picture.shows == PictureContent::Pattern {
            let explained = "The pattern of the layer that painted each px, or of one layer alone";
            layer(ui, choices, context, "Topmost layer", explained);
        }
        named(ui, "Format", "Numbers can only be written in lossless formats");
        let formats = FORMATS.map(|format| (format, format.name().to_owned()));
        let content = choices.picture.content();
        one_of(ui, "Format", &mut choices.picture.format, &formats, |format| format.holds(content));
        ui.end_row();
        size(ui, choices, context);
        if choices.picture.shows == PictureContent::Texture {
            colours(ui, choices);
        }
        if choices.picture.format == Format::Png {
            named(ui, "Document", "What the PNG holds besides the picture");
            let explained = "The PNG can be opened in dapple and grown again. It then contains your sketch";
            yes(ui, "include the document", &mut choices.picture.document, true, explained);
            ui.end_row();
        }
    });
    ui.add_space(6.0);
    ui.weak(note(choices));
}

fn colours(ui: &mut Ui, choices: &mut Choices) {
    let picture = &mut choices.picture;
    if picture.format.is_deep() {
        named(ui, "Depth", "Bits per channel: 16 where colours will be edited later");
        ui.horizontal(|ui| {
            ui.radio_value(&mut picture.deep, false, "8 bit");
            ui.radio_value(&mut picture.deep, true, "16 bit");
        });
        ui.end_row();
    }
    if picture.format == Format::Jpeg {
        named(ui, "Quality", "Higher: a larger file with fewer artefacts");
        let slider = ui.add(Slider::new(&mut picture.quality, 1..=100));
        slider.widget_info(|| WidgetInfo::slider(true, f64::from(picture.quality), "Quality"));
        ui.end_row();
    } else {
        named(ui, "Ground", "The surface between the marks");
        let explained = "Makes the ground transparent; over its own colour, the picture is the same";
        yes(ui, "transparent", &mut picture.transparent, true, explained);
        ui.end_row();
    }
}

fn note(choices: &Choices) -> &'static str {
    match (choices.picture.shows, choices.picture.format) {
        (PictureContent::Texture, Format::Exr) => "32 bit per channel, linear light.",
        (PictureContent::Texture, Format::Tiff) => "Not compressed, lossless.",
        (PictureContent::Texture, Format::Png | Format::Webp) => "Compressed, lossless.",
        (PictureContent::Texture, Format::Jpeg) => "A small file; fine edges are blurred.",
        (PictureContent::Pattern, Format::Exr) => {
            "0 = ground, 0.5 = the edge of a mark, 1 = its centre; 32 bit."
        }
        (PictureContent::Pattern, _) => {
            "Black = ground, middle gray = the edge of a mark, white = its centre; 16 bit."
        }
        (PictureContent::Labels, _) => {
            "Pixel value 0 = no layer, 1 = the lowest layer, and so on. Such small values look black."
        }
        (PictureContent::Concentrations, _) => {
            "The amounts of the simulated substances: one channel for each substance of each layer. The \
             texture is grown again."
        }
    }
}
