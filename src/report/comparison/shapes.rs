//! The lines of compared runs at a common time: where they are furthest apart, and at the end.

use crate::document::Report;
use seacable_base::number::si;
use seacable_display::chart::{Axis, Chart, LimitLine, ReferenceLine, Series};
use seacable_runs::run::{LineShape, Run};
use seacable_studies::comparison::{common_times, distances, letter, shapes_at};

/// Rows of a chart.
const LINES: usize = 18;

/// What is closer than this is the same place \[m\].
const CLOSE: f64 = 1e-6;

/// Adds the line of each run and that of the first, a chart a time; lines that never part are left out.
pub fn add_shapes(page: &mut Report, runs: &[&Run]) {
    let Some((first, others)) = runs.split_first() else {
        return;
    };
    for (other, index) in others.iter().zip(1..) {
        for moment in moments(first, other) {
            let names = [letter(0), letter(index)];
            page.chart(moment.chart(&names), LINES);
            page.paragraph(&moment.words(&names));
        }
    }
}

/// Two lines at a time.
#[derive(Debug, Clone, PartialEq)]
struct Moment {
    /// The time \[s\]; none at rest.
    time: Option<f64>,
    nodes: [Vec<[f64; 3]>; 2],
    /// Where along the first line \[m\] they are furthest apart, and how far \[m\].
    gap: (f64, f64),
    /// They are nowhere further apart at any other time.
    furthest: bool,
}

impl Moment {
    fn at(a: &Run, b: &Run, shapes: [&[LineShape]; 2], time: f64) -> Option<Self> {
        let [first, second] = shapes_at(shapes[0], shapes[1], time)?;
        let nodes = [first.nodes, second.nodes];
        let apart = distances((&nodes[0], &a.profile().arc), (&nodes[1], &b.profile().arc))?;
        let gap = apart.into_iter().max_by(|x, y| x.1.total_cmp(&y.1))?;
        Some(Self {
            time: (!at_rest(a)).then_some(time),
            nodes,
            gap,
            furthest: false,
        })
    }

    fn chart(&self, names: &[String; 2]) -> Chart {
        // Seen from the side on which more of the line is seen.
        let across = if self.span(1) > self.span(0) { 1 } else { 0 };
        let series = self.nodes.iter().zip(names).enumerate();
        let series = series.map(|(slot, (nodes, name))| {
            let points = nodes.iter().map(|node| (node[across], node[2])).collect();
            Series::new(name, slot, points)
        });
        let time = self.time.map_or_else(
            || "at rest".to_owned(),
            |time| format!("at {}", si(time, "s")),
        );
        Chart {
            limits: vec![ReferenceLine::new(
                "still water",
                LimitLine::Horizontal(0.0),
            )],
            equal_scale: true,
            ..Chart::new(
                format!("Shape of the line {time}: {} and {}", names[0], names[1]),
                Axis::new(["x", "y"][across], "m"),
                Axis::new("z", "m"),
                series.collect(),
            )
        }
    }

    fn span(&self, axis: usize) -> f64 {
        let all = || self.nodes.iter().flatten().map(|node| node[axis]);
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    }

    fn words(&self, names: &[String; 2]) -> String {
        let ever = if self.furthest && self.time.is_some() {
            ", further than at any other stored time"
        } else {
            ""
        };
        format!(
            "{} and {} are up to {} apart{ever}, at arc length {} of {}.",
            names[0],
            names[1],
            si(self.gap.1, "m"),
            si(self.gap.0, "m"),
            names[0]
        )
    }
}

/// The time at which two lines are furthest apart, and the end of the time that both have.
fn moments(a: &Run, b: &Run) -> Vec<Moment> {
    if at_rest(a) != at_rest(b) {
        return Vec::new();
    }
    let shapes = [shapes_of(a), shapes_of(b)];
    let shapes = [&shapes[0][..], &shapes[1][..]];
    let Some((begin, end)) = common_times(shapes[0], shapes[1]) else {
        return Vec::new();
    };
    let at = |time: f64| Moment::at(a, b, shapes, time);
    let stored = shapes.iter().flat_map(|shapes| shapes.iter());
    let times = stored.map(|shape| shape.time);
    let all = times.filter(|time| (begin..=end).contains(time));
    let furthest = all
        .filter_map(at)
        .max_by(|x, y| x.gap.1.total_cmp(&y.gap.1));
    let Some(furthest) = furthest.filter(|moment| moment.gap.1 > CLOSE) else {
        return Vec::new();
    };
    let last = at(end).filter(|last| last.time != furthest.time);
    let furthest = Moment {
        furthest: true,
        ..furthest
    };
    [furthest].into_iter().chain(last).collect()
}

/// Whether a run is a line at rest.
fn at_rest(run: &Run) -> bool {
    run.shapes.is_empty()
}

/// The stored shapes of a run; of a line at rest that of its end.
fn shapes_of(run: &Run) -> Vec<LineShape> {
    if !at_rest(run) {
        return run.shapes.clone();
    }
    let rest = LineShape {
        time: 0.0,
        line: 0,
        nodes: run.profile().nodes.clone(),
        tension: run.profile().tension.clone(),
        ..LineShape::default()
    };
    vec![rest]
}
