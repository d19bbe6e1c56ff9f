//! The design of a section: geometry, weight, stiffness, strength.

use super::bending::{BendingStiffness, bending};
use super::lay_out::{LayoutError, LayoutKey, lay_out};
use super::layout::SectionLayout;
use super::model::{Core, CrossSection};
use super::stiffness::{EndRotation, StiffnessMatrix, matrix};
use super::strength::{Strength, strength};
use super::weight::{CableWeight, weight};
use crate::case::Material;

/// The design of a section.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// The keys of its file.
    pub section: CrossSection,
    /// Geometry.
    pub layout: SectionLayout,
    /// Weight.
    pub weight: CableWeight,
    /// Tension and torsion with a rigid core.
    pub rigid: StiffnessMatrix,
    /// Tension and torsion with an incompressible core.
    pub incompressible: StiffnessMatrix,
    /// Bending.
    pub bending: BendingStiffness,
    /// Contributions of the sheaths to EA \[N\] and GJ \[N m²\], which eqs. (16)-(17) neglect.
    pub sheaths: (f64, f64),
    /// Strength; absent where no load-carrying unit has a known strength.
    pub strength: Option<Strength>,
}

impl Design {
    /// The stiffness matrix of one core model.
    #[must_use]
    pub fn matrix(&self, core: Core) -> &StiffnessMatrix {
        match core {
            Core::Rigid => &self.rigid,
            Core::Incompressible => &self.incompressible,
        }
    }

    /// Axial stiffness of the line material: fixed ends, the core model of the file \[N\].
    #[must_use]
    pub fn ea(&self) -> f64 {
        self.matrix(self.section.about.core).ea(EndRotation::Fixed)
    }

    /// The section as a material of a line case, its bending stiffness that of full slip, without drag,
    /// which depends on the flow.
    #[must_use]
    pub fn material(&self) -> Material {
        Material {
            wet_weight_kg_per_m: Some(self.weight.in_water),
            ei_n_m2: self.bending.full_slip(),
            break_load_n: self.strength.as_ref().map(|s| s.break_load),
            ..Material::new(
                2.0 * self.layout.outer_radius,
                self.weight.moving,
                self.ea(),
            )
        }
    }
}

/// Computes the design of a section that has passed validation; fast enough for every keystroke.
///
/// # Errors
///
/// Why it cannot be laid out, or that nothing in it carries tension.
pub fn design(section: &CrossSection) -> Result<Design, LayoutError> {
    let layout = lay_out(section)?;
    let rigid = matrix(&layout, Core::Rigid);
    if !(rigid.tension_strain > 0.0 && rigid.tension_strain.is_finite()) {
        let remedy = "give a unit or an armour layer Young's modulus, or an electric or optical cable its `ea_n`";
        let problem = "nothing in the section carries tension";
        return Err(LayoutError::new(LayoutKey::Section, problem, remedy));
    }
    let solids = layout.sheaths().map(super::SheathTube::solid);
    let sheaths = solids.fold((0.0, 0.0), |(ea, gj), s| (ea + s.ea, gj + s.gj));
    Ok(Design {
        weight: weight(&layout, &section.about),
        rigid,
        incompressible: matrix(&layout, Core::Incompressible),
        bending: bending(&layout),
        sheaths,
        strength: strength(&layout, section.about.usage_factor),
        section: section.clone(),
        layout,
    })
}

/// The section as a material of a line case.
///
/// # Errors
///
/// Those of [`design`].
pub fn material(section: &CrossSection) -> Result<Material, LayoutError> {
    Ok(design(section)?.material())
}
