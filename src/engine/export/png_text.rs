//! The texts in a PNG (iTXt chunks), read without decoding its px.

use std::io::{BufRead, Seek};

use png::{Decoder, DecodingError, Limits};

/// The first bytes of every PNG.
pub const SIGNATURE: [u8; 8] = *b"\x89PNG\r\n\x1a\n";

/// The reason why the texts of a PNG cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("it is not a whole PNG: {0}")]
pub struct Damaged(String);

/// The text with this `key`, or `None`. It may be stored before the px or, as some programs do, after them.
/// A text has at most `longest` bytes.
///
/// ```
/// use std::io::Cursor;
///
/// use dapple_engine::export::{png, png_text};
///
/// let mut file = Vec::new();
/// png::rgb8(&mut file, [1, 1], None, &[0, 0, 0])?;
/// assert_eq!(png_text::read(Cursor::new(file), "document", 1 << 20)?, None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// It is not a PNG, or a damaged one.
pub fn read(from: impl BufRead + Seek, key: &str, longest: u64) -> Result<Option<String>, Damaged> {
    let damaged = |error: DecodingError| Damaged(error.to_string());
    let longest = usize::try_from(longest).unwrap_or(usize::MAX);
    let mut reader =
        Decoder::new_with_limits(from, Limits { bytes: longest }).read_info().map_err(damaged)?;
    if let Some(text) = found(reader.info(), key)? {
        return Ok(Some(text));
    }
    reader.finish().map_err(damaged)?;
    found(reader.info(), key)
}

fn found(info: &png::Info, key: &str) -> Result<Option<String>, Damaged> {
    let text = info.utf8_text.iter().find(|text| text.keyword == key);
    text.map(|text| text.get_text().map_err(|error| Damaged(error.to_string()))).transpose()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::png::{Header, Samples, write};
    use std::io::Cursor;

    const KEY: &str = "dapple";

    fn picture(texts: &[(&'static str, String)]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let header = Header { texts, ..Header::new([200, 100], Samples::Gray8) };
        write(&mut bytes, header, |rows, band| {
            band.iter_mut().enumerate().for_each(|(i, px)| *px = (i * i / 7 + rows.start) as u8);
            Ok(())
        })
        .unwrap();
        bytes
    }

    fn text(bytes: &[u8]) -> Result<Option<String>, Damaged> {
        read(Cursor::new(bytes), KEY, 1 << 20)
    }

    #[test]
    fn a_text_is_found_by_its_key() {
        let texts = [("other", "no".to_owned()), (KEY, "{\"name\": \"Flußpferd 🦛\"}\n".to_owned())];
        assert_eq!(text(&picture(&texts)).unwrap(), Some(texts[1].1.clone()));
        assert_eq!(text(&picture(&texts[..1])).unwrap(), None);
    }

    #[test]
    fn a_text_after_the_px_is_found_too() {
        let (with, without) = (picture(&[(KEY, "late".to_owned())]), picture(&[]));
        let start = with.windows(4).position(|four| four == b"iTXt").unwrap() - 4;
        let chunk = &with[start..start + with.len() - without.len()];
        let end = without.len() - 12;
        let moved = [&without[..end], chunk, &without[end..]].concat();
        assert_eq!(text(&moved).unwrap(), Some("late".to_owned()));
    }

    #[test]
    fn a_damaged_file_is_an_error() {
        let whole = picture(&[(KEY, "text".to_owned())]);
        assert!(text(b"JPEG").is_err());
        assert!(text(&whole[..40]).is_err());
        let at = whole.windows(4).position(|four| four == b"text").unwrap();
        let mut wrong = whole.clone();
        wrong[at] = b'n';
        assert_ne!(text(&wrong).ok().flatten(), Some("next".to_owned()));
        assert!(text(&picture(&[])[..400]).is_err());
    }
}
