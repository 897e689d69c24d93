//! Properties of every document.

use super::*;
use dapple::document::{Axis, Body, BodyEllipse, BodyMark, BodySource, ParametricSurface, Pin, Relief};
use dapple::document::{Finish, FinishKind, Finishing, FlowChoice, Warp};

fn number(low: f64, high: f64) -> impl Strategy<Value = f64> {
    prop_oneof![low..=high, (low.ceil() as i64..=high.floor() as i64).prop_map(|x| x as f64)]
}

/// A point of the canvas of 512 × 256 px.
fn point() -> impl Strategy<Value = [f64; 2]> {
    (number(0.0, 512.0), number(0.0, 256.0)).prop_map(<[f64; 2]>::from)
}

fn ellipse() -> impl Strategy<Value = Stroke> {
    (point(), number(0.01, 512.0), number(0.01, 512.0), number(-1e4, 1e4))
        .prop_map(|(center, r, q, angle)| Stroke::Ellipse(Ellipse { center, radii: [r, q], angle }))
}

fn freehand() -> impl Strategy<Value = Stroke> {
    let points = prop::collection::vec(point(), 2..60);
    let points = points.prop_filter("has an extent", |p| p.iter().any(|q| (q[0] - p[0][0]).abs() > 0.1));
    (points, number(0.01, 512.0)).prop_map(|(points, width)| Stroke::Freehand { points, width })
}

fn path() -> impl Strategy<Value = Stroke> {
    let points = prop::collection::vec(point(), 2..60);
    let points = points.prop_filter("has an extent", |p| p.iter().any(|q| (q[0] - p[0][0]).abs() > 0.1));
    (points, number(0.01, 512.0)).prop_map(|(points, width)| Stroke::path(points, width))
}

/// A star-shaped outline about a point, which therefore does not cross itself.
fn outline() -> impl Strategy<Value = Stroke> {
    let center = (number(100.0, 400.0), number(60.0, 200.0));
    (center, prop::collection::vec(0.2f64..60.0, 3..60)).prop_map(|((x, y), radii)| {
        let corner = |(k, r): (usize, &f64)| {
            let (s, c) = (std::f64::consts::TAU * k as f64 / radii.len() as f64).sin_cos();
            [x + r * c, y + r * s]
        };
        Stroke::outline(radii.iter().enumerate().map(corner))
    })
}

fn line() -> impl Strategy<Value = Stroke> {
    (point(), point(), number(0.01, 512.0))
        .prop_filter("has a length", |(from, to, _)| (from[0] - to[0]).abs() > 0.1)
        .prop_map(|(from, to, width)| Stroke::Line(Line { from, to, width }))
}

fn colours() -> impl Strategy<Value = Colours> {
    let stops = prop::collection::btree_map(0..=1000u32, any::<[u8; 4]>(), 1..5).prop_map(|stops| {
        let stop = |(at, [red, green, blue, alpha]): (u32, [u8; 4])| Stop {
            at: f64::from(at) / 1000.0,
            colour: [red, green, blue],
            alpha,
        };
        stops.into_iter().map(stop).collect::<Vec<_>>()
    });
    let bend = (0.0..=1.0, -2.0..=3.0, 0.0..=1.0, -2.0..=3.0).prop_map(<[f64; 4]>::from);
    (stops, prop::collection::vec(bend, 0..5)).prop_map(|(stops, mut bends)| {
        bends.truncate(stops.len() - 1);
        // From numbers that are there already, so that the other random numbers stay.
        let [red, green, blue] = stops[0].colour;
        let ground = if red % 3 == 0 { [blue, red, green] } else { Colours::GROUND };
        let halo = if green % 4 == 0 { 0.05 + f64::from(blue) / 300.0 } else { 1.0 };
        Colours { stops, bends, ground, halo }
    })
}

fn layer() -> impl Strategy<Value = Layer> {
    let spots = prop::collection::vec(prop_oneof![ellipse(), outline(), freehand()], 1..6);
    let lines = prop::collection::vec(prop_oneof![line(), path(), freehand()], 1..6);
    let after = prop::sample::select(After::NAMES.map(|(_, after)| after).to_vec());
    let strokes = prop_oneof![spots, lines];
    (".{0,20}", after, any::<bool>(), any::<Option<u64>>(), strokes, prop::option::of(colours())).prop_map(
        |(name, after, visible, seed, strokes, colours)| Layer {
            name,
            after,
            visible,
            seed,
            strokes,
            colours,
            ..Layer::default()
        },
    )
}

