//! The window on a full disk: it reports the fault, loses nothing, and saves as soon as there is room.

use std::fs;
use std::path::Path;

use dapple::ReadFile;
use dapple::app::{Settings, Start};
use dapple::document::Document;
use egui::{Key, Modifiers, Theme, vec2};

use crate::bench::{DOCUMENT, files};
use crate::hand::{Hand, with};
use crate::mounts::Mounted;

fn window(start: Start) -> Hand {
    with(start, vec2(1280.0, 800.0), Theme::Light)
}

/// The text of the only notice, which must be an error.
#[track_caller]
fn notice(hand: &Hand) -> String {
    let notices = hand.window.state().notices().to_vec();
    assert!(notices.len() == 1 && notices[0].wrong, "{notices:?}");
    notices[0].text.clone()
}

#[test]
fn a_document_that_cannot_be_saved_stays_unsaved_and_its_file_whole() {
    for full in [true, false] {
        let folder = tempfile::tempdir().unwrap();
        let Some(mounted) = Mounted::on(&folder.path().join("disk")) else { return };
        let path = folder.path().join("disk/a.dapple");
        fs::write(&path, DOCUMENT).unwrap();
        let mut hand = window(Start { file: Some(path.clone()), ..Start::default() });
        if full {
            mounted.fill(0);
        } else {
            mounted.protect();
        }
        let before = files(&folder.path().join("disk"));
        hand.draw_round([70.0, 70.0], [10.0, 6.0], 30.0);
        assert!(hand.window.state().session().is_changed());
        hand.key(Modifiers::COMMAND, Key::S);
        let said = notice(&hand);
        let remedy = if full {
            "the disk is full; free some space"
        } else {
            "is not permitted; choose another folder"
        };
        assert!(said.contains("a.dapple") && said.contains(remedy), "{said}");
        assert!(hand.window.state().session().is_changed(), "it is not saved");
        assert!(files(&folder.path().join("disk")) == before);
        if full {
            mounted.make_room();
            hand.press("OK");
            hand.key(Modifiers::COMMAND, Key::S);
            assert!(!hand.window.state().session().is_changed());
            assert_eq!(Document::read(&path).unwrap(), hand.document());
        }
    }
}

#[test]
fn unsaved_work_without_room_on_the_disk_is_reported_once_and_kept_once_there_is_room() {
    let folder = tempfile::tempdir().unwrap();
    let disk = folder.path().join("disk");
    let Some(mounted) = Mounted::on(&disk) else { return };
    fs::create_dir(disk.join("recovery")).unwrap();
    mounted.fill(0);
    let mut hand = window(Start { recovery: Some(disk.join("recovery")), ..Start::default() });
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.until("a notice", |window| !window.notices().is_empty());
    assert!(notice(&hand).contains("the disk is full"), "{}", notice(&hand));
    // The notice is shown from the next frame on.
    hand.rest();
    hand.press("OK");
    mounted.make_room();
    hand.draw_round([250.0, 200.0], [40.0, 20.0], 30.0);
    let kept = |at: &Path| files(at).keys().any(|name| name.ends_with(".dapple"));
    hand.until("the slot", |_| kept(&disk.join("recovery")));
    assert!(hand.window.state().notices().is_empty());
}

#[test]
fn preferences_that_cannot_be_written_are_no_error_and_stay_whole() {
    let folder = tempfile::tempdir().unwrap();
    let disk = folder.path().join("disk");
    let Some(mounted) = Mounted::on(&disk) else { return };
    let file = disk.join("settings");
    fs::write(&file, "{\"theme\": \"dark\"}\n").unwrap();
    mounted.fill(0);
    let mut settings = Settings::read(&file);
    settings.remember(&folder.path().join("a.dapple"));
    settings.write();
    assert_eq!(fs::read_to_string(&file).unwrap(), "{\"theme\": \"dark\"}\n");
    assert!(Settings::read(&file).error.is_none());
}
