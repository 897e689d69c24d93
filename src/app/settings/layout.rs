//! How the window lies on the screen and what it shows.

use super::file::Entries;
use crate::app::Tab;

/// The smallest and largest side that is believed, points.
const SIDES: std::ops::RangeInclusive<f32> = 200.0..=20_000.0;

/// How the window lies, and what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Left upper corner of the window with its frame, where the platform tells; points.
    pub position: Option<[f32; 2]>,
    /// Width and height within the frame, while it does not fill the screen; points.
    pub size: Option<[f32; 2]>,
    /// Does it fill the screen?
    pub maximised: bool,
    /// What the column shows.
    pub tab: Tab,
    /// One over the other, instead of side by side.
    pub over: bool,
    /// Where the curtain hangs, 0..1.
    pub curtain: f32,
    /// Do the views move together?
    pub linked: bool,
    /// Is the region grid shown?
    pub regions: bool,
    /// Is shown what is seen in the sketch?
    pub analysis: bool,
}

impl Default for Layout {
    fn default() -> Self {
        Self {
            position: None,
            size: None,
            maximised: false,
            tab: Tab::default(),
            over: false,
            curtain: 0.5,
            linked: true,
            regions: true,
            analysis: false,
        }
    }
}

impl Layout {
    /// Takes in what the settings say.
    pub fn take_in(&mut self, entries: &Entries) {
        *self = Self::default();
        if let Some([width, height]) = entries.numbers("size").map(|size| size.map(|side| side as f32))
            && SIDES.contains(&width)
            && SIDES.contains(&height)
        {
            self.size = Some([width, height]);
        }
        self.position = entries.numbers("position").map(|corner| corner.map(|at| at as f32));
        let is = |key: &str, value: &str| entries.one(key) == Some(value);
        self.maximised = is("maximised", "yes");
        let tab = Tab::ALL.into_iter().find(|tab| is("tab", &tab.name().to_lowercase()));
        self.tab = tab.unwrap_or_default();
        self.over = is("over", "yes");
        self.linked = !is("linked", "no");
        self.regions = !is("grid", "no");
        self.analysis = is("analysis", "yes");
        self.curtain = entries.numbers("curtain").map_or(0.5, |[share]| share.clamp(0.0, 1.0) as f32);
    }

    /// Says what differs from what a first start finds.
    pub fn tell(&self, entries: &mut Entries) {
        for (key, pair) in [("position", self.position), ("size", self.size)] {
            if let Some([x, y]) = pair {
                entries.add(key, format!("{x:.0} {y:.0}"));
            }
        }
        if self.tab != Tab::default() {
            entries.add("tab", self.tab.name().to_lowercase());
        }
        for (key, value, usual) in [
            ("maximised", self.maximised, false),
            ("over", self.over, false),
            ("linked", self.linked, true),
            ("grid", self.regions, true),
            ("analysis", self.analysis, false),
        ] {
            if value != usual {
                entries.add(key, if value { "yes" } else { "no" });
            }
        }
        if (self.curtain - 0.5).abs() > 1e-3 {
            entries.add("curtain", format!("{:.3}", self.curtain));
        }
    }
}
