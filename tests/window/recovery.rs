//! Unsaved work survives a crash, and two windows do not disturb each other.

use std::fs;
use std::path::{Path, PathBuf};

use dapple::app::{Layout, Settings, Start, Tab, Window};
use dapple::document::Document;
use dapple::{ReadFile, WriteFile};
use egui::{Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, with};
#[cfg(unix)]
use crate::hand::{opened, pipe};

const RESTORE: &str = "Restore";

/// A window that backs up its unsaved work in `folder`. Dropping it has the same effect as a kill.
fn window(folder: &Path, file: Option<&Path>) -> Hand {
    with(start(folder, file), vec2(1280.0, 800.0), Theme::Light)
}

fn start(folder: &Path, file: Option<&Path>) -> Start {
    let recovery = Some(folder.join("recovery"));
    let settings = Settings::read(&folder.join("settings"));
    Start { file: file.map(Path::to_owned), settings, recovery, ..Start::default() }
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"))
}

/// The files in the recovery folder.
fn backups(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder.join("recovery")) else { return Vec::new() };
    let files = entries.map(|entry| entry.unwrap().path());
    files.filter(|file| file.extension().is_some_and(|ending| ending == "dapple")).collect()
}

fn until_backups(hand: &mut Hand, folder: &Path, number: usize) {
    hand.until("the backup", |_| backups(folder).len() == number);
}

fn is_offered(hand: &Hand) -> usize {
    hand.window.query_all_by_label(RESTORE).count()
}

#[test]
fn a_sketch_from_before_a_crash_is_offered_once_and_restored() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = window(folder.path(), None);
    assert_eq!(is_offered(&hand), 0);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.drag(&[[100.0, 400.0], [300.0, 430.0]]);
    let drawn = hand.document();
    drop(hand);
    assert_eq!(backups(folder.path()).len(), 1);

    let mut hand = window(folder.path(), None);
    assert_eq!(is_offered(&hand), 1);
    assert!(hand.window.query_by_label("Sketch of untitled").is_some());
    assert!(hand.window.query_by_label_contains("2 marks on 512 × 512 px").is_some());
    assert!(hand.window.query_by_label("Never saved to a file").is_some());
    hand.press(RESTORE);
    assert_eq!(hand.document(), drawn);
    assert!(hand.window.state().session().is_changed(), "it is not saved yet");
    assert_eq!(is_offered(&hand), 0);
    hand.key(Modifiers::COMMAND, Key::S);
    let file = folder.path().join("mine.dapple");
    hand.type_into("File", file.to_str().unwrap());
    assert_eq!(Document::read(&file).unwrap(), drawn);
    until_backups(&mut hand, folder.path(), 0);
    drop(hand);
    assert_eq!(is_offered(&window(folder.path(), None)), 0, "never twice");
}

#[test]
fn restored_unsaved_work_survives_the_next_crash() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = window(folder.path(), None);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    drop(hand);
    let mut hand = window(folder.path(), None);
    hand.press(RESTORE);
    hand.draw_round([300.0, 200.0], [40.0, 20.0], 30.0);
    let drawn = hand.document();
    drop(hand);
    assert_eq!(backups(folder.path()).len(), 1, "one of them, not both");
    let mut hand = window(folder.path(), None);
    hand.press(RESTORE);
    assert_eq!(hand.document(), drawn);
}

#[test]
fn changes_of_a_file_come_back_with_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tiger.dapple");
    fs::copy(example("tiger"), &file).unwrap();
    let mut hand = window(folder.path(), Some(&file));
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::ArrowRight);
    let moved = hand.document();
    drop(hand);
    let mut hand = window(folder.path(), None);
    assert!(hand.window.query_by_label(file.to_str().unwrap()).is_some());
    hand.press(RESTORE);
    assert_eq!(hand.document(), moved);
    assert_eq!(hand.window.state().session().path.as_deref(), Some(&*file));
    hand.key(Modifiers::COMMAND, Key::S);
    assert_eq!(Document::read(&file).unwrap(), moved, "it is saved where it came from");
    until_backups(&mut hand, folder.path(), 0);
}

#[cfg(unix)]
#[test]
fn the_window_can_be_used_while_unsaved_work_is_searched_for() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tiger.dapple");
    let saved = Document::read(example("tiger")).unwrap();
    saved.write(&file).unwrap();
    let mut hand = window(folder.path(), Some(&file));
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::ArrowRight);
    let moved = hand.document();
    drop(hand);
    fs::remove_file(&file).unwrap();
    pipe(&file);
    let settings = start(folder.path(), None);
    let mut hand = opened(settings, vec2(1280.0, 800.0), Theme::Light);
    hand.window.run_steps(4);
    assert!(hand.window.state().is_busy_with_files() && is_offered(&hand) == 0);
    hand.window.key_press_modifiers(Modifiers::SHIFT, Key::E);
    hand.window.run_steps(4);
    assert_eq!(hand.strokes().len(), 1, "an ellipse is inserted meanwhile");
    fs::write(&file, saved.to_json()).unwrap();
    hand.rest();
    assert_eq!(is_offered(&hand), 1);
    hand.press(RESTORE);
    hand.press("Don't save");
    assert_eq!(hand.document(), moved);
}

