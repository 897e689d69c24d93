//! Scales: the overlapping round ones of fish, and the keeled ones of reptiles, which lie side by side.

use super::light;
use super::noise::{Noise, Random, floor, part_seed, whole_cells, wrapped};
use super::surfel::{Source, Surfel};

/// The share of a scale's colour that is that of its centre; the rest is that of the px.
pub(super) const FROM_CENTRE: f32 = 0.8;
/// Radius of a fish scale ÷ the distance between two scales of a row.
pub(super) const RADIUS: f32 = 0.62;
/// Distance between two rows of fish scales ÷ that between two scales of a row.
pub(super) const ROW: f32 = 0.42;
/// Distance between two rings of growth ÷ radius.
const RING: f32 = 0.11;
/// Distance between two rows of reptile scales ÷ that between two scales of a row.
pub(super) const REPTILE_ROW: f32 = 0.78;

/// A lattice of scales in rows that are offset by half. Rows follow each other along the axis of the canvas that is the nearest to
/// the flow, from head to tail.
#[derive(Clone, Debug)]
struct Rows {
    /// Scales in a row, and rows: an even number.
    count: [usize; 2],
    /// Distance between two scales of a row, and between two rows, px.
    apart: [f32; 2],
    /// The axis along which rows follow each other, and whether against it.
    axis: usize,
    against: bool,
    seed: u32,
}

impl Rows {
    fn new(source: &Source, size: f32, row: f32) -> Self {
        let flow = source.flow.at(source.canvas.map(|side| 0.5 * side));
        let axis = usize::from(flow[0].abs() < flow[1].abs());
        let canvas = [source.canvas[1 - axis], source.canvas[axis]];
        let across = whole_cells(canvas, size)[0];
        let rows = 2 * ((canvas[1] / (2.0 * row * size)).round() as usize).max(1);
        Self {
            count: [across, rows],
            apart: [canvas[0] / across as f32, canvas[1] / rows as f32],
            axis,
            against: flow[axis] < 0.0,
            seed: part_seed(source.seed, 32),
        }
    }

    /// A point of the canvas: along a row, and from head to tail.
    #[inline]
    fn local(&self, point: [f32; 2]) -> [f32; 2] {
        let down = point[self.axis];
        [point[1 - self.axis], if self.against { self.count[1] as f32 * self.apart[1] - down } else { down }]
    }

    /// A vector along a row and from head to tail as one on the canvas.
    #[inline]
    fn on_canvas(&self, [across, down]: [f32; 2]) -> [f32; 2] {
        let down = if self.against { -down } else { down };
        if self.axis == 1 { [across, down] } else { [down, across] }
    }

    /// From a point to the centre of the nearest scale of a row, and that scale.
    #[inline]
    fn nearest(&self, [across, down]: [f32; 2], row: i32) -> ([f32; 2], [i32; 2]) {
        let offset = if row.rem_euclid(2) == 1 { 0.5 } else { 0.0 };
        let column = floor(across / self.apart[0] - offset);
        let centre = [(column as f32 + 0.5 + offset) * self.apart[0], (row as f32 + 0.5) * self.apart[1]];
        ([centre[0] - across, centre[1] - down], [column, row])
    }

    fn random(&self, [column, row]: [i32; 2]) -> Random {
        let place = [wrapped(column, self.count[0]), wrapped(row, self.count[1])];
        Random::of(self.seed, place.map(|place| place as u32))
    }
}

/// Rises from 0 at `from` to 1 at `to`.
#[inline]
fn step(from: f32, to: f32, value: f32) -> f32 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Fish scales `size` px wide.
#[must_use]
pub fn fish(source: &Source, size: f32) -> Vec<Surfel> {
    let fish = fish_surfel(source, size);
    let mut picture = source.shaded(fish);
    light::apply(&mut picture, source, 0.35);
    picture
}

pub(super) fn fish_surfel<'a>(source: &'a Source, size: f32) -> impl Fn([f32; 2]) -> Surfel + Sync + 'a {
    let rows = Rows::new(source, size, ROW);
    let grain = Noise::new(source.canvas, 0.12 * size.max(4.0), part_seed(source.seed, 33));
    let radius = RADIUS * rows.apart[0];
    let rings = rings(radius, source.scale()[0]);
    move |point| {
        let local = rows.local(point);
        let row = floor(local[1] / rows.apart[1]);
        // The first row from the head whose scale covers the place lies over the others.
        let reach = (radius / rows.apart[1]) as i32 + 1;
        let mut found = ([0.0; 2], [0, row], radius);
        for row in row - reach..=row + 1 {
            let (to_centre, scale) = rows.nearest(local, row);
            let distance = (to_centre[0] * to_centre[0] + to_centre[1] * to_centre[1]).sqrt();
            if distance < radius {
                found = (to_centre, scale, distance);
                break;
            }
        }
        let (to_centre, scale, distance) = found;
        let mut random = rows.random(scale);
        let colour = source.carried(point, rows.on_canvas(to_centre), radius, FROM_CENTRE);
        let plate = Plate { size, radius, rings };
        plate.surfel([-to_centre[1], distance], &mut random, grain.at(point), colour)
    }
}

