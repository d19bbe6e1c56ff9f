//! Checks of lines that are paid out, and of points that slide along them.

use super::check::{end_of_run, motion_table};
use crate::case::schema::Key;
use crate::case::{CreepModel, Finding, MaterialKeys, unknown};
use crate::system::model::{
    BodyKeys, BodyKind, LineKeys, PayoutKeys, PointKind, SlidingKeys, SystemKeys, WhichEnd,
};

/// Payouts that contradict themselves, each other, or their line.
pub(in crate::system) fn payouts(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let names: Vec<&str> = line_names(keys);
    let response = keys.output.as_ref().map(|output| &output.response_from_s);
    found.extend(
        response
            .filter(|_| !keys.payouts.is_empty())
            .and_then(|key| {
                let problem =
                    "is of nodes that stay, and those of lines that are paid out come and go";
                key.if_given(problem, "leave it out, or the payouts")
            }),
    );
    for (number, (_, payout)) in keys.payouts.iter().enumerate() {
        let lost = unknown(&payout.line, &names, "line", "system");
        let known = lost.is_none();
        found.extend(lost);
        found.extend(drives(payout));
        found.extend(without_effect(payout));
        found.extend(stops_first(&payout.start_s, &payout.stop_s));
        let until = end_of_run(keys);
        found.extend(motion_table(
            &payout.table_time_s,
            &[&payout.table_m],
            until,
        ));
        found.extend(table(&payout.table_time_s, &payout.table_m));
        if known {
            let end = payout.end.value().map(WhichEnd::index);
            found.extend(of_line(keys, &payout.line, end));
            found.extend(of_end(keys, payout));
            found.extend(used_before(keys, number));
        }
    }
    for (number, (_, sliding)) in keys.sliding_points.iter().enumerate() {
        found.extend(slides(keys, sliding));
        found.extend(hauls(keys, sliding));
        found.extend(slid_before(keys, number));
    }
    found
}

fn line_names<'a>(keys: &'a SystemKeys<'_>) -> Vec<&'a str> {
    let names = keys.lines.iter().filter_map(|(_, line)| line.name.get());
    names.map(String::as_str).collect()
}

fn line<'a, 'b>(keys: &'a SystemKeys<'b>, name: &Key<'_, String>) -> Option<&'a LineKeys<'b>> {
    let name = name.get()?;
    let mut lines = keys.lines.iter().map(|(_, line)| line);
    lines.find(|line| line.name.get() == Some(name))
}

/// One drive each; the heave may be compensated beside a rate or a table.
fn drives(payout: &PayoutKeys<'_>) -> Option<Finding> {
    let given = [
        (payout.rate_m_per_s.is_given(), "rate_m_per_s"),
        (payout.table_time_s.is_given(), "table_time_s"),
        (payout.tension_n.is_given(), "tension_n"),
    ];
    let all = given.iter().filter(|(is, _)| *is);
    let names: Vec<&str> = all.map(|(_, name)| *name).collect();
    let heave = &payout.heave_compensation;
    match names.as_slice() {
        [] if heave.is_given() => None,
        [] => Some(payout.place.finding(
            "nothing pays the line out",
            "give `rate_m_per_s`, `table_time_s` and `table_m`, `heave_compensation`, or `tension_n`",
        )),
        [one] => {
            let gives_way = *one == "tension_n" || payout.greatest_tension_n.is_given();
            let problem = "is not covered beside a winch that gives way";
            let remedy = "leave it out, or the tension";
            heave.if_given(problem, remedy).filter(|_| gives_way)
        }
        [first, second, ..] => {
            let problem = format!("the line is paid out by both `{first}` and `{second}`");
            Some(payout.place.finding(problem, "leave one of them out"))
        }
    }
}

/// A rate that stops before it sets in.
fn stops_first(start: &Key<'_, f64>, stop: &Key<'_, f64>) -> Option<Finding> {
    let (from, to) = (start.value()?, stop.value()?);
    (to < from).then(|| {
        let problem = format!("is before the start at {from} s");
        stop.finding(problem, "let it stop later")
    })
}

