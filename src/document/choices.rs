//! The named choices of a document.

use crate::document::{Options, Problem, Seeding, SpreadChoice};

/// What a layer's marks are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Spots.
    Ellipse,
    /// Stripes.
    Line,
}

impl Kind {
    /// Its name in a document.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ellipse => "ellipse",
            Self::Line => "line",
        }
    }

    /// The problem that a stroke at `place` is of this kind although the layer holds `first`.
    ///
    /// A layer holds ellipses or lines, not both. Explicit strokes are checked when a document is read;
    /// freehand ones by whoever fits them, with the same words.
    #[must_use]
    pub fn mixed(self, place: &str, first: Self) -> Problem {
        let name = |kind: Self| if kind == Self::Ellipse { "an ellipse" } else { "a line" };
        Problem::new(
            place,
            format!("{} in a layer of {}s", name(self), first.name()),
            format!(
                "{} (a layer holds ellipses or lines: give the others a layer of their own)",
                name(first)
            ),
        )
    }
}

/// The reaction-diffusion system that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SystemChoice {
    /// The one that reaches the marks' attributes best: lines → stripes, ellipses → spots.
    #[default]
    Auto,
    /// Turing's spots.
    TuringSpots,
    /// Meinhardt's spots.
    MeinhardtSpots,
    /// Meinhardt's stripes.
    MeinhardtStripes,
    /// Meinhardt's lines: thin stripes on wide ground.
    MeinhardtLines,
}

impl SystemChoice {
    /// All of them with their names in documents and on the command line.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("auto", Self::Auto),
        ("turing-spots", Self::TuringSpots),
        ("meinhardt-spots", Self::MeinhardtSpots),
        ("meinhardt-stripes", Self::MeinhardtStripes),
        ("meinhardt-lines", Self::MeinhardtLines),
    ];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_in(&Self::NAMES, self)
    }

    /// What it grows; `None` = whatever the marks are.
    #[must_use]
    pub fn grows(self) -> Option<Kind> {
        match self {
            Self::Auto => None,
            Self::TuringSpots | Self::MeinhardtSpots => Some(Kind::Ellipse),
            Self::MeinhardtStripes | Self::MeinhardtLines => Some(Kind::Line),
        }
    }

    /// The keys that a layer's `options` may have with it.
    #[must_use]
    pub fn option_keys(self) -> &'static [&'static str] {
        match self {
            Self::Auto => &["spread", "keep", "duty", "irregular", "seeding"],
            Self::TuringSpots | Self::MeinhardtSpots => &["spread", "keep", "irregular"],
            Self::MeinhardtStripes => &["keep", "duty", "seeding"],
            Self::MeinhardtLines => &["keep", "duty"],
        }
    }

    /// The problem that a layer at `place` (its `system`) asks for this system but holds marks of `kind`.
    #[must_use]
    pub fn mismatch(self, place: &str, kind: Kind) -> Option<Problem> {
        if self.grows().is_none_or(|grown| grown == kind) {
            return None;
        }
        let fitting = |(_, system): &&(&str, Self)| system.grows().is_none_or(|grown| grown == kind);
        let names: Vec<&str> = Self::NAMES.iter().filter(fitting).map(|(name, _)| *name).collect();
        let found = format!("\"{}\" for a layer of {}s", self.name(), kind.name());
        Some(Problem::new(place, found, names.join(", ")))
    }
}

impl Options {
    /// The share of the way from stripe to stripe that each covers where nothing else is said.
    pub const DUTY: f64 = 0.5;

    /// The problem that options at `place` do not go with marks of `kind`, or with `system`.
    #[must_use]
    pub fn mismatch(&self, place: &str, system: SystemChoice, kind: Option<Kind>) -> Option<Problem> {
        let duty = self.duty_mismatch(&format!("{place}.duty"), system, kind);
        let irregular = || self.irregular_mismatch(&format!("{place}.irregular"), system, kind);
        duty.or_else(irregular).or_else(|| self.seeding_mismatch(&format!("{place}.seeding"), system, kind))
    }

    /// The problem that a layer's `options` say at `place` how much of the ground its marks cover although they are of
    /// `kind`, or `system` cannot.
    fn duty_mismatch(&self, place: &str, system: SystemChoice, kind: Option<Kind>) -> Option<Problem> {
        if self.duty == Self::DUTY {
            return None;
        }
        if system.grows().or(kind) == Some(Kind::Ellipse) {
            let allowed = "no such key: only stripes have a duty; spots stand as far apart as they are drawn";
            return Some(Problem::new(place, "a duty of spots", allowed));
        }
        (system == SystemChoice::MeinhardtStripes).then(|| {
            let found = format!("{} with the system \"meinhardt-stripes\"", self.duty);
            let allowed = "0.5, the only duty of this system; for thinner stripes the system \"meinhardt-lines\" or \"auto\"";
            Problem::new(place, found, allowed)
        })
    }
}

