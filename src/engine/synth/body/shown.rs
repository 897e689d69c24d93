//! A model as it is seen: drawn once, or turned in a film.

use crate::colour::Gradient;
use crate::export::body::{Blurred, Paint, Painted, Picture, View, draw, is_far, length_of_px, normals};
use crate::export::srgb_from_linear;
use crate::surface::{Mesh, Surface};
use crate::synth::body::grown::GrownBody;
use crate::synth::body::output::{BARE, Bare, Lights, upright};

/// Steps of the colours and of the light on them, in a palette.
const SHADES: [usize; 2] = [12, 18];
/// The least and the greatest light on a model.
const LIGHT: [f32; 2] = [0.12, 1.2];
/// Shades of the ground behind it.
const BEHIND: usize = 36;

/// A model that is ready to be drawn from any side.
pub struct Shown<'a> {
    grown: &'a GrownBody,
    mesh: Mesh,
    normals: Vec<[f64; 3]>,
    bare: Vec<Bare>,
    lights: Lights,
    blurred: Option<Blurred>,
}

impl<'a> Shown<'a> {
    /// Makes a model ready for pictures of the size of this view. If it is so far away that a px shows more of the pattern than its
    /// samples can, the pattern is blurred (Turk 1991).
    #[must_use]
    pub fn new(grown: &'a GrownBody, view: &View) -> Self {
        let up = grown.up();
        let surface = grown.plan.surface();
        let positions = surface.mesh.positions.iter().map(|at| upright(up, *at)).collect();
        let mesh = Mesh { positions, faces: surface.mesh.faces.clone() };
        let bare = grown.bare(&|at| upright(up, grown.placed.scale.to_px(at)));
        let lights = Lights::new(&grown.colours().gradient());
        let places: Vec<[f64; 3]> =
            mesh.positions.iter().chain(bare.iter().flat_map(|bare| &bare.mesh.positions)).copied().collect();
        let px = length_of_px(view, &places);
        let blurred = is_far(surface, px).then(|| Self::blurred(grown, &lights, surface, px));
        let normals = normals(&mesh);
        Self { grown, mesh, normals, bare, lights, blurred }
    }

    fn blurred(grown: &GrownBody, lights: &Lights, surface: &Surface, px: f64) -> Blurred {
        let colours: Vec<[f32; 3]> = grown.levelled.pattern.iter().map(|value| lights.of(*value)).collect();
        // Parts that are seen aslant need more than a px.
        Blurred::new(surface, &colours, 4.0 * px)
    }

    /// The picture that is seen from `view`.
    #[must_use]
    pub fn picture(&self, view: &View) -> Picture {
        let light = |values: &[f32]| self.lights.of(values[0]);
        let fields = [self.grown.levelled.pattern.as_slice()];
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
        palette(&self.grown.colours().gradient(), view.background.unwrap_or([0.76; 3]))
    }
}

impl GrownBody {
    /// A picture of the model, seen from `view`.
    #[must_use]
    pub fn picture(&self, view: &View) -> Picture {
        Shown::new(self, view).picture(view)
    }
}

/// Colours under many lights, and the ground in shadows: at most 255.
fn palette(gradient: &Gradient, background: [f32; 3]) -> Vec<[u8; 3]> {
    let lights = Lights::new(gradient);
    let code = |light: f32| (255.0 * srgb_from_linear(f64::from(light.clamp(0.0, 1.0)))).round() as u8;
    let mut colours = Vec::new();
    for shade in 0..SHADES[0] {
        let colour = lights.of(shade as f32 / (SHADES[0] - 1) as f32);
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
