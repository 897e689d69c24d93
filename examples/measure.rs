//! The attributes of what has grown, measured and compared with what was drawn.
//!
//!     cargo run --release --example measure

use dapple::document::{Document, Layer, Stroke};
use dapple::output::{Picture, picture};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let spots =
        [[50.0, 50.0], [86.0, 50.0], [68.0, 81.0]].map(|center| Stroke::ellipse(center, [10.0, 6.0], 30.0));
    let grown = Document::new([240, 240]).with_layer(Layer::new(spots)).grow()?;

    // The edges of the marks are where the pattern is 0.5.
    let pattern = grown.pattern(0).ok_or("the document has one layer")?;
    match picture(&pattern, 0.5) {
        Some(Picture::Spots { marks, got, spread, .. }) => {
            println!("drawn: spots of {:.0} px², aspect 0.60 at 30°", std::f64::consts::PI * 60.0);
            println!(
                "grown: {marks} spots of {:.0} px², aspect {:.2} at {:.0}°",
                got.area, got.aspect, got.angle
            );
            println!("their areas vary by {:.0} %", 100.0 * spread.area);
        }
        Some(Picture::Stripes { got, .. }) => println!("stripes {:.1} px wide", got.width),
        None => println!("neither spots nor stripes"),
    }
    // Growing measures as well, region by region, and says by how much the result is off.
    for region in &grown.report().layers[0].regions {
        for (attribute, error) in &region.error {
            println!("region {:?}: {attribute} is off by {error:.3}", region.place);
        }
    }
    Ok(())
}
