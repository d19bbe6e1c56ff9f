//! Compares the numbers of two builds of the program, bit by bit.
//!
//! ```text
//! cargo run --release --example numbers -- record target/release/seacable -o before.tsv
//! cargo run --release --example numbers -- compare before.tsv target/release/seacable
//! ```
//!
//! `record` computes every shipped case with the given binary and writes one line for each number or column of
//! numbers: every column of every stored history, profile and shape (matched by its name, as a digest of its text,
//! which reads back to the same bits), every value and error of every summary, every count of work, every row of
//! `validate` and `study hard-cases`, and what the other commands print on the shipped cross-sections, ships and
//! ropeways. Words are left out: texts may be reworded. `compare` takes a record or a binary on either side and lists
//! what differs; the exit status is 1 when anything does.

#![expect(clippy::print_stdout, reason = "a command prints")]

use std::{
    collections::BTreeMap,
    error::Error,
    fs,
    path::{Path, PathBuf},
    process::{Command, ExitCode},
};

type Numbers = BTreeMap<(String, String), String>;
type Fallible<T> = Result<T, Box<dyn Error>>;

/// How many differences are listed.
const LISTED: usize = 40;

/// CSV files of a run that hold a column for each quantity.
const COLUMNS: [&str; 4] = ["history.csv", "profile.csv", "shapes.csv", "ropes.csv"];

/// CSV files of a run that hold a row for each quantity.
const ROWS: [&str; 3] = ["summary.csv", "errors.csv", "channels.csv"];

fn main() -> Fallible<ExitCode> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["record", binary, "-o", file] => {
            fs::write(file, text(&record(Path::new(binary))?))?;
            Ok(ExitCode::SUCCESS)
        }
        ["compare", before, after] => Ok(compare(&numbers(before)?, &numbers(after)?)),
        _ => {
            eprintln!("usage: numbers record BINARY -o FILE | numbers compare BEFORE AFTER");
            Ok(ExitCode::from(2))
        }
    }
}

/// The numbers of a record, or of a binary.
fn numbers(of: &str) -> Fallible<Numbers> {
    if Path::new(of).extension().is_some_and(|e| e == "tsv") {
        let fields = |line: &str| -> Option<((String, String), String)> {
            let mut parts = line.split('\t').map(str::to_owned);
            Some(((parts.next()?, parts.next()?), parts.next()?))
        };
        Ok(fs::read_to_string(of)?.lines().filter_map(fields).collect())
    } else {
        record(Path::new(of))
    }
}

fn text(numbers: &Numbers) -> String {
    let line =
        |((file, item), value): (&(String, String), &String)| format!("{file}\t{item}\t{value}\n");
    numbers.iter().map(line).collect()
}

fn compare(before: &Numbers, after: &Numbers) -> ExitCode {
    let mut differences = Vec::new();
    for (key, value) in before {
        match after.get(key) {
            None => differences.push(format!("{} {}: {value} is missing", key.0, key.1)),
            Some(other) if other != value => {
                differences.push(format!("{} {}: {value} is now {other}", key.0, key.1));
            }
            Some(_) => {}
        }
    }
    let new = after.keys().filter(|key| !before.contains_key(*key));
    differences.extend(new.map(|key| format!("{} {}: is new", key.0, key.1)));
    for difference in differences.iter().take(LISTED) {
        println!("{difference}");
    }
    if differences.is_empty() {
        println!("same: {} numbers and columns", before.len());
        return ExitCode::SUCCESS;
    }
    println!("{} of {} differ", differences.len(), before.len());
    ExitCode::FAILURE
}

