//! From a path to what it names, through imports and what modules hand on.

use std::collections::BTreeSet;

use crate::sources::{ImportedName, ModuleId, Sources};

/// What a path names.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Target {
    Module(ModuleId),
    /// An item, by the module that defines it. What follows it in a path, a variant or a function, is part of it.
    Item(ModuleId, String),
    /// Something of another crate.
    Outside,
}

/// All that a path names: a name may be a module's and a function's.
pub(crate) type Targets = BTreeSet<Target>;

/// Names being looked up, so that imports in a circle end.
type Pending = BTreeSet<(ModuleId, String)>;

/// What a path in a module names; nothing if it leads nowhere.
pub(crate) fn resolve(sources: &Sources, from: ModuleId, path: &[String]) -> Targets {
    Lookup {
        sources,
        pending: Pending::new(),
    }
    .resolve(from, path)
}

/// Whether a path certainly leads to this crate.
pub(crate) fn is_ours(path: &[String]) -> bool {
    ["crate", "self", "super"].contains(&path[0].as_str())
}

struct Lookup<'a> {
    sources: &'a Sources,
    pending: Pending,
}

impl Lookup<'_> {
    fn resolve(&mut self, from: ModuleId, path: &[String]) -> Targets {
        let (first, rest) = path.split_first().unwrap();
        let module = &self.sources.modules[from];
        match first.as_str() {
            "crate" => self.follow(
                Targets::from([Target::Module(self.sources.roots[&module.floor])]),
                rest,
            ),
            "self" => self.follow(Targets::from([Target::Module(from)]), rest),
            "super" => self.follow(
                module.parent.map(Target::Module).into_iter().collect(),
                rest,
            ),
            name => {
                let mut found = self.look_up(from, name);
                if found.is_empty() {
                    found.insert(self.other_crate(name));
                }
                self.follow(found, rest)
            }
        }
    }

    fn other_crate(&self, name: &str) -> Target {
        let floor = name
            .strip_prefix("seacable_")
            .and_then(|floor| self.sources.roots.get(floor));
        floor.map_or(Target::Outside, |&root| Target::Module(root))
    }

    fn follow(&mut self, start: Targets, path: &[String]) -> Targets {
        path.iter().fold(start, |targets, name| {
            targets
                .into_iter()
                .flat_map(|target| self.step(target, name))
                .collect()
        })
    }

    fn step(&mut self, target: Target, name: &str) -> Targets {
        match target {
            Target::Module(module) if name == "super" => self.sources.modules[module]
                .parent
                .map(Target::Module)
                .into_iter()
                .collect(),
            Target::Module(module) => self.look_up(module, name),
            // Functions and constants have nothing below them: a module of the same name is meant.
            Target::Item(module, item) if self.sources.modules[module].values.contains(&item) => {
                Targets::new()
            }
            within => Targets::from([within]),
        }
    }

    /// What a name means in a module.
    fn look_up(&mut self, id: ModuleId, name: &str) -> Targets {
        if !self.pending.insert((id, name.to_owned())) {
            return Targets::new();
        }
        let mut found = self.defined(id, name);
        found.extend(self.imported(id, name));
        if found.is_empty() {
            found = self.in_globs(id, name);
        }
        if found.is_empty() && self.sources.modules[id].in_macros.contains(name) {
            found.insert(Target::Item(id, name.to_owned()));
        }
        self.pending.remove(&(id, name.to_owned()));
        found
    }

    fn defined(&self, id: ModuleId, name: &str) -> Targets {
        let module = &self.sources.modules[id];
        let child = module
            .children
            .get(name)
            .map(|&child| Target::Module(child));
        let is_item = module.types.contains_key(name) || module.values.contains(name);
        let item = is_item.then(|| Target::Item(id, name.to_owned()));
        child.into_iter().chain(item).collect()
    }

    fn imported(&mut self, id: ModuleId, name: &str) -> Targets {
        let imports = &self.sources.modules[id].imports;
        let named = imports
            .iter()
            .filter(|import| matches!(&import.name, ImportedName::As(it) if it == name));
        named
            .flat_map(|import| self.resolve(id, &import.path))
            .collect()
    }

    fn in_globs(&mut self, id: ModuleId, name: &str) -> Targets {
        let mut found = Targets::new();
        for import in self.sources.modules[id]
            .imports
            .iter()
            .filter(|import| import.name == ImportedName::Every)
        {
            for target in self.resolve(id, &import.path) {
                match target {
                    Target::Module(module) => found.extend(self.look_up(module, name)),
                    Target::Item(module, item)
                        if self.sources.modules[module]
                            .types
                            .get(&item)
                            .is_some_and(|it| it.contains(name)) =>
                    {
                        found.insert(Target::Item(module, item));
                    }
                    _ => {}
                }
            }
        }
        found
    }
}
