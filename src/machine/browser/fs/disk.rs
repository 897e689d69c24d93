//! The files and folders in memory, by path.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, PoisonError};

use crate::machine::browser::sync::{Mutex, MutexGuard};
use crate::machine::clock::SystemTime;

/// The folder that the page keeps from one visit to the next.
pub const KEPT: &str = "/kept";
/// File name endings of files that the page does not keep: incomplete ones, and locks, which hold nothing.
const FLEETING: [&str; 2] = ["part", "lock"];

/// The content of a file.
#[derive(Debug)]
pub(super) struct Content {
    pub(super) bytes: Vec<u8>,
    pub(super) modified: SystemTime,
    /// The number of the open file that holds the lock; 0 = none.
    pub(super) holder: u64,
}

/// A file or a folder at a path.
#[derive(Clone, Debug)]
pub(super) enum Node {
    Folder,
    File(Arc<Mutex<Content>>),
}

impl Node {
    /// A new file.
    pub(super) fn file(bytes: Vec<u8>) -> Self {
        Self::File(Arc::new(Mutex::new(Content { bytes, modified: SystemTime::now(), holder: 0 })))
    }
}

/// All files and folders except the root, which always exists.
#[derive(Debug)]
pub(super) struct Disk {
    nodes: BTreeMap<PathBuf, Node>,
    /// Files in [`KEPT`] that were written or deleted since the page last asked.
    changed: BTreeSet<PathBuf>,
}

static DISK: Mutex<Disk> = Mutex::new(Disk { nodes: BTreeMap::new(), changed: BTreeSet::new() });

pub(super) fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(super) fn disk() -> MutexGuard<'static, Disk> {
    locked(&DISK)
}

/// The path from the root, without `.` and `..`.
pub(super) fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::from("/");
    for part in path.components() {
        match part {
            Component::Normal(name) => normal.push(name),
            Component::ParentDir => drop(normal.pop()),
            Component::RootDir | Component::CurDir | Component::Prefix(_) => {}
        }
    }
    normal
}

/// The files in [`KEPT`] that have changed since the last call, with their content; `None` = deleted.
#[must_use]
pub fn take_changed() -> Vec<(PathBuf, Option<Vec<u8>>)> {
    let mut disk = disk();
    let changed = std::mem::take(&mut disk.changed);
    let now = |path: PathBuf| {
        let bytes = disk.file(&path).ok().map(|content| locked(&content).bytes.clone());
        (path, bytes)
    };
    changed.into_iter().map(now).collect()
}

impl Disk {
    pub(super) fn at(&self, path: &Path) -> io::Result<&Node> {
        if path == Path::new("/") {
            return Ok(&Node::Folder);
        }
        self.nodes.get(path).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    pub(super) fn file(&self, path: &Path) -> io::Result<Arc<Mutex<Content>>> {
        match self.at(path)? {
            Node::File(content) => Ok(Arc::clone(content)),
            Node::Folder => Err(io::ErrorKind::IsADirectory.into()),
        }
    }

    /// Adds a file or folder at a path.
    pub(super) fn create(&mut self, path: &Path, node: Node) -> io::Result<()> {
        if self.at(path).is_ok() {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        self.has_parent(path)?;
        self.nodes.insert(path.to_owned(), node);
        self.note(path);
        Ok(())
    }

    fn has_parent(&self, path: &Path) -> io::Result<()> {
        match self.at(path.parent().unwrap_or(Path::new("/")))? {
            Node::Folder => Ok(()),
            Node::File(_) => Err(io::ErrorKind::NotADirectory.into()),
        }
    }

    pub(super) fn remove(&mut self, path: &Path) {
        self.nodes.remove(path);
        self.note(path);
    }

    /// All files and folders in a folder and in its subfolders; `true` = a folder.
    pub(super) fn below(&self, folder: &Path) -> Vec<(PathBuf, bool)> {
        let from = self.nodes.range(folder.to_owned()..).skip_while(|(path, _)| *path == folder);
        let inside = from.take_while(|(path, _)| path.starts_with(folder));
        inside.map(|(path, node)| (path.clone(), matches!(node, Node::Folder))).collect()
    }

    /// The entries of a folder; `true` = a folder.
    pub(super) fn children(&self, folder: &Path) -> Vec<(PathBuf, bool)> {
        let mut below = self.below(folder);
        below.retain(|(path, _)| path.parent() == Some(folder));
        below
    }

    pub(super) fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()> {
        self.at(from)?;
        self.has_parent(to)?;
        if matches!(self.at(to), Ok(Node::Folder)) {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        let mut moved: Vec<PathBuf> = self.below(from).into_iter().map(|(path, _)| path).collect();
        moved.push(from.to_owned());
        for path in moved {
            let place = path.strip_prefix(from).map_or(to.to_owned(), |inside| match inside {
                inside if inside == Path::new("") => to.to_owned(),
                inside => to.join(inside),
            });
            if let Some(node) = self.nodes.remove(&path) {
                self.nodes.insert(place.clone(), node);
            }
            self.note(&path);
            self.note(&place);
        }
        Ok(())
    }

    /// Records for the page that a file is to be kept, or no longer.
    pub(super) fn note(&mut self, path: &Path) {
        let stays =
            path.extension().or(path.file_name()).is_none_or(|end| !FLEETING.iter().any(|one| end == *one));
        if stays && path.starts_with(KEPT) && !matches!(self.nodes.get(path), Some(Node::Folder)) {
            self.changed.insert(path.to_owned());
        }
    }
}
