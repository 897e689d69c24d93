//! Writes the documents and pictures of a trial to files.

use std::path::Path;

use dapple::document::{Colours, Document};
use dapple::files::{self, WriteFile};
use dapple_engine::colour::{Gradient, Painted, Table, paint};
use dapple_engine::export::ExportError;
use dapple_engine::export::png::{gray16, rgb8};
use dapple_engine::grid::Field;

/// Writes `NAME.dapple`, `NAME.png` and, of each layer, `NAME.pattern.png` (from the second on with its number).
pub fn write(folder: &Path, name: &str, document: &Document, patterns: &[Field]) -> Result<(), String> {
    let failed = |error: ExportError| error.to_string();
    document.write(folder.join(format!("{name}.dapple"))).map_err(|error| error.to_string())?;
    for (k, pattern) in patterns.iter().enumerate() {
        let number = if k == 0 { String::new() } else { format!("-{}", k + 1) };
        let path = folder.join(format!("{name}.pattern{number}.png"));
        files::save(&path, |out| gray16(out, pattern, Some(document.dpi))).map_err(failed)?;
    }
    let tables: Vec<Table> = document
        .layers
        .iter()
        .enumerate()
        .map(|(k, layer)| {
            let own = layer.colours.as_ref().map(Colours::gradient);
            own.unwrap_or_else(|| Gradient::default_for_layer(k)).table()
        })
        .collect();
    let layers = patterns.iter().zip(&tables).zip(&document.layers);
    let painted: Vec<Painted> = layers
        .map(|((pattern, table), layer)| Painted {
            ground: None,
            pattern,
            free: None,
            table,
            visible: layer.visible,
        })
        .collect();
    let size = document.size.map(|side| side as usize);
    let rgb = paint(&painted, size[0], size[1]);
    let path = folder.join(format!("{name}.png"));
    files::save(&path, |out| rgb8(out, size, Some(document.dpi), &rgb)).map_err(failed)
}
