//! The first stage of a plan: the targets in the sketch of a layer.

use crate::attributes::AttributeMap;
use crate::attributes::Attributes;
use crate::document::layer_rules::{self, Combination};
use crate::document::{After, Document, DocumentError, Kind, Layer};
use crate::marks::Mark;
use crate::rd::Seeding;
use crate::synth::drawn::maps::modulated_by;
use crate::synth::drawn::parametric::on_surface;
use crate::synth::drawn::sketch_targets::{marks_on, region_map};
use crate::synth::error::PlanError;
use crate::synth::marks::plan::beyond::beyond;
use crate::synth::marks::plan::layer_lookup::{Lookup, look_up};
use crate::synth::marks::plan::offset_curves::CurveKind;
use crate::synth::marks::plan::{around, inside};
use crate::synth::training::Training;

/// The targets in the sketch of a layer.
pub struct Targets<'a> {
    /// The wanted attributes by place, on the canvas that is grown.
    pub map: AttributeMap,
    layer: &'a Layer,
    place: Place<'a>,
}

/// The relation of the layer to the one beneath.
enum Place<'a> {
    /// Independent of it, with these drawn marks, which stay in place.
    Free(Vec<Mark>),
    /// Inside the marks of that layer.
    Inside(&'a Lookup),
    /// Along curves around its marks, or between them.
    Curves(CurveKind),
}

impl<'a> Targets<'a> {
    /// Reads layer `index` of a document named `source`, on a canvas of `size` px above the layer looked up `beneath`.
    ///
    /// # Errors
    /// The layer cannot be grown as drawn: file, place, value, what is allowed.
    pub fn read(
        document: &'a Document,
        index: usize,
        source: &str,
        size: [f64; 2],
        beneath: Option<&'a Lookup>,
    ) -> Result<Self, DocumentError> {
        let map = region_map(document, index, source)?.resized(size);
        let map = modulated_by(document, index, size, map);
        let map = on_surface(document, source, size, map)?;
        let layer = &document.layers[index];
        let on_pairs = index > 0 && document.pairs(index - 1).is_some();
        let on_areas = index > 0 && document.is_of_points(index - 1);
        let on_tone = index > 0 && document.layers[index - 1].is_driven();
        let below = match beneath {
            _ if on_tone => layer_rules::Beneath::Tone,
            _ if on_pairs => layer_rules::Beneath::Pairs,
            _ if on_areas => layer_rules::Beneath::Areas,
            Some(lookup) => layer_rules::Beneath::Grows(grown_kind(&lookup.map)),
            None if index == 0 || layer.after == After::Inside => layer_rules::Beneath::Nothing,
            None => layer_rules::Beneath::Unknown,
        };
        let combination = Combination::new(layer, Some(grown_kind(&map)), below);
        if let Some(problem) = combination.problem(&format!("layers[{index}]")) {
            return Err(problem.in_file(source));
        }
        let place = if let Some(kind) = around::curve_kind(layer.after) {
            Place::Curves(kind)
        } else if let Some(beneath) = beneath.filter(|_| layer.after == After::Inside) {
            if let Some(problem) = inside::too_large(index, &map, beneath) {
                return Err(problem.in_file(source));
            }
            Place::Inside(beneath)
        } else if document.keeps_marks(index) || layer.options.seeding == Seeding::Initiators {
            Place::Free(marks_on(document, index, source, size)?)
        } else {
            Place::Free(Vec::new())
        };
        Ok(Self { map, layer, place })
    }

    /// Looks up the parameters for the targets.
    ///
    /// # Errors
    /// A training set cannot be read.
    pub fn look_up(self, training: &Training) -> Result<Lookup, PlanError> {
        let Self { map, layer, place } = self;
        let options = &layer.options;
        let lookup = match place {
            Place::Free(marks) => {
                let lookup = look_up(training, layer.wanted_system(), &map)?;
                Lookup { irregular: options.irregular, ..lookup }.with_pinned(training, &marks)?
            }
            Place::Inside(beneath) => inside::look_up(training, &map, beneath)?,
            Place::Curves(kind) => around::look_up(kind, options.broken, map)?,
        };
        let mut lookup = Lookup { seeding: options.seeding, ..lookup };
        if lookup.map.is_modulated() {
            let found = beyond(&lookup, training)?;
            lookup.remarks.iter_mut().zip(found).for_each(|(remarks, found)| remarks.extend(found));
        }
        Ok(lookup)
    }
}

/// The kind of marks that a layer with this map grows.
fn grown_kind(map: &AttributeMap) -> Kind {
    match map.at([0.0, 0.0]) {
        Attributes::Spots(_) => Kind::Ellipse,
        Attributes::Stripes(_) => Kind::Line,
    }
}
