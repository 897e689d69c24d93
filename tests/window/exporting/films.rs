//! Films: the preview plays what is written.

use super::*;

#[test]
fn a_film_plays_in_the_preview_and_is_written_as_shown() {
    for (format, name) in [("GIF", "x.gif"), ("Animated PNG", "x.png"), ("Single PNG, in a folder", "frames")]
    {
        let (mut hand, folder) = small();
        open(&mut hand, "Film");
        if format != "GIF" {
            take(&mut hand, "Format of the film", format);
        }
        hand.type_into("Length", "0.4");
        hand.press("Preview the film");
        let made = seen(&mut hand);
        assert_eq!(made.frames().len(), 8);
        let path = folder.path().join(name);
        write(&mut hand, &path);
        if path.is_dir() {
            for (index, (frame, _)) in made.frames().iter().enumerate() {
                same(frame, &path.join(format!("frame-{:04}.png", index + 1)));
            }
            continue;
        }
        let dapple = assert_cmd::cargo::cargo_bin!("dapple");
        let other = folder.path().join(format!("cli-{name}"));
        let mut film = Command::new(dapple);
        film.arg("film").arg(folder.path().join("a.dapple")).arg("-o").arg(&other);
        film.args(["--seconds", "0.4", "-q"]).assert().success();
        assert!(fs::read(&path).unwrap() == fs::read(&other).unwrap(), "{format}");
        if format != "GIF" {
            // Decoders of plain PNGs show the first frame of an animated one.
            same(&made.frames()[0].0, &path);
        }
    }
}

#[test]
fn one_document_becomes_another_in_a_film() {
    let (mut hand, folder) = small();
    let other = folder.path().join("other.dapple");
    let text = r#"{"format": "dapple", "version": 1, "size": [96, 80], "layers": [
        {"strokes": [{"kind": "ellipse", "center": [40, 40], "radii": [7, 6], "angle": 80}]}]}"#;
    Document::parse(text, "other").unwrap().write(&other).unwrap();
    open(&mut hand, "Film");
    hand.press("The change into another document");
    hand.press("Choose a document…");
    hand.type_path("File", &other);
    hand.type_into("Length", "0.3");
    hand.press("Preview the film");
    let made = seen(&mut hand);
    assert_eq!(made.frames().len(), 6);
    let path = folder.path().join("x.gif");
    write(&mut hand, &path);
    let dapple = assert_cmd::cargo::cargo_bin!("dapple");
    let cli = folder.path().join("cli.gif");
    let mut film = Command::new(dapple);
    film.arg("film").arg(folder.path().join("a.dapple")).arg("-o").arg(&cli).arg("--to").arg(&other);
    film.args(["--seconds", "0.3", "-q"]).assert().success();
    assert_eq!(fs::read(&path).unwrap(), fs::read(&cli).unwrap());
}
