//! Bytes from the terminal to keys and pastes.
//!
//! A slow link may cut an escape sequence anywhere, also right after its Esc. The decoder therefore
//! keeps what is incomplete and lets the caller decide how long a lone Esc may wait to become more.

use crate::key::KeyPress;

/// What a person did at the terminal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TerminalInput {
    /// A key.
    Key(KeyPress),
    /// Text pasted as one piece; never commands.
    Paste(String),
}

const PASTE_END: &[u8] = b"\x1b[201~";
const LONGEST_SEQUENCE: usize = 64;
const LONGEST_PASTE: usize = 1 << 20;

/// Keeps the bytes that do not make a key yet.
#[derive(Debug, Default)]
pub struct Decoder {
    pending: Vec<u8>,
    paste: Option<Vec<u8>>,
}

/// What the first pending bytes are.
enum DecodeStep {
    /// More bytes are needed to decide.
    Wait,
    /// So many bytes mean nothing to us.
    Skip(usize),
    /// So many bytes are this key.
    Take(usize, KeyPress),
    /// So many bytes begin a paste.
    BeginPaste(usize),
}

impl Decoder {
    /// Adds bytes and returns what they complete, in order.
    pub fn feed(&mut self, bytes: &[u8]) -> Vec<TerminalInput> {
        let mut out = Vec::new();
        for &byte in bytes {
            if self.paste.is_some() {
                out.extend(self.feed_paste(byte));
            } else {
                self.pending.push(byte);
                self.drain(&mut out);
            }
        }
        out
    }

    /// True while bytes are kept that may be the beginning of something.
    #[must_use]
    pub fn waiting(&self) -> bool {
        !self.pending.is_empty()
    }

    /// Nothing more came: a lone Esc is the Esc key, and half a sequence is dropped.
    pub fn give_up(&mut self) -> Vec<TerminalInput> {
        let lone_escape = self.pending == [0x1b];
        self.pending.clear();
        if lone_escape {
            vec![TerminalInput::Key(KeyPress::Esc)]
        } else {
            Vec::new()
        }
    }

    fn drain(&mut self, out: &mut Vec<TerminalInput>) {
        while !self.pending.is_empty() {
            let used = match first(&self.pending) {
                DecodeStep::Wait if self.pending.len() < LONGEST_SEQUENCE => return,
                DecodeStep::Wait => self.pending.len(),
                DecodeStep::Skip(n) => n,
                DecodeStep::Take(n, key) => {
                    out.push(TerminalInput::Key(key));
                    n
                }
                DecodeStep::BeginPaste(n) => {
                    self.paste = Some(Vec::new());
                    n
                }
            };
            self.pending.drain(..used.clamp(1, self.pending.len()));
        }
    }

    /// Ctrl-C ends a paste whose end mark got lost, so that the keyboard never goes dead.
    fn feed_paste(&mut self, byte: u8) -> Option<TerminalInput> {
        let text = self.paste.as_mut()?;
        text.push(byte);
        let ended = text.ends_with(PASTE_END);
        if byte == 0x03 {
            self.paste = None;
            return Some(TerminalInput::Key(KeyPress::Ctrl('c')));
        }
        if !ended && text.len() < LONGEST_PASTE {
            return None;
        }
        let mut text = self.paste.take()?;
        if ended {
            text.truncate(text.len() - PASTE_END.len());
        }
        Some(TerminalInput::Paste(
            String::from_utf8_lossy(&text).into_owned(),
        ))
    }
}

fn first(bytes: &[u8]) -> DecodeStep {
    match bytes[0] {
        0x1b => escape(bytes),
        b'\r' | b'\n' => DecodeStep::Take(1, KeyPress::Enter),
        b'\t' => DecodeStep::Take(1, KeyPress::Tab),
        0x7f | 0x08 => DecodeStep::Take(1, KeyPress::Backspace),
        control @ 1..=26 => DecodeStep::Take(1, KeyPress::Ctrl(char::from(b'a' + control - 1))),
        0 | 27..=31 => DecodeStep::Skip(1),
        _ => character(bytes),
    }
}

/// Esc with any other character after it is Esc and then that character: nothing here is bound to
/// Alt, and over a slow link the two arrive together.
fn escape(bytes: &[u8]) -> DecodeStep {
    match bytes.get(1) {
        None => DecodeStep::Wait,
        Some(b'[') => control_sequence(bytes),
        Some(b'O') => match bytes.get(2) {
            None => DecodeStep::Wait,
            Some(last) => letter(*last).map_or(DecodeStep::Skip(3), |key| DecodeStep::Take(3, key)),
        },
        Some(_) => DecodeStep::Take(1, KeyPress::Esc),
    }
}

fn control_sequence(bytes: &[u8]) -> DecodeStep {
    // The Linux console sends F1 to F5 as Esc [ [ A.
    if bytes.get(2) == Some(&b'[') {
        return match bytes.get(3) {
            None => DecodeStep::Wait,
            Some(last @ b'A'..=b'E') => DecodeStep::Take(4, KeyPress::F(last - b'A' + 1)),
            Some(_) => DecodeStep::Skip(4),
        };
    }
    let Some(end) = bytes[2..].iter().position(|b| !(0x20..=0x3f).contains(b)) else {
        return DecodeStep::Wait;
    };
    let length = end + 3;
    let parameters = &bytes[2..length - 1];
    match bytes[length - 1] {
        b'~' => numbered(parameters, length),
        b'Z' => DecodeStep::Take(length, KeyPress::BackTab),
        // Any other control character breaks the sequence off and counts by itself.
        0..=0x1f => DecodeStep::Skip(length - 1),
        last => letter(last).map_or(DecodeStep::Skip(length), |key| {
            DecodeStep::Take(length, key)
        }),
    }
}

