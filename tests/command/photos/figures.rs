//! The tables of `docs/photos.md`: photographs of textures whose attributes are known, compared with these.
//!
//!     cargo test --release --test command -- --ignored --nocapture figures

use std::fs;
use std::path::{Path, PathBuf};

use dapple::ReadFile;
use dapple::document::{Document, PairKind, SystemChoice};
use dapple::output::LayerReport;
use dapple_engine::attributes::spacing::weighted_edges;
use dapple_engine::attributes::system::Family;
use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::marks::turn;
use dapple_engine::measure::{Directions, Picture, Regions, widths};
use dapple_engine::photo::{Corners, Raster, Reading, read};
use image::RgbImage;

use crate::photos::degrade::degraded;
use crate::photos::others::others;
use crate::photos::random;

/// Random documents.
const RANDOM: u64 = 60;
/// The angle by which the camera is tilted, degrees, and its distance, in picture widths.
const TILT: f64 = 10.0;
const DISTANCE: f64 = 2.0;
/// The margins that are left out, as shares of width and height, because a part of them is outside the oblique picture.
const INSET: [f64; 2] = [0.06, 0.02];

/// Errors from which on a document is named, for each attribute.
const LARGE: [f64; 6] = [0.06, 0.04, 0.03, 1.0, 0.1, 1.0];

/// Errors of one series, by attribute.
#[derive(Default)]
struct Errors {
    all: [Vec<f64>; 6],
}

const NAMES: [&str; 6] = ["area", "spacing", "aspect", "angle", "stripe width", "stripe angle"];

impl Errors {
    fn counts(&self) -> [usize; 6] {
        [0, 1, 2, 3, 4, 5].map(|k| self.all[k].len())
    }

    /// Prints the largest errors among those that were added after `before`, where they are large.
    fn print_worst(&self, name: &str, before: [usize; 6]) {
        for k in 0..6 {
            let worst = self.all[k][before[k]..].iter().copied().fold(0.0, f64::max);
            if worst > LARGE[k] {
                println!("  {name}: {} is off by {worst:.3}", NAMES[k]);
            }
        }
    }

    fn print(&mut self, series: &str) {
        for (name, errors) in NAMES.iter().zip(&mut self.all).filter(|(_, errors)| !errors.is_empty()) {
            errors.sort_by(f64::total_cmp);
            let at = |share: f64| errors[((errors.len() - 1) as f64 * share).round() as usize];
            println!("{series} | {name} | {:.4} | {:.4} | {}", at(0.5), at(0.95), errors.len());
        }
    }
}

/// The documents of a folder that are spots or stripes, with their names.
fn spots_and_stripes(folder: &str) -> Vec<(String, Document)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut all: Vec<PathBuf> = fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "dapple"))
        .collect();
    all.sort();
    let named = |path: PathBuf| {
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        (name, Document::read(&path).expect("an example"))
    };
    all.into_iter().map(named).filter(|(_, document)| is_spots_or_stripes(document)).collect()
}

fn is_spots_or_stripes(document: &Document) -> bool {
    document.layers.iter().all(|layer| {
        let plain = layer.system.kind().is_none_or(|kind| kind == Family::Marks)
            || layer.system.pairs() == Some(PairKind::Stripes);
        plain && layer.tone.is_none()
    })
}

fn raster(picture: &RgbImage) -> Raster {
    Raster {
        size: [picture.width() as usize, picture.height() as usize],
        rgb: picture.as_raw().clone(),
        dpi: None,
    }
}

/// The picture, as a tilted camera sees it, and the corners of the canvas in it.
fn tilted(picture: &RgbImage) -> (RgbImage, Corners) {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let (sin, cos) = TILT.to_radians().sin_cos();
    let depth = DISTANCE * width;
    let seen = |x: f64, y: f64| {
        let (u, v) = (x - width / 2.0, y - height / 2.0);
        let scale = depth / (depth + v * sin);
        [width / 2.0 + u * scale, height / 2.0 + v * cos * scale]
    };
    let from = raster(picture);
    let back = |[x, y]: [f64; 2]| {
        let (u, v) = (x - width / 2.0, y - height / 2.0);
        let down = v * depth / (cos * depth - v * sin);
        [width / 2.0 + u * (depth + down * sin) / depth, height / 2.0 + down]
    };
    let warped = from.warped(from.size, back);
    let corner = |x: f64, y: f64| seen(x, y).map(|place| place.clamp(0.0, width.max(height)));
    let (inset_x, inset_y) = (INSET[0] * width, INSET[1] * height);
    let corners = [
        corner(inset_x, inset_y),
        corner(width - inset_x, inset_y),
        corner(width - inset_x, height - inset_y),
        corner(inset_x, height - inset_y),
    ];
    let rgb = RgbImage::from_raw(picture.width(), picture.height(), warped.rgb).expect("as many px");
    (rgb, Corners(corners))
}

