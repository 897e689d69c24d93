//! Reads the files that are opened or dropped, on background threads.

use std::path::{Path, PathBuf};

use crate::document::palette::Palette;
use crate::document::{Document, Extent, ToneImage, with_causes};
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::export::has_ending;
use crate::files::{self, ReadFile, import_svg, in_picture, open};
use crate::machine::fs::read_to_string;
use crate::synth::import::svg::{self, Imported, unread_in_words};

/// File name endings of pictures that become a sketch or are shown under the canvas.
const PICTURES: [&str; 8] = ["png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp", "gif"];

/// The content of a file that is to be opened.
pub enum Content {
    /// A document.
    Document(Document),
    /// The document in a picture, and how large the picture is.
    Picture(Document, Extent),
    /// A drawing, imported.
    Drawing(Imported),
}

/// The kind of a dropped file.
pub enum Dropped {
    /// To be opened.
    Document,
    /// Colours for the active layer.
    Palette(Palette),
    /// A picture without a document.
    Picture,
    /// None of these: why.
    Unreadable(String),
}

/// A file that is being read.
pub type Reading = Task<(PathBuf, Result<Content, String>)>;
/// A pasted SVG that is being read: its document, and a text about the parts that were not read.
pub type ReadingSvg = Task<Result<(Document, String), String>>;
/// A palette that is being read.
pub type ReadingPalette = Task<Result<Palette, String>>;
/// A picture that is being read, for a layer to follow.
pub type ReadingTone = Task<Result<ToneImage, String>>;
/// Dropped files whose kind is being determined.
pub type Inspecting = Task<Vec<(PathBuf, Dropped)>>;

/// Reads a document, the document in a picture, or a drawing.
///
/// # Errors
/// Where no thread can be started.
pub fn read(path: &Path, tasks: &Tasks) -> Result<Reading, StartError> {
    let path = path.to_owned();
    tasks.start("reading a file", move |worker: &Worker<_>| {
        let content = content(&path);
        worker.send((path, content));
    })
}

/// Whether a text is an SVG rather than a document: as JSON, a document begins with a brace.
#[must_use]
pub fn is_svg(text: &str) -> bool {
    text.trim_start().starts_with('<') && text.contains("<svg")
}

/// Reads an SVG that is given as text.
///
/// # Errors
/// Where no thread can be started.
pub fn read_svg(text: String, tasks: &Tasks) -> Result<ReadingSvg, StartError> {
    tasks.start("reading a drawing", move |worker: &Worker<_>| {
        let read = svg::read_svg(text.as_bytes(), None, "the clipboard");
        let read = read.map(|(document, unread)| (document, unread_in_words(&unread)));
        worker.send(read.map_err(|error| with_causes(&error)));
    })
}

/// Reads a palette.
///
/// # Errors
/// Where no thread can be started.
pub fn read_palette(path: &Path, tasks: &Tasks) -> Result<ReadingPalette, StartError> {
    let path = path.to_owned();
    tasks.start("reading a palette", move |worker: &Worker<_>| {
        worker.send(Palette::read(&path).map_err(|error| with_causes(&error)));
    })
}

/// Reads a picture for a layer to follow.
///
/// # Errors
/// Where no thread can be started.
pub fn read_tone(path: &Path, tasks: &Tasks) -> Result<ReadingTone, StartError> {
    let path = path.to_owned();
    tasks.start("reading a picture", move |worker: &Worker<_>| {
        worker.send(files::read_tone(&path).map_err(|error| with_causes(&error)));
    })
}

/// Finds out the kinds of dropped files.
///
/// # Errors
/// Where no thread can be started.
pub fn inspect(paths: Vec<PathBuf>, tasks: &Tasks) -> Result<Inspecting, StartError> {
    tasks.start("reading a file", move |worker: &Worker<_>| {
        let kinds = paths.into_iter().map(|path| {
            let kind = kind(&path);
            (path, kind)
        });
        worker.send(kinds.collect());
    })
}

