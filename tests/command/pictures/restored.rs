use super::{Folder, tile};
use serde_json::json;

#[test]
fn a_picture_grows_again_from_itself_with_seed_size_and_scale() {
    let folder = Folder::with(&tile());
    for more in ["", "--seed 7 --no-refine", "--size 100x150 --scale 2"] {
        folder.does(&format!("grow a.dapple -o one.png {more}"));
        folder.does("grow one.png -o two.png");
        assert!(folder.bytes("one.png") == folder.bytes("two.png"), "{more}");
    }
    // Options take precedence over the stored values.
    folder.does("grow one.png -o two.png --scale 1 --size 120x96");
    folder.does("grow a.dapple -o one.png");
    assert!(folder.bytes("one.png") == folder.bytes("two.png"));
}

#[test]
fn a_name_in_any_script_is_read_back() {
    let mut document = tile();
    document["name"] = json!("Flußpferd 河马 🦛");
    let folder = Folder::with(&document);
    folder.does("grow a.dapple -o one.png");
    let (read, _) = dapple::files::in_picture(folder.path("one.png")).unwrap().unwrap();
    assert_eq!(read.name, "Flußpferd 河马 🦛");
}

#[test]
fn a_picture_without_a_document_and_a_damaged_one_are_errors() {
    let folder = Folder::with(&tile());
    folder.does("grow a.dapple -o with.png");
    folder.does("grow a.dapple -o bare.png --no-document");
    assert!(folder.picture("with.png") == folder.picture("bare.png"));
    assert!(dapple::files::in_picture(folder.path("bare.png")).unwrap().is_none());
    folder.refuses("grow bare.png -o x.png", 1, &["bare.png", "without a document", ".dapple"]);
    folder.does("grow a.dapple -o a.jpg");
    folder.refuses("grow a.jpg -o x.png", 1, &["a.jpg", "without a document"]);
    let whole = folder.bytes("with.png");
    std::fs::write(folder.path("cut.png"), &whole[..60]).unwrap();
    folder.refuses("grow cut.png -o x.png", 1, &["cut.png", "damaged"]);
    folder.refuses("grow with.png -o with.png", 2, &["with.png", "two files"]);
}
