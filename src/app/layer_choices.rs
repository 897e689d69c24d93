//! What can be chosen for a layer, and in plain words why not.

use crate::app::desk::Desk;
use crate::document::{After, Kind, Layer, Options, Seeding, SpreadChoice, SystemChoice};

/// Why layer `layer` cannot meet those beneath like this; `None` where it can.
#[must_use]
pub fn after_refusal(desk: &Desk, layer: usize, after: After) -> Option<&'static str> {
    if after == After::Between {
        return None;
    }
    let Some(beneath) = desk.beneath(layer) else {
        return Some("Nothing lies beneath this layer: it grows freely");
    };
    let (own, there) = (desk.kind(layer), desk.kind(beneath));
    match after {
        After::Around | After::Net if own == Some(Kind::Ellipse) => {
            Some("Rings and webs are drawn as lines, whose width is theirs; this layer holds ellipses")
        }
        After::Inside if own == Some(Kind::Line) => {
            Some("A spot grows inside each spot beneath; this layer holds lines")
        }
        After::Inside if there == Some(Kind::Line) => {
            Some("A spot grows inside each spot beneath; the layer beneath holds lines, which have no places")
        }
        _ => None,
    }
}

/// Why layer `layer` cannot be grown by this system; `None` where it can.
#[must_use]
pub fn system_refusal(desk: &Desk, layer: usize, system: SystemChoice) -> Option<&'static str> {
    let of = desk.document().layers.get(layer)?;
    match of.after {
        After::Around | After::Net
            if !matches!(system, SystemChoice::Auto | SystemChoice::MeinhardtLines) =>
        {
            return Some("Rings and webs are Meinhardt's lines");
        }
        After::Inside if system == SystemChoice::TuringSpots => {
            return Some("Turing's spots fill all the space between the places, too");
        }
        After::Inside if system.grows() == Some(Kind::Line) => return Some("Inside spots grow spots"),
        _ => {}
    }
    match (system.grows()?, desk.kind(layer)?) {
        (Kind::Line, Kind::Ellipse) => Some("It grows stripes; this layer holds ellipses"),
        (Kind::Ellipse, Kind::Line) => Some("It grows spots; this layer holds lines"),
        _ => None,
    }
}

/// An option of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// `spread`
    Spread,
    /// `irregular`
    Irregular,
    /// `keep`
    Keep,
    /// `duty`
    Duty,
    /// `seeding`
    Seeding,
    /// `broken`
    Broken,
}

impl Choice {
    /// All, as they stand.
    pub const ALL: [Self; 6] =
        [Self::Spread, Self::Irregular, Self::Duty, Self::Seeding, Self::Broken, Self::Keep];

    /// Its key in a document.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Spread => "spread",
            Self::Irregular => "irregular",
            Self::Keep => "keep",
            Self::Duty => "duty",
            Self::Seeding => "seeding",
            Self::Broken => "broken",
        }
    }

    /// Whether `layer`, whose marks are of `kind`, has this option at all.
    #[must_use]
    pub fn is_of(self, layer: &Layer, kind: Option<Kind>) -> bool {
        if !layer.system.option_keys().contains(&self.key())
            && !layer.after.option_keys().contains(&self.key())
        {
            return false;
        }
        let kind = kind_of(layer, kind);
        let free = layer.after == After::Between;
        match self {
            Self::Spread => kind == Some(Kind::Ellipse),
            Self::Irregular => kind == Some(Kind::Ellipse) && layer.after != After::Inside,
            Self::Keep => kind.is_some() && free,
            Self::Duty | Self::Seeding => kind == Some(Kind::Line) && free,
            Self::Broken => true,
        }
    }

    /// Why it cannot be changed as things are; `None` where it can.
    #[must_use]
    pub fn refusal(self, layer: &Layer) -> Option<&'static str> {
        match (self, layer.system) {
            (Self::Irregular, SystemChoice::MeinhardtSpots) => {
                Some("The spots of Meinhardt's system stay ellipses; Turing's can be irregular")
            }
            (Self::Duty, SystemChoice::MeinhardtStripes) => Some(
                "Meinhardt's stripes are as wide as their gaps; for thinner ones choose Meinhardt's lines or automatic",
            ),
            (Self::Duty, _) if layer.options.seeding != Seeding::Noise => {
                Some("Stripes that do not begin from noise are as wide as their gaps")
            }
            (Self::Seeding, _) if layer.options.duty != Options::DUTY => {
                Some("Thin stripes begin from noise alone; a share of 50 % lets you choose")
            }
            _ => None,
        }
    }

    /// Is it as it would be if nobody had said anything?
    #[must_use]
    pub fn is_default(self, options: &Options) -> bool {
        let mut reset = *options;
        self.reset(&mut reset);
        reset == *options
    }

    /// Makes it so.
    pub fn reset(self, options: &mut Options) {
        let default = Options::default();
        match self {
            Self::Spread => options.spread = default.spread,
            Self::Irregular => options.irregular = default.irregular,
            Self::Keep => options.keep = default.keep,
            Self::Duty => options.duty = default.duty,
            Self::Seeding => options.seeding = default.seeding,
            Self::Broken => options.broken = default.broken,
        }
    }
}

