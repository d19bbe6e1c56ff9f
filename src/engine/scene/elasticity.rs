//! Elasticity of a material: constant EA, or a nonlinear law.

mod creep;

use super::error::SceneError;
use crate::case::{CreepModel, DynamicStiffness, Material, StiffnessScope};
use crate::physics::rope::{
    CreepingRope, FibreRope, StaticElasticity, StiffnessForm, TensionLaw, TensionTable,
};

/// The elasticity of the segments of one section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Elasticity {
    /// Upper bound of the slope of tension over strain \[N\].
    pub(super) steepest: f64,
    /// Stiffness that axial damping, given as a ratio, refers to \[N\].
    pub(super) ea: f64,
    /// Number of its law among those of the line; absent: tension is `ea` times strain.
    pub(super) law: Option<u16>,
    /// Damping of a rope that creeps in fast motion \[N s\].
    pub(super) creep_damping: Option<f64>,
}

impl Elasticity {
    /// Tension that is a stiffness \[N\] times strain.
    pub(super) const fn linear(ea: f64) -> Self {
        Self {
            steepest: ea,
            ea,
            law: None,
            creep_damping: None,
        }
    }
}

/// The elasticity of a material; a nonlinear law is added to those of the line.
///
/// # Errors
/// [`SceneError`] where the material has neither a stiffness nor a table.
pub(super) fn elasticity(
    name: &str,
    material: &Material,
    laws: &mut Vec<TensionLaw>,
) -> Result<Elasticity, SceneError> {
    let slow = match (table(name, material)?, material.ea_n) {
        (Some(table), _) => StaticElasticity::TensionTable(table),
        (None, Some(ea)) => StaticElasticity::Linear(ea),
        (None, None) => {
            return Err(SceneError::Missing {
                key: format!("materials.{name}.ea_n"),
                why: "a material must have a stiffness, or a table of strains and tensions",
            });
        }
    };
    let ea = match &slow {
        StaticElasticity::Linear(ea) => *ea,
        StaticElasticity::TensionTable(table) => table.representative_stiffness(),
    };
    if material.creep_model != CreepModel::None {
        let rope = creep::creeping_rope(name, material, slow)?;
        return Ok(with_law(TensionLaw::Creeping(rope), ea, laws));
    }
    let reading = match (material.dynamic_stiffness, slow) {
        (DynamicStiffness::None, StaticElasticity::Linear(ea)) => {
            return Ok(Elasticity::linear(ea));
        }
        (DynamicStiffness::None, StaticElasticity::TensionTable(table)) => {
            return Ok(with_law(TensionLaw::TensionTable(table), ea, laws));
        }
        (DynamicStiffness::Secant, _) => StiffnessForm::Secant,
        (DynamicStiffness::AboutTheMean, slow) => StiffnessForm::AboutTheMean(slow),
    };
    let law = TensionLaw::FibreRope(dynamic(name, material, reading)?);
    Ok(with_law(law, ea, laws))
}

/// Elasticity by a law, which is added to those of the line.
fn with_law(law: TensionLaw, ea: f64, laws: &mut Vec<TensionLaw>) -> Elasticity {
    Elasticity {
        steepest: law.max_stiffness(),
        ea,
        creep_damping: law.creeping().map(CreepingRope::damping),
        law: Some(number(law, laws)),
    }
}

/// The dynamic stiffness of a material.
fn dynamic(
    name: &str,
    material: &Material,
    reading: StiffnessForm,
) -> Result<FibreRope, SceneError> {
    let needed = |value: Option<f64>, key: &str| {
        value.ok_or_else(|| SceneError::Missing {
            key: format!("materials.{name}.{key}"),
            why: "dynamic stiffness goes with it",
        })
    };
    Ok(FibreRope {
        alpha: needed(material.dynamic_alpha, "dynamic_alpha")?,
        beta: material.dynamic_beta,
        gamma: material.dynamic_gamma,
        strength: needed(material.break_load_n, "break_load_n")?,
        reading,
        window: material.mean_window_s.unwrap_or(f64::INFINITY),
        shared: material.stiffness_scope == StiffnessScope::Rope,
    })
}

/// The tension-strain table of a material, if it has one.
fn table(name: &str, material: &Material) -> Result<Option<TensionTable>, SceneError> {
    if material.strain.is_none() {
        return Ok(None);
    }
    let table = material
        .tension_table()
        .ok_or_else(|| SceneError::Impossible {
            key: format!("materials.{name}.strain"),
            why: "strains and tensions must be equally many, and rise from 0",
        })?;
    Ok(Some(table))
}

/// The number of a law among those of the line, to which it is added where no section had it before.
fn number(law: TensionLaw, laws: &mut Vec<TensionLaw>) -> u16 {
    let place = laws.iter().position(|known| *known == law);
    let place = place.unwrap_or_else(|| {
        laws.push(law);
        laws.len() - 1
    });
    u16::try_from(place).unwrap_or(u16::MAX)
}
