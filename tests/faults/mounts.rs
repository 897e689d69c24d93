//! File systems that are small or read-only. Only root may mount them; otherwise a test prints SKIPPED.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::bench::say;

/// A file system of 1 MB in memory, which is unmounted when this is dropped.
pub struct Mounted(PathBuf);

impl Mounted {
    /// Creates `folder` and mounts the file system there. `None` if that is not permitted, which is reported on stderr;
    /// with `DAPPLE_MUST_MOUNT` set, the test fails then.
    pub fn on(folder: &Path) -> Option<Self> {
        fs::create_dir_all(folder).unwrap();
        if mount(&["-t", "tmpfs", "-o", "size=1m", "tmpfs"], folder) {
            return Some(Self(folder.to_owned()));
        }
        let test = std::thread::current().name().unwrap_or_default().to_owned();
        assert!(std::env::var_os("DAPPLE_MUST_MOUNT").is_none(), "{test}: mount is not permitted");
        say(&format!("SKIPPED {test}: mount is not permitted; run it as root"));
        None
    }

    /// Fills the file system, except for `blocks` blocks of 4096 bytes.
    pub fn fill(&self, blocks: usize) {
        let mut filler = fs::File::create(self.0.join("filler")).unwrap();
        while filler.write_all(&[7; 4096]).is_ok() {}
        let length = filler.metadata().unwrap().len() / 4096 * 4096;
        filler.set_len(length - 4096 * blocks as u64).unwrap();
    }

    /// Deletes the file that fills it.
    #[cfg(feature = "app")]
    pub fn make_room(&self) {
        fs::remove_file(self.0.join("filler")).unwrap();
    }

    /// Makes the file system read-only.
    pub fn protect(&self) {
        assert!(mount(&["-o", "remount,ro"], &self.0), "it was mounted");
    }
}

impl Drop for Mounted {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg("-l").arg(&self.0).status();
    }
}

fn mount(options: &[&str], folder: &Path) -> bool {
    let mounted = Command::new("mount").args(options).arg(folder).output();
    mounted.is_ok_and(|output| output.status.success())
}
