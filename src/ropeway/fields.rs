//! Every table and field of a ropeway file: unit, range, default, help.

use crate::case::fields::Absent::{self, Default, Means, Required};
use crate::case::fields::Kind::{Boolean, Choice, Integer, List, Name, Number, Text};
use crate::case::fields::{Field, Range, STANDINGS, Schema, Table, TableShape, field, table};

/// The ropeway file.
pub static ROPEWAY: Schema = Schema {
    what: "ropeway",
    least: "a ropeway has at least [ropeway] with a title and a span, [[rope]], [platform], [ship], [cargo] and [setting]",
    fields: std::borrow::Cow::Borrowed(FIELDS),
    parts: std::borrow::Cow::Borrowed(&[]),
    tables: std::borrow::Cow::Borrowed(TABLES),
};

const ANY: Range = Range::ANY;
const LENGTH: Range = Range::positive(1e4);
const FORCE: Range = Range::positive(1e9);
const NOT_USED: Absent = Means("not used");
const NO_LIMIT: Absent = Means("no limit");

#[rustfmt::skip] // one table a line
static TABLES: &[Table] = &[
    table("ropeway", TableShape::One, true, "What the ropeway is, and what holds for it as a whole."),
    table("rope", TableShape::List, true, "The ropes, side by side; they hang as one."),
    table("platform", TableShape::One, true, "End A: what does not move."),
    table("ship", TableShape::One, true, "End B: the ship, with the winch."),
    table("cargo", TableShape::One, true, "What is carried."),
    table("setting", TableShape::One, true, "How the rope is set before anything moves."),
    table("water", TableShape::One, false, "The water below."),
    table("winch", TableShape::One, false, "A winch that keeps the tension at the ship."),
    table("motion", TableShape::One, false, "The motion of the rope's hang point on the ship."),
    table("dynamics", TableShape::One, false, "The cargo's own motion on the rope."),
    table("finite_element", TableShape::One, false, "The rope as a finite-element check had it: a round bar."),
    table("marks", TableShape::ByName, false, "Where an input comes from that the source does not print."),
    table("published", TableShape::List, false, "A published value the ropeway is held against."),
    table("trend", TableShape::List, false, "A published statement of trend, checked along values of a key."),
];

