//! GIMP palettes (`.gpl`): colours with names, as text.
//!
//! `GIMP Palette`, then `Name: …` and `Columns: …` (both optional), then a colour on each line: red, green, blue from 0 to 255
//! and its name. Empty lines and lines that start with `#` are ignored.
//!
//! GIMP developer site, "GIMP Palette Format Version 2".

use std::fmt::Write;

use thiserror::Error;

/// A palette.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Palette {
    /// Its name; may be empty.
    pub name: String,
    /// Its colours in order.
    pub swatches: Vec<Swatch>,
}

/// A colour with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Swatch {
    /// Red, green, blue; 8-bit sRGB.
    pub colour: [u8; 3],
    /// Its name; may be empty.
    pub name: String,
}

/// The reason why a text is not a GIMP palette.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GplError {
    /// The first line is wrong.
    #[error("line 1: found {found}; allowed: \"GIMP Palette\"; export palettes of other programs as .gpl")]
    Beginning {
        /// The text found.
        found: String,
    },
    /// A line that is not a colour.
    #[error(
        "line {line}: found {found}; allowed: red, green, blue from 0 to 255 and a name, such as \"244 227 193 cream\""
    )]
    Line {
        /// Line number, from 1.
        line: usize,
        /// The text found.
        found: String,
    },
}

impl Palette {
    /// Parses the palette in `text`.
    ///
    /// # Errors
    /// The first invalid line.
    pub fn parse(text: &str) -> Result<Self, GplError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text.lines().enumerate();
        let first = lines.next().map_or("", |(_, line)| line);
        if first.trim_end() != "GIMP Palette" {
            return Err(GplError::Beginning { found: shown(first) });
        }
        let mut palette = Self::default();
        for (index, line) in lines {
            let line = line.trim();
            // Both are optional and come before the first colour.
            if palette.swatches.is_empty() {
                if let Some(name) = line.strip_prefix("Name:") {
                    palette.name = name.trim().to_owned();
                    continue;
                }
                if line.starts_with("Columns:") {
                    continue;
                }
            }
            if !line.is_empty() && !line.starts_with('#') {
                let wrong = || GplError::Line { line: index + 1, found: shown(line) };
                palette.swatches.push(swatch(line).ok_or_else(wrong)?);
            }
        }
        Ok(palette)
    }

    /// The text of its file. Line breaks in names become spaces.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!("GIMP Palette\nName: {}\nColumns: 0\n#\n", on_one_line(&self.name));
        for Swatch { colour: [red, green, blue], name } in &self.swatches {
            let name = on_one_line(name);
            // Writing to a text cannot fail.
            let _ = writeln!(text, "{red:3} {green:3} {blue:3}\t{name}");
        }
        text
    }
}

/// Three numbers and the rest of the line.
fn swatch(line: &str) -> Option<Swatch> {
    let mut rest = line;
    let mut colour = [0; 3];
    for channel in &mut colour {
        let end = rest.find(char::is_whitespace).unwrap_or(rest.len());
        *channel = rest[..end].parse().ok()?;
        rest = rest[end..].trim_start();
    }
    Some(Swatch { colour, name: rest.to_owned() })
}

fn on_one_line(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A line for messages: shortened, control characters escaped.
fn shown(line: &str) -> String {
    const MAX_LENGTH: usize = 40;
    let cut = if line.chars().count() > MAX_LENGTH { "…" } else { "" };
    let line: String = line.chars().take(MAX_LENGTH).collect();
    format!("\"{}{cut}\"", line.escape_debug())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn named(names: &[(&str, [u8; 3])]) -> Vec<Swatch> {
        names.iter().map(|(name, colour)| Swatch { colour: *colour, name: (*name).to_owned() }).collect()
    }

    #[test]
    fn a_gimp_palette_is_read() {
        let text = "GIMP Palette\r\nName: Earth tones\r\nColumns: 4\r\n# a remark\r\n\r\n244 227 193\tcream\r\n \
                    59  35  20 dark brown\r\n  0   0   0\r\n";
        let palette = Palette::parse(text).unwrap();
        assert_eq!(palette.name, "Earth tones");
        let expected = [("cream", [244, 227, 193]), ("dark brown", [59, 35, 20]), ("", [0; 3])];
        assert_eq!(palette.swatches, named(&expected));
    }

    #[test]
    fn the_old_format_without_a_head_is_read() {
        let palette = Palette::parse("GIMP Palette\n1 2 3 ink").unwrap();
        assert_eq!(palette, Palette { name: String::new(), swatches: named(&[("ink", [1, 2, 3])]) });
    }

    #[test]
    fn an_error_gives_the_line_number() {
        let said = |text: &str| Palette::parse(text).unwrap_err().to_string();
        assert!(said("").starts_with("line 1: found \"\"; allowed: \"GIMP Palette\""), "{}", said(""));
        assert!(said("JASC-PAL\n0100").starts_with("line 1: found \"JASC-PAL\""));
        let wrong = said("GIMP Palette\n# c\n1 2 256 too bright");
        assert!(
            wrong
                .starts_with("line 3: found \"1 2 256 too bright\"; allowed: red, green, blue from 0 to 255"),
            "{wrong}"
        );
        assert!(said("GIMP Palette\n1 2").starts_with("line 2: found \"1 2\""));
        assert!(said("GIMP Palette\n1 2 3.5 x").starts_with("line 2"));
        assert!(said("GIMP Palette\n\u{1b}[31m").contains("\\u{1b}"), "nothing acts on a terminal");
    }

    proptest! {
        #[test]
        fn what_is_written_is_read_back(
            name in "[a-zA-Z][a-zA-Z ]{0,12}[a-z]",
            swatches in prop::collection::vec((any::<[u8; 3]>(), "[a-zé]{0,4}( [a-z0-9]{1,4})?"), 0..20),
        ) {
            let name = on_one_line(&name);
            let swatches = swatches.into_iter().map(|(colour, name)| Swatch { colour, name: on_one_line(&name) });
            let palette = Palette { name, swatches: swatches.collect() };
            prop_assert_eq!(Palette::parse(&palette.text()), Ok(palette));
        }

        #[test]
        fn no_text_makes_it_panic(text in "(GIMP Palette\n)?\\PC{0,80}") {
            let _ = Palette::parse(&text);
        }
    }
}