fn letter(last: u8) -> Option<KeyPress> {
    Some(match last {
        b'A' => KeyPress::Up,
        b'B' => KeyPress::Down,
        b'C' => KeyPress::Right,
        b'D' => KeyPress::Left,
        b'H' => KeyPress::Home,
        b'F' => KeyPress::End,
        b'M' => KeyPress::Enter,
        b'P'..=b'S' => KeyPress::F(last - b'P' + 1),
        _ => return None,
    })
}

fn numbered(parameters: &[u8], length: usize) -> DecodeStep {
    let number = parameters
        .split(|b| *b == b';')
        .next()
        .and_then(|n| std::str::from_utf8(n).ok())
        .and_then(|n| n.parse::<u8>().ok());
    let key = match number {
        Some(200) => return DecodeStep::BeginPaste(length),
        Some(1 | 7) => KeyPress::Home,
        Some(4 | 8) => KeyPress::End,
        Some(2) => KeyPress::Insert,
        Some(3) => KeyPress::Delete,
        Some(5) => KeyPress::PageUp,
        Some(6) => KeyPress::PageDown,
        Some(n @ 11..=15) => KeyPress::F(n - 10),
        Some(n @ 17..=21) => KeyPress::F(n - 11),
        Some(n @ 23..=24) => KeyPress::F(n - 12),
        _ => return DecodeStep::Skip(length),
    };
    DecodeStep::Take(length, key)
}

fn character(bytes: &[u8]) -> DecodeStep {
    let length = match bytes[0] {
        0x20..=0x7e => 1,
        0xc2..=0xdf => 2,
        0xe0..=0xef => 3,
        0xf0..=0xf4 => 4,
        _ => return DecodeStep::Skip(1),
    };
    match bytes.get(..length).map(std::str::from_utf8) {
        Some(Ok(text)) => text.chars().next().map_or(DecodeStep::Skip(length), |c| {
            DecodeStep::Take(length, KeyPress::Char(c))
        }),
        Some(Err(_)) => DecodeStep::Skip(1),
        None if bytes[1..].iter().all(|b| b & 0xc0 == 0x80) => DecodeStep::Wait,
        None => DecodeStep::Skip(1),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn keys(bytes: &[u8]) -> Vec<TerminalInput> {
        let mut decoder = Decoder::default();
        let mut out = decoder.feed(bytes);
        out.extend(decoder.give_up());
        out
    }

    #[test]
    fn common_sequences() {
        for (bytes, key) in [
            (&b"\x1b[A"[..], KeyPress::Up),
            (b"\x1bOB", KeyPress::Down),
            (b"\x1b[1;5C", KeyPress::Right),
            (b"\x1b[3~", KeyPress::Delete),
            (b"\x1b[6~", KeyPress::PageDown),
            (b"\x1b[Z", KeyPress::BackTab),
            (b"\x1bOP", KeyPress::F(1)),
            (b"\x1b[[B", KeyPress::F(2)),
            (b"\x1b[24~", KeyPress::F(12)),
            (b"\x03", KeyPress::Ctrl('c')),
            (b"\x1a", KeyPress::Ctrl('z')),
            (b"\x7f", KeyPress::Backspace),
            (b"\x1b", KeyPress::Esc),
            ("é".as_bytes(), KeyPress::Char('é')),
        ] {
            assert_eq!(keys(bytes), [TerminalInput::Key(key)], "{bytes:?}");
        }
    }

    #[test]
    fn a_sequence_cut_right_after_its_escape_is_still_one_key() {
        let mut decoder = Decoder::default();
        assert_eq!(decoder.feed(b"\x1b"), []);
        assert!(decoder.waiting());
        assert_eq!(decoder.feed(b"["), []);
        assert_eq!(decoder.feed(b"B"), [TerminalInput::Key(KeyPress::Down)]);
        assert!(!decoder.waiting());
    }

    #[test]
    fn a_paste_is_text_even_if_it_holds_commands() {
        let paste = keys(b"\x1b[200~q:quit\r\x1b[A\x1b[201~j");
        assert_eq!(
            paste,
            [
                TerminalInput::Paste("q:quit\r\x1b[A".to_owned()),
                TerminalInput::Key(KeyPress::Char('j'))
            ]
        );
    }

    #[test]
    fn control_c_gets_out_of_a_paste_without_an_end() {
        assert_eq!(
            keys(b"\x1b[200~abc\x03"),
            [TerminalInput::Key(KeyPress::Ctrl('c'))]
        );
    }

    proptest! {
        #[test]
        fn how_the_bytes_are_cut_makes_no_difference(
            bytes in proptest::collection::vec(
                prop_oneof![Just(0x1b_u8), Just(b'['), Just(b'O'), Just(b'2'), Just(b'0'), Just(b'1'), Just(b'~'), any::<u8>()],
                0..200,
            ),
        ) {
            let mut whole = Decoder::default();
            let mut cut = Decoder::default();
            let mut pieces = Vec::new();
            for byte in &bytes {
                pieces.extend(cut.feed(&[*byte]));
            }
            prop_assert_eq!(whole.feed(&bytes), pieces);
        }
    }
}
