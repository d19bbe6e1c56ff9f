//! One paper: what is not reproduced first, then what is, a line each; on demand its inputs and equations.

use super::JudgedPaper;
use crate::document::Block;
use seacable_display::table::{Align, Cell, CellStyle, Table};
use seacable_runs::reference::papers::{Answer, FileRows, JudgedStatement, count_answers, row};
use seacable_runs::reference::{Outcome, RowKind, ValidationRow, table};

/// Results that agree, by what that is worth.
const GROUPS: [(&str, &[RowKind]); 3] = [
    (
        "Reproduced: evidence",
        &[RowKind::Predicted, RowKind::Trend],
    ),
    (
        "Agrees with closed forms and second methods of our own",
        &[RowKind::ClosedForm],
    ),
    (
        "Agrees by construction",
        &[RowKind::Fitted, RowKind::Echoed],
    ),
];

pub(super) fn blocks(paper: &JudgedPaper<'_>, files: &[FileRows<'_>], details: bool) -> Vec<Block> {
    let about = &paper.paper.about;
    let mut blocks = vec![
        Block::Heading(about.title.clone()),
        Block::Paragraph(about.cite.clone()),
        Block::Paragraph(counts(paper)),
    ];
    let lines: Vec<StatementLine<'_>> = paper
        .statements
        .iter()
        .map(|one| StatementLine::of_statement(one, files))
        .collect();
    let of = |wanted: &dyn Fn(&Answer) -> bool| {
        let chosen = lines.iter().filter(|line| wanted(&line.judged.answer));
        chosen.collect::<Vec<_>>()
    };
    blocks.extend(unanswered(
        "Not reproduced, the farthest off first",
        of(&|a| matches!(a, Answer::NotReproduced(_) | Answer::NotAttempted(_))),
    ));
    for (title, kinds) in GROUPS {
        let lines = of(&|a| matches!(a, Answer::Agrees(kind) if kinds.contains(kind)));
        if !lines.is_empty() {
            blocks.push(Block::Table(results(title, &lines)));
            blocks.extend(notes(&lines).map(Block::Paragraph));
        }
    }
    blocks.extend(unanswered(
        "Nothing to test",
        of(&|a| matches!(a, Answer::Untestable(_))),
    ));
    if details {
        blocks.extend(inputs_and_equations(&paper.statements));
    }
    blocks
}

fn counts(paper: &JudgedPaper<'_>) -> String {
    let n = count_answers(&paper.statements);
    format!(
        "{} statements: {} predicted, {} trends, {} fitted, {} echoed, {} equations, {} closed forms, {} not reproduced \
         ({} of them by a second reading), {} without a test, {} not attempted. Cases: {}.",
        n.printed,
        n.predicted,
        n.trends,
        n.fitted,
        n.echoed,
        n.equations,
        n.closed_forms,
        n.not_reproduced,
        n.by_second,
        n.untestable,
        n.not_attempted,
        paper.paper.about.cases.join(", "),
    )
}

/// A statement with the row that is farthest off among those that test it.
struct StatementLine<'a> {
    judged: &'a JudgedStatement<'a>,
    row: Option<&'a ValidationRow>,
    second: Option<&'a ValidationRow>,
}