/// A texture whose attributes are known, and its place in the part that is read.
struct Known<'a> {
    report: &'a LayerReport,
    /// Width and height of the canvas, px.
    size: [f64; 2],
    /// Columns and rows.
    grid: [usize; 2],
    /// The place of the reading's corner on the canvas, px, and the number of px of the canvas per px of the reading.
    offset: [f64; 2],
    scale: [f64; 2],
}

impl<'a> Known<'a> {
    fn new(report: &'a LayerReport, size: [f64; 2]) -> Self {
        let grid = report.regions.iter().fold([1, 1], |grid: [usize; 2], region| {
            [grid[0].max(region.place[0] + 1), grid[1].max(region.place[1] + 1)]
        });
        Self { report, size, grid, offset: [0.0; 2], scale: [1.0; 2] }
    }

    fn number(&self, place: [usize; 2]) -> usize {
        place[1] * self.grid[0] + place[0]
    }

    /// The region of the canvas in which a place of the reading lies.
    fn region_of(&self, place: [f64; 2]) -> usize {
        let at = |k: usize| {
            let share = (self.offset[k] + place[k] * self.scale[k]) / self.size[k];
            ((share * self.grid[k] as f64).max(0.0) as usize).min(self.grid[k] - 1)
        };
        self.number([at(0), at(1)])
    }

    /// px of the canvas per px of the reading, on average.
    fn px(&self) -> f64 {
        (self.scale[0] * self.scale[1]).sqrt()
    }

    /// Compares what was read, region by region.
    fn compare(&self, reading: &Reading, errors: &mut Errors) {
        for region in &self.report.regions {
            let k = self.number(region.place);
            match (&reading.picture, region.got) {
                (Picture::Spots { .. }, Some(Attributes::Spots(got))) => self.spots(reading, k, &got, errors),
                (Picture::Stripes { .. }, Some(Attributes::Stripes(got))) => {
                    self.stripes(reading, k, &got, errors);
                }
                (_, None) => {}
                _ => println!("  of another kind: {}", self.report.name),
            }
        }
    }

    fn spots(&self, reading: &Reading, k: usize, got: &Spots, errors: &mut Errors) {
        let whole = reading.spots.iter().filter(|spot| spot.whole);
        let here = whole.clone().filter(|spot| self.region_of(spot.ellipse.center) == k);
        let Some(spots) = Spots::measure(&here.map(|spot| spot.ellipse).collect::<Vec<_>>()) else { return };
        errors.all[0].push((spots.area * self.px() * self.px() / got.area - 1.0).abs());
        errors.all[2].push((spots.aspect - got.aspect).abs());
        if got.aspect < 0.85 {
            errors.all[3].push(turn(spots.angle, got.angle).abs());
        }
        // The report weights edges by the spacing that was asked for at their midpoints.
        let nearest = |place: [f64; 2]| {
            let here =
                self.report.regions.iter().find(|region| self.number(region.place) == self.region_of(place));
            let asked = here.and_then(|region| match region.asked {
                Attributes::Spots(asked) => asked.spacing,
                Attributes::Stripes(_) => None,
            });
            asked.map_or(reading.segmentation.wavelength, |asked| asked / self.px())
        };
        let centers: Vec<[f64; 2]> = whole.map(|spot| spot.ellipse.center).collect();
        let edges = weighted_edges(&centers, None, nearest);
        let here = edges.iter().filter(|edge| self.region_of(edge.midpoint) == k);
        let (sum, weight) =
            here.fold((0.0, 0.0), |(sum, all), edge| (sum + edge.length * edge.weight, all + edge.weight));
        if let Some(spacing) = got.spacing.filter(|_| weight > 0.0) {
            errors.all[1].push((sum / weight * self.px() / spacing - 1.0).abs());
        }
    }

    fn stripes(&self, reading: &Reading, k: usize, got: &Stripes, errors: &mut Errors) {
        let found = &reading.segmentation;
        let count = self.grid[0] * self.grid[1];
        let region_of = |place: [f64; 2]| self.region_of(place);
        let width = widths(&found.field, found.level, Regions::Any(count, &region_of))[k];
        let directions = Directions::measure(&found.field, found.wavelength);
        let places = directions.at_places(|place| (region_of(place), [1.0, 0.0]));
        errors.all[4].extend(width.map(|width| (width * self.px() / got.width - 1.0).abs()));
        let angle = directions.means(&places, count)[k];
        errors.all[5].extend(angle.map(|angle| turn(angle, got.angle).abs()));
    }
}

