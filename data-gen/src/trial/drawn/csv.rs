//! Writes the numbers of each drawn mark as a row of a CSV file.

use std::io::Write;
use std::path::Path;

use dapple::files;

use super::attempt::Attempt;
use super::paths::Stroke;
use super::spots::Spot;

/// The columns. Cells that do not apply are empty.
const HEAD: &str = "sketch,mark,there,too_near,distance,area,aspect,angle,covered,direction,period,width";

/// Writes the rows of all sketches.
pub fn write(path: &Path, attempts: &[Attempt]) -> Result<(), String> {
    let mut text = format!("{HEAD}\n");
    for attempt in attempts {
        let rows = attempt.spots.iter().map(spot).chain(attempt.strokes.iter().map(stroke));
        for (mark, row) in rows.enumerate() {
            text += &format!("{},{},{row}\n", attempt.name, mark + 1);
        }
    }
    files::save(path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}

fn number(value: Option<f64>) -> String {
    value.map(|value| format!("{value:.5}")).unwrap_or_default()
}

fn spot(spot: &Spot) -> String {
    let errors = [spot.distance, spot.area, spot.aspect, spot.angle].map(number).join(",");
    format!("{},{},{errors},,,,", u8::from(spot.there), u8::from(spot.too_near))
}

/// The cells of a stroke. Its direction and period are means of the absolute errors along it.
fn stroke(stroke: &Stroke) -> String {
    let mean = |values: &[f64]| {
        (!values.is_empty()).then(|| values.iter().map(|x| x.abs()).sum::<f64>() / values.len() as f64)
    };
    let numbers =
        [Some(stroke.covered), mean(&stroke.directions), mean(&stroke.periods), stroke.width].map(number);
    format!(",,,,,,{}", numbers.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_row_has_the_columns_of_the_head() {
        let columns = HEAD.split(',').count();
        for row in [spot(&Spot::default()), stroke(&Stroke::default())] {
            assert_eq!(row.split(',').count() + 2, columns, "{row}");
        }
    }
}
