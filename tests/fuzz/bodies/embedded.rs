//! Fuzz body for documents in pictures: a PNG holds a valid document with a size that can be grown, or is refused.

use dapple::document::{in_stream, limits};
use dapple_engine::export::png::{Header, Samples, write};
use dapple_engine::export::png_text::SIGNATURE;
use std::io::Cursor;

use crate::kept::comes_back;
use crate::refusal::assert_readable;

const FILE: &str = "bad.png";

/// `bytes` are a PNG; or the texts of a PNG: the document and, after a zero byte, its size and scale.
pub fn holds(bytes: &[u8]) {
    if bytes.starts_with(&SIGNATURE) {
        restored(bytes);
    } else {
        restored(&with_texts(bytes));
    }
}

fn restored(png: &[u8]) {
    match in_stream(Cursor::new(png), FILE) {
        Ok(Some((document, extent))) => {
            comes_back(&document);
            assert!((1..=64).contains(&extent.scale), "{extent:?}");
            let sides = extent.size.unwrap_or(document.size);
            assert!(sides.iter().all(|side| (1..=limits::MAX_SIDE).contains(side)), "{extent:?}");
        }
        Ok(None) => {}
        Err(error) => assert_readable(&error.to_string(), FILE),
    }
}

/// A PNG of one px that holds these texts.
fn with_texts(bytes: &[u8]) -> Vec<u8> {
    let mut parts = bytes.splitn(2, |byte| *byte == 0);
    let keys = ["dapple", "dapple-grown"].into_iter();
    let texts: Vec<(&'static str, String)> =
        keys.filter_map(|key| Some((key, String::from_utf8_lossy(parts.next()?).into_owned()))).collect();
    let mut png = Vec::new();
    let header = Header { texts: &texts, ..Header::new([1, 1], Samples::Gray8) };
    write(&mut png, header, |_, _| Ok(())).expect("a PNG of one px is written");
    png
}
