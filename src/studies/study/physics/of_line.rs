//! The effects of a case of a line.

use std::collections::BTreeMap;

use super::of_material::{self, HasMaterials};
use super::{HasEffects, ScenePart};
use crate::case::{
    Case, Clump, EndKind, Floats, Material, Method, Modules, OneOrMany, PayloadShape, StudyPoint,
    Subject, WaterSurface, WaveKind, Waves, channels, kind, write,
};

impl HasMaterials for Case {
    fn materials(&mut self) -> &mut BTreeMap<String, Material> {
        &mut self.materials
    }
}

impl HasEffects for Case {
    const KEPT: &'static [(&'static str, &'static str)] = &[
        (
            "weight and buoyancy",
            "they hold the line in its shape; without them nothing is left to compute",
        ),
        (
            "elasticity",
            "segments have a finite stiffness; the line with ten times the stiffness stands for one that does not stretch",
        ),
        (
            "sea bed",
            "without it another line is computed; its friction and damping are left out one by one",
        ),
        (
            "bodies on the line and at its end",
            "their weight is a load of the case; their drag, added mass and rotation are left out one by one",
        ),
    ];

    fn parts() -> Vec<ScenePart<Self>> {
        [&of_material::parts()[..], &PARTS].concat()
    }

    fn forget_what_it_says_of_itself(&mut self) {
        let case = self;
        case.marks.clear();
        case.trial.clear();
        for curve in &mut case.published_curve {
            curve.points_file = None;
        }
        // Channels that the case does not have any more have no published values.
        let channels = channels(case);
        let is_there = |subject: &Subject| match subject {
            Subject::Channel(id) => channels.iter().any(|channel| channel.id == *id),
            _ => true,
        };
        case.published.retain(|row| is_there(&row.channel));
        case.trend.retain(|row| is_there(&row.channel));
        case.published_curve
            .retain(|row| channels.iter().any(|channel| channel.id == row.channel));
        without_idle_studies(case);
    }
}

const PARTS: [ScenePart<Case>; 12] = [
    ScenePart::new(
        "drag of bodies",
        "drag areas of payload, clumps, floats, modules, traveller = 0",
        without_body_drag,
    ),
    ScenePart::new(
        "added mass of bodies",
        "added masses of payload, clumps, floats = 0",
        without_body_added_mass,
    ),
    ScenePart::new(
        "bed friction",
        "seabed.friction, friction_lateral left out",
        without_friction,
    ),
    ScenePart::new("bed damping", "seabed.damping_n_s_per_m3 = 0", |case| {
        case.seabed
            .iter_mut()
            .for_each(|bed| bed.damping_n_s_per_m3 = 0.0);
    }),
    ScenePart::new("current", "current left out", |case| case.current = None),
    ScenePart::new("waves", "height of the waves = 0", without_waves),
    ScenePart::new(
        "water surface",
        "environment.water_surface = ignored",
        |case| {
            case.environment.water_surface = WaterSurface::Ignored;
        },
    ),
    ScenePart::new(
        "motion of the ends",
        "ends.*.kind = fixed where it is moving",
        without_end_motion,
    ),
    ScenePart::new(
        "rotation of the payload",
        "payload.rotation left out: the payload is a point",
        |case| {
            case.payload
                .iter_mut()
                .for_each(|payload| payload.rotation = None);
        },
    ),
    ScenePart::new("inertia", "solver.method = quasi", without_inertia),
    ScenePart::new("mesh halved", "line.*.segments halved", |case| {
        case.line
            .iter_mut()
            .for_each(|section| section.segments = section.segments.div_ceil(2));
    }),
    ScenePart::new("mesh doubled", "line.*.segments doubled", |case| {
        case.line
            .iter_mut()
            .for_each(|section| section.segments *= 2);
    }),
];

/// Gives waves no height.
pub(super) fn flatten(waves: &mut Waves) {
    match waves.kind {
        WaveKind::Regular => waves.height_m = Some(0.0),
        WaveKind::Irregular => waves.significant_height_m = Some(0.0),
        WaveKind::Components => waves.heights_m.iter_mut().for_each(|all| all.fill(0.0)),
    }
}

/// Zero where something else is given, so that a case without it stays as it is.
pub(super) fn clear(values: &mut OneOrMany) {
    if !values.is_zero() {
        *values = OneOrMany::One(0.0);
    }
}

/// Sets what is given, or follows from a shape, to nothing.
pub(super) fn clear_given(value: &mut Option<OneOrMany>, shape: Option<&PayloadShape>) {
    match value {
        Some(value) => clear(value),
        None if shape.is_some() => *value = Some(OneOrMany::One(0.0)),
        None => {}
    }
}

