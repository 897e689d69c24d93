//! A document and choices → a grown texture → files, by the same functions as the command line.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::choices::{Choices, ExportKind, PictureContent};
use super::outline_picture::OutlinePicture;
use crate::app::growth::essence;
use crate::document::with_causes;
use crate::document::{Document, Extent, embedded};
use crate::export::maps::Surface;
use crate::export::material::{Set, name};
use crate::export::motion;
use crate::export::outline::dxf;
use crate::export::outline::svg::{self, Sheet};
use crate::export::{ExportError, Stopped};
use crate::files::{self, Prepared, PreparedFilm, ReadFile, SaveFilm, SavePicture, prepare_concentrations};
use crate::machine::fs;
use crate::machine::{free_memory, this_machine};
use crate::synth::Growth;
use crate::synth::render::film::Scene;
use crate::synth::render::morph::Morph;
use crate::synth::render::outlining::{self, Outlining, outlines};
use crate::synth::render::painting::{Channel, Making, Painting, Style};
use crate::synth::{Grown, Options, Training, Watch};

/// What is to be exported.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportRequest {
    /// The document.
    pub document: Document,
    /// The choices.
    pub choices: Choices,
    /// The name of its files, without an ending.
    pub title: String,
}

/// Files that are written under temporary names.
pub enum Pending {
    /// Files; either all are kept or none.
    Files(Vec<Prepared>),
    /// A film.
    Film(PreparedFilm, motion::Film),
}

impl Pending {
    /// Renames them to their final names.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn keep(self) -> Result<(), String> {
        let kept = match self {
            Self::Files(files) => files.into_iter().try_for_each(Prepared::keep),
            Self::Film(film, _) => film.keep(),
        };
        kept.map_err(|error| error.to_string())
    }
}

/// The files that were written, and a message about them.
pub struct Written {
    /// The files.
    pub pending: Pending,
    /// A message about it.
    pub message: Option<String>,
    /// The outlines that were written.
    pub drawing: Option<OutlinePicture>,
}

/// The message of an error.
fn text(error: impl std::error::Error) -> String {
    with_causes(&error)
}

