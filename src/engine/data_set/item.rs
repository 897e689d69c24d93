//! One item of a data set: a random sketch, grown and labelled.

use super::asked::AskedFields;
use super::dice::Dice;
use super::kind::Kind;
use super::marks::{LabelledMark, marks};
use super::sketch::sketch;
use super::tips::{Tip, tips};
use crate::document::Document;
use crate::synth::drawn::sketch_targets::region_map;
use crate::synth::layer_report::layer_reports;
use crate::synth::render::painting::Painting;
use crate::synth::report::LayerReport;
use crate::synth::{GrowError, Growth, Options, Watch};

/// Sketches that are tried for an item: of some the marks have no room.
const ATTEMPTS: u64 = 20;

/// What an item depends on beside its index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Seed of the data set.
    pub seed: u64,
    /// Width and height of the pictures, px: [`Settings::SIDES`].
    pub side: u32,
    /// The kinds, at least one: item k is of kind k mod their number.
    pub kinds: Vec<Kind>,
}

impl Settings {
    /// The smallest and the largest pictures.
    pub const SIDES: [u32; 2] = [64, 4096];
    /// The side of pictures where none is asked for, px.
    pub const SIDE: u32 = 256;
}

impl Default for Settings {
    fn default() -> Self {
        Self { seed: 1, side: Self::SIDE, kinds: Kind::ALL.to_vec() }
    }
}

/// A labelled texture.
pub struct Item {
    /// Its index in the data set.
    pub index: u64,
    /// Its kind.
    pub kind: Kind,
    /// The sketch, with its seed and colours: it grows the same texture again at any scale.
    pub document: Document,
    /// Red, green, blue a px, row by row from the top.
    pub rgb: Vec<u8>,
    /// For each px the label of its mark, 0 = ground.
    pub labels: Vec<u16>,
    /// The marks, in the order of their labels.
    pub marks: Vec<LabelledMark>,
    /// Ends and forks of stripes; empty of other kinds.
    pub tips: Vec<Tip>,
    /// What the sketch asks for at each px.
    pub asked: AskedFields,
    /// The report of the layer, with its parameters.
    pub report: LayerReport,
}

/// Why there is no item.
#[derive(Debug, thiserror::Error)]
pub enum ItemError {
    /// The growth was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// None of the sketches that were tried can be grown.
    #[error(
        "item {index}: found {ATTEMPTS} sketches that cannot be grown, the last one because: {why}; allowed: take another seed"
    )]
    Failed {
        /// Its index.
        index: u64,
        /// The reason of the last attempt.
        why: Box<GrowError>,
    },
}

/// Item `index` of a data set.
///
/// ```
/// use dapple_engine::data_set::{Kind, Settings, item};
/// use dapple_engine::synth::Watch;
///
/// let settings = Settings { side: 96, kinds: vec![Kind::Spots], ..Settings::default() };
/// let spots = item(&settings, 5, &Watch::NONE)?;
/// assert_eq!((spots.rgb.len(), spots.labels.len()), (3 * 96 * 96, 96 * 96));
/// # Ok::<(), dapple_engine::data_set::ItemError>(())
/// ```
///
/// # Errors
/// None of several sketches can be grown; or `watch` cancels it.
pub fn item(settings: &Settings, index: u64, watch: &Watch) -> Result<Item, ItemError> {
    let kind = settings.kinds[(index % settings.kinds.len() as u64) as usize];
    let mut attempt = 0;
    loop {
        let mut dice = Dice::of_item(settings.seed, index, attempt);
        let document = sketch(kind, settings.side, &mut dice).with_name(format!(
            "{}, item {index} of seed {}",
            kind.name(),
            settings.seed
        ));
        match labelled(index, kind, document, watch) {
            Ok(item) => return Ok(item),
            Err(GrowError::Cancelled(_)) => return Err(ItemError::Cancelled),
            Err(why) if attempt + 1 == ATTEMPTS => {
                return Err(ItemError::Failed { index, why: Box::new(why) });
            }
            Err(_) => attempt += 1,
        }
    }
}

/// Grows a document and labels its marks.
fn labelled(index: u64, kind: Kind, document: Document, watch: &Watch) -> Result<Item, GrowError> {
    let options = Options { watch: *watch, source: &document.name, ..Options::default() };
    let grown = Growth::begin(&document, &options, None).run()?;
    let map = region_map(&document, 0, &document.name)?;
    let side = document.size[0] as usize;
    let pattern = grown.layers[0].pattern();
    let (labels, marks) = marks(&*pattern, side, kind, &map);
    let tips = if kind.has_tips() { tips(&*pattern, side) } else { Vec::new() };
    let rgb = Painting::new(&document, &grown, 1).rgb();
    let report = layer_reports(&document, &grown).swap_remove(0);
    let asked = AskedFields::new(&map, side);
    drop(pattern);
    Ok(Item { index, kind, rgb, labels, marks, tips, asked, report, document })
}
