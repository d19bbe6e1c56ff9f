//! The points of a variation as a table, as CSV and as charts.

use super::chart::{Axis, AxisScale, Chart, GridMap, Series};
use super::comparison::result_text;
use super::number::duration;
use super::table::{Align, Cell, CellStyle, LineKind, Table};
use crate::case::{QuantityId, StudyValue};
use crate::number::si;
use crate::run::Quantity;
use crate::study::points::{Point, PointOutcome};
use crate::study::vary::{Spacing, Variation, VariedKey};

/// Curves of a chart, at most; a finer grid is drawn as a map.
const MOST_CURVES: usize = 6;

/// A variation with what became of its points and the results of interest.
#[derive(Debug, Clone, Copy)]
pub struct VariationView<'a> {
    /// What was computed.
    pub variation: &'a Variation,
    /// What became of each point; absent for those that did not begin.
    pub outcomes: &'a [Option<PointOutcome>],
    /// The results shown.
    pub results: &'a [QuantityId],
}

/// A point with its number.
struct PointRow<'a> {
    number: usize,
    point: &'a Point,
    outcome: Option<&'a PointOutcome>,
}

impl PointRow<'_> {
    fn result(&self, id: &QuantityId) -> Option<&Quantity> {
        self.outcome?.as_ref().ok()?.result(id)
    }

    /// Why there is no result; none where there is one.
    fn reason(&self) -> Option<(&'static str, String)> {
        match self.outcome {
            None => Some(("STOPPED", "it was stopped before it began".to_owned())),
            Some(Err(why)) => Some(("REFUSED", why.clone())),
            Some(Ok(run)) => run.failure().map(|why| ("FAILED", why.to_owned())),
        }
    }

    fn cpu_s(&self) -> Option<f64> {
        Some(self.outcome?.as_ref().ok()?.info.cost.cpu_s)
    }
}

