//! The program: all of it stands in the library, where tests reach it.

fn main() -> std::process::ExitCode {
    data_gen::main()
}
