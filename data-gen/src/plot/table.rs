//! The table of `dapple learn`, sorted into panels.

/// The rows of the table about one quantity.
#[derive(Debug)]
pub struct Panel {
    /// The system.
    pub system: String,
    /// `parameters` or `grown`.
    pub errors: String,
    /// The quantity with its unit.
    pub title: String,
    /// The curves, one for each method.
    pub curves: Vec<Curve>,
}

/// The errors of one method.
#[derive(Debug)]
pub struct Curve {
    /// The method.
    pub method: String,
    /// The points, in the order of the number of rows.
    pub points: Vec<Point>,
}

/// The errors with one number of rows.
#[derive(Debug)]
pub struct Point {
    /// The number of training rows.
    pub rows: f64,
    /// Median of the absolute errors.
    pub median: f64,
    /// 95th percentile of the absolute errors.
    pub p95: f64,
}

/// Columns that are read.
const COLUMNS: [&str; 8] = ["system", "errors", "method", "rows", "quantity", "unit", "median", "p95"];

/// The panels of a table, in its order, without quantities whose errors are all 0; or the line and the problem.
pub fn panels(text: &str) -> Result<Vec<Panel>, String> {
    let mut lines = text.lines().zip(1..);
    let header: Vec<&str> = lines.next().map_or(Vec::new(), |(header, _)| header.split(',').collect());
    let mut places = [0; COLUMNS.len()];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        let found = header.iter().position(|name| *name == column);
        *place =
            found.ok_or(format!("line 1: the column '{column}' is missing; `dapple learn -o` writes it"))?;
    }
    let mut panels: Vec<Panel> = Vec::new();
    for (line, number) in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let cell = |column: usize| cells.get(places[column]).copied().unwrap_or_default();
        let [system, errors, method, rows, quantity, unit, median, p95] = std::array::from_fn(cell);
        if median.is_empty() {
            // The row with the number of failures.
            continue;
        }
        let value = |text: &str| {
            let value = text.parse::<f64>().ok().filter(|value| value.is_finite() && *value >= 0.0);
            value.ok_or(format!("line {number}: '{text}' is not a number from 0"))
        };
        let point = Point { rows: value(rows)?, median: value(median)?, p95: value(p95)? };
        let title = if unit.is_empty() { quantity.to_owned() } else { format!("{quantity}, {unit}") };
        let same = |panel: &Panel| panel.system == system && panel.errors == errors && panel.title == title;
        let at = panels.iter().position(same).unwrap_or(panels.len());
        if at == panels.len() {
            let (system, errors) = (system.to_owned(), errors.to_owned());
            panels.push(Panel { system, errors, title, curves: Vec::new() });
        }
        let panel = &mut panels[at];
        match panel.curves.iter_mut().find(|curve| curve.method == method) {
            Some(curve) => curve.points.push(point),
            None => panel.curves.push(Curve { method: method.to_owned(), points: vec![point] }),
        }
    }
    panels.retain(|panel| panel.curves.iter().flat_map(|curve| &curve.points).any(|point| point.p95 > 0.0));
    Ok(panels)
}

impl Panel {
    /// All numbers of rows, once each, the lowest first.
    pub fn rows(&self) -> Vec<f64> {
        let mut rows: Vec<f64> =
            self.curves.iter().flat_map(|curve| &curve.points).map(|point| point.rows).collect();
        rows.sort_by(f64::total_cmp);
        rows.dedup();
        rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_in_a_table_is_reported_with_its_line() {
        assert!(panels("").unwrap_err().contains("line 1: the column 'system' is missing"));
        let header = COLUMNS.join(",");
        let wrong = panels(&format!("{header}\na,parameters,LWR,30,rate,%,x,2\n")).unwrap_err();
        assert_eq!(wrong, "line 2: 'x' is not a number from 0");
        assert!(panels(&format!("{header}\na,parameters,LWR,30,rate,%,1\n")).unwrap_err().contains("line 2"));
    }

    #[test]
    fn lines_are_sorted_into_panels_and_curves() {
        let lines = "a,grown,LWR,30,area,%,1,2\na,grown,LWR,90,area,%,1,2\na,grown,law,30,area,%,1,2\n\
                     a,grown,LWR,30,aspect,,1,2\n";
        let panels = panels(&format!("{}\n{lines}", COLUMNS.join(","))).unwrap();
        let output: Vec<_> = panels.iter().map(|p| (p.title.as_str(), p.curves.len(), p.rows())).collect();
        assert_eq!(output, [("area, %", 2, vec![30.0, 90.0]), ("aspect", 1, vec![30.0])]);
    }
}
