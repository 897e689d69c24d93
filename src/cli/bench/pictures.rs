//! The time from a document to its picture, measured with `dapple grow`.

use super::check_interrupt;
use super::kernels::{Effort, Pools, median, seconds};
use crate::cli::{Cli, Command, Error, grow};
use crate::document::Document;
use crate::files::TemporaryFolder;
use clap::Parser;
use std::ffi::OsString;
use std::path::Path;

/// A built-in document.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// Its name.
    pub name: &'static str,
    /// Its file.
    pub text: &'static str,
}

/// Spots that vary in all attributes, stripes whose direction changes, and large marks.
pub const EXAMPLES: [Example; 3] = [
    Example { name: "cheetah-run", text: include_str!("../../../examples/cheetah-run.dapple") },
    Example { name: "zebra", text: include_str!("../../../examples/zebra.dapple") },
    Example { name: "ladybird", text: include_str!("../../../examples/ladybird.dapple") },
];

impl Example {
    /// Such as `picture/zebra`.
    pub fn label(&self) -> String {
        format!("picture/{}", self.name)
    }
}

/// The measurement of one document.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Its name.
    pub document: &'static str,
    /// Width and height, px.
    pub size: [u32; 2],
    /// Median time from reading the document to the written picture, on all threads, seconds.
    pub seconds: f64,
}

/// A folder for documents and their pictures; it is deleted when dropped.
pub struct Folder(TemporaryFolder);

impl Folder {
    /// A new folder.
    pub fn new() -> Result<Self, Error> {
        TemporaryFolder::new().map(Self).map_err(Error::step)
    }

    /// The arguments with which `dapple grow` makes a picture of `example` here, on a canvas of `side` × `side` px.
    pub fn grow_args(&self, example: &Example, side: Option<usize>) -> Result<grow::Args, Error> {
        let file = |ending: &str| self.0.path().join(format!("{}.{ending}", example.name));
        let document = file("dapple");
        let unwritable =
            |source| Error::File { file: document.display().to_string(), done: "written", source };
        std::fs::write(&document, example.text).map_err(unwritable)?;
        let args = grow_args(&document, &file("png"))?;
        Ok(grow::Args { size: side.map(|side| [side as u32; 2]), ..args })
    }
}

/// Measures the duration of `dapple grow`, without the start of the program.
///
/// # Errors
/// [`Error::Interrupted`]; the errors of `grow`.
pub fn measure(example: &Example, folder: &Folder, pools: &Pools, effort: Effort) -> Result<Picture, Error> {
    let size = Document::parse(example.text, example.name)?.size;
    let args = folder.grow_args(example, None)?;
    let mut times = Vec::with_capacity(effort.pictures);
    for _ in 0..effort.pictures {
        check_interrupt()?;
        let mut grown = Ok(());
        times.push(seconds(|| grown = pools.run(|| grow::run(&args))));
        grown?;
    }
    Ok(Picture { document: example.name, size, seconds: median(times) })
}

/// The arguments of `grow` for this document and picture; all others have their defaults.
fn grow_args(document: &Path, picture: &Path) -> Result<grow::Args, Error> {
    let words: [OsString; 6] = [
        "dapple".into(),
        "grow".into(),
        document.into(),
        "--output".into(),
        picture.into(),
        "--quiet".into(),
    ];
    match Cli::try_parse_from(words).map_err(Error::step)?.command {
        Command::Grow(args) => Ok(*args),
        _ => Err(Error::Usage("grow: is another command".to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_are_valid_and_grow_takes_them() {
        for example in EXAMPLES {
            Document::parse(example.text, example.name).expect("an example is valid");
        }
        let args = grow_args(Path::new("a b.dapple"), Path::new("a b.png")).expect("two names are enough");
        assert_eq!((args.file, args.output), ("a b.dapple".into(), Some("a b.png".into())));
    }
}
