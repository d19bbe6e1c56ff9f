//! What the screen shows, remembered and restored.

use super::{ChartsMemory, ScreenMemory, of_tables, tables::RunsMemory};
use crate::bindings::names::{pane_name, pane_of};
use crate::report::figures::FIGURES;
use crate::state::{AppState, Document, Filter};
use std::path::Path;

impl ScreenMemory {
    /// What the screen shows now.
    #[must_use]
    pub fn of_state(state: &AppState) -> Self {
        let list = Self {
            pane: pane_name(state.focus()),
            cases_filter: state.cases.filter.input.value().to_owned(),
            ..Self::default()
        };
        match &state.document {
            None => list,
            Some(document) => Self {
                cases_filter: list.cases_filter,
                ..Self::of_document(document)
            },
        }
    }

    fn of_document(document: &Document) -> Self {
        let editor = &document.editor;
        let field = editor.current_field();
        Self {
            case: Some(std::path::absolute(&editor.path).unwrap_or_else(|_| editor.path.clone())),
            pane: pane_name(document.pane),
            input: field.map_or_else(String::new, |row| row.path.clone()),
            input_filter: editor.filter.input.value().to_owned(),
            folded: editor.folded,
            zoomed: document.zoomed,
            tab: document.tab,
            charts: charts_of(document),
            runs: document
                .runs_view()
                .map(|view| RunsMemory::of_runs(&view.runs)),
            tables: of_tables::memories_of_tables(document),
            ..Self::default()
        }
    }

    /// Whether it is of this file.
    #[must_use]
    pub fn is_of(&self, path: &Path) -> bool {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.case.as_ref() == Some(&path)
    }

    /// Shows the list of cases as it was.
    pub fn restore_list(&self, state: &mut AppState) {
        state.cases.filter = Filter::of_words(&self.cases_filter);
    }

    /// Shows the open file as it was; what there is no more stays as it opens.
    pub fn restore(&self, document: &mut Document) {
        let panes = document.kind().info().panes;
        if let Some(pane) = pane_of(&self.pane).filter(|pane| panes.contains(pane)) {
            document.pane = pane;
        }
        document.zoomed = self.zoomed;
        document.tab = self.tab.min(document.tables.len().saturating_sub(1));
        let editor = &mut document.editor;
        editor.folded = self.folded;
        editor.filter = Filter::of_words(&self.input_filter);
        let place = editor.fields().position(|row| row.path == self.input);
        editor.field = place.unwrap_or(0);
        self.restore_charts(document);
        if let (Some(runs), Some(view)) = (&self.runs, document.runs_view_mut()) {
            runs.restore(&mut view.runs);
        }
        of_tables::restore(&self.tables, document);
    }

    fn restore_charts(&self, document: &mut Document) {
        let (Some(charts), Some(view)) = (&self.charts, document.runs_view_mut()) else {
            return;
        };
        let named = FIGURES.iter().find(|figure| figure.title == charts.chart);
        if let Some(figure) = named.filter(|figure| view.figures.contains(&figure.id)) {
            view.chart = figure.id;
            let range = |range: [f64; 2]| (range[0], range[1]);
            view.views[figure.id.index()].show(charts.x.map(range), charts.y.map(range));
        }
    }
}

fn charts_of(document: &Document) -> Option<ChartsMemory> {
    let view = document.runs_view()?;
    let (x, y) = view.views[view.chart.index()].shown();
    Some(ChartsMemory {
        chart: FIGURES[view.chart.index()].title.to_owned(),
        x: x.map(|(from, to)| [from, to]),
        y: y.map(|(from, to)| [from, to]),
    })
}
