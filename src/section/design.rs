//! A section with all that follows from it.

use super::bending::{Bending, bending};
use super::lay::lay_out;
use super::layout::Layout;
use super::misfit::Misfit;
use super::model::{Core, Section};
use super::stiffness::{Matrix, Twist, matrix};
use super::strength::{Strength, strength};
use super::units::unused;
use super::weight::{Weight, weight};
use crate::case::Material;

/// A section with all that follows from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// The words.
    pub section: Section,
    /// Where everything lies.
    pub layout: Layout,
    /// What it weighs.
    pub weight: Weight,
    /// Tension and torsion with a rigid middle.
    pub rigid: Matrix,
    /// Tension and torsion with a middle that keeps its volume.
    pub incompressible: Matrix,
    /// Bending.
    pub bending: Bending,
    /// What the sheaths would add to EA \[N\] and to GJ \[N m²\]; eqs. (16)-(17) leave them out.
    pub sheaths: (f64, f64),
    /// The tension it stands; absent when no unit that carries has a known strength.
    pub strength: Option<Strength>,
}

impl Design {
    /// The stiffness matrix for one kind of middle.
    #[must_use]
    pub fn matrix(&self, core: Core) -> &Matrix {
        match core {
            Core::Rigid => &self.rigid,
            Core::Incompressible => &self.incompressible,
        }
    }

    /// Axial stiffness handed to a line: ends kept from turning, the middle as the section says \[N\].
    #[must_use]
    pub fn ea(&self) -> f64 {
        self.matrix(self.section.about.core).ea(Twist::Held)
    }

    /// The section as a material of a line case, its bending stiffness that of full slip. Its drag is left at nothing: it depends on the
    /// flow, not on the make-up.
    #[must_use]
    pub fn material(&self) -> Material {
        Material {
            wet_weight_kg_per_m: Some(self.weight.in_water),
            ei_n_m2: self.bending.total(),
            break_load_n: self.strength.as_ref().map(|s| s.break_load),
            ..Material::new(
                2.0 * self.layout.outer_radius,
                self.weight.moving,
                self.ea(),
            )
        }
    }
}

/// Works a section out. Fast enough to follow every keystroke.
///
/// # Errors
///
/// Everything that cannot be as the section says, each with its key, the reason and a remedy.
pub fn design(section: &Section) -> Result<Design, Vec<Misfit>> {
    let mut layout = lay_out(section)?;
    layout.warnings.extend(unused(section));
    let rigid = matrix(&layout, Core::Rigid);
    if !(rigid.tension_strain > 0.0 && rigid.tension_strain.is_finite()) {
        let remedy = "give a unit or an armour layer Young's modulus, or an electric or optical cable its `ea_n`";
        let misfit = Misfit::new(
            &["section"],
            "nothing in the section carries tension",
            remedy,
        );
        return Err(vec![misfit]);
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
pub fn material(section: &Section) -> Result<Material, Vec<Misfit>> {
    Ok(design(section)?.material())
}
