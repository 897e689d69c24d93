//! The picture that drives the pattern of a layer (`"tone"`).

use std::fmt;
use std::sync::{Arc, OnceLock};

use crate::document::Problem;
use crate::document::limits;
use crate::document::node::Node;
use crate::document::shape::{Key, Object, Shape};
use crate::export::gray_png;

/// A picture that drives the pattern of a layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Tone {
    /// The picture.
    pub image: ToneImage,
    /// The share of ink where the picture is white, and where it is black; each 0..1. Falling: a negative.
    pub range: [f64; 2],
    /// The properties of the pattern that follow the picture.
    pub drives: Drives,
    /// Weight of the drawn direction, relative to the mean weight of the picture's edges: 0–[`limits::SKETCH`].
    pub sketch: f64,
    /// Whether the contrast of the picture is evened out, so that all tones occur everywhere.
    pub equalise: bool,
}

impl Tone {
    /// The share of ink at white and at black. A tenth of their distance is about two px of the tone.
    pub const RANGE: [f64; 2] = [0.1, 0.9];
    /// The weight of the drawn direction: flat parts of the picture get straight hatching, and the directions at edges hardly
    /// change.
    pub const SKETCH: f64 = 0.1;

    /// A tone of this picture, with all defaults.
    #[must_use]
    pub fn new(image: ToneImage) -> Self {
        Self { image, range: Self::RANGE, drives: Drives::default(), sketch: Self::SKETCH, equalise: true }
    }
}

/// The properties of a pattern that follow the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drives {
    /// The local share of ink.
    pub level: bool,
    /// Directions: along the edges of the picture.
    pub direction: bool,
    /// Spacing: finer where the picture has details.
    pub spacing: bool,
}

impl Default for Drives {
    fn default() -> Self {
        Self { level: true, direction: true, spacing: true }
    }
}

impl Drives {
    /// Their names in documents.
    pub const NAMES: [&'static str; 3] = ["level", "direction", "spacing"];

    /// The names of the drives that are set.
    #[must_use]
    pub fn names(self) -> Vec<&'static str> {
        let set = [self.level, self.direction, self.spacing];
        Self::NAMES.into_iter().zip(set).filter_map(|(name, set)| set.then_some(name)).collect()
    }
}

/// The gray picture in a document: px of 8 bits, in the coding of sRGB. Copies share it.
#[derive(Clone)]
pub struct ToneImage(Arc<Picture>);

struct Picture {
    size: [usize; 2],
    values: Vec<u8>,
    /// Its PNG in base64, once it has been written.
    text: OnceLock<String>,
}

impl ToneImage {
    /// A picture of `size` px; `None` if the number of `values` differs, or for no px, or more than [`limits::TONE_SIDE`] a side.
    ///
    /// ```
    /// use dapple_engine::document::ToneImage;
    ///
    /// let gray = ToneImage::new([2, 1], vec![0, 255]).unwrap();
    /// assert_eq!((gray.size(), gray.values()), ([2, 1], &[0, 255][..]));
    /// assert!(ToneImage::new([2, 2], vec![0]).is_none());
    /// ```
    #[must_use]
    pub fn new(size: [usize; 2], values: Vec<u8>) -> Option<Self> {
        let side = |side: usize| (1..=limits::TONE_SIDE as usize).contains(&side);
        let fits = size.into_iter().all(side) && values.len() == size[0] * size[1];
        fits.then(|| Self(Arc::new(Picture { size, values, text: OnceLock::new() })))
    }

    /// Width and height, px.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.0.size
    }

    /// The luminance of each px in the coding of sRGB, row by row from the top.
    #[must_use]
    pub fn values(&self) -> &[u8] {
        &self.0.values
    }

    /// Its PNG in base64.
    #[must_use]
    pub fn base64(&self) -> &str {
        self.0.text.get_or_init(|| {
            // Encoding does not fail: any PNG can have sides of 1 to 1024 px, and it is written to memory.
            base64::encode(gray_png::encode(self.0.size, &self.0.values).unwrap_or_default())
        })
    }
}

impl PartialEq for ToneImage {
    fn eq(&self, other: &Self) -> bool {
        let same = |a: &Picture, b: &Picture| a.size == b.size && a.values == b.values;
        Arc::ptr_eq(&self.0, &other.0) || same(&self.0, &other.0)
    }
}

