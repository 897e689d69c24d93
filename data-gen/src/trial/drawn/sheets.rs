//! Contact sheets: each sketch beside its texture.

use std::path::Path;

use dapple::sheet::{Contact, Thumbnail, write as write_sheet};

use super::Kind;
use super::attempt::Attempt;
use super::drawing::{GAP, SIDE};
use super::paths::COVERED;

/// Sketches on a sheet.
const A_SHEET: usize = 24;

/// Writes the sheets of each kind.
pub fn write(folder: &Path, kinds: &[Kind], attempts: &[Attempt]) -> Result<(), String> {
    for kind in kinds {
        let own = attempts.iter().filter(|attempt| attempt.name.starts_with(kind.letter()));
        let own: Vec<&Attempt> = own.collect();
        for (number, chunk) in own.chunks(A_SHEET).enumerate() {
            let mut contact = Contact::new(None, 2 * SIDE + GAP);
            for attempt in chunk {
                if let Some(drawing) = &attempt.drawing {
                    let picture = Thumbnail::from_rgb([2 * SIDE + GAP, SIDE], drawing.rgb.clone());
                    contact.add(title(attempt), picture);
                }
            }
            let path = folder.join(format!("sheet-{}-{}.png", kind.letter(), number + 1));
            write_sheet(&contact, &path).map_err(|error| error.to_string())?;
        }
    }
    Ok(())
}

fn title(attempt: &Attempt) -> String {
    let spots = attempt.spots.iter().filter(|spot| !spot.there).count();
    let strokes = attempt.strokes.iter().filter(|stroke| stroke.covered < COVERED).count();
    let (missing, all) = (spots + strokes, attempt.spots.len() + attempt.strokes.len());
    let failures = attempt.failures.iter().map(|failure| format!("; {failure}")).collect::<String>();
    format!("{}: {missing} of {all} not there{failures}", attempt.name)
}
