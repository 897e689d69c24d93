//! The first steps of every system, to the bit.

use crate::renew::{golden, renew, renews, text};
use dapple_engine::grid::{Edges, Grid};
use dapple_engine::rd::{Growth, Maps, Parameters, System};
use std::fmt::Write;

/// 48 × 40 oblong cells whose parameters all vary; computed by plain arithmetic, which is the same on every machine.
fn varying(system: System, edges: Edges) -> Maps {
    let rate = system.definition().usual_rate;
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
    let grid = Grid { size: [48, 40], cell: [1.0, 0.95], edges };
    Maps::new(grid, (0..48 * 40).map(parameters).collect())
}

/// FNV-1a, 64 bits, of the values' bytes, the lowest first.
fn fnv(values: &[f32]) -> u64 {
    let bytes = values.iter().flat_map(|value| value.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A line for each chemical: the hash of all cells, then a few of them as value and bits.
fn concentrations() -> String {
    let mut text =
        "# Concentrations on 48 x 40 cells after 20 steps (whole super steps), by system, edges, chemical: FNV-1a of the\n\
                    # bits of all cells; then cells 0, 500, 1000, 1500, 1919 as bits=value.\n"
            .to_owned();
    for system in System::ALL {
        for (edges, word) in [(Edges::Wrap, "wrap"), (Edges::Closed, "closed")] {
            let mut growth = Growth::new(system, &varying(system, edges), 11);
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
    let file = golden("concentrations.txt");
    let stored = if renews() { std::fs::read_to_string(&file).unwrap_or_default() } else { text(&file) };
    let [old, new] = [&stored, &fresh].map(|text| text.lines().collect::<Vec<_>>());
    let differ: Vec<String> = (0..old.len().max(new.len()))
        .filter(|line| old.get(*line) != new.get(*line))
        .map(|line| {
            format!("stored {}\n grown {}", old.get(line).unwrap_or(&""), new.get(line).unwrap_or(&""))
        })
        .collect();
    if renews() && !differ.is_empty() {
        return renew("concentrations.txt", fresh.as_bytes(), &format!("changed\n{}", differ.join("\n")));
    }
    assert!(
        differ.is_empty(),
        "{} lines of tests/golden/concentrations.txt differ:\n{}\nIf that is meant: REGENERATE=1",
        differ.len(),
        differ.join("\n")
    );
}
