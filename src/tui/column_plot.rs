//! A column of the table of runs against another: a point for each run of the table.

use super::run_cells::{axis_name, cell};
use super::state::run_list::ColumnName;
use super::state::{RunColumn, RunEntry, RunList};
use crate::chart::{self, Axis, AxisScale, Chart, Glyphs, Series};

/// Two columns of the table of runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnPair {
    /// That along the x axis.
    pub x: ColumnName,
    /// That along the y axis.
    pub y: ColumnName,
    /// How x and y are spread.
    pub scales: (AxisScale, AxisScale),
}

impl ColumnPair {
    /// The first result against the first input that differs; other columns of numbers where there are none. Nothing where there are no
    /// two.
    #[must_use]
    pub fn first(runs: &RunList) -> Option<Self> {
        let all = number_columns(runs);
        let input = |column: &&RunColumn| matches!(column, RunColumn::Input(_));
        let x = *all.iter().find(input).or(all.last())?;
        let result = |column: &&RunColumn| matches!(column, RunColumn::Result(_));
        let other = || all.iter().find(|column| **column != x);
        let y = *all.iter().find(result).or_else(other)?;
        let pair = Self {
            x: runs.name_of(x)?,
            y: runs.name_of(y)?,
            scales: Default::default(),
        };
        (x != y).then_some(pair)
    }

    /// The next or the previous column along an axis, around at the end; never that of the other axis.
    #[must_use]
    pub fn stepped(mut self, runs: &RunList, along_x: bool, forward: bool) -> Self {
        let (now, other) = match along_x {
            true => (&mut self.x, &self.y),
            false => (&mut self.y, &self.x),
        };
        let (at, other) = (runs.column_of(now), runs.column_of(other));
        let mut all = number_columns(runs);
        all.retain(|column| Some(*column) != other);
        let count = all.len();
        let next = match all.iter().position(|column| Some(*column) == at) {
            Some(at) if forward => all.get((at + 1) % count),
            Some(at) => all.get((at + count - 1) % count),
            None => all.first(),
        };
        if let Some(next) = next.and_then(|column| runs.name_of(*column)) {
            *now = next;
        }
        self
    }

    /// The columns of these names, x and y; nothing while the table lacks one.
    #[must_use]
    pub fn columns(&self, runs: &RunList) -> Option<[RunColumn; 2]> {
        Some([runs.column_of(&self.x)?, runs.column_of(&self.y)?])
    }

    /// What is drawn, in words.
    #[must_use]
    pub fn title(&self, runs: &RunList) -> String {
        let Some([x, y]) = self.columns(runs) else {
            return "No run of the table has these columns any more".to_owned();
        };
        let (x, y) = (axis(runs, x).label, axis(runs, y).label);
        format!("{y} against {x}")
    }

    /// The chart, with a vertical line for the error of each run.
    #[must_use]
    pub fn chart(&self, runs: &RunList) -> Chart {
        let Some([x, y]) = self.columns(runs) else {
            return Chart::default();
        };
        let points = self.points(runs);
        let line = points.iter().map(|point| (point.x, point.y)).collect();
        let mut series = vec![Series::new("result", 0, line)];
        let bars = points
            .iter()
            .filter_map(|point| Some((point.x, point.bar?)))
            .flat_map(|(x, [least, greatest])| [(x, least), (x, greatest), (x, f64::NAN)]);
        let bars: Vec<(f64, f64)> = bars.collect();
        if !bars.is_empty() {
            series.push(Series::new("error bars", 1, bars));
        }
        let [x, y] = [(x, self.scales.0), (y, self.scales.1)].map(|(column, scale)| Axis {
            scale,
            ..axis(runs, column)
        });
        Chart::new("", x, y, series)
    }

    /// The same with a logarithmic axis where it was linear, and the other way round.
    #[must_use]
    pub fn with_other_scale(mut self, along_x: bool) -> Self {
        let scale = match along_x {
            true => &mut self.scales.0,
            false => &mut self.scales.1,
        };
        *scale = match scale {
            AxisScale::Linear => AxisScale::Log,
            AxisScale::Log => AxisScale::Linear,
        };
        self
    }

