//! Streaks and cracks: they have the drawn width and share, and streaks the drawn direction.

use serde_json::{Value, json};

use crate::grow::folder::Folder;

/// Two lines of this `width` side by side, `apart` px from middle to middle, at this direction.
fn document(system: &str, edges: &str, [width, apart, angle]: [f64; 3]) -> Value {
    let (s, c) = angle.to_radians().sin_cos();
    let line = |side: f64| {
        let middle = [200.0 - side * s, 180.0 + side * c];
        let end = |way: f64| [middle[0] + way * c, middle[1] + way * s];
        json!({"kind": "line", "from": end(-80.0), "to": end(80.0), "width": width})
    };
    json!({"format": "dapple", "version": 2, "size": [400, 360], "edges": edges,
        "layers": [{"system": system, "strokes": [line(-0.5 * apart), line(0.5 * apart)]}]})
}

fn layer(folder: &Folder, more: &str) -> Value {
    folder.grow(&format!("--report r.json {more}"));
    folder.json("r.json")["layers"][0].clone()
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

/// The share of white px in a picture of labels that shows one layer.
fn share_of(folder: &Folder, name: &str) -> f64 {
    let ([width, height], labels) = folder.gray8(name);
    labels.iter().filter(|label| **label > 0).count() as f64 / (width * height) as f64
}

#[test]
fn streaks_have_the_drawn_width_share_and_direction() {
    for (edges, drawn) in
        [("closed", [9.0, 22.0, 30.0]), ("wrap", [8.0, 26.0, 110.0]), ("wrap", [12.0, 24.0, 0.0])]
    {
        let folder = Folder::with(&document("streaks", edges, drawn));
        let found = layer(&folder, "--labels labels.png");
        assert_eq!(found["system"], "streaks");
        let [width, apart, angle] = drawn;
        let region = &found["regions"][0];
        assert!((number(&region["asked"], "width") - width).abs() < 0.2 && found["drawn"].is_null());
        let error = |key: &str| number(&region["error"], key).abs();
        assert!(error("width") < 0.05, "{drawn:?}: {region}");
        assert!(error("angle") < 8.0 && error("angle_rms") < 40.0, "{drawn:?}: {region}");
        let turn = (number(&region["got"], "angle") - angle + 90.0).rem_euclid(180.0) - 90.0;
        assert!(turn.abs() < 8.0, "{drawn:?}: {region}");
        let share = &found["share"];
        assert!((number(share, "asked") - width / apart).abs() < 0.02, "{drawn:?}: {share}");
        assert!((number(share, "got") - number(share, "asked")).abs() < 0.005, "{drawn:?}: {share}");
        assert!((share_of(&folder, "labels.png") - number(share, "got")).abs() < 0.01, "{drawn:?}: {share}");
    }
}

#[test]
fn cracks_have_the_drawn_width_and_a_share_that_follows_from_the_distance_of_the_lines() {
    for (edges, drawn) in [("closed", [6.0, 40.0, 30.0]), ("wrap", [5.0, 45.0, 80.0])] {
        let folder = Folder::with(&document("cracks", edges, drawn));
        let found = layer(&folder, "");
        let region = &found["regions"][0];
        assert!(number(&region["error"], "width").abs() < 0.05, "{drawn:?}: {region}");
        assert!(region["asked"]["angle"].is_null() && region["error"]["angle"].is_null(), "{region}");
        let (duty, share) = (drawn[0] / drawn[1], &found["share"]);
        assert!((number(share, "asked") - duty * (2.0 - duty)).abs() < 0.01, "{drawn:?}: {share}");
        assert!((number(share, "got") - number(share, "asked")).abs() < 0.005, "{drawn:?}: {share}");
    }
}

/// The texts of the notes of `check` on the only layer of `a.dapple`, and of its report in `r.json`.
fn notes(folder: &Folder) -> [String; 2] {
    let checked = folder.dapple("check a.dapple --json").output().unwrap().stdout;
    let checked: Value = serde_json::from_slice(&checked).unwrap();
    [checked["layers"][0]["notes"].to_string(), folder.json("r.json")["layers"][0].to_string()]
}

#[test]
fn streaks_of_an_impossible_duty_cover_as_much_as_possible_and_a_note_says_so() {
    for (duty, share) in [(0.82, 0.6), (0.18, 0.2)] {
        let mut document = document("streaks", "closed", [9.0, 22.0, 30.0]);
        document["layers"][0]["options"] = json!({"duty": duty});
        let folder = Folder::with(&document);
        let found = &layer(&folder, "")["share"];
        assert!((number(found, "asked") - share).abs() < 1e-6, "{found}");
        assert!((number(found, "got") - share).abs() < 0.005, "{found}");
        let said = format!("streaks cover 20 % to 60 % of the canvas, not {:.0} %", 100.0 * duty);
        assert!(notes(&folder).iter().all(|notes| notes.contains(&said)), "{:?}", notes(&folder));
    }
}

#[test]
fn lines_too_close_together_for_streaks_and_cracks_are_noted() {
    for system in ["streaks", "cracks"] {
        let folder = Folder::with(&document(system, "closed", [9.0, 12.0, 30.0]));
        layer(&folder, "");
        let said = "lines are 12 px apart, and stripes of their width can be at least 18 px apart";
        assert!(notes(&folder).iter().all(|notes| notes.contains(said)), "{:?}", notes(&folder));
    }
}

#[test]
fn streaks_leave_room_around_the_layer_beneath_and_grow_the_same_bytes_again() {
    let mut document = document("streaks", "closed", [8.0, 20.0, 60.0]);
    let disc = json!({"kind": "ellipse", "center": [200, 180], "radii": [60, 40], "angle": 0});
    let beneath = json!({"system": "patches", "strokes": [disc]});
    let above = document["layers"][0].clone();
    document["layers"] = json!([beneath, above]);
    let folder = Folder::with(&document);
    folder.grow("--labels one.png --report r.json --threads 1");
    let (_, labels) = folder.gray8("one.png");
    let count = |label: u8| labels.iter().filter(|of_px| **of_px == label).count();
    assert!(count(1) > 5_000 && count(2) > 5_000, "{} {}", count(1), count(2));
    let share = &folder.json("r.json")["layers"][1]["share"];
    assert!((number(share, "got") - number(share, "asked")).abs() < 0.01, "{share}");
    folder.grow("--labels two.png --threads 2");
    assert_eq!(folder.bytes("one.png"), folder.bytes("two.png"));
}

#[test]
fn streaks_and_cracks_only_take_lines_and_streaks_take_a_number_of_points() {
    let disc = json!({"kind": "ellipse", "center": [50, 50], "radii": [9, 9], "angle": 0});
    for (system, strokes, options, names) in [
        ("cracks", json!([disc]), json!({}), ["layers[0].system", "This system grows stripes"]),
        (
            "cracks",
            document("cracks", "closed", [5.0, 30.0, 0.0])["layers"][0]["strokes"].clone(),
            json!({"detail": 30}),
            ["layers[0].options.detail", "Only patches and streaks"],
        ),
    ] {
        let document = json!({"format": "dapple", "version": 2, "size": [400, 360],
            "layers": [{"system": system, "strokes": strokes, "options": options}]});
        Folder::with(&document).refuses("grow a.dapple -o a.png", 1, &names);
    }
}
