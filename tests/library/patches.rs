//! Checks that patches, when they are measured, have the attributes that were asked for. `cargo run --release -p
//! data-gen -- trial patches` measures sixty random sketches.

use dapple_engine::attributes::Spread;
use dapple_engine::attributes::spacing::{mean_length, neighbours};
use dapple_engine::grid::{Edges, Field, Grid};
use dapple_engine::marks::Ellipse;
use dapple_engine::measure::{census, raggedness, spot_raggedness};
use dapple_engine::points::patches::{GrownPatches, Outline, Patches, Wanted};

const PATCH: Wanted =
    Wanted { area: 1500.0, spacing: 70.0, aspect: 0.6, angle: 30.0, raggedness: 1.4, spread: Spread::ZERO };

fn patches<'a>(side: usize, edges: Edges, wanted: &'a (dyn Fn([f64; 2]) -> Wanted + Sync)) -> Patches<'a> {
    let grid = Grid::unit([side, side], edges);
    Patches { grid, wanted, kept: &[], blocked: None, detail: Patches::DETAIL, seed: 1 }
}

/// The measured attributes of a field.
struct Got {
    count: usize,
    area: f64,
    spacing: f64,
    aspect: f64,
    angle: f64,
    raggedness: f64,
}

fn got(field: &Field) -> Got {
    let spots = census(field, 0.5).spots;
    let whole: Vec<_> = spots.iter().filter(|spot| spot.whole).map(|spot| spot.ellipse).collect();
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let mut double = [0.0, 0.0];
    for ellipse in &whole {
        let (s, c) = libm::sincos(2.0 * ellipse.major_angle().to_radians());
        let weight = 1.0 - ellipse.aspect();
        double = [double[0] + weight * c, double[1] + weight * s];
    }
    let centers: Vec<[f64; 2]> = spots.iter().map(|spot| spot.ellipse.center).collect();
    let tile = (field.edges == Edges::Wrap).then_some(field.extent());
    Got {
        count: spots.len(),
        area: mean(whole.iter().map(Ellipse::area).collect()),
        spacing: mean_length(&neighbours(&centers, tile)).expect("neighbours"),
        aspect: mean(whole.iter().map(Ellipse::aspect).collect()),
        angle: 0.5 * libm::atan2(double[1], double[0]).to_degrees(),
        raggedness: mean(spot_raggedness(field, 0.5)),
    }
}

/// The errors of area and spacing (relative), aspect and angle (differences), and raggedness (relative).
fn errors(wanted: &Wanted, got: &Got) -> [f64; 5] {
    let turned = (got.angle - wanted.angle + 90.0).rem_euclid(180.0) - 90.0;
    [
        got.area / wanted.area - 1.0,
        got.spacing / wanted.spacing - 1.0,
        got.aspect - wanted.aspect,
        turned,
        got.raggedness / wanted.raggedness - 1.0,
    ]
}

#[test]
fn patches_have_the_wanted_area_spacing_aspect_angle_and_raggedness() {
    for (coverage, aspect, raggedness, edges) in
        [(0.2, 0.5, 1.2, Edges::Wrap), (0.45, 0.75, 1.6, Edges::Closed), (0.65, 0.6, 1.35, Edges::Wrap)]
    {
        let spacing = Wanted::spacing_of_coverage(PATCH.area, coverage);
        let wanted = Wanted { spacing, aspect, raggedness, ..PATCH };
        let grown = patches(640, edges, &|_| wanted).grow();
        let got = got(&grown.field);
        let found = errors(&wanted, &got);
        let allowed = [0.02, 0.06, 0.06, 6.0, 0.12];
        assert!((0..5).all(|k| found[k].abs() < allowed[k]), "coverage {coverage}: {found:?}");
        // No patches merged and none are missing. At a closed border there are also cut patches whose centres are
        // outside.
        let lost = grown.centers.len() as i64 - got.count as i64;
        assert!(if edges == Edges::Wrap { lost == 0 } else { lost <= 0 }, "{lost}, coverage {coverage}");
        // Among dense patches, one in a hundred has no room for nine tenths of its area.
        assert!(grown.cramped * 100 <= grown.centers.len(), "{} cramped, coverage {coverage}", grown.cramped);
    }
}

#[test]
fn patches_follow_a_map_of_attributes() {
    let wanted = |[x, _]: [f64; 2]| {
        let t = (x / 720.0).clamp(0.0, 1.0);
        let area = 600.0 * libm::pow(4.0, t);
        Wanted {
            area,
            spacing: Wanted::spacing_of_coverage(area, 0.4),
            angle: 120.0 * t,
            raggedness: 1.3,
            ..PATCH
        }
    };
    let grown = patches(720, Edges::Closed, &wanted).grow();
    let spots = census(&grown.field, 0.5).spots;
    for (low, high) in [(0.0, 240.0), (240.0, 480.0), (480.0, 720.0)] {
        let mut share = (0.0, 0.0);
        let mut double = [0.0, 0.0];
        for spot in spots.iter().filter(|spot| spot.whole && (low..high).contains(&spot.ellipse.center[0])) {
            let asked = wanted(spot.ellipse.center);
            share = (share.0 + spot.ellipse.area() / asked.area, share.1 + 1.0);
            let (s, c) = libm::sincos(2.0 * (spot.ellipse.major_angle() - asked.angle).to_radians());
            double = [double[0] + c, double[1] + s];
        }
        let turned = 0.5 * libm::atan2(double[1], double[0]).to_degrees();
        assert!((share.0 / share.1 - 1.0).abs() < 0.06, "{low}: {share:?}");
        assert!(turned.abs() < 8.0, "{low}: {turned}");
    }
}