/// What a layer grows: its system says so, or how it meets those beneath, or its marks.
fn kind_of(layer: &Layer, held: Option<Kind>) -> Option<Kind> {
    let met = match layer.after {
        After::Between => None,
        After::Around | After::Net => Some(Kind::Line),
        After::Inside => Some(Kind::Ellipse),
    };
    layer.system.grows().or(met).or(held)
}

/// Puts back to its default what a document may not hold beside the rest of the layer, whose marks are of `kind`.
pub fn tidy(layer: &mut Layer, kind: Option<Kind>) {
    let allowed = match layer.after {
        After::Between => true,
        After::Around | After::Net => {
            matches!(layer.system, SystemChoice::Auto | SystemChoice::MeinhardtLines)
        }
        After::Inside => matches!(layer.system, SystemChoice::Auto | SystemChoice::MeinhardtSpots),
    };
    if !allowed {
        layer.system = SystemChoice::Auto;
    }
    if layer.after != After::Between {
        layer.options.keep = layer.options.keep.filter(|keep| !keep);
        layer.options.seeding = Seeding::Noise;
        layer.options.duty = Options::DUTY;
    }
    let options = &mut layer.options;
    if layer.after != After::Around {
        options.broken = 0.0;
    }
    if layer.after == After::Inside || layer.system == SystemChoice::MeinhardtSpots {
        options.irregular = 0.0;
    }
    if layer.system == SystemChoice::MeinhardtStripes {
        options.duty = Options::DUTY;
    }
    if layer.system == SystemChoice::MeinhardtLines || options.duty != Options::DUTY {
        options.seeding = Seeding::Noise;
    }
    match kind_of(layer, kind) {
        Some(Kind::Line) => {
            layer.options.spread = SpreadChoice::Drawn;
            layer.options.irregular = 0.0;
        }
        Some(Kind::Ellipse) => {
            layer.options.duty = Options::DUTY;
            layer.options.seeding = Seeding::Noise;
        }
        None => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::Spread;
    use crate::document::{Document, Stroke};
    use crate::marks::{Ellipse, Line};
    use proptest::prelude::*;

    fn stroke(ellipse: bool) -> Stroke {
        if ellipse {
            Stroke::Ellipse(Ellipse { center: [100.0, 100.0], radii: [10.0, 8.0], angle: 0.0 })
        } else {
            Stroke::Line(Line { from: [50.0, 50.0], to: [150.0, 50.0], width: 6.0 })
        }
    }

    fn any_options() -> impl Strategy<Value = Options> {
        let spread = prop_oneof![
            Just(SpreadChoice::Drawn),
            (0.0..0.6f64, 0.0..45.0f64).prop_map(|(area, angle)| SpreadChoice::Given(Spread {
                area,
                angle,
                ..Spread::EVEN
            })),
        ];
        let duty = prop_oneof![Just(0.5), 0.2..0.5f64];
        let share = || prop_oneof![Just(0.0), 0.0..0.6f64];
        let seeding = prop::sample::select(vec![Seeding::Noise, Seeding::Segments, Seeding::Initiators]);
        let keep = prop::option::of(any::<bool>());
        (spread, duty, share(), share(), keep, seeding).prop_map(
            |(spread, duty, broken, irregular, keep, seeding)| Options {
                spread,
                duty,
                broken,
                irregular,
                keep,
                seeding,
            },
        )
    }

    proptest! {
        #[test]
        fn a_layer_that_was_tidied_may_stand_in_a_document(
            options in any_options(),
            system in prop::sample::select(SystemChoice::NAMES.to_vec()),
            after in prop::sample::select(After::NAMES.to_vec()),
            ellipse: bool,
        ) {
            let (system, after) = (system.1, after.1);
            let kind = if ellipse { Kind::Ellipse } else { Kind::Line };
            // What holds other marks than its system or its way to meet others wants is not offered.
            prop_assume!(system.grows().is_none_or(|grown| grown == kind));
            let met = match after {
                After::Between => kind,
                After::Around | After::Net => Kind::Line,
                After::Inside => Kind::Ellipse,
            };
            prop_assume!(met == kind);
            let beneath = Layer { strokes: vec![stroke(true)], ..Layer::default() };
            let mut layer = Layer { system, after, options, strokes: vec![stroke(ellipse)], ..Layer::default() };
            tidy(&mut layer, Some(kind));
            let once = layer.clone();
            tidy(&mut layer, Some(kind));
            prop_assert_eq!(&layer, &once);
            let named = |name: &str, layer: Layer| Layer { name: name.to_owned(), ..layer };
            let document =
                Document { layers: vec![named("a", beneath), named("b", layer)], ..Document::default() };
            let again = Document::parse(&document.to_json(), "itself");
            prop_assert_eq!(again.map_err(|error| error.to_string()), Ok(document));
        }
    }

    #[test]
    fn only_the_options_that_a_layer_takes_are_offered() {
        let offered = |layer: &Layer, kind| {
            let of = Choice::ALL.into_iter().filter(|choice| choice.is_of(layer, kind));
            of.map(Choice::key).collect::<Vec<_>>()
        };
        let mut layer = Layer::default();
        assert_eq!(offered(&layer, Some(Kind::Ellipse)), ["spread", "irregular", "keep"]);
        assert_eq!(offered(&layer, Some(Kind::Line)), ["duty", "seeding", "keep"]);
        assert!(offered(&layer, None).is_empty());
        layer.system = SystemChoice::MeinhardtLines;
        assert_eq!(offered(&layer, Some(Kind::Line)), ["duty", "keep"]);
        layer.after = After::Around;
        assert_eq!(offered(&layer, Some(Kind::Line)), ["broken"]);
        layer = Layer { after: After::Inside, ..Layer::default() };
        assert_eq!(offered(&layer, Some(Kind::Ellipse)), ["spread"]);
    }

    #[test]
    fn the_lowest_layer_meets_nothing_and_is_told_so() {
        let mut desk = Desk::open(Document::default(), None);
        desk.edit(|document| {
            document.layers.push(Layer { strokes: vec![stroke(false)], ..Layer::default() });
        });
        assert_eq!(after_refusal(&desk, 0, After::Between), None);
        for after in [After::Around, After::Net, After::Inside] {
            assert!(after_refusal(&desk, 0, after).unwrap().contains("beneath"));
        }
        desk.edit(|document| {
            document.layers.push(Layer { strokes: vec![stroke(false)], ..Layer::default() });
        });
        assert_eq!(after_refusal(&desk, 1, After::Around), None);
        assert!(after_refusal(&desk, 1, After::Inside).unwrap().contains("lines"));
        assert!(system_refusal(&desk, 1, SystemChoice::TuringSpots).unwrap().contains("spots"));
        assert_eq!(system_refusal(&desk, 1, SystemChoice::MeinhardtLines), None);
    }
}
