//! Measuring: marks that are painted with known attributes are measured with the same attributes.

mod weave;

use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::marks::{Ellipse, turn};
use dapple_engine::measure::{self, Directions, Picture, Reason, Regions, Target};
use proptest::prelude::*;

/// The profile of a mark across its edge; on the edge, all profiles are 0.5.
#[derive(Clone, Copy, Debug)]
enum Profile {
    /// 2^(−ρ²): a spot whose value decreases gradually from its centre.
    Soft,
    /// Nearly constant inside and outside, with an edge of a third of the radius, like grown spots.
    Firm,
    /// The share of a pixel that is covered, like in a printed picture.
    Hard,
}

/// The distance of a place from the centre in radii of the ellipse, across the border where `edges` wrap.
fn radius(ellipse: &Ellipse, [x, y]: [f64; 2], size: [f64; 2], edges: Edges) -> f64 {
    let near = |d: f64, side: f64| match edges {
        Edges::Wrap => d - side * (d / side).round(),
        Edges::Closed => d,
    };
    let (dx, dy) = (near(x - ellipse.center[0], size[0]), near(y - ellipse.center[1], size[1]));
    let (sin, cos) = ellipse.angle.to_radians().sin_cos();
    let (along, across) = (dx * cos + dy * sin, dy * cos - dx * sin);
    (along / ellipse.radii[0]).hypot(across / ellipse.radii[1])
}

fn draw(size: [usize; 2], edges: Edges, profile: Profile, ellipses: &[Ellipse]) -> Field {
    let extent = size.map(|side| side as f64);
    let out =
        |p: [f64; 2]| ellipses.iter().map(|e| radius(e, p, extent, edges)).fold(f64::INFINITY, f64::min);
    Field::from_fn(size, [1.0, 1.0], edges, |p| match profile {
        Profile::Soft => (-out(p) * out(p)).exp2() as f32,
        Profile::Firm => (0.5 + 0.5 * (3.0 * (1.0 - out(p))).tanh()) as f32,
        Profile::Hard => covered(p, |q| out(q) <= 1.0),
    })
}

/// The share of the pixel about `p` that is inside.
fn covered(p: [f64; 2], inside: impl Fn([f64; 2]) -> bool) -> f32 {
    let corners =
        [[-0.6, -0.6], [0.6, -0.6], [0.6, 0.6], [-0.6, 0.6]].map(|d| inside([p[0] + d[0], p[1] + d[1]]));
    if corners.iter().all(|corner| *corner == corners[0]) {
        return f32::from(u8::from(corners[0]));
    }
    let part = |k: usize| (k as f64 + 0.5) / 16.0 - 0.5;
    let hits = (0..256).filter(|k| inside([p[0] + part(k % 16), p[1] + part(k / 16)])).count();
    hits as f32 / 256.0
}

/// The errors of the only spot: area ratio − 1, aspect difference, angle difference, distance of the centres.
fn read(field: &Field, ellipse: &Ellipse) -> (f64, f64, f64, f64) {
    let spots = measure::spots(field, 0.5);
    assert_eq!(spots.len(), 1, "{ellipse:?}");
    assert!(spots[0].whole, "{ellipse:?}");
    let got = spots[0].ellipse;
    (
        got.area() / ellipse.area() - 1.0,
        got.aspect() - ellipse.aspect(),
        turn(got.major_angle(), ellipse.major_angle()),
        (got.center[0] - ellipse.center[0]).hypot(got.center[1] - ellipse.center[1]),
    )
}

/// Long stripes with this width, direction and wavelength, soft (a Gaussian that is 0.5 on the edge) or hard.
fn stripes(size: [usize; 2], hard: bool, width: f64, angle: f64, wavelength: f64) -> Field {
    let (sin, cos) = angle.to_radians().sin_cos();
    let out = |[x, y]: [f64; 2]| {
        let across = y * cos - x * sin;
        (across - wavelength * (across / wavelength).round()).abs() / (0.5 * width)
    };
    Field::from_fn(size, [1.0, 1.0], Edges::Closed, |p| {
        if hard { covered(p, |q| out(q) <= 1.0) } else { (-out(p) * out(p)).exp2() as f32 }
    })
}

/// This number of random cases, or the number in `PROPTEST_CASES` (`.ci/property`).
fn cases(usual: u32) -> ProptestConfig {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|text| text.parse().ok());
    ProptestConfig::with_cases(asked.unwrap_or(usual))
}

