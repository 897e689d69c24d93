//! The parts that all pages have around their content.

use std::path::Path;

use crate::place::way;

/// A whole page, whose path is `at`.
pub fn shell(at: &Path, title: &str, content: &str) -> String {
    let to = |file: &str| way(at, Path::new(file));
    let title =
        if title == "dapple" { "dapple".to_owned() } else { format!("{} – dapple", escaped(title)) };
    format!(
        r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="icon" href="{icon}">
<link rel="stylesheet" href="{css}">
</head>
<body>
<header><nav><a class="home" href="{home}">dapple</a> <a href="{editor}">Draw</a> <a href="{gallery}">Gallery</a> <a href="{docs}">Docs</a></nav></header>
<main>
{content}</main>
</body>
</html>
"#,
        icon = to("files/assets/icon/dapple.svg"),
        css = to("site.css"),
        home = to("index.html"),
        editor = to("editor/index.html"),
        gallery = to("gallery.html"),
        docs = to("docs/index.html"),
    )
}

/// A text within HTML.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
