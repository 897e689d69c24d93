//! Checks the pages: every link leads somewhere, nothing is loaded from another host, and each link to the editor holds
//! its document.

use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Failure;
use crate::gallery::Item;
use crate::place;

/// The folder of the editor, which .ci/web makes.
const EDITOR: &str = "editor";
/// The folder of the page that proves that the browser grows the same bytes; .ci/web-bytes makes it.
const PROVE: &str = "prove";

/// Checks all pages.
pub fn check(out: &Path, program: &Path, items: &[Item]) -> Result<(), Failure> {
    let mut pages = HashMap::new();
    read_pages(out, Path::new(""), &mut pages)?;
    let mut wrong = BTreeSet::new();
    let (mut links, mut to_editor) = (0, BTreeSet::new());
    for (page, text) in &pages {
        for (attribute, link) in attributes(text) {
            links += 1;
            match target(page, attribute, &link) {
                Target::Outside => {}
                Target::Editor(fragment) => to_editor.extend(fragment),
                Target::Inside(file, anchor) => {
                    let has = |id: &str| {
                        pages.get(&file).is_some_and(|text| text.contains(&format!("id=\"{id}\"")))
                    };
                    if !out.join(&file).is_file() || anchor.is_some_and(|anchor| !has(&anchor)) {
                        wrong.insert(format!("{}: {link} leads nowhere", page.display()));
                    }
                }
                Target::Wrong(why) => {
                    wrong.insert(format!("{}: {link}: {why}", page.display()));
                }
            }
        }
    }
    for item in items {
        if let Some(link) = &item.link
            && (!to_editor.contains(link) || !comes_back(program, link)?)
        {
            wrong.insert(format!("{}: its link does not give it back", item.file.display()));
        }
    }
    for built in [EDITOR, PROVE] {
        if !out.join(built).join("index.html").is_file() {
            println!("NOT CHECKED: that {built}/ opens, which is not there");
        }
    }
    println!("{} pages, {links} links, {} of them to documents in the editor", pages.len(), to_editor.len());
    if wrong.is_empty() { Ok(()) } else { Err(wrong.into_iter().collect::<Vec<_>>().join("\n").into()) }
}

/// The target of a link.
enum Target {
    /// Another host, or pages that another step builds.
    Outside,
    /// The editor, with a document.
    Editor(Option<String>),
    /// A file of the site, and an anchor in it.
    Inside(PathBuf, Option<String>),
    Wrong(&'static str),
}

fn target(page: &Path, attribute: &str, link: &str) -> Target {
    if link.contains("://") || link.starts_with("//") || link.starts_with("mailto:") {
        return if attribute == "src" { Target::Wrong("comes from another host") } else { Target::Outside };
    }
    let (path, anchor) = link.split_once('#').map_or((link, None), |(path, at)| (path, Some(at.to_owned())));
    let path = path.split('?').next().unwrap_or_default();
    let from = page.parent().unwrap_or(Path::new(""));
    let file = if path.is_empty() { Some(page.to_owned()) } else { place::plain(&from.join(path)) };
    match file {
        None => Target::Wrong("leaves the site"),
        Some(file) if file.starts_with(PROVE) => Target::Outside,
        Some(file) if file.starts_with(EDITOR) => Target::Editor(anchor.map(|anchor| format!("#{anchor}"))),
        Some(file) => Target::Inside(file, anchor),
    }
}

/// The texts of all pages below a folder of the site, except those of the editor.
fn read_pages(out: &Path, folder: &Path, pages: &mut HashMap<PathBuf, String>) -> Result<(), Failure> {
    for entry in fs::read_dir(out.join(folder))? {
        let path = folder.join(entry?.file_name());
        if out.join(&path).is_dir() {
            if ![EDITOR, PROVE].map(Path::new).contains(&path.as_path()) {
                read_pages(out, &path, pages)?;
            }
        } else if path.extension().is_some_and(|ending| ending == "html") {
            pages.insert(path.clone(), fs::read_to_string(out.join(&path))?);
        }
    }
    Ok(())
}

/// The `href` and `src` of the elements of a page.
fn attributes(text: &str) -> Vec<(&'static str, String)> {
    let tags = text.split('<').skip(1).filter_map(|piece| Some(piece.split_once('>')?.0));
    let value = |tag: &str, name| {
        Some(tag.split_once(&format!(" {name}=\""))?.1.split_once('"')?.0.replace("&amp;", "&"))
    };
    tags.flat_map(|tag| ["href", "src"].map(|name| Some((name, value(tag, name)?)))).flatten().collect()
}

/// Whether dapple reads a link and makes the same link again from its document.
fn comes_back(program: &Path, link: &str) -> Result<bool, Failure> {
    let output = Command::new(program).args(["link", "--site", "", link]).output()?;
    Ok(output.status.success() && String::from_utf8_lossy(&output.stdout).trim() == link)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_told_apart_by_where_they_lead() {
        let at = |link| target(Path::new("docs/a.html"), "href", link);
        assert!(matches!(at("https://a.example/"), Target::Outside));
        assert!(matches!(target(Path::new("a.html"), "src", "https://a.example/a.png"), Target::Wrong(_)));
        assert!(matches!(at("../../a"), Target::Wrong(_)));
        assert!(
            matches!(at("../editor/?view#dapple1=a"), Target::Editor(Some(link)) if link == "#dapple1=a")
        );
        assert!(
            matches!(at("#b"), Target::Inside(file, Some(at)) if file == Path::new("docs/a.html") && at == "b")
        );
        let page = "<a href=\"b&amp;c\"><img src=\"d\"></a> &lt;a href=\"no link\"&gt;";
        assert_eq!(attributes(page), [("href", "b&c".to_owned()), ("src", "d".to_owned())]);
    }
}
