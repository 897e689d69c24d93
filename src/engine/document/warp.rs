//! The warp of a grown texture (`"warp"`): its marks are bent as if drawn on cloth that is pulled.

use serde_json::{Value, json};

use crate::document::Problem;
use crate::document::limits::{self, Range};
use crate::document::node::{Node, number};
use crate::document::shape::{Key, Object, Shape};

/// A displacement of all patterns by the curl of a noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Warp {
    /// Distance from a light place of the noise to the next dark one, px: [`limits::MAP_SIZE`].
    pub size: f64,
    /// Root mean square displacement, px: up to [`Self::STEEPEST`] × size.
    pub by: f64,
}

impl Warp {
    /// The largest displacement ÷ size: beyond it marks fold over.
    pub const STEEPEST: f64 = 0.2;
    /// A first warp: marks of 12 px are clearly bent.
    pub const USUAL: Self = Self { size: 80.0, by: 5.0 };

    /// The displacements that are allowed with its size.
    #[must_use]
    pub fn allowed(&self) -> [f64; 2] {
        [0.0, Self::STEEPEST * self.size]
    }
}

const BY: Range = Range { low: 0.0, high: Warp::STEEPEST * limits::MAP_SIZE.high, unit: "px" };

pub(super) static WARP: Object = Object {
    name: "Warp",
    keys: &[
        Key::new(
            "size",
            Shape::Number(limits::MAP_SIZE),
            Key::REQUIRED,
            "the distance from a light place of the noise to the next dark one",
        ),
        Key::new(
            "by",
            Shape::Number(BY),
            Key::REQUIRED,
            "how far places move, root mean square, px: at most a fifth of `size`",
        ),
    ],
};

/// The warp of a document; those that grow on a model (`on_model`) have none.
pub(super) fn read(node: &Node, on_model: bool) -> Result<Warp, Problem> {
    if on_model {
        let found = "a warp of a document with a model, whose surface has no plane to bend the marks in";
        return Err(node.found(found, "a document without \"model\", or without \"warp\""));
    }
    node.is(&WARP)?;
    let size = node.need("size", &limits::MAP_SIZE.to_string())?.number(&limits::MAP_SIZE)?;
    let by = node.need("by", &BY.to_string())?;
    let warp = Warp { size, by: by.number(&BY)? };
    let [_, most] = warp.allowed();
    if warp.by > most {
        return Err(by.wrong(format!("at most {most} px, a fifth of the size: beyond it marks fold over")));
    }
    Ok(warp)
}

/// The warp as JSON.
pub(super) fn written(warp: &Warp) -> Value {
    json!({"size": number(warp.size), "by": number(warp.by)})
}

#[cfg(test)]
mod tests {
    use crate::document::Document;

    fn parsed(keys: &str) -> Result<Document, String> {
        let text = format!(
            r#"{{"format": "dapple", "version": 2, "size": [96, 96], {keys} "layers":
                [{{"strokes": [{{"kind": "ellipse", "center": [30, 30], "radii": [8, 5]}}]}}]}}"#
        );
        Document::parse(&text, "a").map_err(|error| error.to_string())
    }

    #[test]
    fn a_warp_is_read_and_written() {
        let document = parsed(r#""warp": {"size": 60, "by": 4.5},"#).unwrap();
        assert_eq!(document.warp.map(|warp| [warp.size, warp.by]), Some([60.0, 4.5]));
        assert_eq!(Document::parse(&document.to_json(), "b").unwrap(), document);
    }

    #[test]
    fn a_warp_that_folds_marks_over_or_has_no_plane_is_refused() {
        for (keys, words) in [
            (r#""warp": {"size": 20, "by": 4.1},"#, "at most 4 px, a fifth of the size"),
            (r#""warp": {"size": 20},"#, "no key \"by\""),
            (r#""warp": {"size": 20, "by": 1}, "model": {"file": "sphere"},"#, "without \"warp\""),
        ] {
            let error = parsed(keys).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }
}
