//! Layers whose marks are too dense to grow as drawn spots: a system that is chosen automatically grows patches or cells instead.
//!
//! c = area ÷ (√¾ · spacing²) is the share of the plane that marks cover. Spots of reaction and diffusion reach about .28 of it.
//! Scattered points make patches up to .72. Cells with lines between them cover more than half, and marks that touch are cells rather
//! than one patch.

use crate::attributes::Attributes;
use crate::attributes::regions::{Region, RegionMap};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{AreaKind, Document, Kind, Layer, MapKey, Stroke, SystemChoice};
use crate::grid::Bounds;
use crate::marks::{Ellipse, Mark};

/// The largest c that still grows as spots: the mean over all regions, and the value of any one region. Of 77 irregular marks drawn
/// at c ≈ 0.28, 12 were lost as spots. Figures of papers have single regions up to 0.285 among sparser ones.
const SPOTS: [f64; 2] = [0.265, 0.29];
/// Least c at which marks that touch are cells.
const CELLS: f64 = 0.55;
/// The largest c of patches: denser ones find no room.
const PATCHES: f64 = 0.72;
/// The fewest marks from whose distances a density is computed.
const LEAST: usize = 3;
/// Outlines closer to each other than this, px, merge on a canvas.
const APART: f64 = 2.0;
/// The least share of the marks with a neighbour closer than [`APART`] for the layer to be cells.
const TOUCHING: f64 = 0.5;
/// The largest share of the marks that overlap another one by [`APART`] or more, of layers that are not spots. Above it the layer
/// stays one of spots: patches would merge overlapping marks, whereas one of two spots remains. Of 100 sketches at uniform random
/// places three grew drawn marks as one patch; in these 0.31, 0.38 and 0.58 of the marks overlap another one.
const OVERLAPPING: f64 = 0.25;

impl Document {
    /// The kind of areas that layer `index` grows: that of its system; or, if the system is `"auto"`, patches where outlines are
    /// drawn, and patches or cells where its marks are too dense for spots. `None` for all other layers.
    ///
    /// Both the mean density of the regions and that of the densest region count. A layer stays one of spots if the layer above
    /// grows around, between or inside its marks, or if it has options or maps that areas do not take.
    #[must_use]
    pub fn areas(&self, index: usize) -> Option<AreaKind> {
        let layer = self.layers.get(index)?;
        // Fitting strokes takes long; only layers that may be dense need it.
        let fits = layer.areas().is_none() && self.may_be_areas(index);
        let marks: Vec<Option<Mark>> = layer.strokes.iter().filter(|_| fits).map(Stroke::mark).collect();
        self.areas_of(index, &marks)
    }

    /// The kind of areas that layer `index` grows, see [`Self::areas`]. `marks` are the fitted marks of its strokes, `None` for a
    /// stroke that is no mark.
    #[must_use]
    pub fn areas_of(&self, index: usize, marks: &[Option<Mark>]) -> Option<AreaKind> {
        let layer = self.layers.get(index)?;
        layer.areas().or_else(|| {
            let kind = self.may_be_areas(index).then(|| self.dense(marks)).flatten()?;
            takes(layer, kind).then_some(kind)
        })
    }

    /// The share c of the plane that the drawn marks cover: the mean over the regions, and the largest. `None` for layers that hold
    /// lines, and where there are too few marks to measure a distance.
    #[must_use]
    pub fn drawn_coverage(&self, marks: &[Option<Mark>]) -> Option<[f64; 2]> {
        let ellipses: Vec<Ellipse> =
            marks.iter().map(|mark| mark.as_ref()?.ellipse()).collect::<Option<_>>()?;
        let canvas = Bounds { size: self.size.map(f64::from), edges: self.edges };
        // A mark that is drawn again over another one makes the layer no denser.
        let is_over = |index: &usize| {
            let one = &ellipses[*index];
            ellipses[..*index]
                .iter()
                .any(|other| may_meet(one, other, 0.0, &canvas) && is_within(one, other, &canvas))
        };
        let apart = (0..ellipses.len()).filter(|index| !is_over(index));
        let marks: Vec<Mark> = apart.map(|index| Mark::Ellipse(ellipses[index]).on_tile(&canvas)).collect();
        if marks.len() < LEAST {
            return None;
        }
        let map = RegionMap::from_marks(&marks, canvas.size, self.region_grid(), self.edges).ok()?;
        let all: Vec<f64> = map.regions().filter_map(|(_, region)| coverage(region)).collect();
        let largest = all.iter().copied().reduce(f64::max)?;
        Some([all.iter().sum::<f64>() / all.len() as f64, largest])
    }

