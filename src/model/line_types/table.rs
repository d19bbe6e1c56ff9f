//! The table of line types.

use super::DiameterLaw;

/// What a type is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Chain; the nominal diameter is that of the bar.
    Chain,
    /// Steel wire rope or strand; the nominal diameter is that of the steel.
    Wire,
    /// Fibre rope; the nominal diameter is that of the rope.
    Fibre,
}

/// A formula or number and the publication that it is from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sourced<T> {
    /// The formula or number.
    pub value: T,
    /// The publication.
    pub source: &'static str,
}

/// A coefficient of drag, on the nominal diameter, or of added mass, on the displaced volume.
pub type Coefficient = Sourced<f64>;

/// How the volume-equivalent diameter follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OuterDiameter {
    /// So many nominal diameters.
    Times(f64),
    /// That of a rod of the line's mass and this density \[kg/m^3\].
    ByDensity(f64),
}

/// A line type: formulas by nominal diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineType {
    /// Its name, `chain-r4-studless`.
    pub name: &'static str,
    /// What it is, in words.
    pub title: &'static str,
    /// What it is made of.
    pub family: Family,
    /// Nominal diameters \[m\] for which such lines are made and the formulas are meant.
    pub diameters_m: [f64; 2],
    /// Volume-equivalent diameter \[m\].
    pub outer: Sourced<OuterDiameter>,
    /// Mass in air \[kg/m\].
    pub mass: Sourced<DiameterLaw>,
    /// Axial stiffness EA \[N\]; of fibre ropes the quasi-static one.
    pub ea: Sourced<DiameterLaw>,
    /// Minimum breaking load \[N\].
    pub break_load: Sourced<DiameterLaw>,
    /// Proof load \[N\], of chain.
    pub proof_load: Option<Sourced<DiameterLaw>>,
    /// Normal drag.
    pub drag_normal: Coefficient,
    /// Tangential drag; 0 where the source has none.
    pub drag_tangential: Coefficient,
    /// Added mass across the line.
    pub added_mass_normal: Coefficient,
    /// Added mass along the line.
    pub added_mass_tangential: Coefficient,
    /// Stiffness in motion by breaking load, `alpha + beta Lm`, with the mean tension Lm in percent of it.
    pub dynamic_stiffness: Option<Sourced<[f64; 2]>>,
    /// What a user should know of it; may be empty.
    pub note: &'static str,
}

const W22: &str = "IACS UR W22";
const E301: &str = "DNV-OS-E301";
const NR493: &str = "Bureau Veritas NR 493";
const ORCINA_CHAIN: &str = "OrcaFlex help, Chain";
const ORCINA_ROPE: &str = "OrcaFlex help, Rope/wire";
const MOORPY: &str = "MoorPy defaults";

const fn from<T>(value: T, source: &'static str) -> Sourced<T> {
    Sourced { value, source }
}

/// A chain grade of IACS UR W22: coefficients of the breaking load and of the proof loads with and without stud
/// \[kN/mm^2\], and the effective modulus without stud \[N/m^2\], falling with the diameter \[N/m^3\].
struct Grade {
    break_load: f64,
    proof_stud: f64,
    proof_studless: f64,
    modulus: [f64; 2],
}

const fn grade(loads: [f64; 3], modulus: [f64; 2]) -> Grade {
    let [break_load, proof_stud, proof_studless] = loads;
    Grade {
        break_load,
        proof_stud,
        proof_studless,
        modulus,
    }
}

// DNV-OS-E301 has moduli for R3, R4 and R5; R3S and R4S take those of the grade below.
const R3: Grade = grade([0.0223, 0.0148, 0.0148], [5.40e10, 4.0e10]);
const R3S: Grade = grade([0.0249, 0.0180, 0.0174], [5.40e10, 4.0e10]);
const R4: Grade = grade([0.0274, 0.0216, 0.0192], [5.45e10, 2.5e10]);
const R4S: Grade = grade([0.0304, 0.0240, 0.0213], [5.45e10, 2.5e10]);
const R5: Grade = grade([0.0320, 0.0251, 0.0223], [6.00e10, 3.3e10]);

/// From kN with d in mm to N with d in m.
const LOAD: f64 = 1e9;

const fn chain(name: &'static str, title: &'static str, grade: &Grade, stud: bool) -> LineType {
    let [e, f] = if stud { [5.6e10, 0.0] } else { grade.modulus };
    let [outer, mass, normal, tangential] = if stud {
        [1.89, 21_900.0, 2.6, 1.4]
    } else {
        [1.80, 19_900.0, 2.4, 1.15]
    };
    let proof = if stud {
        grade.proof_stud
    } else {
        grade.proof_studless
    };
    LineType {
        name,
        title,
        family: Family::Chain,
        diameters_m: [0.034, 0.220],
        outer: from(OuterDiameter::Times(outer), ORCINA_CHAIN),
        mass: from(DiameterLaw::Square(mass), ORCINA_CHAIN),
        ea: from(DiameterLaw::ChainModulus(e, f), E301),
        break_load: from(DiameterLaw::ChainLoad(grade.break_load * LOAD), W22),
        proof_load: Some(from(DiameterLaw::ChainLoad(proof * LOAD), W22)),
        drag_normal: from(normal, E301),
        drag_tangential: from(tangential, E301),
        added_mass_normal: from(1.0, NR493),
        added_mass_tangential: from(0.5, NR493),
        dynamic_stiffness: None,
        note: if stud {
            "The help of OrcaFlex has EA = 1.01e11 d^2."
        } else {
            "The help of OrcaFlex has EA = 0.854e11 d^2."
        },
    }
}