#[test]
fn saved_undone_or_discarded_work_is_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = window(folder.path(), None);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    until_backups(&mut hand, folder.path(), 1);
    hand.key(Modifiers::COMMAND, Key::Z);
    until_backups(&mut hand, folder.path(), 0);
    hand.key(Modifiers::COMMAND, Key::Y);
    until_backups(&mut hand, folder.path(), 1);
    hand.key(Modifiers::COMMAND, Key::N);
    hand.press("Don't save");
    assert_eq!(backups(folder.path()).len(), 1, "the new one was not made yet");
    hand.press("Create");
    until_backups(&mut hand, folder.path(), 0);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    until_backups(&mut hand, folder.path(), 1);
    hand.key(Modifiers::COMMAND, Key::Q);
    hand.press("Don't save");
    drop(hand);
    assert!(backups(folder.path()).is_empty());
    let left: Vec<_> = fs::read_dir(folder.path().join("recovery")).unwrap().collect();
    assert_eq!(left.len(), 1, "nothing but the lock is left: {left:?}");
}

#[test]
fn discarding_a_backup_asks_for_confirmation_and_deletes_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = window(folder.path(), None);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    drop(hand);
    let mut hand = window(folder.path(), None);
    hand.press("Discard");
    assert_eq!(backups(folder.path()).len(), 1);
    hand.press("Discard permanently");
    assert!(backups(folder.path()).is_empty());
    assert_eq!(is_offered(&hand), 0);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    assert_eq!(hand.strokes().len(), 1, "the page is gone, too");
}

#[test]
fn several_backups_can_be_postponed_by_keys_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mut windows = [window(folder.path(), None), window(folder.path(), None)];
    for (x, hand) in [150.0, 250.0].into_iter().zip(&mut windows) {
        hand.draw_round([x, 200.0], [40.0, 20.0], 30.0);
    }
    drop(windows);
    let mut hand = window(folder.path(), None);
    assert_eq!(is_offered(&hand), 2);
    hand.key(Modifiers::NONE, Key::Escape);
    assert_eq!((is_offered(&hand), backups(folder.path()).len()), (0, 2));
    assert_eq!(is_offered(&window(folder.path(), None)), 2, "whoever starts next may decide");
    hand.window.get_by_label("File").click();
    hand.rest();
    hand.click_label("Recover unsaved work");
    hand.rest();
    assert_eq!(is_offered(&hand), 2);
    // The first one has the focus.
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.strokes().len(), 1);
    // The restored document is unsaved, so the window asks before it opens the other one.
    hand.window.get_by_label("File").click();
    hand.rest();
    hand.click_label("Recover unsaved work");
    hand.rest();
    hand.press(RESTORE);
    hand.press("Cancel");
    hand.key(Modifiers::NONE, Key::Escape);
    assert_eq!(hand.strokes().len(), 1);
}

#[test]
fn the_backup_of_a_running_window_is_not_offered_to_another() {
    let folder = tempfile::tempdir().unwrap();
    let mut one = window(folder.path(), None);
    one.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    until_backups(&mut one, folder.path(), 1);
    let mut two = window(folder.path(), None);
    assert_eq!(is_offered(&two), 0);
    two.draw_round([250.0, 200.0], [40.0, 20.0], 30.0);
    until_backups(&mut two, folder.path(), 2);
    drop(one);
    assert_eq!(is_offered(&window(folder.path(), None)), 1, "the one that is no more");
    until_backups(&mut two, folder.path(), 2);
}

#[test]
fn a_damaged_backup_is_reported_and_the_window_opens() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("recovery")).unwrap();
    fs::write(folder.path().join("recovery/1-2-3.dapple"), "dapple recovery 2\n{\"when\":17}\n\n{\"form")
        .unwrap();
    fs::write(folder.path().join("settings"), b"theme dark\xff").unwrap();
    let mut hand = window(folder.path(), None);
    let notices = hand.window.state().notices().to_vec();
    assert_eq!(notices.len(), 2, "{notices:?}");
    assert!(notices.iter().all(|notice| notice.wrong && notice.text.contains("was renamed")));
    assert!(folder.path().join("recovery/1-2-3.damaged").exists());
    assert!(folder.path().join("settings.damaged").exists());
    assert_eq!(is_offered(&hand), 0);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    until_backups(&mut hand, folder.path(), 1);
}

#[test]
fn a_backup_folder_that_cannot_be_written_is_reported_once() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("recovery"), "a file where a folder should be").unwrap();
    let mut hand = window(folder.path(), None);
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.until("a notice", |window| !window.notices().is_empty());
    let notices = hand.window.state().notices().to_vec();
    assert!(notices[0].wrong && notices[0].text.contains("Save often"), "{notices:?}");
    hand.rest();
    hand.press("OK");
    hand.draw_round([250.0, 200.0], [40.0, 20.0], 30.0);
    hand.rest();
    assert!(hand.window.state().notices().is_empty());
}

#[test]
fn the_window_opens_with_its_last_size_and_position() {
    crate::hand::with_goals();
    let folder = tempfile::tempdir().unwrap();
    let mut hand = window(folder.path(), None);
    hand.press("Canvas");
    hand.press("Link both views");
    hand.press("Analysis of the sketch");
    hand.press("Texture over the sketch");
    hand.press("Colour");
    hand.window.state_mut().leave();
    let layout = Settings::read(&folder.path().join("settings")).layout;
    let wanted = Layout { tab: Tab::Colour, over: true, linked: false, analysis: true, ..Layout::default() };
    assert_eq!(Layout { size: None, position: None, ..layout }, wanted);
    let mut again = window(folder.path(), None);
    assert!(again.window.query_by_label("Region grid").is_none(), "Colour is open");
    again.window.state_mut().leave();
    let layout = Settings::read(&folder.path().join("settings")).layout;
    assert_eq!(Layout { size: None, position: None, ..layout }, wanted);
}

#[test]
fn a_window_without_a_backup_folder_writes_no_backups() {
    let mut hand = crate::hand::hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.rest();
    assert!(Window::notices(hand.window.state()).is_empty());
}
