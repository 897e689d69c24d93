//! The table of the round trip in `docs/photos.md`: photograph → document → grown, compared with the photographed
//! texture. All of them are measured in the same way.
//!
//!     cargo test --release --test command -- --ignored --nocapture round_trip

use std::fs;
use std::path::Path;

use dapple::ReadFile;
use dapple::document::Document;
use dapple::photograph::{PhotoOptions, import_photo};
use dapple_engine::colour::{linear_light, oklab_of_light};
use dapple_engine::marks::turn;
use dapple_engine::measure::Picture;
use dapple_engine::photo::{Raster, Reading, Wanted, read, sketch};
use image::RgbImage;

use crate::photos::degrade::degraded;
use crate::photos::{grown, png, random};

/// The number of random documents.
const RANDOM: u64 = 24;
/// Documents of two sizes of spots.
const TWO_SIZES: [&str; 2] = ["phan-grimm-12-mixed-spots", "turk-2-lower-left-cheetah"];
const NAMES: [&str; 8] =
    ["area", "spacing", "aspect", "angle", "stripe width", "period", "OKLab ground", "OKLab marks"];

/// Differences, by attribute.
#[derive(Default)]
struct Differences([Vec<f64>; 8]);

impl Differences {
    fn print(&mut self, series: &str) {
        for (name, all) in NAMES.iter().zip(&mut self.0).filter(|(_, all)| !all.is_empty()) {
            all.sort_by(f64::total_cmp);
            let at = |share: f64| all[((all.len() - 1) as f64 * share).round() as usize];
            println!("{series} | {name} | {:.4} | {:.4} | {}", at(0.5), at(0.95), all.len());
        }
    }

    fn compare(&mut self, before: &Reading, after: &Reading) -> bool {
        let off = |before: f64, after: f64| (after / before - 1.0).abs();
        match (&before.picture, &after.picture) {
            (Picture::Spots { got: before, .. }, Picture::Spots { got: after, .. }) => {
                self.0[0].push(off(before.area, after.area));
                if let (Some(before), Some(after)) = (before.spacing, after.spacing) {
                    self.0[1].push(off(before, after));
                }
                self.0[2].push((before.aspect - after.aspect).abs());
                if before.aspect < 0.85 {
                    self.0[3].push(turn(before.angle, after.angle).abs());
                }
            }
            (Picture::Stripes { got: before, .. }, Picture::Stripes { got: after, .. }) => {
                self.0[4].push(off(before.width, after.width));
                self.0[5].push(off(before.wavelength, after.wavelength));
                self.0[3].push(turn(before.angle, after.angle).abs());
            }
            _ => return false,
        }
        let before_picture = before.picture;
        let [before, after] = [before, after].map(ends);
        for (k, (before, after)) in before.into_iter().zip(after).enumerate() {
            let apart = (0..3).map(|k| f64::from(before[k] - after[k]).powi(2)).sum::<f64>().sqrt();
            if apart > 0.05 {
                println!("  {}: {apart:.3}, {:?}", NAMES[6 + k], wide(&before_picture));
            }
            self.0[6 + k].push(apart);
        }
        true
    }
}

/// The widths of the marks and of the ground between them, px.
fn wide(picture: &Picture) -> [f64; 2] {
    match picture {
        Picture::Spots { got, .. } => {
            let width = 2.0 * (got.area / std::f64::consts::PI).sqrt();
            [width, got.spacing.unwrap_or(0.0) - width]
        }
        Picture::Stripes { got, .. } => [got.width, got.wavelength - got.width],
    }
}

/// The colours of ground and marks, OKLab.
fn ends(reading: &Reading) -> [[f32; 3]; 2] {
    let wanted = Wanted { regions: Some([1, 1]), layers: Some(1), all_marks: false };
    let sketch = sketch(reading, [384; 2], &wanted);
    let tones = &sketch.layers[0].tones;
    let light = linear_light();
    [&tones[0], &tones[tones.len() - 1]]
        .map(|tone| oklab_of_light(tone.colour.map(|channel| light[usize::from(channel)])))
}

fn reading(picture: &RgbImage) -> Reading {
    let size = [picture.width() as usize, picture.height() as usize];
    read(&Raster { size, rgb: picture.as_raw().clone(), dpi: None }, false).expect("marks")
}

/// The texture that grows from the document that is made from a photograph; `None` where the photograph is refused.
fn back(folder: &Path, bytes: &[u8]) -> Option<RgbImage> {
    let path = folder.join("photograph");
    fs::write(&path, bytes).expect("written");
    let imported = import_photo(&path, &PhotoOptions::default()).ok()?;
    Some(grown(&imported.document))
}

/// The clean and the degraded photograph of a picture.
fn photographs(picture: &RgbImage, seed: u64) -> [Vec<u8>; 2] {
    [png(picture), degraded(picture, seed)]
}

#[test]
#[ignore = "some minutes: prints the table of docs/photos.md"]
fn round_trip() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut series: [Differences; 2] = std::array::from_fn(|_| Differences::default());
    for k in 0..RANDOM {
        let picture = grown(&random::document(k));
        let before = reading(&picture);
        for (kind, bytes) in photographs(&picture, k).iter().enumerate() {
            let after = back(folder.path(), bytes);
            let same = after.is_some_and(|after| series[kind].compare(&before, &reading(&after)));
            if !same {
                println!("  random {k}, {kind}: not compared");
            }
        }
    }
    for (differences, kind) in series.iter_mut().zip(["clean", "degraded"]) {
        differences.print(kind);
    }
    for name in TWO_SIZES {
        two_sizes(folder.path(), name);
    }
}

/// Prints the numbers of large and small spots, before and after.
fn two_sizes(folder: &Path, name: &str) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/gallery/{name}.dapple"));
    let document = Document::read(file).expect("an example");
    let picture = grown(&document);
    let before = reading(&picture);
    let size = document.size.map(|side| side as usize);
    let Some(between) = sketch(&before, size, &Wanted::default()).between else {
        println!("{name}: one size");
        return;
    };
    let count = |reading: &Reading| {
        let large = |spot: &&dapple_engine::measure::Spot| spot.ellipse.area() >= between;
        let whole: Vec<_> = reading.spots.iter().filter(|spot| spot.whole).copied().collect();
        let large = whole.iter().filter(large).count();
        [large, whole.len() - large]
    };
    for (kind, bytes) in ["clean", "degraded"].iter().zip(photographs(&picture, 3)) {
        let after = back(folder, &bytes).map(|after| count(&reading(&after)));
        println!("{name}, {kind} | {:?} → {after:?}", count(&before));
    }
}
