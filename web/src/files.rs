//! Files between the page and the program.

use std::path::{Path, PathBuf};

use dapple::machine::browser::page::{self, Request};
use dapple::machine::fs;
use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::*;

/// A request of the program to the page.
#[wasm_bindgen]
pub struct Asked(Request);

#[wasm_bindgen]
impl Asked {
    /// The kind of the request: `choose`, `load`, `save` or `copy`.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn what(&self) -> String {
        let what = match self.0 {
            Request::Choose(..) => "choose",
            Request::Load(..) => "load",
            Request::Save(..) => "save",
            Request::Copy(..) => "copy",
        };
        what.to_owned()
    }

    /// The allowed endings, as `.png,.jpg`; the name of the file to load; or the path of the file to save or copy.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn name(&self) -> String {
        match &self.0 {
            Request::Choose(_, endings) => {
                endings.iter().map(|ending| format!(".{ending}")).collect::<Vec<_>>().join(",")
            }
            Request::Load(_, name) => name.clone(),
            Request::Save(path) | Request::Copy(path) => path.to_string_lossy().into_owned(),
        }
    }

    /// The number that the answer must have.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn number(&self) -> f64 {
        match self.0 {
            Request::Choose(number, _) | Request::Load(number, _) => number as f64,
            Request::Save(_) | Request::Copy(_) => 0.0,
        }
    }
}

/// The next request.
#[wasm_bindgen]
#[must_use]
pub fn next_request() -> Option<Asked> {
    page::next_request().map(Asked)
}

/// Answers a request with a file; without bytes there is no file.
#[wasm_bindgen]
pub fn answer(number: f64, name: &str, bytes: Option<Vec<u8>>) {
    page::answer(number as u64, bytes.and_then(|bytes| page::give(name, bytes).ok()));
}

/// Reports an error in the page, to be shown in the window.
#[wasm_bindgen]
pub fn tell(why: String) {
    page::tell(why);
}

/// Passes a file that was dropped or pasted to the window.
///
/// # Errors
/// Where the file does not fit into memory.
#[wasm_bindgen]
pub fn drop_file(name: &str, bytes: Vec<u8>) -> Result<(), JsValue> {
    page::drop_file(page::give(name, bytes).map_err(|error| error.to_string())?);
    Ok(())
}

/// The bytes of a file that is to be saved.
///
/// # Errors
/// Where there is no such file.
#[wasm_bindgen]
pub fn take_written(path: &str) -> Result<Vec<u8>, JsValue> {
    page::take(Path::new(path)).map_err(|error| error.to_string().into())
}

/// The kept files that have changed since the last call: path and bytes; `undefined` = deleted.
#[wasm_bindgen]
#[must_use]
pub fn take_changed() -> Array {
    let pair = |(path, bytes): (PathBuf, Option<Vec<u8>>)| {
        let bytes = bytes.map_or(JsValue::UNDEFINED, |bytes| Uint8Array::from(&bytes[..]).into());
        Array::of2(&path.to_string_lossy().as_ref().into(), &bytes)
    };
    fs::take_changed().into_iter().map(pair).collect()
}

/// Restores a file that was kept from an earlier visit.
///
/// # Errors
/// Where the file does not fit into memory.
#[wasm_bindgen]
pub fn keep(path: &str, bytes: Vec<u8>) -> Result<(), JsValue> {
    let path = Path::new(path);
    let folder = path.parent().unwrap_or(Path::new("/"));
    let put = fs::create_dir_all(folder).and_then(|()| fs::put(path, bytes));
    put.map_err(|error| error.to_string().into())
}
