//! Seams: compares the steps across the border of a tile with the steps inside it, for every map of a material.

use super::Folder;
use image::DynamicImage;
use rayon::prelude::*;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::LazyLock;
use test_pictures::seams::Steps;

/// All maps of the material of a document, with their names.
fn maps(folder: &Folder, document: &str, name: &str) -> Vec<(String, DynamicImage)> {
    let set = format!("set-{name}");
    folder.does(&format!("grow {document} --material {set} -q"));
    let mut maps = Vec::new();
    for entry in std::fs::read_dir(folder.path(&set)).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "png") {
            let map = path.file_stem().unwrap().to_string_lossy().into_owned();
            maps.push((map, image::open(&path).unwrap()));
        }
    }
    assert_eq!(maps.len(), 9);
    maps
}

#[track_caller]
fn has_no_seams(found: &[(String, [f64; 2])]) {
    for (map, [most, largest]) in found {
        println!("{map}: {most:.3} {largest:.3}");
    }
    let seams: Vec<_> = found.iter().filter(|(_, [most, largest])| *most > 1.3 || *largest > 1.0).collect();
    assert!(seams.is_empty(), "{seams:?}");
}

#[test]
fn a_step_across_the_border_that_is_much_larger_is_not_by_chance() {
    // Waves on a slope, so that opposite ends differ.
    let value = |x: u32, _: u32| {
        let wave = 6_000.0 * libm::sin(std::f64::consts::TAU * 3.0 * f64::from(x) / 64.0);
        image::Luma([(20_000.0 + wave + 150.0 * f64::from(x)) as u16])
    };
    let tile = DynamicImage::ImageLuma16(image::ImageBuffer::from_fn(64, 64, value));
    let [_, largest] = Steps::of(&tile).ratios_beyond_chance();
    assert!(largest > 1.5, "{largest}");
}

#[test]
fn seamless_examples_have_no_seam_in_any_map() {
    let folder = Folder::with(&json!(null));
    let mut found = Vec::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for folder_of in [root.clone(), root.join("gallery")] {
        let mut paths: Vec<_> =
            std::fs::read_dir(folder_of).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        for path in paths.iter().filter(|path| path.extension().is_some_and(|ending| ending == "dapple")) {
            let text = std::fs::read_to_string(path).unwrap();
            let document: Value = serde_json::from_str(&text).unwrap();
            if document["edges"] == "wrap" {
                let name = path.file_stem().unwrap().to_string_lossy();
                std::fs::copy(path, folder.path(&format!("{name}.dapple"))).unwrap();
                let maps = maps(&folder, &format!("{name}.dapple"), &name);
                let of_map = |(map, picture): (String, DynamicImage)| {
                    (map, Steps::of(&picture).ratios_beyond_chance())
                };
                found.extend(maps.into_iter().map(of_map));
            }
        }
    }
    assert!(found.len() >= 27, "{}", found.len());
    has_no_seams(&found);
}

/// A sketch like that of a user, different for each `number`.
fn sketch(number: u64) -> Value {
    let mut state = number.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = |low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let size = [random(180.0, 330.0).round(), random(180.0, 330.0).round()];
    let regions = [random(1.0, 3.0).floor(), random(1.0, 3.0).floor()];
    let (angle, long) = (random(0.0, 180.0), random(5.0, 11.0));
    let striped = number % 2 == 1;
    let mut strokes = Vec::new();
    for column in 0..regions[0] as usize {
        for row in 0..regions[1] as usize {
            let at = |part: usize, axis: usize| (part as f64 + 0.5) * size[axis] / regions[axis];
            let (center, turned) = ([at(column, 0), at(row, 1)], angle + random(-15.0, 15.0));
            let [sin, cos] = [turned.to_radians().sin(), turned.to_radians().cos()];
            strokes.push(if striped {
                let end = |way: f64| [center[0] + way * 20.0 * cos, center[1] + way * 20.0 * sin];
                json!({"kind": "line", "from": end(-1.0), "to": end(1.0), "width": long})
            } else {
                json!({"kind": "ellipse", "center": center, "radii": [long, 0.65 * long], "angle": turned})
            });
        }
    }
    json!({"format": "dapple", "version": 1, "name": format!("{number}"), "size": size.map(|side| side as u32),
        "regions": regions.map(|count| count as u32), "edges": "wrap", "seed": number, "layers": [{"strokes": strokes}]})
}

