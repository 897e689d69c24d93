//! Checks that the first sentence of each doc comment says what the item is, without referring to the item above it. In
//! lists of items and in tooltips of editors, the sentence is shown alone.

use crate::sources::sources;

/// First words of a sentence that can only be understood together with another text.
const LEANING: [&str; 6] = ["The same", "As", "See", "Those", "That of", "And"];

/// The first paragraph of each doc comment, with the number of its first line, counted from 1.
fn first_paragraphs(source: &str) -> Vec<(usize, String)> {
    let text =
        |line: &str| line.strip_prefix("///").or(line.strip_prefix("//!")).map(|text| text.trim().to_owned());
    let mut found: Vec<(usize, String)> = Vec::new();
    let (mut within, mut ended) = (false, false);
    for (index, line) in source.lines().enumerate() {
        let Some(text) = text(line.trim()) else {
            within = false;
            continue;
        };
        if !within {
            found.push((index + 1, text));
            (within, ended) = (true, false);
        } else if text.is_empty() {
            ended = true;
        } else if let (false, Some((_, paragraph))) = (ended, found.last_mut()) {
            paragraph.push(' ');
            paragraph.push_str(&text);
        }
    }
    found
}

/// What is wrong with a first paragraph, if anything.
fn complaint(paragraph: &str) -> Option<String> {
    let begins = |words: &&&str| {
        paragraph.strip_prefix(**words).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    };
    if let Some(words) = LEANING.iter().find(begins) {
        return Some(format!("begins with \"{words}\""));
    }
    let ends = paragraph
        .match_indices(['.', '?', '!', ':', ';'])
        .find(|(at, sign)| paragraph[at + sign.len()..].chars().next().is_none_or(char::is_whitespace));
    ends.is_some_and(|(_, sign)| sign == "?").then(|| "is a question".to_owned())
}

#[test]
fn docs_of_an_item_stand_alone() {
    let mut complaints = Vec::new();
    for (file, source) in sources() {
        for (line, paragraph) in first_paragraphs(&source) {
            complaints.extend(complaint(&paragraph).map(|why| format!("{file}:{line} {why}: {paragraph}")));
        }
    }
    assert!(complaints.is_empty(), "say what the item is, with its unit:\n{}", complaints.join("\n"));
}

#[test]
fn a_doc_that_leans_on_another_is_found() {
    for paragraph in [
        "The same in px.",
        "As [`f`].",
        "See `g`.",
        "Is it round?",
        "Is it round? Yes.",
        "As\nis.",
        "Those of a grid.",
        "And less.",
    ] {
        assert!(complaint(paragraph).is_some(), "{paragraph}");
    }
    for paragraph in
        ["The sameness.", "Asks.", "Area, px².", "What `?embed` asks for.", "Whether it is round. Is it?"]
    {
        assert_eq!(complaint(paragraph), None, "{paragraph}");
    }
    let source = "/// One\n/// line.\n///\n/// Two.\nfn f() {}\n//! Head.";
    assert_eq!(first_paragraphs(source), [(1, "One line.".to_owned()), (6, "Head.".to_owned())]);
}
