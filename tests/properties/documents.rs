//! Documents of every kind of layer, system and option, as users might draw them, and with random values.

use crate::cases;
use dapple::document::Edges;
use dapple::document::Spread;
use dapple::document::{
    After, Colours, Document, DutyChoice, GapChoice, Growth, Interpolation, Kind, Labels, Layer, LayerMap,
    LayerMaps, LayerOptions, MapChange, MapKey, MapSource, Over, Points, Progression, RaggedChoice,
    SpreadChoice, Stop, Stroke, SystemChoice, ToneImage, Towards, layer_rules,
};
use dapple::document::{Ellipse, Line, Path};
use dapple_engine::rd::Seeding;
use proptest::prelude::*;

fn point(size: [u32; 2]) -> impl Strategy<Value = [f64; 2]> {
    let [width, height] = size.map(f64::from);
    (0.0..=width, 0.0..=height).prop_map(<[f64; 2]>::from)
}

/// Marks at least so thick that the grid of a small canvas is small.
fn thickness() -> impl Strategy<Value = f64> {
    prop_oneof![2.0..9.0_f64, 1.5..30.0_f64]
}

fn ellipse(size: [u32; 2]) -> impl Strategy<Value = Stroke> {
    (point(size), thickness(), thickness(), -400.0..400.0_f64)
        .prop_map(|(center, r, q, angle)| Stroke::Ellipse(Ellipse { center, radii: [r, q], angle }))
}

fn line(size: [u32; 2]) -> impl Strategy<Value = Stroke> {
    (point(size), point(size), thickness())
        .prop_map(|(from, to, width)| Stroke::Line(Line { from, to, width }))
}

fn path(size: [u32; 2]) -> impl Strategy<Value = Stroke> {
    (prop::collection::vec(point(size), 2..9), thickness())
        .prop_map(|(points, width)| Stroke::Path(Path { points, width }))
}

fn freehand(size: [u32; 2]) -> impl Strategy<Value = Stroke> {
    (prop::collection::vec(point(size), 2..12), thickness())
        .prop_map(|(points, width)| Stroke::Freehand { points, width })
}

/// A star about a point of the canvas, which may leave it.
fn outline(size: [u32; 2]) -> impl Strategy<Value = Stroke> {
    (point(size), prop::collection::vec(2.0..20.0_f64, 3..20)).prop_map(|([x, y], radii)| {
        let corner = |(k, r): (usize, &f64)| {
            let (s, c) = (std::f64::consts::TAU * k as f64 / radii.len() as f64).sin_cos();
            [x + r * c, y + r * s]
        };
        Stroke::outline(radii.iter().enumerate().map(corner))
    })
}

fn strokes(size: [u32; 2], kind: Kind) -> BoxedStrategy<Vec<Stroke>> {
    match kind {
        Kind::Ellipse => {
            let kinds = prop_oneof![
                12 => ellipse(size).boxed(),
                3 => outline(size).boxed(),
                1 => freehand(size).boxed(),
            ];
            prop::collection::vec(kinds, 1..5).boxed()
        }
        Kind::Line => {
            let stripes = prop_oneof![
                8 => line(size).boxed(),
                4 => path(size).boxed(),
                1 => freehand(size).boxed()
            ];
            prop::collection::vec(stripes, 1..5).boxed()
        }
    }
}

fn spread() -> impl Strategy<Value = SpreadChoice> {
    let given = (0.0..=0.6_f64, 0.0..=45.0_f64, 0.0..=0.2_f64, 0.0..=0.2_f64).prop_map(
        |(area, angle, aspect, spacing)| SpreadChoice::Given(Spread { area, angle, aspect, spacing }),
    );
    prop_oneof![2 => Just(SpreadChoice::Drawn), 1 => given]
}

