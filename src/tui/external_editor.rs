//! The user's own editor on a file.

use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use super::case_library;
use super::state::reading::read_file;

/// Runs the editor that `VISUAL` or `EDITOR` names, with its words, else `vi`, until it ends. A file with faults opens at the first
/// where the editor is known to take a place.
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
    let ended = Command::new(program)
        .args(parts)
        .args(file_words(program, path, first_fault(path)))
        .status();
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

/// Line and column of the first fault of a file, from 1.
fn first_fault(path: &Path) -> Option<(u32, u32)> {
    let faults = read_file(path).err()?;
    let first = faults.first()?;
    Some((first.line, first.column))
}

/// The words by which an editor opens a file, at a place where one is given and the editor is known to take it.
fn file_words(program: &str, path: &Path, place: Option<(u32, u32)>) -> Vec<OsString> {
    let file = path.as_os_str().to_owned();
    let name = Path::new(program).file_name().unwrap_or_default();
    let Some((line, column)) = place else {
        return vec![file];
    };
    let before = |words: String| vec![words.into(), file.clone()];
    let behind = || {
        let mut words = file.clone();
        words.push(format!(":{line}:{column}"));
        words
    };
    match name.to_string_lossy().trim_end_matches(".basic") {
        "vi" | "ex" | "joe" | "ne" | "jed" | "mg" => before(format!("+{line}")),
        "vim" | "nvim" | "view" | "gvim" => before(format!("+call cursor({line},{column})")),
        "nano" | "pico" | "rnano" => before(format!("+{line},{column}")),
        "emacs" | "emacsclient" | "kak" | "micro" => before(format!("+{line}:{column}")),
        "hx" | "helix" | "subl" | "zed" => vec![behind()],
        "code" | "codium" => vec!["--goto".into(), behind()],
        _ => vec![file],
    }
}

/// The text of a file of any kind that can be open.
///
/// # Errors
/// All that is wrong with it, with the lines meant.
pub(super) fn read(path: &Path) -> Result<String, String> {
    let read = read_file(path).map(|(text, _)| text);
    read.map_err(|all| case_library::story(&all))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinds::FileType;

    #[test]
    fn editors_open_a_file_at_its_fault() {
        let words = |program: &str, place: Option<(u32, u32)>| {
            let words = file_words(program, Path::new("a.toml"), place);
            words.join(std::ffi::OsStr::new(" ")).into_string().unwrap()
        };
        let at = Some((21, 12));
        assert_eq!(words("/usr/bin/vi", at), "+21 a.toml");
        assert_eq!(words("vim.basic", at), "+call cursor(21,12) a.toml");
        assert_eq!(words("nano", at), "+21,12 a.toml");
        assert_eq!(words("emacs", at), "+21:12 a.toml");
        assert_eq!(words("hx", at), "a.toml:21:12");
        assert_eq!(words("code", at), "--goto a.toml:21:12");
        assert_eq!(words("my-editor", at), "a.toml");
        assert_eq!(words("vi", None), "a.toml");
    }

    #[test]
    fn files_of_every_kind_are_read() {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        for (file, kind) in [
            ("pendulous/manifold.toml", FileType::Line),
            ("umbilical/section.toml", FileType::Section),
            ("ropeway/span_40.toml", FileType::Ropeway),
            ("ship/coupled.toml", FileType::Ship),
        ] {
            let path = cases.join(file);
            assert_eq!(FileType::of_path(&path), kind, "{file}");
            assert_eq!(read(&path), Ok(std::fs::read_to_string(&path).unwrap()));
        }
    }
}
