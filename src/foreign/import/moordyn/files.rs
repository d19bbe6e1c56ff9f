//! Files that a MoorDyn file names: curves of tension over strain, Syrope ropes, currents, waves.

use std::path::{Path, PathBuf};

use crate::case::read_current;
use crate::files::root;
use crate::import::fault::Fault;
use crate::import::mooring::{CurrentFile, PolyesterCurve, WaveComponent, WorkingForm};
use crate::import::words::{Row, Word};

/// The file of a current by height.
pub const PROFILE: &str = "current_profile.txt";

/// Where files that a file names are looked for.
#[derive(Debug, Clone)]
pub struct Files<'p> {
    /// The folder of the file that names them.
    pub folder: &'p Path,
}

/// Rows z, x, y of a current, and the first of a file that does not list them from below.
pub type ProfileRows = (Vec<[f64; 3]>, Option<[f64; 3]>);

impl Files<'_> {
    /// The text of a file named at a place: below the folder by its whole path, or by its last part.
    ///
    /// # Errors
    /// It is not there, too large or no text.
    pub fn text(&self, name: Word<'_>, key: &str) -> Result<String, Fault> {
        let path = self.path(name.text).ok_or_else(|| {
            Fault::new(
                name.span(),
                key,
                format!("there is no file `{}` beside this one", name.text),
                "put it there, or correct its name",
            )
        })?;
        let unreadable = |why: String| {
            Fault::new(
                name.span(),
                key,
                format!("the file `{}` cannot be read: {why}", name.text),
                "check the file",
            )
        };
        let text = root::place_at(self.folder, &path).and_then(|place| place.text_lossy());
        text.map_err(|error| unreadable(error.to_string()))
    }

    /// Where a file lies that is named, if it is there.
    #[must_use]
    pub fn path(&self, name: &str) -> Option<PathBuf> {
        let name = name.trim_matches(['"', '\'']);
        let whole = self.folder.join(name);
        let last = Path::new(name)
            .file_name()
            .map(|last| self.folder.join(last));
        [Some(whole), last]
            .into_iter()
            .flatten()
            .find(|path| path.is_file())
    }

    /// Strains and tensions \[N\] of a file, rising, from zero.
    ///
    /// # Errors
    /// It cannot be read, or its rows do not rise.
    pub fn curve(&self, name: Word<'_>, key: &str) -> Result<Vec<[f64; 2]>, Fault> {
        let text = self.text(name, key)?;
        let mut points = vec![[0.0, 0.0]];
        let rows = numbers_of(&text, 2).map_err(|why| in_file(name.text, &why, name, key))?;
        for (line, numbers) in rows {
            let [strain, tension] = [numbers[0], numbers[1]];
            if strain == 0.0 && tension == 0.0 && points.len() == 1 {
                continue;
            }
            let last = points[points.len() - 1];
            if strain <= last[0] || tension <= last[1] {
                return Err(Fault::new(
                    name.span(),
                    key,
                    format!(
                        "line {line} of `{}` does not rise: strain {strain}, tension {tension}",
                        name.text
                    ),
                    "strains and tensions rise from row to row",
                ));
            }
            points.push([strain, tension]);
        }
        match points.len() {
            0..3 => Err(Fault::new(
                name.span(),
                key,
                format!("`{}` has no two rows of strain and tension", name.text),
                "write a strain and a tension in N on each row",
            )),
            _ => Ok(points),
        }
    }

    /// The working curve of a Syrope rope and the curve of its first loading.
    ///
    /// # Errors
    /// A file cannot be read, or lacks an entry.
    pub fn syrope(
        &self,
        name: Word<'_>,
        key: &str,
    ) -> Result<(PolyesterCurve, Vec<[f64; 2]>), Fault> {
        let text = self.text(name, key)?;
        let wrong = |problem: String| {
            let remedy = "it has rows for OWC, WCType (LINEAR, QUADRATIC or EXP), k1 and k2, each value before its name";
            Fault::new(name.span(), key, problem, remedy)
        };
        let entry = |wanted: &str| {
            let mut rows = Row::all(&text).map(|row| row.words());
            let found = rows.find_map(|words| match words.as_slice() {
                [value, entry, ..] if entry.is(wanted) => Some(*value),
                _ => None,
            });
            found.ok_or_else(|| wrong(format!("`{}` does not give {wanted}", name.text)))
        };
        let number = |wanted: &str| {
            let given = entry(wanted)?;
            given.number().ok_or_else(|| {
                let (file, text) = (name.text, given.text);
                wrong(format!("{wanted} in `{file}` is `{text}`, not a number"))
            })
        };
        let form = match entry("WCType")?.text.to_uppercase().as_str() {
            "LINEAR" => WorkingForm::Linear,
            "QUADRATIC" => WorkingForm::Quadratic,
            "EXP" => WorkingForm::Exponential,
            other => return Err(wrong(format!("WCType in `{}` is `{other}`", name.text))),
        };
        let working = PolyesterCurve {
            form,
            k1: number("k1")?,
            k2: number("k2")?,
        };
        let first_loading = self.curve(entry("OWC")?, key);
        // What is wrong with the curve is shown where its file is named.
        first_loading
            .map(|curve| (working, curve))
            .map_err(|fault| at_option(fault, name))
    }

    /// A current by height: z, x, y from a profile of rows z, x, y, z, sorted from above, and its first row where the file has its rows in
    /// another order than from below.
    ///
    /// # Errors
    /// The file is not there or has no rows, or currents up or down.
    pub fn current(&self, at: Word<'_>, key: &str) -> Result<ProfileRows, Fault> {
        let name = Word {
            text: PROFILE,
            ..at
        };
        let text = self.text(name, key).map_err(|fault| at_option(fault, at))?;
        let rows = numbers_of(&text, 2).map_err(|why| in_file(name.text, &why, at, key))?;
        let rows = rows.into_iter().map(|(line, row)| {
            let part = |column: usize| row.get(column).copied().unwrap_or(0.0);
            match part(3) == 0.0 {
                true => Ok([row[0], row[1], part(2)]),
                false => Err(Fault::new(
                    at.span(),
                    key,
                    format!(
                        "line {line} of current_profile.txt has a current of {} m/s upwards",
                        part(3)
                    ),
                    "currents here are horizontal",
                )),
            }
        });
        let mut rows: Vec<[f64; 3]> = rows.collect::<Result<_, _>>()?;
        let falls = rows.windows(2).any(|pair| pair[1][0] < pair[0][0]);
        let first = rows.first().copied().filter(|_| falls);
        rows.sort_by(|a, b| b[0].total_cmp(&a[0]));
        Ok((rows, first))
    }

    /// A current over time and place, by a file of this name.
    ///
    /// # Errors
    /// The file is not there, or has a fault, shown where it is named.
    pub fn current_file(
        &self,
        at: Word<'_>,
        key: &str,
        name: &'static str,
    ) -> Result<CurrentFile, Fault> {
        let text = self.text(Word { text: name, ..at }, key);
        let text = text.map_err(|fault| at_option(fault, at))?;
        let grid = read_current(&text, name).map_err(|fault| {
            let problem = match fault.span.is_empty() {
                true => format!("{name} {}", fault.problem),
                false => format!("line {} of {name}: {}", fault.line, fault.problem),
            };
            Fault::new(at.span(), key, problem, fault.remedy)
        })?;
        Ok(CurrentFile {
            name,
            varies: grid.varies_in_time(),
            text,
        })
    }

    /// Waves by their components from rows of angular frequency, complex amplitude and, where it is given, direction \[rad\]. Elevations are
    /// cosines of the phase where `lag` is 0 \[rad\].
    ///
    /// # Errors
    /// The file is not there, has no rows, or a row that is none.
    pub fn waves(&self, at: Word<'_>, key: &str, lag: f64) -> Result<Vec<WaveComponent>, Fault> {
        let file = "wave_frequencies.txt";
        let name = Word { text: file, ..at };
        let text = self.text(name, key).map_err(|fault| at_option(fault, at))?;
        let rows = numbers_of(&text, 3).map_err(|why| in_file(file, &why, at, key))?;
        if let Some((line, row)) = rows.iter().find(|(_, row)| row[0] < 0.0) {
            let why = format!("line {line}: the frequency {} is negative", row[0]);
            return Err(in_file(file, &why, at, key));
        }
        let components = rows.iter().filter_map(|(_, row)| {
            let (frequency, amplitude) = (row[0], f64::hypot(row[1], row[2]));
            (frequency > 0.0 && amplitude > 0.0).then(|| WaveComponent {
                frequency,
                amplitude,
                phase: row[2].atan2(row[1]) - lag,
                direction: row.get(3).copied().unwrap_or(0.0),
            })
        });
        Ok(components.collect())
    }
}

