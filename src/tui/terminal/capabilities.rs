//! What the terminal can show: glyphs and colours, decided from flags and environment alone.

use crate::chart::Glyphs;
use crate::theme::Palette;

/// What was decided, and whether the user should be asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capabilities {
    /// Characters for charts and frames.
    pub glyphs: Glyphs,
    /// False under `NO_COLOR`.
    pub colour: bool,
    /// The colours, where there are any.
    pub palette: Palette,
    /// True when nothing says what the terminal can show: no locale is no proof of plain ASCII,
    /// as a command run over SSH often has none.
    pub unsure: bool,
}

/// Decides from the `--glyphs` flag, the effective locale, `TERM` and `NO_COLOR`.
///
/// `remembered` is the user's answer of an earlier session; `var` looks up the environment.
pub fn decide(
    flag: Option<Glyphs>,
    remembered: Option<Glyphs>,
    var: &dyn Fn(&str) -> Option<String>,
) -> Capabilities {
    let set = |name: &str| var(name).filter(|v| !v.is_empty());
    let utf8 = utf8_locale(var);
    // The Linux console has no braille in its fonts.
    let console = var("TERM").is_some_and(|t| t == "linux" || t.starts_with("vt"));
    let (glyphs, unsure) = match (flag.or(remembered), utf8) {
        (Some(chosen), _) => (chosen, false),
        (None, Some(false)) => (Glyphs::Ascii, false),
        (None, _) if console => (Glyphs::Ascii, false),
        (None, Some(true)) => (Glyphs::Braille, false),
        (None, None) => (Glyphs::Ascii, true),
    };
    Capabilities {
        glyphs,
        colour: set("NO_COLOR").is_none(),
        palette: Palette::default(),
        unsure,
    }
}

/// Whether the effective locale says UTF-8; absent where none is set.
fn utf8_locale(var: &dyn Fn(&str) -> Option<String>) -> Option<bool> {
    let set = |name: &str| var(name).filter(|v| !v.is_empty());
    let locale = set("LC_ALL")
        .or_else(|| set("LC_CTYPE"))
        .or_else(|| set("LANG"))?;
    let locale = locale.to_ascii_lowercase();
    Some(locale.contains("utf-8") || locale.contains("utf8"))
}

/// Whether the terminal may know synchronized output. Most others ignore its sequences, but consoles and those of old are spared them.
pub fn synchronizes(var: &dyn Fn(&str) -> Option<String>) -> bool {
    let old =
        |term: &str| term.is_empty() || matches!(term, "dumb" | "linux") || term.starts_with("vt");
    var("TERM").is_some_and(|term| !old(&term))
}

/// Whether the locale says that text may hold more than ASCII.
pub fn knows_utf8(var: &dyn Fn(&str) -> Option<String>) -> bool {
    utf8_locale(var).unwrap_or(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(pairs: &[(&str, &str)], flag: Option<Glyphs>, kept: Option<Glyphs>) -> Capabilities {
        decide(flag, kept, &|name| {
            pairs
                .iter()
                .find(|(n, _)| *n == name)
                .map(|(_, v)| (*v).to_owned())
        })
    }

    #[test]
    fn the_effective_locale_decides() {
        let utf8 = ("LANG", "en_US.UTF-8");
        assert_eq!(with(&[utf8], None, None).glyphs, Glyphs::Braille);
        assert_eq!(with(&[("LANG", "C")], None, None).glyphs, Glyphs::Ascii);
        assert_eq!(
            with(&[utf8, ("LC_ALL", "C")], None, None).glyphs,
            Glyphs::Ascii
        );
        assert_eq!(
            with(&[utf8, ("LC_ALL", "")], None, None).glyphs,
            Glyphs::Braille
        );
        assert_eq!(
            with(&[utf8, ("TERM", "linux")], None, None).glyphs,
            Glyphs::Ascii
        );
    }

    #[test]
    fn flag_before_memory_before_locale() {
        let c = ("LANG", "C");
        assert_eq!(
            with(&[c], Some(Glyphs::Braille), None).glyphs,
            Glyphs::Braille
        );
        assert_eq!(
            with(&[c], None, Some(Glyphs::Braille)).glyphs,
            Glyphs::Braille
        );
        assert_eq!(
            with(&[c], Some(Glyphs::Ascii), Some(Glyphs::Braille)).glyphs,
            Glyphs::Ascii
        );
    }

    #[test]
    fn no_locale_is_a_question_and_no_answer() {
        let capabilities = with(&[], None, None);
        assert!(capabilities.unsure);
        assert!(!with(&[], None, Some(Glyphs::Ascii)).unsure);
    }

    #[test]
    fn old_terminals_are_sent_no_synchronized_output() {
        let known = |term: Option<&str>| synchronizes(&|_| term.map(str::to_owned));
        assert!(known(Some("xterm-256color")) && known(Some("tmux-256color")));
        for term in [None, Some(""), Some("dumb"), Some("linux"), Some("vt100")] {
            assert!(!known(term), "{term:?}");
        }
    }

    #[test]
    fn an_empty_no_color_means_nothing() {
        assert!(with(&[("NO_COLOR", "")], None, None).colour);
        assert!(!with(&[("NO_COLOR", "1")], None, None).colour);
    }
}
