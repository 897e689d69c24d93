//! Stripes along given lines: the initial noise gets its crests there.
//!
//! n′ = (1 − W) n + Σᵢ wᵢ A cos(2π dᵢ/λ) ÷ max(1, Σᵢ wᵢ), W = min(1, Σᵢ wᵢ). dᵢ is the distance across line i; wᵢ is 1 beside the
//! line and falls to 0 across it and beyond its ends.

use std::f64::consts::TAU;

use rayon::prelude::*;

use crate::grid::{Bounds, BoxTiles, Domain, Edges};
use crate::rd::parameter_field::{ParameterField, Parameters};

/// A straight line along which a stripe should run, in shares of the canvas' sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GuideLine {
    /// One end.
    pub from: [f64; 2],
    /// The other end.
    pub to: [f64; 2],
}

/// Height of the wave ÷ the noise's deviation.
pub(super) const HEIGHT: f64 = 2.0;
/// How far from a line the noise follows it, in wavelengths: up to the first distance the wave has its full amplitude, at the
/// second it ends.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// Beyond the ends of the line.
    pub beyond: [f64; 2],
    /// To its sides.
    pub across: [f64; 2],
}

/// The wavelength of the stripes that have these parameters, cells.
pub type Wavelength<'a> = &'a (dyn Fn(&Parameters) -> f64 + Sync);

/// Adds wave crests along these lines to `noise` over the grid of `maps`, which has unit variance.
pub fn lead(
    noise: &mut [f32],
    maps: &ParameterField,
    lines: &[GuideLine],
    wavelength: Wavelength,
    reach: Reach,
) {
    if lines.is_empty() {
        return;
    }
    let guide = Guide::new(maps, lines, wavelength, reach);
    noise.par_iter_mut().enumerate().for_each(|(cell, noise)| {
        let Led { share, wave: [cos, _] } = guide.led(cell, [0.0; 2]);
        *noise = ((1.0 - share) * f64::from(*noise) + HEIGHT * cos) as f32;
    });
}

/// The wave that replaces the noise at a cell.
#[derive(Clone, Copy, Debug, Default)]
pub struct Led {
    /// W.
    pub share: f64,
    /// Σᵢ wᵢ cos(2π dᵢ/λ) ÷ max(1, Σᵢ wᵢ), and the sum with sines instead of cosines; d is counted along `across`.
    pub wave: [f64; 2],
}

/// Side of a tile, cells. Not tuned.
const TILE: f64 = 32.0;

/// The waves that lines make on a grid.
pub struct Guide<'a> {
    maps: &'a ParameterField,
    lines: &'a [GuideLine],
    wavelength: Wavelength<'a>,
    reach: Reach,
    /// Boxes around the lines, as far as their waves reach.
    boxes: BoxTiles,
}

impl<'a> Guide<'a> {
    /// The waves of `lines` on the grid of `maps`.
    pub fn new(
        maps: &'a ParameterField,
        lines: &'a [GuideLine],
        wavelength: Wavelength<'a>,
        reach: Reach,
    ) -> Self {
        let lengths = || maps.parameters.par_iter().map(wavelength);
        let longest = if lines.is_empty() { 0.0 } else { lengths().reduce(|| 0.0, f64::max) };
        // A wave reaches past the ends of its line and to its sides.
        let margin = (reach.beyond[1] + reach.across[1]) * longest;
        let bounds = maps.domain.bounds();
        let around = |line: &GuideLine| {
            let [low, high] = line.box_of(&bounds);
            [low.map(|low| low - margin), high.map(|high| high + margin)]
        };
        let wrap = [bounds.edges == Edges::Wrap; 2];
        let boxes = BoxTiles::new(bounds.size, wrap, TILE, lines.iter().map(around));
        Self { maps, lines, wavelength, reach, boxes }
    }

    /// The wave at a cell that the lines make; `across` is a direction across the stripes.
    pub fn led(&self, cell: usize, across: [f64; 2]) -> Led {
        let (at, bounds) = (self.maps.domain.center(cell), self.maps.domain.bounds());
        let near = self.boxes.holding(at);
        if near.is_empty() {
            return Led::default();
        }
        let length = (self.wavelength)(&self.maps.parameters[cell]);
        let (mut sum, mut wave) = (0.0, [0.0; 2]);
        for line in near {
            let Seen { beyond, off, normal } = self.lines[*line as usize].seen(at, &bounds);
            let weight =
                fall(beyond / length, self.reach.beyond) * fall(off.abs() / length, self.reach.across);
            if weight > 0.0 {
                let same = normal[0] * across[0] + normal[1] * across[1] >= 0.0;
                let phase = TAU * if same { off } else { -off } / length;
                sum += weight;
                wave[0] += weight * libm::cos(phase);
                wave[1] += weight * libm::sin(phase);
            }
        }
        Led { share: sum.min(1.0), wave: wave.map(|part| part / f64::max(sum, 1.0)) }
    }
}

/// A point as seen from a line, cells.
struct Seen {
    /// Distance of the point beyond an end.
    beyond: f64,
    /// Distance from the line, positive on the side of `normal`.
    off: f64,
    normal: [f64; 2],
}

