//! Analyses of a system in tables and charts: offsets, watch circle, natural periods, clearances.

use seacable_base::number::rounded;
use seacable_display::chart::{Axis, Chart, Outline, Series};
use seacable_display::table::{NumberFormat, Table};
use seacable_systems::system::SolvedSystem;
use seacable_systems::system::analysis::analyses::OffsetCurve;
use seacable_systems::system::analysis::clearance::LineDistances;
use seacable_systems::system::analysis::offset::OffsetPoint;
use seacable_systems::system::analysis::periods::{NaturalModes, SystemMode};
use seacable_systems::system::analysis::seek::Sought;
use seacable_systems::system::analysis::watch_circle::WatchCircle;
use seacable_systems::system::equilibrium::SystemEquilibrium;
use seacable_systems::system::model::GoalInputs;
use seacable_systems::system::stability::Stability;

const NEWTONS: NumberFormat = NumberFormat::Si("N");
const METRES: NumberFormat = NumberFormat::Decimals(3, "m");
const DIGITS: NumberFormat = NumberFormat::Digits(8, "");
const SECONDS: NumberFormat = NumberFormat::Digits(5, "s");

/// Name of a line with its number.
fn line_name(solved: &SolvedSystem, index: usize) -> String {
    let line = solved.network.lines.get(index);
    format!(
        "{} {}",
        index + 1,
        line.map_or("", |line| line.name.as_str())
    )
}

/// A point of a curve with its distance from the start.
fn distance(point: &OffsetPoint) -> f64 {
    point.offset_m[0].hypot(point.offset_m[1])
}

/// Force and tensions against the offset.
#[must_use]
pub fn offsets(solved: &SolvedSystem, heading_deg: f64, points: &[OffsetPoint]) -> Table {
    let heading = heading_deg.to_radians();
    let towards = |p: &OffsetPoint| {
        let force = -(p.force_n.x * heading.cos() + p.force_n.y * heading.sin());
        // What rounding leaves at the place of rest is nothing.
        let rounding = force.abs() <= 1e-12 * p.greatest.1;
        if rounding { 0.0 } else { force }
    };
    let title = format!("Offset along {heading_deg} deg, height and angles held");
    Table::of_records(title, points)
        .number("offset", METRES, distance)
        .number("restoring force", NEWTONS, towards)
        .number("down", NEWTONS, |p| -p.force_n.z)
        .number("greatest tension", NEWTONS, |p| p.greatest.1)
        .text("in line", |p| line_name(solved, p.greatest.0))
        .number("of breaking load", NumberFormat::Percent, |p| {
            p.weakest.map(|(_, share)| share)
        })
        .number("anchor uplift", NEWTONS, |p| {
            p.uplift.map_or(0.0, |(_, z)| z)
        })
        .build()
}

/// Restoring force against the offset.
#[must_use]
pub fn offset_chart(heading_deg: f64, points: &[OffsetPoint]) -> Chart {
    let heading = heading_deg.to_radians();
    let towards = |p: &OffsetPoint| -(p.force_n.x * heading.cos() + p.force_n.y * heading.sin());
    let force: Outline = points.iter().map(|p| (distance(p), towards(p))).collect();
    let tension: Outline = points.iter().map(|p| (distance(p), p.greatest.1)).collect();
    let (x, y) = (Axis::new("offset", "m"), Axis::new("force", "N"));
    let series = vec![
        Series::new("restoring force", 0, force),
        Series::new("greatest tension", 1, tension),
    ];
    Chart::new("Offset", x, y, series)
}

/// The table of an offset curve that a file asks for; says where it ends for want of an equilibrium.
#[must_use]
pub fn offset_curve(solved: &SolvedSystem, curve: &OffsetCurve) -> Table {
    let mut table = offsets(solved, curve.heading_deg, &curve.points);
    if let Some(before) = curve.ends_before_m {
        table.notes.push(format!(
            "No equilibrium was found at {} and beyond.",
            METRES.write(before)
        ));
    }
    table
}

/// The goals of a file: the input that meets each, or why none does.
#[must_use]
pub fn goals(goals: &[(GoalInputs, Result<Sought, String>)]) -> Table {
    let found = |sought: &Result<Sought, String>| sought.as_ref().ok().cloned();
    let table = Table::of_records("Wanted results", goals)
        .text("result", |(goal, _)| goal.result.as_str())
        .number("wanted", DIGITS, |(goal, _)| goal.value)
        .number("comes to", DIGITS, |(_, sought)| {
            found(sought).map(|s| s.result)
        })
        .text("with", |(goal, _)| goal.vary.as_str())
        .number("at", DIGITS, |(_, sought)| found(sought).map(|s| s.value))
        .build();
    let refused = goals.iter().filter_map(|(_, sought)| sought.as_ref().err());
    table.noted(
        refused
            .map(|why| format!("Not met: {why}."))
            .collect::<Vec<_>>(),
    )
}

