use super::*;
use crate::document::Edges;
use crate::editor::edit::Edit;
use crate::marks::Ellipse;

fn spots() -> Vec<Stroke> {
    let at = [[40.0, 40.0], [90.0, 50.0], [60.0, 100.0]];
    at.map(|center| Stroke::Ellipse(Ellipse { center, radii: [12.0, 8.0], angle: 20.0 })).to_vec()
}

fn line(from: [f64; 2], to: [f64; 2]) -> Stroke {
    Stroke::Line(Line { from, to, width: 6.0 })
}

fn parallel() -> Vec<Stroke> {
    [40.0, 60.0, 80.0].map(|y| line([20.0, y], [120.0, y + 4.0])).to_vec()
}

/// A session whose topmost layer is active.
fn session(layers: Vec<Vec<Stroke>>) -> Session {
    let layers = layers.into_iter().map(|strokes| Layer { strokes, ..Layer::default() }).collect();
    Session::open(Document { size: [160, 160], layers, ..Document::default() }, None)
}

fn offer(session: &Session, goal: Goal) -> Option<Offer> {
    Goal::offers(session, None).into_iter().find(|offer| offer.goal == goal)
}

fn words(session: &Session, goal: Goal) -> &'static str {
    offer(session, goal).unwrap().outcome.unwrap_err()[0]
}

#[test]
fn every_document_that_is_offered_keeps_the_rules() {
    let crossing = [parallel(), vec![line([50.0, 20.0], [60.0, 130.0])]].concat();
    for layers in
        [vec![spots()], vec![parallel()], vec![crossing], vec![spots(), parallel()], vec![spots(), spots()]]
    {
        for edges in [Edges::Closed, Edges::Wrap] {
            let mut session = session(layers.clone());
            session.edit(|document| document.edges = edges);
            let offers = Goal::offers(&session, None);
            assert!(offers.iter().filter(|offer| offer.outcome.is_ok()).count() >= 6, "{offers:?}");
            for Offer { goal, outcome } in offers {
                if let Ok(document) = outcome {
                    document.check(goal.name()).unwrap();
                }
            }
        }
    }
}

#[test]
fn what_is_missing_is_said() {
    let stripes = session(vec![parallel()]);
    assert_eq!(words(&stripes, Goal::Rings), "needs spots on a layer beneath");
    assert_eq!(words(&stripes, Goal::Net), "needs spots on a layer beneath");
    assert_eq!(words(&stripes, Goal::Weave), "needs lines that cross");
    assert_eq!(words(&stripes, Goal::Maze), "needs lines in two directions");
    assert_eq!(words(&session(vec![spots()]), Goal::Inside), "needs spots on a layer beneath");
    let above = session(vec![spots(), parallel()]);
    assert!(offer(&above, Goal::Rings).unwrap().outcome.is_ok());
    assert_eq!(words(&above, Goal::Tone), "only on the lowest layer");
    let above_stripes = session(vec![parallel(), parallel()]);
    assert!(offer(&above_stripes, Goal::Rings).unwrap().outcome.is_ok(), "they go round stripes, too");
}

#[test]
fn marks_are_offered_what_they_can_be_alone() {
    assert!(offer(&session(vec![spots()]), Goal::Stripes).is_none());
    assert!(offer(&session(vec![parallel()]), Goal::Cells).is_none());
    assert!(Goal::offers(&session(vec![Vec::new()]), None).is_empty());
}

#[test]
fn a_goal_is_taken_and_undone_in_one_step() {
    let mut session = session(vec![spots()]);
    let before = session.document().clone();
    for goal in [Goal::Cells, Goal::Patches, Goal::DotsAndWorms, Goal::Rings, Goal::Blotches] {
        let offered = offer(&session, goal).unwrap().outcome.unwrap();
        session.change(Edit::LayerGoal(0, goal));
        session.commit();
        let far = |document: &Document| {
            let mut document = document.clone();
            // A session names new layers.
            document
                .layers
                .iter_mut()
                .for_each(|layer| (layer.far_spacing, layer.name) = (None, String::new()));
            document
        };
        assert_eq!(far(&session.finished()), far(&offered), "{goal:?}");
        session.undo();
        assert_eq!(*session.document(), before);
    }
}

#[test]
fn rings_around_spots_are_a_layer_of_their_own_that_is_active_then() {
    let mut session = session(vec![spots()]);
    session.change(Edit::LayerGoal(0, Goal::Rings));
    let layers = &session.document().layers;
    assert_eq!((layers.len(), layers[1].after, session.active_layer), (2, After::Around, 1));
    // Now the spots are beneath them, and the net is the same lines.
    session.change(Edit::LayerGoal(1, Goal::Net));
    assert_eq!((session.document().layers.len(), session.document().layers[1].after), (2, After::Net));
}

#[test]
fn what_a_layer_is_now_stays_as_it_is() {
    let session = session(vec![spots()]);
    let offers = Goal::offers(&session, Some(Goal::Spots));
    assert_eq!(offers[0], Offer { goal: Goal::Spots, outcome: Ok(session.finished()) });
}

#[test]
fn each_goal_is_told_from_the_layer_and_its_system() {
    for layers in [vec![spots()], vec![parallel()], vec![spots(), parallel()]] {
        let session = session(layers);
        for Offer { goal, outcome } in Goal::offers(&session, None) {
            let Ok(document) = outcome else { continue };
            let index = document.layers.len() - 1;
            let layer = &document.layers[index];
            if let Some(system) = layer.system.description() {
                assert_eq!(Goal::of_layer(layer, system), Some(goal));
            }
        }
    }
}

#[test]
fn rings_around_cells_make_them_spots() {
    let mut session = session(vec![spots()]);
    session.change(Edit::LayerGoal(0, Goal::Cells));
    session.change(Edit::LayerGoal(0, Goal::Rings));
    assert_eq!(session.document().layers[0].system, Goal::Spots.choice());
    assert_eq!((session.document().layers[1].after, session.active_layer), (After::Around, 1));
    session.finished().check("rings").unwrap();
}
