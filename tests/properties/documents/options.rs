//! Random options, colours and maps of a layer.

use dapple_engine::document::limits::{GAP, MAP_SIZE, Range as Limits};
use dapple_engine::document::{
    Colours, DutyChoice, GapChoice, LayerMap, LayerMaps, LayerOptions, MapChange, MapKey, MapSource, Over,
    RaggedChoice, Rosettes, Seeding, Spread, SpreadChoice, Stop, ToneImage,
};
use proptest::prelude::*;
use std::ops::{Range, RangeInclusive};

fn spread() -> impl Strategy<Value = SpreadChoice> {
    let given = (0.0..=0.6_f64, 0.0..=45.0_f64, 0.0..=0.2_f64, 0.0..=0.2_f64).prop_map(
        |(area, angle, aspect, spacing)| SpreadChoice::Given(Spread { area, angle, aspect, spacing }),
    );
    prop_oneof![2 => Just(SpreadChoice::Drawn), 1 => given]
}

/// Random values of some of all options, whether or not the layer allows them.
pub fn options() -> BoxedStrategy<LayerOptions> {
    options_of(1.0..=30.0)
}

/// Random values of some of all options, with gaps from the whole allowed range.
pub fn wild_options() -> BoxedStrategy<LayerOptions> {
    options_of(GAP.low..=GAP.high)
}

fn options_of(gaps: RangeInclusive<f64>) -> BoxedStrategy<LayerOptions> {
    let seeding = prop::sample::select(vec![Seeding::Noise, Seeding::Segments, Seeding::Initiators]);
    let often = |usual: f64, range: RangeInclusive<f64>| prop_oneof![2 => Just(usual), 1 => range];
    (
        spread(),
        prop_oneof![2 => Just(DutyChoice::Drawn), 1 => (0.18..=0.82_f64).prop_map(DutyChoice::Given)],
        often(0.0, 0.0..=0.6),
        often(0.0, 0.0..=1.0),
        any::<Option<bool>>(),
        seeding,
        prop_oneof![2 => Just(RaggedChoice::Drawn), 1 => (0.0..=0.5_f64).prop_map(RaggedChoice::Given)],
        often(24.0, 7.0..=200.0),
        prop_oneof![2 => Just(GapChoice::Drawn), 1 => gaps.prop_map(GapChoice::Given)],
        (often(0.8, 0.0..=0.85), prop::sample::select(Over::NAMES.map(|(_, over)| over).to_vec()), rosette()),
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
                // From numbers that only other marks use, so that these remain as they were before there were shapes of stripes.
                vary: if detail == 24.0 { 0.0 } else { 0.8 * (detail - 7.0) / 193.0 },
                near: if detail == 24.0 { 24.0 } else { 2.0 + detail },
                double: rest.2.as_ref().map_or(0.0, |of| of.solid),
                rosette: rest.2,
            }
        })
        .boxed()
}

/// Mostly none.
fn rosette() -> impl Strategy<Value = Option<Rosettes>> {
    let width = prop_oneof![Just(None), (2.0..=60.0_f64).prop_map(Some)];
    let parts = (1..=12_u32, 0..=4_u32).prop_map(|(least, more)| [least, (least + more).min(12)]);
    let given = (parts, 0.0..=1.0_f64, width, 0..=6_u32, 0.0..=0.45_f64)
        .prop_map(|(parts, solid, width, dots, tint)| Some(Rosettes { parts, solid, width, dots, tint }));
    prop_oneof![3 => Just(None), 1 => given]
}

/// Colours with stops and bends.
pub fn colours() -> impl Strategy<Value = Colours> {
    let stops = prop::collection::btree_map(0..=100_u32, any::<[u8; 3]>(), 1..4).prop_map(|stops| {
        stops.into_iter().map(|(at, colour)| Stop::opaque(f64::from(at) / 100.0, colour)).collect::<Vec<_>>()
    });
    let bend = (0.0..=1.0, -2.0..=3.0, 0.0..=1.0, -2.0..=3.0).prop_map(<[f64; 4]>::from);
    (stops, prop::collection::vec(bend, 0..3)).prop_map(|(stops, mut bends)| {
        bends.truncate(stops.len() - 1);
        // From numbers that are there already, so that the other random numbers stay.
        let [red, green, blue] = stops[0].colour;
        let ground = if red % 3 == 0 { [blue, red, green] } else { Colours::GROUND };
        let halo = if green % 4 == 0 { 0.05 + f64::from(blue) / 300.0 } else { 1.0 };
        Colours { stops, bends, ground, halo }
    })
}

/// Mostly no maps; otherwise noise and pictures that vary the drawn attributes by up to a half, or shift colours.
pub fn maps() -> BoxedStrategy<LayerMaps> {
    maps_of((5.0..90.0_f64).boxed(), 0.5..1.5)
}

/// Maps with noise of any allowed size, and with larger variation.
pub fn wild_maps() -> BoxedStrategy<LayerMaps> {
    let any = (0.0..=1.0_f64).prop_map(|share| {
        let Limits { low, high, .. } = MAP_SIZE;
        (low * (high / low).powf(share)).clamp(low, high)
    });
    maps_of(any.boxed(), 0.1..1.9)
}

fn maps_of(noise: BoxedStrategy<f64>, shares: Range<f64>) -> BoxedStrategy<LayerMaps> {
    let key = prop::sample::select(MapKey::ALL.to_vec());
    let image = prop::collection::vec(any::<u8>(), 6);
    let image = image.prop_map(|values| ToneImage::new([3, 2], values).expect("six px"));
    let image = image.prop_map(|image| MapSource::Image { image, factor: true });
    let noise = (noise, 1..4_u32).prop_map(|(size, octaves)| MapSource::Noise { size, octaves });
    let shares = [shares.clone(), shares];
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
    prop_oneof![3 => Just(Vec::new()), 1 => prop::collection::vec(one, 1..3)]
        .prop_map(|all| {
            let mut maps = LayerMaps::default();
            all.into_iter().for_each(|(key, map)| maps.set(key, Some(map)));
            maps
        })
        .boxed()
}
