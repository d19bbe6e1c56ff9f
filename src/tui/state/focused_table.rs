//! The table that has the focus, whatever pane it is in, and how the user has it.

use std::borrow::Cow;

use super::AppState;
use super::sweeps::SweepTab;
use crate::pane::PaneId;
use crate::panes::modes::is_narrow;
use crate::report::modes as mode_views;
use crate::table::Table;
use crate::table_pane::TablePane;
use crate::update::parts;

impl AppState {
    /// The table that has the focus, without what the user does to it; nothing where no table has it.
    #[must_use]
    pub fn focused_table(&self) -> Option<Cow<'_, Table>> {
        let table = match self.focus() {
            PaneId::Trials => Cow::Owned(self.trials.as_ref()?.table(self.size.0)),
            PaneId::Modes => match self.modes()?.found.as_ref()? {
                Ok(modes) if is_narrow(self) => Cow::Owned(mode_views::narrow(modes)),
                Ok(modes) => Cow::Owned(mode_views::table(modes)),
                Err(_) => return None,
            },
            PaneId::Validation => {
                let checks = self.document.as_ref()?.kind().checks()?;
                Cow::Borrowed(&checks.table)
            }
            focus @ (PaneId::Tables | PaneId::Nodes) => {
                let document = self.document.as_ref()?;
                let part = parts::of_pane(document, focus)?;
                Cow::Borrowed(&document.parts.last(part)?.table)
            }
            PaneId::Sweep => {
                let view = self.document.as_ref()?.sweeps()?;
                let open = view.open.as_ref()?;
                let verdict = open.verdict.as_ref().filter(|_| open.cell.is_none())?;
                match view.tab {
                    SweepTab::Checks => Cow::Borrowed(&verdict.checks),
                    SweepTab::Seas => Cow::Borrowed(&verdict.seas),
                    SweepTab::Map | SweepTab::LoadCases => return None,
                }
            }
            _ => return None,
        };
        (!table.rows.is_empty()).then_some(table)
    }

    /// How the user has the table that has the focus.
    #[must_use]
    pub fn table_pane(&self) -> Option<&TablePane> {
        match self.focus() {
            PaneId::Trials => Some(&self.trials.as_ref()?.pane),
            PaneId::Modes => Some(&self.modes()?.pane),
            PaneId::Nodes => Some(&self.line()?.nodes_pane),
            PaneId::Validation => Some(&self.document.as_ref()?.checks_pane),
            PaneId::Tables => {
                let document = self.document.as_ref()?;
                document.tables.get(document.tab)
            }
            PaneId::Sweep => {
                let view = self.document.as_ref()?.sweeps()?;
                let open = view.open.as_ref()?;
                match view.tab {
                    SweepTab::Checks => Some(&open.checks_pane),
                    SweepTab::Seas => Some(&open.seas_pane),
                    SweepTab::Map | SweepTab::LoadCases => None,
                }
            }
            _ => None,
        }
    }

    /// The same, to be changed.
    pub fn table_pane_mut(&mut self) -> Option<&mut TablePane> {
        match self.focus() {
            PaneId::Trials => Some(&mut self.trials.as_mut()?.pane),
            PaneId::Modes => Some(&mut self.modes_mut()?.pane),
            PaneId::Nodes => Some(&mut self.line_mut()?.nodes_pane),
            PaneId::Validation => Some(&mut self.document.as_mut()?.checks_pane),
            PaneId::Tables => {
                let document = self.document.as_mut()?;
                document.tables.get_mut(document.tab)
            }
            PaneId::Sweep => {
                let view = self.document.as_mut()?.sweeps_mut()?;
                let tab = view.tab;
                let open = view.open.as_mut()?;
                match tab {
                    SweepTab::Checks => Some(&mut open.checks_pane),
                    SweepTab::Seas => Some(&mut open.seas_pane),
                    SweepTab::Map | SweepTab::LoadCases => None,
                }
            }
            _ => None,
        }
    }
}