proptest! {
    #![proptest_config(cases(50))]

    #[test]
    fn a_soft_ellipse_is_measured_as_it_was_drawn(
        area in 40.0..1500.0, aspect in 0.3..1.0, angle in 0.0..180.0, x in 50.0..60.0, y in 50.0..60.0,
    ) {
        let ellipse = Ellipse::from_area([x, y], area, aspect, angle);
        let field = draw([110, 110], Edges::Closed, Profile::Soft, &[ellipse]);
        let (area, aspect, angle, centre) = read(&field, &ellipse);
        prop_assert!(area.abs() < 0.005, "area {}", area);
        prop_assert!(aspect.abs() < 0.005, "aspect {}", aspect);
        prop_assert!(angle.abs() < 0.3 || ellipse.aspect() > 0.95, "angle {}", angle);
        prop_assert!(centre < 0.01, "centre {}", centre);
    }

    #[test]
    fn a_firm_ellipse_is_measured_as_it_was_drawn(
        area in 100.0..1500.0, aspect in 0.3..1.0, angle in 0.0..180.0, x in 50.0..60.0, y in 50.0..60.0,
    ) {
        let ellipse = Ellipse::from_area([x, y], area, aspect, angle);
        let field = draw([110, 110], Edges::Closed, Profile::Firm, &[ellipse]);
        let (area, aspect, angle, _) = read(&field, &ellipse);
        prop_assert!(area.abs() < 0.005, "area {}", area);
        prop_assert!(aspect.abs() < 0.005, "aspect {}", aspect);
        prop_assert!(angle.abs() < 0.3 || ellipse.aspect() > 0.95, "angle {}", angle);
    }

    /// A printed edge is one pixel wide and blurs sharp tips: about 0.6 px² are missing, whatever the size is.
    #[test]
    fn a_hard_ellipse_is_measured_as_it_was_drawn(
        area in 100.0..1500.0, aspect in 0.3..1.0, angle in 0.0..180.0, x in 50.0..60.0, y in 50.0..60.0,
    ) {
        let ellipse = Ellipse::from_area([x, y], area, aspect, angle);
        let field = draw([110, 110], Edges::Closed, Profile::Hard, &[ellipse]);
        let (area, aspect, angle, _) = read(&field, &ellipse);
        prop_assert!(area.abs() * ellipse.area() < 2.5, "area {}", area);
        prop_assert!(aspect.abs() < 0.012, "aspect {}", aspect);
        // The same error of the second moments changes the direction of a rounder ellipse more.
        let turned = angle.abs() * (1.0 - ellipse.aspect());
        prop_assert!(turned < 0.35, "angle {}", angle);
    }

    #[test]
    fn on_a_tile_an_ellipse_is_one_spot_at_any_place(
        area in 60.0..400.0, aspect in 0.4..0.9, angle in 0.0..180.0, x in 0.0..64.0, y in 0.0..48.0,
    ) {
        let ellipse = Ellipse::from_area([x, y], area, aspect, angle);
        let field = draw([64, 48], Edges::Wrap, Profile::Firm, &[ellipse]);
        let spots = measure::spots(&field, 0.5);
        prop_assert_eq!(spots.len(), 1);
        let got = spots[0];
        prop_assert!(got.whole && !got.endless);
        prop_assert!((got.ellipse.area() / ellipse.area() - 1.0).abs() < 0.01);
        prop_assert!((got.ellipse.aspect() - aspect).abs() < 0.01);
        prop_assert!(turn(got.ellipse.major_angle(), angle).abs() < 0.5);
        prop_assert!(got.fill > 0.995);
        let near = |d: f64, side: f64| (d - side * (d / side).round()).abs();
        prop_assert!(near(got.ellipse.center[0] - x, 64.0) < 0.05);
        prop_assert!(near(got.ellipse.center[1] - y, 48.0) < 0.05);
        prop_assert!((0.0..=64.0).contains(&got.ellipse.center[0]));
    }

    #[test]
    fn stripes_are_measured_as_they_were_drawn(m in -9..=9_i32, n in 0..=9_i32, share in 0.3..0.6_f64, hard: bool) {
        // m and n stripes fit across and down the canvas, so that no frame cuts one lengthwise.
        prop_assume!((m, n) != (0, 0));
        let [k, l] = [f64::from(m) / 180.0, f64::from(n) / 160.0];
        let wavelength = 1.0 / k.hypot(l);
        let width = share * wavelength;
        let angle = l.atan2(k).to_degrees() + 90.0;
        let mut field = stripes([180, 160], hard, width, angle, wavelength);
        field.edges = Edges::Wrap;
        let got = measure::stripes(&field, 0.5).unwrap();
        // A printed edge is measured up to 0.09 px from its place, on alternating sides, which makes it longer.
        let (longer, off) = if hard { (0.015, 0.2) } else { (0.002, 0.0) };
        let tolerance = longer * width + off;
        prop_assert!((got.width - width).abs() < tolerance, "width {} {}", got.width, width);
        prop_assert!((got.wavelength / wavelength - 1.0).abs() < longer, "{} {}", got.wavelength, wavelength);
        prop_assert!(turn(got.angle, angle).abs() < 0.1, "angle {} {}", got.angle, angle);
        prop_assert!(got.coherence > 0.95 && got.alignment > 0.99, "{:?}", got);
        prop_assert!((got.share - share).abs() < 0.002 + off / wavelength, "{:?}", got);
    }
}

