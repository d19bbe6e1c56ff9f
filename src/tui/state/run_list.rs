//! The runs of the open case: all of them, which are on the charts, and the table's filter, order and columns.

mod columns;

use std::cmp::Ordering;
use std::collections::HashMap;
use std::ops::Index;
use std::path::{Path, PathBuf};

use super::case_list::Filter;
use super::curves::RunEntry;
use crate::run::index::{MeasuredResult, RunColumns, SyncProgress};
use crate::run_filter::{FilterText, RunFilter};

/// A column of the table of runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunColumn {
    /// Its name.
    Name,
    /// Its state.
    State,
    /// The input of this number among those that differ.
    Input(usize),
    /// The result of this number among those shown.
    Result(usize),
    /// Its method.
    Method,
    /// Time steps.
    Steps,
    /// CPU time.
    Cpu,
    /// When it began.
    Age,
    /// Its tags.
    Tags,
}

impl RunColumn {
    /// Whether its cells are numbers; inputs may have words too.
    #[must_use]
    pub const fn has_numbers(self) -> bool {
        matches!(
            self,
            Self::Input(_) | Self::Result(_) | Self::Steps | Self::Cpu
        )
    }
}

/// A column by its name: its number changes with the runs of the table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ColumnName {
    /// The input of this key.
    Input(String),
    /// The result of this name.
    Result(String),
    /// A column that every table has.
    Other(RunColumn),
}

/// The runs of the open case.
#[derive(Debug, Clone, Default)]
pub struct RunList {
    /// The runs, the oldest first.
    entries: Vec<RunEntry>,
    /// Where each directory is among them.
    places: HashMap<PathBuf, usize>,
    /// Whether they are there: no run has come, gone or changed its directory since.
    placed: bool,
    /// What the words of a filter are looked for in, run by run; empty until it is needed.
    texts: Vec<FilterText>,
    /// Those on the charts, in their order.
    on_charts: Vec<usize>,
    /// How many are marked.
    marked: usize,
    /// Those that pass the filter, in the order of the table.
    rows: Vec<usize>,
    /// The filter that they passed, as typed.
    filtered_by: String,
    /// The columns of the table; whether an input differs takes a look at all runs.
    shown_columns: Vec<RunColumn>,
    /// Whether the first line of the table is the live run.
    has_live: bool,
    /// Cursor in the table; 0 is the live run, where there is one.
    pub cursor: usize,
    /// The filter: words and conditions.
    pub filter: Filter,
    /// The column that sorts, and whether the greatest comes first; absent: oldest first.
    pub sort: Option<(RunColumn, bool)>,
    /// The column that is to sort once it is there, and whether the greatest comes first.
    sort_later: Option<(ColumnName, bool)>,
    /// Columns hidden at the left.
    pub scroll: usize,
    /// The column under the cursor.
    pub column: Option<ColumnName>,
    /// Columns that the user hides.
    pub hidden: Vec<ColumnName>,
    /// Inputs that differ among the runs, and results.
    pub columns: RunColumns,
    /// How far the index is in step with the directories, while it is not.
    pub indexing: Option<SyncProgress>,
}

impl Index<usize> for RunList {
    type Output = RunEntry;

    fn index(&self, at: usize) -> &RunEntry {
        &self.entries[at]
    }
}

impl RunList {
    /// A list without runs, with the columns that every table has; `has_live` where a live run is its first line.
    #[must_use]
    pub fn empty(has_live: bool) -> Self {
        let mut list = Self {
            has_live,
            ..Self::default()
        };
        list.arrange();
        list
    }

    /// Whether the first line of the table is the live run.
    #[must_use]
    pub const fn has_live(&self) -> bool {
        self.has_live
    }

    /// All runs, the oldest first.
    #[must_use]
    pub fn all(&self) -> &[RunEntry] {
        &self.entries
    }

    /// How many runs there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// True when there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The runs of the table, in its order.
    #[must_use]
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// How many lines the table has, the live run among them.
    #[must_use]
    pub fn lines(&self) -> usize {
        self.rows.len() + usize::from(self.has_live)
    }

