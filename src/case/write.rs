//! A typed case as the text of a case file.

use toml::{Table, Value};

use super::fields::{Absent, FIELDS};
use super::model::Case;

/// The text of a case file that says what `case` says; keys that hold their default are left out.
///
/// [`parse`](super::parse) of the text gives the same case again.
#[must_use]
pub fn write(case: &Case) -> String {
    let Ok(Value::Table(mut root)) = Value::try_from(case) else {
        return String::new();
    };
    for field in FIELDS {
        if let Absent::Default(text) = field.absent
            && let Ok(default) = format!("value = {text}").parse::<Table>()
        {
            let path: Vec<&str> = field.path.split('.').collect();
            drop_default(&mut root, &path, &default["value"]);
        }
    }
    whole_study_values(&mut root);
    // A table that is always there says nothing where it is empty; an empty [modes] asks for modes.
    let implied = ["environment", "start", "solver", "output"];
    root.retain(|key: &str, value| match value {
        Value::Table(table) => !table.is_empty() || !implied.contains(&key),
        Value::Array(items) => !items.is_empty(),
        _ => true,
    });
    root.to_string()
}

/// Removes the key where it holds `default`; `*` stands for every table of a list or by name.
fn drop_default(table: &mut Table, path: &[&str], default: &Value) {
    let inner = |value: &mut Value, rest: &[&str]| {
        if let Value::Table(table) = value {
            drop_default(table, rest, default);
        }
    };
    match path {
        [key] => {
            if table.get(*key).is_some_and(|value| same(value, default)) {
                table.remove(*key);
            }
        }
        ["*", rest @ ..] => table.iter_mut().for_each(|(_, value)| inner(value, rest)),
        [key, rest @ ..] => match (table.get_mut(*key), rest) {
            (Some(Value::Array(items)), ["*", rest @ ..]) => {
                items.iter_mut().for_each(|item| inner(item, rest));
            }
            (Some(value), rest) => inner(value, rest),
            (None, _) => {}
        },
        [] => {}
    }
}

fn same(value: &Value, default: &Value) -> bool {
    match (value, default) {
        (Value::Float(a), Value::Integer(b)) => *a == *b as f64,
        _ => value == default,
    }
}

/// Writes whole numbers among the values of studies without a decimal point: the key they vary may want it so.
fn whole_study_values(root: &mut Table) {
    let studies = root.get_mut("study").and_then(Value::as_array_mut);
    for study in studies.into_iter().flatten() {
        let values = study.get_mut("values").and_then(Value::as_array_mut);
        for value in values.into_iter().flatten() {
            if let Value::Float(number) = *value
                && number.fract() == 0.0
                && number.abs() < 1e15
            {
                *value = Value::Integer(number as i64);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::write;
    use crate::case::{parse, shipped::SHIPPED};

    #[test]
    fn a_written_case_reads_as_the_same_case() {
        for (path, text) in SHIPPED {
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/");
            let case = parse(text, &format!("{folder}{path}")).unwrap();
            // The files that a case names are part of it once it is read, as are the points of curves in them.
            if case.published_curve.iter().any(|c| c.points_file.is_some()) {
                continue;
            }
            let written = write(&case);
            let again =
                parse(&written, path).unwrap_or_else(|e| panic!("{path}: {e:?}\n{written}"));
            assert_eq!(again, case, "{path}");
        }
    }

    #[test]
    fn keys_that_hold_their_default_are_left_out() {
        let text = SHIPPED[0].1;
        let written = write(&parse(text, "case").unwrap());
        assert!(!written.contains("gravity_m_per_s2"), "{written}");
        assert!(!written.contains("max_iterations"), "{written}");
    }
}
