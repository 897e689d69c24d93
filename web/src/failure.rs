//! Errors in the program are told in words.

use std::panic::{set_hook, take_hook};

use dapple::machine::browser::threads;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Tells the visitor; both the page and the workers have it.
    #[wasm_bindgen(js_namespace = globalThis, js_name = dappleFailed)]
    fn failed(text: &str);
}

/// Lets a thread fail, for tests: the page's, or a worker.
///
/// # Panics
/// Always, on that thread.
#[wasm_bindgen]
pub fn fail(on_page: bool) {
    let failing = || panic!("a test lets this thread fail");
    if on_page {
        failing();
    }
    // The page starts as many workers as are wanted.
    let _ = threads::start("failing", failing);
}

/// Lets every panic tell what it was, on whatever thread. What is shown stops only where the page's thread has failed.
pub fn tell_in_words() {
    let of_the_window = take_hook();
    set_hook(Box::new(move |info| {
        threads::note_panic();
        failed(&info.to_string());
        if threads::is_page() {
            of_the_window(info);
        }
    }));
}