fn document() -> impl Strategy<Value = Document> {
    let edges = prop::sample::select(vec![Edges::Closed, Edges::Wrap]);
    let regions = prop::option::of((1..=64u32, 1..=64u32).prop_map(<[u32; 2]>::from));
    let layers = prop::collection::vec(layer(), 1..4);
    let chosen = (".{0,20}", regions, edges, any::<u64>(), number(1.0, 1e5), any::<bool>());
    let on_model = prop_oneof![
        Just((None, None, None)),
        (model(), body_mark()).prop_map(|(model, mark)| (Some(model), Some(mark), None)),
        parametric().prop_map(|surface| (None, None, Some(surface))),
    ];
    (chosen, layers, on_model).prop_map(
        |((name, regions, edges, seed, dpi, refine), mut layers, (model, mark, parametric))| {
            layers[0].on_model.extend(mark);
            let (size, growth) = ([512, 256], Growth { refine });
            let starred = Vec::new();
            // Models and surfaces with a flat map take no finish.
            let finish = finish(seed).filter(|_| model.is_none() && parametric.is_none());
            let warp =
                (seed % 3 == 0 && model.is_none()).then_some(Warp { size: 40.0, by: (seed % 9) as f64 });
            Document {
                name,
                size,
                regions,
                edges,
                seed,
                dpi,
                growth,
                model,
                parametric,
                warp,
                finish,
                layers,
                starred,
            }
        },
    )
}

/// One of all finishes, or none.
fn finish(seed: u64) -> Option<Finishing> {
    let (_, kind) = *FinishKind::NAMES.get((seed % (FinishKind::NAMES.len() as u64 + 1)) as usize)?;
    let size = 2.0 + (seed % 61) as f64;
    let flow = if kind.has_flow() { FlowChoice::Angle((seed % 359) as f64) } else { FlowChoice::Usual };
    Some(Finishing { finish: Finish { size, mottle: size / 300.0, ..Finish::new(kind) }, flow })
}

/// A surface that has a flat map; its height picture is not read.
fn parametric() -> impl Strategy<Value = ParametricSurface> {
    let heights = (".{1,20}", number(0.0, 65_536.0))
        .prop_map(|(path, scale)| ParametricSurface::Heights(Relief::new(path, scale)));
    prop_oneof![Just(ParametricSurface::Torus), heights]
}

/// A point of a model.
fn place() -> impl Strategy<Value = [f64; 3]> {
    (number(-9.0, 9.0), number(-1e9, 1e9), number(-1e-3, 1e-3)).prop_map(<[f64; 3]>::from)
}

fn model() -> impl Strategy<Value = Body> {
    let file =
        (".{1,20}", any::<Option<[u8; 32]>>()).prop_map(|(path, sha256)| BodySource::File { path, sha256 });
    let source = prop_oneof![Just(BodySource::BuiltIn("egg")), file];
    let axis = || prop::sample::select(Axis::NAMES.map(|(_, axis)| axis).to_vec());
    let toward = prop::option::of(place().prop_map(|[x, y, _]| [x, y, 1.0]));
    let pin = (place(), toward).prop_map(|(at, toward)| Pin { region: [0, 0], at, toward });
    let stroke = (place(), place()).prop_map(|(from, [x, y, _])| vec![from, [x, y, from[2] + 1.0]]);
    let lists = (
        prop::collection::vec(pin, 0..3),
        prop::collection::vec(stroke, 0..3),
        prop::collection::vec(".{1,9}", 0..3),
    );
    (source, number(60.0, 65_536.0), axis(), axis(), lists).prop_map(
        |(source, px, up, along, (pins, strokes, only))| Body { source, px, up, along, pins, strokes, only },
    )
}

fn body_mark() -> impl Strategy<Value = BodyMark> {
    let normal = prop::option::of(place().prop_map(|[x, y, _]| [x, y, 1.0]));
    let ellipse = (place(), normal, number(0.01, 60.0), number(0.01, 60.0), number(-1e4, 1e4));
    ellipse.prop_map(|(at, normal, r, q, angle)| {
        BodyMark::Ellipse(BodyEllipse { at, normal, radii: [r, q], angle })
    })
}

proptest! {
    #![proptest_config(crate::cases(200))]

    #[test]
    fn a_document_written_is_the_document_read(document in document()) {
        let text = document.to_json();
        let read = Document::parse(&text, "x").unwrap();
        prop_assert_eq!(&read, &document);
        prop_assert_eq!(read.to_json(), text);
    }

    /// Any damaged file is read, or is refused with one line that names the file.
    #[test]
    fn a_damaged_file_never_panics(
        document in document(),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<char>()), 1..4),
    ) {
        let mut text: Vec<char> = document.to_json().chars().collect();
        for (index, new) in damage {
            let at = index.index(text.len());
            text[at] = new;
        }
        if let Err(error) = Document::parse(&text.into_iter().collect::<String>(), "bad.dapple") {
            let message = error.to_string();
            prop_assert!(message.starts_with("bad.dapple: "));
            prop_assert!(!message.contains(char::is_control), "{:?}", message);
            prop_assert!(message.len() < 1000);
        }
    }
}
