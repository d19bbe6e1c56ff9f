//! What holds a point, rod or body, and what lines are attached to, by the words of the tables.

use super::sections::SectionTitle;
use super::table::TableRow;
use crate::import::fault::Fault;
use crate::import::index::Index;
use crate::import::listing::listed;
use crate::import::mooring::{Attachment, Given, Hold, Mooring};
use crate::import::words::Word;

const FIXED: [&str; 4] = ["fixed", "fix", "anchor", "ground"];
const COUPLED: [&str; 5] = ["coupled", "vessel", "ves", "cpld", "fairlead"];
const FREE: [&str; 7] = ["free", "connect", "con", "point", "p", "rod", "r"];
const PINNED: [&str; 2] = ["pinned", "pin"];

/// Words that `MoorDyn` takes with a number behind them, which has no effect.
const NUMBERED: [&str; 4] = ["free", "connect", "con", "point"];

/// A word in its parts, as `MoorDyn` cuts it: letters, a number, and what follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct WordParts<'w> {
    letters: &'w str,
    number: &'w str,
    more: &'w str,
}

impl<'w> WordParts<'w> {
    fn of_word(word: &'w str) -> Self {
        let end = |text: &str, of: fn(&char) -> bool| {
            text.find(|letter: char| !of(&letter)).unwrap_or(text.len())
        };
        let (letters, rest) = word.split_at(end(word, |letter| !letter.is_ascii_digit()));
        let (number, more) = rest.split_at(end(rest, char::is_ascii_digit));
        Self {
            letters,
            number,
            more,
        }
    }
}

/// What holds a part, by a word such as `Fixed`, `Body2`, `CoupledPinned`, `Coupled1`; `bodies` are those of the mooring.
///
/// # Errors
/// The word is not known, or names a body that is not there.
pub fn hold(
    row: &TableRow<'_, '_>,
    column: usize,
    (mooring, bodies): (&Mooring, &Index),
) -> Result<Given<Hold>, Fault> {
    let word = row.words[column];
    let lower = word.text.to_lowercase();
    let parts = WordParts::of_word(&lower);
    let given = |hold| Ok(Given::new(hold, word.span()));
    let pinned = |hold: Hold| Hold::Pinned(Box::new(hold));
    let is_pin = |word: &str| PINNED.contains(&word);
    if is_pin(parts.letters) && parts.more.is_empty() {
        return given(pinned(Hold::Fixed));
    }
    let on_body = |number: &str| {
        let body = bodies.find(number).map(Hold::Body);
        body.ok_or_else(|| missing(row, column, SectionTitle::Bodies, number))
    };
    let with_pin = |hold: Hold, is_pinned: bool| match is_pinned {
        true => given(pinned(hold)),
        false => given(hold),
    };
    let end = PINNED.iter().find_map(|end| lower.strip_suffix(end));
    if let Some(number) = turbine(end.unwrap_or(&lower)) {
        let hold = match mooring.turbines {
            0 => Hold::Coupled,
            _ => on_body(number)?,
        };
        return with_pin(hold, end.is_some());
    }
    if parts.letters == "body" {
        let hold = on_body(parts.number)?;
        return match parts.more.is_empty() || is_pin(parts.more) {
            true => with_pin(hold, !parts.more.is_empty()),
            false => Err(unknown(row, column)),
        };
    }
    let end = PINNED
        .iter()
        .find_map(|end| parts.letters.strip_suffix(end));
    let base = end.unwrap_or(parts.letters);
    let numbered = !parts.number.is_empty();
    let hold = if !parts.more.is_empty() {
        return Err(behind_number(row, column, &parts));
    } else if FIXED.contains(&base) {
        Hold::Fixed
    } else if COUPLED.contains(&base) {
        Hold::Coupled
    } else if NUMBERED.contains(&base) || !numbered && FREE.contains(&base) {
        Hold::Free
    } else {
        return Err(unknown(row, column));
    };
    with_pin(hold, end.is_some())
}

fn unknown(row: &TableRow<'_, '_>, column: usize) -> Fault {
    row.fault(
        column,
        format!("`{}` does not say what holds it", row.words[column].text),
        "it is Fixed, Free, Coupled (Vessel), or Body with the number of a body",
    )
}

