use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};

use super::backup::BackupFile;
use super::*;
use crate::document::{Document, Layer, Stroke};
use crate::editor::task::Spawn;
use crate::files::WriteFile;
use crate::marks::Ellipse;

fn spot(x: f64) -> Mark {
    Mark::Ellipse(Ellipse { center: [x, 40.0], radii: [12.0, 6.0], angle: 30.0 })
}

fn backup(x: f64, path: Option<&Path>) -> Backup {
    let Mark::Ellipse(ellipse) = spot(x) else { unreachable!("a spot is an ellipse") };
    let layer = Layer { name: "a".into(), strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
    let document = Document { layers: vec![layer], ..Document::default() };
    Backup { document, path: path.map(Path::to_owned), name: "100 %\nnew".into() }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

fn backups(folder: &Path) -> Vec<PathBuf> {
    let files = names(folder).into_iter().filter(|name| name.ends_with(".dapple"));
    files.map(|name| folder.join(name)).collect()
}

/// Rewrites the time in a recovery file.
fn set_time(file: &Path, millis: u64) {
    let text = fs::read_to_string(file).unwrap();
    let from = text.find(r#""when":"#).unwrap() + 7;
    let to = from + text[from..].find([',', '}']).unwrap();
    fs::write(file, format!("{}{millis}{}", &text[..from], &text[to..])).unwrap();
}

#[test]
fn a_backup_is_found_once_its_window_is_gone() {
    let folder = tempfile::tempdir().unwrap();
    let file = BackupFile::new(folder.path()).unwrap();
    let what = backup(50.0, Some(Path::new("/nowhere/tiger.dapple")));
    file.write(&what).unwrap();
    assert!(find(folder.path()).lost.is_empty(), "its window lives");
    drop(file);
    let found = find(folder.path());
    assert_eq!(found.lost.len(), 1);
    let lost = &found.lost[0];
    assert_eq!((&lost.backup.document, &lost.backup.path), (&what.document, &what.path));
    assert_eq!((&lost.backup.name, lost.marks.len()), (&what.name, 1));
    assert!(lost.when.elapsed().unwrap() < Duration::from_secs(60));
    assert!(find(folder.path()).lost.is_empty(), "only one window offers it");
    drop(found);
    assert_eq!(find(folder.path()).lost.len(), 1, "another may offer it later");
}

#[test]
fn a_deleted_backup_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let file = BackupFile::new(folder.path()).unwrap();
    file.write(&backup(50.0, None)).unwrap();
    file.clear().unwrap();
    file.clear().unwrap();
    drop(file);
    assert_eq!(names(folder.path()), ["lock"]);
    let file = BackupFile::new(folder.path()).unwrap();
    file.write(&backup(50.0, None)).unwrap();
    drop(file);
    find(folder.path()).lost.remove(0).delete().unwrap();
    assert_eq!(names(folder.path()), ["lock"]);
}

#[test]
fn the_latest_of_several_comes_first() {
    let folder = tempfile::tempdir().unwrap();
    for (name, when) in [("a", 1000), ("b", 3000), ("c", 2000)] {
        let before = backups(folder.path());
        let file = BackupFile::new(folder.path()).unwrap();
        file.write(&Backup { name: name.into(), ..backup(50.0, None) }).unwrap();
        let new = backups(folder.path()).into_iter().find(|file| !before.contains(file));
        set_time(&new.unwrap(), when);
    }
    let found = find(folder.path());
    let names: Vec<_> = found.lost.iter().map(|lost| lost.backup.name.as_str()).collect();
    assert_eq!(names, ["b", "c", "a"]);
}

#[test]
fn a_file_of_an_older_dapple_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let document = backup(50.0, None).document.to_json();
    let text = format!(
        "dapple recovery 2\n{{\"when\":1732200000123,\"file\":\"/nowhere/a.dapple\",\"name\":\"a\"}}\n\n{document}"
    );
    fs::write(folder.path().join("1-2-3.dapple"), text).unwrap();
    let found = find(folder.path());
    assert!(found.errors.is_empty(), "{:?}", found.errors);
    assert_eq!(found.lost[0].backup.document, backup(50.0, None).document);
    assert_eq!(found.lost[0].backup.path.as_deref(), Some(Path::new("/nowhere/a.dapple")));
}

#[test]
fn a_backup_that_equals_its_file_is_not_offered() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.dapple");
    let recovery = folder.path().join("recovery");
    let what = backup(50.0, Some(&file));
    what.document.write(&file).unwrap();
    BackupFile::new(&recovery).unwrap().write(&what).unwrap();
    assert!(find(&recovery).lost.is_empty());
    assert_eq!(names(&recovery), ["lock"]);
    BackupFile::new(&recovery).unwrap().write(&backup(60.0, Some(&file))).unwrap();
    assert_eq!(find(&recovery).lost.len(), 1, "but one that differs is");
}

