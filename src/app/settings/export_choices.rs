//! The export choices in the settings file.

use serde::{Deserialize, Serialize};

use crate::app::exporting::choices::{Choices, Film, RELIEF};
use crate::editor::settings_file::Entries;
use crate::export::motion::Kind;
use crate::synth::render::clip::Clip;

/// The part of [`Film`] that is remembered.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
struct SavedFilm {
    kind: Kind,
    clip: Clip,
}

impl SavedFilm {
    fn new(film: &Film) -> Self {
        Self { kind: film.kind, clip: film.clip }
    }
}

/// Writes the choices that differ from the defaults.
pub fn write(choices: &Choices, entries: &mut Entries) {
    let default = Choices::default();
    entries.set("export", &choices.what, &default.what);
    entries.set("export_picture", &choices.picture, &default.picture);
    entries.set("export_material", &choices.material, &default.material);
    entries.set("export_outlines", &choices.outlines, &default.outlines);
    entries.set("export_film", &SavedFilm::new(&choices.film), &SavedFilm::new(&default.film));
}

/// Reads the choices. Missing and invalid values get their defaults; numbers are limited to their ranges.
pub fn read(entries: &Entries) -> Choices {
    let default = Choices::default();
    let SavedFilm { kind, clip } = entries.fields("export_film", &SavedFilm::new(&default.film));
    let mut choices = Choices {
        what: entries.get("export").unwrap_or(default.what),
        picture: entries.fields("export_picture", &default.picture),
        material: entries.fields("export_material", &default.material),
        outlines: entries.fields("export_outlines", &default.outlines),
        film: Film { kind, change: false, to: None, clip },
        ..Choices::default()
    };
    limit(&mut choices, &default);
    choices.make_consistent();
    choices
}

fn limit(choices: &mut Choices, default: &Choices) {
    choices.picture.quality = choices.picture.quality.clamp(1, 100);
    let material = &mut choices.material;
    if material.relief.is_empty() || material.roughness.len() < 2 {
        material.clone_from(&default.material);
    }
    material.relief.iter_mut().for_each(|px| *px = px.clamp(-RELIEF, RELIEF));
    material.roughness.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
    let outlines = &mut choices.outlines;
    outlines.level = outlines.level.clamp(0.01, 0.99);
    for length in [&mut outlines.spacing, &mut outlines.pen] {
        *length = length.max(1e-3);
    }
    for length in [&mut outlines.width, &mut outlines.area] {
        *length = length.max(0.0);
    }
    let clip = &mut choices.film.clip;
    clip.side = clip.side.filter(|side| *side >= 16).map(|side| side.min(8192));
    clip.seconds = clip.seconds.clamp(0.1, 600.0);
    clip.fps = clip.fps.clamp(1, 120);
    clip.hold = clip.hold.clamp(0.0, 60.0);
}
