//! How the line answers what drives it, as tables: peaks and valleys of its root mean square displacement, and the waves on
//! each of its sections.

use std::f64::consts::TAU;

use super::number::{digits, rounded};
use super::table::{Cell, CellInk, Column, Table};
use crate::case::{AlongLine, Case, Statistic};
use crate::run::response::peaks_and_valleys;
use crate::run::{Profile, along_line};

/// Peaks and valleys from end A to end B: arc length, height, root mean square in metres and diameters with its numerical
/// error, tension there, all at the end of the run but the root mean square. Empty where the run did not record it.
#[must_use]
pub fn peaks(profile: &Profile) -> Table {
    let found = peaks_and_valleys(&profile.arc, &profile.rms);
    let waves = found.iter().filter(|(.., peak)| *peak).count();
    let row = |(s, value, is_peak): &(f64, f64, bool)| {
        let node = profile.arc.iter().position(|arc| arc >= s)?;
        let (word, ink) = if *is_peak {
            ("peak", CellInk::Warn)
        } else {
            ("valley", CellInk::Plain)
        };
        let error = profile.rms_error.get(node);
        Some(vec![
            Cell::new(word, ink),
            Cell::plain(rounded(*s, 1)),
            Cell::plain(rounded(profile.nodes.get(node)?[2], 1)),
            Cell::plain(digits(*value, 4)),
            Cell::plain(digits(*profile.rms_diameters.get(node)?, 4)),
            Cell::plain(error.map_or_else(|| "unknown".to_owned(), |e| digits(*e, 2))),
            Cell::plain(digits(*profile.tension.get(node)?, 4)),
        ])
    };
    Table {
        columns: vec![
            Column::left("response"),
            Column::decimal("arc [m]"),
            Column::decimal("z [m]"),
            Column::decimal("rms [m]"),
            Column::decimal("rms [D]"),
            Column::decimal("error [m]"),
            Column::decimal("tension [N]"),
        ],
        rows: found.iter().filter_map(row).collect(),
        notes: (waves > 0)
            .then(|| format!("{waves} peaks; ripples below 1 % of the greatest are left out."))
            .into_iter()
            .collect(),
        ..Table::default()
    }
}

/// The sections of the line and the waves on them at the driving period: peaks of the response, lengths of the waves as
/// computed and by WKB theory, waves by the turn of phase of WKB theory, amplitudes of what runs towards either end and
/// their standing wave ratio. Empty where nothing drives the line at one period.
#[must_use]
pub fn waves(case: &Case, profile: &Profile) -> Table {
    if profile.wkb_number.is_empty() {
        return Table::default();
    }
    let mut from = 0.0;
    let mut rows = Vec::new();
    for section in &case.line {
        let to = from + section.length_m;
        rows.push(section_row(profile, &section.name, [from, to]));
        from = to;
    }
    if rows.len() > 1 {
        rows.push(section_row(profile, "whole line", [0.0, from]));
    }
    Table {
        columns: vec![
            Column::left("section"),
            Column::right("peaks"),
            Column::decimal("tension [N]"),
            Column::decimal("wave [m]"),
            Column::decimal("WKB [m]"),
            Column::decimal("WKB waves"),
            Column::decimal("to A [m]"),
            Column::decimal("to B [m]"),
            Column::decimal("ratio"),
        ],
        rows,
        notes: vec![
            "Means over each section: length of the waves as computed and by WKB theory (EI k^4 + T k^2 = m omega^2), \
             amplitudes of what runs towards ends A and B, and their standing wave ratio, 1 where all travels. Where loads \
             act the motion is not of free waves."
                .to_owned(),
        ],
        ..Table::default()
    }
}

fn section_row(profile: &Profile, name: &str, stretch: [f64; 2]) -> Vec<Cell> {
    let number = |quantity, statistic, shown: fn(f64) -> String| {
        let value = along_line(profile, quantity, statistic, Some(stretch));
        value.map_or_else(|| Cell::new("-", CellInk::Dim), |v| Cell::plain(shown(v)))
    };
    let mean = |values: &[f64]| {
        let inside = profile.arc.iter().zip(values);
        let inside = inside.filter(|(s, _)| (stretch[0]..=stretch[1]).contains(*s));
        let (sum, count) = inside.fold((0.0, 0.0), |(sum, n), (_, v)| (sum + v, n + 1.0));
        Cell::plain(if count > 0.0 {
            digits(sum / count, 2)
        } else {
            "-".to_owned()
        })
    };
    vec![
        Cell::plain(name),
        number(AlongLine::RmsDisplacement, Statistic::Peaks, |v| {
            rounded(v, 0)
        }),
        number(AlongLine::Tension, Statistic::Mean, |v| digits(v, 4)),
        number(AlongLine::Wavelength, Statistic::Mean, |v| rounded(v, 1)),
        number(AlongLine::WkbWavelength, Statistic::Mean, |v| rounded(v, 1)),
        Cell::plain(rounded(turn(profile, stretch) / TAU, 2)),
        mean(&profile.towards_a),
        mean(&profile.towards_b),
        number(AlongLine::StandingWaveRatio, Statistic::Mean, |v| {
            digits(v, 3)
        }),
    ]
}

/// Turn of the phase of a wave along a stretch by WKB theory \[rad\].
fn turn(profile: &Profile, [from, to]: [f64; 2]) -> f64 {
    let pieces = profile.arc.windows(2).zip(profile.wkb_number.windows(2));
    let inside = pieces.filter(|(s, _)| s[0] >= from - 1e-6 && s[1] <= to + 1e-6);
    inside
        .map(|(s, k)| 0.5 * (s[1] - s[0]) * (k[0] + k[1]))
        .sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn profile() -> Profile {
        let arc: Vec<f64> = (0..=100).map(f64::from).collect();
        let rms: Vec<f64> = arc.iter().map(|s| (PI * s / 25.0).sin().abs()).collect();
        Profile {
            nodes: arc.iter().map(|s| [*s, 0.0, -10.0 - s]).collect(),
            tension: vec![500.0; 101],
            rms_diameters: rms.iter().map(|r| 2.0 * r).collect(),
            rms_error: vec![0.01; 101],
            rms,
            wkb_number: vec![PI / 25.0; 101],
            wave_number: vec![PI / 25.0; 101],
            wkb_amplitude: vec![1.0; 101],
            towards_a: vec![0.6; 101],
            towards_b: vec![0.4; 101],
            arc,
            ..Profile::default()
        }
    }

    #[test]
    fn peaks_and_valleys_have_their_places_and_errors() {
        let table = peaks(&profile());
        let words = |column: usize| -> Vec<String> {
            (0..table.rows.len())
                .map(|r| table.cell(r, column).text)
                .collect()
        };
        assert_eq!(
            words(0),
            ["peak", "valley", "peak", "valley", "peak", "valley", "peak"]
        );
        assert_eq!(words(1)[1], "25.0");
        assert_eq!(words(5)[0], "0.01");
        assert_eq!(words(6)[0], "500");
        assert!(peaks(&Profile::default()).rows.is_empty());
    }

    #[test]
    fn the_waves_of_a_section_are_counted() {
        let row = section_row(&profile(), "rope", [0.0, 50.0]);
        let words: Vec<&str> = row.iter().map(|c| c.text.as_str()).collect();
        assert_eq!(
            words,
            [
                "rope", "2", "500", "50.0", "50.0", "1.00", "0.6", "0.4", "5"
            ]
        );
    }
}
