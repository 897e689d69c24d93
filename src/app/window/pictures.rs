//! Pictures that a layer follows.

use std::path::Path;

use super::Window;
use crate::document::ToneImage;
use crate::editor::picture_use::PictureUse;
use crate::editor::reading::{self, ReadingTone};

/// A picture that is being read, and what for.
pub struct ReadingPicture {
    wanted: PictureUse,
    /// Position and name of the layer that it is for.
    layer: (usize, String),
    task: ReadingTone,
}

impl Window {
    /// Reads a picture for the active layer; where it cannot be read, the layer stays as it is.
    pub(super) fn open_picture(&mut self, path: &Path, wanted: PictureUse) {
        let layer = self.session.active_layer;
        match reading::read_tone(path, &self.tasks) {
            Ok(task) => {
                let layer = (layer, self.session.layer_name(layer));
                self.files.picture = Some(ReadingPicture { wanted, layer, task });
            }
            Err(error) => self.notices.wrong(error.to_string()),
        }
    }

    /// Receives a picture that was read.
    pub(super) fn listen_to_picture(&mut self) {
        let Some(reading) = &mut self.files.picture else { return };
        let read = reading.task.poll();
        if read.is_none() && !reading.task.has_ended() {
            return;
        }
        let Some(ReadingPicture { wanted, layer: (layer, name), .. }) = self.files.picture.take() else {
            return;
        };
        match read {
            None => self
                .notices
                .wrong("Reading the picture failed because of an error in dapple. Please report it."),
            Some(Err(why)) => self.notices.wrong(why),
            Some(Ok(image)) if self.session.layer_name(layer) == name => {
                self.follow_picture(layer, wanted, image);
            }
            Some(Ok(_)) => {
                self.notices
                    .wrong(format!("{name} has changed: choose the picture once more for its layer."));
            }
        }
    }

    fn follow_picture(&mut self, layer: usize, wanted: PictureUse, image: ToneImage) {
        match wanted.edit(&self.session, layer, image) {
            Some(edit) => self.session.change(edit),
            None => self.notices.wrong("The layer is no longer there, or no longer a field of points."),
        }
    }
}
