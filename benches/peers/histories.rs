//! Histories of the tensions at both ends of a line, and how far they are apart.

use std::collections::BTreeMap;
use std::path::Path;

/// Tensions at end A and end B \[N\] by time \[ms\].
pub(crate) type History = BTreeMap<i64, [f64; 2]>;

/// The key of a row at a time \[s\].
pub(crate) fn milliseconds(time: f64) -> i64 {
    (1e3 * time).round() as i64
}

/// The rows of time, end A and end B that a script printed.
pub(crate) fn printed(text: &str) -> History {
    let row = |line: &str| {
        let words = line.split_whitespace();
        let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
        (milliseconds(numbers[0]), [numbers[1], numbers[2]])
    };
    let rows = text.lines().filter(|line| !line.starts_with("inside"));
    rows.map(row).collect()
}

/// The history of a line in a stored run.
pub(crate) fn stored(run: &Path, line: &str) -> History {
    let mut rows = csv::Reader::from_path(run.join("history.csv")).unwrap();
    let names = rows.headers().unwrap().clone();
    let column = |name: String| names.iter().position(|other| other == name).unwrap();
    let [a, b] = ["a", "b"].map(|end| column(format!("tension_n[{line}|{end}]")));
    let row = |row: csv::StringRecord| {
        let [time, a, b] = [0, a, b].map(|column| row[column].parse::<f64>().unwrap());
        (milliseconds(time), [a, b])
    };
    rows.records().map(|read| row(read.unwrap())).collect()
}

/// Root mean square differences at end A and B by the peak there \[%\], at all times of both behind the start.
pub(crate) fn errors(of: &History, exact: &History) -> [f64; 2] {
    let pairs: Vec<_> = of
        .iter()
        .filter(|(time, _)| **time > 0)
        .filter_map(|(time, ends)| Some((ends, exact.get(time)?)))
        .collect();
    assert!(!pairs.is_empty());
    [0, 1].map(|end| {
        let peak = pairs.iter().map(|(_, b)| b[end]).fold(0.0, f64::max);
        let squares = pairs.iter().map(|(a, b)| (a[end] - b[end]).powi(2));
        100.0 * (squares.sum::<f64>() / pairs.len() as f64).sqrt() / peak
    })
}
