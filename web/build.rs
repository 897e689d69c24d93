//! Linker options of the module: all threads share one memory, which the page creates.

/// The most memory that a module can address, bytes. The page may create less.
const MOST: u64 = 1 << 32;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    for flag in ["--shared-memory", "--import-memory", &format!("--max-memory={MOST}")] {
        println!("cargo:rustc-link-arg-cdylib={flag}");
    }
    // Symbols that each thread needs for its own variables.
    for name in ["__wasm_init_tls", "__tls_size", "__tls_align", "__tls_base", "__heap_base"] {
        println!("cargo:rustc-link-arg-cdylib=--export={name}");
    }
}
