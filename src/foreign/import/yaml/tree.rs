//! A YAML text as a tree whose nodes know their bytes.

use std::ops::Range;

use crate::import::words::Word;

/// A key of a mapping.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct YamlKey {
    /// Its text.
    pub name: String,
    /// Its bytes in the file.
    pub span: Range<usize>,
}

/// A word, number or text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Scalar {
    /// Its text, without quotes.
    pub text: String,
    /// Whether it stands in quotes or is a block of text.
    pub is_quoted: bool,
    /// Its tag, `!include`, if it has one.
    pub tag: Option<String>,
}

/// What a node is; others are named by their places in the list of the document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Value {
    /// A word, number or text; an empty plain one is null.
    Scalar(Scalar),
    /// Nodes one after the other.
    Sequence(Vec<usize>),
    /// Nodes by keys.
    Mapping(Vec<(YamlKey, usize)>),
}

/// A node with its bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spanned {
    /// Where it is; of a mapping its first key.
    pub span: Range<usize>,
    /// What it is.
    pub value: Value,
}

/// A file as a tree. An alias is the node that it names, which so has several parents; none is its own descendant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct YamlDocument {
    pub(super) nodes: Vec<Spanned>,
    pub(super) root: usize,
}

impl YamlDocument {
    /// The node that everything is in.
    #[must_use]
    pub fn root(&self) -> Option<YamlNode<'_>> {
        self.node(self.root, None)
    }

    fn node<'d>(&'d self, id: usize, key: Option<&'d YamlKey>) -> Option<YamlNode<'d>> {
        let spanned = self.nodes.get(id)?;
        Some(YamlNode {
            document: self,
            spanned,
            key,
        })
    }
}

/// A node of a document, with the key by which it was reached.
#[derive(Debug, Clone, Copy)]
pub struct YamlNode<'d> {
    document: &'d YamlDocument,
    spanned: &'d Spanned,
    key: Option<&'d YamlKey>,
}

impl<'d> YamlNode<'d> {
    /// Its bytes; of a mapping its first key.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.spanned.span.clone()
    }

    /// The bytes of its key; its own where it has none.
    #[must_use]
    pub fn key_span(&self) -> Range<usize> {
        self.key.map_or_else(|| self.span(), |key| key.span.clone())
    }

    /// Whether its key has no value.
    #[must_use]
    pub fn is_null(&self) -> bool {
        let is_null = |scalar: &Scalar| {
            !scalar.is_quoted && ["", "~", "null", "Null", "NULL"].contains(&scalar.text.as_str())
        };
        self.scalar().is_some_and(is_null)
    }

    /// The word, number or text that it is.
    #[must_use]
    pub fn scalar(&self) -> Option<&'d Scalar> {
        match &self.spanned.value {
            Value::Scalar(scalar) => Some(scalar),
            Value::Sequence(_) | Value::Mapping(_) => None,
        }
    }

    /// Its text.
    #[must_use]
    pub fn text(&self) -> Option<&'d str> {
        self.scalar().map(|scalar| scalar.text.as_str())
    }

    /// The number that it is, in quotes or not, in the ways of C and of Fortran; infinite and NaN are none.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        let text = self.text()?.trim();
        Word { text, start: 0 }.number()
    }

    /// Whether it is an integer with a leading zero, which YAML readers take as octal.
    #[must_use]
    pub fn is_octal(&self) -> bool {
        let digits = |scalar: &Scalar| {
            let text = scalar.text.trim_start_matches(['+', '-']);
            let has_zero = text.len() > 1 && text.starts_with('0');
            !scalar.is_quoted && has_zero && text.bytes().all(|byte| byte.is_ascii_digit())
        };
        self.scalar().is_some_and(digits)
    }

    /// Its nodes, if it is a sequence.
    #[must_use]
    pub fn items(&self) -> Option<Vec<Self>> {
        let Value::Sequence(ids) = &self.spanned.value else {
            return None;
        };
        let items = ids.iter().filter_map(|id| self.document.node(*id, None));
        Some(items.collect())
    }

    /// Its nodes by keys, if it is a mapping.
    #[must_use]
    pub fn entries(&self) -> Option<Vec<(&'d str, Self)>> {
        let Value::Mapping(entries) = &self.spanned.value else {
            return None;
        };
        let entries = entries.iter().filter_map(|(key, id)| {
            let node = self.document.node(*id, Some(key))?;
            Some((key.name.as_str(), node))
        });
        Some(entries.collect())
    }

    /// Whether it is a mapping.
    #[must_use]
    pub fn is_mapping(&self) -> bool {
        matches!(self.spanned.value, Value::Mapping(_))
    }

    /// The node of a key.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<Self> {
        let Value::Mapping(entries) = &self.spanned.value else {
            return None;
        };
        let (key, id) = entries.iter().find(|(key, _)| key.name == name)?;
        self.document.node(*id, Some(key))
    }

    /// What it is, in words.
    #[must_use]
    pub fn description(&self) -> String {
        match &self.spanned.value {
            Value::Scalar(_) if self.is_null() => "nothing".to_owned(),
            Value::Scalar(scalar) => format!("`{}`", shortened(&scalar.text)),
            Value::Sequence(items) => format!("a list of {}", items.len()),
            Value::Mapping(_) => "a mapping".to_owned(),
        }
    }
}

/// A text without ends of lines and other control characters: they are blanks.
#[must_use]
pub fn in_a_row(text: &str) -> String {
    text.replace(char::is_control, " ")
}

/// A text that fits into a message: short, in one row.
#[must_use]
pub fn shortened(text: &str) -> String {
    const GREATEST: usize = 40;
    let text = in_a_row(text);
    let mut letters = text.chars();
    let mut short: String = letters.by_ref().take(GREATEST).collect();
    if letters.next().is_some() {
        short.push_str("...");
    }
    short
}