    /// How many runs of the table have both values.
    #[must_use]
    pub fn count(&self, runs: &RunList) -> usize {
        self.points(runs).len()
    }

    /// Chart and values as text.
    #[must_use]
    pub fn text(&self, runs: &RunList, width: usize, glyphs: Glyphs) -> String {
        let chart = Chart {
            title: self.title(runs),
            ..self.chart(runs)
        };
        let mut text = chart::draw(&chart, width, 30, glyphs).to_text();
        text.push('\n');
        for point in self.points(runs) {
            let of = |name| {
                let column = runs.column_of(name);
                column.map_or_else(String::new, |column| cell(runs, point.run, column))
            };
            let (x, y) = (of(&self.x), of(&self.y));
            text.push_str(&format!("{x:>14}  {y:>36}  {}\n", point.run.title()));
        }
        text
    }

    /// The runs of the table that have both values, by that along x.
    fn points<'r>(&self, runs: &'r RunList) -> Vec<ChartedRun<'r>> {
        let Some([x, y]) = self.columns(runs) else {
            return Vec::new();
        };
        let rows = runs.rows().iter().map(|at| &runs[*at]);
        let mut points: Vec<ChartedRun> = rows
            .filter_map(|run| {
                Some(ChartedRun {
                    run,
                    x: value(runs, run, x)?,
                    y: value(runs, run, y)?,
                    bar: bar(runs, run, y),
                })
            })
            .collect();
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        points
    }
}

/// A run on the chart.
struct ChartedRun<'a> {
    run: &'a RunEntry,
    x: f64,
    y: f64,
    bar: Option<[f64; 2]>,
}

/// The columns of the table that have a number in any row.
fn number_columns(runs: &RunList) -> Vec<RunColumn> {
    let mut columns = runs.shown_columns().to_vec();
    columns.retain(|column| column.has_numbers());
    let rows = || runs.rows().iter().map(|at| &runs[*at]);
    columns.retain(|column| rows().any(|run| value(runs, run, *column).is_some()));
    columns
}

/// A column of a run as a number.
fn value(runs: &RunList, run: &RunEntry, column: RunColumn) -> Option<f64> {
    let value = match column {
        RunColumn::Input(_) => runs.input(run, column)?.parse().ok(),
        RunColumn::Result(at) => runs.result(run, at).map(|result| result.value),
        RunColumn::Steps => run.cost.map(|(steps, _)| steps as f64),
        RunColumn::Cpu => run.cost.map(|(_, cpu)| cpu),
        _ => None,
    };
    value.filter(|value| value.is_finite())
}

/// The error bar of a result.
fn bar(runs: &RunList, run: &RunEntry, column: RunColumn) -> Option<[f64; 2]> {
    let RunColumn::Result(at) = column else {
        return None;
    };
    let result = runs.result(run, at)?;
    let error = result.error.filter(|error| error.is_finite());
    let around = error.map(|error| [result.value - error, result.value + error]);
    let unsettled = result.unsettled.map(|(least, greatest)| [least, greatest]);
    unsettled.or(around)
}

/// What a column measures, and in which unit.
fn axis(runs: &RunList, column: RunColumn) -> Axis {
    let columns = &runs.columns;
    match column {
        RunColumn::Input(at) => columns.inputs.get(at).map_or_else(Axis::default, |column| {
            let (name, unit) = axis_name(&column.key);
            Axis::new(&name, unit)
        }),
        RunColumn::Result(at) => columns
            .results
            .get(at)
            .map_or_else(Axis::default, |column| {
                let unit = column.values.first().map_or("", |(_, found)| &found.unit);
                Axis::new(&column.name, unit)
            }),
        RunColumn::Cpu => Axis::new("CPU time", "s"),
        _ => Axis::new("steps", ""),
    }
}
