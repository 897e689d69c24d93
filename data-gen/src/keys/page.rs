//! The page of the keys.

use std::fmt::Write;

use super::effect::Effect;
use super::table::{Row, Table};

/// What stands above the tables.
const HEAD: &str = "# What each key changes\n\n\
    Written by `cargo run --release -p data-gen -- cross-talk --only keys`. Each row grows one small document with two values of one key, at the\n\
    left and at the right, and measures both. The documents and the values are in `data-gen/src/keys/pairs.json`; a test compares that list with\n\
    the keys that the program reads. [format.md](format.md) says what the keys mean, [cross-talk.md](cross-talk.md) what else changes when an\n\
    attribute of a sketch does.\n\n\
    Attributes are those of the report of `dapple grow`, of the layer whose key is changed, else of the lowest layer: means over the marks\n\
    that were measured. *Spread* is that of the spots that have grown, *ink* the share of the canvas that marks cover, *luma* the mean over the\n\
    picture, *contrast of neighbours* the root mean square difference of luma of px side by side, *direction* that along which luma changes least\n\
    over the whole picture, and *coherence* how much that is the only one (0 to 1), by its structure tensor. A px differs where a colour of it differs by more than 16 of 255. Most canvases have 160 × 160 px, so that there are few\n\
    marks: means of areas and widths are still as asked, those of spacings vary by some per cent. `ramp` is a picture from black at the left to white\n\
    at the right, `disc` a black disc on white, `hill` a white spot that fades into black, `boxes.obj` a model of two boxes, the groups `left` and\n\
    `right`.\n";

/// The page.
pub fn text(table: &Table, rows: &[Row], effects: &[Effect]) -> String {
    let mut text = HEAD.to_owned();
    let mut object = "";
    for (row, effect) in rows.iter().zip(effects) {
        if row.section.object != object {
            object = &row.section.object;
            text += &heading(row);
        }
        text += &line(row, effect);
    }
    text + &unseen(table)
}

/// The heading of an object and the first lines of its table.
fn heading(row: &Row) -> String {
    let object = &row.section.object;
    let there = row.section.heading.as_ref().unwrap_or(object);
    let anchor = there.to_lowercase().replace(' ', "-");
    format!(
        "\n## {object}\n\nIn [format.md](format.md#{anchor}): {there}.\n\n\
         | key | left, right | pictures | measured |\n|---|---|---|---|\n"
    )
}

/// The row of a pair.
fn line(row: &Row, effect: &Effect) -> String {
    let picture = format!("![Two textures: {}](../assets/keys/{})", row.name(), row.file());
    format!("{} | {picture} | {effect} |\n", first_cells(row))
}

/// The key and its values.
pub fn first_cells(row: &Row) -> String {
    let [left, right] = row.values();
    format!("| `{}` | {left}, {right}", row.pair.key)
}

/// The keys that no picture shows.
fn unseen(table: &Table) -> String {
    let mut text = "\n## Keys without pictures\n\n| object | keys | why |\n|---|---|---|\n".to_owned();
    for unseen in &table.unseen {
        let keys: Vec<String> = unseen.keys.iter().map(|key| format!("`{key}`")).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "| {} | {} | {} |", unseen.object, keys.join(", "), unseen.why);
    }
    text
}
