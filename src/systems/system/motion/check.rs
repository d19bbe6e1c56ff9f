//! Checks of the keys of motion: prescribed motions, breaks.

use super::super::check_matrix::matrix;
use crate::case::schema::Key;
use crate::case::{
    Finding, Method, MotionInterpolation, WaveKind, of_companions, of_gauge, of_longest_step,
    of_waves, too_many_rows, too_many_steps,
};
use crate::limits::SEGMENTS;
use crate::system::model::{BodyKeys, BodyKind, LineKeys, PointKeys, PointKind, SystemKeys};

/// Waves without height or period, or in a system without water.
pub(in crate::system) fn waves(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let density = keys
        .environment
        .as_ref()
        .and_then(|around| around.water_density_kg_per_m3.value());
    let is_held = |point: &PointKeys<'_>| {
        point.kind.is(&PointKind::Fixed) || point.kind.is(&PointKind::Moved)
    };
    let held = keys.points.iter().filter(|(_, point)| is_held(point));
    let held: Vec<&str> = held.map(|(name, _)| name.as_str()).collect();
    for (_, waves) in &keys.waves {
        found.extend(of_waves(waves, keys.seabed.is_some()));
        found.extend(of_gauge(waves, &held, ("fixed or moved point", "system")));
        if density == Some(0.0) {
            let remedy = "give environment.water_density_kg_per_m3, or leave the waves out";
            found.push(waves.place.finding("there is no water to run in", remedy));
        }
        let (regular, irregular) = (WaveKind::Regular, WaveKind::Irregular);
        if waves.kind.is(&regular) {
            let height = "regular waves have a height: `height_m`";
            found.extend(waves.height_m.if_missing(height));
            found.extend(waves.period_s.if_missing("and a period: `period_s`"));
        }
        if waves.kind.is(&irregular) {
            let height = "irregular waves have a height: `significant_height_m`";
            found.extend(waves.significant_height_m.if_missing(height));
            let period = "and a period: `peak_period_s`";
            found.extend(waves.peak_period_s.if_missing(period));
        }
    }
    found.extend(keys.bodies.iter().filter_map(|(_, body)| {
        let file = &body.response_file;
        let moved = [&body.amplitude_m, &body.amplitude_deg]
            .iter()
            .any(|key| key.is_given())
            || body.table_time_s.is_given();
        let (problem, remedy) = match moved {
            true => (
                "the body has a prescribed motion too",
                "leave its amplitudes and tables out, or this",
            ),
            false => (
                "there are no waves to respond to",
                "add [[waves]] with a kind, a height and a period",
            ),
        };
        file.if_given(problem, remedy)
            .filter(|_| moved || keys.waves.is_empty())
    }));
    found
}

/// When the run in time ends \[s\]; nothing at rest.
pub(super) fn end_of_run(keys: &SystemKeys<'_>) -> Option<f64> {
    let solver = keys.solver.as_ref()?;
    let moves = !solver.method.is(&Method::Static);
    solver.duration_s.value().filter(|_| moves)
}

/// The work that steps, output and segments make, where a limit is exceeded.
fn work(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let solver = keys.solver.as_ref();
    let duration = end_of_run(keys);
    let output = keys.output.as_ref().map(|output| &output.interval_s);
    let rows = output.and_then(|key| too_many_rows(key, key.value(), duration?));
    let steps = solver.map(|solver| &solver.time_step_s);
    let steps = steps.and_then(|key| too_many_steps(key, key.value(), duration?));
    let mut found: Vec<Finding> = rows.into_iter().chain(steps).collect();
    let of_sections = |line: &LineKeys<'_>| -> Option<usize> {
        let sections = line.sections.iter();
        sections.map(|(_, section)| section.segments.value()).sum()
    };
    let own = |line: &LineKeys<'_>| line.segments.value().or_else(|| of_sections(line));
    let counts = keys.lines.iter().filter_map(|(_, line)| own(line));
    let total = counts.sum::<usize>() as f64;
    if let Some((_, last)) = keys.lines.last().filter(|_| SEGMENTS.is_exceeded_by(total)) {
        let problem = format!("the lines have {total} segments in all");
        let remedy = SEGMENTS.remedy("divide them into fewer", total);
        found.push(last.segments.finding(problem, remedy));
    }
    found
}

