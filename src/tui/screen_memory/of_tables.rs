//! Tables remembered and restored.

use super::tables::{RunsMemory, TableMemory};
use crate::run_cells::plain_head;
use crate::state::run_list::ColumnName;
use crate::state::{Document, DocumentContent, Filter, RunColumn, RunList};
use crate::table_pane::TablePane;

impl TableMemory {
    /// The table as it is; nothing where the user changed nothing.
    fn of_pane(table: &str, pane: &TablePane) -> Option<Self> {
        let sorted = pane.sorted_by();
        let memory = Self {
            table: table.to_owned(),
            filter: pane.filter.input.value().to_owned(),
            sort: sorted.map_or_else(String::new, |(head, _)| head.clone()),
            greatest_first: sorted.is_some_and(|(_, down)| *down),
            hidden: pane.hidden().to_vec(),
        };
        let untouched = Self {
            table: memory.table.clone(),
            ..Self::default()
        };
        (memory != untouched).then_some(memory)
    }

    fn restore(&self, pane: &mut TablePane) {
        pane.filter = Filter::of_words(&self.filter);
        pane.hide_only(self.hidden.clone());
        let sort = (!self.sort.is_empty()).then(|| (self.sort.clone(), self.greatest_first));
        pane.sort_by(sort);
    }
}

/// The tables of a file with their names.
fn panes(document: &mut Document) -> Vec<(String, &mut TablePane)> {
    let names = document.kind().info().tabs;
    let Document {
        tables,
        checks_pane,
        content,
        ..
    } = document;
    let tabs = names.iter().map(|name| format!("tables: {name}"));
    let mut all: Vec<(String, &mut TablePane)> = tabs.zip(tables.iter_mut()).collect();
    all.push(("validation".to_owned(), checks_pane));
    match content {
        DocumentContent::Line(line) => {
            all.push(("nodes".to_owned(), &mut line.nodes_pane));
            all.push(("modes".to_owned(), &mut line.modes.pane));
        }
        DocumentContent::System(system) => {
            all.push(("modes".to_owned(), &mut system.modes.pane));
        }
        _ => {}
    }
    all
}

/// The tables of a file that the user changed.
pub(super) fn memories_of_tables(document: &Document) -> Vec<TableMemory> {
    let names = document.kind().info().tabs;
    let mut all: Vec<Option<TableMemory>> = names
        .iter()
        .zip(&document.tables)
        .map(|(name, pane)| TableMemory::of_pane(&format!("tables: {name}"), pane))
        .collect();
    all.push(TableMemory::of_pane("validation", &document.checks_pane));
    if let Some(line) = document.line() {
        all.push(TableMemory::of_pane("nodes", &line.nodes_pane));
    }
    if let Some(modes) = document.content.modes() {
        all.push(TableMemory::of_pane("modes", &modes.pane));
    }
    all.into_iter().flatten().collect()
}

/// Has the tables of a file as they were.
pub(super) fn restore(memories: &[TableMemory], document: &mut Document) {
    for (name, pane) in panes(document) {
        if let Some(memory) = memories.iter().find(|memory| memory.table == name) {
            memory.restore(pane);
        }
    }
}

impl RunsMemory {
    pub(super) fn of_runs(runs: &RunList) -> Self {
        let wanted = runs.wanted_sort();
        let hidden = runs.hidden.iter().filter_map(|name| word(runs, name));
        Self {
            filter: runs.filter.input.value().to_owned(),
            sort: wanted
                .as_ref()
                .and_then(|(name, _)| word(runs, name))
                .unwrap_or_default(),
            greatest_first: wanted.is_some_and(|(_, down)| down),
            hidden: hidden.collect(),
        }
    }

    pub(super) fn restore(&self, runs: &mut RunList) {
        runs.filter = Filter::of_words(&self.filter);
        runs.hide_only(
            self.hidden
                .iter()
                .filter_map(|word| column(runs, word))
                .collect(),
        );
        let sort = column(runs, &self.sort);
        runs.sort_when_there(sort.map(|name| (name, self.greatest_first)));
        runs.arrange();
    }
}

/// The columns that every table of runs has.
const OTHERS: [RunColumn; 7] = [
    RunColumn::Name,
    RunColumn::State,
    RunColumn::Method,
    RunColumn::Steps,
    RunColumn::Cpu,
    RunColumn::Age,
    RunColumn::Tags,
];

/// A column in the file.
fn word(runs: &RunList, name: &ColumnName) -> Option<String> {
    Some(match name {
        ColumnName::Input(key) => format!("input {key}"),
        ColumnName::Result(name) => format!("result {name}"),
        ColumnName::Other(column) => plain_head(runs, *column),
    })
}

/// The column of a word in the file.
fn column(runs: &RunList, word: &str) -> Option<ColumnName> {
    if let Some(key) = word.strip_prefix("input ") {
        return Some(ColumnName::Input(key.to_owned()));
    }
    if let Some(name) = word.strip_prefix("result ") {
        return Some(ColumnName::Result(name.to_owned()));
    }
    let other = OTHERS
        .into_iter()
        .find(|column| plain_head(runs, *column) == word);
    other.map(ColumnName::Other)
}
