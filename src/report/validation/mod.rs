//! The validation page: a line for each paper first, then each paper statement by statement, then the other files.

mod beside;
mod paper;
mod summary;

use crate::document::Report;
use seacable_runs::reference::papers::{FileRows, JudgedStatement, Paper};

/// A paper with its statements answered.
#[derive(Debug, Clone)]
pub struct JudgedPaper<'a> {
    /// The paper.
    pub paper: &'a Paper,
    /// Its statements.
    pub statements: Vec<JudgedStatement<'a>>,
}

/// How much of the page is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// The first screen.
    Summary,
    /// The first screen, the results of every paper, a line for every other file.
    Page,
    /// The same with the papers' inputs and equations.
    Details,
}

/// The page.
#[must_use]
pub fn page(files: &[FileRows<'_>], papers: &[JudgedPaper<'_>], extent: Extent) -> Report {
    let mut page = Report::of_blocks(summary::blocks(files, papers));
    if extent == Extent::Summary {
        return page;
    }
    for paper in papers {
        page.extend(paper::blocks(paper, files, extent == Extent::Details));
    }
    page.extend(beside::blocks(files, papers));
    page
}

/// Whether a file is one of those that reproduce a paper.
fn is_of_a_paper(file: &str, papers: &[JudgedPaper<'_>]) -> bool {
    papers
        .iter()
        .any(|one| one.paper.about.cases.iter().any(|case| case == file))
}
