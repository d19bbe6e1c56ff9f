//! The papers that the program must reproduce, statement by statement: what is printed, and what of ours answers it.
//!
//! A list ([`Paper`]) names for each statement an input, rows of validation tables, or the code of an equation with its test;
//! or why it is out of reach. [`judge()`] says what these answers come to, given the rows of the shipped files.

mod judged;
mod model;

pub use judged::row;
pub use judged::{Answer, AnswerCounts, FileRows, JudgedStatement, count_answers, judge};
pub use model::{Paper, PaperInfo, Statement};

use crate::case::{Diagnostic, kind};

macro_rules! lists {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../../../docs/papers/", $name)))),*]
    };
}

/// The lists that come with the program: file and text.
pub const LISTS: &[(&str, &str)] = lists![
    "jia_2019.toml",
    "lin_2016.toml",
    "tianjin_2016.toml",
    "double_stepped_2022.toml",
    "zhu_2017.toml",
];

/// Reads a list.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Paper, Vec<Diagnostic>> {
    kind::parse::<Paper>(text, file)
}
