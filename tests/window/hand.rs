//! A window with a simulated user.

#[path = "aim.rs"]
pub mod aim;

use std::cell::Cell;
use std::f64::consts::TAU;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use dapple::WriteFile;
use dapple::app::{GrowthState, Start, Window};
use dapple::document::{Document, Stroke};
use dapple::document::{Ellipse, Line};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Pos2, Rect, Theme, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{Harness, LazyRenderer};
use test_pictures::window::Painter;

/// A new window with the default size.
pub struct Hand {
    pub window: Harness<'static, Window>,
    /// Gets a message each time the window asks for a frame.
    asked: Receiver<()>,
}

thread_local! {
    /// Whether the windows of this test grow small pictures of what layers can become. That takes long, and few tests look at them.
    static GOALS: Cell<bool> = const { Cell::new(false) };
}

/// From now on the windows of this test grow small pictures of what layers can become, as a new user's do.
pub fn with_goals() {
    GOALS.set(true);
}

/// A window of 1280 × 800 points.
pub fn hand() -> Hand {
    with(Start::default(), vec2(1280.0, 800.0), Theme::Light)
}

/// A window with a document.
pub fn hand_with(document: &Document) -> (Hand, tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    document.write(&path).unwrap();
    let start = Start { file: Some(path.clone()), ..Start::default() };
    (with(start, vec2(1280.0, 800.0), Theme::Light), folder, path)
}

/// A window that starts with these settings, with this size and theme.
pub fn with(start: Start, size: Vec2, theme: Theme) -> Hand {
    let mut hand = opened(start, size, theme);
    hand.rest();
    hand
}

/// A window after its first frame; files may still be being read.
pub fn opened(mut start: Start, size: Vec2, theme: Theme) -> Hand {
    start.settings.theme = theme.into();
    start.settings.layout.goals &= GOALS.get();
    let (ask, asked) = channel();
    let window = Harness::builder()
        .with_size(size)
        .with_theme(theme)
        .with_step_dt(1.0 / 60.0)
        .renderer(LazyRenderer::new(Painter::default))
        .build_eframe(|cc| {
            // The receiver no longer exists when the test has ended.
            cc.egui_ctx.set_request_repaint_callback(move |_| {
                let _ = ask.send(());
            });
            Window::new(&cc.egui_ctx, start)
        });
    Hand { window, asked }
}

/// Replaces a file by a pipe: whoever reads it blocks until it is written to.
#[cfg(unix)]
pub fn pipe(file: &std::path::Path) {
    let made = std::process::Command::new("mkfifo").arg(file).status().unwrap();
    assert!(made.success());
}

impl Hand {
    /// Waits until a task of the window asks for a frame, but for less than the duration of a frame.
    pub fn wait_for_tasks(&self) {
        // Removes the requests that the last frame made itself.
        while self.asked.try_recv().is_ok() {}
        let _ = self.asked.recv_timeout(Duration::from_millis(4));
    }

    /// Runs a few frames, waits for files and for the sketch to be read, and runs a few more frames.
    #[track_caller]
    pub fn rest(&mut self) {
        let began = Instant::now();
        let mut left = 4;
        while left > 0 {
            self.window.step();
            left -= 1;
            let window = self.window.state();
            if window.is_busy_with_files() || window.is_busy_with_sketch() {
                assert!(began.elapsed() < Duration::from_secs(60), "a file or the sketch is read for ever");
                self.wait_for_tasks();
                left = 4;
            }
        }
    }

    /// The document.
    pub fn document(&self) -> Document {
        self.window.state().document()
    }

    /// All strokes of all layers.
    pub fn strokes(&self) -> Vec<Stroke> {
        self.document().layers.into_iter().flat_map(|layer| layer.strokes).collect()
    }

    /// The ellipses that are drawn.
    pub fn ellipses(&self) -> Vec<Ellipse> {
        self.strokes().iter().filter_map(|stroke| stroke.mark()?.ellipse()).collect()
    }

    /// The lines that are drawn.
    pub fn lines(&self) -> Vec<Line> {
        let line = |stroke| if let Stroke::Line(line) = stroke { Some(line) } else { None };
        self.strokes().into_iter().filter_map(line).collect()
    }

    /// The rectangle of the canvas.
    pub fn canvas(&self) -> Rect {
        self.window.get_by_role(Role::Canvas).rect()
    }

