//! A run of a system in time that is asked for: what the run store, reports, comparisons and the screen know.

use std::sync::Arc;

pub use super::channel_result::STATISTICS;
use super::system_in_time::SystemInTime;
use crate::case::attachments::with_files;
use crate::run::job::Request;
use crate::system::SolvedSystem;

/// A run of a system in time that is asked for.
pub type SystemRequest = Request<SystemInTime>;

/// The run that a file asks for, with the files that it names in its text; nothing of a system at rest.
#[must_use]
pub fn request(
    solved: Arc<SolvedSystem>,
    text: &str,
    file: String,
    overrides: Vec<String>,
) -> Option<SystemRequest> {
    let motion = solved.file.as_run()?.clone();
    let text = with_files(text, &solved.file.files).into_owned();
    Some(Request {
        case: SystemInTime::new(solved, motion),
        text,
        file,
        overrides,
        id: String::new(),
    })
}