/// The maps of tiles 1 to 20, with the names of their kinds.
fn random_tiles() -> &'static [(String, DynamicImage)] {
    static TILES: LazyLock<Vec<(String, DynamicImage)>> = LazyLock::new(|| {
        let folder = Folder::with(&json!(null));
        let tiles = (1..=20_u64).into_par_iter().flat_map_iter(|number| {
            let name = format!("{number}.dapple");
            std::fs::write(folder.path(&name), sketch(number).to_string()).unwrap();
            maps(&folder, &name, &number.to_string())
        });
        tiles.collect()
    });
    &TILES
}

/// Sketches 1 to 20 of the generator above, without selection: tiles with sides of 180–330 px, whose border crosses
/// about 15 to 60 marks. The random variation of the ratio was measured by cutting the tile elsewhere: a standard
/// deviation of 0.02 to 0.13 (normals), so that the bound of 1.3 is at least two deviations away.
#[test]
fn twenty_random_tiles_have_no_seam_in_any_map() {
    let found: Vec<_> =
        random_tiles().iter().map(|(map, picture)| (map.clone(), Steps::of(picture).ratios())).collect();
    assert_eq!(found.len(), 180);
    has_no_seams(&found);
}

/// The mean rank of the borders of the random tiles, for each map.
fn mean_ranks(cut: impl Fn(&DynamicImage) -> DynamicImage + Sync) -> Vec<(&'static str, f64)> {
    let tiles = random_tiles();
    let ranked: Vec<_> =
        tiles.par_iter().map(|(map, picture)| (map, Steps::of(&cut(picture)).ranks())).collect();
    let mean = |kind: &'static str| {
        let of: Vec<f64> =
            ranked.iter().filter(|(map, _)| map.ends_with(kind)).flat_map(|(_, r)| *r).collect();
        assert_eq!(of.len(), 40);
        (kind, of.iter().sum::<f64>() / 40.0)
    };
    ["Height", "NormalGL", "NormalDX", "AmbientOcclusion", "BaseColor", "Roughness", "ORM", "MaskMap"]
        .map(mean)
        .to_vec()
}

/// Three standard deviations above the mean of 40 ranks distributed uniformly from 0 to 1.
const HIGH: f64 = 0.5 + 3.0 * 0.288_7 / 6.325;

#[test]
fn the_border_of_a_tile_does_not_differ_from_other_lines() {
    let means = mean_ranks(DynamicImage::clone);
    println!("{means:?}");
    assert!(means.iter().all(|(_, rank)| *rank < HIGH), "{means:?}");
}

#[test]
fn a_missing_px_at_the_border_is_detected() {
    let means = mean_ranks(|picture| picture.crop_imm(0, 0, picture.width() - 1, picture.height() - 1));
    println!("{means:?}");
    assert!(means.iter().all(|(_, rank)| *rank > HIGH), "{means:?}");
}

#[test]
fn the_measurement_detects_a_seam() {
    let ramp = image::RgbImage::from_fn(64, 64, |x, _| image::Rgb([4 * x as u8; 3]));
    let ramp = DynamicImage::ImageRgb8(ramp);
    let steps = Steps::of(&ramp);
    let [most, largest] = steps.ratios();
    assert!(most > 10.0 && largest > 10.0);
    assert_eq!(steps.ratios_beyond_chance(), [most, largest]);
}
