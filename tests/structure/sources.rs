//! Every file of the sources as modules: what each defines, imports and names.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, File, Ident, Item, ItemMod, UseTree, Visibility};

/// The names of a path, from its first.
pub(crate) type Names = Vec<String>;

/// The index of a module in [`Sources::modules`].
pub(crate) type ModuleId = usize;

/// The modules of all floors.
pub(crate) struct Sources {
    pub(crate) modules: Vec<Module>,
    /// The module at the root of each floor.
    pub(crate) roots: BTreeMap<String, ModuleId>,
    src: PathBuf,
}

/// A module: a file, or a part of one between braces.
pub(crate) struct Module {
    /// Its file, from `src`.
    pub(crate) file: String,
    pub(crate) floor: String,
    pub(crate) parent: Option<ModuleId>,
    pub(crate) children: BTreeMap<String, ModuleId>,
    /// Types, traits and macros by name, an enumeration with its variants.
    pub(crate) types: BTreeMap<String, BTreeSet<String>>,
    /// Functions, constants and statics.
    pub(crate) values: BTreeSet<String>,
    /// The names inside macro calls that may define items.
    pub(crate) in_macros: BTreeSet<String>,
    pub(crate) imports: Vec<Import>,
    /// The paths that its code names.
    pub(crate) paths: BTreeSet<Names>,
}

/// A name that a `use` brings into scope.
pub(crate) struct Import {
    pub(crate) path: Names,
    pub(crate) name: ImportedName,
    /// Whether other modules can reach the item through this module.
    pub(crate) is_public: bool,
}

#[derive(PartialEq)]
pub(crate) enum ImportedName {
    As(String),
    /// `_`: a trait for its methods.
    Unnamed,
    /// `*`
    Every,
}

impl Sources {
    /// Reads every folder of `src`, each a crate, as a floor. The files of `src` itself only hand names on.
    pub(crate) fn read(src: &Path) -> Self {
        let mut sources = Self {
            modules: Vec::new(),
            roots: BTreeMap::new(),
            src: src.to_owned(),
        };
        for entry in std::fs::read_dir(src).unwrap() {
            let folder = entry.unwrap().path();
            let root = ["lib.rs", "mod.rs"]
                .map(|name| folder.join(name))
                .into_iter()
                .find(|file| file.exists());
            if let Some(root) = root {
                let floor = folder.file_name().unwrap().to_str().unwrap().to_owned();
                let id = sources.read_file(&root, &floor, None);
                sources.roots.insert(floor, id);
            }
        }
        sources
    }

    pub(crate) fn floors(&self) -> BTreeSet<String> {
        self.roots.keys().cloned().collect()
    }

    /// The text of a file, named from `src`.
    pub(crate) fn text(&self, file: &str) -> String {
        std::fs::read_to_string(self.src.join(file)).unwrap()
    }

    fn read_file(&mut self, file: &Path, floor: &str, parent: Option<ModuleId>) -> ModuleId {
        let text = std::fs::read_to_string(file).unwrap();
        let syntax: File =
            syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let id = self.add_module(file, floor, parent);
        self.read_items(id, &syntax.items, &folder_of_children(file));
        id
    }

    fn add_module(&mut self, file: &Path, floor: &str, parent: Option<ModuleId>) -> ModuleId {
        self.modules.push(Module {
            file: file
                .strip_prefix(&self.src)
                .unwrap()
                .to_str()
                .unwrap()
                .to_owned(),
            floor: floor.to_owned(),
            parent,
            children: BTreeMap::new(),
            types: BTreeMap::new(),
            values: BTreeSet::new(),
            in_macros: BTreeSet::new(),
            imports: Vec::new(),
            paths: BTreeSet::new(),
        });
        self.modules.len() - 1
    }

    fn read_items(&mut self, id: ModuleId, items: &[Item], folder: &Path) {
        for item in items.iter().filter(|item| !is_for_tests(attributes(item))) {
            match item {
                Item::Mod(child) => self.read_child(id, child, folder),
                _ => {
                    self.modules[id].define(item);
                    Reader {
                        module: &mut self.modules[id],
                    }
                    .visit_item(item);
                }
            }
        }
    }

    fn read_child(&mut self, parent: ModuleId, child: &ItemMod, folder: &Path) {
        let name = child.ident.to_string();
        let floor = self.modules[parent].floor.clone();
        let id = if let Some((_, items)) = &child.content {
            let file = self.src.join(&self.modules[parent].file);
            let id = self.add_module(&file, &floor, Some(parent));
            self.read_items(id, items, &folder.join(&name));
            id
        } else {
            let flat = folder.join(format!("{name}.rs"));
            let file = if flat.exists() {
                flat
            } else {
                folder.join(&name).join("mod.rs")
            };
            self.read_file(&file, &floor, Some(parent))
        };
        self.modules[parent].children.insert(name, id);
    }
}

/// Where the files of the modules below a file are.
fn folder_of_children(file: &Path) -> PathBuf {
    let is_root = ["lib.rs", "mod.rs"].iter().any(|name| file.ends_with(name));
    if is_root {
        file.parent().unwrap().to_owned()
    } else {
        file.with_extension("")
    }
}

