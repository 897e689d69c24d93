//! A model as it is seen: drawn once, or turned in a film.

use crate::export::body::{Blurred, Paint, Painted, Picture, View, draw, is_far, length_of_px, normals};
use crate::export::srgb_from_linear;
use crate::surface::{Mesh, Surface};
use crate::synth::body::coat::Coat;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::output::{BARE, Bare, upright};

/// Steps of the colours and of the light on them, in a palette.
const SHADES: [usize; 2] = [12, 18];
/// The least and the greatest light on a model.
const LIGHT: [f32; 2] = [0.12, 1.2];
/// Shades of the ground behind it.
const BEHIND: usize = 36;

/// A model that is ready to be drawn from any side.
pub struct Shown {
    mesh: Mesh,
    normals: Vec<[f64; 3]>,
    bare: Vec<Bare>,
    coat: Coat,
    patterns: Vec<Vec<f32>>,
    blurred: Option<Blurred>,
}

impl Shown {
    /// Makes a model ready for pictures of the size of this view. If it is so far away that a px shows more of the pattern than its
    /// samples can, the pattern is blurred (Turk 1991).
    #[must_use]
    pub fn new(grown: &GrownBody, view: &View) -> Self {
        let up = grown.up();
        let surface = grown.finest().plan.surface();
        let positions = surface.mesh.positions.iter().map(|at| upright(up, *at)).collect();
        let mesh = Mesh { positions, faces: surface.mesh.faces.clone() };
        let bare = grown.bare(&|at| upright(up, grown.placed.scale.to_px(at)));
        let (coat, patterns) = (Coat::new(&grown.document), grown.painted());
        let places: Vec<[f64; 3]> =
            mesh.positions.iter().chain(bare.iter().flat_map(|bare| &bare.mesh.positions)).copied().collect();
        let px = length_of_px(view, &places);
        let blurred = is_far(surface, px).then(|| blurred(&coat, &patterns, surface, px));
        let normals = normals(&mesh);
        Self { mesh, normals, bare, coat, patterns, blurred }
    }

    /// The picture that is seen from `view`.
    #[must_use]
    pub fn picture(&self, view: &View) -> Picture {
        let light = |values: &[f32]| self.coat.light(values);
        let fields: Vec<&[f32]> = self.patterns.iter().map(Vec::as_slice).collect();
        let paint = match &self.blurred {
            Some(blurred) => Paint::Blurred(blurred),
            None => Paint::Pattern { fields: &fields, colour: &light },
        };
        let grown = Painted { mesh: &self.mesh, normals: &self.normals, paint };
        let others = self.bare.iter().map(|bare| Painted {
            mesh: &bare.mesh,
            normals: &bare.normals,
            paint: Paint::Plain(BARE),
        });
        draw(&[grown].into_iter().chain(others).collect::<Vec<Painted>>(), view)
    }

    /// The colours of such pictures, for formats with few.
    #[must_use]
    pub fn palette(&self, view: &View) -> Vec<[u8; 3]> {
        palette(&self.coat, view.background.unwrap_or([0.76; 3]))
    }
}

/// The colours of a surface's vertices at all levels of blur that px so long on it need.
fn blurred(coat: &Coat, patterns: &[Vec<f32>], surface: &Surface, px: f64) -> Blurred {
    // Parts that are seen aslant need more than a px.
    Blurred::new(surface, &coat.lights(patterns), 4.0 * px)
}

impl GrownBody {
    /// A picture of the model, seen from `view`.
    #[must_use]
    pub fn picture(&self, view: &View) -> Picture {
        Shown::new(self, view).picture(view)
    }
}

/// Colours under many lights, and the ground in shadows: at most 255.
fn palette(coat: &Coat, background: [f32; 3]) -> Vec<[u8; 3]> {
    let layers = coat.layers();
    let code = |light: f32| (255.0 * srgb_from_linear(f64::from(light.clamp(0.0, 1.0)))).round() as u8;
    let mut colours = Vec::new();
    let grounds = if coat.has_second_ground() { &[0.0, 0.5, 1.0][..] } else { &[0.0] };
    let shades = (SHADES[0] / layers.max(1) / grounds.len()).max(2);
    for (shade, second) in
        (0..layers * shades).flat_map(|shade| grounds.iter().map(move |second| (shade, *second)))
    {
        let mut values = coat.unvaried(second);
        values[shade / shades] = (shade % shades) as f32 / (shades - 1) as f32;
        let colour = coat.light(&values);
        for step in 0..SHADES[1] {
            let share = step as f32 / (SHADES[1] - 1) as f32;
            // Even steps of what is seen.
            let light = LIGHT[0] + (LIGHT[1] - LIGHT[0]) * share * share;
            colours.push(colour.map(|part| code(part * light)));
        }
    }
    for step in 0..BEHIND {
        let share = 1.0 - 0.9 * step as f32 / (BEHIND - 1) as f32;
        colours.push(background.map(|part| code(part * share)));
    }
    colours.sort_unstable();
    colours.dedup();
    colours
}