/// A ragged polygon of about `radius` px about a centre.
fn drawn(center: [f64; 2], radius: f64, lobes: f64, depth: f64) -> Vec<[f64; 2]> {
    let at = |k: usize| {
        let turn = std::f64::consts::TAU * k as f64 / 120.0;
        let (s, c) = libm::sincos(turn);
        let r = radius
            * (1.0 + depth * libm::cos(lobes * turn) + 0.5 * depth * libm::cos(2.3 * lobes * turn + 1.0));
        [center[0] + r * c, center[1] + 0.7 * r * s]
    };
    (0..120).map(at).collect()
}

/// For a region above ½ that belongs to an outline, and the outline: overlap ÷ union, within the box of the outline and
/// a margin.
fn overlap(field: &Field, outline: &Outline) -> f64 {
    let extent = dapple_engine::points::extent::Extent::from(field.grid().bounds_px());
    let [mut both, mut either] = [0, 0];
    for (cell, value) in field.values.iter().enumerate() {
        let depth = outline.depth(field.grid().center_px(cell), &extent);
        let (inside, grown) = (depth > 0.0, *value > 0.5 && depth > -6.0);
        both += usize::from(inside && grown);
        either += usize::from(inside || grown);
    }
    f64::from(both as u32) / f64::from(either as u32)
}

#[test]
fn kept_outlines_are_reproduced_and_other_patches_do_not_touch_them() {
    let shapes = [
        drawn([140.0, 150.0], 40.0, 5.0, 0.15),
        drawn([420.0, 180.0], 30.0, 3.0, 0.0),
        drawn([300.0, 420.0], 36.0, 7.0, 0.22),
        vec![[60.0, 420.0], [110.0, 400.0], [90.0, 470.0]],
    ];
    for edges in [Edges::Closed, Edges::Wrap] {
        let kept: Vec<Outline> =
            shapes.iter().map(|points| Outline::new(points.clone()).expect("an area")).collect();
        let wanted = Wanted { area: 2600.0, spacing: Wanted::spacing_of_coverage(2600.0, 0.4), ..PATCH };
        let grown = Patches { kept: &kept, ..patches(560, edges, &|_| wanted) }.grow();
        let spots = census(&grown.field, 0.5).spots;
        for outline in &kept {
            let shared = overlap(&grown.field, outline);
            assert!(shared > 0.9, "{shared}");
            let alone = |spot: &&dapple_engine::measure::Spot| {
                (spot.ellipse.area() / outline.area() - 1.0).abs() < 0.1
                    && (0..2).all(|k| (spot.ellipse.center[k] - outline.center()[k]).abs() < 3.0)
            };
            assert_eq!(spots.iter().filter(alone).count(), 1, "merged or missing: {:?}", outline.center());
            assert!(raggedness(outline.points()).is_some());
        }
    }
}

#[test]
fn no_patch_covers_the_marks_of_other_layers() {
    let blocked = |[x, y]: [f64; 2]| libm::hypot(x - 250.0, y - 250.0) < 90.0;
    let grown = Patches { blocked: Some(&blocked), ..patches(500, Edges::Wrap, &|_| PATCH) }.grow();
    let field = &grown.field;
    let inside = |cell: &usize| {
        let [x, y] = field.grid().center_px(*cell);
        libm::hypot(x - 250.0, y - 250.0) < 84.0
    };
    assert!((0..field.values.len()).filter(inside).all(|cell| field.values[cell] < 0.5));
    assert!(got(field).count > 30);
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_number_of_threads() {
    let grow = |seed: u64, threads: usize| -> GrownPatches {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| Patches { seed, ..patches(300, Edges::Wrap, &|_| PATCH) }.grow())
    };
    assert!(grow(1, 1) == grow(1, 3));
    assert!(grow(1, 1) != grow(2, 1));
}

#[test]
fn values_outside_the_usual_ranges_still_give_a_field() {
    let odd = [
        Wanted { area: 1.0, spacing: 3.0, ..PATCH },
        Wanted { spacing: 20.0, ..PATCH },
        Wanted { spacing: 5_000.0, ..PATCH },
        Wanted { aspect: 0.02, raggedness: 30.0, ..PATCH },
    ];
    for wanted in odd {
        let grown = Patches { detail: 0.0, ..patches(90, Edges::Closed, &|_| wanted) }.grow();
        assert!(grown.field.values.iter().all(|value| (0.0..=1.0).contains(value)), "{wanted:?}");
    }
}
