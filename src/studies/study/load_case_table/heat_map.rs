//! A result of load cases over two of their axes; the others are reduced by a rule, or held at one of their values.

use super::{LoadCaseAxis, LoadCaseTable, ResultValue};

/// How the load cases of a cell are made one value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Reduction {
    /// Their greatest value.
    #[default]
    Greatest,
    /// Their least value.
    Least,
    /// Their mean, by probability where that is known.
    Mean,
}

impl Reduction {
    /// The rule that suits a result of this name: a least tension or a clearance is judged by its least value.
    #[must_use]
    pub fn suiting(result: &str) -> Self {
        let is_least = [".min", "radius", "clearance"];
        match is_least.iter().any(|word| result.contains(word)) {
            true => Self::Least,
            false => Self::Greatest,
        }
    }

    /// The next rule.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::Greatest => Self::Least,
            Self::Least => Self::Mean,
            Self::Mean => Self::Greatest,
        }
    }

    /// Its word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Greatest => "greatest",
            Self::Least => "least",
            Self::Mean => "mean",
        }
    }
}

/// What a heat map shows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct HeatMapChoice {
    /// The axis across, by its place among those of the table; nothing where there is none.
    pub across: Option<usize>,
    /// The axis down.
    pub down: Option<usize>,
    /// How load cases of a cell are made one value.
    pub reduction: Reduction,
    /// The value at which each axis of the table is held, by its place; nothing: all of its values.
    pub held: Vec<Option<usize>>,
}

/// A result over two axes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct HeatMap {
    /// Cells across.
    pub columns: usize,
    /// Cells down.
    pub rows: usize,
    /// The cells, row by row.
    pub cells: Vec<HeatCell>,
    /// Least and greatest value of the cells; nothing where none has a value.
    pub range: Option<(f64, f64)>,
}

/// The load cases at one value of both axes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct HeatCell {
    /// Its value.
    pub value: Option<f64>,
    /// Its numerical error: that of the load case that gives the value, of a mean the mean of the errors; where that was not estimated the
    /// greatest that another load case of the cell has. Nothing where no error was estimated.
    pub error: Option<f64>,
    /// Whether the error is that of another load case.
    pub error_of_other: bool,
    /// The load case that gives the value, by its place in the list; nothing of a mean.
    pub governing: Option<usize>,
    /// Its load cases, by their places in the list.
    pub load_cases: Vec<usize>,
    /// Load cases that have this result.
    pub known: usize,
    /// Load cases that failed or are refused.
    pub failed: usize,
}

impl HeatMapChoice {
    /// The first two axes that tell seas apart, else those that there are.
    #[must_use]
    pub fn first(table: &LoadCaseTable, result: &str) -> Self {
        let mut places: Vec<usize> = (0..table.axes.len()).collect();
        places.sort_by_key(|place| table.axes[*place].is_of_samples);
        Self {
            across: places.first().copied(),
            down: places.get(1).copied(),
            reduction: Reduction::suiting(result),
            held: vec![None; table.axes.len()],
        }
    }

    /// The axes that are neither across nor down, by their places.
    pub fn others(&self) -> impl Iterator<Item = usize> {
        let shown = [self.across, self.down];
        (0..self.held.len()).filter(move |place| !shown.contains(&Some(*place)))
    }
}

