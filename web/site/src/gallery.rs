//! The gallery: the examples as pictures, each with a link that opens it in the editor.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Failure;
use crate::shell::{escaped, shell};

/// The folders of examples/, and what they hold.
const FOLDERS: [(&str, &str); 3] = [
    ("examples", "Examples"),
    ("examples/gallery", "After figures of papers"),
    ("examples/bodies", "On models"),
];
/// Quality of the pictures: at this quality no blocks are visible.
const QUALITY: &str = "85";

/// An example.
pub struct Item {
    /// The path of its file, from the root.
    pub file: PathBuf,
    /// Its file name without ending.
    pub name: String,
    /// What it shows.
    pub title: String,
    /// Width and height of its picture, px.
    pub size: [u64; 2],
    /// The fragment that holds it; `None` where it is too large for a link.
    pub link: Option<String>,
}

/// Grows the pictures and writes the page.
pub fn write(root: &Path, out: &Path, program: &Path) -> Result<Vec<Item>, Failure> {
    for folder in ["pictures", "documents"] {
        fs::create_dir_all(out.join(folder))?;
    }
    let mut items = Vec::new();
    let mut content = "<h1>Gallery</h1>\n<p>Each picture opens in the editor.</p>\n".to_owned();
    for (folder, title) in FOLDERS {
        // Writing to a String cannot fail.
        let _ = writeln!(content, "<h2>{title}</h2>\n<div class=\"gallery\">");
        for file in documents(root, folder)? {
            let item = item(root, out, program, file)?;
            content.push_str(&figure(&item));
            items.push(item);
        }
        content.push_str("</div>\n");
    }
    fs::write(out.join("gallery.html"), shell(Path::new("gallery.html"), "Gallery", &content))?;
    Ok(items)
}

/// The documents in a folder, from the root.
fn documents(root: &Path, folder: &str) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for entry in fs::read_dir(root.join(folder))? {
        files.push(Path::new(folder).join(entry?.file_name()));
    }
    files.retain(|file| file.extension().is_some_and(|ending| ending == "dapple"));
    files.sort();
    Ok(files)
}

fn item(root: &Path, out: &Path, program: &Path, file: PathBuf) -> Result<Item, Failure> {
    let path = root.join(&file);
    let document: serde_json::Value = serde_json::from_str(&fs::read_to_string(&path)?)?;
    let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let copy = out.join(format!("documents/{name}.dapple"));
    if copy.exists() && fs::read(&copy)? != fs::read(&path)? {
        return Err(format!("{}: found a second document named {name}", file.display()).into());
    }
    let is_on_model = document.get("model").is_some();
    let size = if is_on_model {
        [512, 512]
    } else {
        [0, 1].map(|axis| document["size"][axis].as_u64().unwrap_or(0))
    };
    let picture = out.join(format!("pictures/{name}.jpg"));
    let mut grow = Command::new(program);
    grow.arg("grow").arg(&path).arg("-o").arg(&picture).args(["--quality", QUALITY, "--quiet"]);
    if is_on_model {
        grow.args(["--size", "512x512"]);
    }
    if !grow.status()?.success() {
        return Err(format!("{}: cannot be grown", file.display()).into());
    }
    fs::copy(&path, copy)?;
    let title = document["name"].as_str().filter(|title| !title.is_empty()).unwrap_or(&name).to_owned();
    let link = fragment(program, &path)?;
    Ok(Item { file, name, title, size, link })
}

/// The fragment of the link to a document; `None` where the document is too large for a link.
fn fragment(program: &Path, file: &Path) -> Result<Option<String>, Failure> {
    let output = Command::new(program).args(["link", "--site", ""]).arg(file).output()?;
    if output.status.success() {
        return Ok(Some(String::from_utf8(output.stdout)?.trim().to_owned()));
    }
    let why = String::from_utf8_lossy(&output.stderr).into_owned();
    if why.contains("as a file instead") || why.contains("a document of more than") {
        Ok(None)
    } else {
        Err(why.into())
    }
}

/// A picture with its link. A document that is too large for a link is offered as a file to open in the editor.
fn figure(item: &Item) -> String {
    let Item { name, title, size: [width, height], link, .. } = item;
    let (to, note) = match link {
        Some(link) => (format!("editor/index.html{link}"), ""),
        None => (format!("documents/{name}.dapple"), " (a file to open in the editor)"),
    };
    let title = escaped(title);
    format!(
        "<figure><a href=\"{to}\"><img src=\"pictures/{name}.jpg\" width=\"{width}\" height=\"{height}\" loading=\"lazy\" \
         alt=\"{title}\"></a><figcaption>{title}{note} <a href=\"documents/{name}.dapple\" download>file</a></figcaption></figure>\n"
    )
}
