//! Text that is not JSON.

use super::*;

#[test]
fn an_empty_file_is_refused() {
    no_json("", 1, 1, "an empty file");
    no_json(" \n\u{feff}", 2, 1, "`\\u{feff}`");
    no_json("\u{feff} \n\n", 1, 1, "an empty file");
}

#[test]
fn invalid_json_is_reported_with_line_and_column() {
    no_json("{\n  \"format\": dapple\n}", 2, 13, "dapple");
    no_json("{\n  \"größe\": 'x' }", 2, 12, "`'`");
    no_json("{\"format\": \"dapple\",}", 1, 21, "`}`");
    no_json("{} {}", 1, 4, "`{`");
    no_json("hello", 1, 1, "hello");
}

#[test]
fn a_file_cut_short_is_refused() {
    let whole = least().to_string();
    for end in 1..whole.len() {
        let message = error_of_text(&whole[..end]);
        assert!(message.contains("found the end of the file"), "{message}");
    }
}

#[test]
fn nan_and_infinity_are_named() {
    for literal in ["NaN", "-NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"] {
        let text = least().to_string().replace("[12,", &format!("[{literal},"));
        let message = error_of_text(&text);
        let expected = format!("found {literal}, which JSON does not have; allowed: a finite number");
        assert!(message.ends_with(&expected), "{message}");
    }
}

#[test]
fn a_number_beyond_all_floats_is_named() {
    let message = error_of_text(&least().to_string().replace("[12,", "[1e999,"));
    assert!(message.contains("found 1e999, which is too large; allowed: a finite number"), "{message}");
    let message = error_of_text(&least().to_string().replace("[12,", &format!("[{},", "9".repeat(400))));
    assert!(message.contains("which is too large"), "{message}");
    assert!(message.len() < 300, "{message}");
}

#[test]
fn a_repeated_key_is_refused() {
    no_json("{\n\"format\": \"dapple\",\n\"seed\": 1, \"seed\": 2}", 3, 17, "the key \"seed\" twice");
    let message = error_of_text(r#"{"layers": [{"strokes": [{"kind": "line", "kind": "line"}]}]}"#);
    assert!(message.contains("the key \"kind\" twice"), "{message}");
}

#[test]
fn brackets_without_end_do_not_exhaust_the_stack() {
    for bracket in ["[", "{\"a\":"] {
        let message = error_of_text(&bracket.repeat(100_000));
        assert!(message.contains("nested more than 127 deep"), "{message}");
    }
}
