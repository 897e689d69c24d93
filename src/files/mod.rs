//! Files: the engine reads bytes and writes to any writer; this module reads and writes the files.
//!
//! [`save()`] writes a stream into a temporary file beside the target and renames it at the end, so an error or a cancelled run
//! leaves nothing incomplete and keeps the file that was there before. [`ReadFile`], [`WriteFile`], [`SaveTexture`],
//! [`SavePicture`] and [`SaveFilm`] add files to types of the engine.

mod abandon;
mod document;
mod film;
mod folder;
mod heights;
mod import;
mod input;
mod maps;
mod model;
mod pictures;
mod save;
mod stale_files;
mod temporary_folder;
mod texture;
mod textured_body;
mod training;

pub use abandon::{abandon, remove_empty_folders};
pub use document::{ReadFile, WriteFile, as_link, in_picture, open, source};
pub use film::{PreparedFilm, SaveFilm, film_kind, write_film};
pub use folder::write_folder;
pub use heights::read_heights;
pub use import::{import_photo, import_svg, is_svg, measure_file, measure_patches, open_picture, read_tone};
pub use input::{Input, input, is_pipe, is_standard_output, stem};
pub use maps::prepare_maps;
pub use model::{ModelFile, read_model};
pub use pictures::{SavePicture, check_picture, prepare_concentrations};
pub use save::{
    Prepared, Unfinished, begin, check_content, check_ending, check_file, folder_of, keep_all, make_folder,
    prepare, save,
};
pub use temporary_folder::TemporaryFolder;
pub use texture::SaveTexture;
pub use textured_body::TexturedBody;
pub use training::{TrainingFolder, training};
