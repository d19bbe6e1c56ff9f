//! What the columns of the table of runs are: inputs with the help of their keys, results with what they are taken of.

use super::run_cells::head;
use super::state::{RunColumn, RunList};
use crate::case::{self, CurveMeasure, QuantityId, Statistic, Subject};

/// The head of a column, and what it is: its unit, and where it comes from.
#[must_use]
pub fn explanation(runs: &RunList, column: RunColumn) -> (String, String) {
    let words = match column {
        RunColumn::Name => "The name of the run: your own where you gave one, else case file and time. [x] marks a run on the charts, * one that is marked.".to_owned(),
        RunColumn::State => "What became of the run: done, partial (stopped or killed, with all rows up to then), failed, or computing. From run.toml in its directory.".to_owned(),
        RunColumn::Input(at) => {
            let key = runs.columns.inputs.get(at).map_or("", |of| of.key.as_str());
            input(key)
        }
        RunColumn::Result(at) => {
            let name = runs.columns.results.get(at).map_or("", |of| of.name.as_str());
            result(name)
        }
        RunColumn::Method => "The solver of the run: static, quasi (quasi-static), rk4 or alpha (generalized-alpha). The key solver.method of its case.".to_owned(),
        RunColumn::Steps => "Accepted time steps. From run.toml in the directory of the run.".to_owned(),
        RunColumn::Cpu => "CPU time of the run without the companion runs that estimate its errors. From run.toml in its directory.".to_owned(),
        RunColumn::Age => "When the run began, in UTC. From run.toml in its directory.".to_owned(),
        RunColumn::Tags => "Tags that you gave the run; `#wet` in the filter shows the runs with one. From the notes in its directory.".to_owned(),
    };
    (head(runs, column), words)
}

/// An input by its key.
fn input(key: &str) -> String {
    let path: Vec<&str> = key.split('.').collect();
    let Some(field) = case::field_at(&path) else {
        return format!(
            "The key {key} of the case of each run, shown as it differs among the runs of the table."
        );
    };
    let unit = match field.unit {
        "" | "-" => String::new(),
        unit => format!(" Unit: {unit}."),
    };
    format!(
        "{}{unit} The key {key} of the case of each run, shown as it differs among the runs of the table.",
        sentence(field.help)
    )
}

/// A result by its name.
#[must_use]
pub fn result(name: &str) -> String {
    let origin = "From summary.csv of each run; behind ± its numerical error, estimated by companion runs with half the time step and half the mesh.";
    let Ok(id) = name.parse::<QuantityId>() else {
        return format!("The result {name}. {origin}");
    };
    let unit = match id.unit() {
        unit if unit.is_empty() || unit == "-" => String::new(),
        unit => format!(" Unit: {unit}."),
    };
    let words = match &id {
        QuantityId::Statistic {
            of,
            statistic,
            within,
            ..
        } => {
            let window =
                within.map_or_else(String::new, |[from, to]| format!(", from {from} to {to} s"));
            format!("{}: {}{window}.", subject(of), statistic_words(*statistic))
        }
        QuantityId::CurveDifference(channel, measure, number) => {
            let what = match measure {
                CurveMeasure::RootMeanSquare => "Root mean square of the difference",
                CurveMeasure::Greatest => "Greatest difference",
            };
            format!("{what} of {channel} from the published curve {number} of the case.")
        }
    };
    format!("{words}{unit} {origin}")
}

fn subject(of: &Subject) -> String {
    match of {
        Subject::Channel(channel) => {
            format!("{} ({channel})", channel.quantity.title())
        }
        other => other.to_string(),
    }
}

/// What a statistic takes of its channel or, along the line, of its quantity.
const fn statistic_words(of: Statistic) -> &'static str {
    match of {
        Statistic::Mean => "the mean",
        Statistic::Max => "the greatest value over all time steps",
        Statistic::Min => "the smallest value over all time steps",
        Statistic::Final => "the value at the end",
        Statistic::Travel => "its first value less the smallest",
        Statistic::TimeOfMax => "the time of the greatest value",
        Statistic::TimeOfMin => "the time of the smallest value",
        Statistic::SettlingTime => {
            "the time after which it stays within 2 % of its range from its final value"
        }
        Statistic::RiseTime => "the time at which it has gone 90 % of the way to its final value",
        Statistic::Rate => "the magnitude of its mean rate of change",
        Statistic::MeanPeak => "the mean of the greatest values of whole cycles",
        Statistic::MeanTrough => "the mean of the smallest values of whole cycles",
        Statistic::ArcOfMax => "the arc length from end A of the greatest value",
        Statistic::ArcOfMin => "the arc length from end A of the smallest value",
        Statistic::GreatestFall => {
            "the most that it falls along the line from one place to a later one"
        }
        Statistic::Turns => "how often it turns along the line from rising to falling or back",
        Statistic::Peaks => "how many times it rises and falls again along the line",
        Statistic::Peak => "the value at a local maximum along the line",
        Statistic::Valley => "the value at a local minimum along the line",
    }
}

fn sentence(words: &str) -> String {
    let words = words.trim();
    match words.ends_with('.') {
        true => words.to_owned(),
        false => format!("{words}."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_says_what_it_is_taken_of_its_unit_and_where_it_comes_from() {
        let words = result("tension_n[vessel|chain].max");
        assert!(
            words
                .starts_with("Tension at the joints (tension_n[vessel|chain]): the greatest value"),
            "{words}"
        );
        assert!(
            words.contains("Unit: N.") && words.contains("summary.csv"),
            "{words}"
        );
        assert!(result("of another program").contains("The result of another program."));
    }

    #[test]
    fn an_input_says_what_its_key_is() {
        let words = input("current.speed_m_per_s");
        assert!(
            words.contains("Unit: m/s.") && words.contains("current.speed_m_per_s"),
            "{words}"
        );
        assert!(!input("no.such_key").is_empty());
    }
}