    /// The row of a line of the table; nothing for the live run.
    #[must_use]
    pub fn row_of(&self, line: usize) -> Option<usize> {
        line.checked_sub(usize::from(self.has_live))
    }

    /// The run under the cursor; nothing for the live run.
    #[must_use]
    pub fn current(&self) -> Option<&RunEntry> {
        Some(&self.entries[self.current_place()?])
    }

    fn current_place(&self) -> Option<usize> {
        self.rows.get(self.row_of(self.cursor)?).copied()
    }

    /// The run under the cursor, to be changed, but for its directory.
    pub fn current_mut(&mut self) -> Option<&mut RunEntry> {
        self.texts.clear();
        let at = self.current_place()?;
        self.entries.get_mut(at)
    }

    /// The runs on the charts, in the order of the list.
    pub fn on_charts(&self) -> impl Iterator<Item = &RunEntry> {
        self.on_charts.iter().map(|at| &self.entries[*at])
    }

    /// The marked runs of the table; the one under the cursor where none is marked. What the filter hides is never among them.
    #[must_use]
    pub fn chosen(&self) -> Vec<&RunEntry> {
        let rows = self.rows.iter().copied().filter(|_| self.any_marked());
        let mut marked: Vec<_> = rows.filter(|at| self.entries[*at].marked).collect();
        if marked.is_empty() {
            return self.current().into_iter().collect();
        }
        marked.sort_unstable();
        marked.iter().map(|at| &self.entries[*at]).collect()
    }

    /// Whether any run is marked, also where the filter hides it.
    #[must_use]
    pub fn any_marked(&self) -> bool {
        self.marked > 0
    }

    /// Marks the run under the cursor, or takes its mark off.
    pub fn turn_mark(&mut self) {
        if let Some(at) = self.current_place() {
            let run = &mut self.entries[at];
            run.marked = !run.marked;
            self.marked = if run.marked {
                self.marked + 1
            } else {
                self.marked.saturating_sub(1)
            };
        }
    }

    /// The run in a directory.
    #[must_use]
    pub fn in_dir(&self, dir: &Path) -> Option<&RunEntry> {
        self.places.get(dir).map(|at| &self.entries[*at])
    }

    /// The run in a directory, to be changed, but for its directory.
    pub fn in_dir_mut(&mut self, dir: &Path) -> Option<&mut RunEntry> {
        let at = *self.places.get(dir)?;
        self.texts.clear();
        self.entries.get_mut(at)
    }

    /// The newest run for which something is so, to be changed.
    pub fn newest_mut(&mut self, so: impl Fn(&RunEntry) -> bool) -> Option<&mut RunEntry> {
        self.forget();
        self.entries.iter_mut().rev().find(|run| so(run))
    }

    /// Adds a run at the end; [`RunList::arrange`] brings the table in step, once for many of them.
    pub fn push(&mut self, run: RunEntry) {
        self.forget();
        self.entries.push(run);
    }

    /// Adds runs at the end.
    pub fn extend(&mut self, runs: impl IntoIterator<Item = RunEntry>) {
        self.forget();
        self.entries.extend(runs);
        self.arrange();
    }

    /// Drops the runs for which nothing is so any more.
    pub fn retain(&mut self, keep: impl FnMut(&RunEntry) -> bool) {
        self.forget();
        self.entries.retain(keep);
        self.arrange();
    }

    /// Changes all runs.
    pub fn change_all(&mut self, change: impl FnMut(&mut RunEntry)) {
        self.forget();
        self.entries.iter_mut().for_each(change);
        self.arrange();
    }

    /// Takes all runs off the charts.
    pub fn hide_all(&mut self) {
        for run in &mut self.entries {
            run.shown = false;
        }
        self.on_charts.clear();
    }

