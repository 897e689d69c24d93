//! The pictures that documents of the table name, by formula.

use std::sync::Arc;

use dapple::tone::ToneImage;
use dapple_engine::surface::HeightField;
use serde_json::{Value, json};

/// A picture: its name, its size in px, and its values from 0 (black) to 1 (white) at places from 0 to 1.
type Picture = (&'static str, [usize; 2], fn([f64; 2]) -> f64);

const PICTURES: [Picture; 3] = [
    // From black at the left to white at the right.
    ("ramp", [32, 2], |[x, _]| x),
    // A black disc on white.
    ("disc", [40, 40], |at| 0.5 + 0.5 * libm::tanh(20.0 * (from_centre(at) - 0.3))),
    // White at the centre.
    ("hill", [40, 40], |at| libm::exp(-15.0 * from_centre(at) * from_centre(at))),
];

fn from_centre([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x - 0.5, y - 0.5)
}

/// The size and the values of a picture.
fn values(name: &str) -> Option<([usize; 2], Vec<f64>)> {
    let (_, size, value) = PICTURES.iter().find(|(known, _, _)| *known == name)?;
    let [width, height] = *size;
    let at = |px: usize| [(px % width) as f64 + 0.5, (px / width) as f64 + 0.5].map(f64::from);
    let place = |px: usize| {
        let [x, y] = at(px);
        [x / width as f64, y / height as f64]
    };
    Some((*size, (0..width * height).map(|px| value(place(px))).collect()))
}

/// Replaces the name of a picture in each `{"png": NAME}` by the picture.
pub fn embed(document: &mut Value) {
    match document {
        Value::Array(list) => list.iter_mut().for_each(embed),
        Value::Object(object) => {
            if let Some(picture) = object.get("png").and_then(Value::as_str).and_then(image) {
                object.insert("png".to_owned(), json!(picture.base64()));
            }
            object.values_mut().for_each(embed);
        }
        _ => {}
    }
}

fn image(name: &str) -> Option<ToneImage> {
    let (size, values) = values(name)?;
    ToneImage::new(size, values.iter().map(|value| (255.0 * value).round() as u8).collect())
}

/// A picture as heights.
pub fn heights(name: &str) -> Option<Arc<HeightField>> {
    let (size, values) = values(name)?;
    HeightField::new(size, values.iter().map(|value| *value as f32).collect()).map(Arc::new)
}
