//! What of a system a file of another program cannot say.

use super::parts::alike;
use super::sea::{common_friction, current_by_file};
use super::target::{Target, Unsayable};
use crate::case::{
    BedInterpolation, Clump, CreepModel, DragCoefficient, DynamicStiffness, WaveKind,
};
use crate::numerics::V3;
use crate::system::bed::Bed;
use crate::system::model::{BodyInputs, BodyKind, LineInputs, PointInputs, PointKind};
use crate::system::parts::sections;
use crate::system::{SolvedSystem, SystemFile};

/// All of it.
#[must_use]
pub fn refusals(solved: &SolvedSystem, target: Target) -> Vec<Unsayable> {
    let file = &solved.file;
    let mut found = FoundRefusals::default();
    let name = target.name();
    surroundings(solved, target, &mut found);
    changes_in_time(solved, target, &mut found);
    materials(file, target, &mut found);
    for (name, point) in &file.points {
        free_point(name, point, target, &mut found);
    }
    bodies(file, target, &mut found);
    rods(file, target, &mut found);
    for line in &file.lines {
        clumps(line, target, &mut found);
        single_line(line, solved, target, &mut found);
    }
    let in_words = |one: Unsayable| Unsayable {
        what: format!("a file of {name} has no {}", one.what),
        ..one
    };
    found.0.into_iter().map(in_words).collect()
}

/// Ageing, current and bed.
fn surroundings(solved: &SolvedSystem, target: Target, found: &mut FoundRefusals) {
    let file = &solved.file;
    found.add(
        file.ageing.is_some(),
        "ageing",
        "lines that age (leave `[ageing]` out)",
    );
    found.add(
        file.current.is_some() && target == Target::MapPlusPlus,
        "current",
        "current",
    );
    found.add(
        file.current
            .as_ref()
            .is_some_and(|current| current.file.is_some())
            && current_by_file(file).is_none(),
        "current.file",
        "current by a table of times and places (its own current_profile_dynamic.txt and current_profile_4d.txt are carried over)",
    );
    found.add(
        target == Target::MapPlusPlus && is_grid(solved),
        "seabed.depth_file",
        "depths over a grid",
    );
    found.add(
        target == Target::MoorDyn && is_smooth(solved),
        "seabed.interpolation",
        "smooth bed between the depths of a grid; its bed is bilinear",
    );
    found.add(
        matches!(solved.network.bed, Some(Bed::Plane(..))),
        "seabed.slope_deg",
        "bed that slopes evenly (give the slope as a `depth_file` of four places)",
    );
}

/// Parts that nothing holds, payouts, points that slide, and waves.
fn changes_in_time(solved: &SolvedSystem, target: Target, found: &mut FoundRefusals) {
    let file = &solved.file;
    for part in &solved.dropped {
        found.add(
            true,
            "start.placement",
            &format!("part that nothing holds (`{part}`)"),
        );
    }
    for payout in &file.payouts {
        let key = format!("payouts.{}", payout.line);
        found.add(true, key, "payout of lines");
    }
    for sliding in &file.sliding_points {
        let key = format!("sliding_points.{}", sliding.point);
        found.add(true, key, "points that slide along lines");
    }
    for (number, waves) in file.waves.iter().enumerate() {
        found.add(
            waves.kind == WaveKind::Irregular && target == Target::MoorDyn,
            format!("waves[{number}]"),
            "waves from a spectrum",
        );
    }
}

fn materials(file: &SystemFile, target: Target, found: &mut FoundRefusals) {
    for (name, material) in &file.materials {
        let key = |key: &str| format!("materials.{name}.{key}");
        let drag = [&material.drag_normal, &material.drag_tangential];
        found.add(
            drag.iter()
                .any(|drag| matches!(drag, DragCoefficient::Named(_))),
            key("drag_normal"),
            "drag by a law of the Reynolds number",
        );
        found.add(
            material.attached_drag_width_m > 0.0,
            key("attached_drag_width_m"),
            "drag of attachments beside that of the line",
        );
        let by_table = material.strain.is_some() || material.creep_model != CreepModel::None;
        found.add(
            by_table && target == Target::MapPlusPlus,
            key("strain"),
            "stiffness by strain or time",
        );
        found.add(
            material.dynamic_stiffness != DynamicStiffness::None,
            key("dynamic_stiffness"),
            "stiffness by the past tension",
        );
    }
}

fn bodies(file: &SystemFile, target: Target, found: &mut FoundRefusals) {
    for (name, body) in &file.bodies {
        if matches!(body.kind, BodyKind::Free | BodyKind::Pinned) {
            turning_body(name, body, target, found);
        }
        found.add(
            target == Target::MapPlusPlus && body.kind == BodyKind::Pinned,
            format!("bodies.{name}.kind"),
            "pinned bodies",
        );
        found.add(
            body.pinned_to.is_some(),
            format!("bodies.{name}.pinned_to"),
            "bodies that are pinned to bodies",
        );
    }
}

