//! The executable. All of its code is in the library, where tests can call it.

fn main() -> std::process::ExitCode {
    data_gen::main()
}
