//! Splits a layer into two, where its spots have two sizes or its lines cross.

use crate::document::sketch_notes::{crossing_strokes, size_groups};
use crate::document::{After, Colours, limits};
use crate::editor::session::Session;

impl Session {
    /// Whether the spots of a layer have two clearly different sizes.
    #[must_use]
    pub fn has_two_sizes(&self, layer: usize) -> bool {
        self.fitted_marks().get(layer).is_some_and(|marks| size_groups(marks).is_some())
    }

    /// Moves the small spots of a layer that has two sizes to a new layer above it, which has the same settings and
    /// keeps away from the large spots. Unfreezes the layer and makes it active. Does nothing where it has one size.
    pub fn split_by_size(&mut self, layer: usize) {
        let groups = self.fitted_marks().get(layer).and_then(|marks| size_groups(marks));
        if let Some([small, _]) = groups {
            self.split(layer, &small, ["large", "small"]);
        }
    }

    /// The strokes of a layer that cross earlier ones. Without these strokes, no two lines cross.
    #[must_use]
    pub fn crossing_strokes(&self, layer: usize) -> Vec<usize> {
        self.fitted_marks().get(layer).map(|marks| crossing_strokes(marks)).unwrap_or_default()
    }

    /// Moves the lines of a layer that cross earlier ones to a new layer above it, which has the same settings. Unfreezes the
    /// layer and makes it active. Does nothing where none cross.
    pub fn split_crossings(&mut self, layer: usize) {
        let crossing = self.crossing_strokes(layer);
        if !crossing.is_empty() {
            self.split(layer, &crossing, ["", "crossing"]);
        }
    }

    /// Moves strokes of a layer to a new one above it. `words`: the words before the names of the two layers.
    fn split(&mut self, layer: usize, moved: &[usize], words: [&str; 2]) {
        if self.document().layers.len() >= limits::MAX_LAYERS {
            return;
        }
        self.unfreeze_layer(layer);
        self.selection.clear();
        self.edit(|document| {
            let below = &mut document.layers[layer];
            let mut above = below.clone();
            let mut index = 0..;
            let mut is_moved = || index.next().is_some_and(|index| moved.contains(&index));
            (above.strokes, below.strokes) = below.strokes.drain(..).partition(|_| is_moved());
            above.after = After::Between;
            // The default colours depend on the index.
            above.colours.get_or_insert_with(|| Colours::default_for_layer(layer));
            if !below.name.is_empty() {
                let named = |word: &str| {
                    format!("{word} {}", below.name).trim().chars().take(limits::MAX_NAME).collect()
                };
                (below.name, above.name) = (named(words[0]), named(words[1]));
            }
            document.layers.insert(layer + 1, above);
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Layer, Stroke};

    fn radius(stroke: &Stroke) -> f64 {
        if let Stroke::Ellipse(ellipse) = stroke { ellipse.radii[0] } else { 0.0 }
    }

    #[test]
    fn the_small_spots_go_to_a_layer_above_with_the_same_settings_and_one_undo_brings_them_back() {
        let spot = |k: u32| {
            let center = [40.0 + 60.0 * f64::from(k % 4), 40.0 + 60.0 * f64::from(k / 4)];
            Stroke::ellipse(center, [if k % 5 == 2 { 20.0 } else { 6.0 }; 2], 0.0)
        };
        let mut drawn = Layer::new((0..12).map(spot));
        drawn.name = "dots".to_owned();
        drawn.options.irregular = 0.4;
        let before = Document { layers: vec![drawn.clone(), Layer::default()], ..Document::default() };
        let mut session = Session::open(before.clone(), None);
        assert!(session.has_two_sizes(0) && !session.has_two_sizes(1) && !session.has_two_sizes(9));
        session.split_by_size(0);
        session.commit();
        let [large, small, _] = &session.document().layers[..] else { panic!() };
        assert_eq!((large.name.as_str(), small.name.as_str()), ("large dots", "small dots"));
        assert_eq!([large, small].map(|layer| layer.strokes.len()), [2, 10]);
        assert!(large.strokes.iter().all(|stroke| radius(stroke) == 20.0));
        assert!(small.strokes.iter().all(|stroke| radius(stroke) == 6.0));
        assert_eq!((&large.options, &small.options), (&drawn.options, &drawn.options));
        assert_eq!((&large.colours, &small.colours), (&None, &Some(Colours::default_for_layer(0))));
        session.undo();
        assert_eq!(session.document(), &before);
    }

    #[test]
    fn a_layer_of_one_size_is_not_split() {
        let spots = (0..9).map(|k| Stroke::ellipse([20.0 + 30.0 * f64::from(k), 50.0], [8.0, 8.0], 0.0));
        let before = Document { layers: vec![Layer::new(spots)], ..Document::default() };
        let mut session = Session::open(before.clone(), None);
        session.split_by_size(0);
        assert_eq!(session.document(), &before);
    }

    #[test]
    fn crossing_lines_go_to_a_layer_above_and_none_cross_any_more() {
        let across = |y: f64| Stroke::line([20.0, y], [300.0, y], 6.0);
        let down = |x: f64| Stroke::line([x, 20.0], [x, 300.0], 6.0);
        let layer = Layer::new([across(60.0), down(100.0), across(160.0), down(200.0)]);
        let mut session =
            Session::open(Document { layers: vec![layer.clone()], ..Document::default() }, None);
        assert_eq!(session.crossing_strokes(0), [1, 3]);
        session.split_crossings(0);
        let strokes: Vec<_> = session.document().layers.iter().map(|layer| layer.strokes.clone()).collect();
        assert_eq!(strokes, [vec![across(60.0), across(160.0)], vec![down(100.0), down(200.0)]]);
        assert!(session.crossing_strokes(0).is_empty() && session.crossing_strokes(1).is_empty());
        session.commit();
        session.undo();
        assert_eq!(session.document().layers, [layer]);
    }
}
