use super::*;
use crate::app::Tab;

fn somewhere() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("deep/settings");
    (folder, file)
}

#[test]
fn everything_is_remembered() {
    let (_folder, file) = somewhere();
    let mut settings = Settings::at(&file);
    settings.theme = ThemePreference::Dark;
    settings.hint_seen = true;
    settings.units = Units::Mm;
    settings.threads = Some(3);
    settings.new = New { size: [300, 200], regions: [3, 1], seamless: true, dpi: 150.5 };
    settings.layout = Layout {
        position: Some([-20.0, 40.0]),
        size: Some([900.0, 700.0]),
        maximised: true,
        tab: Tab::Colour,
        over: true,
        curtain: 0.25,
        linked: false,
        regions: false,
        analysis: true,
    };
    settings.remember(Path::new("/a/b\n%.dapple"));
    let again = Settings::at(&file);
    assert_eq!(again.recent, [Path::new("/a/b\n%.dapple")]);
    assert_eq!(again.entries(), settings.entries());
    assert_eq!((again.layout, again.new), (settings.layout.clone(), settings.new.clone()));
    settings.theme = ThemePreference::System;
    settings.layout = Layout::default();
    settings.write();
    let again = Settings::at(&file);
    assert_eq!((again.theme, again.layout), (ThemePreference::System, Layout::default()), "and back again");
}

#[test]
fn two_windows_do_not_overwrite_what_the_other_one_changed() {
    let (_folder, file) = somewhere();
    let (mut one, mut two) = (Settings::at(&file), Settings::at(&file));
    one.remember(Path::new("/one"));
    two.theme = ThemePreference::Dark;
    two.write();
    one.units = Units::Mm;
    one.remember(Path::new("/more"));
    two.remember(Path::new("/two"));
    two.write();
    let now = Settings::at(&file);
    assert_eq!(now.recent, [Path::new("/two"), Path::new("/more"), Path::new("/one")]);
    assert_eq!((now.theme, now.units), (ThemePreference::Dark, Units::Mm));
    // What one forgets is forgotten, and what it never touched stays as the other one left it.
    one.forget();
    one.write();
    let now = Settings::at(&file);
    assert!(now.recent.is_empty());
    assert_eq!(now.theme, ThemePreference::Dark);
}

#[test]
fn many_windows_at_once_lose_nothing() {
    let (_folder, file) = somewhere();
    std::thread::scope(|scope| {
        for window in 0..RECENT {
            let file = &file;
            scope.spawn(move || Settings::at(file).remember(&PathBuf::from(format!("/{window}"))));
        }
    });
    let mut recent = Settings::at(&file).recent;
    recent.sort();
    assert_eq!(recent, (0..RECENT).map(|window| PathBuf::from(format!("/{window}"))).collect::<Vec<_>>());
}

#[test]
fn what_a_newer_version_remembers_stays() {
    let (_folder, file) = somewhere();
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, "brush soft\ntheme light\nbrush hard\n").unwrap();
    let mut settings = Settings::at(&file);
    settings.theme = ThemePreference::Dark;
    settings.write();
    assert_eq!(fs::read_to_string(&file).unwrap(), "brush soft\nbrush hard\ntheme dark\n");
}

#[test]
fn a_damaged_file_is_put_aside_and_told() {
    let (_folder, file) = somewhere();
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    for bytes in [&b"theme dark\n\xff\xfe"[..], b"theme dark\0\0\0"] {
        fs::write(&file, bytes).unwrap();
        let settings = Settings::at(&file);
        assert!(settings.trouble.unwrap().contains("damaged"));
        assert_eq!(settings.theme, ThemePreference::System);
        assert_eq!(fs::read(file.with_extension("damaged")).unwrap(), bytes);
        assert!(Settings::at(&file).trouble.is_none(), "told once");
    }
}

#[test]
fn nonsense_is_passed_over() {
    let (_folder, file) = somewhere();
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    let lines =
        "threads none\nthreads\nnew 1 1 1\nsize 0 inf\nposition a b\ncurtain 7\ntab Other\nunits feet\n\n x";
    fs::write(&file, lines).unwrap();
    let settings = Settings::at(&file);
    assert!(settings.trouble.is_none());
    assert_eq!(settings.layout, Layout { curtain: 1.0, ..Layout::default() });
    assert_eq!((settings.threads, settings.units, settings.new), (None, Units::Px, New::default()));
    for cut in 0..lines.len() {
        fs::write(&file, &lines[..cut]).unwrap();
        assert!(Settings::at(&file).trouble.is_none());
    }
}
