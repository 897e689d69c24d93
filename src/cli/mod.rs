//! The command line: one file for each command. Without a command it opens the window.
//!
//! Exit codes: 0 success; 1 failure (file, growth); 2 invalid usage; 130 interrupted. Results go to stdout, errors, notes and
//! progress to stderr.

mod bench;
mod check;
mod data_set;
#[cfg(test)]
mod documented;
mod error;
mod estimate;
mod film;
mod flat;
mod grow;
mod import;
mod interrupt;
mod json;
mod learn;
mod limits;
mod link;
pub mod lookup;
mod manual;
mod map_argument;
mod measure;
mod paths;
mod progress;
mod schema;
mod settings;
pub(crate) mod sheet;
mod values;

pub use error::Error;
pub use interrupt::{install, interrupted};

use crate::document::with_causes;
use crate::rd::Solver;
use clap::{Arg, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::any::TypeId;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
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
    /// Film a document while it grows, or while it changes into another one
    Film(film::Args),
    /// Grow many documents and lay their pictures out on one sheet
    Sheet(sheet::Args),
    /// Make a document from the shapes in an SVG, or from the spots or stripes in a photograph
    Import(import::Args),
    /// Look up the parameters for spots or stripes with given attributes
    Lookup(lookup::Args),
    /// Measure the spots or stripes in a picture
    Measure(measure::Args),
    /// Check a document and list its content
    Check(check::Args),
    /// Compare the training sets with other methods and with grown textures
    Learn(learn::Args),
    /// Make labelled textures of random sketches, by the thousand
    DataSet(data_set::Args),
    /// Print the JSON Schema of documents
    Schema,
    /// Print a link that holds a document
    Link(link::Args),
    /// Measure how fast this machine is
    Bench(bench::Args),
    /// Print the completion script for a shell
    Completions(manual::CompletionsArgs),
    /// Print dapple's manual page, or write those of all commands
    Man(manual::ManArgs),
}

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    let form = Form::wanted();
    if let Err(error) = choose_solver() {
        return finish(Err(error), form);
    }
    match &arguments[..] {
        [] | [_] => finish(window(None), form),
        [_, file] if is_document(file) => finish(window(Some(file)), form),
        _ => match parsed(arguments) {
            Ok(cli) => finish(run(cli.command), form),
            Err(error) => {
                let code = u8::try_from(error.exit_code()).unwrap_or(2);
                if code != 0 && form == Form::Json {
                    return failed(&error.to_string(), code, form);
                }
                match error.print() {
                    Err(why) if code == 0 => finish(Err(Error::Output(why)), form),
                    // If stderr is closed, the message is lost.
                    _ => ExitCode::from(code),
                }
            }
        },
    }
}

fn parsed(arguments: Vec<OsString>) -> Result<Cli, clap::Error> {
    let mut command = command();
    let mut matches = command.try_get_matches_from_mut(arguments)?;
    Cli::from_arg_matches_mut(&mut matches).map_err(|error| error.format(&mut command))
}

/// All commands. The value of an option that takes a number may begin with a hyphen, so that a negative number reaches
/// the parser of that option, whose error says what is allowed.
fn command() -> clap::Command {
    let names = [TypeId::of::<PathBuf>(), TypeId::of::<String>()];
    let is_name = move |arg: &Arg| names.iter().any(|name| arg.get_value_parser().type_id() == *name);
    Cli::command().mut_subcommands(move |command| {
        command.mut_args(move |arg| {
            let takes_number = arg.get_action().takes_values() && !arg.is_positional() && !is_name(&arg);
            arg.allow_hyphen_values(takes_number)
        })
    })
}

fn run(command: Command) -> Result<(), Error> {
    install();
    match command {
        Command::Grow(args) => grow::run(&args),
        Command::Film(args) => film::run(&args),
        Command::Sheet(args) => sheet::run(&args),
        Command::Import(args) => import::run(&args),
        Command::Lookup(args) => lookup::run(&args),
        Command::Measure(args) => measure::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Learn(args) => learn::run(&args),
        Command::DataSet(args) => data_set::run(&args),
        Command::Schema => schema::run(),
        Command::Link(args) => link::run(&args),
        Command::Bench(args) => bench::run(&args),
        Command::Completions(args) => manual::completions(&args),
        Command::Man(args) => manual::man(&args),
    }
}

