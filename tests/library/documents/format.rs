//! Checks that the tables of `docs/format.md` describe the program.

use super::*;
use dapple::SaveTexture;
use dapple::document::layer_rules::RULES;
use dapple::document::systems::TURING_GROWTH;
use dapple::document::{AreaKind, LineKind, PairKind, Points, Tone, ToneImage};
use dapple_engine::synth::Grown;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Output;

fn page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/format.md");
    fs::read_to_string(path).expect("docs/format.md can be read")
}

/// The rows of the first table with these columns after a heading, without backticks around cells.
fn table(heading: &str, columns: &str) -> Vec<Vec<String>> {
    let page = page();
    let (_, after) =
        page.split_once(&format!("# {heading}\n")).unwrap_or_else(|| panic!("no heading {heading}"));
    let (_, rows) =
        after.split_once(&format!("| {columns} |\n|")).unwrap_or_else(|| panic!("{heading}: no {columns}"));
    let cells = |row: &str| {
        let cells = row.trim_matches('|').split(" | ").map(str::trim);
        cells
            .map(|cell| cell.strip_prefix('`').and_then(|c| c.strip_suffix('`')).unwrap_or(cell).to_owned())
            .collect()
    };
    rows.lines().skip(1).take_while(|row| row.starts_with('|')).map(cells).collect()
}

fn first_column(heading: &str) -> Vec<String> {
    table(heading, "key | meaning").into_iter().map(|row| row[0].clone()).collect()
}

/// The shortest document with a `tone`.
fn driven() -> Value {
    let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
    with("/layers/0/tone", json!({"image": {"png": image.base64()}}))
}

/// The shortest document of a field of these points.
fn pointed(points: &Value) -> Value {
    let mut document = with("/layers/0/points", points.clone());
    document["layers"][0]["system"] = json!("points");
    document["layers"][0]["strokes"] = json!([]);
    document
}

#[test]
fn the_labels_on_the_page_are_those_that_the_program_reads() {
    let rows = table("Labels", "kind | key | meaning | allowed | default");
    assert_eq!(rows.len(), 11);
    let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
    for row in rows {
        let [kind, key, _, allowed, default] = &row[..] else { panic!("five cells: {row:?}") };
        let mut least = json!({"kind": kind});
        if kind == "image" {
            least["image"] = json!({"png": image.base64()});
        }
        let mut wrong = least.clone();
        wrong[key.as_str()] = json!(null);
        let message = error_of_text(&pointed(&json!({"labels": wrong})).to_string());
        assert!(message.ends_with(&format!("found null; allowed: {allowed}")), "{row:?}: {message}");
        let mut with = least.clone();
        if default == "required" {
            with.as_object_mut().unwrap().remove(key);
            let message = error_of_text(&pointed(&json!({"labels": with})).to_string());
            assert!(message.contains(&format!("no key \"{key}\"")), "{message}");
            continue;
        }
        with[key.as_str()] = serde_json::from_str(default).unwrap();
        let [with, without] = [with, least].map(|labels| accepted(&pointed(&json!({"labels": labels}))));
        assert_eq!(with, without, "{row:?}");
    }
}

/// The shortest document with `maps` of both kinds.
fn varied() -> Value {
    let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
    let noise = json!({"noise": {"size": 40, "range": [0.5, 2]}});
    let maps = json!({"area": {"image": {"png": image.base64()}, "range": [80, 300]}, "spacing": noise});
    with("/layers/0/maps", maps)
}

/// The shortest document on a model with a pin and a mark.
fn on_model() -> Value {
    let mut document = with("/model", json!({"file": "egg", "pins": [{"at": [0, 1, 0]}]}));
    let mark = json!({"kind": "ellipse", "at": [0, 1, 0], "normal": [0, 1, 0], "radii": [12, 6]});
    document["layers"][0]["strokes"].as_array_mut().expect("strokes").push(mark);
    document
}

/// The shortest document of rosettes.
fn rosettes() -> Value {
    let mut document = with("/layers/0/options", json!({"rosette": {}}));
    document["layers"][0]["system"] = json!("patches");
    document
}

