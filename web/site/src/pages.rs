//! The guides as pages, and the list of them.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crate::Failure;
use crate::markdown::{self, Page};
use crate::place::{self, GUIDES};
use crate::shell::{escaped, shell};

/// Writes all pages; returns how many.
pub fn write(root: &Path, out: &Path) -> Result<usize, Failure> {
    fs::create_dir_all(out.join("docs"))?;
    let mut list = String::new();
    let guides = guides(root)?;
    for guide in &guides {
        let to = place::page(guide).ok_or_else(|| format!("{}: no page", guide.display()))?;
        let Page { title, summary, html } = page(root, out, guide, &to)?;
        fs::write(out.join(&to), shell(&to, &title, &html))?;
        let file = to.file_name().unwrap_or_default().to_string_lossy();
        // Writing to a String cannot fail.
        let _ = writeln!(
            list,
            "<li><a href=\"{file}\">{}</a><p>{}</p></li>",
            escaped(&title),
            escaped(first_sentence(&summary))
        );
    }
    let index = Path::new("docs/index.html");
    fs::write(
        out.join(index),
        shell(index, "Docs", &format!("<h1>Docs</h1>\n<ul class=\"list\">\n{list}</ul>\n")),
    )?;
    Ok(guides.len())
}

/// The guides of docs/ and of other folders, from the root.
fn guides(root: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut guides: Vec<PathBuf> = fs::read_dir(root.join("docs"))?
        .map(|entry| Ok(Path::new("docs").join(entry?.file_name())))
        .collect::<Result<_, std::io::Error>>()?;
    guides.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    guides.extend(GUIDES.map(|folder| Path::new(folder).join("README.md")));
    guides.sort_by_key(|path| path.to_string_lossy().to_lowercase());
    Ok(guides)
}

/// Renders a guide and copies the files that it shows or links to.
fn page(root: &Path, out: &Path, guide: &Path, to: &Path) -> Result<Page, Failure> {
    let folder = guide.parent().unwrap_or(Path::new(""));
    markdown::render(&fs::read_to_string(root.join(guide))?, |link| {
        if link.starts_with('#') || link.contains("://") || link.starts_with("mailto:") {
            return Ok(link.to_owned());
        }
        let (path, anchor) =
            link.split_once('#').map_or((link, String::new()), |(path, at)| (path, format!("#{at}")));
        let nowhere = || format!("{}: found the link {link}, which leads nowhere", guide.display());
        let file =
            place::plain(&folder.join(path)).filter(|file| root.join(file).is_file()).ok_or_else(nowhere)?;
        let target = place::page(&file).unwrap_or_else(|| place::copy(&file));
        if target.starts_with("files") {
            fs::create_dir_all(out.join(&target).parent().unwrap_or(out))?;
            fs::copy(root.join(&file), out.join(&target))?;
        }
        Ok(place::way(to, &target) + &anchor)
    })
}

fn first_sentence(text: &str) -> &str {
    text.split_inclusive(". ").next().unwrap_or_default().trim_end()
}
