//! Regions, marks and colours of a sketch from the marks of a photograph.

use super::lines::{self, Band};
use super::reading::Reading;
use super::regions::{Sample, fewest, region_of};
use super::representatives::{Bounds, representatives};
use super::rosettes::centres;
use super::segmentation::Segmentation;
use super::stops::{Tone, tones};
use super::{layers, watershed};
use crate::attributes::spacing::{WeightedEdge, mean_length, neighbours};
use crate::attributes::{Spots, Spread};
use crate::grid::Field;
use crate::marks::{Ellipse, Mark};
use crate::measure::{Directions, Picture, Regions, is_circle_covered, usual_area, widths};
use crate::points::rosettes::Rosettes;

/// Options for a sketch; by default everything follows from the photograph.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Columns and rows; `None` = as few as explain the marks.
    pub regions: Option<[usize; 2]>,
    /// Number of sizes of spots that become layers of their own, 1 or 2; `None` = two if they are clearly apart.
    pub layers: Option<usize>,
    /// Whether it has all marks, without regions, in place of representatives.
    pub all_marks: bool,
}

/// A sketch of a photograph, px of the photograph.
#[derive(Clone, Debug, PartialEq)]
pub struct Sketch {
    /// Columns and rows; `None` with all marks.
    pub regions: Option<[usize; 2]>,
    /// The lowest first.
    pub layers: Vec<FoundLayer>,
    /// The area between the sizes of two layers, px².
    pub between: Option<f64>,
}

/// Marks of one layer.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundLayer {
    /// The name of its marks.
    pub name: &'static str,
    /// Ellipses, or paths.
    pub marks: Vec<Mark>,
    /// Number of whole marks that they represent.
    pub found: usize,
    /// The mean raggedness of their edges, at least 1; `None` if they are smooth.
    pub raggedness: Option<f64>,
    /// How much spots vary within their regions; `None` if there are too few to tell.
    pub spread: Option<Spread>,
    /// What marks that are rosettes are like; their outlines are the marks.
    pub rosettes: Option<Rosettes>,
    /// Colours, ascending by pattern value; empty for a pattern without colours.
    pub tones: Vec<Tone>,
}

/// Share of the picture from which on marks are dense: spots of reaction and diffusion reach 0.28.
pub const DENSE: f64 = 0.3;
/// Least share of the usual area for the visible part of a mark that the border cuts to be drawn. Not tuned.
const LEAST_PART: f64 = 0.15;
/// The least aspect of such a part: narrower ones are slivers along the border. Not tuned.
const NARROWEST_PART: f64 = 0.3;
/// Ragged spots below this share of the usual area are fringes that have separated from others.
const FRINGE: f64 = 0.2;

/// Least raggedness of rosettes that are drawn ragged: gaps between blotches dent the outlines of round ones. Those of the two leopards in
/// the gallery, which are round, are read as 1.02 and 1.10.
const RAGGED_ROSETTES: f64 = 1.12;

/// A sketch of the marks of a photograph; `size` is that of the photograph, px.
#[must_use]
pub fn sketch(reading: &Reading, size: [usize; 2], wanted: &Wanted) -> Sketch {
    match reading.picture {
        Picture::Spots { raggedness, .. } => of_spots(reading, size, wanted, raggedness),
        Picture::Stripes { marks, .. } => of_stripes(reading, size, wanted, marks),
    }
}

/// The part of a canvas that is region `k`, px.
fn bounds(size: [usize; 2], [columns, rows]: [usize; 2], k: usize) -> Bounds {
    let side = [size[0] as f64 / columns as f64, size[1] as f64 / rows as f64];
    let low = [(k % columns) as f64 * side[0], (k / columns) as f64 * side[1]];
    Bounds { low, high: [low[0] + side[0], low[1] + side[1]] }
}

fn share(place: [f64; 2], size: [usize; 2]) -> [f64; 2] {
    [place[0] / size[0] as f64, place[1] / size[1] as f64]
}

