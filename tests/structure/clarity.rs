//! What a reader meets in a search: types that share a name, functions that do not say what they return, functions of many steps.

use std::collections::{BTreeMap, BTreeSet};

use crate::sources::Sources;

/// A function outside of test modules.
pub(crate) struct Function {
    pub(crate) name: String,
    pub(crate) lines: usize,
    /// Its file and first line.
    pub(crate) place: String,
}

/// The names of types that more than one file defines, with those files.
pub(crate) fn shared_names(sources: &Sources) -> Vec<String> {
    let mut files: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for module in &sources.modules {
        let types = module.types.keys().map(String::as_str);
        for name in types.filter(|name| name.starts_with(char::is_uppercase)) {
            files.entry(name).or_default().insert(&module.file);
        }
    }
    let shared = files.into_iter().filter(|(_, files)| files.len() > 1);
    shared
        .map(|(name, files)| format!("  {name}: {}", Vec::from_iter(files).join(", ")))
        .collect()
}

/// All functions, by the layout that rustfmt gives them.
pub(crate) fn functions(sources: &Sources) -> Vec<Function> {
    let files: BTreeSet<&str> = sources.modules.iter().map(|m| m.file.as_str()).collect();
    let each = files
        .into_iter()
        .map(|file| of_file(file, &sources.text(file)));
    each.flatten().collect()
}

fn of_file(file: &str, text: &str) -> Vec<Function> {
    let lines: Vec<&str> = text
        .lines()
        .take_while(|line| line.trim() != "#[cfg(test)]")
        .collect();
    let starts = lines.iter().enumerate();
    let named = starts.filter_map(|(start, line)| Some((start, name_of_function(line)?)));
    named
        .filter_map(|(start, name)| {
            Some(Function {
                name: name.to_owned(),
                lines: length(&lines[start..])?,
                place: format!("{file}:{}", start + 1),
            })
        })
        .collect()
}

/// The name of the function whose declaration a line begins.
fn name_of_function(line: &str) -> Option<&str> {
    let (before, after) = line.split_once("fn ")?;
    let is_declaration = before.split_whitespace().all(|word| {
        ["const", "async", "unsafe"].contains(&word)
            || word.starts_with("pub")
            || word == "in"
            || word.ends_with(')')
    });
    let end = after.find(|c: char| c != '_' && !c.is_alphanumeric())?;
    (is_declaration && end > 0).then(|| &after[..end])
}

/// The lines of the function that begins here, up to the brace below its first letter; nothing without a body.
fn length(lines: &[&str]) -> Option<usize> {
    let indent = lines[0].len() - lines[0].trim_start().len();
    let closing = format!("{}}}", " ".repeat(indent));
    let opened = lines
        .iter()
        .position(|line| line.ends_with(['{', ';', '}']))?;
    match lines[opened] {
        line if line.ends_with('{') => {
            let body = lines[opened..].iter().position(|line| *line == closing)?;
            Some(opened + body + 1)
        }
        line if line.ends_with('}') => Some(opened + 1),
        _ => None,
    }
}
