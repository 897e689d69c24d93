//! How the module is linked: one memory for all threads, which the page brings.

/// The most that a module can address, bytes. The page may bring less.
const MOST: u64 = 1 << 32;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    for flag in ["--shared-memory", "--import-memory", &format!("--max-memory={MOST}")] {
        println!("cargo:rustc-link-arg-cdylib={flag}");
    }
    // What each thread needs for variables of its own.
    for name in ["__wasm_init_tls", "__tls_size", "__tls_align", "__tls_base", "__heap_base"] {
        println!("cargo:rustc-link-arg-cdylib=--export={name}");
    }
}