impl HeatMap {
    /// The map of a result with these values at the load cases of a table.
    #[must_use]
    pub fn of_result(
        table: &LoadCaseTable,
        values: &[Option<ResultValue>],
        choice: &HeatMapChoice,
    ) -> Self {
        let axis = |place: Option<usize>| place.and_then(|place| table.axes.get(place));
        let (across, down) = (axis(choice.across), axis(choice.down));
        let count = |axis: Option<&LoadCaseAxis>| axis.map_or(1, |axis| axis.values.len());
        let (columns, rows) = (count(across), count(down));
        let mut cells = vec![HeatCell::default(); columns * rows];
        let others: Vec<usize> = choice.others().collect();
        let is_held = |load_case: usize| {
            let mut held = others
                .iter()
                .filter_map(|place| Some((place, choice.held[*place]?)));
            held.all(|(place, value)| table.axes[*place].place(load_case) == Some(value))
        };
        let at = |axis: Option<&LoadCaseAxis>, load_case| {
            axis.map_or(Some(0), |axis| axis.place(load_case))
        };
        for load_case in (0..table.states.len()).filter(|case| is_held(*case)) {
            let places = at(across, load_case).zip(at(down, load_case));
            let cell = places.and_then(|(x, y)| cells.get_mut(y * columns + x));
            if let Some(cell) = cell {
                cell.load_cases.push(load_case);
            }
        }
        for cell in &mut cells {
            cell.sum_up(table, values, choice.reduction);
        }
        let known = cells.iter().filter_map(|cell| cell.value);
        let range = known.fold(None, |range: Option<(f64, f64)>, value| {
            let (low, high) = range.unwrap_or((value, value));
            Some((low.min(value), high.max(value)))
        });
        Self {
            columns,
            rows,
            cells,
            range,
        }
    }

    /// The cell in a column and a row.
    #[must_use]
    pub fn cell(&self, column: usize, row: usize) -> Option<&HeatCell> {
        let inside = column < self.columns;
        self.cells
            .get(row * self.columns + column)
            .filter(|_| inside)
    }

    /// Where a value lies between the least, 0, and the greatest, 1; the middle where all are the same.
    #[must_use]
    pub fn level(&self, value: f64) -> f64 {
        match self.range {
            Some((low, high)) if high > low => ((value - low) / (high - low)).clamp(0.0, 1.0),
            _ => 0.5,
        }
    }
}

impl HeatCell {
    fn sum_up(
        &mut self,
        table: &LoadCaseTable,
        values: &[Option<ResultValue>],
        reduction: Reduction,
    ) {
        let cases = self.load_cases.iter().copied();
        let found = cases.clone().filter_map(|case| {
            let value = values.get(case).copied().flatten()?;
            value.value.is_finite().then_some((case, value))
        });
        let found: Vec<(usize, ResultValue)> = found.collect();
        let states = cases.filter_map(|case| table.states.get(case));
        self.failed = states.filter(|state| state.reason().is_some()).count();
        self.known = found.len();
        if found.is_empty() {
            return;
        }
        let by_value =
            |a: &&(usize, ResultValue), b: &&(usize, ResultValue)| a.1.value.total_cmp(&b.1.value);
        let one = match reduction {
            Reduction::Greatest => found.iter().max_by(by_value),
            Reduction::Least => found.iter().min_by(by_value),
            Reduction::Mean => None,
        };
        match one {
            Some((case, of)) => {
                (self.value, self.error, self.governing) = (Some(of.value), of.error, Some(*case));
            }
            None => (self.value, self.error) = mean(table, &found),
        }
        if self.error.is_none() {
            let errors = found.iter().filter_map(|(_, of)| of.error);
            self.error = errors.reduce(f64::max);
            self.error_of_other = self.error.is_some();
        }
    }
}

/// The mean, and the mean of the errors, which may all point one way; nothing where one was not estimated.
fn mean(table: &LoadCaseTable, found: &[(usize, ResultValue)]) -> (Option<f64>, Option<f64>) {
    let weight = |case: usize| {
        let known = table.probability.as_ref();
        known.and_then(|all| all.get(case)).copied().unwrap_or(1.0)
    };
    let all: f64 = found.iter().map(|(case, _)| weight(*case)).sum();
    if all <= 0.0 {
        return (None, None);
    }
    let sum = found
        .iter()
        .map(|(case, of)| weight(*case) * of.value)
        .sum::<f64>();
    let errors = found
        .iter()
        .map(|(case, of)| Some(weight(*case) * of.error?));
    let error: Option<f64> = errors.sum();
    (Some(sum / all), error.map(|error| error / all))
}

#[cfg(test)]
mod tests {
    use super::super::{LoadCaseColumn, LoadCaseState};
    use super::*;
    use crate::case::load_cases::{LoadCaseKey, LoadCases};
    use crate::case::{StudyValue, field_at};
    use crate::study::points::BaseCase;
    use crate::study::vary::Variation;

