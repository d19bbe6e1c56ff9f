//! The line: materials, sections, floats.

use serde::{Deserialize, Serialize};

use super::OneOrMany;

/// What a stretch of line is made of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Hydrodynamic (outer) diameter \[m\].
    pub diameter_m: f64,
    /// Mass per unstretched length \[kg/m\].
    pub mass_kg_per_m: f64,
    /// Weight in water as mass per unstretched length \[kg/m\]; absent: from mass, diameter and water density.
    pub wet_weight_kg_per_m: Option<f64>,
    /// Axial stiffness EA \[N\]; absent: from the table below.
    pub ea_n: Option<f64>,
    /// Strains of a tension-strain table \[-\], rising from 0; absent: tension is EA times strain.
    pub strain: Option<Vec<f64>>,
    /// Tensions at those strains \[N\], rising from 0.
    pub tension_n: Option<Vec<f64>>,
    /// How the stiffness of a fibre rope depends on how it was loaded before.
    #[serde(default)]
    pub dynamic_stiffness: DynamicStiffness,
    /// alpha of `EA / breaking load = alpha + beta Lm - gamma La` \[-\].
    pub dynamic_alpha: Option<f64>,
    /// beta, per percent of mean load \[-\].
    #[serde(default)]
    pub dynamic_beta: f64,
    /// gamma, per percent of deviation from the mean load \[-\].
    #[serde(default)]
    pub dynamic_gamma: f64,
    /// Time over which the past tension is averaged \[s\]; absent: all of the past.
    pub mean_window_s: Option<f64>,
    /// Bending stiffness EI \[N m²\]; 0 for ropes and chains. A material that bends also bears compression.
    #[serde(default)]
    pub ei_n_m2: f64,
    /// Axial damping \[N s\]: tension per strain rate. At most one of this and the ratio.
    pub axial_damping_n_s: Option<f64>,
    /// Axial damping as a fraction of critical of a segment's highest axial mode \[-\].
    pub axial_damping_ratio: Option<f64>,
    /// Normal drag on the diameter: a coefficient or a named law \[-\].
    #[serde(default = "no_drag")]
    pub drag_normal: DragLaw,
    /// Tangential drag, on the width chosen below: a coefficient or a named law \[-\].
    #[serde(default = "no_drag")]
    pub drag_tangential: DragLaw,
    /// Reference width of tangential drag: `diameter` (Jia et al. 2019, eq. 3) or `perimeter`.
    #[serde(default)]
    pub drag_tangential_width: DragWidth,
    /// Normal added-mass coefficient on the displaced volume \[-\].
    #[serde(default = "one")]
    pub added_mass_normal: f64,
    /// Tangential added-mass coefficient on the displaced volume \[-\].
    #[serde(default)]
    pub added_mass_tangential: f64,
    /// Minimum breaking load \[N\], for checks.
    pub break_load_n: Option<f64>,
    /// Smallest radius it may be bent to \[m\], for checks.
    pub min_bend_radius_m: Option<f64>,
}

impl Material {
    /// A material of this diameter \[m\], mass per length \[kg/m\] and axial stiffness EA \[N\]; all else as in a file
    /// that leaves it out.
    #[must_use]
    pub fn new(diameter_m: f64, mass_kg_per_m: f64, ea_n: f64) -> Self {
        Self {
            diameter_m,
            mass_kg_per_m,
            wet_weight_kg_per_m: None,
            ea_n: Some(ea_n),
            strain: None,
            tension_n: None,
            dynamic_stiffness: DynamicStiffness::default(),
            dynamic_alpha: None,
            dynamic_beta: 0.0,
            dynamic_gamma: 0.0,
            mean_window_s: None,
            ei_n_m2: 0.0,
            axial_damping_n_s: None,
            axial_damping_ratio: None,
            drag_normal: no_drag(),
            drag_tangential: no_drag(),
            drag_tangential_width: DragWidth::default(),
            added_mass_normal: one(),
            added_mass_tangential: 0.0,
            break_load_n: None,
            min_bend_radius_m: None,
        }
    }
}

fn no_drag() -> DragLaw {
    DragLaw::Constant(0.0)
}

fn one() -> f64 {
    1.0
}

/// How dynamic stiffness (Zhu, Yin and Shen 2017, eq. 1) makes a tension.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DynamicStiffness {
    /// Not at all: the static stiffness holds in motion too.
    #[default]
    None,
    /// As a secant through the origin of strain, as in the paper.
    Secant,
    /// About the mean state, up to which the static stiffness holds.
    AboutTheMean,
}

/// A drag coefficient, constant or from a named law of the Reynolds number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum DragLaw {
    /// The same at every Reynolds number.
    Constant(f64),
    /// A law by name.
    Named(DragLawName),
}