impl fmt::Debug for ToneImage {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [width, height] = self.0.size;
        write!(f, "ToneImage({width} × {height})")
    }
}

pub(super) static TONE: Object = Object {
    name: "Tone",
    keys: &[
        Key::new("image", Shape::Object(&IMAGE), Key::REQUIRED, "the picture, which travels in the document"),
        Key::new(
            "range",
            Shape::Numbers(&[limits::INK; 2]),
            "[0.1, 0.9]",
            "the share of ink where it is white, and where it is black; falling, a negative",
        ),
        Key::new(
            "drives",
            Shape::List(&Shape::Choice(|| Drives::NAMES.to_vec()), [1, 3]),
            "[\"level\", \"direction\", \"spacing\"]",
            "what follows it: the local share of ink, directions, and the spacing, finer where it has details (of spots: where it is darker)",
        ),
        Key::new(
            "sketch",
            Shape::Number(limits::SKETCH),
            "0.1",
            "how much the drawn direction counts, in means of the weight of the picture's edges",
        ),
        Key::new(
            "equalise",
            Shape::Flag,
            "true",
            "whether its contrast is evened out, so that all tones occur everywhere",
        ),
    ],
};

pub(super) static IMAGE: Object =
    Object { name: "Tone image", keys: &[Key::new("png", Shape::Png, Key::REQUIRED, "the picture")] };

/// A layer's tone.
pub(super) fn read(node: &Node) -> Result<Tone, Problem> {
    node.is(&TONE)?;
    let share = limits::INK;
    let range = node.get("range").map_or(Ok(Tone::RANGE), |node| node.numbers([share; 2]))?;
    Ok(Tone {
        image: image(&node.need("image", "an object {\"png\": a gray PNG in base64}")?, REMEDY)?,
        range,
        drives: node.get("drives").map_or(Ok(Drives::default()), |node| drives(&node))?,
        sketch: node.get("sketch").map_or(Ok(Tone::SKETCH), |node| node.number(&limits::SKETCH))?,
        equalise: node.get("equalise").map_or(Ok(true), |node| node.flag())?,
    })
}

/// The remedy for a picture in another form.
const REMEDY: &str = "dapple grow --tone embeds any picture so";

/// Reads the gray picture of `node`; `remedy` tells the user how to convert another picture.
pub(super) fn image(node: &Node, remedy: &str) -> Result<ToneImage, Problem> {
    node.is(&IMAGE)?;
    let node = node.need("png", "a gray PNG in base64")?;
    let most = limits::TONE_SIDE;
    let allowed = format!("a gray PNG of 8 bits and at most {most} px a side in base64 ({remedy})");
    let text = node.text(&allowed)?;
    let wrong = |found: String| node.found(found, allowed.clone());
    let bytes = base64::decode(text).map_err(|error| wrong(format!("no base64 ({error})")))?;
    let (size, values) = gray_png::decode(&bytes, most).map_err(|error| wrong(error.to_string()))?;
    ToneImage::new(size, values).ok_or_else(|| wrong("a PNG without px".to_owned()))
}

fn drives(node: &Node) -> Result<Drives, Problem> {
    let allowed = format!("a list of one or more of {}, each once", Drives::NAMES.join(", "));
    let mut drives = Drives { level: false, direction: false, spacing: false };
    for item in node.items(&allowed)? {
        let choice = item.choice(&[("level", 0), ("direction", 1), ("spacing", 2)])?;
        let one = match choice {
            0 => &mut drives.level,
            1 => &mut drives.direction,
            _ => &mut drives.spacing,
        };
        if std::mem::replace(one, true) {
            return Err(item.wrong(allowed));
        }
    }
    if drives.names().is_empty() { Err(node.found("nothing", allowed)) } else { Ok(drives) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_are_equal_and_copies_share_their_text() {
        let image = |value: u8| ToneImage::new([4, 3], vec![value; 12]).expect("12 px");
        assert!(image(7) == image(7) && image(7) != image(8));
        let (one, copy) = (image(9), image(9).clone());
        assert_eq!(one.base64(), copy.base64());
        assert!(std::ptr::eq(one.base64(), one.clone().base64()));
        assert!(ToneImage::new([4, 3], vec![0; 11]).is_none());
        assert!(ToneImage::new([0, 3], Vec::new()).is_none());
    }
}
