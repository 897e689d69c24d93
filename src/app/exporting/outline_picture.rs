//! A picture of outlines, made from the same paths that are written to the file.

use egui::{Color32, ColorImage};

use crate::export::outline::path::flattened;
use crate::export::outline::{BezPath, Group, Shape};

/// Outlines, as they are written to the file.
pub struct OutlinePicture {
    /// The canvas, px.
    pub size: [f64; 2],
    /// The paths, by colour.
    pub groups: Vec<Group>,
    /// The width of strokes, px; `None` = hairlines.
    pub pen: Option<f64>,
    /// The colour beneath them; `None` = white paper.
    pub ground: Option<[u8; 3]>,
}

/// Samples per px in y; in x, coverage is exact.
const FINENESS: usize = 4;

impl OutlinePicture {
    /// The outlines on their ground, the longer side `side` px.
    #[must_use]
    pub fn picture(&self, side: usize) -> ColorImage {
        let scale = side as f64 / self.size[0].max(self.size[1]);
        let size = self.size.map(|side| ((side * scale).round() as usize).max(1));
        let ground = self.ground.unwrap_or([255; 3]).map(f32::from);
        let mut paper = Paper { size, cover: Vec::new(), image: vec![ground; size[0] * size[1]] };
        for group in &self.groups {
            let areas = group.areas.iter().flat_map(Shape::paths);
            paper.cover = vec![0.0; size[0] * size[1]];
            paper.fill(&areas.map(|path| flat(path, scale)).collect::<Vec<_>>());
            paper.ink(group.colour);
            paper.cover = vec![0.0; size[0] * size[1]];
            // Strokes thinner than a px are drawn one px wide and paler.
            let width = self.pen.map_or(1.0, |pen| pen * scale);
            for stroke in &group.strokes {
                paper.stroke(&flat(stroke, scale), width);
            }
            paper.ink(group.colour);
        }
        let px = |[r, g, b]: [f32; 3]| Color32::from_rgb(r.round() as u8, g.round() as u8, b.round() as u8);
        ColorImage::new(size, paper.image.into_iter().map(px).collect())
    }
}

/// A path as points, px of the picture.
fn flat(path: &BezPath, scale: f64) -> Vec<[f64; 2]> {
    flattened(path, 0.1 / scale).into_iter().map(|point| [point.x * scale, point.y * scale]).collect()
}

struct Paper {
    size: [usize; 2],
    /// The coverage of each px, 0..1.
    cover: Vec<f32>,
    image: Vec<[f32; 3]>,
}

impl Paper {
    /// Covers the inside of the rings, by the even-odd rule.
    fn fill(&mut self, rings: &[Vec<[f64; 2]>]) {
        let [width, height] = self.size;
        let lines = height * FINENESS;
        let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); lines];
        for pair in rings.iter().flat_map(|ring| ring.windows(2)) {
            let ([x0, y0], [x1, y1]) =
                if pair[0][1] < pair[1][1] { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
            // Lines are centred in their rows.
            let line = |y: f64| (y * FINENESS as f64 - 0.5).ceil().clamp(0.0, lines as f64) as usize;
            for (index, line) in crossings.iter_mut().enumerate().take(line(y1)).skip(line(y0)) {
                let y = (index as f64 + 0.5) / FINENESS as f64;
                line.push(x0 + (y - y0) / (y1 - y0) * (x1 - x0));
            }
        }
        for (index, line) in crossings.iter_mut().enumerate() {
            line.sort_by(f64::total_cmp);
            let row = &mut self.cover[index / FINENESS * width..][..width];
            for span in line.chunks_exact(2) {
                let [from, to] = [span[0], span[1]].map(|x| x.clamp(0.0, width as f64));
                for (x, cover) in row.iter_mut().enumerate().take(to.ceil() as usize).skip(from as usize) {
                    let covered = to.min(x as f64 + 1.0) - from.max(x as f64);
                    *cover += (covered / FINENESS as f64) as f32;
                }
            }
        }
    }

    /// Covers a line of this width along the points.
    fn stroke(&mut self, points: &[[f64; 2]], width: f64) {
        let (seen, pale) = (width.max(1.0), width.min(1.0));
        let reach = seen / 2.0 + 0.5;
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let along = [b[0] - a[0], b[1] - a[1]];
            let length = (along[0] * along[0] + along[1] * along[1]).max(1e-12);
            let range = |axis: usize| {
                let (low, high) = (a[axis].min(b[axis]) - reach, a[axis].max(b[axis]) + reach);
                (low.max(0.0) as usize, (high.max(0.0).ceil() as usize).min(self.size[axis]))
            };
            let ((left, right), (top, bottom)) = (range(0), range(1));
            for y in top..bottom {
                for x in left..right {
                    let [u, v] = [x as f64 + 0.5 - a[0], y as f64 + 0.5 - a[1]];
                    let t = ((u * along[0] + v * along[1]) / length).clamp(0.0, 1.0);
                    let off = (u - t * along[0]).hypot(v - t * along[1]);
                    let covered = (pale * (reach - off).clamp(0.0, 1.0)) as f32;
                    let cover = &mut self.cover[y * self.size[0] + x];
                    *cover = cover.max(covered);
                }
            }
        }
    }

    /// Paints the covered px.
    fn ink(&mut self, colour: [u8; 3]) {
        for (px, cover) in self.image.iter_mut().zip(&self.cover) {
            let cover = cover.min(1.0);
            for (channel, ink) in px.iter_mut().zip(colour) {
                *channel += cover * (f32::from(ink) - *channel);
            }
        }
    }
}
