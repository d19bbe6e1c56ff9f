//! Files that a case uses: tables of numbers beside the case file, which go with it from then on.
//!
//! A case read from disk takes the text of every file it names into its [`Case::files`]; a run stores the case with
//! them ([`stand_alone`]), so that it needs nothing but itself. A case that holds `[files."NAME"]` never looks on disk.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use super::carried_text::CarriedText;
use super::diagnostic::{Diagnostic, Finding};
use super::file_kind::FileKind;
use super::model::{Attachment, CASE, Case, EndKind, MotionName, PublishedCurve};
use super::shipped;
use super::tree::TomlNode;
use crate::files::root;
use crate::physics::sea::DEGREES;
use crate::work_log::{self, Task};

/// Columns of a table of places over time.
pub const PLACES: [&str; 4] = ["time_s", "x_m", "y_m", "z_m"];

/// Columns of a table of a curve's points.
const POINTS: [&str; 2] = ["time_s", "value"];

/// Columns of a table of responses: period, then amplitude and phase of the six degrees of freedom.
pub fn response_columns() -> Vec<String> {
    let of = |(i, name): (usize, &&str)| {
        let unit = if i < 3 { "m_per_m" } else { "deg_per_m" };
        [format!("{name}_{unit}"), format!("{name}_phase_deg")]
    };
    let columns = DEGREES.iter().enumerate().flat_map(of);
    std::iter::once("period_s".to_owned())
        .chain(columns)
        .collect()
}

/// A file that is being read: its tree, its text, what it is called in diagnostics, the file that it is of, the folder it stands in, and files that
/// were read before.
#[derive(Clone, Copy)]
pub struct FileSource<'a> {
    /// Its tree.
    pub root: &'a TomlNode,
    /// Its text.
    pub text: &'a str,
    /// What it is called.
    pub file: &'a str,
    /// The file that it is of.
    pub of: &'a str,
    pub(crate) folder: &'a Path,
    pub(crate) known: &'a BTreeMap<String, Attachment>,
}

/// Takes in the files that the case uses, and reads them as what they are named for.
pub(crate) fn gather(
    case: &mut Case,
    root: &TomlNode,
    text: &str,
    (file, folder): (&str, &Path),
    known: &BTreeMap<String, Attachment>,
) -> Result<(), Diagnostic> {
    let reading = FileSource {
        root,
        text,
        file,
        of: file,
        folder,
        known,
    };
    gather_from(&reading, case).map_err(|found| reading.quoting_none_outside(found))
}

fn gather_from(reading: &FileSource<'_>, case: &mut Case) -> Result<(), Diagnostic> {
    for (letter, end) in [("a", case.ends.a.clone()), ("b", case.ends.b.clone())] {
        let used = end.kind == EndKind::Moving
            && matches!(end.motion, MotionName::Table | MotionName::Vessel);
        let Some(name) = end.motion_file.as_ref().filter(|_| used) else {
            continue;
        };
        let shown = reading.take(&mut case.files, name, &["ends", letter, "motion_file"])?;
        let carried = &case.files[name].text;
        match end.motion {
            MotionName::Vessel => {
                carried_numbers(carried, &shown, &response_columns())?;
            }
            _ => {
                places(carried, &shown)?;
            }
        }
    }
    if let Some(bed) = case.seabed.clone() {
        reading.take_depths(&mut case.files, bed.depths(), "seabed")?;
    }
    let tables = case.load_cases.clone();
    reading.take_load_cases(&mut case.files, &tables, &CASE)?;
    let checks = case.checks.clone();
    reading.take_checks(&mut case.files, &checks)?;
    reading.take_curves(&mut case.files, &mut case.published_curve)?;
    Ok(())
}

