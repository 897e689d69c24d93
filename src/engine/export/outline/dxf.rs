//! Outlines → DXF, release 12 (AC1009), which the programs of all cutters read.
//!
//! Release 12 has no entry for the unit; a comment names it. Beziers become polylines. y points up in a DXF, so y is flipped.

use super::Group;
use super::path::{flattened, is_closed};
use super::svg::Unit;
use kurbo::{BezPath, Point};
use std::collections::BTreeSet;
use std::io::{self, Write};

/// Largest distance of a polyline from its curve, in the file's unit: 0.01 mm or 0.01 px.
const TOLERANCE: f64 = 0.01;
/// Colour numbers with the same meaning in all readers: red, yellow, green, cyan, blue, magenta, and 7 for black or white.
const COLOURS: [u8; 7] = [7, 1, 5, 3, 6, 4, 2];
/// Longest layer name in release 12, characters.
const LONGEST: usize = 31;

/// Writes the outlines of areas and the strokes of `groups`, on a canvas of `size` px.
///
/// # Errors
/// An error of `out`.
pub fn write(out: &mut impl Write, size: [f64; 2], unit: Unit, groups: &[Group]) -> io::Result<()> {
    let scale = unit.per_px();
    let [width, height] = size.map(|side| side * scale);
    let names = names(groups);
    header(out, [width, height], unit)?;
    tables(out, &names)?;
    pair(out, 0, "SECTION")?;
    pair(out, 2, "ENTITIES")?;
    for (group, name) in groups.iter().zip(&names) {
        let rings = group.areas.iter().flat_map(super::Shape::paths);
        for path in rings.chain(&group.strokes) {
            polyline(out, name, path, scale, height)?;
        }
    }
    pair(out, 0, "ENDSEC")?;
    pair(out, 0, "EOF")
}

fn pair(out: &mut impl Write, code: u16, value: impl std::fmt::Display) -> io::Result<()> {
    write!(out, "{code:>3}\r\n{value}\r\n")
}

fn point(out: &mut impl Write, [x, y]: [f64; 2]) -> io::Result<()> {
    for (code, value) in [(10, x), (20, y), (30, 0.0)] {
        pair(out, code, format_args!("{value:.4}"))?;
    }
    Ok(())
}

fn header(out: &mut impl Write, extent: [f64; 2], unit: Unit) -> io::Result<()> {
    pair(out, 999, format_args!("dapple; lengths in {}", unit.name()))?;
    pair(out, 0, "SECTION")?;
    pair(out, 2, "HEADER")?;
    pair(out, 9, "$ACADVER")?;
    pair(out, 1, "AC1009")?;
    for (name, at) in [("$EXTMIN", [0.0, 0.0]), ("$EXTMAX", extent)] {
        pair(out, 9, name)?;
        point(out, at)?;
    }
    pair(out, 0, "ENDSEC")
}

fn tables(out: &mut impl Write, names: &[String]) -> io::Result<()> {
    pair(out, 0, "SECTION")?;
    pair(out, 2, "TABLES")?;
    pair(out, 0, "TABLE")?;
    pair(out, 2, "LTYPE")?;
    pair(out, 70, 1)?;
    pair(out, 0, "LTYPE")?;
    pair(out, 2, "CONTINUOUS")?;
    pair(out, 70, 0)?;
    pair(out, 3, "Solid line")?;
    pair(out, 72, 65)?;
    pair(out, 73, 0)?;
    pair(out, 40, "0.0")?;
    pair(out, 0, "ENDTAB")?;
    pair(out, 0, "TABLE")?;
    pair(out, 2, "LAYER")?;
    pair(out, 70, names.len())?;
    for (index, name) in names.iter().enumerate() {
        pair(out, 0, "LAYER")?;
        pair(out, 2, name)?;
        pair(out, 70, 0)?;
        pair(out, 62, COLOURS[index % COLOURS.len()])?;
        pair(out, 6, "CONTINUOUS")?;
    }
    pair(out, 0, "ENDTAB")?;
    pair(out, 0, "ENDSEC")
}

fn polyline(out: &mut impl Write, layer: &str, path: &BezPath, scale: f64, height: f64) -> io::Result<()> {
    let mut points = flattened(path, TOLERANCE / scale);
    let closed = is_closed(path);
    if closed {
        points.pop();
    }
    pair(out, 0, "POLYLINE")?;
    pair(out, 8, layer)?;
    pair(out, 66, 1)?;
    point(out, [0.0, 0.0])?;
    pair(out, 70, u8::from(closed))?;
    for Point { x, y } in points {
        pair(out, 0, "VERTEX")?;
        pair(out, 8, layer)?;
        point(out, [x * scale, height - y * scale])?;
    }
    pair(out, 0, "SEQEND")?;
    pair(out, 8, layer)
}

/// The layers' names in release 12: letters, digits, `$`, `-`, `_`, at most 31 characters, all different.
fn names(groups: &[Group]) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let name = |(index, group): (usize, &Group)| {
        let plain = |c: char| if c.is_ascii_alphanumeric() || c == '-' || c == '$' { c } else { '_' };
        let mut name: String = group.name.trim().chars().map(plain).take(LONGEST).collect();
        if name.chars().all(|c| c == '_') {
            name = format!("layer_{}", index + 1);
        }
        let first = name.clone();
        let mut next = 2;
        // DXF names ignore upper and lower case.
        while !taken.insert(name.to_uppercase()) {
            let end = format!("_{next}");
            name = format!("{}{end}", first.chars().take(LONGEST - end.len()).collect::<String>());
            next += 1;
        }
        name
    };
    groups.iter().enumerate().map(name).collect()
}
