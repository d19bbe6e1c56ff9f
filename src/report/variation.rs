//! The points of a variation as a table, as CSV and as charts.

mod extremes;
mod head;
mod outcome;
mod system;

pub use outcome::{OutcomeColumn, PointView, ResultView};

use std::ops::Range;

use super::chart::{Axis, AxisScale, Chart, GridMap, Series};
use super::number::duration;
use super::table::{Align, Cell, CellStyle, LineKind, Table};
use seacable_base::number::si;
use seacable_model::case::{Spacing, StudyValue};
use seacable_studies::study::points::StudyPoint;
use seacable_studies::study::vary::{Variation, VariedKey};

/// Curves of a chart, at most; a finer grid is drawn as a map.
const MOST_CURVES: usize = 6;

/// Failed points that are listed.
const MOST_FAILURES: usize = 100;

/// A variation with what became of its points and the results of interest.
#[derive(Debug, Clone)]
pub struct VariationView<'a> {
    variation: &'a Variation,
    /// The results shown.
    results: Vec<OutcomeColumn>,
    /// What became of each point.
    outcomes: Vec<PointView>,
    /// Whether the points are runs, which have a cost and may be stored.
    runs: bool,
}

/// A point with its number.
struct PointRow<'a> {
    number: usize,
    point: &'a StudyPoint,
    outcome: &'a PointView,
}

