//! Shades of a heat map: five characters that darken with the value, and colours that repeat them where there are colours.

use ratatui::style::Style;

use crate::chart::{Glyphs, PicturePart};
use crate::view::painter::Painter;

/// How many shades there are.
pub(super) const COUNT: usize = 5;

const BLOCKS: [char; COUNT] = ['·', '░', '▒', '▓', '█'];
const ASCII: [char; COUNT] = ['.', '-', '+', '#', '@'];

/// The shade of a level from 0 to 1.
pub(super) fn of_level(level: f64) -> usize {
    ((level * COUNT as f64) as usize).min(COUNT - 1)
}

/// A shade's character so many times.
pub(super) fn bar(painter: &Painter, shade: usize, width: u16) -> String {
    let all = match painter.glyphs() {
        Glyphs::Braille => BLOCKS,
        Glyphs::Ascii => ASCII,
    };
    String::from_iter(std::iter::repeat_n(all[shade], width.into()))
}

/// A shade's colour.
pub(super) fn style(painter: &Painter, shade: usize) -> Style {
    let shades = [-2, -1, 0, 1, 2];
    painter.theme.chart(PicturePart::Shade(shades[shade]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_divide_the_range_evenly() {
        let shades: Vec<usize> = [0.0, 0.19, 0.2, 0.5, 0.79, 0.8, 1.0].map(of_level).into();
        assert_eq!(shades, [0, 0, 1, 2, 3, 4, 4]);
    }
}
