//! The simulated user can press controls that move.

use egui::Vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use crate::hand::aim::click_on;

/// A column of buttons, the frames that were shown, and how often each button was pressed.
#[derive(Default)]
struct Column {
    frames: usize,
    pressed: [usize; 2],
}

/// A window with two buttons, above which a line appears this number of frames after the first ones.
fn column(appears: usize) -> Harness<'static, Column> {
    let show = move |ui: &mut egui::Ui, column: &mut Column| {
        column.frames += 1;
        if column.frames > appears {
            ui.allocate_space(Vec2::new(100.0, 60.0));
        }
        for (index, name) in ["Above", "Below"].into_iter().enumerate() {
            column.pressed[index] += usize::from(ui.button(name).clicked());
        }
    };
    let mut window = Harness::builder().build_ui_state(show, Column::default());
    // Independent of the number of frames that were shown so far.
    window.state_mut().frames = 0;
    window
}

#[test]
fn a_button_that_moves_before_it_is_pressed_or_released_is_pressed_once() {
    for appears in 0..6 {
        let mut window = column(appears);
        click_on(&mut window, "Below", |window| window.query_by_label("Below").map(|node| node.rect()));
        window.step();
        assert_eq!(window.state().pressed, [0, 1], "a line appears in frame {appears}");
    }
}
