//! The user's own editor on a file.

use std::path::Path;
use std::process::Command;

use super::case_library;
use super::state::DocumentContent;

/// Runs the editor that `VISUAL` or `EDITOR` names, with its words, else `vi`, until it ends.
///
/// # Errors
/// Why it did not run to a good end, as a sentence.
pub(super) fn run(path: &Path) -> Result<(), String> {
    let named = ["VISUAL", "EDITOR"].into_iter().find_map(|name| {
        let words = std::env::var(name).ok()?;
        (!words.trim().is_empty()).then_some(words)
    });
    let words = named.unwrap_or_else(|| "vi".to_owned());
    let mut parts = words.split_whitespace();
    let program = parts.next().unwrap_or("vi");
    let ended = Command::new(program).args(parts).arg(path).status();
    match ended {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!(
            "The editor `{words}` ended with {status}; the file was not read again."
        )),
        Err(error) => Err(format!(
            "The editor `{words}` cannot be run: {error}. The variable EDITOR names another one."
        )),
    }
}

/// The text of a file of any kind that can be open.
///
/// # Errors
/// All that is wrong with it, with the lines meant.
pub(super) fn read(path: &Path) -> Result<String, String> {
    let read = DocumentContent::read(path).map(|(text, _)| text);
    read.map_err(|all| case_library::story(path, &all))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinds::FileType;

    #[test]
    fn files_of_every_kind_are_read() {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
        for (file, kind) in [
            ("pendulous/manifold.toml", FileType::Line),
            ("umbilical/section.toml", FileType::Section),
            ("ropeway/span_40.toml", FileType::Ropeway),
            ("ship/coupled.toml", FileType::Ship),
        ] {
            let path = cases.join(file);
            assert_eq!(FileType::of(&path), kind, "{file}");
            assert_eq!(read(&path), Ok(std::fs::read_to_string(&path).unwrap()));
        }
    }
}
