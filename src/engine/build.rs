//! Build script: parses the training rows once, so that the program need not do it whenever it starts, and copies the small pictures of
//! the systems to where the program includes them from.
//!
//! `NAME.csv` of the training rows becomes `NAME.rows` in `OUT_DIR`: the first line as it is, then the numbers of all rows in the order
//! of the file, each a double (IEEE 754) of eight bytes, the least significant first. `learn::compiled_rows` reads it. `all.pack` holds
//! all of them, each after a line with its name and the number of its bytes: `learn::bring_rows` takes it.

use std::fs;
use std::path::{Path, PathBuf};

fn main() {
    let out = from("OUT_DIR");
    let mut pack = Vec::new();
    for path in files("training", "../../training") {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let Some(set) = name.strip_suffix(".csv").filter(|set| !set.ends_with(".rejected")) else { continue };
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let rows = compiled(&path, &text);
        pack.extend(format!("{set} {}\n", rows.len()).into_bytes());
        pack.extend(&rows);
        fs::write(out.join(format!("{set}.rows")), rows).expect("the rows can be written");
    }
    fs::write(out.join("all.pack"), pack).expect("the rows can be written");
    for path in files("systems", "../../assets/systems") {
        let name = path.file_name().expect("a file has a name");
        fs::copy(&path, out.join(name)).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

fn from(name: &str) -> PathBuf {
    PathBuf::from(std::env::var_os(name).expect("cargo sets it"))
}

/// The files of a folder, sorted. `linked` is a symbolic link in this package, which cargo follows when it packs; where links cannot be
/// checked out, `original` is the folder of the repository to which it leads.
fn files(linked: &str, original: &str) -> Vec<PathBuf> {
    let root = from("CARGO_MANIFEST_DIR");
    let folders = [linked, original].map(|name| root.join(name));
    let folder = folders.iter().find(|folder| folder.is_dir());
    let folder = folder.unwrap_or_else(|| panic!("found neither the folder {linked} nor {original}"));
    println!("cargo::rerun-if-changed={}", folder.display());
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> =
        entries.map(|entry| entry.expect("its entries can be read").path()).collect();
    paths.sort();
    paths
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
