//! The settings file of earlier versions: a line a value, a name and what follows the first space. Several numbers
//! stood side by side, by their position.

use serde_json::{Map, Value, json};

const WHATS: [&str; 4] = ["picture", "material", "outlines", "film"];
const CONTENTS: [&str; 4] = ["texture", "pattern", "labels", "concentrations"];
const FORMATS: [&str; 5] = ["png", "tiff", "exr", "jpeg", "webp"];
const FILMS: [&str; 3] = ["gif", "apng", "folder"];
/// The names of the numbers in `export-outlines`; the first seven are 0 or 1.
const OUTLINES: [&str; 13] = [
    "dxf", "units", "fill", "stroke", "hatch", "cut", "ordered", "level", "spacing", "angle", "pen", "width",
    "area",
];

/// The values of such a file, with the names and types of today.
///
/// # Errors
/// Where the text holds control characters: it is no settings file.
pub(super) fn parse(text: &str) -> Result<Map<String, Value>, String> {
    if text.contains(|letter: char| letter.is_control() && letter != '\n' && letter != '\r') {
        return Err("it holds control characters".to_owned());
    }
    let mut values = Map::new();
    for (name, value) in text.lines().filter_map(|line| line.split_once(' ')) {
        add(&mut values, name, value);
    }
    Ok(values)
}

fn add(values: &mut Map<String, Value>, name: &str, text: &str) {
    let numbers = numbers(text);
    let mut set = |name: &str, value: Option<Value>| {
        // What makes no sense is left out; of several lines the first counts.
        if let Some(value) = value {
            values.entry(name).or_insert(value);
        }
    };
    match name {
        "recent" => push(values, name, text),
        // Whether the page of the first start was read: there is none any more.
        "hint" => {}
        "theme" | "units" | "tab" => set(name, Some(json!(text))),
        "threads" => set(name, text.parse::<usize>().ok().map(Value::from)),
        "new" => set(name, numbers.and_then(|numbers| new(&numbers))),
        "position" | "size" => set(name, numbers.filter(|pair| pair.len() == 2).map(Value::from)),
        "curtain" => set(name, numbers.filter(|share| share.len() == 1).map(|share| json!(share[0]))),
        "grid" => set("regions", yes_or_no(text)),
        "maximised" | "over" | "linked" | "analysis" => set(name, yes_or_no(text)),
        "export" => {
            if let Some((what, picture)) = numbers.and_then(|numbers| picture(&numbers)) {
                set("export", Some(what));
                set("export_picture", Some(picture));
            }
        }
        "export-relief" => merge(values, "export_material", numbers.map(|relief| json!({"relief": relief}))),
        "export-material" => merge(values, "export_material", numbers.and_then(|numbers| material(&numbers))),
        "export-outlines" => set("export_outlines", numbers.and_then(|numbers| outlines(&numbers))),
        "export-film" => set("export_film", numbers.and_then(|numbers| film(&numbers))),
        _ => push(values, name, text),
    }
}

/// Adds to the list `name`.
fn push(values: &mut Map<String, Value>, name: &str, text: &str) {
    if let Value::Array(list) = values.entry(name).or_insert(json!([])) {
        list.push(json!(text));
    }
}

/// Adds fields to the object `name`.
fn merge(values: &mut Map<String, Value>, name: &str, fields: Option<Value>) {
    if let Some(Value::Object(fields)) = fields
        && let Value::Object(object) = values.entry(name).or_insert(json!({}))
    {
        object.extend(fields);
    }
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(' ').map(|number| number.parse().ok().filter(|number: &f64| number.is_finite())).collect()
}

fn yes_or_no(text: &str) -> Option<Value> {
    match text {
        "yes" => Some(json!(true)),
        "no" => Some(json!(false)),
        _ => None,
    }
}

/// A whole number: the types of today do not take 3.0 for 3.
fn whole(number: f64) -> u64 {
    number as u64
}

fn name_at(names: &[&str], index: f64) -> Option<Value> {
    names.get(index as usize).map(|name| json!(name))
}

fn new(numbers: &[f64]) -> Option<Value> {
    let &[width, height, columns, rows, seamless, dpi] = numbers else { return None };
    let (size, regions) = ([width, height].map(whole), [columns, rows].map(whole));
    Some(json!({"size": size, "regions": regions, "seamless": seamless != 0.0, "dpi": dpi}))
}

