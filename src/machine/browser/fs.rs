//! Files in memory, because a browser gives programs no file system. The page adds the files that a visitor opens and
//! takes the exported ones. It keeps the files in [`KEPT`] from one visit to the next.

mod disk;
mod file;

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};

pub use disk::{KEPT, take_changed};
use disk::{Node, disk, normal};
pub use file::{File, OpenOptions, TryLockError};

use crate::machine::clock::SystemTime;

/// Permissions of a file: everyone may use it.
#[derive(Clone, Debug)]
pub struct Permissions;

impl Permissions {
    /// Files can always be written.
    #[must_use]
    pub fn readonly(&self) -> bool {
        false
    }
}

/// Whether an entry is a file or a folder.
#[derive(Clone, Copy, Debug)]
pub struct FileType {
    is_dir: bool,
}

impl FileType {
    /// A folder.
    #[must_use]
    pub fn is_dir(&self) -> bool {
        self.is_dir
    }

    /// A file.
    #[must_use]
    pub fn is_file(&self) -> bool {
        !self.is_dir
    }
}

/// Properties of a file or folder.
#[derive(Clone, Debug)]
pub struct Metadata {
    kind: FileType,
    len: u64,
    modified: SystemTime,
}

impl Metadata {
    /// A folder.
    #[must_use]
    pub fn is_dir(&self) -> bool {
        self.kind.is_dir()
    }

    /// A file.
    #[must_use]
    pub fn is_file(&self) -> bool {
        self.kind.is_file()
    }

    /// The length of the file in bytes; 0 for a folder.
    #[expect(clippy::len_without_is_empty, reason = "it is called as the standard library calls it")]
    #[must_use]
    pub fn len(&self) -> u64 {
        self.len
    }

    /// The time at which it was written.
    ///
    /// # Errors
    /// None.
    pub fn modified(&self) -> io::Result<SystemTime> {
        Ok(self.modified)
    }

    /// The permissions, which are the same for all files.
    #[must_use]
    pub fn permissions(&self) -> Permissions {
        Permissions
    }
}

/// An entry of a folder.
#[derive(Debug)]
pub struct DirEntry {
    path: PathBuf,
    kind: FileType,
}

impl DirEntry {
    /// Its path.
    #[must_use]
    pub fn path(&self) -> PathBuf {
        self.path.clone()
    }

    /// Its name.
    #[must_use]
    pub fn file_name(&self) -> OsString {
        self.path.file_name().unwrap_or_default().to_owned()
    }

    /// Whether it is a file or a folder.
    ///
    /// # Errors
    /// None.
    pub fn file_type(&self) -> io::Result<FileType> {
        Ok(self.kind)
    }
}

/// Whether there is a file or folder at `path`.
#[must_use]
pub fn exists(path: impl AsRef<Path>) -> bool {
    metadata(path).is_ok()
}

/// Whether a folder is at `path`.
#[must_use]
pub fn is_dir(path: impl AsRef<Path>) -> bool {
    metadata(path).is_ok_and(|there| there.is_dir())
}

/// The properties of the file or folder at `path`.
///
/// # Errors
/// There is no file or folder.
pub fn metadata(path: impl AsRef<Path>) -> io::Result<Metadata> {
    let disk = disk();
    Ok(match disk.at(&normal(path.as_ref()))? {
        Node::Folder => {
            Metadata { kind: FileType { is_dir: true }, len: 0, modified: SystemTime::UNIX_EPOCH }
        }
        Node::File(content) => {
            let content = disk::locked(content);
            let len = content.bytes.len() as u64;
            Metadata { kind: FileType { is_dir: false }, len, modified: content.modified }
        }
    })
}

/// All bytes of a file.
///
/// # Errors
/// The file is missing, or is a folder.
pub fn read(path: impl AsRef<Path>) -> io::Result<Vec<u8>> {
    let content = disk().file(&normal(path.as_ref()))?;
    let bytes = disk::locked(&content).bytes.clone();
    Ok(bytes)
}

