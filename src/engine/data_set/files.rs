//! The files of an item: pictures, tables and one object, as bytes.

use std::fmt::Write;

use super::item::{Item, Settings};
use super::marks::LabelledMark;
use super::tips::Tip;
use crate::attributes::Attribute;
use crate::document::embedded::{Extent, embedded};
use crate::export::Stopped;
use crate::export::png::{Header, Samples, write};
use crate::grid::Field;
use serde_json::{Value, json};

/// The names of an item's files.
pub const FILES: [&str; 7] =
    ["picture.png", "marks.png", "size.png", "direction.png", "marks.csv", "tips.csv", "item.json"];

/// Values a px² of area or a px of width in `size.png`.
const SIZE: f32 = 16.0;
/// Values a degree in `direction.png`.
const DIRECTION: f32 = 360.0;

impl Item {
    /// The bytes of its [`FILES`], with their names.
    ///
    /// # Errors
    /// A picture that PNG cannot hold.
    pub fn files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, Stopped> {
        let side = self.document.size[0] as usize;
        let texts = embedded(&self.document, Extent::default());
        let header =
            Header { texts: &texts, dpi: Some(self.document.dpi), ..Header::new([side; 2], Samples::Rgb8) };
        let marks: Vec<u8> = self.labels.iter().flat_map(|label| label.to_be_bytes()).collect();
        let direction = if self.kind.has_direction() { DIRECTION } else { 0.0 };
        let bytes = [
            png(header, &self.rgb)?,
            png(numbers(side), &marks)?,
            png(numbers(side), &scaled(&self.asked.size, SIZE))?,
            png(numbers(side), &scaled(&self.asked.direction, direction))?,
            marks_table(self).into_bytes(),
            tips_table(&self.tips).into_bytes(),
            format!("{:#}\n", self.object()).into_bytes(),
        ];
        Ok(FILES.into_iter().zip(bytes).collect())
    }

    /// Kind, document, report and counts.
    #[must_use]
    pub fn object(&self) -> Value {
        let document: Value = serde_json::from_str(&self.document.to_json()).unwrap_or_default();
        // As text first: numbers of single precision keep their few digits.
        let report = serde_json::to_string(&self.report).unwrap_or_default();
        let report: Value = serde_json::from_str(&report).unwrap_or_default();
        json!({"item": self.index, "kind": self.kind.name(), "marks": self.marks.len(), "tips": self.tips.len(),
            "document": document, "report": report})
    }
}

/// The object that says what a folder of items is made from.
#[must_use]
pub fn manifest(settings: &Settings) -> Value {
    let kinds: Vec<&str> = settings.kinds.iter().map(|kind| kind.name()).collect();
    json!({"format": "dapple data set", "version": 1, "seed": settings.seed, "size": settings.side, "kinds": kinds})
}

fn numbers(side: usize) -> Header<'static> {
    Header { colours: false, ..Header::new([side; 2], Samples::Gray16) }
}

fn png(header: Header, bytes: &[u8]) -> Result<Vec<u8>, Stopped> {
    let row = header.size[0] * header.samples.bytes();
    let mut out = Vec::new();
    write(&mut out, header, |rows, band| {
        band.copy_from_slice(&bytes[rows.start * row..rows.end * row]);
        Ok(())
    })?;
    Ok(out)
}

/// Values × `factor` as 16-bit numbers, big-endian.
fn scaled(field: &Field, factor: f32) -> Vec<u8> {
    let number = |value: &f32| ((value * factor).round() as u16).to_be_bytes();
    field.values.iter().flat_map(number).collect()
}

/// One row a mark; a cell is empty where its attribute does not apply.
fn marks_table(item: &Item) -> String {
    let asked = [
        Attribute::Area,
        Attribute::Aspect,
        Attribute::Angle,
        Attribute::Spacing,
        Attribute::Width,
        Attribute::Wavelength,
    ];
    let mut text = "label,x,y,whole,area,aspect,angle,width".to_owned();
    asked.iter().for_each(|attribute| text += &format!(",asked_{attribute}"));
    text.push('\n');
    for mark in &item.marks {
        let LabelledMark { label, ellipse, width, angle, whole, .. } = mark;
        let [x, y] = ellipse.center;
        let (area, aspect) = (ellipse.area(), ellipse.aspect());
        let cell = |value: f64, applies: bool| if applies { format!("{value:.3}") } else { String::new() };
        let (angle, width) = (cell(*angle, item.kind.has_direction()), cell(*width, item.kind.is_striped()));
        // Writing to a String cannot fail.
        let _ =
            write!(text, "{label},{x:.3},{y:.3},{},{area:.3},{aspect:.4},{angle},{width}", u8::from(*whole));
        for attribute in asked {
            let applies = item.kind.has_direction() || attribute != Attribute::Angle;
            let value = mark.asked.get(attribute).filter(|_| applies);
            text += &format!(",{}", value.map_or(String::new(), |value| format!("{value:.3}")));
        }
        text.push('\n');
    }
    text
}

/// One row an end or fork.
fn tips_table(tips: &[Tip]) -> String {
    let mut text = "kind,x,y,angle\n".to_owned();
    for Tip { kind, at: [x, y], angle } in tips {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{},{x:.3},{y:.3},{angle:.2}", kind.name());
    }
    text
}

#[cfg(test)]
mod tests {
    use crate::data_set::{Kind, Settings, item};
    use crate::synth::Watch;

    fn settings() -> Settings {
        Settings { seed: 7, side: 96, ..Settings::default() }
    }

    fn bytes(index: u64) -> Vec<(&'static str, Vec<u8>)> {
        item(&settings(), index, &Watch::NONE).expect("an item").files().expect("files")
    }

    #[test]
    fn an_item_depends_on_seed_and_index_alone() {
        let first: Vec<_> = (0..7).map(bytes).collect();
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
        for index in (0..7).rev() {
            assert!(alone.install(|| bytes(index)) == first[index as usize], "{index}");
        }
        assert!(bytes(7) != first[0]);
    }

    #[test]
    fn each_px_of_a_mark_has_its_label_and_the_areas_are_those_of_the_px() {
        for index in 0..7 {
            let item = item(&settings(), index, &Watch::NONE).expect("an item");
            assert_eq!(item.kind, Kind::ALL[index as usize]);
            assert!(!item.marks.is_empty(), "{index}");
            for mark in &item.marks {
                let px = item.labels.iter().filter(|label| **label == mark.label).count() as f64;
                let area = mark.ellipse.area();
                let off = (px - area).abs();
                assert!(
                    off < 3.0 + 0.6 * area.sqrt(),
                    "{} {}: {px} px, {area} px²",
                    item.kind.name(),
                    mark.label
                );
            }
        }
    }
}
