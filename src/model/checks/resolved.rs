//! The checks of a file, with the rules of the sets that they name.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::case::{
    Attachment, CarriedText, CheckInputs, CheckKind, Diagnostic, LineQuantity, QuantityId,
    SectionText, Statistic, Subject, nearest, rule_sets,
};
use crate::fatigue::component::FatigueComponent;
use crate::fatigue::curve_file::read_curve;
use crate::fatigue::curve_library::published;
use crate::section::Design;

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
    pub curve: Option<CarriedText>,
    /// The text of the cross-section that it names.
    pub section: Option<CarriedText>,
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

    /// The least value along a line that it holds, by the name of the line, empty of a line by itself; nothing of other checks and lines.
    #[must_use]
    pub fn least_along(&self, line: &str) -> Option<QuantityId> {
        let inputs = &self.inputs;
        let quantity = match self.kind {
            CheckKind::BendRadius => LineQuantity::BendRadius,
            CheckKind::BedClearance if inputs.of.is_some() || inputs.stretch_m.is_some() => {
                LineQuantity::BedClearance
            }
            _ => return None,
        };
        let of = Subject::along(quantity, line);
        let id = QuantityId::new(of, Statistic::Min, inputs.stretch_m);
        self.holds_for(line).then_some(id)
    }

    /// The component of a check of fatigue: its curve with a diameter \[m\] and a breaking load \[N\], unless it states these itself.
    ///
    /// # Errors
    /// A curve that there is not, or one that lacks a number, in words.
    pub fn component(
        &self,
        diameter: Option<f64>,
        strength: Option<f64>,
    ) -> Result<FatigueComponent, String> {
        if let Some(text) = &self.curve {
            let curve = text.parsed((), read_curve);
            let curve = curve.map_err(|error| error.to_string())?;
            return Ok(FatigueComponent::clone(&curve));
        }
        let name = self.inputs.curve.as_deref().unwrap_or_default();
        let curve = published(name);
        let curve = curve.ok_or_else(|| format!("there is no published curve `{name}`"))?;
        let diameter = self.inputs.diameter_m.or(diameter);
        let strength = self.inputs.break_load_n.or(strength);
        let found = curve.component(diameter, strength);
        found.map_err(|error| error.to_string())
    }

    /// The same of a stress in Pa in the place of a tension, for the units of a cross-section.
    ///
    /// # Errors
    /// A curve that there is not, or one that is not of a stress, in words.
    pub fn component_of_stress(&self) -> Result<FatigueComponent, String> {
        // The diameter of a published curve only makes an area, which stress has no need of.
        let component = self.component(Some(1.0), None)?;
        component.of_stress().ok_or_else(|| {
            "the curve is of a tension or of a mean load; stress in units needs one of stress alone"
                .to_owned()
        })
    }

    /// The cross-section that it names; nothing without one.
    ///
    /// # Errors
    /// A file that is no section, in words.
    pub fn design(&self) -> Result<Option<Arc<Design>>, String> {
        let name = self.inputs.section.as_deref().unwrap_or_default();
        let read = |text: &CarriedText| text.design(name);
        let design = self.section.as_ref().map(read).transpose();
        design.map_err(|faults| {
            let faults = faults.iter().map(ToString::to_string);
            faults.collect::<Vec<_>>().join("; ")
        })
    }
}

/// The least values along these lines that the checks of a file hold. A set or a curve that cannot be read is refused where checks are resolved
/// for a verdict.
#[must_use]
pub fn held_along<'a>(
    inputs: &[CheckInputs],
    files: &BTreeMap<String, Attachment>,
    lines: impl IntoIterator<Item = &'a str>,
) -> Vec<QuantityId> {
    let checks = resolved(inputs, files).unwrap_or_default();
    let of = |line: &'a str| {
        checks
            .iter()
            .filter_map(move |check| check.least_along(line))
    };
    lines.into_iter().flat_map(of).collect()
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
        text.parsed((), read_curve).map_err(wrong)?;
        Ok(text)
    });
    let section = inputs.section.as_ref().map(|file| {
        let text = files.get(file).map(|found| found.text.clone());
        text.ok_or_else(|| CheckError::NoFile(file.clone()))
    });
    Ok(Check {
        name,
        clause: inputs.clause.clone().unwrap_or_default(),
        kind,
        inputs: inputs.clone(),
        curve: curve.transpose()?,
        section: section.transpose()?,
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
            along: given.along || rule.along,
            ..rule.clone()
        };
        let set = set.strip_suffix(".toml").unwrap_or(set);
        checks.push(one(&merged, kind, format!("{set} {name}"), files)?);
    }
    Ok(checks)
}
