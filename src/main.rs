//! The executable: passes its arguments to the command line.

fn main() -> std::process::ExitCode {
    dapple::cli::main()
}
