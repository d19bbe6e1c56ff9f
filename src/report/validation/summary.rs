//! The first screen: a line for each paper, and what stands beside them.

use super::{JudgedPaper, ValidatedFile, is_of_a_paper};
use crate::reference::papers::{AnswerCounts, count_answers};
use crate::reference::{Outcome, RowKind, ValidationRow};
use crate::report::document::Block;
use crate::report::table::{Align, Cell, CellStyle, Table};

pub(super) fn blocks(files: &[ValidatedFile<'_>], papers: &[JudgedPaper<'_>]) -> Vec<Block> {
    let mut blocks = vec![Block::Title("Published results against ours".to_owned())];
    if !papers.is_empty() {
        blocks.push(Block::Table(of_papers(papers)));
    }
    blocks.push(Block::Table(of_rows(files, papers)));
    blocks.push(Block::Paragraph(HOW_TO_READ.to_owned()));
    let unreasoned =
        rows(files).filter(|row| row.tolerance.is_some() && row.tolerance_reason.is_none());
    let unreasoned = unreasoned.count();
    if unreasoned > 0 {
        blocks.push(Block::Paragraph(format!(
            "{unreasoned} rows have a tolerance without a reason: what they come to rests on our word."
        )));
    }
    blocks
}

const HOW_TO_READ: &str = "\
Evidence is what is predicted (no input was fitted to it) and the trends. Fitted numbers, inputs and their exact consequences \
(echoed) agree by construction; closed forms check the program, not a source. A statement is reproduced when every row that \
tests it is within its tolerance; (+n) of those not reproduced come out by a second reading of what the paper does not print.";

fn of_papers(papers: &[JudgedPaper<'_>]) -> Table {
    let counted: Vec<(&str, AnswerCounts)> = papers
        .iter()
        .map(|one| {
            (
                one.paper.about.title.as_str(),
                count_answers(&one.statements),
            )
        })
        .collect();
    let count = |n: usize| {
        Cell::new(
            n.to_string(),
            if n == 0 {
                CellStyle::Dim
            } else {
                CellStyle::Plain
            },
        )
    };
    let missed = |counts: &AnswerCounts| {
        let second = match counts.by_second {
            0 => String::new(),
            n => format!(" (+{n})"),
        };
        let ink = if counts.not_reproduced > 0 {
            CellStyle::Warn
        } else {
            CellStyle::Dim
        };
        Cell::new(format!("{}{second}", counts.not_reproduced), ink)
    };
    Table::of("", &counted)
        .text("paper: its statements", |(title, _)| (*title).to_owned())
        .cell("all", Align::Right, |(_, n)| count(n.printed))
        .cell("pre- dicted", Align::Right, |(_, n)| count(n.predicted))
        .cell("trends", Align::Right, |(_, n)| count(n.trends))
        .cell("fitted", Align::Right, |(_, n)| count(n.fitted))
        .cell("echoed", Align::Right, |(_, n)| count(n.echoed))
        .cell("equa- tions", Align::Right, |(_, n)| {
            count(n.equations + n.closed_forms)
        })
        .cell("not repro- duced", Align::Right, |(_, n)| missed(n))
        .cell("not tried", Align::Right, |(_, n)| {
            let ink = if n.not_attempted > 0 {
                CellStyle::Bad
            } else {
                CellStyle::Dim
            };
            Cell::new(n.not_attempted.to_string(), ink)
        })
        .build()
}

/// Rows of one origin, by kind.
struct Origin {
    name: &'static str,
    of: fn(&ValidationRow, bool) -> bool,
}

const ORIGINS: [Origin; 4] = [
    Origin {
        name: "rows of the papers' files",
        of: |row, paper| paper && row.kind != RowKind::ClosedForm,
    },
    Origin {
        name: "other programs and measurements",
        of: |row, paper| !paper && row.kind.is_evidence(),
    },
    Origin {
        name: "of these other files, fitted or echoed",
        of: |row, paper| !paper && matches!(row.kind, RowKind::Fitted | RowKind::Echoed),
    },
    Origin {
        name: "closed forms of our own",
        of: |row, _| row.kind == RowKind::ClosedForm,
    },
];

fn of_rows(files: &[ValidatedFile<'_>], papers: &[JudgedPaper<'_>]) -> Table {
    let origins: Vec<(&str, Vec<&ValidationRow>)> = ORIGINS
        .iter()
        .map(|origin| {
            let of_file = |file: &'_ ValidatedFile<'_>| is_of_a_paper(file.of.file, papers);
            let rows = files.iter().flat_map(|file| {
                let paper = of_file(file);
                file.of
                    .rows
                    .iter()
                    .filter(move |row| (origin.of)(row, paper))
            });
            (origin.name, rows.collect())
        })
        .filter(|(_, rows): &(_, Vec<_>)| !rows.is_empty())
        .collect();
    let count = |rows: &[&ValidationRow], outcome: Outcome, ink: CellStyle| {
        let n = rows.iter().filter(|row| row.outcome == outcome).count();
        Cell::new(n.to_string(), if n == 0 { CellStyle::Dim } else { ink })
    };
    Table::of("", &origins)
        .text("rows of tables", |(name, _)| (*name).to_owned())
        .cell("all", Align::Right, |(_, rows)| {
            Cell::plain(rows.len().to_string())
        })
        .cell("PASS", Align::Right, |(_, rows)| {
            count(rows, Outcome::Pass, CellStyle::Good)
        })
        .cell("FAIL", Align::Right, |(_, rows)| {
            count(rows, Outcome::Fail, CellStyle::Bad)
        })
        .cell("DIFFERS", Align::Right, |(_, rows)| {
            count(rows, Outcome::Differs, CellStyle::Warn)
        })
        .cell("NOT RUN", Align::Right, |(_, rows)| {
            count(rows, Outcome::NotRun, CellStyle::Bad)
        })
        .build()
}

fn rows<'a>(files: &'a [ValidatedFile<'_>]) -> impl Iterator<Item = &'a ValidationRow> {
    files.iter().flat_map(|file| file.of.rows)
}
