//! Other textures that fit the same sketch. They are grown in the background while they are shown.

#[cfg(test)]
mod tests;
mod variants;

use std::sync::Arc;

use egui::{ColorImage, Context, TextureHandle, TextureOptions};

use super::growth::{Growth, Texture, essence};
use super::result::finished_layer;
use super::small_growth::{self, Job, News};
use crate::document::{Document, Layer, Starred, limits};
use crate::editor::session::Session;
use crate::editor::task::{StartError, Task, Tasks};
use crate::synth::{Grown, Training};
use variants::{Variant, variants};

/// Bytes that the grown textures of all alternatives may take.
const MEMORY: usize = 64 << 20;
/// Bytes that a grown texture takes for each px of the canvas and each layer, about: fields on a grid that is at most as fine.
const BYTES: usize = 48;

/// An alternative.
pub struct Alternative {
    /// Its id; it never changes.
    pub id: u64,
    /// What differs from the sketch, in a few words.
    pub name: String,
    /// What differs from the sketch, in a sentence.
    pub help: String,
    /// Its document.
    pub document: Document,
    /// Whether it stays when the sketch changes.
    pub kept: bool,
    /// The grown texture, once there is one. Where all of them would take too much memory, it is dropped again, and grows anew
    /// when the alternative is opened.
    pub grown: Option<Arc<Grown>>,
    /// Its picture, once there is one.
    pub picture: Option<Arc<ColorImage>>,
    /// Why it cannot be grown.
    pub failed: Option<String>,
    /// Whether the picture was painted with other colours.
    stale: bool,
    texture: Option<TextureHandle>,
}

impl Alternative {
    fn is_wanted(&self) -> bool {
        self.failed.is_none() && (self.picture.is_none() || self.stale)
    }

    /// The picture on the graphics card.
    pub fn texture(&mut self, ctx: &Context) -> Option<&TextureHandle> {
        if self.texture.is_none() {
            let image = self.picture.clone()?;
            self.texture = Some(ctx.load_texture("alternative", image, TextureOptions::LINEAR));
        }
        self.texture.as_ref()
    }
}

/// The alternatives.
pub struct Alternatives {
    /// Whether they are shown.
    pub shown: bool,
    /// The alternatives in the order in which they are shown: the kept ones, the original sketch, the others.
    pub all: Vec<Alternative>,
    training: Arc<Training>,
    /// The id of the alternative that is growing, and the task that grows one alternative after the other.
    series: Option<(Option<u64>, Task<News>)>,
    /// Whether the user stopped the growth of alternatives.
    stopped: bool,
    /// The document with which the alternatives were last compared.
    followed: Option<Arc<Document>>,
    /// The id of the alternative that is open.
    taken: Option<u64>,
    /// The revision of the session from which the stars were last read.
    stars_seen: Option<u64>,
    ids: u64,
}

impl Alternatives {
    /// No alternatives yet. They will be grown with `training`.
    #[must_use]
    pub fn new(training: Arc<Training>) -> Self {
        Self {
            shown: false,
            all: Vec::new(),
            training,
            series: None,
            stopped: false,
            followed: None,
            taken: None,
            stars_seen: None,
            ids: 0,
        }
    }

    /// Removes all alternatives, because another document was opened.
    pub fn forget(&mut self) {
        *self = Self { shown: self.shown, ids: self.ids, ..Self::new(Arc::clone(&self.training)) };
    }

    /// Makes new alternatives when the sketch has changed, and grows them once the sketch itself has grown; never
    /// blocks. While the user draws (`busy`) no growth is started. Returns an error once where no thread can be
    /// started.
    pub fn follow(
        &mut self,
        tasks: &Tasks,
        session: &Session,
        growth: &Growth,
        busy: bool,
    ) -> Option<StartError> {
        self.listen();
        if self.stars_seen != Some(session.revision()) {
            self.stars_seen = Some(session.revision());
            self.take_stars(&session.document().starred);
        }
        if !self.shown {
            self.series = None;
            return None;
        }
        let Some(texture) = &growth.texture else {
            // The sketch itself is grown before its alternatives.
            self.series = None;
            return None;
        };
        let same = self.followed.as_ref().is_some_and(|followed| Arc::ptr_eq(followed, &texture.document));
        if !same && !busy {
            self.followed = Some(Arc::clone(&texture.document));
            self.compare(texture, finished_layer(session, session.active_layer).unwrap_or(0));
        }
        if self.series.is_none() && !self.stopped && !busy {
            return self.begin(tasks).err();
        }
        None
    }

