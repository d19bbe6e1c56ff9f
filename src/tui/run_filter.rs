//! The filter of the table of runs: words that a run must contain, letters with others between them allowed, and conditions
//! such as `speed>0.4`, `state=done` or `#wet`.

use nucleo_matcher::pattern::{CaseMatching, Normalization, Pattern};
use nucleo_matcher::{Config, Matcher, Utf32String};
use std::cell::RefCell;

use super::state::{RunColumn, RunEntry, RunList};

/// What the words of a filter are looked for in.
#[derive(Debug, Clone)]
pub struct FilterText {
    text: Utf32String,
    /// The letters and digits that it has.
    letters: LetterSet,
}

impl FilterText {
    /// The text of a run.
    #[must_use]
    pub fn new(run: &RunEntry) -> Self {
        let notes = &run.notes;
        let text = format!(
            "{} {} {} {} {} {} {}",
            run.id,
            run.label,
            run.state.word(),
            run.method,
            notes.name,
            notes.tags.join(" "),
            notes.note
        );
        Self {
            letters: LetterSet::of_text(&text).unwrap_or(LetterSet::ALL),
            text: Utf32String::from(text),
        }
    }
}

/// Letters, whatever their case, and digits. A run that lacks one of those typed fails without a look at its text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct LetterSet(u64);

impl LetterSet {
    /// What any text may have.
    const ALL: Self = Self(u64::MAX);

    /// Those of a text; nothing where others are taken for them, as accented letters are.
    fn of_text(text: &str) -> Option<Self> {
        let bit = |c: u8| match c.to_ascii_lowercase() {
            c @ b'a'..=b'z' => 1 << (c - b'a'),
            c @ b'0'..=b'9' => 1 << (26 + c - b'0'),
            _ => 0,
        };
        let set = || text.bytes().fold(0_u64, |set, c| set | bit(c));
        text.is_ascii().then(|| Self(set()))
    }

    const fn has_all_of(self, other: Self) -> bool {
        other.0 & !self.0 == 0
    }
}

/// What a filter asks of a run.
#[derive(Debug)]
pub struct RunFilter {
    conditions: Vec<Condition>,
    words: Pattern,
    /// Letters and digits that a run must have for the words.
    letters: LetterSet,
    /// Whether nothing else is needed for the words.
    only_letters: bool,
    matcher: RefCell<Matcher>,
}

/// `speed>0.4`
#[derive(Debug, Clone, PartialEq)]
struct Condition {
    name: String,
    relation: Relation,
    value: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Relation {
    Less,
    AtMost,
    More,
    AtLeast,
    Is,
    IsNot,
}

/// Longer signs first: `<=` is not `<`.
const RELATIONS: [(&str, Relation); 6] = [
    ("<=", Relation::AtMost),
    (">=", Relation::AtLeast),
    ("!=", Relation::IsNot),
    ("<", Relation::Less),
    (">", Relation::More),
    ("=", Relation::Is),
];

impl RunFilter {
    /// A filter as typed.
    #[must_use]
    pub fn new(typed: &str) -> Self {
        let (conditions, words): (Vec<_>, Vec<_>) = typed
            .split_whitespace()
            .map(|word| Condition::new(word).ok_or(word))
            .partition(Result::is_ok);
        let words: Vec<&str> = words.into_iter().filter_map(Result::err).collect();
        // Signs have a meaning in words: `!` before a word asks for runs without it.
        let is_plain = |word: &&&str| word.bytes().all(|c| c.is_ascii_alphanumeric());
        let plain: String = words.iter().filter(is_plain).copied().collect();
        Self {
            conditions: conditions.into_iter().flatten().collect(),
            words: Pattern::parse(&words.join(" "), CaseMatching::Ignore, Normalization::Smart),
            letters: LetterSet::of_text(&plain).unwrap_or(LetterSet(0)),
            only_letters: words.iter().all(|word| word.len() == 1) && plain.len() == words.len(),
            matcher: RefCell::new(Matcher::new(Config::DEFAULT)),
        }
    }

    /// Whether a run that passes the filter typed now has passed the one typed before: letters were added to words, and nothing else
    /// is asked.
    #[must_use]
    pub fn narrows(before: &str, now: &str) -> bool {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, ' ' | '-' | '_' | '.');
        now.starts_with(before) && !before.trim().is_empty() && now.chars().all(is_plain)
    }

    /// Whether it asks for words, which are looked for in the text of a run.
    #[must_use]
    pub fn has_words(&self) -> bool {
        !self.words.atoms.is_empty()
    }

    /// Whether a run of a list passes; its text is needed where there are words.
    #[must_use]
    pub fn passes(&self, list: &RunList, run: &RunEntry, text: Option<&FilterText>) -> bool {
        let met = |condition: &Condition| condition.is_met(list, run);
        if !self.conditions.iter().all(met) {
            return false;
        }
        let Some(text) = text.filter(|_| self.has_words()) else {
            return !self.has_words();
        };
        if !text.letters.has_all_of(self.letters) {
            return false;
        }
        if self.only_letters && text.letters != LetterSet::ALL {
            return true;
        }
        let matcher = &mut *self.matcher.borrow_mut();
        self.words.score(text.text.slice(..), matcher).is_some()
    }
}

