//! Reads the photograph on another thread, in steps whose results are kept.

use std::path::Path;
use std::sync::Arc;

use egui::{Color32, ColorImage};
use rayon::prelude::*;

use super::overlay::overlay;
use super::refusals::{no_sketch, refused};
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::files::open_picture;
use crate::machine::threads;
use crate::measure::Picture;
use crate::photo::{Limits, Neither, Raster};
use crate::synth::import::measured_picture::{
    Framing, MeasureError, OpenedPicture, ReadPicture, SegmentedPicture,
};
use crate::synth::import::photo::{ImportedPhoto, PhotoOptions, import_read};

/// The longest side of a picture that is shown, px: the same as for reference pictures.
const LONGEST: usize = 2048;

/// What the job sends.
pub enum News {
    /// The photograph, and how it is shown.
    Opened(Arc<OpenedPicture>, Arc<ColorImage>),
    /// Marks and ground are told apart.
    Segmented(Segmented),
    /// All of it: the last message.
    Found(Box<Found>),
    /// Why there is nothing to show: the last message.
    Failed(PhotoOptions, String),
}

/// A part of the photograph, divided into marks and ground.
#[derive(Clone)]
pub struct Segmented {
    /// The part, without limits.
    framing: Framing,
    picture: Arc<SegmentedPicture>,
    /// The part as it is shown under the canvas.
    reference: Arc<ColorImage>,
}

/// What was found with some options.
pub struct Found {
    /// The options of this reading; whether the sketch is taken anyway is not part of them.
    pub options: PhotoOptions,
    /// Spots or stripes, and their numbers.
    pub picture: Picture,
    /// Spots that the border cuts.
    pub cut: usize,
    /// The level of the edges.
    pub level: f32,
    /// The area of the smallest mark, px².
    pub least: f64,
    /// Why the photograph shows neither spots nor stripes.
    pub neither: Option<Neither>,
    /// The document, or why there is none.
    pub document: Result<ImportedPhoto, String>,
    /// The marks, to be painted over the photograph.
    pub overlay: ColorImage,
    /// The part that was read, as it is shown under the canvas.
    pub reference: Arc<ColorImage>,
}

/// What is known before a job starts.
#[derive(Clone, Default)]
pub struct Known {
    /// The photograph.
    pub opened: Option<Arc<OpenedPicture>>,
    /// Marks and ground, with the choices of the last reading.
    pub segmented: Option<Segmented>,
}

/// The options on which the segmentation depends.
#[must_use]
pub fn part(options: &PhotoOptions) -> Framing {
    Framing { limits: Limits::default(), ..options.framing }
}

/// Reads the photograph with `options`, except for the steps that are known, with this number of threads (`None` = all
/// cores).
///
/// # Errors
/// Where no thread can be started.
pub fn start(
    path: &Path,
    options: PhotoOptions,
    known: Known,
    threads: Option<usize>,
    tasks: &Tasks,
) -> Result<Task<News>, StartError> {
    let path = path.to_owned();
    tasks.start("reading a photograph", move |worker: &Worker<_>| {
        match threads::with(threads, || work(&path, options, known, worker)) {
            Ok(Some(found)) => worker.send(News::Found(Box::new(found))),
            Ok(None) => {}
            Err(error) => worker.send(News::Failed(options, refused(&error))),
        }
    })
}

/// The result; `None` where the job was cancelled.
fn work(
    path: &Path,
    options: PhotoOptions,
    known: Known,
    worker: &Worker<News>,
) -> Result<Option<Found>, MeasureError> {
    let opened = match known.opened {
        Some(opened) => opened,
        None => {
            let opened = Arc::new(open_picture(path)?);
            let photo = Arc::new(reduced(&opened.raster));
            worker.send(News::Opened(Arc::clone(&opened), photo));
            opened
        }
    };
    worker.set_progress(0.2);
    let framing = part(&options);
    let segmented = match known.segmented.filter(|segmented| segmented.framing == framing) {
        Some(segmented) => segmented,
        None => {
            let goes_on = |share: f64| {
                worker.set_progress(0.2 + 0.5 * share);
                !worker.is_cancelled()
            };
            let Some(picture) = opened.segmented(path, &framing, &goes_on)? else { return Ok(None) };
            let reference = Arc::new(reduced(&*opened.framed(path, &framing)?));
            let segmented = Segmented { framing, picture: Arc::new(picture), reference };
            worker.send(News::Segmented(segmented.clone()));
            segmented
        }
    };
    worker.set_progress(0.7);
    if worker.is_cancelled() {
        return Ok(None);
    }
    let read = SegmentedPicture::clone(&segmented.picture).read(path, &options.framing.limits)?;
    worker.set_progress(0.85);
    if worker.is_cancelled() {
        return Ok(None);
    }
    let document = import_read(&read, &opened, path, &options).map_err(|error| no_sketch(&error));
    worker.set_progress(0.95);
    Ok(Some(found(&read, options, document, opened.raster.size, segmented.reference)))
}

fn found(
    read: &ReadPicture,
    options: PhotoOptions,
    document: Result<ImportedPhoto, String>,
    photo: [usize; 2],
    reference: Arc<ColorImage>,
) -> Found {
    let reading = &read.reading;
    let between = document.as_ref().ok().and_then(|imported| imported.between);
    Found {
        options,
        picture: reading.picture,
        cut: reading.spots.iter().filter(|spot| !spot.whole).count(),
        level: reading.level(),
        least: reading.least,
        neither: reading.neither,
        document,
        overlay: overlay(reading, read.size, photo, options.framing.corners, between),
        reference,
    }
}

/// A picture to show: the mean colours of blocks of px, where the photograph is larger than pictures are shown.
fn reduced(raster: &Raster) -> ColorImage {
    let longest = raster.size[0].max(raster.size[1]).max(1);
    let size = raster.size.map(|side| (side * LONGEST.min(longest) / longest).max(1));
    // Block k of n covers the px from k·side ÷ n on.
    let block = |axis: usize, k: usize| {
        let at = |k: usize| k * raster.size[axis] / size[axis];
        at(k)..at(k + 1)
    };
    let colour = |px: usize| {
        let (columns, rows) = (block(0, px % size[0]), block(1, px / size[0]));
        let count = (columns.len() * rows.len()).max(1) as u32;
        let mut sums = [0_u32; 3];
        for y in rows {
            for x in columns.clone() {
                let px = raster.px(x, y);
                (0..3).for_each(|k| sums[k] += u32::from(px[k]));
            }
        }
        let [red, green, blue] = sums.map(|sum| ((sum + count / 2) / count) as u8);
        Color32::from_rgb(red, green, blue)
    };
    let pixels = (0..size[0] * size[1]).into_par_iter().with_min_len(size[0]).map(colour).collect();
    ColorImage::new(size, pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_photograph_is_shown_by_the_means_of_blocks_and_a_small_one_as_it_is() {
        let px = |k: usize| if (k % 4096).is_multiple_of(2) { [0, 100, 200] } else { [10, 120, 230] };
        let large = Raster { size: [4096, 6], rgb: (0..4096 * 6).flat_map(px).collect(), dpi: None };
        let shown = reduced(&large);
        assert_eq!(shown.size, [2048, 3]);
        assert!(shown.pixels.iter().all(|px| *px == Color32::from_rgb(5, 110, 215)));
        let small = Raster { size: [3, 2], rgb: (0..18).collect(), dpi: None };
        assert_eq!(reduced(&small).pixels[5], Color32::from_rgb(15, 16, 17));
    }
}