/// Reads a picture. `None` where the picture is refused; the reason is printed.
fn taken(name: &str, raster: &Raster) -> Option<Reading> {
    let why = match read(raster, false) {
        Ok(Reading { neither: Some(why), .. }) | Err(why) => why,
        Ok(reading) => return Some(reading),
    };
    println!("  refused: {name}: {why}");
    None
}

/// Measures the series of a document: clean, degraded, oblique and flattened. Returns false, without measuring, for a
/// weave.
fn measure(
    name: &str,
    document: &Document,
    seed: u64,
    series: &mut [Errors],
    counts: &mut [usize; 2],
) -> bool {
    let grown = document.clone().grow().expect("an example grows");
    let [width, height] = document.size;
    let picture = RgbImage::from_raw(width, height, grown.rgb()).expect("as many px");
    let layers = grown.report().layers;
    // Lines that cross, in a layer that does not name a system.
    if layers.iter().any(|layer| layer.system == SystemChoice::Of(PairKind::Weave.description()).name()) {
        return false;
    }
    // The attributes of several layers are not those of all marks together.
    let known = (layers.len() == 1 && !layers[0].inverted)
        .then(|| Known::new(&layers[0], [f64::from(width), f64::from(height)]));
    let bad = image::load_from_memory(&degraded(&picture, seed)).expect("a JPEG").into_rgb8();
    for (k, picture) in [&picture, &bad].into_iter().enumerate() {
        if let Some(reading) = taken(&format!("{name}, series {k}"), &raster(picture)) {
            counts[k] += 1;
            if let Some(known) = &known {
                let before = series[k].counts();
                known.compare(&reading, &mut series[k]);
                series[k].print_worst(&format!("{name}, series {k}"), before);
            }
        }
    }
    if let Some(known) = known {
        let (tilted, corners) = tilted(&picture);
        let flat = corners.flattened(&raster(&tilted));
        let offset = [INSET[0] * known.size[0], INSET[1] * known.size[1]];
        let scale = [0, 1].map(|k| (known.size[k] - 2.0 * offset[k]) / flat.size[k] as f64);
        if let Some(reading) = taken(&format!("{name}, flattened"), &flat) {
            Known { offset, scale, ..known }.compare(&reading, &mut series[2]);
        }
    }
    true
}

/// Errors of the clean, the degraded and the flattened series.
fn series_of(name: &str, documents: impl Iterator<Item = (String, Document)>) -> [Errors; 3] {
    let mut series: [Errors; 3] = std::array::from_fn(|_| Errors::default());
    let (mut counts, mut all) = ([0; 2], 0);
    for (k, (name, document)) in documents.enumerate() {
        all += usize::from(measure(&name, &document, k as u64, &mut series, &mut counts));
    }
    print_series(name, &mut series);
    println!("{name}: {} clean and {} degraded of {all} were taken", counts[0], counts[1]);
    series
}

fn print_series(name: &str, series: &mut [Errors; 3]) {
    for (errors, kind) in series.iter_mut().zip(["clean", "degraded", "10° flattened"]) {
        errors.print(&format!("{name}, {kind}"));
    }
}

#[test]
#[ignore = "some minutes: prints the tables of docs/photos.md"]
fn figures() {
    let mut both = series_of("random", (0..RANDOM).map(|k| (format!("random {k}"), random::document(k))));
    let examples = series_of("examples", spots_and_stripes("examples").into_iter());
    for (both, examples) in both.iter_mut().zip(examples) {
        both.all.iter_mut().zip(examples.all).for_each(|(both, examples)| both.extend(examples));
    }
    print_series("examples and random", &mut both);
    series_of("gallery", spots_and_stripes("examples/gallery").into_iter());
    let refused = |picture: RgbImage| {
        let found = read(&raster(&picture), false);
        found.map_or(true, |reading| reading.neither.is_some())
    };
    let all = others();
    let clean = all.iter().filter(|(_, picture)| refused(picture.clone())).count();
    let bad =
        |picture: &RgbImage| image::load_from_memory(&degraded(picture, 2)).expect("a JPEG").into_rgb8();
    let degraded = all.iter().filter(|(_, picture)| refused(bad(picture))).count();
    println!("others: {clean} clean and {degraded} degraded of {} were refused", all.len());
}