impl VariationView<'_> {
    fn rows(&self) -> Vec<PointRow<'_>> {
        let points = self.variation.points.iter().enumerate();
        points
            .map(|(index, point)| PointRow {
                number: index + 1,
                point,
                outcome: &self.outcomes[index],
            })
            .collect()
    }

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.outcomes.len()
    }

    /// Whether the points are runs, which may be stored.
    #[must_use]
    pub const fn has_runs(&self) -> bool {
        self.runs
    }

    /// The points that failed and why, up to a hundred; nothing where none did.
    #[must_use]
    pub fn failures(&self) -> Option<Table> {
        let mut rows = self.rows();
        rows.retain(|row| row.outcome.reason.is_some());
        let failed = rows.len();
        rows.truncate(MOST_FAILURES);
        let more = failed - rows.len();
        let table = Table::of_records("Without results", &rows)
            .count("point", |row| row.number)
            .text("state", |row| row.outcome.state())
            .text("reason", |row| {
                let reason = row.outcome.reason.as_ref();
                reason.map(|(_, why)| why.clone()).unwrap_or_default()
            });
        let note = (more > 0).then(|| format!("{more} more failed."));
        (failed > 0).then(|| table.build().noted(note))
    }

    /// Whether every point has come to its end.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.outcomes.iter().all(|point| point.reason.is_none())
    }

    /// A row a point: the values of the keys, the results with their errors, state and CPU time; a note for each point that failed.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows = self.rows();
        let notes = rows.iter().filter_map(|row| {
            let why = &row.outcome.reason.as_ref()?.1;
            Some(format!("[{}] {why}", row.number))
        });
        let notes: Vec<String> = notes.collect();
        let unestimated = self.unestimated();
        self.part(&rows, 0..self.results.len(), true)
            .noted(unestimated)
            .noted(notes)
    }

    /// The same for a width: where not all results fit, the others follow in tables of their own.
    #[must_use]
    pub fn tables(&self, width: usize) -> Vec<Table> {
        let rows = self.rows();
        let has_columns = |table: &Table| {
            let lines = table.layout(width).lines;
            lines.iter().any(|line| line.kind == LineKind::Head)
        };
        let fits = |count: &usize| has_columns(&self.part(&rows, 0..*count, true));
        let count = (1..=self.results.len())
            .rev()
            .find(fits)
            .unwrap_or(self.results.len());
        let whole = self.table();
        let all: Vec<usize> = (0..self.results.len()).collect();
        let parts = all.chunks(count.max(1)).enumerate();
        let mut tables: Vec<Table> = parts
            .map(|(place, part)| self.part(&rows, part[0]..part[0] + part.len(), place == 0))
            .collect();
        if let Some(last) = tables.last_mut() {
            last.notes = whole.notes;
        }
        tables
    }

    /// The columns of the keys and of some results, with state and CPU time or without.
    fn part(&self, rows: &[PointRow<'_>], results: Range<usize>, with_state: bool) -> Table {
        let mut table = Table::of_records("", rows).count("point", |row| row.number);
        for (place, key) in self.variation.keys.iter().enumerate() {
            table = table.cell(&key.path, Align::Decimal, move |row| {
                Cell::plain(setting(key, &row.point.settings[place].value))
            });
        }
        if let Some(probability) = self.variation.probability.as_ref().filter(|_| with_state) {
            table = table.cell("probability", Align::Decimal, move |row| {
                Cell::plain(si(probability[row.number - 1], ""))
            });
        }
        for place in results {
            table = table.cell(&self.results[place].name, Align::Decimal, move |row| {
                let found = row.outcome.result(place);
                found.map_or_else(Cell::none, |found| Cell::plain(found.text.clone()))
            });
        }
        table
            .when(with_state, |table| table.cell("state", Align::Left, state))
            .when(with_state && self.runs, |table| {
                table.cell("CPU time", Align::Right, |row| {
                    let cost = row.outcome.cpu_s;
                    cost.map_or_else(Cell::none, |s| Cell::plain(duration(s)))
                })
            })
            .build()
    }

    /// That errors are not estimated, where they are not.
    fn unestimated(&self) -> Option<&'static str> {
        let mut shown = self.outcomes.iter().flat_map(|point| &point.results);
        let unknown = shown.any(|result| result.as_ref().is_some_and(|result| result.unestimated));
        unknown.then_some("± ?: the numerical error was not estimated.")
    }

    /// The same for other programs: every digit, errors in columns of their own, the run's directory, the reason of a failure.
    #[must_use]
    pub fn csv_table(&self) -> Table {
        self.csv(true)
    }

    /// The same without what the runs cost, which is another at every time.
    #[must_use]
    pub fn results_table(&self) -> Table {
        self.csv(false)
    }

    fn csv(&self, with_cost: bool) -> Table {
        let rows = self.rows();
        let number = |value: Option<f64>| {
            Cell::plain(value.map_or_else(String::new, |value| value.to_string()))
        };
        let mut table = Table::of_records("", &rows).count("point", |row| row.number);
        for (place, key) in self.variation.keys.iter().enumerate() {
            table = table.text(&headed(&key.path, key.unit()), move |row| {
                row.point.settings[place].value.to_string()
            });
        }
        if let Some(probability) = &self.variation.probability {
            table = table.cell("probability", Align::Right, |row| {
                number(probability.get(row.number - 1).copied())
            });
        }
        for (place, result) in self.results.iter().enumerate() {
            let (name, unit) = (&result.name, &result.unit);
            table = table
                .cell(&headed(name, unit), Align::Right, move |row| {
                    number(row.outcome.result(place).map(|found| found.value))
                })
                .cell(
                    &headed(&format!("error of {name}"), unit),
                    Align::Right,
                    move |row| number(row.outcome.result(place).and_then(|found| found.error)),
                );
        }
        table
            .text("state", |row| row.outcome.state())
            .text("reason", |row| {
                let reason = row.outcome.reason.as_ref().map(|(_, why)| why.clone());
                reason
                    .or_else(|| row.outcome.remark.clone())
                    .unwrap_or_default()
            })
            .when(self.runs && with_cost, |table| {
                table.cell("CPU time [s]", Align::Right, move |row| {
                    number(row.outcome.cpu_s)
                })
            })
            .when(self.runs, |table| {
                table.text("run", move |row| {
                    let dir = row.outcome.dir.as_deref().unwrap_or_default();
                    // Results without their cost are the same wherever they are read from.
                    let name = dir.rsplit('/').next().unwrap_or(dir);
                    if with_cost { dir } else { name }.to_owned()
                })
            })
            .build()
    }

    /// A chart for each result: against the key that is varied; of a grid a curve for each value of the second key, or a map where these
    /// are many. Keys that take words have no axis and no chart.
    #[must_use]
    pub fn charts(&self) -> Vec<Chart> {
        let numbers = |key: &VariedKey| key.range.numbers();
        match self.variation.keys.as_slice() {
            _ if !self.variation.is_grid => Vec::new(),
            [key] => self.each(|place| Some(self.one(key, &numbers(key)?, place))),
            [first, second] if second.range.values.len() <= MOST_CURVES => {
                self.each(|place| Some(self.family(first, second, &numbers(first)?, place)))
            }
            [first, second] => self.each(|place| {
                let grid = (numbers(first)?, numbers(second)?);
                Some(self.map(first, second, grid, place))
            }),
            _ => Vec::new(),
        }
    }

    fn each(&self, chart: impl Fn(usize) -> Option<Chart>) -> Vec<Chart> {
        let charts = (0..self.results.len()).filter_map(chart);
        charts.filter(|chart| !chart.is_empty()).collect()
    }

    /// The result at a point.
    fn found(&self, point: usize, place: usize) -> Option<&ResultView> {
        self.outcomes.get(point)?.result(place)
    }

    fn one(&self, key: &VariedKey, values: &[f64], place: usize) -> Chart {
        let values = values.iter().enumerate();
        let found: Vec<(f64, &ResultView)> = values
            .filter_map(|(point, x)| Some((*x, self.found(point, place)?)))
            .collect();
        let mut series = vec![Series::new(
            "result",
            0,
            sorted(found.iter().map(|(x, result)| (*x, result.value))),
        )];
        let bars = found.iter().flat_map(|(x, result)| {
            let bar = result.bar.unwrap_or([f64::NAN; 2]);
            [(*x, bar[0]), (*x, bar[1]), (*x, f64::NAN)]
        });
        if found.iter().any(|(_, result)| result.bar.is_some()) {
            series.push(Series::new("error bars", 1, bars.collect()));
        }
        let of = &self.results[place];
        Chart::new(
            format!("{} against {}", of.name, key.path),
            axis(key),
            Axis::new("", &of.unit),
            series,
        )
    }

    fn family(&self, first: &VariedKey, second: &VariedKey, values: &[f64], of: usize) -> Chart {
        let count = second.range.values.len();
        let curve = |(place, value): (usize, &StudyValue)| {
            let points = values
                .iter()
                .enumerate()
                .filter_map(|(row, x)| Some((*x, self.found(row * count + place, of)?.value)));
            Series::new(&setting(second, value), place, sorted(points))
        };
        let series = second.range.values.iter().enumerate().map(curve).collect();
        let of = &self.results[of];
        let title = format!("{} against {}, by {}", of.name, first.path, second.path);
        Chart::new(title, axis(first), Axis::new("", &of.unit), series)
    }

    fn map(
        &self,
        first: &VariedKey,
        second: &VariedKey,
        (xs, ys): (Vec<f64>, Vec<f64>),
        place: usize,
    ) -> Chart {
        let (by_x, by_y) = (order(&xs), order(&ys));
        let value = |x: usize, y: usize| {
            let found = self.found(x * ys.len() + y, place);
            found.map_or(f64::NAN, |found| found.value)
        };
        let of = &self.results[place];
        let values = by_x.iter().flat_map(|x| by_y.iter().map(|y| value(*x, *y)));
        let map = GridMap {
            values: values.collect(),
            x: by_x.iter().map(|i| xs[*i]).collect(),
            y: by_y.iter().map(|i| ys[*i]).collect(),
            of: Axis::new(&of.name, &of.unit),
        };
        let title = format!("{} against {} and {}", of.name, first.path, second.path);
        let (along, up) = (across(first, &map.x), across(second, &map.y));
        Chart {
            map: Some(map),
            ..Chart::new(title, along, up, Vec::new())
        }
    }
}

