//! Build script: parses the training rows once, so that the program need not do it whenever it starts.
//!
//! `NAME.csv` of this folder becomes `NAME.rows` in `OUT_DIR`: the first line as it is, then the numbers of all rows in the order of
//! the file, each a double (IEEE 754) of eight bytes, the least significant first. `learn::compiled_rows` reads it. `all.pack` holds all
//! of them, each after a line with its name and the number of its bytes: `learn::bring_rows` takes it.

use std::fs;
use std::path::{Path, PathBuf};

fn main() {
    let from = |name: &str| PathBuf::from(std::env::var_os(name).expect("cargo sets it"));
    let (training, out) = (from("CARGO_MANIFEST_DIR").join("../../training"), from("OUT_DIR"));
    println!("cargo::rerun-if-changed={}", training.display());
    let mut pack = Vec::new();
    let entries = fs::read_dir(&training).expect("the folder training is there");
    let mut paths: Vec<PathBuf> =
        entries.map(|entry| entry.expect("its entries can be read").path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let Some(set) = name.strip_suffix(".csv").filter(|set| !set.ends_with(".rejected")) else { continue };
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let rows = compiled(&path, &text);
        pack.extend(format!("{set} {}\n", rows.len()).into_bytes());
        pack.extend(&rows);
        fs::write(out.join(format!("{set}.rows")), rows).expect("the rows can be written");
    }
    fs::write(out.join("all.pack"), pack).expect("the rows can be written");
}

fn compiled(path: &Path, text: &str) -> Vec<u8> {
    let mut lines = text.lines().enumerate();
    let header = lines.next().map_or("", |(_, header)| header);
    let columns = header.split(',').count();
    let mut bytes = format!("{header}\n").into_bytes();
    for (index, line) in lines {
        let wrong = |what: &str| -> ! { panic!("{}, line {}: {what}", path.display(), index + 1) };
        let before = bytes.len();
        for value in line.split(',') {
            let Ok(number) = value.parse::<f64>() else { wrong(&format!("'{value}' is not a number")) };
            bytes.extend(number.to_le_bytes());
        }
        if bytes.len() - before != 8 * columns {
            wrong(&format!("a row has {columns} numbers"));
        }
    }
    bytes
}
