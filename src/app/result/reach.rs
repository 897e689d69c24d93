//! For a region that cannot be reached: the nearest that can, as a change of the sketch.

use crate::attributes::AttributeMap;
use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Spots, Stripes};
use crate::document::{Document, DutyChoice, Stroke, limits};
use crate::editor::shape;
use crate::learn::Answer;
use crate::marks::{Ellipse, Line, Mark, Path, turn};
use crate::synth::Training;
use crate::synth::plan::sketch_targets;
use crate::synth::plan::{Lookup, Targets};

/// Number of attempts, each farther beyond the limit than the one before.
const TRIES: i32 = 10;
/// How much farther each attempt goes, as a share of the change.
const FARTHER: f64 = 0.15;
/// How much farther apart than the nearest that can be reached each attempt moves marks that are too near, as a share.
const APART: f64 = 0.01;
/// Distance of marks from the border of their region, px.
const RIM: f64 = 0.5;

/// A change of the sketch after which a region can be reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Indices of strokes in the layer, and the marks that replace them.
    pub marks: Vec<(usize, Mark)>,
    /// The new duty of the layer, where it changes.
    pub duty: Option<f64>,
    /// What changes, in words.
    pub text: String,
}

/// The change after which region `index` of layer `layer` of `document`, planned in `plans`, can be reached; `None` where
/// it can be reached already, or where none was found.
#[must_use]
pub fn reach(
    training: &Training,
    document: &Document,
    plans: &[&Lookup],
    layer: usize,
    index: usize,
) -> Option<Reach> {
    let mut document = document.clone();
    let beneath = layer.checked_sub(1).map(|below| plans[below]);
    let first = plans[layer];
    let place = source(&first.map, index)?;
    let index = first.map.layout().index(place);
    let mut asked = asked_in(first, place);
    let mut answer = first.answers[index].clone();
    let from = Sketch::of_region(&document, layer, first.map.layout(), place)?;
    for attempt in 0..TRIES {
        if answer.notes.iter().all(|note| !note.is_beyond()) {
            let to = Sketch::of_region(&document, layer, first.map.layout(), place)?;
            return (attempt > 0).then(|| to.reach(&from));
        }
        let sketch = Sketch::of_region(&document, layer, first.map.layout(), place)?;
        let farther = 1.0 + FARTHER * f64::from(attempt);
        // Some systems have only one spacing, and beyond it the error grows again.
        let free = first.system.description().free_spacing;
        let apart = if free { 1.0 + APART * f64::from(attempt) } else { 1.0 };
        let by = Farther { change: farther, apart };
        sketch.toward(&asked, &answer, by, first.map.layout(), place)?.write(&mut document, layer);
        let size = document.size.map(f64::from);
        let plan = Targets::read(&document, layer, "", size, beneath).ok()?.look_up(training).ok()?;
        asked = asked_in(&plan, place);
        answer = plan.answers[index].clone();
    }
    None
}

fn asked_in(plan: &Lookup, place: [usize; 2]) -> Attributes {
    plan.map.at(plan.map.layout().center(place))
}

/// The region whose marks set the attributes of region `index`: itself, else the nearest one that has marks.
fn source(map: &AttributeMap, index: usize) -> Option<[usize; 2]> {
    let layout = map.layout();
    let holds = |index: usize| map.region(layout.place(index)).own.is_some();
    let own = if holds(index) { Some(index) } else { layout.nearest(layout.place(index), holds) };
    own.map(|index| layout.place(index))
}

/// How much farther than the nearest attributes that can be reached a change goes.
#[derive(Clone, Copy, Debug)]
struct Farther {
    /// Factor of the change.
    change: f64,
    /// Factor of the distances, where these have to grow.
    apart: f64,
}

/// The marks of one region and the duty of its layer.
#[derive(Clone, Debug, PartialEq)]
struct Sketch {
    marks: Vec<(usize, Mark)>,
    duty: DutyChoice,
}

