//! The window of dapple in a browser. The page calls what is here; `dapple::machine::browser` is the other side.
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

/// To be called once, on the page: the number of threads that the machine runs at once, and how many bytes of memory there are.
#[wasm_bindgen]
pub fn begin(cores: usize, bytes: f64) {
    threads::set_cores(cores);
    memory::limit(bytes);
    alone_on_the_page();
    // Before anything else is asked of workers.
    threads::set_shared(0);
}

/// Makes the page's thread a pool of its own. What is done in parallel elsewhere it then does alone: it must not wait for others.
fn alone_on_the_page() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    // It lives as long as the page.
    std::mem::forget(pool);
}

/// Opens the window of the page at `address`: with the document in its fragment, if there is one, and with as much of the window as its
/// query asks for. `is_tested`: [`widgets::widgets`] tells where its widgets are.
///
/// # Errors
/// The browser cannot show it: why.
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
        // Links that are copied here lead here.
        let mut settings = Settings::for_user();
        site.clone_into(&mut settings.site);
        let (link, presentation) =
            (is_link(&address).then(|| address.clone()), Presentation::of_query(query));
        // A frame in a page of others offers nobody's unsaved work, and keeps none.
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
    // It lives as long as the page.
    std::mem::forget(runner);
    Ok(())
}

/// Brings the training rows, which are not in the module. Nothing can grow before.
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

/// Lets the workers begin: what they need is there.
#[wasm_bindgen]
pub fn open_workers() {
    threads::open();
}

/// What a worker calls: it does one piece of work after the other, without end.
#[wasm_bindgen]
pub fn work() {
    threads::serve();
}

/// The number of workers that are wanted beside those that have nothing to do.
#[wasm_bindgen]
pub fn workers_wanted() -> usize {
    threads::wanted()
}

/// To be called before each frame of the browser: shows a frame where a worker has asked for one.
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
