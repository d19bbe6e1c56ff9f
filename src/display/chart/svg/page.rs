//! Elements of an SVG picture.

use std::fmt::Write;

use unicode_width::UnicodeWidthStr;

use super::ink;
use crate::markup::escaped;

/// Units across a picture; on a printed page of 180 mm a unit is a quarter of a millimetre.
pub const WIDTH: f64 = 720.0;

/// Mean width of a character in sizes of its words: that of the widest of the usual sans-serif fonts.
const CHARACTER: f64 = 0.62;

/// A picture being drawn.
#[derive(Debug, Default)]
pub(super) struct SvgPage {
    body: String,
}

/// Which end of words is at their place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl SvgPage {
    /// The elements, in the order in which they were drawn.
    pub(super) fn finish(self) -> String {
        self.body
    }

    /// An element without content.
    pub(super) fn element(&mut self, name: &str, attributes: &[(&str, String)]) {
        self.body.push('<');
        self.body.push_str(name);
        for (attribute, value) in attributes.iter().filter(|(_, value)| !value.is_empty()) {
            // Writing to a text does not fail.
            let _ = write!(self.body, " {attribute}=\"{value}\"");
        }
        self.body.push_str("/>\n");
    }

    /// A straight line.
    pub(super) fn line(&mut self, from: (f64, f64), to: (f64, f64), stroke: &str, dash: &str) {
        let d = format!("M{} {}L{} {}", px(from.0), px(from.1), px(to.0), px(to.1));
        self.path(&d, stroke, 1.0, dash);
    }

    /// An outline that is not filled.
    pub(super) fn path(&mut self, d: &str, stroke: &str, width: f64, dash: &str) {
        self.element(
            "path",
            &[
                ("d", d.to_owned()),
                ("fill", "none".to_owned()),
                ("stroke", stroke.to_owned()),
                ("stroke-width", px(width)),
                ("stroke-dasharray", dash.to_owned()),
                ("stroke-linejoin", "round".to_owned()),
            ],
        );
    }

    /// The marker of a slot at a place.
    pub(super) fn marker(&mut self, at: (f64, f64), slot: usize, colour: &str) {
        let filled = ink::is_filled(slot);
        let d = format!("M{} {}{}", px(at.0), px(at.1), ink::marker(slot));
        self.element(
            "path",
            &[
                ("d", d),
                ("fill", if filled { colour } else { "#ffffff" }.to_owned()),
                ("stroke", colour.to_owned()),
                ("stroke-width", "1.5".to_owned()),
            ],
        );
    }

    /// Words whose baseline is at a place; a white edge keeps them legible over lines.
    pub(super) fn words(&mut self, at: (f64, f64), anchor: Anchor, words: &str) {
        self.styled_words(at, anchor, words, "");
    }

    /// Words with further attributes.
    pub(super) fn styled_words(
        &mut self,
        at: (f64, f64),
        anchor: Anchor,
        words: &str,
        attributes: &str,
    ) {
        if words.is_empty() {
            return;
        }
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let (x, y) = (px(at.0), px(at.1));
        let _ = writeln!(
            self.body,
            "<text x=\"{x}\" y=\"{y}\"{anchor}{attributes} paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\">{}</text>",
            escaped(words)
        );
    }
}

/// Room that words of a size need, at most.
pub(super) fn width(words: &str, size: f64) -> f64 {
    CHARACTER * size * words.width() as f64
}

/// The words if they fit into so many units, else their beginning with dots that say that more follows.
pub(super) fn shortened(words: &str, room: f64, size: f64) -> String {
    if width(words, size) <= room {
        return words.to_owned();
    }
    let mut short = words.to_owned();
    while !short.is_empty() && width(&short, size) + width("…", size) > room {
        short.pop();
    }
    format!("{}…", short.trim_end())
}

/// A length with one decimal.
pub(super) fn px(value: f64) -> String {
    let text = format!("{value:.1}");
    match text.strip_suffix(".0").unwrap_or(&text) {
        "-0" => "0".to_owned(),
        short => short.to_owned(),
    }
}