impl Sketch {
    fn of_region(document: &Document, layer: usize, layout: &RegionGrid, place: [usize; 2]) -> Option<Self> {
        let marks = sketch_targets::marks(document, layer, "").ok()?;
        let inside = |(_, mark): &(usize, Mark)| layout.region_of(mark.center()) == place;
        let duty = document.layers[layer].options.duty;
        Some(Self { marks: marks.into_iter().enumerate().filter(inside).collect(), duty })
    }

    fn write(self, document: &mut Document, layer: usize) {
        let layer = &mut document.layers[layer];
        layer.options.duty = self.duty;
        for (stroke, mark) in self.marks {
            layer.strokes[stroke] = Stroke::from(mark);
        }
    }

    /// Changed from `asked` toward the nearest attributes in `answer`, and `farther`.
    fn toward(
        self,
        asked: &Attributes,
        answer: &Answer,
        farther: Farther,
        layout: &RegionGrid,
        place: [usize; 2],
    ) -> Option<Self> {
        match (asked, &answer.nearest) {
            (Attributes::Spots(asked), Attributes::Spots(to)) => {
                Some(self.spots_toward(asked, to, farther, layout, place))
            }
            (Attributes::Stripes(asked), Attributes::Stripes(to)) => {
                Some(self.lines_toward(asked, to, farther.change))
            }
            _ => None,
        }
    }

    fn spots_toward(
        self,
        asked: &Spots,
        to: &Spots,
        Farther { change: farther, apart: more }: Farther,
        layout: &RegionGrid,
        place: [usize; 2],
    ) -> Self {
        let by = |from: f64, to: f64| libm::pow(to / from, farther);
        let mut area = by(asked.area, to.area);
        let apart = asked.spacing.zip(to.spacing).map_or(1.0, |(from, to)| to / from);
        let apart = if apart > 1.0 { apart * more } else { apart };
        let centers: Vec<[f64; 2]> = self.marks.iter().map(|(_, mark)| mark.center()).collect();
        let reaches: Vec<[f64; 2]> = self.marks.iter().map(|(_, mark)| reach_of(mark, area.sqrt())).collect();
        let moved = spaced(&centers, &reaches, apart, layout, place).unwrap_or_else(|| {
            // No room to move apart: smaller marks have the same density.
            area /= apart * apart;
            centers.clone()
        });
        let by_angle = farther * turn(to.angle, asked.angle);
        let aspect = |own: f64| {
            if to.aspect <= asked.aspect {
                own * by(asked.aspect, to.aspect)
            } else {
                1.0 - (1.0 - own) * by(1.0 - asked.aspect, (1.0 - to.aspect).max(0.0))
            }
        };
        let changed = |((stroke, mark), center): ((usize, Mark), [f64; 2])| match mark {
            Mark::Ellipse(e) => {
                let angle = e.major_angle() + by_angle;
                (
                    stroke,
                    Mark::Ellipse(Ellipse::from_area(
                        center,
                        e.area() * area,
                        aspect(e.aspect()).min(1.0),
                        angle,
                    )),
                )
            }
            Mark::Line(_) | Mark::Path(_) => (stroke, mark),
        };
        Self { marks: self.marks.into_iter().zip(moved).map(changed).collect(), ..self }
    }

    fn lines_toward(self, asked: &Stripes, to: &Stripes, farther: f64) -> Self {
        let width = libm::pow(to.width / asked.width, farther);
        let by_angle = farther * turn(to.angle, asked.angle);
        let duty = match to.wavelength {
            Some(_) if (to.duty() / asked.duty() - 1.0).abs() > 1e-6 => {
                let [low, high] = [limits::DUTY.low, limits::DUTY.high];
                let own = self.duty.given().unwrap_or(asked.duty());
                DutyChoice::Given((own * libm::pow(to.duty() / asked.duty(), farther)).clamp(low, high))
            }
            _ => self.duty,
        };
        let changed = |(stroke, mark)| match mark {
            Mark::Line(line) => {
                let line = Line { width: line.width * width, ..line };
                (stroke, shape::turned(&Mark::Line(line), by_angle, line.center()))
            }
            Mark::Path(path) => {
                let (center, path) = (path.center(), Path { width: path.width * width, ..path });
                (stroke, shape::turned(&Mark::Path(path), by_angle, center))
            }
            Mark::Ellipse(_) => (stroke, mark),
        };
        Self { marks: self.marks.into_iter().map(changed).collect(), duty }
    }