    /// The position of a px of the canvas on the screen, where the canvas is fitted as in [`dapple::app`].
    pub fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.window.state().screen(self.canvas(), [x, y])
    }

    /// Drags from px to px of the canvas.
    pub fn drag(&mut self, path: &[[f64; 2]]) {
        self.drag_with(path, Modifiers::NONE);
    }

    /// Drags from px to px of the canvas with a key held.
    pub fn drag_with(&mut self, path: &[[f64; 2]], modifiers: Modifiers) {
        let path: Vec<Pos2> = path.iter().map(|point| self.at(*point)).collect();
        self.window.event(egui::Event::ModifiersChanged(modifiers));
        self.window.hover_at(path[0]);
        self.window.step();
        self.button(path[0], true, modifiers);
        for point in &path {
            self.window.hover_at(*point);
            self.window.step();
        }
        self.button(path[path.len() - 1], false, modifiers);
        self.window.event(egui::Event::ModifiersChanged(Modifiers::NONE));
        self.rest();
    }

    fn button(&mut self, pos: Pos2, pressed: bool, modifiers: Modifiers) {
        let button = egui::PointerButton::Primary;
        self.window.event(egui::Event::PointerButton { pos, button, pressed, modifiers });
        self.window.step();
    }

    /// Clicks on a px of the canvas.
    pub fn click(&mut self, point: [f64; 2]) {
        self.drag(&[point, point]);
    }

    /// Draws an ellipse as a freehand stroke: once around, with about 60 points.
    pub fn draw_round(&mut self, center: [f64; 2], radii: [f64; 2], degrees: f64) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let path: Vec<[f64; 2]> = (0..=60)
            .map(|i| {
                let (y, x) = (TAU * f64::from(i) / 60.0).sin_cos();
                let [x, y] = [radii[0] * x, radii[1] * y];
                [center[0] + cos * x - sin * y, center[1] + sin * x + cos * y]
            })
            .collect();
        self.drag(&path);
    }

    /// Presses a button by its name.
    pub fn press(&mut self, name: &str) {
        const PRESSED: [Role; 4] = [Role::Button, Role::CheckBox, Role::SpinButton, Role::RadioButton];
        self.click_on(name, |window| {
            let of_role = |role| window.query_by_role_and_label(role, name);
            PRESSED.into_iter().find_map(of_role).map(|node| node.rect())
        });
        self.rest();
    }

    /// Clicks on what has this role and this name.
    #[track_caller]
    pub fn click_role(&mut self, role: Role, name: &str) {
        self.click_on(name, |window| window.query_by_role_and_label(role, name).map(|node| node.rect()));
    }

    /// Clicks at a position on the screen.
    pub fn click_field(&mut self, at: Pos2) {
        for pressed in [true, false] {
            self.window.hover_at(at);
            self.button(at, pressed, Modifiers::NONE);
        }
    }

    /// Clicks on the control whose name contains these words.
    #[track_caller]
    pub fn click_label(&mut self, words: &str) {
        self.click_on(words, |window| window.query_by_label_contains(words).map(|node| node.rect()));
    }

    #[track_caller]
    fn click_on(&mut self, name: &str, find: impl Fn(&Harness<'static, Window>) -> Option<Rect>) {
        aim::click_on(&mut self.window, name, find);
    }

    /// Scrolls the column to a button if necessary, and presses it.
    #[track_caller]
    pub fn reach(&mut self, name: &str) {
        self.window.get_by_label(name).scroll_to_me();
        self.window.run_steps(60);
        self.press(name);
    }

    /// Types a number into the field with this name.
    pub fn type_into(&mut self, name: &str, text: &str) {
        let role = if name == "File" { Role::TextInput } else { Role::SpinButton };
        self.click_role(role, name);
        self.rest();
        self.key(Modifiers::COMMAND, Key::A);
        self.window.event(egui::Event::Text(text.to_owned()));
        self.window.step();
        self.key(Modifiers::NONE, Key::Enter);
    }

    /// Types a path into the file dialog, and confirms it.
    pub fn type_path(&mut self, name: &str, path: &std::path::Path) {
        self.type_path_only(name, path);
        self.key(Modifiers::NONE, Key::Enter);
    }

    /// Types a path into the file dialog, for a file that is opened or saved slowly. Afterwards the dialog is closed,
    /// and the file is not yet read or written.
    pub fn type_slow_path(&mut self, name: &str, path: &std::path::Path) {
        self.type_path_only(name, path);
        self.window.key_press_modifiers(Modifiers::NONE, Key::Enter);
        let began = Instant::now();
        while self.window.query_by_role_and_label(Role::TextInput, name).is_some() {
            assert!(began.elapsed() < Duration::from_secs(60), "the dialog stays open");
            self.wait_for_tasks();
            self.window.step();
        }
        self.window.run_steps(4);
    }

    /// Types a path into the file dialog.
    pub fn type_path_only(&mut self, name: &str, path: &std::path::Path) {
        self.click_role(Role::TextInput, name);
        self.rest();
        self.key(Modifiers::COMMAND, Key::A);
        self.window.event(egui::Event::Text(path.to_str().unwrap().to_owned()));
        self.window.step();
    }

    /// Presses keys.
    pub fn key(&mut self, modifiers: Modifiers, key: Key) {
        self.window.key_press_modifiers(modifiers, key);
        self.rest();
    }

    /// Waits in real time until `is` is true.
    #[track_caller]
    pub fn until(&mut self, what: &str, mut is: impl FnMut(&Window) -> bool) {
        let began = Instant::now();
        loop {
            self.window.step();
            if is(self.window.state()) {
                return;
            }
            assert!(
                began.elapsed() < Duration::from_secs(300),
                "waited for ever: {what}: {:?}",
                self.growth_state()
            );
            self.wait_for_tasks();
        }
    }

    /// The state of the growth.
    pub fn growth_state(&self) -> &GrowthState {
        self.window.state().growth_state()
    }

    /// Waits until the texture has settled.
    #[track_caller]
    pub fn until_settled(&mut self) {
        // The sizes and directions between marks are computed afterwards.
        let is_settled = |window: &Window| matches!(window.growth_state(), GrowthState::Settled(_));
        self.until("settled", |window| is_settled(window) && !window.is_busy_with_sketch());
    }
}
