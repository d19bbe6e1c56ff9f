//! What acts in a case and a system cannot state.

use super::ends::rows_of;
use super::payload;
use super::source::{DENSITY, LETTERS, LineSource};
use super::stretches::end_of;
use crate::case::{DragCoefficient, DynamicStiffness, End, EndKind, MotionName};
use crate::import::fault::Fault;

/// All of it, but for what the mesh and the results show.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let mut found = Vec::new();
    if source.case.traveller.is_some() {
        let problem =
            "a body that travels along the line at a given speed has no words in a system";
        let remedy = "make the line two, and a sliding point that is hauled along them";
        found.push(source.fault(&["traveller"], problem, remedy));
    }
    for (letter, end) in LETTERS
        .into_iter()
        .zip([&source.case.ends.a, &source.case.ends.b])
    {
        found.extend(motion(source, letter, end));
    }
    if source.case.ends.b.kind == EndKind::Payload {
        found.extend(payload::faults(source));
    }
    found.extend(clumps(source));
    found.extend(buoyed(source));
    found.extend(secants(source));
    found.extend(slope(source));
    found.extend(start(source));
    found
}

/// The motion of an end.
fn motion(source: &LineSource<'_>, letter: &str, end: &End) -> Option<Fault> {
    if end.kind != EndKind::Moving {
        return None;
    }
    let at = |key, problem, remedy| Some(source.fault(&["ends", letter, key], problem, remedy));
    match end.motion {
        MotionName::Irregular => at(
            "motion",
            "a system moves points by harmonics or by a table",
            "give the motion as a table",
        ),
        MotionName::Vessel => at(
            "motion",
            "in a system a vessel is a body with a response_file of its own, and this one is not carried over",
            "import the case with a held end, and put its point on a moved body",
        ),
        MotionName::Table
            if rows_of(source, end)
                .first()
                .is_some_and(|row| row[0] != 0.0) =>
        {
            at(
                "motion_file",
                "the table of a system begins at time 0",
                "begin it at 0",
            )
        }
        MotionName::Table => None,
        MotionName::Harmonic if !source.is_in_time() && is_off_place(end) => at(
            "phase_deg",
            "at rest a system has the point at its position, not where its motion begins",
            "give that position, or leave the phase out",
        ),
        MotionName::Harmonic => None,
    }
}

/// Whether a motion begins off its place.
fn is_off_place(end: &End) -> bool {
    let mut axes = end.amplitude_m.iter().zip(&end.phase_deg);
    end.ramp_s == 0.0 && axes.any(|(amplitude, phase)| amplitude * phase.to_radians().sin() != 0.0)
}

/// Clumps between the ends whose coefficients go by axes, or that bear on the bed otherwise than a cube does.
fn clumps(source: &LineSource<'_>) -> Vec<Fault> {
    let mut found = Vec::new();
    let clumps = source.case.clumps.iter();
    for clump in clumps.filter(|clump| end_of(&source.case, clump).is_none()) {
        let name = clump.name.as_str();
        let both = [
            ("drag_area_m2", source.flows(), &clump.drag_area_m2),
            ("added_mass_kg", source.is_in_time(), &clump.added_mass_kg),
        ];
        for (key, acts, value) in both {
            if acts && value.alike().is_none() {
                let problem = "a clump of a system has the same along all axes";
                found.push(source.fault(&["clumps", name, key], problem, "give one number"));
            }
        }
        for key in ["bed_area_m2", "bottom_m", "breakout_n"] {
            let path = ["clumps", name, key];
            if source.case.seabed.is_some() && source.node(&path).is_some() {
                let problem = "a clump of a system bears on the bed as a cube of its volume";
                found.push(source.fault(&path, problem, "leave it out"));
            }
        }
        for key in ["at_m", "drag_area_m2", "added_mass_kg"] {
            found.extend(source.fault_of_expression(&["clumps", name, key]));
        }
    }
    found
}

