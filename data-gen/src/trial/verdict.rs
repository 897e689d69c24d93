//! Checks that a texture has grown everywhere, and as separate marks.

use std::fmt;

use dapple_engine::attributes::AttributeMap;
use dapple_engine::attributes::Attributes;
use dapple_engine::attributes::regions::RegionGrid;
use dapple_engine::grid::Field;
use dapple_engine::measure::Spot;

/// Why a grown document is not the requested texture.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// The growth failed.
    NotGrown(String),
    /// A value is not finite.
    BlownUp,
    /// Nothing has formed.
    Blank {
        /// Highest − lowest value of the pattern.
        range: f32,
    },
    /// Marks have merged.
    Merged {
        /// The share of the area that is not elliptical; for a region of stripes, the share that is stripe.
        share: f64,
    },
    /// Stripes have no common direction.
    Incoherent {
        /// Mean coherence of the structure tensor.
        coherence: f64,
    },
    /// A region holds fewer than half of its marks.
    HalfEmpty {
        /// [column, row].
        region: [usize; 2],
        /// Marks that were found, or the share of the region that is stripe.
        found: f64,
        /// Marks, or the share of the region that is stripe, that are expected.
        expected: f64,
    },
}

impl Failure {
    /// The kind of failure in one or two words, for counting.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NotGrown(_) => "not grown",
            Self::BlownUp => "blown up",
            Self::Blank { .. } => "blank",
            Self::Merged { .. } => "merged",
            Self::Incoherent { .. } => "incoherent",
            Self::HalfEmpty { .. } => "half empty",
        }
    }
}

/// All kinds, worst first.
pub const KINDS: [&str; 6] = ["not grown", "blown up", "blank", "merged", "incoherent", "half empty"];

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::NotGrown(why) => write!(f, "not grown: {why}"),
            Self::BlownUp => write!(f, "blown up"),
            Self::Blank { range } => write!(f, "blank: the pattern spans {range:.3}"),
            Self::Merged { share } => write!(f, "merged: {:.0} % of the area", 100.0 * share),
            Self::Incoherent { coherence } => {
                write!(f, "incoherent: {coherence:.2}, at least {COHERENCE} is wanted")
            }
            Self::HalfEmpty { region: [column, row], found, expected } => {
                write!(f, "half empty: region {column},{row} holds {found:.2} of {expected:.2}")
            }
        }
    }
}

/// The range of a pattern below which nothing has formed.
const RANGE: f32 = 0.1;
/// An ellipse fills all of the ellipse with its second moments (1); two that grew together fill less than this.
const FILL: f64 = 0.93;
/// A mark whose area is more than this many times the asked one is several that grew together. Only this detects a net
/// that touches a closed edge all around.
const HUGE: f64 = 2.5;
/// The largest allowed share of the area in marks that fill less than [`FILL`].
const BENT: f64 = 0.05;
/// A region with less than this share of its marks is half empty.
const HALF: f64 = 0.5;
/// The least mean coherence of stripes. A labyrinth reaches 0.48, good stripes 0.98.
const COHERENCE: f64 = 0.9;
/// Points along each side of a region at which the map is read.
const POINTS: usize = 8;

/// The failures that any pattern can have.
pub fn of_any(pattern: &Field) -> Option<Failure> {
    if !pattern.values.iter().all(|value| value.is_finite()) {
        return Some(Failure::BlownUp);
    }
    let low = pattern.values.iter().copied().fold(f32::INFINITY, f32::min);
    let high = pattern.values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    (high - low < RANGE).then_some(Failure::Blank { range: high - low })
}

/// The failures of a pattern of spots.
pub fn of_spots(spots: &[Spot], map: &AttributeMap) -> Vec<Failure> {
    let layout = map.layout();
    let mut failures = Vec::new();
    let area = |counts: &dyn Fn(&Spot) -> bool| -> f64 {
        spots.iter().filter(|spot| counts(spot)).map(|spot| spot.ellipse.area()).sum()
    };
    let huge = |spot: &Spot| match map.at(spot.ellipse.center) {
        Attributes::Spots(wanted) => spot.ellipse.area() > HUGE * wanted.area,
        Attributes::Stripes(_) => false,
    };
    let bent = area(&|spot| spot.endless || spot.whole && spot.fill < FILL || huge(spot));
    let share = bent / area(&|_| true).max(f64::MIN_POSITIVE);
    if share > BENT {
        failures.push(Failure::Merged { share });
    }
    let mut found = vec![0.0; layout.len()];
    for spot in spots {
        found[layout.index(layout.region_of(spot.ellipse.center))] += 1.0;
    }
    for (index, found) in found.into_iter().enumerate() {
        let expected = expected(map, index);
        if found < HALF * expected {
            failures.push(Failure::HalfEmpty { region: layout.place(index), found, expected });
        }
    }
    failures
}

/// The number of spots that fit into a region: ∫ dA ÷ (√¾ · spacing²), that of a hexagonal lattice; 0 where the spacing
/// is free.
fn expected(map: &AttributeMap, index: usize) -> f64 {
    let layout = map.layout();
    let share = layout.size[0] * layout.size[1] / (layout.len() * POINTS * POINTS) as f64;
    let mut sum = 0.0;
    for point in points(layout, index) {
        if let Attributes::Spots(wanted) = map.at(point)
            && let Some(spacing) = wanted.spacing
        {
            sum += share / (0.75f64.sqrt() * spacing * spacing);
        }
    }
    sum
}

