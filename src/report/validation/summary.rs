//! The first screen: a line for each paper, and the counts of all rows.

use super::{JudgedPaper, is_of_a_paper};
use crate::document::Block;
use seacable_display::table::{Align, Cell, CellStyle, Table};
use seacable_runs::reference::papers::{AnswerCounts, FileRows, count_answers};
use seacable_runs::reference::{Outcome, RowKind, ValidationRow};

pub(super) fn blocks(files: &[FileRows<'_>], papers: &[JudgedPaper<'_>]) -> Vec<Block> {
    let mut blocks = vec![Block::Title("Published results against ours".to_owned())];
    if !papers.is_empty() {
        blocks.push(Block::Table(of_papers(papers)));
    }
    blocks.push(Block::Table(of_rows(files, papers)));
    blocks.push(Block::Paragraph(HOW_TO_READ.to_owned()));
    blocks.extend(chosen(papers).map(Block::Paragraph));
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
(echoed) agree by construction. Equations have a test, or closed forms beside the paper: they check the program. \
Missed: not reproduced, each with what was tried; (+n) of them come out by a second reading of what the paper \
does not print. No test: a figure that is lost, or a remark from which nothing follows. Open: without an answer. `tol.` is the difference in tolerances; * an input behind it is not printed.";

/// Which inputs were chosen by the statements themselves: what these rows show is then less than the word says.
fn chosen(papers: &[JudgedPaper<'_>]) -> Option<String> {
    let said = papers.iter().filter_map(|one| {
        let about = &one.paper.about;
        let chosen = about.chosen.as_ref()?;
        Some(format!("{}: {}", about.short, chosen.trim_end_matches('.')))
    });
    let said: Vec<String> = said.collect();
    let all = said.join("; ");
    (!said.is_empty()).then(|| format!("Inputs chosen by how many statements come out: {all}."))
}

fn of_papers(papers: &[JudgedPaper<'_>]) -> Table {
    let counted: Vec<(&str, AnswerCounts)> = papers
        .iter()
        .map(|one| {
            (
                one.paper.about.short.as_str(),
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
    Table::of_records("", &counted)
        .text("paper", |(title, _)| (*title).to_owned())
        .cell("all", Align::Right, |(_, n)| count(n.printed))
        .cell("predicted", Align::Right, |(_, n)| count(n.predicted))
        .cell("trends", Align::Right, |(_, n)| count(n.trends))
        .cell("fitted", Align::Right, |(_, n)| count(n.fitted))
        .cell("echoed", Align::Right, |(_, n)| count(n.echoed))
        .cell("equat.", Align::Right, |(_, n)| {
            count(n.equations + n.closed_forms)
        })
        .cell("missed", Align::Right, |(_, n)| missed(n))
        .cell("no test", Align::Right, |(_, n)| count(n.untestable))
        .cell("open", Align::Right, |(_, n)| {
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
struct OriginRows {
    name: &'static str,
    of: fn(&ValidationRow, bool) -> bool,
}

const ORIGINS: [OriginRows; 4] = [
    OriginRows {
        name: "rows of the papers' files",
        of: |row, paper| paper && row.kind != RowKind::ClosedForm,
    },
    OriginRows {
        name: "other programs and measurements",
        of: |row, paper| !paper && row.kind.is_evidence(),
    },
    OriginRows {
        name: "of these other files, fitted or echoed",
        of: |row, paper| !paper && matches!(row.kind, RowKind::Fitted | RowKind::Echoed),
    },
    OriginRows {
        name: "closed forms of our own",
        of: |row, _| row.kind == RowKind::ClosedForm,
    },
];

fn of_rows(files: &[FileRows<'_>], papers: &[JudgedPaper<'_>]) -> Table {
    let origins: Vec<(&str, Vec<&ValidationRow>)> = ORIGINS
        .iter()
        .map(|origin| {
            let of_file = |file: &'_ FileRows<'_>| is_of_a_paper(file.file, papers);
            let rows = files.iter().flat_map(|file| {
                let paper = of_file(file);
                file.rows.iter().filter(move |row| (origin.of)(row, paper))
            });
            (origin.name, rows.collect())
        })
        .filter(|(_, rows): &(_, Vec<_>)| !rows.is_empty())
        .collect();
    let count = |rows: &[&ValidationRow], outcome: Outcome, ink: CellStyle| {
        let n = rows.iter().filter(|row| row.outcome == outcome).count();
        Cell::new(n.to_string(), if n == 0 { CellStyle::Dim } else { ink })
    };
    Table::of_records("", &origins)
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

fn rows<'a>(files: &'a [FileRows<'_>]) -> impl Iterator<Item = &'a ValidationRow> {
    files.iter().flat_map(|file| file.rows)
}
