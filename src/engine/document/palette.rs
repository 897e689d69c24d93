//! The colours of a layer in a file of their own: `.json`, which keeps everything, or `.gpl`, which other programs read.
//!
//! `{"format": "dapple palette", "version": 1, "name": "zebra", "colours": {"stops": […], "bends": […]}}`, with `colours`
//! as a layer's in a document. A GIMP palette has neither pattern values nor bends: the pattern values are written as the
//! colours' names (`at 0.4`) and read from there; if any colour has another name, all are spread evenly. Bends are lost.

use std::io;
use std::path::Path;

use serde_json::json;

use crate::colour::gpl::{self, GplError, Swatch};
use crate::document::node::Node;
use crate::document::{Colours, DocumentError, Problem, Stop, limits, reader, syntax, writer};
use crate::export::ExportError;

/// Colours with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// Its name; may be empty.
    pub name: String,
    /// Its colours.
    pub colours: Colours,
}

/// Most colours of a palette that become stops: more cannot be distinguished on a bar.
pub const MOST_STOPS: usize = 64;
/// Largest palette that is read, bytes: 64 stops take 4 kB.
pub const MAX_FILE: u64 = 1 << 20;
const FORMAT: &str = "dapple palette";
const VERSION: u64 = 1;

/// The reason why a palette could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum PaletteError {
    /// The file cannot be opened or read.
    #[error("{file}: cannot be read")]
    Unreadable {
        /// The file.
        file: String,
        /// The operating system's error.
        source: io::Error,
    },
    /// The file is larger than any palette.
    #[error(
        "{file}: found a file of more than {MAX_FILE} bytes; allowed: a palette of at most {MAX_FILE} bytes"
    )]
    TooLarge {
        /// The file.
        file: String,
    },
    /// The file name does not end like that of a palette.
    #[error(
        "{file}: found the ending \"{ending}\"; allowed: .json (keeps everything) or .gpl (a GIMP palette)"
    )]
    Ending {
        /// The file.
        file: String,
        /// Its ending.
        ending: String,
    },
    /// The file is not a GIMP palette.
    #[error("{file}: {problem}")]
    Gpl {
        /// The file.
        file: String,
        /// The place and the reason.
        problem: GplError,
    },
    /// The palette has no colours, or more than a bar can hold.
    #[error("{file}: found {found} colours; allowed: 1 to {MOST_STOPS}; remove some of them")]
    Count {
        /// The file.
        file: String,
        /// Number of colours in the palette.
        found: usize,
    },
    /// The file is not a dapple palette.
    #[error(transparent)]
    Json(#[from] DocumentError),
    /// The file cannot be written.
    #[error(transparent)]
    Unwritable(#[from] ExportError),
}

/// The form of a palette's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaletteForm {
    /// A dapple palette, which keeps everything.
    Json,
    /// A GIMP palette.
    Gpl,
}

impl PaletteForm {
    /// The form that the ending of `path` names.
    ///
    /// # Errors
    /// [`PaletteError::Ending`].
    pub fn from_path(path: &Path) -> Result<Self, PaletteError> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        match ending.as_str() {
            "json" => Ok(Self::Json),
            "gpl" => Ok(Self::Gpl),
            _ => Err(PaletteError::Ending { file: path.display().to_string(), ending }),
        }
    }
}

impl Palette {
    /// Reads the bytes of a file of this `form`; errors call it `source_name`.
    ///
    /// # Errors
    /// They are not a palette.
    pub fn from_bytes(form: PaletteForm, bytes: &[u8], source_name: &str) -> Result<Self, PaletteError> {
        match form {
            PaletteForm::Json => {
                let text = syntax::text(bytes).map_err(|problem| problem.in_file(source_name))?;
                Ok(Self::parse_json(text, source_name)?)
            }
            PaletteForm::Gpl => Self::parse_gpl(&String::from_utf8_lossy(bytes), source_name),
        }
    }

    /// The text of its file of this `form`.
    #[must_use]
    pub fn text(&self, form: PaletteForm) -> String {
        match form {
            PaletteForm::Json => self.to_json(),
            PaletteForm::Gpl => self.to_gpl(),
        }
    }

    /// Parses the text of a `.json` file; errors call it `source_name`.
    ///
    /// # Errors
    /// It is not JSON, or not a palette: the place, what was found, what is allowed.
    pub fn parse_json(text: &str, source_name: &str) -> Result<Self, DocumentError> {
        let value = syntax::json(text).map_err(|problem| problem.in_file(source_name))?;
        palette(&Node::root(&value)).map_err(|problem| problem.in_file(source_name))
    }

    /// The text of its `.json` file.
    #[must_use]
    pub fn to_json(&self) -> String {
        let colours = writer::colours(&self.colours);
        writer::text(&json!({"format": FORMAT, "version": VERSION, "name": self.name, "colours": colours}))
    }

    /// Parses the text of a `.gpl` file; errors call it `source_name`.
    ///
    /// # Errors
    /// A line is not one of a GIMP palette, or there are no colours, or too many.
    pub fn parse_gpl(text: &str, source_name: &str) -> Result<Self, PaletteError> {
        let file = || source_name.to_owned();
        let gpl::Palette { name, swatches } =
            gpl::Palette::parse(text).map_err(|problem| PaletteError::Gpl { file: file(), problem })?;
        if swatches.is_empty() || swatches.len() > MOST_STOPS {
            return Err(PaletteError::Count { file: file(), found: swatches.len() });
        }
        let places = named(&swatches).unwrap_or_else(|| even(swatches.len()));
        let stops = places.into_iter().zip(&swatches).map(|(at, swatch)| Stop::opaque(at, swatch.colour));
        Ok(Self { name, colours: Colours { stops: stops.collect(), ..Colours::new([]) } })
    }

