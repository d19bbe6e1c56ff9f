//! Arrows between files: which names of which file another file uses.

use std::collections::{BTreeMap, BTreeSet};

use crate::floors::room;
use crate::names::{Target, Targets, is_ours, resolve};
use crate::sources::{Import, ImportedName, Module, ModuleId, Names, Sources};

/// The names that tie one file, or room, to another.
#[derive(Default)]
pub(crate) struct Arrows(pub(crate) BTreeMap<String, BTreeMap<String, BTreeSet<String>>>);

impl Arrows {
    pub(crate) fn between_files(sources: &Sources) -> Self {
        let mut arrows = Self::default();
        for (id, module) in sources.modules.iter().enumerate() {
            for target in targets(sources, id, module) {
                if let Target::Item(definer, name) = target {
                    arrows.add(&module.file, &sources.modules[definer].file, name);
                }
            }
        }
        arrows
    }

    /// The arrows between rooms, each named by the files and items that tie them.
    pub(crate) fn between_rooms(files: &Self) -> Self {
        let mut arrows = Self::default();
        for (from, to, names) in files.each() {
            for name in names {
                arrows.add(&room(from), &room(to), format!("{from} -> {to} {name}"));
            }
        }
        arrows
    }

    fn add(&mut self, from: &str, to: &str, name: String) {
        if from != to {
            self.0
                .entry(from.to_owned())
                .or_default()
                .entry(to.to_owned())
                .or_default()
                .insert(name);
        }
    }

    /// Every arrow: from, to, names.
    pub(crate) fn each(&self) -> impl Iterator<Item = (&String, &String, &BTreeSet<String>)> {
        self.0
            .iter()
            .flat_map(|(from, to)| to.iter().map(move |(to, names)| (from, to, names)))
    }
}

/// The names of an arrow, as text.
pub(crate) fn words(names: &BTreeSet<String>) -> String {
    names
        .iter()
        .map(String::as_str)
        .collect::<Vec<_>>()
        .join(", ")
}

/// The paths from a crate's root, or from a module's parent, that lead nowhere.
pub(crate) fn unresolved(sources: &Sources) -> Vec<String> {
    let mut found = Vec::new();
    for (id, module) in sources.modules.iter().enumerate() {
        let imported = module.imports.iter().map(|import| &import.path);
        for path in imported.chain(&module.paths) {
            let starts = resolve(sources, id, &path[..1]);
            let leads_to_us = starts
                .iter()
                .any(|start| matches!(start, Target::Module(_)));
            if (is_ours(path) || leads_to_us) && resolve(sources, id, path).is_empty() {
                found.push(format!("{}: {}", module.file, path.join("::")));
            }
        }
    }
    found
}

/// All that the code of a module names.
fn targets(sources: &Sources, id: ModuleId, module: &Module) -> Targets {
    let imported = module
        .imports
        .iter()
        .filter(|import| !hands_on(module, import));
    let by_imports = imported.flat_map(|import| targets_of_import(sources, id, import));
    let by_paths = module
        .paths
        .iter()
        .flat_map(|path: &Names| resolve(sources, id, path));
    by_imports.chain(by_paths).collect()
}

/// Whether an import is only for other modules. The root of a folder hands names on; elsewhere `pub use` is a use.
fn hands_on(module: &Module, import: &Import) -> bool {
    import.is_public && !module.children.is_empty()
}

/// What an import certainly uses. A name that is a module's too, or one of many, counts where the code names it.
fn targets_of_import(sources: &Sources, id: ModuleId, import: &Import) -> Targets {
    let targets = resolve(sources, id, &import.path);
    let is_module = targets
        .iter()
        .any(|target| matches!(target, Target::Module(_)));
    if is_module || import.name == ImportedName::Every {
        Targets::new()
    } else {
        targets
    }
}
