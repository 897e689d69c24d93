//! Errors of commands.

use crate::document::DocumentError;
use crate::export::ExportError;
use crate::files::is_standard_output;
use crate::synth::GrowError;
use std::io;
use std::path::PathBuf;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The document is invalid or cannot be read.
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
        /// The system's error.
        source: io::Error,
    },
    /// Invalid or contradictory arguments.
    #[error("{0}")]
    Usage(String),
    /// An output would overwrite an input.
    #[error("{name} and {output}: found {file} twice; allowed: two files", file = file.display())]
    WriteOver {
        /// The name of the input in the usage.
        name: String,
        /// The option that names the output.
        output: &'static str,
        /// The file.
        file: PathBuf,
    },
    /// The program was built without the window.
    #[cfg(not(feature = "app"))]
    #[error("{file}: this dapple was built without the window; use: dapple grow {file} -o OUT.png")]
    NoWindow {
        /// The document is invalid or cannot be read.
        file: String,
    },
    /// Some pictures of a sheet were not grown.
    #[error("{} of {all} pictures were not grown; {sheet} shows the reasons in their places:\n  {}", why.len(), why.join("\n  "))]
    Tiles {
        /// The sheet, which was written.
        sheet: String,
        /// Number of pictures on the sheet.
        all: usize,
        /// One line for each missing picture.
        why: Vec<String>,
    },
    /// Some documents of a batch were not grown.
    #[error("{} of {all} pictures were not grown:\n  {}", why.len(), why.join("\n  "))]
    Batch {
        /// Number of requested pictures.
        all: usize,
        /// One line for each missing picture.
        why: Vec<String>,
    },
    /// Ctrl-C.
    #[error("interrupted")]
    Interrupted,
    /// The error of a step.
    #[error(transparent)]
    Step(Box<dyn std::error::Error + Send + Sync>),
}

impl Error {
    /// Wraps the error of a step.
    pub fn step(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self::Step(error.into())
    }

    /// Wraps the error of a growth.
    #[must_use]
    pub fn grown(error: GrowError) -> Self {
        if matches!(error, GrowError::Cancelled(_)) { Self::Interrupted } else { Self::step(error) }
    }

    /// Wraps the error of an export.
    #[must_use]
    pub fn exported(error: ExportError) -> Self {
        if matches!(error, ExportError::Cancelled { .. }) { Self::Interrupted } else { Self::step(error) }
    }

    /// 1 failed; 2 invalid usage; 130 interrupted.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) | Self::WriteOver { .. } => 2,
            Self::Interrupted => 130,
            _ => 1,
        }
    }

    /// Whether the reader of standard output has closed it.
    #[must_use]
    pub fn is_broken_pipe(&self) -> bool {
        let closed = |error: &io::Error| error.kind() == io::ErrorKind::BrokenPipe;
        match self {
            Self::Output(error) => closed(error),
            // A picture or a document that was to be written to standard output.
            Self::Step(error) => error.downcast_ref().is_some_and(
                |error| matches!(error, ExportError::Io { path, source } if closed(source) && is_standard_output(path)),
            ),
            Self::Document(DocumentError::Unwritable(ExportError::Io { path, source })) => {
                closed(source) && is_standard_output(path)
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::with_causes;

    #[test]
    fn causes_follow_in_order() {
        let source = io::Error::other("disk full");
        let error = Error::File { file: "a".into(), done: "written", source };
        assert_eq!(with_causes(&error), "a: cannot be written: disk full");
    }
}