/// Coefficients that are given twice, or count the waves twice.
pub(in crate::system) fn potential_flow(body: &BodyKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    if body.radiation_file.is_given() {
        let problem = "is given twice, here and by radiation_file";
        found.extend(body.added_mass.if_given(problem, "leave one of them out"));
    }
    let floats = body.kind.is(&BodyKind::Free);
    if body.excitation_file.is_given() && floats {
        let problem = "is given beside excitation_file: both say how waves load the body";
        found.extend(
            body.response_file
                .if_given(problem, "leave one of them out"),
        );
    }
    if body.drift_file.is_given() && !body.drift_loads.is_empty() {
        let problem = "has the mean drift, which drift_loads give too";
        found.extend(body.drift_file.if_given(problem, "leave one of them out"));
    }
    let by_responses = floats && body.response_file.is_given();
    if body.excitation_file.is_given() || by_responses {
        for (_, member) in &body.members {
            if member.drag_only.value() != Some(true) {
                let problem = match by_responses {
                    true => {
                        "counts the waves twice: response_file has the loads of what it displaces"
                    }
                    false => {
                        "counts the waves twice: excitation_file has the loads of what it displaces"
                    }
                };
                let remedy =
                    "set `drag_only = true`, with its volume in that of the body, or leave it out";
                found.push(member.place.finding(problem, remedy));
            }
        }
    }
    found
}

/// Motions without a period or without a run in time.
pub(in crate::system) fn motion(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let mut found: Vec<Finding> = moved_rods(keys).collect();
    found.extend(work(keys));
    if let Some(solver) = &keys.solver {
        found.extend(of_companions(&solver.companions));
        found.extend(of_longest_step(&solver.time_step_s, &solver.longest_step_s));
    }
    for (_, point) in &keys.points {
        found.extend(irregular(point));
        if point.kind.is(&PointKind::Moved) && point.amplitude_m.is_given() {
            let remedy = "add the period of its motion: `period_s = 10.0`, or one along each axis";
            found.extend(point.period_s.if_missing(remedy));
        }
    }
    let until = end_of_run(keys);
    for (_, point) in &keys.points {
        let columns = [&point.table_x_m, &point.table_y_m, &point.table_z_m];
        found.extend(motion_table(&point.table_time_s, &columns, until));
        if point.motion_file.is_given() {
            let problem = "is given beside a motion by a file";
            let remedy = "leave it out, or `motion_file`";
            found.extend(point.amplitude_m.if_given(problem, remedy));
            found.extend(point.table_time_s.if_given(problem, remedy));
        } else {
            found.extend(interpolated_table(
                &point.table_interpolation,
                &point.table_time_s,
            ));
        }
    }
    for (_, body) in &keys.bodies {
        let columns = [
            &body.table_x_m,
            &body.table_y_m,
            &body.table_z_m,
            &body.table_roll_deg,
            &body.table_pitch_deg,
            &body.table_yaw_deg,
        ];
        found.extend(motion_table(&body.table_time_s, &columns, until));
        found.extend(interpolated_table(
            &body.table_interpolation,
            &body.table_time_s,
        ));
        let moves = body.amplitude_m.is_given() || body.amplitude_deg.is_given();
        let follows = body.kind.is(&BodyKind::Moved) || body.kind.is(&BodyKind::Pinned);
        if follows && moves {
            let remedy = "add the period of its motion: `period_s = [10.0]`, or six of them";
            found.extend(body.period_s.if_missing(remedy));
        }
        found.extend(matrix(&body.period_s, &[1, 6], "one number, or six"));
        found.extend(matrix(&body.phase_deg, &[6], "six numbers"));
    }
    found
}

