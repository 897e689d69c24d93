//! A WebAssembly module that takes a document and returns the files of `dapple grow`. It can be called from node or
//! from a page.
//!
//! ```text
//!  room(n) ─▶ n bytes are written there ─▶ grow() ─▶ files(), then of each: name, start, length
//! ```
//!
//! Only one thread calls. Where `grow` returns 1, the only file is `error`, a text; where `grow` traps, that text gives
//! the reason.

mod grown;

use std::cell::RefCell;
use std::panic;

use grown::{Written, error};

thread_local! {
    /// The document that is read and the files that were written.
    static EXCHANGE: RefCell<Exchange> = const { RefCell::new(Exchange { document: Vec::new(), files: Vec::new() }) };
}

struct Exchange {
    document: Vec<u8>,
    files: Vec<Written>,
}

/// Makes room for a document with this number of bytes, and returns the address.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    panic::set_hook(Box::new(|panic| keep(vec![error(&panic.to_string())])));
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.document = vec![0; bytes];
        exchange.document.as_mut_ptr()
    })
}

/// Grows the document. Returns 0, or 1 where the document cannot be grown.
#[unsafe(no_mangle)]
pub extern "C" fn grow() -> u32 {
    let document = EXCHANGE.with_borrow_mut(|exchange| std::mem::take(&mut exchange.document));
    let grown = grown::files(&document);
    let failed = u32::from(grown.is_err());
    keep(grown.unwrap_or_else(|why| vec![error(&why)]));
    failed
}

/// The number of files that were written.
#[unsafe(no_mangle)]
pub extern "C" fn files() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.files.len())
}

/// The address of a file.
#[unsafe(no_mangle)]
pub extern "C" fn start(file: usize) -> *const u8 {
    EXCHANGE.with_borrow(|exchange| exchange.files[file].bytes.as_ptr())
}

/// The length of a file, bytes.
#[unsafe(no_mangle)]
pub extern "C" fn length(file: usize) -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.files[file].bytes.len())
}

/// The kind of a file: 0 an error, 1 the picture, 2 the pattern, 3 the model with its values.
#[unsafe(no_mangle)]
pub extern "C" fn kind(file: usize) -> u32 {
    EXCHANGE.with_borrow(|exchange| exchange.files[file].kind as u32)
}

fn keep(files: Vec<Written>) {
    EXCHANGE.with_borrow_mut(|exchange| exchange.files = files);
}