impl FileSource<'_> {
    /// Takes the points of published curves from the files that they name.
    ///
    /// # Errors
    /// A file that cannot be read, or holds no curve, with its line.
    pub fn take_curves(
        &self,
        files: &mut BTreeMap<String, Attachment>,
        curves: &mut [PublishedCurve],
    ) -> Result<(), Diagnostic> {
        for curve in curves {
            let Some(name) = &curve.points_file else {
                continue;
            };
            let key = ["published_curve", &*curve.name, "points_file"];
            let shown = self.take(files, name, &key)?;
            (curve.time_s, curve.value) = curve_points(&files[name].text, &shown)?;
        }
        Ok(())
    }

    /// Sees to it that a file that is named at a key is carried; what it is called in words.
    pub fn take(
        &self,
        files: &mut BTreeMap<String, Attachment>,
        name: &str,
        key: &[&str],
    ) -> Result<String, Diagnostic> {
        let beside = root::shown(self.folder, name);
        if !files.contains_key(name) {
            let with_program = |error| {
                let text = shipped::beside(self.of, name);
                text.map(str::to_owned).ok_or(error)
            };
            let read = root::place(self.folder, name)
                .and_then(|place| place.text())
                .or_else(with_program);
            let read = read.map_err(|error| {
                let span = self.root.find(key).map_or(0..0, |node| node.span.clone());
                let problem = format!("{beside} cannot be read: {error}");
                let remedy = "name a file beside the case file, or carry it in the case as [files.\"NAME\"] text = \"...\"";
                Finding::new(&span, key.join("."), problem, remedy).at(self.file, self.text)
            })?;
            let known = self.known.get(name).filter(|known| *known.text == *read);
            let carried = known
                .cloned()
                .unwrap_or_else(|| Attachment { text: read.into() });
            files.insert(name.to_owned(), carried);
        }
        Ok(beside)
    }

    /// A diagnostic without what the file holds that it is about, where the user named one outside the root.
    pub(crate) fn quoting_none_outside(&self, found: Diagnostic) -> Diagnostic {
        let is_named = found.file != self.file;
        match is_named && root::is_outside(self.folder, &found.file) {
            true => found.without_contents(),
            false => found,
        }
    }
}

/// A table of places over time, as columns of [`PLACES`] \[s, m\].
///
/// # Errors
/// Fewer than two rows, or times that do not increase.
pub fn places(text: &CarriedText, file: &str) -> Result<Arc<Vec<Vec<f64>>>, Diagnostic> {
    let columns = PLACES.map(str::to_owned);
    let rows = carried_numbers(text, file, &columns)?;
    if rows.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
        // Again, with the places of the numbers.
        let rows = placed(text, file, &columns)?;
        times_rise(&rows, PLACES[0]).map_err(|found| found.at(file, text))?;
    }
    match rows.len() {
        0 | 1 => Err(Diagnostic::whole_file(
            file,
            "a motion needs two rows at least",
            "give a line for each time: time and place",
        )),
        _ => Ok(rows),
    }
}

/// Checks that the first numbers of rows rise.
fn times_rise(rows: &[Vec<PlacedNumber>], column: &str) -> Result<(), Finding> {
    let back = rows.windows(2).find(|w| w[1][0].value <= w[0][0].value);
    back.map_or(Ok(()), |pair| {
        let [before, here] = [&pair[0][0], &pair[1][0]];
        let problem = format!(
            "the time {} s does not come after {} s",
            here.value, before.value
        );
        let remedy = "give the rows in the order of their times, each time once";
        Err(Finding::new(&here.span, column, problem, remedy))
    })
}

/// Times and values of a published curve, the times increasing.
fn curve_points(text: &str, file: &str) -> Result<(Vec<f64>, Vec<f64>), Diagnostic> {
    let rows = placed(text, file, &POINTS.map(str::to_owned))?;
    times_rise(&rows, POINTS[0]).map_err(|found| found.at(file, text))?;
    if rows.len() < 2 {
        let problem = "a curve needs at least two points";
        return Err(Diagnostic::whole_file(
            file,
            problem,
            "give a line for each point: time, value",
        ));
    }
    Ok(rows.iter().map(|row| (row[0].value, row[1].value)).unzip())
}

/// The text of a case with the files it names, which it may read no more.
#[must_use]
pub fn stand_alone<'t>(text: &'t str, case: &Case) -> Cow<'t, str> {
    with_files(text, &case.files)
}

