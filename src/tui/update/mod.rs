//! What each message does to the state. Pure: the world is asked for by [`Effect`]s.

mod ask_edit;
pub mod build;
mod cases;
pub mod column_plot;
mod command_line;
pub mod curves;
pub mod earlier;
pub mod edit;
pub mod edit_check;
mod end;
pub mod export;
mod filter;
mod job_events;
mod job_lines;
mod job_processes;
pub mod jobs;
mod keys;
mod line_commands;
pub mod line_types;
mod modes;
pub mod motion;
pub mod notice;
mod overlay;
pub mod pages;
pub mod parts;
mod quit;
mod recovery;
pub mod results;
pub mod resume;
pub mod run_table;
pub mod runs;
pub mod settings;
pub mod ship;
pub mod step_value;
mod studies;
pub mod sweep_view;
pub mod sweeps;
pub mod tables;
mod text_input;
pub mod trials;
pub mod tutorial;
pub mod vary;
mod watch;

pub use jobs::joined_label;
pub use overlay::run_command;

use super::msg::{Effect, Msg};
use super::state::AppState;
use crate::visible;

/// Changes the state as the message says, and returns what is to be done outside of it.
pub fn update(state: &mut AppState, msg: Msg) -> Vec<Effect> {
    let mut effects = match edit_check::hold(state, msg) {
        Ok(effects) => effects,
        Err(msg) => on(state, msg),
    };
    while let Some(msg) = edit_check::released(state) {
        effects.extend(on(state, msg));
    }
    effects.extend(modes::follow(state));
    effects.extend(runs::plan(state));
    effects.extend(parts::follow_checks(state));
    effects.extend(parts::follow(state));
    effects.extend(sweeps::follow(state));
    effects.extend(export::follow_report(state));
    effects.extend(watch::follow(state));
    tutorial::follow(state);
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
        Msg::Coarse(ticket, run) => job_events::coarse(state, ticket, run),
        Msg::Edited(read) => edit::edited(state, read),
        Msg::EditsChecked(answer) => edit_check::checked(state, *answer),
        Msg::Report(of, text) => export::reported(state, &of, text),
        Msg::Modes(text, found) => modes::computed(state, text, found),
        Msg::TrialProgress(ticket, progress) => trials::progress(state, ticket, *progress),
        Msg::ResumeReady(dir, until, found) => resume::found(state, dir, until, found),
        Msg::Recorded(ticket, curves) => job_events::recorded(state, ticket, &curves),
        Msg::Stored(ticket, dir) => runs::stored(state, ticket, dir),
        Msg::Process(msg) => job_processes::told(state, msg),
        Msg::JobFailed(ticket, reason) => job_events::failed(state, ticket, reason),
        Msg::CasesRead(dir, entries) => cases::listed(state, dir, entries),
        Msg::FileRead(read) => cases::opened(state, *read),
        Msg::ShipComputed(by, computed) => {
            ship::computed(state, &by, computed);
            Vec::new()
        }
        Msg::PartMade(key, view) => parts::made(state, *key, view),
        Msg::ValuesChecked(token, table) => parts::compared(state, &token, *table),
        Msg::CaseRejected(file, text) => cases::rejected(state, visible::path(&file), file, text),
        Msg::Saved(path, text) => quit::saved(state, path, text),
        Msg::ChangedOutside(path, text) => watch::changed(state, &path, text),
        Msg::ListChanged(dir) => watch::listed(state, &dir),
        Msg::NotMade(why) => build::new_file::failed(state, why),
        Msg::NotSaved(why) => quit::not_saved(state, &why),
        Msg::ChangedOnDisk => quit::changed_on_disk(state),
        Msg::RunsListed(found) => runs::listed(state, *found),
        Msg::Indexing(progress) => runs::indexing(state, progress),
        Msg::Planned(plan) => runs::planned(state, *plan),
        Msg::Page(title, text, of_study) => pages::opened(state, title, text, of_study),
        Msg::StudyProgress(done, of) => pages::progress(state, done, of),
        Msg::Sweep(msg) => sweeps::told(state, msg),
        Msg::Varied(runs) => vary::begun(state, *runs),
        Msg::RunCase(dir, wanted, text) => run_table::exact_case(state, &dir, wanted, text),
        Msg::RunRead(dir, run) => runs::read(state, &dir, run),
        Msg::RunsDeleted(dirs) => runs::deleted(state, &dirs),
        Msg::Kept(dir, run) => runs::kept(state, &dir, run),
        Msg::SettingsRead(settings) => settings::read(state, *settings),
        Msg::Say(level, text) => {
            state.say(level, text);
            Vec::new()
        }
    }
}
