//! What a window keeps beside the files it was opened from: one slot a window, `ID.dapple` with a lock `ID.lock` that
//! the living window holds. A slot whose lock is free was lost.
//!
//! ```text
//! dapple recovery 1
//! when 1732200000123        milliseconds since 1970
//! file /home/me/tiger.dapple    left out where it never was saved
//! name tiger.dapple
//!
//! {"format": "dapple", …
//! ```

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use crate::app::Session;
use crate::document::{Document, limits};
use crate::editor::file_lock;
use crate::editor::path_encoding;
use crate::export;
use crate::marks::Mark;

const HEAD: &str = "dapple recovery 1";
/// After that, half a file that somebody began to write is rubbish, seconds.
const STALE: u64 = 600;

/// What is kept.
#[derive(Clone, Debug)]
pub struct Kept {
    /// The document.
    pub document: Document,
    /// Where it was saved before.
    pub path: Option<PathBuf>,
    /// What people call it.
    pub name: String,
}

/// The slot of a living window.
#[derive(Debug)]
pub struct Slot {
    file: PathBuf,
    /// `None` where the file system knows no locks.
    _lock: Option<File>,
}

/// What a window that is no more had kept.
#[derive(Debug)]
pub struct Lost {
    /// What it had kept.
    pub kept: Kept,
    /// When, as far as the clock was right.
    pub when: SystemTime,
    /// Its marks, with their layers.
    pub marks: Vec<(usize, Mark)>,
    /// Was its file written after that?
    pub file_is_newer: bool,
    slot: Slot,
}

/// What was found: what was lost, and what has to be said.
#[derive(Debug, Default)]
pub struct Found {
    /// The latest first.
    pub lost: Vec<Lost>,
    /// Slots that could not be read.
    pub troubles: Vec<String>,
}

impl Slot {
    /// A new one in `folder`, which is made where it is missing.
    ///
    /// # Errors
    /// Where the folder cannot be made or written.
    pub fn new(folder: &Path) -> io::Result<Self> {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        fs::create_dir_all(folder)?;
        let _all = file_lock::wait_for(&folder.join("lock"));
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let file = folder.join(format!("{}-{}-{number}.dapple", millis(), std::process::id()));
            let beside = file.with_extension("lock");
            match OpenOptions::new().write(true).create_new(true).open(&beside) {
                Ok(_) => {}
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
                Err(error) => return Err(error),
            }
            let file_lock::Lock::Held(held) = file_lock::try_lock(&beside) else {
                return Ok(Self { file, _lock: None });
            };
            return Ok(Self { file, _lock: Some(held) });
        }
    }

    /// Writes what is kept: all of it is there afterwards, or what was there before.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn write(&self, kept: &Kept) -> Result<(), export::ExportError> {
        let mut text = format!("{HEAD}\nwhen {}\n", millis());
        if let Some(path) = &kept.path {
            let path = std::path::absolute(path).unwrap_or_else(|_| path.clone());
            text.push_str(&format!("file {}\n", path_encoding::told(&path)));
        }
        text.push_str(&format!("name {}\n\n", path_encoding::told(Path::new(&kept.name))));
        text.push_str(&kept.document.to_json());
        export::save(&self.file, |out| Ok(out.write_all(text.as_bytes())?))?;
        if let Some(folder) = self.file.parent().and_then(|folder| File::open(folder).ok()) {
            // The name too shall be on the disk; not every system can be asked for that.
            let _ = folder.sync_all();
        }
        Ok(())
    }

    /// What it is called.
    #[must_use]
    pub fn id(&self) -> String {
        self.file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Takes away what is kept; the slot stays ours.
    ///
    /// # Errors
    /// Where that is not permitted.
    pub fn clear(&self) -> io::Result<()> {
        match fs::remove_file(&self.file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            outcome => outcome,
        }
    }

    /// Gives it back: what is kept stays, and was lost.
    fn give_up(&mut self) {
        self._lock = None;
        if !self.file.exists() {
            let _ = fs::remove_file(self.file.with_extension("lock"));
        }
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        self.give_up();
    }
}

