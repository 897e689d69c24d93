//! Outlines → SVG 1.1, one group for each layer.

use super::Group;
use super::path::{is_closed, pieces};
use kurbo::{BezPath, PathEl, Point};
use std::collections::BTreeSet;
use std::fmt;
use std::io::{self, Write};

/// The unit of lengths in the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// Canvas px.
    Px,
    /// Millimetres.
    Mm {
        /// px an inch.
        dpi: f64,
    },
}

impl Unit {
    /// Units for each px.
    #[must_use]
    pub fn per_px(self) -> f64 {
        match self {
            Self::Px => 1.0,
            Self::Mm { dpi } => 25.4 / dpi,
        }
    }

    /// Its abbreviation.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Px => "px",
            Self::Mm { .. } => "mm",
        }
    }

    /// The default stroke width: 1 px, or 0.3 mm, the width of a fineliner.
    #[must_use]
    pub fn stroke(self) -> f64 {
        match self {
            Self::Px => 1.0,
            Self::Mm { .. } => 0.3,
        }
    }
}

/// The content of the file except the groups.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The drawing's title; may be empty.
    pub title: String,
    /// The canvas, px.
    pub size: [f64; 2],
    /// The unit of lengths in the file.
    pub unit: Unit,
    /// The width of strokes, in that unit.
    pub stroke_width: f64,
    /// The colour of a rectangle beneath everything; `None` = there is none.
    pub ground: Option<[u8; 3]>,
}

/// Writes the groups.
///
/// # Errors
/// An error of `out`.
pub fn write(out: &mut impl Write, sheet: &Sheet, groups: &[Group]) -> io::Result<()> {
    let scale = sheet.unit.per_px();
    let [width, height] = sheet.size.map(|side| Number(side * scale));
    let unit = sheet.unit.name();
    // So that the canvas has the same number of px when it is imported.
    let dpi = match sheet.unit {
        Unit::Px => String::new(),
        Unit::Mm { dpi } => format!(" data-dpi=\"{dpi}\""),
    };
    writeln!(out, r#"<?xml version="1.0" encoding="UTF-8"?>"#)?;
    writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" version="1.1" width="{width}{unit}" height="{height}{unit}" viewBox="0 0 {width} {height}"{dpi}>"#
    )?;
    if !sheet.title.is_empty() {
        writeln!(out, "<title>{}</title>", Escaped(&sheet.title))?;
    }
    let mut ids = BTreeSet::new();
    if let Some([red, green, blue]) = sheet.ground {
        let colour = format!("#{red:02x}{green:02x}{blue:02x}");
        let id = id("ground", 0, &mut ids);
        writeln!(out, r#"<rect id="{id}" width="{width}" height="{height}" fill="{colour}"/>"#)?;
    }
    for (index, group) in groups.iter().enumerate() {
        let [red, green, blue] = group.colour;
        let colour = format!("#{red:02x}{green:02x}{blue:02x}");
        writeln!(
            out,
            r#"<g id="{}" inkscape:groupmode="layer" inkscape:label="{}">"#,
            id(&group.name, index, &mut ids),
            Escaped(&group.name)
        )?;
        if !group.areas.is_empty() {
            writeln!(out, r#"<g fill="{colour}" fill-rule="evenodd" stroke="none">"#)?;
            for shape in &group.areas {
                write!(out, "<path d=\"")?;
                shape.paths().try_for_each(|path| data(out, path, scale))?;
                writeln!(out, "\"/>")?;
            }
            writeln!(out, "</g>")?;
        }
        if !group.strokes.is_empty() {
            let width = Number(sheet.stroke_width);
            writeln!(
                out,
                r#"<g fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round" stroke-linejoin="round">"#
            )?;
            for path in &group.strokes {
                write!(out, "<path d=\"")?;
                data(out, path, scale)?;
                writeln!(out, "\"/>")?;
            }
            writeln!(out, "</g>")?;
        }
        writeln!(out, "</g>")?;
    }
    writeln!(out, "</svg>")
}

/// A path in the syntax of the attribute `d`. kurbo's own writer gives all 17 digits, twice the bytes.
fn data(out: &mut impl Write, path: &BezPath, scale: f64) -> io::Result<()> {
    let point = |Point { x, y }: Point| Pair(Number(x * scale), Number(y * scale));
    let last = if is_closed(path) { pieces(path).len() } else { usize::MAX };
    for (i, element) in path.elements().iter().enumerate() {
        match *element {
            PathEl::MoveTo(at) => write!(out, "M{}", point(at))?,
            // `Z` draws the last line.
            PathEl::LineTo(_) if i == last => {}
            PathEl::LineTo(end) => write!(out, "L{}", point(end))?,
            PathEl::QuadTo(a, end) => write!(out, "Q{} {}", point(a), point(end))?,
            PathEl::CurveTo(a, b, end) => write!(out, "C{} {} {}", point(a), point(b), point(end))?,
            PathEl::ClosePath => write!(out, "Z")?,
        }
    }
    Ok(())
}

/// A number with at most three decimals: a μm, or a thousandth of a px.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let text = format!("{:.3}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

struct Pair(Number, Number);

impl fmt::Display for Pair {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}", self.0, self.1)
    }
}

/// Text escaped for XML elements and attributes.
struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                // XML 1.0 cannot contain these.
                c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => f.write_str("\u{fffd}")?,
                c => write!(f, "{c}")?,
            }
        }
        Ok(())
    }
}

/// The layer's name as an id of letters, digits, `-`, `_` and `.`, different from those in `taken`.
fn id(name: &str, index: usize, taken: &mut BTreeSet<String>) -> String {
    let mut id: String = name
        .trim()
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() || c == '_' || c == '.' { c } else { '-' })
        .collect();
    if id.chars().all(|c| c == '-') {
        id = format!("layer-{}", index + 1);
    } else if !id.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        id.insert_str(0, "layer-");
    }
    let first = id.clone();
    let mut next = 2;
    while !taken.insert(id.clone()) {
        id = format!("{first}-{next}");
        next += 1;
    }
    id
}