impl Condition {
    /// A word as a condition; a word that is none is nothing. One that is only begun, `speed>`, asks nothing yet.
    fn new(word: &str) -> Option<Self> {
        if let Some(tag) = word.strip_prefix('#') {
            return Some(Self {
                name: "tag".to_owned(),
                relation: Relation::Is,
                value: tag.to_lowercase(),
            });
        }
        let found = RELATIONS.iter().find_map(|(sign, relation)| {
            let (name, value) = word.split_once(sign)?;
            Some((name, *relation, value))
        });
        let (name, relation, value) = found?;
        (!name.is_empty()).then(|| Self {
            name: name.to_lowercase(),
            relation,
            value: value.to_lowercase(),
        })
    }

    fn is_met(&self, list: &RunList, run: &RunEntry) -> bool {
        if self.value.is_empty() {
            return true;
        }
        match self.name.as_str() {
            "tag" => {
                let has = run
                    .notes
                    .tags
                    .iter()
                    .any(|tag| tag.to_lowercase() == self.value);
                has == (self.relation != Relation::IsNot)
            }
            "state" => self.holds(run.state.word()),
            "method" | "solver" => self.holds(&run.method),
            "steps" => run
                .cost
                .is_some_and(|(steps, _)| self.holds(&steps.to_string())),
            "cpu" => run
                .cost
                .is_some_and(|(_, cpu)| self.holds(&cpu.to_string())),
            "name" => self.holds(&run.title()),
            "started" | "age" => self.holds(&run.started),
            name => self.column_holds(name, list, run),
        }
    }

    /// The first input or result whose name contains the one typed.
    fn column_holds(&self, name: &str, list: &RunList, run: &RunEntry) -> bool {
        let inputs = &list.columns.inputs;
        if let Some(at) = inputs
            .iter()
            .position(|c| c.key.to_lowercase().contains(name))
        {
            let value = list.input(run, RunColumn::Input(at));
            return value.is_some_and(|value| self.holds(value));
        }
        let results = &list.columns.results;
        let at = results
            .iter()
            .position(|c| c.name.to_lowercase().contains(name));
        let result = at.and_then(|at| list.result(run, at));
        result.is_some_and(|result| self.holds(&result.value.to_string()))
    }

    /// Whether a value is as asked: numbers by their value, words by their letters.
    fn holds(&self, value: &str) -> bool {
        let order = match (value.parse::<f64>(), self.value.parse::<f64>()) {
            (Ok(value), Ok(asked)) => value.total_cmp(&asked),
            _ => value.to_lowercase().as_str().cmp(&self.value),
        };
        match self.relation {
            Relation::Less => order.is_lt(),
            Relation::AtMost => order.is_le(),
            Relation::More => order.is_gt(),
            Relation::AtLeast => order.is_ge(),
            Relation::Is => order.is_eq(),
            Relation::IsNot => order.is_ne(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::TextDigest;

    #[test]
    fn letters_decide_only_what_the_matcher_would() {
        let list = RunList::empty(true);
        let method = |word: &str| RunEntry::session(TextDigest::of_text(""), word.to_owned());
        let passes = |typed: &str, run: &RunEntry| {
            RunFilter::new(typed).passes(&list, run, Some(&FilterText::new(run)))
        };
        let (plain, accented) = (method("quasi-static"), method("\u{e9}tat \u{e0} rest"));
        for (typed, run, expected) in [
            ("q", &plain, true),
            ("Q", &plain, true),
            ("z", &plain, false),
            ("qs", &plain, true),
            ("sq", &plain, false),
            ("q z", &plain, false),
            ("!q", &plain, false),
            ("!z", &plain, true),
            ("e", &accented, true),
            ("z", &accented, false),
        ] {
            assert_eq!(passes(typed, run), expected, "{typed} in {}", run.method);
        }
    }

    #[test]
    fn a_filter_narrows_when_letters_are_added_to_words() {
        assert!(RunFilter::narrows("mod", "modu") && RunFilter::narrows("mod", "mod 3"));
        for (before, now) in [("", "m"), ("mod", "mo"), ("cpu>1", "cpu>12"), ("!m", "!mo")] {
            assert!(!RunFilter::narrows(before, now), "{before} to {now}");
        }
    }

    #[test]
    fn a_word_with_a_sign_is_a_condition() {
        let condition = Condition::new("Speed>=0.4").unwrap();
        assert_eq!(
            (condition.name.as_str(), condition.relation),
            ("speed", Relation::AtLeast)
        );
        assert!(condition.holds("0.4") && condition.holds("12") && !condition.holds("0.39"));
        assert!(Condition::new("module").is_none());
        assert!(Condition::new(">3").is_none());
        assert_eq!(Condition::new("#wet").unwrap().name, "tag");
        assert!(Condition::new("state=done").unwrap().holds("done"));
        assert!(Condition::new("cpu!=1").unwrap().holds("2"));
    }
}