#[rustfmt::skip]
static FIELDS: &[Field] = &[
    field("ropeway.title",  Text, "", ANY, Required, "title", "What the ropeway is, in one line."),
    field("ropeway.source", Text, "", ANY, Default("\"\""), "source", "Where the data come from."),
    field("ropeway.notes",  Text, "", ANY, Default("\"\""), "notes", "What is missing in the source, what was decided."),
    field("ropeway.span_m", Number, "m", LENGTH, Required, "span", "Horizontal distance from platform to ship."),
    field("ropeway.mass_kg_per_m", Number, "kg/m", Range::positive(1e4), Means("the sum of the ropes"), "mass of all ropes", "Mass per length of all ropes together."),
    field("ropeway.gravity_m_per_s2", Number, "m/s²", Range::positive(100.0), Default("9.80665"), "gravity", "Gravity, for weights."),
    field("ropeway.segments", Integer, "-", Range::of(4.0, 2000.0), Default("80"), "segments", "Segments of the discretised line."),

    field("rope.*.name", Name, "", ANY, Required, "name", "Name of the rope."),
    field("rope.*.diameter_m", Number, "m", Range::positive(1.0), Required, "diameter", "Diameter of the rope."),
    field("rope.*.mass_kg_per_m", Number, "kg/m", Range::positive(1e3), Required, "mass", "Mass per length of the rope."),
    field("rope.*.ea_n", Number, "N", Range::of(1e3, 1e13), Required, "axial stiffness", "EA of the rope."),
    field("rope.*.length_m", Number, "m", LENGTH, Required, "length there is", "Length there is of the rope: no more can be paid out."),
    field("rope.*.break_load_n", Number, "N", FORCE, Means("not checked"), "breaking load", "Tension at which the rope breaks."),

    field("platform.height_m", Number, "m", Range::of(0.0, 1e3), Required, "height", "Height of the rope's hang point above still water."),
    field("ship.height_m", Number, "m", Range::of(0.0, 1e3), Required, "height", "Height of the rope's hang point above still water."),

    field("cargo.mass_kg", Number, "kg", Range::of(0.0, 1e6), Required, "mass", "Mass of the cargo with trolley and hook."),
    field("cargo.position", Number, "-", Range::of(0.0, 1.0), Default("0.5"), "position", "Where it hangs: 0 at the platform, 1 at the ship."),
    field("cargo.drop_m", Number, "m", Range::of(0.0, 100.0), Default("0.0"), "drop", "How far its lower side hangs below the rope."),
    field("cargo.speed_m_per_s", Number, "m/s", Range::positive(100.0), Default("1.0"), "speed", "Speed at which it is hauled along the rope."),

    field("setting.by", Choice(&["bare-sag", "loaded-sag", "length", "tension"]), "", ANY, Required, "set by", "What is given: sag of the bare rope, sag with the cargo at mid-span, unstretched length, or the tension at the ship that the winch keeps."),
    field("setting.sag_m", Number, "m", LENGTH, Means("needed where a sag sets the rope"), "sag", "Sag at mid-span below the straight line between the ends."),
    field("setting.length_m", Number, "m", LENGTH, Means("needed where the length sets the rope"), "length", "Unstretched length between the ends."),
    field("setting.tension_n", Number, "N", FORCE, Means("needed where the tension sets the rope"), "tension", "Tension at the ship, with the cargo where it is."),

    field("water.crest_m", Number, "m", Range::of(0.0, 50.0), Default("0.0"), "wave crest", "Height of the wave crests that the cargo must clear."),

    field("winch.tension_n", Number, "N", FORCE, Means("that of the setting, with the cargo on"), "tension kept", "Tension that the winch keeps at the ship."),
    field("winch.speed_m_per_s", Number, "m/s", Range::positive(100.0), NO_LIMIT, "greatest speed", "Greatest speed at which the winch moves the rope."),
    field("winch.power_w", Number, "W", Range::positive(1e9), NO_LIMIT, "greatest power", "Greatest power of the winch: tension times speed."),

    field("motion.surge_m", Number, "m", Range::of(0.0, 1e3), Default("0.0"), "surge", "Amplitude away from the platform."),
    field("motion.surge_period_s", Number, "s", Range::of(0.1, 1e4), Default("10.0"), "period of surge", "Period of the motion away from the platform."),
    field("motion.heave_m", Number, "m", Range::of(0.0, 1e3), Default("0.0"), "heave", "Amplitude upwards."),
    field("motion.heave_period_s", Number, "s", Range::of(0.1, 1e4), Default("10.0"), "period of heave", "Period of the motion upwards."),

    field("dynamics.damping_ratio", Number, "-", Range::of(0.0, 1.0), Default("0.05"), "damping ratio", "Damping ratio of the cargo's up-and-down motion."),
    field("dynamics.duration_s", Number, "s", Range::positive(1e5), Default("60.0"), "duration", "Time that is followed."),

    field("finite_element.radius_m", Number, "m", Range::positive(1.0), Required, "radius", "Radius of the bar that stands for the ropes."),
    field("finite_element.density_kg_per_m3", Number, "kg/m³", Range::positive(3e4), Required, "density", "Density of the bar."),
    field("finite_element.tension_n", Number, "N", FORCE, Required, "tension", "End tension that the check gave."),

    field("marks.*.status", STANDINGS, "", ANY, Required, "standing", "Where the number stands, from best to worst: published, derived, calibrated, assumed."),
    field("marks.*.reason", Text, "", ANY, Required, "reason", "Why this value."),

    field("published.*.name", Text, "", ANY, Required, "name", "What the value is, in words."),
    field("published.*.quantity", Text, "", ANY, Required, "quantity", "The quantity, such as model.max_tension_n."),
    field("published.*.value", Number, "", ANY, Required, "value", "The published value, in the unit of the quantity."),
    field("published.*.tolerance_rel", Number, "-", Range::positive(10.0), NOT_USED, "relative tolerance", "Tolerance relative to the value."),
    field("published.*.tolerance_abs", Number, "", Range::positive(f64::INFINITY), NOT_USED, "absolute tolerance", "Tolerance in the unit of the value."),
    field("published.*.source", Text, "", ANY, Required, "source", "Where it is printed."),
    field("published.*.inputs", STANDINGS, "", ANY, Required, "inputs", "Standing of the inputs behind the computed value, at worst."),
    field("published.*.fitted", Boolean, "", ANY, Default("false"), "fitted", "True when an input was fitted to this very number: agreement is then no evidence."),
    field("published.*.out_of_reach", Text, "", ANY, NOT_USED, "out of reach", "Why the number cannot be reached; the row then reads DIFFERS instead of FAIL."),

    field("trend.*.name", Text, "", ANY, Required, "name", "The statement, in words."),
    field("trend.*.key", Text, "", ANY, Required, "key", "The key that is varied."),
    field("trend.*.values", List, "", ANY, Required, "values", "Its values, growing."),
    field("trend.*.quantity", Text, "", ANY, Required, "quantity", "The quantity that is looked at."),
    field("trend.*.expect", Choice(&["rises", "falls"]), "", ANY, Required, "expect", "What the quantity does as the values grow."),
    field("trend.*.source", Text, "", ANY, Required, "source", "Where it is printed."),
    field("trend.*.out_of_reach", Text, "", ANY, NOT_USED, "out of reach", "Why the statement cannot be reached; the row then reads DIFFERS instead of FAIL."),
];
