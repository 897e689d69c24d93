//! How maps change what marks ask for, from place to place.

use super::regions::RegionGrid;
use super::{Attributes, Spots, Stripes};
use crate::marks::axial;

/// The narrowest and the roundest spots that a change leads to: minor ÷ major radius.
const ASPECTS: [f64; 2] = [0.2, 1.0];
/// The thinnest and the widest stripes that a change leads to, width ÷ period: those that `options.duty` may ask for.
const DUTIES: [f64; 2] = [0.18, 0.82];

/// What is changed of spots or stripes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modulated {
    /// The area of spots, px².
    Area,
    /// The spacing of spots, px; of stripes their period, px, with their width.
    Spacing,
    /// The direction, degrees.
    Direction,
    /// The aspect of spots.
    Aspect,
    /// Width ÷ period of stripes.
    Duty,
}

/// How a value changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The attribute is replaced by the value.
    Replace,
    /// The attribute is multiplied by the value.
    Multiply,
    /// Something is added.
    Add,
}

impl Change {
    /// The `value` as it is changed by a number.
    #[must_use]
    pub fn of(self, value: f64, by: f64) -> f64 {
        match self {
            Self::Replace => by,
            Self::Multiply => value * by,
            Self::Add => value + by,
        }
    }
}

/// One attribute changed by numbers at nodes over the canvas.
#[derive(Clone, Debug, PartialEq)]
pub struct ModulatedAttribute {
    /// The attribute that is changed.
    pub attribute: Modulated,
    /// How its value changes.
    pub change: Change,
    /// The numbers, by node.
    pub values: Vec<f64>,
}

/// How attributes change over a canvas.
#[derive(Clone, Debug, PartialEq)]
pub struct Modulation {
    /// The nodes.
    pub nodes: RegionGrid,
    /// What changes; each attribute at most once.
    pub attributes: Vec<ModulatedAttribute>,
}

impl Modulation {
    /// What is wanted at a point, px, where `base` was. `follows`: whether spots are as far apart as suits their area, because nothing else
    /// says so; their spacing then goes with √area.
    #[must_use]
    pub fn applied(&self, base: Attributes, point: [f64; 2], follows: bool) -> Attributes {
        let changed = |attribute: Modulated, value: f64| self.changed(attribute, value, point);
        modulated(base, &changed, self.replaces_spacing(), follows)
    }

    /// The `value` of one attribute as it is changed at a point, px; `None` where it does not change.
    #[must_use]
    pub fn changed(&self, attribute: Modulated, value: f64, point: [f64; 2]) -> Option<f64> {
        let map = self.attributes.iter().find(|map| map.attribute == attribute)?;
        let by = self.nodes.corners(point).iter().map(|&(node, weight)| weight * map.values[node]).sum();
        Some(map.change.of(value, by))
    }

    /// This modulation with directions that replace others turned by so many degrees.
    #[must_use]
    pub fn turned(&self, by: f64) -> Self {
        let mut turned = self.clone();
        let replaces = |map: &&mut ModulatedAttribute| {
            map.attribute == Modulated::Direction && map.change == Change::Replace
        };
        for map in turned.attributes.iter_mut().filter(replaces) {
            map.values.iter_mut().for_each(|angle| *angle += by);
        }
        turned
    }

    /// Whether spacings are replaced.
    #[must_use]
    pub fn replaces_spacing(&self) -> bool {
        self.attributes.iter().any(|map| map.attribute == Modulated::Spacing && map.change == Change::Replace)
    }

    /// Whether directions change.
    #[must_use]
    pub fn turns(&self) -> bool {
        self.changes(Modulated::Direction)
    }

    /// Whether this attribute changes.
    #[must_use]
    pub fn changes(&self, attribute: Modulated) -> bool {
        self.attributes.iter().any(|map| map.attribute == attribute)
    }

    /// This modulation over a canvas of another size, px.
    #[must_use]
    pub fn resized(&self, size: [f64; 2]) -> Self {
        Self { nodes: RegionGrid { size, ..self.nodes }, attributes: self.attributes.clone() }
    }
}

