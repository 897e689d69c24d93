//! From a document to a picture.
//!
//!     cargo run --release --example grow -- examples/zebra.dapple zebra.png
//!
//! The ending of the second name says what is written: a picture (`.png`, `.tif`, `.exr`, `.jpg`, `.webp`) or outlines
//! (`.svg`, `.dxf`).

use dapple::Document;
use dapple::prelude::*;
use std::env;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut names = env::args().skip(1);
    let document = names.next().unwrap_or_else(|| "examples/tile-petals.dapple".to_owned());
    let picture = names.next().unwrap_or_else(|| "tile-petals.png".to_owned());
    Document::read(document)?.grow()?.save(picture)?;
    Ok(())
}