#[test]
fn a_cut_ellipse_is_not_whole_and_has_its_visible_area() {
    let ellipse = Ellipse { center: [40.0, 0.0], radii: [12.0, 8.0], angle: 0.0 };
    let field = draw([80, 60], Edges::Closed, Profile::Firm, &[ellipse]);
    let spots = measure::spots(&field, 0.5);
    assert_eq!(spots.len(), 1);
    assert!(!spots[0].whole);
    assert!((spots[0].ellipse.area() / (0.5 * ellipse.area()) - 1.0).abs() < 0.005);
    // Half of the perimeter, by Ramanujan's second formula; the part along the border does not count.
    let h = (4.0_f64 / 20.0).powi(2);
    let perimeter = std::f64::consts::PI * 20.0 * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()));
    assert!((spots[0].contour / (0.5 * perimeter) - 1.0).abs() < 0.002);
    assert!(spots[0].fill < 0.99);
}

#[test]
fn the_same_spots_on_coarser_cells_have_the_same_px() {
    let ellipse = Ellipse::from_area([61.0, 57.0], 600.0, 0.5, 33.0);
    let size = [120.0, 114.0];
    let on = |cell: [f64; 2]| {
        let cells = [(size[0] / cell[0]) as usize, (size[1] / cell[1]) as usize];
        let value = |p| (-radius(&ellipse, p, size, Edges::Closed).powi(2)).exp2() as f32;
        read(&Field::from_fn(cells, cell, Edges::Closed, value), &ellipse)
    };
    for cell in [[1.0, 1.0], [2.0, 1.9], [0.5, 0.5], [3.0, 3.0]] {
        let (area, aspect, angle, centre) = on(cell);
        assert!(area.abs() < 0.003 && aspect.abs() < 0.003, "{cell:?}: {area} {aspect}");
        assert!(angle.abs() < 0.1 && centre < 0.03, "{cell:?}: {angle} {centre}");
    }
}

/// Ellipses on a hexagonal lattice, larger towards the right: area 100 at x = 0, 200 at x = 240.
fn graded() -> Vec<Ellipse> {
    let row = 24.0 * 0.75_f64.sqrt();
    (0..12)
        .flat_map(|j| {
            (0..10).map(move |i| [24.0 * i as f64 + 12.0 * (j % 2) as f64 + 6.0, row * (j as f64 + 0.5)])
        })
        .map(|center| {
            Ellipse::from_area(center, 100.0 + 100.0 * center[0] / 240.0, 0.6, 20.0 + center[1] / 10.0)
        })
        .collect()
}

#[test]
fn errors_of_spots_are_the_differences_between_marks_and_map() {
    let edges = Edges::Wrap;
    let field = draw([240, 249], edges, Profile::Firm, &graded());
    let spots = measure::spots(&field, 0.5);
    let wanted = |[x, y]: [f64; 2]| {
        Attributes::Spots(Spots {
            area: (100.0 + 100.0 * x / 240.0) / 1.1,
            aspect: 0.57,
            angle: 17.0 + y / 10.0,
            spacing: Some(25.0),
        })
    };
    let region_of = |[x, _]: [f64; 2]| usize::from(x >= 120.0);
    let target = Target {
        bounds: field.grid().bounds_px(),
        regions: Regions::Any(3, &region_of),
        covered: &|_| false,
        wanted: &wanted,
        surface: None,
    };
    let errors = measure::spot_errors(&spots, &target);
    assert_eq!(errors[2], measure::SpotErrors::default());
    assert_eq!(errors[0].marks + errors[1].marks, 120);
    for error in &errors[..2] {
        assert!((error.area.unwrap() - 0.1).abs() < 0.004, "{error:?}");
        assert!((error.aspect.unwrap() - 0.03).abs() < 0.003, "{error:?}");
        assert!((error.angle.unwrap() - 3.0).abs() < 0.05, "{error:?}");
        assert!((error.spacing.unwrap() + 0.04).abs() < 0.002, "{error:?}");
        // The spots follow the map, so that nothing varies relative to it, except for errors of the grid.
        let spread = error.spread.unwrap();
        assert!(spread.area < 0.005 && spread.angle < 0.3, "{spread:?}");
        assert!(spread.aspect < 0.005 && spread.spacing < 0.005, "{spread:?}");
    }
    let rounder = |p: [f64; 2]| match wanted(p) {
        Attributes::Spots(spots) => Attributes::Spots(Spots { aspect: 0.9, spacing: None, ..spots }),
        other => other,
    };
    let errors = measure::spot_errors(&spots, &Target { wanted: &rounder, ..target });
    assert_eq!((errors[0].angle, errors[0].spacing), (None, None));
    assert!((errors[0].got.unwrap().spacing.unwrap() - 24.0).abs() < 0.05);
}

