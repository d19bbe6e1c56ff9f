//! The library of line types, with the properties of the one under the cursor.

use ratatui::layout::{Constraint, Layout, Rect};

use super::paint::{row, wrap};
use super::painter::Painter;
use crate::line_types::{LINE_TYPES, LineProperties};
use crate::number::{digits, si};
use crate::state::overlay::LineTypePicker;
use crate::update::line_types::chosen;

/// Size of the box, and lines for the properties below the list.
const SIZE: (u16, u16) = (96, 26);
const PROPERTIES: u16 = 6;

impl Painter<'_> {
    pub(super) fn line_types(&mut self, screen: Rect, picker: &LineTypePicker) {
        let title = "Add a line type (arrows choose, Enter adds it, Esc closes)";
        let area = self.boxed(screen, SIZE, title);
        let [head, list, _, foot] = Layout::vertical([
            Constraint::Length(1),
            Constraint::Min(0),
            Constraint::Length(1),
            Constraint::Length(PROPERTIES),
        ])
        .areas(area);
        self.prompt(head, "Nominal diameter: ", &picker.input, true);
        self.list(list, picker.cursor, LINE_TYPES.len(), |painter, at, i| {
            let line = &LINE_TYPES[i];
            let [least, greatest] = line.diameters_m.map(|d| digits(d * 1e3, 6));
            let words = format!(
                "{:<20} {:<28} {least} to {greatest} mm",
                line.name, line.title
            );
            let style = painter.line_style(i == picker.cursor);
            painter.buf.set_style(at, style);
            painter.text(at, &words, style);
        });
        self.line_type_properties(foot, picker);
    }

    /// The properties at the diameter typed, or what to type.
    fn line_type_properties(&mut self, area: Rect, picker: &LineTypePicker) {
        let words = match chosen(picker) {
            Ok(line) => properties(&line),
            Err(_) if picker.problem.is_empty() => {
                vec!["Type the nominal diameter, such as 120mm.".to_owned()]
            }
            Err(_) => vec![picker.problem.clone()],
        };
        let wrapped = words.iter().flat_map(|line| wrap(line, area.width.into()));
        for (i, line) in (0..area.height).zip(wrapped) {
            self.text(row(area, i), &line, self.theme.plain());
        }
    }
}

/// The properties of a line, a few to a sentence.
fn properties(line: &LineProperties) -> Vec<String> {
    let proof = line.proof_load.as_ref().map(|load| si(load.value, "N"));
    let proof = proof.map_or_else(String::new, |load| format!(", proof load {load}"));
    let number = |value: f64| digits(value, 4);
    let mut lines = vec![
        format!(
            "Outer diameter D {}, {} in air, {} in sea water",
            si(line.diameter.value, "m"),
            si(line.mass.value, "kg/m"),
            si(line.wet_weight.value, "kg/m")
        ),
        format!(
            "EA {}, breaking load {}{proof}",
            si(line.ea.value, "N"),
            si(line.break_load.value, "N")
        ),
        format!(
            "On D: drag {} and {} along, added mass {} and {} along",
            number(line.drag_normal.value),
            number(line.drag_tangential.value),
            number(line.added_mass_normal.value),
            number(line.added_mass_tangential.value)
        ),
    ];
    lines.extend(line.warning.clone());
    lines
}
