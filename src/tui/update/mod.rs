//! What each message does to the state. Pure: the world is asked for by [`Effect`]s.

mod cases;
mod charts;
mod edit;
mod enabled;
mod export;
mod file;
mod job_events;
mod jobs;
mod keys;
mod modes;
mod overlay;
mod quit;
mod resume;
mod ropeway;
mod runs;
mod section;
mod ship;
mod studies;
mod text_input;
mod trials;

pub(in crate::tui) use charts::readout_words;
pub(in crate::tui) use edit::can_go;
pub use enabled::enabled;
pub use jobs::joined_label;
pub use overlay::{palette_matches, run_command};
pub(in crate::tui) use runs::reported;

use super::msg::{Effect, Msg};
use super::state::{AppState, ChartKind, Level};

/// Changes the state as the message says, and returns what is to be done outside of it.
pub fn update(state: &mut AppState, msg: Msg) -> Vec<Effect> {
    let mut effects = on(state, msg);
    if let Some(open) = &mut state.open {
        // An edit may take away the chart that was shown.
        let kinds = ChartKind::of(&open.case);
        if !kinds.contains(&open.chart) {
            open.chart = kinds.first().copied().unwrap_or(open.chart);
        }
    }
    effects.extend(modes::follow(state));
    effects
}

fn on(state: &mut AppState, msg: Msg) -> Vec<Effect> {
    match msg {
        Msg::Key(key) => keys::key(state, key),
        Msg::Paste(text) => keys::paste(state, &text),
        Msg::Resize(columns, rows) => {
            state.size = (columns, rows);
            vec![Effect::Repaint]
        }
        Msg::Job(ticket, event) => job_events::event(state, ticket, *event),
        Msg::Edited(read) => edit::edited(state, read),
        Msg::Modes(text, found) => modes::found(state, text, found),
        Msg::TrialProgress(ticket, progress) => trials::progress(state, ticket, *progress),
        Msg::ResumeReady(dir, until, found) => resume::found(state, dir, until, found),
        Msg::Recorded(ticket, curves) => job_events::recorded(state, ticket, &curves),
        Msg::Stored(ticket, dir) => runs::stored(state, ticket, dir),
        Msg::JobFailed(ticket, reason) => job_events::failed(state, ticket, reason),
        Msg::CasesRead(dir, entries) => cases::listed(state, dir, entries),
        Msg::CaseRead(read) => cases::opened(state, *read),
        Msg::FileRead(read) => file::opened(state, *read),
        Msg::ShipComputed(by, sea) => ship::worked(state, &by, sea),
        Msg::CaseRejected(title, text) => cases::rejected(state, title, text),
        Msg::Saved(path, text) => quit::saved(state, path, text),
        Msg::NotSaved(why) => quit::not_saved(state, &why),
        Msg::ChangedOnDisk => quit::changed_on_disk(state),
        Msg::RunsListed(slots) => runs::listed(state, slots),
        Msg::RunRead(dir, run) => runs::read(state, &dir, run),
        Msg::RunDeleted(dir) => runs::deleted(state, &dir),
        Msg::Kept(dir, run) => runs::kept(state, &dir, run),
        Msg::Say(level, text) => {
            state.say(level, text);
            Vec::new()
        }
    }
}

/// Says something of little weight.
fn info(state: &mut AppState, text: impl Into<String>) -> Vec<Effect> {
    state.say(Level::Info, text);
    Vec::new()
}

/// Moves a cursor in a list of so many lines.
fn moved(cursor: usize, by: isize, lines: usize) -> usize {
    cursor
        .saturating_add_signed(by)
        .min(lines.saturating_sub(1))
}