    /// Two heights, two speeds, two seeds; the last load case failed.
    fn table() -> LoadCaseTable {
        let key = |path: &str| LoadCaseKey {
            path: path.to_owned(),
            field: field_at(&path.split('.').collect::<Vec<_>>()).unwrap(),
        };
        let digit = |place: usize, bit: usize| 1.0 + (place >> bit & 1) as f64;
        let row = |place| [2, 1, 0].map(|bit| StudyValue::Number(digit(place, bit)));
        let rows = (0..8).map(|place| row(place).to_vec());
        let load_cases = LoadCases {
            keys: vec![
                key("waves.significant_height_m"),
                key("current.speed_m_per_s"),
                key("waves.seed"),
            ],
            rows: rows.collect(),
            probability: Some(vec![0.1, 0.3, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1]),
        };
        let variation = Variation::of_load_cases(BaseCase::new("", "c.toml"), load_cases);
        let mut states = vec![LoadCaseState::Done; 8];
        states[7] = LoadCaseState::Failed("step 3 did not converge".to_owned());
        let value = |case: i32| ResultValue {
            value: f64::from(case),
            error: (case % 2 == 0).then_some(0.5),
        };
        let mut values: Vec<Option<ResultValue>> = (0..8).map(|case| Some(value(case))).collect();
        values[7] = None;
        LoadCaseTable {
            axes: super::super::axes::axes(&variation),
            columns: vec![LoadCaseColumn {
                name: "tension_n.max".to_owned(),
                unit: "N".to_owned(),
                values,
            }],
            states,
            dirs: vec![None; 8],
            probability: variation.probability,
        }
    }

    #[test]
    fn seeds_are_reduced_by_the_rule() {
        let table = table();
        let values = &table.columns[0].values;
        let mut choice = HeatMapChoice::first(&table, "tension_n.max");
        assert_eq!((choice.across, choice.down), (Some(0), Some(1)));
        assert_eq!(choice.others().collect::<Vec<_>>(), [2]);
        let map = HeatMap::of_result(&table, values, &choice);
        assert_eq!((map.columns, map.rows, map.range), (2, 2, Some((1.0, 6.0))));
        let cell = map.cell(0, 0).unwrap();
        assert_eq!((cell.value, cell.governing), (Some(1.0), Some(1)));
        // Its own error was not estimated.
        assert_eq!((cell.error, cell.error_of_other), (Some(0.5), true));
        assert_eq!(map.cell(1, 0).unwrap().value, Some(5.0));
        let failed = map.cell(1, 1).unwrap();
        assert_eq!(
            (failed.value, failed.known, failed.failed),
            (Some(6.0), 1, 1)
        );
        choice.reduction = Reduction::Mean;
        let map = HeatMap::of_result(&table, values, &choice);
        let mean = map.cell(0, 0).unwrap().value.unwrap();
        assert!((mean - 0.75).abs() < 1e-12);
        choice.reduction = Reduction::Least;
        choice.held[2] = Some(1);
        let map = HeatMap::of_result(&table, values, &choice);
        let cell = map.cell(0, 1).unwrap();
        assert_eq!(
            (cell.value, cell.load_cases.as_slice()),
            (Some(3.0), &[3][..])
        );
        assert_eq!(map.cell(1, 1).unwrap().value, None);
    }

    #[test]
    fn an_axis_that_is_not_shown_makes_one_row() {
        let table = table();
        let choice = HeatMapChoice {
            across: Some(0),
            held: vec![None; 3],
            ..HeatMapChoice::default()
        };
        let map = HeatMap::of_result(&table, &table.columns[0].values, &choice);
        assert_eq!((map.columns, map.rows), (2, 1));
        assert_eq!(map.cells[0].load_cases, [0, 1, 2, 3]);
    }

    #[test]
    fn least_values_are_judged_by_their_least() {
        assert_eq!(Reduction::suiting("tension_n[a|b].min"), Reduction::Least);
        assert_eq!(
            Reduction::suiting("tension_n[a|b].max"),
            Reduction::Greatest
        );
    }
}
