//! Ctrl-C (also SIGTERM, SIGHUP): the program stops within half a second, and leaves no incomplete file.

use super::Error;
use crate::files;
use crate::machine::threads;
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;

/// The time that the work has to stop by itself. After that the program ends in any case.
const GRACE: Duration = Duration::from_millis(150);

static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// The flag that Ctrl-C sets; long work checks it and stops.
///
/// After the first call of this function, the program ends within a sixth of a second after Ctrl-C, and at once after a
/// second Ctrl-C. All calls return the same flag.
pub fn install() -> Arc<AtomicBool> {
    let flag = FLAG.get_or_init(|| {
        let flag = Arc::new(AtomicBool::new(false));
        let seen = Arc::clone(&flag);
        // If no handler can be set, Ctrl-C ends the program as usual.
        let _ = ctrlc::set_handler(move || {
            if seen.swap(true, Ordering::SeqCst) {
                end();
            }
            // Where no thread can be started, the program ends at once.
            let waits = threads::start("ending", || {
                threads::sleep(GRACE);
                end();
            });
            if waits.is_err() {
                end();
            }
        });
        flag
    });
    Arc::clone(flag)
}

/// Ends the program: deletes its unfinished files, reports the interruption, and exits.
pub fn end() -> ! {
    static ENDING: Mutex<()> = Mutex::new(());
    // A second caller waits for the program to end.
    let _first = ENDING.lock().unwrap_or_else(PoisonError::into_inner);
    files::abandon();
    let mut stderr = io::stderr();
    // The message overwrites the progress bar of a terminal. If stderr is closed, it is lost.
    let _ = write!(stderr, "{}", if stderr.is_terminal() { "\r\x1b[K" } else { "" });
    super::failed(&Error::Interrupted.to_string(), Error::Interrupted.exit_code(), super::Form::wanted());
    std::process::exit(Error::Interrupted.exit_code().into())
}

/// Whether Ctrl-C was pressed since [`install`].
#[must_use]
pub fn interrupted() -> bool {
    FLAG.get().is_some_and(|flag| flag.load(Ordering::SeqCst))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_calls_return_the_same_flag() {
        assert!(Arc::ptr_eq(&install(), &install()));
        assert!(!interrupted());
    }
}