/// What is wanted where `base` was, with attributes that are `changed`; that gives `None` for those that are not. `replaces`: whether spacings
/// are replaced; `follows` as in [`Modulation::applied`].
#[must_use]
pub fn modulated(
    base: Attributes,
    changed: &dyn Fn(Modulated, f64) -> Option<f64>,
    replaces: bool,
    follows: bool,
) -> Attributes {
    let angle = |angle: f64| changed(Modulated::Direction, angle).map_or(angle, axial);
    match base {
        Attributes::Spots(spots) => {
            let area = changed(Modulated::Area, spots.area).unwrap_or(spots.area);
            let grown = if follows { (area / spots.area).sqrt() } else { 1.0 };
            let spacing = match spots.spacing.map(|spacing| grown * spacing) {
                Some(spacing) => Some(changed(Modulated::Spacing, spacing).unwrap_or(spacing)),
                // A free one stays free unless it is replaced.
                None if replaces => changed(Modulated::Spacing, 1.0),
                None => None,
            };
            let aspect = changed(Modulated::Aspect, spots.aspect);
            let aspect = aspect.map_or(spots.aspect, |aspect| aspect.clamp(ASPECTS[0], ASPECTS[1]));
            Attributes::Spots(Spots { area, aspect, angle: angle(spots.angle), spacing })
        }
        Attributes::Stripes(stripes) => {
            let usual = stripes.width / stripes.duty();
            let period = changed(Modulated::Spacing, usual).unwrap_or(usual);
            let duty = changed(Modulated::Duty, stripes.duty());
            let duty = duty.map_or(stripes.duty(), |duty| duty.clamp(DUTIES[0], DUTIES[1]));
            let wavelength = stripes.wavelength.map(|_| period);
            Attributes::Stripes(Stripes { width: duty * period, angle: angle(stripes.angle), wavelength })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    const SPOTS: Spots = Spots { area: 100.0, aspect: 0.8, angle: 170.0, spacing: Some(30.0) };

    /// A map of one attribute on a canvas of 100 × 50 px: `low` at 25 px and less from the left, `high` at 75 px and more.
    fn map(attribute: Modulated, change: Change, [low, high]: [f64; 2]) -> Modulation {
        let nodes = RegionGrid { size: [100.0, 50.0], grid: [2, 1], edges: Edges::Closed };
        Modulation {
            nodes,
            attributes: vec![ModulatedAttribute { attribute, change, values: vec![low, high] }],
        }
    }

    fn spots(map: &Modulation, x: f64, follows: bool) -> Spots {
        match map.applied(Attributes::Spots(SPOTS), [x, 10.0], follows) {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(_) => panic!("spots were given"),
        }
    }

    #[test]
    fn values_are_replaced_multiplied_or_added_and_linear_between_nodes() {
        let area = map(Modulated::Area, Change::Replace, [50.0, 150.0]);
        assert_eq!([10.0, 50.0, 90.0].map(|x| spots(&area, x, false).area), [50.0, 100.0, 150.0]);
        let spacing = map(Modulated::Spacing, Change::Multiply, [0.5, 2.0]);
        assert_eq!(spots(&spacing, 90.0, false), Spots { spacing: Some(60.0), ..SPOTS });
        let turned = map(Modulated::Direction, Change::Add, [0.0, 40.0]);
        assert!((spots(&turned, 90.0, false).angle - 30.0).abs() < 1e-9);
        let narrow = map(Modulated::Aspect, Change::Multiply, [0.1, 10.0]);
        assert_eq!([10.0, 90.0].map(|x| spots(&narrow, x, false).aspect), ASPECTS);
    }

    #[test]
    fn a_spacing_that_nothing_asks_for_goes_with_the_size_of_spots() {
        let area = map(Modulated::Area, Change::Multiply, [1.0, 4.0]);
        assert_eq!(
            [false, true].map(|follows| spots(&area, 90.0, follows).spacing),
            [Some(30.0), Some(60.0)]
        );
    }

    #[test]
    fn of_stripes_a_spacing_keeps_the_duty_and_a_duty_the_period() {
        let stripes = Stripes { width: 6.0, angle: 0.0, wavelength: Some(20.0) };
        let changed = |map: Modulation| match map.applied(Attributes::Stripes(stripes), [90.0, 10.0], false) {
            Attributes::Stripes(stripes) => stripes,
            Attributes::Spots(_) => panic!("stripes were given"),
        };
        let wide = changed(map(Modulated::Spacing, Change::Multiply, [1.0, 2.0]));
        assert_eq!(wide, Stripes { width: 12.0, wavelength: Some(40.0), ..stripes });
        let bold = changed(map(Modulated::Duty, Change::Replace, [0.3, 0.6]));
        assert_eq!(bold, Stripes { width: 12.0, ..stripes });
    }
}