fn rods(file: &SystemFile, target: Target, found: &mut FoundRefusals) {
    for (rod, inputs) in &file.rods {
        let key = |key: &str| format!("rods.{rod}.{key}");
        found.add(
            target == Target::MapPlusPlus && inputs.kind == BodyKind::Free,
            key("kind"),
            "free rods",
        );
        found.add(
            target == Target::MapPlusPlus && inputs.kind == BodyKind::Pinned,
            key("kind"),
            "pinned rods",
        );
        let to_rod = inputs.pinned_to.as_ref();
        found.add(
            to_rod.is_some_and(|to| file.rods.contains_key(to)),
            key("pinned_to"),
            "rods that are pinned to rods",
        );
        found.add(inputs.load_n != [0.0; 3], key("load_n"), "loads on rods");
    }
}

/// Whether the depths of the bed are over a grid.
fn is_grid(solved: &SolvedSystem) -> bool {
    matches!(solved.network.bed, Some(Bed::Grid(_)))
}

/// Whether a bed over a grid is smooth and not flat.
fn is_smooth(solved: &SolvedSystem) -> bool {
    let Some(Bed::Grid(grid)) = &solved.network.bed else {
        return false;
    };
    let [least, greatest] = grid.range();
    let bed = solved.file.seabed.as_ref();
    let is_smooth = bed.is_some_and(|bed| bed.interpolation == BedInterpolation::Smooth);
    is_smooth && least < greatest
}

/// What was found so far.
#[derive(Debug, Default)]
struct FoundRefusals(Vec<Unsayable>);

impl FoundRefusals {
    fn add(&mut self, is: bool, key: impl Into<String>, what: &str) {
        if is {
            self.0.push(Unsayable {
                key: key.into(),
                what: what.to_owned(),
            });
        }
    }
}

fn turning_body(name: &str, body: &BodyInputs, target: Target, found: &mut FoundRefusals) {
    if target == Target::MapPlusPlus {
        // The program that calls MAP++ knows the body.
        return;
    }
    loads_on_body(name, body, found);
    mass_of_body(name, body, found);
    members(name, body, found);
}

fn loads_on_body(name: &str, body: &BodyInputs, found: &mut FoundRefusals) {
    let key = |key: &str| format!("bodies.{name}.{key}");
    found.add(
        body.waterplane_stiffness.iter().any(|k| *k != 0.0),
        key("waterplane_stiffness"),
        "stiffness of a water-plane",
    );
    let files = [
        &body.radiation_file,
        &body.excitation_file,
        &body.drift_file,
        &body.response_file,
    ];
    found.add(
        files.iter().any(|file| file.is_some()),
        key("radiation_file"),
        "coefficients and responses of bodies from files",
    );
    found.add(
        !body.damping.is_empty(),
        key("damping"),
        "linear damping of bodies",
    );
    found.add(
        body.centre_of_added_mass_m.is_some()
            || body.centre_of_drag_m != [0.0; 3]
            || body.drag_length_m > 0.0,
        key("centre_of_added_mass_m"),
        "centres of added mass and of drag of a body apart from its origin",
    );
    let by_heading = body.wind_loads.len() + body.current_loads.len() + body.drift_loads.len();
    found.add(
        by_heading > 0,
        key("wind_loads"),
        "loads on bodies by heading",
    );
    found.add(
        body.load_n != [0.0; 3] || body.moment_n_m != [0.0; 3],
        key("load_n"),
        "loads on bodies",
    );
}

/// Centre of buoyancy, inertia, added mass and quadratic damping.
fn mass_of_body(name: &str, body: &BodyInputs, found: &mut FoundRefusals) {
    let key = |key: &str| format!("bodies.{name}.{key}");
    found.add(
        body.volume_m3 > 0.0 && body.centre_of_buoyancy_m != body.centre_of_gravity_m,
        key("centre_of_buoyancy_m"),
        "centre of buoyancy of a body apart from that of gravity",
    );
    let off_diagonal = body.inertia_kg_m2.get(3..).unwrap_or(&[]);
    found.add(
        off_diagonal.iter().any(|i| *i != 0.0),
        key("inertia_kg_m2"),
        "products of inertia",
    );
    found.add(
        body.added_mass.len() == 36
            || body
                .added_mass
                .get(3..)
                .is_some_and(|m| m.iter().any(|m| *m != 0.0)),
        key("added_mass"),
        "added mass besides that along the axes",
    );
    found.add(
        body.added_mass.iter().any(|m| *m != 0.0) && body.volume_m3 == 0.0,
        key("added_mass"),
        "added mass of a body without volume",
    );
    let quadratic = &body.quadratic_damping;
    found.add(
        quadratic.len() == 36
            || quadratic
                .get(..3)
                .is_some_and(|d| d.iter().any(|d| *d != 0.0)),
        key("quadratic_damping"),
        "quadratic damping besides that about the axes",
    );
}