/// Each object of a document: its heading, its place, and a document that holds it with only the required keys.
fn objects() -> [(&'static str, &'static str, Value); 24] {
    let line = json!({"kind": "line", "from": [10, 10], "to": [90, 60]});
    let path = json!({"kind": "path", "points": [[10, 10], [40, 20], [80, 14]]});
    let freehand = json!({"kind": "freehand", "points": [[10, 10], [40, 12], [80, 14]]});
    let ellipse = json!({"kind": "ellipse", "center": [64, 64], "radii": [12, 6]});
    let outline = json!({"kind": "outline", "points": [[10, 10], [40, 12], [80, 50]]});
    let colours = with("/layers/0/colours", json!({"stops": [{"at": 0, "colour": "#000"}]}));
    [
        ("Document", "", least()),
        ("Model", "/model", on_model()),
        ("Height field", "/model", with("/model", json!({"height": "hills.png", "scale": 80}))),
        ("Pin", "/model/pins/0", on_model()),
        ("Ellipse on the model", "/layers/0/strokes/1", on_model()),
        ("Growth", "/growth", with("/growth", json!({}))),
        ("Finish", "/finish", with("/finish", json!({"kind": "fur"}))),
        ("Layer", "/layers/0", least()),
        ("Ellipse", "/layers/0/strokes/0", with_stroke(&ellipse)),
        ("Line", "/layers/0/strokes/0", with_stroke(&line)),
        ("Path", "/layers/0/strokes/0", with_stroke(&path)),
        ("Freehand", "/layers/0/strokes/0", with_stroke(&freehand)),
        ("Outline", "/layers/0/strokes/0", with_stroke(&outline)),
        ("Options", "/layers/0/options", with("/layers/0/options", json!({}))),
        ("Tone", "/layers/0/tone", driven()),
        ("Tone image", "/layers/0/tone/image", driven()),
        ("Points", "/layers/0/points", pointed(&json!({}))),
        ("Maps", "/layers/0/maps", varied()),
        ("Map", "/layers/0/maps/area", varied()),
        ("Map noise", "/layers/0/maps/spacing/noise", varied()),
        ("Spread", "/layers/0/options/spread", with("/layers/0/options", json!({"spread": {}}))),
        ("Rosette", "/layers/0/options/rosette", rosettes()),
        ("Colours", "/layers/0/colours", colours.clone()),
        ("Stop", "/layers/0/colours/stops/0", colours),
    ]
}

#[test]
fn the_keys_on_the_page_are_those_that_the_program_reads() {
    for (heading, pointer, document) in objects() {
        let mut wrong = document.clone();
        wrong.pointer_mut(pointer).unwrap()["zzzzzzzzzzzz"] = json!(1);
        let keys = table(heading, "key | meaning | allowed | default").into_iter().map(|row| row[0].clone());
        let listed = keys.collect::<Vec<_>>().join(", ");
        let message = error_of_text(&wrong.to_string());
        assert!(message.ends_with(&format!("\"zzzzzzzzzzzz\"; allowed: {listed}")), "{heading}: {message}");
    }
}

#[test]
fn the_values_on_the_page_are_those_that_are_allowed() {
    for (heading, pointer, document) in objects() {
        for row in table(heading, "key | meaning | allowed | default") {
            let mut wrong = document.clone();
            wrong.pointer_mut(pointer).unwrap()[row[0].as_str()] = json!(null);
            let message = error_of_text(&wrong.to_string());
            assert!(
                message.ends_with(&format!("found null; allowed: {}", row[2])),
                "{heading}: {row:?}: {message}"
            );
        }
    }
}

#[test]
fn the_defaults_on_the_page_are_those_of_the_program() {
    for (heading, pointer, document) in objects() {
        for row in table(heading, "key | meaning | allowed | default") {
            let (key, default) = (row[0].as_str(), row[3].as_str());
            let mut without = document.clone();
            without.pointer_mut(pointer).unwrap().as_object_mut().unwrap().remove(key);
            if default == "required" {
                let message = error_of_text(&without.to_string());
                assert!(message.contains(&format!("no key \"{key}\"")), "{heading}: {message}");
                continue;
            }
            let expected = accepted(&without);
            if default == "none" {
                continue;
            }
            let mut with = without;
            let value: Value = serde_json::from_str(default).unwrap_or_else(|error| panic!("{key}: {error}"));
            with.pointer_mut(pointer).unwrap()[key] = value;
            assert_eq!(accepted(&with), expected, "{heading}: {key}");
        }
    }
}

/// A meaning as the schema has it: without addresses, and without links to pages in brackets.
fn without_links(meaning: &str) -> String {
    let mut text = meaning.to_owned();
    while let Some((before, rest)) = text.split_once('[').filter(|(_, rest)| rest.contains("](")) {
        let (name, rest) = rest.split_once("](").expect("a link");
        let (_, after) = rest.split_once(')').expect("the end of a link");
        text = match (before.strip_suffix(" ("), after.strip_prefix(')')) {
            (Some(before), Some(after)) => format!("{before}{after}"),
            _ => format!("{before}{name}{after}"),
        };
    }
    text
}

