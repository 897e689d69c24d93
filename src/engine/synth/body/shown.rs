//! A model as it is seen: drawn once, or turned in a film.

use rayon::prelude::*;

use crate::colour::linear_light;
use crate::document::Axis;
use crate::export::body::{
    Blurred, Look, Paint, Painted, Picture, View, draw, is_far, length_of_px, normals,
};
use crate::export::motion::{COLOURS, median_cut};
use crate::export::srgb_from_linear;
use crate::finish::body::SurfaceFinish;
use crate::surface::{Mesh, Surface, SurfacePoint};
use crate::synth::body::coat::Coat;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::output::{BARE, Bare, upright};
use crate::synth::watch::Watch;

/// Steps of the colours and of the light on them, in a palette.
const SHADES: [usize; 2] = [12, 18];
/// The least and the greatest light on a model.
const LIGHT: [f32; 2] = [0.12, 1.2];
/// Shades of the ground behind it.
const BEHIND: usize = 36;

/// Sides from which a model with a finish is drawn to find its colours, and the longest side of these pictures, px.
const SIDES: usize = 4;
const SMALL: u32 = 256;

/// A model that is ready to be drawn from any side.
pub struct Shown<'a> {
    mesh: Mesh,
    normals: Vec<[f64; 3]>,
    bare: Vec<Bare>,
    coat: Coat,
    patterns: Vec<Vec<f32>>,
    blurred: Option<Blurred>,
    finished: Option<FinishedLook<'a>>,
}

/// The finish of a model as it is drawn.
struct FinishedLook<'a> {
    finish: SurfaceFinish<'a>,
    /// The axis that points up in the coordinates of the finish.
    up: Axis,
}

impl Look for FinishedLook<'_> {
    fn at(&self, triangle: usize, [a, b, _]: [f64; 3], px: f64) -> ([f32; 3], [f64; 3]) {
        let point = SurfacePoint { face: triangle as u32, weights: [a, b] };
        let found = self.finish.at(point, (1.0 / px) as f32);
        (linear(found.surfel.albedo()), upright(self.up, found.slope))
    }
}

/// The linear light of a colour in the coding of sRGB, between two of 256 codes.
fn linear(colour: [f32; 3]) -> [f32; 3] {
    let table = linear_light();
    colour.map(|code| {
        let at = 255.0 * code.clamp(0.0, 1.0);
        let low = at as usize;
        table[low] + (at - low as f32) * (table[(low + 1).min(255)] - table[low])
    })
}

impl<'a> Shown<'a> {
    /// Makes a model ready for pictures of the size of this view. If it is so far away that a px shows more of the pattern than its
    /// samples can, the pattern is blurred (Turk 1991). A finish is left out if it is cancelled.
    #[must_use]
    pub fn new(grown: &'a GrownBody, view: &View, watch: &Watch) -> Self {
        let up = grown.up();
        let surface = grown.finest().plan.surface();
        let positions = surface.mesh.positions.iter().map(|at| upright(up, *at)).collect();
        let mesh = Mesh { positions, faces: surface.mesh.faces.clone() };
        let bare = grown.bare(&|at| upright(up, grown.placed.scale.to_px(at)));
        let (coat, patterns) = (Coat::new(&grown.document), grown.painted());
        let places: Vec<[f64; 3]> =
            mesh.positions.iter().chain(bare.iter().flat_map(|bare| &bare.mesh.positions)).copied().collect();
        let px = length_of_px(view, &places);
        let finish = grown.finish(watch);
        let blurred = is_far(surface, px).then(|| {
            let lights =
                finish.as_ref().map_or_else(|| coat.lights(&patterns), |finish| lights(finish, surface));
            // Parts that are seen aslant need more than a px.
            Blurred::new(surface, &lights, 4.0 * px)
        });
        let normals = normals(&mesh);
        let finished = finish.map(|finish| FinishedLook { finish, up });
        Self { mesh, normals, bare, coat, patterns, blurred, finished }
    }

    /// The picture that is seen from `view`.
    #[must_use]
    pub fn picture(&self, view: &View) -> Picture {
        let light = |values: &[f32]| self.coat.light(values);
        let fields: Vec<&[f32]> = self.patterns.iter().map(Vec::as_slice).collect();
        let paint = match (&self.blurred, &self.finished) {
            (Some(blurred), _) => Paint::Blurred(blurred),
            (None, Some(look)) => Paint::Look(look),
            (None, None) => Paint::Pattern { fields: &fields, colour: &light },
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
        if self.finished.is_none() {
            return palette(&self.coat, view.background.unwrap_or([0.76; 3]));
        }
        let px = (0..SIDES).flat_map(|side| {
            let azimuth = view.azimuth + 360.0 * side as f64 / SIDES as f64;
            self.picture(&View { azimuth, size: view.size.map(|side| side.min(SMALL)), ..*view }).rgb()
        });
        median_cut(&px.collect::<Vec<u8>>(), COLOURS)
    }
}

/// The light of the vertices of a surface with a finish.
fn lights(finish: &SurfaceFinish, surface: &Surface) -> Vec<[f32; 3]> {
    let vertices = 0..surface.mesh.positions.len();
    let light = |vertex: usize| linear(finish.at(surface.place_of(vertex), 0.0).surfel.albedo());
    vertices.into_par_iter().map(light).collect()
}

impl GrownBody {
    /// A picture of the model, seen from `view`.
    #[must_use]
    pub fn picture(&self, view: &View) -> Picture {
        Shown::new(self, view, &Watch::NONE).picture(view)
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
