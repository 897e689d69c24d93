//! Texts about the marks that were found.

use super::job::Found;
use crate::editor::units::Ruler;
use crate::measure::Picture;

/// The heading: the kind of marks, and how many.
#[must_use]
pub fn heading(found: &Found) -> String {
    let many = |count: usize, one: &str, more: &str| {
        if count == 1 { format!("1 {one}") } else { format!("{count} {more}") }
    };
    match found.picture {
        Picture::Spots { marks, .. } => many(marks, "whole spot", "whole spots"),
        Picture::Stripes { marks, .. } => many(marks, "stripe", "stripes"),
    }
}

/// Names and values of what was measured.
#[must_use]
pub fn numbers(found: &Found, ruler: Ruler) -> Vec<(&'static str, String)> {
    match found.picture {
        Picture::Spots { got, .. } => {
            let mut rows = vec![("Area", ruler.area(got.area))];
            if let Some(spacing) = got.spacing {
                rows.push(("Spacing", ruler.length(spacing)));
            }
            rows.push(("Aspect", format!("{:.2}", got.aspect)));
            // The direction of round spots is arbitrary.
            if got.aspect < ROUND {
                rows.push(("Direction", format!("{:.0}°", got.angle)));
            }
            let sizes = found.document.as_ref().ok().map(|imported| &imported.found[..]);
            if let Some([large, small]) = sizes {
                rows.push(("Sizes", format!("{large} large, {small} small")));
            }
            if found.cut > 0 {
                rows.push(("Cut", format!("{} at the border", found.cut)));
            }
            rows
        }
        Picture::Stripes { got, .. } => vec![
            ("Width", ruler.length(got.width)),
            ("Period", ruler.length(got.wavelength)),
            ("Direction", format!("{:.0}°", got.angle)),
        ],
    }
}

/// The least aspect at which a spot is so round that its direction cannot be seen.
const ROUND: f64 = 0.95;

/// The sketch, in words; `None` where there is none.
#[must_use]
pub fn sketch(found: &Found) -> Option<String> {
    let document = &found.document.as_ref().ok()?.document;
    let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    let layers = match document.layers.len() {
        1 => "1 layer".to_owned(),
        layers => format!("{layers} layers"),
    };
    let regions = match document.regions {
        Some([1, 1]) => "1 region".to_owned(),
        Some([columns, rows]) => format!("{columns} × {rows} regions"),
        None => "no regions".to_owned(),
    };
    let [width, height] = document.size;
    Some(format!("{marks} marks, {layers}, {regions}, {width} × {height} px"))
}
