//! A typed case as the text of a case file.

use toml_edit::DocumentMut;

use super::model::Case;
use super::schema::{TableType, WrittenKeys};

/// The text of a case file that says what `case` says; keys that hold their default are left out.
///
/// [`parse`](super::parse) of the text gives the same case again.
#[must_use]
pub fn write(case: &Case) -> String {
    DocumentMut::from(case.write(WrittenKeys::WithoutDefaults)).to_string()
}

#[cfg(test)]
mod tests {
    use super::write;
    use crate::case::{parse, shipped::SHIPPED};

    #[test]
    fn a_written_case_reads_as_the_same_case() {
        for (path, text) in SHIPPED {
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/");
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
