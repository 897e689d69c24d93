use super::*;
use crate::document::{Layer, Stroke};
use crate::marks::Ellipse;

fn kept(x: f64, path: Option<&Path>) -> Kept {
    let ellipse = Ellipse { center: [x, 40.0], radii: [12.0, 6.0], angle: 30.0 };
    let layer = Layer { name: "a".into(), strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
    let document = Document { layers: vec![layer], ..Document::default() };
    Kept { document, path: path.map(Path::to_owned), name: "100 %\nnew".into() }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

#[test]
fn what_a_living_window_keeps_is_not_lost_and_what_a_dead_one_kept_is() {
    let folder = tempfile::tempdir().unwrap();
    let slot = Slot::new(folder.path()).unwrap();
    let what = kept(50.0, Some(Path::new("/nowhere/tiger.dapple")));
    slot.write(&what).unwrap();
    assert!(find(folder.path()).lost.is_empty(), "it lives");
    drop(slot);
    let found = find(folder.path());
    assert_eq!(found.lost.len(), 1);
    assert_eq!(found.lost[0].kept.document, what.document);
    assert_eq!(found.lost[0].kept.path, what.path);
    assert_eq!(found.lost[0].kept.name, what.name);
    assert_eq!(found.lost[0].marks.len(), 1);
    assert!(found.lost[0].when.elapsed().unwrap() < Duration::from_secs(60));
    assert!(find(folder.path()).lost.is_empty(), "one window asks about it");
    drop(found);
    assert_eq!(find(folder.path()).lost.len(), 1, "and another may later");
}

#[test]
fn what_was_forgotten_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let slot = Slot::new(folder.path()).unwrap();
    slot.write(&kept(50.0, None)).unwrap();
    slot.clear().unwrap();
    slot.clear().unwrap();
    drop(slot);
    assert_eq!(names(folder.path()), ["lock"]);
    let slot = Slot::new(folder.path()).unwrap();
    slot.write(&kept(50.0, None)).unwrap();
    drop(slot);
    find(folder.path()).lost.remove(0).remove().unwrap();
    assert_eq!(names(folder.path()), ["lock"]);
}

#[test]
fn several_that_were_lost_come_the_latest_first() {
    let folder = tempfile::tempdir().unwrap();
    for (name, when) in [("a", 1000), ("b", 3000), ("c", 2000)] {
        let slot = Slot::new(folder.path()).unwrap();
        slot.write(&Kept { name: name.into(), ..kept(50.0, None) }).unwrap();
        let text = fs::read_to_string(&slot.file).unwrap();
        let now = text.lines().nth(1).unwrap();
        fs::write(&slot.file, text.replace(now, &format!("when {when}"))).unwrap();
    }
    let found = find(folder.path());
    let names: Vec<_> = found.lost.iter().map(|lost| lost.kept.name.as_str()).collect();
    assert_eq!(names, ["b", "c", "a"]);
}

#[test]
fn what_is_in_the_file_already_was_not_lost() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.dapple");
    let recovery = folder.path().join("recovery");
    let what = kept(50.0, Some(&file));
    what.document.write(&file).unwrap();
    Slot::new(&recovery).unwrap().write(&what).unwrap();
    assert!(find(&recovery).lost.is_empty());
    assert_eq!(names(&recovery), ["lock"]);
    Slot::new(&recovery).unwrap().write(&kept(60.0, Some(&file))).unwrap();
    assert_eq!(find(&recovery).lost.len(), 1, "but what is not");
}

#[test]
fn damaged_ones_are_put_aside_wherever_they_were_cut() {
    let folder = tempfile::tempdir().unwrap();
    let slot = Slot::new(folder.path()).unwrap();
    slot.write(&kept(50.0, Some(Path::new("/a")))).unwrap();
    let whole = fs::read(&slot.file).unwrap();
    drop(slot);
    let file = find(folder.path()).lost[0].slot.file.clone();
    let last = whole.iter().rposition(|byte| *byte == b'}').unwrap();
    for cut in (0..=last).step_by(7) {
        fs::write(&file, &whole[..cut]).unwrap();
        let found = find(folder.path());
        assert_eq!((found.lost.len(), found.troubles.len()), (0, 1), "cut after {cut} bytes");
        assert!(file.with_extension("damaged").exists() && !file.exists());
        assert!(find(folder.path()).troubles.is_empty(), "and told once");
    }
    for bytes in [&b"\xff\xfe\0\0"[..], b"dapple recovery 2\n\n{}", b"dapple recovery 1\nwhen soon\n\n{}"] {
        fs::write(&file, bytes).unwrap();
        assert_eq!(find(folder.path()).troubles.len(), 1);
    }
}

#[test]
fn a_file_that_was_written_later_is_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.dapple");
    kept(70.0, None).document.write(&file).unwrap();
    let recovery = folder.path().join("recovery");
    let slot = Slot::new(&recovery).unwrap();
    slot.write(&kept(50.0, Some(&file))).unwrap();
    let text = fs::read_to_string(&slot.file).unwrap();
    let now = text.lines().nth(1).unwrap().to_owned();
    fs::write(&slot.file, text.replace(&now, "when 1000")).unwrap();
    drop(slot);
    assert!(find(&recovery).lost[0].file_is_newer);
}

#[test]
fn nothing_was_lost_where_there_is_no_folder() {
    let found = find(Path::new("/nowhere/at/all"));
    assert!(found.lost.is_empty() && found.troubles.is_empty());
}
