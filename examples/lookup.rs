//! The parameters of a reaction-diffusion system that grow marks of given attributes.
//!
//!     cargo run --release --example lookup

use dapple::lookup::{Attributes, LookedUp, Spots, Stripes, System, Training};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let spots = Spots { area: 300.0, aspect: 0.6, angle: 30.0, spacing: Some(40.0) };
    show(System::MEINHARDT_SPOTS, Attributes::Spots(spots))?;
    let stripes = Stripes { width: 9.0, angle: 120.0, wavelength: None };
    show(System::MEINHARDT_STRIPES, Attributes::Stripes(stripes))
}

/// Prints what `system` needs to grow the attributes that are `wanted` (px, degrees).
fn show(system: System, wanted: Attributes) -> Result<(), Box<dyn Error>> {
    let looked = LookedUp::new(Training::built_in(), system, &wanted)?;
    let (answer, cell) = (looked.predict(), looked.cell);
    println!("{}, on cells of {cell:.2} px:", system.name());
    for (name, value) in answer.parameters.named() {
        println!("  {name:10} {value:.5}");
    }
    println!("  expected: {:?}, which lies {} the training set", answer.predicted, answer.coverage);
    Ok(())
}
