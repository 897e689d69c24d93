//! Describes the maps of a layer.

use crate::document::{Layer, LayerMap, MapChange, MapKey, MapSource};
use serde_json::{Map, Value, json};

/// A line for each map of a layer.
pub(super) fn lines(layer: &Layer) -> String {
    layer.maps.iter().map(|(key, map)| format!("  {}\n", described(key, map))).collect()
}

fn described(key: MapKey, map: &LayerMap) -> String {
    let [low, high] = map.range;
    let (from, low_at, high_at) = match &map.source {
        MapSource::Image { image, .. } => {
            let [width, height] = image.size();
            (format!("a picture of {width} × {height} px"), "at black", "at white")
        }
        MapSource::Noise { size, octaves: 1 } => {
            (format!("noise of {size} px"), "at its lowest", "at its highest")
        }
        MapSource::Noise { size, octaves } => {
            (format!("noise of {size} px in {octaves} octaves"), "at its lowest", "at its highest")
        }
    };
    let unit = match key.unit() {
        "" => String::new(),
        unit => format!(" {unit}"),
    };
    let name = key.name();
    match (map.change(key), key) {
        (MapChange::Replace, MapKey::Ground) => {
            format!(
                "{from} gives the share of the second colour of the ground: {low} {low_at} to {high} {high_at}"
            )
        }
        (MapChange::Replace, _) => {
            format!("{from} gives the {name}: {low}{unit} {low_at} to {high}{unit} {high_at}")
        }
        (MapChange::Multiply, MapKey::Colour) => {
            format!("{from} multiplies places in the gradient: by {low} {low_at} to {high} {high_at}")
        }
        (MapChange::Multiply, _) => {
            format!("{from} multiplies the {name}: by {low} {low_at} to {high} {high_at}")
        }
        (MapChange::Add, MapKey::Colour) => {
            format!("{from} shifts places in the gradient: by {low} {low_at} to {high} {high_at}")
        }
        (MapChange::Add, _) => {
            format!("{from} turns directions: by {low}{unit} {low_at} to {high}{unit} {high_at}")
        }
    }
}

/// The entry of a layer in `check --json`, with its maps.
pub(super) fn with_maps(mut found: Value, layer: &Layer) -> Value {
    if let (false, Some(object)) = (layer.maps.is_empty(), found.as_object_mut()) {
        let maps = layer.maps.iter().map(|(key, map)| (key.name().to_owned(), as_json(key, map)));
        object.insert("maps".to_owned(), Value::Object(maps.collect::<Map<_, _>>()));
    }
    found
}

fn as_json(key: MapKey, map: &LayerMap) -> Value {
    let change = match map.change(key) {
        MapChange::Replace => "replace",
        MapChange::Multiply => "multiply",
        MapChange::Add => "add",
    };
    match &map.source {
        MapSource::Image { image, .. } => {
            json!({"image": image.size(), "range": map.range, "change": change})
        }
        MapSource::Noise { size, octaves } => {
            json!({"noise": {"size": size, "octaves": octaves}, "range": map.range, "change": change})
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::ToneImage;

    #[test]
    fn each_map_is_described_with_what_it_does() {
        let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
        let picture =
            |factor, range| LayerMap { source: MapSource::Image { image: image.clone(), factor }, range };
        let noise = |range| LayerMap { source: MapSource::Noise { size: 60.0, octaves: 2 }, range };
        assert_eq!(
            described(MapKey::Area, &picture(false, [80.0, 300.0])),
            "a picture of 2 × 1 px gives the area: 80 px² at black to 300 px² at white"
        );
        assert_eq!(
            described(MapKey::Duty, &noise([0.5, 1.5])),
            "noise of 60 px in 2 octaves multiplies the duty: by 0.5 at its lowest to 1.5 at its highest"
        );
        assert_eq!(
            described(MapKey::Direction, &picture(true, [-20.0, 20.0])),
            "a picture of 2 × 1 px turns directions: by -20 degrees at black to 20 degrees at white"
        );
        assert!(
            described(MapKey::Colour, &noise([-0.2, 0.2])).contains("shifts places in the gradient: by -0.2")
        );
    }
}