/// The rows of numbers of a file, with their line numbers: titles may stand before the first, and every row behind it has so many
/// numbers at least.
///
/// # Errors
/// What is wrong, with its line, or that there is no row.
fn numbers_of(text: &str, least: usize) -> Result<Vec<(usize, Vec<f64>)>, String> {
    let mut rows: Vec<(usize, Vec<f64>)> = Vec::new();
    for (line, row) in (1..).zip(Row::all(text)) {
        let words = row.words();
        let begins = words
            .first()
            .is_some_and(|word| plain(*word).number().is_some());
        if words.is_empty() || !begins && rows.is_empty() {
            continue;
        }
        let numbers = words.iter().map(|word| {
            let word = plain(*word);
            word.number()
                .ok_or_else(|| format!("line {line}: `{}` is not a number", word.text))
        });
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
        if numbers.len() < least {
            return Err(format!(
                "line {line} has {} numbers where {least} are needed",
                numbers.len()
            ));
        }
        rows.push((line, numbers));
    }
    match rows.is_empty() {
        true => Err("it has no rows of numbers".to_owned()),
        false => Ok(rows),
    }
}

/// A word without the comma behind it.
fn plain(word: Word<'_>) -> Word<'_> {
    Word {
        text: word.text.trim_end_matches(','),
        ..word
    }
}

/// What is wrong with a file, where it is named.
fn in_file(file: &str, why: &str, at: Word<'_>, key: &str) -> Fault {
    Fault::new(
        at.span(),
        key,
        format!("in `{file}`: {why}"),
        "correct the file",
    )
}

/// A fault of a file that is not named where it shows, but here.
fn at_option(fault: Fault, at: Word<'_>) -> Fault {
    Fault {
        span: at.span(),
        ..fault
    }
}
