//! The command line: one file a command. Without one it opens the window.
//!
//! Exit codes: 0 done; 1 could not (file, growth); 2 used wrongly; 130 interrupted. What is asked for goes to
//! stdout, errors and progress go to stderr.

mod bench;
mod check;
#[cfg(test)]
mod documented;
mod error;
mod estimate;
mod film;
mod grow;
mod import;
mod interrupt;
mod learn;
pub mod lookup;
mod manual;
mod measure;
mod paths;
mod progress;
mod sheet;
mod values;

pub use error::Error;
pub use interrupt::{install, interrupted};

use crate::document::with_causes;
use crate::rd::Solver;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

/// Draw a few spots or stripes; dapple grows a reaction-diffusion texture with their size, shape, spacing and
/// direction. Without a command, or with a document alone, it opens its window.
#[derive(Parser)]
#[command(name = "dapple", version, subcommand_required = true, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Grow documents and write their pictures
    Grow(Box<grow::Args>),
    /// Film a document while it grows, or while it turns into another
    Film(film::Args),
    /// Grow many documents and lay their pictures out on one sheet
    Sheet(sheet::Args),
    /// Make a document of what is drawn in an SVG
    Import(import::Args),
    /// Look up the parameters that give spots or stripes of certain attributes
    Lookup(lookup::Args),
    /// Measure the spots or stripes in a picture
    Measure(measure::Args),
    /// Tell whether a document is valid, and what is in it
    Check(check::Args),
    /// Tell how good the training sets are, against other methods and against what then grows
    Learn(learn::Args),
    /// Measure how fast this machine is
    Bench(bench::Args),
    /// Print what a shell completes dapple's command line by
    Completions(manual::CompletionsArgs),
    /// Print dapple's manual page, or write those of all commands
    Man(manual::ManArgs),
}

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> ExitCode {
    if let Err(error) = choose_solver() {
        return finish(Err(error));
    }
    let arguments: Vec<OsString> = std::env::args_os().collect();
    match &arguments[..] {
        [] | [_] => finish(window(None)),
        [_, file] if is_document(file) => finish(window(Some(file))),
        _ => match Cli::try_parse_from(arguments) {
            Ok(cli) => finish(run(cli.command)),
            Err(error) => {
                let code = u8::try_from(error.exit_code()).unwrap_or(2);
                match error.print() {
                    Err(why) if code == 0 => finish(Err(Error::Output(why))),
                    // If stderr is closed there is nobody left to tell.
                    _ => ExitCode::from(code),
                }
            }
        },
    }
}

fn run(command: Command) -> Result<(), Error> {
    match command {
        Command::Grow(args) => grow::run(&args),
        Command::Film(args) => film::run(&args),
        Command::Sheet(args) => sheet::run(&args),
        Command::Import(args) => import::run(&args),
        Command::Lookup(args) => lookup::run(&args),
        Command::Measure(args) => measure::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Learn(args) => learn::run(&args),
        Command::Bench(args) => bench::run(&args),
        Command::Completions(args) => manual::completions(&args),
        Command::Man(args) => manual::man(&args),
    }
}

/// What takes the steps, where `DAPPLE_SOLVER` names it: the bits are the same, and so it is no option of a command but
/// something to test with, or to go round a processor's fault.
fn choose_solver() -> Result<(), Error> {
    let Some(name) = std::env::var_os("DAPPLE_SOLVER").filter(|name| !name.is_empty()) else { return Ok(()) };
    let name = name.to_string_lossy();
    if Solver::choose(&name) {
        return Ok(());
    }
    let names: Vec<_> = Solver::available().into_iter().map(Solver::name).collect();
    let allowed = names.join(", ");
    Err(Error::Usage(format!("DAPPLE_SOLVER: found {name}; allowed: {allowed}, which this machine has")))
}

/// Whether a lone argument is a document to open rather than a command.
fn is_document(argument: &OsString) -> bool {
    let path = Path::new(argument);
    let command = |name| Cli::command().get_subcommands().any(|command| command.get_name() == name);
    let named =
        argument.to_str().is_some_and(|name| command(name) || name == "help" || name.starts_with('-'));
    !named && (path.extension().is_some_and(|extension| extension == "dapple") || path.is_file())
}

/// Opens the window, with a document if one is named.
#[cfg(feature = "app")]
fn window(file: Option<&OsString>) -> Result<(), Error> {
    crate::app::run(file.map(Into::into)).map_err(Error::step)
}

/// Built without the window.
#[cfg(not(feature = "app"))]
fn window(file: Option<&OsString>) -> Result<(), Error> {
    say(&Cli::command().render_help().to_string())?;
    match file {
        None => Ok(()),
        Some(file) => Err(Error::NoWindow { file: file.to_string_lossy().into_owned() }),
    }
}

/// Tells how it went, once and on stderr, and gives the exit code.
fn finish(result: Result<(), Error>) -> ExitCode {
    let Err(error) = result else { return ExitCode::SUCCESS };
    if error.is_broken_pipe() {
        // Whoever reads our output, such as `head`, has seen enough.
        return ExitCode::SUCCESS;
    }
    // If stderr is closed there is nobody left to tell.
    let _ = writeln!(io::stderr(), "error: {}", with_causes(&error));
    ExitCode::from(error.exit_code())
}

/// Writes `text` to stdout; unlike `print!`, does not panic where nobody reads it.
///
/// # Errors
/// Where stdout is closed or full.
pub fn say(text: &str) -> Result<(), Error> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Error::Output)
}

/// Writes one note to stderr. Where stderr is closed the note is lost: that is no reason to fail.
fn note(text: &str) {
    let _ = writeln!(io::stderr(), "note: {text}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_commands_are_well_formed() {
        Cli::command().debug_assert();
    }
}
