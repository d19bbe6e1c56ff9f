//! Flags of a line. Outputs are all recorded anyway; contact with the bed and springs are physics.

use std::ops::Range;

use crate::case::nearest;
use crate::import::moordyn::table::TableRow;
use crate::import::words::Word;

/// The column in which they begin.
const COLUMN: usize = 5;

/// Flags that ask for outputs.
const OUTPUTS: [&str; 22] = [
    "gx_pos",
    "gy_pos",
    "gz_pos",
    "gx_a_pos",
    "gy_a_pos",
    "gz_a_pos",
    "gx_force",
    "gy_force",
    "gz_force",
    "h_fair",
    "h_anch",
    "v_fair",
    "v_anch",
    "tension_fair",
    "tension_anch",
    "x_excursion",
    "z_excursion",
    "azimuth",
    "altitude",
    "altitude_anch",
    "line_tension",
    "lay_length",
];

/// Flags with a number behind them.
const WITH_NUMBER: [&str; 3] = ["seg_size", "damage_time", "diagnostic"];

/// Other flags; `plot` is one of other programs that draw the line.
const OTHERS: [&str; 3] = ["omit_contact", "linear_spring", "plot"];

/// What the flags of a line state besides outputs.
#[derive(Debug, Default)]
pub struct Flags {
    /// Lines that are springs without weight.
    pub springs: Vec<String>,
    /// What has no effect.
    pub remarks: Vec<String>,
}

impl Flags {
    /// Reads the flags of a row; the place of the one by which the line has no contact with the bed.
    pub fn read(&mut self, row: &TableRow<'_, '_>) -> Option<Range<usize>> {
        let line = row.words[0].text;
        let mut without_bed = None;
        let mut words = row.words.iter().skip(COLUMN).peekable();
        while let Some(flag) = words.next() {
            let name = flag.text.to_lowercase();
            match name.as_str() {
                "linear_spring" => self.springs.push(line.to_owned()),
                "omit_contact" => without_bed = Some(flag.span()),
                "damage_time" => self.remarks.push(format!(
                    "Line {line}: the flag {} has no effect, as in MAP++: the line is not cut.",
                    flag.text
                )),
                name if is_known(name) => {}
                name => self.remarks.push(unknown(line, *flag, name)),
            }
            if WITH_NUMBER.contains(&name.as_str()) {
                words.next_if(|word| word.number().is_some());
            }
        }
        without_bed
    }
}

fn is_known(name: &str) -> bool {
    OUTPUTS.contains(&name) || WITH_NUMBER.contains(&name) || OTHERS.contains(&name)
}

fn unknown(line: &str, flag: Word<'_>, name: &str) -> String {
    let known = OUTPUTS.into_iter().chain(WITH_NUMBER).chain(OTHERS);
    let problem = format!(
        "Line {line}: the flag `{}` is not known and has no effect",
        flag.text
    );
    match nearest(name, known) {
        Some(near) => format!("{problem}; did you mean `{near}`?"),
        None => format!("{problem}."),
    }
}
