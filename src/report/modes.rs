//! Natural modes as a table, as curves along the line, and as CSV.

use std::fmt::Write as _;

use super::chart::{Axis, Chart, Series, extent};
use super::number::{digits, rounded};
use super::table::{Align, Cell, CellStyle, NumberFormat, Table};
use seacable_engine::modes::{LineModes, ModeKind, NamedMode, WkbMedium};
use seacable_numerics::V3;

/// The modes, from the lowest frequency up: frequency and its error from the mesh, period, what moves, which one of its
/// kind it is, half waves.
#[must_use]
pub fn table(found: &LineModes) -> Table {
    columns(found, true)
}

/// The same on 80 columns: without what follows from the order of the rows and from the words.
#[must_use]
pub fn narrow(found: &LineModes) -> Table {
    columns(found, false)
}

fn columns(found: &LineModes, wide: bool) -> Table {
    let medium = WkbMedium::of_line_at_rest(&found.scene, &found.rest);
    let wkb = |mode: &NamedMode| {
        let across = matches!(mode.mode.kind, ModeKind::InPlane | ModeKind::OutOfPlane);
        let medium = medium.as_ref().filter(|_| across)?;
        medium.frequency_hz(mode.of_kind)
    };
    let vibrates = |mode: &NamedMode| mode.mode.eigenvalue > 0.0;
    let numbered: Vec<(usize, &NamedMode)> = (1..).zip(&found.modes).collect();
    Table::of_records("", &numbered)
        .count("mode", |(number, _)| *number)
        .cell("frequency [Hz]", Align::Decimal, |(_, mode)| {
            frequency(mode)
        })
        .cell("error [Hz]", Align::Decimal, |(_, mode)| {
            let error = mode.error_hz.filter(|_| vibrates(mode));
            Cell::plain(error.map_or_else(|| "unknown".to_owned(), |e| digits(e, 2)))
        })
        .number("period [s]", NumberFormat::Digits(5, ""), |(_, mode)| {
            vibrates(mode).then(|| 1.0 / mode.mode.frequency_hz())
        })
        .number("WKB [Hz]", NumberFormat::Digits(4, ""), |(_, mode)| {
            wkb(mode)
        })
        .text("moves", |(_, mode)| mode.mode.kind.name())
        .when(wide, |table| {
            table
                .count("of kind", |(_, mode)| mode.of_kind)
                .count("half waves", |(_, mode)| mode.mode.half_waves)
                .count("out of plane", |(_, mode)| {
                    format!("{} %", rounded(100.0 * mode.mode.out_of_plane, 0))
                })
        })
        .build()
        .noted(notes(found))
}

fn frequency(mode: &NamedMode) -> Cell {
    let eigenvalue = mode.mode.eigenvalue;
    if eigenvalue > 0.0 {
        Cell::plain(digits(mode.mode.frequency_hz(), 6))
    } else if eigenvalue < 0.0 {
        Cell::new("grows", CellStyle::Bad)
    } else {
        Cell::new("0", CellStyle::Warn)
    }
}

fn notes(found: &LineModes) -> Vec<String> {
    let mut notes = vec![
        "Small motions about the line at rest, added mass included, drag left out. Errors are those of the mesh, from half \
         the segments."
            .to_owned(),
        "WKB: where the phase of a wave along the line, hinged at its ends, turns by n pi; leaves out its bow and its stretch, \
         which raise or lower the first modes in the plane."
            .to_owned(),
    ];
    notes.extend(instability_notes(found));
    notes
}

/// What is wrong with the line at rest, where its motions say so.
#[must_use]
pub fn instability_notes(found: &LineModes) -> Vec<String> {
    let mut notes = Vec::new();
    let count = |some: fn(f64) -> bool| {
        let values = found.modes.iter().map(|m| m.mode.eigenvalue);
        values.filter(|v| some(*v)).count()
    };
    let (grows, free) = (count(|v| v < 0.0), count(|v| v.abs() <= 0.0));
    if grows > 0 {
        notes.push(format!(
            "The line at rest is not stable: {grows} of these motions grow, and the line would leave this shape for another."
        ));
    }
    if free > 0 {
        notes.push(format!(
            "Nothing drives {free} of these motions back: some of the line lies slack."
        ));
    }
    notes
}

