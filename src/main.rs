//! The front door: hands the arguments to the command line.

fn main() -> std::process::ExitCode {
    dapple::cli::main()
}