impl Module {
    /// Notes the name that an item defines.
    fn define(&mut self, item: &Item) {
        match item {
            Item::Const(item) => self.define_value(&item.ident),
            Item::Fn(item) => self.define_value(&item.sig.ident),
            Item::Static(item) => self.define_value(&item.ident),
            Item::Enum(item) => {
                let variants = item
                    .variants
                    .iter()
                    .map(|variant| variant.ident.to_string());
                self.types
                    .insert(item.ident.to_string(), variants.collect());
            }
            Item::Struct(item) => self.define_type(&item.ident),
            Item::Trait(item) => self.define_type(&item.ident),
            Item::Type(item) => self.define_type(&item.ident),
            Item::Union(item) => self.define_type(&item.ident),
            Item::Macro(item) => {
                names_of(&item.mac.tokens, &mut self.in_macros);
                item.ident.iter().for_each(|name| self.define_type(name));
            }
            _ => {}
        }
    }

    fn define_type(&mut self, name: &Ident) {
        self.types.insert(name.to_string(), BTreeSet::new());
    }

    fn define_value(&mut self, name: &Ident) {
        self.values.insert(name.to_string());
    }

    fn import(&mut self, tree: &UseTree, before: &[String], is_public: bool) {
        let path = |last: &dyn ToString| [before, &[last.to_string()]].concat();
        match tree {
            UseTree::Path(tree) => self.import(&tree.tree, &path(&tree.ident), is_public),
            UseTree::Group(group) => group
                .items
                .iter()
                .for_each(|tree| self.import(tree, before, is_public)),
            UseTree::Glob(_) => self.add_import(before.to_vec(), ImportedName::Every, is_public),
            UseTree::Name(tree) if tree.ident == "self" => {
                let name = before.last().unwrap().clone();
                self.add_import(before.to_vec(), ImportedName::As(name), is_public);
            }
            UseTree::Name(tree) => {
                self.add_import(
                    path(&tree.ident),
                    ImportedName::As(tree.ident.to_string()),
                    is_public,
                );
            }
            UseTree::Rename(tree) => {
                let whole = if tree.ident == "self" {
                    before.to_vec()
                } else {
                    path(&tree.ident)
                };
                let name = match tree.rename.to_string() {
                    name if name == "_" => ImportedName::Unnamed,
                    name => ImportedName::As(name),
                };
                self.add_import(whole, name, is_public);
            }
        }
    }

    fn add_import(&mut self, path: Names, name: ImportedName, is_public: bool) {
        self.imports.push(Import {
            path,
            name,
            is_public,
        });
    }
}

/// Notes what the code of a module imports and names.
struct Reader<'a> {
    module: &'a mut Module,
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            _ if is_for_tests(attributes(item)) => {}
            Item::Use(item) if item.leading_colon.is_some() => {}
            Item::Use(item) => {
                let is_public = !matches!(item.vis, Visibility::Inherited);
                self.module.import(&item.tree, &[], is_public);
            }
            // Paths in a macro's definition belong to where it is called, but for those from the crate's root.
            Item::Macro(item) if item.ident.is_some() => {
                let mut paths = BTreeSet::new();
                paths_of(&item.mac.tokens, &mut paths);
                self.module
                    .paths
                    .extend(paths.into_iter().filter(|path| path[0] == "crate"));
            }
            _ => visit::visit_item(self, item),
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if !is_for_tests(&item.attrs) {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_field(&mut self, field: &'ast syn::Field) {
        if !is_for_tests(&field.attrs) {
            visit::visit_field(self, field);
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.module.paths.insert(
                path.segments
                    .iter()
                    .map(|segment| segment.ident.to_string())
                    .collect(),
            );
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        self.visit_path(&call.path);
        paths_of(&call.tokens, &mut self.module.paths);
    }

    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_visibility(&mut self, _: &'ast Visibility) {}
}

/// Whether only tests compile what these attributes are on.
fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("cfg"))
        .any(|attribute| {
            attribute.meta.require_list().is_ok_and(|list| {
                let condition = list.tokens.to_string();
                condition == "test" || condition.starts_with("all (test")
            })
        })
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// All names among tokens.
fn names_of(tokens: &TokenStream, names: &mut BTreeSet<String>) {
    for token in tokens.clone() {
        match token {
            TokenTree::Group(group) => names_of(&group.stream(), names),
            TokenTree::Ident(name) => {
                names.insert(name.to_string());
            }
            _ => {}
        }
    }
}

/// All paths among the tokens of a macro, whose syntax is its own.
fn paths_of(tokens: &TokenStream, paths: &mut BTreeSet<Names>) {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let is_mark = |at: usize, mark: char| matches!(tokens.get(at), Some(TokenTree::Punct(it)) if it.as_char() == mark);
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Group(group) => paths_of(&group.stream(), paths),
            TokenTree::Ident(first) => {
                let is_member = at > 0 && is_mark(at - 1, '.') && !(at > 1 && is_mark(at - 2, '.'));
                let is_variable = at > 0 && is_mark(at - 1, '$') && first != "crate";
                let mut path = vec![first.to_string()];
                while is_mark(at + 1, ':') && is_mark(at + 2, ':') {
                    let Some(TokenTree::Ident(next)) = tokens.get(at + 3) else {
                        break;
                    };
                    path.push(next.to_string());
                    at += 3;
                }
                let is_visibility = path == ["crate"];
                if !is_member && !is_variable && !is_visibility {
                    paths.insert(path);
                }
            }
            _ => {}
        }
        at += 1;
    }
}
