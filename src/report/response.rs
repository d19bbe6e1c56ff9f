//! How the line answers what drives it, as tables: peaks and valleys of its root mean square displacement, and the waves on
//! each of its sections.

use std::f64::consts::TAU;

use super::number::digits;
use super::table::{Align, Cell, CellStyle, NumberFormat, Table};
use seacable_model::case::{Case, LineQuantity, Statistic};
use seacable_runs::run::response::peaks_and_valleys;
use seacable_runs::run::{Profile, along_line};

/// Peaks and valleys from end A to end B: arc length, height, root mean square in metres and diameters with its numerical
/// error, tension there, all at the end of the run but the root mean square. Empty where the run did not record it.
#[must_use]
pub fn peaks(profile: &Profile) -> Table {
    let found = peaks_and_valleys(&profile.arc, &profile.rms);
    let peaks = found.iter().filter(|(.., peak)| *peak).count();
    let at_node = |(arc, value, peak): (f64, f64, bool)| {
        let node = profile.arc.iter().position(|s| *s >= arc)?;
        Some((node, arc, value, peak))
    };
    let rows: Vec<_> = found.into_iter().filter_map(at_node).collect();
    let at = |values: &[f64], node: usize| values.get(node).copied();
    let note = (peaks > 0)
        .then(|| format!("{peaks} peaks; ripples below 1 % of the greatest are left out."));
    Table::of_records("", &rows)
        .cell("response", Align::Left, |(.., peak)| match peak {
            true => Cell::new("peak", CellStyle::Warn),
            false => Cell::plain("valley"),
        })
        .number("arc [m]", NumberFormat::Decimals(1, ""), |(_, arc, ..)| {
            *arc
        })
        .number("z [m]", NumberFormat::Decimals(1, ""), |(node, ..)| {
            profile.nodes.get(*node).map(|x| x[2])
        })
        .number("rms [m]", NumberFormat::Digits(4, ""), |(_, _, rms, _)| {
            *rms
        })
        .number("rms [D]", NumberFormat::Digits(4, ""), |(node, ..)| {
            at(&profile.rms_diameters, *node)
        })
        .cell("error [m]", Align::Decimal, |(node, ..)| {
            let error = at(&profile.rms_error, *node);
            Cell::plain(error.map_or_else(|| "unknown".to_owned(), |e| digits(e, 2)))
        })
        .number("tension [N]", NumberFormat::Digits(4, ""), |(node, ..)| {
            at(&profile.tension, *node)
        })
        .build()
        .noted(note)
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
    let mut stretches = Vec::new();
    for section in &case.line {
        let to = from + section.length_m;
        stretches.push((section.name.as_str(), [from, to]));
        from = to;
    }
    if stretches.len() > 1 {
        stretches.push(("whole line", [0.0, from]));
    }
    waves_of(profile, &stretches).noted([
        "Means over each section: length of the waves as computed and by WKB theory (EI k^4 + T k^2 = m omega^2), \
         amplitudes of what runs towards ends A and B, and their standing wave ratio, 1 where all travels. Where loads \
         act the motion is not of free waves.",
    ])
}

fn waves_of(profile: &Profile, stretches: &[(&str, [f64; 2])]) -> Table {
    let statistic = |quantity, statistic, stretch: [f64; 2]| {
        along_line(profile, quantity, statistic, Some(stretch), None)
    };
    let mean = |quantity, stretch| statistic(quantity, Statistic::Mean, stretch);
    let nodes_mean = |values: &[f64], [from, to]: [f64; 2]| {
        let inside = profile.arc.iter().zip(values);
        let inside = inside.filter(|(s, _)| (from..=to).contains(*s));
        let (sum, count) = inside.fold((0.0, 0.0), |(sum, n), (_, v)| (sum + v, n + 1.0));
        (count > 0.0).then(|| sum / count)
    };
    let (digits_2, decimals) = (NumberFormat::Digits(2, ""), NumberFormat::Decimals(1, ""));
    Table::of_records("", stretches)
        .text("section", |(name, _)| *name)
        .cell("peaks", Align::Right, |(_, at)| {
            let peaks = statistic(LineQuantity::RmsDisplacement, Statistic::Peaks, *at);
            NumberFormat::Decimals(0, "").cell(peaks)
        })
        .number("tension [N]", NumberFormat::Digits(4, ""), |(_, at)| {
            mean(LineQuantity::Tension, *at)
        })
        .number("wave [m]", decimals, |(_, at)| {
            mean(LineQuantity::Wavelength, *at)
        })
        .number("WKB [m]", decimals, |(_, at)| {
            mean(LineQuantity::WkbWavelength, *at)
        })
        .number("WKB waves", NumberFormat::Decimals(2, ""), |(_, at)| {
            turn(profile, *at) / TAU
        })
        .number("to A [m]", digits_2, |(_, at)| {
            nodes_mean(&profile.towards_a, *at)
        })
        .number("to B [m]", digits_2, |(_, at)| {
            nodes_mean(&profile.towards_b, *at)
        })
        .number("ratio", NumberFormat::Digits(3, ""), |(_, at)| {
            mean(LineQuantity::StandingWaveRatio, *at)
        })
        .build()
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
        let table = waves_of(&profile(), &[("rope", [0.0, 50.0])]);
        let words: Vec<&str> = table.rows[0].iter().map(|c| c.text.as_str()).collect();
        assert_eq!(
            words,
            [
                "rope", "2", "500", "50.0", "50.0", "1.00", "0.6", "0.4", "5"
            ]
        );
    }
}
