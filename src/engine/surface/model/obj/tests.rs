use super::*;
use crate::surface::model::reading::tests::is_whole;
use proptest::prelude::*;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn read(text: &str) -> Result<Model, ModelError> {
    read_obj(text.as_bytes(), "cat.obj")
}

fn positions(model: &Model) -> Vec<[u32; 3]> {
    model.faces.iter().map(|face| face.corners.map(|corner| corner.position)).collect()
}

#[test]
fn every_way_to_write_a_corner_is_read() {
    let head = format!("{SQUARE}vt 0 0\nvt .5\nvn 0 0 1\n");
    let first = |line: &str| read(&format!("{head}{line}")).unwrap().faces[0].corners[0];
    let corner = |position, uv, normal| Corner { position, uv, normal };
    assert_eq!(first("f 1 2 3"), corner(0, None, None));
    assert_eq!(first("f 2/2 2/1 3/1"), corner(1, Some(1), None));
    assert_eq!(first("f 1//1 2//1 3//1"), corner(0, None, Some(0)));
    assert_eq!(first("f 3/2/1 1/1/1 2/1/1"), corner(2, Some(1), Some(0)));
    assert_eq!(first("f -4/-2/-1 -3 -2"), corner(0, Some(0), Some(0)));
    assert_eq!(first("f 1/ 2/ 3/"), corner(0, None, None));
    assert_eq!(first("f 1// 2// 3//"), corner(0, None, None));
    assert_eq!(read(&head.replace("\n", "\r\n")).unwrap_err().to_string().matches("no faces").count(), 1);
}

#[test]
fn what_exporters_write_is_read() {
    let text = "\u{feff}# by hand\r\nmtllib x.mtl\r\nv 0 0 0 1 .5 .25\r\n  v 1e0 0. \\\r\n  0 # right\r\n\tv 1 1 0 1.0 0 0 1\r\nv 0 1 0\r\n\
        s off\r\no a b\r\ng\r\nusemtl Fell#2\r\nf 1 2 \\\r\n3 4\r\nl 1 2\r\nf 1 2\r\n\r\n";
    let model = read(text).unwrap();
    assert_eq!(model.positions, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(positions(&model).len(), 2);
    assert_eq!(
        model.parts,
        [Part { object: Some("a b".into()), groups: vec![], material: Some("Fell#2".into()) }]
    );
    assert_eq!(model.notes.len(), 2, "{:?}", model.notes);
    assert!(read_obj(b"g f\xe9\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0", "latin.obj").is_ok());
}

#[test]
fn a_part_that_comes_again_is_the_same_part() {
    let model = read(&format!("{SQUARE}g a\nf 1 2 3\ng b\nf 1 3 4\ng a\nf 2 3 4\n")).unwrap();
    assert_eq!(model.parts.len(), 2);
    assert_eq!(model.faces.iter().map(|face| face.part).collect::<Vec<_>>(), [0, 1, 0]);
}

#[test]
fn errors_name_file_line_value_what_is_allowed_and_the_remedy() {
    let cases = [
        ("v 1 2", "2 numbers after v", "3 numbers"),
        ("v 1 x 2", "'x' after v", "numbers such as"),
        ("v 1,5 2 3", "'1,5' after v", "decimal point"),
        ("f 1 2 9", "position 9", "of 1 to 4 positions"),
        ("f 1 2 0", "the corner '0'", "of 1 to 4 positions"),
        ("f 1 2 -5", "the corner '-5'", "count back"),
        ("f 1/1 2/1 3/1", "texture coordinate 1", "0 texture coordinates"),
        ("f 1//2 2//1 3//1", "normal 2", "0 normals"),
        ("f 1//6// 2 3", "the corner '1//6//'", "1//3"),
        ("f a b c", "the corner 'a'", "1/2/3"),
        ("f 99999999999999999999 1 2", "the corner", "1/2/3"),
        ("vertex 1 2 3", "the statement 'vertex'", "usemtl"),
    ];
    for (line, found, allowed) in cases {
        let message = read(&format!("{SQUARE}{line}\nf 1 2 3\n")).unwrap_err().to_string();
        for part in ["cat.obj, line 5", found, allowed, "; "] {
            assert!(message.contains(part), "{line}: {message}");
        }
    }
    let message = read(&format!("{SQUARE}l 1 2 3\n")).unwrap_err().to_string();
    assert!(message.contains("4 positions and lines that begin with l"), "{message}");
    let big = format!("{SQUARE}f{}", " 1".repeat(5000));
    assert!(read(&big).unwrap_err().to_string().contains("a face of 5000 corners"));
}

proptest! {
    #[test]
    fn lines_with_errors_give_a_whole_model_or_an_error(
        lines in prop::collection::vec("(v|vt|vn|f|g|o|usemtl|l|#|)( (-?[0-9]{1,2}|[0-9]/[0-9]|-?[0-9]//-[0-9]|[0-9]/[0-9]/[0-9]/|nan|inf|1e999|x|\\\\)){0,6}", 0..30),
    ) {
        let text = format!("{SQUARE}vt 0 0\nvn 0 0 1\nf 1 2 3\n{}", lines.join("\n"));
        if let Ok(model) = read(&text) {
            prop_assert!(is_whole(&model));
            prop_assert!(model.mesh(&[]).is_ok_and(|mesh| mesh.faces.len() == model.faces.len()));
            let split = (0..model.parts.len()).map(|part| model.split(part).mesh.faces.len());
            prop_assert_eq!(split.sum::<usize>(), model.faces.len());
            let [low, high] = model.bounds();
            prop_assert!((0..3).all(|axis| low[axis] <= high[axis]));
        }
    }
}
