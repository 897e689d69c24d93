//! The table of `dapple learn` as a picture: errors against the number of rows that the lookup used.

mod axis;
mod table;

use std::fmt::Write;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use axis::Axis;
use dapple::files;
use table::{Curve, Panel};

/// What to draw.
#[derive(clap::Args)]
pub struct Args {
    /// The table that `dapple learn -o TABLE.csv` wrote
    #[arg(value_name = "TABLE.csv")]
    table: PathBuf,
    /// Where to write the picture
    #[arg(short, long, value_name = "OUT.svg")]
    output: PathBuf,
}

/// Methods with their colours, which colour-blind readers can distinguish as well (Okabe & Ito, 2008), on white and on
/// black.
const METHODS: [(&str, &str); 4] = [
    ("nearest neighbour", "#cc79a7"),
    ("scale law", "#56b4e9"),
    ("LWR", "#009e73"),
    ("LWR + refinement", "#d55e00"),
];
/// The colour of texts and axes: equally far from white and from black.
const GREY: &str = "#7a7a7a";

/// Size of a panel with its texts, and of the plot inside, px.
const PANEL: [f64; 2] = [240.0, 210.0];
const PLOT: [f64; 2] = [180.0, 140.0];
/// Distance of the plot's corner from the panel's corner, px.
const INSET: [f64; 2] = [46.0, 28.0];
/// Space above all panels, for the legend, and above the panels of a system, for its name, px.
const LEGEND: f64 = 48.0;
const NAME: f64 = 34.0;
/// Width of a number of rows, px.
const NUMBER: f64 = 26.0;

/// Draws the table.
pub fn run(args: &Args) -> Result<bool, String> {
    let shown = |path: &Path| path.display().to_string();
    let text = std::fs::read_to_string(&args.table)
        .map_err(|error| format!("{}: cannot be read: {error}", shown(&args.table)))?;
    let panels = table::panels(&text).map_err(|error| format!("{}, {error}", shown(&args.table)))?;
    files::save(&args.output, |out| Ok(out.write_all(svg(&panels).as_bytes())?))
        .map_err(|error| error.to_string())?;
    Ok(true)
}

/// Panels in rows: those of one system and one kind of error side by side.
fn svg(panels: &[Panel]) -> String {
    let (mut body, mut y, mut most) = (String::new(), LEGEND, 3);
    for row in panels.chunk_by(|a, b| (&a.system, &a.errors) == (&b.system, &b.errors)) {
        let what = match row[0].errors.as_str() {
            "grown" => "random targets that were grown",
            _ => "parameters of rows left out of the training",
        };
        body += &words([8.0, y + 20.0], "start", 14, &format!("{}: {what}", row[0].system));
        y += NAME;
        for (i, panel) in row.iter().enumerate() {
            body += &drawn(panel, [PANEL[0] * i as f64 + INSET[0], y + INSET[1]]);
        }
        most = most.max(row.len());
        y += PANEL[1];
    }
    let width = PANEL[0] * most as f64;
    // Writing to a String cannot fail.
    let mut svg = String::new();
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {y}\" width=\"{width}\" height=\"{y}\" \
         font-family=\"sans-serif\">"
    );
    svg += "<title>Errors against the number of training rows</title>\n";
    svg + &legend() + &body + "</svg>\n"
}

fn legend() -> String {
    let mut svg = String::new();
    let mut x = 8.0;
    for (method, colour) in METHODS {
        svg += &format!("<circle cx=\"{}\" cy=\"16\" r=\"4\" fill=\"{colour}\"/>\n", x + 4.0);
        svg += &words([x + 13.0, 20.0], "start", 12, method);
        x += 30.0 + 6.4 * method.len() as f64;
    }
    let note = "solid: median; dashed: 95th percentile of |error|; x: number of training rows, the last number is all";
    svg + &words([8.0, 38.0], "start", 11, note)
}

/// `text` at a place; `anchor` says which end of the text is at the place.
fn words([x, y]: [f64; 2], anchor: &str, size: u32, text: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" fill=\"{GREY}\">{text}</text>\n"
    )
}

