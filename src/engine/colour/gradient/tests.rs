use super::*;
use proptest::prelude::*;

/// A slow reference from the definitions: Ottosson's matrices in his own form, std's powers, easing by bisection.
mod reference {
    use super::*;

    fn linear(channel: u8) -> f64 {
        let c = f64::from(channel) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    }

    fn encoded(c: f64) -> u8 {
        let c = c.clamp(0.0, 1.0);
        let e = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
        (255.0 * e).round() as u8
    }

    fn times(m: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
        m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    fn to_lab(colour: [u8; 3]) -> [f64; 3] {
        let lms = times(
            [
                [0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9],
                [0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6],
                [0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5],
            ],
            colour.map(linear),
        );
        times(
            [
                [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
                [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
                [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
            ],
            lms.map(f64::cbrt),
        )
    }

    fn from_lab(lab: [f64; 3]) -> [u8; 3] {
        let lms = times(
            [
                [1.0, 0.396_337_777_4, 0.215_803_757_3],
                [1.0, -0.105_561_345_8, -0.063_854_172_8],
                [1.0, -0.089_484_177_5, -1.291_485_548_0],
            ],
            lab,
        );
        times(
            [
                [4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2],
                [-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5],
                [-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701_0],
            ],
            lms.map(|c| c * c * c),
        )
        .map(encoded)
    }

    fn ease([x1, y1, x2, y2]: [f64; 4], x: f64) -> f64 {
        let bernstein = |p1: f64, p2: f64, t: f64| {
            3.0 * (1.0 - t) * (1.0 - t) * t * p1 + 3.0 * (1.0 - t) * t * t * p2 + t * t * t
        };
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..60 {
            let midpoint = 0.5 * (low + high);
            if bernstein(x1, x2, midpoint) < x { low = midpoint } else { high = midpoint }
        }
        bernstein(y1, y2, 0.5 * (low + high))
    }

    pub fn colour(gradient: &Gradient, v: f32) -> [u8; 3] {
        let stops = &gradient.stops;
        let after = stops.iter().take_while(|stop| stop.at <= v).count();
        if after == 0 || after == stops.len() {
            return stops[after.max(1) - 1].colour;
        }
        let [from, to] = [stops[after - 1], stops[after]];
        let way = (f64::from(v) - f64::from(from.at)) / (f64::from(to.at) - f64::from(from.at));
        let t = gradient.bends.get(after - 1).map_or(way, |bend| ease(bend.0, way));
        let [from, to] = [to_lab(from.colour), to_lab(to.colour)];
        from_lab([0, 1, 2].map(|i| from[i] + (to[i] - from[i]) * t))
    }
}

fn stop(at: f32, colour: [u8; 3]) -> Stop {
    Stop::opaque(at, colour)
}

const CREAM: [u8; 3] = [0xf4, 0xe3, 0xc1];
const BROWN: [u8; 3] = [0x3b, 0x23, 0x14];

fn assert_table_follows_reference(gradient: &Gradient) {
    let table = gradient.table();
    for step in 0..=u16::MAX {
        let v = f32::from(step) / 65535.0;
        let (fast, slow) = (table.colour(v), reference::colour(gradient, v));
        let apart = (0..3).map(|i| fast[i].abs_diff(slow[i])).max();
        assert!(apart <= Some(1), "{gradient:?} at {v}: {fast:?}, not {slow:?}");
        assert_eq!(fast, gradient.colour(v));
    }
}

#[test]
fn the_table_follows_a_slow_reference_at_every_step() {
    let gradients = [
        (vec![stop(0.0, CREAM), stop(1.0, BROWN)], vec![Bend([0.42, 0.0, 0.58, 1.0])]),
        // Hard steps, also at the ends, and a stop without effect.
        (
            vec![
                stop(0.0, [255, 0, 0]),
                stop(0.0, CREAM),
                stop(0.3, BROWN),
                stop(0.3, [1, 2, 3]),
                stop(0.3, [0, 0, 255]),
                stop(1.0, CREAM),
                stop(1.0, [0, 255, 0]),
            ],
            vec![],
        ),
        // As steep as possible, and overshooting the range of sRGB.
        (
            vec![stop(0.2, [0, 255, 0]), stop(0.6, [255, 0, 255]), stop(0.61, BROWN), stop(0.9, CREAM)],
            vec![Bend([1.0, 0.0, 0.0, 1.0]), Bend([0.0, 3.0, 1.0, -2.0]), Bend([0.0, 1.0, 0.0, 1.0])],
        ),
    ];
    for (stops, bends) in gradients {
        assert_table_follows_reference(&Gradient { stops, bends });
    }
}

#[test]
fn outside_of_the_stops_the_colour_is_constant() {
    let gradient = Gradient { stops: vec![stop(0.25, CREAM), stop(0.75, BROWN)], bends: vec![] };
    for v in [f32::NEG_INFINITY, -1.0, 0.0, 0.25, f32::NAN] {
        assert_eq!(gradient.colour(v), CREAM, "{v}");
    }
    for v in [0.75, 1.0, 7.0, f32::INFINITY] {
        assert_eq!(gradient.colour(v), BROWN, "{v}");
    }
    assert_eq!(Gradient { stops: vec![], bends: vec![] }.colour(0.5), [0; 3]);
}

#[test]
fn two_stops_at_one_value_are_a_hard_step() {
    let stops = vec![stop(0.0, CREAM), stop(0.5, CREAM), stop(0.5, BROWN), stop(1.0, BROWN)];
    let gradient = Gradient { stops, bends: vec![] };
    for (v, colour) in [(0.499_99, CREAM), (0.5, BROWN), (0.500_01, BROWN)] {
        assert_eq!(gradient.colour(v), colour, "{v}");
        assert_eq!(gradient.table().colour(v), colour, "{v} by table");
    }
}

#[test]
fn halfway_from_black_to_white_is_the_gray_of_half_the_lightness() {
    // OKLab lightness 0.5 is linear 0.125, sRGB 0.388573: 99.09 of 255.
    let gradient = Gradient { stops: vec![stop(0.0, [0; 3]), stop(1.0, [255; 3])], bends: vec![] };
    assert_eq!(gradient.colour(0.5), [99; 3]);
    let eased = Gradient { bends: vec![Bend([0.25, 0.1, 0.25, 1.0])], ..gradient };
    // 0.8024034³ = 0.516622 linear, sRGB 0.746257: 190.30 of 255.
    assert_eq!(eased.colour(0.5), [190; 3]);
}

proptest! {
    #[test]
    fn several_colours_at_once_equal_single_ones(values in prop::collection::vec(any::<f32>(), 0..9)) {
        let stops = vec![stop(0.1, CREAM), stop(0.4, BROWN), stop(0.9, CREAM)];
        let gradient = Gradient { stops, bends: vec![Bend([0.42, 0.0, 0.58, 1.0])] };
        let single: Vec<_> = values.iter().map(|v| gradient.colour(*v)).collect();
        prop_assert_eq!(gradient.colours(values), single);
    }

    #[test]
    fn any_colour_is_unchanged_by_oklab(colour: [u8; 3]) {
        let gradient = Gradient { stops: vec![stop(0.0, colour), stop(1.0, colour)], bends: vec![] };
        prop_assert_eq!(gradient.colour(0.4), colour);
    }

    #[test]
    fn any_gradient_has_a_colour_everywhere(
        mut ats in prop::collection::vec(0.0_f32..=1.0, 1..6),
        bends in prop::collection::vec((0.0..=1.0, any::<f64>(), 0.0..=1.0, any::<f64>()), 0..5),
        v: f32,
    ) {
        ats.sort_by(f32::total_cmp);
        let stops: Vec<_> = ats.into_iter().map(|at| stop(at, BROWN)).collect();
        let bends = bends.into_iter().map(|(x1, y1, x2, y2)| Bend([x1, y1, x2, y2])).take(stops.len() - 1);
        let gradient = Gradient { bends: bends.collect(), stops };
        let _ = gradient.colour(v);
    }
}

#[test]
fn the_colour_of_a_transparent_stop_does_not_shine_through() {
    let red = Stop { alpha: 0, ..stop(0.2, [255, 0, 0]) };
    let gradient = Gradient { stops: vec![red, stop(0.6, [0, 0, 200]), stop(1.0, [0; 3])], bends: vec![] };
    assert_eq!(gradient.rgba(0.0), [255, 0, 0, 0]);
    assert_eq!(gradient.rgba(0.3), [0, 0, 200, 64]);
    assert_eq!(gradient.rgba(0.5), [0, 0, 200, 191]);
    assert_eq!(gradient.rgba(0.6), [0, 0, 200, 255]);
    assert!(!gradient.is_opaque());
}

#[test]
fn stops_of_equal_opacity_have_the_colours_of_opaque_ones() {
    let opaque = Gradient::default_for_layer(0);
    let mut faint = opaque.clone();
    faint.stops.iter_mut().for_each(|stop| stop.alpha = 90);
    for step in 0..=50_u8 {
        let v = f32::from(step) / 50.0;
        let [red, green, blue] = opaque.colour(v);
        assert_eq!(faint.rgba(v), [red, green, blue, 90]);
    }
}

#[test]
fn the_table_shows_transparent_colours_over_white() {
    let half = Stop { alpha: 51, ..stop(0.0, [0, 100, 255]) };
    let table = Gradient { stops: vec![half], bends: vec![] }.table();
    assert_eq!(table.colour(0.5), [204, 224, 255]);
}
