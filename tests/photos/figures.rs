//! The tables of `docs/photos.md`: photographs of textures whose numbers are known, against what was grown.
//!
//!     cargo test --release --test photos -- --ignored --nocapture figures

use std::fs;
use std::path::{Path, PathBuf};

use dapple::document::Document;
use dapple::internals::attributes::spacing::weighted_edges;
use dapple::internals::attributes::{Attributes, Spots};
use dapple::internals::marks::turn;
use dapple::internals::measure::{Directions, Picture, widths};
use dapple::internals::photo::{Corners, Raster, Reading, read};
use dapple::output::LayerReport;
use image::RgbImage;

use crate::degrade::degraded;
use crate::others::others;
use crate::random;

/// Random documents.
const RANDOM: u64 = 60;
/// The angle by which the camera is tilted, degrees, and its distance in picture widths.
const TILT: f64 = 10.0;
const DISTANCE: f64 = 2.0;

/// Errors of one series, by attribute.
#[derive(Default)]
struct Errors {
    all: [Vec<f64>; 6],
}

const NAMES: [&str; 6] = ["area", "spacing", "aspect", "angle", "stripe width", "stripe angle"];

impl Errors {
    fn print(&mut self, series: &str) {
        for (name, errors) in NAMES.iter().zip(&mut self.all).filter(|(_, errors)| !errors.is_empty()) {
            errors.sort_by(f64::total_cmp);
            let at = |share: f64| errors[((errors.len() - 1) as f64 * share).round() as usize];
            println!("{series} | {name} | {:.4} | {:.4} | {}", at(0.5), at(0.95), errors.len());
        }
    }
}

/// The documents of `examples/`, those of the gallery too.
fn examples() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut all: Vec<PathBuf> = [root.clone(), root.join("gallery")]
        .iter()
        .flat_map(|folder| fs::read_dir(folder).expect("the folder can be read"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "dapple"))
        .collect();
    all.sort();
    all
}

fn raster(picture: &RgbImage) -> Raster {
    Raster {
        size: [picture.width() as usize, picture.height() as usize],
        rgb: picture.as_raw().clone(),
        dpi: None,
    }
}

/// The picture as a camera sees it that is tilted, and the corners of the canvas in it.
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
    // What leaves the picture is cut: the corners of a smaller canvas.
    let (inset_x, inset_y) = (0.06 * width, 0.02 * height);
    let corners = [
        corner(inset_x, inset_y),
        corner(width - inset_x, inset_y),
        corner(width - inset_x, height - inset_y),
        corner(inset_x, height - inset_y),
    ];
    let rgb = RgbImage::from_raw(picture.width(), picture.height(), warped.rgb).expect("as many px");
    (rgb, Corners(corners))
}

/// Compares what was read with the report of a layer, region by region; `offset` and `scale` lead from px of the reading to px
/// of the canvas.
fn compare(
    reading: &Reading,
    report: &LayerReport,
    size: [f64; 2],
    frame: ([f64; 2], [f64; 2]),
    errors: &mut Errors,
) {
    let (offset, scale) = frame;
    let grid = report.regions.iter().fold([1, 1], |grid: [usize; 2], region| {
        [grid[0].max(region.place[0] + 1), grid[1].max(region.place[1] + 1)]
    });
    let region_of = |place: [f64; 2]| {
        let at = |k: usize| {
            let share = (offset[k] + place[k] * scale[k]) / size[k];
            ((share * grid[k] as f64).max(0.0) as usize).min(grid[k] - 1)
        };
        at(1) * grid[0] + at(0)
    };
    let number = |place: [usize; 2]| place[1] * grid[0] + place[0];
    let found = &reading.segmentation;
    for region in &report.regions {
        let k = number(region.place);
        let Some(got) = region.got else { continue };
        match (&reading.picture, got) {
            (Picture::Spots { .. }, Attributes::Spots(got)) => {
                let whole = reading.spots.iter().filter(|spot| spot.whole);
                let here: Vec<_> = whole
                    .clone()
                    .filter(|spot| region_of(spot.ellipse.center) == k)
                    .map(|spot| spot.ellipse)
                    .collect();
                let Some(spots) = Spots::measure(&here) else { continue };
                let px = scale[0] * scale[1];
                errors.all[0].push((spots.area * px / got.area - 1.0).abs());
                errors.all[2].push((spots.aspect - got.aspect).abs());
                if got.aspect < 0.85 {
                    errors.all[3].push(turn(spots.angle, got.angle).abs());
                }
                let asked = report.regions.iter().map(|region| match region.asked {
                    Attributes::Spots(asked) => (number(region.place), asked.spacing),
                    Attributes::Stripes(_) => (number(region.place), None),
                });
                let asked: Vec<(usize, Option<f64>)> = asked.collect();
                let nearest = |place: [f64; 2]| {
                    let here = asked.iter().find(|(k, _)| *k == region_of(place));
                    here.and_then(|(_, spacing)| *spacing).unwrap_or(found.wavelength * px.sqrt()) / px.sqrt()
                };
                let centers: Vec<[f64; 2]> = whole.map(|spot| spot.ellipse.center).collect();
                let edges = weighted_edges(&centers, None, nearest);
                let here = edges.iter().filter(|edge| region_of(edge.midpoint) == k);
                let (sum, weight) = here.fold((0.0, 0.0), |(sum, weight), edge| {
                    (sum + edge.length * edge.weight, weight + edge.weight)
                });
                if let Some(spacing) = got.spacing.filter(|_| weight > 0.0) {
                    errors.all[1].push((sum / weight * px.sqrt() / spacing - 1.0).abs());
                }
            }
            (Picture::Stripes { .. }, Attributes::Stripes(got)) => {
                let count = grid[0] * grid[1];
                let width = widths(&found.field, found.level, count, region_of)[k];
                let directions = Directions::measure(&found.field, found.wavelength);
                let places = directions.at_centers(|place| (region_of(place), [1.0, 0.0]));
                errors.all[4].extend(
                    width.map(|width| (width * (scale[0] * scale[1]).sqrt() / got.width - 1.0).abs()),
                );
                errors.all[5]
                    .extend(directions.means(&places, count)[k].map(|angle| turn(angle, got.angle).abs()));
            }
            _ => println!("  of another kind: {:?}", reading.picture),
        }
    }
}