/// The fault of a word with letters behind its number, which `MoorDyn` leaves out.
fn behind_number(row: &TableRow<'_, '_>, column: usize, parts: &WordParts<'_>) -> Fault {
    let known = [&FIXED[..], &COUPLED, &FREE].concat();
    if !known.contains(&parts.letters) {
        return unknown(row, column);
    }
    let (letters, more) = (parts.letters, parts.more);
    row.fault(
        column,
        format!(
            "`{}`: MoorDyn leaves out what stands behind the number, here `{more}`",
            row.words[column].text
        ),
        format!("write `{letters}{more}`, or `{letters}` as MoorDyn takes it"),
    )
}

/// The numbers behind words that say what holds a part, where they have no effect, in words.
pub fn idle_numbers<'w>(words: impl Iterator<Item = Word<'w>>) -> Option<String> {
    let mut found: Vec<&str> = Vec::new();
    for word in words {
        let lower = word.text.to_lowercase();
        let parts = WordParts::of_word(&lower);
        let names_another = parts.letters == "body" || turbine(&lower).is_some();
        if !parts.number.is_empty() && !names_another && !found.contains(&word.text) {
            found.push(word.text);
            if found.len() > MOST_WORDS {
                break;
            }
        }
    }
    let listed = listed(&found);
    (!found.is_empty()).then(|| format!("The number in {listed} has no effect, as in MoorDyn."))
}

/// Different words that are looked for at most.
const MOST_WORDS: usize = 20;

/// The number of a turbine in the words of a wind farm: `turbine1`. Without an array of turbines it is coupled.
pub fn turbine(word: &str) -> Option<&str> {
    let number = word
        .strip_prefix("turbine")
        .or_else(|| word.strip_prefix('t'))?;
    let number = number.strip_suffix("coupled").unwrap_or(number);
    let is_number = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some(number)
}

/// Points and rods by their identifiers, for the ends of lines.
#[derive(Debug, Clone, Default)]
pub struct Ends {
    points: Index,
    rods: Index,
}

impl Ends {
    /// Those of a mooring.
    #[must_use]
    pub fn of_mooring(mooring: &Mooring) -> Self {
        Self {
            points: Index::of_identifiers(mooring.points.iter().map(|point| point.id.as_str())),
            rods: Index::of_identifiers(mooring.rods.iter().map(|rod| rod.id.as_str())),
        }
    }
}

/// What an end of a line is attached to: `3`, `Point3`, `R2A`.
///
/// # Errors
/// The word is not known, or names what is not there.
pub fn attachment(
    row: &TableRow<'_, '_>,
    column: usize,
    ends: &Ends,
) -> Result<Given<Attachment>, Fault> {
    let word = row.words[column];
    let lower = word.text.to_lowercase();
    let rod = lower
        .strip_prefix("rod")
        .or_else(|| lower.strip_prefix('r'));
    if let Some(rest) = rod {
        let parts = WordParts::of_word(rest);
        let number = parts.number;
        let end = match (parts.letters, parts.more) {
            ("", "a") => 0,
            ("", "b") => 1,
            _ => {
                return Err(row.fault(
                    column,
                    format!("`{}` does not say which end of the rod", word.text),
                    format!("write R{number}A or R{number}B"),
                ));
            }
        };
        let rod = ends.rods.find(number);
        let rod = rod.ok_or_else(|| missing(row, column, SectionTitle::Rods, number))?;
        return Ok(Given::new(Attachment::Rod(rod, end), word.span()));
    }
    let number = point_number(&lower);
    let point = ends.points.find(number);
    let point = point.ok_or_else(|| missing(row, column, SectionTitle::Points, number))?;
    Ok(Given::new(Attachment::Point(point), word.span()))
}

/// The number of a point in its words: `3`, `point3`, `c3`.
#[must_use]
pub fn point_number(lower: &str) -> &str {
    let plain = ["point", "con", "p", "c", "n"];
    let mut found = plain.iter().filter_map(|prefix| lower.strip_prefix(prefix));
    found.next().unwrap_or(lower)
}

/// A reference to a row of a section that is not there.
pub fn missing(
    row: &TableRow<'_, '_>,
    column: usize,
    section: SectionTitle,
    number: &str,
) -> Fault {
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
