//! `after: "around"` and `after: "net"`: lines around the marks beneath, or one web of lines between them.
//!
//! The lines begin along curves that are computed once the layers beneath have grown. Only the width of the lines is drawn. Their
//! rate follows from it by one law, and the correction of the threshold removes the last per cents.

use crate::attributes::{AttributeMap, Attributes, Polarity, Spots, Stripes};
use crate::document::After;
use crate::learn::{self, Answer};
use crate::rd::{LinesAlongCurves, System};
use crate::synth::error::PlanError;
use crate::synth::marks::plan::asked::Asked;
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};
use crate::synth::marks::plan::offset_curves::CurveKind;

/// The curves along which the lines of a layer run; `None` if they do not follow curves.
#[must_use]
pub fn curve_kind(after: After) -> Option<CurveKind> {
    match after {
        After::Around => Some(CurveKind::Rings),
        After::Net => Some(CurveKind::Web),
        After::Between | After::Near | After::Inside => None,
    }
}

/// Looks up lines of the width in `map`, from one law. The share `broken` of each ring will be open.
pub(super) fn look_up(kind: CurveKind, broken: f64, map: AttributeMap) -> Result<Lookup, PlanError> {
    let (system, laws) = System::ALL
        .into_iter()
        .find_map(|system| Some((system, system.definition().along_curves?)))
        .expect("a system grows along curves");
    let asked = |wanted: &Attributes, cell: f64| Ok(Asked::Law(Box::new(law(kind, &laws, wanted, cell))));
    let start = Start::Curves { kind, laws, broken };
    Lookup::new((system, Polarity::Positive), map, start, &asked)
}

/// What grows lines of this width along curves, on cells of `cell` px.
#[must_use]
pub fn law(kind: CurveKind, laws: &LinesAlongCurves, wanted: &Attributes, cell: f64) -> Answer {
    let law = kind.law(laws);
    let width = match wanted {
        Attributes::Stripes(stripes) => stripes.width,
        Attributes::Spots(spots) => spots.area.sqrt(),
    };
    let root = law.root_rate * cell / width;
    let parameters = learn::Parameters {
        rate: root * root,
        ratio: Some(laws.ratio),
        stretch: law.stretch,
        direction: 0.0,
        level: Some(0.5),
    };
    Answer::of_law(parameters, *wanted)
}

/// (Mean spacing of the spots − their diameter) ÷ the distance that lines between them need. Below the first value most
/// places have too little room, since the nearest neighbour of a spot is closer than the mean; below the second some have.
const TIGHT: [f64; 2] = [1.1, 1.5];

impl Lookup {
    /// A warning, before anything has grown, that there will be little room between the marks of the layer looked up `beneath`;
    /// `None` if there is enough.
    #[must_use]
    pub fn expected_room(&self, beneath: &Self) -> Option<String> {
        let kind = self.curve_kind().filter(|_| beneath.curve_kind().is_none())?;
        let layout = self.map.layout();
        let room = |(place, _)| {
            let center = layout.center(place);
            let Attributes::Stripes(Stripes { width, .. }) = self.map.at(center) else { return None };
            let gap = match beneath.map.at(center) {
                Attributes::Spots(Spots { area, spacing, .. }) => {
                    spacing? - 2.0 * (area / std::f64::consts::PI).sqrt()
                }
                Attributes::Stripes(stripes) => stripes.width,
            };
            Some((gap / width, gap, width))
        };
        let (room, gap, width) = self.map.regions().filter_map(room).min_by(|a, b| a.0.total_cmp(&b.0))?;
        let [lines, some] = match kind {
            CurveKind::Rings => ["rings", "some neighbours will share a wall"],
            CurveKind::Web => ["a web of lines", "some marks will be surrounded together"],
        };
        let tight = TIGHT.map(|tight| room < tight * kind.need());
        let then = match tight {
            [true, _] => {
                "grow will most likely refuse it; draw thinner lines, or the marks beneath farther apart"
            }
            [false, true] => some,
            [false, false] => return None,
        };
        Some(format!(
            "{lines} {width:.1} px wide need {:.1} px between the marks beneath, which will stand about {gap:.1} px \
             apart: {then}",
            kind.need() * width
        ))
    }
}
