//! Undo and redo of every action.

use dapple::app::Session;
use dapple::app::{Place, Selection};
use dapple::document::{After, Document, DutyChoice, Stroke};
use dapple_engine::marks::{Ellipse, Line, Mark, Path};
use egui::{Key, Modifiers};
use proptest::prelude::*;

use crate::hand::hand;

#[derive(Clone, Debug)]
enum Deed {
    Add(Mark),
    Remove(usize),
    Nudge([f64; 2]),
    Replace(usize, Mark),
    Regions(Option<[u32; 2]>),
    Select(usize),
    Seed(u64),
    AddLayer,
    DuplicateLayer,
    DeleteLayer(usize),
    MoveLayer(usize, usize),
    SelectLayer(usize),
    UnfreezeLayer(usize),
    SketchNext,
    Hide(usize),
    Meet(usize, After, f64),
    Duty(usize, f64),
    Undo,
    Redo,
}

fn mark() -> impl Strategy<Value = Mark> {
    let place = || (0.0..512.0f64, 0.0..512.0f64);
    prop_oneof![
        (place(), 2.0..40.0f64, 2.0..40.0f64, 0.0..180.0f64).prop_map(|((x, y), a, b, angle)| {
            Mark::Ellipse(Ellipse { center: [x, y], radii: [a, b], angle })
        }),
        (place(), place(), 1.0..20.0f64)
            .prop_map(|((x, y), (u, v), width)| { Mark::Line(Line { from: [x, y], to: [u, v], width }) }),
        (prop::collection::vec([-100.0..700.0f64, -100.0..700.0f64], 2..9), 1.0..20.0f64)
            .prop_map(|(points, width)| Mark::Path(Path { points, width })),
    ]
}

fn deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        4 => mark().prop_map(Deed::Add),
        1 => any::<usize>().prop_map(Deed::Remove),
        1 => [-90.0..90.0f64, -90.0..90.0f64].prop_map(Deed::Nudge),
        // To the edge of the canvas.
        1 => [-900.0..900.0f64, -900.0..900.0f64].prop_map(Deed::Nudge),
        1 => (any::<usize>(), mark()).prop_map(|(i, mark)| Deed::Replace(i, mark)),
        1 => prop::option::of([1..5u32, 1..5u32]).prop_map(Deed::Regions),
        1 => any::<usize>().prop_map(Deed::Select),
        1 => any::<u64>().prop_map(Deed::Seed),
        2 => layer_deed(),
        2 => Just(Deed::Undo),
        1 => Just(Deed::Redo),
    ]
}

fn layer_deed() -> impl Strategy<Value = Deed> {
    let layer = || 0..6usize;
    let after = prop::sample::select(After::NAMES.to_vec());
    prop_oneof![
        Just(Deed::AddLayer),
        Just(Deed::DuplicateLayer),
        Just(Deed::SketchNext),
        layer().prop_map(Deed::DeleteLayer),
        (layer(), layer()).prop_map(|(from, to)| Deed::MoveLayer(from, to)),
        layer().prop_map(Deed::SelectLayer),
        layer().prop_map(Deed::UnfreezeLayer),
        layer().prop_map(Deed::Hide),
        (layer(), after, 0.0..0.6f64).prop_map(|(layer, after, broken)| Deed::Meet(layer, after.1, broken)),
        (layer(), 0.18..0.82f64).prop_map(|(layer, duty)| Deed::Duty(layer, duty)),
    ]
}

fn some(session: &Session, index: usize) -> Option<Place> {
    let places: Vec<Place> = session.marks().map(|(place, _)| place).collect();
    (!places.is_empty()).then(|| places[index % places.len()])
}

fn act(session: &mut Session, deed: &Deed) {
    match deed {
        Deed::Add(mark) => session.add(std::slice::from_ref(mark)),
        Deed::Remove(index) => session.remove(&some(session, *index).into_iter().collect::<Vec<_>>()),
        Deed::Nudge(by) => session.nudge(*by),
        Deed::Replace(index, mark) => {
            // A mark is only replaced by one of the same kind: a user cannot turn an ellipse into a line.
            if let Some(place) = some(session, *index)
                && std::mem::discriminant(&session.mark(place).unwrap()) == std::mem::discriminant(mark)
            {
                session.replace(&[(place, mark.clone())]);
            }
        }
        Deed::Regions(regions) => session.edit(|document| document.regions = *regions),
        Deed::Select(index) => session.selection = Selection::new(some(session, *index)),
        Deed::Seed(seed) => session.edit(|document| document.seed = *seed),
        Deed::AddLayer => session.add_layer(),
        Deed::DuplicateLayer => session.duplicate_layer(),
        Deed::DeleteLayer(layer) => session.delete_layer(*layer),
        Deed::MoveLayer(from, to) => session.move_layer(*from, *to),
        Deed::SelectLayer(layer) => session.select_layer(*layer),
        Deed::UnfreezeLayer(layer) => session.unfreeze_layer(*layer),
        Deed::SketchNext => session.sketch_next(),
        Deed::Hide(layer) => session.show_layer(*layer, false),
        Deed::Meet(layer, after, broken) => session.change_layer(*layer, |layer| {
            (layer.after, layer.options.broken) = (*after, *broken);
        }),
        Deed::Duty(layer, duty) => {
            session.change_layer(*layer, |layer| layer.options.duty = DutyChoice::Given(*duty));
        }
        Deed::Undo => session.undo(),
        Deed::Redo => session.redo(),
    }
    session.commit();
    let layers = session.document().layers.len();
    assert!(session.frozen() < layers.max(1), "{} of {layers} frozen", session.frozen());
    assert!(session.active_layer < layers.max(1));
}

