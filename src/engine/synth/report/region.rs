//! The report of a region: what was asked for, what was looked up, and what grew.

use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::attributes::{Attribute, Attributes, Polarity, Spread};
use crate::learn::Note;
use crate::synth::report::pinned::Stayed;

/// The report of a region of a grown layer. Lengths are px.
#[derive(Clone, Debug)]
pub struct RegionReport {
    /// Column and row.
    pub place: [usize; 2],
    /// Whole spots that were measured; `None` for stripes.
    pub marks: Option<usize>,
    /// Number of these that are two merged spots; `None` for stripes.
    pub merged: Option<usize>,
    /// The attributes that were asked for at its centre.
    pub asked: Attributes,
    /// Whether the lines that grow are its stripes, or the gaps between them.
    pub polarity: Polarity,
    /// Whether the direction of its stripes was asked for: lines around marks, or between them, follow these marks.
    pub directed: bool,
    /// Parameters of the simulation by name, in cells; and `cell`, px a cell.
    pub parameters: Vec<(&'static str, f64)>,
    /// The attributes that the training rows predict; `None` for patches.
    pub predicted: Option<Attributes>,
    /// The attributes that grew.
    pub got: Option<Attributes>,
    /// Raggedness of its patches, or of its roughened edges; `None` for any other.
    pub raggedness: Option<RaggednessReport>,
    /// Errors by attribute: relative for area, spacing, width and wavelength, differences for aspect and angle.
    pub error: Vec<(Attribute, f64)>,
    /// The spread of its spots that was asked for, and the one that grew; `None` if none was asked for.
    pub spread: Option<(Spread, Option<Spread>)>,
    /// Deviation of kept drawn marks from their places.
    pub kept: Option<Stayed>,
    /// Attributes that cannot be reached, and the nearest that can.
    pub beyond: Vec<Note>,
    /// All notes as sentences, including those of `beyond`.
    pub notes: Vec<String>,
}

/// Raggedness of the edges of a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RaggednessReport {
    /// The mean raggedness that was asked for.
    pub asked: f64,
    /// The mean of the grown areas; `None` without whole ones.
    pub got: Option<f64>,
}

/// The JSON of `grow --report`; entries that do not apply are left out.
impl Serialize for RegionReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("region", &self.place)?;
        if let Some(marks) = self.marks {
            map.serialize_entry("marks", &marks)?;
        }
        if let Some(merged) = self.merged {
            map.serialize_entry("merged", &merged)?;
        }
        let ragged = |raggedness| {
            move |attributes| AttributesEntry { attributes, directed: self.directed, raggedness }
        };
        let attributes = ragged(None);
        map.serialize_entry("asked", &ragged(self.raggedness.map(|of| of.asked))(&self.asked))?;
        map.serialize_entry("parameters", &Named(&self.parameters))?;
        if let Some(predicted) = &self.predicted {
            map.serialize_entry("predicted", &attributes(predicted))?;
        }
        if let Some(got) = &self.got {
            map.serialize_entry("got", &ragged(self.raggedness.and_then(|of| of.got))(got))?;
        }
        map.serialize_entry("error", &Named(&self.error))?;
        if let Some((asked, got)) = self.spread {
            map.serialize_entry("spread", &SpreadEntry { asked, got })?;
        }
        if let Some(kept) = &self.kept {
            map.serialize_entry("kept", kept)?;
        }
        map.serialize_entry("notes", &self.notes)?;
        map.end()
    }
}

/// Attributes in the form of the report. The direction of stripes that follow marks (`directed` = false) was not asked for, so that
/// only their width is written.
struct AttributesEntry<'a> {
    attributes: &'a Attributes,
    directed: bool,
    /// Raggedness of patches and roughened edges.
    raggedness: Option<f64>,
}

/// Spots or stripes with their raggedness.
#[derive(serde::Serialize)]
struct Ragged<'a, T: Serialize> {
    #[serde(flatten)]
    marks: &'a T,
    raggedness: f64,
}

impl Serialize for AttributesEntry<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.attributes {
            Attributes::Spots(spots) => match self.raggedness {
                Some(raggedness) => Ragged { marks: spots, raggedness }.serialize(serializer),
                None => spots.serialize(serializer),
            },
            Attributes::Stripes(stripes) if self.directed => match self.raggedness {
                Some(raggedness) => Ragged { marks: stripes, raggedness }.serialize(serializer),
                None => stripes.serialize(serializer),
            },
            Attributes::Stripes(stripes) => {
                let mut named = vec![(Attribute::Width, stripes.width)];
                named.extend(self.raggedness.map(|raggedness| (Attribute::Raggedness, raggedness)));
                Named(&named).serialize(serializer)
            }
        }
    }
}

/// Numbers by name.
struct Named<'a, K>(&'a [(K, f64)]);

impl<K: Copy + Serialize> Serialize for Named<'_, K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

#[derive(serde::Serialize)]
struct SpreadEntry {
    asked: Spread,
    #[serde(skip_serializing_if = "Option::is_none")]
    got: Option<Spread>,
}