impl Lost {
    /// What it is called.
    #[must_use]
    pub fn id(&self) -> String {
        self.slot.id()
    }

    /// Forgets it for good.
    ///
    /// # Errors
    /// Where that is not permitted.
    pub fn remove(self) -> io::Result<()> {
        self.slot.clear()
    }
}

/// Looks for what was lost in `folder`. What is found is ours until it is dropped: no other window finds it too.
#[must_use]
pub fn find(folder: &Path) -> Found {
    let mut found = Found::default();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    let _all = file_lock::wait_for(&folder.join("lock"));
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.sort();
    for file in &files {
        match file.extension().and_then(|ending| ending.to_str()) {
            Some("dapple") => look_at(file, &mut found),
            Some("lock") if !file.with_extension("dapple").exists() => {
                // Its window went without having anything to keep.
                if let file_lock::Lock::Held(held) = file_lock::try_lock(file) {
                    drop(held);
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
    let held = match file_lock::try_lock(&file.with_extension("lock")) {
        file_lock::Lock::Held(held) => Some(held),
        file_lock::Lock::Busy => return,
        file_lock::Lock::Unsupported => None,
    };
    let slot = Slot { file: file.to_owned(), _lock: held };
    match read(file) {
        Ok((kept, when)) => {
            let modified = kept.path.as_deref().and_then(|path| fs::metadata(path).ok()?.modified().ok());
            let on_disk = kept.path.as_deref().and_then(|path| Document::read(path).ok());
            if on_disk.as_ref() == Some(&kept.document) {
                // It was killed between saving and forgetting: nothing was lost.
                let _ = slot.clear();
                return;
            }
            let session = Session::open(kept.document.clone(), None);
            let marks = session.marks().map(|(place, mark)| (place.layer, mark)).collect();
            let file_is_newer = modified.is_some_and(|modified| modified > when);
            found.lost.push(Lost { kept, when, marks, file_is_newer, slot });
        }
        Err(why) => {
            let aside = file.with_extension("damaged");
            let kept = match fs::rename(file, &aside) {
                Ok(()) => format!("it is kept aside as {}", aside.display()),
                Err(error) => format!("it could not be put aside: {error}"),
            };
            found.troubles.push(format!("What was kept of an earlier session is damaged ({why}); {kept}"));
        }
    }
}

fn read(file: &Path) -> Result<(Kept, SystemTime), String> {
    let mut bytes = Vec::new();
    let open = File::open(file).map_err(|error| error.to_string())?;
    let read = open.take(limits::MAX_FILE + 65_536).read_to_end(&mut bytes);
    read.map_err(|error| error.to_string())?;
    let text = String::from_utf8(bytes).map_err(|_| "it is no text".to_owned())?;
    let (head, document) = text.split_once("\n\n").ok_or("it ends too early")?;
    let mut lines = head.lines();
    match lines.next() {
        Some(HEAD) => {}
        Some(newer) if newer.starts_with("dapple recovery ") => {
            return Err("a newer dapple wrote it".to_owned());
        }
        _ => return Err("it has no head".to_owned()),
    }
    let (mut when, mut path, mut name) = (UNIX_EPOCH, None, String::new());
    for (key, value) in lines.filter_map(|line| line.split_once(' ')) {
        match key {
            "when" => {
                let millis = value.parse().map_err(|_| "it has no time".to_owned())?;
                // A time that the clock does not know is no reason to lose a sketch.
                when = UNIX_EPOCH.checked_add(Duration::from_millis(millis)).unwrap_or(UNIX_EPOCH);
            }
            "file" => path = Some(path_encoding::read(value)),
            "name" => name = path_encoding::read(value).to_string_lossy().into_owned(),
            _ => {}
        }
    }
    let document = Document::parse(document, "what was kept").map_err(|error| error.to_string())?;
    Ok((Kept { document, path, name }, when))
}

fn millis() -> u128 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_millis())
}

/// Seconds since it was written.
fn age(file: &Path) -> Option<u64> {
    Some(fs::metadata(file).ok()?.modified().ok()?.elapsed().ok()?.as_secs())
}

#[cfg(test)]
mod tests;