impl<'a> StatementLine<'a> {
    fn of_statement(judged: &'a JudgedStatement<'a>, files: &[FileRows<'a>]) -> Self {
        let farthest = |names: &Option<Vec<String>>| {
            let rows = names.iter().flatten().filter_map(|name| row(name, files));
            let fails = |row: &ValidationRow| row.outcome != Outcome::Pass;
            rows.max_by(|a, b| {
                let outcome = fails(a).cmp(&fails(b));
                outcome.then(distance(a).total_cmp(&distance(b)))
            })
        };
        Self {
            judged,
            row: farthest(&judged.statement.rows),
            second: farthest(&judged.statement.second),
        }
    }

    fn says(&self) -> String {
        let statement = self.judged.statement;
        format!("{}: {}", statement.printed_in, statement.says)
    }
}

fn distance(row: &ValidationRow) -> f64 {
    row.in_tolerances().unwrap_or(0.0)
}

/// Statements without agreement, the farthest off first, each reason once.
fn unanswered(title: &str, mut lines: Vec<&StatementLine<'_>>) -> Vec<Block> {
    if lines.is_empty() {
        return Vec::new();
    }
    let far = |line: &StatementLine<'_>| line.row.map_or(0.0, distance);
    lines.sort_by(|a, b| far(b).total_cmp(&far(a)));
    let mut reasons: Vec<&str> = Vec::new();
    let numbered: Vec<(usize, &StatementLine<'_>)> = lines
        .into_iter()
        .map(|line| {
            let reason = match &line.judged.answer {
                Answer::NotReproduced(reason)
                | Answer::NotAttempted(reason)
                | Answer::Untestable(reason) => reason.trim(),
                _ => "",
            };
            let known = reasons.iter().position(|known| *known == reason);
            let number = known.unwrap_or_else(|| {
                reasons.push(reason);
                reasons.len() - 1
            });
            (number + 1, line)
        })
        .collect();
    let notes = reasons.iter().enumerate();
    let notes: Vec<String> = notes
        .map(|(i, reason)| format!("[{}] {reason}", i + 1))
        .collect();
    let has_second = numbered
        .iter()
        .any(|(_, line)| line.judged.second.is_some());
    let mut table = Table::of_records(title, &numbered)
        .text("printed", |(_, line)| line.says())
        .cell("computed", Align::Right, |(_, line)| {
            line.row.map_or_else(Cell::none, table::computed)
        })
        .cell("% off", Align::Right, |(_, line)| {
            line.row.map_or_else(Cell::none, table::percent)
        })
        .cell("tol.", Align::Right, |(_, line)| tolerances(line.row));
    if has_second {
        table = table.cell("second reading", Align::Right, |(_, line)| second(line));
    }
    let table = table.cell("why", Align::Left, |(reason, line)| {
        match line.judged.answer {
            Answer::NotAttempted(_) => Cell::new(format!("NOT TRIED [{reason}]"), CellStyle::Bad),
            _ => Cell::plain(format!("[{reason}]")),
        }
    });
    vec![Block::Table(table.build().noted(notes))]
}

fn tolerances(row: Option<&ValidationRow>) -> Cell {
    let off = row.and_then(ValidationRow::in_tolerances);
    off.map_or_else(Cell::none, |off| Cell::plain(format!("{off:.1}")))
}

/// What a second reading gives: its difference, and whether that is within the tolerance.
fn second(line: &StatementLine<'_>) -> Cell {
    let (Some(answer), Some(row)) = (&line.judged.second, line.second) else {
        return Cell::default();
    };
    let off = table::percent(row).text;
    match answer {
        Answer::Agrees(RowKind::Fitted) => Cell::new(format!("{off} fitted"), CellStyle::Warn),
        Answer::Agrees(_) => Cell::new(format!("{off} PASS"), CellStyle::Good),
        _ => Cell::new(format!("{off} no"), CellStyle::Warn),
    }
}

/// Statements that agree, a line each.
fn results(title: &str, lines: &[&StatementLine<'_>]) -> Table {
    Table::of_records(title, lines)
        .text("printed", |line| line.says())
        .cell("computed", Align::Right, |line| {
            line.row.map_or_else(Cell::none, table::computed)
        })
        .cell("% off", Align::Right, |line| {
            line.row.map_or_else(Cell::none, table::percent)
        })
        .cell("tol.", Align::Right, |line| tolerances(line.row))
        .cell("kind", Align::Left, |line| {
            line.row.map_or_else(Cell::default, table::kind)
        })
        .build()
}

/// The notes of the rows, each once.
fn notes(lines: &[&StatementLine<'_>]) -> impl Iterator<Item = String> {
    let mut said: Vec<String> = Vec::new();
    for line in lines {
        let Some(note) = line.row.and_then(|row| row.note.as_deref()) else {
            continue;
        };
        let note = format!("Note: {}", note.trim());
        if !said.contains(&note) {
            said.push(note);
        }
    }
    said.into_iter()
}

fn inputs_and_equations(statements: &[JudgedStatement<'_>]) -> Vec<Block> {
    let of = |wanted: &dyn Fn(&Answer) -> bool| {
        statements
            .iter()
            .filter(|one| wanted(&one.answer))
            .collect::<Vec<_>>()
    };
    let says = |one: &&JudgedStatement<'_>| {
        format!("{}: {}", one.statement.printed_in, one.statement.says)
    };
    let mut blocks = Vec::new();
    let equations = of(&|a| *a == Answer::Equation);
    if !equations.is_empty() {
        let table = Table::of_records("Equations and methods", &equations)
            .text("printed", says)
            .text("code", |one| one.statement.code.clone().unwrap_or_default())
            .text("test", |one| one.statement.test.clone().unwrap_or_default())
            .build();
        blocks.push(Block::Table(table));
    }
    let inputs = of(&|a| *a == Answer::Input);
    if !inputs.is_empty() {
        let table = Table::of_records("Inputs", &inputs)
            .text("printed", says)
            .text("key", |one| one.statement.input.clone().unwrap_or_default())
            .build();
        blocks.push(Block::Table(table));
    }
    blocks
}
