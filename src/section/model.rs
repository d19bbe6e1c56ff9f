//! A cross-section as the user words it: one struct a table of the file, one field a key.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

/// Everything a section file says.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// What the section is, and what holds for it as a whole.
    #[serde(rename = "section")]
    pub about: About,
    /// The units it is made of, by name.
    #[serde(default)]
    pub units: BTreeMap<String, Unit>,
    /// What runs straight in the middle; absent: the middle is empty.
    pub centre: Option<Centre>,
    /// The layers around it, from the inside out.
    #[serde(default, rename = "layer")]
    pub layers: Vec<Layer>,
}

/// What the section is, and what holds for it as a whole.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// Name of the material it makes for a line case.
    pub name: String,
    /// One line.
    pub title: String,
    /// Where the data come from.
    #[serde(default)]
    pub source: String,
    /// A few sentences: what is missing in the source, what was decided.
    #[serde(default)]
    pub notes: String,
    /// How the middle behaves under the squeeze of the layers, for the stiffness handed to a line.
    #[serde(default)]
    pub core: Core,
    /// What fills the gaps between units and wires.
    #[serde(default)]
    pub voids: Voids,
    /// Share of every strength and breaking load that may be used \[-\].
    #[serde(default = "one")]
    pub usage_factor: f64,
    /// Density of the water around and in flooded gaps \[kg/m³\].
    #[serde(default = "sea_water")]
    pub water_density_kg_per_m3: f64,
    /// Gravity \[m/s²\], for weights.
    #[serde(default = "standard_gravity")]
    pub gravity_m_per_s2: f64,
}

/// How the middle behaves when the layers squeeze it: the factor Θ of Knapp 1979.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Core {
    /// It keeps its diameter: Θ = 0.
    #[default]
    Rigid,
    /// It keeps its volume: Θ = 1.
    Incompressible,
}

impl Core {
    /// Both, the stiffer first.
    pub const BOTH: [Self; 2] = [Self::Rigid, Self::Incompressible];

    /// The factor Θ \[-\].
    #[must_use]
    pub fn theta(self) -> f64 {
        match self {
            Self::Rigid => 0.0,
            Self::Incompressible => 1.0,
        }
    }
}

impl fmt::Display for Core {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Rigid => "rigid",
            Self::Incompressible => "incompressible",
        })
    }
}

/// What fills the gaps between units and wires.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Voids {
    /// Nothing that weighs: they are kept dry, and displace water.
    #[default]
    Dry,
    /// Water: they displace none, and their water moves with the cable.
    Flooded,
}

/// A unit: something round that is laid into a layer or runs in the middle.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields, tag = "kind")]
pub enum Unit {
    /// An electric cable, as a whole.
    Electric(Whole),
    /// An optical cable, as a whole.
    Fibre(Whole),
    /// A tube in a jacket.
    Tube(Tube),
    /// A solid rod or wire.
    Rod(Rod),
    /// A filler rope: takes room and weighs, carries nothing.
    Filler(Filler),
}

/// A unit known by its data sheet, not by its make-up.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Whole {
    /// Outer diameter \[m\].
    pub diameter_m: f64,
    /// Mass per length of its own \[kg/m\].
    pub mass_kg_per_m: f64,
    /// Axial stiffness EA \[N\].
    #[serde(default)]
    pub ea_n: f64,
    /// Bending stiffness EI \[N m²\].
    #[serde(default)]
    pub ei_n_m2: f64,
    /// Torsional stiffness GJ \[N m²\]; counts in the middle only.
    #[serde(default)]
    pub gj_n_m2: f64,
    /// Poisson's ratio \[-\].
    #[serde(default = "metal_poisson")]
    pub poisson_ratio: f64,
    /// Tension at which it breaks \[N\].
    pub break_load_n: Option<f64>,
}

/// A tube in a jacket.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tube {
    /// Outer diameter, over the jacket \[m\].
    pub diameter_m: f64,
    /// Outer diameter of the tube itself; absent: it has no jacket \[m\].
    pub tube_diameter_m: Option<f64>,
    /// Wall of the tube \[m\].
    pub wall_m: f64,
    /// Density of the tube \[kg/m³\].
    pub density_kg_per_m3: f64,
    /// Density of what the tube holds; nought for an empty one \[kg/m³\].
    #[serde(default)]
    pub content_density_kg_per_m3: f64,
    /// Density of the jacket \[kg/m³\].
    #[serde(default = "polymer")]
    pub jacket_density_kg_per_m3: f64,
    /// Young's modulus of the tube \[Pa\]; the jacket carries nothing.
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio of the tube \[-\].
    #[serde(default = "metal_poisson")]
    pub poisson_ratio: f64,
    /// Shear modulus of the tube \[Pa\]; absent: E/2(1+ν).
    pub shear_modulus_pa: Option<f64>,
    /// Axial stress that the tube stands \[Pa\].
    pub strength_pa: Option<f64>,
    /// Tension at which it breaks \[N\]; goes before the strength.
    pub break_load_n: Option<f64>,
}

