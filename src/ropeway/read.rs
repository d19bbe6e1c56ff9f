//! From a ropeway file to a ropeway worked out.

use std::path::{Path, PathBuf};

use super::exact::Span;
use super::fields::ROPEWAY;
use super::model::Ropeway;
use super::quantities::NAMES;
use super::work::{Worked, work};
use crate::case::fields::either;
use crate::case::{self, Diagnostic, Finding, Misfit};

/// A ropeway with the text and the file it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The text of the file.
    pub text: String,
    /// The ropeway.
    pub worked: Worked,
    /// The file.
    pub path: PathBuf,
}

/// Whether a file is a ropeway rather than a line case; the two may share a folder.
#[must_use]
pub fn is_ropeway(path: &Path) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    text.lines()
        .any(|line| line.trim_start().starts_with("[ropeway]"))
}

/// Reads, checks and works out a ropeway file.
///
/// # Errors
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary
/// or empty, faults of the TOML syntax, every fault of keys and values, or what cannot be as the file says.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    let text = case::text_of(path, &ROPEWAY).map_err(|diagnostic| vec![diagnostic])?;
    let worked = parse(&text, &path.display().to_string())?;
    Ok(Loaded {
        text,
        worked,
        path: path.to_owned(),
    })
}

/// Checks the text of a ropeway and works it out. `file` is the name the diagnostics carry.
///
/// # Errors
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Worked, Vec<Diagnostic>> {
    let tree = case::said(text, file, &ROPEWAY)?;
    let mut found = case::check_keys(&ROPEWAY, &tree);
    if found.is_empty() {
        let ropeway: Ropeway =
            case::words_of(text).map_err(|finding| case::diagnose(vec![finding], text, file))?;
        let misfits = check(&ropeway);
        found = misfits.iter().map(|misfit| misfit.found(&tree)).collect();
        found.extend(marks(&ropeway, &tree));
        if found.is_empty() {
            return work(&ropeway)
                .map_err(|misfit| case::diagnose(vec![misfit.found(&tree)], text, file));
        }
    }
    found.sort_by_key(|finding| finding.span.start);
    Err(case::diagnose(found, text, file))
}

/// What its words say against each other.
fn check(ropeway: &Ropeway) -> Vec<Misfit> {
    let mut wrong = Vec::new();
    let gap = Span::of(ropeway).gap;
    if gap.rise_m.abs() > 2.0 * gap.span_m {
        wrong.push(Misfit::new(
            &["ship", "height_m"],
            "the rope would be steeper than a ropeway can be",
            "give the ends less difference of height, or a longer span",
        ));
    }
    for (i, published) in ropeway.published.iter().enumerate() {
        let row = element("published", &published.name, i, ropeway);
        wrong.extend(known_quantity(&published.quantity, &row, "published"));
        if published.tolerance_rel.is_none() && published.tolerance_abs.is_none() {
            wrong.push(Misfit::new(
                &["published", &row],
                "has no tolerance",
                "add `tolerance_rel` or `tolerance_abs`",
            ));
        }
    }
    for (i, trend) in ropeway.trend.iter().enumerate() {
        let row = element("trend", &trend.name, i, ropeway);
        wrong.extend(known_quantity(&trend.quantity, &row, "trend"));
    }
    wrong
}

/// The name by which an element of a list is known in key paths.
fn element(list: &str, name: &str, index: usize, ropeway: &Ropeway) -> String {
    let earlier = match list {
        "published" => ropeway.published.iter().take(index).any(|p| p.name == name),
        _ => ropeway.trend.iter().take(index).any(|t| t.name == name),
    };
    if earlier {
        (index + 1).to_string()
    } else {
        name.to_owned()
    }
}

fn known_quantity(quantity: &str, row: &str, list: &str) -> Option<Misfit> {
    if NAMES.iter().any(|known| known.0 == quantity) {
        return None;
    }
    let names: Vec<&str> = NAMES.iter().map(|known| known.0).collect();
    let remedy = match case::nearest(quantity, names.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("give {}", either(&names)),
    };
    let problem = format!("there is no quantity \"{}\"", quantity.escape_default());
    Some(Misfit::new(&[list, row, "quantity"], problem, remedy))
}

/// Marks of keys that the file does not have.
fn marks(ropeway: &Ropeway, tree: &case::Node) -> Vec<Finding> {
    let lost = ropeway.marks.keys().filter(|key| {
        let parts = case::split(key);
        let known = parts.is_some_and(|parts| ROPEWAY.fields_at(&parts).next().is_some());
        !known
    });
    let told = lost.map(|key| {
        let misfit = Misfit::new(
            &["marks", key],
            format!("there is no key `{key}` in a ropeway"),
            "name a key as the file groups them: table, name, key",
        );
        misfit.found(tree)
    });
    told.collect()
}
