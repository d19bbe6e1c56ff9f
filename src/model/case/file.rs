//! The line case as a kind of file.

use std::collections::BTreeMap;

use super::check::check;
use super::diagnostic::Finding;
use super::fields::Schema;
use super::file_kind::{FileContent, FileKind};
use super::model::{Attachment, CASE, Case, CaseKeys};
use super::rows::{FieldLister, FieldRow};
use super::tree::TomlNode;

impl FileContent for Case {
    type Computed = Self;
}

impl FileKind for Case {
    fn schema() -> &'static Schema {
        &CASE
    }

    fn check(keys: &CaseKeys<'_>) -> Vec<Finding> {
        check(keys)
    }

    fn files_mut(&mut self) -> Option<&mut BTreeMap<String, Attachment>> {
        Some(&mut self.files)
    }

    fn compute(self, _: &CaseKeys<'_>) -> Result<Self, Finding> {
        Ok(self)
    }

    /// Environment, current, sea bed, each material with its bore, each section, ends, payload, floats, clumps, modules, traveller, start,
    /// solver, output.
    fn list(lister: &FieldLister<'_>) -> Vec<FieldRow> {
        let end = |letter: &str| {
            let name = lister.root.find(&["ends", letter, "name"]);
            let name = name.and_then(TomlNode::text).unwrap_or_default();
            let group = format!("end {} ({name})", letter.to_uppercase());
            lister.table("ends.*", &["ends", letter], &group)
        };
        [
            lister.always("environment"),
            lister.always("current"),
            lister.if_given(&["waves"], "waves"),
            lister.if_given(&["seabed"], "sea bed"),
            materials(lister),
            lister.named("line", "section"),
            end("a"),
            end("b"),
            lister.if_given(&["payload"], "payload"),
            lister.if_given(&["payload", "rotation"], "payload"),
            lister.if_given(&["payload", "shape"], "payload"),
            lister.named("floats", "floats on"),
            lister.named("clumps", "body"),
            lister.named("modules", "modules on"),
            lister.if_given(&["traveller"], "traveller"),
            lister.always("start"),
            lister.always("solver"),
            lister.always("output"),
        ]
        .concat()
    }
}

/// Every material, each followed by its bore where it has one.
fn materials(lister: &FieldLister<'_>) -> Vec<FieldRow> {
    let names = lister
        .root
        .get("materials")
        .map_or_else(Vec::new, TomlNode::names);
    let each = names.iter().flat_map(|name| {
        let (path, group) = (["materials", name, "bore"], format!("material {name}"));
        let mut rows = lister.table("materials.*", &path[..2], &group);
        if lister.root.find(&path).is_some() {
            rows.extend(lister.table("materials.*.bore", &path, &group));
        }
        rows
    });
    each.collect()
}
