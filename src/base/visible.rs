//! Makes invisible characters visible in text from outside: titles, names, paths, excerpts of files, arguments.
//!
//! A control character steers a terminal, a bidirectional one reorders what is read, and others show nothing at all. All
//! of them are written as escapes such as `\u{202e}` wherever text leaves the program: standard output and standard
//! error, the screen, reports and tables. The program's own colours are added after this step.

use std::borrow::Cow;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;

/// Whether a character shows nothing, or changes how its neighbours are shown: controls (C0, DEL, C1), bidirectional
/// controls, separators of lines, fillers, zero-width and other format characters, tags.
#[must_use]
pub fn is_invisible(c: char) -> bool {
    c.is_control()
        || matches!(
            c,
            '\u{ad}'
                | '\u{34f}'
                | '\u{61c}'
                | '\u{115f}'..='\u{1160}'
                | '\u{17b4}'..='\u{17b5}'
                | '\u{180b}'..='\u{180f}'
                | '\u{200b}'..='\u{200f}'
                | '\u{2028}'..='\u{202e}'
                | '\u{2060}'..='\u{206f}'
                | '\u{3164}'
                | '\u{feff}'
                | '\u{ffa0}'
                | '\u{fff0}'..='\u{fffb}'
                | '\u{1bca0}'..='\u{1bca3}'
                | '\u{1d173}'..='\u{1d17a}'
                | '\u{e0000}'..='\u{e0fff}'
        )
}

/// The text with its invisible characters escaped. Line feeds and tabs stay.
#[must_use]
pub fn text(text: &str) -> Cow<'_, str> {
    let hidden = |c| is_invisible(c) && !matches!(c, '\n' | '\t');
    escape(text, hidden, |c| c.escape_unicode().to_string())
}

/// Text that belongs on one line, with its invisible characters escaped, line feeds and tabs as well.
#[must_use]
pub fn line(text: &str) -> Cow<'_, str> {
    escape(text, is_invisible, |c| match c {
        '\n' | '\t' | '\r' => c.escape_default().to_string(),
        _ => c.escape_unicode().to_string(),
    })
}

/// A TOML document with its invisible characters as TOML's own escapes, which read back to the same text inside strings.
#[must_use]
pub fn toml(document: &str) -> Cow<'_, str> {
    let hidden = |c| is_invisible(c) && !matches!(c, '\n' | '\t');
    escape(document, hidden, |c| match u32::from(c) {
        code @ 0..=0xffff => format!("\\u{code:04x}"),
        code => format!("\\U{code:08x}"),
    })
}

/// A JSON document with its invisible characters as JSON's own escapes, which read back to the same text.
#[must_use]
pub fn json(document: &str) -> Cow<'_, str> {
    let hidden = |c| is_invisible(c) && !matches!(c, '\n' | '\t' | '\r');
    escape(document, hidden, |c| {
        let mut units = [0; 2];
        let units = c.encode_utf16(&mut units).iter();
        units.map(|unit| format!("\\u{unit:04x}")).collect()
    })
}

/// A path as it can be typed again: as it is, or, with bytes that are no text or show nothing, in the quotes of a shell that
/// know their numbers, `$'caf\351.toml'`.
#[must_use]
pub fn path(path: &Path) -> String {
    let bytes = path.as_os_str().as_bytes();
    let plain = std::str::from_utf8(bytes).ok();
    if let Some(plain) = plain.filter(|plain| !plain.contains(is_invisible)) {
        return plain.to_owned();
    }
    let mut out = String::from("$'");
    for part in bytes.utf8_chunks() {
        for c in part.valid().chars() {
            match c {
                '\'' | '\\' => out.extend(['\\', c]),
                c if is_invisible(c) => numbers(c.encode_utf8(&mut [0; 4]).as_bytes(), &mut out),
                c => out.push(c),
            }
        }
        numbers(part.invalid(), &mut out);
    }
    out.push('\'');
    out
}

/// Bytes by their numbers. Three octal digits end where they must, whatever follows.
fn numbers(bytes: &[u8], out: &mut String) {
    out.extend(bytes.iter().map(|byte| format!("\\{byte:03o}")));
}

