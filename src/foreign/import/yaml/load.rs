//! The tree of a YAML text, from the events of the parser.
//!
//! An alias names a node that is complete and is not copied, so that aliases of aliases take no memory. Depth and number of nodes are
//! bounded. Merge keys (`<<`) are resolved.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use saphyr_parser::{Event, Marker, Parser, ScalarStyle, ScanError, Span};

use super::tree::{Scalar, Spanned, Value, YamlDocument, YamlKey, shortened};
use crate::import::fault::Fault;

/// Greatest depth of nodes.
const GREATEST_DEPTH: usize = 100;
/// Greatest number of nodes, entries that are merged included.
const GREATEST_COUNT: usize = 4_000_000;

/// The tree of a text, and keys that occur twice in a mapping, whose first value stays.
///
/// # Errors
/// The first fault of its syntax; what is too large or has several documents.
pub fn load(text: &str) -> Result<(YamlDocument, Vec<Fault>), Fault> {
    let text_without_mark = text.strip_prefix('\u{feff}').unwrap_or(text);
    let places = Places::of_text(text_without_mark, text.len() - text_without_mark.len());
    let mut loader = Loader::new(places);
    for event in Parser::new_from_str(text_without_mark) {
        let (event, span) = event.map_err(|error| loader.syntax(&error, text))?;
        loader.take(event, span)?;
    }
    let Some(root) = loader.root else {
        return Err(Fault::new(
            0..0,
            "",
            "the file is empty: it has no YAML document",
            "write a design with a `mooring` table",
        ));
    };
    let document = YamlDocument {
        nodes: loader.nodes,
        root,
    };
    Ok((document, loader.duplicates))
}

/// The bytes of positions, which the parser counts in characters.
struct Places {
    /// The byte of each character; none where every character is one byte.
    bytes: Option<Vec<usize>>,
    length: usize,
    /// Bytes before the text.
    offset: usize,
}

impl Places {
    fn of_text(text: &str, offset: usize) -> Self {
        let bytes = || text.char_indices().map(|(byte, _)| byte).collect();
        Self {
            bytes: (!text.is_ascii()).then(bytes),
            length: text.len(),
            offset,
        }
    }

    fn byte(&self, at: &Marker) -> usize {
        let byte = match &self.bytes {
            None => at.index().min(self.length),
            Some(bytes) => bytes.get(at.index()).copied().unwrap_or(self.length),
        };
        byte + self.offset
    }

    fn range(&self, span: Span) -> Range<usize> {
        let start = self.byte(&span.start);
        start..self.byte(&span.end).max(start)
    }
}

/// A sequence or mapping that has begun.
struct OpenCollection {
    anchor: usize,
    span: Range<usize>,
    content: NodeContent,
}

enum NodeContent {
    Sequence(Vec<usize>),
    Mapping(Box<OpenMapping>),
}

#[derive(Default)]
struct OpenMapping {
    entries: Vec<(YamlKey, usize)>,
    names: HashSet<String>,
    /// The key whose value comes next.
    key: Option<YamlKey>,
    /// Nodes of merge keys.
    merged: Vec<(usize, Range<usize>)>,
}

struct Loader {
    places: Places,
    nodes: Vec<Spanned>,
    count: usize,
    open: Vec<OpenCollection>,
    anchors: HashMap<usize, usize>,
    documents: usize,
    root: Option<usize>,
    duplicates: Vec<Fault>,
}

impl Loader {
    fn new(places: Places) -> Self {
        Self {
            places,
            nodes: Vec::new(),
            count: 0,
            open: Vec::new(),
            anchors: HashMap::new(),
            documents: 0,
            root: None,
            duplicates: Vec::new(),
        }
    }

    fn syntax(&self, error: &ScanError, text: &str) -> Fault {
        let at = self.places.byte(error.marker());
        let is_json = text_is_json(text);
        let what = if is_json { "JSON" } else { "YAML" };
        if let Some(tab) = tab_near(text, at) {
            return Fault::new(
                tab..tab + 1,
                "",
                format!("this is not {what}: the row is indented by a tab"),
                "indent it by blanks",
            );
        }
        let remedy = match is_json {
            true => "check commas, colons, quotes and brackets here and before",
            false => {
                "check indentation (blanks, no tabs), colons, quotes and brackets of this row and the one before"
            }
        };
        // In the words of the parser, which quotes letters by single quotes.
        let said = error.info().replace('\'', "`");
        let problem = format!("this is not {what}: {}", said.escape_debug());
        Fault::new(at..at, "", problem, remedy)
    }

    fn take(&mut self, event: Event<'_>, span: Span) -> Result<(), Fault> {
        let range = self.places.range(span);
        match event {
            Event::DocumentStart(_) => {
                self.documents += 1;
                if self.documents > 1 {
                    return Err(Fault::new(
                        range,
                        "",
                        "a second document begins here",
                        "leave one document in the file",
                    ));
                }
            }
            Event::Alias(anchor) => self.alias(anchor, range)?,
            Event::Scalar(text, style, anchor, tag) => {
                let scalar = Scalar {
                    text: text.into_owned(),
                    is_quoted: style != ScalarStyle::Plain,
                    tag: tag.map(|tag| format!("{}{}", tag.handle, tag.suffix)),
                };
                let id = self.complete(range, Value::Scalar(scalar), anchor)?;
                self.add(id)?;
            }
            Event::SequenceStart(anchor, _) => {
                self.begin(anchor, range, NodeContent::Sequence(Vec::new()))?;
            }
            Event::MappingStart(anchor, _) => {
                self.begin(anchor, range, NodeContent::Mapping(Box::default()))?;
            }
            Event::SequenceEnd | Event::MappingEnd => self.end()?,
            Event::Nothing | Event::StreamStart | Event::StreamEnd | Event::DocumentEnd => {}
        }
        Ok(())
    }