fn picture(numbers: &[f64]) -> Option<(Value, Value)> {
    let &[what, shows, format, deep, transparent, quality, document] = numbers else { return None };
    let picture = json!({
        "shows": name_at(&CONTENTS, shows)?,
        "format": name_at(&FORMATS, format).unwrap_or(json!(FORMATS[0])),
        "deep": deep != 0.0,
        "transparent": transparent != 0.0,
        "quality": whole(quality.clamp(1.0, 100.0)),
        "document": document != 0.0,
    });
    Some((name_at(&WHATS, what)?, picture))
}

fn material(numbers: &[f64]) -> Option<Value> {
    let [deep, transparent, roughness @ ..] = numbers else { return None };
    Some(json!({"deep": *deep != 0.0, "transparent": *transparent != 0.0, "roughness": roughness}))
}

fn outlines(numbers: &[f64]) -> Option<Value> {
    let numbers: &[f64; 13] = numbers.try_into().ok()?;
    let named = OUTLINES.into_iter().zip(numbers).enumerate().map(|(index, (name, number))| {
        let value = match name {
            "units" if *number != 0.0 => json!("mm"),
            "units" => json!("px"),
            _ if index < 7 => json!(*number != 0.0),
            _ => json!(number),
        };
        (name.to_owned(), value)
    });
    Some(Value::Object(named.collect()))
}

fn film(numbers: &[f64]) -> Option<Value> {
    let &[kind, side, seconds, fps, once, hold] = numbers else { return None };
    let clip = json!({
        "side": (side >= 16.0).then(|| whole(side)),
        "seconds": seconds,
        "fps": whole(fps),
        "once": once != 0.0,
        "hold": hold,
    });
    Some(json!({"kind": name_at(&FILMS, kind).unwrap_or(json!(FILMS[0])), "clip": clip}))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of settings as the last version with lines wrote it.
    const OLD: &str = "\
analysis yes
curtain 0.250
export 1 2 3 1 0 87 0
export-film 2 640 2.5 12 1 0.5
export-material 1 0 0.9 0.25 0.5
export-outlines 1 0 0 1 1 0 1 0.4 2 30 0.5 0.1 0.2
export-relief 4 -2
grid no
hint seen
linked no
maximised yes
new 300 200 3 1 1 150.5
over yes
position -20 40
recent /a/b%0A%25.dapple
recent /c d.dapple
size 900 700
tab colour
theme dark
threads 3
units mm
";

    #[test]
    fn a_whole_file_of_an_earlier_version_is_read() {
        let wanted = json!({
            "analysis": true, "curtain": 0.25, "regions": false, "linked": false,
            "maximised": true, "over": true, "position": [-20.0, 40.0], "size": [900.0, 700.0],
            "recent": ["/a/b%0A%25.dapple", "/c d.dapple"], "tab": "colour", "theme": "dark", "threads": 3,
            "units": "mm",
            "new": {"size": [300, 200], "regions": [3, 1], "seamless": true, "dpi": 150.5},
            "export": "material",
            "export_picture": {"shows": "labels", "format": "jpeg", "deep": true, "transparent": false,
                "quality": 87, "document": false},
            "export_material": {"relief": [4.0, -2.0], "roughness": [0.9, 0.25, 0.5], "deep": true,
                "transparent": false},
            "export_outlines": {"dxf": true, "units": "px", "fill": false, "stroke": true, "hatch": true,
                "cut": false, "ordered": true, "level": 0.4, "spacing": 2.0, "angle": 30.0, "pen": 0.5,
                "width": 0.1, "area": 0.2},
            "export_film": {"kind": "folder", "clip": {"side": 640, "seconds": 2.5, "fps": 12, "once": true,
                "hold": 0.5}},
        });
        assert_eq!(Value::Object(parse(OLD).unwrap()), wanted);
    }

    #[test]
    fn invalid_values_are_left_out_and_unknown_names_are_kept() {
        let text =
            "threads none\nthreads\nnew 1 1 1\nsize 0 inf\ncurtain a\nover maybe\nbrush soft\nbrush hard\n x";
        assert_eq!(Value::Object(parse(text).unwrap()), json!({"brush": ["soft", "hard"], "": ["x"]}));
    }
}
