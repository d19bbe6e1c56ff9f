//! Natural modes as a table, as curves along the lines, and as CSV.

use std::fmt::Write as _;
use std::ops::Range;

use super::chart::{Axis, Chart, Series, extent};
use super::number::{digits, rounded};
use super::table::{Align, Cell, CellStyle, NumberFormat, Table};
use seacable_engine::modes::{LineModes, ModeKind, ModeLine, NamedMode, WkbMedium};
use seacable_numerics::V3;

/// The modes, from the lowest frequency up: frequency and its error from the mesh, period, what moves, which one of its
/// kind it is, half waves; of several lines and what they hang on also which of them moves most.
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
    let medium = alone(found).and_then(|line| WkbMedium::of_line_at_rest(&line.scene, &line.rest));
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
        .when(alone(found).is_some(), |table| {
            table.number("WKB [Hz]", NumberFormat::Digits(4, ""), |(_, mode)| {
                wkb(mode)
            })
        })
        .text("moves", |(_, mode)| mode.mode.kind.name())
        .when(alone(found).is_none(), |table| {
            table.text("mostly", |(_, mode)| mode.most.clone().unwrap_or_default())
        })
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

/// The line, where there is nothing else.
fn alone(found: &LineModes) -> Option<&ModeLine> {
    let named = found.modes.iter().any(|mode| mode.most.is_some());
    found
        .lines
        .first()
        .filter(|_| found.lines.len() == 1 && !named)
}

/// The lines, each with its nodes among those of all.
fn with_nodes(found: &LineModes) -> impl Iterator<Item = (&ModeLine, Range<usize>)> {
    let mut begin = 0;
    found.lines.iter().map(move |line| {
        let nodes = begin..begin + line.rest.x.len();
        begin = nodes.end;
        (line, nodes)
    })
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
    ];
    notes.push(match alone(found) {
        Some(_) => "WKB: where the phase of a wave along the line, hinged at its ends, turns by n pi; leaves out its bow and its stretch, \
         which raise or lower the first modes in the plane."
            .to_owned(),
        None => "Planes: that nearest to all lines. Mostly: what has most of the kinetic energy.".to_owned(),
    });
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

/// Displacements below this share of the greatest of a mode are not drawn: the line rests in it.
const DRAWN_FROM: f64 = 0.02;

/// The shapes of some modes, by their numbers from 0, along the lines that they move: across them in the plane or out of it, whichever a
/// mode does; the greatest displacement of a mode is 1.
#[must_use]
pub fn chart(found: &LineModes, numbers: &[usize]) -> Chart {
    let single = alone(found).is_some();
    let mut series = Vec::new();
    for number in numbers {
        let Some(named) = found.modes.get(*number) else {
            continue;
        };
        for (line, nodes) in with_nodes(found) {
            let profile = &named.mode.profile[nodes];
            let moves = profile.iter().any(|value| value.abs() > DRAWN_FROM);
            if !single && !moves {
                continue;
            }
            let of = if single {
                named.mode.kind.name()
            } else {
                &line.name
            };
            let label = format!("mode {} {of}", number + 1);
            let points = line.scene.line.arc.iter().copied();
            let points = points.zip(profile.iter().copied()).collect();
            series.push(Series::new(&label, series.len(), points));
        }
    }
    let arcs = found.lines.iter().flat_map(|line| &line.scene.line.arc);
    let range = extent(arcs.copied()).filter(|range| range.1 > range.0);
    Chart::new(
        match single {
            true => "Mode shapes along the line",
            false => "Mode shapes along the lines",
        },
        Axis::new("arc length from end A", "m").over(range),
        Axis::new("displacement", "-").over((-1.0, 1.0)),
        series,
    )
}

/// Arc length, place at rest, and displacements of every mode, a row a node; of several lines also the name of the line.
#[must_use]
pub fn csv(found: &LineModes) -> String {
    let named = alone(found).is_none();
    let mut text = String::from(if named {
        "line,arc_m,x_m,y_m,z_m"
    } else {
        "arc_m,x_m,y_m,z_m"
    });
    for (i, named) in found.modes.iter().enumerate() {
        let hz = named.mode.frequency_hz();
        for axis in ["x", "y", "z"] {
            let _ = write!(text, ",{axis}[mode {} at {hz:.6} Hz]", i + 1);
        }
    }
    for (line, nodes) in with_nodes(found) {
        for (own, node) in nodes.enumerate() {
            text.push('\n');
            if named {
                let _ = write!(text, "{},", line.name);
            }
            let (arc, place) = (line.scene.line.arc[own], line.rest.x[own]);
            let _ = write!(text, "{arc},{},{},{}", place.x, place.y, place.z);
            for named in &found.modes {
                for value in named.mode.shape[node].iter() {
                    let _ = write!(text, ",{value}");
                }
            }
        }
    }
    text.push('\n');
    text
}

/// Greatest displacement in the picture of a mode, by the greatest extent of the line.
const DRAWN: f64 = 0.08;

/// A mode, by its number from 0, over the lines at rest, swung out to both sides, seen from where its motion
/// shows most. How far it is swung out means nothing, so the scales need not be equal.
#[must_use]
pub fn over_line(found: &LineModes, number: usize) -> Chart {
    let Some(named) = found.modes.get(number) else {
        return Chart::default();
    };
    let single = alone(found).is_some();
    let shape = &named.mode.shape;
    let places = || found.lines.iter().flat_map(|line| &line.rest.x);
    let reach = |axis: usize| {
        let range = extent(places().map(|p| p[axis]));
        range.map_or(0.0, |(low, high)| high - low)
    };
    let (right, up) = seen_from(&shape[..named.mode.profile.len()], &reach);
    let scale = DRAWN * reach(right).max(reach(up));
    let swung = |line: &ModeLine, nodes: Range<usize>, factor: f64| {
        let places = line.rest.x.iter().zip(&shape[nodes]);
        let at = |axis: usize, (p, u): (&V3, &V3)| p[axis] + factor * u[axis];
        places.map(|pair| (at(right, pair), at(up, pair))).collect()
    };
    let label = format!("mode {} {}", number + 1, named.mode.kind.name());
    let [mut out, mut back, mut rest] = [const { Vec::new() }; 3];
    for (line, nodes) in with_nodes(found) {
        out.push(Series::new(&label, 0, swung(line, nodes.clone(), scale)));
        back.push(Series {
            dimmed: true,
            ..Series::new("half a period later", 0, swung(line, nodes.clone(), -scale))
        });
        rest.push(Series::new("at rest", 1, swung(line, nodes, 0.0)));
    }
    let letters = ["x", "y", "z"];
    let chart = Chart::new(
        match single {
            true => format!("Mode {} over the line at rest", number + 1),
            false => format!("Mode {} over the lines at rest", number + 1),
        },
        Axis::new(letters[right], "m"),
        Axis::new(letters[up], "m"),
        [out, back, rest].concat(),
    );
    Chart {
        legend: chart.legend && found.lines.len() < 2,
        ..chart
    }
}

/// The axes to the right and up, so that motion is seen from the side, along x, or from above: where most of it meets most of the lines.
fn seen_from(shape: &[V3], reach: &impl Fn(usize) -> f64) -> (usize, usize) {
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
    best.unwrap_or((0, 2))
}
