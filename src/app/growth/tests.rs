//! Tests of growths and paintings on other threads.

use std::sync::mpsc::channel;

use super::*;
use crate::document::{Colours, Layer, Stroke};
use crate::editor::task::Spawn;
use crate::marks::Ellipse;

fn spot() -> Document {
    let ellipse = Ellipse { center: [30.0, 30.0], radii: [8.0, 6.0], angle: 30.0 };
    let layer = Layer { strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
    Document { size: [64, 64], layers: vec![layer], ..Document::default() }
}

#[test]
fn a_growth_thread_that_does_not_start_is_reported() {
    let tasks = Tasks::default().with_spawn(Spawn(|_, _| Err(std::io::Error::other("none left"))));
    let mut growth = Growth::new(tasks);
    growth.grow(&spot());
    let GrowthState::Failed(why) = &growth.state else { panic!("{:?}", growth.state) };
    assert!(why.contains("growth") && why.contains("none left"), "{why}");
    assert!(!growth.listen());
}

#[test]
fn the_latest_document_wins_and_colours_and_fineness_are_changed_without_growing() {
    let (wake, woken) = channel();
    let mut growth = Growth::new(Tasks::new(move || {
        let _ = wake.send(());
    }));
    growth.grow(&Document { seed: 7, ..spot() });
    growth.grow(&spot());
    let wait = |growth: &mut Growth, until: &dyn Fn(&Growth) -> bool| {
        growth.listen();
        while !until(growth) {
            let spoken = woken.recv_timeout(Duration::from_secs(60));
            assert!(spoken.is_ok(), "{:?}", growth.state);
            growth.listen();
        }
    };
    wait(&mut growth, &|growth| matches!(growth.state, GrowthState::Settled(_)));
    assert_eq!(growth.texture.as_ref().unwrap().grown.document, spot());
    let (generation, before) = (growth.generation(), growth.picture.clone().unwrap().image);
    let mut other = spot();
    other.layers[0].colours = Some(Colours::default_for_layer(1));
    growth.grow(&other);
    wait(&mut growth, &|growth| growth.painting.is_none());
    assert_eq!(growth.generation(), generation);
    assert_ne!(growth.picture.as_ref().unwrap().image.pixels, before.pixels);
    assert_eq!(before.size, [64, 64]);
    for fineness in [2, 4, 1] {
        growth.set_fineness(fineness);
        wait(&mut growth, &|growth| growth.painting.is_none());
        assert_eq!(growth.picture.as_ref().unwrap().image.size, [fineness * 64; 2]);
    }
    growth.set_fineness(3);
    growth.again(&spot());
    wait(&mut growth, &|growth| matches!(growth.state, GrowthState::Settled(_)));
    assert_eq!(
        growth.picture.unwrap().image.size,
        [192; 2],
        "the first settled picture is that fine already"
    );
}

#[test]
fn other_computations_wait_while_a_growth_may_settle_soon() {
    let mut growth = Growth::new(Tasks::default());
    assert!(!growth.may_settle_soon());
    growth.state = GrowthState::Growing(Stage::Plan, 0.0);
    assert!(growth.may_settle_soon(), "before the first picture");
    growth.first_picture = Some(Duration::ZERO);
    growth.since = Instant::now() + Duration::from_secs(60);
    assert!(growth.may_settle_soon() && growth.until_next_frame(0.0) == AFTER_FIRST);
    growth.paused = true;
    assert!(!growth.may_settle_soon());
    growth.paused = false;
    growth.since = Instant::now().checked_sub(2 * AFTER_FIRST).expect("a machine that runs for a second");
    assert!(!growth.may_settle_soon() && growth.until_next_frame(0.0).is_zero());
}