fn members(name: &str, body: &BodyInputs, found: &mut FoundRefusals) {
    for (number, member) in body.members.iter().enumerate() {
        let cone = member.to_diameter_m.is_some_and(|d| d != member.diameter_m);
        let key = format!("bodies.{name}.members[{number}]");
        found.add(
            cone || member.drag_only || !member.repeat_at_deg.is_empty(),
            key.clone(),
            "members that are cones, have drag alone, or are repeated",
        );
        let differs = |other: Option<f64>, one: f64| other.is_some_and(|other| other != one);
        found.add(
            differs(member.to_drag_end, member.drag_end)
                || differs(member.to_added_mass_end, member.added_mass_end),
            key,
            "ends of a member with drag or added mass of their own",
        );
    }
}

/// Added mass of a free point that displaces nothing, coefficients that differ along its axes, and how it bears on the bed.
fn free_point(name: &str, point: &PointInputs, target: Target, found: &mut FoundRefusals) {
    let key = |key: &str| format!("points.{name}.{key}");
    found.add(
        point.bed_area_m2.is_some(),
        key("bed_area_m2"),
        "a point that bears on the bed over an area",
    );
    found.add(
        point.bottom_m > 0.0,
        key("bottom_m"),
        "a point whose bottom is below it",
    );
    found.add(
        point.breakout_n > 0.0,
        key("breakout_n"),
        "a point that the bed holds back",
    );
    if point.kind != PointKind::Free || target != Target::MoorDyn {
        return;
    }
    // Which of them are nothing, or the same along all axes, no density changes.
    let of = point.hydrodynamics(1.0);
    let displaces = point.displaced_m3(1.0) != 0.0 || point.wet_mass_kg.is_some();
    found.add(
        !displaces && of.added_mass != V3::zeros(),
        key("added_mass_kg"),
        "added mass of a point without volume",
    );
    let both = [
        ("drag_area_m2", &of.drag_area),
        ("added_mass_kg", &of.added_mass),
    ];
    for (name, value) in both {
        found.add(
            alike(value).is_none(),
            key(name),
            "a drag area or added mass of a point that differs along its axes",
        );
    }
}

/// Added mass of bodies in a line that displace nothing, and drag and added mass of bodies that are aligned with it; a file of MAP++ has
/// neither.
fn clumps(line: &LineInputs, target: Target, found: &mut FoundRefusals) {
    for (number, section) in line.sections.iter().enumerate() {
        let clump = section.clump().unwrap_or_default();
        let key = |key: &str| format!("lines.{}.sections.{}.{key}", line.name, number + 1);
        found.add(
            target == Target::MoorDyn
                && !clump.added_mass_kg.is_zero()
                && clump.mass_kg <= clump.wet_mass_kg,
            key("clump_added_mass_kg"),
            "added mass of a point without volume",
        );
        for (name, value) in [
            ("clump_drag_area_m2", &clump.drag_area_m2),
            ("clump_added_mass_kg", &clump.added_mass_kg),
        ] {
            found.add(
                target == Target::MoorDyn && value.alike().is_none(),
                key(name),
                "point with another drag or added mass along each axis",
            );
        }
        found.add(
            bears(&clump),
            key("clump_bottom_m"),
            "bearing area, bottom and breakout force of a point",
        );
        for (name, value) in [
            ("drag_area_normal_m2", clump.drag_area_normal_m2),
            ("drag_area_tangential_m2", clump.drag_area_tangential_m2),
            ("added_mass_normal_kg", clump.added_mass_normal_kg),
            ("added_mass_tangential_kg", clump.added_mass_tangential_kg),
        ] {
            found.add(
                target == Target::MoorDyn && value > 0.0,
                key(&format!("clump_{name}")),
                "drag or added mass of a point across and along its line",
            );
        }
    }
}

/// Whether a body says how it bears on the bed.
fn bears(clump: &Clump) -> bool {
    let bare = Clump::default();
    clump.bed_area_m2.is_some()
        || clump.bottom_m != bare.bottom_m
        || clump.breakout_n != bare.breakout_n
        || clump.breakout_distance_m != bare.breakout_distance_m
}