    fn alias(&mut self, anchor: usize, range: Range<usize>) -> Result<(), Fault> {
        let Some(id) = self.anchors.get(&anchor).copied() else {
            return Err(Fault::new(
                range,
                "",
                "this alias names what it is itself a part of",
                "write out what is meant",
            ));
        };
        self.counted(1, &range)?;
        self.add(id)
    }

    fn begin(
        &mut self,
        anchor: usize,
        span: Range<usize>,
        content: NodeContent,
    ) -> Result<(), Fault> {
        if self.open.len() >= GREATEST_DEPTH {
            return Err(Fault::new(
                span,
                "",
                format!("this is more than {GREATEST_DEPTH} levels deep"),
                "a design has fewer than 20",
            ));
        }
        self.open.push(OpenCollection {
            anchor,
            span,
            content,
        });
        Ok(())
    }

    fn end(&mut self) -> Result<(), Fault> {
        let Some(open) = self.open.pop() else {
            return Ok(());
        };
        let (span, value) = match open.content {
            NodeContent::Sequence(ids) => (open.span, Value::Sequence(ids)),
            NodeContent::Mapping(mapping) => {
                let mut mapping = *mapping;
                self.merge(&mut mapping)?;
                let first = mapping.entries.first().map(|(key, _)| key.span.clone());
                let span = first.unwrap_or(open.span);
                (span, Value::Mapping(mapping.entries))
            }
        };
        let id = self.complete(span, value, open.anchor)?;
        self.add(id)
    }

    /// Entries of merged mappings that the mapping does not have itself.
    fn merge(&mut self, mapping: &mut OpenMapping) -> Result<(), Fault> {
        for (id, span) in std::mem::take(&mut mapping.merged) {
            let ids = match self.nodes.get(id).map(|node| &node.value) {
                Some(Value::Sequence(ids)) => ids.clone(),
                _ => vec![id],
            };
            self.counted(ids.len(), &span)?;
            for id in ids {
                let Some(Value::Mapping(entries)) = self.nodes.get(id).map(|node| &node.value)
                else {
                    return Err(Fault::new(
                        span,
                        "<<",
                        "a merge key takes in a mapping or a list of mappings, which this is not",
                        "write `<<: *name` with the anchor of a mapping",
                    ));
                };
                let new: Vec<(YamlKey, usize)> = entries
                    .iter()
                    .filter(|(key, _)| mapping.names.insert(key.name.clone()))
                    .cloned()
                    .collect();
                let looked_at = entries.len();
                mapping.entries.extend(new);
                self.counted(looked_at, &span)?;
            }
        }
        Ok(())
    }

    fn complete(
        &mut self,
        span: Range<usize>,
        value: Value,
        anchor: usize,
    ) -> Result<usize, Fault> {
        self.counted(1, &span)?;
        self.nodes.push(Spanned { span, value });
        let id = self.nodes.len() - 1;
        if anchor > 0 {
            self.anchors.insert(anchor, id);
        }
        Ok(id)
    }

    fn counted(&mut self, more: usize, span: &Range<usize>) -> Result<(), Fault> {
        self.count += more;
        if self.count <= GREATEST_COUNT {
            return Ok(());
        }
        Err(Fault::new(
            span.clone(),
            "",
            format!("the file has more than {GREATEST_COUNT} values up to here"),
            "give a file of the mooring alone",
        ))
    }

    /// Puts a complete node where it belongs.
    fn add(&mut self, id: usize) -> Result<(), Fault> {
        let Some(open) = self.open.last_mut() else {
            self.root.get_or_insert(id);
            return Ok(());
        };
        let mapping = match &mut open.content {
            NodeContent::Sequence(ids) => {
                ids.push(id);
                return Ok(());
            }
            NodeContent::Mapping(mapping) => mapping,
        };
        let Some(key) = mapping.key.take() else {
            let node = self.nodes.get(id);
            mapping.key = Some(node.map_or_else(|| Err(no_key(0..0)), key_of)?);
            return Ok(());
        };
        if key.name == "<<" {
            mapping.merged.push((id, key.span));
        } else if mapping.names.insert(key.name.clone()) {
            mapping.entries.push((key, id));
        } else {
            let name = shortened(&key.name);
            self.duplicates.push(Fault::new(
                key.span,
                name.clone(),
                format!("there is a second `{name}` in the same mapping"),
                "leave one of them",
            ));
        }
        Ok(())
    }
}

/// Whether a text is meant as JSON: it begins with a bracket, and its first word is in double quotes.
fn text_is_json(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let Some(inside) = text.strip_prefix(['{', '[']) else {
        return false;
    };
    inside.trim_start().starts_with(['"', '{', '['])
}

/// A tab that indents the row of a byte, or one of the two rows after it: a row that goes on is found faulty at its beginning.
fn tab_near(text: &str, at: usize) -> Option<usize> {
    let begins = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let mut start = begins;
    for row in text.get(begins..)?.split_inclusive('\n').take(3) {
        let indent = row.len() - row.trim_start_matches([' ', '\t']).len();
        if let Some(tab) = row.get(..indent).and_then(|blanks| blanks.find('\t')) {
            return Some(start + tab);
        }
        start += row.len();
    }
    None
}

fn key_of(node: &Spanned) -> Result<YamlKey, Fault> {
    match &node.value {
        Value::Scalar(scalar) => Ok(YamlKey {
            name: scalar.text.clone(),
            span: node.span.clone(),
        }),
        _ => Err(no_key(node.span.clone())),
    }
}

fn no_key(span: Range<usize>) -> Fault {
    Fault::new(
        span,
        "",
        "a list or mapping is used as a key",
        "keys are words",
    )
}
