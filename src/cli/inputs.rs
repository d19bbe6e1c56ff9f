//! The files that a command reads, so that it never writes onto one of them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use toml::Value;

use seacable_base::files::read;
use seacable_base::files::shallow::shallow;
use seacable_runs::run::store;

/// The files that a command reads which is given these paths: the files themselves, the case files below directories,
/// the files of stored runs, and all files that TOML files name in a value.
pub(super) fn inputs(paths: &[PathBuf]) -> Vec<PathBuf> {
    let mut found = BTreeSet::new();
    for path in paths {
        collect(path, &mut found);
    }
    found.into_iter().collect()
}

fn collect(path: &Path, found: &mut BTreeSet<PathBuf>) {
    if path.is_dir() {
        collect_directory(path, found);
    } else if path.is_file() && found.insert(path.to_owned()) && is_toml(path) {
        let text = read::text(path).unwrap_or_default();
        let folder = path.parent().unwrap_or(Path::new(""));
        if let Ok(table) = shallow(&text).parse::<toml::Table>() {
            collect_named(&Value::Table(table), folder, found);
        }
    }
}

/// The files of a stored run, or the case files below a directory.
fn collect_directory(directory: &Path, found: &mut BTreeSet<PathBuf>) {
    if directory.join(store::RUN).is_file() {
        let files = store::FILES.iter().map(|name| directory.join(name));
        found.extend(files.filter(|file| file.is_file()));
        return;
    }
    for item in fs::read_dir(directory).into_iter().flatten().flatten() {
        let path = item.path();
        let is_link = path.is_symlink();
        if is_toml(&path) || (path.is_dir() && !is_link) {
            collect(&path, found);
        }
    }
}

/// The files that the strings of a TOML value name, relative to the folder of its file.
fn collect_named(value: &Value, folder: &Path, found: &mut BTreeSet<PathBuf>) {
    match value {
        Value::String(name) if !name.is_empty() => {
            let path = folder.join(name);
            let is_plain_directory = path.is_dir() && !path.join(store::RUN).is_file();
            if !is_plain_directory {
                collect(&path, found);
            }
        }
        Value::Array(values) => values
            .iter()
            .for_each(|value| collect_named(value, folder, found)),
        Value::Table(table) => table
            .values()
            .for_each(|value| collect_named(value, folder, found)),
        _ => {}
    }
}

fn is_toml(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension == "toml")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_named_in_files_are_inputs() {
        let dir = tempfile::tempdir().unwrap();
        let put = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
        put("a.toml", "[sea]\nfile = \"b.toml\"\nname = \"nothing\"\n");
        put(
            "b.toml",
            "curves = [{ file = \"c.csv\" }]\nback = \"a.toml\"\n",
        );
        put("c.csv", "x,y\n");
        put("d.csv", "x,y\n");
        let found = inputs(&[dir.path().join("a.toml")]);
        let names: Vec<_> = found.iter().map(|path| path.file_name().unwrap()).collect();
        assert_eq!(names, ["a.toml", "b.toml", "c.csv"]);
        assert_eq!(inputs(&[dir.path().to_owned()]).len(), 3);
    }

    #[test]
    fn the_files_of_a_run_are_inputs_but_not_a_report_beside_them() {
        let dir = tempfile::tempdir().unwrap();
        for name in [store::RUN, store::HISTORY, "report.txt"] {
            fs::write(dir.path().join(name), "").unwrap();
        }
        assert_eq!(inputs(&[dir.path().to_owned()]).len(), 2);
    }
}