/// Masses, stiffness, strength and density of a fibre rope as fitted by MoorPy.
struct Fibre {
    diameters_m: [f64; 2],
    density: f64,
    mass: f64,
    break_load: DiameterLaw,
    ea: f64,
    dynamic: [f64; 2],
}

const fn fibre(name: &'static str, title: &'static str, fit: &Fibre) -> LineType {
    LineType {
        name,
        title,
        family: Family::Fibre,
        diameters_m: fit.diameters_m,
        outer: from(OuterDiameter::ByDensity(fit.density), MOORPY),
        mass: from(DiameterLaw::Square(fit.mass), MOORPY),
        ea: from(DiameterLaw::OfBreakLoad(fit.ea), MOORPY),
        break_load: from(fit.break_load, MOORPY),
        proof_load: None,
        drag_normal: from(1.6, E301),
        drag_tangential: from(0.0, E301),
        added_mass_normal: from(1.1, NR493),
        added_mass_tangential: from(0.15, NR493),
        dynamic_stiffness: Some(from(fit.dynamic, MOORPY)),
        note: "EA is the quasi-static one; in waves the rope is stiffer. DNV-OS-E301 has no tangential drag.",
    }
}

const fn wire(
    name: &'static str,
    title: &'static str,
    [outer, mass, ea, break_load]: [f64; 4],
    (drag, source): (f64, &'static str),
    (diameters_m, note): ([f64; 2], &'static str),
) -> LineType {
    LineType {
        name,
        title,
        family: Family::Wire,
        diameters_m,
        outer: from(OuterDiameter::Times(outer), source),
        mass: from(DiameterLaw::Square(mass), source),
        ea: from(DiameterLaw::Square(ea), source),
        break_load: from(DiameterLaw::Square(break_load), source),
        proof_load: None,
        drag_normal: from(drag, E301),
        drag_tangential: from(0.0, E301),
        added_mass_normal: from(1.0, "a cylinder, DNV-RP-C205"),
        added_mass_tangential: from(0.0, "a smooth cylinder, DNV-RP-C205"),
        dynamic_stiffness: None,
        note,
    }
}

const POLYESTER: Fibre = Fibre {
    diameters_m: [0.08, 0.32],
    density: 1380.0,
    mass: 679.0,
    break_load: DiameterLaw::Square(308e6),
    ea: 14.0,
    dynamic: [11.6, 0.40],
};

const NYLON: Fibre = Fibre {
    diameters_m: [0.03, 0.25],
    density: 1140.0,
    mass: 585.0,
    break_load: DiameterLaw::Cubic(207e6, 230e6),
    ea: 5.0,
    dynamic: [2.08, 0.39],
};

const HMPE: Fibre = Fibre {
    diameters_m: [0.03, 0.25],
    density: 975.0,
    mass: 496.0,
    break_load: DiameterLaw::Cubic(580e6, 651e6),
    ea: 56.0,
    dynamic: [59.0, 0.54],
};

/// All line types. Ranges of diameters are those in which makers list such lines; the sources of the formulas state none.
pub const LINE_TYPES: &[LineType] = &[
    chain("chain-r3-studless", "Studless chain, grade R3", &R3, false),
    chain("chain-r3-stud", "Stud-link chain, grade R3", &R3, true),
    chain(
        "chain-r3s-studless",
        "Studless chain, grade R3S",
        &R3S,
        false,
    ),
    chain("chain-r3s-stud", "Stud-link chain, grade R3S", &R3S, true),
    chain("chain-r4-studless", "Studless chain, grade R4", &R4, false),
    chain("chain-r4-stud", "Stud-link chain, grade R4", &R4, true),
    chain(
        "chain-r4s-studless",
        "Studless chain, grade R4S",
        &R4S,
        false,
    ),
    chain("chain-r4s-stud", "Stud-link chain, grade R4S", &R4S, true),
    chain("chain-r5-studless", "Studless chain, grade R5", &R5, false),
    chain("chain-r5-stud", "Stud-link chain, grade R5", &R5, true),
    wire(
        "spiral-strand",
        "Spiral strand, sheathed",
        [1.18, 5293.0, 97.1e9, 1022e6],
        (1.2, MOORPY),
        (
            [0.06, 0.16],
            "The outer diameter includes the plastic sheath; DNV-OS-E301 has a drag of 1.6 for strand without it.",
        ),
    ),
    wire(
        "wire-six-strand",
        "Six-strand rope, IWRC",
        [0.80, 3989.7, 4.04e10, 633.358e6],
        (1.8, ORCINA_ROPE),
        ([0.008, 0.14], ""),
    ),
    fibre("polyester", "Polyester rope", &POLYESTER),
    fibre("nylon", "Nylon rope", &NYLON),
    fibre("hmpe", "HMPE rope", &HMPE),
];

/// The type of this name, in letters of either case.
#[must_use]
pub fn find(name: &str) -> Option<&'static LineType> {
    let same = |line: &&LineType| line.name.eq_ignore_ascii_case(name.trim());
    LINE_TYPES.iter().find(same)
}
