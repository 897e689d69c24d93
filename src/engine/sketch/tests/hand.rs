//! Strokes as a hand draws them.

use std::f64::consts::TAU;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Strokes tried of each kind. The thresholds of `outline` were tuned with 2,000.
pub const STROKES: usize = 300;

/// A curve from t = 0 to 1, in units of the mark's half length, about the origin, long axis along x.
pub type Curve = Box<dyn Fn(f64) -> [f64; 2]>;

/// What was meant: centre and half length in px, aspect (of an outline), direction in degrees.
#[derive(Debug)]
pub struct Meant {
    pub center: [f64; 2],
    pub radius: f64,
    pub aspect: f64,
    pub angle: f64,
}

/// The curve as a hand with a mouse draws it: uneven speed, either sense, a wobble of up to 2 % of the half
/// length, jitter of up to 0.3 px, rests; sometimes whole px only.
pub fn drawn(curve: &Curve, meant: &Meant, rng: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
    let n = rng.random_range(40..220);
    let jitter = rng.random_range(0.0..0.3f64).min(0.04 * meant.radius);
    let [speed, wobble, phase] = [0.9, 0.02, TAU].map(|most| rng.random_range(0.0..most));
    let (flip, whole) = (rng.random_bool(0.5), rng.random_bool(0.3));
    let (s, c) = meant.angle.to_radians().sin_cos();
    let mut points = Vec::new();
    for i in 0..n {
        let u = f64::from(i) / f64::from(n - 1);
        let t = u - speed * ((TAU * u + phase).sin() - phase.sin()) / TAU;
        let [x, y] = curve(t);
        let x = x + wobble * (7.0 * t + phase).sin();
        let y = if flip { -y } else { y } + wobble * (9.0 * t + 2.0 * phase).sin();
        for _ in 0..if rng.random_bool(0.02) { 10 } else { 1 } {
            let [dx, dy] = [0, 1].map(|_| rng.random_range(-1.0..1.0) * jitter);
            let point = [
                meant.center[0] + meant.radius * (c * x - s * y) + dx,
                meant.center[1] + meant.radius * (s * x + c * y) + dy,
            ];
            points.push(if whole { point.map(f64::round) } else { point });
        }
    }
    points
}

/// A piece of the ellipse's outline, `from` and `turns` in turns of its parameter.
pub fn arc(aspect: f64, from: f64, turns: f64) -> Curve {
    Box::new(move |t| {
        let (y, x) = (TAU * (from + turns * t)).sin_cos();
        [x, aspect * y]
    })
}

/// Through these corners, evenly along.
pub fn polyline(corners: Vec<[f64; 2]>) -> Curve {
    let length = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let total: f64 = corners.windows(2).map(|side| length(side[0], side[1])).sum();
    Box::new(move |t| {
        let mut left = t * total;
        for side in corners.windows(2) {
            let here = length(side[0], side[1]);
            if left <= here {
                return [0, 1].map(|axis| side[0][axis] + (side[1][axis] - side[0][axis]) * left / here);
            }
            left -= here;
        }
        corners[corners.len() - 1]
    })
}

/// The curve, then straight on (or with a bend at the joint) for `length`, with the share of t it takes.
pub fn with_tail(curve: Curve, length: f64, bend: f64) -> Curve {
    let (end, before) = (curve(1.0), curve(0.99));
    let heading = (end[1] - before[1]).atan2(end[0] - before[0]) + bend;
    let share = 0.15;
    Box::new(move |t| {
        let beyond = (t - (1.0 - share)) / share;
        if beyond <= 0.0 {
            return curve(t / (1.0 - share));
        }
        [end[0] + beyond * length * heading.cos(), end[1] + beyond * length * heading.sin()]
    })
}

pub fn reversed(curve: Curve) -> Curve {
    Box::new(move |t| curve(1.0 - t))
}