fn points(layout: &RegionGrid, index: usize) -> impl Iterator<Item = [f64; 2]> {
    let (place, size) = (layout.place(index), layout.size.map(|side| side / POINTS as f64));
    let grid = layout.grid;
    let at = move |axis: usize, k: usize| {
        (place[axis] * POINTS) as f64 * size[axis] / grid[axis] as f64
            + (k as f64 + 0.5) * size[axis] / grid[axis] as f64
    };
    (0..POINTS * POINTS).map(move |k| [at(0, k % POINTS), at(1, k / POINTS)])
}

/// The failures of a pattern of stripes, of which `duty` of the canvas should be stripe. A region has at least [`HALF`]
/// of that share, and at most as much more.
pub fn of_stripes(pattern: &Field, layout: &RegionGrid, duty: f64) -> Vec<Failure> {
    let (mut inside, mut all) = (vec![0.0; layout.len()], vec![0.0; layout.len()]);
    for (px, value) in pattern.values.iter().enumerate() {
        let place = [(px % pattern.width) as f64 + 0.5, (px / pattern.width) as f64 + 0.5];
        let region = layout.index(layout.region_of([place[0] * pattern.cell[0], place[1] * pattern.cell[1]]));
        all[region] += 1.0;
        inside[region] += f64::from(u8::from(*value >= 0.5));
    }
    let mut failures = Vec::new();
    for index in 0..layout.len() {
        let found: f64 = inside[index] / all[index];
        if found < HALF * duty {
            failures.push(Failure::HalfEmpty { region: layout.place(index), found, expected: duty });
        } else if found > (2.0 - HALF) * duty {
            failures.push(Failure::Merged { share: found });
        }
    }
    let coherence = dapple_engine::measure::stripes(pattern, 0.5).map_or(0.0, |found| found.coherence);
    if coherence < COHERENCE {
        failures.push(Failure::Incoherent { coherence });
    }
    failures
}

#[cfg(test)]
mod tests {
    use super::*;
    use dapple::document::Edges;
    use dapple_engine::marks::{Ellipse, Mark};
    use dapple_engine::measure::spots;

    /// Two regions of spots of area 100 px² every 40 px; `keep` says which of a square lattice are there.
    fn judged(keep: impl Fn([usize; 2]) -> bool, radius: f64) -> Vec<Failure> {
        let drawn = [[20.0, 20.0], [60.0, 20.0], [20.0, 60.0], [220.0, 20.0], [260.0, 20.0], [220.0, 60.0]];
        let drawn = drawn.map(|center| Mark::Ellipse(Ellipse::from_area(center, 100.0, 1.0, 0.0)));
        let map = AttributeMap::from_marks(&drawn, [400.0, 200.0], Some([2, 1]), Edges::Closed).unwrap();
        let pattern = Field::from_fn([400, 200], [1.0, 1.0], Edges::Closed, |[x, y]| {
            let place = [(x / 40.0) as usize, (y / 40.0) as usize];
            let [dx, dy] = [x.rem_euclid(40.0) - 20.0, y.rem_euclid(40.0) - 20.0];
            if keep(place) { (1.0 - 0.5 * (dx * dx + dy * dy).sqrt() / radius).max(0.0) as f32 } else { 0.0 }
        });
        of_any(&pattern).into_iter().chain(of_spots(&spots(&pattern, 0.5), &map)).collect()
    }

    #[test]
    fn stripes_that_run_both_ways_are_incoherent() {
        let layout = RegionGrid { size: [160.0, 160.0], grid: [1, 1], edges: Edges::Wrap };
        let wave = |x: f64| libm::sin(x * std::f64::consts::TAU / 16.0);
        let judged = |both: f64| {
            let value = |[x, y]: [f64; 2]| (0.5 + 0.4 * (wave(x) + both * wave(y)) / (1.0 + both)) as f32;
            let pattern = Field::from_fn([160, 160], [1.0, 1.0], Edges::Wrap, value);
            of_stripes(&pattern, &layout, 0.5).iter().map(Failure::kind).collect::<Vec<_>>()
        };
        assert_eq!(judged(0.0), [""; 0]);
        assert_eq!(judged(1.0), ["incoherent"]);
    }

    #[test]
    fn stripes_are_half_empty_where_they_cover_less_than_half_of_the_requested_share() {
        let layout = RegionGrid { size: [160.0, 160.0], grid: [1, 1], edges: Edges::Wrap };
        let judged = |covered: f64, duty: f64| {
            let value = |[x, _]: [f64; 2]| {
                let apart = ((x / 16.0).fract() - 0.5).abs() * 2.0;
                (0.5 + 0.5 * (covered - apart)).clamp(0.0, 1.0) as f32
            };
            let pattern = Field::from_fn([160, 160], [1.0, 1.0], Edges::Wrap, value);
            of_stripes(&pattern, &layout, duty).iter().map(Failure::kind).collect::<Vec<_>>()
        };
        assert_eq!(judged(0.15, 0.2), [""; 0]);
        assert_eq!(judged(0.15, 0.5), ["half empty"]);
        assert_eq!(judged(0.5, 0.2), ["merged"]);
    }

    #[test]
    fn a_full_canvas_is_good_and_missing_or_merged_marks_are_reported() {
        assert_eq!(judged(|_| true, 6.0), []);
        let kinds = |failures: Vec<Failure>| failures.iter().map(Failure::kind).collect::<Vec<_>>();
        assert_eq!(kinds(judged(|_| false, 6.0)), ["blank", "half empty", "half empty"]);
        assert_eq!(kinds(judged(|[x, _]| x < 5, 6.0)), ["half empty"]);
        assert!(kinds(judged(|_| true, 21.0)).contains(&"merged"));
    }
}
