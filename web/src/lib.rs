//! The window of dapple in a browser. The page calls these functions; `dapple::machine::browser` is the part inside the
//! program.
//!
//! ```text
//!  page.js ─▶ begin ─▶ keep (files of the last visit) ─▶ open_window ─▶ tick, next_request, … while it is shown
//!  worker.js ─▶ work
//! ```

mod failure;
mod files;
mod fonts;
mod memory;
mod pens;
mod timing;
mod widgets;

use std::cell::RefCell;

use dapple::app::{Presentation, Settings, Start, Window};
use dapple::document::link::is_link;
use dapple::machine::browser::{page, threads};
use dapple::machine::fs;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

thread_local! {
    /// The window's context, on the page's thread.
    static CONTEXT: RefCell<Option<egui::Context>> = const { RefCell::new(None) };
}

/// Called once by the page, with the number of threads that the machine runs at once, and with the bytes of memory.
#[wasm_bindgen]
pub fn begin(cores: usize, bytes: f64) {
    threads::set_cores(cores);
    memory::limit(bytes);
    alone_on_the_page();
    // This must happen before workers are used for anything else.
    threads::set_shared(0);
}

/// Makes a pool of the page's thread alone. Work that is parallel elsewhere then runs on this thread only, because it
/// must not wait for other threads.
fn alone_on_the_page() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    // The pool lives as long as the page.
    std::mem::forget(pool);
}

/// Opens the window of the page at `address`: with the document in the fragment of the address, if there is one, and
/// with the parts of the window that its query asks for. `is_tested`: [`widgets::widgets`] then returns the places of
/// the widgets.
///
/// # Errors
/// The reason why the browser cannot show the window.
#[wasm_bindgen]
pub async fn open_window(canvas: HtmlCanvasElement, address: String, is_tested: bool) -> Result<(), JsValue> {
    for folder in [page::WRITTEN, fs::KEPT] {
        fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    }
    let runner = eframe::WebRunner::new();
    failure::tell_in_words();
    let create: eframe::AppCreator<'static> = Box::new(move |cc| {
        let page = address.split('#').next().unwrap_or_default();
        let (site, query) = page.split_once('?').unwrap_or((page, ""));
        // Links that are copied here lead to this page.
        let mut settings = Settings::for_user();
        site.clone_into(&mut settings.site);
        let (link, presentation) =
            (is_link(&address).then(|| address.clone()), Presentation::of_query(query));
        // A window that is embedded in another page offers no unsaved work, and keeps none.
        let recovery = (presentation == Presentation::Full).then(|| [fs::KEPT, "recovery"].iter().collect());
        let start =
            Start { settings, link, presentation, recovery, native_dialogs: true, ..Start::default() };
        fonts::first(&cc.egui_ctx);
        pens::listen(&cc.egui_ctx);
        if is_tested {
            widgets::follow(&cc.egui_ctx);
        }
        CONTEXT.set(Some(cc.egui_ctx.clone()));
        Ok(Box::new(timing::Timed(timing::watched(|| Window::new(&cc.egui_ctx, start)))))
    });
    runner.start(canvas, eframe::WebOptions::default(), create).await?;
    // The window lives as long as the page.
    std::mem::forget(runner);
    Ok(())
}

/// Sets the training rows, which are not in the module. Before this call nothing can grow.
#[wasm_bindgen]
pub fn bring_rows(pack: &[u8]) {
    dapple::engine::learn::bring_rows(pack);
}

/// Adds a font for characters that the others lack; `scale`: its size relative to them.
#[wasm_bindgen]
pub fn add_font(name: &str, bytes: Vec<u8>, scale: f32) {
    CONTEXT.with_borrow(|context| {
        if let Some(context) = context {
            fonts::add(context, name, bytes, scale);
        }
    });
}

/// Lets the workers start: the data that they need have arrived.
#[wasm_bindgen]
pub fn open_workers() {
    threads::open();
}

/// The function that a worker calls: it does one piece of work after the other, without end.
#[wasm_bindgen]
pub fn work() {
    threads::serve();
}

/// The number of workers that are needed in addition to the idle ones.
#[wasm_bindgen]
pub fn workers_wanted() -> usize {
    threads::wanted()
}

/// Called before each frame of the browser: shows a frame if a worker has requested one.
#[wasm_bindgen]
pub fn tick() {
    if page::take_wake() {
        CONTEXT.with_borrow(|context| {
            if let Some(context) = context {
                context.request_repaint();
            }
        });
    }
}
