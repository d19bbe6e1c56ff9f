//! The cases that come with the program, so that it needs nothing but itself.

/// Path below `cases` and text.
pub type Shipped = (&'static str, &'static str);

macro_rules! shipped {
    ($path:literal) => {
        ($path, include_str!(concat!("../../cases/", $path)))
    };
}

/// The cases that come with the program, in the order of their paths.
pub const SHIPPED: &[Shipped] = &[
    shipped!("basics/hanging_line.toml"),
    shipped!("basics/mooring_static.toml"),
    shipped!("basics/pendulum.toml"),
    shipped!("basics/steep_wave.toml"),
    shipped!("benchmarks/current_across.toml"),
    shipped!("benchmarks/current_along.toml"),
    shipped!("benchmarks/elastica.toml"),
    shipped!("benchmarks/point_load.toml"),
    shipped!("pendulous/manifold.toml"),
    shipped!("pendulous/module.toml"),
    shipped!("umbilical/catenary.toml"),
    shipped!("umbilical/steep_wave.toml"),
];

/// The cross-sections that come with the program, in the order of their paths.
pub const SECTIONS: &[Shipped] = &[
    shipped!("umbilical/section.toml"),
    shipped!("umbilical/section_power_cable.toml"),
];

#[cfg(test)]
mod tests {
    use std::{
        collections::BTreeMap,
        fs,
        path::{Path, PathBuf},
    };

    use super::{SECTIONS, SHIPPED, Shipped};
    use crate::section::is_section;

    #[test]
    fn the_lists_are_the_folder() {
        same(SHIPPED, |path| !is_section(path));
        same(SECTIONS, is_section);
    }

    fn same(list: &[Shipped], belongs: impl Fn(&Path) -> bool) {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
        let mut found = BTreeMap::new();
        let mut folders: Vec<PathBuf> = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for item in fs::read_dir(folder).unwrap() {
                let path = item.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|e| e == "toml") && belongs(&path) {
                    let name = path
                        .strip_prefix(&root)
                        .unwrap()
                        .to_str()
                        .unwrap()
                        .to_owned();
                    found.insert(name, fs::read_to_string(&path).unwrap());
                }
            }
        }
        let listed: BTreeMap<String, String> = list
            .iter()
            .map(|(path, text)| ((*path).to_owned(), (*text).to_owned()))
            .collect();
        assert_eq!(
            listed.keys().collect::<Vec<_>>(),
            found.keys().collect::<Vec<_>>()
        );
        assert!(listed == found, "a listed case is not the text of its file");
    }
}