#[test]
fn damaged_files_are_renamed_wherever_they_were_cut() {
    let folder = tempfile::tempdir().unwrap();
    BackupFile::new(folder.path()).unwrap().write(&backup(50.0, Some(Path::new("/a")))).unwrap();
    let file = backups(folder.path()).remove(0);
    let whole = fs::read(&file).unwrap();
    let last = whole.iter().rposition(|byte| *byte == b'}').unwrap();
    for cut in (0..=last).step_by(7) {
        fs::write(&file, &whole[..cut]).unwrap();
        let found = find(folder.path());
        assert_eq!((found.lost.len(), found.errors.len()), (0, 1), "cut after {cut} bytes");
        assert!(file.with_extension("damaged").exists() && !file.exists());
        assert!(find(folder.path()).errors.is_empty(), "reported once");
    }
    for bytes in
        [&b"\xff\xfe\0\0"[..], b"dapple recovery 3\n\n{}", b"dapple recovery 2\n{\"when\":\"soon\"}\n\n{}"]
    {
        fs::write(&file, bytes).unwrap();
        assert_eq!(find(folder.path()).errors.len(), 1);
    }
}

#[test]
fn a_file_that_was_written_later_is_recognised() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.dapple");
    backup(70.0, None).document.write(&file).unwrap();
    let recovery = folder.path().join("recovery");
    BackupFile::new(&recovery).unwrap().write(&backup(50.0, Some(&file))).unwrap();
    set_time(&backups(&recovery)[0], 1000);
    assert!(find(&recovery).lost[0].file_is_newer);
}

#[test]
fn a_missing_folder_holds_no_backups() {
    let found = find(Path::new("/nowhere/at/all"));
    assert!(found.lost.is_empty() && found.errors.is_empty());
}

/// Waits for the result of a write. `woken` gets a message each time a task has a message or ends.
fn outcome(recovery: &mut Recovery, session: &Session, woken: &Receiver<()>) -> Result<Duration, String> {
    loop {
        if let Some(outcome) = recovery.update(session, None) {
            return outcome;
        }
        woken.recv_timeout(Duration::from_secs(60)).expect("something is written");
    }
}

#[test]
fn changes_in_quick_succession_are_all_kept_when_the_window_closes() {
    let folder = tempfile::tempdir().unwrap();
    let mut recovery = Recovery::new(Some(folder.path().to_owned()), Tasks::default());
    let mut session = Session::default();
    for x in 0..5 {
        session.add(&[spot(20.0 + 40.0 * f64::from(x))]);
        recovery.update(&session, None);
    }
    drop(recovery);
    assert_eq!(find(folder.path()).lost[0].backup.document, session.finished());
}

#[test]
fn undone_work_is_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let (wake, woken) = channel();
    let tasks = Tasks::new(move || {
        let _ = wake.send(());
    });
    let mut recovery = Recovery::new(Some(folder.path().to_owned()), tasks);
    let mut session = Session::default();
    session.add(&[spot(50.0)]);
    outcome(&mut recovery, &session, &woken).unwrap();
    assert_eq!(backups(folder.path()).len(), 1);
    session.undo();
    recovery.update(&session, None);
    drop(recovery);
    assert_eq!(names(folder.path()), ["lock"]);
}