/// One panel; the upper left corner of its plot is at `at`.
fn drawn(panel: &Panel, at: [f64; 2]) -> String {
    let curves = || panel.curves.iter().flat_map(|curve| &curve.points);
    let across = Axis::over(curves().map(|point| point.rows), [at[0], at[0] + PLOT[0]], 0.1);
    let up = Axis::over(curves().flat_map(|point| [point.median, point.p95]), [at[1] + PLOT[1], at[1]], 0.05);
    let mut svg = words([at[0], at[1] - 8.0], "start", 12, &panel.title);
    svg += &format!(
        "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{GREY}\"/>\n",
        at[0], at[1], PLOT[0], PLOT[1]
    );
    for value in up.ticks() {
        let y = up.at(value);
        svg += &format!(
            "<path d=\"M{:.1} {y:.1}h{}\" stroke=\"{GREY}\" stroke-opacity=\"0.35\"/>\n",
            at[0], PLOT[0]
        );
        svg += &words([at[0] - 5.0, y + 4.0], "end", 10, &value.to_string());
    }
    svg += &words([at[0] - 5.0, at[1] + PLOT[1] + 14.0], "end", 10, "rows");
    let rows = panel.rows();
    for (i, &value) in rows.iter().enumerate() {
        // A number is left out where the next one is too close; the dots still show its place.
        let room = rows.get(i + 1).map_or(f64::INFINITY, |next| across.at(*next) - across.at(value));
        if room > NUMBER {
            svg += &words([across.at(value), at[1] + PLOT[1] + 14.0], "middle", 10, &value.to_string());
        }
    }
    for curve in &panel.curves {
        svg += &line(curve, &across, &up);
    }
    svg
}

/// Median and 95th percentile of one method.
fn line(curve: &Curve, across: &Axis, up: &Axis) -> String {
    let known = METHODS.iter().find(|(method, _)| *method == curve.method);
    let colour = known.map_or(GREY, |(_, colour)| colour);
    let place = |rows: f64, value: f64| format!("{:.1},{:.1}", across.at(rows), up.at(value));
    let polyline = |points: Vec<String>, style: &str| {
        format!("<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" {style}/>\n", points.join(" "))
    };
    let points = &curve.points;
    let mut svg = polyline(points.iter().map(|p| place(p.rows, p.median)).collect(), "stroke-width=\"2\"");
    let dashed = "stroke-width=\"1.2\" stroke-dasharray=\"4 3\"";
    svg += &polyline(points.iter().map(|p| place(p.rows, p.p95)).collect(), dashed);
    for point in points {
        let (x, y) = (across.at(point.rows), up.at(point.median));
        svg += &format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"{colour}\"/>\n");
    }
    svg
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "system,errors,method,rows,all,quantity,unit,count,median,p95,median_bound,p95_bound,verdict\n\
        turing-spots,parameters,scale law,30,false,rate,%,9,2.0,5.0,,,\n\
        turing-spots,parameters,scale law,100,false,rate,%,9,2.0,4.0,,,\n\
        turing-spots,parameters,LWR,30,false,rate,%,9,1.0,3.0,,,\n\
        turing-spots,parameters,LWR,100,false,rate,%,9,0.5,2.0,,,\n\
        turing-spots,parameters,LWR,30,false,level,,9,0.00000,0.00000,,,\n\
        turing-spots,grown,LWR,100,true,area,%,9,0.5,2.0,1.5,5,ok\n\
        turing-spots,grown,LWR,100,true,failed,,1,,,,,MISSED\n";

    #[test]
    fn every_method_has_its_lines_in_every_panel() {
        let svg = svg(&table::panels(TABLE).unwrap());
        assert_eq!(svg.matches("<polyline").count(), 2 * 3);
        for word in [
            "turing-spots: parameters of rows left out of the training",
            "rate, %",
            "area, %",
            ">30<",
            ">100<",
            ">LWR<",
        ] {
            assert!(svg.contains(word), "{word} in {svg}");
        }
        assert!(!svg.contains("level") && !svg.contains("failed"), "{svg}");
    }

    #[test]
    fn smaller_errors_lie_lower() {
        let panels = table::panels(TABLE).unwrap();
        let svg = drawn(&panels[0], [0.0, 0.0]);
        let first = |line: &str| -> f64 {
            let points = line.split('"').nth(1).unwrap();
            points.split(' ').next().unwrap().split_once(',').unwrap().1.parse().unwrap()
        };
        let medians: Vec<f64> = svg.lines().filter(|l| l.contains("stroke-width=\"2\"")).map(first).collect();
        assert!(medians[0] < medians[1], "y is down: {medians:?}");
    }

    #[test]
    fn the_picture_is_well_formed() {
        let svg = svg(&table::panels(TABLE).unwrap());
        let open = svg.matches('<').count() - svg.matches("</").count();
        assert_eq!(open, svg.matches("</").count() + svg.matches("/>").count());
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}