/// The text of a file.
///
/// # Errors
/// The file is missing, is a folder, or is not UTF-8.
pub fn read_to_string(path: impl AsRef<Path>) -> io::Result<String> {
    String::from_utf8(read(path)?).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))
}

/// Writes a file.
///
/// # Errors
/// Its folder is missing, or a folder has this path.
pub fn write(path: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    io::Write::write_all(&mut File::create(path)?, bytes.as_ref())
}

/// Makes a file of these bytes, without copying them.
///
/// # Errors
/// Its folder is missing, or a file or folder has this path already.
pub fn put(path: impl AsRef<Path>, bytes: Vec<u8>) -> io::Result<()> {
    disk().create(&normal(path.as_ref()), Node::file(bytes))
}

/// Makes a folder.
///
/// # Errors
/// Its parent is missing, or a file or folder has this path already.
pub fn create_dir(path: impl AsRef<Path>) -> io::Result<()> {
    disk().create(&normal(path.as_ref()), Node::Folder)
}

/// Makes a folder and its missing parents.
///
/// # Errors
/// A file has this path, or that of a parent.
pub fn create_dir_all(path: impl AsRef<Path>) -> io::Result<()> {
    let path = normal(path.as_ref());
    let mut missing: Vec<&Path> = path.ancestors().take_while(|folder| !is_dir(*folder)).collect();
    missing.reverse();
    missing.into_iter().try_for_each(create_dir)
}

/// The entries of a folder.
///
/// # Errors
/// There is no such folder.
pub fn read_dir(path: impl AsRef<Path>) -> io::Result<impl Iterator<Item = io::Result<DirEntry>>> {
    let path = normal(path.as_ref());
    if !metadata(&path)?.is_dir() {
        return Err(io::ErrorKind::NotADirectory.into());
    }
    let entries = disk().children(&path);
    let entry = |(path, is_dir)| Ok(DirEntry { path, kind: FileType { is_dir } });
    Ok(entries.into_iter().map(entry))
}

/// Deletes a file.
///
/// # Errors
/// The file is missing, or is a folder.
pub fn remove_file(path: impl AsRef<Path>) -> io::Result<()> {
    let (path, mut disk) = (normal(path.as_ref()), disk());
    disk.file(&path)?;
    disk.remove(&path);
    Ok(())
}

/// Deletes an empty folder.
///
/// # Errors
/// The folder is missing, is a file, or is not empty.
pub fn remove_dir(path: impl AsRef<Path>) -> io::Result<()> {
    let (path, mut disk) = (normal(path.as_ref()), disk());
    match disk.at(&path)? {
        Node::File(_) => return Err(io::ErrorKind::NotADirectory.into()),
        Node::Folder if !disk.children(&path).is_empty() => {
            return Err(io::ErrorKind::DirectoryNotEmpty.into());
        }
        Node::Folder => {}
    }
    disk.remove(&path);
    Ok(())
}

/// Deletes a folder with all that is in it.
///
/// # Errors
/// The folder is missing.
pub fn remove_dir_all(path: impl AsRef<Path>) -> io::Result<()> {
    let (path, mut disk) = (normal(path.as_ref()), disk());
    disk.at(&path)?;
    for (path, _) in disk.below(&path) {
        disk.remove(&path);
    }
    disk.remove(&path);
    Ok(())
}

/// Renames a file or a folder; a file with the new name is replaced.
///
/// # Errors
/// It is missing, the folder of the new path is missing, or a folder has the new name.
pub fn rename(from: impl AsRef<Path>, to: impl AsRef<Path>) -> io::Result<()> {
    disk().rename(&normal(from.as_ref()), &normal(to.as_ref()))
}

/// The absolute path of the file or folder at `path`.
///
/// # Errors
/// There is no file or folder.
pub fn canonicalize(path: impl AsRef<Path>) -> io::Result<PathBuf> {
    let path = normal(path.as_ref());
    disk().at(&path)?;
    Ok(path)
}
