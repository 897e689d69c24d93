//! Random documents of spots or stripes, by number. Their textures differ as much as photographs do.

use dapple::document::{Colours, Document, Layer, Stroke};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Width and height, px.
const SIDE: u32 = 384;

/// Colours of ground and mark that differ by at least 0.25 in OKLab.
const COLOURS: [[[u8; 3]; 2]; 6] = [
    [[244, 227, 193], [59, 35, 20]],
    [[36, 64, 79], [239, 246, 242]],
    [[214, 160, 84], [40, 24, 12]],
    [[205, 214, 200], [52, 96, 60]],
    [[24, 24, 30], [224, 170, 60]],
    [[230, 222, 226], [120, 30, 60]],
];

/// Document number `k`: spots if it is even, stripes if odd; one to four regions.
pub fn document(k: u64) -> Document {
    let mut random = Pcg64Mcg::seed_from_u64(4000 + k);
    let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let regions = [if between(0.0, 1.0) < 0.5 { 1 } else { 2 }, if between(0.0, 1.0) < 0.5 { 1 } else { 2 }];
    let [ground, mark] = COLOURS[between(0.0, COLOURS.len() as f64) as usize];
    let (area, aspect, angle) = (between(90.0, 420.0), between(0.45, 0.95), between(0.0, 180.0));
    let spread = between(1.7, 2.3);
    let (width, duty) = (between(5.0, 13.0), between(0.36, 0.5));
    let mut strokes = Vec::new();
    for region in 0..regions[0] * regions[1] {
        let side = f64::from(SIDE);
        let middle = [
            (f64::from(region % regions[0]) + 0.5) * side / f64::from(regions[0]),
            (f64::from(region / regions[0]) + 0.5) * side / f64::from(regions[1]),
        ];
        let (larger, turned) = (between(0.8, 1.25), angle + between(-20.0, 20.0));
        let (sin, cos) = turned.to_radians().sin_cos();
        if k.is_multiple_of(2) {
            let area = larger * area;
            let minor = (area * aspect / std::f64::consts::PI).sqrt();
            let spacing = spread * 2.0 * (area / std::f64::consts::PI).sqrt();
            for corner in 0..3 {
                let (s, c) = (120.0 * f64::from(corner)).to_radians().sin_cos();
                let center = [middle[0] + spacing * c / 3_f64.sqrt(), middle[1] + spacing * s / 3_f64.sqrt()];
                strokes.push(Stroke::ellipse(center, [minor / aspect, minor], turned));
            }
        } else {
            let width = larger * width;
            for line in [-1.0, 0.0, 1.0] {
                let by = line * width / duty;
                let [x, y] = [middle[0] - by * sin, middle[1] + by * cos];
                strokes.push(Stroke::line(
                    [x - 25.0 * cos, y - 25.0 * sin],
                    [x + 25.0 * cos, y + 25.0 * sin],
                    width,
                ));
            }
        }
    }
    let colours = Colours::new([(0.0, ground), (0.4, ground), (0.6, mark), (1.0, mark)]);
    let layer = Layer::new(strokes).with_colours(colours);
    Document::new([SIDE; 2])
        .with_name(format!("random {k}"))
        .with_regions(regions)
        .with_seed(k)
        .with_layer(layer)
}
