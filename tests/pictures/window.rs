//! Pictures of a window, painted on the processor. They are the same on every machine, and no graphics library has to
//! be built.
//!
//! It follows egui's shader for pictures in tests: one sample in the middle of each pixel, colours multiplied by their opacity
//! and blended as they are stored, textures interpolated by hand.

mod texture;
mod triangle;

use std::collections::HashMap;

use egui::epaint::{ClippedPrimitive, Primitive};
use egui::{Context, FullOutput, Rect, TextureId, TexturesDelta};
use egui_kittest::TestRenderer;
use image::RgbaImage;

use texture::Texture;
use triangle::{Corner, Triangle};

/// The textures of a window, by which its pictures are painted.
#[derive(Default)]
pub struct Painter {
    textures: HashMap<TextureId, Texture>,
}

impl TestRenderer for Painter {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        for (id, changes) in delta.set.drain() {
            for change in changes {
                match change.pos {
                    None => drop(self.textures.insert(id, Texture::new(&change))),
                    Some(corner) => {
                        self.textures.get_mut(&id).expect("a part of a texture").replace(corner, &change);
                    }
                }
            }
        }
        for id in delta.free.drain() {
            self.textures.remove(&id);
        }
    }

    fn render(&mut self, ctx: &Context, output: &FullOutput) -> Result<RgbaImage, String> {
        let scale = ctx.pixels_per_point();
        let size = ctx.content_rect().size() * scale;
        let mut picture = RgbaImage::new(size.x.round() as u32, size.y.round() as u32);
        for ClippedPrimitive { clip_rect, primitive } in ctx.tessellate(output.shapes.clone(), scale) {
            let Primitive::Mesh(mesh) = primitive else {
                return Err("only triangles are painted, no callbacks".into());
            };
            // A texture may have been freed after the frame that shows it.
            let Some(texture) = self.textures.get(&mesh.texture_id) else { continue };
            let [left, top, right, bottom] = pixels(clip_rect * scale, picture.dimensions());
            for corners in mesh.indices.chunks_exact(3) {
                let corner = |at: usize| Corner::new(&mesh.vertices[corners[at] as usize], scale);
                if let Some(triangle) = Triangle::new([corner(0), corner(1), corner(2)]) {
                    triangle.fill([left..right, top..bottom], |[x, y], colour, place| {
                        let texel = texture.at(place);
                        let source: [f32; 4] = std::array::from_fn(|part| colour[part] * texel[part]);
                        blend(&mut picture.get_pixel_mut(x as u32, y as u32).0, source);
                    });
                }
            }
        }
        Ok(picture)
    }
}

/// The pixels of a picture inside a rectangle: left, top, right, bottom.
fn pixels(rect: Rect, (width, height): (u32, u32)) -> [i64; 4] {
    let within = |value: f32, most: u32| (value.round() as i64).clamp(0, i64::from(most));
    let [left, right] = [rect.min.x, rect.max.x].map(|x| within(x, width));
    let [top, bottom] = [rect.min.y, rect.max.y].map(|y| within(y, height));
    [left, top, right, bottom]
}

/// Lays a colour over a pixel; both are multiplied by their opacity.
fn blend(pixel: &mut [u8; 4], source: [f32; 4]) {
    let source = source.map(|part| (255.0 * part.clamp(0.0, 1.0)).round());
    for (below, part) in pixel.iter_mut().zip(source) {
        *below = (part + f32::from(*below) * (255.0 - source[3]) / 255.0).round().min(255.0) as u8;
    }
}
