//! The command line through the real program: documents in; pictures, outlines, films, tables and reports out.

mod batch;
mod command_line;
mod data_set;
mod examples;
mod grow;
mod idle;
mod inputs;
mod learn;
mod motion;
mod numbers;
mod outlines;
mod photos;
mod pictures;
mod reach;
mod scripting;
mod sheet;

/// The pictures or documents to try, of several that test the same thing: one out of `of`, or all of them where
/// `DAPPLE_ALL` is set (`.ci/property`).
fn some<T>(all: impl IntoIterator<Item = T>, of: usize) -> Vec<T> {
    let step = if std::env::var_os("DAPPLE_ALL").is_some() { 1 } else { of };
    all.into_iter().step_by(step).collect()
}
