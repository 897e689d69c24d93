//! `dapple completions` and `dapple man`: shell completions and manual pages, generated from the arguments.

use super::{Cli, Error, print};
use crate::files;
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use std::io::Write;
use std::path::PathBuf;

/// Arguments of `dapple completions`.
#[derive(clap::Args, Debug)]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: Shell,
}

/// Arguments of `dapple man`.
#[derive(clap::Args, Debug)]
pub struct ManArgs {
    /// Print the page of this command [default: the page of dapple itself]
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
    /// Write all pages into this folder instead: dapple.1, dapple-grow.1, …
    #[arg(short, long, value_name = "DIR", conflicts_with = "command")]
    pub output: Option<PathBuf>,
}

/// Prints the completion script for a shell.
///
/// # Errors
/// Stdout is closed.
pub fn completions(args: &CompletionsArgs) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "dapple", &mut script);
    print(&String::from_utf8_lossy(&script))
}

/// Prints a page of the manual, or writes them all.
///
/// # Errors
/// An unknown command; the pages cannot be written.
pub fn man(args: &ManArgs) -> Result<(), Error> {
    let mut root = Cli::command();
    root.build();
    let pages = || std::iter::once(&root).chain(root.get_subcommands().filter(|c| c.get_name() != "help"));
    if let Some(folder) = &args.output {
        let pages: Vec<_> = pages()
            .map(|command| {
                let text = page(&root, command)?;
                let path = folder.join(format!("{}.1", title(&root, command)));
                files::prepare(&path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(Error::step)
            })
            .collect::<Result<_, _>>()?;
        return files::keep_all(pages).map_err(Error::step);
    }
    let name = args.command.as_deref().unwrap_or("dapple");
    let Some(command) = pages().find(|command| command.get_name() == name) else {
        let names: Vec<_> = pages().skip(1).map(Command::get_name).collect();
        return Err(Error::Usage(format!("COMMAND: found {name}; allowed: {}", names.join(", "))));
    };
    print(&page(&root, command)?)
}

/// The title of a page, for example `dapple-grow`.
fn title(root: &Command, command: &Command) -> String {
    let (name, program) = (command.get_name(), root.get_name());
    if name == program { name.to_owned() } else { format!("{program}-{name}") }
}

fn page(root: &Command, command: &Command) -> Result<String, Error> {
    let titled = command.clone().name(title(root, command)).version(env!("CARGO_PKG_VERSION"));
    let mut page = Vec::new();
    clap_mangen::Man::new(titled).render(&mut page).map_err(Error::Output)?;
    Ok(in_ascii(&String::from_utf8_lossy(&page)))
}

/// The page with escape sequences in place of characters outside ASCII, because not every troff knows the encoding of
/// its input.
fn in_ascii(page: &str) -> String {
    let escaped = |c: char| if c.is_ascii() { c.to_string() } else { format!("\\[u{:04X}]", u32::from(c)) };
    page.chars().map(escaped).collect()
}
