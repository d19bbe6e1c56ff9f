//! Filters of lists: the lines that hold every word typed; where none does, those that hold the letters of every word in their order,
//! close together. So a word that is known finds what it names, and one half remembered finds it too.

use std::cell::RefCell;

use nucleo_matcher::pattern::{AtomKind, CaseMatching, Normalization, Pattern};
use nucleo_matcher::{Config, Matcher, Utf32Str};

/// The words of a filter.
#[derive(Debug)]
pub struct FuzzyFilter {
    words: Vec<FilterWord>,
    /// Made when it is needed: it takes some memory.
    matcher: RefCell<Option<Matcher>>,
}

#[derive(Debug)]
struct FilterWord {
    lower: String,
    letters: Pattern,
}

/// What is searched for in a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Looking {
    /// For the words as they are typed.
    Words,
    /// For their letters.
    Letters,
}

impl FuzzyFilter {
    /// A filter as typed.
    #[must_use]
    pub fn new(typed: &str) -> Self {
        let words = typed.split_whitespace().map(|word| FilterWord {
            lower: word.to_lowercase(),
            letters: Pattern::new(
                word,
                CaseMatching::Ignore,
                Normalization::Smart,
                AtomKind::Fuzzy,
            ),
        });
        Self {
            words: words.collect(),
            matcher: RefCell::default(),
        }
    }

    /// Whether it lets everything pass.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// Whether every word is in some part of a line.
    #[must_use]
    pub fn passes<S: AsRef<str>>(&self, parts: &[S], looking: Looking) -> bool {
        self.words.iter().all(|word| {
            let mut parts = parts.iter().map(AsRef::as_ref);
            match looking {
                Looking::Words => parts.any(|part| part.to_lowercase().contains(&word.lower)),
                Looking::Letters => parts.any(|part| self.has_letters(word, part)),
            }
        })
    }

    /// The places of the lines that pass, in their order.
    #[must_use]
    pub fn places<S: AsRef<str>>(&self, lines: &[Vec<S>]) -> Vec<usize> {
        if self.is_empty() {
            return (0..lines.len()).collect();
        }
        let found = |looking| {
            let passes = |place: &usize| self.passes(&lines[*place], looking);
            (0..lines.len()).filter(passes).collect::<Vec<usize>>()
        };
        let exact = found(Looking::Words);
        match exact.is_empty() {
            true => found(Looking::Letters),
            false => exact,
        }
    }

    /// How well a name fits all words; nothing where it does not.
    #[must_use]
    pub fn score(&self, name: &str) -> Option<u32> {
        let mut buffer = Vec::new();
        let text = Utf32Str::new(name, &mut buffer);
        let mut matcher = self.matcher.borrow_mut();
        let matcher = matcher.get_or_insert_with(matcher_of_names);
        let each = self.words.iter();
        let scores = each.map(|word| word.letters.score(text, matcher));
        scores.sum()
    }

    /// Whether the letters of a word are in a text in their order, not much further apart than they are many.
    fn has_letters(&self, word: &FilterWord, text: &str) -> bool {
        let mut buffer = Vec::new();
        let text = Utf32Str::new(text, &mut buffer);
        let mut at = Vec::new();
        let mut matcher = self.matcher.borrow_mut();
        let matcher = matcher.get_or_insert_with(matcher_of_names);
        let found = word.letters.indices(text, matcher, &mut at);
        let span = match (at.iter().min(), at.iter().max()) {
            (Some(first), Some(last)) => (last - first) as usize,
            _ => 0,
        };
        found.is_some() && span <= 2 * word.lower.chars().count() + 2
    }
}

/// What scores names: best where they begin with the word.
fn matcher_of_names() -> Matcher {
    let mut config = Config::DEFAULT;
    config.prefer_prefix = true;
    Matcher::new(config)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(typed: &str, lines: &[&str]) -> Vec<usize> {
        let lines: Vec<Vec<&str>> = lines.iter().map(|line| vec![*line]).collect();
        FuzzyFilter::new(typed).places(&lines)
    }

    #[test]
    fn words_are_found_as_typed_and_letters_where_no_line_has_the_words() {
        let lines = ["current speed", "drag area of the body", "wave height"];
        assert_eq!(found("", &lines), [0, 1, 2]);
        assert_eq!(found("AREA drag", &lines), [1]);
        assert_eq!(found("ea", &lines), [1]);
        assert_eq!(found("crsp", &lines), [0]);
        assert_eq!(found("wvhgt", &lines), [2]);
        assert!(found("xyz", &lines).is_empty());
        assert!(found("caod", &lines).is_empty(), "letters far apart");
    }

    #[test]
    fn a_name_that_begins_with_the_word_fits_better() {
        let filter = FuzzyFilter::new("so");
        assert!(filter.score("sort") > filter.score("also so"));
        assert_eq!(FuzzyFilter::new("zz").score("sort"), None);
    }
}
