//! Small pictures, grown from the user's own sketch, of what the active layer can become. They grow in the background once the
//! texture itself has settled and nothing has changed for a moment; a stroke cancels them.

use std::sync::Arc;
use std::time::Duration;

use egui::{ColorImage, Context, TextureHandle, TextureOptions};

use super::growth::{Growth, essence};
use super::result::finished_layer;
use super::small_growth::{self, Job, News};
use crate::document::Document;
use crate::editor::goal::{Goal, Offer};
use crate::editor::session::Session;
use crate::editor::task::{StartError, Task, Tasks};
use crate::machine::clock::Instant;
use crate::synth::Training;

/// The time without a change after which they begin to grow: many a change is followed by the next one soon.
const CALM: Duration = Duration::from_millis(350);

/// A goal that is shown.
pub struct ShownGoal {
    /// The goal, and the document in which the layer is it, or what is missing.
    pub offer: Offer,
    /// Whether the layer is this now.
    pub is_now: bool,
    /// Its picture, once there is one; that of the sketch from before until then.
    pub picture: Option<Arc<ColorImage>>,
    /// Why it cannot be grown; it is not shown then.
    pub failed: Option<String>,
    /// The id under which its picture grows.
    id: u64,
    is_current: bool,
    texture: Option<TextureHandle>,
}

impl ShownGoal {
    /// Whether a click takes it: it has a picture.
    #[must_use]
    pub fn can_be_taken(&self) -> bool {
        self.offer.outcome.is_ok() && self.failed.is_none() && self.picture.is_some()
    }

    fn is_wanted(&self) -> bool {
        self.offer.outcome.is_ok() && self.failed.is_none() && !self.is_current
    }

    /// The picture on the graphics card.
    pub fn texture(&mut self, ctx: &Context) -> Option<&TextureHandle> {
        if self.texture.is_none() {
            let image = self.picture.clone()?;
            self.texture = Some(ctx.load_texture("goal", image, TextureOptions::LINEAR));
        }
        self.texture.as_ref()
    }
}

/// The goals of the active layer.
pub struct Goals {
    /// Whether they are shown.
    pub shown: bool,
    /// The goals in the order in which they are shown.
    pub all: Vec<ShownGoal>,
    training: Arc<Training>,
    series: Option<Task<News>>,
    /// The document and the layer of the goals, and the time from which they grow.
    followed: Option<(Arc<Document>, usize)>,
    due: Instant,
    /// Whether no thread could be started; it is tried again after the next change.
    stopped: bool,
    /// Whether pictures are missing that are going to grow.
    waiting: bool,
    ids: u64,
}

impl Goals {
    /// No goals yet. They will be grown with `training`.
    #[must_use]
    pub fn new(training: Arc<Training>) -> Self {
        Self {
            shown: true,
            all: Vec::new(),
            training,
            series: None,
            followed: None,
            due: Instant::now(),
            stopped: false,
            waiting: false,
            ids: 0,
        }
    }

    /// Removes all goals, because another document was opened.
    pub fn forget(&mut self) {
        *self = Self { shown: self.shown, ids: self.ids, ..Self::new(Arc::clone(&self.training)) };
    }

