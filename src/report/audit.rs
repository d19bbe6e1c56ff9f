//! The page of an audit, and its findings as a table.

use super::chart::Glyphs;
use super::document::Report;
use super::table::{NumberFormat, Table};
use super::text::WIDTH;
use seacable_base::number::{digits, percent, si, with_error};
use seacable_foreign::audit::finding::AuditFinding;
use seacable_foreign::audit::lumped::relaxation::Ended;
use seacable_foreign::audit::mesh::LineAudit;
use seacable_foreign::audit::start::StartAudit;
use seacable_foreign::audit::step::{StepAudit, StepByRk2};
use seacable_foreign::audit::{Audit, settings};
use seacable_foreign::import::mooring::Program;

/// Lines of the table at most: the rest of many is left to `seacable run`.
const LINES: usize = 12;

/// The audit as one page of text.
#[must_use]
pub fn page(audit: &Audit) -> String {
    let mut page = Report::default();
    let name = std::path::Path::new(&audit.file).file_name();
    let name = name.map_or_else(|| audit.file.clone(), |name| name.to_string_lossy().into());
    page.title(&format!(
        "Audit of {name}, a file of {}",
        audit.program.name()
    ));
    page.paragraph(&summary(audit));
    if !audit.left_out.is_empty() {
        page.paragraph(&format!(
            "LEFT OUT, as asked for: {}.",
            audit.left_out.join(", ")
        ));
    }
    if !audit.findings.is_empty() {
        page.heading("Findings");
        for (number, finding) in audit.findings.iter().enumerate() {
            page.paragraph(&words(audit, number + 1, finding));
        }
    }
    page.heading("Computed");
    if !audit.lines.is_empty() {
        page.close_table(lines(audit));
    }
    if !audit.starts.is_empty() {
        page.close_table(starts(&audit.starts));
    }
    if let Some(step) = &audit.step {
        page.paragraph(&step_words(step));
    }
    for what in &audit.not_judged {
        page.paragraph(&format!("Not judged: {what}"));
    }
    page.to_text(WIDTH, Glyphs::Braille)
}

fn summary(audit: &Audit) -> String {
    let count = match audit.findings.len() {
        0 => "Nothing was found.".to_owned(),
        1 => "1 finding.".to_owned(),
        count => format!("{count} findings."),
    };
    let tensions = audit.lines.iter().filter_map(|line| {
        let tension = line.tension?;
        Some((tension, line))
    });
    let greatest = tensions.max_by(|one, other| one.0.total_cmp(&other.0));
    match greatest {
        Some((tension, line)) => format!(
            "{count} The system rests; the greatest tension at an end B is {}, of line {}.",
            with_error(tension, line.error, "N"),
            line.id
        ),
        None => format!("{count} The system has no equilibrium that was found."),
    }
}

/// A finding in words: where, what, and what to do.
fn words(audit: &Audit, number: usize, finding: &AuditFinding) -> String {
    let place = match &finding.span {
        Some(span) => {
            let (line, column) = settings::row_and_column(&audit.text, span);
            format!("line {line}, column {column}, ")
        }
        None => String::new(),
    };
    format!(
        "{number}. {} ({place}{}): {}. Remedy: {}.",
        finding.topic.name(),
        finding.subject,
        finding.what.trim_end_matches('.'),
        finding.remedy.trim_end_matches('.')
    )
}

/// A share, of which hundredths of a percent count.
fn share(value: f64) -> String {
    match value.abs() < 5e-5 {
        true => "0 %".to_owned(),
        false => percent(value),
    }
}

/// A figure of a relaxation; a dash for one that diverged.
fn of_start(start: &StartAudit, words: impl Fn(&StartAudit) -> String) -> String {
    match start.ended {
        Some((_, Ended::Diverged)) => "-".to_owned(),
        _ => words(start),
    }
}

fn curvature(line: &LineAudit, which: usize) -> String {
    let value = line.curvature.map(|both| both[which]);
    value.map_or_else(|| "-".to_owned(), |value| digits(value, 4))
}

