//! Drawn lines that are recognised as a weave, where the system is chosen automatically.

use std::f64::consts::{PI, TAU};

use dapple::document::{After, Document, DutyChoice, Layer, PairKind, Stroke, SystemChoice};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const WIDTH: f64 = 6.0;
const SKETCHES: u64 = 100;

/// Draws lines and arcs like a hand that means them to be exact, with small errors.
struct Hand(Pcg64Mcg);

impl Hand {
    fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0.random_range(low..high)
    }

    /// A stroke along `at`, 0..1, with `length` px: it is bent by up to 3 % of its length, and shakes by up to 0.8 px.
    fn stroke(&mut self, length: f64, at: impl Fn(f64) -> [f64; 2]) -> Stroke {
        let (bow, wave) = (self.within(-0.03, 0.03) * length, self.within(-0.01, 0.01) * length);
        let (shake, phase) = (self.within(0.2, 0.8), self.within(0.0, TAU));
        let count = (length / self.within(2.0, 4.0)).ceil().max(8.0) as u32;
        let points = (0..=count).map(|i| {
            let t = f64::from(i) / f64::from(count);
            let [[x, y], [to_x, to_y]] = [at(t), at(t + 1e-4)];
            let ahead = (to_x - x).hypot(to_y - y);
            let [u, v] = [(to_x - x) / ahead, (to_y - y) / ahead];
            let aside = bow * (PI * t).sin()
                + wave * (TAU * t).sin()
                + shake * (TAU * t * length / 11.0 + phase).sin();
            [x - aside * v, y + aside * u]
        });
        Stroke::Freehand { points: points.collect(), width: WIDTH }
    }

    /// A straight line whose ends are up to `off` px from their intended places.
    fn line(&mut self, [from, to]: [[f64; 2]; 2], off: f64) -> Stroke {
        let [from, to] = [from, to].map(|end| end.map(|x| x + off * self.within(-1.0, 1.0)));
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        self.stroke(length, move |t| [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis])))
    }

    /// Lines side by side, `apart` px from each other, in one direction, about the middle of the canvas.
    fn parallel(&mut self, count: u32, degrees: f64, apart: f64, length: f64) -> Vec<Stroke> {
        let (s, c) = degrees.to_radians().sin_cos();
        let lines = (0..count).map(|i| {
            let across = (f64::from(i) - 0.5 * f64::from(count - 1)) * apart;
            [-0.5 * length, 0.5 * length].map(|a| [256.0 + a * c - across * s, 256.0 + a * s + across * c])
        });
        lines.collect::<Vec<_>>().into_iter().map(|ends| self.line(ends, 0.15 * apart)).collect()
    }
}

/// The system of pairs with the name `weave`.
fn weave() -> Option<PairKind> {
    SystemChoice::named("weave").unwrap().pairs()
}

fn document(strokes: Vec<Stroke>) -> Document {
    Document { size: [512, 512], layers: vec![Layer::new(strokes)], ..Document::default() }
}

/// How many of the sketches of 100 hands are recognised as weaves.
fn weaves(sketch: impl Fn(&mut Hand) -> Vec<Stroke>) -> usize {
    let is_weave = |seed: &u64| document(sketch(&mut Hand::new(*seed))).pairs(0) == weave();
    (0..SKETCHES).filter(is_weave).count()
}

#[test]
fn crossing_lines_of_two_or_three_directions_are_a_weave() {
    let found = weaves(|hand| {
        let (first, apart) = (hand.within(0.0, 180.0), hand.within(24.0, 60.0));
        let directions = if hand.within(0.0, 1.0) < 0.7 { 2 } else { 3 };
        let between = if directions == 2 { hand.within(45.0, 90.0) } else { hand.within(45.0, 65.0) };
        let mut strokes = Vec::new();
        for direction in 0..directions {
            let count = hand.within(1.0, 5.0) as u32;
            let length = hand.within(160.0, 320.0);
            strokes.extend(hand.parallel(count, first + f64::from(direction) * between, apart, length));
        }
        strokes
    });
    assert!(found >= 95, "{found} of {SKETCHES}");
}

#[test]
fn lines_side_by_side_are_never_a_weave() {
    let straight = weaves(|hand| {
        let (degrees, apart, length) =
            (hand.within(0.0, 180.0), hand.within(18.0, 50.0), hand.within(100.0, 400.0));
        hand.parallel(6, degrees, apart, length)
    });
    let curved = weaves(|hand| {
        let (apart, waves) = (hand.within(36.0, 60.0), hand.within(0.5, 2.5));
        // At most as steep as 45°: steeper waves with this bend would touch.
        let height = hand.within(0.1, 1.0) * 360.0 / (TAU * waves);
        let wave = |hand: &mut Hand, y: f64| {
            hand.stroke(360.0, |t| [76.0 + 360.0 * t, y + height * (waves * TAU * t).sin()])
        };
        (0..6).map(|i| wave(hand, 130.0 + apart * f64::from(i))).collect()
    });
    let rings = weaves(|hand| {
        let from = hand.within(0.0, TAU);
        let arc = |hand: &mut Hand, radius: f64| {
            let at = move |t: f64| {
                [256.0 + radius * (from + 4.0 * t).cos(), 256.0 + radius * (from + 4.0 * t).sin()]
            };
            hand.stroke(4.0 * radius, at)
        };
        (1..6).map(|i| arc(hand, 36.0 * f64::from(i))).collect()
    });
    assert_eq!([straight, curved, rings], [0; 3]);
}

