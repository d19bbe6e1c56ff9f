//! The section as a kind of file.

use std::sync::{Arc, LazyLock};

use super::check::{check, located};
use super::design::{Design, design};
use super::model::{CrossSection, SectionKeys};
use crate::case::fields::Schema;
use crate::case::file_kind::{FileContent, FileKind};
use crate::case::schema::schema_of;
use crate::case::{
    CarriedText, Diagnostic, FieldLister, FieldRow, Finding, Mark, Provenance, SectionText, kind,
    split,
};

/// The section file.
pub static SECTION: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a section has at least [section] with a name and a title, [units.<name>], and a [centre] or a [[layer]]";
    schema_of::<CrossSection>("section", least).with_parameters()
});

impl FileContent for CrossSection {
    type Computed = Design;
}

impl FileKind for CrossSection {
    fn schema() -> &'static Schema {
        &SECTION
    }

    fn check(keys: &SectionKeys<'_>) -> Vec<Finding> {
        check(keys)
    }

    fn compute(self, keys: &SectionKeys<'_>) -> Result<Design, Finding> {
        design(&self).map_err(|error| located(&error, keys))
    }

    /// From the section as a whole to the outermost layer.
    fn list(lister: &FieldLister<'_>) -> Vec<FieldRow> {
        let mut rows = [
            lister.always("section"),
            lister.named("units", "unit"),
            lister.if_given(&["centre"], "centre"),
            lister.named("layer", "layer"),
        ]
        .concat();
        for row in rows.iter_mut().filter(|row| row.given) {
            let node = split(&row.path).and_then(|parts| lister.root.find(&parts));
            row.standing = node.and_then(|node| standing(lister.text.get(node.span.end..)?));
        }
        rows
    }
}

impl SectionText for CarriedText {
    type Design = Design;

    fn design(&self, file: &str) -> Result<Arc<Design>, Vec<Diagnostic>> {
        self.parsed((), |text| kind::parse_stored::<CrossSection>(text, file))
    }
}

/// Where a value comes from, by the comment behind it, when that begins with `printed`, `published`, `derived`, `calibrated` or `assumed`.
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
        ..Mark::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::kind::{rows, set};

    const TEXT: &str = include_str!("../../../cases/umbilical/section.toml");

    #[test]
    fn one_value_changes_and_every_comment_stays() {
        let edited = set::<CrossSection>(TEXT, "units.tube.wall_m", "0.002").unwrap();
        assert_eq!(edited, TEXT.replace("wall_m = 0.00165", "wall_m = 0.002"));
        let edited = set::<CrossSection>(TEXT, "section.voids", "flooded").unwrap();
        assert_eq!(edited, TEXT.replace("\"dry\"", "\"flooded\""));
    }

    #[test]
    fn a_key_left_out_is_added_to_the_table_of_its_kind() {
        let edited = set::<CrossSection>(TEXT, "layer.inner-armour.poisson_ratio", "0.28").unwrap();
        let row = |text: &str| {
            let rows = rows::<CrossSection>(text);
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
        let why = |key: &str, value: &str| {
            set::<CrossSection>(TEXT, key, value).unwrap_err()[0]
                .problem
                .clone()
        };
        assert!(why("units.tube.wall_m", "-1").contains("out of range"));
        assert!(why("layer.inner-armour.count", "500").contains("fit"));
        assert!(why("units.tube.colour", "3").contains("no key"));
    }

    #[test]
    fn every_key_of_the_file_is_listed_and_comments_tell_standings() {
        let rows = rows::<CrossSection>(TEXT);
        let given = rows.iter().filter(|row| row.given).count();
        // Published values are no inputs.
        let keys = TEXT
            .lines()
            .take_while(|line| *line != "[[published]]")
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
