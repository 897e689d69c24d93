//! Messages between the program and the page. The page looks for requests several times a second.

use std::collections::{BTreeMap, VecDeque};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::PoisonError;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use super::sync::{Mutex, MutexGuard};
use super::threads::{fail_if_panicked, sleep, start};
use super::{archive, fs};

/// The folder of files that are written for the visitor.
pub const WRITTEN: &str = "/written";
/// The folder of files that the visitor has opened.
const GIVEN: &str = "/given";
/// The number of opened files that are kept; the oldest are deleted.
const REMEMBERED: u64 = 12;
/// The time between two checks for an answer.
const ASKED: Duration = Duration::from_millis(20);

/// What the program asks of the page.
#[derive(Clone, Debug)]
pub enum Request {
    /// Let the visitor choose a file with one of these endings; the answer gets this number.
    Choose(u64, &'static [&'static str]),
    /// Load the file of this name beside the page; the answer gets this number.
    Load(u64, String),
    /// Save this file where the visitor keeps files.
    Save(PathBuf),
    /// Put the picture in this file on the clipboard.
    Copy(PathBuf),
}

/// The path of a file that was chosen or loaded; `None` = no file was.
type Answer = Option<PathBuf>;

static REQUESTS: Mutex<VecDeque<Request>> = Mutex::new(VecDeque::new());
static ANSWERS: Mutex<BTreeMap<u64, Answer>> = Mutex::new(BTreeMap::new());
/// Failures outside the window, as messages.
static FAILED: Mutex<Vec<String>> = Mutex::new(Vec::new());
static DROPPED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
static AWAKE: AtomicBool = AtomicBool::new(false);
static NUMBER: AtomicU64 = AtomicU64::new(0);

fn locked<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn next_number() -> u64 {
    NUMBER.fetch_add(1, Ordering::Relaxed)
}

/// Requests a frame.
pub fn wake() {
    AWAKE.store(true, Ordering::Release);
}

/// Whether a frame was requested since the last call.
#[must_use]
pub fn take_wake() -> bool {
    AWAKE.swap(false, Ordering::AcqRel)
}

/// Sends a request to the page.
pub fn ask(request: Request) {
    locked(&REQUESTS).push_back(request);
}

/// The next request.
#[must_use]
pub fn next_request() -> Option<Request> {
    locked(&REQUESTS).pop_front()
}

/// Answers a request.
pub fn answer(number: u64, file: Option<PathBuf>) {
    locked(&ANSWERS).insert(number, file);
}

/// Waits for an answer while `is_wanted` is true. Must not be called on the page's thread.
fn wait_for(number: u64, is_wanted: &dyn Fn() -> bool) -> Answer {
    while is_wanted() {
        fail_if_panicked();
        if let Some(answer) = locked(&ANSWERS).remove(&number) {
            return answer;
        }
        sleep(ASKED);
    }
    None
}

/// Lets the visitor choose a file, and waits for the answer while `is_wanted` is true.
pub fn choose(endings: &'static [&'static str], is_wanted: &dyn Fn() -> bool) -> Option<PathBuf> {
    let number = next_number();
    ask(Request::Choose(number, endings));
    wait_for(number, is_wanted)
}

/// Lets the page save what was written: a file as it is, a folder as an archive with the name of the folder. Where the
/// archive cannot be made, the folder stays, and [`take_failed`] returns the reason.
pub fn save(path: &Path) {
    let path = path.to_owned();
    if !fs::is_dir(&path) {
        ask(Request::Save(path));
        return;
    }
    let pack = move || {
        let mut archive = path.clone().into_os_string();
        archive.push(".zip");
        match fs::File::create(&archive).and_then(|out| archive::write(&path, out)) {
            Ok(()) => {
                let _ = fs::remove_dir_all(&path);
                ask(Request::Save(archive.into()));
            }
            Err(error) => {
                let _ = fs::remove_file(&archive);
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                tell(format!(
                    "{name}: the files could not be packed into a ZIP ({error}), and are not downloaded. They stay in memory \
                     until the page is closed: close other pages, or export fewer or smaller pictures, and export again."
                ));
            }
        }
    };
    // Cannot fail: the page starts as many threads as are needed.
    let _ = start("packing", pack);
}

/// Reports a failure outside the window, to be shown in the window.
pub fn tell(why: String) {
    locked(&FAILED).push(why);
    wake();
}

/// Failures outside the window since the last call, as messages.
#[must_use]
pub fn take_failed() -> Vec<String> {
    std::mem::take(&mut locked(&FAILED))
}

/// The bytes of a file. A file that was written for the visitor is then deleted.
///
/// # Errors
/// There is no such file.
pub fn take(path: &Path) -> io::Result<Vec<u8>> {
    let bytes = fs::read(path)?;
    if path.starts_with(WRITTEN) {
        fs::remove_file(path)?;
    }
    Ok(bytes)
}

/// The bytes of a file beside the page.
///
/// # Errors
/// It cannot be loaded.
pub fn load(name: &str) -> io::Result<Vec<u8>> {
    let number = next_number();
    ask(Request::Load(number, name.to_owned()));
    let path = wait_for(number, &|| true)
        .ok_or_else(|| io::Error::other(format!("{name} could not be loaded: is there a connection?")))?;
    let bytes = fs::read(&path);
    let _ = fs::remove_file(&path);
    bytes
}

/// Stores a file that the visitor opens or the page loads in memory; returns its path.
///
/// # Errors
/// It is too large.
pub fn give(name: &str, bytes: Vec<u8>) -> io::Result<PathBuf> {
    let number = next_number();
    if let Some(old) = number.checked_sub(REMEMBERED) {
        let _ = fs::remove_dir_all(Path::new(GIVEN).join(old.to_string()));
    }
    let folder = Path::new(GIVEN).join(number.to_string());
    fs::create_dir_all(&folder)?;
    let name = Path::new(name).file_name().unwrap_or("file".as_ref());
    let path = folder.join(name);
    fs::put(&path, bytes)?;
    Ok(path)
}

/// Passes on a file that was dropped or pasted.
pub fn drop_file(path: PathBuf) {
    locked(&DROPPED).push(path);
    wake();
}

/// The files that were dropped or pasted since the last call.
#[must_use]
pub fn take_dropped() -> Vec<PathBuf> {
    std::mem::take(&mut locked(&DROPPED))
}
