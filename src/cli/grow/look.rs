//! Options for the picture of a growth.

use crate::cli::values;
use crate::document::embedded::embedded;
use crate::document::{Document, Extent};
use crate::export::picture::QUALITY;
use crate::synth::render::painting::Style;

/// Options for the picture.
#[derive(clap::Args, Clone, Debug)]
pub struct Look {
    /// Make the ground transparent; over the colour of the ground, the picture looks the same as without this option
    #[arg(long)]
    pub transparent: bool,
    /// Bits of each colour: 8 or, in .png and .tif, 16 (.exr has 32)
    #[arg(long, value_name = "BITS", default_value_t = 8, value_parser = values::bits)]
    pub depth: u8,
    #[arg(
        long, value_name = "Q", value_parser = values::whole(1..=100u8),
        help = format!("Quality of a .jpg, 1 to 100 [default: {QUALITY}]")
    )]
    pub quality: Option<u8>,
    /// Do not store the document in the PNG; with it, `dapple grow OUT.png` grows the same picture again
    #[arg(long)]
    pub no_document: bool,
}

impl Look {
    /// The style without its resolution and texts.
    pub fn style(&self) -> Style {
        Style {
            deep: self.depth == 16,
            transparent: self.transparent,
            quality: self.quality.unwrap_or(QUALITY),
            ..Style::default()
        }
    }

    /// The style of a picture of `document`. `refined`: whether the growth was corrected by its measurements.
    pub fn style_for(&self, document: &Document, refined: bool, extent: Extent) -> Style {
        let dpi = document.dpi * f64::from(extent.scale);
        if self.no_document {
            return Style { dpi, ..self.style() };
        }
        let mut document = document.clone();
        document.growth.refine = refined;
        Style { dpi, texts: embedded(&document, extent), ..self.style() }
    }
}
