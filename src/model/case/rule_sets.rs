//! Sets of rules: those that come with the program, and files of a user.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::attachments::FileSource;
use super::check::of_checks;
use super::diagnostic::{Diagnostic, Finding};
use super::fields::Schema;
use super::file_kind::{FileContent, FileKind};
use super::kind;
use super::model::{Attachment, CheckInputs, RuleSet, RuleSetKeys};
use super::rows::{FieldLister, FieldRow};
use super::schema::schema_of;
use super::section_text::SectionText;

/// Names of the sets that come with the program.
pub const NAMES: [&str; 3] = ["api-rp-2sk", "dnv-os-e301", "dnv-st-0119"];

const TEXTS: [&str; 3] = [
    include_str!("../../../docs/rules/api-rp-2sk.toml"),
    include_str!("../../../docs/rules/dnv-os-e301.toml"),
    include_str!("../../../docs/rules/dnv-st-0119.toml"),
];

static RULES: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a set of rules has [rules] and one [[checks]] for each rule";
    schema_of::<RuleSet>("set of rules", least)
});

/// Names and texts of the sets that come with the program.
pub fn shipped() -> impl Iterator<Item = (&'static str, &'static str)> {
    NAMES.into_iter().zip(TEXTS)
}

/// Whether a set of this name comes with the program.
#[must_use]
pub fn is_shipped(name: &str) -> bool {
    NAMES.contains(&name)
}

/// The text of a set by its name; nothing where none comes with the program and none is carried.
#[must_use]
pub fn text<'a>(name: &str, files: &'a BTreeMap<String, Attachment>) -> Option<&'a str> {
    let place = NAMES.iter().position(|known| *known == name);
    let shipped = place.map(|place| TEXTS[place]);
    shipped.or_else(|| files.get(name).map(|file| &*file.text))
}

/// Reads a set.
///
/// # Errors
/// Everything that is wrong with it, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<RuleSet, Vec<Diagnostic>> {
    kind::parse_stored::<RuleSet>(text, file)
}

impl FileSource<'_> {
    /// Takes in the files of rules, curves and cross-sections that checks name.
    ///
    /// # Errors
    /// A file that cannot be read, or is no set of rules or no section.
    pub fn take_checks(
        &self,
        files: &mut BTreeMap<String, Attachment>,
        checks: &[CheckInputs],
    ) -> Result<(), Diagnostic> {
        for (index, check) in checks.iter().enumerate() {
            let number = (index + 1).to_string();
            let is_file = |name: &&String| name.ends_with(".toml");
            if let Some(name) = check.rules.as_ref().filter(is_file) {
                let shown = self.take(files, name, &["checks", &number, "rules"])?;
                if let Err(faults) = parse(&files[name].text, &shown)
                    && let Some(first) = faults.into_iter().next()
                {
                    return Err(first);
                }
            }
            if let Some(name) = check.curve.as_ref().filter(is_file) {
                self.take(files, name, &["checks", &number, "curve"])?;
            }
            if let Some(name) = check.section.as_ref().filter(is_file) {
                let shown = self.take(files, name, &["checks", &number, "section"])?;
                let read = files[name].text.design(&shown);
                if let Err(faults) = read
                    && let Some(first) = faults.into_iter().next()
                {
                    return Err(first);
                }
            }
        }
        Ok(())
    }
}

impl FileContent for RuleSet {
    type Computed = Self;
}

impl FileKind for RuleSet {
    fn schema() -> &'static Schema {
        &RULES
    }

    fn check(keys: &RuleSetKeys<'_>) -> Vec<Finding> {
        let mut found = of_checks(&keys.checks);
        for (_, check) in &keys.checks {
            let problem = "a rule of a set names no other set";
            found.extend(check.rules.if_given(problem, "write the rule itself"));
            found.extend(check.name.if_missing("give the rule a name"));
            found.extend(
                check
                    .clause
                    .if_missing("say where it is printed: add `clause`"),
            );
        }
        found
    }

    fn compute(self, _keys: &RuleSetKeys<'_>) -> Result<Self, Finding> {
        Ok(self)
    }

    fn list(_lister: &FieldLister<'_>) -> Vec<FieldRow> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_set_that_is_shipped_reads_and_says_where_it_is_from() {
        for (name, text) in NAMES.iter().zip(TEXTS) {
            let set = parse(text, name).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
            assert!(set.about.source.contains("agree"), "{name}");
            assert!(
                set.checks.iter().all(|check| check.clause.is_some()),
                "{name}"
            );
        }
    }

    #[test]
    fn rules_that_lack_their_numbers_are_refused_at_their_place() {
        let text = "[rules]\ntitle = \"t\"\nedition = \"e\"\nsource = \"s\"\n[[checks]]\nname = \"a\"\nclause = \"c\"\nkind = \"safety-factor\"\nlimit_m = 3.0\n";
        let faults = parse(text, "mine.toml").unwrap_err();
        let shown: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert_eq!(faults.len(), 2, "{shown:?}");
        assert!(shown[0].contains("add `factor`"), "{shown:?}");
        assert!(shown[1].contains("`limit_m` is not used"), "{shown:?}");
    }
}
