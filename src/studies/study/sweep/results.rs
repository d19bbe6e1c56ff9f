//! The results that a sweep shows.

use crate::case::{Case, QuantityId, Statistic, Subject, fields::nearest};
use crate::study::results::{main_results, named_result};
use crate::system::motion::channels::Channels;
use crate::system::motion::job::STATISTICS;
use crate::system::motion::start::start;
use crate::system::{SolvedSystem, quantities};

/// The results of a load case that are shown.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepResults {
    /// Of a run of a line.
    Line(Vec<QuantityId>),
    /// Of a run of a system in time.
    InTime(Vec<QuantityId>),
    /// Of a system at rest, by name.
    AtRest(Vec<String>),
}

impl SweepResults {
    /// Those of a line by name, or its main results.
    ///
    /// # Errors
    /// A name that is no result, and what would be right.
    pub fn of_line(case: &Case, names: &[String]) -> Result<Self, String> {
        if names.is_empty() {
            return Ok(Self::Line(main_results(case)));
        }
        let named = names.iter().map(|name| named_result(case, name));
        let named: Result<Vec<QuantityId>, _> = named.collect();
        named.map(Self::Line).map_err(|error| error.to_string())
    }

    /// Those of a system by name, or the main ones: at rest, or in time where its file has a table `[solver]`.
    ///
    /// # Errors
    /// A name that is no result, or why the system cannot be computed.
    pub fn of_system(solved: &SolvedSystem, names: &[String]) -> Result<Self, String> {
        if solved.file.as_run().is_some() {
            return in_time(solved, names).map(Self::InTime);
        }
        if names.is_empty() {
            return Ok(Self::AtRest(quantities::main_results(solved)));
        }
        for name in names {
            quantities::value(solved, name)?;
        }
        Ok(Self::AtRest(names.to_vec()))
    }

    /// Those of runs.
    #[must_use]
    pub fn ids(self) -> Vec<QuantityId> {
        match self {
            Self::Line(ids) | Self::InTime(ids) => ids,
            Self::AtRest(_) => Vec::new(),
        }
    }

    /// Their names.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        match self {
            Self::Line(ids) | Self::InTime(ids) => ids.iter().map(ToString::to_string).collect(),
            Self::AtRest(names) => names.clone(),
        }
    }
}

/// Results of a system in time; the main ones are the greatest tension of every line, at the end where it is greater at rest.
fn in_time(solved: &SolvedSystem, names: &[String]) -> Result<Vec<QuantityId>, String> {
    let begun = start(solved, 1.0).map_err(|why| format!("{}; {}", why.problem, why.remedy))?;
    let channels = Channels::of_system(&begun.system).ids;
    let of = |statistic: Statistic| {
        let subjects = channels.iter().cloned().map(Subject::Channel);
        subjects.map(move |subject| QuantityId::new(subject, statistic, None))
    };
    let known: Vec<QuantityId> = STATISTICS.into_iter().flat_map(of).collect();
    if names.is_empty() {
        let greater = quantities::main_results(solved);
        let main = greater.iter().map(|channel| format!("{channel}.max"));
        let main: Vec<String> = main.collect();
        let found = known.into_iter();
        return Ok(found.filter(|id| main.contains(&id.to_string())).collect());
    }
    let known: Vec<(String, QuantityId)> =
        known.into_iter().map(|id| (id.to_string(), id)).collect();
    let one = |name: &String| {
        let found = known.iter().find(|(known, _)| known == name.trim());
        found.map(|(_, id)| id.clone()).ok_or_else(|| {
            let names = known.iter().map(|(name, _)| name.as_str());
            match nearest(name, names) {
                Some(near) => format!("`{name}` is no result of this system; did you mean `{near}`?"),
                None => format!("`{name}` is no result of this system; name a channel and min, max, mean or final"),
            }
        })
    };
    names.iter().map(one).collect()
}
