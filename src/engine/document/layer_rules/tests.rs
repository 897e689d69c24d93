use super::*;
use crate::attributes::Spread;
use crate::document::{
    Document, DutyChoice, GapChoice, LayerMap, LayerMaps, MapSource, Over, RaggedChoice, Rosettes, Seeding,
    SpreadChoice, Stroke,
};
use crate::rd::System;
use proptest::prelude::*;

fn alone(marks: Option<Kind>) -> Combination {
    Combination::new(&Layer::default(), marks, Beneath::Nothing)
}

#[test]
fn a_system_takes_only_the_marks_it_grows() {
    assert!(alone(Some(Line)).against_system(SystemChoice::Auto).is_none());
    assert!(
        alone(Some(Ellipse)).against_system(SystemChoice::Of(System::TURING_SPOTS.description())).is_none()
    );
    let layer =
        Combination { system: SystemChoice::Of(System::TURING_SPOTS.description()), ..alone(Some(Line)) };
    let problem = layer.problem("layers[0]").unwrap();
    assert_eq!(problem.place, "layers[0].system");
    assert_eq!(
        problem.allowed,
        "auto, stripes, meinhardt-stripes, meinhardt-lines, weave, maze, pair-stripes, stucco, streaks, cracks, turing-growth. This system grows spots; this layer holds lines"
    );
}

#[test]
fn a_layer_of_either_kind_at_its_defaults_goes_with_any_layer_beneath() {
    for marks in [None, Some(Ellipse), Some(Line)] {
        for beneath in [Beneath::Unknown, Beneath::Nothing, Beneath::Grows(Ellipse), Beneath::Grows(Line)] {
            let layer = Combination { beneath, ..alone(marks) };
            assert!(layer.broken_rule().is_none(), "{layer:?}");
        }
    }
}

#[test]
fn every_rule_can_be_broken() {
    let mut never: Vec<&Rule> = RULES.iter().collect();
    let options = OptionKey::ALL.map(|option| {
        let mut options = LayerOptions {
            spread: SpreadChoice::Given(Spread::ZERO),
            irregular: 0.5,
            duty: DutyChoice::Given(0.3),
            seeding: Seeding::Segments,
            broken: 0.3,
            near: 40.0,
            keep: Some(true),
            vary: 0.3,
            double: 0.2,
            ragged: RaggedChoice::Given(0.2),
            detail: 40.0,
            gap: GapChoice::Given(5.0),
            rosette: Some(Rosettes::default()),
            decay: 0.5,
            over: Over::Plain,
        };
        for other in OptionKey::ALL.into_iter().filter(|other| *other != option) {
            other.reset(&mut options);
        }
        options
    });
    let thin =
        LayerOptions { duty: DutyChoice::Given(0.3), seeding: Seeding::Segments, ..LayerOptions::default() };
    for marks in [None, Some(Ellipse), Some(Line)] {
        for beneath in [Beneath::Nothing, Beneath::Grows(Line), Beneath::Pairs, Beneath::Areas, Beneath::Tone]
        {
            for (_, after) in After::NAMES {
                for (_, system) in SystemChoice::names() {
                    for options in options.into_iter().chain([thin]) {
                        for driven in [false, true] {
                            for mapped in [false, true].map(|mapped| [mapped; MapKey::ALL.len()]) {
                                let pointed = mapped[0];
                                let layer = Combination {
                                    marks,
                                    holds_both: mapped[0] && marks == Some(Ellipse),
                                    beneath,
                                    after,
                                    system,
                                    options,
                                    driven,
                                    pointed,
                                    by_chance: false,
                                    mapped,
                                };
                                never.retain(|rule| !rule.refuses(&layer));
                            }
                        }
                    }
                }
            }
        }
    }
    // Options that every system takes at present if its marks can have them.
    let taken = [OptionKey::Duty, OptionKey::Keep];
    never.retain(|rule| !matches!(rule.condition, Condition::NotTaken(option) if taken.contains(&option)));
    assert!(never.is_empty(), "{never:?}");
}

#[test]
fn a_problem_names_the_value_and_what_is_allowed() {
    let with = |options| Combination { options, ..alone(Some(Ellipse)) }.problem("layers[2]").unwrap();
    let problem = with(LayerOptions { duty: DutyChoice::Given(0.3), ..LayerOptions::default() });
    assert_eq!([problem.place.as_str(), problem.found.as_str()], ["layers[2].options.duty", "0.3"]);
    assert!(problem.allowed.starts_with("\"drawn\" or 0.5. Only stripes"), "{problem}");
    let ring = Combination { after: After::Around, ..alone(Some(Line)) }.problem("layers[0]").unwrap();
    assert_eq!([ring.place.as_str(), ring.found.as_str()], ["layers[0].after", "\"around\""]);
    assert!(ring.allowed.starts_with("between. The lowest layer"), "{ring}");
}