/// An irregular motion without a period, beside another motion, or keys of one that there is not.
fn irregular(point: &PointKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    if point.rms_m.is_given() {
        let remedy = "add the period of the peak of its spectrum: `peak_period_s = 10.0`";
        found.extend(point.peak_period_s.if_missing(remedy));
        let problem = "is given beside an irregular motion";
        let remedy = "leave it out, or `rms_m`";
        found.extend(point.amplitude_m.if_given(problem, remedy));
        found.extend(point.table_time_s.if_given(problem, remedy));
        found.extend(point.motion_file.if_given(problem, remedy));
        return found;
    }
    let problem = "has no effect: the point has no irregular motion";
    let remedy = "add its root mean square: `rms_m = [x, y, z]`, or remove it";
    found.extend(point.peak_period_s.if_given(problem, remedy));
    found.extend(point.gamma.if_given(problem, remedy));
    found.extend(point.components.if_given(problem, remedy));
    found.extend(point.seed.if_given(problem, remedy));
    found
}

/// How a table is interpolated that there is not.
fn interpolated_table(
    how: &Key<'_, MotionInterpolation>,
    times: &Key<'_, Vec<f64>>,
) -> Option<Finding> {
    let acts = times.is_given() || !how.is_given();
    (!acts).then(|| {
        let remedy = "add a table: `table_time_s` and its columns, or leave it out";
        how.finding("acts on nothing: there is no table", remedy)
    })
}

/// A table of motion with times that do not increase from 0 to the end, or columns of another length.
pub(super) fn motion_table(
    times: &Key<'_, Vec<f64>>,
    columns: &[&Key<'_, Vec<f64>>],
    until: Option<f64>,
) -> Option<Finding> {
    let given = columns.iter().find(|column| column.is_given());
    let Some(rows) = times.value().filter(|rows| !rows.is_empty()) else {
        let remedy = "add the times of its rows: `table_time_s = [0.0, ...]`";
        return given.and(times.if_missing(remedy));
    };
    let increases = rows.windows(2).all(|pair| pair[0] < pair[1]);
    let ends = until.is_none_or(|until| rows.last().is_some_and(|last| *last >= until));
    if rows.len() < 2 || rows[0] > 0.0 || !increases || !ends {
        let problem = "must increase from 0 or before to the end of the run";
        return Some(times.finding(problem, "give two rows or more, the first at 0 or before"));
    }
    let off = |column: &&&Key<'_, Vec<f64>>| {
        column.is_given()
            && column
                .value()
                .is_some_and(|values| values.len() != rows.len())
    };
    let column = columns.iter().find(off)?;
    let remedy = "give one value for each time";
    Some(column.finding("has another number of rows than `table_time_s`", remedy))
}

/// A break without a place or a cause, beyond the line, of a line that stands for several, or of one that ages.
pub(in crate::system) fn breaks(keys: &SystemKeys<'_>, line: &LineKeys<'_>) -> Option<Finding> {
    let place = &line.break_at_m;
    let caused = line.break_s.is_given() || line.break_n.is_given();
    if !place.is_given() {
        let remedy = "add where it breaks, from its end A: `break_at_m`";
        return caused.then(|| place.if_missing(remedy)).flatten();
    }
    if line.repeat_at_deg.is_given() {
        let problem = "is not covered for a line that is repeated";
        let remedy = "write the line that breaks apart from the others";
        return Some(place.finding(problem, remedy));
    }
    if keys.ageing.is_some() {
        let problem = "is not covered where lines age";
        return Some(place.finding(problem, "leave the break or [ageing] out"));
    }
    if !caused {
        let remedy = "say when it breaks: add `break_s`, or `break_n`";
        return Some(place.finding("has no effect by itself", remedy));
    }
    let sections = line.sections.iter();
    let sections: Option<f64> = sections.map(|(_, section)| section.length_m.value()).sum();
    let whole = line.length_m.value().or(sections)?;
    let beyond = place.value().is_some_and(|at| at >= whole);
    let problem = format!("lies beyond the line, which is {whole} m long");
    beyond.then(|| {
        place.finding(
            &problem,
            "give a place on the line; to let an end go give `release_b_s` or `release_b_n`",
        )
    })
}

/// A rod that is said to be moved: its motion has no keys.
fn moved_rods(keys: &SystemKeys<'_>) -> impl Iterator<Item = Finding> {
    let moved = keys
        .rods
        .iter()
        .filter(|(_, rod)| rod.kind.is(&BodyKind::Moved));
    moved.map(|(_, rod)| {
        let remedy = "make it a body of one member, which has `amplitude_m` and `amplitude_deg`";
        rod.kind.finding("is not covered for a rod", remedy)
    })
}
