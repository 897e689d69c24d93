//! Fuzz body for training rows: rows that are read are written and read back unchanged, and every question gets numbers
//! or is refused.

use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::learn::{InCells, TrainingSet, write_rows};
use dapple_engine::rd::System;

use crate::refusal::assert_readable;

const FILE: &str = "rows.csv";

/// `bytes` are a training set, or are refused. The first byte chooses the system.
pub fn holds(bytes: &[u8]) {
    let Some((first, rows)) = bytes.split_first() else { return };
    let system = System::ALL[usize::from(*first) % System::ALL.len()].description();
    match TrainingSet::read(system, [(FILE, rows)].into_iter()) {
        Ok(set) => {
            comes_back(&set);
            answers(&set);
        }
        Err(error) => assert_readable(&error.to_string(), FILE),
    }
}

/// Writes rows as CSV and reads them back: equal to six digits the first time, and exactly after that.
fn comes_back(set: &TrainingSet) {
    let written = |set: &TrainingSet| {
        let mut text = Vec::new();
        write_rows(set.system(), set.rows(), &mut text).expect("rows that were read are written");
        text
    };
    let text = written(set);
    let read = TrainingSet::read(set.system(), [("own.csv", text.as_slice())].into_iter())
        .unwrap_or_else(|error| panic!("what is written is read: {error}"));
    assert_eq!(read.rows().len(), set.rows().len());
    assert_eq!(written(&read), text);
}

/// Asks for the attributes of the first row, and for attributes far from all rows.
fn answers(set: &TrainingSet) {
    for wanted in questions(set) {
        let Ok(found) = set.ask(&wanted) else { continue };
        let InCells(answer) = found.predict(set);
        let p = &answer.parameters;
        for (name, value) in p.named() {
            assert!(value.is_finite() && value >= 0.0, "{name} {value} for {wanted:?}");
        }
        assert!(p.rate > 0.0 && p.stretch > 0.0 && p.stretch <= 1.0, "{p:?} for {wanted:?}");
        assert!(p.ratio.is_none_or(|ratio| ratio > 0.0), "{p:?} for {wanted:?}");
        assert!(p.level.is_none_or(|level| level > 0.0 && level < 1.0), "{p:?} for {wanted:?}");
        for (name, [low, high]) in &answer.interval {
            assert!(low <= high, "{name} from {low} to {high} for {wanted:?}");
        }
    }
}

fn questions(set: &TrainingSet) -> Vec<InCells<Attributes>> {
    let mut asked: Vec<InCells<Attributes>> = set.rows().iter().take(2).map(|row| row.attributes).collect();
    if !set.system().is_striped() {
        for (area, aspect, angle, spacing) in
            [(1e-3, 1.0, 0.0, None), (60.0, 0.5, 179.999, Some(14.0)), (1e7, 0.01, -720.0, Some(1e-3))]
        {
            asked.push(InCells(Attributes::Spots(Spots { area, aspect, angle, spacing })));
        }
    } else {
        for (width, angle, wavelength) in
            [(1e-3, 0.0, None), (6.0, 91.0, Some(14.0)), (1e6, -1e9, Some(1e-3))]
        {
            asked.push(InCells(Attributes::Stripes(Stripes { width, angle, wavelength })));
        }
    }
    asked
}
