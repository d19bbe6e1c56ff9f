//! A file of water kinematics of `MoorDyn` in OpenFAST (`WaterKin`), of which a steady current is taken.
//!
//! As `setupWaterKin` of modules/moordyn/src/MoorDyn_Misc.f90 reads it: `WaveKinMod` 0 has no waves, 1 a history of elevations, 2 the waves
//! of the host; `CurrentMod` 0 has no current, 1 the table z, x, y in the file, 2 the current of the host. Between its rows the current
//! is linear, beyond them constant. Values are looked for by their names, which stand behind them, or else by the lines of the form.

use crate::import::fault::Fault;
use crate::import::mooring::{MooringCurrent, Unmodelled};
use crate::import::words::{Row, Word};

/// The line of `WaveKinMod` and of `CurrentMod`, from 0, where nothing names them.
const WAVES_AT: usize = 3;
/// See [`WAVES_AT`].
const CURRENT_AT: usize = 14;
/// Lines behind `CurrentMod` that are passed over, and how many more may be no rows.
const HEADERS: usize = 2;
/// See [`HEADERS`].
const MORE_HEADERS: usize = 3;
/// Rows of a current that `MoorDyn` reads at most.
const MOST_ROWS: usize = 100;

/// What a file of water kinematics has.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WaterKinematics {
    /// A steady current.
    pub current: Option<MooringCurrent>,
    /// What is not modelled.
    pub unmodelled: Vec<Unmodelled>,
    /// What is said of it.
    pub remarks: Vec<String>,
}

/// Reads the text of a file that stands at an option; `depths_too` where a z above 0 is a depth.
///
/// # Errors
/// What is wrong, at the option, with its line in words.
pub fn read(
    text: &str,
    (at, key): (Word<'_>, &str),
    depths_too: bool,
) -> Result<WaterKinematics, Fault> {
    let name = at.text.trim_matches(['"', '\'']);
    let rows: Vec<Row<'_>> = Row::all(text).collect();
    let wrong = |line: usize, problem: &str, remedy: &str| {
        let problem = format!("in `{name}`, line {}: {problem}", line + 1);
        Fault::new(at.span(), key, problem, remedy)
    };
    let mut found = WaterKinematics::default();
    let mut put = |name: &'static str, what: &str| {
        found.unmodelled.push(Unmodelled {
            name,
            span: at.span(),
            key: key.to_owned(),
            what: what.to_owned(),
        });
    };
    let (line, waves) = value(&rows, "WaveKinMod", WAVES_AT);
    match waves.map(|word| (word.number(), word.is("SEASTATE"))) {
        Some((Some(0.0), _)) => {}
        Some((Some(1.0), _)) => put(
            "waves",
            "waves by a history of elevations as long as the run of the host (WaveKinMod 1)",
        ),
        Some((Some(2.0), _) | (_, true)) => put("waves", "waves of the host (WaveKinMod 2)"),
        _ => {
            let problem = "WaveKinMod is not 0, 1 or 2";
            return Err(wrong(line, problem, "write `0 WaveKinMod` on line 4"));
        }
    }
    let (line, current) = value(&rows, "CurrentMod", CURRENT_AT);
    match current.and_then(|word| word.number()) {
        Some(0.0) => {}
        Some(1.0) => {
            found.current = Some(steady_current((&rows, line), name, depths_too, wrong)?);
        }
        Some(2.0) => put("currents", "the current of the host (CurrentMod 2)"),
        _ => {
            let problem = "CurrentMod is not 0, 1 or 2";
            return Err(wrong(line, problem, "write `1 CurrentMod` on line 15"));
        }
    }
    if found.current.is_some() && waves.and_then(|word| word.number()) == Some(0.0) {
        found.remarks.push(format!(
            "Of `{name}` the current is taken; dtWave, WaveDir and the grid are those of waves, of which it has none."
        ));
    }
    Ok(found)
}

