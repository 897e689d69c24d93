//! Reads a map on the command line, and makes it a map of a layer.

use std::path::PathBuf;

use crate::document::{Document, LayerMap, MapKey, MapSource, limits};
use crate::files::read_tone;
use crate::synth::import::measured_picture::MeasureError;

/// A value of `--map`: `area=IMG:LOW:HIGH`, `area=IMG:LOW:HIGH:factor` or `area=noise:SIZE:LOW:HIGH`.
#[derive(Clone, Debug, PartialEq)]
pub struct MapArgument {
    /// The attribute that the map varies.
    pub key: MapKey,
    /// Where its values come from.
    pub source: MapArgumentSource,
    /// The values at black and at white.
    pub range: [f64; 2],
}

/// Where the values of a map come from.
#[derive(Clone, Debug, PartialEq)]
pub enum MapArgumentSource {
    /// A picture file, and whether its values are factors on what the sketch asks for.
    Picture(PathBuf, bool),
    /// Noise of this size, px.
    Noise(f64),
}

impl MapArgument {
    /// The picture file of the map, if it has one.
    #[must_use]
    pub fn picture(&self) -> Option<&PathBuf> {
        if let MapArgumentSource::Picture(path, _) = &self.source { Some(path) } else { None }
    }
}

impl std::str::FromStr for MapArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const ALLOWED: &str = "allowed: WHAT=IMG:LOW:HIGH, WHAT=IMG:LOW:HIGH:factor or WHAT=noise:SIZE:LOW:HIGH, such as area=clouds.png:80:300";
        let names = MapKey::ALL.map(MapKey::name).join(", ");
        let (name, rest) = text.split_once('=').ok_or(ALLOWED)?;
        let key = MapKey::ALL.into_iter().find(|key| key.name() == name);
        let key = key.ok_or_else(|| format!("found {name:?} for WHAT; allowed: {names}"))?;
        let (rest, factor) = rest.strip_suffix(":factor").map_or((rest, false), |rest| (rest, true));
        let number = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite()).ok_or(ALLOWED);
        let (rest, high) = rest.rsplit_once(':').ok_or(ALLOWED)?;
        let (rest, low) = rest.rsplit_once(':').ok_or(ALLOWED)?;
        let source = match rest.strip_prefix("noise:") {
            _ if factor && key == MapKey::Ground => {
                return Err(format!(
                    "the ground has no factor: LOW and HIGH are shares of its second colour; {ALLOWED}"
                ));
            }
            Some(_) if factor => return Err(format!("noise is always a factor; {ALLOWED}")),
            Some(size) => {
                let size = number(size)?;
                let found = || format!("found a size of {size}; allowed: {}", limits::MAP_SIZE);
                MapArgumentSource::Noise(
                    Some(size).filter(|size| limits::MAP_SIZE.holds(*size)).ok_or_else(found)?,
                )
            }
            None if rest.is_empty() => return Err(ALLOWED.to_owned()),
            None => MapArgumentSource::Picture(PathBuf::from(rest), factor),
        };
        let change = key.change(match source {
            MapArgumentSource::Picture(_, factor) => factor,
            MapArgumentSource::Noise(_) => key != MapKey::Colour,
        });
        let allowed = key.allowed(change);
        let range = [number(low)?, number(high)?];
        match range.into_iter().find(|value| !allowed.holds(*value)) {
            Some(value) => Err(format!("found {value} for LOW or HIGH; allowed: {allowed}")),
            None => Ok(Self { key, source, range }),
        }
    }
}

/// Reads the picture that `argument` names, if it names one, and varies the lowest layer of `document` by it.
///
/// # Errors
/// Those of [`read_tone`].
pub fn read_map(document: &mut Document, argument: &MapArgument) -> Result<(), MeasureError> {
    let source = match &argument.source {
        MapArgumentSource::Picture(path, factor) => {
            MapSource::Image { image: read_tone(path)?, factor: *factor }
        }
        MapArgumentSource::Noise(size) => MapSource::Noise { size: *size, octaves: LayerMap::OCTAVES },
    };
    if let Some(layer) = document.layers.first_mut() {
        layer.maps.set(argument.key, Some(LayerMap { source, range: argument.range }));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_is_read_from_its_text() {
        let picture = |factor| MapArgumentSource::Picture(PathBuf::from("C:\\a b.png"), factor);
        let of = |key, source, range| Ok(MapArgument { key, source, range });
        assert_eq!("area=C:\\a b.png:80:300".parse(), of(MapKey::Area, picture(false), [80.0, 300.0]));
        assert_eq!("duty=C:\\a b.png:0.5:2:factor".parse(), of(MapKey::Duty, picture(true), [0.5, 2.0]));
        let noise = MapArgumentSource::Noise(60.0);
        assert_eq!("colour=noise:60:-0.2:0.2".parse(), of(MapKey::Colour, noise, [-0.2, 0.2]));
    }

    #[test]
    fn wrong_maps_are_refused_with_what_is_allowed() {
        let refused = |text: &str| text.parse::<MapArgument>().expect_err(text);
        assert!(refused("size=a.png:1:2").starts_with("found \"size\" for WHAT; allowed: area, spacing"));
        assert!(
            refused("duty=a.png:0.5:2").starts_with("found 2 for LOW or HIGH; allowed: a number from 0.18")
        );
        assert!(refused("area=noise:1:0.5:2").starts_with("found a size of 1; allowed: a number from 2"));
        assert!(refused("ground=a.png:0:1:factor").starts_with("the ground has no factor"));
        for text in
            ["area", "area=a.png", "area=a.png:1", "area=:1:2", "area=a.png:1:x", "area=noise:9:1:2:factor"]
        {
            assert!(refused(text).contains("area=clouds.png:80:300"), "{text}");
        }
    }
}