#[test]
fn cut_marks_are_neighbours_but_not_measured() {
    let field = draw([240, 249], Edges::Closed, Profile::Firm, &graded());
    let spots = measure::spots(&field, 0.5);
    let whole = spots.iter().filter(|spot| spot.whole).count();
    assert!(whole < spots.len());
    let wanted =
        |_: [f64; 2]| Attributes::Spots(Spots { area: 150.0, aspect: 0.6, angle: 20.0, spacing: Some(24.0) });
    let target = Target {
        bounds: field.grid().bounds_px(),
        regions: Regions::ONE,
        covered: &|_| false,
        wanted: &wanted,
        surface: None,
    };
    let errors = measure::spot_errors(&spots, &target);
    assert_eq!(errors[0].marks, whole);
    // The centre of a cut mark is shifted inwards, so that some long edges are inside the hull.
    assert!(errors[0].spacing.unwrap().abs() < 0.03, "{errors:?}");
}

#[test]
fn errors_of_stripes_are_the_differences_between_field_and_map() {
    let field = stripes([240, 200], false, 7.0, 40.0, 16.0);
    let wanted = |[x, _]: [f64; 2]| {
        let angle = if x < 120.0 { 35.0 } else { 44.0 };
        Attributes::Stripes(Stripes { width: 6.0, angle, wavelength: None })
    };
    let region_of = |[x, _]: [f64; 2]| usize::from(x >= 120.0);
    let target = Target {
        bounds: field.grid().bounds_px(),
        regions: Regions::Any(2, &region_of),
        covered: &|_| false,
        wanted: &wanted,
        surface: None,
    };
    let errors = measure::stripe_errors(&field, 0.5, &target);
    for (error, turned) in errors.iter().zip([5.0, -4.0]) {
        assert!((error.width.unwrap() - 1.0 / 6.0).abs() < 0.015, "{error:?}");
        assert!((error.angle.unwrap() - turned).abs() < 0.15, "{error:?}");
        assert!((error.angle_rms.unwrap() - turned.abs()).abs() < 0.3, "{error:?}");
        assert!((error.got.unwrap().angle - 40.0).abs() < 0.15, "{error:?}");
    }
}

#[test]
fn stripes_in_rings_have_the_direction_of_the_tangents() {
    let rings = Field::from_fn([200, 200], [1.0, 1.0], Edges::Closed, |[x, y]| {
        (0.5 + 0.5 * ((x - 100.0).hypot(y - 100.0) * std::f64::consts::TAU / 12.0).cos()) as f32
    });
    let directions = Directions::measure(&rings, 12.0);
    let places = directions.at_places(|[x, y]| {
        let (dx, dy) = (x - 100.0, y - 100.0);
        let double = 2.0 * (dy.atan2(dx) + std::f64::consts::FRAC_PI_2);
        (usize::from(dx.hypot(dy) > 25.0), [double.cos(), double.sin()])
    });
    let deviation = directions.deviations(&places, 2)[1].unwrap();
    assert!(deviation.mean.abs() < 0.05 && deviation.rms < 1.0, "{deviation:?}");
    // The directions cancel each other: there is no mean direction, although each place has a direction.
    let statistics = measure::stripes(&rings, 0.5).unwrap();
    assert!(statistics.alignment < 0.15 && statistics.coherence > 0.9, "{statistics:?}");
    assert!(
        (statistics.width - 6.0).abs() < 0.1 && (statistics.wavelength - 12.0).abs() < 0.1,
        "{statistics:?}"
    );
}