/// The current of the table behind a line; `wrong` makes a fault of a line, a problem and its remedy.
fn steady_current(
    (rows, line): (&[Row<'_>], usize),
    name: &str,
    depths_too: bool,
    wrong: impl Fn(usize, &str, &str) -> Fault,
) -> Result<MooringCurrent, Fault> {
    let table = table(rows, line);
    let Some((first, _)) = table.first() else {
        let problem = "no row of numbers follows CurrentMod";
        return Err(wrong(line, problem, "write rows z, x-current, y-current"));
    };
    let sign = sign(&table, depths_too).ok_or_else(|| {
        let problem = "a height z is above the water";
        let remedy = "give heights from still water up, 0 or below: -20 at a depth of 20 m";
        wrong(*first, problem, remedy)
    })?;
    Ok(profile(name, &table, sign))
}

/// The line, from 0, and the first word of the row that names a value; else those of the line where the form has it.
fn value<'t>(rows: &[Row<'t>], name: &str, at: usize) -> (usize, Option<Word<'t>>) {
    let words = rows.iter().map(Row::words).enumerate();
    let mut named = words.filter(|(_, words)| words.get(1).is_some_and(|word| word.is(name)));
    match named.next() {
        Some((line, words)) => (line, words.first().copied()),
        None => (
            at,
            rows.get(at).and_then(|row| row.words().first().copied()),
        ),
    }
}

/// The rows z, x, y behind a line, each with its line.
fn table(rows: &[Row<'_>], behind: usize) -> Vec<(usize, [f64; 3])> {
    let row = |line: usize| {
        let words = rows.get(line)?.words();
        let numbers = [0, 1, 2].map(|k| words.get(k).and_then(Word::number));
        let [z, x, y] = numbers;
        Some([z?, x?, y?])
    };
    let start = behind + 1 + HEADERS;
    let first = (start..=start + MORE_HEADERS).find(|line| row(*line).is_some());
    let all = first.map_or(0..0, |first| first..rows.len().min(first + MOST_ROWS));
    all.map_while(|line| Some((line, row(line)?))).collect()
}

/// What heights are multiplied by: 1, or -1 where all are depths and may be; nothing where they are above the water.
fn sign(rows: &[(usize, [f64; 3])], depths_too: bool) -> Option<f64> {
    match rows {
        rows if rows.iter().all(|(_, [z, ..])| *z <= 0.0) => Some(1.0),
        rows if depths_too && rows.iter().all(|(_, [z, ..])| *z >= 0.0) => Some(-1.0),
        _ => None,
    }
}

fn profile(name: &str, rows: &[(usize, [f64; 3])], sign: f64) -> MooringCurrent {
    let rows = rows.iter().map(|(_, [z, x, y])| [sign * z, *x, *y]);
    let mut rows: Vec<[f64; 3]> = rows.collect();
    rows.sort_by(|a, b| b[0].total_cmp(&a[0]));
    MooringCurrent {
        file: name.to_owned(),
        rows,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "a\nb\n--- WAVES ---\n0 WaveKinMod\n\"\" WaveKinFile\n0.5 dtWave\n0 WaveDir\n2 - X\n-1, 1, 2\n2 - Y\n-1, 1, 2\n\
        2 - Z\n-100, 0, 2\n--- CURRENT ---\n1 CurrentMod\nz x y\n(m) (m/s) (m/s)\n0 0.8 0\n-100 0.4 0.1\n--- end ---\n";

    fn read_text(text: &str) -> Result<WaterKinematics, Fault> {
        let at = Word {
            text: "\"WaterKin.dat\"",
            start: 7,
        };
        read(text, (at, "OPTIONS, WaterKin"), false)
    }

    #[test]
    fn the_current_is_found_by_name_and_by_line() {
        let rows = |text: &str| read_text(text).unwrap().current.unwrap().rows;
        let plain = rows(FILE);
        assert_eq!(plain, [[0.0, 0.8, 0.0], [-100.0, 0.4, 0.1]]);
        assert_eq!(
            rows(&FILE.replace(" WaveKinMod", "").replace(" CurrentMod", "")),
            plain
        );
        assert_eq!(
            rows(&FILE.replace("0 0.8 0\n", "2 - type\n-100, 0, 9\n0 0.8 0\n")),
            plain
        );
    }

    #[test]
    fn what_is_not_in_the_file_is_said() {
        let names = |text: &str| -> Vec<&str> {
            let all = read_text(text).unwrap().unmodelled;
            all.iter().map(|one| one.name).collect()
        };
        assert!(names(FILE).is_empty());
        assert_eq!(
            names(&FILE.replace("0 WaveKinMod", "1 WaveKinMod")),
            ["waves"]
        );
        assert_eq!(
            names(&FILE.replace("1 CurrentMod", "2 CurrentMod")),
            ["currents"]
        );
        let wrong = |of: &str, by: &str| read_text(&FILE.replace(of, by)).unwrap_err().problem;
        assert!(wrong("-100 0.4", "100 0.4").contains("above the water"));
        assert!(wrong("0 WaveKinMod", "7 WaveKinMod").contains("line 4"));
        assert!(wrong("0 0.8 0\n-100 0.4 0.1\n", "").contains("no row"));
    }
}
