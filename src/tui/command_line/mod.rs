//! Commands typed with their arguments: `open manifold`, `set current.speed_m_per_s=0.4`, `sort tension`.
//!
//! Commands without arguments are those of the panes, by their names.

pub mod arguments;
pub mod candidates;

/// A command that takes an argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineCommand {
    /// Opens a case.
    Open,
    /// Sets a key of the open file.
    Set,
    /// Runs the case over values of keys.
    Vary,
    /// Goes to a key.
    GoTo,
    /// Goes to a pane.
    Pane,
    /// Filters the list with the focus.
    Filter,
    /// Sorts the table with the focus.
    Sort,
    /// Hides a column.
    Hide,
    /// Shows a column again.
    Show,
    /// Says what a column is.
    Explain,
    /// Saves under another name.
    SaveAs,
    /// Changes the colours.
    Theme,
    /// Changes the characters.
    Glyphs,
}

/// A command that takes an argument, as it is typed.
#[derive(Debug, Clone, Copy)]
pub struct LineWord {
    /// Which.
    pub id: LineCommand,
    /// Its name.
    pub name: &'static str,
    /// What follows it.
    pub argument: &'static str,
    /// What it does.
    pub doc: &'static str,
}

const fn word(
    id: LineCommand,
    name: &'static str,
    argument: &'static str,
    doc: &'static str,
) -> LineWord {
    LineWord {
        id,
        name,
        argument,
        doc,
    }
}

/// All of them.
#[rustfmt::skip] // a table: one command a line
pub const WORDS: &[LineWord] = &[
    word(LineCommand::Open, "open", "CASE", "Open a case of the list, or a file by its path"),
    word(LineCommand::Set, "set", "KEY=VALUE", "Set a key of the open file, as if it were typed into its field"),
    word(LineCommand::Vary, "vary", "KEY=VALUES", "Run the case at several values: 0.2..0.8/4 or 1, 2, 4; of several keys: all combinations"),
    word(LineCommand::GoTo, "goto", "KEY", "Go to a field of the inputs"),
    word(LineCommand::Pane, "pane", "NAME", "Go to a pane"),
    word(LineCommand::Filter, "filter", "WORDS", "Show only the lines of the list that hold these words"),
    word(LineCommand::Sort, "sort", "COLUMN", "Sort the table by a column; given again: the other way round"),
    word(LineCommand::Hide, "hide", "COLUMN", "Hide a column of the table"),
    word(LineCommand::Show, "show", "COLUMN", "Show a column again; without one: all of them"),
    word(LineCommand::Explain, "explain", "COLUMN", "Say what a column of the table is, its unit, and where it comes from"),
    word(LineCommand::SaveAs, "save as", "NAME", "Save the file under another name, and go on with that"),
    word(LineCommand::Theme, "theme", "NAME", "Change the colours: dark, light, mono"),
    word(LineCommand::Glyphs, "glyphs", "SET", "Draw with braille or ASCII characters, and remember it"),
];

/// A typed line, taken apart.
#[derive(Debug, Clone, Copy)]
pub struct TypedLine<'a> {
    /// The command that it begins with.
    pub word: &'static LineWord,
    /// What follows.
    pub argument: &'a str,
}

/// The command with an argument that a line begins with; nothing where it is no such command, or no argument is begun.
#[must_use]
pub fn typed(line: &str) -> Option<TypedLine<'_>> {
    let line = line.trim_start();
    // The longer name goes first: `save as` is not `save`.
    let mut words: Vec<&LineWord> = WORDS.iter().collect();
    words.sort_by_key(|word| std::cmp::Reverse(word.name.len()));
    words.into_iter().find_map(|word| {
        let rest = line.strip_prefix(word.name)?;
        let argument = rest.strip_prefix(' ')?;
        Some(TypedLine {
            word,
            argument: argument.trim_start(),
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_a_command_and_its_argument() {
        let line = typed("save as  my case.toml").unwrap();
        assert_eq!(
            (line.word.id, line.argument),
            (LineCommand::SaveAs, "my case.toml")
        );
        assert_eq!(typed("set a.b=3").unwrap().argument, "a.b=3");
        assert!(typed("save").is_none() && typed("set").is_none() && typed("seta b").is_none());
        assert_eq!(typed("sort ").unwrap().argument, "");
    }
}