impl VariationView<'_> {
    fn rows(&self) -> Vec<PointRow<'_>> {
        let points = self.variation.points.iter().enumerate();
        points
            .map(|(index, point)| PointRow {
                number: index + 1,
                point,
                outcome: self.outcomes.get(index).and_then(Option::as_ref),
            })
            .collect()
    }

    /// Whether every point has come to its end.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.rows().iter().all(|row| row.reason().is_none())
    }

    /// A row a point: the values of the keys, the results with their errors, state and CPU time; a note for each point that failed.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows = self.rows();
        let notes = rows
            .iter()
            .filter_map(|row| Some((row.number, row.reason()?.1)));
        let notes: Vec<String> = notes
            .map(|(number, why)| format!("[{number}] {why}"))
            .collect();
        let unestimated = self.unestimated(&rows);
        self.part(&rows, self.results, true)
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
        let fits = |count: &usize| has_columns(&self.part(&rows, &self.results[..*count], true));
        let count = (1..=self.results.len())
            .rev()
            .find(fits)
            .unwrap_or(self.results.len());
        let whole = self.table();
        let parts = self.results.chunks(count.max(1)).enumerate();
        let mut tables: Vec<Table> = parts
            .map(|(place, results)| self.part(&rows, results, place == 0))
            .collect();
        if let Some(last) = tables.last_mut() {
            last.notes = whole.notes;
        }
        tables
    }

    /// The columns of the keys and of some results, with state and CPU time or without.
    fn part(&self, rows: &[PointRow<'_>], results: &[QuantityId], with_state: bool) -> Table {
        let mut table = Table::of("", rows).count("point", |row| row.number);
        for (place, key) in self.variation.keys.iter().enumerate() {
            table = table.cell(&key.path, Align::Decimal, move |row| {
                Cell::plain(setting(key, &row.point.settings[place].value))
            });
        }
        for id in results {
            table = table.cell(&id.to_string(), Align::Decimal, move |row| {
                row.result(id)
                    .map_or_else(Cell::none, |q| Cell::plain(result_text(q)))
            });
        }
        table
            .when(with_state, |table| {
                table
                    .cell("state", Align::Left, state)
                    .cell("CPU time", Align::Right, |row| {
                        row.cpu_s()
                            .map_or_else(Cell::none, |s| Cell::plain(duration(s)))
                    })
            })
            .build()
    }

    /// That errors are not estimated, where they are not.
    fn unestimated(&self, rows: &[PointRow<'_>]) -> Option<&'static str> {
        let mut shown = rows
            .iter()
            .flat_map(|row| self.results.iter().filter_map(|id| row.result(id)));
        let unknown = shown.any(|quantity| quantity.error_estimate().is_none());
        unknown.then_some("± ?: the numerical error was not estimated.")
    }

    /// The same for other programs: every digit, errors in columns of their own, the run's directory, the reason of a failure.
    #[must_use]
    pub fn csv_table(&self) -> Table {
        let rows = self.rows();
        let number = |value: Option<f64>| {
            Cell::plain(value.map_or_else(String::new, |value| value.to_string()))
        };
        let mut table = Table::of("", &rows).count("point", |row| row.number);
        for (place, key) in self.variation.keys.iter().enumerate() {
            table = table.text(&headed(&key.path, key.unit()), move |row| {
                row.point.settings[place].value.to_string()
            });
        }
        for id in self.results {
            let (name, unit) = (id.to_string(), id.unit());
            table = table
                .cell(&headed(&name, &unit), Align::Right, move |row| {
                    number(row.result(id).map(|q| q.value))
                })
                .cell(
                    &headed(&format!("error of {name}"), &unit),
                    Align::Right,
                    move |row| number(row.result(id).and_then(Quantity::error_estimate)),
                );
        }
        table
            .text("state", |row| row.reason().map_or("OK", |(state, _)| state))
            .text("reason", |row| {
                row.reason().map_or_else(String::new, |(_, why)| why)
            })
            .cell("CPU time [s]", Align::Right, move |row| number(row.cpu_s()))
            .text("run", |row| {
                let run = row.outcome.and_then(|outcome| outcome.as_ref().ok());
                let dir = run.and_then(|run| run.dir.as_ref());
                dir.map_or_else(String::new, |dir| dir.display().to_string())
            })
            .build()
    }

    /// A chart for each result: against the key that is varied; of a grid a curve for each value of the second key, or a map where these
    /// are many. Keys that take words have no axis and no chart.
    #[must_use]
    pub fn charts(&self) -> Vec<Chart> {
        let numbers = |key: &VariedKey| key.range.numbers();
        match self.variation.keys.as_slice() {
            [key] => self.each(|id| Some(self.one(key, &numbers(key)?, id))),
            [first, second] if second.range.values.len() <= MOST_CURVES => {
                self.each(|id| Some(self.family(first, second, &numbers(first)?, id)))
            }
            [first, second] => self.each(|id| {
                let grid = (numbers(first)?, numbers(second)?);
                Some(self.map(first, second, grid, id))
            }),
            _ => Vec::new(),
        }
    }

    fn each(&self, chart: impl Fn(&QuantityId) -> Option<Chart>) -> Vec<Chart> {
        let charts = self.results.iter().filter_map(chart);
        charts.filter(|chart| !chart.is_empty()).collect()
    }

    /// The result at a point.
    fn quantity(&self, point: usize, id: &QuantityId) -> Option<&Quantity> {
        self.outcomes
            .get(point)?
            .as_ref()?
            .as_ref()
            .ok()?
            .result(id)
    }

    fn one(&self, key: &VariedKey, values: &[f64], id: &QuantityId) -> Chart {
        let values = values.iter().enumerate();
        let found: Vec<(f64, &Quantity)> = values
            .filter_map(|(point, x)| Some((*x, self.quantity(point, id)?)))
            .collect();
        let mut series = vec![Series::new(
            "result",
            0,
            sorted(found.iter().map(|(x, q)| (*x, q.value))),
        )];
        let bars = found.iter().flat_map(|(x, quantity)| {
            let bar = crate::comparison::error_bar(quantity).unwrap_or([f64::NAN; 2]);
            [(*x, bar[0]), (*x, bar[1]), (*x, f64::NAN)]
        });
        series.push(Series::new("error bars", 1, bars.collect()));
        let unit = id.unit();
        Chart::new(
            format!("{id} against {}", key.path),
            axis(key),
            Axis::new("", &unit),
            series,
        )
    }

    fn family(
        &self,
        first: &VariedKey,
        second: &VariedKey,
        values: &[f64],
        id: &QuantityId,
    ) -> Chart {
        let count = second.range.values.len();
        let curve = |(place, value): (usize, &StudyValue)| {
            let points = values
                .iter()
                .enumerate()
                .filter_map(|(row, x)| Some((*x, self.quantity(row * count + place, id)?.value)));
            Series::new(&setting(second, value), place, sorted(points))
        };
        let series = second.range.values.iter().enumerate().map(curve).collect();
        let title = format!("{id} against {}, by {}", first.path, second.path);
        Chart::new(title, axis(first), Axis::new("", &id.unit()), series)
    }

    fn map(
        &self,
        first: &VariedKey,
        second: &VariedKey,
        (xs, ys): (Vec<f64>, Vec<f64>),
        id: &QuantityId,
    ) -> Chart {
        let (by_x, by_y) = (order(&xs), order(&ys));
        let value = |x: usize, y: usize| {
            let found = self.quantity(x * ys.len() + y, id);
            found.map_or(f64::NAN, |quantity| quantity.value)
        };
        let values = by_x.iter().flat_map(|x| by_y.iter().map(|y| value(*x, *y)));
        let map = GridMap {
            values: values.collect(),
            x: by_x.iter().map(|i| xs[*i]).collect(),
            y: by_y.iter().map(|i| ys[*i]).collect(),
            of: Axis::new(&id.to_string(), &id.unit()),
        };
        let title = format!("{id} against {} and {}", first.path, second.path);
        let (along, up) = (across(first, &map.x), across(second, &map.y));
        Chart {
            map: Some(map),
            ..Chart::new(title, along, up, Vec::new())
        }
    }
}

fn state(row: &PointRow<'_>) -> Cell {
    let warnings = match row.outcome {
        Some(Ok(run)) => run.info.warnings.len(),
        _ => 0,
    };
    match row.reason() {
        Some((state, _)) => Cell::new(format!("{state} [{}]", row.number), CellStyle::Bad),
        None if warnings > 0 => {
            let plural = if warnings == 1 { "" } else { "s" };
            Cell::new(format!("OK, {warnings} warning{plural}"), CellStyle::Warn)
        }
        None => Cell::new("OK", CellStyle::Good),
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
        ..Axis::new(key.field.label, key.unit())
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
