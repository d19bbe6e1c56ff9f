//! The checks of a file, with the rules of the sets that they name.

use std::collections::BTreeMap;

use crate::case::{Attachment, CheckInputs, CheckKind, Diagnostic, nearest, rule_sets};
use crate::fatigue::curve_file::read_curve;

/// A check with its name, its clause and its kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Its name, with that of its set.
    pub name: String,
    /// Where its limit is printed; empty where nothing is stated.
    pub clause: String,
    /// What it compares.
    pub kind: CheckKind,
    /// Its numbers.
    pub inputs: CheckInputs,
    /// The text of the curve that it names, where that is a file.
    pub curve: Option<String>,
}

/// Why checks cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum CheckError {
    /// A set of rules that cannot be read.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Set(Vec<Diagnostic>),
    /// A rule that its set has not.
    #[error("the set {set} has no rule `{name}`; {remedy}")]
    NoRule {
        /// The set.
        set: String,
        /// The rule.
        name: String,
        /// What would be right.
        remedy: String,
    },
    /// A file that is not carried.
    #[error("the file {0} of a check is not at hand")]
    NoFile(String),
    /// A curve that cannot be read.
    #[error("the curve {file} of a check: {reason}")]
    Curve {
        /// Its file.
        file: String,
        /// Why.
        reason: String,
    },
}

impl Check {
    /// Whether a subject of this name is held to it: one that it names, or a copy NAME@ANGLE of that.
    #[must_use]
    pub fn holds_for(&self, name: &str) -> bool {
        let Some(of) = &self.inputs.of else {
            return true;
        };
        let stem = name.split('@').next().unwrap_or(name);
        of.iter().any(|known| known == name || known == stem)
    }
}

/// The checks of a file, each rule of a set as one.
///
/// # Errors
/// A set or a curve that is not at hand or cannot be read, a rule that a set has not.
pub fn resolved(
    inputs: &[CheckInputs],
    files: &BTreeMap<String, Attachment>,
) -> Result<Vec<Check>, CheckError> {
    let mut checks = Vec::new();
    for given in inputs {
        match (&given.rules, given.kind) {
            (Some(set), _) => checks.extend(of_set(set, given, files)?),
            (None, Some(kind)) => {
                let name = given.name.clone();
                checks.push(one(
                    given,
                    kind,
                    name.unwrap_or_else(|| kind.name().to_owned()),
                    files,
                )?);
            }
            // The checks of the file have refused it.
            (None, None) => {}
        }
    }
    Ok(checks)
}

fn one(
    inputs: &CheckInputs,
    kind: CheckKind,
    name: String,
    files: &BTreeMap<String, Attachment>,
) -> Result<Check, CheckError> {
    let file = inputs.curve.as_ref().filter(|name| name.ends_with(".toml"));
    let curve = file.map(|file| {
        let text = files.get(file).map(|found| found.text.clone());
        let text = text.ok_or_else(|| CheckError::NoFile(file.clone()))?;
        let wrong = |reason: crate::fatigue::curve_file::CurveFileError| CheckError::Curve {
            file: file.clone(),
            reason: reason.to_string(),
        };
        read_curve(&text).map(|_| text).map_err(wrong)
    });
    Ok(Check {
        name,
        clause: inputs.clause.clone().unwrap_or_default(),
        kind,
        inputs: inputs.clone(),
        curve: curve.transpose()?,
    })
}

/// The rules of a set that are asked for, with what the check says of its own.
fn of_set(
    set: &str,
    given: &CheckInputs,
    files: &BTreeMap<String, Attachment>,
) -> Result<Vec<Check>, CheckError> {
    let text = rule_sets::text(set, files).ok_or_else(|| CheckError::NoFile(set.to_owned()))?;
    let rules = rule_sets::parse(text, set).map_err(CheckError::Set)?;
    let names: Vec<&str> = rules
        .checks
        .iter()
        .filter_map(|rule| rule.name.as_deref())
        .collect();
    for name in given.only.iter().flatten() {
        if !names.contains(&name.as_str()) {
            let remedy = match nearest(name, names.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("its rules are {}", names.join(", ")),
            };
            return Err(CheckError::NoRule {
                set: set.to_owned(),
                name: name.clone(),
                remedy,
            });
        }
    }
    let mut checks = Vec::new();
    for rule in &rules.checks {
        let name = rule.name.clone().unwrap_or_default();
        let is_asked = given.only.as_ref().is_none_or(|only| only.contains(&name));
        let (Some(kind), true) = (rule.kind, is_asked) else {
            continue;
        };
        let merged = CheckInputs {
            of: given.of.clone().or_else(|| rule.of.clone()),
            break_load_n: given.break_load_n.or(rule.break_load_n),
            diameter_m: given.diameter_m.or(rule.diameter_m),
            ..rule.clone()
        };
        let set = set.strip_suffix(".toml").unwrap_or(set);
        checks.push(one(&merged, kind, format!("{set} {name}"), files)?);
    }
    Ok(checks)
}
