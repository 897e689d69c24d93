//! Fills by a pattern: the marks of its tile, again and again.

use std::collections::BTreeMap;

use usvg::tiny_skia_path::{Point, Transform};
use usvg::{Group, Node, Path, Pattern};

use super::MOST;
use super::ground::Area;
use super::reader::{Painted, Reader};
use super::strokes::{Drawn, strokes};
use super::visibility::{Visibility, inside, tested};

/// The least share of a mark that its tiles show.
const SEEN: f64 = 0.5;

/// A shape of a tile.
struct Piece<'a> {
    path: &'a Path,
    /// From its own coordinates to those of the tile.
    transform: Transform,
    /// The share of its points that lies in the tile.
    seen: f64,
}

/// Where the tiles of a pattern lie, px of the canvas.
struct Tiles {
    /// From the coordinates of the tile at (0, 0) to the canvas of the SVG.
    transform: Transform,
    /// Width and height of a tile in these coordinates.
    size: [f32; 2],
    /// First and last column and row.
    range: [[i32; 2]; 2],
}

impl Reader {
    /// Reads the fill of `shape`, whose outlines are `around`, by `pattern`. What covers a whole tile is its ground.
    pub(super) fn pattern(
        &mut self,
        pattern: &Pattern,
        shape: &Path,
        around: &[Drawn],
        at: usize,
        seen: &Visibility,
    ) {
        let mut pieces = Vec::new();
        let tile = [pattern.rect().width(), pattern.rect().height()];
        collect(pattern.root(), Transform::identity(), tile, &mut pieces);
        let rule = shape.fill().map_or_else(Default::default, usvg::Fill::rule);
        let outlines: Vec<&[[f64; 2]]> = around.iter().map(|drawn| &drawn.points[..]).collect();
        let Some(tiles) = Tiles::over(pattern, shape, &outlines, self.scale) else {
            self.unread("pattern");
            return;
        };
        if pieces.is_empty() || tiles.count().saturating_mul(pieces.len()) > MOST {
            self.unread("pattern");
            return;
        }
        let mut shown: BTreeMap<[i64; 3], (f64, Painted)> = BTreeMap::new();
        let whole = Area { corner: [0.0; 2], sides: [[f64::from(tile[0]), 0.0], [0.0, f64::from(tile[1])]] };
        let covers =
            Area::canvas(self.drawing.size)
                .is_covered(&around.iter().collect::<Vec<_>>(), rule, |place| seen.shows(place));
        for (number, piece) in pieces.iter().enumerate() {
            let own = strokes(piece.path.data(), piece.transform, 1.0);
            let fill = piece.path.fill().map(usvg::Fill::rule);
            if fill.is_some_and(|rule| whole.is_covered(&own.iter().collect::<Vec<_>>(), rule, |_| true)) {
                if covers {
                    self.ground(piece.path, seen);
                }
                continue;
            }
            for offset in tiles.offsets() {
                let transform =
                    tiles.transform.pre_translate(offset[0], offset[1]).pre_concat(piece.transform);
                for painted in self.painted(piece.path, transform, seen) {
                    let center = painted.mark.center();
                    if inside(&outlines, rule, center) && seen.shows(center) {
                        let [x, y] = center.map(|c| (c * 100.0).round() as i64);
                        // Marks across the border of a tile are drawn once in each.
                        let key = if piece.seen < 1.0 { [x, y, -1] } else { [x, y, number as i64] };
                        shown.entry(key).or_insert((0.0, painted)).0 += piece.seen;
                    }
                }
            }
        }
        for (share, painted) in shown.into_values() {
            match share >= SEEN {
                true => self.add(painted, at),
                false => self.unread("clipped shape"),
            }
        }
    }
}

/// The paths of a tile, with their transforms: those that usvg gives for the whole are not known inside of patterns.
fn collect<'a>(group: &'a Group, around: Transform, tile: [f32; 2], pieces: &mut Vec<Piece<'a>>) {
    for node in group.children() {
        match node {
            Node::Group(group) => collect(group, around.pre_concat(group.transform()), tile, pieces),
            Node::Path(path) if path.is_visible() => {
                let drawn = strokes(path.data(), around, 1.0);
                let (mut all, mut within) = (0, 0);
                for point in drawn.iter().flat_map(|drawn| tested(&drawn.points)) {
                    all += 1;
                    within +=
                        usize::from((0..2).all(|axis| (0.0..=f64::from(tile[axis])).contains(&point[axis])));
                }
                let seen = within as f64 / f64::from(all.max(1));
                pieces.push(Piece { path, transform: around, seen });
            }
            Node::Path(_) | Node::Image(_) | Node::Text(_) => {}
        }
    }
}

impl Tiles {
    /// The tiles that a shape with these outlines, px, needs; `None` where tiles have no extent, or there are far too many.
    fn over(pattern: &Pattern, shape: &Path, outlines: &[&[[f64; 2]]], scale: f64) -> Option<Self> {
        let rect = pattern.rect();
        let transform =
            shape.abs_transform().pre_concat(pattern.transform()).pre_translate(rect.x(), rect.y());
        let size = [rect.width(), rect.height()];
        let back = transform.invert()?;
        let mut range = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
        for [x, y] in outlines.iter().flat_map(|outline| outline.iter()) {
            let mut point = Point { x: (x / scale) as f32, y: (y / scale) as f32 };
            back.map_point(&mut point);
            for (axis, at) in [point.x, point.y].into_iter().enumerate() {
                let column = at / size[axis];
                range[axis] = [range[axis][0].min(column), range[axis][1].max(column)];
            }
        }
        let most = MOST as f32;
        let is_fine = range.iter().flatten().all(|column| column.abs() < most);
        // A mark may reach over the border of its tile.
        is_fine.then(|| Self {
            transform,
            size,
            range: range.map(|[low, high]| [low.floor() as i32 - 1, high.ceil() as i32 + 1]),
        })
    }

    fn count(&self) -> usize {
        self.range.iter().map(|[low, high]| (high - low + 1) as usize).fold(1, usize::saturating_mul)
    }

    fn offsets(&self) -> impl Iterator<Item = [f32; 2]> {
        let [across, down] = self.range.map(|[low, high]| low..=high);
        down.flat_map(move |row| {
            across.clone().map(move |column| [column as f32 * self.size[0], row as f32 * self.size[1]])
        })
    }
}