#[test]
fn lines_that_meet_where_one_of_them_ends_are_never_a_weave() {
    // One line ends up to a width too far.
    let chevrons = weaves(|hand| {
        let high = hand.within(20.0, 60.0);
        (0..8u32)
            .flat_map(|i| {
                let (tip, side) = ([256.0, 100.0 + 36.0 * f64::from(i)], 90.0);
                [-side, side].map(|to| hand.line([tip, [256.0 + to, tip[1] + high]], 0.5 * WIDTH))
            })
            .collect()
    });
    let joints = weaves(|hand| {
        let bar = hand.line([[100.0, 256.0], [400.0, 256.0]], 10.0);
        let Stroke::Freehand { points, .. } = &bar else { panic!("{bar:?}") };
        // The hand can see where the bar is.
        let height =
            |x: f64| points.iter().min_by(|a, b| (a[0] - x).abs().total_cmp(&(b[0] - x).abs())).unwrap()[1];
        let stems = [140.0, 200.0, 260.0, 340.0].map(|x| {
            let beyond = hand.within(-WIDTH, WIDTH);
            hand.line([[x, height(x) + beyond], [x + 20.0, 400.0]], 0.0)
        });
        stems.into_iter().chain([bar.clone()]).collect()
    });
    let rays = weaves(|hand| {
        let count = hand.within(5.0, 16.0) as u32;
        let ray = |hand: &mut Hand, turn: f64| {
            let (s, c) = turn.sin_cos();
            let from = hand.within(-0.8 * WIDTH, 20.0);
            hand.line([from, 200.0].map(|radius| [256.0 + radius * c, 256.0 + radius * s]), 0.0)
        };
        (0..count).map(|i| ray(hand, TAU * f64::from(i) / f64::from(count))).collect()
    });
    let herringbone = weaves(|hand| {
        let bone = |hand: &mut Hand, i: u32| {
            let (column, row) = (f64::from(i % 5), f64::from(i / 5));
            let turn: f64 = if (i % 5).is_multiple_of(2) { 45.0 } else { -45.0 };
            let (s, c) = turn.to_radians().sin_cos();
            let middle = [100.0 + 60.0 * column, 100.0 + 50.0 * row];
            hand.line([-40.0, 40.0].map(|along| [middle[0] + along * c, middle[1] + along * s]), 3.0)
        };
        (0..30).map(|i| bone(hand, i)).collect()
    });
    assert_eq!([chevrons, joints, rays, herringbone], [0; 4]);
}

#[test]
fn a_line_that_only_crosses_itself_is_no_weave() {
    let loops = weaves(|hand| {
        let round = hand.within(30.0, 90.0);
        let at = move |t: f64| {
            [100.0 + 300.0 * t + round * (TAU * t).sin() * 2.0, 256.0 - round * (TAU * t).cos()]
        };
        vec![hand.stroke(500.0, at)]
    });
    assert_eq!(loops, 0);
}

fn crossed() -> Vec<Stroke> {
    let lines = [[60.0, 200.0], [60.0, 230.0]].map(|from| Stroke::line(from, [400.0, from[1]], 6.0));
    lines.into_iter().chain([Stroke::line([200.0, 60.0], [210.0, 420.0], 6.0)]).collect()
}

#[test]
fn a_layer_with_stripes_or_options_that_a_weave_lacks_stays_stripes() {
    assert_eq!(document(crossed()).pairs(0), weave());
    let mut asked = document(crossed());
    asked.layers[0].system = SystemChoice::Stripes;
    assert_eq!(asked.pairs(0), None);
    let written = Document::parse(&asked.to_json(), "x").unwrap();
    assert_eq!(written.layers[0].system, SystemChoice::Stripes);
    let mut ringed = document(crossed());
    ringed.layers[0].after = After::Net;
    assert_eq!(ringed.pairs(0), None);
    let mut kept = document(crossed());
    kept.layers[0].options.keep = Some(false);
    assert_eq!(kept.pairs(0), None);
    let mut even = document(crossed());
    even.layers[0].options.duty = DutyChoice::Given(0.3);
    assert_eq!(even.pairs(0), weave(), "a weave has a duty, too");
}
