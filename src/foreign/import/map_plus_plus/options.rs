//! The section SOLVER OPTIONS: `repeat 120 240`; the others control a solver that is not used here.

use super::SectionBlock;
use crate::case::nearest;
use crate::import::fault::Fault;
use crate::import::mooring::{Given, Mooring, ProgramSetting};
use crate::import::words::{Row, Word};

/// The options of MAP++.
const NAMES: [&str; 21] = [
    "help",
    "inner_ftol",
    "inner_gtol",
    "inner_xtol",
    "inner_max_its",
    "outer_max_its",
    "outer_tol",
    "outer_epsilon",
    "integration_dt",
    "kb_default",
    "cb_default",
    "outer_bd",
    "outer_cd",
    "outer_fd",
    "wave_kinematics",
    "lm_model",
    "powell",
    "pg_cooked",
    "krylov_accelerator",
    "repeat",
    "ref_position",
];

/// Reads the options.
pub fn read(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    for (number, row) in block.rows.iter().enumerate() {
        let words = row.words();
        let Some(first) = words.first() else { continue };
        if number < 2 && is_header(*first) {
            continue;
        }
        match is_comment(row) {
            true => note_comment(row, *first, mooring),
            false => option(row, &words, mooring, faults),
        }
    }
}

/// The names of the columns, `Option`, and their units.
fn is_header(first: Word<'_>) -> bool {
    first.is("option") || first.is("options") || first.text.starts_with('(')
}

/// MAP++ takes the text before the first blank as the name of an option: a row that begins with a blank has none.
fn is_comment(row: &Row<'_>) -> bool {
    row.text.starts_with(char::is_whitespace)
}

/// Says that copies of the lines are not made. Comments on the solver change nothing here.
fn note_comment(row: &Row<'_>, first: Word<'_>, mooring: &mut Mooring) {
    if first.is("repeat") {
        mooring.remarks.push(format!(
            "`{}` begins with a blank, which makes it a comment in MAP++: nothing is repeated.",
            row.text.trim()
        ));
    }
}

fn option(row: &Row<'_>, words: &[Word<'_>], mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let Some(first) = words.first() else { return };
    let name = first.text.to_lowercase();
    if name == "repeat" {
        for word in &words[1..] {
            match word.required("SOLVER OPTIONS, repeat") {
                Ok(angle) => mooring.repeats.push(Given::new(angle, word.span())),
                Err(fault) => faults.push(fault),
            }
        }
    } else if name == "ref_position" {
        mooring.remarks.push(
            "The reference position of the option ref_position is not used: stiffness is about the origin."
                .to_owned(),
        );
    } else if NAMES.contains(&name.as_str()) {
        mooring.passed_over.push(first.text.to_owned());
    } else {
        mooring.remarks.push(unknown(first.text, &name));
    }
    mooring.settings.push(ProgramSetting {
        name,
        written: first.text.to_owned(),
        value: words
            .get(1)
            .map_or_else(String::new, |word| word.text.to_owned()),
        span: row.span(),
    });
}

fn unknown(written: &str, name: &str) -> String {
    let problem = format!("The option `{written}` is not known and has no effect");
    match nearest(name, NAMES) {
        Some(near) => format!("{problem}; did you mean `{near}`?"),
        None => format!("{problem}."),
    }
}
