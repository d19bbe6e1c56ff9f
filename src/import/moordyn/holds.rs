//! What holds a point, rod or body, and what lines are attached to, by the words of the tables.

use super::sections::Section;
use super::table::TableRow;
use crate::import::fault::Fault;
use crate::import::mooring::{Attachment, Given, Hold, Mooring};

const FIXED: [&str; 4] = ["fixed", "fix", "anchor", "ground"];
const COUPLED: [&str; 5] = ["coupled", "vessel", "ves", "cpld", "fairlead"];
const FREE: [&str; 7] = ["free", "connect", "con", "point", "p", "rod", "r"];
const PINNED: [&str; 2] = ["pinned", "pin"];

/// What holds a part, by a word such as `Fixed`, `Body2`, `CoupledPinned`.
///
/// # Errors
/// The word is not known, or names a body that is not there.
pub fn hold(
    row: &TableRow<'_, '_>,
    column: usize,
    mooring: &Mooring,
) -> Result<Given<Hold>, Fault> {
    let word = row.words[column];
    let lower = word.text.to_lowercase();
    let given = |hold| Ok(Given::new(hold, word.span()));
    if PINNED.contains(&lower.as_str()) {
        return given(Hold::Pinned(Box::new(Hold::Fixed)));
    }
    let (base, pinned) = match PINNED.iter().find_map(|end| lower.strip_suffix(end)) {
        Some(base) => (base, true),
        None => (lower.as_str(), false),
    };
    let of_turbine = turbine(base);
    let numbered = match of_turbine {
        Some(number) if mooring.turbines > 0 => Some(number),
        Some(_) => None,
        None => base.strip_prefix("body"),
    };
    let base = of_turbine.map_or(base, |_| "coupled");
    let hold = if let Some(number) = numbered {
        let found = mooring
            .bodies
            .iter()
            .position(|body| same(&body.id, number));
        Hold::Body(found.ok_or_else(|| missing(row, column, Section::Bodies, number))?)
    } else if FIXED.contains(&base) {
        Hold::Fixed
    } else if COUPLED.contains(&base) || base.is_empty() {
        Hold::Coupled
    } else if FREE.contains(&base) {
        Hold::Free
    } else {
        return Err(row.fault(
            column,
            format!("`{}` does not say what holds it", word.text),
            "it is Fixed, Free, Coupled (Vessel), or Body with the number of a body",
        ));
    };
    match pinned {
        true => given(Hold::Pinned(Box::new(hold))),
        false => given(hold),
    }
}

/// The number of a turbine in the words of a wind farm: `turbine1`. Without an array of turbines it is coupled.
pub fn turbine(word: &str) -> Option<&str> {
    let number = word
        .strip_prefix("turbine")
        .or_else(|| word.strip_prefix('t'))?;
    let number = number.strip_suffix("coupled").unwrap_or(number);
    let is_number = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some(number)
}

/// What an end of a line is attached to: `3`, `Point3`, `R2A`.
///
/// # Errors
/// The word is not known, or names what is not there.
pub fn attachment(
    row: &TableRow<'_, '_>,
    column: usize,
    mooring: &Mooring,
) -> Result<Given<Attachment>, Fault> {
    let word = row.words[column];
    let lower = word.text.to_lowercase();
    let rod = lower
        .strip_prefix("rod")
        .or_else(|| lower.strip_prefix('r'));
    if let Some(rest) = rod {
        let digits = rest
            .find(|letter: char| !letter.is_ascii_digit())
            .unwrap_or(rest.len());
        let (number, end) = rest.split_at(digits);
        let end = match end {
            "a" => 0,
            "b" => 1,
            _ => {
                return Err(row.fault(
                    column,
                    format!("`{}` does not say which end of the rod", word.text),
                    format!("write R{number}A or R{number}B"),
                ));
            }
        };
        let found = mooring.rods.iter().position(|rod| same(&rod.id, number));
        let rod = found.ok_or_else(|| missing(row, column, Section::Rods, number))?;
        return Ok(Given::new(Attachment::Rod(rod, end), word.span()));
    }
    let plain = ["point", "con", "p", "c", "n"];
    let number = plain
        .iter()
        .find_map(|prefix| lower.strip_prefix(prefix))
        .unwrap_or(&lower);
    let found = mooring
        .points
        .iter()
        .position(|point| same(&point.id, number));
    let point = found.ok_or_else(|| missing(row, column, Section::Points, number))?;
    Ok(Given::new(Attachment::Point(point), word.span()))
}

/// Whether two identifiers are the same; `01` is 1.
pub fn same(id: &str, other: &str) -> bool {
    match (id.parse::<u64>(), other.parse::<u64>()) {
        (Ok(one), Ok(two)) => one == two,
        _ => id.eq_ignore_ascii_case(other),
    }
}

/// A reference to a row of a section that is not there.
pub fn missing(row: &TableRow<'_, '_>, column: usize, section: Section, number: &str) -> Fault {
    let what = section.of_one();
    let fault = row.fault(
        column,
        format!("there is no {what} `{number}`"),
        format!("give the number of a {what} of its table"),
    );
    Fault {
        refers_to: Some(Box::new((section.title(), number.to_owned()))),
        ..fault
    }
}
