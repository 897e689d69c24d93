//! The form of a table: the separators between its cells, and the decimal signs in its numbers.

use std::io::{self, BufRead, BufReader, Chain, Cursor, Read};

/// A table whose beginning has been read.
pub(super) type Begun<R> = Chain<Cursor<Vec<u8>>, BufReader<R>>;

/// The most bytes in which the first line is looked for.
const LONGEST: u64 = 1 << 20;

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Form {
    /// The separator between cells: a comma, a semicolon or a tab.
    pub delimiter: u8,
    /// Lines before the header.
    pub skipped: u64,
}

impl Form {
    /// Whether numbers may have decimal commas.
    pub fn may_have_commas(self) -> bool {
        self.delimiter != b','
    }

    /// A number whose only comma is replaced by a decimal point.
    pub fn with_point(self, text: &str) -> String {
        let is_decimal = self.may_have_commas() && text.matches(',').count() == 1 && !text.contains('.');
        if is_decimal { text.replace(',', ".") } else { text.to_owned() }
    }
}

/// Finds the form of a table by its first line: the header, or `sep=;` before it, as Excel writes it.
pub(super) fn begun<R: Read>(input: R) -> io::Result<(Form, Begun<R>)> {
    let mut rest = BufReader::new(input);
    let mut line = Vec::new();
    rest.by_ref().take(LONGEST).read_until(b'\n', &mut line)?;
    let start = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&line).trim_ascii();
    let form = match start {
        [b's' | b'S', b'e' | b'E', b'p' | b'P', b'=', delimiter] => {
            let delimiter = *delimiter;
            line.clear();
            Form { delimiter, skipped: 1 }
        }
        header => {
            let count = |byte: &u8| header.iter().filter(|other| *other == byte).count();
            // Where both are equally frequent, the comma.
            let delimiter = [b'\t', b';', b','].into_iter().max_by_key(count).unwrap_or(b',');
            Form { delimiter, skipped: 0 }
        }
    };
    Ok((form, Cursor::new(line).chain(rest)))
}
