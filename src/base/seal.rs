//! The seal of a checkpoint: digests by which it is known to be whole, and to belong to the files beside it.
//!
//! A checkpoint ends with a table `[seal]`: length and SHA-256 of the case, of the rows of the history and of the shapes that it goes
//! on from. Its last table, `[seal.body]`, holds the SHA-256 of all that stands before it. Whoever edits on purpose can seal
//! anew; sizes, names and finiteness are therefore checked as well.

use std::fmt::Write as _;
use std::io::{self, Read};

use crate::files::shallow::shallow;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

/// A SHA-256 of bytes that follow one another.
#[derive(Debug, Clone, Default)]
pub struct Digest {
    sha: Sha256,
    bytes: u64,
}

/// Length and digest of a file, or of its beginning.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SealedPart {
    bytes: u64,
    sha256: String,
}

/// What a checkpoint belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Seal {
    /// The whole case.
    pub case: SealedPart,
    /// The history so far, with its header.
    pub history: SealedPart,
    /// The shapes so far, with their header.
    pub shapes: SealedPart,
}

/// The table as it is written.
#[derive(Serialize, Deserialize)]
struct SealTable {
    seal: Seal,
}

/// What the table of the body begins with.
const BODY: &str = "[seal.body]\nsha256 = \"";

impl Digest {
    /// That of some bytes.
    pub fn of_bytes(bytes: &[u8]) -> Self {
        let mut digest = Self::default();
        digest.update(bytes);
        digest
    }

    /// Takes in what follows.
    pub fn update(&mut self, bytes: &[u8]) {
        self.sha.update(bytes);
        self.bytes += bytes.len() as u64;
    }

    /// Length and digest so far.
    pub fn part(&self) -> SealedPart {
        SealedPart {
            bytes: self.bytes,
            sha256: self.text(),
        }
    }

    /// The digest so far, 64 hexadecimal digits.
    pub fn text(&self) -> String {
        let mut text = String::with_capacity(64);
        for byte in self.sha.clone().finalize() {
            // A string refuses nothing.
            let _ = write!(text, "{byte:02x}");
        }
        text
    }
}

impl SealedPart {
    /// Whether a file begins with it.
    pub fn begins(&self, file: impl Read) -> io::Result<bool> {
        let mut digest = Digest::default();
        let mut rest = file.take(self.bytes);
        let mut block = vec![0; 1 << 16];
        loop {
            let read = rest.read(&mut block)?;
            if read == 0 {
                return Ok(digest.part() == *self);
            }
            digest.update(&block[..read]);
        }
    }

    /// Whether a text is it.
    pub fn is(&self, text: &str) -> bool {
        Digest::of_bytes(text.as_bytes()).part() == *self
    }
}

/// A checkpoint with its seal.
///
/// # Errors
/// Never for a seal; the writer of TOML may refuse.
pub fn sealed(checkpoint: &str, seal: Seal) -> Result<String, toml::ser::Error> {
    let mut text = format!("{checkpoint}\n{}\n", toml::to_string(&SealTable { seal })?);
    let tail = tail(&text);
    text.push_str(&tail);
    Ok(text)
}

/// The table with the digest of all before it.
fn tail(before: &str) -> String {
    format!("{BODY}{}\"\n", Digest::of_bytes(before.as_bytes()).text())
}

/// What a checkpoint holds, and its seal.
///
/// # Errors
/// Why it is refused, in words: it is damaged, or holds a number that is not finite.
pub fn opened<C: DeserializeOwned>(text: &str) -> Result<(C, Seal), String> {
    let Some((before, _)) = text.rsplit_once(BODY) else {
        return Err("it has no seal by which it is known to be whole".to_owned());
    };
    if text[before.len()..] != tail(before) {
        return Err(
            "it was changed since it was written: its seal is that of another text".to_owned(),
        );
    }
    let table: toml::Table = toml::from_str(shallow(before)).map_err(|e| e.to_string())?;
    check_finite(&table)?;
    let SealTable { seal } = SealTable::deserialize(table.clone()).map_err(|e| e.to_string())?;
    let content = C::deserialize(table).map_err(|e| e.to_string())?;
    Ok((content, seal))
}

/// Checks that all numbers of a file are finite.
///
/// # Errors
/// Which one is not, in words.
pub fn check_finite(table: &toml::Table) -> Result<(), String> {
    let mut all = table.iter();
    match all.find_map(|(key, value)| not_finite(key, value)) {
        Some(key) => Err(format!("{key} is not finite")),
        None => Ok(()),
    }
}

/// The key of the first number that is not finite.
fn not_finite(key: &str, value: &toml::Value) -> Option<String> {
    match value {
        toml::Value::Float(number) => (!number.is_finite()).then(|| key.to_owned()),
        toml::Value::Array(list) => list.iter().find_map(|value| not_finite(key, value)),
        toml::Value::Table(table) => table
            .iter()
            .find_map(|(inner, value)| not_finite(&format!("{key}.{inner}"), value)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seal() -> Seal {
        let part = |text: &str| Digest::of_bytes(text.as_bytes()).part();
        Seal {
            case: part("case"),
            history: part("abc"),
            shapes: part(""),
        }
    }

    #[test]
    fn the_digest_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1.
        let mut digest = Digest::of_bytes(b"a");
        digest.update(b"bc");
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(digest.part().sha256, abc);
        assert_eq!(digest.part().bytes, 3);
    }

    #[test]
    fn a_part_is_known_where_more_follows_it() {
        let part = seal().history;
        assert!(part.begins(&b"abc"[..]).unwrap());
        assert!(part.begins(&b"abcd"[..]).unwrap());
        assert!(!part.begins(&b"ab"[..]).unwrap());
        assert!(!part.begins(&b"abd"[..]).unwrap());
        assert!(part.is("abc") && !part.is("abcd"));
    }

    #[test]
    fn every_changed_byte_is_seen() {
        let text = sealed("time = 1.5\n\n[[steps]]\nx = [1, 2]\n", seal()).unwrap();
        let (table, known) = opened::<toml::Table>(&text).unwrap();
        assert_eq!(table["time"].as_float(), Some(1.5));
        assert_eq!(known, seal());
        for at in 0..text.len() {
            let mut bytes = text.clone().into_bytes();
            bytes[at] ^= 1;
            let changed = String::from_utf8(bytes).unwrap();
            assert!(opened::<toml::Table>(&changed).is_err(), "byte {at}");
            assert!(opened::<toml::Table>(&text[..at]).is_err(), "cut at {at}");
        }
        assert!(opened::<toml::Table>(&format!("{text}\n")).is_err());
    }

    #[test]
    fn a_number_that_is_not_finite_is_named() {
        let text = sealed("[a]\nb = [1.0, inf]\n", seal()).unwrap();
        let refused = opened::<toml::Table>(&text).unwrap_err();
        assert_eq!(refused, "a.b is not finite");
    }
}