    fn listen(&mut self) {
        while let Some(news) = self.series.as_mut().and_then(|(_, task)| task.poll()) {
            self.receive(news);
        }
        if self.series.as_ref().is_some_and(|(_, task)| task.has_ended()) {
            self.series = None;
        }
    }

    fn receive(&mut self, news: News) {
        match (news, &mut self.series) {
            (News::Begun(id), Some((growing, _))) => *growing = Some(id),
            (News::Begun(_), None) => {}
            (News::Done { id, outcome }, _) => {
                let Some(one) = self.all.iter_mut().find(|one| one.id == id) else { return };
                one.stale = false;
                one.texture = None;
                match outcome {
                    Ok((grown, picture)) => (one.grown, one.picture) = (Some(grown), Some(picture)),
                    Err(why) => one.failed = Some(why),
                }
                self.limit_memory();
            }
        }
    }

    /// Drops grown textures where all of them take too much memory: of the starred alternatives first. The open one is kept,
    /// and so is the original, from which the others take the layers that do not change.
    fn limit_memory(&mut self) {
        let bytes = |grown: &Grown| {
            let [width, height] = grown.size.map(|side| side as usize);
            BYTES * width * height * grown.layers.len()
        };
        let mut all: usize = self.all.iter().filter_map(|one| one.grown.as_deref()).map(bytes).sum();
        let original = self.all.iter().find(|one| !one.kept).map(|one| one.id);
        let needed = [original, self.taken];
        for one in self.all.iter_mut().filter(|one| !needed.contains(&Some(one.id))) {
            if all <= MEMORY {
                return;
            }
            all -= one.grown.take().map_or(0, |grown| bytes(&grown));
        }
    }

    /// Finds the alternative that has the document of `texture`. If there is none, makes new alternatives for
    /// `texture`.
    fn compare(&mut self, texture: &Texture, layer: usize) {
        let needed = essence(&texture.document);
        let one = self.all.iter().find(|one| essence(&one.document) == needed);
        self.taken = one.map(|one| one.id);
        // A kept one belongs to the current alternatives if they have the same marks.
        let belongs = one.is_some_and(|one| {
            let fits = |other: &Alternative| !other.kept && fits(&other.document, &one.document);
            !one.kept || self.all.iter().any(fits)
        });
        if belongs {
            self.recolour(&texture.document);
            return;
        }
        self.series = None;
        self.stopped = false;
        self.all.retain(|one| one.kept);
        let base = Variant {
            name: "Original".to_owned(),
            help: "The document from which these alternatives were made".to_owned(),
            document: without_stars(&texture.document),
        };
        let others = variants(&base.document, layer);
        for (index, variant) in std::iter::once(base).chain(others).enumerate() {
            let needed = essence(&variant.document);
            let there = self.all.iter().any(|one| essence(&one.document) == needed);
            if !there {
                let grown = (index == 0).then(|| Arc::clone(&texture.grown));
                let id = self.add(variant, grown);
                if index == 0 {
                    self.taken = Some(id);
                }
            }
        }
    }

    fn add(&mut self, variant: Variant, grown: Option<Arc<Grown>>) -> u64 {
        self.ids += 1;
        self.all.push(Alternative {
            id: self.ids,
            name: variant.name,
            help: variant.help,
            document: variant.document,
            kept: false,
            grown,
            picture: None,
            failed: None,
            stale: false,
            texture: None,
        });
        self.ids
    }

    /// Sets the names and colours of `document` in the alternatives that are not kept.
    fn recolour(&mut self, document: &Document) {
        for one in self.all.iter_mut().filter(|one| !one.kept) {
            let mut other =
                Document { name: document.name.clone(), dpi: document.dpi, ..one.document.clone() };
            for (layer, of) in other.layers.iter_mut().zip(&document.layers) {
                layer.name.clone_from(&of.name);
                layer.colours.clone_from(&of.colours);
                layer.visible = of.visible;
            }
            one.stale |= other != one.document;
            one.document = other;
        }
    }

