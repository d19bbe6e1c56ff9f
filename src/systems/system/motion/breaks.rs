//! Lines that may break: in motion they are two lines from the start, joined by a point without mass that the break parts.

use super::broken_names::{BETWEEN, SECOND};
use crate::case::OnSection;
use crate::numerics::V3;
use crate::system::SolvedSystem;
use crate::system::freedoms::Placement;
use crate::system::model::{LineInputs, LineSection, PointInputs, PointKind, SystemFile};
use crate::system::network::{Held, Network};
use crate::system::parts::{sections, shared};

/// The file with every line that may break written as two.
#[must_use]
pub fn written_out(file: &SystemFile) -> SystemFile {
    let mut whole = file.clone();
    whole.lines.clear();
    for line in &file.lines {
        let Some((first, second)) = parted(line) else {
            whole.lines.push(line.clone());
            continue;
        };
        whole
            .points
            .insert(first.to.clone(), PointInputs::of(PointKind::Free));
        whole.lines.extend([first, second]);
    }
    whole
}

/// Both parts of a line; nothing where it does not break within its length.
fn parted(line: &LineInputs) -> Option<(LineInputs, LineInputs)> {
    let at = line.break_at_m?;
    let sections = sections(line);
    let whole: f64 = sections.iter().map(|section| section.length_m).sum();
    if at >= whole || (line.break_s.is_none() && line.break_n.is_none()) {
        return None;
    }
    let [attached, attached_after] = [false, true].map(|after| LineInputs {
        floats: on_side(&line.floats, &sections, at, after),
        modules: on_side(&line.modules, &sections, at, after),
        clumps: on_side(&line.clumps, &sections, at, after),
        ..line.clone()
    });
    let (before, after) = cut(sections, at);
    let segments = line.wanted_segments();
    let share = |part: f64| Some(shared(segments, part / whole).max(2));
    let part = |name: String, sections: Vec<LineSection>, length: f64, on: LineInputs| LineInputs {
        name,
        material: None,
        length_m: None,
        segments: share(length),
        sections,
        break_at_m: None,
        break_s: None,
        break_n: None,
        ..on
    };
    let middle = format!("{}{BETWEEN}", line.name);
    let first = LineInputs {
        to: middle.clone(),
        clamp_b_elevation_deg: None,
        release_b_s: line.break_s,
        release_b_n: line.break_n,
        ..part(line.name.clone(), before, at, attached)
    };
    let second = LineInputs {
        from: middle,
        clamp_a_elevation_deg: None,
        release_a_s: None,
        release_a_n: None,
        ..part(
            format!("{}{SECOND}", line.name),
            after,
            whole - at,
            attached_after,
        )
    };
    Some((first, second))
}

/// What is attached to a line before or after a place \[m\].
fn on_side<T: OnSection>(all: &[T], sections: &[LineSection], at: f64, after: bool) -> Vec<T> {
    let mut found = Vec::new();
    let mut arc = 0.0;
    for section in sections {
        let own = all.iter().filter(|one| one.is_on(section.name.as_deref()));
        let here = (at - arc).clamp(0.0, section.length_m);
        let piece = if after {
            [here, section.length_m]
        } else {
            [0.0, here]
        };
        if piece[1] > piece[0] {
            found.extend(own.filter_map(|one| one.on_piece(section.length_m, piece)));
        }
        arc += section.length_m;
    }
    found
}

/// The sections before and after a place.
fn cut(sections: Vec<LineSection>, at: f64) -> (Vec<LineSection>, Vec<LineSection>) {
    let (mut before, mut after) = (Vec::new(), Vec::new());
    let mut arc = 0.0;
    for section in sections {
        let end = arc + section.length_m;
        if end <= at {
            before.push(section);
        } else if arc >= at {
            after.push(section);
        } else {
            let share = (at - arc) / section.length_m;
            before.push(LineSection {
                length_m: at - arc,
                segments: section.segments.map(|count| shared(count, share)),
                ..section.clone().without_clump()
            });
            after.push(LineSection {
                length_m: end - at,
                segments: section.segments.map(|count| shared(count, 1.0 - share)),
                ..section
            });
        }
        arc = end;
    }
    (before, after)
}

/// Where everything is at rest in the system written out: what it has in common with the one solved, by name, and points at
/// breaks on their lines.
#[must_use]
pub fn placed(solved: &SolvedSystem, network: &Network) -> Placement {
    let at_rest = &solved.rest.placement;
    let points = network.points.iter().map(|point| {
        if let Some(known) = solved.network.point(&point.name) {
            return at_rest.points[known];
        }
        at_break(solved, &point.name).unwrap_or_else(|| match point.held {
            Held::At(place) => place,
            _ => V3::zeros(),
        })
    });
    Placement {
        points: points.collect(),
        bodies: at_rest.bodies.clone(),
    }
}

/// The place on its line of a point at a break.
fn at_break(solved: &SolvedSystem, point: &str) -> Option<V3> {
    let name = point.strip_suffix(BETWEEN)?;
    let given = solved.file.lines.iter().find(|line| line.name == name)?;
    let index = solved.network.line(name)?;
    let line = &solved.network.lines[index];
    let places = &solved.rest.placement.points;
    let ends = [&places[line.from], &places[line.to]];
    let share = given.break_at_m? / line.length();
    Some(solved.rest.balance.lines[index].at(share, ends).0)
}