/// A solid rod or wire.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rod {
    /// Diameter \[m\].
    pub diameter_m: f64,
    /// Density \[kg/m³\].
    pub density_kg_per_m3: f64,
    /// Young's modulus \[Pa\].
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio \[-\].
    #[serde(default = "metal_poisson")]
    pub poisson_ratio: f64,
    /// Shear modulus \[Pa\]; absent: E/2(1+ν).
    pub shear_modulus_pa: Option<f64>,
    /// Axial stress that it stands \[Pa\].
    pub strength_pa: Option<f64>,
    /// Tension at which it breaks \[N\]; goes before the strength.
    pub break_load_n: Option<f64>,
}

/// A filler rope.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Filler {
    /// Diameter \[m\].
    pub diameter_m: f64,
    /// Density, its own gaps included \[kg/m³\].
    pub density_kg_per_m3: f64,
}

/// What runs straight in the middle.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Centre {
    /// Name of the unit.
    pub unit: String,
    /// Outer diameter of a jacket that fills the room up to the first layer \[m\]; absent: none.
    pub jacket_diameter_m: Option<f64>,
    /// Density of that jacket \[kg/m³\].
    #[serde(default = "polymer")]
    pub jacket_density_kg_per_m3: f64,
    /// Young's modulus of that jacket \[Pa\]; nought: it carries nothing.
    #[serde(default)]
    pub jacket_youngs_modulus_pa: f64,
    /// Poisson's ratio of that jacket \[-\].
    #[serde(default = "polymer_poisson")]
    pub jacket_poisson_ratio: f64,
}

/// A layer.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase", tag = "kind")]
pub enum Layer {
    /// Units laid in a helix, side by side.
    Units(UnitLayer),
    /// Wires laid in a helix.
    Armour(Armour),
    /// A tube of polymer all around.
    Sheath(Sheath),
}

impl Layer {
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Units(layer) => &layer.name,
            Self::Armour(layer) => &layer.name,
            Self::Sheath(layer) => &layer.name,
        }
    }
}

/// Units laid in a helix, side by side.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UnitLayer {
    /// Name.
    pub name: String,
    /// Names of the units, in order around the layer.
    pub units: Vec<String>,
    /// Angle of the helix to the cable's axis \[deg\].
    pub lay_angle_deg: f64,
    /// Which way the helix turns.
    pub sense: Sense,
    /// Radius of the helix of the units' axes \[m\]; absent: the smallest that holds them.
    pub pitch_radius_m: Option<f64>,
    /// Share of the gaps in the layer that filler ropes take \[-\].
    #[serde(default)]
    pub filler_fraction: f64,
    /// Density of those filler ropes \[kg/m³\].
    #[serde(default = "polymer")]
    pub filler_density_kg_per_m3: f64,
}

/// A layer of armour wires, close upon what lies inside.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Armour {
    /// Name.
    pub name: String,
    /// Diameter of a wire \[m\].
    pub wire_diameter_m: f64,
    /// Number of wires; absent: as many as fit.
    pub count: Option<usize>,
    /// Angle of the helix to the cable's axis \[deg\].
    pub lay_angle_deg: f64,
    /// Which way the helix turns.
    pub sense: Sense,
    /// Density of the wire \[kg/m³\].
    #[serde(default = "steel")]
    pub density_kg_per_m3: f64,
    /// Young's modulus of the wire \[Pa\].
    #[serde(default = "steel_modulus")]
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio of the wire \[-\].
    #[serde(default = "metal_poisson")]
    pub poisson_ratio: f64,
    /// Axial stress that a wire stands \[Pa\].
    pub strength_pa: Option<f64>,
}

/// A sheath.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sheath {
    /// Name.
    pub name: String,
    /// Thickness \[m\].
    pub thickness_m: f64,
    /// Density \[kg/m³\].
    #[serde(default = "polymer")]
    pub density_kg_per_m3: f64,
    /// Young's modulus \[Pa\]; it counts in bending.
    #[serde(default)]
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio \[-\].
    #[serde(default = "polymer_poisson")]
    pub poisson_ratio: f64,
}

/// Which way a helix turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sense {
    /// As a usual screw does; counts as positive.
    Right,
    /// The other way.
    Left,
}

impl Sense {
    /// +1 for right, -1 for left.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }
}

impl fmt::Display for Sense {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Right => "right",
            Self::Left => "left",
        })
    }
}

fn one() -> f64 {
    1.0
}

fn sea_water() -> f64 {
    1025.0
}

fn standard_gravity() -> f64 {
    9.80665
}

fn steel() -> f64 {
    7850.0
}

fn steel_modulus() -> f64 {
    2.0e11
}

fn polymer() -> f64 {
    950.0
}

fn metal_poisson() -> f64 {
    0.3
}

fn polymer_poisson() -> f64 {
    0.4
}