fn of_spots(reading: &Reading, size: [usize; 2], wanted: &Wanted, raggedness: Option<f64>) -> Sketch {
    let whole = |spot: &&crate::measure::Spot| spot.whole;
    let areas: Vec<f64> = reading.spots.iter().filter(whole).map(|spot| spot.ellipse.area()).collect();
    let between = match (wanted.layers, raggedness) {
        (Some(1), _) | (None, Some(_)) => None,
        (layers, _) => layers::between_sizes(&areas, layers == Some(2)),
    };
    // Ragged spots lose fringes, which are not spots of a second size.
    let least = if raggedness.is_some() && between.is_none() {
        FRINGE * usual_area(areas.iter().copied())
    } else {
        0.0
    };
    // Each layer holds the areas within a range.
    let ranges: Vec<(&'static str, [f64; 2])> = match between {
        Some(area) => vec![("large spots", [area, f64::INFINITY]), ("small spots", [0.0, area])],
        None => vec![("spots", [least, f64::INFINITY])],
    };
    let holds = |range: &[f64; 2], area: f64| range[0] <= area && area < range[1];
    let of_layer = |range: [f64; 2]| -> Vec<crate::measure::Spot> {
        reading.spots.iter().filter(|spot| holds(&range, spot.ellipse.area())).copied().collect()
    };
    let groups: Vec<Vec<crate::measure::Spot>> = ranges.iter().map(|(_, range)| of_layer(*range)).collect();
    let regions = wanted.regions.unwrap_or_else(|| {
        let each = groups.iter().map(|spots| fewest(&samples_of_spots(spots, size)));
        // The finest layout that a layer needs.
        each.max_by_key(|[columns, rows]| columns * rows).unwrap_or([1, 1])
    });
    let by_cell = between.map(|_| watershed::areas(&reading.segmentation.field, reading.segmentation.level));
    let layers = ranges.iter().zip(&groups).map(|((name, range), spots)| {
        let whole: Vec<Ellipse> = spots.iter().filter(whole).map(|spot| spot.ellipse).collect();
        let mut found = whole.len();
        // Small spots grow between the large ones.
        let is_large = |[x, y]: [f64; 2]| {
            let Field { width, height, cell, .. } = reading.segmentation.field;
            let [column, row] = [(x / cell[0]) as usize, (y / cell[1]) as usize];
            let inside = x >= 0.0 && y >= 0.0 && column < width && row < height;
            by_cell.as_ref().is_some_and(|areas| inside && areas[row * width + column] >= range[1])
        };
        let ellipses = if wanted.all_marks {
            let all = with_cut(whole, spots);
            found = all.len();
            all
        } else {
            let ink = if ranges.len() == 1 { dense_ink(reading, size, regions) } else { Vec::new() };
            by_region(spots, size, regions, is_large, &ink)
        };
        let counts = |cell: usize| by_cell.as_ref().is_none_or(|areas| holds(range, areas[cell]));
        let (tones, rosettes) = appearance(reading, counts);
        FoundLayer {
            name,
            marks: ellipses.into_iter().map(Mark::Ellipse).collect(),
            found,
            raggedness: raggedness.filter(|found| rosettes.is_none() || *found >= RAGGED_ROSETTES),
            spread: spread(spots, size, regions),
            rosettes,
            tones,
        }
    });
    Sketch {
        regions: (!wanted.all_marks).then_some(regions),
        layers: layers.filter(|layer| !layer.marks.is_empty()).collect(),
        between,
    }
}

/// The colours of the marks that count, and what they are like as rosettes.
fn appearance(reading: &Reading, counts: impl Fn(usize) -> bool) -> (Vec<Tone>, Option<Rosettes>) {
    match &reading.rosettes {
        None => (colours(reading, counts), None),
        Some(rosettes) => {
            let (tones, like) = centres::tones(reading.segmentation.lab.as_deref(), rosettes);
            (tones, Some(like))
        }
    }
}

/// The `whole` ellipses, and the visible parts of `spots` that the border cuts: without these the border of the sketch would be
/// empty.
fn with_cut(whole: Vec<Ellipse>, spots: &[crate::measure::Spot]) -> Vec<Ellipse> {
    let least = LEAST_PART * usual_area(whole.iter().map(Ellipse::area));
    let is_cut = |spot: &&crate::measure::Spot| {
        !spot.whole && spot.ellipse.area() >= least && spot.ellipse.aspect() >= NARROWEST_PART
    };
    let cut = spots.iter().filter(is_cut).map(|spot| spot.ellipse);
    whole.into_iter().chain(cut).collect()
}