/// Modules on a line whose drag goes by a law, or on a pipe with a bore; expressions in what they are computed from.
fn buoyed(source: &LineSource<'_>) -> Vec<Fault> {
    let case = &source.case;
    let floats = case.floats.iter().map(|of| ("floats", of.section.as_str()));
    let modules = case
        .modules
        .iter()
        .map(|of| ("modules", of.section.as_str()));
    let mut found = Vec::new();
    for (table, section) in floats.chain(modules) {
        let entries = source
            .node(&[table, section])
            .map_or(&[][..], |node| node.entries());
        for entry in entries.iter().filter(|entry| entry.key != "section") {
            found.extend(source.fault_of_expression(&[table, section, &entry.key]));
        }
        let Some(own) = case.line.iter().find(|one| one.name == section) else {
            continue;
        };
        for key in ["length_m", "segments"] {
            found.extend(source.fault_of_expression(&["line", section, key]));
        }
        found.extend(under(source, table, &own.material));
        found.extend(along_law(source, (table, section), &own.material));
    }
    found
}

/// Drag of floats along a line whose own goes by a law.
fn along_law(source: &LineSource<'_>, (table, section): (&str, &str), name: &str) -> Option<Fault> {
    let material = source.case.materials.get(name)?;
    let is_law = matches!(material.drag_tangential, DragCoefficient::Named(_));
    let mut floats = source.case.floats.iter();
    let drags = floats.any(|one| one.section == section && one.drag_area_tangential_m2 > 0.0);
    let acts = table == "floats" && is_law && drags;
    let problem = "goes along a line whose drag is a law of the Reynolds number";
    acts.then(|| {
        let path = [table, section, "drag_area_tangential_m2"];
        source.fault(&path, problem, "give the line a coefficient")
    })
}

/// A material under floats or modules.
fn under(source: &LineSource<'_>, table: &str, name: &str) -> Vec<Fault> {
    let Some(material) = source.case.materials.get(name) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    let drags = [
        ("drag_normal", &material.drag_normal),
        ("drag_tangential", &material.drag_tangential),
    ];
    for (key, drag) in drags {
        if table == "modules" && matches!(drag, DragCoefficient::Named(_)) {
            let problem = "is a law of the Reynolds number, under modules of a constant coefficient that cover a part of the line";
            found.push(source.fault(&["materials", name, key], problem, "give a coefficient"));
        }
    }
    if table == "modules" && material.bore.is_some() {
        let problem = "is a pipe under modules, which a system has as a thicker line";
        found.push(source.fault(&["materials", name, "bore"], problem, "leave the bore out"));
    }
    let keys = [
        "diameter_m",
        "mass_kg_per_m",
        "wet_weight_kg_per_m",
        "axial_damping_ratio",
        "added_mass_normal",
        "added_mass_tangential",
    ];
    found.extend(
        keys.into_iter()
            .filter_map(|key| source.fault_of_expression(&["materials", name, key])),
    );
    found.extend(source.fault_of_expression(&DENSITY));
    found
}

/// Ropes at rest whose stiffness goes with their tension: the closed form of a line has the static one.
fn secants(source: &LineSource<'_>) -> Vec<Fault> {
    let is_closed = !source.is_in_time() && source.case.current.is_none() && !source.bends();
    let materials = source.case.materials.iter().filter(|_| is_closed);
    let secants = materials.filter(|(_, of)| of.dynamic_stiffness == DynamicStiffness::Secant);
    let fault = |(name, _): (&String, _)| {
        let problem = "makes the line stiffer at rest, and a system has its static stiffness there";
        let path = ["materials", name, "dynamic_stiffness"];
        source.fault(
            &path,
            problem,
            "let the case run in time, or leave this out",
        )
    };
    secants.map(fault).collect()
}

/// A bed that slopes.
fn slope(source: &LineSource<'_>) -> Option<Fault> {
    let bed = source.case.seabed.as_ref()?;
    (bed.slope_deg != 0.0 && bed.depth_file.is_none()).then(|| {
        let problem = "a bed of a system is level, or has depths over a grid with vertical springs, and not ones across a slope";
        source.fault(
            &["seabed", "slope_deg"],
            problem,
            "give the slope as a `depth_file` of four places, with `interpolation = \"bilinear\"`",
        )
    })
}

/// A start that is no equilibrium.
fn start(source: &LineSource<'_>) -> Vec<Fault> {
    let start = &source.case.start;
    let mut found = Vec::new();
    if source.bends() && start.arc_m.is_some() && !super::start::is_in_shape(source) {
        let problem = "says which of several equilibria of a line that bends is meant, and a system searches its own";
        found.push(source.fault(
            &["start", "arc_m"],
            problem,
            "leave it out where there is one equilibrium",
        ));
    }
    if start.from_run.is_some() {
        let problem = "a system begins at no stored run of a line";
        found.push(source.fault(&["start", "from_run"], problem, "start in equilibrium"));
    }
    found
}
