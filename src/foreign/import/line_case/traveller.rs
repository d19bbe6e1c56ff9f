//! A body that travels along the line: a point hauled between the two lines that the line becomes.
//!
//! On the line its loads are interpolated between nodes that stay; the segments of the two lines end at the point. It keeps its course but for
//! its stop: on the line it stays at once, the point eases over its ramp.

use super::copied::{bare, coefficient, value_of};
use super::end_clumps::{of_weight, write_weight};
use super::lines::parting;
use super::places::end_of;
use super::source::{BESIDE, LineSource};
use super::start;
use crate::case::{CreepModel, TomlNode, Traveller};
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, number, text};

/// Its table in a case.
const TABLE: [&str; 1] = ["traveller"];

fn key(name: &str) -> [&str; 2] {
    [TABLE[0], name]
}

/// Whether it sets out at all in a run in time.
fn sets_out(source: &LineSource<'_>, body: &Traveller) -> bool {
    source.is_in_time() && body.speed_m_per_s > 0.0
}

/// What of it, or of the line under it, a hauled point cannot state.
pub(super) fn faults(source: &LineSource<'_>, body: &Traveller) -> Vec<Fault> {
    let weight = (body.mass_kg, body.wet_mass_kg);
    let mut found: Vec<Fault> = of_weight(source, &TABLE, weight).into_iter().collect();
    found.extend(source.fault_of_expression(&key("from_m")));
    found.extend(of_way(source, body));
    if start::is_in_shape(source) || start::is_searched_from(source) {
        let problem = "is a shape of the whole line, which becomes two with a body that travels";
        let remedy = "start in equilibrium, and let it be searched";
        found.push(source.fault(&["start"], problem, remedy));
    }
    if !sets_out(source, body) {
        return found;
    }
    for name in ["to_m", "speed_m_per_s", "start_s"] {
        found.extend(source.fault_of_expression(&key(name)));
    }
    if body.ramp_s == 0.0 {
        let problem = "sets out at full speed, and a hauled point does so over a ramp";
        let remedy = "give it a ramp, such as 0.5 s";
        found.push(source.fault(&key("ramp_s"), problem, remedy));
    }
    let materials = &source.case.materials;
    let of_line = source.case.line.iter();
    let mut of_line = of_line.filter_map(|section| materials.get(&section.material));
    if of_line.any(|of| of.ei_n_m2 > 0.0 || of.creep_model != CreepModel::None) {
        let problem = "travels along a line that bends or creeps, which a hauled point cannot";
        found.push(source.fault(&TABLE, problem, "leave its `ei_n_m2` and `creep_model` out"));
    }
    found
}

/// What of its way, or of what hangs on the section where it begins, a point hauled within that section cannot state.
fn of_way(source: &LineSource<'_>, body: &Traveller) -> Vec<Fault> {
    let case = &source.case;
    let Some(parting) = parting(case, body) else {
        return vec![outside(source, "from_m")];
    };
    let mut found = Vec::new();
    let [first, last] = parting.within;
    let whole: f64 = case.line.iter().map(|one| one.length_m).sum();
    let to = body.to_m.unwrap_or(whole);
    if sets_out(source, body) && !(first <= to && to <= last) {
        found.push(outside(source, "to_m"));
    }
    let section = &case.line[parting.section].name;
    for name in ["length_m", "segments"] {
        found.extend(source.fault_of_expression(&["line", section, name]));
    }
    for table in ["floats", "modules", "clumps"] {
        let nodes = source.node(&[table]).map_or(&[][..], |list| list.items());
        for (number, node) in nodes.iter().enumerate() {
            let on = node.get("section").and_then(|on| on.text());
            let clump = case.clumps.get(number).filter(|_| table == "clumps");
            let at_end = clump.is_some_and(|clump| end_of(case, clump).is_some());
            if on.is_none_or(|on| on == section) && !at_end {
                let names = source.node(&[table]).map_or_else(Vec::new, TomlNode::names);
                let name = names.get(number).map_or("", String::as_str);
                let problem = "is on the section that the body that travels parts";
                let remedy = "divide the section, so that the body stays on one without";
                found.push(source.fault(&[table, name], problem, remedy));
            }
        }
    }
    found
}

fn outside(source: &LineSource<'_>, name: &str) -> Fault {
    let problem = "lies less than a segment from where a section of the line ends: a hauled point stays within one";
    let remedy = "let it begin and stay a segment away from there";
    source.fault(&key(name), problem, remedy)
}

/// Writes the point that it is.
pub(super) fn write_point(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let Some(body) = &source.case.traveller else {
        return;
    };
    let header = format!("[points.{}]", bare(&body.name));
    system.table(&header, source.span(&TABLE));
    system.line("kind = \"free\"", None);
    if start::is_moving(source)
        && let Some(node) = source.node(&["start", "velocity_m_per_s"])
    {
        let value = value_of(source, node);
        system.given("start_velocity_m_per_s", &value, &node.span, "");
    }
    write_weight(system, source, &TABLE);
    let area = key("drag_area_m2");
    coefficient(system, source, &area, &body.drag_area_m2);
}

/// Writes how it is hauled from one line to the other.
pub(super) fn write_hauling(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let Some(body) = &source.case.traveller else {
        return;
    };
    if !sets_out(source, body) {
        return;
    }
    system.table("[[sliding_points]]", source.span(&TABLE));
    let name = text(&body.name);
    for (own, value) in [
        ("point", &*name),
        ("line", &*text(BESIDE[0])),
        ("other", &*text(BESIDE[1])),
    ] {
        system.line(&format!("{own} = {value}"), None);
    }
    let whole: f64 = source.case.line.iter().map(|one| one.length_m).sum();
    let way = body.to_m.unwrap_or(whole) - body.from_m;
    let mut one = |own: &str, from: &str, value: f64, why: &str| match source.node(&key(from)) {
        Some(node) => system.given(own, &number(value), &node.span, why),
        None => system.assumed(own, &number(value), why),
    };
    let rate = body.speed_m_per_s.copysign(way);
    one("rate_m_per_s", "speed_m_per_s", rate, "speed_m_per_s");
    if body.start_s != 0.0 {
        one("start_s", "start_s", body.start_s, "");
    }
    let stop = body.start_s + way.abs() / body.speed_m_per_s;
    one("stop_s", "to_m", stop, "its way by its speed");
    one("ramp_s", "ramp_s", body.ramp_s, "");
}

/// What differs of its course.
pub(super) fn remark(source: &LineSource<'_>) -> Option<String> {
    let body = source.case.traveller.as_ref();
    let body = body.filter(|body| sets_out(source, body))?;
    Some(format!(
        "`{}` is a point hauled between two lines, at whose mesh the line ends on either side; it eases to its stop over its ramp, where it stopped at once.",
        body.name
    ))
}
