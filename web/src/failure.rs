//! Shows errors of the program to the visitor.

use std::panic::{set_hook, take_hook};

use dapple::machine::browser::threads;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Shows an error to the visitor. Both the page and the workers provide this function.
    #[wasm_bindgen(js_namespace = globalThis, js_name = dappleFailed)]
    fn failed(text: &str);
}

/// Makes a thread panic, for tests: the page's thread, or a worker.
///
/// # Panics
/// Always, on that thread.
#[wasm_bindgen]
pub fn fail(on_page: bool) {
    let failing = || panic!("a test lets this thread fail");
    if on_page {
        failing();
    }
    // Cannot fail: the page starts as many workers as are needed.
    let _ = threads::start("failing", failing);
}

/// Shows the message of every panic, on whatever thread it happens. The window stops only if the page's thread has
/// panicked.
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
