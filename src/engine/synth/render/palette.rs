//! The colours of films, for formats with few.

use crate::colour::{Ground, Table};
use crate::document::{Document, FlowChoice, Layer, MapKey};
use crate::export::motion::median_cut;
use crate::finish::{Finish, Flow, Source};
use crate::grid::Edges;
use crate::synth::render::film::mixed;
use crate::synth::render::painting::{gradient_of, second_ground};

/// Colours between those of two documents.
const STATIONS: usize = 8;
/// Side of the square of one colour that gets a finish, px, and the number of these in a row.
const SQUARE: [usize; 2] = [10, 16];

/// Up to `most` colours for films of these documents: evenly spaced in the colours of their visible layers, with the first and with the
/// second colour of the ground, and between those of the first and the last document. With a finish those that it makes of these.
#[must_use]
pub fn palette(documents: &[&Document], most: usize) -> Vec<[u8; 3]> {
    let plain = plain(documents, most);
    let finished =
        documents.iter().filter_map(|document| Some((document.finish.as_ref()?.finish, document.seed)));
    let px: Vec<u8> = finished.flat_map(|(finish, seed)| finished_px(&plain, finish, seed)).collect();
    if px.is_empty() { plain } else { median_cut(&px, most) }
}

/// The colours without a finish.
fn plain(documents: &[&Document], most: usize) -> Vec<[u8; 3]> {
    let tables = |document: &Document| {
        let layers = document.layers.iter().enumerate().filter(|(_, layer)| layer.visible);
        layers.flat_map(|(index, layer)| shades_of(layer, index)).collect::<Vec<_>>()
    };
    let (Some(first), Some(last)) = (documents.first(), documents.last()) else { return Vec::new() };
    let (first, last) = (tables(first), tables(last));
    let stations = if documents.len() > 1 { STATIONS } else { 1 };
    let layers = first.len().max(1);
    let count = (most / (layers * stations)).max(2);
    let mut colours = Vec::with_capacity(most);
    for (a, b) in first.iter().zip(&last) {
        for station in 0..stations {
            let share = station as f64 / (stations.max(2) - 1) as f64;
            let value = |k: usize| k as f32 / (count - 1) as f32;
            colours.extend((0..count).map(|k| mixed(a.colour(value(k)), b.colour(value(k)), share)));
        }
    }
    colours.sort_unstable();
    colours.dedup();
    colours.truncate(most);
    colours
}

/// The colours of a layer by pattern value.
struct Shades {
    table: Table,
    /// The second colour of the ground, and its share.
    ground: Option<(Ground, f32)>,
}

impl Shades {
    fn colour(&self, value: f32) -> [u8; 3] {
        let colour = self.table.colour(value);
        self.ground.as_ref().map_or(colour, |(ground, share)| ground.tinted(colour, value, *share))
    }
}

/// The colours of the layer with this index: with the second colour of the ground in these shares, if it has one.
fn shades_of(layer: &Layer, index: usize) -> Vec<Shades> {
    let gradient = gradient_of(layer, index);
    let plain = Shades { table: gradient.table(), ground: None };
    if layer.maps.get(MapKey::Ground).is_none() {
        return vec![plain];
    }
    let ground = Ground::new(&gradient, second_ground(layer));
    let tinted = [0.25, 0.5, 0.75, 1.0]
        .map(|share| Shades { table: gradient.table(), ground: Some((ground.clone(), share)) });
    [plain].into_iter().chain(tinted).collect()
}

/// A picture of squares of these colours with this finish: red, green, blue a px.
fn finished_px(colours: &[[u8; 3]], finish: Finish, seed: u64) -> Vec<u8> {
    let [side, columns] = SQUARE;
    let size = [side * columns, side * colours.len().div_ceil(columns)];
    let square = |px: usize| px / size[0] / side * columns + px % size[0] / side;
    // The last row begins again with the first colours.
    let rgb: Vec<u8> = (0..size[0] * size[1]).flat_map(|px| colours[square(px) % colours.len()]).collect();
    let labels = vec![0; size[0] * size[1]];
    let finished = finish.paint(&Source {
        size,
        canvas: size.map(|side| side as f32),
        edges: Edges::Wrap,
        rgb: &rgb,
        labels: &labels,
        flow: &Flow::uniform(FlowChoice::HEAD_TO_TAIL),
        reach: &finish.reach(&labels, size, Edges::Wrap),
        seed,
    });
    let code = |part: f32| (255.0 * part + 0.5) as u8;
    finished.surfels.iter().flat_map(|surfel| surfel.lit().map(code)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finish::Kind;

    #[test]
    fn a_film_with_a_finish_has_the_colours_of_its_hairs() {
        let plain = Document::new([64, 64]).with_layer(Layer::default());
        let furry = Document { finish: Some(Finish::new(Kind::Fur).into()), ..plain.clone() };
        let darkest = |document: &Document| {
            let colours = palette(&[document], 255);
            assert!((100..=255).contains(&colours.len()), "{}", colours.len());
            colours.iter().map(|px| px.iter().map(|part| u32::from(*part)).sum::<u32>()).min().unwrap()
        };
        // Between hairs it is darker than the darkest colour of the layer.
        assert!(darkest(&furry) < darkest(&plain), "{} {}", darkest(&furry), darkest(&plain));
        assert_eq!(palette(&[&furry], 255), palette(&[&furry], 255));
    }
}
