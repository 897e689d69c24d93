//! The pictures of a material.

/// A picture in PNG.
#[derive(Clone, Copy, Debug)]
pub enum SkinPicture<'a> {
    /// Its bytes, which become part of the file.
    Inside(&'a [u8]),
    /// The name of its file, which lies beside.
    Beside(&'a str),
}

/// What a material looks like: pictures on the texture coordinates of the parts that have it.
#[derive(Clone, Copy, Debug)]
pub struct Skin<'a> {
    /// The name of the material.
    pub material: &'a str,
    /// Colours, with opacity if any of them is transparent.
    pub base_colour: SkinPicture<'a>,
    /// Normals, green points up in the picture.
    pub normal: SkinPicture<'a>,
    /// Occlusion in red, roughness in green, metalness in blue.
    pub orm: SkinPicture<'a>,
    /// The direction of reflections, if they have one (KHR_materials_anisotropy).
    pub anisotropy: Option<SkinPicture<'a>>,
    /// Whether any colour is transparent.
    pub transparent: bool,
}

impl<'a> Skin<'a> {
    /// Its pictures: colours, normals, occlusion with roughness and metalness, and if there is one the direction of reflections.
    #[must_use]
    pub fn pictures(&self) -> Vec<SkinPicture<'a>> {
        [self.base_colour, self.normal, self.orm].into_iter().chain(self.anisotropy).collect()
    }
}
