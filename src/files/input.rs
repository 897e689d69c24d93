//! Opens inputs: files, standard input, and pipes, which can be read only once.

use std::collections::BTreeMap;
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::machine::fs::{self, File};

/// The bytes that were read from pipes, by path, because a command may read an input more than once.
static RECEIVED: Mutex<BTreeMap<PathBuf, Arc<[u8]>>> = Mutex::new(BTreeMap::new());
/// The most bytes that are read from a pipe: 1 GB. Some devices never end.
const MOST: u64 = 1 << 30;
/// The path that stands for standard input and output.
const STANDARD: &str = "-";

/// A file, or the bytes that were read from a pipe.
#[derive(Debug)]
pub enum Input {
    /// A file.
    File(BufReader<File>),
    /// All bytes of a pipe.
    Received(Cursor<Arc<[u8]>>),
}

/// Opens a file or a pipe, or standard input, which is called `-`. A pipe is read to its end, once: whoever opens it again gets the same
/// bytes.
///
/// # Errors
/// It cannot be read; more than 1 GB came.
pub fn input(path: &Path) -> io::Result<Input> {
    if !is_pipe(path) {
        return Ok(Input::File(BufReader::new(File::open(path)?)));
    }
    let mut all = RECEIVED.lock().unwrap_or_else(PoisonError::into_inner);
    let key = if is_standard_input(path) { PathBuf::from(STANDARD) } else { path.to_owned() };
    if let Some(bytes) = all.get(&key) {
        return Ok(Input::Received(Cursor::new(Arc::clone(bytes))));
    }
    let mut bytes = Vec::new();
    if is_standard_input(path) {
        io::stdin().lock().take(MOST + 1).read_to_end(&mut bytes)?;
    } else {
        File::open(path)?.take(MOST + 1).read_to_end(&mut bytes)?;
    }
    if bytes.len() as u64 > MOST {
        return Err(io::Error::new(io::ErrorKind::InvalidData, "more than 1 GB came through the pipe"));
    }
    let bytes: Arc<[u8]> = bytes.into();
    all.insert(key, Arc::clone(&bytes));
    Ok(Input::Received(Cursor::new(bytes)))
}

/// Whether a path stands for standard input: `-`, or the name that the system has for it.
fn is_standard_input(path: &Path) -> bool {
    path == Path::new(STANDARD) || path == Path::new("/dev/stdin") && is_pipe(path)
}

/// Whether the file at a path can be read only once: standard input, a pipe, a device.
#[must_use]
pub fn is_pipe(path: &Path) -> bool {
    let once = |there: fs::Metadata| !there.is_file() && !there.is_dir();
    path == Path::new(STANDARD) || fs::metadata(path).is_ok_and(once)
}

/// Whether a path stands for standard output: `-`, or the name that the system has for it.
#[must_use]
pub fn is_standard_output(path: &Path) -> bool {
    path == Path::new(STANDARD) || path == Path::new("/dev/stdout")
}

/// The name of a file without folder and ending; `None` of a pipe, which has none.
#[must_use]
pub fn stem(path: &Path) -> Option<String> {
    path.file_stem().filter(|_| !is_pipe(path)).map(|stem| stem.to_string_lossy().into_owned())
}

impl Read for Input {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.read(buffer),
            Self::Received(bytes) => bytes.read(buffer),
        }
    }
}

impl BufRead for Input {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        match self {
            Self::File(file) => file.fill_buf(),
            Self::Received(bytes) => bytes.fill_buf(),
        }
    }

    fn consume(&mut self, amount: usize) {
        match self {
            Self::File(file) => file.consume(amount),
            Self::Received(bytes) => bytes.consume(amount),
        }
    }
}

impl Seek for Input {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            Self::File(file) => file.seek(to),
            Self::Received(bytes) => bytes.seek(to),
        }
    }
}
