//! From a ropeway file to a ropeway worked out.

use std::collections::BTreeMap;
use std::path::Path;

use super::elastic::ElasticRope;
use super::model::{ROPEWAY, Ropeway};
use super::quantities::{self, QUANTITIES};
use super::solve::{SolvedRopeway, solve};
use crate::case::fields::{Schema, either};
use crate::case::kind::{self, FileKind};
use crate::case::{self, Diagnostic, InvalidValue, Mark, Node};
use crate::case::{FieldRow, Lister};
use crate::reference::published_number;

/// A ropeway with the text and the file it came from.
pub type Loaded = case::Opened<SolvedRopeway>;

/// The ropeway file as a kind.
pub(crate) enum RopewayFile {}

impl FileKind for RopewayFile {
    type Words = Ropeway;
    type Worked = SolvedRopeway;

    fn schema() -> &'static Schema {
        &ROPEWAY
    }

    fn work(words: Ropeway, _tree: &Node) -> Result<SolvedRopeway, Vec<InvalidValue>> {
        let mut wrong = check(&words);
        wrong.extend(lost_marks(&words));
        if wrong.is_empty() {
            solve(&words).map_err(|invalid| vec![invalid])
        } else {
            Err(wrong)
        }
    }

    fn marks(words: &Ropeway) -> BTreeMap<String, Mark> {
        words.marks.clone()
    }

    fn list(lister: &Lister<'_>) -> Vec<FieldRow> {
        super::edit::list(lister)
    }
}

/// Whether a file is a ropeway rather than a line case; the two may share a folder.
#[must_use]
pub(crate) fn is_ropeway(path: &Path) -> bool {
    kind::begins::<RopewayFile>(path, &[])
}

/// Reads, checks and works out a ropeway file.
///
/// # Errors
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary
/// or empty, faults of the TOML syntax, every fault of keys and values, or what cannot be as the file says.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    kind::load::<RopewayFile>(path)
}

/// Checks the text of a ropeway and works it out. `file` is the name the diagnostics carry.
///
/// # Errors
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<SolvedRopeway, Vec<Diagnostic>> {
    kind::parse::<RopewayFile>(text, file)
}

/// What its words say against each other.
fn check(ropeway: &Ropeway) -> Vec<InvalidValue> {
    let mut wrong = Vec::new();
    let geometry = ElasticRope::of(ropeway).geometry;
    if geometry.rise_m.abs() > 2.0 * geometry.span_m {
        wrong.push(InvalidValue::new(
            &["ship", "height_m"],
            "the rope would be steeper than a ropeway can be",
            "give the ends less difference of height, or a longer span",
        ));
    }
    wrong.extend(published_number::invalid_values(
        &ropeway.published,
        unknown_quantity,
    ));
    for (i, trend) in ropeway.trend.iter().enumerate() {
        let taken = ropeway.trend.iter().take(i).any(|t| t.name == trend.name);
        let name = if taken {
            (i + 1).to_string()
        } else {
            trend.name.clone()
        };
        if let Some((problem, remedy)) = unknown_quantity(&trend.quantity) {
            wrong.push(InvalidValue::new(
                &["trend", &name, "quantity"],
                problem,
                remedy,
            ));
        }
    }
    wrong
}

/// Problem and remedy of a quantity that there is not.
fn unknown_quantity(quantity: &str) -> Option<(String, String)> {
    if quantities::find(quantity).is_some() {
        return None;
    }
    let names: Vec<&str> = QUANTITIES.iter().map(|known| known.name).collect();
    let remedy = match case::nearest(quantity, names.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("give {}", either(&names)),
    };
    let problem = format!("there is no quantity \"{}\"", quantity.escape_default());
    Some((problem, remedy))
}

/// Marks of keys that no ropeway has.
fn lost_marks(ropeway: &Ropeway) -> Vec<InvalidValue> {
    let lost = ropeway.marks.keys().filter(|key| {
        let parts = case::split(key);
        let known = parts.is_some_and(|parts| ROPEWAY.fields_at(&parts).next().is_some());
        !known
    });
    let told = lost.map(|key| {
        InvalidValue::new(
            &["marks", key],
            format!("there is no key `{key}` in a ropeway"),
            "name a key as the file groups them: table, name, key",
        )
    });
    told.collect()
}
