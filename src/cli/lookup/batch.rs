//! A table of questions → the table with their answers.

mod form;

use super::answer::{named_parameters, system_of, worded};
use crate::attributes::{Attributes, Spots};
use crate::cli::{Error, values};
use crate::document::{Kind, SystemChoice};
use crate::learn::{line_of, shown};
use crate::marks::axial;
use crate::synth::{LookedUp, Training};
use csv::{ByteRecord, Position, Reader, ReaderBuilder, Trim, Writer, WriterBuilder};
use form::{Begun, Form, begun};
use std::io::{self, Read, Write};

/// The columns of a table of questions.
const COLUMNS: [&str; 7] = ["system", "area", "aspect", "angle", "spacing", "width", "duty"];
/// The columns that the answers add.
const ANSWERS: [&str; 10] =
    ["rate", "ratio", "stretch", "direction", "level", "pitch", "cell", "coverage", "note", "inverted"];

/// Why a table is invalid.
#[derive(Debug, PartialEq, thiserror::Error)]
pub(super) enum BatchError {
    /// It is not a valid table.
    #[error("{file}, line {line}: {problem}")]
    Table { file: String, line: u64, problem: String },
    /// Its header is wrong.
    #[error(
        "{file}, line 1: {problem}; allowed: the columns {}, in any order (others are copied), with commas or semicolons between them",
        COLUMNS.join(",")
    )]
    Columns { file: String, problem: String },
    /// A value is wrong.
    #[error("{file}, line {line}, column {column}: found '{value}'; {allowed}")]
    Value { file: String, line: u64, column: &'static str, value: String, allowed: String },
}

/// A table of questions that is read row by row.
pub(super) struct Questions<'a, R> {
    file: &'a str,
    reader: Reader<Remembering<Begun<R>>>,
    header: ByteRecord,
    /// The place of each of [`COLUMNS`] in a row.
    places: [Option<usize>; COLUMNS.len()],
    form: Form,
    /// Whether numbers have decimal commas; known once the first rows are read.
    has_commas: Option<bool>,
}

/// A row of a table of questions.
#[derive(Debug)]
pub(super) struct Question {
    record: ByteRecord,
    /// Whether its numbers have decimal commas.
    has_commas: bool,
    pub system: SystemChoice,
    /// Whether the row leaves the choice of the system open; the note then names it.
    is_open: bool,
    /// The attributes that the row asks for, px.
    pub wanted: Attributes,
}

/// A row that is being parsed.
struct Row<'a> {
    file: &'a str,
    /// The cells of [`COLUMNS`], with decimal points; those of missing columns are empty.
    cells: [String; COLUMNS.len()],
    line: u64,
}

impl<'a> Row<'a> {
    /// The cells of a row; `None` where one is not UTF-8. Other columns may hold any bytes.
    fn of(file: &'a str, line: u64, cell: impl Fn(usize) -> Option<&'a [u8]>, form: Form) -> Option<Self> {
        let mut cells: [String; COLUMNS.len()] = Default::default();
        for (column, text) in cells.iter_mut().enumerate() {
            let found = std::str::from_utf8(cell(column).unwrap_or_default()).ok()?;
            *text = if COLUMNS[column] == "system" { found.to_owned() } else { form.with_point(found) };
        }
        Some(Self { file, cells, line })
    }

    fn wrong(&self, column: &'static str, allowed: String) -> BatchError {
        BatchError::Value {
            file: self.file.to_owned(),
            line: self.line,
            column,
            value: shown(self.text(column)),
            allowed,
        }
    }

    /// The text in a column; empty if there is no such column.
    fn text(&self, column: &str) -> &str {
        let place = COLUMNS.iter().position(|name| *name == column);
        place.map_or("", |place| &self.cells[place])
    }

    fn value<T>(
        &self,
        column: &'static str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<T, BatchError> {
        parse(self.text(column)).map_err(|allowed| self.wrong(column, allowed))
    }

