//! Tables as texts.

use super::*;
use crate::cli::lookup::answer_table;

/// The table with the answers to the questions in `bytes`.
fn answer(bytes: &[u8]) -> Result<Vec<u8>, Error> {
    let mut answers = Vec::new();
    answer_table(Training::built_in(), "q.csv", bytes, &mut answers).map(|()| answers)
}

fn message(text: &str) -> String {
    answer(text.as_bytes()).unwrap_err().to_string()
}

fn table(text: &str) -> Vec<Vec<String>> {
    let out = answer(text.as_bytes()).unwrap();
    let mut reader = ReaderBuilder::new().has_headers(false).from_reader(out.as_slice());
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

#[test]
fn answers_are_added_as_columns_to_the_unchanged_table() {
    let rows = table(
        "\u{feff}angle,system,width,aspect,area,spacing\n30,meinhardt-stripes,8,,,\n -20 ,meinhardt-spots,,0.5,300,60\n5,turing-spots,,.6,200,\n",
    );
    assert_eq!(
        rows[0],
        [
            "angle",
            "system",
            "width",
            "aspect",
            "area",
            "spacing",
            "rate",
            "ratio",
            "stretch",
            "direction",
            "level",
            "pitch",
            "cell",
            "coverage",
            "note",
            "inverted"
        ]
    );
    assert_eq!(rows[1][..6], ["30", "meinhardt-stripes", "8", "", "", ""]);
    assert_eq!(rows[2][..6], ["-20", "meinhardt-spots", "", "0.5", "300", "60"]);
    assert_eq!((rows[1][7].as_str(), rows[1][10].as_str()), ("", ""));
    assert!(rows.iter().all(|row| row.len() == 16));
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    assert!((1..4).all(|row| number(row, 6) > 0.0 && number(row, 12) > 0.0));
    assert!((number(2, 9) - 160.0).abs() < 3.0);
    assert_eq!(rows[1][13], "inside");
}

#[test]
fn lines_are_asked_for_with_their_duty() {
    let rows = table(
        "system,width,angle,duty\nmeinhardt-lines,8,0,0.25\nmeinhardt-lines,8,0,\nmeinhardt-stripes,8,0,0.5\n",
    );
    let ratio = |row: usize| rows[row][5].parse::<f64>().unwrap();
    assert!(ratio(1) > 2.0 * ratio(2) && rows[3][5].is_empty(), "{rows:?}");
    let wrong = message("system,width,angle,duty\nmeinhardt-stripes,8,0,0.3\n");
    assert!(
        wrong.contains(
            "column duty: found '0.3'; allowed: 0.5. Meinhardt's stripes are as wide as their gaps"
        ),
        "{wrong}"
    );
}

#[test]
fn columns_of_the_other_kind_may_be_missing() {
    assert_eq!(table("system,width,angle\nmeinhardt-stripes,8,0\n").len(), 2);
    assert_eq!(table("system,area,angle,aspect\nturing-spots,200,0,0.6\n").len(), 2);
    assert_eq!(table("system,width,angle\n").len(), 1);
}

#[test]
fn an_invalid_value_is_named_with_its_place() {
    let with = |row: &str| message(&format!("system,area,aspect,angle,spacing,width\n\n{row}\n"));
    assert_eq!(
        with("turing-spots,-3,0.5,0,,"),
        "q.csv, line 3, column area: found '-3'; allowed: a number above 0, from 1e-6 to 1e12"
    );
    for (row, place) in [
        ("auto,300,0.5,0,,", "column system: found 'auto'; allowed: turing-spots"),
        (",300,0.5,0,,", "column system: found ''"),
        ("turing-spots,300,1.5,0,,", "column aspect: found '1.5'"),
        ("turing-spots,300,,0,,", "column aspect: found ''"),
        ("turing-spots,300,0.5,NaN,,", "column angle: found 'NaN'"),
        ("turing-spots,300,0.5,0,x,", "column spacing: found 'x'"),
        ("turing-spots,300,0.5,0,,4", "column width: found '4'; allowed: empty, as spots do not have it"),
        (
            "meinhardt-stripes,300,,0,,4",
            "column area: found '300'; allowed: empty, as stripes do not have it",
        ),
        ("meinhardt-stripes,,,0,,", "column width: found ''"),
        ("meinhardt-stripes,4", "line 3: found 2 values; allowed: 6, as in line 1"),
    ] {
        let message = with(row);
        assert!(message.starts_with("q.csv, line 3") && message.contains(place), "{message}");
    }
}

#[test]
fn a_table_longer_than_what_is_held_has_all_its_answers_and_lines() {
    let row = "turing-spots,200,0,0.6\n";
    let long = format!("system,area,angle,aspect\n{}", row.repeat(2_500));
    let rows = table(&long);
    assert_eq!(rows.len(), 2_501);
    assert!(rows[2..].iter().all(|row| *row == rows[1]));
    let wrong = message(&format!("{long}\n\n{row}turing-spots,-200,0,0.6\n"));
    assert!(wrong.starts_with("q.csv, line 2505, column area: found '-200'"), "{wrong}");
}

#[test]
fn other_columns_are_copied_whatever_they_hold() {
    let text = b"id,system,width,note,angle\n7,meinhardt-stripes,8,\"a, L\xf6we\",0\n";
    let out = answer(text).expect("answers");
    let mut lines = out.split(|byte| *byte == b'\n');
    assert!(lines.next().is_some_and(|line| line.starts_with(b"id,system,width,note,angle,rate,")));
    assert!(lines.next().is_some_and(|line| line.starts_with(b"7,meinhardt-stripes,8,\"a, L\xf6we\",0,")));
}

#[test]
fn a_table_with_semicolons_and_decimal_commas_is_answered_in_its_form() {
    let text = "sep=;\nsystem;area;aspect;angle;name\nturing-spots;200;0,6;20;a,b\n";
    let out = String::from_utf8(answer(text.as_bytes()).expect("answers")).expect("text");
    let cells: Vec<&str> = out.lines().nth(1).expect("a row").split(';').collect();
    assert_eq!(cells[..5], ["turing-spots", "200", "0,6", "20", "a,b"]);
    assert_eq!(cells.len(), 15);
    let plain = table("system,area,aspect,angle\nturing-spots,200,0.6,20\n");
    assert_eq!(cells[5].replace(',', "."), plain[1][4]);
    // With decimal points, and with tabs.
    for (between, aspect) in [(";", "0.6"), ("\t", "0.6"), ("\t", "0,6")] {
        let text = "system,area,aspect,angle\nturing-spots,200,ASPECT,20\n"
            .replace(',', between)
            .replace("ASPECT", aspect);
        let out = String::from_utf8(answer(text.as_bytes()).expect("answers")).expect("text");
        let rate = out.lines().nth(1).and_then(|row| row.split(between).nth(4)).expect("a rate");
        assert_eq!(rate.contains(','), aspect.contains(','), "{text}");
    }
    let wrong = message("system;area;aspect;angle\nturing-spots;2,0,0;0,6;20\n");
    assert!(wrong.contains("line 2, column area: found '2,0,0'"), "{wrong}");
}

#[test]
fn stripes_are_asked_of_the_system_that_grows_them() {
    let rows = table("system,width,angle,duty\nstripes,8,20,0.3\nmeinhardt-lines,8,20,0.3\nstripes,8,20,\n");
    // The parameters are those of the system that the note names.
    assert_eq!(rows[1][4..11], rows[2][4..11]);
    let note = rows[0].iter().position(|name| name == "note").expect("a column");
    let notes: Vec<&str> = rows[1..].iter().map(|row| row[note].as_str()).collect();
    assert!(notes[0].starts_with("grown by meinhardt-lines"), "{notes:?}");
    assert!(!notes[1].contains("grown by"), "{notes:?}");
    assert!(notes[2].starts_with("grown by meinhardt-stripes"), "{notes:?}");
}

#[test]
fn a_wrong_header_is_named() {
    assert!(message("").contains("the column 'system' is missing"));
    assert!(message("system,widht\n").contains("found the column 'widht'; allowed: the columns system,area"));
    assert!(message("system,width,width\n").contains("found the column 'width' twice"));
    assert!(
        answer(b"system,width,angle\nmeinhardt-stripes,\xff,0\n").unwrap_err().to_string().contains("UTF-8")
    );
}