/// The text with these files carried in it.
pub fn with_files<'t>(text: &'t str, files: &BTreeMap<String, Attachment>) -> Cow<'t, str> {
    if files.is_empty() {
        return Cow::Borrowed(text);
    }
    let root = TomlNode::parse(text).ok();
    let held = |name: &str| {
        let root = root.as_ref();
        root.is_some_and(|root| root.find(&["files", name]).is_some())
    };
    let mut whole = Cow::Borrowed(text);
    for (name, carried) in files {
        if !held(name) {
            let value = toml::Value::String(carried.text.to_string());
            let key = toml::Value::String(name.clone());
            whole
                .to_mut()
                .push_str(&format!("\n[files.{key}]\ntext = {value}\n"));
        }
    }
    whole
}

/// Takes over files of the same text, with the tables that were parsed of them.
pub(crate) fn share<K: FileKind>(content: &mut K, known: &BTreeMap<String, Attachment>) {
    for (name, carried) in content.files_mut().into_iter().flatten() {
        if let Some(same) = known.get(name).filter(|same| *same == carried) {
            carried.clone_from(same);
        }
    }
}

/// A word of a line and where it stands in the text.
pub(super) type PlacedWord<'t> = (&'t str, Range<usize>);

/// A number and where it stands in the text.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedNumber {
    /// The number.
    pub value: f64,
    /// Its place.
    pub span: Range<usize>,
}

/// Reads a table of numbers: a first line with the names of the columns, in any order, then one line a row, words
/// separated by commas; empty lines and lines that begin with `#` say nothing. Rows in the order of `columns`.
///
/// # Errors
/// The first fault, with its line and column.
pub fn numbers(text: &str, file: &str, columns: &[String]) -> Result<Vec<Vec<f64>>, Diagnostic> {
    work_log::log(Task::Parse, file);
    let rows = placed(text, file, columns)?.into_iter();
    Ok(rows
        .map(|row| row.into_iter().map(|placed| placed.value).collect())
        .collect())
}

/// The numbers of a carried table, which is parsed once.
///
/// # Errors
/// As [`numbers`].
pub fn carried_numbers(
    text: &CarriedText,
    file: &str,
    columns: &[String],
) -> Result<Arc<Vec<Vec<f64>>>, Diagnostic> {
    text.parsed(columns.to_vec(), |text| numbers(text, file, columns))
}

/// The same as of [`numbers`], each number with its place, for those who have more to say of it.
///
/// # Errors
/// As [`numbers`].
pub fn placed(
    text: &str,
    file: &str,
    columns: &[String],
) -> Result<Vec<Vec<PlacedNumber>>, Diagnostic> {
    let mut lines = placed_lines(text);
    let wanted = columns.join(",");
    let Some(head) = lines.next() else {
        return Err(Diagnostic::whole_file(
            file,
            "the table is empty",
            format!("begin with a line of column names: {wanted}"),
        ));
    };
    let stray = head
        .iter()
        .find(|(name, _)| !columns.iter().any(|c| c == name));
    if let Some((name, span)) = stray {
        let problem = format!("`{name}` is no column of this table");
        let remedy = format!("the columns are {wanted}");
        return Err(Finding::new(span, *name, problem, remedy).at(file, text));
    }
    let mut places = Vec::new();
    for column in columns {
        let Some(place) = head.iter().position(|(name, _)| name == column) else {
            let span = &head[0].1;
            let remedy = format!("the columns are {wanted}");
            return Err(Finding::new(span, column, "the column is missing", remedy).at(file, text));
        };
        places.push(place);
    }
    let mut rows = Vec::new();
    for line in lines {
        rows.push(row(&line, &head, &places).map_err(|finding| finding.at(file, text))?);
    }
    Ok(rows)
}