fn samples_of_spots(spots: &[crate::measure::Spot], size: [usize; 2]) -> Vec<Sample> {
    let sample = |ellipse: &Ellipse| {
        let (sin, cos) = libm::sincos(2.0 * ellipse.major_angle().to_radians());
        let long = -libm::log(ellipse.aspect().max(1e-3));
        Sample {
            place: share(ellipse.center, size),
            value: [libm::log(ellipse.area()), long * cos, long * sin],
        }
    };
    spots.iter().filter(|spot| spot.whole).map(|spot| sample(&spot.ellipse)).collect()
}

/// Fewest whole spots whose spread says more than that of the drawn ones.
const VARIED: usize = 12;

/// How much the whole spots vary about the means of their regions: the mean over the regions, by their numbers of spots.
fn spread(spots: &[crate::measure::Spot], size: [usize; 2], regions: [usize; 2]) -> Option<Spread> {
    let mut whole = vec![Vec::new(); regions[0] * regions[1]];
    for spot in spots.iter().filter(|spot| spot.whole) {
        whole[region_of(share(spot.ellipse.center, size), regions)].push(spot.ellipse);
    }
    let count = whole.iter().map(Vec::len).sum::<usize>();
    let sum = whole.iter().filter(|spots| !spots.is_empty()).fold(Spread::ZERO, |sum, spots| {
        sum.with(&Spread::measure(spots), |sum, one| sum + one * spots.len() as f64 / count as f64)
    });
    (count >= VARIED).then_some(sum)
}

/// Representatives of each region. Spots with a place between them that marks of another layer have `taken` are no neighbours, as
/// in a growth.
fn by_region(
    spots: &[crate::measure::Spot],
    size: [usize; 2],
    regions: [usize; 2],
    taken: impl Fn([f64; 2]) -> bool,
    ink: &[f64],
) -> Vec<Ellipse> {
    let mut whole = vec![Vec::new(); regions[0] * regions[1]];
    for spot in spots.iter().filter(|spot| spot.whole) {
        whole[region_of(share(spot.ellipse.center, size), regions)].push(spot.ellipse);
    }
    // All spots are neighbours, also those that are cut.
    let centers: Vec<[f64; 2]> = spots.iter().map(|spot| spot.ellipse.center).collect();
    let mut edges: Vec<Vec<WeightedEdge>> = vec![Vec::new(); whole.len()];
    for edge in neighbours(&centers, None) {
        let half = [0, 1].map(|axis| edge.midpoint[axis] - centers[edge.ends[0]][axis]);
        if is_circle_covered(edge.midpoint, half, &taken) {
            continue;
        }
        edges[region_of(share(edge.midpoint, size), regions)].push(edge);
    }
    let each = whole.iter().zip(&edges).enumerate();
    each.flat_map(|(k, (whole, edges))| {
        let wanted = Spots::measure(whole)
            .map(|found| Spots { spacing: mean_length(edges).or(found.spacing), ..found })
            .map(|found| no_denser(found, ink.get(k).copied()));
        wanted.map_or_else(Vec::new, |wanted| representatives(whole, &wanted, bounds(size, regions, k)))
    })
    .collect()
}

/// Dense spots with a spacing large enough that they cover the share `ink` of the region. Neighbours of dense spots stand close to
/// each other and leave empty places, so that their distance alone would give more spots than there are.
fn no_denser(found: Spots, ink: Option<f64>) -> Spots {
    let least = ink.filter(|ink| *ink > 0.0).map(|ink| (found.area / (0.75f64.sqrt() * ink)).sqrt());
    Spots { spacing: found.spacing.map(|spacing| least.map_or(spacing, |least| spacing.max(least))), ..found }
}

/// The share of marks in each region; empty for a picture whose marks are not dense.
fn dense_ink(reading: &Reading, size: [usize; 2], regions: [usize; 2]) -> Vec<f64> {
    if reading.ink() < DENSE {
        return Vec::new();
    }
    let Segmentation { field, level, .. } = &reading.segmentation;
    let mut counts = vec![[0usize; 2]; regions[0] * regions[1]];
    for (cell, value) in field.values.iter().enumerate() {
        let at = [(cell % field.width) as f64 + 0.5, (cell / field.width) as f64 + 0.5];
        let place = [0, 1].map(|axis| at[axis] * field.cell[axis]);
        let [marks, all] = &mut counts[region_of(share(place, size), regions)];
        *marks += usize::from(*value > *level);
        *all += 1;
    }
    counts.into_iter().map(|[marks, all]| marks as f64 / all.max(1) as f64).collect()
}