#[test]
#[ignore = "two minutes: prints the tables of docs/photos.md"]
fn figures() {
    let named = |path: &PathBuf| {
        (
            path.file_stem().expect("a name").to_string_lossy().into_owned(),
            Document::read(path).expect("an example"),
        )
    };
    let mut series: [Errors; 6] = std::array::from_fn(|_| Errors::default());
    let (mut taken, mut all) = ([0; 2], 0);
    let documents = examples()
        .iter()
        .map(named)
        .chain((0..RANDOM).map(|k| (format!("random {k}"), random::document(k))))
        .collect::<Vec<_>>();
    for (k, (name, document)) in documents.iter().enumerate() {
        let grown = document.clone().grow().expect("an example grows");
        let [width, height] = document.size;
        let picture = RgbImage::from_raw(width, height, grown.rgb()).expect("as many px");
        let layers = grown.report().layers;
        all += 1;
        let random = usize::from(name.starts_with("random"));
        let pictures = [
            picture.clone(),
            image::load_from_memory(&degraded(&picture, k as u64)).expect("a JPEG").into_rgb8(),
        ];
        for (degraded, picture) in pictures.iter().enumerate() {
            match read(&raster(picture), false) {
                Ok(reading) if reading.neither.is_none() => {
                    taken[degraded] += 1;
                    if layers.len() == 1 && !layers[0].inverted {
                        let size = [f64::from(width), f64::from(height)];
                        compare(
                            &reading,
                            &layers[0],
                            size,
                            ([0.0; 2], [1.0; 2]),
                            &mut series[2 * random + degraded],
                        );
                    }
                }
                Ok(reading) => {
                    println!("  refused: {name} {degraded}: {}", reading.neither.expect("a reason"))
                }
                Err(why) => println!("  refused: {name} {degraded}: {why}"),
            }
        }
        if layers.len() == 1 && !layers[0].inverted {
            let (tilted, corners) = tilted(&picture);
            let flat = corners.flattened(&raster(&tilted));
            let (size, inset) =
                ([f64::from(width), f64::from(height)], [0.06 * f64::from(width), 0.02 * f64::from(height)]);
            let scale = [0, 1].map(|k| (size[k] - 2.0 * inset[k]) / flat.size[k] as f64);
            if let Ok(reading) = read(&flat, false) {
                compare(&reading, &layers[0], size, (inset, scale), &mut series[4 + random]);
            }
        }
    }
    for (errors, name) in series.iter_mut().zip([
        "examples, clean",
        "examples, degraded",
        "random, clean",
        "random, degraded",
        "examples, 10° flattened",
        "random, 10° flattened",
    ]) {
        errors.print(name);
    }
    println!("taken: {} clean, {} degraded, of {all}", taken[0], taken[1]);
    let refused = |degrade: bool| {
        let pictures = others();
        let each = pictures.iter().filter(|(_, picture)| {
            let picture = if degrade {
                image::load_from_memory(&degraded(picture, 2)).expect("a JPEG").into_rgb8()
            } else {
                picture.clone()
            };
            read(&raster(&picture), false).map_or(true, |reading| reading.neither.is_some())
        });
        (each.count(), pictures.len())
    };
    println!("refused: {:?} clean, {:?} degraded", refused(false), refused(true));
}