fn any_maps() -> impl Strategy<Value = LayerMaps> {
    prop::collection::vec(prop::sample::select(MapKey::ALL.to_vec()), 0..3).prop_map(|keys| {
        let mut maps = LayerMaps::default();
        let noise = LayerMap { source: MapSource::Noise { size: 30.0, octaves: 1 }, range: [0.2, 0.4] };
        keys.into_iter().for_each(|key| maps.set(key, Some(noise.clone())));
        maps
    })
}

fn any_options() -> impl Strategy<Value = LayerOptions> {
    let given = (0.0..0.6f64, 0.0..45.0f64);
    let given = given.prop_map(|(area, angle)| SpreadChoice::Given(Spread { area, angle, ..Spread::ZERO }));
    let spread = prop_oneof![Just(SpreadChoice::Drawn), given];
    let duty = prop_oneof![
        Just(DutyChoice::Drawn),
        prop_oneof![Just(0.5), 0.18..0.82f64].prop_map(DutyChoice::Given)
    ];
    let share = || prop_oneof![Just(0.0), 0.0..0.6f64];
    let seeding = prop::sample::select(vec![Seeding::Noise, Seeding::Segments, Seeding::Initiators]);
    let keep = prop::option::of(any::<bool>());
    let ragged = prop_oneof![Just(RaggedChoice::Drawn), (0.0..0.5f64).prop_map(RaggedChoice::Given)];
    let detail = prop_oneof![Just(24.0), 7.0..200.0f64];
    let gap = prop_oneof![Just(GapChoice::Drawn), (1.0..50.0f64).prop_map(GapChoice::Given)];
    let decay = prop_oneof![Just(0.8), 0.0..0.85f64];
    let over = prop::sample::select(vec![Over::Level, Over::Twill21]);
    let rosette = prop::option::of((0.0..1.0f64).prop_map(|solid| Rosettes { solid, ..Rosettes::default() }));
    let near = prop_oneof![Just(24.0), 2.0..200.0f64];
    let shapes = (share(), share(), rosette, decay, over, near);
    (spread, duty, share(), share(), keep, seeding, ragged, detail, gap, shapes).prop_map(
        |(spread, duty, broken, irregular, keep, seeding, ragged, detail, gap, shapes)| {
            let (vary, double, rosette, decay, over, near) = shapes;
            LayerOptions {
                spread,
                duty,
                broken,
                near,
                irregular,
                keep,
                seeding,
                vary,
                double,
                ragged,
                detail,
                gap,
                rosette,
                decay,
                over,
            }
        },
    )
}

fn stroke(kind: Kind) -> Stroke {
    use crate::marks;
    match kind {
        Ellipse => Stroke::Ellipse(marks::Ellipse { center: [100.0, 100.0], radii: [10.0, 8.0], angle: 0.0 }),
        Line => Stroke::Line(marks::Line { from: [50.0, 50.0], to: [150.0, 50.0], width: 6.0 }),
    }
}

proptest! {
    #[test]
    fn a_tidied_layer_breaks_no_rule_and_is_read_as_it_was_written(
        options in any_options(),
        maps in any_maps(),
        system in prop::sample::select(SystemChoice::names()),
        after in prop::sample::select(After::NAMES.to_vec()),
        ellipse: bool,
    ) {
        let kind = if ellipse { Ellipse } else { Line };
        let (system, after) = (system.1, after.1);
        // Marks of the other kind are refused, and tidying leaves `after` and the marks alone.
        prop_assume!(after.grows().is_none_or(|grown| grown == kind));
        let mut layer = Layer { system, after, options, maps, strokes: vec![stroke(kind)], ..Layer::default() };
        tidy(&mut layer, Some(kind));
        let once = layer.clone();
        tidy(&mut layer, Some(kind));
        prop_assert_eq!(&layer, &once);
        // Tidying does not know the layer beneath, so it does not change a system that only the lowest layer may have.
        let lowest = layer.system.is_known(|system| system.lowest_alone.is_some());
        // Nor does it change `after`: nothing is beneath such a layer that it could be near.
        prop_assume!(!lowest || after != After::Near);
        let below = if lowest { Beneath::Nothing } else { Beneath::Grows(Ellipse) };
        let combination = Combination::new(&layer, Some(kind), below);
        prop_assert!(combination.broken_rule().is_none(), "{:?}", combination.broken_rule());
        let beneath = Layer { strokes: vec![stroke(Ellipse)], ..Layer::default() };
        let named = |name: &str, layer: Layer| Layer { name: name.to_owned(), ..layer };
        let document = Document { layers: vec![named("a", beneath), named("b", layer)], ..Document::default() };
        let again = Document::parse(&document.to_json(), "itself");
        prop_assert_eq!(again.map_err(|error| error.to_string()), Ok(document));
    }
}
