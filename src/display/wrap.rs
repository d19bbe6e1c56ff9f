//! Breaking words into lines, and padding them, by the width they have on screen.

use unicode_width::UnicodeWidthStr;

use crate::padding::blanks;
use crate::visible;

/// What becomes of words that are wider than a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WideWords {
    /// They have lines of their own.
    Whole,
    /// They are broken inside.
    Broken,
    /// They are broken inside unless they hold a digit: numbers are never cut.
    BrokenUnlessNumbers,
}

/// The text in lines no wider than `width`, broken between words.
pub fn wrap(text: &str, width: usize, wide: WideWords) -> Vec<String> {
    let breaks = |word: &str| match wide {
        WideWords::Whole => false,
        WideWords::Broken => true,
        WideWords::BrokenUnlessNumbers => breakable(word),
    };
    let mut lines = Vec::new();
    for paragraph in text.split('\n') {
        let paragraph = visible::text(paragraph);
        // Its width is kept beside it: asked of the line for every word, it was a quarter of the time of a frame.
        let (mut line, mut used) = (String::new(), 0);
        for word in paragraph.split_whitespace() {
            let wide = word.width();
            if !line.is_empty() && used + 1 + wide > width {
                lines.push(std::mem::take(&mut line));
                used = 0;
            }
            if !line.is_empty() {
                line.push(' ');
                used += 1;
            }
            line.push_str(word);
            used += wide;
            while used > width && breaks(&line) {
                let at = split_at(&line, width);
                if at == line.len() {
                    break;
                }
                let rest = line.split_off(at);
                lines.push(std::mem::replace(&mut line, rest));
                used = line.width();
            }
        }
        lines.push(line);
    }
    lines
}

/// The narrowest a text can be made without breaking numbers, or words of up to `keep` columns.
pub(crate) fn narrowest(text: &str, keep: usize) -> usize {
    let least = |word: &str| {
        if breakable(word) {
            word.width().min(keep)
        } else {
            word.width()
        }
    };
    text.split_whitespace().map(least).max().unwrap_or(0)
}

fn breakable(word: &str) -> bool {
    !word.bytes().any(|b| b.is_ascii_digit())
}

/// Byte at which so many columns are full; at least one character.
fn split_at(text: &str, width: usize) -> usize {
    let mut end = 0;
    for (at, ch) in text.char_indices() {
        let next = at + ch.len_utf8();
        if end > 0 && text[..next].width() > width {
            break;
        }
        end = next;
    }
    end
}

/// The text with blanks before and after it.
pub(crate) fn padded(text: &str, before: usize, width: usize) -> String {
    let after = width.saturating_sub(before + text.width());
    format!("{}{text}{}", blanks(before), blanks(after))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_kept_whole_where_they_fit() {
        assert_eq!(
            wrap("mean tension at the wire joint", 12, WideWords::Whole),
            ["mean tension", "at the wire", "joint"]
        );
        assert_eq!(wrap("", 5, WideWords::Broken), [""]);
        assert_eq!(wrap("a\n\nb", 5, WideWords::Broken), ["a", "", "b"]);
        let lines = wrap("a verylongword b", 5, WideWords::Whole);
        assert_eq!(lines, ["a", "verylongword", "b"]);
        let lines = wrap("abcdefghij k", 4, WideWords::Broken);
        assert_eq!(lines, ["abcd", "efgh", "ij k"]);
    }

    #[test]
    fn long_words_are_broken_and_numbers_are_not() {
        let wrap = |text| wrap(text, 5, WideWords::BrokenUnlessNumbers);
        assert_eq!(wrap("uncomfortable"), ["uncom", "forta", "ble"]);
        assert_eq!(wrap("1.234567e-12"), ["1.234567e-12"]);
        assert_eq!(narrowest("a 1.234567 uncomfortable", 8), 8);
    }

    #[test]
    fn wide_characters_count_twice() {
        let wrap = |text, width| wrap(text, width, WideWords::Broken);
        assert_eq!(wrap("漢字漢字", 5), ["漢字", "漢字"]);
        assert_eq!(padded("漢", 1, 5), " 漢  ");
        assert_eq!(wrap("漢字", 1), ["漢", "字"]);
        assert_eq!(wrap("日", 1), ["日"]);
    }
}
