//! Effects of what lines are made of.

use std::collections::BTreeMap;

use super::ScenePart;
use crate::case::{CreepModel, DragCoefficient, DynamicStiffness, Material, StiffnessScope};

/// A scene with materials.
pub(super) trait HasMaterials {
    /// Its materials, by name.
    fn materials(&mut self) -> &mut BTreeMap<String, Material>;
}

/// How many times stiffer the line is that stands for one that does not stretch.
const STIFFER: f64 = 10.0;

/// The effects of the materials of a scene.
pub(super) fn parts<K: HasMaterials>() -> [ScenePart<K>; 9] {
    let part = ScenePart::new;
    [
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
            "added mass of the line",
            "materials.*.added_mass_normal = added_mass_tangential = 0",
            |scene| {
                each_material(scene, |m| {
                    (m.added_mass_normal, m.added_mass_tangential) = (0.0, 0.0);
                });
            },
        ),
        part("bending stiffness", "materials.*.ei_n_m2 = 0", |scene| {
            each_material(scene, |m| m.ei_n_m2 = 0.0);
        }),
        part(
            "axial damping",
            "materials.*.axial_damping_n_s, axial_damping_ratio left out",
            |scene| {
                each_material(scene, |m| {
                    (m.axial_damping_n_s, m.axial_damping_ratio) = (None, None);
                });
            },
        ),
        part(
            "mass damping",
            "materials.*.mass_damping_per_s = 0",
            |scene| each_material(scene, |m| m.mass_damping_per_s = 0.0),
        ),
        part(
            "elasticity",
            "axial stiffness x 10 (tensions of a tension-strain table x 10)",
            |scene| each_material(scene, stiffen),
        ),
        part(
            "dynamic stiffness",
            "materials.*.dynamic_stiffness = none",
            |scene| each_material(scene, without_dynamic_stiffness),
        ),
        part("creep", "materials.*.creep_model = none", |scene| {
            each_material(scene, without_creep);
        }),
    ]
}

fn each_material(scene: &mut impl HasMaterials, change: impl Fn(&mut Material)) {
    scene.materials().values_mut().for_each(change);
}

fn without_line_drag(scene: &mut impl HasMaterials) {
    without_tangential_drag(scene);
    each_material(scene, |material| {
        material.drag_normal = DragCoefficient::Constant(0.0);
        material.attached_drag_width_m = 0.0;
    });
}

fn without_tangential_drag(scene: &mut impl HasMaterials) {
    each_material(scene, |material| {
        material.drag_tangential = DragCoefficient::Constant(0.0);
    });
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

#[cfg(test)]
mod tests {
    use super::*;

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