/// Chooses the solver that the environment variable `DAPPLE_SOLVER` names. All solvers give the same bits. The variable
/// is for tests, and for avoiding a faulty processor instruction, so it is not an option of commands.
fn choose_solver() -> Result<(), Error> {
    let Some(name) = std::env::var_os("DAPPLE_SOLVER").filter(|name| !name.is_empty()) else { return Ok(()) };
    let name = name.to_string_lossy();
    if Solver::choose(&name) {
        return Ok(());
    }
    let names: Vec<_> = Solver::available().into_iter().map(Solver::name).collect();
    let allowed = names.join(", ");
    Err(Error::Usage(format!("DAPPLE_SOLVER: found {name}; allowed on this machine: {allowed}")))
}

/// Whether a single argument is a document to open or a link to one, not a command.
fn is_document(argument: &OsString) -> bool {
    let path = Path::new(argument);
    let command = |name| Cli::command().get_subcommands().any(|command| command.get_name() == name);
    let named =
        argument.to_str().is_some_and(|name| command(name) || name == "help" || name.starts_with('-'));
    !named
        && (crate::files::as_link(path).is_some()
            || path.extension().is_some_and(|extension| extension == "dapple")
            || path.exists() && !path.is_dir())
}

/// Opens the window, with a document if one is given.
#[cfg(feature = "app")]
fn window(file: Option<&OsString>) -> Result<(), Error> {
    crate::app::run(file.map(Into::into)).map_err(Error::step)
}

/// Reports that this program was built without the window.
#[cfg(not(feature = "app"))]
fn window(file: Option<&OsString>) -> Result<(), Error> {
    print(&Cli::command().render_help().to_string())?;
    match file {
        None => Ok(()),
        Some(file) => Err(Error::NoWindow { file: file.to_string_lossy().into_owned() }),
    }
}

/// How errors are written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Text,
    /// With `--json`: one object.
    Json,
}

impl Form {
    /// Whether the arguments of the process ask for JSON, even if the arguments are not valid.
    fn wanted() -> Self {
        if std::env::args_os().any(|argument| argument == "--json") { Self::Json } else { Self::Text }
    }
}

/// Writes an error to stderr, and returns the exit code. If stderr is closed, the message is lost.
fn failed(message: &str, code: u8, form: Form) -> ExitCode {
    let _ = match form {
        Form::Text => writeln!(io::stderr(), "error: {}", escaped(message)),
        Form::Json => {
            let message = message.trim_end();
            let message = message.strip_prefix("error: ").unwrap_or(message);
            writeln!(io::stderr(), "{}", serde_json::json!({"error": message, "code": code}))
        }
    };
    ExitCode::from(code)
}

/// A text for a terminal. Control characters, which file names may hold, are written as `\\u{1b}`.
fn escaped(text: &str) -> String {
    let plain =
        |c: char| if c.is_control() && c != '\n' { c.escape_default().to_string() } else { c.to_string() };
    text.chars().map(plain).collect()
}

/// Writes the error to stderr, if any, and returns the exit code.
fn finish(result: Result<(), Error>, form: Form) -> ExitCode {
    let Err(error) = result else { return ExitCode::SUCCESS };
    crate::files::remove_empty_folders();
    if matches!(error, Error::Interrupted) {
        interrupt::end();
    }
    if error.is_broken_pipe() {
        // The reader of stdout, such as `head`, has ended: this is not an error.
        return ExitCode::SUCCESS;
    }
    failed(&with_causes(&error), error.exit_code(), form)
}

/// Writes `text` to stdout. Unlike `print!` it does not panic if stdout is closed.
///
/// # Errors
/// Stdout is closed or full.
pub fn print(text: &str) -> Result<(), Error> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Error::Output)
}

/// Writes one note to stderr. Where stderr is closed the note is lost, which is not a failure.
fn note(text: &str) {
    let _ = writeln!(io::stderr(), "note: {}", escaped(text));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_of_names_are_escaped() {
        assert_eq!(escaped("a\u{1b}[2J\rb\n\u{7f}ö"), "a\\u{1b}[2J\\rb\n\\u{7f}ö");
    }

    #[test]
    fn the_commands_are_well_formed() {
        command().debug_assert();
    }
}
