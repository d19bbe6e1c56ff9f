//! The list of everything that a paper prints, and by what of ours each statement is answered.

use std::sync::LazyLock;

use crate::case::fields::Schema;
use crate::case::file_kind::{FileContent, FileKind};
use crate::case::schema::{schema_of, table};
use crate::case::{FieldLister, FieldRow, Finding, StudyValue};

table! {
    /// A paper, statement by statement.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Paper => PaperKeys {}
    tables {
        /// The paper, and the cases that reproduce it.
        about: PaperInfo as "paper";
        /// One thing that the paper prints.
        statements: Vec<Statement> as "statement";
    }
}

table! {
    /// The paper, and the cases that reproduce it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PaperInfo => PaperInfoKeys {
        /// What the paper is about, and its year.
        title: String, "title";
        /// The same in a word.
        short: String, "short title";
        /// Authors, year, journal, identifier.
        cite: String, "citation";
        /// The shipped files that reproduce it, below cases.
        cases: Vec<String>, "cases";
        /// Inputs that are not printed and were chosen by how many of the statements come out, and what that says of them.
        chosen: Option<String>, "inputs chosen by the statements", absent "none";
    }
}

table! {
    /// One thing that a paper prints: an equation, a number, a figure, a conclusion.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Statement => StatementKeys {
        /// Where it is printed.
        printed_in: String, "printed in";
        /// What it says, in words of our own.
        says: String, "says";
        /// It is an input: file and key that repeat it, as file.toml: key.path.
        input: Option<String>, "input", absent "it is no input";
        /// What that key has there.
        value: Option<StudyValue>, "value", absent "it is no input";
        /// It is a result: the rows that hold it against ours, as file.toml: name of the row.
        rows: Option<Vec<String>>, "rows", absent "no row tests it";
        /// The same rows by a second reading of what the paper does not print.
        second: Option<Vec<String>>, "second reading", absent "none";
        /// It is an equation or a method: the file of the program that does it.
        code: Option<String>, "code", absent "it is no equation";
        /// The test that checks that.
        test: Option<String>, "test", absent "it is no equation";
        /// Why it cannot be tested, and what was tried.
        out_of_reach: Option<String>, "out of reach", absent "it is tested";
    }
}

/// The list of a paper's statements.
static PAPER: LazyLock<Schema> = LazyLock::new(|| {
    let least =
        "a list of statements has [paper] and one [[statement]] for each thing that is printed";
    schema_of::<Paper>("list of statements", least)
});

impl FileContent for Paper {
    type Computed = Self;
}

impl FileKind for Paper {
    fn schema() -> &'static Schema {
        &PAPER
    }

    fn check(keys: &PaperKeys<'_>) -> Vec<Finding> {
        keys.statements
            .iter()
            .filter_map(|(_, s)| one_answer(s))
            .collect()
    }

    fn compute(self, _keys: &PaperKeys<'_>) -> Result<Self, Finding> {
        Ok(self)
    }

    fn list(_lister: &FieldLister<'_>) -> Vec<FieldRow> {
        Vec::new()
    }
}

/// A statement has one answer or none yet: an input with its value, rows, code with its test, or a reason.
fn one_answer(keys: &StatementKeys<'_>) -> Option<Finding> {
    let given = [
        keys.input.is_given(),
        keys.rows.is_given(),
        keys.code.is_given(),
        keys.out_of_reach.is_given(),
    ];
    let pairs = [
        (
            keys.input.is_given(),
            keys.value.is_given(),
            "`input` and `value`",
        ),
        (
            keys.code.is_given(),
            keys.test.is_given(),
            "`code` and `test`",
        ),
    ];
    let half = pairs.iter().find(|(one, other, _)| one != other);
    match (given.iter().filter(|given| **given).count(), half) {
        (2.., _) => Some(keys.place.finding(
            "has more than one answer",
            "keep one of `input`, `rows`, `code` and `out_of_reach`",
        )),
        (_, Some((_, _, both))) => Some(
            keys.place
                .finding("has half an answer", format!("give both {both}")),
        ),
        _ if keys.second.is_given() && !keys.rows.is_given() => Some(
            keys.place
                .finding("has a second reading without a first", "give `rows`"),
        ),
        _ => None,
    }
}
