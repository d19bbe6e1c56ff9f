//! A cross-section as the user words it: one struct a table of the file, one field a key.

use std::collections::BTreeMap;
use std::fmt;

use crate::case::fields::ValueType::Name;
use crate::case::fields::{Range, of, positive};
use crate::case::schema::{table, variants, words};
use crate::published::PublishedNumber;

const LENGTH: Range = positive(10.0);
const DENSITY: Range = of(0.0, 3e4);
const MODULUS: Range = of(0.0, 2e12);
const POISSON: Range = of(0.0, 0.5);
const STRENGTH: Range = positive(1e11);
const LOAD: Range = positive(1e12);
const ANGLE: Range = of(0.0, 90.0);

table! {
    /// Everything a section file says.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CrossSection => SectionKeys {}
    tables {
        /// What the section is, and what holds for it as a whole.
        about: SectionInfo as "section";
        /// The units it is made of, by name.
        units: BTreeMap<String, Unit>;
        /// What runs straight in the middle.
        centre: Option<Centre>;
        /// The layers around it, from the inside out.
        layers: Vec<Layer> as "layer";
        /// A published value the section is held against.
        published: Vec<PublishedNumber>;
    }
}

table! {
    /// What the section is, and what holds for it as a whole.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SectionInfo => AboutKeys {
        /// Name of the material it makes for a line case.
        name: String, "name", kind Name;
        /// What the section is, in one line.
        title: String, "title";
        /// Where the data come from.
        source: String = "", "source";
        /// What is missing in the source, what was decided.
        notes: String = "", "notes";
        /// Why the tolerances of the published values are what they are, where a value states no reason of its own.
        tolerance_reason: Option<String>, "reason of the tolerances", absent "none stated";
        /// Whether the middle keeps its diameter or its volume, for the stiffness handed to a line.
        core: Core = Core::Rigid, "core";
        /// What fills the gaps between units and wires.
        voids: Voids = Voids::Dry, "voids";
        /// Share of every strength and breaking load that may be used.
        usage_factor: f64 = 1.0, "usage factor", range positive(1.0);
        /// Density of the water around and in flooded gaps.
        water_density_kg_per_m3: f64 = 1025.0, "water density", range of(0.0, 3000.0);
        /// Gravity, for weights.
        gravity_m_per_s2: f64 = 9.80665, "gravity", range of(0.0, 100.0);
    }
}

words! {
    /// How the middle behaves when the layers squeeze it: the factor Θ of Knapp 1979.
    #[derive(Default)]
    pub enum Core {
        /// It keeps its diameter: Θ = 0.
        #[default]
        Rigid = "rigid",
        /// It keeps its volume: Θ = 1.
        Incompressible = "incompressible",
    }
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
        f.write_str(self.name())
    }
}

words! {
    /// What fills the gaps between units and wires.
    #[derive(Default)]
    pub enum Voids {
        /// Nothing that weighs: they are kept dry, and displace water.
        #[default]
        Dry = "dry",
        /// Water: they displace none, and their water moves with the cable.
        Flooded = "flooded",
    }
}

variants! {
    /// A unit: something round that is laid into a layer or runs in the middle.
    pub enum Unit => UnitKeys by kind, "kind", "Electric or optical cable as a whole, tube, solid rod, or filler rope." {
        /// An electric cable, as a whole.
        Electric(DataSheetUnit) = "electric",
        /// An optical cable, as a whole.
        Fibre(DataSheetUnit) = "fibre",
        /// A tube in a jacket.
        Tube(Tube) = "tube",
        /// A solid rod or wire.
        Rod(Rod) = "rod",
        /// A filler rope: takes room and weighs, carries nothing.
        Filler(Filler) = "filler",
    }
}

table! {
    /// A unit known by its data sheet, not by its make-up.
    #[derive(Debug, Clone, PartialEq)]
    pub struct DataSheetUnit => WholeKeys {
        /// Outer diameter, over everything.
        diameter_m: f64, "diameter", range LENGTH;
        /// Mass per length of the unit.
        mass_kg_per_m: f64, "mass", range of(0.0, 1e5);
        /// EA of the unit; 0: it carries no load.
        ea_n: f64 = 0.0, "axial stiffness", range of(0.0, 1e13);
        /// EI of the unit.
        ei_n_m2: f64 = 0.0, "bending stiffness", range of(0.0, 1e12);
        /// GJ of the unit; counts in the middle only.
        gj_n_m2: f64 = 0.0, "torsional stiffness", range of(0.0, 1e12);
        /// Poisson's ratio, for bending.
        poisson_ratio: f64 = 0.3, "Poisson's ratio", range POISSON;
        /// Tension at which the unit breaks.
        break_load_n: Option<f64>, "breaking load", range LOAD, absent "not checked";
    }
}

table! {
    /// A tube in a jacket.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Tube => TubeKeys {
        /// Outer diameter, over everything.
        diameter_m: f64, "diameter", range LENGTH;
        /// Outer diameter of the tube itself, without its jacket.
        tube_diameter_m: Option<f64>, "tube diameter", range LENGTH, absent "no jacket";
        /// Wall of the tube.
        wall_m: f64, "wall", range LENGTH;
        /// Density of the tube.
        density_kg_per_m3: f64, "density", range DENSITY;
        /// Density of the contents of the tube; 0: it is empty.
        content_density_kg_per_m3: f64 = 0.0, "content density", range DENSITY;
        /// Density of the jacket.
        jacket_density_kg_per_m3: f64 = 950.0, "jacket density", range DENSITY;
        /// Young's modulus of the tube; the jacket carries nothing.
        youngs_modulus_pa: f64, "Young's modulus", range MODULUS;
        /// Poisson's ratio of the tube.
        poisson_ratio: f64 = 0.3, "Poisson's ratio", range POISSON;
        /// Shear modulus of the tube.
        shear_modulus_pa: Option<f64>, "shear modulus", range MODULUS, absent "from Young's modulus";
        /// Axial stress that the tube stands.
        strength_pa: Option<f64>, "strength", range STRENGTH, absent "not checked";
        /// Tension at which the tube breaks; goes before the strength.
        break_load_n: Option<f64>, "breaking load", range LOAD, absent "not checked";
    }
}