/// The drag laws known by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum DragLawName {
    /// Normal drag of Jia et al. 2019, eq. (4).
    #[serde(rename = "jia-2019-normal")]
    Jia2019Normal,
    /// Tangential drag of Jia et al. 2019, eq. (5).
    #[serde(rename = "jia-2019-tangential")]
    Jia2019Tangential,
}

/// The width that tangential drag is referred to.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DragWidth {
    /// The diameter D.
    #[default]
    Diameter,
    /// The perimeter πD.
    Perimeter,
}

/// A section of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// Name, used in channel names and key paths (`line.polyester.length_m`).
    pub name: String,
    /// Name of its material.
    pub material: String,
    /// Unstretched length \[m\].
    pub length_m: f64,
    /// Number of segments it is divided into.
    pub segments: usize,
}

/// Floats spread evenly over a stretch of a section.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Floats {
    /// The section they sit on.
    pub section: String,
    /// Where the stretch begins, from the section's end nearer to A \[m\].
    #[serde(default)]
    pub from_m: f64,
    /// Where it ends \[m\]; absent: the section's end.
    pub to_m: Option<f64>,
    /// Net lift of all of them as mass \[kg\] (buoyancy less their own weight).
    pub lift_kg: f64,
    /// Mass of all of them \[kg\].
    #[serde(default)]
    pub mass_kg: f64,
    /// Normal drag coefficient times area of all of them \[m²\].
    #[serde(default)]
    pub drag_area_m2: f64,
    /// Normal added mass of all of them \[kg\].
    #[serde(default)]
    pub added_mass_kg: f64,
}

/// A body hung on the line at one place: a clump weight, or a buoy where its weight in water is negative.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Clump {
    /// Name, used in channel names (`x_m[clump]`).
    pub name: String,
    /// The section it hangs on.
    pub section: String,
    /// Where, from the section's end nearer to A \[m\]; it hangs at the node nearest to that.
    pub at_m: f64,
    /// Mass in air \[kg\].
    pub mass_kg: f64,
    /// Weight in water as mass \[kg\]; negative for a buoy.
    pub wet_mass_kg: f64,
    /// Drag coefficient times area \[m²\]: one number, or along x, y, z.
    #[serde(default = "nothing")]
    pub drag_area_m2: OneOrMany,
    /// Added mass \[kg\]: one number, or along x, y, z.
    #[serde(default = "nothing")]
    pub added_mass_kg: OneOrMany,
}

pub(super) fn nothing() -> OneOrMany {
    OneOrMany::One(0.0)
}

/// A body that travels along the line, at a given speed: a cargo on a ropeway, a crawler.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Traveller {
    /// Name, used in channel names (`x_m[cargo]`).
    pub name: String,
    /// Mass in air \[kg\].
    pub mass_kg: f64,
    /// Weight in water as mass \[kg\].
    pub wet_mass_kg: f64,
    /// Drag coefficient times area \[m²\]: one number, or along x, y, z.
    #[serde(default = "nothing")]
    pub drag_area_m2: OneOrMany,
    /// Unstretched length from end A at which it begins \[m\].
    #[serde(default)]
    pub from_m: f64,
    /// Unstretched length from end A at which it stays \[m\]; absent: end B.
    pub to_m: Option<f64>,
    /// Speed along the unstretched line \[m/s\].
    pub speed_m_per_s: f64,
    /// Time at which it sets out \[s\].
    #[serde(default)]
    pub start_s: f64,
    /// Time in which it comes to its speed \[s\].
    #[serde(default)]
    pub ramp_s: f64,
}

/// Buoyancy modules clamped on a stretch of a section, one a pitch. Their volume, mass and drag are spread over the
/// stretch (Lin, Guo, Niu and Zhang 2016, eqs 20 and 21).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Modules {
    /// The section they sit on.
    pub section: String,
    /// Where the stretch begins, from the section's end nearer to A \[m\].
    #[serde(default)]
    pub from_m: f64,
    /// Where it ends \[m\]; absent: the section's end.
    pub to_m: Option<f64>,
    /// Outer diameter of a module \[m\].
    pub diameter_m: f64,
    /// Length of a module \[m\].
    pub length_m: f64,
    /// Distance from one module to the next \[m\].
    pub pitch_m: f64,
    /// Density of a module's material \[kg/m³\].
    pub density_kg_per_m3: f64,
    /// Mass of what holds each module in place \[kg\].
    #[serde(default)]
    pub fittings_kg: f64,
    /// Normal drag coefficient of a module on its diameter \[-\].
    #[serde(default)]
    pub drag_normal: f64,
}
