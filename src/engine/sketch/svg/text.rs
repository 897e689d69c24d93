//! The bytes of an SVG → text: compressed files, encodings other than UTF-8, and numbers with decimal commas.

use std::borrow::Cow;

use usvg::roxmltree::{Document, Node, ParsingOptions};

use super::SvgError;

/// What a gzip file begins with (RFC 1952).
const GZIP: [u8; 2] = [0x1f, 0x8b];
/// The largest text of a compressed file, bytes.
const LARGEST: usize = 64 << 20;
/// Bytes in which the XML declaration is looked for.
const DECLARATION: usize = 200;
/// Attributes that hold one number.
const NUMBERS: [&str; 22] = [
    "x",
    "y",
    "width",
    "height",
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "x1",
    "y1",
    "x2",
    "y2",
    "fx",
    "fy",
    "offset",
    "stroke-width",
    "opacity",
    "fill-opacity",
    "stroke-opacity",
    "stop-opacity",
    "font-size",
];
/// Elements whose `x` and `y` may be lists.
const LISTS: [&str; 3] = ["text", "tspan", "tref"];

/// Whether a file that begins with these bytes is compressed.
pub fn is_compressed(start: &[u8]) -> bool {
    start.starts_with(&GZIP)
}

/// The text of a file.
///
/// # Errors
/// It is no text, its compressed data are damaged, or there is too much of it.
pub(super) fn text(bytes: &[u8]) -> Result<String, SvgError> {
    let unpacked = if is_compressed(bytes) { Cow::Owned(unpacked(bytes)?) } else { Cow::Borrowed(bytes) };
    decoded(&unpacked).ok_or(SvgError::NotText)
}

/// What is in a gzip file (RFC 1952).
fn unpacked(bytes: &[u8]) -> Result<Vec<u8>, SvgError> {
    let data = deflated(bytes).ok_or(SvgError::Packed("its head is damaged".to_owned()))?;
    miniz_oxide::inflate::decompress_to_vec_with_limit(data, LARGEST)
        .map_err(|error| SvgError::Packed(error.to_string()))
}

/// The deflated data of a gzip file: behind the head and its optional fields.
fn deflated(bytes: &[u8]) -> Option<&[u8]> {
    let [check, extra, name, comment] = [2, 4, 8, 16];
    let flags = *bytes.get(3)?;
    let mut rest = bytes.get(10..)?;
    if flags & extra != 0 {
        let length = usize::from(u16::from_le_bytes([*rest.first()?, *rest.get(1)?]));
        rest = rest.get(2 + length..)?;
    }
    for field in [name, comment] {
        if flags & field != 0 {
            let end = rest.iter().position(|byte| *byte == 0)?;
            rest = rest.get(end + 1..)?;
        }
    }
    if flags & check != 0 { rest.get(2..) } else { Some(rest) }
}

/// Text in UTF-8, in UTF-16 with or without a mark, or in Latin-1 and other encodings of one byte a character. Of those only the
/// characters of Windows-1252 are known; others matter to names alone. `None` of what is no text.
fn decoded(bytes: &[u8]) -> Option<String> {
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
        Some(declared_away(String::from_utf16_lossy(&units)))
    };
    match bytes {
        [0xff, 0xfe, rest @ ..] if rest.first() != Some(&0) => return wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => return wide(rest, u16::from_be_bytes),
        [b'<', 0, ..] => return wide(bytes, u16::from_le_bytes),
        [0, b'<', ..] => return wide(bytes, u16::from_be_bytes),
        _ => {}
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Some(text.to_owned());
    }
    // Text of one byte a character holds no zeros, and begins with what all encodings share.
    let is_text = bytes.trim_ascii_start().first() == Some(&b'<') && !bytes.contains(&0);
    is_text.then(|| declared_away(bytes.iter().map(|byte| windows_1252(*byte)).collect()))
}

/// The text without its declaration, which names an encoding that it no longer has.
fn declared_away(text: String) -> String {
    let rest = text.trim_start();
    match rest.strip_prefix("<?xml").and_then(|rest| Some(rest.split_at(rest.find("?>")? + 2))) {
        Some((declaration, rest)) if declaration.len() < DECLARATION => rest.to_owned(),
        _ => text,
    }
}

/// A character of Windows-1252, of which Latin-1 is the part outside of 0x80 to 0x9f.
fn windows_1252(byte: u8) -> char {
    const HIGH: [char; 32] = [
        '€', '\u{fffd}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{fffd}', 'Ž', '\u{fffd}',
        '\u{fffd}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{fffd}', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..=0x9f => HIGH[usize::from(byte - 0x80)],
        byte => char::from(byte),
    }
}

/// How the text is parsed.
pub(super) fn options<'a>() -> ParsingOptions<'a> {
    ParsingOptions { allow_dtd: true, ..ParsingOptions::default() }
}