    /// Puts the cursor on the newest run, and shows it also where the filter would not.
    pub fn go_to_newest(&mut self) {
        self.filter = Filter::default();
        self.arrange();
        let newest = self.entries.len().checked_sub(1);
        let row = self.rows.iter().position(|at| Some(*at) == newest);
        self.cursor = row.map_or(0, |row| row + usize::from(self.has_live));
    }

    /// Brings places, charts and table in step with the runs, the filter and the order. The cursor stays on its run.
    pub fn arrange(&mut self) {
        self.filtered_by.clear();
        if !self.placed {
            let runs = self.entries.iter().enumerate();
            let dirs = runs.filter_map(|(at, run)| Some((run.dir.clone()?, at)));
            self.places = dirs.collect();
            self.placed = true;
        }
        self.on_charts.clear();
        let runs = self.entries.iter().enumerate();
        let shown = runs.filter(|(_, run)| run.shown).map(|(at, _)| at);
        self.on_charts.extend(shown);
        self.marked = self.entries.iter().filter(|run| run.marked).count();
        self.filter_rows();
    }

    /// Places and texts are looked for anew when they are needed.
    fn forget(&mut self) {
        self.placed = false;
        self.texts.clear();
    }

    /// Brings the table in step with the filter and the order. The cursor stays on its run.
    pub fn filter_rows(&mut self) {
        let under = self.current_place();
        let typed = self.filter.input.value();
        let filter = RunFilter::new(typed);
        let known = self.texts.len() == self.entries.len();
        let narrows = known && RunFilter::narrows(&self.filtered_by, typed);
        if filter.has_words() && !known {
            self.texts = self.entries.iter().map(FilterText::new).collect();
        }
        let passes = |at: &usize| filter.passes(self, &self.entries[*at], self.texts.get(*at));
        self.rows = match narrows {
            true => self.rows.iter().copied().filter(passes).collect(),
            false => (0..self.entries.len()).filter(passes).collect(),
        };
        typed.clone_into(&mut self.filtered_by);
        self.shown_columns = self.columns_to_show();
        if let Some((column, down)) = self.sort.filter(|_| !narrows) {
            self.order(column, down);
        }
        let row = self.rows.iter().position(|at| Some(*at) == under);
        self.cursor = match row {
            Some(row) => row + usize::from(self.has_live),
            None => self.cursor.min(self.lines().saturating_sub(1)),
        };
    }

    fn order(&mut self, column: RunColumn, down: bool) {
        let mut rows: Vec<(SortKey, usize)> = self
            .rows
            .iter()
            .map(|at| (self.sort_key(&self.entries[*at], column), *at))
            .collect();
        // Without a value last in both directions.
        rows.sort_by(|(a, _), (b, _)| match (a, b) {
            (SortKey::Nothing, SortKey::Nothing) => Ordering::Equal,
            (SortKey::Nothing, _) => Ordering::Greater,
            (_, SortKey::Nothing) => Ordering::Less,
            (a, b) if down => b.compare(a),
            (a, b) => a.compare(b),
        });
        self.rows = rows.into_iter().map(|(_, at)| at).collect();
    }

    fn sort_key(&self, run: &RunEntry, column: RunColumn) -> SortKey {
        let number = SortKey::Number;
        match column {
            RunColumn::Input(_) => self.input(run, column).map_or(SortKey::Nothing, |text| {
                text.parse()
                    .map_or_else(|_| SortKey::Word(text.to_owned()), number)
            }),
            RunColumn::Result(at) => self
                .result(run, at)
                .map_or(SortKey::Nothing, |r| number(r.value)),
            RunColumn::Steps => run
                .cost
                .map_or(SortKey::Nothing, |(steps, _)| number(steps as f64)),
            RunColumn::Cpu => run.cost.map_or(SortKey::Nothing, |(_, cpu)| number(cpu)),
            RunColumn::Name => SortKey::Word(run.title().to_lowercase()),
            RunColumn::State => SortKey::Word(run.state.word().to_owned()),
            RunColumn::Method => SortKey::Word(run.method.clone()),
            RunColumn::Age => SortKey::Word(run.started.clone()),
            RunColumn::Tags => SortKey::Word(run.notes.tags.join(" ")),
        }
    }

