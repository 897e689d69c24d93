//! The system that grows a layer on a model, and which phase of its stripes.

use crate::attributes::system::{Description, MarkKind};
use crate::attributes::{Attributes, Polarity};
use crate::document::{Layer, SystemChoice};
use crate::learn::{Answer, Parameters};
use crate::rd::pairs::PairKind;
use crate::rd::{LinesAlongCurves, System};
use crate::synth::body::area_form::AreaForm;
use crate::synth::marks::plan::around::curve_kind;
use crate::synth::marks::plan::offset_curves::CurveKind;

/// What grows a layer.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The system.
    pub system: System,
    /// Whether stripes are its lines, or the gaps between them.
    pub polarity: Polarity,
    /// The curves round or between the marks beneath that its lines run along, and the laws of these; `None` where they run freely.
    pub curves: Option<(CurveKind, LinesAlongCurves)>,
    /// The kind of pair of morphogens, which does not grow by `system`; `None` of other marks.
    pub pair: Option<PairKind>,
    /// The form of patches or cells, which do not react: `system` lays their places; `None` of other marks.
    pub areas: Option<AreaForm>,
}

/// Whether a system grows on models.
#[must_use]
pub fn grows(system: System) -> bool {
    system.definition().by_rows.is_some()
}

/// The systems that grow on models.
pub fn systems() -> impl Iterator<Item = System> {
    System::ALL.into_iter().filter(|system| grows(*system))
}

impl Choice {
    /// What grows a layer that asks for these attributes. Where the layer leaves its system open, spots take the first one of which
    /// is known what a coarse mesh does to it, and stripes one with a free wavelength where they have one.
    ///
    /// `None` where it asks for a system that does not grow on models, or for one of other marks.
    #[must_use]
    pub fn new(layer: &Layer, wanted: &[Attributes], areas: Option<AreaForm>) -> Option<Self> {
        let first = wanted.first()?;
        if let Some(kind) = curve_kind(layer.after) {
            let along = |system: System| Some((system, system.definition().along_curves?));
            let (system, laws) = systems().find_map(along)?;
            return Some(Self { curves: Some((kind, laws)), ..Self::of(system) });
        }
        let open = match first {
            Attributes::Spots(_) => systems().find(|system| system.definition().fineness.is_some()),
            Attributes::Stripes(stripes) => {
                SystemChoice::system_of_stripes(stripes.wavelength.is_some()).filter(|system| grows(*system))
            }
        };
        if areas.is_some() {
            let is_spots = wanted.iter().all(|wanted| matches!(wanted, Attributes::Spots(_)));
            return open.filter(|_| is_spots).map(|system| Self { areas, ..Self::of(system) });
        }
        let system = match layer.wanted_system() {
            SystemChoice::Auto | SystemChoice::Stripes => open?,
            given => given.system().filter(|system| grows(*system))?,
        };
        let is_striped = matches!(first, Attributes::Stripes(_));
        if is_striped != (system.description().marks == MarkKind::Stripes) {
            return None;
        }
        let duties = wanted.iter().filter_map(|wanted| match wanted {
            Attributes::Stripes(stripes) if stripes.wavelength.is_some() => Some(stripes.duty()),
            _ => None,
        });
        let (sum, count) = duties.fold((0.0, 0), |(sum, count), duty| (sum + duty, count + 1));
        let polarity =
            if count == 0 { Polarity::Positive } else { Polarity::of_duty(sum / f64::from(count)) };
        Some(Self { polarity, ..Self::of(system) })
    }

    /// Marks of a system that grow freely.
    #[must_use]
    pub const fn of(system: System) -> Self {
        Self { system, polarity: Polarity::Positive, curves: None, pair: None, areas: None }
    }

    /// Stripes with tips; `None` where no system has stripes at any distance, by whose rules they are read.
    #[must_use]
    pub fn of_pair_stripes() -> Option<Self> {
        let system = SystemChoice::system_of_stripes(true).filter(|system| grows(*system))?;
        Some(Self { pair: Some(PairKind::Stripes), ..Self::of(system) })
    }

    /// The parameters of marks of which nothing is looked up, because another law than that of `system` gives their sizes.
    #[must_use]
    pub fn no_parameters(wanted: &Attributes) -> Answer {
        let parameters =
            Parameters { rate: 1.0, ratio: None, stretch: 1.0, direction: 0.0, level: Some(0.5) };
        Answer::of_law(parameters, *wanted)
    }

    /// The description of what grows.
    #[must_use]
    pub fn description(&self) -> &'static Description {
        if let Some(kind) = self.pair {
            return kind.description();
        }
        self.areas.map_or(self.system.description(), |form| form.description())
    }
}
