//! Every option of every command that takes a number takes any number: it is used, or refused with a message.

use std::time::Duration;

use assert_cmd::Command;
use serde_json::json;

use crate::grow::folder::{Folder, document};
use crate::some;

/// Numbers at the ends of the usual range, and beyond it.
const NUMBERS: [&str; 15] = [
    "0",
    "-0",
    "1",
    "0.5",
    "-1",
    "1e-6",
    "1e-30",
    "5e-324",
    "1e12",
    "1e30",
    "-1.7976931348623157e308",
    "4294967296",
    "18446744073709551615",
    "nan",
    "-inf",
];

/// Short uses of all commands; of `lookup` one for each kind of answer.
const USES: [&str; 20] = [
    "grow spots.dapple -o a.png",
    "grow lines.dapple -o a.jpg --svg a.svg --dxf a.dxf --pattern p.png --material m --style stroke",
    "film spots.dapple -o f.gif --seconds 0.2 --fps 10 --side 16",
    "sheet spots.dapple -o s.png --thumb 32 --lit=2",
    "import in.svg -o i.dapple",
    "import spots.png -o i.dapple --take-it",
    "learn --system meinhardt-lines --no-simulation --targets 1",
    "bench --quick --size 16 --only turing-spots/isotropic",
    "lookup --system turing-spots --area 90 --aspect 0.8 --angle 0",
    "lookup --system meinhardt-spots --area 90 --aspect 0.8 --angle 0 --spacing 20",
    "lookup --system meinhardt-stripes --width 9 --angle 0",
    "lookup --system meinhardt-lines --width 9 --angle 0 --duty 0.3",
    "lookup --system patches --area 90 --aspect 0.8 --angle 0 --raggedness 1.4",
    "lookup --system streaks --width 9 --angle 0",
    "lookup --system cracks --width 9 --duty 0.2",
    "lookup --system weave --width 9 --angle 0 --across 90",
    "lookup --system maze --width 9 --angle 0 --across 90 --long 40",
    "lookup --system pair-stripes --width 9 --angle 0",
    "lookup --system stucco --width 9",
    "lookup --system cells --area 90 --aspect 0.8 --angle 0",
];

/// The options of a command that take numbers, with the names of their values. Options that name files, systems and
/// units are left out.
fn numeric_options(command: &str) -> Vec<(String, String)> {
    let output = Folder::new().dapple(&format!("{command} --help")).output().unwrap();
    let help = String::from_utf8(output.stdout).unwrap();
    let option = |line: &str| {
        let (option, rest) = line.trim_start().strip_prefix("--")?.split_once('<')?;
        let value = rest.split_once('>')?.0;
        let is_name = value.contains('.') && !value.contains("...") || value.contains('|');
        let is_name = is_name || ["DIR", "IMG", "TEXT"].contains(&value) || option.trim_end() == "system";
        (!is_name).then(|| (option.trim_end_matches([' ', '[', '=']).to_owned(), value.to_owned()))
    };
    help.lines().filter_map(option).collect()
}

/// Values of an option, with `number` at each place of its value.
fn values(name: &str, number: &str) -> Vec<String> {
    let forms: &[&str] = match name {
        "WxH" | "CxR" => &["NxN", "8xN"],
        "WHAT=IMG:LOW:HIGH" => &["area=noise:N:0.5:2", "area=noise:9:N:2", "angle=noise:9:0:N"],
        "STYLE" => &["hatch:N", "hatch:2:N"],
        "X,Y,W,H" => &["N,0,8,8", "0,0,N,N"],
        "X,Y,X,Y,X,Y,X,Y" => &["N,0,40,0,40,40,0,40", "N,N,N,N,N,N,N,N"],
        "D[,W[,Q]]" => &["N", "90,N", "90,9,N"],
        "PX,…" | "GROUND,MARKS,…" => &["N", "0,N"],
        _ => &["N"],
    };
    forms.iter().map(|form| form.replace('N', number)).collect()
}

/// The command line `line` with this value of this option, where it has the option.
fn with(line: &str, option: &str, value: &str) -> Vec<String> {
    let mut words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
    let name = format!("--{option}");
    if let Some(at) = words.iter().position(|word| *word == name) {
        words.drain(at..at + 2);
    }
    words.retain(|word| !word.starts_with(&format!("{name}=")));
    words.push(format!("{name}={value}"));
    words
}