fn options() -> impl Strategy<Value = LayerOptions> {
    let seeding = prop::sample::select(vec![Seeding::Noise, Seeding::Segments, Seeding::Initiators]);
    let often = |usual: f64, range: std::ops::RangeInclusive<f64>| prop_oneof![2 => Just(usual), 1 => range];
    (
        spread(),
        prop_oneof![2 => Just(DutyChoice::Drawn), 1 => (0.18..=0.82_f64).prop_map(DutyChoice::Given)],
        often(0.0, 0.0..=0.6),
        often(0.0, 0.0..=1.0),
        any::<Option<bool>>(),
        seeding,
        prop_oneof![2 => Just(RaggedChoice::Drawn), 1 => (0.0..=0.5_f64).prop_map(RaggedChoice::Given)],
        often(24.0, 7.0..=200.0),
        prop_oneof![2 => Just(GapChoice::Drawn), 1 => (1.0..=30.0_f64).prop_map(GapChoice::Given)],
        (often(0.8, 0.0..=0.85), prop::sample::select(Over::NAMES.map(|(_, over)| over).to_vec())),
    )
        .prop_map(|(spread, duty, broken, irregular, keep, seeding, ragged, detail, gap, rest)| {
            LayerOptions {
                spread,
                duty,
                broken,
                irregular,
                keep,
                seeding,
                ragged,
                detail,
                gap,
                decay: rest.0,
                over: rest.1,
            }
        })
}

fn colours() -> impl Strategy<Value = Colours> {
    let stops = prop::collection::btree_map(0..=100_u32, any::<[u8; 3]>(), 1..4).prop_map(|stops| {
        stops.into_iter().map(|(at, colour)| Stop::opaque(f64::from(at) / 100.0, colour)).collect::<Vec<_>>()
    });
    let bend = (0.0..=1.0, -2.0..=3.0, 0.0..=1.0, -2.0..=3.0).prop_map(<[f64; 4]>::from);
    (stops, prop::collection::vec(bend, 0..3)).prop_map(|(stops, mut bends)| {
        bends.truncate(stops.len() - 1);
        Colours { stops, bends }
    })
}

/// Mostly no maps; noise and pictures that vary what is drawn by up to a half, or shift colours.
fn maps() -> impl Strategy<Value = LayerMaps> {
    let key = prop::sample::select(MapKey::ALL.to_vec());
    let image = prop::collection::vec(any::<u8>(), 6);
    let image = image.prop_map(|values| ToneImage::new([3, 2], values).expect("six px"));
    let image = image.prop_map(|image| MapSource::Image { image, factor: true });
    let noise = (5.0..90.0_f64, 1..4_u32).prop_map(|(size, octaves)| MapSource::Noise { size, octaves });
    let shares = [0.5..1.5_f64, 0.5..1.5_f64];
    let one = (key, prop_oneof![image, noise], shares).prop_map(|(key, source, shares)| {
        let map = LayerMap { source, range: [0.0; 2] };
        let range = match (key, map.change(key)) {
            (MapKey::Growth, MapChange::Replace) => shares.map(|share| 18.0 + 9.0 * (share - 0.5)),
            (MapKey::Direction, _) => shares.map(|share| 60.0 * (share - 1.0)),
            (_, MapChange::Add) => shares.map(|share| share - 1.0),
            _ => shares,
        };
        (key, LayerMap { range, ..map })
    });
    prop_oneof![3 => Just(Vec::new()), 1 => prop::collection::vec(one, 1..3)].prop_map(|all| {
        let mut maps = LayerMaps::default();
        all.into_iter().for_each(|(key, map)| maps.set(key, Some(map)));
        maps
    })
}

fn picture() -> impl Strategy<Value = ToneImage> {
    prop::collection::vec(any::<u8>(), 6).prop_map(|values| ToneImage::new([3, 2], values).expect("six px"))
}

fn labels() -> impl Strategy<Value = Labels> {
    let cluster = || 1..60_u32;
    prop_oneof![
        (1..5_u32).prop_map(|group| Labels::Values { group }),
        (0.1..=0.9_f64, 0.1..=0.9_f64).prop_map(|(a, b)| Labels::Random { dark: [a, b] }),
        (picture(), 1..4_u32).prop_map(|(image, passes)| Labels::Image { image, passes }),
        (3..12_u32, 0..12_u32).prop_map(|(least, more)| Labels::SpaceGiraffe { rays: [least, least + more] }),
        cluster().prop_map(|size| Labels::BreadthFirst { size }),
        cluster().prop_map(|size| Labels::DepthFirst { size }),
        (cluster(), 0..2_u32).prop_map(|(size, rings)| Labels::RoundRobin { size, rings }),
        (0.01..=0.3_f64, 0..2_u32).prop_map(|(start, rings)| Labels::Connected { start, rings }),
    ]
}