impl Options {
    /// The problem that a layer's `options` say at `place` how irregular its marks are although they are of `kind`, or
    /// `system` cannot.
    fn irregular_mismatch(&self, place: &str, system: SystemChoice, kind: Option<Kind>) -> Option<Problem> {
        if self.irregular == 0.0 {
            return None;
        }
        if system.grows().or(kind) == Some(Kind::Line) {
            let allowed = "no such key: only spots can be irregular";
            return Some(Problem::new(place, "irregular stripes", allowed));
        }
        (system == SystemChoice::MeinhardtSpots).then(|| {
            let found = format!("{} with the system \"meinhardt-spots\"", self.irregular);
            let allowed =
                "0, its spots stay ellipses; for irregular ones the system \"turing-spots\" or \"auto\"";
            Problem::new(place, found, allowed)
        })
    }
}

impl Options {
    /// The problem that options at `place` say where marks begin although the layer beneath does, `after` which they come.
    #[must_use]
    pub fn placed(&self, place: &str, after: After) -> Option<Problem> {
        let told = [
            ("keep", self.keep == Some(true), "drawn marks that are kept"),
            ("seeding", self.seeding != Seeding::Noise, "a seeding"),
        ];
        let (key, _, what) =
            told.into_iter().find(|(_, told, _)| *told).filter(|_| after != After::Between)?;
        let found = format!("{what} with \"after\": \"{}\"", after.name());
        let allowed = "with \"between\" alone: here the marks of the layer beneath say where these grow";
        Some(Problem::new(format!("{place}.{key}"), found, allowed))
    }
}

impl SpreadChoice {
    /// The problem that a layer's `options` say at `place` how its marks differ although they are of `kind`.
    #[must_use]
    pub fn mismatch(place: &str, kind: Option<Kind>) -> Option<Problem> {
        let stripes = kind == Some(Kind::Line);
        stripes.then(|| Problem::new(place, "a spread of stripes", "no such key: only spots have a spread"))
    }
}

/// What stripes begin from, with its names in documents.
pub const SEEDINGS: [(&str, Seeding); 3] =
    [("noise", Seeding::Noise), ("segments", Seeding::Segments), ("initiators", Seeding::Initiators)];

impl Options {
    /// The problem that a layer's `options` say at `place` what its stripes begin from although its marks are of `kind`,
    /// or are thin lines, which nothing but noise along a tensor makes.
    fn seeding_mismatch(&self, place: &str, system: SystemChoice, kind: Option<Kind>) -> Option<Problem> {
        if self.seeding == Seeding::Noise {
            return None;
        }
        if system.grows().or(kind) == Some(Kind::Ellipse) {
            return Some(Problem::new(
                place,
                "a seeding of spots",
                "no such key: only stripes have a seeding",
            ));
        }
        let name = name_in(&SEEDINGS, self.seeding);
        (self.duty != Self::DUTY).then(|| {
            let found = format!("\"{name}\" with a duty of {}", self.duty);
            Problem::new(place, found, "\"noise\"; the others grow stripes of a duty of 0.5 alone")
        })
    }
}

/// How a layer meets the frozen marks beneath it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum After {
    /// It keeps away from them, as on a cheetah.
    #[default]
    Between,
    /// It rings them, as a leopard's rosettes.
    Around,
    /// It fills the space between them with a connected web, as on a giraffe.
    Net,
    /// A smaller mark at each place of the layer beneath, which itself is not shown.
    Inside,
}

impl After {
    /// All of them with their names in documents.
    pub const NAMES: [(&'static str, Self); 4] =
        [("between", Self::Between), ("around", Self::Around), ("net", Self::Net), ("inside", Self::Inside)];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_in(&Self::NAMES, self)
    }

    /// The keys that a layer's `options` may have with it, beside those of its system.
    #[must_use]
    pub fn option_keys(self) -> &'static [&'static str] {
        match self {
            Self::Around => &["broken"],
            Self::Between | Self::Net | Self::Inside => &[],
        }
    }
}

/// The name of `one` among these.
pub fn name_in<T: Copy + PartialEq>(names: &[(&'static str, T)], one: T) -> &'static str {
    names.iter().find(|(_, other)| *other == one).map_or("", |(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_takes_only_the_marks_it_grows() {
        assert_eq!(SystemChoice::Auto.mismatch("system", Kind::Line), None);
        assert_eq!(SystemChoice::TuringSpots.mismatch("system", Kind::Ellipse), None);
        let problem = SystemChoice::TuringSpots.mismatch("layers[0].system", Kind::Line).unwrap();
        assert_eq!(problem.allowed, "auto, meinhardt-stripes, meinhardt-lines");
    }
}
