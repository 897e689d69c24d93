//! The colours of a layer, and editing them.

use crate::colour::{self, Bend, Gradient};
use crate::document::limits;

/// The colours of a layer: stops at pattern values, with straight or bent transitions between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Colours {
    /// Stops, ascending; at least one. Two at the same value make a hard step.
    pub stops: Vec<Stop>,
    /// `bends[i]` is the cubic Bezier (x1, y1, x2, y2, as in CSS easing) between stops i and i + 1; those
    /// that are missing at the end are straight.
    pub bends: Vec<[f64; 4]>,
    /// The second colour of the ground (red, green, blue, sRGB), which [`MapKey::Ground`](crate::document::MapKey::Ground) mixes into the
    /// first one.
    pub ground: [u8; 3],
    /// How far the colours of the ground reach from the edge of a mark, [`limits::HALO`]: 1 = as the stops say, less = nearer to the edge.
    pub halo: f64,
}

/// A colour at a pattern value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// The pattern value, 0..1.
    pub at: f64,
    /// Red, green, blue (sRGB).
    pub colour: [u8; 3],
    /// Opacity: 0 = transparent, 255 = opaque.
    pub alpha: u8,
}

impl Stop {
    /// An opaque stop.
    #[must_use]
    pub const fn opaque(at: f64, colour: [u8; 3]) -> Self {
        Self { at, colour, alpha: u8::MAX }
    }

    /// Red, green, blue, alpha.
    #[must_use]
    pub const fn rgba(&self) -> [u8; 4] {
        let [red, green, blue] = self.colour;
        [red, green, blue, self.alpha]
    }

    /// In hexadecimal digits: `#rrggbb`, or `#rrggbbaa` where it is not opaque.
    #[must_use]
    pub fn hex(&self) -> String {
        let [red, green, blue] = self.colour;
        let opaque = format!("#{red:02x}{green:02x}{blue:02x}");
        if self.alpha == u8::MAX { opaque } else { format!("{opaque}{:02x}", self.alpha) }
    }

    /// Sets colour and opacity.
    pub const fn set_rgba(&mut self, [red, green, blue, alpha]: [u8; 4]) {
        (self.colour, self.alpha) = ([red, green, blue], alpha);
    }
}

const STRAIGHT: [f64; 4] = [0.0, 0.0, 1.0, 1.0];

impl Colours {
    /// The second colour of a ground for which the document gives none: a white belly.
    pub const GROUND: [u8; 3] = [u8::MAX; 3];

    /// The default colours of the layer with this index (0 = the lowest).
    #[must_use]
    pub fn default_for_layer(layer: usize) -> Self {
        Self::from(&Gradient::default_for_layer(layer))
    }

    /// The gradient of its stops.
    ///
    /// ```
    /// use dapple_engine::document::Colours;
    ///
    /// let colours = Colours::new([(0.0, [240, 220, 180]), (1.0, [40, 30, 20])]);
    /// assert_eq!(colours.gradient().colour(1.0), [40, 30, 20]);
    /// ```
    #[must_use]
    pub fn gradient(&self) -> Gradient {
        Gradient {
            stops: self
                .stops
                .iter()
                .map(|stop| colour::Stop { at: stop.at as f32, colour: stop.colour, alpha: stop.alpha })
                .collect(),
            bends: self.bends.iter().map(|bend| Bend(*bend)).collect(),
        }
    }

    /// The gradient that paints them: that of the stops, with those of the ground moved towards the edge of the marks, 0.5, by
    /// [`Self::halo`].
    ///
    /// ```
    /// use dapple_engine::document::Colours;
    ///
    /// let halo = Colours::new([(0.0, [240, 220, 180]), (1.0, [40, 30, 20])]);
    /// let none = Colours { halo: 0.1, ..halo.clone() };
    /// assert_ne!(halo.painted().colour(0.4), [240, 220, 180]);
    /// assert_eq!(none.painted().colour(0.4), [240, 220, 180]);
    /// assert_eq!(none.painted().colour(0.5), halo.painted().colour(0.5));
    /// ```
    #[must_use]
    pub fn painted(&self) -> Gradient {
        const EDGE: f64 = 0.5;
        if self.halo >= 1.0 {
            return self.gradient();
        }
        // A stop at the edge divides the curve that crosses it.
        let mut nearer = self.clone();
        let is_crossed = nearer.stops.windows(2).any(|pair| pair[0].at < EDGE && pair[1].at > EDGE);
        if is_crossed {
            nearer.insert(EDGE);
        }
        for stop in nearer.stops.iter_mut().filter(|stop| stop.at < EDGE) {
            stop.at = EDGE - self.halo * (EDGE - stop.at);
        }
        nearer.gradient()
    }

    /// The Bezier curve between stop `gap` and the next.
    #[must_use]
    pub fn bend(&self, gap: usize) -> [f64; 4] {
        self.bends.get(gap).copied().unwrap_or(STRAIGHT)
    }

