//! The effects of a scene, and a case without each of them.

use crate::case::{
    Case, CreepModel, DragCoefficient, DynamicStiffness, EndKind, Material, Method, OneOrMany,
    StiffnessScope, WaterSurface, WaveKind,
};

/// An effect of a scene that can be left out, or a part of it that can be changed.
#[derive(Debug, Clone, Copy)]
pub struct ScenePart {
    /// What it is: "drag of the line".
    pub name: &'static str,
    /// What is done to the case, by its keys.
    pub how: &'static str,
    /// Does so; leaves a case as it is that does not have the effect.
    pub leave_out: fn(&mut Case),
}

/// Effects that cannot be left out, and why.
pub const KEPT: [(&str, &str); 4] = [
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

/// How many times stiffer the line is that stands for one that does not stretch.
const STIFFER: f64 = 10.0;

/// All effects that can be left out, in the order of the table.
pub const SCENE_PARTS: [ScenePart; 21] = [
    part(
        "drag of the line",
        "materials.*.drag_normal = drag_tangential = 0",
        without_line_drag,
    ),
    part(
        "drag along the line",
        "materials.*.drag_tangential = 0",
        without_tangential_drag,
    ),
    part(
        "drag of bodies",
        "drag areas of payload, clumps, floats, modules, traveller = 0",
        without_body_drag,
    ),
    part(
        "added mass of the line",
        "materials.*.added_mass_normal = added_mass_tangential = 0",
        |case| {
            each_material(case, |m| {
                (m.added_mass_normal, m.added_mass_tangential) = (0.0, 0.0);
            });
        },
    ),
    part(
        "added mass of bodies",
        "added masses of payload, clumps, floats = 0",
        without_body_added_mass,
    ),
    part("bending stiffness", "materials.*.ei_n_m2 = 0", |case| {
        each_material(case, |m| m.ei_n_m2 = 0.0);
    }),
    part(
        "axial damping",
        "materials.*.axial_damping_n_s, axial_damping_ratio left out",
        |case| {
            each_material(case, |m| {
                (m.axial_damping_n_s, m.axial_damping_ratio) = (None, None);
            });
        },
    ),
    part(
        "mass damping",
        "materials.*.mass_damping_per_s = 0",
        |case| each_material(case, |m| m.mass_damping_per_s = 0.0),
    ),
    part(
        "elasticity",
        "axial stiffness x 10 (tensions of a tension-strain table x 10)",
        |case| each_material(case, stiffen),
    ),
    part(
        "dynamic stiffness",
        "materials.*.dynamic_stiffness = none",
        |case| each_material(case, without_dynamic_stiffness),
    ),
    part("creep", "materials.*.creep_model = none", |case| {
        each_material(case, without_creep);
    }),
    part(
        "bed friction",
        "seabed.friction, friction_lateral left out",
        without_friction,
    ),
    part("bed damping", "seabed.damping_n_s_per_m3 = 0", |case| {
        case.seabed
            .iter_mut()
            .for_each(|bed| bed.damping_n_s_per_m3 = 0.0);
    }),
    part("current", "current left out", |case| case.current = None),
    part("waves", "height of the waves = 0", without_waves),
    part(
        "water surface",
        "environment.water_surface = ignored",
        |case| {
            case.environment.water_surface = WaterSurface::Ignored;
        },
    ),
    part(
        "motion of the ends",
        "ends.*.kind = fixed where it is moving",
        without_end_motion,
    ),
    part(
        "rotation of the payload",
        "payload.rotation left out: the payload is a point",
        |case| {
            case.payload
                .iter_mut()
                .for_each(|payload| payload.rotation = None);
        },
    ),
    part("inertia", "solver.method = quasi", without_inertia),
    part("mesh halved", "line.*.segments halved", |case| {
        case.line
            .iter_mut()
            .for_each(|section| section.segments = section.segments.div_ceil(2));
    }),
    part("mesh doubled", "line.*.segments doubled", |case| {
        case.line
            .iter_mut()
            .for_each(|section| section.segments *= 2);
    }),
];

const fn part(name: &'static str, how: &'static str, leave_out: fn(&mut Case)) -> ScenePart {
    ScenePart {
        name,
        how,
        leave_out,
    }
}

fn each_material(case: &mut Case, change: impl Fn(&mut Material)) {
    case.materials.values_mut().for_each(change);
}

fn without_line_drag(case: &mut Case) {
    without_tangential_drag(case);
    each_material(case, |material| {
        material.drag_normal = DragCoefficient::Constant(0.0);
    });
}

fn without_tangential_drag(case: &mut Case) {
    each_material(case, |material| {
        material.drag_tangential = DragCoefficient::Constant(0.0);
    });
}

/// Zero where something else is given, so that a case without it stays as it is.
fn clear(values: &mut OneOrMany) {
    let is_zero = match values {
        OneOrMany::One(value) => *value == 0.0,
        OneOrMany::Many(values) => values.iter().all(|value| *value == 0.0),
    };
    if !is_zero {
        *values = OneOrMany::One(0.0);
    }
}

fn without_body_drag(case: &mut Case) {
    if let Some(payload) = &mut case.payload {
        match &mut payload.drag_area_m2 {
            Some(area) => clear(area),
            // The drag area of its shape.
            None if payload.shape.is_some() => payload.drag_area_m2 = Some(OneOrMany::One(0.0)),
            None => {}
        }
    }
    case.clumps
        .iter_mut()
        .for_each(|clump| clear(&mut clump.drag_area_m2));
    case.traveller
        .iter_mut()
        .for_each(|body| clear(&mut body.drag_area_m2));
    case.floats
        .iter_mut()
        .for_each(|floats| floats.drag_area_m2 = 0.0);
    case.modules
        .iter_mut()
        .for_each(|modules| modules.drag_normal = 0.0);
}

fn without_body_added_mass(case: &mut Case) {
    if let Some(payload) = &mut case.payload {
        match &mut payload.added_mass_kg {
            Some(mass) => clear(mass),
            None if payload.shape.is_some() => payload.added_mass_kg = Some(OneOrMany::One(0.0)),
            None => {}
        }
    }
    case.clumps
        .iter_mut()
        .for_each(|clump| clear(&mut clump.added_mass_kg));
    case.floats
        .iter_mut()
        .for_each(|floats| floats.added_mass_kg = 0.0);
}

fn stiffen(material: &mut Material) {
    material.ea_n = material.ea_n.map(|stiffness| STIFFER * stiffness);
    let tensions = material.tension_n.as_mut();
    tensions
        .into_iter()
        .flatten()
        .for_each(|tension| *tension *= STIFFER);
    for stiffness in [&mut material.dynamic_ea_n, &mut material.working_curve_ea_n] {
        *stiffness = stiffness.map(|stiffness| STIFFER * stiffness);
    }
    material.past_tension_n *= STIFFER;
}

/// The rope with its static curve alone: of a Syrope rope the original one.
fn without_creep(material: &mut Material) {
    if material.creep_model == CreepModel::None {
        return;
    }
    let bare = Material::default();
    *material = Material {
        creep_model: bare.creep_model,
        dynamic_ea_n: bare.dynamic_ea_n,
        dynamic_ea_per_tension: bare.dynamic_ea_per_tension,
        slow_damping_n_s: bare.slow_damping_n_s,
        fast_damping_n_s: bare.fast_damping_n_s,
        working_curve: bare.working_curve,
        working_curve_shape: bare.working_curve_shape,
        permanent_strain_ratio: bare.permanent_strain_ratio,
        working_curve_ea_n: bare.working_curve_ea_n,
        past_tension_n: bare.past_tension_n,
        initial_mean_tension_n: bare.initial_mean_tension_n,
        ..material.clone()
    };
}

fn without_dynamic_stiffness(material: &mut Material) {
    if material.dynamic_stiffness != DynamicStiffness::None {
        material.dynamic_stiffness = DynamicStiffness::None;
        (material.dynamic_alpha, material.mean_window_s) = (None, None);
        (material.dynamic_beta, material.dynamic_gamma) = (0.0, 0.0);
        material.stiffness_scope = StiffnessScope::Segment;
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
    let Some(waves) = case.waves.as_mut() else {
        return;
    };
    match waves.kind {
        WaveKind::Regular => waves.height_m = Some(0.0),
        WaveKind::Irregular => waves.significant_height_m = Some(0.0),
        WaveKind::Components => waves.heights_m.iter_mut().for_each(|all| all.fill(0.0)),
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{self, shipped::SHIPPED, write};

    /// What is left of every shipped case is the case without it, or refused with a reason; leaving out twice changes nothing more.
    #[test]
    fn effects_of_shipped_cases_are_left_out() {
        let mut seen = [0; SCENE_PARTS.len()];
        for (path, text) in SHIPPED {
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/");
            let case = case::parse(text, &format!("{folder}{path}")).unwrap();
            for (place, part) in SCENE_PARTS.iter().enumerate() {
                let mut without = case.clone();
                (part.leave_out)(&mut without);
                if without == case {
                    continue;
                }
                seen[place] += 1;
                let again = case::parse(&write(&without), path).is_ok();
                if again && !["elasticity", "mesh halved", "mesh doubled"].contains(&part.name) {
                    let mut twice = without.clone();
                    (part.leave_out)(&mut twice);
                    assert!(twice == without, "{path}: {}", part.name);
                }
            }
        }
        for (count, part) in seen.iter().zip(SCENE_PARTS) {
            // No line that is shipped creeps or is damped by its mass.
            let unused = ["creep", "mass damping"].contains(&part.name);
            assert!(*count > 0 || unused, "{}", part.name);
        }
    }

    #[test]
    fn a_rope_that_creeps_is_left_with_its_curve() {
        let mut rope = Material::new(0.1, 8.0, 1e8);
        let bare = rope.clone();
        rope.creep_model = CreepModel::Viscoelastic;
        (rope.dynamic_ea_n, rope.slow_damping_n_s) = (Some(3e8), Some(1e9));
        let mut stiff = rope.clone();
        stiffen(&mut stiff);
        assert_eq!((stiff.ea_n, stiff.dynamic_ea_n), (Some(1e9), Some(3e9)));
        without_creep(&mut rope);
        assert!(rope == bare);
    }
}
