//! Written files → images for the preview.

use std::io::BufReader;
use std::path::Path;

use egui::{Color32, ColorImage};
use image::codecs::{gif::GifDecoder, png::PngDecoder};
use image::{AnimationDecoder, DynamicImage, RgbaImage, imageops};

use super::choices::ExportKind;
use super::request::ExportRequest;
use crate::export::motion::Kind;
use crate::export::{Format, srgb_from_linear};
use crate::machine::fs::File;

/// Largest memory of the frames of a film, bytes; larger frames are reduced.
const MOST: usize = 128 << 20;

/// The images of an export.
pub enum PreviewImages {
    /// Pictures and their names; the name of a single one is empty.
    Pictures(Vec<(String, ColorImage)>),
    /// The frames of a film, and how long each is shown, seconds.
    Film(Vec<(ColorImage, f64)>),
}

impl PreviewImages {
    /// Reads the `files` that were written for `request`.
    ///
    /// # Errors
    /// What cannot be read.
    pub fn read(request: &ExportRequest, files: &[impl AsRef<Path>], seconds: f64) -> Result<Self, String> {
        let choices = &request.choices;
        match choices.what {
            ExportKind::Film => frames(choices.film.kind, files, seconds).map(Self::Film),
            ExportKind::Picture if choices.picture.format == Format::Exr => {
                light(files[0].as_ref()).map(Self::Pictures)
            }
            _ => {
                let pictures =
                    files.iter().map(AsRef::as_ref).filter(|file| Format::from_path(file).is_some());
                let named = |file: &Path| {
                    let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                    let name = stem.rsplit_once('_').map_or("", |(_, suffix)| suffix);
                    Ok((name.to_owned(), shown(open(file)?)))
                };
                pictures.map(named).collect::<Result<_, String>>().map(Self::Pictures)
            }
        }
    }
}

fn open(file: &Path) -> Result<DynamicImage, String> {
    let stream = File::open(file).map(BufReader::new).map_err(|error| error.to_string())?;
    let mut reader = image::ImageReader::new(stream);
    reader.no_limits();
    let reader = reader.with_guessed_format().map_err(|error| error.to_string())?;
    reader.decode().map_err(|error| error.to_string())
}

fn shown(image: DynamicImage) -> ColorImage {
    let image = image.into_rgba8();
    let size = [image.width() as usize, image.height() as usize];
    ColorImage::from_rgba_unmultiplied(size, image.as_raw())
}

fn frames(kind: Kind, files: &[impl AsRef<Path>], seconds: f64) -> Result<Vec<(ColorImage, f64)>, String> {
    let stream = |file: &Path| File::open(file).map(BufReader::new).map_err(|error| error.to_string());
    let wrong = |error: image::ImageError| error.to_string();
    let mut frames: Vec<(RgbaImage, f64)> = Vec::new();
    let mut push = |image: RgbaImage, seconds: f64, of: usize| {
        let all = 4 * (image.width() * image.height()) as usize * of;
        let smaller = (MOST as f64 / all.max(1) as f64).sqrt();
        let image = if smaller < 1.0 {
            let side = |px: u32| ((f64::from(px) * smaller) as u32).max(1);
            imageops::thumbnail(&image, side(image.width()), side(image.height()))
        } else {
            image
        };
        frames.push((image, seconds));
    };
    // The number of frames is not known: assumes a usual one.
    let usual = 80;
    let mut take = |found: image::Frames| {
        for frame in found {
            let frame = frame.map_err(wrong)?;
            let (numerator, denominator) = frame.delay().numer_denom_ms();
            push(frame.into_buffer(), f64::from(numerator) / f64::from(denominator) / 1000.0, usual);
        }
        Ok::<(), String>(())
    };
    match kind {
        Kind::Gif => take(GifDecoder::new(stream(files[0].as_ref())?).map_err(wrong)?.into_frames())?,
        Kind::Apng => {
            let decoder = PngDecoder::new(stream(files[0].as_ref())?).map_err(wrong)?;
            take(decoder.apng().map_err(wrong)?.into_frames())?;
        }
        Kind::Folder => {
            for file in files {
                push(open(file.as_ref())?.into_rgba8(), seconds, files.len());
            }
        }
    }
    let image = |image: RgbaImage| {
        let size = [image.width() as usize, image.height() as usize];
        ColorImage::from_rgba_unmultiplied(size, image.as_raw())
    };
    Ok(frames.into_iter().map(|(frame, seconds)| (image(frame), seconds)).collect())
}

/// An OpenEXR picture: colours in sRGB, or each channel scaled between its minimum and maximum.
fn light(file: &Path) -> Result<Vec<(String, ColorImage)>, String> {
    let image = exr::prelude::read_first_flat_layer_from_file(file).map_err(|error| error.to_string())?;
    let layer = &image.layer_data;
    let size = [layer.size.width(), layer.size.height()];
    let channels: Vec<(String, Vec<f32>)> = layer
        .channel_data
        .list
        .iter()
        .map(|channel| (channel.name.to_string(), channel.sample_data.values_as_f32().collect()))
        .collect();
    let of = |name: &str| channels.iter().find(|(other, _)| other == name).map(|(_, values)| values);
    if let (Some(r), Some(g), Some(b)) = (of("R"), of("G"), of("B")) {
        let opacity = of("A");
        let px = |i: usize| {
            let a = opacity.map_or(1.0, |opacity| opacity[i]);
            let look = |light: f32| if a > 0.0 { to_srgb(light / a) } else { 0 };
            Color32::from_rgba_unmultiplied(look(r[i]), look(g[i]), look(b[i]), (255.0 * a).round() as u8)
        };
        let image = ColorImage::new(size, (0..r.len()).map(px).collect());
        return Ok(vec![(String::new(), image)]);
    }
    let lone = channels.len() == 1;
    let gray = |(name, values): (String, Vec<f32>)| {
        let (low, high) = match lone {
            true => (0.0, 1.0),
            false => {
                values.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)))
            }
        };
        let value = |v: &f32| (255.0 * ((v - low) / (high - low).max(1e-12)).clamp(0.0, 1.0)).round() as u8;
        let px = values.iter().map(|v| Color32::from_gray(value(v))).collect();
        let name = if lone { String::new() } else { format!("{name}  {low:.3} to {high:.3}") };
        (name, ColorImage::new(size, px))
    };
    Ok(channels.into_iter().map(gray).collect())
}

/// Linear light as 8-bit sRGB.
fn to_srgb(light: f32) -> u8 {
    (255.0 * srgb_from_linear(f64::from(light))).round() as u8
}