/// A kind of stroke: its name, and how one is made for an outline of this aspect.
pub type Kind = (&'static str, fn(f64, &mut Pcg64Mcg) -> Curve);

/// Aspects 0.3..1.
pub const OUTLINES: &[Kind] = &[
    ("ends that meet", |aspect, rng| arc(aspect, rng.random(), 1.0)),
    ("ends that nearly meet", |aspect, rng| arc(aspect, rng.random(), rng.random_range(0.88..1.0))),
    ("a C with a gap of up to a quarter of its length", |aspect, rng| {
        let from = rng.random();
        // The largest piece whose chord is that share of its length.
        let share = rng.random_range(0.1..0.24);
        let mut turns = 1.0;
        loop {
            let curve = arc(aspect, from, turns);
            let points: Vec<_> = (0..=200).map(|i| curve(f64::from(i) / 200.0)).collect();
            let length: f64 = points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum();
            let chord = (points[200][0] - points[0][0]).hypot(points[200][1] - points[0][1]);
            if chord >= share * length || turns < 0.8 {
                return curve;
            }
            turns -= 0.005;
        }
    }),
    ("an overshoot along the outline", |aspect, rng| arc(aspect, rng.random(), rng.random_range(1.03..1.5))),
    ("an overshoot off the outline", |aspect, rng| {
        let (bend, length) = (rng.random_range(-0.6..0.6), rng.random_range(0.1..0.5) * 2.0 * aspect);
        with_tail(arc(aspect, rng.random(), rng.random_range(0.97..1.1)), length, bend)
    }),
    ("a hook at the start", |aspect, rng| {
        let (bend, length) = (rng.random_range(-1.0..1.0), rng.random_range(0.1..0.4) * 2.0 * aspect);
        reversed(with_tail(arc(aspect, rng.random(), rng.random_range(0.95..1.1)), length, bend))
    }),
    ("two or three rounds", |aspect, rng| {
        let (from, turns): (f64, f64) = (rng.random(), rng.random_range(1.6..3.5));
        let (drift, size) = (rng.random_range(0.0..0.08), rng.random_range(-0.08..0.08));
        Box::new(move |t| {
            let (y, x) = (TAU * (from + turns * t)).sin_cos();
            let grown = 1.0 + size * (2.0 * t - 1.0);
            [grown * x + drift * (5.0 * t).sin(), aspect * (grown * y + drift * (4.0 * t + from).cos())]
        })
    }),
];

/// Closed, but without an ellipse that is defined to a per cent.
pub const BLOBS: &[Kind] = &[
    ("a spiral from within", |aspect, rng| {
        let turns = rng.random_range(2.0..5.0);
        Box::new(move |t| {
            let (y, x) = (TAU * turns * t.sqrt()).sin_cos();
            [t.sqrt() * x, aspect * t.sqrt() * y]
        })
    }),
    ("hatched to and fro", |aspect, rng| {
        let rows = rng.random_range(9..14);
        let row = |i| -0.97 + 1.94 * f64::from(i) / f64::from(rows - 1);
        let side = |i| if i % 2 == 0 { 1.0 } else { -1.0 };
        let aspect = aspect.max(0.6);
        polyline((0..rows).map(|i| [row(i), side(i) * aspect * (1.0 - row(i) * row(i)).sqrt()]).collect())
    }),
    ("corners", |aspect, rng| {
        let n = rng.random_range(4..7);
        let from: f64 = rng.random();
        polyline(
            (0..=n)
                .map(|i| {
                    let (y, x) = (TAU * (from + f64::from(i) / f64::from(n))).sin_cos();
                    [x, aspect * y]
                })
                .collect(),
        )
    }),
    ("a bean", |aspect, _| {
        Box::new(move |t| {
            let (y, x) = (TAU * t).sin_cos();
            [x, aspect * y + 0.25 * x * x]
        })
    }),
    ("a thin loop there and back", |aspect, rng| {
        let thin = 0.14 + 0.12 * aspect;
        arc(thin, rng.random(), rng.random_range(0.96..1.06))
    }),
];

/// Half length 1 along x; the aspect is of no meaning.
pub const OPEN: &[Kind] = &[
    ("straight", |_, _| polyline(vec![[-1.0, 0.0], [1.0, 0.0]])),
    ("bent by up to 180°", |_, rng| {
        let half = rng.random_range(0.05..0.25);
        arc(1.0, 0.25 - half, 2.0 * half)
    }),
    ("an elbow", |_, rng| {
        let depth = rng.random_range(0.2..1.0);
        polyline(vec![[-1.0, 0.0], [rng.random_range(-0.5..0.5), depth], [1.0, 0.0]])
    }),
    ("wavy", |_, rng| {
        let (waves, height) = (rng.random_range(0.5..4.5), rng.random_range(0.03..0.3));
        Box::new(move |t| [2.0 * t - 1.0, height * (TAU * waves * t).sin()])
    }),
    ("an S", |_, rng| {
        let height = rng.random_range(0.1..0.6);
        Box::new(move |t| [2.0 * t - 1.0, height * (TAU * t).sin()])
    }),
    ("hooked", |_, rng| {
        let (length, bend) = (rng.random_range(0.1..0.4), rng.random_range(-2.9..2.9));
        with_tail(polyline(vec![[-1.0, 0.0], [1.0, 0.0]]), length, bend)
    }),
    ("a V", |_, rng| {
        let half = rng.random_range(0.17..0.6f64);
        polyline(vec![[1.0, half.tan()], [-1.0, 0.0], [1.0, -half.tan()]])
    }),
    ("a wide U", |_, rng| {
        let arm = rng.random_range(0.0..0.6);
        Box::new(move |t| {
            let along = (std::f64::consts::PI + 2.0 * arm) * t - arm;
            let (s, c) = along.clamp(0.0, std::f64::consts::PI).sin_cos();
            [s - (along - along.clamp(0.0, std::f64::consts::PI)).abs(), c]
        })
    }),
    ("hooked at both ends", |_, rng| {
        let [length, bend, other] = [0.35, 2.0, 2.0].map(|most: f64| rng.random_range(0.1..most));
        let hooked = with_tail(polyline(vec![[-1.0, 0.0], [1.0, 0.0]]), length, bend);
        with_tail(reversed(hooked), length, -other)
    }),
    ("retraced", |_, rng| {
        let passes = rng.random_range(2..6);
        let mut end = |i: i32| {
            let side = if i % 2 == 0 { -1.0 } else { 1.0 };
            [side * rng.random_range(0.9..1.0), rng.random_range(-0.04..0.04)]
        };
        polyline((0..=passes).map(&mut end).collect())
    }),
    ("a small loop at the end", |_, rng| {
        let r = rng.random_range(0.08..0.16);
        Box::new(move |t| {
            if t < 0.7 {
                return [-1.0 + 2.0 * t / 0.7, 0.0];
            }
            let (s, c) = (TAU * (t - 0.7) / 0.3 * 1.1).sin_cos();
            [1.0 + r * s, r - r * c]
        })
    }),
];

/// `STROKES` of a kind, with what was meant: area 40..1500 px², or length 10..160 px.
pub fn strokes((name, make): &Kind, line: bool) -> Vec<(Meant, Vec<[f64; 2]>)> {
    let mut rng =
        Pcg64Mcg::seed_from_u64(name.bytes().fold(1, |hash: u64, b| hash * 31 % 999_983 + u64::from(b)));
    (0..STROKES)
        .map(|_| {
            let aspect: f64 = rng.random_range(0.3..1.0);
            let area = rng.random_range(40f64.sqrt()..1500f64.sqrt()).powi(2);
            let radius = if line {
                rng.random_range(5.0..80.0)
            } else {
                (area / aspect / std::f64::consts::PI).sqrt()
            };
            let center = [rng.random_range(0.0..512.0), rng.random_range(0.0..512.0)];
            let meant = Meant { center, radius, aspect, angle: rng.random_range(0.0..180.0) };
            let curve = make(aspect, &mut rng);
            let points = drawn(&curve, &meant, &mut rng);
            (meant, points)
        })
        .collect()
}
