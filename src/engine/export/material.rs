//! The maps of a material: file names that engines recognise, and writing all maps in one pass.

use std::io::Write;
use std::ops::Range;

use rayon::prelude::*;

use super::Stopped;
use super::png::{Header, Samples, Started};

/// A map of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Map {
    /// Colours, with opacity if any of them is transparent.
    BaseColour,
    /// 0 = transparent; only if any colour is transparent.
    Opacity,
    /// 0 = the lowest, 1 = the highest; 16 bit.
    Height,
    /// Normals, green points up in the picture (OpenGL).
    NormalGl,
    /// Normals, green points down in the picture (DirectX).
    NormalDx,
    /// 0 = mirror, 1 = chalk.
    Roughness,
    /// 0 = occluded, 1 = open to the whole sky.
    Occlusion,
    /// Occlusion, roughness, metalness.
    Orm,
    /// Metalness, occlusion, 0, smoothness.
    MaskMap,
    /// A flat colour for the marks of each layer, black for the ground.
    Id,
    /// The direction in which reflections are stretched, red = x and green = y, up in the picture, 0..1 for −1..1; blue: how far. Only
    /// of materials with such.
    Anisotropy,
}

impl Map {
    /// All maps.
    pub const ALL: [Self; 11] = [
        Self::BaseColour,
        Self::Opacity,
        Self::Height,
        Self::NormalGl,
        Self::NormalDx,
        Self::Roughness,
        Self::Occlusion,
        Self::Orm,
        Self::MaskMap,
        Self::Id,
        Self::Anisotropy,
    ];

    /// The suffix of its file name; docs/materials.md lists the engines that recognise it.
    #[must_use]
    pub fn suffix(self) -> &'static str {
        match self {
            Self::BaseColour => "BaseColor",
            Self::Opacity => "Opacity",
            Self::Height => "Height",
            Self::NormalGl => "NormalGL",
            Self::NormalDx => "NormalDX",
            Self::Roughness => "Roughness",
            Self::Occlusion => "AmbientOcclusion",
            Self::Orm => "ORM",
            Self::MaskMap => "MaskMap",
            Self::Id => "ID",
            Self::Anisotropy => "Anisotropy",
        }
    }

    /// The name of its file.
    #[must_use]
    pub fn file(self, name: &str) -> String {
        format!("{name}_{}.png", self.suffix())
    }

    /// The samples of its px; colours and normals have 16 bits if `deep`.
    #[must_use]
    pub fn samples(self, deep: bool, transparent: bool) -> Samples {
        match self {
            Self::BaseColour => Samples::colours(deep, transparent),
            Self::NormalGl | Self::NormalDx => Samples::colours(deep, false),
            Self::Height => Samples::Gray16,
            Self::Opacity | Self::Roughness | Self::Occlusion => Samples::Gray8,
            Self::Orm => Samples::Rgb8,
            Self::MaskMap => Samples::Rgba8,
            Self::Id | Self::Anisotropy => Samples::Rgb8,
        }
    }

    /// Whether it holds colours. All other maps hold numbers, which colour management must not change.
    #[must_use]
    pub fn is_colour(self) -> bool {
        matches!(self, Self::BaseColour | Self::Id)
    }
}

/// `text` as a name that is valid in file names and links everywhere: ASCII letters, digits, `_` and `-` are kept, everything
/// else becomes `-`. If nothing is left, the name is `dapple`.
///
/// ```
/// use dapple_engine::export::material;
///
/// let name = material::name("a zebra / two");
/// assert!(!name.contains(['/', ' ']), "{name}");
/// ```
#[must_use]
pub fn name(text: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '_' || c == '-' { c } else { ' ' };
    let spaced: String = text.chars().map(plain).collect();
    let name = spaced.split_whitespace().collect::<Vec<_>>().join("-");
    let name: String = name.trim_matches('-').chars().take(100).collect();
    if name.is_empty() { "dapple".to_owned() } else { name }
}

/// The flat colour of the marks of layer `label` (1 = the lowest; 0 = the ground). Successive hues differ by the golden section of
/// the circle.
#[must_use]
pub fn id_colour(label: u8) -> [u8; 3] {
    if label == 0 {
        return [0; 3];
    }
    let hue = 6.0 * (f64::from(label - 1) * 0.618_033_988_75).fract();
    let channel = |at: f64| {
        let off = (hue - at).rem_euclid(6.0);
        let off = off.min(6.0 - off);
        (255.0 * (2.0 - off).clamp(0.0, 1.0)).round() as u8
    };
    [channel(0.0), channel(2.0), channel(4.0)]
}

/// The common properties of a set of maps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Set<'a> {
    /// The beginning of the file names, made by [`name()`].
    pub name: &'a str,
    /// Width and height, px.
    pub size: [usize; 2],
    /// Whether colours and normals have 16 bits.
    pub deep: bool,
    /// Whether the ground or another colour is transparent.
    pub transparent: bool,
    /// Whether reflections have a direction: those of hair.
    pub anisotropic: bool,
    /// px an inch.
    pub dpi: Option<f64>,
}

impl Set<'_> {
    /// Its maps.
    #[must_use]
    pub fn maps(&self) -> Vec<Map> {
        let is_written = |map: &Map| match map {
            Map::Opacity => self.transparent,
            Map::Anisotropy => self.anisotropic,
            _ => true,
        };
        Map::ALL.into_iter().filter(is_written).collect()
    }
}

