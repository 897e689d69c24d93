//! The finish of a growth: what it cannot be combined with, and what it leaves as it is.

use super::Args;
use super::outlines;
use crate::cli::Error;
use crate::document::Document;
use crate::finish::Finish;
use crate::machine::free_memory;
use crate::synth::memory;

/// Checks the options for a document with a finish, and that a picture of `size` px fits into memory, before anything grows.
pub fn check(args: &Args, document: &Document, size: [usize; 2]) -> Result<(), Error> {
    let Some(finishing) = &document.finish else { return Ok(()) };
    let file = args.file.display();
    if args.look.transparent {
        let kind = finishing.finish.kind.name();
        return Err(Error::Usage(format!(
            "--transparent: {file} has the finish {kind}, which covers the ground too; allowed: without \"finish\" in the document"
        )));
    }
    let needed = size[0] as f64 * size[1] as f64 * Finish::BYTES_A_PX;
    memory::check_export("the finish", needed, "write a smaller picture", Some(free_memory()))
        .map_err(Error::step)
}

/// A note on what the finish does not change; `None` if the document has none, or nothing such is written.
pub fn note(args: &Args, document: &Document) -> Option<String> {
    let kind = document.finish.as_ref()?.finish.kind.name();
    let is_drawn = outlines::requested(args);
    is_drawn
        .then(|| format!("the outlines are those without the finish {kind}; --mask writes the marks with it"))
}