#[test]
fn directions_are_measured_on_canvases_shorter_than_the_wavelength() {
    // A wave along y: its stripes run along x.
    for size in [[11, 19], [19, 11], [2, 7], [3, 64]] {
        for edges in [Edges::Closed, Edges::Wrap] {
            for wavelength in [8.0, 40.0, 250.0, 4_000.0] {
                let wave = |[_, y]: [f64; 2]| (std::f64::consts::TAU * y / size[1] as f64).cos() as f32;
                let field = Field::from_fn(size, [1.0, 1.0], edges, wave);
                let mean = Directions::measure(&field, wavelength).mean();
                let along = |(angle, _): (f64, f64)| turn(angle, 0.0).abs() < 1e-3;
                assert!(mean.is_none_or(along), "{size:?} {edges:?} {wavelength}: {mean:?}");
                assert!(mean.is_some() || size != [11, 19] || wavelength > 8.0);
            }
        }
    }
}

#[test]
fn a_picture_is_classified_as_spots_or_stripes() {
    let spots = draw([240, 249], Edges::Closed, Profile::Hard, &graded());
    assert!(matches!(measure::picture(&spots, 0.5), Some(Picture::Spots { .. })));
    for (width, angle) in [(4.0, 0.0), (6.0, 45.0), (20.0, 100.0)] {
        let field = stripes([256, 256], true, width, angle, 2.4 * width);
        assert!(matches!(measure::picture(&field, 0.5), Some(Picture::Stripes { .. })), "{width} {angle}");
    }
    let one =
        draw([60, 60], Edges::Closed, Profile::Hard, &[Ellipse::from_area([30.0, 30.0], 150.0, 0.15, 70.0)]);
    assert!(matches!(measure::picture(&one, 0.5), Some(Picture::Spots { marks: 1, .. })));
    assert!(measure::picture(&Field::flat(40, 40, Edges::Closed, 0.0), 0.5).is_none());
}

#[test]
fn a_field_without_a_texture_is_refused_with_a_reason() {
    let judge = |field: &Field| measure::check_spot_texture(field, &measure::census(field, 0.5), [0.0, 1.0]);
    let with = |ellipses: &[Ellipse]| draw([240, 249], Edges::Wrap, Profile::Firm, ellipses);
    let even: Vec<Ellipse> =
        graded().iter().map(|e| Ellipse::from_area(e.center, 130.0, 0.6, e.angle)).collect();
    assert_eq!(judge(&with(&even)), Ok(()));
    assert!(matches!(judge(&Field::flat(50, 50, Edges::Wrap, 0.6)), Err(Reason::NoPattern { .. })));
    let mut blown = with(&even);
    blown.values[77] = f32::NAN;
    assert_eq!(judge(&blown), Err(Reason::NotFinite));
    assert_eq!(judge(&with(&even[..4])), Err(Reason::TooFew { marks: 4, least: 6 }));
    let mixed: Vec<Ellipse> =
        (0..120).map(|k| Ellipse::from_area(even[k].center, [60.0, 160.0][k % 2], 0.9, 0.0)).collect();
    assert!(matches!(judge(&with(&mixed)), Err(Reason::TooIrregular { .. })));
    let tiny = draw(
        [64, 64],
        Edges::Wrap,
        Profile::Soft,
        &(0..16)
            .map(|k| {
                Ellipse::from_area([16.0 * (k % 4) as f64 + 8.3, 16.0 * (k / 4) as f64 + 8.1], 5.0, 1.0, 0.0)
            })
            .collect::<Vec<_>>(),
    );
    assert!(matches!(judge(&tiny), Err(Reason::TooSmall { .. })));
    let bent: Vec<Ellipse> = even
        .iter()
        .flat_map(|e| {
            let [x, y] = e.center;
            [
                Ellipse::from_area([x - 4.0, y], 60.0, 0.5, 60.0),
                Ellipse::from_area([x + 4.0, y], 60.0, 0.5, 120.0),
            ]
        })
        .collect();
    assert!(matches!(judge(&with(&bent)), Err(Reason::Merged { .. })));
    let lines = stripes([240, 240], false, 6.0, 0.0, 12.0);
    assert!(judge(&Field { edges: Edges::Wrap, ..lines.clone() }).is_err());
    let found = measure::stripes(&lines, 0.5);
    assert_eq!(measure::check_stripe_texture(&lines, found.as_ref(), [0.0, 1.0]), Ok(()));
    let dots = draw([240, 240], Edges::Wrap, Profile::Firm, &graded());
    let found = measure::stripes(&dots, 0.5);
    assert!(measure::check_stripe_texture(&dots, found.as_ref(), [0.0, 1.0]).is_err(), "{found:?}");
}