#[test]
fn the_meanings_and_defaults_on_the_page_are_those_of_the_schema() {
    let schema: Value = serde_json::from_str(&dapple::document::schema()).unwrap();
    let check = |object: &str, key: &str, meaning: &str, default: &str| {
        let of = if object == "Document" { &schema } else { &schema["$defs"][object] };
        let property = &of["properties"][key];
        assert_eq!(property["description"], without_links(meaning), "{object}: {key}");
        let is_required = of["required"].as_array().expect("a list").contains(&json!(key));
        assert_eq!(is_required, default == "required", "{object}: {key}");
        if !["required", "none"].contains(&default) {
            assert_eq!(
                property["default"],
                serde_json::from_str::<Value>(default).unwrap(),
                "{object}: {key}"
            );
        }
    };
    for (heading, ..) in objects() {
        for row in table(heading, "key | meaning | allowed | default") {
            check(heading, &row[0], &row[1], &row[3]);
        }
    }
    for row in table("Labels", "kind | key | meaning | allowed | default") {
        check(&format!("Labels {}", row[0]), &row[1], &row[2], &row[4]);
    }
}

#[test]
fn the_rules_on_the_page_are_those_of_the_program() {
    let row = |rule: &dapple::document::layer_rules::Rule| {
        let checked = if rule.on_reading { "reading" } else { "growing" };
        format!("| {} | {} | {checked} | {} |\n", rule.key, rule.condition, rule.reason)
    };
    let rows: String = RULES.iter().map(row).collect();
    assert!(page().contains(&format!("|---|---|---|---|\n{rows}\n")), "docs/format.md should hold:\n{rows}");
}

