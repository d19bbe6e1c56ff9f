//! What is varied, and the inputs that all points share.

use super::VariationView;
use crate::document::Report;
use crate::text::inputs;
use seacable_base::files::shallow::shallow;
use seacable_model::case::{Case, FieldRow, kind};
use seacable_model::kinds::FileType;
use seacable_systems::system::SystemFile;

impl VariationView<'_> {
    /// Adds the title, the file, what is set on top of it, and what is varied.
    pub(crate) fn add_head(&self, page: &mut Report) {
        let base = &self.variation.base;
        let keys = self.variation.keys.iter().map(|key| key.path.as_str());
        page.title(&format!("Load cases of {}", base.file()));
        page.pairs(&[
            ("File", base.file()),
            ("Set on top", base.overrides.join(", ")),
            ("Varied", keys.collect::<Vec<_>>().join(", ")),
            ("Load cases", self.variation.points.len().to_string()),
            ("Version", format!("seacable {}", env!("CARGO_PKG_VERSION"))),
        ]);
    }

    /// Adds the inputs of the file; those that are varied have other values in each load case.
    pub(crate) fn add_inputs(&self, page: &mut Report) {
        let text = &self.variation.base.text;
        let (fields, source) = match FileType::of_text(text) {
            FileType::System => (kind::rows::<SystemFile>(text), source_of(text, "system")),
            _ => (kind::rows::<Case>(text), source_of(text, "case")),
        };
        let is_varied = |field: &FieldRow| {
            let mut keys = self.variation.keys.iter();
            keys.any(|key| key.path == field.path)
        };
        let shared: Vec<FieldRow> = fields.into_iter().filter(|row| !is_varied(row)).collect();
        inputs(page, &shared, source);
    }
}

/// Whether a file names the source of its data, in the table of this name.
fn source_of(text: &str, table: &str) -> bool {
    let parsed = shallow(text).parse::<toml::Table>().ok();
    let source = parsed
        .as_ref()
        .and_then(|all| all.get(table)?.get("source")?.as_str());
    source.is_some_and(|source| !source.trim().is_empty())
}
