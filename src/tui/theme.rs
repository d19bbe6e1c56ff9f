//! Styles of text, charts and tables on the terminal.
//!
//! Colours are the sixteen of the terminal's own palette on its own background. Without colour,
//! weight alone distinguishes styles; markers and words carry the meaning in both.

use ratatui::style::{Color, Modifier, Style};

use super::terminal::capabilities::Capabilities;
use crate::chart::PicturePart;
use crate::table::CellStyle;

/// The colours of the screen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Palette {
    /// Colours that are read on a dark background.
    #[default]
    Dark,
    /// Colours that are read on a light background.
    Light,
    /// None: weight alone.
    Mono,
}

impl Palette {
    /// The palettes by their names.
    pub const NAMES: [(&'static str, Self); 3] = [
        ("dark", Self::Dark),
        ("light", Self::Light),
        ("mono", Self::Mono),
    ];

    /// The name of the palette.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dark => "dark",
            Self::Light => "light",
            Self::Mono => "mono",
        }
    }
}

/// Styles by meaning. Meaning is never by colour alone, so that one theme without colour is enough.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Theme {
    /// False under `NO_COLOR`: weight alone.
    colour: bool,
    palette: Palette,
}

/// Colours of the series on a light background: none of the bright ones, and no yellow.
const SLOTS_ON_LIGHT: [Color; 6] = [
    Color::Blue,
    Color::Red,
    Color::Green,
    Color::Magenta,
    Color::Cyan,
    Color::DarkGray,
];

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

impl Theme {
    /// The theme of a terminal.
    #[must_use]
    pub fn new(capabilities: Capabilities) -> Self {
        Self {
            colour: capabilities.colour && capabilities.palette != Palette::Mono,
            palette: capabilities.palette,
        }
    }

    /// Text.
    pub(super) fn plain(self) -> Style {
        Style::new()
    }

    /// What stands out, such as the heads of a table.
    pub(super) fn strong(self) -> Style {
        Style::new().add_modifier(Modifier::BOLD)
    }

    /// What stays in the background.
    pub(super) fn faint(self) -> Style {
        Style::new().add_modifier(Modifier::DIM)
    }

    /// The line under the cursor.
    pub(super) fn selected(self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    /// Headings and the focused pane.
    pub(super) fn head(self) -> Style {
        let colour = self.either(Color::Cyan, Color::Blue);
        self.fg(colour).add_modifier(Modifier::BOLD)
    }

    pub(super) fn warning(self) -> Style {
        let colour = self.either(Color::Yellow, Color::Magenta);
        self.fg(colour).add_modifier(Modifier::BOLD)
    }

    pub(super) fn error(self) -> Style {
        self.fg(Color::Red).add_modifier(Modifier::BOLD)
    }

    pub(super) fn good(self) -> Style {
        self.fg(Color::Green)
    }

    /// The colour of a series; none without colour.
    #[must_use]
    pub fn slot(self, slot: usize) -> Style {
        self.fg(match self.palette {
            Palette::Light => SLOTS_ON_LIGHT[slot % SLOTS_ON_LIGHT.len()],
            _ => SLOTS[slot % SLOTS.len()],
        })
    }

    /// The style of a character of a chart.
    #[must_use]
    pub fn chart(self, ink: PicturePart) -> Style {
        let plain = self.plain();
        match ink {
            PicturePart::Blank | PicturePart::Label | PicturePart::Legend => plain,
            PicturePart::Axis => self.faint(),
            PicturePart::Title => self.strong(),
            PicturePart::Series(slot) => self.slot(slot),
            PicturePart::Dimmed(slot) => self.slot(slot).add_modifier(Modifier::DIM),
            PicturePart::Shade(-2) => self.fg(Color::Blue),
            PicturePart::Shade(-1) => self.fg(Color::Cyan),
            PicturePart::Shade(1) => self.fg(self.either(Color::Yellow, Color::Magenta)),
            PicturePart::Shade(2) => self.fg(Color::Red),
            // Without colour the shades differ by their characters alone, all at one weight.
            PicturePart::Shade(_) => plain,
            PicturePart::Cursor => self.strong(),
            PicturePart::Limit => self.fg(Color::Red),
        }
    }

    /// The style of a cell of a table.
    #[must_use]
    pub fn cell(self, ink: CellStyle) -> Style {
        match ink {
            CellStyle::Plain => self.plain(),
            CellStyle::Good => self.good(),
            CellStyle::Bad => self.error(),
            CellStyle::Warn => self.warning(),
            CellStyle::Dim => self.faint(),
        }
    }

    /// A colour of the dark palette, or the one that is read on a light background in its place.
    const fn either(self, dark: Color, light: Color) -> Color {
        match self.palette {
            Palette::Light => light,
            _ => dark,
        }
    }

    fn fg(self, colour: Color) -> Style {
        if self.colour {
            Style::new().fg(colour)
        } else {
            Style::new()
        }
    }
}
