//! What was grown once is grown again. `REGENERATE=1 cargo test --test grow golden` writes `tests/golden` anew,
//! for whoever changes a result on purpose; the difference is then to be looked at and told.

use crate::folder::Folder;
use dapple::field::Edges;
use dapple::marks::turn;
use dapple::rd::{Growth, Maps, Parameters, System};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

fn golden(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests", "golden", name].iter().collect()
}

/// What the golden file holds; `None` where it was just written anew.
fn stored(name: &str, fresh: &str) -> Option<String> {
    if std::env::var_os("REGENERATE").is_some_and(|value| value == "1") {
        std::fs::write(golden(name), fresh).unwrap();
        return None;
    }
    let read = std::fs::read_to_string(golden(name));
    // Git may have checked the file out with the line ends of the platform.
    Some(read.unwrap_or_else(|error| panic!("tests/golden/{name}: {error}")).replace("\r\n", "\n"))
}

/// 48 × 40 oblong cells whose parameters all vary; by plain arithmetic, which is the same everywhere.
fn varying(system: System) -> Maps {
    let rate = match system {
        System::TuringSpots => 0.15,
        System::MeinhardtSpots => 2.0,
        System::MeinhardtStripes => 40.0,
        System::MeinhardtLines => 6.0,
    };
    let parameters = |cell: u16| {
        let [x, y] = [f32::from(cell % 48) / 48.0, f32::from(cell / 48) / 40.0];
        Parameters {
            rate: rate * (1.0 + 0.5 * x),
            ratio: 15.0 + 10.0 * y,
            stretch: 0.4 + 0.5 * y,
            direction: 170.0 * x,
            pitch: 1.0 + 0.1 * x,
        }
    };
    Maps::new([48, 40], [1.0, 0.95], (0..48 * 40).map(parameters).collect())
}

/// FNV-1a, 64 bits, of the values' bytes, the lowest first.
fn fnv(values: &[f32]) -> u64 {
    let bytes = values.iter().flat_map(|value| value.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A line a chemical: the hash of all cells, then a few of them as value and bits.
fn concentrations() -> String {
    let mut text =
        "# Concentrations on 48 x 40 cells after 20 steps, by system, edges, chemical: FNV-1a of the\n\
                    # bits of all cells; then cells 0, 500, 1000, 1500, 1919 as bits=value.\n"
            .to_owned();
    for system in System::ALL {
        for (edges, word) in [(Edges::Wrap, "wrap"), (Edges::Closed, "closed")] {
            let mut growth = Growth::new(system, &varying(system), edges, 11);
            growth.advance(20);
            for (chemical, values) in growth.concentrations().iter().enumerate() {
                write!(text, "{} {word} {chemical} {:016x}", system.name(), fnv(values)).unwrap();
                for cell in [0, 500, 1000, 1500, 1919] {
                    write!(text, " {:08x}={:e}", values[cell].to_bits(), values[cell]).unwrap();
                }
                text.push('\n');
            }
        }
    }
    text
}

#[test]
fn twenty_steps_of_each_system_give_the_stored_bits() {
    let fresh = concentrations();
    let Some(stored) = stored("concentrations.txt", &fresh) else { return };
    let differ: Vec<String> = stored
        .lines()
        .zip(fresh.lines())
        .filter(|(stored, fresh)| stored != fresh)
        .map(|(stored, fresh)| format!("stored {stored}\n grown {fresh}"))
        .collect();
    assert!(
        differ.is_empty() && stored.lines().count() == fresh.lines().count(),
        "{} lines of tests/golden/concentrations.txt differ:\n{}\nIf that is meant: REGENERATE=1",
        differ.len(),
        differ.join("\n")
    );
}

/// What has grown in each region, by the report; numbers shortened to what is compared.
fn regions(folder: &Folder) -> Vec<Value> {
    let report = folder.json("r.json");
    let short = |value: &Value| json!((value.as_f64().unwrap() * 1000.0).round() / 1000.0);
    let regions = report["layers"][0]["regions"].as_array().unwrap().iter().map(|region| {
        let got = region["got"].as_object().unwrap();
        let got: serde_json::Map<String, Value> =
            got.iter().map(|(key, value)| (key.clone(), short(value))).collect();
        json!({"region": region["region"], "got": got})
    });
    regions.collect()
}

/// Grows `NAME.dapple` and compares with `NAME.json`: not to the bit, since solvers and training sets get better,
/// but within what a seed changes.
#[track_caller]
fn grows_as_stored(name: &str) {
    let folder = Folder::new();
    std::fs::copy(golden(&format!("{name}.dapple")), folder.path("a.dapple")).unwrap();
    folder.grow("--report r.json");
    let fresh = regions(&folder);
    let file = format!("{name}.json");
    let Some(text) = stored(&file, &format!("{:#}\n", json!(fresh))) else { return };
    let old: Vec<Value> = serde_json::from_str(&text).unwrap();
    assert_eq!(old.len(), fresh.len());
    for (old, fresh) in old.iter().zip(&fresh) {
        assert_eq!(old["region"], fresh["region"]);
        for (key, value) in old["got"].as_object().unwrap() {
            let [stored, grown] = [value, &fresh["got"][key]].map(|value| value.as_f64().unwrap());
            let (off, allowed) = match key.as_str() {
                "area" => (grown / stored - 1.0, 0.03),
                "spacing" => (grown / stored - 1.0, 0.06),
                "width" => (grown / stored - 1.0, 0.04),
                "aspect" => (grown - stored, 0.03),
                _ => (turn(grown, stored), 4.0),
            };
            assert!(
                off.abs() <= allowed,
                "tests/golden/{file}: {key} of region {}: stored {stored}, grown {grown}, off by {off}, \
                 allowed {allowed}. If that is meant: REGENERATE=1",
                old["region"]
            );
        }
    }
}

#[test]
fn golden_spots_grow_as_stored() {
    grows_as_stored("spots");
}

#[test]
fn golden_stripes_grow_as_stored() {
    grows_as_stored("stripes");
}
