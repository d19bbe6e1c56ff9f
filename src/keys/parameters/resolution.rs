//! The values of parameters, each computed after those that its expression names.
//!
//! The chain of parameters that wait for others is kept in a list, not on the stack: its length is that of the file's.

use std::collections::{BTreeMap, HashMap};

use super::expression::Expression;
use super::vocabulary::{is_name, is_taken};
use super::{
    super::fields::parameters_table::{PARAMETERS, field},
    UnknownNames, as_data, not_finite, unknown, unreadable,
};
use crate::diagnostic::Finding;
use crate::fields::join;
use crate::tree::{TomlData, TomlEntry, TomlNode};

/// Greatest number of parameters of a circle that a message names.
const MOST_OF_CIRCLE: usize = 20;

/// How far a parameter is known.
#[derive(Debug, Clone)]
enum ParameterProgress {
    /// Not looked at yet.
    New,
    /// Waits for others; one that comes up again depends on itself.
    Waiting,
    Known(f64),
    /// It has no value, which is reported, of itself or of what it depends on.
    Faulty,
}

/// A parameter that waits for those which its expression names.
struct Begun {
    parameter: usize,
    expression: Expression,
    /// The parameters that its expression names, in the order of its names.
    needs: Vec<usize>,
    /// How many of them are known.
    done: usize,
}

/// The parameters of a table, on the way to their values.
pub(super) struct ParameterResolution<'a> {
    entries: &'a [TomlEntry],
    places: HashMap<&'a str, usize>,
    progress: Vec<ParameterProgress>,
    found: Vec<Finding>,
}

impl<'a> ParameterResolution<'a> {
    /// The values of the parameters of a table, and what is wrong with them.
    pub(super) fn values_of_table(table: &'a TomlNode) -> (BTreeMap<String, f64>, Vec<Finding>) {
        let entries = table.entries();
        let keys = entries.iter().map(|entry| entry.key.as_str());
        let mut resolution = Self {
            entries,
            places: keys.zip(0..).collect(),
            progress: vec![ParameterProgress::New; entries.len()],
            found: Vec::new(),
        };
        for parameter in 0..entries.len() {
            resolution.resolve(parameter);
        }
        let values = entries.iter().zip(&resolution.progress);
        let known = values.filter_map(|(entry, progress)| match progress {
            ParameterProgress::Known(value) => Some((entry.key.clone(), *value)),
            _ => None,
        });
        (known.collect(), resolution.found)
    }

    /// Resolves a parameter with all that it depends on.
    fn resolve(&mut self, parameter: usize) {
        let mut chain: Vec<Begun> = Vec::new();
        self.begin(parameter, &mut chain);
        while let Some(last) = chain.last_mut() {
            let Some(needed) = last.needs.get(last.done).copied() else {
                let begun = chain.pop();
                begun.into_iter().for_each(|begun| self.compute(&begun));
                continue;
            };
            match self.progress[needed] {
                ParameterProgress::New => self.begin(needed, &mut chain),
                ParameterProgress::Known(_) => last.done += 1,
                // What it depends on is reported.
                ParameterProgress::Faulty => {
                    self.progress[last.parameter] = ParameterProgress::Faulty;
                    chain.pop();
                }
                ParameterProgress::Waiting => self.report_circle(needed, &chain),
            }
        }
    }

    /// Looks at a parameter: it is known, faulty, or waits at the end of the chain.
    fn begin(&mut self, parameter: usize, chain: &mut Vec<Begun>) {
        if !matches!(self.progress[parameter], ParameterProgress::New) {
            return;
        }
        let entry = &self.entries[parameter];
        let given = match self.expression(entry) {
            Ok(ParameterInput::Number(value)) => Ok(ParameterProgress::Known(value)),
            Ok(ParameterInput::Expression(expression, needs)) => {
                chain.push(Begun {
                    parameter,
                    expression,
                    needs,
                    done: 0,
                });
                Ok(ParameterProgress::Waiting)
            }
            Err(fault) => Err(fault),
        };
        match given {
            Ok(progress) => self.progress[parameter] = progress,
            Err(fault) => self.report(parameter, fault),
        }
    }

    /// The number that a parameter is given, or its expression with the parameters that it names.
    fn expression(&self, entry: &TomlEntry) -> Result<ParameterInput, (String, String)> {
        if !is_name(&entry.key) {
            let problem = match is_taken(&entry.key) {
                true => "is the name of a function or constant",
                false => "cannot be named in an expression",
            };
            let remedy = "give it a name of letters, digits and _, which begins with a letter";
            return Err((problem.to_owned(), remedy.to_owned()));
        }
        let node = &entry.node;
        let Some(text) = node.text() else {
            let value = node.number().map(ParameterInput::Number);
            return value.ok_or_else(|| {
                let is = match node.data {
                    TomlData::Float(value) => format!("{value}"),
                    _ => node.describe().to_owned(),
                };
                let problem = format!("must be a number, and is {is}");
                (
                    problem,
                    "give a number, or an expression in quotes".to_owned(),
                )
            });
        };
        let expression = Expression::read(text).map_err(|fault| unreadable(text, &fault))?;
        let place = |name: &String| {
            let place = self.places.get(name.as_str()).copied();
            place.ok_or_else(|| {
                let all = self.entries.iter().map(|entry| entry.key.as_str());
                unknown(name, all, UnknownNames::after(self.found.len()))
            })
        };
        let needs: Result<Vec<usize>, _> = expression.names().iter().map(place).collect();
        needs.map(|needs| ParameterInput::Expression(expression, needs))
    }

    /// Computes a parameter whose expression names known ones alone.
    fn compute(&mut self, begun: &Begun) {
        let value = |place: &usize| match self.progress[*place] {
            ParameterProgress::Known(value) => value,
            _ => f64::NAN,
        };
        let values: Vec<f64> = begun.needs.iter().map(value).collect();
        let text = self.entries[begun.parameter].node.text();
        let value = begun.expression.value(&values);
        let value = value.map_err(|found| not_finite(text.unwrap_or_default(), &found));
        match value.and_then(|value| as_data(&field(), value)) {
            Ok(TomlData::Float(value)) => {
                self.progress[begun.parameter] = ParameterProgress::Known(value);
            }
            Ok(_) => self.progress[begun.parameter] = ParameterProgress::Faulty,
            Err(fault) => self.report(begun.parameter, fault),
        }
    }

    /// Reports a parameter that the chain comes back to.
    fn report_circle(&mut self, parameter: usize, chain: &[Begun]) {
        let circle = chain.iter().skip_while(|one| one.parameter != parameter);
        let names = circle.map(|one| self.entries[one.parameter].key.as_str());
        let names: Vec<&str> = names.collect();
        let first = &names[..names.len().min(MOST_OF_CIRCLE)];
        let further = match names.len() - first.len() {
            0 => String::new(),
            count => format!(" and {count} more"),
        };
        let problem = format!("depends on itself ({}{further})", first.join(", "));
        self.report(parameter, (problem, "give one of them a number".to_owned()));
    }

    fn report(&mut self, parameter: usize, (problem, remedy): (String, String)) {
        let entry = &self.entries[parameter];
        let path = join(&[PARAMETERS, &entry.key]);
        let finding = Finding::new(&entry.node.span, path, problem, remedy);
        self.found.push(finding);
        self.progress[parameter] = ParameterProgress::Faulty;
    }
}

/// What a parameter is given as.
enum ParameterInput {
    Number(f64),
    Expression(Expression, Vec<usize>),
}
