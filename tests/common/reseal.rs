//! Seals a checkpoint anew, as somebody may who edits one on purpose: what is refused then is refused for what it holds.

use std::fs;
use std::path::Path;

use sha2::{Digest, Sha256};

/// What a checkpoint holds, without its seal.
pub(crate) fn unsealed(text: &str) -> &str {
    text.split("\n[seal").next().unwrap()
}

/// Writes a checkpoint with the seal of the files beside it.
pub(crate) fn reseal(dir: &Path, body: &str) {
    let part = |name: &str, file: &str| {
        let bytes = fs::read(dir.join(file)).unwrap();
        let (length, sha256) = (bytes.len(), hex(&bytes));
        format!("[seal.{name}]\nbytes = {length}\nsha256 = \"{sha256}\"\n")
    };
    let parts = [
        ("case", "case.toml"),
        ("history", "history.csv"),
        ("shapes", "shapes.csv"),
    ];
    let parts: String = parts.iter().map(|(name, file)| part(name, file)).collect();
    let text = format!("{body}\n{parts}");
    let tail = format!("[seal.body]\nsha256 = \"{}\"\n", hex(text.as_bytes()));
    fs::write(dir.join("checkpoint.toml"), text + &tail).unwrap();
}

fn hex(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}
