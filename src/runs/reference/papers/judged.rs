//! The statements of a paper, each with what its answer comes to.

use super::model::{Paper, Statement};
use crate::case::{StudyValue, TomlNode, shipped, split};
use crate::reference::{Outcome, RowKind, ValidationRow};

/// A file with the rows of its validation.
#[derive(Debug, Clone, Copy)]
pub struct FileRows<'a> {
    /// Its path below `cases`.
    pub file: &'a str,
    /// Its text.
    pub text: &'a str,
    /// Its rows.
    pub rows: &'a [ValidationRow],
}

/// What the answer to a statement comes to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// An input of ours repeats it.
    Input,
    /// An equation or a method that the program has, with a test.
    Equation,
    /// Every row that tests it passes; of the kinds of these rows the one that is least as evidence.
    Agrees(RowKind),
    /// A row that tests it is outside its tolerance, or an input of ours is another, as the reason says.
    NotReproduced(String),
    /// Nothing can test it, as the reason says: a lost figure, an input without consequence.
    Untestable(String),
    /// No row, input or equation stands for it.
    NotAttempted(String),
}

/// A statement with its answer.
#[derive(Debug, Clone, PartialEq)]
pub struct JudgedStatement<'a> {
    /// The statement.
    pub statement: &'a Statement,
    /// What its answer comes to.
    pub answer: Answer,
    /// The same by a second reading, where the list names one.
    pub second: Option<Answer>,
}

/// Every statement of a paper with its answer, in the order of the list. Files that were not computed leave their statements
/// not attempted.
#[must_use]
pub fn judge<'a>(paper: &'a Paper, files: &[FileRows<'_>]) -> Vec<JudgedStatement<'a>> {
    let judged = |statement: &'a Statement| JudgedStatement {
        statement,
        answer: answer(statement, files),
        second: statement.second.as_ref().map(|rows| by_rows(rows, files)),
    };
    paper.statements.iter().map(judged).collect()
}

fn answer(statement: &Statement, files: &[FileRows<'_>]) -> Answer {
    if let Some(reason) = &statement.out_of_reach {
        return Answer::Untestable(reason.clone());
    }
    if let Some((input, value)) = statement.input.as_ref().zip(statement.value.as_ref()) {
        return by_input(input, value, files);
    }
    if statement.code.is_some() {
        return Answer::Equation;
    }
    match &statement.rows {
        Some(rows) => by_rows(rows, files),
        None => Answer::NotAttempted("The list names nothing that answers it.".to_owned()),
    }
}

fn by_input(input: &str, wanted: &StudyValue, files: &[FileRows<'_>]) -> Answer {
    let found = input.split_once(": ").and_then(|(file, key)| {
        let computed = files.iter().find(|f| f.file == file).map(|f| f.text);
        let text = computed.or_else(|| shipped::text(file))?;
        let root = TomlNode::parse(text).ok()?;
        let node = root.find(&split(key)?)?;
        node.number()
            .map(StudyValue::Number)
            .or_else(|| node.text().map(|word| StudyValue::Word(word.to_owned())))
    });
    match found {
        Some(found) if found == *wanted => Answer::Input,
        Some(found) => {
            Answer::NotReproduced(format!("{input} is {found}, and the list says {wanted}."))
        }
        None => Answer::NotAttempted(format!("There is no input {input}.")),
    }
}

fn by_rows(names: &[String], files: &[FileRows<'_>]) -> Answer {
    let mut kind = None;
    let mut reason = None;
    for name in names {
        let Some(row) = row(name, files) else {
            return Answer::NotAttempted(format!("There is no row {name}."));
        };
        kind = kind.max(Some(row.kind));
        let why = row
            .reason
            .clone()
            .unwrap_or_else(|| "Outside its tolerance.".to_owned());
        match row.outcome {
            Outcome::Pass => {}
            Outcome::Fail | Outcome::Differs => reason = Some(why),
            Outcome::NotRun | Outcome::Edited => return Answer::NotAttempted(why),
        }
    }
    match (reason, kind) {
        (Some(why), _) => Answer::NotReproduced(why),
        (None, Some(kind)) => Answer::Agrees(kind),
        (None, None) => Answer::NotAttempted("The list names no row.".to_owned()),
    }
}

/// The row of this name, given as file.toml: name.
pub fn row<'a>(name: &str, files: &[FileRows<'a>]) -> Option<&'a ValidationRow> {
    let (file, name) = name.split_once(": ")?;
    let file = files.iter().find(|f| f.file == file)?;
    file.rows.iter().find(|row| row.name == name)
}

/// How many statements have which answer.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct AnswerCounts {
    /// Everything that is printed.
    pub printed: usize,
    /// Inputs, and results that are exact consequences of them.
    pub echoed: usize,
    /// Equations and methods.
    pub equations: usize,
    /// Numbers that come out without having been fitted.
    pub predicted: usize,
    /// Trends that hold.
    pub trends: usize,
    /// Numbers to which an input was fitted.
    pub fitted: usize,
    /// Formulas worked out beside the paper, where it prints no number.
    pub closed_forms: usize,
    /// Not reproduced.
    pub not_reproduced: usize,
    /// Of these, reproduced by a second reading.
    pub by_second: usize,
    /// Nothing can test them.
    pub untestable: usize,
    /// Without an answer.
    pub not_attempted: usize,
}

/// Counts the answers.
#[must_use]
pub fn count_answers(judged: &[JudgedStatement<'_>]) -> AnswerCounts {
    let mut counts = AnswerCounts {
        printed: judged.len(),
        ..AnswerCounts::default()
    };
    for one in judged {
        let agrees = matches!(one.second, Some(Answer::Agrees(_)));
        let missed = matches!(one.answer, Answer::NotReproduced(_));
        counts.by_second += usize::from(agrees && missed);
        *match &one.answer {
            Answer::Input | Answer::Agrees(RowKind::Echoed) => &mut counts.echoed,
            Answer::Equation => &mut counts.equations,
            Answer::Agrees(RowKind::Predicted) => &mut counts.predicted,
            Answer::Agrees(RowKind::Trend) => &mut counts.trends,
            Answer::Agrees(RowKind::ClosedForm) => &mut counts.closed_forms,
            Answer::Agrees(RowKind::Fitted) => &mut counts.fitted,
            Answer::NotReproduced(_) => &mut counts.not_reproduced,
            Answer::Untestable(_) => &mut counts.untestable,
            Answer::NotAttempted(_) => &mut counts.not_attempted,
        } += 1;
    }
    counts
}
