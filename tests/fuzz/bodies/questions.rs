//! Fuzz body for tables of questions (`lookup --batch`): there are as many answers as questions, and all are numbers.

use dapple::cli::lookup::answer_table;
use dapple_engine::synth::Training;
use std::sync::LazyLock;

use crate::refusal::assert_readable;

const FILE: &str = "bad.csv";
/// The most questions of a table that are answered.
const MOST: usize = 24;

static TRAINING: LazyLock<Training> = LazyLock::new(Training::default);

/// `bytes` are a table of questions, or are refused.
pub fn holds(bytes: &[u8]) {
    if bytes.iter().filter(|byte| matches!(byte, b'\n' | b'\r')).count() > MOST {
        return;
    }
    let mut table = Vec::new();
    match answer_table(&TRAINING, FILE, bytes, &mut table) {
        Ok(()) => answered(&table),
        Err(error) => assert_readable(&error.to_string(), FILE),
    }
}

fn answered(table: &[u8]) {
    let mut reader = csv::Reader::from_reader(table);
    // Other columns are copied, whatever their encoding is.
    let header = reader.byte_headers().expect("the answers have a header").clone();
    let place = |name: &str| {
        header.iter().rposition(|column| column == name.as_bytes()).expect("a column of answers")
    };
    let [coverage, rate, cell] = ["coverage", "rate", "cell"].map(place);
    for record in reader.byte_records() {
        let bytes = record.expect("the answers are a table");
        let record: Vec<_> = bytes.iter().map(String::from_utf8_lossy).collect();
        assert!(["inside", "edge", "outside"].contains(&&*record[coverage]), "{record:?}");
        for number in [rate, cell] {
            let number: f64 = record[number].parse().expect("a number");
            assert!(number.is_finite() && number > 0.0, "{record:?}");
        }
        for name in ["ratio", "stretch", "direction", "level", "pitch"] {
            let text = &record[place(name)];
            assert!(
                text.is_empty() || text.parse().is_ok_and(|n: f64| n.is_finite() && n >= 0.0),
                "{record:?}"
            );
        }
    }
}