fn lines(audit: &Audit) -> Table {
    let all: Vec<&LineAudit> = audit.lines.iter().take(LINES).collect();
    let tension = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| si(v, "N"));
    let is_divided = matches!(audit.program, Program::MoorDyn | Program::MoorDyn1);
    let bends = audit.lines.iter().any(|line| line.curvature.is_some());
    let table = Table::of_records("Tension at end B at rest", &all)
        .text("line", |line| line.id.as_str())
        .text("exact", |line| tension(line.tension))
        .when(is_divided, |table| {
            table
                .count("segments", |line| line.segments)
                .text("FairTen", |line| tension(line.mid_segment))
                .text("less by", |line| {
                    tension(
                        line.mid_segment
                            .zip(line.tension)
                            .map(|(mid, end)| end - mid),
                    )
                })
                .text("by segments", |line| {
                    line.by_segments().map_or_else(|| "-".to_owned(), share)
                })
        })
        .when(bends, |table| {
            table
                .text("curvature", |line| curvature(line, 0))
                .text("of fine mesh", |line| curvature(line, 1))
        })
        .build();
    let convention = match audit.program {
        Program::MoorDyn | Program::MoorDyn1 => {
            "FairTen: MoorDyn gives the tension in the middle of the last segment, less than that at the end by half a segment's weight; by segments: what the division adds to that."
        }
        _ => "The program gives tensions at the ends, as here.",
    };
    let more = audit.lines.len().saturating_sub(LINES);
    let more = (more > 0).then(|| format!("{more} more lines are not shown."));
    table
        .noted([convention])
        .noted(bends.then_some("curvature: the greatest, in 1/m, by the angles of the segments, and of a mesh 8 times as fine."))
        .noted(more)
}

fn starts(all: &[StartAudit]) -> Table {
    let table = Table::of_records("Start of a run", all)
        .text("by", |start| start.by)
        .text("ends", |start| match start.ended {
            None => "-".to_owned(),
            Some((time, Ended::Converged)) => format!("after {}", si(time, "s")),
            Some((time, Ended::OutOfTime | Ended::TooLong)) => {
                format!("at {}, unfinished", si(time, "s"))
            }
            Some((time, Ended::Diverged)) => format!("by {}, diverged", si(time, "s")),
        })
        .text("line", |start| {
            of_start(start, |one| format!("{} {}", one.line, one.end))
        })
        .text("tension", |start| {
            of_start(start, |one| si(one.tension, "N"))
        })
        .text("at rest", |start| {
            of_start(start, |one| si(one.at_rest, "N"))
        })
        .text("off", |start| of_start(start, |one| share(one.off)))
        .text("displaced", |start| {
            of_start(start, |one| si(one.displaced, "m"))
        });
    table
        .build()
        .noted(["Repeated on lumped masses; at rest: the same segments in equilibrium."])
}

fn step_words(step: &StepAudit) -> String {
    let origin = match step.is_given {
        true => "dtM",
        false => "the default by the Courant number",
    };
    let limit = match step.longest {
        Some(longest) => format!("stable up to {}", si(longest, "s")),
        None => "no step is stable without damping".to_owned(),
    };
    let axial = match &step.axial {
        Some((line, period, error)) => format!(
            " In the first axial mode of line {line}, {}, it leaves an error of the period of {}.",
            si(*period, "s"),
            percent(*error)
        ),
        None => String::new(),
    };
    let by_rk2 = step.by_rk2.as_ref().map_or_else(String::new, by_rk2_words);
    format!(
        "Time step: {} ({origin}), {}: {limit}; the fastest mode of the segments has {} rad/s and {} of critical damping.{axial}{by_rk2}",
        si(step.step, "s"),
        step.scheme,
        digits(step.fastest.frequency, 4),
        percent(step.fastest.damping)
    )
}

/// How the step does in `OpenFAST`, where the file is of a scheme that it does not have.
fn by_rk2_words(by_rk2: &StepByRk2) -> String {
    let judged = match (by_rk2.holds(), by_rk2.stable) {
        (true, _) => "the same dtM is stable".to_owned(),
        (false, Some(step)) => format!(
            "the same dtM is unstable; {} was tried and is stable",
            si(step, "s")
        ),
        (false, None) => "the same dtM is unstable, and so is a 4,096th of it".to_owned(),
    };
    format!(" By RK2, which MoorDyn in OpenFAST has alone, {judged}.")
}

/// The findings, one a row, with every digit.
#[must_use]
pub fn findings(audit: &Audit) -> Table {
    const EVERY_DIGIT: NumberFormat = NumberFormat::With(|value| format!("{value}"));
    let place = |finding: &AuditFinding| {
        let span = finding.span.as_ref();
        span.map(|span| settings::row_and_column(&audit.text, span))
    };
    let number = |value: Option<u32>| value.map_or_else(String::new, |value| value.to_string());
    Table::of_records("findings", &audit.findings)
        .text("topic", |finding| finding.topic.name())
        .text("line", |finding| number(place(finding).map(|at| at.0)))
        .text("column", |finding| number(place(finding).map(|at| at.1)))
        .text("subject", |finding| finding.subject.as_str())
        .number("value", EVERY_DIGIT, |finding| {
            finding.figure.map(|figure| figure.value)
        })
        .number("reference", EVERY_DIGIT, |finding| {
            finding.figure.map(|figure| figure.reference)
        })
        .text("unit", |finding| {
            finding.figure.map_or("", |figure| figure.unit)
        })
        .text("finding", |finding| finding.what.as_str())
        .text("remedy", |finding| finding.remedy.as_str())
        .build()
}