/// The numbers of a line, in the order of the columns.
fn row(
    line: &[PlacedWord<'_>],
    head: &[PlacedWord<'_>],
    places: &[usize],
) -> Result<Vec<PlacedNumber>, Finding> {
    if line.len() != head.len() {
        let problem = format!(
            "the line has {} values for {} columns",
            line.len(),
            head.len()
        );
        let span = line[0].1.start..line[line.len() - 1].1.end;
        return Err(Finding::new(
            &span,
            "",
            problem,
            "give one value for each column",
        ));
    }
    let number = |place: &usize| {
        let (word, span) = &line[*place];
        let value = word.parse::<f64>().ok().filter(|v| v.is_finite());
        let placed = value.map(|value| PlacedNumber {
            value,
            span: span.clone(),
        });
        placed.ok_or_else(|| {
            let problem = format!("`{word}` is not a number");
            Finding::new(
                span,
                head[*place].0,
                problem,
                "write a number, such as 1.5 or -2e3",
            )
        })
    };
    places.iter().map(number).collect()
}

/// A text behind its byte order mark, which spreadsheets write before a table, and where it begins.
pub fn without_mark(text: &str) -> (usize, &str) {
    let behind = text.trim_start_matches('\u{feff}');
    (text.len() - behind.len(), behind)
}

/// The lines of a table that say something, as words between commas, each with its place in the text.
pub(super) fn placed_lines(text: &str) -> impl Iterator<Item = Vec<PlacedWord<'_>>> {
    let (mut start, text) = without_mark(text);
    let placed = text.split_inclusive('\n').map(move |line| {
        let from = start;
        start += line.len();
        (from, line)
    });
    placed
        .filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'))
        .map(|(from, line)| words(from, line.trim_end()))
}

fn words(from: usize, line: &str) -> Vec<PlacedWord<'_>> {
    let mut start = from;
    let mut list = Vec::new();
    for part in line.split(',') {
        let word = part.trim();
        let at = start + part.find(word).unwrap_or(0);
        list.push((word, at..at + word.len()));
        start += part.len() + 1;
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns() -> Vec<String> {
        PLACES.map(str::to_owned).to_vec()
    }

    #[test]
    fn columns_in_any_order_and_lines_that_say_nothing() {
        let text = "# a path\nx_m, time_s,y_m,z_m\n\n1, 0,0,0\n2,1.5 ,-3e1,4\n";
        let rows = numbers(text, "p.csv", &columns()).unwrap();
        assert_eq!(rows, [vec![0.0, 1.0, 0.0, 0.0], vec![1.5, 2.0, -30.0, 4.0]]);
    }

    #[test]
    fn a_byte_order_mark_says_nothing() {
        let text = "\u{feff}time_s,x_m,y_m,z_m\n0,1,2,x\n";
        let fault = numbers(text, "p.csv", &columns()).unwrap_err();
        assert_eq!((fault.line, fault.column), (2, 7));
        let rows = numbers(
            &text.replace('x', "3").replace("3_m", "x_m"),
            "p.csv",
            &columns(),
        );
        assert_eq!(rows.unwrap(), [vec![0.0, 1.0, 2.0, 3.0]]);
    }

    #[test]
    fn points_of_a_curve_come_one_after_the_other() {
        let points = |text: &str| curve_points(text, "c.csv").map_err(|f| (f.line, f.problem));
        let read = points("value,time_s\n5.0,0.0\n6.0,0.5\n").unwrap();
        assert_eq!(read, (vec![0.0, 0.5], vec![5.0, 6.0]));
        assert_eq!(
            points("time_s,value\n0,1\n2,1\n2,3\n"),
            Err((4, "the time 2 s does not come after 2 s".to_owned()))
        );
        let short = points("time_s,value\n0,1\n").unwrap_err();
        assert_eq!(short.1, "a curve needs at least two points");
    }

    #[test]
    fn faults_stand_at_their_line_and_column() {
        let fault = |text: &str| {
            let fault = numbers(text, "p.csv", &columns()).unwrap_err();
            (fault.line, fault.column, fault.problem)
        };
        let head = "time_s,x_m,y_m,z_m\n";
        assert_eq!(
            fault(&format!("{head}0,0,0,0\n1, two,0,0\n")),
            (3, 4, "`two` is not a number".to_owned())
        );
        assert_eq!(
            fault(&format!("{head}0,0,0\n")),
            (2, 1, "the line has 3 values for 4 columns".to_owned())
        );
        assert_eq!(fault("time_s,x_m,w_m,z_m\n").1, 12);
        assert_eq!(fault("time_s,x_m,z_m\n").2, "the column is missing");
        assert_eq!(fault("").2, "the table is empty");
    }
}