    fn may_be_areas(&self, index: usize) -> bool {
        let followed = self.layers.get(index + 1).is_some_and(|above| !above.after.keeps_away());
        let choice = |layer: &Layer| layer.system == SystemChoice::Auto && layer.strokes.len() >= LEAST;
        !followed
            && self.layers.get(index).is_some_and(|layer| choice(layer) && takes(layer, AreaKind::Patches))
    }

    fn dense(&self, marks: &[Option<Mark>]) -> Option<AreaKind> {
        let [mean, coverage] = self.drawn_coverage(marks)?;
        if mean <= SPOTS[0] && coverage <= SPOTS[1] {
            None
        } else if coverage > PATCHES || (coverage > CELLS && self.share_nearer(APART, marks) >= TOUCHING) {
            Some(AreaKind::Polygons)
        } else if self.share_nearer(-APART, marks) >= OVERLAPPING {
            None
        } else {
            Some(AreaKind::Patches)
        }
    }

    /// The share of the marks that are closer than `gap`, px, to another one; a negative gap is an overlap.
    fn share_nearer(&self, gap: f64, marks: &[Option<Mark>]) -> f64 {
        let ellipses: Vec<Ellipse> = marks.iter().flatten().filter_map(Mark::ellipse).collect();
        let canvas = Bounds { size: self.size.map(f64::from), edges: self.edges };
        let is_near = |index: usize| {
            let one = &ellipses[index];
            let others = (0..ellipses.len()).filter(|other| *other != index).map(|other| &ellipses[other]);
            let mut near = others.filter(|other| may_meet(one, other, gap, &canvas));
            near.any(|other| one.gap_to(other, &canvas) < gap)
        };
        let count = (0..ellipses.len()).filter(|index| is_near(*index)).count();
        count as f64 / ellipses.len().max(1) as f64
    }
}

/// Whether two ellipses could be less than `gap` px apart, judged by their largest radii: cheap, since most pairs are far apart.
fn may_meet(one: &Ellipse, other: &Ellipse, gap: f64, canvas: &Bounds) -> bool {
    let way = canvas.shortest([0, 1].map(|axis| other.center[axis] - one.center[axis]));
    let reach = one.radii[0].max(one.radii[1]) + other.radii[0].max(other.radii[1]) + gap;
    way[0] * way[0] + way[1] * way[1] < reach * reach
}

/// Whether the centre of one of two ellipses lies in the other.
fn is_within(one: &Ellipse, other: &Ellipse, canvas: &Bounds) -> bool {
    let way = canvas.shortest([0, 1].map(|axis| other.center[axis] - one.center[axis]));
    let reach = one.radius_towards(way).max(other.radius_towards(way));
    way[0] * way[0] + way[1] * way[1] < reach * reach
}

/// The share c of the marks of a region; `None` for too few marks.
fn coverage(region: &Region) -> Option<f64> {
    let Some(Attributes::Spots(spots)) = region.own.filter(|_| region.marks >= LEAST) else { return None };
    let spacing = spots.spacing?;
    Some(spots.area / (0.75f64.sqrt() * spacing * spacing))
}