/// A word as a shell of POSIX takes it for itself.
#[must_use]
pub fn quoted(word: &str) -> String {
    let plain = |b: u8| b.is_ascii_alphanumeric() || b"-_./=:,+@%".contains(&b);
    match !word.is_empty() && word.bytes().all(plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

/// A path as an argument of a command that is proposed: one word of a shell, and no option.
#[must_use]
pub fn argument(of: &Path) -> String {
    let plain = of.to_str().filter(|plain| !plain.contains(is_invisible));
    match plain {
        None => path(of),
        Some(plain) if plain.starts_with('-') => quoted(&format!("./{plain}")),
        Some(plain) => quoted(plain),
    }
}

/// Longest text of one message, as of a word that it quotes \[characters\].
const LONGEST: usize = 1000;

/// A message without the middle of words that are pages long.
#[must_use]
pub fn shortened(text: String) -> String {
    let cut = |from: usize| text.char_indices().nth(from).map(|(at, _)| at);
    // As long as its bytes at most.
    if text.len() <= LONGEST {
        return text;
    }
    let Some(end) = cut(LONGEST) else { return text };
    let head = cut(LONGEST * 3 / 4).unwrap_or(end);
    let tail = text.char_indices().rev().nth(LONGEST / 4 - 1);
    let tail = tail.map_or(text.len(), |(at, _)| at);
    let left_out = text[head..tail].chars().count();
    format!(
        "{} [{left_out} characters left out] {}",
        &text[..head],
        &text[tail..]
    )
}

fn escape<'a>(
    text: &'a str,
    hidden: impl Fn(char) -> bool,
    escaped: impl Fn(char) -> String,
) -> Cow<'a, str> {
    // Most text is plain ASCII, where its bytes decide.
    let feeds = !hidden('\n');
    let plain = text
        .bytes()
        .all(|byte| matches!(byte, b' '..=b'~') || byte == b'\n' && feeds);
    if plain || !text.contains(&hidden) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if hidden(c) {
            out.push_str(&escaped(c));
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_or_hides_is_escaped() {
        assert_eq!(
            text("a\u{1b}[31m\u{7f}\u{9b}2J\u{202e}b\u{200f}\u{61c}\u{2069}"),
            "a\\u{1b}[31m\\u{7f}\\u{9b}2J\\u{202e}b\\u{200f}\\u{61c}\\u{2069}"
        );
        assert_eq!(
            text("\u{feff}\u{200b}\u{2028}\r"),
            "\\u{feff}\\u{200b}\\u{2028}\\u{d}"
        );
        assert_eq!(text("a\n\tb"), "a\n\tb");
        assert_eq!(line("a\n\tb\u{7}"), "a\\n\\tb\\u{7}");
    }

    #[test]
    fn a_path_can_be_typed_again() {
        use std::ffi::OsStr;
        let shown = |bytes: &[u8]| path(Path::new(OsStr::from_bytes(bytes)));
        assert_eq!(shown("a b/häfen.toml".as_bytes()), "a b/häfen.toml");
        assert_eq!(shown(b"caf\xe9.toml"), "$'caf\\351.toml'");
        assert_eq!(
            shown(b"a\nerror: b's\x1b[2J"),
            "$'a\\012error: b\\'s\\033[2J'"
        );
        assert_eq!(shown("a\u{202e}1".as_bytes()), "$'a\\342\\200\\2561'");
    }

    #[test]
    fn an_argument_is_one_word_of_a_shell() {
        use std::ffi::OsStr;
        let shown = |bytes: &[u8]| argument(Path::new(OsStr::from_bytes(bytes)));
        assert_eq!(shown(b"runs/a-1"), "runs/a-1");
        assert_eq!(shown(b"my runs/a"), "'my runs/a'");
        assert_eq!(shown(b"it's $HOME"), r"'it'\''s $HOME'");
        assert_eq!(shown(b"~/a"), "'~/a'");
        assert_eq!(shown(b"-x"), "./-x");
        assert_eq!(shown(b"caf\xe9 1"), "$'caf\\351 1'");
    }

    #[test]
    fn messages_lose_the_middle_of_a_word_of_pages() {
        let plain = "no key `lenght_m`".to_owned();
        assert_eq!(shortened(plain.clone()), plain);
        let word = "é".repeat(1000);
        assert_eq!(shortened(word.clone()), word);
        let long = shortened(format!("no key `{}` here", "é".repeat(100_000)));
        assert!(long.starts_with("no key `é") && long.ends_with("é` here"));
        assert!(long.contains(" [99014 characters left out] "), "{long}");
        assert_eq!(
            long.chars().count(),
            1000 + " [99014 characters left out] ".len()
        );
    }

    #[test]
    fn what_people_write_stays() {
        for plain in ["m²/s ± 漢字 ελληνικά", "שלום", "سلام", "é e\u{301}", "⠿│─"]
        {
            assert!(matches!(text(plain), Cow::Borrowed(same) if same == plain));
            assert!(matches!(line(plain), Cow::Borrowed(_)));
        }
    }

    #[test]
    fn documents_read_back_to_the_same_text() {
        let name = "a\u{202e}b\u{9b}\u{e0001}";
        let document = toml(&format!("name = \"{name}\"\n")).into_owned();
        assert!(!document.chars().any(|c| is_invisible(c) && c != '\n'));
        let table: ::toml::Table = document.parse().unwrap();
        assert_eq!(table["name"].as_str(), Some(name));
        assert_eq!(json("\"\u{202e}\u{e0001}\""), "\"\\u202e\\udb40\\udc01\"");
    }
}
