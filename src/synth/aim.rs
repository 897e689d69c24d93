//! Kept marks begin where they end at the drawn places.
//!
//! Spots push each other while they form, by a tenth to a half of their radius where they were drawn unevenly. Their
//! first grid, the coarsest, shows by how much; there they begin again, so much to the other side.

use super::keep::{Kept, apart, seen};
use super::plan::Plan;
use crate::attributes::regions::Layout;
use crate::field::Field;
use crate::measure::{Spot, spots};

/// Times that a pattern begins again at most. Each takes as long as the first grid does, a fifth of the whole.
const AGAIN: usize = 3;
/// Marks that end nearer than this (÷ radius) need not begin again.
const NEAR: f64 = 0.12;
/// A spot farther than this (÷ radius) is another's.
const OWN: f64 = 1.2;
/// Beginnings are moved no farther than this (÷ radius) from the drawn place: nearer to their neighbours they merge.
const FARTHEST: f64 = 0.5;

/// Where the kept marks of a plan begin and where they are to end.
#[derive(Clone, Debug)]
pub struct Aim {
    layout: Layout,
    marks: Vec<Aimed>,
    left: usize,
}

#[derive(Clone, Debug)]
struct Aimed {
    /// What is seen of it is to have its centre here, px.
    target: [f64; 2],
    radius: f64,
    drawn: [f64; 2],
    begins: [f64; 2],
    /// The beginning that ended nearest so far, and how near, ÷ radius.
    best: ([f64; 2], f64),
}

impl Aim {
    /// `None` where nothing is kept.
    #[must_use]
    pub fn of(plan: &Plan) -> Option<Self> {
        let layout = *plan.map.layout();
        let aimed = |kept: &Kept| {
            let drawn = kept.drawn.center;
            let target = seen(&kept.drawn, &layout);
            Aimed { target, radius: kept.radius(), drawn, begins: drawn, best: (drawn, f64::INFINITY) }
        };
        let marks: Vec<Aimed> = plan.kept.iter().map(aimed).collect();
        (!marks.is_empty()).then_some(Self { layout, marks, left: AGAIN })
    }

    /// Where the marks are to begin instead, as shares of the canvas' sides, if they ended too far off in `field`.
    pub fn again(&mut self, field: &Field) -> Option<Vec<[f64; 2]>> {
        if self.left == 0 {
            return None;
        }
        self.left -= 1;
        let found = spots(field, 0.5);
        let layout = self.layout;
        let last = self.left == 0;
        let before: Vec<[f64; 2]> = self.marks.iter().map(|mark| mark.begins).collect();
        let worst = self.marks.iter_mut().map(|mark| mark.learn(&found, &layout, last)).fold(0.0, f64::max);
        let moved = self.marks.iter().zip(&before).any(|(mark, before)| mark.begins != *before);
        if worst < NEAR || !moved {
            self.left = 0;
            return None;
        }
        let end = 1.0 - 1e-12;
        let share = |mark: &Aimed| [0, 1].map(|axis| (mark.begins[axis] / layout.size[axis]).clamp(0.0, end));
        Some(self.marks.iter().map(share).collect())
    }
}

impl Aimed {
    /// Moves its beginning by what it was off; gives how far that was, ÷ radius. The last time, back to the best.
    fn learn(&mut self, found: &[Spot], layout: &Layout, last: bool) -> f64 {
        let offs = found.iter().map(|spot| apart(spot.ellipse.center, self.target, layout));
        let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt() / self.radius;
        let nearest = offs.min_by(|a, b| length(*a).total_cmp(&length(*b)));
        let Some(off) = nearest.filter(|off| length(*off) < OWN) else {
            self.begins = self.best.0;
            return 0.0;
        };
        let missed = length(off);
        if missed < self.best.1 {
            self.best = (self.begins, missed);
        } else if last {
            self.begins = self.best.0;
            return missed;
        }
        if last || missed < 0.5 * NEAR {
            return missed;
        }
        let way = apart([self.begins[0] - off[0], self.begins[1] - off[1]], self.drawn, layout);
        let shorter = (FARTHEST / length(way)).min(1.0);
        self.begins = [0, 1].map(|axis| self.drawn[axis] + shorter * way[axis]);
        missed
    }
}
