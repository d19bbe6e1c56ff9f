//! Every table and field of a section file: unit, range, default, help.

use crate::case::fields::Absent::{self, Default, Means, Required};
use crate::case::fields::Kind::{self, Choice, Integer, Name, Number, Text, Words};
use crate::case::fields::{Field, Range, Schema, Table, TableShape, field, only, table};

/// The section file.
pub static SECTION: Schema = Schema {
    what: "section",
    least: "a section has at least [section] with a name and a title, [units.<name>], and a [centre] or a [[layer]]",
    fields: std::borrow::Cow::Borrowed(FIELDS),
    parts: std::borrow::Cow::Borrowed(&[]),
    tables: std::borrow::Cow::Borrowed(TABLES),
};

const ANY: Range = Range::ANY;
const LENGTH: Range = Range::positive(10.0);
const DENSITY: Range = Range::of(0.0, 3e4);
const MODULUS: Range = Range::of(0.0, 2e12);
const POISSON: Range = Range::of(0.0, 0.5);
const STRENGTH: Range = Range::positive(1e11);
const LOAD: Range = Range::positive(1e12);
const ANGLE: Range = Range::of(0.0, 90.0);

const NOT_CHECKED: Absent = Means("not checked");
const POLYMER: Absent = Default("950.0");
const METAL_POISSON: Absent = Default("0.3");
const SENSE: Kind = Choice(&["right", "left"]);
const UNIT_KINDS: Kind = Choice(&["electric", "fibre", "tube", "rod", "filler"]);

const TUBE: (&str, &str) = ("kind", "tube");
const ROD: (&str, &str) = ("kind", "rod");
const ELECTRIC: (&str, &str) = ("kind", "electric");
const FIBRE: (&str, &str) = ("kind", "fibre");
const FILLER: (&str, &str) = ("kind", "filler");
const UNITS: (&str, &str) = ("kind", "units");
const ARMOUR: (&str, &str) = ("kind", "armour");
const SHEATH: (&str, &str) = ("kind", "sheath");

#[rustfmt::skip] // one table a line
static TABLES: &[Table] = &[
    table("section", TableShape::One, true, "What the section is, and what holds for it as a whole."),
    table("units", TableShape::ByName, false, "The units it is made of, by name."),
    table("centre", TableShape::One, false, "What runs straight in the middle."),
    table("layer", TableShape::List, false, "The layers around it, from the inside out."),
];

