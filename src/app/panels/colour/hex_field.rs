//! The field for a colour in hexadecimal digits or by its name in CSS.

use egui::{TextEdit, Ui};
use svgtypes::Color;

use super::ColourPanel;
use crate::app::theme::Palette;
use crate::document::Stop;

/// The field for hexadecimal digits or a name.
pub(super) fn hex_field(ui: &mut Ui, panel: &mut ColourPanel, stop: &mut Stop, name: &str) {
    let mut text = panel.hex.clone().unwrap_or_else(|| stop.hex());
    let known = read(&text);
    let mut edit = TextEdit::singleline(&mut text).desired_width(84.0).char_limit(40);
    if known.is_none() {
        edit = edit.text_color(Palette::current(ui.visuals()).wrong);
    }
    let response = ui.add(edit).accessible_name(name);
    if response.changed() {
        panel.hex = Some(text);
    }
    if response.lost_focus()
        && let Some(text) = panel.hex.take()
        && let Some(typed) = read(&text)
    {
        stop.set_rgba(typed);
    }
    let help = "Red, green, blue: #rrggbb or #rgb in hexadecimal digits, with opacity #rrggbbaa; or as in CSS: tan, \
                rgb(210, 180, 140)";
    response.on_hover_text(if known.is_none() {
        format!("This is not a colour. {help}")
    } else {
        help.to_owned()
    });
}

/// Parses `#rrggbb`, `#rgb` or `#rrggbbaa`, with or without the `#`, or a colour as CSS writes it.
fn read(text: &str) -> Option<[u8; 4]> {
    let text = match text.trim().to_lowercase() {
        // The one name of CSS that SVG does not have.
        name if name == "rebeccapurple" => "#663399".to_owned(),
        text => text,
    };
    hexadecimal(&text).or_else(|| {
        let Color { red, green, blue, alpha } = text.parse().ok()?;
        Some([red, green, blue, alpha])
    })
}

fn hexadecimal(text: &str) -> Option<[u8; 4]> {
    let digits = text.strip_prefix('#').unwrap_or(text).chars();
    let digits: Vec<u8> = digits.map(|c| c.to_digit(16).map(|digit| digit as u8)).collect::<Option<_>>()?;
    match digits[..] {
        [r, g, b] => Some([r * 17, g * 17, b * 17, u8::MAX]),
        [a, b, c, d, e, f] => Some([a * 16 + b, c * 16 + d, e * 16 + f, u8::MAX]),
        [a, b, c, d, e, f, g, h] => Some([a * 16 + b, c * 16 + d, e * 16 + f, g * 16 + h]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read_as_people_write_them() {
        for (text, colour) in [
            ("#f4e3c1", [244, 227, 193, 255]),
            (" F4E3C1 ", [244, 227, 193, 255]),
            ("#fc0", [255, 204, 0, 255]),
            ("#fc003380", [252, 0, 51, 128]),
            ("tan", [210, 180, 140, 255]),
            (" RebeccaPurple", [102, 51, 153, 255]),
            ("rgb(1, 2, 3)", [1, 2, 3, 255]),
        ] {
            assert_eq!(read(text), Some(colour), "{text}");
        }
        for text in ["", "#", "reddish", "#12345", "#1234567", "##123456"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
