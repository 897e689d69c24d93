//! Errors of training sets.

use std::path::PathBuf;

/// The reason why a training set could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum TrainingError {
    /// A file or folder could not be opened.
    #[error("{}: cannot be read (a folder of training sets holds SYSTEM.csv or SYSTEM-*.csv for each system, as data-gen writes them)", path.display())]
    Open {
        /// The file or folder.
        path: PathBuf,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// A folder has no file of this system.
    #[error(
        "{}: holds no rows of {system}: neither {system}.csv nor {system}-*.csv, as data-gen writes them; it has rows of \
         {}: let the document name one of these as its system, or add the missing ones", dir.display(), listed(others)
    )]
    NoFiles {
        /// The folder.
        dir: PathBuf,
        /// The system.
        system: String,
        /// The systems whose rows it has.
        others: Vec<&'static str>,
    },
    /// The file does not agree with its manifest.
    #[error(
        "{file}: {problem}; sweep again with data-gen, or remove this file to learn from the rows as they are"
    )]
    Manifest {
        /// The manifest.
        file: String,
        /// The problem.
        problem: String,
    },
    /// The file is not a CSV table.
    #[error("{file}, line {line}: {problem}")]
    Table {
        /// The file.
        file: String,
        /// Its line, from 1.
        line: u64,
        /// The message of the CSV reader.
        problem: String,
    },
    /// A column is missing, unknown or repeated.
    #[error("{file}, line 1: {problem}; the columns are {columns}, in any order")]
    Columns {
        /// The file.
        file: String,
        /// The column and its problem.
        problem: String,
        /// The columns of this set.
        columns: String,
    },
    /// A value is not allowed in its column.
    #[error("{file}, line {line}, column {column}: '{value}' is not {allowed}")]
    Value {
        /// The file.
        file: String,
        /// Its line, from 1.
        line: u64,
        /// The column's name.
        column: &'static str,
        /// The value.
        value: String,
        /// The allowed values.
        allowed: &'static str,
    },
    /// Too few rows to learn from.
    #[error("{file}: {rows} rows are too few to learn from; at least {needed} are needed")]
    TooFew {
        /// The file.
        file: String,
        /// The rows it has.
        rows: usize,
        /// The rows it needs.
        needed: usize,
    },
    /// A row to be written is not one of this system.
    #[error("row {index} (seed {seed}) cannot be written to {system}: {problem}")]
    Row {
        /// The row's place, from 0.
        index: usize,
        /// The row's seed.
        seed: u64,
        /// The set it was for.
        system: &'static str,
        /// The problem.
        problem: String,
    },
    /// The rows could not be written.
    #[error("the rows cannot be written: {0}")]
    Write(#[from] std::io::Error),
}

fn listed(systems: &[&'static str]) -> String {
    if systems.is_empty() { "no system".to_owned() } else { systems.join(", ") }
}
