//! Documents put together in code.
//!
//! All types are plain structs with public fields and a [`Default`]; the methods here only make the common cases short.

use crate::document::systems::POINTS;
use crate::document::{
    After, Colours, Document, Layer, LayerMap, LayerOptions, MapKey, Outline, Points, Stop, Stroke,
    SystemChoice, Tone,
};
use crate::grid::Edges;
use crate::marks::{Ellipse, Line, Path};

impl Document {
    /// An empty canvas of `size` px, with all defaults. It needs a layer before it can be written or grown.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let spots = [Stroke::ellipse([40.0, 50.0], [12.0, 7.0], 30.0), Stroke::ellipse([80.0, 60.0], [12.0, 7.0], 40.0)];
    /// let document = Document::new([256, 256]).with_name("cheetah").with_seed(7).with_layer(Layer::new(spots));
    /// document.check("the cheetah")?;
    /// # Ok::<(), dapple_engine::document::DocumentError>(())
    /// ```
    #[must_use]
    pub fn new(size: [u32; 2]) -> Self {
        Self { size, ..Self::default() }
    }

    /// With another name.
    #[must_use]
    pub fn with_name(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// With this number of columns and rows of regions, instead of free marks.
    #[must_use]
    pub fn with_regions(self, regions: [u32; 2]) -> Self {
        Self { regions: Some(regions), ..self }
    }

    /// With other edges; [`Edges::Wrap`] makes a seamless tile.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Edges};
    ///
    /// let tile = Document::new([128, 128]).with_edges(Edges::Wrap).with_regions([4, 2]);
    /// assert_eq!((tile.edges, tile.region_grid()), (Edges::Wrap, [4, 2]));
    /// ```
    #[must_use]
    pub fn with_edges(self, edges: Edges) -> Self {
        Self { edges, ..self }
    }

    /// With another seed of all random numbers.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// With one more layer on top. A layer without a name is named `layer 1`, `layer 2`, …, as in a file.
    #[must_use]
    pub fn with_layer(mut self, mut layer: Layer) -> Self {
        if layer.name.is_empty() {
            layer.name = format!("layer {}", self.layers.len() + 1);
        }
        self.layers.push(layer);
        self
    }
}

impl Layer {
    /// A layer of these strokes, with all defaults: it grows between the marks beneath, by the system that suits it.
    ///
    /// ```
    /// use dapple_engine::document::{After, Layer, LayerOptions, Stroke};
    ///
    /// // Rings around the marks beneath, 4 px wide; a third of each is open.
    /// let rings = Layer::new([Stroke::line([20.0, 20.0], [60.0, 20.0], 4.0)])
    ///     .with_after(After::Around)
    ///     .with_options(LayerOptions { broken: 1.0 / 3.0, ..LayerOptions::default() });
    /// assert_eq!(rings.strokes.len(), 1);
    /// ```
    #[must_use]
    pub fn new(strokes: impl IntoIterator<Item = impl Into<Stroke>>) -> Self {
        Self { strokes: strokes.into_iter().map(Into::into).collect(), ..Self::default() }
    }

    /// With another name.
    #[must_use]
    pub fn with_name(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// Grown by this system.
    #[must_use]
    pub fn with_system(self, system: SystemChoice) -> Self {
        Self { system, ..self }
    }

    /// Meeting the marks beneath like this.
    #[must_use]
    pub fn with_after(self, after: After) -> Self {
        Self { after, ..self }
    }

    /// With these options.
    #[must_use]
    pub fn with_options(self, options: LayerOptions) -> Self {
        Self { options, ..self }
    }

    /// Driven by a picture.
    #[must_use]
    pub fn with_tone(self, tone: Tone) -> Self {
        Self { tone: Some(tone), ..self }
    }

    /// With these points.
    #[must_use]
    pub fn with_points(self, points: Points) -> Self {
        Self { system: SystemChoice::Of(&POINTS), points: Some(points), ..self }
    }

    /// Varied by this map.
    #[must_use]
    pub fn with_map(mut self, key: MapKey, map: LayerMap) -> Self {
        self.maps.set(key, Some(map));
        self
    }

    /// In these colours.
    #[must_use]
    pub fn with_colours(self, colours: Colours) -> Self {
        Self { colours: Some(colours), ..self }
    }

    /// With a seed of its own.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed: Some(seed), ..self }
    }

