//! The place of a file of the repository on the site: guides become pages, all other files are copied.

use std::path::{Component, Path, PathBuf};

/// Folders whose README becomes a page, in addition to the files of docs/.
pub const GUIDES: [&str; 3] = ["benches", "examples", "training"];

/// The page of a guide, from the folder of the site.
pub fn page(file: &Path) -> Option<PathBuf> {
    let name = file.file_stem()?.to_str()?;
    let folder = file.parent()?.to_str()?;
    match (folder, name) {
        _ if file.extension()? != "md" => None,
        ("", "README") => Some("index.html".into()),
        ("docs", name) => Some(format!("docs/{}.html", name.to_lowercase()).into()),
        (folder, "README") if GUIDES.contains(&folder) => Some(format!("docs/{folder}.html").into()),
        _ => None,
    }
}

/// The copy of a file that is not a page.
pub fn copy(file: &Path) -> PathBuf {
    Path::new("files").join(file)
}

/// A path without `.` and `..`; `None` where it leaves the folder.
pub fn plain(path: &Path) -> Option<PathBuf> {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::Normal(name) => plain.push(name),
            Component::CurDir => {}
            Component::ParentDir if plain.pop() => {}
            _ => return None,
        }
    }
    Some(plain)
}

/// The relative path from a page to a file; both paths are from the folder of the site.
pub fn way(from: &Path, to: &Path) -> String {
    let up = from.components().count() - 1;
    let down = to.components().map(|part| part.as_os_str().to_string_lossy().into_owned());
    std::iter::repeat_n("..".to_owned(), up).chain(down).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guides_are_pages_and_other_files_copies() {
        assert_eq!(page(Path::new("docs/CHANGELOG.md")), Some("docs/changelog.html".into()));
        assert_eq!(page(Path::new("examples/README.md")), Some("docs/examples.html".into()));
        assert_eq!(page(Path::new("src/README.md")), None);
        assert_eq!(page(Path::new("docs/learning.csv")), None);
        assert_eq!(plain(Path::new("docs/../assets/./a.png")), Some("assets/a.png".into()));
        assert_eq!(plain(Path::new("docs/../../a.png")), None);
        assert_eq!(way(Path::new("docs/a.html"), Path::new("files/b.png")), "../files/b.png");
    }
}
