//! Open files.

use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::Permissions;
use super::disk::{Content, Node, disk, locked, normal};
use crate::machine::browser::sync::Mutex;
use crate::machine::clock::SystemTime;

pub use std::fs::TryLockError;

/// An open file.
#[derive(Debug)]
pub struct File {
    content: Arc<Mutex<Content>>,
    path: PathBuf,
    at: AtomicU64,
    /// Its number among all open files.
    number: u64,
    is_written: AtomicBool,
}

/// The number of the next file that is opened; 0 is none.
static NEXT: AtomicU64 = AtomicU64::new(1);

/// How a file is opened.
#[derive(Clone, Copy, Debug, Default)]
pub struct OpenOptions {
    create: bool,
    create_new: bool,
    truncate: bool,
}

impl OpenOptions {
    /// Options that open an existing file.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Every file can be read.
    pub fn read(&mut self, _: bool) -> &mut Self {
        self
    }

    /// Every file can be written.
    pub fn write(&mut self, _: bool) -> &mut Self {
        self
    }

    /// Whether a missing file is made.
    pub fn create(&mut self, create: bool) -> &mut Self {
        self.create = create;
        self
    }

    /// Whether the file must be new.
    pub fn create_new(&mut self, create_new: bool) -> &mut Self {
        self.create_new = create_new;
        self
    }

    /// Whether the file is emptied.
    pub fn truncate(&mut self, truncate: bool) -> &mut Self {
        self.truncate = truncate;
        self
    }

    /// Opens a file.
    ///
    /// # Errors
    /// The file is missing, or exists although it must be new; or it is a folder.
    pub fn open(&self, path: impl AsRef<Path>) -> io::Result<File> {
        let (path, mut disk) = (normal(path.as_ref()), disk());
        if self.create_new || self.create && disk.at(&path).is_err() {
            disk.create(&path, Node::file(Vec::new()))?;
        }
        let content = disk.file(&path)?;
        if self.truncate {
            locked(&content).bytes.clear();
            disk.note(&path);
        }
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        Ok(File { content, path, at: AtomicU64::new(0), number, is_written: AtomicBool::new(false) })
    }
}

impl File {
    /// Opens a file to read it.
    ///
    /// # Errors
    /// The file is missing, or is a folder.
    pub fn open(path: impl AsRef<Path>) -> io::Result<Self> {
        OpenOptions::new().open(path)
    }

    /// Opens a file to write it from the beginning.
    ///
    /// # Errors
    /// Its folder is missing, or a folder has this path.
    pub fn create(path: impl AsRef<Path>) -> io::Result<Self> {
        OpenOptions::new().create(true).truncate(true).open(path)
    }

    /// Takes the lock, which is held until the file is dropped.
    ///
    /// # Errors
    /// Another open file holds it.
    pub fn try_lock(&self) -> Result<(), TryLockError> {
        let mut content = locked(&self.content);
        if content.holder != 0 && content.holder != self.number {
            return Err(TryLockError::WouldBlock);
        }
        content.holder = self.number;
        Ok(())
    }

    /// Tells the page that the file was written. The bytes themselves are there at once.
    ///
    /// # Errors
    /// None.
    pub fn sync_all(&self) -> io::Result<()> {
        disk().note(&self.path);
        Ok(())
    }

    /// Does nothing: everyone may use every file.
    ///
    /// # Errors
    /// None.
    pub fn set_permissions(&self, _: Permissions) -> io::Result<()> {
        Ok(())
    }
}

impl Read for &File {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let content = locked(&self.content);
        let at = (self.at.load(Ordering::Relaxed) as usize).min(content.bytes.len());
        let count = bytes.len().min(content.bytes.len() - at);
        bytes[..count].copy_from_slice(&content.bytes[at..at + count]);
        self.at.store((at + count) as u64, Ordering::Relaxed);
        Ok(count)
    }
}

impl Write for &File {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut content = locked(&self.content);
        let at = self.at.load(Ordering::Relaxed) as usize;
        if content.bytes.len() < at {
            content.bytes.resize(at, 0);
        }
        let replaced = bytes.len().min(content.bytes.len() - at);
        content.bytes[at..at + replaced].copy_from_slice(&bytes[..replaced]);
        content.bytes.try_reserve(bytes.len() - replaced).map_err(|_| io::ErrorKind::StorageFull)?;
        content.bytes.extend_from_slice(&bytes[replaced..]);
        content.modified = SystemTime::now();
        self.is_written.store(true, Ordering::Relaxed);
        self.at.store((at + bytes.len()) as u64, Ordering::Relaxed);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for &File {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let end = locked(&self.content).bytes.len() as u64;
        let (from, by) = match to {
            SeekFrom::Start(at) => (at, 0),
            SeekFrom::End(by) => (end, by),
            SeekFrom::Current(by) => (self.at.load(Ordering::Relaxed), by),
        };
        let at = from.checked_add_signed(by).ok_or(io::ErrorKind::InvalidInput)?;
        self.at.store(at, Ordering::Relaxed);
        Ok(at)
    }
}

impl Read for File {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        (&*self).read(bytes)
    }
}

impl Write for File {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        (&*self).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for File {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        (&*self).seek(to)
    }
}

impl Drop for File {
    /// Releases the lock. A file that was written without [`File::sync_all`] is kept as well.
    fn drop(&mut self) {
        let mut content = locked(&self.content);
        if content.holder == self.number {
            content.holder = 0;
        }
        drop(content);
        if self.is_written.load(Ordering::Relaxed) {
            disk().note(&self.path);
        }
    }
}
