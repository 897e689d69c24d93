//! Recovery files: each window has one, `ID.dapple`, and a lock `ID.lock` that it holds while it is open. A file whose
//! lock is free belongs to a window that has crashed.

use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use super::format::{self, Backup};
use crate::document::{Document, io_in_words, limits};
use crate::editor::file_lock::{self, Lock};
use crate::editor::session::Session;
use crate::export::ExportError;
use crate::files::{self, ReadFile};
use crate::machine::clock::{SystemTime, UNIX_EPOCH};
use crate::machine::fs::{self, File, OpenOptions};
use crate::marks::Mark;

/// Age at which a half-written file is deleted, seconds.
const STALE: u64 = 600;
/// Most bytes of the header.
const MAX_HEADER: u64 = 65_536;

/// The recovery file of an open window.
#[derive(Debug)]
pub struct BackupFile {
    file: PathBuf,
    /// `None` where the file system has no locks.
    lock: Option<File>,
}

/// An unsaved document of a window that has crashed.
#[derive(Debug)]
pub struct LostDocument {
    /// The document.
    pub backup: Backup,
    /// The time at which it was written.
    pub when: SystemTime,
    /// Its marks, with their layers.
    pub marks: Vec<(usize, Mark)>,
    /// Whether the document's own file was written after that.
    pub file_is_newer: bool,
    /// Whether the document's own file cannot be found.
    pub file_is_gone: bool,
    /// What the document's own file holds, where it can be read.
    pub saved: Option<Document>,
    pub(super) file: BackupFile,
}

/// The result of [`find`].
#[derive(Debug, Default)]
pub struct Found {
    /// The lost documents, the latest first.
    pub lost: Vec<LostDocument>,
    /// Files that could not be read: messages for the user.
    pub errors: Vec<String>,
}

impl BackupFile {
    /// A new recovery file in `folder`, which is created where it is missing.
    ///
    /// # Errors
    /// Where the folder cannot be made or written.
    pub fn new(folder: &Path) -> io::Result<Self> {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        fs::create_dir_all(folder)?;
        let _folder_lock = file_lock::wait_for(&folder.join("lock"));
        let millis = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_millis());
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let file = folder.join(format!("{millis}-{}-{number}.dapple", crate::machine::process()));
            let lock_file = file.with_extension("lock");
            match OpenOptions::new().write(true).create_new(true).open(&lock_file) {
                Ok(_) => {}
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
                Err(error) => return Err(error),
            }
            let lock = if let Lock::Held(lock) = file_lock::try_lock(&lock_file) { Some(lock) } else { None };
            return Ok(Self { file, lock });
        }
    }

    /// Writes a backup. Afterwards the file holds the whole backup, or, after an error, its earlier content.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn write(&self, backup: &Backup) -> Result<(), ExportError> {
        let text = format::write(backup, SystemTime::now());
        files::save(&self.file, |out| Ok(out.write_all(text.as_bytes())?))?;
        if let Some(folder) = self.file.parent().and_then(|folder| File::open(folder).ok()) {
            // The name must also be on the disk; not every system supports this.
            let _ = folder.sync_all();
        }
        Ok(())
    }

    /// The name by which the backup is known while the program runs.
    #[must_use]
    pub fn id(&self) -> String {
        self.file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Deletes the backup; the window goes on using the file.
    ///
    /// # Errors
    /// Where deleting is not permitted.
    pub fn clear(&self) -> io::Result<()> {
        match fs::remove_file(&self.file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            outcome => outcome,
        }
    }
}

impl Drop for BackupFile {
    /// Releases the lock. The content of the file is now a lost document; if there is none, no file is left.
    fn drop(&mut self) {
        self.lock = None;
        if !fs::exists(&self.file) {
            let _ = fs::remove_file(self.file.with_extension("lock"));
        }
    }
}

impl LostDocument {
    /// The name by which it is known while the program runs.
    #[must_use]
    pub fn id(&self) -> String {
        self.file.id()
    }

    /// Deletes the lost document.
    ///
    /// # Errors
    /// Where deleting is not permitted.
    pub fn delete(self) -> io::Result<()> {
        self.file.clear()
    }
}

/// Looks for lost documents in `folder`. Other windows do not find these documents until they are dropped here.
#[must_use]
pub fn find(folder: &Path) -> Found {
    let mut found = Found::default();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    let _folder_lock = file_lock::wait_for(&folder.join("lock"));
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.sort();
    for file in &files {
        match file.extension().and_then(|ending| ending.to_str()) {
            Some("dapple") => look_at(file, &mut found),
            Some("lock") if !fs::exists(file.with_extension("dapple")) => {
                // Its window ended without unsaved work.
                if let Lock::Held(lock) = file_lock::try_lock(file) {
                    drop(lock);
                    let _ = fs::remove_file(file);
                }
            }
            Some("part") if age(file).is_some_and(|age| age > STALE) => drop(fs::remove_file(file)),
            _ => {}
        }
    }
    found.lost.sort_by_key(|lost| std::cmp::Reverse(lost.when));
    found
}

fn look_at(file: &Path, found: &mut Found) {
    let lock = match file_lock::try_lock(&file.with_extension("lock")) {
        Lock::Held(lock) => Some(lock),
        Lock::Busy => return,
        Lock::Unsupported => None,
    };
    let backup_file = BackupFile { file: file.to_owned(), lock };
    match read(file) {
        Ok((mut backup, when)) => {
            if let Some(path) = &backup.path {
                files::read_heights(&mut backup.document, path);
            }
            let saved = backup.path.as_deref().and_then(|path| Document::read(path).ok());
            if saved.as_ref() == Some(&backup.document) {
                // The window was killed after saving and before deleting the backup: nothing was lost.
                let _ = backup_file.clear();
                return;
            }
            let metadata = backup.path.as_deref().map(fs::metadata);
            let file_is_gone = matches!(metadata, Some(Err(_)));
            let modified = metadata.and_then(|metadata| metadata.ok()?.modified().ok());
            let file_is_newer = modified.is_some_and(|modified| modified > when);
            let session = Session::open(backup.document.clone(), None);
            let marks = session.marks().map(|(place, mark)| (place.layer, mark)).collect();
            let file = backup_file;
            found.lost.push(LostDocument { backup, when, marks, file_is_newer, file_is_gone, saved, file });
        }
        Err(why) => {
            let aside = file.with_extension("damaged");
            let kept = match fs::rename(file, &aside) {
                Ok(()) => format!("it was renamed to {}", aside.display()),
                Err(error) => format!("it could not be renamed: {}", io_in_words(&error)),
            };
            found.errors.push(format!(
                "The unsaved work of an earlier session cannot be read: {}: {why}; {kept}",
                file.display()
            ));
        }
    }
}

fn read(file: &Path) -> Result<(Backup, SystemTime), String> {
    let mut bytes = Vec::new();
    let open = File::open(file).map_err(|error| error.to_string())?;
    let read = open.take(limits::MAX_FILE + MAX_HEADER).read_to_end(&mut bytes);
    read.map_err(|error| error.to_string())?;
    let text = String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_owned())?;
    format::read(&text)
}

/// Seconds since the file was written.
fn age(file: &Path) -> Option<u64> {
    Some(fs::metadata(file).ok()?.modified().ok()?.elapsed().ok()?.as_secs())
}