/// Any points of a field; none at random are those that follow what is drawn.
pub fn points() -> impl Strategy<Value = Points> {
    let distance = (4.0..30.0_f64, 4.0..30.0_f64).prop_map(|(a, b)| [a, b]);
    let progression = prop_oneof![
        Just(Progression::Across),
        Just(Progression::Down),
        Just(Progression::Outward),
        picture().prop_map(Progression::Image),
    ];
    let towards = prop_oneof![
        Just(Towards::Random),
        Just(Towards::Outward),
        (-180.0..180.0_f64).prop_map(Towards::Angle)
    ];
    let shifted = (prop_oneof![2 => Just(0.0), 1 => 0.0..=1.0_f64], towards);
    let cut = (any::<bool>(), prop::option::of(0.1..=0.9_f64), 1.0..=2.0_f64);
    let made = (prop::option::of(distance), progression, labels(), 1..4_u32, any::<bool>(), shifted, cut);
    made.prop_map(
        |(distance, progression, labels, octaves, fold, (shift, towards), (nearest, share, axis))| {
            let interpolation = if nearest { Interpolation::Nearest } else { Interpolation::Smooth };
            let share = share.filter(|_| !nearest);
            Points {
                distance,
                progression,
                labels,
                octaves,
                fold,
                interpolation,
                axis,
                shift,
                towards,
                share,
            }
        },
    )
}

fn layer(size: [u32; 2]) -> impl Strategy<Value = Layer> {
    let kinds = prop::sample::select(vec![Kind::Ellipse, Kind::Line]);
    kinds.prop_flat_map(move |kind| {
        let system = prop::sample::select(
            SystemChoice::names().into_iter().map(|(_, system)| system).collect::<Vec<_>>(),
        );
        let ways: &[After] = match kind {
            Kind::Ellipse => &[After::Between, After::Inside],
            Kind::Line => &[After::Between, After::Around, After::Net],
        };
        let after = prop_oneof![
            5 => prop::sample::select(ways),
            1 => prop::sample::select(After::NAMES.map(|(_, after)| after).to_vec()),
        ];
        let chosen = (system, after, any::<bool>(), any::<Option<u64>>());
        let options = prop_oneof![2 => Just(LayerOptions::default()), 3 => options()];
        let made = (strokes(size, kind), prop::option::of(points()));
        ("\\PC{0,12}", chosen, made, options, maps(), prop::option::of(colours())).prop_map(
            move |(name, (system, after, visible, seed), (strokes, points), options, maps, colours)| {
                let tone = None;
                let far_spacing = seed.map(|seed| 0.01 + (seed % 100_000) as f64);
                let mut layer = Layer {
                    name,
                    system,
                    after,
                    visible,
                    seed,
                    strokes,
                    far_spacing,
                    options,
                    points,
                    tone,
                    maps,
                    colours,
                };
                // Remaining conflicts (`after` with the marks) are refused when the document is grown.
                layer_rules::tidy(&mut layer, Some(kind));
                layer
            },
        )
    })
}

/// The lowest layer has none beneath it to relate to, and those above what scattered points make grow
/// between it.
fn on_the_ground(mut layers: Vec<Layer>) -> Vec<Layer> {
    for index in 0..layers.len() {
        if index == 0 || layers[index - 1].is_of_points() {
            layers[index].after = After::Between;
        }
    }
    layers
}

/// A valid document on a canvas of up to so many px a side, with up to so many layers.
pub fn document(side: u32, layers: usize) -> impl Strategy<Value = Document> {
    let size = (8..=side, 8..=side).prop_map(<[u32; 2]>::from);
    let drawn = size.prop_flat_map(move |size| {
        let layers = (prop::collection::vec(layer(size), 1..=layers), prop::bool::weighted(0.9));
        (Just(size), layers.prop_map(|(layers, usual)| if usual { on_the_ground(layers) } else { layers }))
    });
    let regions = prop::option::of((1..=3_u32, 1..=3_u32).prop_map(<[u32; 2]>::from));
    let edges = prop::sample::select(vec![Edges::Closed, Edges::Wrap]);
    let document = ("\\PC{0,12}", drawn, regions, edges, any::<u64>(), any::<bool>()).prop_map(
        |(name, (size, layers), regions, edges, seed, refine)| Document {
            name,
            size,
            regions,
            edges,
            seed,
            dpi: 300.0,
            growth: Growth { refine },
            layers,
            starred: Vec::new(),
        },
    );
    document.prop_filter("is valid", |document| document.check("x").is_ok())
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_document_of_any_layers_and_options_is_read_as_it_was_written(document in document(2_000, 3)) {
        let text = document.to_json();
        let read = Document::parse(&text, "x").unwrap();
        prop_assert_eq!(&read, &document);
        prop_assert_eq!(read.to_json(), text);
    }
}