fn without_body_drag(case: &mut Case) {
    if let Some(payload) = &mut case.payload {
        clear_given(&mut payload.drag_area_m2, payload.shape.as_ref());
    }
    case.traveller
        .iter_mut()
        .for_each(|body| clear(&mut body.drag_area_m2));
    without_drag_on_line(&mut case.clumps, &mut case.floats, &mut case.modules);
}

/// Leaves out the drag of what is attached to a line.
pub(super) fn without_drag_on_line(
    clumps: &mut [Clump],
    floats: &mut [Floats],
    modules: &mut [Modules],
) {
    for clump in clumps {
        clear(&mut clump.drag_area_m2);
        (clump.drag_area_normal_m2, clump.drag_area_tangential_m2) = (0.0, 0.0);
    }
    for floats in floats {
        (floats.drag_area_m2, floats.drag_area_tangential_m2) = (0.0, 0.0);
    }
    for modules in modules {
        modules.drag_normal = 0.0;
        modules.drag_tangential = modules.drag_tangential.map(|_| 0.0);
    }
}

fn without_body_added_mass(case: &mut Case) {
    if let Some(payload) = &mut case.payload {
        clear_given(&mut payload.added_mass_kg, payload.shape.as_ref());
    }
    without_added_mass_on_line(&mut case.clumps, &mut case.floats);
}

/// Leaves out the added mass of what is attached to a line.
pub(super) fn without_added_mass_on_line(clumps: &mut [Clump], floats: &mut [Floats]) {
    for clump in clumps {
        clear(&mut clump.added_mass_kg);
        (clump.added_mass_normal_kg, clump.added_mass_tangential_kg) = (0.0, 0.0);
    }
    for floats in floats {
        floats.added_mass_kg = 0.0;
    }
}

fn without_friction(case: &mut Case) {
    let Some(bed) = case
        .seabed
        .as_mut()
        .filter(|bed| bed.friction.is_some_and(|mu| mu > 0.0))
    else {
        return;
    };
    (
        bed.friction,
        bed.friction_lateral,
        bed.grip_stiffness_n_per_m3,
    ) = (None, None, None);
    let level = crate::case::Seabed::default();
    (bed.friction_law, bed.slip_speed_m_per_s) = (level.friction_law, level.slip_speed_m_per_s);
}

/// Waves of no height move neither water nor vessels.
fn without_waves(case: &mut Case) {
    case.waves.iter_mut().for_each(flatten);
}

fn without_end_motion(case: &mut Case) {
    for end in [&mut case.ends.a, &mut case.ends.b] {
        if end.kind == EndKind::Moving {
            end.kind = EndKind::Fixed;
        }
    }
}

fn without_inertia(case: &mut Case) {
    if matches!(
        case.solver.method,
        Method::Alpha | Method::Rk4 | Method::Auto
    ) {
        case.solver.method = Method::Quasi;
    }
}

/// Leaves out the studies of keys that went with the effect, and what is published at their points.
fn without_idle_studies(case: &mut Case) {
    if case.study.is_empty() {
        return;
    }
    let rows = kind::rows::<Case>(&write(case));
    let has = |key: &str| {
        rows.iter()
            .any(|row| row.path == key && !row.value.is_empty())
    };
    case.study.retain(|study| has(&study.key));
    let known = |at: &Option<StudyPoint>| {
        let mut studies = case.study.iter();
        at.as_ref()
            .is_none_or(|at| studies.any(|study| study.name == at.study))
    };
    case.published
        .retain(|row| known(&row.at) && known(&row.change_from) && known(&row.ratio_to));
    case.published_curve.retain(|row| known(&row.at));
    case.trend
        .retain(|row| case.study.iter().any(|study| study.name == row.study));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{self, shipped::SHIPPED, write};

    /// What is left of every shipped case is the case without it, or refused with a reason; leaving out twice changes nothing more.
    #[test]
    fn effects_of_shipped_cases_are_left_out() {
        let parts = Case::parts();
        let mut seen = vec![0; parts.len()];
        for (path, text) in SHIPPED {
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/");
            let case = case::parse(text, &format!("{folder}{path}")).unwrap();
            for (place, part) in parts.iter().enumerate() {
                let mut without = case.clone();
                (part.leave_out)(&mut without);
                if without == case {
                    continue;
                }
                seen[place] += 1;
                let again = case::parse(&write(&without), path).is_ok();
                if again
                    && !["elasticity", "mesh halved", "mesh doubled"].contains(&part.effect.name)
                {
                    let mut twice = without.clone();
                    (part.leave_out)(&mut twice);
                    assert!(twice == without, "{path}: {}", part.effect.name);
                }
            }
        }
        for (count, part) in seen.iter().zip(&parts) {
            // No line that is shipped creeps or is damped by its mass.
            let unused = ["creep", "mass damping"].contains(&part.effect.name);
            assert!(*count > 0 || unused, "{}", part.effect.name);
        }
    }
}
