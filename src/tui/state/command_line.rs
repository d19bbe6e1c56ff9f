//! The line on which a command is typed, and what was typed before.

use tui_input::Input;

/// The line on which a command is typed.
#[derive(Debug, Clone, Default)]
pub struct CommandLine {
    /// What is typed.
    pub input: Input,
    /// Cursor among what completes it.
    pub cursor: usize,
    /// Why what was typed cannot be done; empty where nothing was refused.
    pub problem: String,
    /// The line of before that is shown, counted from the newest.
    pub recalled: Option<usize>,
}

/// The lines of before, the oldest first.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct LineHistory(Vec<String>);

/// More lines are not kept.
const MOST: usize = 100;

impl LineHistory {
    /// The lines of an earlier session.
    #[must_use]
    pub fn of_lines(mut lines: Vec<String>) -> Self {
        lines.drain(..lines.len().saturating_sub(MOST));
        Self(lines)
    }

    /// The lines, the oldest first.
    #[must_use]
    pub fn lines(&self) -> &[String] {
        &self.0
    }

    /// Adds a line; one that is there already becomes the newest.
    pub fn push(&mut self, line: &str) {
        self.0.retain(|known| known != line);
        self.0.push(line.to_owned());
        self.0.drain(..self.0.len().saturating_sub(MOST));
    }

    /// A line, counted from the newest.
    #[must_use]
    pub fn recall(&self, back: usize) -> Option<&str> {
        let at = self.0.len().checked_sub(back + 1)?;
        self.0.get(at).map(String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_kept_once_and_few_are_kept() {
        let mut history = LineHistory::default();
        for line in ["one", "two", "one"] {
            history.push(line);
        }
        assert_eq!(history.lines(), ["two", "one"]);
        assert_eq!((history.recall(0), history.recall(2)), (Some("one"), None));
        for number in 0..2 * MOST {
            history.push(&number.to_string());
        }
        assert_eq!(history.lines().len(), MOST);
    }
}