fn dapple(arguments: &[&str], folder: &Path) -> Output {
    let mut dapple = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    dapple.args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn the_commands_and_exit_codes_on_the_page_are_those_of_the_program() {
    let folder = tempfile::tempdir().unwrap();
    let help = String::from_utf8(dapple(&["--help"], folder.path()).stdout).unwrap();
    let (_, listed) = help.split_once("Commands:\n").unwrap();
    let listed = listed.lines().take_while(|line| !line.is_empty());
    let names =
        listed.filter_map(|line| line.strip_prefix("  ")?.split(' ').next().filter(|name| !name.is_empty()));
    let names: BTreeSet<String> = names.filter(|name| *name != "help").map(str::to_owned).collect();
    let page: BTreeSet<String> =
        table("Commands", "command | does").into_iter().map(|row| row[0].clone()).collect();
    assert_eq!(page, names);

    fs::write(folder.path().join("a.dapple"), least().to_string()).unwrap();
    let code = |arguments: &[&str]| dapple(arguments, folder.path()).status.code().unwrap().to_string();
    let codes = table("Commands", "exit code | meaning").into_iter().map(|row| row[0].clone());
    assert_eq!(codes.collect::<Vec<_>>(), ["0", "1", "2", "130"]);
    assert_eq!(
        [code(&["check", "a.dapple"]), code(&["check", "b.dapple"]), code(&["check"])],
        ["0", "1", "2"]
    );
}

/// A small document of spots that vary, one of them drawn nearly on another, with small ones inside them.
fn spots() -> Document {
    let spots = (0..6).map(|i| {
        let (column, row) = (f64::from(i % 3), f64::from(i / 3));
        Stroke::ellipse([30.0 + 34.0 * column, 40.0 + 34.0 * row], [9.0 + 0.4 * f64::from(i), 8.0], 0.0)
    });
    let spots = spots.chain([Stroke::ellipse([68.0, 43.0], [9.0, 8.0], 0.0)]);
    let inside = Layer::new([Stroke::ellipse([30.0, 40.0], [4.0, 4.0], 0.0)]).with_after(After::Inside);
    Document::new([140, 120]).with_layer(Layer::new(spots)).with_layer(inside)
}

fn stripes() -> Document {
    let lines = [20.0, 40.0].map(|y| Stroke::line([20.0, y], [100.0, y + 10.0], 9.0));
    Document::new([140, 120]).with_layer(Layer::new(lines))
}

/// A document of lines that cross, so wide that their threads cannot be as close together as they were drawn.
fn weave() -> Document {
    let [across, down] = [[20.0, 34.0, 48.0], [30.0, 44.0, 58.0]];
    let across = across.map(|y| Stroke::line([10.0, y], [130.0, y], 9.0));
    let down = down.map(|x| Stroke::line([x, 10.0], [x, 110.0], 9.0));
    let layer = Layer::new(across.into_iter().chain(down))
        .with_system(SystemChoice::Of(PairKind::Weave.description()));
    Document::new([140, 120]).with_layer(layer)
}

fn cells() -> Document {
    let layer = Layer::new([Stroke::ellipse([70.0, 60.0], [12.0, 9.0], 20.0)])
        .with_system(SystemChoice::Of(AreaKind::Polygons.description()));
    Document::new([140, 120]).with_layer(layer)
}

fn stucco() -> Document {
    let mark = Stroke::ellipse([70.0, 60.0], [12.0, 5.0], 20.0);
    let layer = Layer::new([mark]).with_system(SystemChoice::Of(PairKind::Stucco.description()));
    Document::new([140, 120]).with_layer(layer)
}

fn streaks() -> Document {
    let lines = [20.0, 40.0].map(|y| Stroke::line([20.0, y], [100.0, y + 10.0], 8.0));
    let layer = Layer::new(lines).with_system(SystemChoice::Of(LineKind::Streaks.description()));
    Document::new([140, 120]).with_layer(layer)
}

/// The keys of a report: those of its layers, and those of their regions after a dot.
fn keys(value: &Value, before: &str, keys: &mut BTreeSet<String>) {
    for (key, value) in value.as_object().into_iter().flatten() {
        let path = format!("{before}{key}");
        for item in value.as_array().into_iter().flatten() {
            self::keys(item, &format!("{path}."), keys);
        }
        keys.insert(path);
    }
}

#[test]
fn the_keys_of_a_report_on_the_page_are_those_that_are_written() {
    let mut written = BTreeSet::from(["outlines".to_owned()]);
    let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
    let layer = Layer { tone: Some(Tone::new(image)), ..Layer::default() };
    let driven = Document::new([140, 120]).with_layer(layer);
    let layer = Layer::default().with_points(Points::default());
    let field = Document::new([140, 120]).with_layer(layer);
    let layer = Layer { system: SystemChoice::Of(TURING_GROWTH), ..Layer::default() };
    let growth = Document::new([140, 120]).with_layer(layer);
    for document in [spots(), stripes(), weave(), cells(), streaks(), stucco(), driven, field, growth] {
        let grown: Grown = document.grow().unwrap();
        keys(&serde_json::to_value(grown.report()).unwrap(), "", &mut written);
    }
    assert_eq!(first_column("Report").into_iter().collect::<BTreeSet<_>>(), written);
}

fn object_keys(value: &Value) -> Vec<String> {
    value.as_object().unwrap().keys().cloned().collect()
}

fn printed(arguments: &[&str], folder: &Path) -> Value {
    let output = dapple(arguments, folder);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn what_commands_print_as_json_has_the_keys_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("a.dapple"), with("/regions", json!([1, 1])).to_string()).unwrap();
    let lookup = "lookup --system meinhardt-spots --area 300 --aspect 0.5 --angle 30 --spacing 60 --json";
    let lookup = printed(&lookup.split(' ').collect::<Vec<_>>(), at);
    assert_eq!(object_keys(&lookup), first_column("Lookup"));
    assert_eq!(object_keys(&printed(&["check", "a.dapple", "--json"], at)), first_column("Check"));
    let kinds = table("Measure", "kind | keys");
    for (row, document) in kinds.iter().zip([spots(), stripes()]) {
        let layer = document.layers[0].clone();
        Document { layers: vec![layer], ..document }.grow().unwrap().save(at.join("a.png")).unwrap();
        let measured = printed(&["measure", "a.png", "--json"], at);
        assert_eq!(measured["kind"], row[0].as_str());
        let listed: Vec<String> = row[1].split(", ").map(|key| key.trim_matches('`').to_owned()).collect();
        assert_eq!(object_keys(&measured), listed);
    }
}

/// The words in backticks in a cell of the page.
fn keys_in(cell: &str) -> BTreeSet<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// The row of this key in the table under a heading.
fn meaning(heading: &str, key: &str) -> String {
    let row = table(heading, "key | meaning").into_iter().find(|row| row[0] == key);
    row.unwrap_or_else(|| panic!("{heading}: no {key}"))[1].clone()
}

#[test]
fn the_json_of_import_has_the_keys_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="96" height="96"><rect width="96" height="96" fill="tan"/><circle cx="40" cy="40" r="9"/></svg>"#;
    fs::write(folder.path().join("in.svg"), svg).unwrap();
    let imported = printed(&["import", "in.svg", "-o", "a.dapple", "--json"], folder.path());
    assert_eq!(object_keys(&imported), first_column("Import"));
    assert_eq!(
        object_keys(&imported["layers"][0]).into_iter().collect::<BTreeSet<_>>(),
        keys_in(&meaning("Import", "layers"))
    );
}