/// The shapes of some modes, by their numbers from 0, along the line: across it in its plane or out of it, whichever a
/// mode does; the greatest displacement of a mode is 1.
#[must_use]
pub fn chart(found: &LineModes, numbers: &[usize]) -> Chart {
    let series = numbers.iter().enumerate().filter_map(|(slot, number)| {
        let named = found.modes.get(*number)?;
        let label = format!("mode {} {}", number + 1, named.mode.kind.name());
        let points = found.scene.line.arc.iter().copied();
        let points = points.zip(named.mode.profile.iter().copied()).collect();
        Some(Series::new(&label, slot, points))
    });
    let range = extent(found.scene.line.arc.iter().copied()).filter(|range| range.1 > range.0);
    Chart::new(
        "Mode shapes along the line",
        Axis::new("arc length from end A", "m").over(range),
        Axis::new("displacement", "-").over((-1.0, 1.0)),
        series.collect(),
    )
}

/// Arc length, place at rest, and displacements of every mode, a row a node.
#[must_use]
pub fn csv(found: &LineModes) -> String {
    let mut text = String::from("arc_m,x_m,y_m,z_m");
    for (i, named) in found.modes.iter().enumerate() {
        let hz = named.mode.frequency_hz();
        for axis in ["x", "y", "z"] {
            let _ = write!(text, ",{axis}[mode {} at {hz:.6} Hz]", i + 1);
        }
    }
    for (node, (arc, place)) in found.scene.line.arc.iter().zip(&found.rest.x).enumerate() {
        let _ = write!(text, "\n{arc},{},{},{}", place.x, place.y, place.z);
        for named in &found.modes {
            for value in named.mode.shape[node].iter() {
                let _ = write!(text, ",{value}");
            }
        }
    }
    text.push('\n');
    text
}

/// Greatest displacement in the picture of a mode, by the greatest extent of the line.
const DRAWN: f64 = 0.08;

/// A mode, by its number from 0, over the line at rest, the line swung out to both sides, seen from where its motion
/// shows most. How far it is swung out means nothing, so the scales need not be equal.
#[must_use]
pub fn over_line(found: &LineModes, number: usize) -> Chart {
    let rest = &found.rest.x;
    let Some(named) = found.modes.get(number) else {
        return Chart::default();
    };
    let shape = &named.mode.shape;
    let reach = |axis: usize| {
        let range = extent(rest.iter().map(|p| p[axis]));
        range.map_or(0.0, |(low, high)| high - low)
    };
    // From the side, along x, or from above: where most of the motion meets most of the line.
    let seen = |(right, up): (usize, usize)| {
        let motion: f64 = shape.iter().map(|u| u[right].powi(2) + u[up].powi(2)).sum();
        motion * reach(right).max(reach(up)).powi(2)
    };
    let views = [(0, 2), (1, 2), (0, 1)];
    let best = views.into_iter().reduce(|best, view| {
        if seen(view) > 1.01 * seen(best) {
            view
        } else {
            best
        }
    });
    let (right, up) = best.unwrap_or((0, 2));
    let scale = DRAWN * reach(right).max(reach(up));
    let swung = |factor: f64| {
        let places = rest.iter().zip(shape);
        let at = |axis: usize, (p, u): (&V3, &V3)| p[axis] + factor * u[axis];
        places.map(|pair| (at(right, pair), at(up, pair))).collect()
    };
    let label = format!("mode {} {}", number + 1, named.mode.kind.name());
    let back = Series {
        dimmed: true,
        ..Series::new("half a period later", 0, swung(-scale))
    };
    let letters = ["x", "y", "z"];
    Chart::new(
        format!("Mode {} over the line at rest", number + 1),
        Axis::new(letters[right], "m"),
        Axis::new(letters[up], "m"),
        vec![
            Series::new(&label, 0, swung(scale)),
            back,
            Series::new("at rest", 1, swung(0.0)),
        ],
    )
}
