//! The fields of load cases, statistics and checks, as the parameter editor lists them. They are no inputs of a run: reports,
//! comparisons and marks leave them out.

use super::check::is_of_check;
use super::file_kind::FileKind;
use super::rows::{FieldLister, FieldRow};
use super::tree::TomlNode;

const LOAD_CASES: &str = "load_cases";
const STATISTICS: &str = "statistics";
const CHECKS: &str = "checks";

/// The fields of load cases, statistics and checks that a file has, in reading order. A text that is not TOML has none.
#[must_use]
pub fn judging_rows<K: FileKind>(text: &str) -> Vec<FieldRow> {
    let Ok(root) = TomlNode::parse(text) else {
        return Vec::new();
    };
    let lister = FieldLister::new(K::schema(), text, &root);
    let mut rows = lister.named(LOAD_CASES, "load cases");
    for row in &mut rows {
        row.applies = is_of_table(&root, row);
    }
    let has_any = [LOAD_CASES, STATISTICS, CHECKS].iter();
    if has_any.clone().any(|table| root.get(table).is_some()) {
        rows.extend(lister.always(STATISTICS));
    }
    let mut checks = lister.named(CHECKS, "check");
    for row in &mut checks {
        let text = |key| sibling(&root, row, key).and_then(TomlNode::text);
        let of = (text("rules").is_some(), text("kind"));
        row.applies = is_of_check(row.field.key(), of);
    }
    rows.extend(checks);
    rows
}

/// Whether a key path is of load cases, statistics or checks.
#[must_use]
pub fn is_judging(path: &str) -> bool {
    let table = path.split('.').next().unwrap_or(path);
    [LOAD_CASES, STATISTICS, CHECKS].contains(&table)
}

/// Another key of the table of a field.
fn sibling<'a>(root: &'a TomlNode, row: &FieldRow, key: &str) -> Option<&'a TomlNode> {
    let mut path = super::fields::split(&row.path)?;
    path.pop()?;
    root.find(&path)?.get(key)
}

/// Whether a key matters beside the others of its table of load cases: a file has columns, a key has values or a range.
fn is_of_table(root: &TomlNode, row: &FieldRow) -> bool {
    let is_given = |key: &str| sibling(root, row, key).is_some();
    match row.field.key() {
        "file" => !is_given("key"),
        "values" => !is_given("file") && !is_given("range"),
        "range" => !is_given("file") && !is_given("values"),
        "key" | "probability" => !is_given("file"),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    const TEXT: &str = "
[[load_cases]]
key = \"current.speed_m_per_s\"
values = [0.2, 0.4]

[[checks]]
name = \"chain holds\"
kind = \"safety-factor\"
factor = 1.7

[[checks]]
rules = \"dnv-st-0119\"
";

    fn shown(text: &str) -> Vec<String> {
        let rows = judging_rows::<Case>(text);
        let shown = rows.into_iter().filter(FieldRow::is_shown);
        shown.map(|row| row.path).collect()
    }

    #[test]
    fn what_a_check_takes_is_listed_and_nothing_else() {
        let paths = shown(TEXT);
        let has = |path: &str| paths.iter().any(|known| known == path);
        assert!(has("load_cases.1.values") && !has("load_cases.1.file"));
        assert!(!has("load_cases.1.range"), "{paths:?}");
        assert!(has("statistics.hours") && has("statistics.method"));
        let of = |end: &str| paths.iter().filter(|path| path.ends_with(end)).count();
        assert_eq!(
            (of(".factor"), of(".limit_m"), of(".only")),
            (1, 0, 1),
            "{paths:?}"
        );
        assert!(paths.iter().all(|path| is_judging(path)));
        assert!(shown("[case]\ntitle = \"a\"\n").is_empty());
        assert!(!is_judging("solver.duration_s"));
    }
}
