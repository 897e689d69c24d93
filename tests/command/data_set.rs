//! `dapple data-set`: the same items in any order, from any number of processes, and again after an interruption.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use assert_cmd::Command;
use dapple::data_set::FILES;

fn data_set(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let usual = ["data-set", "-q", "--size", "80", "--seed", "3", "-o"];
    Command::new(assert_cmd::cargo::cargo_bin!("dapple")).args(usual).arg(folder).args(arguments).assert()
}

/// The bytes of all files below a folder, by their paths.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else {
                let name = entry.strip_prefix(folder).unwrap().display().to_string();
                found.insert(name, fs::read(&entry).unwrap());
            }
        }
    }
    found
}

#[test]
fn items_are_the_same_in_any_order_and_from_several_processes() {
    let place = tempfile::tempdir().unwrap();
    let [whole, parts] = ["whole", "parts"].map(|name| place.path().join(name));
    data_set(&whole, &["--count", "7", "--threads", "2"]).success();
    // The last items first, and one of them twice.
    data_set(&parts, &["--first", "4", "--count", "3", "--threads", "1"]).success();
    data_set(&parts, &["--count", "5", "--threads", "3"]).success();
    let [whole, parts] = [whole, parts].map(|folder| files(&folder));
    assert_eq!(whole.len(), 1 + 7 * FILES.len());
    assert!(whole == parts);
}

#[test]
fn an_item_that_is_there_is_kept_and_a_missing_one_is_made_again() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("set");
    data_set(&folder, &["--count", "2", "--kinds", "stucco"]).success();
    let before = files(&folder);
    let [kept, lost] = [0, 1].map(|index| folder.join(format!("000000/{index:09}")));
    fs::write(kept.join("marks.csv"), "kept").unwrap();
    fs::remove_dir_all(lost).unwrap();
    data_set(&folder, &["--count", "2", "--kinds", "stucco"]).success();
    let after = files(&folder);
    assert_eq!(after["000000/000000000/marks.csv"], b"kept");
    assert!(after["000000/000000001/picture.png"] == before["000000/000000001/picture.png"]);
}

#[test]
fn a_folder_of_another_data_set_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("set");
    data_set(&folder, &["--count", "1", "--kinds", "stucco"]).success();
    let refused = data_set(&folder, &["--count", "1", "--kinds", "spots"]).code(2);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    assert!(message.contains("stucco") && message.contains("another folder"), "{message}");
    data_set(&folder, &["--count", "1", "--kinds", "dots"]).code(2);
}
