//! Why a command could not do what was asked.

use crate::document::DocumentError;
use crate::export::ExportError;
use crate::synth::GrowError;
use std::io;
use std::path::PathBuf;

/// Why a command could not do what was asked.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The document.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Stdout is closed or full.
    #[error("standard output: cannot be written")]
    Output(#[source] io::Error),
    /// A file other than a document cannot be read or written.
    #[error("{file}: cannot be {done}")]
    File {
        /// The file.
        file: String,
        /// `read` or `written`.
        done: &'static str,
        /// What the system said.
        source: io::Error,
    },
    /// Arguments that contradict each other.
    #[error("{0}")]
    Usage(String),
    /// What is read would be written over.
    #[error("{name} and {output}: found {file} twice; allowed: two files", file = file.display())]
    WriteOver {
        /// What the file that is read is called in the usage.
        name: String,
        /// The option that names what is written.
        output: &'static str,
        /// The file.
        file: PathBuf,
    },
    /// It was built without the window.
    #[cfg(not(feature = "app"))]
    #[error("{file}: this dapple was built without its window; allowed: dapple grow {file} -o OUT.png")]
    NoWindow {
        /// The document.
        file: String,
    },
    /// Some pictures of a sheet were not grown.
    #[error("{} of {all} pictures were not grown; {sheet} says why in their places:\n  {}", why.len(), why.join("\n  "))]
    Tiles {
        /// The sheet, which was written.
        sheet: String,
        /// Pictures that it has places for.
        all: usize,
        /// One line for each that is missing.
        why: Vec<String>,
    },
    /// Some documents of a batch were not grown.
    #[error("{} of {all} pictures were not grown:\n  {}", why.len(), why.join("\n  "))]
    Batch {
        /// Pictures that were asked for.
        all: usize,
        /// One line for each that is missing.
        why: Vec<String>,
    },
    /// Ctrl-C.
    #[error("interrupted")]
    Interrupted,
    /// A step said why.
    #[error(transparent)]
    Step(Box<dyn std::error::Error + Send + Sync>),
}

impl Error {
    /// Wraps what a step said.
    pub fn step(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self::Step(error.into())
    }

    /// Wraps why nothing was grown.
    #[must_use]
    pub fn grown(error: GrowError) -> Self {
        if matches!(error, GrowError::Cancelled(_)) { Self::Interrupted } else { Self::step(error) }
    }

    /// Wraps why a picture was not written.
    #[must_use]
    pub fn exported(error: ExportError) -> Self {
        if matches!(error, ExportError::Cancelled { .. }) { Self::Interrupted } else { Self::step(error) }
    }

    /// 1 could not; 2 used wrongly; 130 interrupted.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Interrupted => 130,
            _ => 1,
        }
    }

    /// Whether the reader of our output went away.
    #[must_use]
    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Output(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }

    /// The message and those of its causes, on one line.
    #[must_use]
    pub fn with_causes(&self) -> String {
        let mut text = self.to_string();
        let mut cause = std::error::Error::source(self);
        while let Some(error) = cause {
            let said = error.to_string();
            // A transparent or a repeating error is not said twice.
            if !text.ends_with(&said) {
                text = format!("{text}: {said}");
            }
            cause = error.source();
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_are_told_in_order() {
        let source = io::Error::other("disk full");
        let error = Error::File { file: "a".into(), done: "written", source };
        assert_eq!(error.with_causes(), "a: cannot be written: disk full");
    }
}