/// The text with points in place of decimal commas, where attributes that hold one number have such: programs write them in
/// countries with decimal commas. `None` where there are none.
///
/// Commas of lists separate numbers. Where attributes of one number have decimal commas, those of lists are taken for such, too, if
/// each number is followed by a space.
pub(super) fn with_points(text: &str) -> Option<String> {
    let xml = Document::parse_with_options(text, options()).ok()?;
    let (mut single, mut lists) = (Vec::new(), Vec::new());
    for element in xml.descendants().filter(Node::is_element) {
        let has_lists = LISTS.contains(&element.tag_name().name());
        for attribute in element.attributes().filter(|attribute| attribute.namespace().is_none()) {
            let value = text.get(attribute.range_value()).unwrap_or_default();
            match attribute.name() {
                name if NUMBERS.contains(&name) && !has_lists && is_decimal(value) => {
                    single.push(attribute.range_value());
                }
                "style" if value.split(';').any(|part| part.split(':').nth(1).is_some_and(is_decimal)) => {
                    single.push(attribute.range_value());
                }
                "d" | "points" | "viewBox" | "transform" if is_list(value) => {
                    lists.push(attribute.range_value());
                }
                _ => {}
            }
        }
    }
    if single.is_empty() {
        return None;
    }
    let mut bytes = text.as_bytes().to_vec();
    for at in single.into_iter().chain(lists).flatten() {
        if bytes[at] == b',' {
            bytes[at] = b'.';
        }
    }
    String::from_utf8(bytes).ok()
}

/// Whether a value is one number with a decimal comma, with or without a unit.
fn is_decimal(value: &str) -> bool {
    let number = value.trim().trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '%');
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let number = number.trim_start_matches(['-', '+']);
    number.split_once(',').is_some_and(|(whole, rest)| (whole.is_empty() || digits(whole)) && digits(rest))
}

/// Whether every comma of a list may be a decimal one: a digit on either side, at most one in each word, and no points.
fn is_list(value: &str) -> bool {
    let is_word = |word: &str| {
        let (mut parts, last) = (word.split(','), word.matches(',').count());
        let begins = |part: &str| part.bytes().next().is_some_and(|byte| byte.is_ascii_digit());
        last == 0 || last == 1 && parts.nth(1).is_some_and(begins)
    };
    let between = |c: char| c.is_whitespace() || c == '(' || c == ')';
    value.contains(',') && !value.contains('.') && value.split(between).all(is_word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_read_in_the_encodings_that_programs_write() {
        let text = "<?xml version=\"1.0\" encoding=\"E\"?><svg id=\"Löwe\"/>";
        let mut little = vec![0xff, 0xfe];
        little.extend(text.encode_utf16().flat_map(u16::to_le_bytes));
        let mut big = vec![0xfe, 0xff];
        big.extend(text.encode_utf16().flat_map(u16::to_be_bytes));
        let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
        for bytes in [&little[..], &big, &little[2..], &big[2..], &latin] {
            assert_eq!(decoded(bytes).as_deref(), Some("<svg id=\"Löwe\"/>"));
        }
        assert_eq!(decoded(text.as_bytes()).as_deref(), Some(text));
        assert_eq!(decoded(b"\x89PNG\r\n\x1a\n\0"), None);
    }

    #[test]
    fn a_compressed_file_is_unpacked_whatever_its_head_holds() {
        let data = miniz_oxide::deflate::compress_to_vec(b"<svg/>", 6);
        for (flags, fields) in [(0, &b""[..]), (8, b"coat.svg\0"), (4 + 16 + 2, b"\x02\0abwhat\0\x11\x22")] {
            let mut file = vec![0x1f, 0x8b, 8, flags, 0, 0, 0, 0, 0, 3];
            file.extend(fields.iter().chain(&data));
            assert_eq!(text(&file).ok().as_deref(), Some("<svg/>"), "{flags}");
            file.truncate(file.len() - 4);
            assert!(matches!(text(&file), Err(SvgError::Packed(_))));
        }
    }

    #[test]
    fn decimal_commas_become_points_and_commas_of_lists_stay() {
        let points = |text: &str| with_points(text);
        assert_eq!(
            points(
                "<a><r x='1,5' width='20,25mm' style='a:b;stroke-width:,5'/><p d='M 1,5 2,25 L 3 4'/></a>"
            )
            .as_deref(),
            Some("<a><r x='1.5' width='20.25mm' style='a:b;stroke-width:.5'/><p d='M 1.5 2.25 L 3 4'/></a>")
        );
        assert_eq!(
            points("<a><r x='1,5'/><p d='M1.5,2 L3,-4' points='1,2,3'/></a>").as_deref(),
            Some("<a><r x='1.5'/><p d='M1.5,2 L3,-4' points='1,2,3'/></a>")
        );
        assert_eq!(points("<a><text x='1,5'/><p points='1,2 3,4' d='M1,2'/></a>"), None);
    }
}
