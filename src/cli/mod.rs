//! The command line: one file a command.

pub mod measure;

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> std::process::ExitCode {
    std::process::ExitCode::SUCCESS
}