/// A table without lengths, or one that begins with a length paid out.
fn table(times: &Key<'_, Vec<f64>>, lengths: &Key<'_, Vec<f64>>) -> Option<Finding> {
    if times.is_given() && !lengths.is_given() {
        return lengths.if_missing("add the lengths at these times: `table_m`");
    }
    let first = *lengths.given()?.first()?;
    (first != 0.0).then(|| {
        let problem = format!("begins with {first} m");
        let remedy = "begin with 0, and with a line of another length";
        lengths.finding_at_item(0, problem, remedy)
    })
}

/// Keys that what drives the payout does not use.
fn without_effect(payout: &PayoutKeys<'_>) -> Vec<Finding> {
    let by_rate = payout.rate_m_per_s.is_given();
    let limited = payout.greatest_tension_n.is_given();
    let by_tension = payout.tension_n.is_given();
    let mut found = Vec::new();
    let mut only = |key: Option<Finding>, needed: bool| found.extend(key.filter(|_| !needed));
    let with = |what: &str| format!("has no effect without {what}");
    let leave = "leave it out";
    only(
        payout
            .greatest_tension_n
            .if_given(with("`rate_m_per_s`"), leave),
        by_rate,
    );
    only(
        payout
            .greatest_rate_m_per_s
            .if_given(with("`tension_n`"), leave),
        by_tension,
    );
    let winch = "`tension_n`, or `rate_m_per_s` with `greatest_tension_n`";
    only(
        payout.drum_mass_kg.if_given(with(winch), leave),
        by_tension || (by_rate && limited),
    );
    let kept = "`rate_m_per_s` that is kept at any tension";
    only(
        payout.start_s.if_given(with(kept), leave),
        by_rate && !limited,
    );
    only(
        payout.stop_s.if_given(with(kept), leave),
        by_rate && !limited,
    );
    let by_table = payout.table_time_s.is_given();
    let grows = with("a rate, a table or a tension");
    let ramp = payout.ramp_s.if_given(grows, leave);
    only(ramp, by_rate || by_table || by_tension);
    found
}

/// What a line that is paid out at an end, or that a point there slides along, cannot have.
fn of_line(keys: &SystemKeys<'_>, name: &Key<'_, String>, end: Option<usize>) -> Vec<Finding> {
    let Some(line) = line(keys, name) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    let mut add = |is: bool, problem: &str, remedy: &str| {
        if is {
            found.push(name.finding(problem, remedy));
        }
    };
    add(
        line.repeat_at_deg.is_given(),
        "is not covered for a line that is repeated",
        "write the line apart from the others",
    );
    add(
        line.break_at_m.is_given(),
        "is not covered for a line that may break",
        "leave the break out",
    );
    add(
        keys.ageing.is_some(),
        "is not covered where lines age",
        "leave [ageing] out",
    );
    add(
        end.is_some_and(|end| has_attached_at(line, end)),
        "is not covered for floats, modules and clumps on the section at that end of a line: they would pass the end",
        "put them on a section further on",
    );
    let any = |is: fn(&MaterialKeys<'_>) -> bool| {
        let mut names = materials(line).into_iter();
        names.any(|name| {
            let known = keys.materials.iter().find(|(known, _)| known == name);
            known.is_some_and(|(_, given)| is(given))
        })
    };
    add(
        any(|given| given.ei_n_m2.value().is_some_and(|ei| ei > 0.0)),
        "is not covered for a line with bending stiffness",
        "leave `ei_n_m2` of its material out",
    );
    add(
        any(|given| !given.creep_model.is(&CreepModel::None)),
        "is not covered for a line that creeps",
        "set `creep_model = \"none\"` in its material",
    );
    found
}

