//! The keys of a section file as an editor lists and sets them.

use super::read::SectionFile;
use crate::case::{self, Diagnostic, Mark, Provenance, kind};
use crate::case::{FieldRow, Lister};

/// Every key the file can have, given or not, from the section as a whole to the outermost layer. Where a value comes from
/// is read from the comment behind it, when that begins with `printed`, `published`, `derived`,
/// `calibrated` or `assumed`.
///
/// A text that is not TOML gives no rows.
#[must_use]
pub fn rows(text: &str) -> Vec<FieldRow> {
    kind::rows::<SectionFile>(text)
}

pub(super) fn list(lister: &Lister<'_>) -> Vec<FieldRow> {
    let root = lister.root;
    let mut rows = lister.table("section", &["section"], "section");
    rows.extend(lister.named("units", "unit"));
    if root.get("centre").is_some() {
        rows.extend(lister.table("centre", &["centre"], "centre"));
    }
    rows.extend(lister.named("layer", "layer"));
    for row in rows.iter_mut().filter(|row| row.given) {
        let node = case::split(&row.path).and_then(|parts| root.find(&parts));
        row.standing = node.and_then(|node| standing(lister.text.get(node.span.end..)?));
    }
    rows
}

/// Where a value comes from, by the comment behind it.
fn standing(behind: &str) -> Option<Mark> {
    let line = behind.lines().next()?.trim();
    let comment = line.strip_prefix('#')?.trim();
    let word = comment.split(|c: char| !c.is_alphabetic()).next()?;
    let status = match word.to_lowercase().as_str() {
        "printed" | "published" => Provenance::Published,
        "derived" => Provenance::Derived,
        "calibrated" => Provenance::Calibrated,
        "assumed" => Provenance::Assumed,
        _ => return None,
    };
    Some(Mark {
        status,
        reason: comment.to_owned(),
    })
}

/// The text of the section with one key set to a value, given as a user types it: a TOML value, or
/// a bare word where the field takes words. Nothing but the value changes; a key that the file
/// leaves out is added to its table.
///
/// # Errors
///
/// The key is not known, the value is of the wrong type or out of range, or all faults of the
/// section with it: an edited section is one that can be laid out.
pub fn set(text: &str, key_path: &str, value: &str) -> Result<String, Vec<Diagnostic>> {
    kind::set_all::<SectionFile>(text, &[(key_path, value)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = include_str!("../../cases/umbilical/section.toml");

    #[test]
    fn one_value_changes_and_every_comment_stays() {
        let edited = set(TEXT, "units.tube.wall_m", "0.002").unwrap();
        assert_eq!(edited, TEXT.replace("wall_m = 0.00165", "wall_m = 0.002"));
        let edited = set(TEXT, "section.voids", "flooded").unwrap();
        assert_eq!(edited, TEXT.replace("\"dry\"", "\"flooded\""));
    }

    #[test]
    fn a_key_left_out_is_added_to_the_table_of_its_kind() {
        let edited = set(TEXT, "layer.inner-armour.poisson_ratio", "0.28").unwrap();
        let row = |text: &str| {
            let rows = rows(text);
            let at = |row: &&FieldRow| row.path == "layer.inner-armour.poisson_ratio";
            rows.iter()
                .find(at)
                .map(|row| (row.value.clone(), row.given))
        };
        assert_eq!(row(TEXT), Some(("0.3".to_owned(), false)));
        assert_eq!(row(&edited), Some(("0.28".to_owned(), true)));
    }

    #[test]
    fn a_value_that_cannot_be_is_refused_and_so_is_a_layout() {
        let why = |key: &str, value: &str| set(TEXT, key, value).unwrap_err()[0].problem.clone();
        assert!(why("units.tube.wall_m", "-1").contains("out of range"));
        assert!(why("layer.inner-armour.count", "500").contains("fit"));
        assert!(why("units.tube.colour", "3").contains("no key"));
    }

    #[test]
    fn every_key_of_the_file_is_listed_and_comments_tell_standings() {
        let rows = rows(TEXT);
        let given = rows.iter().filter(|row| row.given).count();
        let keys = TEXT
            .lines()
            .filter(|line| line.contains(" = ") && !line.starts_with('#'));
        assert_eq!(given, keys.count());
        let of = |path: &str| {
            let row = rows.iter().find(|row| row.path == path).unwrap();
            row.standing.as_ref().map(|mark| mark.status)
        };
        assert_eq!(of("units.tube.diameter_m"), Some(Provenance::Published));
        assert_eq!(of("section.usage_factor"), Some(Provenance::Assumed));
        assert_eq!(of("layer.inner-armour.count"), None);
    }
}
