//! The scene of a file that a study computes: a line, or a system in time or at rest.

use std::sync::Arc;

use super::{
    CommandError,
    cases::{self, EditedFile},
    common_args::CaseArgs,
};
use seacable_foreign::import::ImportOptions;
use seacable_model::case::Case;
use seacable_model::kinds::{FileBytes, FileType};
use seacable_systems::system::{
    SystemFile, at_rest::SystemAtRest, motion::system_in_time::SystemInTime,
};

/// A scene in time or at rest.
pub(super) enum StudiedScene {
    Line(Box<Case>),
    System(SystemInTime),
    AtRest(SystemAtRest),
}

/// The scene of a file with what is set on top of it, and its name.
pub(super) fn scene_of(args: &CaseArgs) -> Result<(String, StudiedScene), CommandError> {
    let file = FileBytes::read(&args.file);
    let name = file.path().display().to_string();
    if file.kind() != FileType::System {
        let loaded = cases::load_set(file, &args.set)?;
        return Ok((loaded.name, StudiedScene::Line(Box::new(loaded.case))));
    }
    let (system, _) = system_of(file, &args.set, &args.import.options())?;
    Ok((name, system))
}

/// The system of a file, in time or at rest, and its text.
pub(super) fn system_of(
    file: FileBytes,
    set: &[String],
    options: &ImportOptions,
) -> Result<(StudiedScene, String), CommandError> {
    let file = EditedFile::<SystemFile>::read(file, set, options)?;
    let text = file.whole_text();
    let solved = file.compute()?.computed;
    let scene = match solved.file.in_time().cloned() {
        Some(motion) => StudiedScene::System(SystemInTime::new(Arc::new(solved), motion)),
        None => StudiedScene::AtRest(SystemAtRest::new(solved.file)),
    };
    Ok((scene, text))
}