fn content(path: &Path) -> Result<Content, String> {
    if ["svg", "svgz"].iter().any(|ending| has_ending(path, ending)) {
        return import_svg(path, None).map(Content::Drawing).map_err(|error| with_causes(&error));
    }
    let is_picture = !has_ending(path, "dapple") && in_picture(path).is_ok_and(|found| found.is_some());
    let (document, extent) = open(path).map_err(|error| with_causes(&error))?;
    Ok(if is_picture { Content::Picture(document, extent) } else { Content::Document(document) })
}

fn kind(path: &Path) -> Dropped {
    let is = |ending: &&str| has_ending(path, ending);
    let found = if PICTURES.iter().any(is) {
        in_picture(path).map(|found| if found.is_some() { Dropped::Document } else { Dropped::Picture })
    } else if is(&"svg") || is(&"svgz") {
        Ok(Dropped::Document)
    } else if is(&"gpl") || is(&"json") && is_palette(path) {
        return match Palette::read(path) {
            Ok(palette) => Dropped::Palette(palette),
            Err(error) => Dropped::Unreadable(with_causes(&error)),
        };
    } else {
        Document::read(path).map(|_| Dropped::Document)
    };
    found.unwrap_or_else(|error| Dropped::Unreadable(with_causes(&error)))
}

/// Whether a .json holds a palette rather than a document. A file that calls itself a palette counts as one even where
/// it cannot be read, so that the error says what is wrong with the palette.
fn is_palette(path: &Path) -> bool {
    let says_so = || read_to_string(path).is_ok_and(|text| text.contains("dapple palette"));
    Palette::read(path).is_ok() || Document::read(path).is_err_and(|_| says_so())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    const DOCUMENT: &str = r#"{"format": "dapple", "version": 1, "size": [96, 96], "layers": [{"strokes": [
        {"kind": "ellipse", "center": [30, 30], "radii": [8, 5], "angle": 30}]}]}"#;

    const PALETTE: &str = "GIMP Palette\n0 0 0 black\n255 255 255 white\n";

    #[test]
    fn dropped_files_are_told_apart_by_what_they_hold() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            let path = folder.path().join(name);
            fs::write(&path, text).unwrap();
            path
        };
        assert!(matches!(kind(&write("a.dapple", DOCUMENT)), Dropped::Document));
        assert!(matches!(kind(&write("a.json", DOCUMENT)), Dropped::Document));
        assert!(matches!(kind(&write("b.json", r#"{"format": "dapple palette"}"#)), Dropped::Unreadable(_)));
        assert!(matches!(kind(&write("a.gpl", PALETTE)), Dropped::Palette(_)));
        assert!(matches!(kind(&write("a.SVG", "")), Dropped::Document));
        assert!(matches!(kind(&write("a.txt", "")), Dropped::Unreadable(_)));
        let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples/zebra.png");
        assert!(matches!(kind(&picture), Dropped::Picture));
        assert!(matches!(kind(&folder.path().join("nowhere.dapple")), Dropped::Unreadable(_)));
    }

    #[test]
    fn an_svg_is_told_from_a_document_and_read() {
        assert!(!is_svg(DOCUMENT) && !is_svg("some <svg text") && !is_svg("<html></html>"));
        let text = "<?xml version='1.0'?><svg xmlns='http://www.w3.org/2000/svg' width='90' height='60'>\
            <ellipse cx='30' cy='20' rx='8' ry='5'/><text>a</text></svg>";
        assert!(is_svg(text));
        let read = read_svg(text.to_owned(), &Tasks::default()).unwrap().join();
        let [Ok((document, unread))] = &read[..] else { panic!("one document") };
        assert_eq!((document.layers[0].strokes.len(), unread.as_str()), (1, "; not read: 1 × text"));
    }

    #[test]
    fn a_file_is_read_on_a_thread_of_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.dapple");
        fs::write(&path, DOCUMENT).unwrap();
        let read = read(&path, &Tasks::default()).unwrap().join();
        let [(from, Ok(Content::Document(document)))] = &read[..] else { panic!("one document") };
        assert_eq!((from, document.size), (&path, [96, 96]));
    }
}