fn folder() -> Folder {
    let folder = Folder::new();
    let spots = json!([{"kind": "ellipse", "center": [12, 12], "radii": [4, 3], "angle": 30}]);
    let lines = json!([{"kind": "line", "from": [4, 8], "to": [20, 8], "width": 3}]);
    folder.write("spots.dapple", &document([24, 24], &spots).to_string());
    folder.write("lines.dapple", &document([24, 24], &lines).to_string());
    let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><ellipse cx="9" cy="9" rx="5" ry="4"/></svg>"#;
    folder.write("in.svg", drawing);
    let ink = |x: u32, y: u32| if (x % 12).abs_diff(6) + (y % 12).abs_diff(6) < 4 { 0u8 } else { 255 };
    image::GrayImage::from_fn(60, 60, |x, y| image::Luma([ink(x, y)]))
        .save(folder.path("spots.png"))
        .unwrap();
    folder
}

/// `dapple` in this folder. Where possible, its address space is limited to 4 GB, which is enough for all these uses.
fn limited(folder: &Folder) -> Command {
    if cfg!(not(unix)) {
        return folder.dapple("");
    }
    let mut command = Command::new("sh");
    command.args(["-c", "ulimit -v 4000000; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_dapple")]);
    command.current_dir(folder.path(""));
    command
}

#[test]
fn any_number_is_used_or_refused_with_a_message() {
    let folder = folder();
    let mut tried = Vec::new();
    for line in USES {
        let command = line.split(' ').next().unwrap_or_default();
        let options = numeric_options(command);
        assert!(options.len() >= 2, "{command}: {options:?}");
        for (option, name) in options {
            for value in NUMBERS.iter().flat_map(|number| values(&name, number)) {
                tried.push(with(line, &option, &value));
            }
        }
    }
    assert!(tried.len() > 2_000, "{}", tried.len());
    // A prime number, so that each option gets other numbers in each use.
    for words in some(tried, 7) {
        let output = limited(&folder).args(&words).timeout(Duration::from_secs(100)).output().unwrap();
        let (code, said) = (output.status.code(), String::from_utf8_lossy(&output.stderr));
        assert!(matches!(code, Some(0..=2)) && !said.contains("panicked"), "{words:?}: {code:?} {said}");
        assert!(code == Some(0) || said.contains("error: "), "{words:?}: {code:?} {said}");
    }
}

#[test]
fn a_negative_number_is_refused_with_what_is_allowed() {
    let folder = folder();
    for (line, words) in [
        ("film spots.dapple -o f.gif --hold -1", "'-1' for '--hold <S>': allowed: 0 to 600 seconds"),
        ("film spots.dapple -o f.gif --fps -1", "'--fps <N>': allowed: a whole number from 1 to 120"),
        ("film spots.dapple -o f.gif --seconds -2", "'--seconds <S>': allowed: a number above 0"),
        ("grow spots.dapple -o a.png --seed -1", "whole number from 0 to 18446744073709551615"),
        ("grow spots.dapple -o a.png --size -5x5", "1 to 65536"),
        ("grow spots.dapple --svg a.svg --pen -0.5", "'--pen <WIDTH>': allowed: a number above 0"),
        ("grow spots.dapple -o a.png --map -1", "allowed: WHAT=IMG:LOW:HIGH"),
        ("import spots.png -o i.dapple --crop -5,0,9,9", "allowed: X,Y,WIDTH,HEIGHT in whole px"),
        ("import spots.png -o i.dapple --level -inf", "'--level <N>': allowed: a number from"),
        ("lookup --system stucco --width -9", "'--width <W>': allowed: a number above 0"),
        ("lookup --system stucco --width 9 --decay -.1", "from 0 to 0.85"),
        ("learn --targets -1", "a whole number from 1 to 10000"),
        ("bench --size -1,16", "16 to 4096"),
    ] {
        let output = folder.dapple(line).assert().code(2).get_output().clone();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.starts_with("error: ") && said.contains(words), "{line}: {said}");
    }
    folder.dapple("lookup --system weave --width 9 --angle -30 --across -120,6").assert().success();
    let corners = "import spots.png -o i.dapple --take-it --corners -1,0,50,0,50,50,0,50";
    let said = folder.dapple(corners).assert().code(1).get_output().stderr.clone();
    assert!(
        String::from_utf8_lossy(&said).contains("--corners: allowed: four corners inside of its 60×60 px")
    );
}