fn state(row: &PointRow<'_>) -> Cell {
    match (&row.outcome.reason, &row.outcome.remark) {
        (Some((state, _)), _) => Cell::new(format!("{state} [{}]", row.number), CellStyle::Bad),
        (None, Some(remark)) => Cell::new(format!("OK, {remark}"), CellStyle::Warn),
        (None, None) => Cell::new("OK", CellStyle::Good),
    }
}

/// The value of a key with its unit.
fn setting(key: &VariedKey, value: &StudyValue) -> String {
    match value {
        StudyValue::Number(number) => si(*number, key.unit()),
        StudyValue::Word(word) => word.clone(),
    }
}

/// A name with its unit in brackets.
fn headed(name: &str, unit: &str) -> String {
    match unit {
        "" | "-" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    }
}

fn axis(key: &VariedKey) -> Axis {
    let scale = match key.range.spacing {
        Spacing::Logarithmic => AxisScale::Log,
        Spacing::Linear | Spacing::Listed => AxisScale::Linear,
    };
    Axis {
        scale,
        ..Axis::new(&key.field.in_words(&key.path).0, key.unit())
    }
}

/// The axis of a key on a map: from the least of its values, in increasing order, to the greatest.
fn across(key: &VariedKey, values: &[f64]) -> Axis {
    let ends = values.first().copied().zip(values.last().copied());
    Axis {
        range: ends,
        ..axis(key)
    }
}

fn sorted(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = points.collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The places of values in increasing order.
fn order(values: &[f64]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..values.len()).collect();
    places.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    places
}
