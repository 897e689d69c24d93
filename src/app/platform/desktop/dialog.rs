//! The dialogs of the system.

use std::path::{Path, PathBuf};

use crate::app::purpose::Purpose;
use crate::editor::folder::{self, Kind};
use crate::editor::task::{StartError, Task, Tasks, Worker};

/// Whether the system has a dialog that chooses a file to read, or (`true`) one to write. On Linux it needs the session bus; without one
/// the call returns at once.
#[must_use]
pub fn has_dialog_to(_: bool) -> bool {
    if !cfg!(target_os = "linux") {
        return true;
    }
    let bus = || Some(PathBuf::from(std::env::var_os("XDG_RUNTIME_DIR")?).join("bus"));
    std::env::var_os("DBUS_SESSION_BUS_ADDRESS").is_some() || bus().is_some_and(|bus| bus.exists())
}

/// Starts the system's dialog.
///
/// # Errors
/// Where no thread can be started.
pub fn system_dialog(
    purpose: Purpose,
    folder: &Path,
    name: &str,
    tasks: &Tasks,
) -> Result<Task<Option<PathBuf>>, StartError> {
    let dialog = rfd::FileDialog::new().set_title(purpose.title()).set_file_name(name);
    let dialog = match purpose.endings() {
        [] => dialog,
        endings => dialog.add_filter(endings[0], endings),
    };
    let (folder, name) = (folder.to_owned(), name.to_owned());
    tasks.start("the file dialog", move |worker: &Worker<_>| {
        let dialog = dialog.set_directory(folder::resolved(&folder));
        worker.send(match purpose {
            // Where the chosen folder is not empty, a new folder inside it is used.
            Purpose::ExportInto => dialog.pick_folder().map(|picked| {
                let is_empty = folder::kind(&picked) == Kind::EmptyFolder;
                if is_empty { picked } else { picked.join(&name) }
            }),
            _ if purpose.writes() => dialog.save_file(),
            _ => dialog.pick_file(),
        });
    })
}
