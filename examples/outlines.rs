//! The outlines of a texture's marks, for a cutter or a plotter.
//!
//!     cargo run --release --example outlines -- leaves.svg
//!
//! Lengths are mm by the document's dpi. A name that ends in `.dxf` writes DXF instead.

use dapple::document::{Document, Layer, Stroke};
use dapple::prelude::*;
use std::env;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let leaves = [[40.0, 60.0], [75.0, 60.0]].map(|center| Stroke::ellipse(center, [16.0, 5.0], 60.0));
    let document = Document { dpi: 100.0, ..Document::new([180, 140]).with_layer(Layer::new(leaves)) };
    let file = env::args().nth(1).unwrap_or_else(|| "leaves.svg".to_owned());
    document.grow()?.save(&file)?;
    let [width, height] = document.size.map(|side| f64::from(side) * 25.4 / document.dpi);
    println!("{file}: {width:.1} × {height:.1} mm");
    Ok(())
}
