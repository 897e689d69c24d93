//! `after: "inside"`: a smaller mark at the place of each mark of the layer beneath, which itself is not shown.
//!
//! The ground of Meinhardt's system is inert: spots remain where they began, and none appears elsewhere (`facts.md` G). So the new
//! marks begin at the centroids of those beneath, with parameters for their own area, aspect and angle at the spacing of the layer
//! beneath. The marks of that layer are no obstacles for them.

use crate::attributes::regions::RegionGrid;
use crate::attributes::{AttributeMap, Attributes, Polarity, Spots};
use crate::document::Problem;
use crate::measure::Spot;
use crate::rd::{System, adjust_to_walls};
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Answers;
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};
use crate::synth::training::Training;

/// The problem that the marks of layer `index`, with the attributes of `map`, are no smaller than those looked up `beneath`; `None`
/// if they are smaller.
pub(super) fn too_large(index: usize, map: &AttributeMap, beneath: &Lookup) -> Option<Problem> {
    let layout = map.layout();
    map.regions().find_map(|(place, _)| {
        let center = layout.center(place);
        let there = if map.is_free() { beneath.map.of_region(place) } else { beneath.map.at(center) };
        let (Attributes::Spots(own), Attributes::Spots(there)) = (map.of_region(place), there) else {
            return None;
        };
        (own.area >= there.area).then(|| {
            let found = format!("a mean area of {:.0} px² in region {place:?}", own.area);
            let allowed = format!(
                "smaller marks than those beneath, of {:.0} px² there, as \"after\" is \"inside\"",
                there.area
            );
            Problem::new(format!("layers[{index}].strokes"), found, allowed)
        })
    })
}

/// Looks up a layer with the attributes of `map` inside that of `beneath`, whose spacing it takes.
pub(super) fn look_up(
    training: &Training,
    map: &AttributeMap,
    beneath: &Lookup,
) -> Result<Lookup, PlanError> {
    let spacings = beneath.answers.iter().map(|answer| match answer.predicted {
        Attributes::Spots(Spots { spacing, .. }) => spacing,
        Attributes::Stripes(_) => None,
    });
    let map = map.with_spacings(&spacings.collect::<Vec<_>>());
    let layout = map.layout();
    let room = |place| room(&map.at(layout.center(place)), &beneath.map.at(layout.center(place)));
    let room = map.regions().map(|(place, _)| room(place)).fold(1.0, f64::min);
    let system = System::first(|system| system.fixed_places).expect("spots of a system stay at given places");
    let answers = Answers::new(training);
    let asked = |wanted: &Attributes, cell| answers.ask_placed(system, wanted, room, cell);
    Lookup::new((system, Polarity::Positive), map, Start::Inside, &asked)
}

/// The share of the mean distance that is left to spots in the direction in which their own shape suits the places of the spots
/// `beneath` least: the longer those are, the closer they lie across their direction.
///
/// Its square is the least eigenvalue of O B⁻¹, where O and B are the shapes' metrics of determinant 1.
fn room(own: &Attributes, beneath: &Attributes) -> f64 {
    let (Attributes::Spots(own), Attributes::Spots(beneath)) = (own, beneath) else { return 1.0 };
    // For metrics of eigenvalues e^±l and e^±m, rotated by Δ against each other, half the trace of O B⁻¹ is cosh l cosh m − sinh l
    // sinh m cos 2Δ.
    let [l, m] = [own, beneath].map(|spots| libm::log(spots.aspect));
    let turned = libm::cos((2.0 * (own.angle - beneath.angle)).to_radians());
    let half = libm::cosh(l) * libm::cosh(m) - libm::sinh(l) * libm::sinh(m) * turned;
    (half - (half * half - 1.0).max(0.0).sqrt()).max(0.0).sqrt()
}

/// Places where the marks begin, px: the centres of the `spots` beneath. At closed edges a spot cannot be near the wall, only on
/// it; spots that would be near are moved.
pub(super) fn places_inside(lookup: &Lookup, spots: &[Spot]) -> Vec<[f64; 2]> {
    let centers: Vec<[f64; 2]> =
        spots.iter().filter(|spot| !spot.endless).map(|spot| spot.ellipse.center).collect();
    let layout = lookup.map.layout();
    let maps = lookup.maps(&vec![1.0; layout.len()], &[]);
    let places = adjust_to_walls(lookup.system, &maps, lookup.all_to_cells(&centers));
    lookup.all_to_px(&places)
}

/// Remarks by region on marks that began at the given places: the layer with these places, and the number of places without a mark.
/// `grown` are the marks now, `beneath` is the name of that layer.
#[must_use]
pub fn remarks(layout: &RegionGrid, places: &[[f64; 2]], grown: &[Spot], beneath: &str) -> Vec<Vec<String>> {
    let mut counts = vec![[0usize; 2]; layout.len()];
    let places_and_marks =
        places.iter().map(|at| (0, *at)).chain(grown.iter().map(|mark| (1, mark.ellipse.center)));
    for (kind, point) in places_and_marks {
        counts[layout.index(layout.region_of(point))][kind] += 1;
    }
    // If none is missing on the whole canvas, a mark may have moved over the border of its region.
    let missing = grown.len() < places.len();
    let of_region = |[given, got]: [usize; 2]| {
        let mut remarks = vec![format!(
            "one mark inside each mark of \"{beneath}\", which is not shown; they have the same spacing"
        )];
        if missing && got < given {
            remarks.push(format!(
                "{} of {given} places have no mark inside: they are too close to each other for such marks; \
                 draw smaller ones",
                given - got
            ));
        }
        remarks
    };
    counts.into_iter().map(of_region).collect()
}
