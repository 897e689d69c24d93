//! A sketch made in code: spots, and rings around them, on a seamless tile.
//!
//!     cargo run --release --example sketch -- rosettes.png

use dapple::document::{After, Colours, Document, Edges, Layer, LayerOptions, Stroke};
use dapple::prelude::*;
use std::env;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // Three ellipses say how large the spots are (11 × 8 px), their direction (20°) and how far apart they are (40 px).
    let spots =
        [[40.0, 40.0], [80.0, 40.0], [60.0, 75.0]].map(|center| Stroke::ellipse(center, [11.0, 8.0], 20.0));
    let spots = Layer::new(spots).with_name("spots").with_colours(colours([0xd9, 0x9a, 0x4e]));

    // A line says how wide the rings are; its place does not matter. A quarter of each ring is open.
    let rings = Layer::new([Stroke::line([30.0, 30.0], [60.0, 30.0], 4.0)])
        .with_name("rings")
        .with_after(After::Around)
        .with_options(LayerOptions { broken: 0.25, ..LayerOptions::default() })
        .with_colours(colours([0x2b, 0x1a, 0x10]));

    let document = Document::new([160, 160])
        .with_name("rosettes")
        .with_edges(Edges::Wrap)
        .with_seed(3)
        .with_layer(spots)
        .with_layer(rings);

    let picture = env::args().nth(1).unwrap_or_else(|| "rosettes.png".to_owned());
    document.grow()?.save(&picture)?;
    // The document can be opened in the window, or grown again by `dapple grow rosettes.dapple`.
    document.write("rosettes.dapple")?;
    println!("{picture} and rosettes.dapple are written");
    Ok(())
}

/// From a pale ground to `mark`; the step is as sharp as a px or two.
fn colours(mark: [u8; 3]) -> Colours {
    Colours::new([(0.0, [0xf0, 0xd9, 0xb0]), (0.4, [0xf0, 0xd9, 0xb0]), (0.6, mark), (1.0, mark)])
}