    /// The change from `from`.
    fn reach(self, from: &Self) -> Reach {
        let text = described(from, &self);
        let duty = self.duty.given().filter(|_| self.duty != from.duty);
        Reach { marks: self.marks, duty, text }
    }
}

/// Half the width and height of an ellipse that is scaled by `factor`, px.
fn reach_of(mark: &Mark, factor: f64) -> [f64; 2] {
    let extent = shape::extent([mark]).unwrap_or_default();
    [0, 1].map(|axis| 0.5 * factor * (extent[1][axis] - extent[0][axis]))
}

/// The centres scaled by `by` about the centre of their region; `None` where they do not fit into it. A mark that was whole on
/// the canvas stays so: `reaches` is half the width and height of each.
fn spaced(
    centers: &[[f64; 2]],
    reaches: &[[f64; 2]],
    by: f64,
    layout: &RegionGrid,
    place: [usize; 2],
) -> Option<Vec<[f64; 2]>> {
    let midpoint = layout.center(place);
    let mut moved: Vec<[f64; 2]> = centers
        .iter()
        .map(|at| [0, 1].map(|axis| midpoint[axis] + by * (at[axis] - midpoint[axis])))
        .collect();
    for axis in 0..2 {
        let side = layout.size[axis] / layout.grid[axis] as f64;
        let [low, high] = [-0.5, 0.5].map(|half| midpoint[axis] + half * side);
        // How far each centre is from the limit below it, and from the one above it.
        let mut room = [f64::INFINITY; 2];
        for ((before, after), reach) in centers.iter().zip(&moved).zip(reaches) {
            let (before, after, reach) = (before[axis], after[axis], reach[axis]);
            let at_start = if low <= 0.0 { reach.min(before).max(RIM) } else { RIM };
            let at_end =
                if high >= layout.size[axis] { reach.min(layout.size[axis] - before).max(RIM) } else { RIM };
            room = [room[0].min(after - low - at_start), room[1].min(high - at_end - after)];
        }
        if room[0] + room[1] < 0.0 {
            return None;
        }
        let by = (-room[0]).max(0.0) - (-room[1]).max(0.0);
        moved.iter_mut().for_each(|at| at[axis] += by);
    }
    Some(moved)
}

/// What changes, in words with numbers.
fn described(from: &Sketch, to: &Sketch) -> String {
    let mut changes = Vec::new();
    let mut more = |what: &str, [more, less]: [&str; 2], factor: f64| {
        let per_cent = 100.0 * (factor - 1.0).abs();
        // Smaller changes are not visible.
        if per_cent >= 0.5 {
            let word = if factor > 1.0 { more } else { less };
            let digits = usize::from(per_cent < 9.5);
            changes.push(format!("{what} {per_cent:.digits$} % {word}"));
        }
    };
    let mean = |marks: &[(usize, Mark)], of: &dyn Fn(&Mark) -> f64| {
        marks.iter().map(|(_, mark)| of(mark)).sum::<f64>() / marks.len().max(1) as f64
    };
    let factor = |of: &dyn Fn(&Mark) -> f64| mean(&to.marks, of) / mean(&from.marks, of);
    let spots = matches!(from.marks.first(), Some((_, Mark::Ellipse(_))));
    if spots {
        more("areas", ["larger", "smaller"], factor(&|mark| mark.ellipse().map_or(0.0, |e| e.area())));
        more("shapes", ["rounder", "longer"], factor(&|mark| mark.ellipse().map_or(0.0, |e| e.aspect())));
        more("places", ["farther apart", "nearer together"], extent(&to.marks) / extent(&from.marks));
    } else {
        let width = |mark: &Mark| mark.path().map_or(0.0, |path| path.width);
        more("lines", ["thicker", "thinner"], factor(&width));
    }
    if let Some(duty) = to.duty.given().filter(|_| from.duty != to.duty) {
        changes.push(format!("duty {duty:.2} on the whole layer"));
    }
    if changes.is_empty() { "different directions".to_owned() } else { changes.join(", ") }
}

