//! Words in HTML and SVG.

use crate::visible;

/// Words on one line in which nothing is markup, nor invisible.
pub fn escaped(words: &str) -> String {
    let mut out = String::new();
    for letter in visible::line(&words.replace('\n', " ")).chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            letter => out.push(letter),
        }
    }
    out
}