#[test]
fn a_thread_that_does_not_start_is_reported_and_the_work_is_kept_at_the_end() {
    let folder = tempfile::tempdir().unwrap();
    let tasks = Tasks::default().with_spawn(Spawn(|_, _| Err(io::Error::other("none left"))));
    let mut recovery = Recovery::new(Some(folder.path().to_owned()), tasks);
    let mut session = Session::default();
    session.add(&[spot(50.0)]);
    let why = recovery.update(&session, None).unwrap().unwrap_err();
    assert!(why.contains("recovery") && why.contains("none left"), "{why}");
    drop(recovery);
    assert_eq!(find(folder.path()).lost.len(), 1);
}

/// A window's recovery that has searched `folder`, and the error messages.
fn searched(folder: &Path) -> (Recovery, Vec<String>) {
    let mut recovery = Recovery::new(Some(folder.to_owned()), Tasks::default());
    recovery.search().unwrap();
    let errors = heard(&mut recovery);
    (recovery, errors)
}

/// Waits until no search and no deletion is running.
fn heard(recovery: &mut Recovery) -> Vec<String> {
    let mut errors = Vec::new();
    while recovery.is_busy() {
        errors.extend(recovery.listen());
        std::thread::yield_now();
    }
    errors
}

#[test]
fn a_postponed_document_is_found_by_the_next_search() {
    let folder = tempfile::tempdir().unwrap();
    BackupFile::new(folder.path()).unwrap().write(&backup(50.0, None)).unwrap();
    let (mut recovery, errors) = searched(folder.path());
    assert_eq!((recovery.lost().len(), recovery.undecided(), errors.len()), (1, 1, 0));
    assert!(searched(folder.path()).0.lost().is_empty(), "only one window offers it");
    recovery.postpone();
    assert_eq!((recovery.lost().len(), recovery.undecided()), (0, 1));
    recovery.search().unwrap();
    heard(&mut recovery);
    assert_eq!(recovery.lost().len(), 1);
    // A search that is requested while one is running gets the results of that one.
    recovery.search().unwrap();
    recovery.postpone();
    recovery.search().unwrap();
    heard(&mut recovery);
    assert_eq!(recovery.lost().len(), 1);
}

#[test]
fn documents_found_after_the_offer_has_ended_are_counted_and_released() {
    let folder = tempfile::tempdir().unwrap();
    BackupFile::new(folder.path()).unwrap().write(&backup(50.0, None)).unwrap();
    let mut recovery = Recovery::new(Some(folder.path().to_owned()), Tasks::default());
    recovery.search().unwrap();
    recovery.postpone();
    heard(&mut recovery);
    assert_eq!((recovery.lost().len(), recovery.undecided()), (0, 1));
    assert_eq!(find(folder.path()).lost.len(), 1, "another window may offer it");
}

#[test]
fn a_restored_document_is_compared_with_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.dapple");
    let saved = backup(70.0, None).document;
    saved.write(&file).unwrap();
    let recovery = folder.path().join("recovery");
    for (path, saved) in [(Some(&*file), saved), (None, Document::default())] {
        BackupFile::new(&recovery).unwrap().write(&backup(50.0, path)).unwrap();
        let (mut found, _) = searched(&recovery);
        let id = found.lost()[0].id();
        let (mut session, _) = found.restore(&id).unwrap();
        assert!(session.is_changed());
        session.edit(|document| *document = saved);
        assert!(!session.is_changed());
        found.restored.remove(0).delete().unwrap();
    }
}

#[test]
fn discarding_that_fails_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    BackupFile::new(folder.path()).unwrap().write(&backup(50.0, None)).unwrap();
    let (mut recovery, _) = searched(folder.path());
    let file = backups(folder.path()).remove(0);
    fs::remove_file(&file).unwrap();
    fs::create_dir(&file).unwrap();
    let id = recovery.lost()[0].id();
    recovery.discard(&id);
    let errors = heard(&mut recovery);
    assert!(errors.len() == 1 && errors[0].contains("could not be discarded"), "{errors:?}");
}
