//! The marks that are drawn for run i of a set of pairs.

use dapple_engine::synth::Drawn;

use crate::draw::point;
use crate::plan::{Range, Set};

/// A quantity that can be varied: its name, its unit, its lowest and highest value, and its place in what is drawn.
pub struct Quantity {
    /// Its name in plans.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Lowest and highest value.
    pub allowed: [f64; 2],
    /// The systems that have it.
    pub of: &'static [&'static str],
    /// Its range in a set.
    pub range: fn(&Set) -> Option<&Range>,
    /// The place of the value in what is drawn.
    value: fn(&mut Drawn) -> Place<'_>,
}

/// A place for a number in what is drawn.
enum Place<'a> {
    Real(&'a mut f64),
    Whole(&'a mut usize),
}

/// All quantities, in the order in which they are drawn.
pub const QUANTITIES: [Quantity; 11] = [
    Quantity {
        name: "directions",
        unit: "directions",
        allowed: [2.0, 5.0],
        of: &["weave", "maze"],
        range: |set| set.sweep.directions.as_ref(),
        value: |drawn| Place::Whole(&mut drawn.directions),
    },
    Quantity {
        name: "duty",
        unit: "width/period",
        allowed: [0.1, 0.8],
        of: &["weave", "pair-stripes"],
        range: |set| set.sweep.duty.as_ref(),
        value: |drawn| Place::Real(&mut drawn.duty),
    },
    Quantity {
        name: "others",
        unit: "width/period",
        allowed: [0.1, 0.8],
        of: &["weave"],
        range: |set| set.sweep.others.as_ref(),
        value: |drawn| Place::Real(&mut drawn.others),
    },
    Quantity {
        name: "unequal",
        unit: "period/period",
        allowed: [0.2, 5.0],
        of: &["weave"],
        range: |set| set.sweep.unequal.as_ref(),
        value: |drawn| Place::Real(&mut drawn.unequal),
    },
    Quantity {
        name: "between",
        unit: "degrees",
        allowed: [30.0, 90.0],
        of: &["weave", "maze"],
        range: |set| set.sweep.between.as_ref(),
        value: |drawn| Place::Real(&mut drawn.between),
    },
    Quantity {
        name: "direction",
        unit: "degrees",
        allowed: [0.0, 180.0],
        of: &["weave", "maze", "pair-stripes", "cells"],
        range: |set| set.sweep.direction.as_ref(),
        value: |drawn| Place::Real(&mut drawn.angle),
    },
    Quantity {
        name: "long",
        unit: "length/period",
        allowed: [1.0, 20.0],
        of: &["maze"],
        range: |set| set.sweep.long.as_ref(),
        value: |drawn| Place::Real(&mut drawn.long),
    },
    Quantity {
        name: "level",
        unit: "of X = 0",
        allowed: [0.3, 1.7],
        of: &["maze"],
        range: |set| set.sweep.level.as_ref(),
        value: |drawn| Place::Real(&mut drawn.level),
    },
    Quantity {
        name: "decay",
        unit: "of the gain",
        allowed: [0.0, 0.85],
        of: &["stucco"],
        range: |set| set.sweep.decay.as_ref(),
        value: |drawn| Place::Real(&mut drawn.decay),
    },
    Quantity {
        name: "sparse",
        unit: "side/gap",
        allowed: [2.5, 30.0],
        of: &["cells"],
        range: |set| set.sweep.sparse.as_ref(),
        value: |drawn| Place::Real(&mut drawn.sparse),
    },
    Quantity {
        name: "aspect",
        unit: "minor/major",
        allowed: [0.3, 1.0],
        of: &["cells"],
        range: |set| set.sweep.aspect.as_ref(),
        value: |drawn| Place::Real(&mut drawn.aspect),
    },
];

/// The quantities of the system of `set`.
pub fn quantities(set: &Set) -> impl Iterator<Item = &'static Quantity> {
    let name = set.system.name();
    QUANTITIES.iter().filter(move |quantity| quantity.of.contains(&name))
}

/// What is drawn for run `index` of `set`, and its quantities by name.
pub fn drawn(set: &Set, index: u64) -> (Drawn, Vec<(&'static str, f64)>) {
    let varied = |quantity: &&Quantity| (quantity.range)(set).is_some_and(Range::varies);
    let point = point(index, quantities(set).filter(varied).count(), set.seed);
    let (mut next, mut drawn, mut named) = (point.into_iter(), Drawn::default(), Vec::new());
    for quantity in quantities(set) {
        let Some(range) = (quantity.range)(set) else { continue };
        let share = if range.varies() { next.next().unwrap_or(0.0) } else { 0.0 };
        let value = match (quantity.value)(&mut drawn) {
            Place::Real(place) => {
                *place = range.at(share);
                *place
            }
            Place::Whole(place) => {
                let [low, high] = range.range;
                *place = (low + (share * (high - low + 1.0)).floor()).min(high) as usize;
                *place as f64
            }
        };
        named.push((quantity.name, value));
    }
    (drawn, named)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Plan;
    use crate::swept::Swept;

    #[test]
    fn runs_stay_within_the_ranges_of_the_plan_and_reach_their_ends() {
        let sets = Plan::built_in().unwrap().sets.into_iter();
        let sets: Vec<Set> = sets.filter(|set| matches!(set.system, Swept::Pairs(_))).collect();
        assert_eq!(sets.len(), 5);
        for set in sets {
            let runs: Vec<_> = (0..set.runs).map(|index| drawn(&set, index).1).collect();
            for quantity in quantities(&set) {
                let [from, to] = (quantity.range)(&set).unwrap().range;
                let values =
                    runs.iter().map(|run| run.iter().find(|(name, _)| *name == quantity.name).unwrap().1);
                let [low, high] = values.fold([f64::MAX, f64::MIN], |[l, h], x| [l.min(x), h.max(x)]);
                let reach = 0.06 * (to - from);
                let name = quantity.name;
                assert!(from <= low && low <= from + reach, "{} {name}: {low}", set.name);
                assert!(to - reach <= high && high <= to, "{} {name}: {high}", set.name);
            }
        }
    }
}