/// A heading of a watch circle: intact, and with the line lost by which the body goes furthest and that which loads another most.
struct HeadingRow<'a> {
    heading: f64,
    intact: Option<&'a OffsetPoint>,
    furthest: Option<(usize, &'a OffsetPoint)>,
    hardest: Option<(usize, &'a OffsetPoint)>,
    /// The line without which the load is not held, and why.
    unheld: Option<(usize, &'a str)>,
}

fn heading_rows(circle: &WatchCircle) -> Vec<HeadingRow<'_>> {
    let row = |(k, heading): (usize, &f64)| {
        let lost = circle
            .damaged
            .iter()
            .filter_map(|(line, points)| Some((*line, points[k].as_ref().ok()?)));
        let furthest = lost
            .clone()
            .max_by(|a, b| a.1.distance_m().total_cmp(&b.1.distance_m()));
        let hardest = lost.max_by(|a, b| a.1.greatest.1.total_cmp(&b.1.greatest.1));
        let mut refused = circle.damaged.iter().filter_map(|(line, points)| {
            let why = points[k].as_ref().err()?;
            Some((*line, why.as_str()))
        });
        HeadingRow {
            heading: heading.to_degrees(),
            intact: circle.intact[k].as_ref().ok(),
            furthest,
            hardest,
            unheld: refused.next(),
        }
    };
    circle.headings.iter().enumerate().map(row).collect()
}

/// The watch circle: offset and greatest tension at each heading, with all lines and with the worst line lost.
#[must_use]
pub fn watch_circle(solved: &SolvedSystem, circle: &WatchCircle) -> Table {
    let rows = heading_rows(circle);
    let name = |line: usize| line_name(solved, line);
    let title = format!(
        "Watch circle under a steady load of {}, height and angles held",
        NEWTONS.write(circle.load_n)
    );
    let mut table = Table::of_records(title, &rows)
        .number("load towards", NumberFormat::Decimals(0, "deg"), |row| {
            row.heading
        })
        .number("offset", METRES, |row| {
            row.intact.map(OffsetPoint::distance_m)
        })
        .number("greatest tension", NEWTONS, |row| {
            row.intact.map(|p| p.greatest.1)
        })
        .text("in", |row| {
            row.intact.map_or_else(String::new, |p| name(p.greatest.0))
        })
        .number("offset, line lost", METRES, |row| {
            row.furthest.map(|(_, p)| p.distance_m())
        })
        .text("lost", |row| {
            row.furthest
                .map_or_else(String::new, |(line, _)| name(line))
        })
        .number("tension, line lost", NEWTONS, |row| {
            row.hardest.map(|(_, p)| p.greatest.1)
        })
        .text("governing", |row| {
            row.hardest.map_or_else(String::new, |(lost, p)| {
                format!("{} without {}", name(p.greatest.0), name(lost))
            })
        })
        .build();
    let unheld = rows
        .iter()
        .filter_map(|row| Some((row.heading, row.unheld?)));
    table.notes.extend(unheld.map(|(heading, (line, why))| {
        format!(
            "Towards {heading:.0} deg the load is not held without line {}: {why}.",
            name(line)
        )
    }));
    for (k, point) in circle.intact.iter().enumerate() {
        if let Err(why) = point {
            table.notes.push(format!(
                "Towards {:.0} deg: {why}.",
                circle.headings[k].to_degrees()
            ));
        }
    }
    table
}

/// The places of the body, seen from above.
#[must_use]
pub fn watch_chart(solved: &SolvedSystem, circle: &WatchCircle) -> Chart {
    let path = |points: &[Result<OffsetPoint, String>]| -> Outline {
        let place = |point: &Result<OffsetPoint, String>| {
            let found = point.as_ref().ok();
            found.map_or((f64::NAN, f64::NAN), |p| (p.offset_m[0], p.offset_m[1]))
        };
        points.iter().chain(points.first()).map(place).collect()
    };
    let mut series = vec![Series::new("all lines", 0, path(&circle.intact))];
    for (line, points) in &circle.damaged {
        let mut lost = Series::new(
            &format!("without {}", line_name(solved, *line)),
            line + 1,
            path(points),
        );
        lost.dimmed = true;
        series.push(lost);
    }
    Chart {
        equal_scale: true,
        legend: series.len() <= 7,
        ..Chart::new(
            "Places of the body",
            Axis::new("x", "m"),
            Axis::new("y", "m"),
            series,
        )
    }
}

/// Natural periods.
#[must_use]
pub fn periods(solved: &SolvedSystem, found: &NaturalModes) -> Table {
    let finite = |mode: &SystemMode| mode.period_s.filter(|period| period.is_finite());
    let table = Table::of_records(
        "Natural periods of bodies and points on their lines",
        &found.modes,
    )
    .number("period", SECONDS, finite)
    .number("frequency", NumberFormat::Digits(5, "Hz"), |mode| {
        finite(mode).map(f64::recip)
    })
    .text("mostly", |mode| {
        let (part, direction) = mode.names(&solved.network);
        format!("{direction} of {part}")
    })
    .text("", |mode| match mode.period_s {
        None => "unstable",
        Some(period) if period.is_infinite() => "nothing restores",
        Some(_) => "",
    });
    let mut notes = vec!["Without damping, and without the inertia of the lines.".to_owned()];
    notes.extend(found.complete_to_s.map(|shortest| {
        format!(
            "Of large parts the longest periods are computed alone: below {} some are missing.",
            SECONDS.write(shortest)
        )
    }));
    table.build().noted(notes)
}

/// The equilibria found, the one that the report is of first: where the free bodies are, how each rests, what the lines carry.
#[must_use]
pub fn equilibria(solved: &SolvedSystem, others: &[(SystemEquilibrium, Stability)]) -> Table {
    let network = &solved.network;
    let first = (&solved.rest, &solved.stability);
    let others = others.iter().map(|(rest, how)| (rest, how));
    let all: Vec<(&SystemEquilibrium, &Stability)> = std::iter::once(first).chain(others).collect();
    let free: Vec<usize> = (0..network.bodies.len())
        .filter(|body| network.bodies[*body].turns())
        .collect();
    let mut table = Table::of_records("Equilibria that were found", &all)
        .text("at rest", |(_, how)| match how {
            Stability::Stable => "stable".to_owned(),
            Stability::Neutral(along) => format!("neutral in {along}"),
            Stability::Unstable(along) => format!("unstable in {along}"),
        })
        .number("greatest tension", NEWTONS, |(rest, _)| {
            rest.balance.tension
        });
    for body in &free {
        let name = &network.bodies[*body].name;
        let pose = |rest: &SystemEquilibrium| rest.placement.bodies[*body];
        let (places, angles) = (format!("{name}: x, y, z"), "roll, pitch, yaw");
        table = table
            .text(&places, |(rest, _)| {
                in_words(pose(rest).origin.as_slice(), "m")
            })
            .text(angles, |(rest, _)| {
                in_words(&pose(rest).angles().map(f64::to_degrees), "deg")
            });
    }
    let mut table = table.build();
    table.notes.push(match free.is_empty() {
        true => "Searched from the poses given; no body is free to be turned.".to_owned(),
        false => "Searched from the poses given and from each free body turned by a quarter and a half about its axes; the report is of the first."
            .to_owned(),
    });
    let stable = |how: &Stability| *how == Stability::Stable;
    if !stable(&solved.stability) && all.iter().any(|(_, how)| stable(how)) {
        let how = "The first is not stable and another is: give the bodies its pose, and the report is of that one.";
        table.notes.push(how.to_owned());
    }
    table
}

/// The three parts of a pose, with their unit.
fn in_words(parts: &[f64], unit: &str) -> String {
    let parts: Vec<String> = parts.iter().map(|part| rounded(*part, 2)).collect();
    format!("{} {unit}", parts.join(", "))
}

/// Distances of lines from one another, from members of bodies, from bed and surface.
#[must_use]
pub fn clearances(solved: &SolvedSystem, distances: &[LineDistances]) -> Table {
    let numbered: Vec<(usize, &LineDistances)> = distances.iter().enumerate().collect();
    let bodies = &solved.network.bodies;
    let has_members = bodies.iter().any(|body| !body.members.is_empty());
    Table::of_records("Clearances", &numbered)
        .text("line", |(k, _)| line_name(solved, *k))
        .number("least distance", METRES, |(_, from)| {
            from.line.map(|(_, distance)| distance)
        })
        .text("from line", |(_, from)| {
            from.line
                .map_or_else(String::new, |(other, _)| line_name(solved, other))
        })
        .when(has_members, |table| {
            table
                .number("from a body", METRES, |(_, from)| {
                    from.body.map(|(_, distance)| distance)
                })
                .text("which", |(_, from)| {
                    from.body
                        .map_or_else(String::new, |(body, _)| bodies[body].name.clone())
                })
        })
        .number("above the bed", METRES, |(_, from)| from.above_bed)
        .number("below the surface", METRES, |(_, from)| from.below_surface)
        .build()
        .noted(vec![
            "Between axes; lines that share a point are left out.".to_owned(),
        ])
}
