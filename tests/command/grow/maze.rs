//! Mazes: straight pieces of the drawn directions, as wide and as far apart as the drawn lines, that do not cross.

use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// A line around `center` with this length, direction (degrees) and width.
fn line([x, y]: [f64; 2], long: f64, angle: f64, width: f64) -> Value {
    let (s, c) = angle.to_radians().sin_cos();
    let [dx, dy] = [0.5 * long * c, 0.5 * long * s];
    json!({"kind": "line", "from": [x - dx, y - dy], "to": [x + dx, y + dy], "width": width})
}

fn maze(size: [u32; 2], edges: &str, strokes: &[Value]) -> Value {
    json!({"format": "dapple", "version": 2, "size": size, "edges": edges,
        "layers": [{"system": "maze", "strokes": strokes}]})
}

/// Two lines side by side of each direction; each pair has its own place.
fn pairs_of(angles: &[f64], long: f64, width: f64, apart: f64) -> Vec<Value> {
    let lines = |(index, angle): (usize, &f64)| {
        let (s, c) = angle.to_radians().sin_cos();
        let [x, y] = [90.0 + 120.0 * (index % 2) as f64, 90.0 + 110.0 * (index / 2) as f64];
        [0.0, 1.0].map(|side| line([x - side * apart * s, y + side * apart * c], long, *angle, width))
    };
    angles.iter().enumerate().flat_map(lines).collect()
}

/// The share of the edges in part of a picture that run within 15° of one of these directions.
fn along(folder: &Folder, name: &str, angles: &[f64], inside: impl Fn([usize; 2]) -> bool) -> f64 {
    let ([width, height], values) = folder.gray16(name);
    let at = |x: usize, y: usize| f64::from(values[y % height * width + x % width]);
    let (mut all, mut own) = (0.0, 0.0);
    for (x, y) in
        (1..height - 1).flat_map(|y| (1..width - 1).map(move |x| (x, y))).filter(|(x, y)| inside([*x, *y]))
    {
        let [gx, gy] = [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)];
        let direction = gx.atan2(-gy).to_degrees();
        let off = |angle: &f64| ((direction - angle + 90.0).rem_euclid(180.0) - 90.0).abs();
        let weight = gx.hypot(gy);
        all += weight;
        own += if angles.iter().any(|angle| off(angle) < 15.0) { weight } else { 0.0 };
    }
    own / all
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

#[test]
fn pieces_of_a_maze_have_the_drawn_directions_and_widths() {
    for (angles, long, width, apart, edges) in [
        (&[0.0, 90.0][..], 80.0, 8.0, 18.0, "wrap"),
        (&[20.0, 75.0], 60.0, 5.0, 12.0, "closed"),
        (&[0.0, 60.0, 120.0], 70.0, 7.0, 13.0, "wrap"),
    ] {
        let folder = Folder::with(&maze([320, 320], edges, &pairs_of(angles, long, width, apart)));
        folder.grow("--report r.json --pattern p.png");
        let layer = &folder.json("r.json")["layers"][0];
        assert_eq!(layer["system"], "maze");
        let threads = layer["threads"].as_array().expect("threads");
        assert_eq!(threads.len(), angles.len());
        for threads in threads {
            let error = |key: &str| number(&threads["error"], key).abs();
            assert!(error("width") < 0.1 && error("wavelength") < 0.1, "{threads}");
            assert!(error("angle") < 4.0, "{threads}");
            assert!((number(&threads["asked"], "width") - width).abs() < 1e-6, "{threads}");
        }
        let share = along(&folder, "p.png", angles, |_| true);
        assert!(share > 0.8, "{share} of {angles:?}");
        // Every direction has its share.
        for angle in angles {
            let own = along(&folder, "p.png", &[*angle], |_| true);
            assert!(own > 0.5 * share / angles.len() as f64, "{own} of {angle} of {share}");
        }
        for mark in layer["drawn"].as_array().expect("marks") {
            assert!(mark["there"] == true, "{mark}");
        }
    }
}

/// For lines of two directions with this width and distance, px: the notes of `check` and of the report of a growth,
/// and the mean width that grew.
fn told(width: f64, apart: f64) -> ([String; 2], f64) {
    let folder = Folder::with(&maze([320, 320], "wrap", &pairs_of(&[0.0, 90.0], 80.0, width, apart)));
    let checked = folder.dapple("check a.dapple --json").output().unwrap().stdout;
    let checked: Value = serde_json::from_slice(&checked).unwrap();
    folder.grow("--report r.json");
    let grown = &folder.json("r.json")["layers"][0];
    let widths = grown["threads"].as_array().expect("threads").iter().map(|of| number(&of["got"], "width"));
    ([&checked["layers"][0], grown].map(|of| of["notes"].to_string()), 0.5 * widths.sum::<f64>())
}

#[test]
fn lines_too_thin_for_a_maze_are_noted_with_the_width_that_grows() {
    let (notes, got) = told(5.0, 25.0);
    assert!((got - 8.0).abs() < 0.5, "{got}");
    for said in notes {
        assert!(
            said.contains("5.0 px wide and 25.0 px apart") && said.contains("they grow 8.0 px wide"),
            "{said}"
        );
    }
    let (notes, got) = told(7.0, 14.0);
    assert!((got - 7.0).abs() < 0.3 && notes.iter().all(|notes| !notes.contains("wide")), "{got} {notes:?}");
    let (notes, _) = told(9.0, 12.0);
    let said = "lines are 12 px apart, and stripes of their width can be at least 18 px apart";
    assert!(notes.iter().all(|notes| notes.contains(said)), "{notes:?}");
}

#[test]
fn regions_of_a_maze_have_the_directions_of_their_lines() {
    let place = |k: usize| [60.0 + 120.0 * (k % 3) as f64, 60.0 + 120.0 * (k / 3) as f64];
    let angle = |k: usize| if k.is_multiple_of(2) { 0.0 } else { 90.0 };
    let strokes: Vec<Value> = (0..9).map(|k| line(place(k), 80.0, angle(k), 8.0)).collect();
    let mut document = maze([360, 360], "closed", &strokes);
    document["regions"] = json!([3, 3]);
    let folder = Folder::with(&document);
    folder.grow("--pattern p.png");
    for k in 0..9 {
        let own = |[x, y]: [usize; 2]| (x / 120, y / 120) == (k % 3, k / 3);
        let share = along(&folder, "p.png", &[angle(k)], own);
        assert!(share > 0.75, "{share} of region {k}");
    }
}

#[test]
fn the_number_of_threads_of_the_computer_changes_no_byte_of_a_maze() {
    let folder = Folder::with(&maze([240, 200], "wrap", &pairs_of(&[0.0, 70.0], 50.0, 6.0, 13.0)));
    let grown = [1, 3].map(|threads| {
        folder.grow(&format!("--threads {threads}"));
        folder.bytes("a.png")
    });
    assert!(grown[0] == grown[1]);
}

#[test]
fn impossible_mazes_are_refused_with_the_reason() {
    let one = maze(
        [200, 200],
        "wrap",
        &[line([60.0, 60.0], 40.0, 10.0, 5.0), line([120.0, 60.0], 40.0, 20.0, 5.0)],
    );
    Folder::with(&one).refuses(
        "check a.dapple",
        1,
        &["layers[0].strokes", "lines of one direction", "for a maze"],
    );
    let mut spots = one;
    spots["layers"][0]["strokes"] = json!([{"kind": "ellipse", "center": [60, 60], "radii": [9, 7]}]);
    Folder::with(&spots).refuses("check a.dapple", 1, &["layers[0].system", "stripes", "ellipses"]);
}