/// Root mean square distance of the marks from their mean centre, px.
fn extent(marks: &[(usize, Mark)]) -> f64 {
    let n = marks.len().max(1) as f64;
    let midpoint = [0, 1].map(|axis| marks.iter().map(|(_, mark)| mark.center()[axis]).sum::<f64>() / n);
    let far = |(_, mark): &(usize, Mark)| {
        let center = mark.center();
        (0..2).map(|axis| (center[axis] - midpoint[axis]) * (center[axis] - midpoint[axis])).sum::<f64>()
    };
    (marks.iter().map(far).sum::<f64>() / n).sqrt().max(1e-9)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::document::{Layer, SystemChoice};
    use crate::rd::System;
    use crate::synth::plan::look_up;

    fn planned_alone(training: &Training, document: &Document) -> Lookup {
        let map = sketch_targets::region_map(document, 0, "").unwrap();
        look_up(training, document.layers[0].wanted_system(), &map).unwrap()
    }

    fn document(strokes: Vec<Stroke>, system: SystemChoice) -> Document {
        let layers = vec![Layer { strokes, system, ..Layer::default() }];
        Document { size: [512, 512], regions: Some([2, 2]), layers, ..Document::default() }
    }

    /// Applies the change for region 0; gives the number of notes before and after.
    fn changed(training: &Training, document: &Document) -> (usize, Option<usize>) {
        let first = planned_alone(training, document);
        let notes = |plan: &Lookup| plan.answers[0].notes.iter().filter(|note| note.is_beyond()).count();
        let before = notes(&first);
        let Some(reach) = reach(training, document, &[&first], 0, 0) else { return (before, None) };
        let mut changed = document.clone();
        if let Some(duty) = reach.duty {
            changed.layers[0].options.duty = DutyChoice::Given(duty);
        }
        for (stroke, mark) in reach.marks {
            changed.layers[0].strokes[stroke] = Stroke::from(mark);
        }
        (before, Some(notes(&planned_alone(training, &changed))))
    }

    fn spots(area: f64, aspect: f64, apart: f64) -> Vec<Stroke> {
        let at = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.866], [1.5, 0.866], [0.0, 1.732]];
        let place = |at: [f64; 2]| at.map(|x| 40.0 + x * apart);
        at.map(|at| Stroke::Ellipse(Ellipse::from_area(place(at), area, aspect, 30.0))).into()
    }

    #[test]
    fn spots_that_are_too_close_are_moved_apart_and_then_reached() {
        let training = Training::default();
        let document = document(spots(500.0, 0.9, 35.0), SystemChoice::Of(System::MEINHARDT_SPOTS));
        let (before, after) = changed(&training, &document);
        assert!(before > 0);
        assert_eq!(after, Some(0));
        let first = planned_alone(&training, &document);
        let reach = reach(&training, &document, &[&first], 0, 0).unwrap();
        assert!(reach.text.contains("% farther apart"), "{}", reach.text);
        // The densest examples are rounder than these, and their areas a little larger.
        for (stroke, mark) in reach.marks {
            let [Some(before), Some(after)] = [document.layers[0].strokes[stroke].mark(), Some(mark)]
                .map(|mark| mark.as_ref().and_then(Mark::ellipse))
            else {
                panic!("an ellipse stays one")
            };
            assert!((after.area() / before.area() - 1.0).abs() < 0.03, "{}", reach.text);
            assert!(after.aspect() > before.aspect(), "{}", reach.text);
        }
    }

    #[test]
    fn spots_that_are_moved_apart_beside_an_edge_stay_on_the_canvas() {
        let layout = RegionGrid { size: [512.0; 2], grid: [1, 1], edges: crate::grid::Edges::Closed };
        let centers = [[20.0, 256.0], [60.0, 256.0], [480.0, 256.0]];
        let moved = spaced(&centers, &[[15.0, 10.0]; 3], 1.03, &layout, [0, 0]).unwrap();
        for (before, after) in [(20.0, moved[0][0]), (480.0, moved[2][0])] {
            assert!((15.0 - 1e-9..=497.0).contains(&after), "{before} {after}");
        }
        assert!((moved[1][0] - moved[0][0] - 1.03 * 40.0).abs() < 1e-9);
        // A mark that reached over the edge may still do so, but no farther.
        let moved =
            spaced(&[[10.0, 256.0], [100.0, 256.0]], &[[15.0, 10.0]; 2], 1.5, &layout, [0, 0]).unwrap();
        assert!(moved[0][0] >= 10.0 - 1e-9, "{moved:?}");
    }

    #[test]
    fn without_room_spots_become_smaller() {
        let training = Training::default();
        let document = document(spots(9000.0, 0.95, 120.0), SystemChoice::Of(System::MEINHARDT_SPOTS));
        let first = planned_alone(&training, &document);
        let reach = reach(&training, &document, &[&first], 0, 0).unwrap();
        assert!(reach.text.contains("smaller"), "{}", reach.text);
        assert_eq!(changed(&training, &document).1, Some(0));
    }

    #[test]
    fn a_duty_that_no_system_has_becomes_one_that_a_system_has() {
        let training = Training::default();
        let line = Line { from: [20.0, 100.0], to: [220.0, 120.0], width: 1.0 };
        let document = document(vec![Stroke::Line(line)], SystemChoice::Auto);
        let (before, after) = changed(&training, &document);
        assert!(before == 0 || after == Some(0), "{before} {after:?}");
    }

    #[test]
    fn a_region_that_can_be_reached_is_not_changed() {
        let training = Training::default();
        let document = document(spots(500.0, 0.8, 60.0), SystemChoice::Of(System::MEINHARDT_SPOTS));
        assert_eq!(changed(&training, &document), (0, None));
    }

    #[test]
    fn a_change_that_narrowly_fails_is_increased() {
        let training = Training::default();
        let document = document(spots(1000.0, 0.2333, 80.0), SystemChoice::Of(System::TURING_SPOTS));
        let (before, after) = changed(&training, &document);
        assert!(before > 0);
        assert_eq!(after, Some(0));
    }

    #[test]
    fn dense_spots_whose_change_ends_just_short_of_the_limit_are_moved_farther_apart() {
        let (area, packing) = (60.0f64, 0.4655);
        let document =
            document(spots(area, 0.828, (area / packing).sqrt()), SystemChoice::Of(System::MEINHARDT_SPOTS));
        assert_eq!(changed(&Training::default(), &document).1, Some(0));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn a_reachable_change_is_found_for_any_spots(
            area in 60.0f64..3000.0,
            aspect in 0.15f64..1.0,
            packing in 0.03f64..0.7,
            turing in any::<bool>(),
        ) {
            let training = Training::default();
            let system = if turing { SystemChoice::Of(System::TURING_SPOTS) } else { SystemChoice::Of(System::MEINHARDT_SPOTS) };
            let apart = (area / packing).sqrt().min(110.0);
            let (before, after) = changed(&training, &document(spots(area, aspect, apart), system));
            prop_assert!(before == 0 || after == Some(0), "{before} {after:?}");
        }
    }
}