#[rustfmt::skip]
static FIELDS: &[Field] = &[
    field("section.name",   Name, "", ANY, Required, "name", "Name of the material it makes for a line case."),
    field("section.title",  Text, "", ANY, Required, "title", "What the section is, in one line."),
    field("section.source", Text, "", ANY, Default("\"\""), "source", "Where the data come from."),
    field("section.notes",  Text, "", ANY, Default("\"\""), "notes", "What is missing in the source, what was decided."),
    field("section.core",   Choice(&["rigid", "incompressible"]), "", ANY, Default("\"rigid\""), "core", "Whether the middle keeps its diameter or its volume, for the stiffness handed to a line."),
    field("section.voids",  Choice(&["dry", "flooded"]), "", ANY, Default("\"dry\""), "voids", "What fills the gaps between units and wires."),
    field("section.usage_factor", Number, "-", Range::positive(1.0), Default("1.0"), "usage factor", "Share of every strength and breaking load that may be used."),
    field("section.water_density_kg_per_m3", Number, "kg/m³", Range::of(0.0, 3000.0), Default("1025.0"), "water density", "Density of the water around and in flooded gaps."),
    field("section.gravity_m_per_s2", Number, "m/s²", Range::of(0.0, 100.0), Default("9.80665"), "gravity", "Gravity, for weights."),

    field("units.*.kind", UNIT_KINDS, "", ANY, Required, "kind", "Electric or optical cable as a whole, tube, solid rod, or filler rope."),
    field("units.*.diameter_m", Number, "m", LENGTH, Required, "diameter", "Outer diameter, over everything."),
    only(ELECTRIC, field("units.*.mass_kg_per_m", Number, "kg/m", Range::of(0.0, 1e5), Required, "mass", "Mass per length of the unit.")),
    only(ELECTRIC, field("units.*.ea_n",          Number, "N", Range::of(0.0, 1e13), Default("0.0"), "axial stiffness", "EA of the unit; nought: it carries nothing.")),
    only(ELECTRIC, field("units.*.ei_n_m2",       Number, "N m²", Range::of(0.0, 1e12), Default("0.0"), "bending stiffness", "EI of the unit.")),
    only(ELECTRIC, field("units.*.gj_n_m2",       Number, "N m²", Range::of(0.0, 1e12), Default("0.0"), "torsional stiffness", "GJ of the unit; counts in the middle only.")),
    only(ELECTRIC, field("units.*.poisson_ratio", Number, "-", POISSON, METAL_POISSON, "Poisson's ratio", "Poisson's ratio, for bending.")),
    only(ELECTRIC, field("units.*.break_load_n",  Number, "N", LOAD, NOT_CHECKED, "breaking load", "Tension at which the unit breaks.")),
    only(FIBRE, field("units.*.mass_kg_per_m", Number, "kg/m", Range::of(0.0, 1e5), Required, "mass", "Mass per length of the unit.")),
    only(FIBRE, field("units.*.ea_n",          Number, "N", Range::of(0.0, 1e13), Default("0.0"), "axial stiffness", "EA of the unit; nought: it carries nothing.")),
    only(FIBRE, field("units.*.ei_n_m2",       Number, "N m²", Range::of(0.0, 1e12), Default("0.0"), "bending stiffness", "EI of the unit.")),
    only(FIBRE, field("units.*.gj_n_m2",       Number, "N m²", Range::of(0.0, 1e12), Default("0.0"), "torsional stiffness", "GJ of the unit; counts in the middle only.")),
    only(FIBRE, field("units.*.poisson_ratio", Number, "-", POISSON, METAL_POISSON, "Poisson's ratio", "Poisson's ratio, for bending.")),
    only(FIBRE, field("units.*.break_load_n",  Number, "N", LOAD, NOT_CHECKED, "breaking load", "Tension at which the unit breaks.")),
    only(TUBE, field("units.*.tube_diameter_m", Number, "m", LENGTH, Means("no jacket"), "tube diameter", "Outer diameter of the tube itself, without its jacket.")),
    only(TUBE, field("units.*.wall_m", Number, "m", LENGTH, Required, "wall", "Wall of the tube.")),
    only(TUBE, field("units.*.density_kg_per_m3", Number, "kg/m³", DENSITY, Required, "density", "Density of the tube.")),
    only(TUBE, field("units.*.content_density_kg_per_m3", Number, "kg/m³", DENSITY, Default("0.0"), "content density", "Density of what the tube holds; nought: it is empty.")),
    only(TUBE, field("units.*.jacket_density_kg_per_m3", Number, "kg/m³", DENSITY, POLYMER, "jacket density", "Density of the jacket.")),
    only(TUBE, field("units.*.youngs_modulus_pa", Number, "Pa", MODULUS, Required, "Young's modulus", "Young's modulus of the tube; the jacket carries nothing.")),
    only(TUBE, field("units.*.poisson_ratio", Number, "-", POISSON, METAL_POISSON, "Poisson's ratio", "Poisson's ratio of the tube.")),
    only(TUBE, field("units.*.shear_modulus_pa", Number, "Pa", MODULUS, Means("from Young's modulus"), "shear modulus", "Shear modulus of the tube.")),
    only(TUBE, field("units.*.strength_pa", Number, "Pa", STRENGTH, NOT_CHECKED, "strength", "Axial stress that the tube stands.")),
    only(TUBE, field("units.*.break_load_n", Number, "N", LOAD, NOT_CHECKED, "breaking load", "Tension at which the tube breaks; goes before the strength.")),
    only(ROD, field("units.*.density_kg_per_m3", Number, "kg/m³", DENSITY, Required, "density", "Density of the rod.")),
    only(ROD, field("units.*.youngs_modulus_pa", Number, "Pa", MODULUS, Required, "Young's modulus", "Young's modulus of the rod.")),
    only(ROD, field("units.*.poisson_ratio", Number, "-", POISSON, METAL_POISSON, "Poisson's ratio", "Poisson's ratio of the rod.")),
    only(ROD, field("units.*.shear_modulus_pa", Number, "Pa", MODULUS, Means("from Young's modulus"), "shear modulus", "Shear modulus of the rod.")),
    only(ROD, field("units.*.strength_pa", Number, "Pa", STRENGTH, NOT_CHECKED, "strength", "Axial stress that the rod stands.")),
    only(ROD, field("units.*.break_load_n", Number, "N", LOAD, NOT_CHECKED, "breaking load", "Tension at which the rod breaks; goes before the strength.")),
    only(FILLER, field("units.*.density_kg_per_m3", Number, "kg/m³", DENSITY, Required, "density", "Density of the rope, its own gaps included.")),

    field("centre.unit", Text, "", ANY, Required, "unit", "Name of the unit in the middle."),
    field("centre.jacket_diameter_m", Number, "m", LENGTH, Means("no jacket"), "jacket diameter", "Outer diameter of a jacket that fills the room up to the first layer."),
    field("centre.jacket_density_kg_per_m3", Number, "kg/m³", DENSITY, POLYMER, "jacket density", "Density of that jacket."),
    field("centre.jacket_youngs_modulus_pa", Number, "Pa", MODULUS, Default("0.0"), "jacket modulus", "Young's modulus of that jacket; nought: it carries nothing."),
    field("centre.jacket_poisson_ratio", Number, "-", POISSON, Default("0.4"), "jacket Poisson's ratio", "Poisson's ratio of that jacket."),

    field("layer.*.name", Name, "", ANY, Required, "name", "Name of the layer."),
    field("layer.*.kind", Choice(&["units", "armour", "sheath"]), "", ANY, Required, "kind", "Units side by side, armour wires, or a sheath all around."),
    only(UNITS, field("layer.*.units", Words, "", ANY, Required, "units", "Names of the units, in order around the layer.")),
    only(UNITS, field("layer.*.lay_angle_deg", Number, "deg", ANGLE, Required, "lay angle", "Angle of the helix to the cable's axis.")),
    only(UNITS, field("layer.*.sense", SENSE, "", ANY, Required, "sense", "Which way the helix turns.")),
    only(UNITS, field("layer.*.pitch_radius_m", Number, "m", LENGTH, Means("the smallest that holds the units"), "pitch radius", "Radius of the helix of the units' axes.")),
    only(UNITS, field("layer.*.filler_fraction", Number, "-", Range::of(0.0, 1.0), Default("0.0"), "filler fraction", "Share of the gaps in the layer that filler ropes take.")),
    only(UNITS, field("layer.*.filler_density_kg_per_m3", Number, "kg/m³", DENSITY, POLYMER, "filler density", "Density of those filler ropes.")),
    only(ARMOUR, field("layer.*.wire_diameter_m", Number, "m", LENGTH, Required, "wire diameter", "Diameter of a wire.")),
    only(ARMOUR, field("layer.*.count", Integer, "-", Range::of(1.0, 5000.0), Means("as many as fit"), "count", "Number of wires.")),
    only(ARMOUR, field("layer.*.lay_angle_deg", Number, "deg", ANGLE, Required, "lay angle", "Angle of the helix to the cable's axis.")),
    only(ARMOUR, field("layer.*.sense", SENSE, "", ANY, Required, "sense", "Which way the helix turns.")),
    only(ARMOUR, field("layer.*.density_kg_per_m3", Number, "kg/m³", DENSITY, Default("7850.0"), "density", "Density of the wire.")),
    only(ARMOUR, field("layer.*.youngs_modulus_pa", Number, "Pa", MODULUS, Default("2.0e11"), "Young's modulus", "Young's modulus of the wire.")),
    only(ARMOUR, field("layer.*.poisson_ratio", Number, "-", POISSON, METAL_POISSON, "Poisson's ratio", "Poisson's ratio of the wire.")),
    only(ARMOUR, field("layer.*.strength_pa", Number, "Pa", STRENGTH, NOT_CHECKED, "strength", "Axial stress that a wire stands.")),
    only(SHEATH, field("layer.*.thickness_m", Number, "m", LENGTH, Required, "thickness", "Thickness of the sheath.")),
    only(SHEATH, field("layer.*.density_kg_per_m3", Number, "kg/m³", DENSITY, POLYMER, "density", "Density of the sheath.")),
    only(SHEATH, field("layer.*.youngs_modulus_pa", Number, "Pa", MODULUS, Default("0.0"), "Young's modulus", "Young's modulus of the sheath; it counts in bending.")),
    only(SHEATH, field("layer.*.poisson_ratio", Number, "-", POISSON, Default("0.4"), "Poisson's ratio", "Poisson's ratio of the sheath.")),
];
