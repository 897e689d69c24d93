//! The sketches whose attributes are changed, and where the report says what has grown.

use dapple::document::Document;
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::{Growth, Options};
use serde_json::{Value, json};

use super::effect::Measured;

/// A system, its attributes and their values.
pub struct Subject {
    /// Its heading.
    pub title: &'static str,
    /// What is asked for and measured.
    pub attributes: &'static [&'static str],
    /// The values that are changed, in this order.
    values: &'static [f64],
    /// A layer with these values.
    layer: fn(&[f64]) -> Value,
    /// The value of an attribute in the report of the layer.
    found: fn(&Value, &str) -> Option<f64>,
}

/// Width and height of the canvases, px.
const SIDE: f64 = 448.0;
/// The distance of spots of 300 px² of `turing-spots`, px: that system takes no other.
const TURING_SPACING: f64 = 38.0;

const SPOTS: &[&str] = &["area", "aspect", "angle", "spacing"];
const STRIPES: &[&str] = &["width", "wavelength", "angle"];

pub const SUBJECTS: [Subject; 7] = [
    Subject {
        title: "Spots (`meinhardt-spots`)",
        attributes: SPOTS,
        values: &[300.0, 0.6, 40.0, 48.0],
        layer: |values| spots("meinhardt-spots", values),
        found: of_region,
    },
    Subject {
        title: "Spots (`turing-spots`): their spacing follows from their area",
        attributes: &["area", "aspect", "angle"],
        values: &[300.0, 0.6, 40.0],
        layer: |values| spots("turing-spots", &[values, &[TURING_SPACING]].concat()),
        found: of_region,
    },
    Subject {
        title: "Stripes (`stripes`)",
        attributes: STRIPES,
        values: &[8.0, 26.0, 40.0],
        layer: |values| stripes("stripes", values),
        found: of_region,
    },
    Subject {
        title: "Stripes with tips (`pair-stripes`)",
        attributes: STRIPES,
        values: &[10.0, 24.0, 40.0],
        layer: |values| stripes("pair-stripes", values),
        found: of_thread,
    },
    Subject {
        title: "Weave (`weave`)",
        attributes: &[
            "width",
            "wavelength",
            "angle",
            "width of the others",
            "wavelength of the others",
            "angle of the others",
        ],
        values: &[10.0, 32.0, 40.0, 10.0, 32.0, 130.0],
        layer: weave,
        found: of_thread,
    },
    Subject {
        title: "Patches (`patches`)",
        attributes: SPOTS,
        values: &[900.0, 0.7, 40.0, 52.0],
        layer: |values| spots("patches", values),
        found: of_region,
    },
    Subject {
        title: "Cells (`cells`): their spacing follows from area and gap",
        attributes: &["area", "aspect", "angle", "gap"],
        values: &[1150.0, 0.7, 40.0, 4.0],
        layer: |values| {
            let &[area, aspect, angle, gap] = values else { return Value::Null };
            let mut layer = spots("cells", &[area, aspect, angle, (2.0 * area).sqrt()]);
            layer["options"]["gap"] = json!(gap);
            layer
        },
        found: |layer, name| {
            if name == "gap" { layer["gap"]["got"].as_f64() } else { of_region(layer, name) }
        },
    },
];

impl Subject {
    /// The values that were drawn, in words.
    pub fn about(&self) -> String {
        let named = self.attributes.iter().zip(self.values).map(|(name, value)| format!("{name} {value}"));
        format!("Drawn: {}.", named.collect::<Vec<_>>().join(", "))
    }

    /// Grows its sketch, with one value multiplied by a factor if there is one, and measures its attributes.
    pub fn grown(&self, changed: Option<(usize, f64)>, seed: u64) -> Result<Measured, String> {
        let mut values = self.values.to_vec();
        if let Some((index, factor)) = changed {
            match self.attributes[index].starts_with("angle") {
                true => values[index] += 90.0 * (factor - 1.0),
                false => values[index] *= factor,
            }
        }
        let layer = (self.layer)(&values);
        let size = [SIDE as u32; 2];
        // One region: the attributes are the same far from what is drawn.
        let text = json!({"format": "dapple", "version": 2, "size": size, "regions": [1, 1], "seed": seed,
            "layers": [layer]})
        .to_string();
        let document = Document::parse(&text, self.title).map_err(|error| error.to_string())?;
        let grown =
            Growth::begin(&document, &Options::default(), None).run().map_err(|error| error.to_string())?;
        let report = json!(report(&document, self.title, &grown, 0.0));
        let layer = &report["layers"][0];
        Ok(self.attributes.iter().map(|name| (self.found)(layer, name)).collect())
    }
}

/// Three ellipses at the corners of a triangle, of this area, aspect, angle and spacing.
fn spots(system: &str, values: &[f64]) -> Value {
    let &[area, aspect, angle, spacing] = values else { return Value::Null };
    let along = (area / std::f64::consts::PI / aspect).sqrt();
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]];
    let strokes = corners.map(|[x, y]| {
        let center = [0.4 * SIDE + spacing * x, 0.4 * SIDE + spacing * y];
        json!({"kind": "ellipse", "center": center, "radii": [along, along * aspect], "angle": angle})
    });
    json!({"system": system, "strokes": strokes, "options": {"keep": false}})
}

/// Three lines side by side, of this width, wavelength and angle, around a place.
fn lines(values: &[f64], middle: [f64; 2]) -> Vec<Value> {
    let &[width, wavelength, angle] = values else { return Vec::new() };
    let (s, c) = angle.to_radians().sin_cos();
    let end = |row: f64, along: f64| {
        [middle[0] + along * c - row * wavelength * s, middle[1] + along * s + row * wavelength * c]
    };
    [-1.0, 0.0, 1.0]
        .map(|row| json!({"kind": "line", "from": end(row, -50.0), "to": end(row, 50.0), "width": width}))
        .to_vec()
}

fn stripes(system: &str, values: &[f64]) -> Value {
    json!({"system": system, "strokes": lines(values, [0.5 * SIDE; 2]), "options": {"keep": false}})
}

/// Threads of two directions, drawn across each other.
fn weave(values: &[f64]) -> Value {
    let mut strokes = lines(&values[..3], [0.5 * SIDE; 2]);
    strokes.extend(lines(&values[3..], [0.5 * SIDE; 2]));
    json!({"system": "weave", "strokes": strokes})
}

/// The attributes of the region.
fn of_region(layer: &Value, name: &str) -> Option<f64> {
    layer["regions"][0]["got"][name].as_f64()
}

/// The attributes of the first threads, or of the others.
fn of_thread(layer: &Value, name: &str) -> Option<f64> {
    let (key, thread) = name.strip_suffix(" of the others").map_or((name, 0), |key| (key, 1));
    layer["threads"][thread]["got"][key].as_f64()
}
