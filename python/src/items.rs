//! Items of data sets.

use crate::arrays::shaped;
use crate::errors::{Failure, error};
use crate::watched::watched;
use dapple::data_set::{self, ItemError, Kind, Settings};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Mutex;

/// A labelled texture. Its arrays are moved out when they are first asked for.
#[pyclass(frozen, module = "dapple")]
pub struct Item {
    #[pyo3(get)]
    index: u64,
    #[pyo3(get)]
    kind: &'static str,
    side: usize,
    made: Mutex<data_set::Item>,
}

impl Item {
    fn with<T>(&self, take: impl FnOnce(&mut data_set::Item) -> T) -> T {
        take(&mut self.made.lock().unwrap_or_else(std::sync::PoisonError::into_inner))
    }
}

#[pymethods]
impl Item {
    fn take_rgb<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shaped(py, self.with(|made| std::mem::take(&mut made.rgb)), [self.side, self.side, 3])
    }

    fn take_labels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shaped(py, self.with(|made| std::mem::take(&mut made.labels)), [self.side, self.side])
    }

    fn take_size<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shaped(py, self.with(|made| std::mem::take(&mut made.asked.size.values)), [self.side, self.side])
    }

    fn take_direction<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shaped(py, self.with(|made| std::mem::take(&mut made.asked.direction.values)), [self.side, self.side])
    }

    /// Columns of the table of marks.
    fn marks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        self.with(|made| {
            let put = |name: String, value: &dyn Fn(&data_set::LabelledMark) -> f64| {
                let values: Vec<f64> = made.marks.iter().map(value).collect();
                columns.set_item(name, values.into_pyarray(py))
            };
            put("label".into(), &|mark| f64::from(mark.label))?;
            put("x".into(), &|mark| mark.ellipse.center[0])?;
            put("y".into(), &|mark| mark.ellipse.center[1])?;
            put("whole".into(), &|mark| f64::from(u8::from(mark.whole)))?;
            put("area".into(), &|mark| mark.ellipse.area())?;
            put("aspect".into(), &|mark| mark.ellipse.aspect())?;
            put("angle".into(), &|mark| mark.angle)?;
            put("width".into(), &|mark| mark.width)?;
            let asked = made.marks.first().map_or(Vec::new(), |mark| mark.asked.listed());
            for (attribute, _) in asked {
                let name = format!("asked_{attribute}");
                put(name, &|mark| mark.asked.get(attribute).unwrap_or(f64::NAN))?;
            }
            Ok::<_, PyErr>(())
        })?;
        Ok(columns)
    }

    /// Kind, place and angle of each end and fork.
    fn tips(&self) -> Vec<(&'static str, f64, f64, f64)> {
        self.with(|made| {
            made.tips.iter().map(|tip| (tip.kind.name(), tip.at[0], tip.at[1], tip.angle)).collect()
        })
    }

    /// Kind, document and report, as JSON text.
    fn object_text(&self) -> String {
        self.with(|made| made.object().to_string())
    }
}

/// Item `index` of the data set of a seed.
#[pyfunction]
pub fn item(py: Python<'_>, seed: u64, index: u64, size: u32, kinds: Vec<String>) -> PyResult<Item> {
    let named = |name: &String| {
        let all = Kind::ALL.map(Kind::name).join(", ");
        let message = format!("kinds: found {name:?}; allowed: {all}");
        Kind::named(name).ok_or_else(|| error(&message, Some("kinds")))
    };
    let kinds = kinds.iter().map(named).collect::<PyResult<Vec<_>>>()?;
    let [least, most] = Settings::SIDES;
    if !(least..=most).contains(&size) {
        return Err(error(&format!("size: found {size}; allowed: {least} to {most} px"), Some("size")));
    }
    if kinds.is_empty() {
        return Err(error("kinds: found none; allowed: one or more", Some("kinds")));
    }
    let settings = Settings { seed, side: size, kinds };
    let made = watched(py, None, |watch| data_set::item(&settings, index, watch))?;
    let made = made.map_err(|why| match why {
        ItemError::Cancelled => pyo3::exceptions::PyKeyboardInterrupt::new_err(()),
        failed @ ItemError::Failed { .. } => PyErr::from(Failure::Other(failed.to_string())),
    })?;
    Ok(Item { index, kind: made.kind.name(), side: size as usize, made: Mutex::new(made) })
}
