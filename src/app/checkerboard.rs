//! The checkerboard that is shown under transparent parts.

use egui::{
    Color32, ColorImage, Id, Painter, Rect, Shape, TextureHandle, TextureOptions, epaint::Mesh, pos2,
};

/// Side of a square, points.
const SQUARE: f32 = 8.0;

/// Paints the checkerboard into `rect`.
pub fn paint(painter: &Painter, rect: Rect) {
    let mut mesh = Mesh::with_texture(squares(painter).id());
    let tiles = Rect::from_min_size(pos2(0.0, 0.0), rect.size() / (2.0 * SQUARE));
    mesh.add_rect_with_uv(rect, tiles, Color32::WHITE);
    painter.add(Shape::mesh(mesh));
}

/// Two by two squares, as a texture that repeats; made once for each window.
fn squares(painter: &Painter) -> TextureHandle {
    let (ctx, id) = (painter.ctx(), Id::unique("checkerboard"));
    ctx.data(|data| data.get_temp(id)).unwrap_or_else(|| {
        let [a, b] = [Color32::from_gray(250), Color32::from_gray(218)];
        let image = ColorImage::new([2, 2], vec![a, b, b, a]);
        let squares = ctx.load_texture("checkerboard", image, TextureOptions::NEAREST_REPEAT);
        ctx.data_mut(|data| data.insert_temp(id, squares.clone()));
        squares
    })
}