    /// Finds the goals of a changed sketch, and grows their pictures once the sketch itself has grown; never blocks. They are
    /// not grown while they are out of sight (`seen`) or the user draws (`drawing`), and change once no button is held down
    /// (`busy`). Gives the time after which it has something to do, and an error once where no thread can be started.
    pub fn follow(
        &mut self,
        tasks: &Tasks,
        (session, growth): (&Session, &Growth),
        [seen, drawing, busy]: [bool; 3],
    ) -> (Option<Duration>, Option<StartError>) {
        self.listen();
        self.waiting = false;
        if growth.is_empty() || session.kind(session.active_layer).is_none() {
            (self.series, self.followed) = (None, None);
            self.all.clear();
        }
        let Some(texture) = growth.texture.as_ref().filter(|_| seen && !drawing) else {
            self.series = None;
            return (None, None);
        };
        let Some(layer) = finished_layer(session, session.active_layer) else { return (None, None) };
        let is_same = self
            .followed
            .as_ref()
            .is_some_and(|(document, of)| *of == layer && Arc::ptr_eq(document, &texture.document));
        if !is_same && !busy {
            self.followed = Some((Arc::clone(&texture.document), layer));
            let now = texture.grown.layers.get(layer).zip(texture.document.layers.get(layer));
            let now = now.and_then(|(grown, of)| Goal::of_layer(of, grown.system()));
            self.replace(Goal::offers(session, now), now);
            self.due = Instant::now() + CALM;
        }
        self.waiting = !self.stopped && !self.is_complete();
        if busy || !self.waiting || self.series.is_some() {
            return (None, None);
        }
        let left = self.due.saturating_duration_since(Instant::now());
        if left.is_zero() { (None, self.begin(tasks, layer).err()) } else { (Some(left), None) }
    }

    /// Shows these offers. A goal whose document is the same keeps its picture; others keep theirs until they have grown.
    fn replace(&mut self, offers: Vec<Offer>, now: Option<Goal>) {
        (self.series, self.stopped) = (None, false);
        let mut before = std::mem::take(&mut self.all);
        for offer in offers {
            self.ids += 1;
            let goal = offer.goal;
            let known = before.iter().position(|one| one.offer.goal == goal).map(|at| before.swap_remove(at));
            let is_same = known.as_ref().is_some_and(|known| match (&known.offer.outcome, &offer.outcome) {
                (Ok(known), Ok(new)) => shown_alike(known, new),
                _ => false,
            });
            let known = known.filter(|_| offer.outcome.is_ok());
            self.all.push(ShownGoal {
                offer,
                is_now: now == Some(goal),
                id: self.ids,
                is_current: is_same && known.as_ref().is_some_and(|known| known.is_current),
                failed: known.as_ref().filter(|_| is_same).and_then(|known| known.failed.clone()),
                picture: known.as_ref().and_then(|known| known.picture.clone()),
                texture: known.and_then(|known| known.texture),
            });
        }
    }

    fn listen(&mut self) {
        while let Some(news) = self.series.as_mut().and_then(Task::poll) {
            if let News::Done { id, outcome } = news
                && let Some(one) = self.all.iter_mut().find(|one| one.id == id)
            {
                one.texture = None;
                (one.picture, one.failed) = match outcome {
                    Ok((_, picture)) => (Some(picture), None),
                    Err(why) => (None, Some(why)),
                };
                one.is_current = true;
            }
        }
        if self.series.as_ref().is_some_and(Task::has_ended) {
            self.series = None;
        }
    }

    fn begin(&mut self, tasks: &Tasks, layer: usize) -> Result<(), StartError> {
        let job = |one: &ShownGoal| {
            let document = one.offer.outcome.clone().ok()?;
            Some(Job { id: one.id, about: Some(layer), document, known: None, grown: false })
        };
        let wanted = self.all.iter().filter(|one| one.is_wanted());
        match small_growth::start("goals", wanted.filter_map(job).collect(), &self.training, tasks) {
            Ok(task) => {
                self.series = Some(task);
                Ok(())
            }
            Err(error) => {
                self.stopped = true;
                Err(error)
            }
        }
    }

    /// Whether a picture is being grown.
    #[must_use]
    pub fn is_growing(&self) -> bool {
        self.series.is_some()
    }

    /// Whether pictures that are in sight are growing, or are going to.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.waiting
    }

    /// Whether every goal that can be taken has a picture of the current sketch, or cannot be grown.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        !self.all.iter().any(ShownGoal::is_wanted)
    }
}

/// Whether two documents have the same picture.
fn shown_alike(a: &Document, b: &Document) -> bool {
    let looks = |of: &Document| -> Vec<_> {
        of.layers.iter().map(|layer| (layer.colours.clone(), layer.maps.clone(), layer.visible)).collect()
    };
    looks(a) == looks(b) && a.warp == b.warp && essence(a) == essence(b)
}