    fn empty(&self, columns: &[&'static str], of: &str) -> Result<(), BatchError> {
        match columns.iter().find(|column| !self.text(column).is_empty()) {
            Some(column) => Err(self.wrong(column, format!("allowed: empty, as {of} do not have it"))),
            None => Ok(()),
        }
    }

    fn question(&self, record: &ByteRecord) -> Result<Question, BatchError> {
        let asked = self.value("system", values::system)?;
        let system = asked.with_stripes_chosen(!self.text("duty").is_empty());
        let is_open = asked != system;
        let wanted = if system.grows() == Some(Kind::Line) {
            self.empty(&["area", "aspect", "spacing"], "stripes")?;
            let duty = match self.text("duty") {
                "" => None,
                _ => Some(self.value("duty", values::duty)?),
            };
            if let Some(allowed) = duty.and_then(|duty| values::duty_mismatch(duty, system)) {
                return Err(self.wrong("duty", format!("allowed: {allowed}")));
            }
            let [width, angle] =
                [self.value("width", values::positive)?, self.value("angle", values::angle)?];
            Attributes::Stripes(values::stripes(system, width, angle, duty))
        } else {
            self.empty(&["width", "duty"], "spots")?;
            let free = self.text("spacing").is_empty();
            Attributes::Spots(Spots {
                area: self.value("area", values::positive)?,
                aspect: self.value("aspect", values::aspect)?,
                angle: axial(self.value("angle", values::angle)?),
                spacing: if free { None } else { Some(self.value("spacing", values::positive)?) },
            })
        };
        Ok(Question { record: record.clone(), has_commas: false, system, is_open, wanted })
    }
}

impl Question {
    /// The row with its answer.
    pub fn answered(mut self, training: &Training) -> Result<ByteRecord, Error> {
        let looked = LookedUp::new(training, system_of(self.system), &self.wanted).map_err(Error::step)?;
        let parameters = named_parameters(&looked.parameters(), looked.pitch(), looked.cell);
        for column in ANSWERS {
            let parameter = parameters.iter().find(|(name, _)| *name == column);
            let number = |value: String| if self.has_commas { value.replace('.', ",") } else { value };
            let answer = match column {
                "coverage" => looked.coverage().to_string(),
                "note" => self.note(&looked),
                "inverted" => looked.inverted.to_string(),
                _ => parameter.map_or_else(String::new, |(_, value)| number(value.to_string())),
            };
            self.record.push_field(answer.as_bytes());
        }
        Ok(self.record)
    }

    fn note(&self, looked: &LookedUp) -> String {
        let system = self.is_open.then(|| format!("grown by {}", self.system.name()));
        let notes = worded(&looked.notes(), looked.free_spacing);
        system.into_iter().chain(notes).collect::<Vec<_>>().join("; ")
    }
}

impl<'a, R: Read> Questions<'a, R> {
    /// Reads and checks the header of a table; `file` is its name in errors.
    pub fn new(file: &'a str, input: R) -> Result<Self, Error> {
        let unreadable = |source| Error::File { file: file.to_owned(), done: "read", source };
        let (form, input) = begun(input).map_err(unreadable)?;
        let input = Remembering { input, bytes: Vec::new(), first: 0 };
        let mut reader = ReaderBuilder::new().delimiter(form.delimiter).trim(Trim::All).from_reader(input);
        let header = match reader.byte_headers() {
            Ok(header) => header.clone(),
            Err(error) => return Err(broken(file, reader.get_ref(), error)),
        };
        let wrong =
            |problem: String| Err(Error::step(BatchError::Columns { file: file.to_owned(), problem }));
        let name = |bytes: &[u8]| shown(&String::from_utf8_lossy(bytes));
        for (place, bytes) in header.iter().enumerate() {
            let is_known = COLUMNS.iter().any(|column| column.as_bytes() == bytes);
            if !is_known && COLUMNS.iter().any(|column| is_misspelt(column, bytes)) {
                return wrong(format!("found the column '{}'", name(bytes)));
            }
            if is_known && header.iter().take(place).any(|before| before == bytes) {
                return wrong(format!("found the column '{}' twice", name(bytes)));
            }
        }
        let places = COLUMNS.map(|column| header.iter().position(|bytes| bytes == column.as_bytes()));
        if places[0].is_none() {
            return wrong("the column 'system' is missing".to_owned());
        }
        Ok(Self { file, reader, header, places, form, has_commas: None })
    }