    /// Grown, but not painted.
    #[must_use]
    pub fn hidden(self) -> Self {
        Self { visible: false, ..self }
    }
}

impl Stroke {
    /// A spot: its centre (px), its radii along and across `angle` (px), `angle` (degrees from +x towards +y).
    #[must_use]
    pub fn ellipse(center: [f64; 2], radii: [f64; 2], angle: f64) -> Self {
        Self::Ellipse(Ellipse { center, radii, angle })
    }

    /// A piece of a stripe: its ends and its width, px.
    #[must_use]
    pub fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Self {
        Self::Line(Line { from, to, width })
    }

    /// A piece of a stripe that may bend: its points in order, at least two, and its width, px.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let arc = Stroke::path([[20.0, 60.0], [50.0, 40.0], [90.0, 40.0], [120.0, 60.0]], 8.0);
    /// Document::new([140, 100]).with_layer(Layer::new([arc])).check("the arc")?;
    /// # Ok::<(), dapple_engine::document::DocumentError>(())
    /// ```
    #[must_use]
    pub fn path(points: impl IntoIterator<Item = [f64; 2]>, width: f64) -> Self {
        Self::Path(Path { points: points.into_iter().collect(), width })
    }
}

impl Stroke {
    /// A patch: the corners of its outline in order, at least three, px; the last is joined to the first.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let patch = Stroke::outline([[20.0, 30.0], [50.0, 20.0], [70.0, 45.0], [40.0, 40.0], [30.0, 60.0]]);
    /// Document::new([140, 100]).with_layer(Layer::new([patch])).check("the patch")?;
    /// # Ok::<(), dapple_engine::document::DocumentError>(())
    /// ```
    #[must_use]
    pub fn outline(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::Outline(Outline { points: points.into_iter().collect() })
    }
}

impl From<Ellipse> for Stroke {
    fn from(ellipse: Ellipse) -> Self {
        Self::Ellipse(ellipse)
    }
}

impl From<Line> for Stroke {
    fn from(line: Line) -> Self {
        Self::Line(line)
    }
}

impl From<Path> for Stroke {
    fn from(path: Path) -> Self {
        Self::Path(path)
    }
}

impl Colours {
    /// Colours (red, green, blue, sRGB) at pattern values (0 = ground, 0.5 = a mark's edge, 1 = its centre), ascending,
    /// with straight transitions between them.
    ///
    /// ```
    /// use dapple_engine::document::Colours;
    ///
    /// // Sand up to 0.4, black from 0.6 on.
    /// let (sand, black) = ([0xf4, 0xe3, 0xc1], [0; 3]);
    /// let colours = Colours::new([(0.0, sand), (0.4, sand), (0.6, black), (1.0, black)]);
    /// assert_eq!(colours.gradient().colour(0.2), sand);
    /// ```
    #[must_use]
    pub fn new(stops: impl IntoIterator<Item = (f64, [u8; 3])>) -> Self {
        let stops = stops.into_iter().map(|(at, colour)| Stop::opaque(at, colour)).collect();
        Self { stops, bends: Vec::new(), ground: Self::GROUND, halo: 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rd::System;

    #[test]
    fn a_built_document_is_read_back_equal() {
        let spots = Layer::new([Ellipse { center: [30.0, 30.0], radii: [8.0, 5.0], angle: 20.0 }]);
        let rings = Layer::new([Stroke::line([20.0, 20.0], [60.0, 25.0], 4.0)])
            .with_name("rings")
            .with_after(After::Around)
            .with_system(SystemChoice::Of(System::MEINHARDT_LINES.description()))
            .with_options(LayerOptions { broken: 0.3, ..LayerOptions::default() })
            .with_colours(Colours::new([(0.0, [255; 3]), (1.0, [0; 3])]))
            .with_seed(9);
        let document = Document::new([120, 90])
            .with_name("rosettes")
            .with_regions([2, 1])
            .with_edges(Edges::Wrap)
            .with_seed(3)
            .with_layer(spots)
            .with_layer(rings);
        assert_eq!(document.layers[0].name, "layer 1");
        assert_eq!(Document::parse(&document.to_json(), "itself").unwrap(), document);
    }

    #[test]
    fn the_builder_refuses_what_a_file_may_not_hold() {
        assert!(Document::new([64, 64]).check("x").unwrap_err().to_string().contains("layers"));
        let outside = Layer::new([Stroke::ellipse([100.0, 10.0], [4.0, 4.0], 0.0)]);
        let error = Document::new([64, 64]).with_layer(outside).check("x").unwrap_err().to_string();
        assert!(error.contains("layers[0].strokes[0]: found an ellipse about [100, 10]"), "{error}");
    }
}
