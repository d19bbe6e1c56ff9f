//! Just enough JSON for one object a line: numbers, text, lists, and where each value stands.

use std::ops::Range;

/// A value and the bytes it stands in.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Value {
    pub kind: Kind,
    pub at: Range<usize>,
}

/// What a value is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kind {
    Number(f64),
    /// As it stands, quotes and escapes included.
    Text,
    List(Vec<Value>),
    /// true, false or null.
    Word,
    Object(Vec<(String, Value)>),
}

/// What is wrong, and at which byte.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    pub at: usize,
    pub problem: String,
}

/// Depth of lists within lists that is read; no line needs more.
const DEEPEST: usize = 16;

/// The keys and values of one object, in order.
///
/// # Errors
/// [`Fault`] when the text is not one JSON object.
pub(super) fn object(text: &str) -> Result<Vec<(String, Value)>, Fault> {
    let mut reader = Reader { text, at: 0 };
    let value = reader.value(0)?;
    reader.skip();
    if reader.at < text.len() {
        return Err(reader.fault("nothing more; the object has ended"));
    }
    match value.kind {
        Kind::Object(entries) => Ok(entries),
        _ => Err(Fault {
            at: value.at.start,
            problem: "a JSON object is needed: {\"key\": value, ...}".into(),
        }),
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn skip(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    fn fault(&self, wanted: &str) -> Fault {
        let found = match self.rest().chars().next() {
            None => "the end of the line".into(),
            Some(c) => format!("\"{}\"", c.escape_default()),
        };
        Fault {
            at: self.at,
            problem: format!("{found} stands where JSON has {wanted}"),
        }
    }

    /// Steps over this character, if it is next.
    fn take(&mut self, wanted: char) -> bool {
        self.skip();
        let there = self.rest().starts_with(wanted);
        if there {
            self.at += wanted.len_utf8();
        }
        there
    }

    fn value(&mut self, depth: usize) -> Result<Value, Fault> {
        self.skip();
        let from = self.at;
        if depth > DEEPEST {
            return Err(self.fault("no deeper list"));
        }
        let kind = match self.rest().bytes().next() {
            Some(b'{') => self.entries(depth)?,
            Some(b'[') => self.items(depth)?,
            Some(b'"') => {
                self.string()?;
                Kind::Text
            }
            Some(b'-' | b'0'..=b'9') => self.number()?,
            _ => self.word()?,
        };
        Ok(Value {
            kind,
            at: from..self.at,
        })
    }

    fn entries(&mut self, depth: usize) -> Result<Kind, Fault> {
        self.take('{');
        let mut entries = Vec::new();
        if self.take('}') {
            return Ok(Kind::Object(entries));
        }
        loop {
            self.skip();
            let key = self.string()?;
            if !self.take(':') {
                return Err(self.fault("a colon"));
            }
            entries.push((key, self.value(depth + 1)?));
            if self.take('}') {
                return Ok(Kind::Object(entries));
            }
            if !self.take(',') {
                return Err(self.fault("a comma or a closing brace"));
            }
        }
    }

    fn items(&mut self, depth: usize) -> Result<Kind, Fault> {
        self.take('[');
        let mut items = Vec::new();
        if self.take(']') {
            return Ok(Kind::List(items));
        }
        loop {
            items.push(self.value(depth + 1)?);
            if self.take(']') {
                return Ok(Kind::List(items));
            }
            if !self.take(',') {
                return Err(self.fault("a comma or a closing bracket"));
            }
        }
    }

    /// Text in quotes, without its escapes undone: no key here has any.
    fn string(&mut self) -> Result<String, Fault> {
        if !self.rest().starts_with('"') {
            return Err(self.fault("text in quotes"));
        }
        let mut escaped = false;
        for (i, c) in self.rest().char_indices().skip(1) {
            match c {
                _ if escaped => escaped = false,
                '\\' => escaped = true,
                '"' => {
                    let inside = self.rest().get(1..i).unwrap_or_default().to_owned();
                    self.at += i + 1;
                    return Ok(inside);
                }
                _ => {}
            }
        }
        self.at = self.text.len();
        Err(self.fault("a closing quote"))
    }

    fn number(&mut self) -> Result<Kind, Fault> {
        let of_number = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
        let end = self
            .rest()
            .find(|c| !of_number(c))
            .unwrap_or(self.rest().len());
        let parsed = self.rest().get(..end).and_then(|text| text.parse().ok());
        let number = parsed.ok_or_else(|| self.fault("a number"))?;
        self.at += end;
        Ok(Kind::Number(number))
    }

    fn word(&mut self) -> Result<Kind, Fault> {
        for word in ["true", "false", "null"] {
            if self.rest().starts_with(word) {
                self.at += word.len();
                return Ok(Kind::Word);
            }
        }
        Err(self.fault("a value: a number, \"text\", a list or an object"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_are_read_with_their_places() {
        let read = object(r#" {"a": [1, [-2.5e3]], "b \" c": null, "d": {}} "#).unwrap_or_default();
        let keys: Vec<&str> = read.iter().map(|(key, _)| key.as_str()).collect();
        assert_eq!(keys, ["a", "b \\\" c", "d"]);
        let Kind::List(list) = &read[0].1.kind else {
            panic!("{read:?}");
        };
        assert_eq!(list[0].kind, Kind::Number(1.0));
        assert_eq!(read[0].1.at, 7..20);
    }

    #[test]
    fn what_is_no_object_is_told_with_its_place() {
        for (text, at, words) in [
            ("", 0, "the end of the line"),
            ("[1]", 0, "object is needed"),
            ("{\"a\": 1 \"b\": 2}", 8, "a comma"),
            ("{\"a\": 1} 2", 9, "nothing more"),
            ("{\"a\": 1e}", 6, "a number"),
            ("{\"a", 3, "closing quote"),
            ("{\"a\": NaN}", 6, "a value"),
            ("{a: 1}", 1, "text in quotes"),
        ] {
            let fault = object(text).expect_err(text);
            assert_eq!(fault.at, at, "{text} {}", fault.problem);
            assert!(fault.problem.contains(words), "{text} {}", fault.problem);
        }
        assert!(object(&"[".repeat(1000)).is_err());
    }
}