/// Whether floats, modules or bodies are on the section at an end of a line.
fn has_attached_at(line: &LineKeys<'_>, end: usize) -> bool {
    let ends = [line.sections.first(), line.sections.last()];
    let at = ends[end].and_then(|(_, section)| section.name.get());
    let floats = line.floats.iter().map(|(_, of)| &of.section);
    let modules = line.modules.iter().map(|(_, of)| &of.section);
    let clumps = line.clumps.iter().map(|(_, of)| &of.section);
    let mut all = floats.chain(modules).chain(clumps);
    all.any(|section| section.get().is_none() || section.get() == at)
}

/// The materials of a line from A to B.
fn materials<'a>(line: &'a LineKeys<'_>) -> Vec<&'a String> {
    let sections = line.sections.iter().map(|(_, section)| &section.material);
    let keys = std::iter::once(&line.material).chain(sections);
    keys.filter_map(Key::get).collect()
}

/// An end that cannot be paid out of.
fn of_end(keys: &SystemKeys<'_>, payout: &PayoutKeys<'_>) -> Option<Finding> {
    let line = line(keys, &payout.line)?;
    let end = payout.end.value()?;
    let (released, tension, point) = match end {
        WhichEnd::A => (&line.release_a_s, &line.release_a_n, &line.from),
        WhichEnd::B => (&line.release_b_s, &line.release_b_n, &line.to),
    };
    if released.is_given() || tension.is_given() {
        let problem = "is not covered for an end that is let go";
        return Some(payout.line.finding(
            problem,
            "leave the release out, or pay out at its other end",
        ));
    }
    let follows = payout.heave_compensation.is_given() && !is_prescribed(keys, point);
    follows.then(|| {
        let problem = "is not covered for an end that is free to move";
        let remedy = "put the end on a point or a body that is held or moved";
        payout.heave_compensation.finding(problem, remedy)
    })
}

/// Whether the motion of a point is prescribed.
fn is_prescribed(keys: &SystemKeys<'_>, point: &Key<'_, String>) -> bool {
    let known = keys
        .points
        .iter()
        .find(|(name, _)| Some(name) == point.get());
    known.is_some_and(|(_, point)| match point.kind.value() {
        Some(PointKind::Body) => {
            let mut bodies = keys.bodies.iter();
            let body = bodies.find(|(name, _)| Some(name) == point.body.get());
            let is = |body: &BodyKeys<'_>, kind| body.kind.is(kind);
            body.is_some_and(|(_, body)| !is(body, &BodyKind::Free) && !is(body, &BodyKind::Pinned))
        }
        kind => kind != Some(PointKind::Free),
    })
}

/// An end that something passes already: another payout, or a point that slides.
fn used_before(keys: &SystemKeys<'_>, number: usize) -> Option<Finding> {
    let (_, payout) = &keys.payouts[number];
    let here = (payout.line.get()?, payout.end.value()?);
    let before = keys.payouts[..number].iter();
    let twice = before.filter_map(|(_, other)| Some((other.line.get()?, other.end.value()?)));
    let slid = (0..keys.sliding_points.len()).flat_map(|number| slid_ends(keys, number));
    let taken = twice.chain(slid).any(|other| other == here);
    let remedy = "give every end one payout";
    taken.then(|| {
        payout
            .line
            .finding("is paid out at that end already", remedy)
    })
}

/// The end of a line that is at a point.
fn end_at<'a>(
    keys: &'a SystemKeys<'_>,
    name: &Key<'_, String>,
    point: &Key<'_, String>,
) -> Option<(&'a String, WhichEnd)> {
    let line = line(keys, name)?;
    let at = |end: &Key<'_, String>| end.get().is_some() && end.get() == point.get();
    let end = match (at(&line.from), at(&line.to)) {
        (true, _) => WhichEnd::A,
        (_, true) => WhichEnd::B,
        _ => return None,
    };
    Some((line.name.get()?, end))
}

