//! A growth as a film.
//!
//!     cargo run --release --example film -- spots.gif
//!
//! A name that ends in `.png` writes an animated PNG instead.

use dapple::Options;
use dapple::document::{Document, Layer, Stroke};
use dapple::output::{Clip, Scene, film_kind};
use dapple::prelude::*;
use std::env;
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let spots = [[40.0, 40.0], [66.0, 40.0]].map(|center| Stroke::ellipse(center, [8.0, 6.0], 45.0));
    let document = Document::new([120, 120]).with_layer(Layer::new(spots));
    let path = PathBuf::from(env::args().nth(1).unwrap_or_else(|| "spots.gif".to_owned()));

    // Frames are as far apart as they look: most of them show the time in which spots appear.
    let clip = Clip { seconds: 2.0, fps: 10, ..Clip::default() };
    let scene = Scene { document: &document, options: Options::default() };
    let (prepared, film) = clip.film_growth(&scene, &path, film_kind(&path)?)?;
    prepared.keep()?;
    println!("{}: {} frames of {} × {} px", path.display(), film.frames, film.size[0], film.size[1]);
    Ok(())
}