#[test]
fn the_json_of_an_imported_photograph_has_the_keys_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let dots = image::GrayImage::from_fn(240, 160, |x, y| {
        let near = |px: u32| (f64::from(px) + 0.5).rem_euclid(40.0) - 20.0;
        image::Luma([if near(x).hypot(near(y)) < 9.0 { 30 } else { 220 }])
    });
    dots.save(folder.path().join("a.png")).unwrap();
    let imported = printed(&["import", "a.png", "-o", "a.dapple", "--json"], folder.path());
    // Four spots are too few, and are taken anyway.
    image::imageops::crop_imm(&dots, 0, 0, 80, 80).to_image().save(folder.path().join("b.png")).unwrap();
    let taken = ["import", "b.png", "-o", "b.dapple", "--json", "--take-it", "--regions", "1x1"];
    let taken = printed(&taken, folder.path());
    let written = object_keys(&imported).into_iter().chain(object_keys(&taken));
    let on_the_page = first_column("Import of a photograph");
    assert_eq!(on_the_page.into_iter().collect::<BTreeSet<_>>(), written.collect::<BTreeSet<_>>());
    assert_eq!(
        object_keys(&imported["layers"][0]).into_iter().collect::<BTreeSet<_>>(),
        keys_in(&meaning("Import of a photograph", "layers"))
    );
}

#[test]
fn the_json_of_bench_has_the_keys_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let bench = |only: &[&str]| {
        let arguments = ["bench", "--quick", "--json", "--size", "64", "--threads", "1", "--only"];
        printed(&[&arguments, only].concat(), folder.path())
    };
    let kernels = bench(&["turing-spots/isotropic"]);
    assert_eq!(object_keys(&kernels), first_column("Bench"));
    let pictures = bench(&["picture/ladybird"]);
    let phases = bench(&["picture/zebra", "--phases"]);
    for (key, value) in [
        ("machine", &kernels["machine"]),
        ("load", &kernels["load"]),
        ("kernels", &kernels["kernels"][0]),
        ("pictures", &pictures["pictures"][0]),
        ("phases", &phases["phases"][0]),
    ] {
        let written: BTreeSet<String> = object_keys(value).into_iter().collect();
        assert_eq!(keys_in(&meaning("Bench", key)), written, "{key}");
    }
}

#[test]
fn the_json_of_learn_has_the_keys_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["learn", "--targets", "1", "--seed", "3", "--system", "turing-spots", "--json"];
    let learnt = printed(&arguments, folder.path());
    assert_eq!(object_keys(&learnt), ["outcomes"]);
    let (mut keys, mut quantities) = (BTreeSet::new(), BTreeSet::new());
    for outcome in learnt["outcomes"].as_array().unwrap() {
        keys.extend(object_keys(outcome));
        quantities.extend(outcome["quantities"].as_object().unwrap().values().flat_map(object_keys));
    }
    assert_eq!(first_column("Learn").into_iter().collect::<BTreeSet<_>>(), keys);
    let mut listed = keys_in(&meaning("Learn", "quantities"));
    assert!(listed.remove("ok") && listed.remove("MISSED"));
    assert_eq!(listed, quantities);
}

#[test]
fn the_columns_of_a_table_of_questions_and_answers_are_those_on_the_page() {
    let columns =
        |row: &[String]| row[1].split(", ").map(|name| name.trim_matches('`').to_owned()).collect::<Vec<_>>();
    let tables = table("Lookup", "table | columns");
    let [questions, answers] = [0, 1].map(|i| columns(&tables[i]));
    let folder = tempfile::tempdir().unwrap();
    let row = questions.iter().map(|column| match column.as_str() {
        "system" => "turing-spots",
        "area" => "200",
        "aspect" => "0.6",
        "angle" => "5",
        _ => "",
    });
    let table = format!("{}\n{}\n", questions.join(","), row.collect::<Vec<_>>().join(","));
    fs::write(folder.path().join("q.csv"), table).unwrap();
    let output = dapple(&["lookup", "--batch", "q.csv", "-o", "a.csv"], folder.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let answered = fs::read_to_string(folder.path().join("a.csv")).unwrap();
    let all = [questions, answers].concat().join(",");
    assert_eq!(answered.lines().next(), Some(all.as_str()));
}
