//! Files of other formats, recognised by their first bytes.

use std::fmt;

/// Number of bytes from which the kind of a file is recognised.
pub const START: u64 = 4096;

/// A file that is no picture of a format that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Foreign {
    /// The kind of file, in words.
    pub what: &'static str,
    /// The remedy.
    pub remedy: &'static str,
}

impl Foreign {
    /// Whether it is text of an unknown kind.
    #[must_use]
    pub fn is_text(&self) -> bool {
        [TEXT, JSON].contains(&self.what)
    }
}

impl fmt::Display for Foreign {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "it is {}; allowed: JPEG, PNG, WebP, TIFF, BMP, GIF; {}", self.what, self.remedy)
    }
}

const TEXT: &str = "text";
const JSON: &str = "JSON text";
const SAVE: &str = "save or export it as JPEG or PNG";
const DEVELOP: &str = "develop it and save it as JPEG or PNG";
const UNPACK: &str = "unpack it, or export the picture in it as PNG";
const AGAIN: &str = "copy or download it again";
const FRAME: &str = "save one of its pictures as JPEG or PNG";

/// First bytes, the kind of file that begins with them, and the remedy.
const BEGINNINGS: [(&[u8], &str, &str); 37] = [
    (b"\xff\x0a", "a JPEG XL picture", SAVE),
    (b"\0\0\0\x0cJXL ", "a JPEG XL picture", SAVE),
    (b"\0\0\0\x0cjP  ", "a JPEG 2000 picture", SAVE),
    (b"\xff\x4f\xff\x51", "a JPEG 2000 picture", SAVE),
    (b"8BPS", "a Photoshop document", SAVE),
    (b"gimp xcf", "a GIMP document", SAVE),
    (b"%PDF", "a PDF document", SAVE),
    (b"%!PS", "a PostScript drawing", SAVE),
    (b"\xc5\xd0\xd3\xc6", "a PostScript drawing", SAVE),
    (b"P1", "a PNM picture", SAVE),
    (b"P2", "a PNM picture", SAVE),
    (b"P3", "a PNM picture", SAVE),
    (b"P4", "a PNM picture", SAVE),
    (b"P5", "a PNM picture", SAVE),
    (b"P6", "a PNM picture", SAVE),
    (b"P7", "a PNM picture", SAVE),
    (b"\x76\x2f\x31\x01", "an OpenEXR picture", SAVE),
    (b"#?RADIANCE", "a Radiance picture", SAVE),
    (b"DDS ", "a DirectDraw surface", SAVE),
    (b"qoif", "a QOI picture", SAVE),
    (b"\0\0\x01\0", "an icon", SAVE),
    (b"SIMPLE  =", "a FITS picture", SAVE),
    (b"ZISRAWFILE", "a CZI picture of a microscope", SAVE),
    (b"\xda\xce\xbe\x0a", "an ND2 picture of a microscope", SAVE),
    (b"IIRO", "a raw photograph", DEVELOP),
    (b"IIU\0", "a raw photograph", DEVELOP),
    (b"FUJIFILMCCD-RAW", "a raw photograph", DEVELOP),
    (b"\0MRM", "a raw photograph", DEVELOP),
    (b"PK\x03\x04", "a ZIP archive, or a document that is one", UNPACK),
    (b"\x1f\x8b", "a compressed file (gzip)", UNPACK),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive", UNPACK),
    (b"Rar!", "a RAR archive", UNPACK),
    (b"\x1a\x45\xdf\xa3", "a film", FRAME),
    (b"OggS", "a film or a sound", FRAME),
    (b"ID3", "a sound", SAVE),
    (b"{", JSON, SAVE),
    (b"\x7fELF", "a program", SAVE),
];

/// Kinds of ISO media files (ISO/IEC 14496-12), by the brand of the box `ftyp`.
const BRANDS: [(&[u8], &str, &str); 16] = [
    (b"heic", "a HEIC photograph, as telephones take them", SAVE),
    (b"heix", "a HEIC photograph, as telephones take them", SAVE),
    (b"heim", "a HEIC photograph, as telephones take them", SAVE),
    (b"heis", "a HEIC photograph, as telephones take them", SAVE),
    (b"hevc", "a HEIC photograph, as telephones take them", SAVE),
    (b"hevx", "a HEIC photograph, as telephones take them", SAVE),
    (b"mif1", "a HEIF photograph, as telephones take them", SAVE),
    (b"msf1", "a HEIF photograph, as telephones take them", SAVE),
    (b"avif", "an AVIF picture", SAVE),
    (b"avis", "an AVIF picture", SAVE),
    (b"crx ", "a raw photograph", DEVELOP),
    (b"qt  ", "a film", FRAME),
    (b"isom", "a film", FRAME),
    (b"mp41", "a film", FRAME),
    (b"mp42", "a film", FRAME),
    (b"M4V ", "a film", FRAME),
];

