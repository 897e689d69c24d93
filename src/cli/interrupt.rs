//! Ctrl-C: the first asks the program to stop, the second ends it at once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

/// Exit code of a program ended by Ctrl-C: 128 + SIGINT.
const EXIT_CODE: i32 = 130;

static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// The flag that Ctrl-C (also SIGTERM, SIGHUP) sets; long work checks it, stops and cleans up.
///
/// From the first call on, a second Ctrl-C ends the program at once with exit code 130. All calls return the same flag.
pub fn install() -> Arc<AtomicBool> {
    let flag = FLAG.get_or_init(|| {
        let flag = Arc::new(AtomicBool::new(false));
        let seen = Arc::clone(&flag);
        // If no handler can be set, Ctrl-C ends the program as usual.
        let _ = ctrlc::set_handler(move || {
            if seen.swap(true, Ordering::SeqCst) {
                std::process::exit(EXIT_CODE);
            }
        });
        flag
    });
    Arc::clone(flag)
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