fn single_line(
    line: &LineInputs,
    solved: &SolvedSystem,
    target: Target,
    found: &mut FoundRefusals,
) {
    line_in_water(line, solved, target, found);
    line_friction(line, solved, target, found);
    clamped_ends(line, solved, target, found);
    let releases = [
        line.release_a_s,
        line.release_b_s,
        line.release_a_n,
        line.release_b_n,
    ];
    found.add(
        target == Target::MapPlusPlus && releases.iter().any(Option::is_some),
        format!("lines.{}.release_a_s", line.name),
        "ends that are let go",
    );
}

/// Where a line breaks, and whether water and bed act on it as on the others.
fn line_in_water(
    line: &LineInputs,
    solved: &SolvedSystem,
    target: Target,
    found: &mut FoundRefusals,
) {
    let key = |key: &str| format!("lines.{}.{key}", line.name);
    let breaks = [line.break_s, line.break_n].iter().any(Option::is_some);
    found.add(
        breaks,
        key("break_at_m"),
        "lines that break between their ends",
    );
    let flows = solved.file.current.is_some() || !solved.file.waves.is_empty();
    found.add(
        line.still_water && flows && target == Target::MoorDyn,
        key("still_water"),
        "lines in still water beside others in a current or waves",
    );
    found.add(
        !line.bed_contact && solved.file.seabed.is_some() && target == Target::MoorDyn,
        key("bed_contact"),
        "lines that hang through the bed",
    );
}

fn line_friction(
    line: &LineInputs,
    solved: &SolvedSystem,
    target: Target,
    found: &mut FoundRefusals,
) {
    let key = |key: &str| format!("lines.{}.{key}", line.name);
    let common = common_friction(&solved.file);
    found.add(
        target == Target::MoorDyn && line.friction.is_some_and(|mu| mu != common),
        key("friction"),
        "friction of a single line",
    );
    // MAP++ computes lines at rest, in the vertical planes of their ends.
    let [along, across] = solved.file.friction_under(line);
    found.add(
        target == Target::MoorDyn && along != across,
        match line.friction_lateral {
            Some(_) => key("friction_lateral"),
            None => "seabed.friction_lateral".to_owned(),
        },
        "friction across lines that is not that along them",
    );
}

/// Ends that are clamped, or not clamped, otherwise than a rod holds them.
fn clamped_ends(
    line: &LineInputs,
    solved: &SolvedSystem,
    target: Target,
    found: &mut FoundRefusals,
) {
    let key = |key: &str| format!("lines.{}.{key}", line.name);
    let clamps = [
        (
            line.clamp_a_elevation_deg,
            &line.from,
            "clamp_a_elevation_deg",
        ),
        (
            line.clamp_b_elevation_deg,
            &line.to,
            "clamp_b_elevation_deg",
        ),
    ];
    let bends = sections(line).iter().any(|section| {
        let material = solved.file.materials.get(&section.material);
        material.is_some_and(|material| material.ei_n_m2 > 0.0)
    });
    for (end, (clamp, at, name)) in clamps.into_iter().enumerate() {
        let axis = rod_axis(solved, at);
        let is_of_rod = match (clamp, axis) {
            (None, axis) => axis.is_none() || !bends,
            (Some(_), None) => is_on_body(solved, at) || line.repeat_at_deg.is_empty(),
            (Some(elevation), Some(outwards)) => {
                let azimuth = [line.clamp_a_azimuth_deg, line.clamp_b_azimuth_deg][end];
                let (up, turn) = (elevation.to_radians(), azimuth.to_radians());
                let along = V3::new(up.cos() * turn.cos(), up.cos() * turn.sin(), up.sin());
                let sign = [1.0, -1.0][end];
                (along - outwards * sign).norm() < SAME
            }
        };
        let what = match (clamp, axis) {
            (None, _) => "hinges of lines that bend at rods",
            (Some(_), None) => "clamped ends of lines that are repeated",
            (Some(_), Some(_)) => "clamped ends at rods in another direction than that of the rod",
        };
        found.add(!is_of_rod && target == Target::MoorDyn, key(name), what);
    }
}

/// Whether a point is on a body.
fn is_on_body(solved: &SolvedSystem, name: &str) -> bool {
    let point = solved.file.points.get(name);
    point.is_some_and(|point| point.kind == PointKind::Body)
}

/// Directions that differ by less are the same \[rad\].
const SAME: f64 = 1e-6;

/// The direction out of the end of a rod that a point is, where the file puts the rod.
fn rod_axis(solved: &SolvedSystem, point: &str) -> Option<V3> {
    let mut rods = solved.file.rods.keys();
    rods.find_map(|name| {
        let body = &solved.network.bodies[solved.network.body(name)?];
        // The body of a rod has its x axis from end A to end B.
        let axis = body.pose.arm(&V3::x());
        if point == format!("{name}-b") {
            return Some(axis);
        }
        (point == format!("{name}-a")).then_some(-axis)
    })
}