    /// Sets the Bezier curve between stop `gap` and the next, clamped to [`limits::BEND_X`] and [`limits::BEND_Y`].
    pub fn set_bend(&mut self, gap: usize, bend: [f64; 4]) {
        if gap + 1 < self.stops.len() {
            self.all_bends()[gap] = within(bend);
            self.tidy();
        }
    }

    /// Inserts a stop at pattern value `at` with the colour that is there, so that the picture stays. Returns its index.
    pub fn insert(&mut self, at: f64) -> usize {
        let at = at.clamp(limits::STOP.low, limits::STOP.high);
        let [red, green, blue, alpha] = self.gradient().rgba(at as f32);
        let index = self.stops.iter().take_while(|stop| stop.at <= at).count();
        let (stops, gaps) = (self.stops.len(), self.stops.len().saturating_sub(1));
        let bends = self.all_bends();
        if index > 0 && index < stops {
            let bend = bends[index - 1];
            let [before, after] = [self.stops[index - 1].at, self.stops[index].at];
            let parts = Bend(bend).split((at - before) / (after - before)).map(|part| within(part.0));
            self.bends.splice(index - 1..index, parts);
        } else if stops > 0 {
            bends.insert(index.min(gaps), STRAIGHT);
        }
        self.stops.insert(index, Stop { at, colour: [red, green, blue], alpha });
        self.tidy();
        index
    }

    /// Removes stop `index`, unless it is the only one; the curves on its two sides are joined. Returns whether it was
    /// removed.
    pub fn remove(&mut self, index: usize) -> bool {
        if self.stops.len() < 2 || index >= self.stops.len() {
            return false;
        }
        let gradient = self.gradient();
        let bends = self.all_bends();
        if index == 0 {
            bends.remove(0);
        } else if index == bends.len() {
            bends.pop();
        } else {
            let parts = [index - 1, index].map(|gap| Bend(bends[gap]));
            let [from, at, to] = [index - 1, index, index + 1].map(|stop| self.stops[stop].at);
            let x = if to > from { (at - from) / (to - from) } else { 0.5 };
            let y = gradient.share(index - 1, index, index + 1);
            let joined = within(parts[0].joined(&parts[1], [x, y]).0);
            self.bends.splice(index - 1..=index, [joined]);
        }
        self.stops.remove(index);
        self.tidy();
        true
    }

    /// Moves stop `index` to pattern value `at`, past other stops if necessary; the curves keep their order. Returns its
    /// new index.
    pub fn shift(&mut self, index: usize, at: f64) -> usize {
        let at = at.clamp(limits::STOP.low, limits::STOP.high);
        let stop = Stop { at, ..self.stops.remove(index) };
        // At the same value as another stop it stays on the side that it came from.
        let to = self
            .stops
            .iter()
            .enumerate()
            .take_while(|(i, other)| other.at < at || (other.at == at && *i < index))
            .count();
        self.stops.insert(to, stop);
        to
    }

    /// Exchanges the colours of two stops; their places stay.
    pub fn swap(&mut self, one: usize, other: usize) {
        let colours = [one, other].map(|index| self.stops[index].rgba());
        self.stops[one].set_rgba(colours[1]);
        self.stops[other].set_rgba(colours[0]);
    }

    /// Reverses the order of the colours, curves included.
    pub fn reverse(&mut self) {
        for stop in &mut self.stops {
            stop.at = rounded(1.0 - stop.at);
        }
        self.stops.reverse();
        let bends = self.all_bends();
        bends.reverse();
        for bend in bends {
            *bend = Bend(*bend).reversed().0.map(rounded);
        }
        self.tidy();
    }

    /// The bends, one for each gap.
    fn all_bends(&mut self) -> &mut Vec<[f64; 4]> {
        self.bends.resize(self.stops.len().saturating_sub(1), STRAIGHT);
        &mut self.bends
    }

    /// Removes straight bends from the end, which are the default.
    fn tidy(&mut self) {
        while self.bends.last() == Some(&STRAIGHT) {
            self.bends.pop();
        }
    }
}

impl From<&Gradient> for Colours {
    fn from(gradient: &Gradient) -> Self {
        // The f64 that reads as the f32 does: 0.4, not 0.4000000059604645.
        let at = |at: f32| at.to_string().parse().unwrap_or_else(|_| f64::from(at));
        let mut colours = Self {
            stops: gradient
                .stops
                .iter()
                .map(|stop| Stop { at: at(stop.at), colour: stop.colour, alpha: stop.alpha })
                .collect(),
            bends: gradient.bends.iter().map(|bend| bend.0).collect(),
            ..Self::new([])
        };
        colours.tidy();
        colours
    }
}

/// Rounds to 12 digits, so that 1 − (1 − 0.4) is 0.4 again.
fn rounded(x: f64) -> f64 {
    (1e12 * x).round() / 1e12
}

/// Clamps handles to what a document may hold.
fn within(bend: [f64; 4]) -> [f64; 4] {
    let ranges = [limits::BEND_X, limits::BEND_Y, limits::BEND_X, limits::BEND_Y];
    std::array::from_fn(|i| bend[i].clamp(ranges[i].low, ranges[i].high))
}

#[cfg(test)]
mod tests;
#[cfg(test)]
pub(super) use tests::any_colours;
