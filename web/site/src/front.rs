//! The front page: `web/site/front.html` with the links to the examples that it names.

use std::fs;
use std::path::Path;

use crate::Failure;
use crate::gallery::Item;
use crate::place;
use crate::shell::shell;

/// Writes the page. `{link:NAME}` in the text becomes the fragment of an example, `{copy:FILE}` a copy of a file.
pub fn write(root: &Path, out: &Path, items: &[Item]) -> Result<(), Failure> {
    let text = fs::read_to_string(root.join("web/site/front.html"))?;
    let mut parts = text.split('{');
    let mut content = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (wanted, rest) = part.split_once('}').ok_or("front.html: found { without }")?;
        content.push_str(&filled(root, out, items, wanted)?);
        content.push_str(rest);
    }
    let icon = Path::new("assets/icon/dapple.svg");
    copied(root, out, icon)?;
    fs::write(out.join("index.html"), shell(Path::new("index.html"), "dapple", &content))?;
    Ok(())
}

fn filled(root: &Path, out: &Path, items: &[Item], wanted: &str) -> Result<String, Failure> {
    match wanted.split_once(':') {
        Some(("link", name)) => {
            let item = items.iter().find(|item| item.name == name);
            let link = item.and_then(|item| item.link.clone());
            link.ok_or_else(|| {
                format!("front.html: found {name}; allowed: an example that has a link").into()
            })
        }
        Some(("copy", file)) => copied(root, out, Path::new(file)),
        _ => Err(format!("front.html: found {{{wanted}}}; allowed: {{link:NAME}}, {{copy:FILE}}").into()),
    }
}

fn copied(root: &Path, out: &Path, file: &Path) -> Result<String, Failure> {
    let to = place::copy(file);
    fs::create_dir_all(out.join(&to).parent().unwrap_or(out))?;
    fs::copy(root.join(file), out.join(&to))?;
    Ok(to.display().to_string())
}
