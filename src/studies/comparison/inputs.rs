//! Inputs that differ between cases.

use std::collections::HashMap;

use super::letter;
use crate::case::{Case, Diagnostic, EffectiveInput, effective_inputs};
use crate::kinds::FileType;
use crate::run::Run;
use crate::system::SystemFile;

/// An input that is not the same in all runs.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedInput {
    /// Key path: `line.polyester.length_m`.
    pub path: String,
    /// Unit as shown; empty for words, "-" for pure numbers.
    pub unit: &'static str,
    /// The value in each run; absent where the case of a run has no such key.
    pub values: Vec<Option<InputValue>>,
}

/// The value of an input in one run.
#[derive(Debug, Clone, PartialEq)]
pub struct InputValue {
    /// The value as text, without its unit.
    pub text: String,
    /// True when the case gives it, false when its default holds.
    pub given: bool,
}

/// The inputs that differ, and notes on cases that cannot be read.
pub(super) fn compare(runs: &[&Run]) -> (Vec<ComparedInput>, Vec<String>) {
    let mut notes = Vec::new();
    let mut all = Vec::with_capacity(runs.len());
    for (index, run) in runs.iter().enumerate() {
        match inputs_of(run) {
            Ok(inputs) => all.push(inputs),
            Err(faults) => {
                let first = faults.first();
                let why = first.map_or(String::new(), |d| format!("{}: {}", d.key, d.problem));
                notes.push(format!(
                    "The case of {} cannot be read, so that inputs are not compared: {why}",
                    letter(index)
                ));
            }
        }
    }
    if notes.is_empty() {
        (differing(&all), notes)
    } else {
        (Vec::new(), notes)
    }
}

/// The inputs of a run, of a line case or of a system of lines.
fn inputs_of(run: &Run) -> Result<Vec<EffectiveInput>, Vec<Diagnostic>> {
    let (text, file) = (&run.case_text, &run.info.case_file);
    match FileType::of_text(text) {
        FileType::System => effective_inputs::<SystemFile>(text, file),
        _ => effective_inputs::<Case>(text, file),
    }
}

fn differing(all: &[Vec<EffectiveInput>]) -> Vec<ComparedInput> {
    let by_path = |inputs: &'_ [EffectiveInput]| -> HashMap<String, EffectiveInput> {
        let named = inputs
            .iter()
            .map(|input| (input.path.clone(), input.clone()));
        named.collect()
    };
    let maps: Vec<_> = all.iter().map(|inputs| by_path(inputs)).collect();
    let mut list = Vec::new();
    for (run, inputs) in all.iter().enumerate() {
        for input in inputs {
            // Listed with the first run that has it.
            if maps[..run]
                .iter()
                .any(|earlier| earlier.contains_key(&input.path))
            {
                continue;
            }
            let value = |map: &HashMap<String, EffectiveInput>| {
                let found = map.get(&input.path)?;
                Some(InputValue {
                    text: found.value.clone(),
                    given: found.given,
                })
            };
            let values: Vec<Option<InputValue>> = maps.iter().map(value).collect();
            let text = |value: &Option<InputValue>| value.as_ref().map(|v| v.text.clone());
            // Defaults of a table that only some of the cases have say nothing new.
            let is_given = values.iter().flatten().any(|value| value.given);
            if is_given && values.iter().any(|value| text(value) != text(&values[0])) {
                list.push(ComparedInput {
                    path: input.path.clone(),
                    unit: input.unit,
                    values,
                });
            }
        }
    }
    list
}
