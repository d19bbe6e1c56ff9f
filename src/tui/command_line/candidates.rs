//! What may complete a line: commands by their names, or the arguments of the command that it begins with.

use super::arguments::arguments;
use super::{LineWord, TypedLine, WORDS, typed};
use crate::bindings::BoundCommand;
use crate::bindings::names::name;
use crate::fuzzy::{FuzzyFilter, Looking};
use crate::panes;
use crate::state::AppState;

/// What may complete a line.
#[derive(Debug, Clone)]
pub enum CompletionCandidate {
    /// A command without an argument.
    Command(BoundCommand),
    /// A command that needs one.
    Word(&'static LineWord),
    /// An argument.
    Argument(Argument),
}

/// An argument that may follow a command.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Argument {
    /// The argument as it is typed.
    pub text: String,
    /// What it is.
    pub help: String,
}

impl CompletionCandidate {
    /// The line that it completes.
    #[must_use]
    pub fn line(&self, line: &str) -> String {
        match self {
            Self::Command(command) => name(command.id),
            Self::Word(word) => format!("{} ", word.name),
            Self::Argument(argument) => match typed(line) {
                Some(typed) => format!("{} {}", typed.word.name, argument.text),
                None => argument.text.clone(),
            },
        }
    }
}

/// What may complete a line, the best first.
#[must_use]
pub fn candidates(state: &AppState, line: &str) -> Vec<CompletionCandidate> {
    match typed(line) {
        Some(line) => of_argument(state, line),
        None => of_command(state, line.trim()),
    }
}

/// The arguments that fit what is typed.
fn of_argument(state: &AppState, line: TypedLine) -> Vec<CompletionCandidate> {
    let (all, wanted) = arguments(state, line);
    let parts: Vec<Vec<&str>> = all
        .iter()
        .map(|argument| vec![argument.text.as_str(), argument.help.as_str()])
        .collect();
    let filter = FuzzyFilter::new(wanted);
    let places = filter.places(&parts);
    let mut scored: Vec<(std::cmp::Reverse<u32>, usize)> = places
        .into_iter()
        .map(|place| {
            (
                std::cmp::Reverse(filter.score(&all[place].text).unwrap_or(0)),
                place,
            )
        })
        .collect();
    if !filter.is_empty() {
        scored.sort_unstable();
    }
    let found = scored
        .into_iter()
        .map(|(_, place)| CompletionCandidate::Argument(all[place].clone()));
    found.collect()
}

/// The commands that fit what is typed: by their names first, then by what they do.
fn of_command(state: &AppState, line: &str) -> Vec<CompletionCandidate> {
    let filter = FuzzyFilter::new(line);
    let words = WORDS.iter().map(CompletionCandidate::Word);
    let commands = panes::commands(state)
        .into_iter()
        .map(CompletionCandidate::Command);
    let mut found: Vec<(Rank, CompletionCandidate)> = words
        .chain(commands)
        .filter_map(|candidate| Some((rank(&candidate, line, &filter)?, candidate)))
        .collect();
    if !filter.is_empty() {
        // Of those that only do what is typed, the ones that need no argument come first.
        let needs_argument = |rank: &Rank, candidate: &CompletionCandidate| {
            *rank == Rank::Described && matches!(candidate, CompletionCandidate::Word(_))
        };
        found.sort_by_key(|(rank, candidate)| (*rank, needs_argument(rank, candidate)));
    }
    found.into_iter().map(|(_, candidate)| candidate).collect()
}

/// How well a command fits: the least rank is the best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    /// It is the name.
    Exact,
    /// The name or the key holds the words.
    Named(std::cmp::Reverse<u32>),
    /// What it does holds them.
    Described,
    /// The name holds the letters.
    Letters(std::cmp::Reverse<u32>),
}

fn rank(candidate: &CompletionCandidate, line: &str, filter: &FuzzyFilter) -> Option<Rank> {
    let (own, doc, label, keys) = match candidate {
        CompletionCandidate::Command(command) => (
            name(command.id),
            command.doc,
            command.label,
            command.keys.joined(),
        ),
        CompletionCandidate::Word(word) => (word.name.to_owned(), word.doc, "", String::new()),
        CompletionCandidate::Argument(_) => return None,
    };
    let spoken = own.replace('_', " ");
    let score = || std::cmp::Reverse(filter.score(&spoken).unwrap_or(0));
    if own == line || spoken == line {
        return Some(Rank::Exact);
    }
    let named = [spoken.as_str(), own.as_str(), label];
    if filter.passes(&named, Looking::Words) {
        return Some(Rank::Named(score()));
    }
    let all = [spoken.as_str(), own.as_str(), label, keys.as_str(), doc];
    if filter.passes(&all, Looking::Words) {
        return Some(Rank::Described);
    }
    let has = filter.passes(&named, Looking::Letters);
    has.then(|| Rank::Letters(score()))
}