proptest! {
    #![proptest_config(crate::cases(200))]

    #[test]
    fn every_change_can_be_undone_and_redone(deeds in prop::collection::vec(deed(), 1..40)) {
        let mut session = Session::open(Document::default(), None);
        for deed in &deeds {
            act(&mut session, deed);
        }
        let last = session.document().clone();
        let mut steps = 0;
        while session.can_undo_redo()[0] {
            session.undo();
            steps += 1;
            prop_assert!(steps <= deeds.len());
        }
        prop_assert_eq!(session.document(), &Document::default());
        for _ in 0..steps {
            session.redo();
        }
        while session.can_undo_redo()[1] {
            session.redo();
        }
        // Steps that were undone at the end are redone after it.
        if !deeds.iter().any(|deed| matches!(deed, Deed::Undo)) {
            prop_assert_eq!(session.document(), &last);
        }
    }

    #[test]
    fn every_drawn_sketch_can_be_saved_and_read_again(deeds in prop::collection::vec(deed(), 1..40)) {
        let mut session = Session::open(Document::default(), None);
        for deed in &deeds {
            act(&mut session, deed);
            let document = session.finished();
            if !document.layers.is_empty() {
                let again = Document::parse(&document.to_json(), "itself").unwrap();
                prop_assert_eq!(again, document);
            }
        }
    }

    #[test]
    fn undo_and_redo_of_one_step_change_nothing(deeds in prop::collection::vec(deed(), 1..30)) {
        let mut session = Session::open(Document::default(), None);
        for deed in &deeds {
            act(&mut session, deed);
            if matches!(deed, Deed::Undo | Deed::Redo) || !session.can_undo_redo()[0] {
                continue;
            }
            let now = session.document().clone();
            session.undo();
            session.redo();
            prop_assert_eq!(session.document(), &now);
        }
    }
}

/// An action of a user in the window.
#[derive(Clone, Debug)]
enum Move {
    Drag([f64; 2], [f64; 2]),
    Key(Modifiers, Key),
}

fn moves() -> impl Strategy<Value = Move> {
    let place = || [0.0..512.0f64, 0.0..512.0f64];
    let keys = prop::sample::select(vec![
        (Modifiers::NONE, Key::V),
        (Modifiers::NONE, Key::B),
        (Modifiers::NONE, Key::E),
        (Modifiers::NONE, Key::L),
        (Modifiers::NONE, Key::X),
        (Modifiers::NONE, Key::N),
        (Modifiers::NONE, Key::F),
        (Modifiers::NONE, Key::PageDown),
        (Modifiers::SHIFT, Key::H),
        (Modifiers::COMMAND | Modifiers::SHIFT, Key::N),
        (Modifiers::COMMAND, Key::J),
        (Modifiers::COMMAND, Key::PageDown),
        (Modifiers::NONE, Key::Delete),
        (Modifiers::NONE, Key::Period),
        (Modifiers::NONE, Key::Plus),
        (Modifiers::SHIFT, Key::E),
        (Modifiers::SHIFT, Key::ArrowLeft),
        (Modifiers::COMMAND, Key::A),
        (Modifiers::COMMAND, Key::D),
        (Modifiers::COMMAND, Key::Z),
    ]);
    prop_oneof![
        3 => (place(), place()).prop_map(|(from, to)| Move::Drag(from, to)),
        2 => keys.prop_map(|(modifiers, key)| Move::Key(modifiers, key)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { max_shrink_iters: 40, ..crate::cases(6) })]

    #[test]
    fn any_sequence_of_actions_is_undone_step_by_step(moves in prop::collection::vec(moves(), 1..25)) {
        let mut hand = hand();
        let empty = hand.window.state().session().document().clone();
        for act in &moves {
            match act {
                Move::Drag(from, to) => {
                    let middle = [0, 1].map(|axis| 0.5 * (from[axis] + to[axis]));
                    hand.drag(&[*from, middle, *to]);
                }
                Move::Key(modifiers, key) => hand.key(*modifiers, *key),
            }
            let document = hand.document();
            if !document.layers.is_empty() {
                document.check("what was drawn").unwrap();
            }
        }
        for _ in 0..200 {
            if !hand.window.state().session().can_undo_redo()[0] {
                break;
            }
            hand.key(Modifiers::COMMAND, Key::Z);
        }
        prop_assert_eq!(hand.window.state().session().document(), &empty);
    }
}

#[test]
fn a_thin_ellipse_stays_as_it_was_drawn_and_is_undone_in_one_step() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[100.0, 100.0], [200.0, 101.5], [300.0, 103.0]]);
    let Stroke::Ellipse(ellipse) = hand.document().layers[0].strokes[0] else { panic!("an ellipse") };
    assert!(ellipse.aspect() < 0.02, "{ellipse:?}");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!(hand.document().layers.is_empty());
}