/// The index of the map that failed, and the reason.
#[derive(Debug)]
pub struct Failed {
    /// The index of the map in [`Set::maps`].
    pub at: usize,
    /// The reason.
    pub why: Stopped,
}

/// Adds the index of the map to an error.
fn failed(at: usize) -> impl Fn(Stopped) -> Failed {
    move |why| Failed { at, why }
}

/// Writes all maps of `set` into `outputs`, in the order of [`Set::maps`], without holding them in memory. `fill` is called for
/// bands of `rows_a_band` rows from the top and writes the bytes of each map into one slice, in the same order.
///
/// # Errors
/// The error of `fill` or of an output.
pub fn write(
    outputs: &mut [impl Write + Send],
    set: &Set,
    rows_a_band: usize,
    fill: impl FnMut(Range<usize>, &mut [Vec<u8>]) -> Result<(), Stopped>,
) -> Result<(), Failed> {
    write_some(outputs, set, &set.maps(), rows_a_band, fill)
}

/// Writes only some of the `maps` of `set`, as [`write()`] does.
///
/// # Errors
/// The error of `fill` or of an output; [`Failed::at`] is the place in `maps`.
pub fn write_some(
    outputs: &mut [impl Write + Send],
    set: &Set,
    maps: &[Map],
    rows_a_band: usize,
    mut fill: impl FnMut(Range<usize>, &mut [Vec<u8>]) -> Result<(), Stopped>,
) -> Result<(), Failed> {
    let rows_a_band = rows_a_band.max(1);
    let [width, height] = set.size;
    let mut started = Vec::with_capacity(maps.len());
    for (at, (map, output)) in maps.iter().zip(outputs).enumerate() {
        let samples = map.samples(set.deep, set.transparent);
        let header = Header { dpi: set.dpi, colours: map.is_colour(), ..Header::new(set.size, samples) };
        started.push(Started::new(output, header).map_err(failed(at))?);
    }
    let rows = started.iter_mut().enumerate().map(|(at, file)| file.rows().map_err(failed(at)));
    let mut files = rows.collect::<Result<Vec<_>, _>>()?;
    let mut bands: Vec<Vec<u8>> = vec![Vec::new(); maps.len()];
    for top in (0..height).step_by(rows_a_band) {
        let rows = top..height.min(top + rows_a_band);
        for (band, map) in bands.iter_mut().zip(maps) {
            band.resize(rows.len() * width * map.samples(set.deep, set.transparent).bytes(), 0);
        }
        // `fill` does not belong to one file: the error names the first one.
        fill(rows, &mut bands).map_err(failed(0))?;
        let pushed = files.par_iter_mut().zip(&bands).enumerate();
        pushed.try_for_each(|(at, (file, band))| file.push(band).map_err(failed(at)))?;
    }
    files.into_iter().enumerate().try_for_each(|(at, file)| file.finish().map_err(failed(at)))?;
    started.into_iter().enumerate().try_for_each(|(at, file)| file.finish().map_err(failed(at)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_valid_in_every_file_system() {
        let named = ["cheetah, Turk 1991 fig. 2", " über/../x ", "…", "a_B-3"].map(name);
        assert_eq!(named, ["cheetah-Turk-1991-fig-2", "ber-x", "dapple", "a_B-3"]);
        assert!(name(&"x".repeat(1000)).len() <= 100);
    }

    /// Accepts this number of bytes.
    struct Disk(usize);

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0 = self.0.checked_sub(bytes.len()).ok_or(std::io::ErrorKind::StorageFull)?;
            Ok(bytes.len())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn the_error_names_the_file_that_failed() {
        let set = Set {
            name: "a",
            size: [300, 200],
            deep: false,
            transparent: false,
            anisotropic: false,
            dpi: None,
        };
        // At the head, among the rows, at the end.
        for (full, room) in [(3, 10), (5, 4_000), (8, 120)] {
            let mut disks: Vec<Disk> =
                (0..9).map(|at| Disk(if at == full { room } else { 1 << 30 })).collect();
            let mut noise = 1_u32;
            let mut fill = |_: Range<usize>, bands: &mut [Vec<u8>]| {
                bands.iter_mut().flatten().for_each(|byte| {
                    noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    *byte = (noise >> 24) as u8;
                });
                Ok(())
            };
            let Failed { at, why } = write(&mut disks, &set, 16, &mut fill).unwrap_err();
            let Stopped::Io(why) = why else { panic!("cancelled") };
            assert_eq!((at, why.kind()), (full, std::io::ErrorKind::StorageFull));
        }
        let mut disks: Vec<Disk> = (0..9).map(|_| Disk(1 << 30)).collect();
        let stopped = write(&mut disks, &set, 16, |_, _| Err(Stopped::Cancelled)).unwrap_err();
        assert!(matches!(stopped.why, Stopped::Cancelled));
    }

    #[test]
    fn layers_have_distinct_colours() {
        let colours: Vec<[u8; 3]> = (0..=12).map(id_colour).collect();
        for (i, a) in colours.iter().enumerate() {
            for b in &colours[..i] {
                let apart: i32 = a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(*b)).abs()).sum();
                assert!(apart > 60, "{a:?} {b:?}");
            }
        }
        assert_eq!(colours[..2], [[0, 0, 0], [255, 0, 0]]);
    }
}