    /// Grows the alternatives that have not grown yet. Where no thread can be started, it stops until the user asks for more.
    fn begin(&mut self, tasks: &Tasks) -> Result<(), StartError> {
        let beneath = self.all.iter().find(|one| !one.kept).and_then(|one| one.grown.clone());
        let job = |one: &Alternative| Job {
            id: one.id,
            about: None,
            document: one.document.clone(),
            known: one.grown.clone().or_else(|| beneath.clone()),
            grown: one.grown.is_some(),
        };
        let jobs: Vec<Job> = self.all.iter().filter(|one| one.is_wanted()).map(job).collect();
        if jobs.is_empty() {
            return Ok(());
        }
        match small_growth::start("alternatives", jobs, &self.training, tasks) {
            Ok(task) => {
                self.series = Some((None, task));
                Ok(())
            }
            Err(error) => {
                self.stopped = true;
                Err(error)
            }
        }
    }

    /// Stops growing the alternatives, or resumes.
    pub fn stop(&mut self, stopped: bool) {
        self.stopped = stopped;
        self.series = None;
    }

    /// Whether an alternative is being grown.
    #[must_use]
    pub fn is_growing(&self) -> bool {
        self.series.is_some()
    }

    /// Whether every alternative has grown or has failed.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        !self.all.iter().any(Alternative::is_wanted)
    }

    /// The progress of an alternative that is growing, 0..1.
    #[must_use]
    pub fn progress(&self, id: u64) -> Option<f32> {
        let (growing, task) = self.series.as_ref()?;
        (*growing == Some(id)).then(|| task.progress() as f32)
    }

    /// Whether the alternative with this id is the open document.
    #[must_use]
    pub fn is_taken(&self, id: u64) -> bool {
        self.taken == Some(id)
    }

    /// The alternative with this id.
    #[must_use]
    pub fn get(&self, id: u64) -> Option<&Alternative> {
        self.all.iter().find(|one| one.id == id)
    }

    /// Marks as kept the alternatives that are starred in the document: those that were read with it, and those whose
    /// star an undo restored or removed.
    fn take_stars(&mut self, starred: &[Starred]) {
        let is = |one: &Alternative, star: &Starred| one.name == star.name && one.document == star.document;
        for one in &mut self.all {
            one.kept = starred.iter().any(|star| is(one, star));
        }
        for star in starred {
            if !self.all.iter().any(|one| is(one, star)) {
                let help = "Saved with an earlier version of this sketch".to_owned();
                let (name, document) = (star.name.clone(), star.document.clone());
                self.add(Variant { name, help, document }, None);
                // Kept alternatives come first.
                if let Some(mut one) = self.all.pop() {
                    one.kept = true;
                    let place = self.all.iter().take_while(|other| other.kept).count();
                    self.all.insert(place, one);
                }
            }
        }
    }
}

/// The document without the textures that it keeps.
fn without_stars(document: &Document) -> Document {
    Document { starred: Vec::new(), ..document.clone() }
}

/// Stars an alternative in the document, or removes its star, as one step that can be undone. Returns whether there was
/// room for it.
pub fn star(session: &mut Session, one: &Alternative, kept: bool) -> bool {
    session.commit();
    let star = Starred { name: one.name.clone(), document: without_stars(&one.document) };
    let is_full = session.document().starred.len() >= limits::MAX_STARRED;
    if kept && is_full {
        return false;
    }
    session.edit(|document| {
        document.starred.retain(|other| *other != star);
        document.starred.extend(kept.then_some(star));
    });
    session.commit();
    true
}

/// Whether both have the same marks on the same canvas.
fn fits(a: &Document, b: &Document) -> bool {
    let canvas = |of: &Document| (of.size, of.regions, of.edges);
    canvas(a) == canvas(b)
        && a.layers.len() == b.layers.len()
        && a.layers.iter().zip(&b.layers).all(|(a, b)| a.strokes == b.strokes && a.after == b.after)
}

/// Replaces the open document by `document`, as one step that can be undone. Empty layers are kept where the marks are
/// the same.
pub fn put(session: &mut Session, document: &Document) {
    session.commit();
    let same = fits(&session.finished(), document);
    session.edit(|old| {
        let mut layers: Vec<Layer> = document.layers.clone();
        if same {
            let mut new = layers.into_iter();
            layers = old.layers.clone();
            for layer in layers.iter_mut().filter(|layer| !layer.is_blank()) {
                if let Some(new) = new.next() {
                    let name = std::mem::take(&mut layer.name);
                    // A name that was generated for the file is not copied.
                    *layer = if name.is_empty() { Layer { name, ..new } } else { new };
                }
            }
        }
        *old = Document { layers, starred: std::mem::take(&mut old.starred), ..document.clone() };
    });
    session.active_layer = session.active_layer.min(session.document().layers.len().saturating_sub(1));
    session.commit();
}