/// Whether areas of this kind break no rule on the layer.
fn takes(layer: &Layer, kind: AreaKind) -> bool {
    let system = SystemChoice::Of(kind.description());
    let combination = Combination::new(layer, Some(Kind::Ellipse), Beneath::Unknown);
    // If a map gives area or spacing, the density of the drawn marks is not that of the grown ones.
    let mapped = [MapKey::Area, MapKey::Spacing].iter().any(|key| layer.maps.get(*key).is_some());
    layer.options.irregular == 0.0
        && !mapped
        && layer.after.keeps_away()
        && Combination { system, ..combination }.broken_rule().is_none()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{After, LayerOptions};

    /// A row of three and a row of two discs that cover the share c of the plane, 40 px apart.
    fn document(c: f64, change: impl Fn(Layer) -> Layer) -> Document {
        let radius = 40.0 * (c * 0.75f64.sqrt() / std::f64::consts::PI).sqrt();
        let place = |k: usize| match k {
            0..3 => [60.0 + 40.0 * k as f64, 60.0],
            _ => [80.0 + 40.0 * (k - 3) as f64, 60.0 + 40.0 * 0.75f64.sqrt()],
        };
        let strokes = (0..5).map(|k| Stroke::ellipse(place(k), [radius, radius], 0.0));
        Document::new([240, 160]).with_layer(change(Layer::new(strokes.collect::<Vec<_>>())))
    }

    #[test]
    fn dense_marks_are_patches_and_denser_ones_cells() {
        let of = |c: f64| document(c, |layer| layer).areas(0);
        assert_eq!([0.1, 0.25].map(of), [None; 2]);
        assert_eq!([0.31, 0.5, 0.7].map(of), [Some(AreaKind::Patches); 3]);
        assert_eq!(of(0.76), Some(AreaKind::Polygons));
        // Discs of 0.85 are less than 2 px apart.
        assert_eq!(of(0.85), Some(AreaKind::Polygons));
    }

    #[test]
    fn the_densest_region_has_a_coverage_of_its_own() {
        let mut sheet = document(0.5, |layer| layer);
        sheet.layers[0].strokes.push(Stroke::ellipse([200.0, 20.0], [5.0, 5.0], 0.0));
        sheet.regions = Some([2, 1]);
        let marks: Vec<Option<Mark>> = sheet.layers[0].strokes.iter().map(Stroke::mark).collect();
        let [mean, largest] = sheet.drawn_coverage(&marks).expect("enough marks");
        assert!((largest - 0.5).abs() < 0.02 && mean < largest, "{mean} {largest}");
    }

    #[test]
    fn marks_drawn_again_over_others_make_them_no_denser() {
        let mut sheet = document(0.2, |layer| layer);
        let again: Vec<Stroke> = sheet.layers[0].strokes.clone();
        sheet.layers[0].strokes.extend(again.iter().map(|stroke| {
            let ellipse = stroke.mark().and_then(|mark| mark.ellipse()).expect("an ellipse");
            Stroke::ellipse([ellipse.center[0] + 4.0, ellipse.center[1]], ellipse.radii, 0.0)
        }));
        assert_eq!(sheet.areas(0), None);
    }

    #[test]
    fn marks_that_run_into_each_other_stay_spots() {
        let mut sheet = document(0.5, |layer| layer);
        assert_eq!(sheet.areas(0), Some(AreaKind::Patches));
        // Two of seven marks, whose centres lie outside each other.
        let [x, y] = [140.0, 130.0];
        sheet.layers[0].strokes.push(Stroke::ellipse([x, y], [14.0, 14.0], 0.0));
        sheet.layers[0].strokes.push(Stroke::ellipse([x + 20.0, y], [14.0, 14.0], 0.0));
        assert_eq!(sheet.areas(0), None);
    }

    #[test]
    fn a_layer_with_options_or_maps_that_areas_lack_stays_one_of_spots() {
        let irregular = LayerOptions { irregular: 0.5, ..LayerOptions::default() };
        assert_eq!(document(0.5, |layer| layer.with_options(irregular)).areas(0), None);
        let spots = SystemChoice::Of(crate::rd::System::MEINHARDT_SPOTS.description());
        assert_eq!(document(0.5, |layer| layer.with_system(spots)).areas(0), None);
        let mut ringed = document(0.5, |layer| layer);
        let ring =
            Layer { after: After::Around, ..Layer::new(vec![Stroke::line([9.0, 9.0], [40.0, 9.0], 4.0)]) };
        ringed.layers.push(ring);
        assert_eq!(ringed.areas(0), None);
    }
}
