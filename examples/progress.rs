//! Progress of a growth, and cancelling it.
//!
//!     cargo run --release --example progress

use dapple::document::{Document, Layer, Stroke};
use dapple::{GrowError, Options, Watch};
use std::error::Error;
use std::sync::atomic::{AtomicBool, Ordering};

fn main() -> Result<(), Box<dyn Error>> {
    let spots = [[40.0, 40.0], [70.0, 40.0]].map(|center| Stroke::ellipse(center, [8.0, 5.0], 0.0));
    let document = Document::new([128, 128]).with_layer(Layer::new(spots));

    // `progress` is called with the stage and the share of it that is done, from any thread.
    let watch =
        Watch { progress: &|stage, share| eprintln!("{stage:?}: {:3.0} %", 100.0 * share), ..Watch::NONE };
    let grown = document.grow_with(&Options { watch, ..Options::default() })?;
    println!("grown in {} steps", grown.layers[0].steps());

    // `cancelled` is asked every few milliseconds. Here the growth stops at its first progress; a program would set the
    // flag when its user presses a button.
    let stop = AtomicBool::new(false);
    let watch = Watch {
        progress: &|_, _| stop.store(true, Ordering::Relaxed),
        cancelled: &|| stop.load(Ordering::Relaxed),
    };
    match document.grow_with(&Options { watch, ..Options::default() }) {
        Err(GrowError::Cancelled(_)) => println!("cancelled, as it was asked to be"),
        Err(other) => return Err(other.into()),
        Ok(_) => println!("it was done before it could be cancelled"),
    }
    Ok(())
}