/// The ends that pass a point.
fn slid_ends<'a>(keys: &'a SystemKeys<'_>, number: usize) -> Vec<(&'a String, WhichEnd)> {
    let (_, sliding) = &keys.sliding_points[number];
    let ends = [&sliding.line, &sliding.other].map(|name| end_at(keys, name, &sliding.point));
    ends.into_iter().flatten().collect()
}

/// A sliding point whose lines another slides along at the same ends.
fn slid_before(keys: &SystemKeys<'_>, number: usize) -> Option<Finding> {
    let here = slid_ends(keys, number);
    let mut before = (0..number).flat_map(|other| slid_ends(keys, other));
    let taken = before.any(|end| here.contains(&end));
    let (_, sliding) = &keys.sliding_points[number];
    taken.then(|| {
        let problem = "passes an end of a line that another sliding point passes already";
        sliding.place.finding(problem, "give every end one of them")
    })
}

/// A sliding point that is not between its two lines, or is held.
fn slides(keys: &SystemKeys<'_>, sliding: &SlidingKeys<'_>) -> Vec<Finding> {
    let points: Vec<&str> = keys.points.iter().map(|(name, _)| name.as_str()).collect();
    let names = line_names(keys);
    let mut found = Vec::from_iter(unknown(&sliding.point, &points, "point", "system"));
    for name in [&sliding.line, &sliding.other] {
        found.extend(unknown(name, &names, "line", "system"));
    }
    if !found.is_empty() {
        return found;
    }
    for name in [&sliding.line, &sliding.other] {
        let end = end_at(keys, name, &sliding.point);
        found.extend(of_line(keys, name, end.map(|(_, end)| end.index())));
        if end.is_none() {
            let point = sliding.point.get().map_or("", String::as_str);
            let problem = format!("has no end at \"{point}\"");
            found.push(name.finding(problem, "name the two lines that end at the point"));
        }
    }
    if sliding.line.get() == sliding.other.get() {
        let problem = "is the line on the other side too";
        found.push(
            sliding
                .other
                .finding(problem, "name the two lines that end at the point"),
        );
    }
    found.extend(other_material(keys, sliding));
    found
}

/// What hauls a point along its line: a rate or a table, and no friction beside it.
fn hauls(keys: &SystemKeys<'_>, sliding: &SlidingKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let (rate, times) = (&sliding.rate_m_per_s, &sliding.table_time_s);
    let leave = "leave it out";
    if rate.is_given() && times.is_given() {
        let problem = "the point is hauled by both `rate_m_per_s` and `table_time_s`";
        let remedy = "leave one of them out";
        found.push(sliding.place.finding(problem, remedy));
    }
    if !rate.is_given() {
        for key in [&sliding.start_s, &sliding.stop_s] {
            found.extend(key.if_given("has no effect without `rate_m_per_s`", leave));
        }
    }
    if rate.is_given() || times.is_given() {
        let problem = "has no effect on a point that is hauled, whatever force that takes";
        for key in [&sliding.friction_n, &sliding.friction] {
            found.extend(key.if_given(problem, leave));
        }
    }
    found.extend(stops_first(&sliding.start_s, &sliding.stop_s));
    let until = end_of_run(keys);
    found.extend(motion_table(times, &[&sliding.table_m], until));
    found.extend(table(times, &sliding.table_m));
    found
}

/// Lines of two materials where they meet at a point that slides.
fn other_material(keys: &SystemKeys<'_>, sliding: &SlidingKeys<'_>) -> Option<Finding> {
    let beside = |name: &Key<'_, String>| {
        let (_, end) = end_at(keys, name, &sliding.point)?;
        let all = materials(line(keys, name)?);
        match end {
            WhichEnd::A => all.first().copied(),
            WhichEnd::B => all.last().copied(),
        }
    };
    let (one, other) = (beside(&sliding.line)?, beside(&sliding.other)?);
    (one != other).then(|| {
        let problem = format!("is of {other} at the point, and the first of {one}");
        sliding.other.finding(
            problem,
            "let the line run through the point with one material",
        )
    })
}
