//! The scenes of files that a laboratory measures the program on.

use std::path::PathBuf;

use crate::CommandError;
use crate::cases::{self, NamedCase};
use crate::studied_scene::{StudiedScene, system_of};
use seacable_foreign::import::ImportOptions;
use seacable_model::kinds::FileBytes;

/// A scene of a file that is named.
pub(super) struct NamedScene {
    pub(super) name: String,
    pub(super) text: String,
    pub(super) scene: StudiedScene,
}

/// The scenes named, systems among them; without names, the cases of lines as [`cases::of_lines`].
pub(super) fn scenes(paths: &[PathBuf]) -> Result<Vec<NamedScene>, CommandError> {
    let systems = cases::systems(paths)?;
    let lines = match systems.is_empty() {
        true => cases::of_lines(paths)?,
        false => cases::lines_among(paths)?,
    };
    let of_line = |named: NamedCase| NamedScene {
        name: named.name,
        text: named.text,
        scene: StudiedScene::Line(Box::new(named.case)),
    };
    let mut scenes: Vec<NamedScene> = lines.into_iter().map(of_line).collect();
    for path in &systems {
        let file = FileBytes::read(path);
        let name = path.display().to_string();
        let (scene, text) = system_of(file, &[], &ImportOptions::default())?;
        scenes.push(NamedScene { name, text, scene });
    }
    Ok(scenes)
}
