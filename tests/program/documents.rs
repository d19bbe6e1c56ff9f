//! Paths that the documents name exist.

use std::fs;
use std::path::Path;

const DOCUMENTS: [&str; 11] = [
    "README.md",
    "CONTRIBUTING.md",
    "docs/ARCHITECTURE.md",
    "docs/GLOSSARY.md",
    "docs/FILES.md",
    "docs/CLUSTER.md",
    "docs/METHODS.md",
    "docs/MUTANTS.md",
    "docs/SECURITY.md",
    "docs/SPEED.md",
    "docs/WORKBENCH.md",
];

/// The paths of the repository in a text: in code, or as the target of a link.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(['`', '(', ')', ' ', '\n', ',']);
    let roots = [
        "src/",
        "tests/",
        "cases/",
        "docs/",
        "examples/",
        "benches/",
        ".ci/",
    ];
    words.filter(move |word| roots.iter().any(|root| word.starts_with(root)))
}

#[test]
fn every_path_in_the_documents_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for document in DOCUMENTS {
        let text = fs::read_to_string(root.join(document)).unwrap();
        let absent: Vec<&str> = paths(&text)
            .map(|path| path.trim_end_matches(['.', ':', ';']))
            .filter(|path| !path.contains("NAME") && !root.join(path).exists())
            .collect();
        assert!(absent.is_empty(), "{document} names {absent:?}");
    }
}
