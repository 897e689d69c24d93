//! Runs work that cannot be interrupted on a separate thread.

use std::io;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use crate::export::Stopped;
use crate::export::web::Work;

use super::threads;

/// The time between two checks whether to continue.
const ASKED: Duration = Duration::from_millis(50);

/// Does `work` on a separate thread, and asks `goes_on` meanwhile whether to continue. If not, this returns without
/// waiting; the thread ends by itself when the work is done.
///
/// # Errors
/// The errors of the work and of `goes_on`; or no thread can be started.
pub fn aside(work: Work, goes_on: &mut dyn FnMut() -> Result<(), Stopped>) -> Result<Vec<u8>, Stopped> {
    let (done, finished) = mpsc::channel();
    threads::start("encoding a WebP", move || {
        // Where the work was cancelled, nobody receives the result.
        let _ = done.send(work());
    })?;
    loop {
        goes_on()?;
        match finished.recv_timeout(ASKED) {
            Ok(encoded) => return Ok(encoded?),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                return Err(io::Error::other("the WebP encoder has ended early").into());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_that_is_not_cancelled_gives_its_result() {
        assert_eq!(aside(Box::new(|| Ok(vec![7])), &mut || Ok(())).unwrap(), [7]);
        let failed = aside(Box::new(|| Err(io::Error::other("no"))), &mut || Ok(()));
        assert!(matches!(failed, Err(Stopped::Io(error)) if error.to_string() == "no"));
        let ended = aside(Box::new(|| panic!("a bug in the encoder")), &mut || Ok(()));
        assert!(matches!(ended, Err(Stopped::Io(error)) if error.to_string().contains("ended early")));
    }

    #[test]
    fn work_that_is_cancelled_is_not_waited_for() {
        let (end, ended) = mpsc::channel::<()>();
        let work: Work = Box::new(move || {
            // This lasts until the test has ended.
            let _ = ended.recv();
            Ok(Vec::new())
        });
        let mut asked = 0;
        let stopped = aside(work, &mut || {
            asked += 1;
            if asked == 3 { Err(Stopped::Cancelled) } else { Ok(()) }
        });
        assert!(matches!(stopped, Err(Stopped::Cancelled)));
        drop(end);
    }
}