/// The kind of a file that begins with these bytes (at least [`START`], or all), if it is certainly not a picture that is read.
#[must_use]
pub fn foreign(bytes: &[u8]) -> Option<Foreign> {
    let start = bytes.get(..START as usize).unwrap_or(bytes);
    let of = |what, remedy| Some(Foreign { what, remedy });
    if start.is_empty() {
        return of("an empty file", AGAIN);
    }
    if start.get(4..8) == Some(b"ftyp") {
        let brand = start.get(8..12).unwrap_or_default();
        // The main brand first; some programs name only a general one there.
        let others = start.get(16..).unwrap_or_default().chunks_exact(4).take(8);
        let known = |brand: &[u8]| BRANDS.iter().find(|(name, ..)| *name == brand);
        let found = known(brand).or_else(|| others.into_iter().find_map(known));
        return found.map_or_else(
            || of("a film or a photograph of a telephone", SAVE),
            |(_, what, remedy)| of(what, remedy),
        );
    }
    if let Some((_, what, remedy)) = BEGINNINGS.iter().find(|(beginning, ..)| start.starts_with(beginning)) {
        return of(what, remedy);
    }
    if start.get(128..132) == Some(b"DICM") {
        return of("a DICOM picture", SAVE);
    }
    if start.get(8..12) == Some(b"CR\x02\0") {
        return of("a raw photograph", DEVELOP);
    }
    if start.iter().all(|byte| *byte == 0) {
        return of("a file of zeros", AGAIN);
    }
    web_page(start)
}

/// The kind of a file that begins with these bytes, if it is a web page or other text.
fn web_page(start: &[u8]) -> Option<Foreign> {
    let text = String::from_utf8_lossy(start).to_ascii_lowercase();
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let is_page = text.starts_with("<!doctype html")
        || text.starts_with("<html")
        || text.starts_with('<') && text.contains("<html");
    if is_page && !text.contains("<svg") {
        let remedy = "save the picture itself, not the page that shows it";
        return Some(Foreign { what: "a web page", remedy });
    }
    let blank = text.is_empty();
    (blank || is_text(start) && !text.starts_with('<')).then_some(Foreign { what: TEXT, remedy: AGAIN })
}

/// Whether all bytes are those of a text in ASCII.
fn is_text(start: &[u8]) -> bool {
    start.iter().all(|byte| matches!(byte, b'\t' | b'\n' | b'\r' | b' '..=b'~'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_other_formats_are_named_with_what_to_do() {
        for (start, what) in [
            (&b"\0\0\0\x24ftypheic\0\0\0\0mif1heic"[..], "HEIC"),
            (b"\0\0\0\x18ftypmif1\0\0\0\0mif1heic", "HEIF"),
            (b"\0\0\0\x1cftypavif\0\0\0\0avifmif1", "AVIF"),
            (b"\0\0\0\x1cftypxxxx\0\0\0\0avifmif1", "AVIF"),
            (b"\0\0\0\x14ftypqt  \0\0\0\0qt  ", "a film"),
            (b"", "an empty file"),
            (b"\0\0\0\0\0\0\0\0\0\0\0\0\0", "zeros"),
            (b"<!DOCTYPE html><html><body>", "a web page"),
            (b"\n<HTML>\n<head>", "a web page"),
            (b"<?xml version=\"1.0\"?>\n<html xmlns=\"a\">", "a web page"),
            (b"404: Not Found", "text"),
            (b"\n\n", "text"),
            (b"%PDF-1.7", "PDF"),
            (b"P6\n4 4\n255\n", "PNM"),
            (b"\xff\x0a\x01", "JPEG XL"),
        ] {
            let found = foreign(start).map(|found| found.to_string()).unwrap_or_default();
            assert!(found.contains(what) && found.contains("allowed: JPEG, PNG"), "{what}: {found}");
        }
        for start in [
            &b"\x89PNG\r\n\x1a\n"[..],
            b"\xff\xd8\xff\xe0",
            b"II*\0",
            b"<svg xmlns='a'>",
            b"BM\x10\0\0\0",
            b"GIF89a\x01",
        ] {
            assert_eq!(foreign(start), None, "{start:?}");
        }
    }
}
