use super::*;
use crate::app::Tab;
use crate::editor::snap::Snap;
use std::fs;

fn somewhere() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("deep/settings");
    (folder, file)
}

#[test]
fn everything_is_remembered() {
    let (_folder, file) = somewhere();
    let mut settings = Settings::read(&file);
    settings.theme = ThemePreference::Dark;
    settings.units = Units::Mm;
    settings.threads = Some(3);
    settings.wheel = Wheel::Zoom;
    settings.scale = 1.25;
    settings.site = "https://a.example/".to_owned();
    settings.new = New { size: [300, 200], regions: Some([3, 1]), seamless: true, dpi: 150.5 };
    settings.layout = Layout {
        position: Some([-20.0, 40.0]),
        size: Some([900.0, 700.0]),
        maximised: true,
        tab: Tab::Colour,
        tools: false,
        column: false,
        column_width: 300.0,
        over: true,
        curtain: 0.25,
        linked: false,
        goals: false,
        regions: false,
        analysis: true,
        wanted: false,
        snap: Snap { on: true, step: 20.0 },
    };
    settings.remember(Path::new("/a/b\n%.dapple"));
    settings.write();
    let again = Settings::read(&file);
    assert_eq!(again.recent, [Path::new("/a/b\n%.dapple")]);
    assert_eq!(again.entries(), settings.entries());
    assert_eq!((again.wheel, again.scale), (Wheel::Zoom, 1.25));
    assert_eq!(again.site, "https://a.example/");
    assert_eq!((again.layout, again.new), (settings.layout.clone(), settings.new.clone()));
    settings.theme = ThemePreference::System;
    settings.layout = Layout::default();
    settings.write();
    let again = Settings::read(&file);
    assert_eq!((again.theme, again.layout), (ThemePreference::System, Layout::default()), "and back again");
}

#[test]
fn two_windows_do_not_overwrite_what_the_other_one_changed() {
    let (_folder, file) = somewhere();
    let (mut one, mut two) = (Settings::read(&file), Settings::read(&file));
    one.remember(Path::new("/one"));
    one.write();
    two.theme = ThemePreference::Dark;
    two.write();
    one.units = Units::Mm;
    one.remember(Path::new("/more"));
    one.write();
    two.remember(Path::new("/two"));
    two.write();
    let now = Settings::read(&file);
    assert_eq!(now.recent, [Path::new("/two"), Path::new("/more"), Path::new("/one")]);
    assert_eq!((now.theme, now.units), (ThemePreference::Dark, Units::Mm));
    // What one window removes from the list stays removed, and what it never changed stays as the other window left it.
    one.forget();
    one.write();
    let now = Settings::read(&file);
    assert!(now.recent.is_empty());
    assert_eq!(now.theme, ThemePreference::Dark);
}

#[test]
fn documents_used_while_the_settings_are_written_stay_recent() {
    let (_folder, file) = somewhere();
    let mut settings = Settings::read(&file);
    settings.remember(Path::new("/one"));
    let change = settings.take_change().unwrap();
    assert!(settings.take_change().is_none(), "nothing is written twice");
    settings.remember(Path::new("/two"));
    settings.take_recent(change.write().recent);
    assert_eq!(settings.recent, [Path::new("/two"), Path::new("/one")]);
    settings.write();
    assert_eq!(Settings::read(&file).recent, settings.recent);
}

#[test]
fn many_windows_at_once_lose_nothing() {
    const WINDOWS: usize = 10;
    let (_folder, file) = somewhere();
    std::thread::scope(|scope| {
        for window in 0..WINDOWS {
            let file = &file;
            scope.spawn(move || {
                let mut settings = Settings::read(file);
                settings.remember(&PathBuf::from(format!("/{window}")));
                settings.write();
            });
        }
    });
    let mut recent = Settings::read(&file).recent;
    recent.sort();
    assert_eq!(recent, (0..WINDOWS).map(|window| PathBuf::from(format!("/{window}"))).collect::<Vec<_>>());
}

#[test]
fn settings_of_a_newer_version_are_kept() {
    let (_folder, file) = somewhere();
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, r#"{"brush": ["soft", "hard"], "theme": "light"}"#).unwrap();
    let mut settings = Settings::read(&file);
    settings.theme = ThemePreference::Dark;
    settings.write();
    let text = fs::read_to_string(&file).unwrap();
    let wanted = "{\n  \"brush\": [\n    \"soft\",\n    \"hard\"\n  ],\n  \"theme\": \"dark\"\n}\n";
    assert_eq!(text, wanted);
}

#[test]
fn a_damaged_file_is_renamed_and_reported() {
    let (_folder, file) = somewhere();
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, b"theme dark\n\xff\xfe").unwrap();
    let settings = Settings::read(&file);
    assert!(settings.error.unwrap().contains("settings.damaged"));
    assert_eq!(settings.theme, ThemePreference::System);
    assert!(Settings::read(&file).error.is_none(), "reported once");
}

#[test]
fn invalid_values_get_their_default() {
    let (_folder, file) = somewhere();
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    let json = r#"{"threads": -1, "new": {"size": [1, 1]}, "size": [0, 9], "position": ["a"], "curtain": 7,
        "tab": "Other", "units": "feet", "theme": 3}"#;
    fs::write(&file, json).unwrap();
    let settings = Settings::read(&file);
    assert!(settings.error.is_none());
    assert_eq!(settings.layout, Layout { curtain: 1.0, ..Layout::default() });
    assert_eq!((settings.threads, settings.units, settings.new), (None, Units::Px, New::default()));
}