/// The stops of the marks for which `counts` holds.
fn colours(reading: &Reading, counts: impl Fn(usize) -> bool) -> Vec<Tone> {
    let segmentation = &reading.segmentation;
    let of = |lab| tones(lab, &segmentation.field, segmentation.level, counts, |_| false).tones;
    segmentation.lab.as_deref().map_or_else(Vec::new, of)
}

/// Side of the tiles in which stripes are measured, in wavelengths, and most tiles along a side.
const TILE: f64 = 1.5;
const MOST_TILES: usize = 12;

fn of_stripes(reading: &Reading, size: [usize; 2], wanted: &Wanted, found: usize) -> Sketch {
    let segmentation = &reading.segmentation;
    let (field, level, wavelength) = (&segmentation.field, segmentation.level, segmentation.wavelength);
    let directions = Directions::measure(field, wavelength);
    let measured = |layout| bands(field, level, &directions, size, layout);
    let tiles = size.map(|side| ((side as f64 / (TILE * wavelength)) as usize).clamp(1, MOST_TILES));
    let by_tile = measured(tiles);
    let regions = wanted.regions.unwrap_or_else(|| {
        let center = |k: usize| [(k % tiles[0]) as f64 + 0.5, (k / tiles[0]) as f64 + 0.5];
        let sample = |(k, band): (usize, &Option<Band>)| {
            let band = band.as_ref()?;
            let (sin, cos) = libm::sincos(2.0 * band.angle.to_radians());
            let place = [0, 1].map(|axis| center(k)[axis] / tiles[axis] as f64);
            Some(Sample { place, value: [libm::log(band.width), cos, sin] })
        };
        fewest(&by_tile.iter().enumerate().filter_map(sample).collect::<Vec<_>>())
    });
    let paths = if wanted.all_marks {
        let mean = by_tile.iter().flatten().map(|band| band.width).sum::<f64>()
            / by_tile.iter().flatten().count().max(1) as f64;
        let width = |place| by_tile[region_of(share(place, size), tiles)].map_or(mean, |band| band.width);
        lines::all(field, level, wavelength, width)
    } else {
        let each = measured(regions).into_iter().enumerate();
        each.filter_map(|(k, band)| Some(lines::of_region(field, band?, bounds(size, regions, k))))
            .flatten()
            .collect()
    };
    let layer = FoundLayer {
        name: "stripes",
        marks: paths.into_iter().map(Mark::Path).collect(),
        found,
        raggedness: None,
        spread: None,
        rosettes: None,
        tones: colours(reading, |_| true),
    };
    Sketch { regions: (!wanted.all_marks).then_some(regions), layers: vec![layer], between: None }
}

/// The stripes of each region; `None` for a region without stripes.
fn bands(
    field: &Field,
    level: f32,
    directions: &Directions,
    size: [usize; 2],
    layout: [usize; 2],
) -> Vec<Option<Band>> {
    let count = layout[0] * layout[1];
    let region = |place: [f64; 2]| region_of(share(place, size), layout);
    let places = directions.at_places(|place| (region(place), [1.0, 0.0]));
    let angles = directions.means(&places, count);
    let widths = widths(field, level, Regions::Any(count, &region));
    let (mut marked, mut all) = (vec![0.0; count], vec![0.0; count]);
    for (cell, value) in field.values.iter().enumerate() {
        let (x, y) = ((cell % field.width) as f64 + 0.5, (cell / field.width) as f64 + 0.5);
        let k = region([x * field.cell[0], y * field.cell[1]]);
        all[k] += 1.0;
        marked[k] += f64::from(u8::from(*value > level));
    }
    (0..count)
        .map(|k| {
            let (width, angle) = (widths[k]?, angles[k]?);
            // Width = 2 × area ÷ contour and period = 2 × canvas ÷ contour.
            (marked[k] > 0.0).then(|| Band { width, angle, period: width * all[k] / marked[k] })
        })
        .collect()
}
