//! What each ink looks like on the terminal.
//!
//! Colours are the sixteen of the terminal's own palette on its own background. Without colour,
//! weight alone tells inks apart; markers and words carry the meaning in both.

use ratatui::style::{Color, Modifier, Style};

use crate::report::chart::Ink;
use crate::report::table::CellInk;

/// With or without colour.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Inks {
    /// The terminal's palette.
    #[default]
    Colour,
    /// Weight only, for `NO_COLOR`.
    Mono,
}

/// Colours of the series, by slot; they repeat after the last.
const SLOTS: [Color; 8] = [
    Color::Cyan,
    Color::Yellow,
    Color::Green,
    Color::Magenta,
    Color::LightBlue,
    Color::LightRed,
    Color::LightGreen,
    Color::LightMagenta,
];

impl Inks {
    /// Inks for a terminal that does or does not show colour.
    #[must_use]
    pub fn new(colour: bool) -> Self {
        if colour { Self::Colour } else { Self::Mono }
    }

    /// The colour of a series; none without colour.
    #[must_use]
    pub fn slot(self, slot: usize) -> Style {
        self.coloured(SLOTS[slot % SLOTS.len()])
    }

    /// The style of a character of a chart.
    #[must_use]
    pub fn chart(self, ink: Ink) -> Style {
        let plain = Style::new();
        match ink {
            Ink::Blank | Ink::Label | Ink::Legend => plain,
            Ink::Axis => plain.add_modifier(Modifier::DIM),
            Ink::Title => plain.add_modifier(Modifier::BOLD),
            Ink::Series(slot) => self.slot(slot),
            Ink::Dimmed(slot) => self.slot(slot).add_modifier(Modifier::DIM),
            Ink::Shade(-2) => self.coloured(Color::Blue),
            Ink::Shade(-1) => self.coloured(Color::Cyan),
            Ink::Shade(1) => self.coloured(Color::Yellow),
            Ink::Shade(2) => self.coloured(Color::Red),
            // Without colour the shades are told apart by their characters alone, all at one weight.
            Ink::Shade(_) => plain,
            Ink::Cursor => plain.add_modifier(Modifier::BOLD),
            Ink::Limit => self.coloured(Color::Red),
        }
    }

    /// The style of a cell of a table.
    #[must_use]
    pub fn cell(self, ink: CellInk) -> Style {
        match ink {
            CellInk::Plain => Style::new(),
            CellInk::Good => self.coloured(Color::Green),
            CellInk::Bad => self.coloured(Color::Red).add_modifier(Modifier::BOLD),
            CellInk::Warn => self.coloured(Color::Yellow).add_modifier(Modifier::BOLD),
            CellInk::Dim => Style::new().add_modifier(Modifier::DIM),
        }
    }

    /// The style of the heads of a table.
    #[must_use]
    pub fn head(self) -> Style {
        Style::new().add_modifier(Modifier::BOLD)
    }

    /// The style laid over a selected line.
    #[must_use]
    pub fn selected(self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    fn coloured(self, colour: Color) -> Style {
        match self {
            Self::Colour => Style::new().fg(colour),
            Self::Mono => Style::new(),
        }
    }
}
