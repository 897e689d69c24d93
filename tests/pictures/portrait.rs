//! A head, rendered from formulas: signed distance functions, traced along rays, with a lamp, a rim light, soft shadows
//! and occlusion.

type Vector = [f64; 3];

fn add(a: Vector, b: Vector, times: f64) -> Vector {
    [0, 1, 2].map(|axis| a[axis] + times * b[axis])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    a.map(|part| part / length(a))
}

/// The approximate distance from an ellipsoid.
fn ellipsoid(p: Vector, center: Vector, radii: Vector) -> f64 {
    let q = add(p, center, -1.0);
    let near = length([0, 1, 2].map(|axis| q[axis] / radii[axis]));
    let steep = length([0, 1, 2].map(|axis| q[axis] / (radii[axis] * radii[axis])));
    if steep < 1e-9 { -radii[0].min(radii[1]).min(radii[2]) } else { near * (near - 1.0) / steep }
}

/// The distance from a rod with round ends.
fn rod(p: Vector, from: Vector, to: Vector, radius: f64) -> f64 {
    let (out, along) = (add(p, from, -1.0), add(to, from, -1.0));
    let share = (dot(out, along) / dot(along, along)).clamp(0.0, 1.0);
    length(add(out, along, -share)) - radius
}

/// The union of two bodies with the distances `a` and `b`, joined smoothly over `soft`.
fn joined(a: f64, b: f64, soft: f64) -> f64 {
    let share = (0.5 + 0.5 * (b - a) / soft).clamp(0.0, 1.0);
    b + (a - b) * share - soft * share * (1.0 - share)
}

/// The part of the body with the distance `a` that is outside the body with the distance `b`, cut smoothly over `soft`.
fn without(a: f64, b: f64, soft: f64) -> f64 {
    -joined(-a, b, soft)
}

fn skin(p: Vector) -> f64 {
    // Left and right are symmetric.
    let m = [p[0].abs(), p[1], p[2]];
    let mut body = ellipsoid(p, [0.0, 0.28, -0.06], [0.62, 0.72, 0.74]);
    let mut join = |part: f64, soft: f64| body = joined(body, part, soft);
    join(ellipsoid(p, [0.0, -0.28, 0.16], [0.42, 0.56, 0.46]), 0.24);
    // Cheeks, chin, brows.
    join(ellipsoid(m, [0.30, -0.1, 0.36], [0.17, 0.15, 0.14]), 0.12);
    join(ellipsoid(p, [0.0, -0.66, 0.46], [0.14, 0.12, 0.12]), 0.1);
    join(ellipsoid(m, [0.22, 0.2, 0.56], [0.22, 0.07, 0.1]), 0.07);
    body = without(body, ellipsoid(m, [0.235, 0.07, 0.74], [0.15, 0.085, 0.16]), 0.06);
    let mut join = |part: f64, soft: f64| body = joined(body, part, soft);
    // Eyes, nose, lips, ears, neck.
    join(ellipsoid(m, EYE, [0.11, 0.085, 0.095]), 0.015);
    join(rod(p, [0.0, 0.14, 0.62], [0.0, -0.13, 0.80], 0.055), 0.07);
    join(ellipsoid(p, [0.0, -0.15, 0.76], [0.10, 0.065, 0.08]), 0.05);
    join(ellipsoid(p, [0.0, -0.345, 0.60], [0.16, 0.035, 0.06]), 0.03);
    join(ellipsoid(p, [0.0, -0.42, 0.59], [0.13, 0.04, 0.06]), 0.03);
    join(ellipsoid(m, [0.62, 0.02, -0.05], [0.06, 0.17, 0.11]), 0.04);
    join(rod(p, [0.0, -0.5, -0.12], [0.0, -1.3, -0.22], 0.30), 0.1);
    body
}

/// The middle of an eye.
const EYE: Vector = [0.23, 0.06, 0.50];

fn hair(p: Vector) -> f64 {
    let cap = ellipsoid(p, [0.0, 0.42, -0.12], [0.72, 0.72, 0.78]);
    let cap = without(cap, ellipsoid(p, [0.05, -0.02, 0.75], [0.56, 0.60, 0.75]), 0.08);
    let cap = without(cap, p[1] + 0.35, 0.1);
    0.8 * (cap + 0.02 * (26.0 * (p[0] + 0.5 * p[1]) + 5.0 * p[1]).sin())
}