    /// Reads and checks the next rows, at most `most` of them; none at the end of the table.
    pub fn next_rows(&mut self, most: usize) -> Result<Vec<Question>, Error> {
        let Self { file, reader, places, form, .. } = self;
        let read_to = reader.position().byte();
        reader.get_mut().forget_before(read_to);
        let mut rows = Vec::with_capacity(most);
        let mut record = ByteRecord::new();
        let mut has_points = false;
        while rows.len() < most {
            match reader.read_byte_record(&mut record) {
                Ok(true) => {}
                Ok(false) => break,
                Err(error) => return Err(broken(file, reader.get_ref(), error)),
            }
            let line = form.skipped + reader.get_ref().line_of(record.position());
            let cell = |column: usize| places[column].and_then(|place| record.get(place));
            let Some(row) = Row::of(file, line, cell, *form) else {
                let problem = "it is not UTF-8 text".to_owned();
                return Err(Error::step(BatchError::Table { file: (*file).to_owned(), line, problem }));
            };
            has_points |=
                (1..COLUMNS.len()).any(|column| cell(column).is_some_and(|text| text.contains(&b'.')));
            rows.push(row.question(&record).map_err(Error::step)?);
        }
        let has_commas = *self.has_commas.get_or_insert(self.form.may_have_commas() && !has_points);
        rows.iter_mut().for_each(|row| row.has_commas = has_commas);
        Ok(rows)
    }
}

/// Whether a name is a known one with other capital letters, or with its letters in another order. Columns with any
/// other name are copied.
fn is_misspelt(column: &str, bytes: &[u8]) -> bool {
    let sorted = |bytes: &[u8]| {
        let mut letters = bytes.to_ascii_lowercase();
        letters.sort_unstable();
        letters
    };
    sorted(column.as_bytes()) == sorted(bytes)
}

/// The error of a table that cannot be read.
fn broken<R>(file: &str, input: &Remembering<R>, error: csv::Error) -> Error {
    let (line, said) = (input.line_of(error.position()), problem(&error));
    let file = file.to_owned();
    match error.into_kind() {
        csv::ErrorKind::Io(source) => Error::File { file, done: "read", source },
        _ => Error::step(BatchError::Table { file, line, problem: said }),
    }
}

/// An input whose last bytes are kept, to find lines in them.
struct Remembering<R> {
    input: R,
    bytes: Vec<u8>,
    /// The position of the first of these bytes in the input.
    first: u64,
}

impl<R> Remembering<R> {
    /// The line of a record. Empty lines may precede it.
    fn line_of(&self, position: Option<&Position>) -> u64 {
        let Some(position) = position else { return 1 };
        let mut from_here = position.clone();
        from_here.set_byte(position.byte().saturating_sub(self.first));
        line_of(&self.bytes, Some(&from_here))
    }

    /// Forgets the bytes before this place in the input.
    fn forget_before(&mut self, place: u64) {
        let known = usize::try_from(place.saturating_sub(self.first)).unwrap_or(usize::MAX);
        self.bytes.drain(..known.min(self.bytes.len()));
        self.first = place;
    }
}

impl<R: Read> Read for Remembering<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.input.read(buffer)?;
        self.bytes.extend_from_slice(&buffer[..count]);
        Ok(count)
    }
}

/// The message of the reader without the line number, with which dapple's own message begins.
fn problem(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("found {len} values; allowed: {expected_len}, as in line 1")
        }
        csv::ErrorKind::Utf8 { .. } => "it is not UTF-8 text".to_owned(),
        _ => error.to_string(),
    }
}

/// The table with the columns of the answers, written row by row.
pub(super) struct Answers<W: Write>(Writer<W>);

impl<W: Write> Answers<W> {
    /// Begins the table with the answers to `questions`, in the form of that table.
    pub fn new<R>(questions: &Questions<R>, output: W) -> Result<Self, Error> {
        let mut writer = WriterBuilder::new().delimiter(questions.form.delimiter).from_writer(output);
        let answers = ANSWERS.iter().map(|name| name.as_bytes());
        writer.write_byte_record(&questions.header.iter().chain(answers).collect()).map_err(unwritable)?;
        Ok(Self(writer))
    }

    /// Writes rows that are answered.
    pub fn write(&mut self, rows: &[ByteRecord]) -> Result<(), Error> {
        rows.iter().try_for_each(|row| self.0.write_byte_record(row)).map_err(unwritable)
    }

    /// Writes what is still buffered.
    pub fn finish(mut self) -> Result<(), Error> {
        self.0.flush().map_err(Error::Output)
    }
}

/// The error of a table that cannot be written.
fn unwritable(error: csv::Error) -> Error {
    match error.into_kind() {
        csv::ErrorKind::Io(source) => Error::Output(source),
        // All rows that are written have the same length.
        other => Error::Output(io::Error::other(format!("{other:?}"))),
    }
}

#[cfg(test)]
mod tests;