fn record(binary: &Path) -> Fallible<Numbers> {
    let binary = fs::canonicalize(binary)?;
    let folder = std::env::temp_dir().join(format!("seacable-numbers-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let mut numbers = Numbers::new();
    for case in shipped(Path::new("cases"))? {
        of_file(&binary, &case, &folder, &mut numbers)?;
    }
    printed(&binary, &["validate"], "validate", &mut numbers)?;
    let table = folder.join("hard.csv");
    let table_name = table.to_string_lossy();
    Command::new(&binary)
        .args(["study", "hard-cases", "-o", &table_name])
        .output()?;
    for (i, line) in fs::read_to_string(&table)?.lines().enumerate() {
        keep_numbers(&mut numbers, "hard-cases", i, line);
    }
    fs::remove_dir_all(&folder)?;
    Ok(numbers)
}

/// Case files below a folder, in order.
fn shipped(folder: &Path) -> Fallible<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(shipped(&path)?);
        } else if path.extension().is_some_and(|e| e == "toml") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn of_file(binary: &Path, file: &Path, folder: &Path, numbers: &mut Numbers) -> Fallible<()> {
    let name = file.to_string_lossy();
    let text = fs::read_to_string(file)?;
    let has = |header: &str| text.lines().any(|line| line.trim() == header);
    for (header, command) in [
        ("[ship]", "ship"),
        ("[ropeway]", "ropeway"),
        ("[section]", "section"),
    ] {
        if has(header) {
            return printed(binary, &[command, &name], &name, numbers);
        }
    }
    let run = folder.join(name.replace('/', "-"));
    let run_name = run.to_string_lossy();
    Command::new(binary)
        .args(["run", &name, "--out", &run_name])
        .output()?;
    if has("method = \"static\"") {
        printed(binary, &["modes", &name], &format!("{name} modes"), numbers)?;
    }
    stored(&run, &name, numbers)
}

/// The numbers of a stored run; none where the case is refused.
fn stored(run: &Path, name: &str, numbers: &mut Numbers) -> Fallible<()> {
    if !run.is_dir() {
        numbers.insert((name.to_owned(), "run".to_owned()), "refused".to_owned());
        return Ok(());
    }
    for file in COLUMNS {
        let columns = columns(&run.join(file))?;
        let digests = columns.into_iter().map(|(column, cells)| {
            let value = format!("{} values, digest {:016x}", cells.len(), digest(&cells));
            ((name.to_owned(), format!("{file} {column}")), value)
        });
        numbers.extend(digests);
    }
    for file in ROWS {
        let Ok(text) = fs::read_to_string(run.join(file)) else {
            continue;
        };
        let mut rows = csv::Reader::from_reader(text.as_bytes());
        for row in rows.records() {
            let row = row?;
            let values: Vec<&str> = row.iter().skip(1).collect();
            numbers.insert(
                (name.to_owned(), format!("{file} {}", &row[0])),
                values.join(" "),
            );
        }
    }
    let info = fs::read_to_string(run.join("run.toml"))?;
    let work = info
        .split("[work]")
        .nth(1)
        .and_then(|rest| rest.split('[').next());
    for line in work
        .unwrap_or_default()
        .lines()
        .filter(|line| !line.is_empty())
    {
        let (key, value) = line.split_once(" = ").unwrap_or((line, ""));
        numbers.insert((name.to_owned(), format!("work {key}")), value.to_owned());
    }
    Ok(())
}

/// The columns of a CSV file, by name; none where the run has no such file.
fn columns(path: &Path) -> Fallible<Vec<(String, Vec<String>)>> {
    let Ok(text) = fs::read_to_string(path) else {
        return Ok(Vec::new());
    };
    let mut rows = csv::ReaderBuilder::new()
        .flexible(true)
        .from_reader(text.as_bytes());
    let mut columns: Vec<(String, Vec<String>)> = rows
        .headers()?
        .iter()
        .map(|name| (name.to_owned(), Vec::new()))
        .collect();
    for row in rows.records() {
        for (cell, column) in row?.iter().zip(&mut columns) {
            column.1.push(cell.to_owned());
        }
    }
    Ok(columns)
}

/// The numbers that a command prints, each with how often it stands there: rewording may wrap lines elsewhere.
fn printed(binary: &Path, words: &[&str], name: &str, numbers: &mut Numbers) -> Fallible<()> {
    let output = Command::new(binary)
        .args(words)
        .env("COLUMNS", "200")
        .output()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for number in text.lines().flat_map(numerals) {
        *counts.entry(number).or_default() += 1;
    }
    numbers.extend(counts.iter().map(|(number, count)| {
        let key = (name.to_owned(), format!("prints {number}"));
        (key, format!("{count} times"))
    }));
    Ok(())
}

fn keep_numbers(numbers: &mut Numbers, name: &str, i: usize, line: &str) {
    let kept = numerals(line).collect::<Vec<_>>().join(" ");
    if !kept.is_empty() {
        numbers.insert((name.to_owned(), format!("row {i}")), kept);
    }
}

/// The decimal numbers and the verdicts in a line, without the words between them; whole numbers without a point are
/// left out, since notes are numbered.
fn numerals(line: &str) -> impl Iterator<Item = &str> {
    let is_number = |word: &&str| {
        word.contains('.') && word.parse::<f64>().is_ok()
            || ["PASS", "FAIL", "DIFFERS", "OK", "REFUSED", "WRONG"].contains(word)
    };
    let split = |c: char| c.is_whitespace() || [',', '|', ';', '(', ')', ':'].contains(&c);
    line.split(split).filter(is_number)
}

/// FNV-1a over the cells of a column.
fn digest(cells: &[String]) -> u64 {
    let bytes = cells.iter().flat_map(|cell| cell.bytes().chain([b'\n']));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    })
}