/// Keeled scales of reptiles, `size` px wide.
#[must_use]
pub fn reptile(source: &Source, size: f32) -> Vec<Surfel> {
    let mut picture = source.shaded(reptile_surfel(source, size));
    light::apply(&mut picture, source, 0.25);
    picture
}

pub(super) fn reptile_surfel<'a>(source: &'a Source, size: f32) -> impl Fn([f32; 2]) -> Surfel + Sync + 'a {
    let rows = Rows::new(source, size, REPTILE_ROW);
    let grain = Noise::new(source.canvas, 0.07 * size.max(6.0), part_seed(source.seed, 33));
    // Scales are longer than wide: distances along them count less.
    let shorter = 0.74 * rows.apart[0] / rows.apart[1];
    move |point| {
        let local = rows.local(point);
        let row = floor(local[1] / rows.apart[1]);
        let mut first = (f32::INFINITY, [0.0; 2], [0; 2]);
        let mut second = (f32::INFINITY, [0.0; 2]);
        for row in row - 2..=row + 2 {
            let (near, [column, _]) = rows.nearest(local, row);
            for by in -1..=1 {
                let to_centre = [near[0] + by as f32 * rows.apart[0], near[1]];
                let metric = [to_centre[0], shorter * to_centre[1]];
                let squared = metric[0] * metric[0] + metric[1] * metric[1];
                if squared < first.0 {
                    second = (first.0, first.1);
                    first = (squared, to_centre, [column + by, row]);
                } else if squared < second.0 {
                    second = (squared, to_centre);
                }
            }
        }
        let (_, to_centre, scale) = first;
        let apart = [second.1[0] - to_centre[0], shorter * (second.1[1] - to_centre[1])];
        let length = (apart[0] * apart[0] + apart[1] * apart[1]).sqrt().max(1e-6);
        let edge = 0.5 * (second.0 - first.0) / length / rows.apart[0];
        let mut random = rows.random(scale);
        let [red, green, blue, ink] =
            source.carried(point, rows.on_canvas(to_centre), 0.7 * size, FROM_CENTRE);
        let place = [to_centre[0] / rows.apart[0], -to_centre[1] / rows.apart[1], edge];
        keeled(size, place, &mut random, grain.at(point), [red, green, blue, ink])
    }
}

/// How far rings of growth are drawn on a fish scale of this radius, px, 0..1: where a picture with `scale` px along each px can show
/// them.
pub(super) fn rings(radius: f32, scale: f32) -> f32 {
    step(1.2, 2.4, RING * radius * scale)
}

/// A fish scale.
pub(super) struct Plate {
    /// Distance between two scales of a row, px.
    pub size: f32,
    /// Its radius, px.
    pub radius: f32,
    /// How far its rings are drawn, 0..1.
    pub rings: f32,
}

impl Plate {
    /// A place on it: its distance from the centre along the flow, and in any direction, px.
    #[inline]
    pub(super) fn surfel(
        &self,
        [along, distance]: [f32; 2],
        random: &mut Random,
        grain: f32,
        [red, green, blue, ink]: [f32; 4],
    ) -> Surfel {
        let share = distance / self.radius;
        // A plate that rises towards the tail, with a round rim.
        let towards_tail = along / self.radius;
        let rim = step(0.84, 1.0, share);
        let phase = (distance / (RING * self.radius)).fract();
        let groove = self.rings * 0.1 * (1.0 - 4.0 * (phase - 0.5) * (phase - 0.5)) * step(0.3, 0.6, share);
        Surfel {
            colour: [red, green, blue],
            tint: (1.0 + 0.11 * random.signed())
                * (1.0 - 0.5 * rim)
                * (1.0 - groove)
                * (1.0 + 0.05 * grain)
                * (1.0 + 0.16 * step(0.5, 0.84, share)),
            light: 1.0,
            height: 0.16 * self.size * (1.0 + 0.9 * towards_tail - 0.5 * share * share - 0.7 * rim),
            roughness: 0.25 + 0.1 * random.number() + 0.3 * rim,
            ink,
        }
    }
}

/// A place on a keeled scale `size` px wide: from its centre across the flow and along it, and from its edge, in widths of a scale.
#[inline]
pub(super) fn keeled(
    size: f32,
    [off, along, edge]: [f32; 3],
    random: &mut Random,
    grain: f32,
    [red, green, blue, ink]: [f32; 4],
) -> Surfel {
    let keel = (1.0 - 9.0 * off.abs()).max(0.0);
    let gap = 1.0 - step(0.02, 0.09, edge);
    let inside = (3.2 * edge).min(1.0);
    let dome = inside * (2.0 - inside);
    Surfel {
        colour: [red, green, blue],
        tint: (1.0 + 0.12 * random.signed())
            * (1.0 - 0.62 * gap)
            * (0.97 + 0.06 * along)
            * (1.0 + 0.07 * grain),
        light: 1.0,
        height: size * (0.11 * dome + 0.035 * keel * dome + 0.06 * along + 0.006 * grain),
        roughness: 0.4 + 0.15 * random.number() + 0.3 * gap,
        ink,
    }
}