impl GuideLine {
    /// The corners of the box around it, cells.
    pub fn box_of(&self, bounds: &Bounds) -> [[f64; 2]; 2] {
        [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| [0, 1].map(|axis| pick(self.from[axis], self.to[axis]) * bounds.size[axis]))
    }

    /// Distance, cells, of a point (cells) from the line.
    pub fn distance(&self, at: [f64; 2], bounds: &Bounds) -> f64 {
        let Seen { beyond, off, .. } = self.seen(at, bounds);
        (beyond * beyond + off * off).sqrt()
    }

    fn seen(&self, at: [f64; 2], bounds: &Bounds) -> Seen {
        let [from, to] = [self.from, self.to].map(|end| [end[0] * bounds.size[0], end[1] * bounds.size[1]]);
        let half = [0, 1].map(|axis| 0.5 * (to[axis] - from[axis]));
        let length = (half[0] * half[0] + half[1] * half[1]).sqrt();
        let along = [0, 1].map(|axis| half[axis] / length);
        let off = bounds.shortest([0, 1].map(|axis| at[axis] - from[axis] - half[axis]));
        let beyond = (off[0] * along[0] + off[1] * along[1]).abs() - length;
        let normal = [-along[1], along[0]];
        Seen { beyond: beyond.max(0.0), off: off[0] * normal[0] + off[1] * normal[1], normal }
    }
}

/// 1 up to `from`, 0 from `to` on, smooth between.
pub(super) fn fall(v: f64, [from, to]: [f64; 2]) -> f64 {
    let t = ((to - v) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    const REACH: Reach = Reach { beyond: [0.0, 1.5], across: [0.4, 1.3] };

    fn wavelength(_: &Parameters) -> f64 {
        81.0 / 25.6f64.sqrt()
    }

    #[test]
    fn noise_follows_a_line_and_is_unchanged_farther_away() {
        let p = Parameters { rate: 25.6, ratio: 1.0, stretch: 0.5, direction: 0.0, pitch: 1.0 };
        let maps = ParameterField::uniform([160, 120], Edges::Closed, p);
        let mut noise = vec![0.5f32; 160 * 120];
        let line = GuideLine { from: [0.3, 0.5], to: [0.7, 0.5] };
        lead(&mut noise, &maps, &[line], &wavelength, REACH);
        let at = |x: usize, y: usize| noise[y * 160 + x];
        // Rows 59 and 60 lie on either side of the line; half a wavelength, 8 cells, off it there is a trough.
        assert!((50..110).all(|x| at(x, 59) > 1.9 && at(x, 60) > 1.9));
        assert!(at(80, 67) < -1.0 && at(80, 52) < -1.0);
        assert!(at(80, 60 + 22) == 0.5 && at(10, 60) == 0.5);
        let before = noise.clone();
        lead(&mut noise, &maps, &[], &wavelength, REACH);
        assert!(noise == before);
    }

    #[test]
    fn lines_side_by_side_share_the_noise() {
        let p = Parameters { rate: 25.6, ratio: 1.0, stretch: 0.5, direction: 0.0, pitch: 1.0 };
        let maps = ParameterField::uniform([160, 120], Edges::Closed, p);
        let line = |y: f64| GuideLine { from: [0.3, y / 120.0], to: [0.7, y / 120.0] };
        // A period apart, both waves agree.
        let pair = [line(52.0), line(68.0)];
        let cell = 60 * 160 + 80;
        let led = |lines| Guide::new(&maps, lines, &wavelength, REACH).led(cell, [0.0, 1.0]);
        let (one, both) = (led(&pair[..1]), led(&pair));
        assert!(one.share <= 1.0 && both.share == 1.0, "{one:?} {both:?}");
        assert!(both.wave[0] < -0.9 && one.wave[0] < 0.0, "{one:?} {both:?}");
    }

    #[test]
    fn no_line_that_reaches_a_cell_is_missed() {
        let p = Parameters { rate: 25.6, ratio: 1.0, stretch: 0.5, direction: 0.0, pitch: 1.0 };
        let lines: Vec<GuideLine> = (0..60)
            .map(|i| {
                let at = |step: f64| 1.6 * (0.5 + step * f64::from(i)).fract() - 0.3;
                let (from, long) = ([at(0.754_877_7), at(0.569_840_3)], if i % 9 == 0 { 0.7 } else { 0.1 });
                GuideLine { from, to: [from[0] + long * (at(0.31) + 0.01), from[1] - long * at(0.87)] }
            })
            .collect();
        for edges in [Edges::Closed, Edges::Wrap] {
            let maps = ParameterField::uniform([150, 110], edges, p);
            let guide = Guide::new(&maps, &lines, &wavelength, REACH);
            let whole = [[f64::NEG_INFINITY; 2], [f64::INFINITY; 2]];
            let boxes = BoxTiles::new([150.0, 110.0], [false; 2], 1e9, lines.iter().map(|_| whole));
            let full = Guide { boxes, ..Guide::new(&maps, &lines, &wavelength, REACH) };
            for cell in (0..150 * 110).step_by(7) {
                let [found, expected] = [&guide, &full].map(|guide| guide.led(cell, [0.6, 0.8]));
                assert_eq!((found.share, found.wave), (expected.share, expected.wave), "{edges:?} {cell}");
            }
        }
    }
}
