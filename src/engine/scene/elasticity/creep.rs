//! The law of a material that creeps.

use crate::case::{CreepModel, Material, WorkingCurveShape};
use crate::physics::rope::working_curve::{CurveEnd, CurveShape, MeanCurve, WorkingCurve};
use crate::physics::rope::{CreepingRope, StaticElasticity};
use crate::scene::SceneError;

/// Share of the breaking load within which the bound of the stiffness holds.
const WORKING: f64 = 0.5;
/// The same where no breaking load is given: the tension of a static stiffness at this strain.
const WORKING_STRAIN: f64 = 0.05;

/// The law of a material whose slow elasticity is given.
///
/// # Errors
/// [`SceneError`] where a number is missing.
pub(super) fn creeping_rope(
    name: &str,
    material: &Material,
    slow: StaticElasticity,
) -> Result<CreepingRope, SceneError> {
    let needed = |value: Option<f64>, key: &str| {
        value.ok_or_else(|| SceneError::Missing {
            key: format!("materials.{name}.{key}"),
            why: "a rope that creeps goes with it",
        })
    };
    let usual = match &slow {
        StaticElasticity::Linear(ea) => ea * WORKING_STRAIN,
        StaticElasticity::TensionTable(_) => material
            .tension_n
            .iter()
            .flatten()
            .copied()
            .fold(0.0, f64::max),
    };
    let curve = match (material.creep_model, slow) {
        (CreepModel::Syrope, StaticElasticity::TensionTable(table)) => {
            let end = match (material.permanent_strain_ratio, material.working_curve_ea_n) {
                (Some(ratio), _) => CurveEnd::Ratio(ratio),
                (None, ea) => CurveEnd::Stiffness(needed(ea, "working_curve_ea_n")?),
            };
            let k = || needed(material.working_curve_shape, "working_curve_shape");
            let shape = match material.working_curve {
                WorkingCurveShape::Linear => CurveShape::Linear,
                WorkingCurveShape::Quadratic => CurveShape::Quadratic(k()?),
                WorkingCurveShape::Exponential => CurveShape::Exponential(k()?),
            };
            MeanCurve::Syrope(table, WorkingCurve { shape, end })
        }
        (CreepModel::Syrope, StaticElasticity::Linear(_)) => {
            return Err(SceneError::Missing {
                key: format!("materials.{name}.strain"),
                why: "a Syrope rope needs its original curve as a table",
            });
        }
        (_, StaticElasticity::Linear(ea)) => MeanCurve::Linear(ea),
        (_, StaticElasticity::TensionTable(table)) => MeanCurve::Table(table),
    };
    let peak = curve.strain_at(material.past_tension_n, 0.0);
    Ok(CreepingRope {
        dynamic: needed(material.dynamic_ea_n, "dynamic_ea_n")?,
        per_tension: material.dynamic_ea_per_tension,
        slow: needed(material.slow_damping_n_s, "slow_damping_n_s")?,
        fast: material.fast_damping_n_s,
        peak,
        bound: material.break_load_n.map_or(usual, |load| WORKING * load),
        initial_mean: material.initial_mean_tension_n,
        curve,
    })
}
