//! Fuzz body for SVG: its marks are finite, and the document made of them is valid.

use dapple_engine::marks::Mark;
use dapple_engine::sketch::svg::{DPI, read};
use dapple_engine::synth::import::svg::read_svg;

use crate::kept::comes_back;
use crate::refusal::assert_readable;

const FILE: &str = "bad.svg";

/// `bytes` are a drawing, or are refused.
pub fn holds(bytes: &[u8]) {
    if let Ok(drawing) = read(bytes, Some(DPI)) {
        assert!(drawing.size.iter().all(|side| side.is_finite() && *side > 0.0), "{:?}", drawing.size);
        for mark in drawing.groups.iter().flat_map(|group| &group.marks) {
            let numbers = match mark {
                Mark::Ellipse(e) => vec![e.center[0], e.center[1], e.radii[0], e.radii[1], e.angle],
                Mark::Line(l) => vec![l.from[0], l.from[1], l.to[0], l.to[1], l.width],
                Mark::Path(p) => p.points.iter().flatten().copied().chain([p.width]).collect(),
            };
            assert!(numbers.iter().all(|number| number.is_finite()), "{mark:?}");
        }
    }
    match read_svg(bytes, Some(DPI), FILE) {
        Ok((document, _)) => comes_back(&document),
        Err(error) => assert_readable(&error.to_string(), FILE),
    }
}
