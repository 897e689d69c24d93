//! Placement of the window on the screen and what it shows.

use crate::app::Tab;
use crate::editor::settings_file::Entries;
use crate::editor::snap::Snap;

/// The smallest and largest side that is accepted, points.
const SIDES: std::ops::RangeInclusive<f32> = 200.0..=20_000.0;

/// The smallest width of the column on the right, which is also that of a new installation, and the largest, points.
pub const COLUMN_WIDTHS: [f32; 2] = [264.0, 480.0];

/// Placement of the window, and what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Left upper corner of the window with its frame, points; `None` where the platform does not say.
    pub position: Option<[f32; 2]>,
    /// Width and height within the frame when it is not maximised, points.
    pub size: Option<[f32; 2]>,
    /// Whether it fills the screen.
    pub maximised: bool,
    /// The tab of the right column.
    pub tab: Tab,
    /// Whether the tools are shown.
    pub tools: bool,
    /// Whether the column on the right is shown.
    pub column: bool,
    /// Width of the column on the right, points.
    pub column_width: f32,
    /// Whether sketch and texture lie one over the other, instead of side by side.
    pub over: bool,
    /// Position of the curtain between them, 0..1.
    pub curtain: f32,
    /// Whether the views move together.
    pub linked: bool,
    /// Whether small pictures of what the layer can become are shown.
    pub goals: bool,
    /// Whether the region grid is shown.
    pub regions: bool,
    /// Whether the analysis of the sketch is shown.
    pub analysis: bool,
    /// Whether the sizes and directions that free marks ask for in the space between them are shown.
    pub wanted: bool,
    /// The grid that marks snap to.
    pub snap: Snap,
}

impl Default for Layout {
    fn default() -> Self {
        Self {
            position: None,
            size: None,
            maximised: false,
            tab: Tab::default(),
            tools: true,
            column: true,
            column_width: COLUMN_WIDTHS[0],
            over: false,
            curtain: 0.5,
            linked: true,
            goals: true,
            regions: true,
            analysis: false,
            wanted: true,
            snap: Snap::default(),
        }
    }
}

impl Layout {
    /// Takes the values from the settings; values that are missing or out of range get their defaults.
    pub fn take_in(&mut self, entries: &Entries) {
        let default = Self::default();
        let is = |name: &str, default: bool| entries.get(name).unwrap_or(default);
        let tab = entries.get::<String>("tab");
        let named = |tab: &Tab, name: &str| tab.name().to_lowercase() == name;
        *self = Self {
            position: entries.get("position"),
            size: entries.get("size").filter(|size: &[f32; 2]| size.iter().all(|side| SIDES.contains(side))),
            maximised: is("maximised", default.maximised),
            tab: Tab::ALL
                .into_iter()
                .find(|one| tab.as_ref().is_some_and(|tab| named(one, tab)))
                .unwrap_or_default(),
            tools: is("tools", default.tools),
            column: is("column", default.column),
            column_width: entries
                .get("column_width")
                .map_or(default.column_width, |width: f32| width.clamp(COLUMN_WIDTHS[0], COLUMN_WIDTHS[1])),
            over: is("over", default.over),
            curtain: entries.get("curtain").map_or(default.curtain, |share: f32| share.clamp(0.0, 1.0)),
            linked: is("linked", default.linked),
            goals: is("goals", default.goals),
            regions: is("regions", default.regions),
            analysis: is("analysis", default.analysis),
            wanted: is("wanted", default.wanted),
            snap: entries.get("snap").unwrap_or(default.snap),
        };
    }

    /// Writes the values that differ from the defaults.
    pub fn write(&self, entries: &mut Entries) {
        let default = Self::default();
        // Whole points and thousandths, so that a window manager's rounding does not count as a change.
        let rounded = |pair: [f32; 2]| pair.map(f32::round);
        entries.set("position", &self.position.map(rounded), &None);
        entries.set("size", &self.size.map(rounded), &None);
        entries.set("maximised", &self.maximised, &default.maximised);
        entries.set("tab", &self.tab.name().to_lowercase(), &default.tab.name().to_lowercase());
        entries.set("tools", &self.tools, &default.tools);
        entries.set("column", &self.column, &default.column);
        entries.set("column_width", &self.column_width.round(), &default.column_width);
        entries.set("over", &self.over, &default.over);
        entries.set("curtain", &thousandths(self.curtain), &thousandths(default.curtain));
        entries.set("linked", &self.linked, &default.linked);
        entries.set("goals", &self.goals, &default.goals);
        entries.set("regions", &self.regions, &default.regions);
        entries.set("analysis", &self.analysis, &default.analysis);
        entries.set("wanted", &self.wanted, &default.wanted);
        entries.set("snap", &self.snap, &default.snap);
    }
}

fn thousandths(share: f32) -> f64 {
    (f64::from(share) * 1000.0).round() / 1000.0
}
