//! docs/*.md and examples/ → static pages.
//!
//! ```text
//!  *.md ─▶ markdown ─▶ pages ──┐
//!  examples ─▶ gallery ────────┼─▶ OUT ─▶ check: no link leads nowhere, each link to the editor holds its document
//!  front.html ─▶ front ────────┘
//! ```
//!
//! `dapple-site ROOT OUT PROGRAM`: the repository, the folder to write, an optimised build of dapple, which grows the
//! pictures and makes the links.

mod check;
mod front;
mod gallery;
mod markdown;
mod pages;
mod place;
mod shell;

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

/// The reason why the site cannot be made.
type Failure = Box<dyn std::error::Error>;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("dapple-site: {why}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Failure> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [root, out, program] = &arguments[..] else {
        return Err("usage: dapple-site ROOT OUT PROGRAM".into());
    };
    fs::create_dir_all(out)?;
    for name in ["site.css", "site.js"] {
        fs::copy(root.join("web/site").join(name), out.join(name))?;
    }
    let pages = pages::write(root, out)?;
    println!("{pages} pages of docs");
    let items = gallery::write(root, out, program)?;
    println!(
        "{} pictures, {} of them with a link",
        items.len(),
        items.iter().filter(|item| item.link.is_some()).count()
    );
    front::write(root, out, &items)?;
    check::check(out, program, &items)
}