impl ExportRequest {
    /// The options with which it is grown.
    #[must_use]
    pub fn options(&self) -> Options<'static> {
        let pictured = self.choices.what == ExportKind::Picture;
        Options {
            size: self.choices.size.other(&self.document),
            concentrations: pictured && self.choices.picture.shows == PictureContent::Concentrations,
            source: "the sketch",
            ..Options::default()
        }
    }

    /// Whether it is a film. Films are grown frame by frame.
    #[must_use]
    pub fn is_film(&self) -> bool {
        self.choices.what == ExportKind::Film
    }

    /// Width and height, px, of its pictures.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.choices.size.in_px(&self.document).map(|side| side as usize)
    }

    /// Whether a `grown` texture can be exported as it is.
    #[must_use]
    pub fn takes(&self, grown: &Grown) -> bool {
        let wanted = self.options();
        let size = grown.settings.size.filter(|size| *size != grown.document.size);
        size == wanted.size
            && grown.settings.refine.is_none()
            && (grown.settings.concentrations || !wanted.concentrations)
            && essence(&grown.document) == essence(&self.document)
    }

    /// Grows it, unless `grown` can be used.
    ///
    /// # Errors
    /// Why it cannot be grown.
    pub fn grow(&self, grown: Option<&Arc<Grown>>, watch: &Watch) -> Result<Arc<Grown>, String> {
        if let Some(grown) = grown.filter(|grown| self.takes(grown)) {
            return Ok(Arc::clone(grown));
        }
        let grown = Growth::begin(
            &self.document,
            &Options { memory: Some(free_memory()), watch: *watch, ..self.options() },
            None,
        )
        .run();
        grown.map(Arc::new).map_err(text)
    }

    fn extent(&self) -> Extent {
        Extent { size: self.choices.size.other(&self.document), scale: self.choices.size.scale }
    }

    /// Writes the export to `path`. Pictures have `size` px: their full size, or a smaller one for the preview.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn write(
        &self,
        grown: Option<&Grown>,
        path: &Path,
        size: [usize; 2],
        watch: &Watch,
    ) -> Result<Written, String> {
        let Some(grown) = grown else { return self.film(path, watch) };
        let files = match self.choices.what {
            ExportKind::Picture => {
                self.picture(grown, path, size, watch).map(|file| vec![file]).map_err(text)?
            }
            ExportKind::Material => self.material(grown, path, size, watch)?,
            ExportKind::Outlines => return self.outlines(grown, path, watch).map_err(text),
            ExportKind::Film => return self.film(path, watch),
        };
        Ok(Written { pending: Pending::Files(files), message: None, drawing: None })
    }

    fn picture(
        &self,
        grown: &Grown,
        path: &Path,
        size: [usize; 2],
        watch: &Watch,
    ) -> Result<Prepared, ExportError> {
        let choices = self.choices.picture;
        let dpi = self.document.dpi * f64::from(self.choices.size.scale);
        let channel = match choices.shows {
            PictureContent::Texture => Channel::Texture,
            PictureContent::Pattern => Channel::Pattern(self.choices.layer),
            PictureContent::Labels => Channel::Labels,
            PictureContent::Concentrations => return prepare_concentrations(grown, path, size, dpi, watch),
        };
        let texts =
            if choices.document { embedded::embedded(&self.document, self.extent()) } else { Vec::new() };
        let style = Style {
            dpi,
            deep: choices.deep,
            transparent: choices.transparent,
            quality: choices.quality,
            texts,
        };
        Painting::sized(&self.document, grown, size).prepare(path, channel, &style, watch)
    }

    fn material(
        &self,
        grown: &Grown,
        folder: &Path,
        size: [usize; 2],
        watch: &Watch,
    ) -> Result<Vec<Prepared>, String> {
        if !fs::is_dir(folder) {
            fs::create_dir(folder).map_err(|error| super::folder_error(folder, &error))?;
        }
        let choices = &self.choices.material;
        let named = name(&self.title);
        let painting = Painting::sized(&self.document, grown, size);
        let set = Set {
            name: &named,
            size,
            deep: choices.deep,
            transparent: choices.transparent || !painting.is_opaque(),
            anisotropic: painting.is_anisotropic(),
            dpi: Some(self.document.dpi * f64::from(self.choices.size.scale)),
        };
        let relief = choices.relief_of(&self.document);
        let (scale, relief) = match size == self.size() {
            true => (self.choices.size.scale as usize, relief),
            false => {
                let smaller = size[0] as f64 / f64::from(grown.size[0]);
                (1, relief.iter().map(|relief| smaller * relief).collect())
            }
        };
        let surface = Surface { relief, roughness: choices.roughness.clone() };
        let transparent_ground = choices.transparent;
        let making = Making { surface, scale, edges: self.document.edges, transparent_ground };
        painting.prepare_material(folder, &set, &making, watch).map_err(text)
    }

    fn outlines(&self, grown: &Grown, path: &Path, watch: &Watch) -> Result<Written, ExportError> {
        let choices = self.choices.outlines;
        let dpi = self.document.dpi * f64::from(self.choices.size.scale);
        let size = self.size();
        let wanted = Outlining {
            size,
            level: choices.level,
            only: self.choices.layer,
            smallest: choices.smallest(dpi),
            style: choices.style(dpi),
        };
        let stopped = |stopped| match stopped {
            Stopped::Cancelled => ExportError::Cancelled { path: path.to_owned() },
            Stopped::Io(source) => ExportError::Io { path: path.to_owned(), source },
        };
        let (groups, travel) = outlines(&self.document, grown, &wanted, watch).map_err(stopped)?;
        let (size, unit) = (size.map(|side| side as f64), choices.unit(dpi));
        let title = self.document.name.clone();
        let ground = (choices.ground && !choices.dxf).then(|| outlining::ground(&self.document));
        let sheet = Sheet { title, size, unit, stroke_width: choices.pen, ground };
        let file = files::prepare(path, |out| {
            if choices.dxf {
                dxf::write(out, size, unit, &groups)?;
            } else {
                svg::write(out, &sheet, &groups)?;
            }
            Ok(())
        })?;
        let pen = if choices.dxf { None } else { Some(choices.pen / unit.per_px()) };
        Ok(Written {
            pending: Pending::Files(vec![file]),
            message: Some(travel.text(unit)),
            drawing: Some(OutlinePicture { size, groups, pen, ground }),
        })
    }

    fn film(&self, path: &Path, watch: &Watch) -> Result<Written, String> {
        let choices = &self.choices.film;
        let made = if choices.change {
            let to = choices.to.as_ref().ok_or("Choose the document into which this one changes.")?;
            let other = Document::read(to).map_err(|error| with_causes(&error))?;
            let there = to.display().to_string();
            let from = (&self.document, self.title.as_str());
            let morph = Morph::new(from, (&other, &there), (Training::built_in(), this_machine()), watch)
                .map_err(text)?;
            choices.clip.film_change([&self.document, &other], &morph, path, choices.kind, watch)
        } else {
            let options = Options {
                source: "the sketch",
                memory: Some(free_memory()),
                watch: *watch,
                ..Options::default()
            };
            let scene = Scene { document: &self.document, options };
            choices.clip.film_growth(&scene, path, choices.kind)
        };
        let (film, summary) = made.map_err(text)?;
        let [width, height] = summary.size;
        let message = format!("{} frames of {width} × {height} px", summary.frames);
        Ok(Written { pending: Pending::Film(film, summary), message: Some(message), drawing: None })
    }

    /// The final paths of the `files` of a preview, where the export is written to `path`.
    #[must_use]
    pub fn places(&self, path: &Path, files: &[PathBuf]) -> Vec<PathBuf> {
        match self.choices.what {
            ExportKind::Material => {
                files.iter().filter_map(|file| Some(path.join(file.file_name()?))).collect()
            }
            _ => vec![path.to_owned()],
        }
    }
}