    /// The value of an input of a run, as its file writes it.
    #[must_use]
    pub fn input(&self, run: &RunEntry, column: RunColumn) -> Option<&str> {
        let RunColumn::Input(at) = column else {
            return None;
        };
        self.columns.inputs.get(at)?.value_in_run(run.number?)
    }

    /// The value of a result of a run.
    #[must_use]
    pub fn result(&self, run: &RunEntry, at: usize) -> Option<&MeasuredResult> {
        self.columns.results.get(at)?.result_in_run(run.number?)
    }

    /// The columns of the table: inputs that differ among its rows, then results, then the rest.
    #[must_use]
    pub fn shown_columns(&self) -> &[RunColumn] {
        &self.shown_columns
    }

    /// The columns, looked for in all rows.
    fn columns_to_show(&self) -> Vec<RunColumn> {
        let inputs = (0..self.columns.inputs.len()).map(RunColumn::Input);
        let differ = inputs.filter(|column| self.differs(*column));
        let results = (0..self.columns.results.len()).map(RunColumn::Result);
        let rest = [
            RunColumn::Method,
            RunColumn::Steps,
            RunColumn::Cpu,
            RunColumn::Age,
            RunColumn::Tags,
        ];
        let first = [RunColumn::Name, RunColumn::State].into_iter();
        let all = first.chain(differ).chain(results).chain(rest);
        all.filter(|column| !self.hides(*column)).collect()
    }

    /// Whether the user hides a column.
    fn hides(&self, column: RunColumn) -> bool {
        !self.hidden.is_empty()
            && self
                .name_of(column)
                .is_some_and(|name| self.hidden.contains(&name))
    }

    /// Whether an input is not the same in all rows of the table.
    fn differs(&self, column: RunColumn) -> bool {
        let indexed = self.rows.iter().map(|at| &self.entries[*at]);
        let mut values = indexed
            .filter(|run| run.number.is_some())
            .map(|run| self.input(run, column));
        let first = values.next();
        values.any(|value| Some(value) != first)
    }

    /// Takes new columns; the table stays sorted by the column of the same name.
    pub fn take_columns(&mut self, columns: RunColumns) {
        let wanted = self.wanted_sort();
        self.columns = columns;
        self.shown_columns = self.columns_to_show();
        self.sort = None;
        self.sort_when_there(wanted);
    }

    /// The name of a column.
    #[must_use]
    pub fn name_of(&self, column: RunColumn) -> Option<ColumnName> {
        Some(match column {
            RunColumn::Input(at) => ColumnName::Input(self.columns.inputs.get(at)?.key.clone()),
            RunColumn::Result(at) => ColumnName::Result(self.columns.results.get(at)?.name.clone()),
            other => ColumnName::Other(other),
        })
    }

    /// The column of this name, where there is one.
    #[must_use]
    pub fn column_of(&self, name: &ColumnName) -> Option<RunColumn> {
        let (inputs, results) = (&self.columns.inputs, &self.columns.results);
        Some(match name {
            ColumnName::Input(key) => {
                RunColumn::Input(inputs.iter().position(|column| column.key == *key)?)
            }
            ColumnName::Result(name) => {
                RunColumn::Result(results.iter().position(|column| column.name == *name)?)
            }
            ColumnName::Other(column) => *column,
        })
    }
}

/// What a row is sorted by.
#[derive(Debug)]
enum SortKey {
    Nothing,
    Number(f64),
    Word(String),
}

impl SortKey {
    /// Numbers before words.
    fn compare(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => a.total_cmp(b),
            (Self::Number(_), _) => Ordering::Less,
            (_, Self::Number(_)) => Ordering::Greater,
            (Self::Word(a), Self::Word(b)) => a.cmp(b),
            _ => Ordering::Equal,
        }
    }
}