    /// The text of its `.gpl` file: colours and places, no bends and no opacity.
    ///
    /// ```
    /// use dapple_engine::document::palette::Palette;
    ///
    /// let palette = Palette::parse_gpl("GIMP Palette\n240 220 180 fur\n40 30 20 stripes\n", "zebra.gpl")?;
    /// assert_eq!(Palette::parse_gpl(&palette.to_gpl(), "again.gpl")?.colours, palette.colours);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn to_gpl(&self) -> String {
        let stops = self.colours.stops.iter();
        let swatches = stops.map(|stop| Swatch { colour: stop.colour, name: format!("at {}", stop.at) });
        gpl::Palette { name: self.name.clone(), swatches: swatches.collect() }.text()
    }
}

fn palette(root: &Node) -> Result<Palette, Problem> {
    root.keys(&["format", "version", "name", "colours"])?;
    let format = root.need("format", "\"dapple palette\"")?;
    if format.text("\"dapple palette\"")? != FORMAT {
        return Err(format.wrong("\"dapple palette\" (a document is opened as such)"));
    }
    let version = root.need("version", "1")?;
    version.whole(VERSION, VERSION)?;
    let name = root.get("name").map_or(Ok(""), |node| node.text("a text"))?;
    let colours = root.need("colours", "an object with stops and bends")?;
    let colours = reader::colours(&colours)?;
    Ok(Palette { name: name.chars().take(limits::MAX_NAME).collect(), colours })
}

/// The pattern values in the colours' names, if all names have one and they ascend.
fn named(swatches: &[Swatch]) -> Option<Vec<f64>> {
    let place =
        |swatch: &Swatch| swatch.name.strip_prefix("at ")?.parse().ok().filter(|at| limits::STOP.holds(*at));
    let places: Vec<f64> = swatches.iter().map(place).collect::<Option<_>>()?;
    places.is_sorted().then_some(places)
}

/// `count` values at equal steps from 0 to 1; a single one is 0.
fn even(count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    // Four digits are enough, and easier to read than 0.3333333333333333.
    (0..count).map(|index| (1e4 * index as f64 / last).round() / 1e4).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::colours::any_colours;
    use proptest::prelude::*;

    fn said(text: &str) -> String {
        Palette::parse_json(text, "a.json").unwrap_err().to_string()
    }

    #[test]
    fn errors_in_a_palette_name_place_and_value() {
        let with = |rest: &str| format!("{{\"format\": \"dapple palette\", \"version\": 1, {rest}}}");
        assert!(said("{").starts_with("a.json: line 1"), "{}", said("{"));
        assert!(said("{\"format\": \"dapple\"}").contains("a document is opened as such"));
        let newer = said("{\"format\": \"dapple palette\", \"version\": 2, \"colours\": {}}");
        assert!(newer.contains("version: found 2; allowed"), "{newer}");
        let missing = said(&with("\"name\": \"x\""));
        assert!(missing.contains("found no key \"colours\""), "{missing}");
        let colour = said(&with("\"colours\": {\"stops\": [{\"at\": 0, \"colour\": \"red\"}]}"));
        assert!(colour.contains("colours.stops[0].colour: found \"red\"; allowed: #rrggbb"), "{colour}");
        let gpl = Palette::parse_gpl("GIMP Palette\n1 2 x", "a.gpl").unwrap_err().to_string();
        assert!(gpl.starts_with("a.gpl: line 2: found \"1 2 x\""), "{gpl}");
        let none = Palette::parse_gpl("GIMP Palette\n", "a.gpl").unwrap_err().to_string();
        assert!(none.contains("found 0 colours; allowed: 1 to 64"), "{none}");
    }

    #[test]
    fn colours_of_other_programs_are_spread_evenly() {
        let palette =
            Palette::parse_gpl("GIMP Palette\nName: x\n1 1 1 ink\n2 2 2\n3 3 3\tat 0.9\n", "").unwrap();
        assert_eq!(palette.colours.stops.iter().map(|stop| stop.at).collect::<Vec<_>>(), [0.0, 0.5, 1.0]);
    }

    proptest! {
        #[test]
        fn json_keeps_everything(colours in any_colours(), name in "\\PC{0,20}") {
            let palette = Palette { name, colours };
            prop_assert_eq!(Palette::parse_json(&palette.to_json(), "a.json").unwrap(), palette);
        }

        #[test]
        fn gpl_keeps_colours_and_positions(mut colours in any_colours()) {
            colours.stops.iter_mut().for_each(|stop| stop.alpha = u8::MAX);
            let palette = Palette { name: "x y".to_owned(), colours };
            let read = Palette::parse_gpl(&palette.to_gpl(), "a.gpl").unwrap();
            prop_assert_eq!(read.name, palette.name);
            prop_assert_eq!(read.colours.stops, palette.colours.stops);
        }

        #[test]
        fn no_text_makes_it_panic(text in "\\PC{0,60}") {
            let _ = (Palette::parse_json(&text, ""), Palette::parse_gpl(&text, ""));
        }
    }
}
