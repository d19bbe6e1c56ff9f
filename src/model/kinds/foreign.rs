//! What tells a file of another program from a case: its name, its rows of dashes, its top keys.

use std::path::Path;

use super::FileType;

/// Top keys by which a text is known for a design.
const TOP_KEYS: [&str; 8] = [
    "mooring",
    "moorings",
    "array_mooring",
    "components",
    "lineProps",
    "mooring_systems",
    "mooring_line_configs",
    "line_types",
];

/// Whether a file has the name of a YAML or JSON file.
#[must_use]
pub fn is_named_yaml(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default();
    ["yaml", "yml", "json"]
        .iter()
        .any(|one| extension.eq_ignore_ascii_case(one))
}

/// Whether a text is a design by its top keys, whatever the name of its file.
#[must_use]
pub fn is_design(text: &str) -> bool {
    let starts_key = |line: &str| {
        let mut keys = TOP_KEYS.iter();
        keys.any(|key| {
            let rest = line.strip_prefix(key).map(str::trim_start);
            rest.is_some_and(|rest| rest.starts_with(':'))
        })
    };
    let begins = text.trim_start_matches('\u{feff}').trim_start();
    let in_json = || {
        let mut keys = TOP_KEYS.iter();
        keys.any(|key| begins.contains(&format!("\"{key}\"")))
    };
    text.lines().any(starts_key) || begins.starts_with('{') && in_json()
}

/// Whether a text is a file of another program rather than a case: rows of dashes or tables of a design, and no table that cases
/// begin with.
#[must_use]
pub fn is_foreign(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    let lines = || text.lines().map(str::trim_start);
    let is_case = |line: &str| {
        let is_of = |kind: FileType| line.starts_with(&format!("[{}]", kind.table()));
        FileType::ALL.into_iter().any(is_of)
    };
    let has_dashes = lines().any(|line| line.starts_with("---"));
    (has_dashes || is_design(text)) && !lines().any(is_case)
}

/// Whether a file with this text is of another program, by its name or its text.
#[must_use]
pub fn is_foreign_file(path: &Path, text: &str) -> bool {
    is_named_yaml(path) || is_foreign(text)
}