table! {
    /// A solid rod or wire.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Rod => RodKeys {
        /// Outer diameter, over everything.
        diameter_m: f64, "diameter", range LENGTH;
        /// Density of the rod.
        density_kg_per_m3: f64, "density", range DENSITY;
        /// Young's modulus of the rod.
        youngs_modulus_pa: f64, "Young's modulus", range MODULUS;
        /// Poisson's ratio of the rod.
        poisson_ratio: f64 = 0.3, "Poisson's ratio", range POISSON;
        /// Shear modulus of the rod.
        shear_modulus_pa: Option<f64>, "shear modulus", range MODULUS, absent "from Young's modulus";
        /// Axial stress that the rod stands.
        strength_pa: Option<f64>, "strength", range STRENGTH, absent "not checked";
        /// Tension at which the rod breaks; goes before the strength.
        break_load_n: Option<f64>, "breaking load", range LOAD, absent "not checked";
    }
}

table! {
    /// A filler rope.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Filler => FillerKeys {
        /// Outer diameter, over everything.
        diameter_m: f64, "diameter", range LENGTH;
        /// Density of the rope, its own gaps included.
        density_kg_per_m3: f64, "density", range DENSITY;
    }
}

table! {
    /// What runs straight in the middle.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Centre => CentreKeys {
        /// Name of the unit in the middle.
        unit: String, "unit";
        /// Outer diameter of a jacket that fills the room up to the first layer.
        jacket_diameter_m: Option<f64>, "jacket diameter", range LENGTH, absent "no jacket";
        /// Density of that jacket.
        jacket_density_kg_per_m3: f64 = 950.0, "jacket density", range DENSITY;
        /// Young's modulus of that jacket; 0: it carries no load.
        jacket_youngs_modulus_pa: f64 = 0.0, "jacket modulus", range MODULUS;
        /// Poisson's ratio of that jacket.
        jacket_poisson_ratio: f64 = 0.4, "jacket Poisson's ratio", range POISSON;
    }
}

variants! {
    /// A layer.
    pub enum Layer => LayerKeys by kind, "kind", "Units side by side, armour wires, or a sheath all around." {
        /// Units laid in a helix, side by side.
        Units(UnitLayer) = "units",
        /// Wires laid in a helix.
        Armour(Armour) = "armour",
        /// A tube of polymer all around.
        Sheath(Sheath) = "sheath",
    }
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

table! {
    /// Units laid in a helix, side by side.
    #[derive(Debug, Clone, PartialEq)]
    pub struct UnitLayer => UnitLayerKeys {
        /// Name of the layer.
        name: String, "name", kind Name;
        /// Names of the units, in order around the layer.
        units: Vec<String>, "units";
        /// Angle of the helix to the cable's axis.
        lay_angle_deg: f64, "lay angle", range ANGLE;
        /// Which way the helix turns.
        sense: LayDirection, "sense";
        /// Radius of the helix of the units' axes.
        pitch_radius_m: Option<f64>, "pitch radius", range LENGTH, absent "the smallest that holds the units";
        /// Share of the gaps in the layer that filler ropes take.
        filler_fraction: f64 = 0.0, "filler fraction", range of(0.0, 1.0);
        /// Density of those filler ropes.
        filler_density_kg_per_m3: f64 = 950.0, "filler density", range DENSITY;
    }
}

table! {
    /// A layer of armour wires, close upon what lies inside.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Armour => ArmourKeys {
        /// Name of the layer.
        name: String, "name", kind Name;
        /// Diameter of a wire.
        wire_diameter_m: f64, "wire diameter", range LENGTH;
        /// Number of wires.
        count: Option<usize>, "count", range of(1.0, 5000.0), absent "as many as fit";
        /// Angle of the helix to the cable's axis.
        lay_angle_deg: f64, "lay angle", range ANGLE;
        /// Which way the helix turns.
        sense: LayDirection, "sense";
        /// Density of the wire.
        density_kg_per_m3: f64 = 7850.0, "density", range DENSITY;
        /// Young's modulus of the wire.
        youngs_modulus_pa: f64 = 2.0e11, "Young's modulus", range MODULUS;
        /// Poisson's ratio of the wire.
        poisson_ratio: f64 = 0.3, "Poisson's ratio", range POISSON;
        /// Axial stress that a wire stands.
        strength_pa: Option<f64>, "strength", range STRENGTH, absent "not checked";
    }
}

table! {
    /// A sheath.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Sheath => SheathKeys {
        /// Name of the layer.
        name: String, "name", kind Name;
        /// Thickness of the sheath.
        thickness_m: f64, "thickness", range LENGTH;
        /// Density of the sheath.
        density_kg_per_m3: f64 = 950.0, "density", range DENSITY;
        /// Young's modulus of the sheath; it counts in bending.
        youngs_modulus_pa: f64 = 0.0, "Young's modulus", range MODULUS;
        /// Poisson's ratio of the sheath.
        poisson_ratio: f64 = 0.4, "Poisson's ratio", range POISSON;
    }
}

words! {
    /// Which way a helix turns.
    pub enum LayDirection {
        /// As a usual screw does; counts as positive.
        Right = "right",
        /// The other way.
        Left = "left",
    }
}

impl LayDirection {
    /// +1 for right, -1 for left.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }
}

impl fmt::Display for LayDirection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