/// The distance to the scene, and the material there: 0 = skin, 1 = cloth, 2 = hair.
fn scene(p: Vector) -> (f64, usize) {
    let chest = ellipsoid(p, [0.0, -1.62, -0.2], [1.12, 0.46, 0.46]);
    let chest = joined(chest, ellipsoid(p, [0.0, -1.5, -0.12], [0.5, 0.3, 0.35]), 0.2);
    let skin = skin(p);
    let dressed = if chest < skin { (joined(skin, chest, 0.05), 1) } else { (skin, 0) };
    let hair = hair(p);
    if hair < dressed.0 { (hair, 2) } else { dressed }
}

fn normal(p: Vector) -> Vector {
    let slope = |axis: usize| {
        let mut step = [0.0; 3];
        step[axis] = 1e-3;
        scene(add(p, step, 1.0)).0 - scene(add(p, step, -1.0)).0
    };
    unit([0, 1, 2].map(slope))
}

/// The share of a lamp in the direction `to` that reaches `p`.
fn lit(p: Vector, to: Vector) -> f64 {
    let (mut share, mut away) = (1.0f64, 0.03);
    for _ in 0..40 {
        let free = scene(add(p, to, away)).0;
        share = share.min(10.0 * free / away);
        away += free.clamp(0.01, 0.15);
        if share < 0.0 || away > 3.0 {
            break;
        }
    }
    share.clamp(0.0, 1.0)
}

/// The darkness of the paint at `p` on a material.
fn paint(p: Vector, material: usize) -> f64 {
    let inside = |x: f64, y: f64, [a, b]: [f64; 2]| (x / a).hypot(y / b) < 1.0;
    let base = [0.72, 0.16, 0.12][material];
    let x = p[0].abs();
    if material != 0 {
        base
    } else if ellipsoid([x, p[1], p[2]], EYE, [0.114, 0.088, 0.099]) < 0.0 {
        base * if inside(x - 0.225, p[1] - 0.06, [0.048; 2]) { 0.12 } else { 1.05 }
    } else if p[2] > 0.5 && inside(p[0], p[1] + 0.385, [0.19, 0.085]) {
        0.55 * base
    } else if p[2] > 0.4 && inside(x - 0.24, p[1] - 0.235 + 0.25 * (x - 0.2).powi(2), [0.17, 0.035]) {
        0.3 * base
    } else {
        base
    }
}

/// The light at a point of the unit square.
fn light_at(u: f64, v: f64) -> f64 {
    let (s, c) = 0.42f64.sin_cos();
    let turned = |p: Vector| [c * p[0] - s * p[2], p[1], s * p[0] + c * p[2]];
    let [x, y] = [2.45 * (u - 0.5), 2.45 * (0.47 - v)];
    let eye = turned([0.6 * x, 0.6 * y, 5.0]);
    let ray = unit(add(turned([x, y, 0.0]), eye, -1.0));
    let mut away = 2.5;
    for _ in 0..140 {
        let p = add(eye, ray, away);
        let (free, material) = scene(p);
        if free < 6e-4 {
            return shaded(p, ray, material, [[-0.75, 0.75, 0.85], [0.95, 0.15, 0.05]].map(turned));
        }
        away += 0.7 * free;
        if away > 9.0 {
            break;
        }
    }
    0.62 - 0.35 * ((u - 0.3).powi(2) + (v - 0.3).powi(2))
}

fn shaded(p: Vector, ray: Vector, material: usize, lamps: [Vector; 2]) -> f64 {
    let [lamp, rim] = lamps.map(unit);
    let (normal, reached) = (normal(p), lit(p, lamp));
    let hidden = |k: i32| {
        let away = 0.06 * f64::from(k);
        (away - scene(add(p, normal, away)).0) / 2f64.powi(k)
    };
    let open = (1.0 - 3.0 * (1..=5).map(hidden).sum::<f64>()).clamp(0.0, 1.0);
    let (sharp, gloss) = if material == 2 { (18, 0.12) } else { (30, 0.06) };
    let shine = dot(normal, unit(add(lamp, ray, -1.0))).max(0.0).powi(sharp);
    let direct = 1.05 * reached * dot(normal, lamp).max(0.0) + 0.22 * open * dot(normal, rim).max(0.0);
    paint(p, material) * (0.12 * open + direct) + gloss * reached * shine
}

/// The portrait: the mean light of four points per px, of a picture with 256 px a side.
pub fn portrait(u: f64, v: f64) -> f64 {
    let part = |k: i32| {
        let off = |k: i32| (f64::from(k) - 0.5) / 512.0;
        light_at(u + off(k % 2), v + off(k / 2))
    };
    (0..4).map(part).sum::<f64>() / 4.0
}
