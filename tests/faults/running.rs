//! A running program, and waiting for its end with a time limit.

use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// A program that runs.
pub struct Running {
    pub child: Child,
    /// Nothing is sent on this channel; it is closed together with the standard output of the program.
    ended: Receiver<()>,
}

impl Running {
    /// Starts it; its standard output is read and dropped.
    pub fn start(command: &mut Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut output = child.stdout.take().unwrap();
        let (open, ended) = channel::<()>();
        std::thread::spawn(move || {
            let _ = std::io::copy(&mut output, &mut std::io::sink());
            drop(open);
        });
        Self { child, ended }
    }

    /// Waits for the end of the program, at most for `time`. Returns whether it has ended.
    pub fn ends_within(&self, time: Duration) -> bool {
        self.ended.recv_timeout(time) == Err(RecvTimeoutError::Disconnected)
    }
}
