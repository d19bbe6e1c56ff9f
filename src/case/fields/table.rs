//! The table of fields and the table of tables. Ranges are wide: they catch slips (millimetres
//! typed as metres, a lost minus sign), not unusual cables.

use super::Absent::{Default, Means, Required};
use super::Kind::{
    Boolean, Choice, Integer, List, Name, Number, NumberOrChoice, NumberOrList, NumberOrTriple,
    Pair, Text, Triple,
};
use super::TableShape::{ByName, List as ListOf, One};
use super::{Absent, Field, Kind, Range, Table};

const ANY: Range = Range::ANY;
const ZERO_UP: Range = Range::of(0.0, f64::INFINITY);

const NORMAL_DRAG: Kind = NumberOrChoice(&["jia-2019-normal"]);
const TANGENTIAL_DRAG: Kind = NumberOrChoice(&["jia-2019-tangential"]);
const STANDINGS: Kind = Choice(&["published", "derived", "calibrated", "assumed"]);
const STATISTICS: Kind = Choice(&[
    "mean",
    "max",
    "min",
    "final",
    "travel",
    "time_of_max",
    "time_of_min",
    "settling_time",
    "rise_time",
    "rate",
    "arc_of_max",
    "arc_of_min",
    "greatest_fall",
    "turns",
]);
const END_KINDS: Kind = Choice(&["fixed", "anchor", "payload", "moving", "free"]);

const WHOLE_RUN: Absent = Means("the whole run");
const NOT_USED: Absent = Means("not used");

/// Every table of the case file.
pub static TABLES: &[Table] = &[
    table("case", One, true, "What the case is, for people."),
    table("environment", One, false, "Water and gravity."),
    table(
        "current",
        One,
        false,
        "The current; absent means still water.",
    ),
    table("seabed", One, false, "A flat sea bed under the line."),
    table(
        "materials",
        ByName,
        true,
        "What the sections of the line are made of, by name.",
    ),
    table(
        "line",
        ListOf,
        true,
        "The sections of the line, from end A to end B.",
    ),
    table("ends", One, true, "The two ends of the line."),
    table(
        "ends.a",
        One,
        true,
        "The end where the first section begins.",
    ),
    table("ends.b", One, true, "The end where the last section stops."),
    table(
        "payload",
        One,
        false,
        "The body hung on an end of kind payload.",
    ),
    table(
        "payload.shape",
        One,
        false,
        "The form of the payload, for what its other keys leave out.",
    ),
    table(
        "floats",
        ListOf,
        false,
        "Floats spread evenly over a stretch of a section.",
    ),
    table(
        "clumps",
        ListOf,
        false,
        "A body hung on the line at one place: a clump weight, or a buoy.",
    ),
    table(
        "modules",
        ListOf,
        false,
        "Buoyancy modules clamped on a stretch of a section, one a pitch.",
    ),
    table(
        "start",
        One,
        false,
        "Where the line is at time zero, at rest.",
    ),
    table("solver", One, false, "Which solver, and its settings."),
    table("output", One, false, "What is recorded and how often."),
    table(
        "marks",
        ByName,
        false,
        "Where an input comes from when the source does not print it, by key path.",
    ),
    table(
        "study",
        ListOf,
        false,
        "One key varied over a list of values.",
    ),
    table(
        "published",
        ListOf,
        false,
        "A published value the case is held against.",
    ),
    table(
        "published.*.at",
        One,
        false,
        "The point of a study this row belongs to.",
    ),
    table(
        "trend",
        ListOf,
        false,
        "A published statement of trend, checked along a study.",
    ),
];

/// Every field of the case file, in the order in which people read it.
#[rustfmt::skip] // one field a line: this is a table to be read down its columns
pub static FIELDS: &[Field] = &[
    field("case.title",  Text, "", ANY, Required,    "title", "One line that says what the case is."),
    field("case.source", Text, "", ANY, Default("\"\""), "source", "Where the data come from."),
    field("case.notes",  Text, "", ANY, Default("\"\""), "notes", "The scene, what the source leaves out, what was decided."),

    field("environment.gravity_m_per_s2",             Number, "m/s²",  Range::of(0.0, 100.0),    Default("9.80665"), "gravity", "Acceleration of gravity, downwards."),
    field("environment.water_density_kg_per_m3",      Number, "kg/m³", Range::of(0.0, 2e4),      Default("1025.0"),  "water density", "Density of the water; it sets buoyancy, drag and added mass."),
    field("environment.kinematic_viscosity_m2_per_s", Number, "m²/s",  Range::positive(1.0),     Default("1.19e-6"), "kinematic viscosity", "Kinematic viscosity of the water, for Reynolds numbers."),

    field("current.speed_m_per_s", NumberOrList, "m/s", Range::of(-20.0, 20.0),    Required,       "current speed", "Speed of the current: one number, or one for each depth."),
    field("current.direction_deg", NumberOrList, "deg", Range::of(-360.0, 360.0),  Default("0.0"), "current direction", "Where the water flows to, from +x towards +y: one number, or one for each depth."),
    field("current.depth_m",       List,         "m",   Range::of(0.0, 2e4),       Means("the same at every depth"), "current depths", "Depths below still water, increasing; linear in between, constant beyond."),

    field("seabed.depth_m",               Number, "m",      Range::of(0.0, 2e4),   Required,       "depth", "Depth of the bed below still water."),
    field("seabed.stiffness_n_per_m3",    Number, "N/m³",   Range::positive(1e12), Default("1.0e5"), "stiffness", "Push of the bed per area and depth below it."),
    field("seabed.damping_n_s_per_m3",    Number, "N s/m³", Range::of(0.0, 1e12),  Default("0.0"), "damping", "Push of the bed per area and speed into it."),

    field("materials.*.diameter_m",               Number,          "m",    Range::positive(10.0),     Required, "diameter", "Outer diameter, which drag, buoyancy and added mass refer to."),
    field("materials.*.mass_kg_per_m",            Number,          "kg/m", Range::positive(1e6),      Required, "mass", "Mass in air per unstretched length."),
    field("materials.*.wet_weight_kg_per_m",      Number,          "kg/m", Range::of(-1e6, 1e6),      Means("mass less displaced water"), "wet weight", "Weight in water, as mass per unstretched length; negative floats."),
    field("materials.*.ea_n",                     Number,          "N",    Range::positive(1e13),     Required, "axial stiffness EA", "Tension per strain."),
    field("materials.*.ei_n_m2",                  Number,          "N m²", Range::of(0.0, 1e12),      Default("0.0"), "bending stiffness EI", "Moment per curvature; 0 for ropes and chains. What bends also bears compression."),
    field("materials.*.axial_damping_n_s",        Number,          "N s",  Range::of(0.0, 1e13),      Means("no axial damping"), "axial damping", "Tension per strain rate. Give this or axial_damping_ratio."),
    field("materials.*.axial_damping_ratio",      Number,          "-",    Range::of(0.0, 10.0),      Means("no axial damping"), "axial damping ratio", "Fraction of critical of a segment's highest axial mode. Give this or axial_damping_n_s."),
    field("materials.*.drag_normal",              NORMAL_DRAG,     "-",    Range::of(0.0, 100.0),     Default("0.0"), "normal drag", "Coefficient on the diameter, or a law of the Reynolds number by name."),
    field("materials.*.drag_tangential",          TANGENTIAL_DRAG, "-",    Range::of(0.0, 100.0),     Default("0.0"), "tangential drag", "Coefficient on the width below, or a law of the Reynolds number by name."),
    field("materials.*.drag_tangential_width",    Choice(&["diameter", "perimeter"]), "", ANY,        Default("\"diameter\""), "tangential drag width", "What tangential drag refers to: the diameter D, or the perimeter pi D."),
    field("materials.*.added_mass_normal",        Number,          "-",    Range::of(0.0, 100.0),     Default("1.0"), "normal added mass", "Coefficient on the displaced volume, across the line."),
    field("materials.*.added_mass_tangential",    Number,          "-",    Range::of(0.0, 100.0),     Default("0.0"), "tangential added mass", "Coefficient on the displaced volume, along the line."),
    field("materials.*.break_load_n",             Number,          "N",    Range::positive(1e12),     NOT_USED, "breaking load", "Minimum breaking load; the run warns where the tension comes to more."),
    field("materials.*.min_bend_radius_m",        Number,          "m",    Range::positive(1e5),      NOT_USED, "least bending radius", "Smallest radius it may be bent to; the run warns where it is bent more sharply."),

    field("line.*.name",     Name,    "",  ANY,                   Required, "name", "Name of the section, used in channel names and key paths."),
    field("line.*.material", Text,    "",  ANY,                   Required, "material", "Name of its material."),
    field("line.*.length_m", Number,  "m", Range::positive(1e5),  Required, "length", "Unstretched length."),
    field("line.*.segments", Integer, "-", Range::of(1.0, 1e4),   Required, "segments", "Number of segments the section is divided into."),

    field("ends.a.name",        Name,      "",    ANY,                       Required, "name", "Name of the end, used in channel names."),
    field("ends.a.kind",        END_KINDS, "",    ANY,                       Required, "kind", "What holds the end."),
    field("ends.a.position_m",  Triple,    "m",   Range::of(-1e6, 1e6),      Means("given by the start shape"), "position", "Position, z up from still water; held ends need it."),
    field("ends.a.amplitude_m", Triple,    "m",   Range::of(-1e4, 1e4),      Default("[0.0, 0.0, 0.0]"), "motion amplitude", "Amplitude of the prescribed motion of a moving end."),
    field("ends.a.period_s",    Number,    "s",   Range::positive(1e5),      Means("no motion"), "motion period", "Period of the prescribed motion; a moving end needs it."),
    field("ends.a.phase_deg",   Triple,    "deg", Range::of(-360.0, 360.0),  Default("[0.0, 0.0, 0.0]"), "motion phase", "Phase of the prescribed motion."),
    field("ends.a.ramp_s",      Number,    "s",   Range::of(0.0, 1e6),       Default("0.0"), "motion ramp", "The prescribed motion grows smoothly from nothing over this time."),
    field("ends.a.clamp_elevation_deg", Number, "deg", Range::of(-90.0, 90.0),   Means("hinged"), "clamp elevation", "Clamps the end: angle of the line there above the horizontal, going from A to B."),
    field("ends.a.clamp_azimuth_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"),  "clamp azimuth", "Direction of a clamped end in plan, from +x towards +y, going from A to B."),
    field("ends.b.name",        Name,      "",    ANY,                       Required, "name", "Name of the end, used in channel names."),
    field("ends.b.kind",        END_KINDS, "",    ANY,                       Required, "kind", "What holds the end."),
    field("ends.b.position_m",  Triple,    "m",   Range::of(-1e6, 1e6),      Means("given by the start shape"), "position", "Position, z up from still water; held ends need it."),
    field("ends.b.amplitude_m", Triple,    "m",   Range::of(-1e4, 1e4),      Default("[0.0, 0.0, 0.0]"), "motion amplitude", "Amplitude of the prescribed motion of a moving end."),
    field("ends.b.period_s",    Number,    "s",   Range::positive(1e5),      Means("no motion"), "motion period", "Period of the prescribed motion; a moving end needs it."),
    field("ends.b.phase_deg",   Triple,    "deg", Range::of(-360.0, 360.0),  Default("[0.0, 0.0, 0.0]"), "motion phase", "Phase of the prescribed motion."),
    field("ends.b.ramp_s",      Number,    "s",   Range::of(0.0, 1e6),       Default("0.0"), "motion ramp", "The prescribed motion grows smoothly from nothing over this time."),
    field("ends.b.clamp_elevation_deg", Number, "deg", Range::of(-90.0, 90.0),   Means("hinged"), "clamp elevation", "Clamps the end: angle of the line there above the horizontal, going from A to B."),
    field("ends.b.clamp_azimuth_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"),  "clamp azimuth", "Direction of a clamped end in plan, from +x towards +y, going from A to B."),

    field("payload.dry_mass_kg",   Number,         "kg", Range::positive(1e10),   Required, "dry mass", "Mass in air."),
    field("payload.wet_mass_kg",   Number,         "kg", Range::of(-1e10, 1e10),  Means("from the volume"), "wet mass", "Weight in water, as mass. Give this or volume_m3."),
    field("payload.volume_m3",     Number,         "m³", Range::of(0.0, 1e7),     Means("from the wet mass or the shape"), "volume", "Displaced volume. Give this or wet_mass_kg."),
    field("payload.drag_area_m2",  NumberOrTriple, "m²", Range::of(0.0, 1e6),     Means("from the shape"), "drag area", "Drag coefficient times area: one number, or along x, y, z."),
    field("payload.added_mass_kg", NumberOrTriple, "kg", Range::of(0.0, 1e10),    Means("from the shape"), "added mass", "Added mass: one number, or along x, y, z."),
    field("payload.shape.kind",    Choice(&["box", "sphere-and-cylinder"]), "", ANY, Required, "shape", "Form of the payload."),
    shape("payload.shape.length_m",            "box", "box length", "Length, along x."),
    shape("payload.shape.breadth_m",           "box", "box breadth", "Breadth, along y."),
    shape("payload.shape.height_m",            "box", "box height", "Height, along z."),
    shape("payload.shape.sphere_diameter_m",   "sphere-and-cylinder", "sphere diameter", "Diameter of the sphere."),
    shape("payload.shape.cylinder_diameter_m", "sphere-and-cylinder", "cylinder diameter", "Diameter of the upright cylinder."),
    shape("payload.shape.cylinder_length_m",   "sphere-and-cylinder", "cylinder length", "Length of the upright cylinder."),

    field("floats.*.section",       Text,   "",   ANY,                    Required,       "section", "The section they sit on."),
    field("floats.*.from_m",        Number, "m",  Range::of(0.0, 1e5),    Default("0.0"), "from", "Where the stretch begins, from the section's end nearer to A."),
    field("floats.*.to_m",          Number, "m",  Range::positive(1e5),   Means("the section's end"), "to", "Where the stretch ends, from the section's end nearer to A."),
    field("floats.*.lift_kg",       Number, "kg", Range::of(-1e9, 1e9),   Required,       "net lift", "Buoyancy less own weight of all of them, as mass."),
    field("floats.*.mass_kg",       Number, "kg", Range::of(0.0, 1e9),    Default("0.0"), "mass", "Mass of all of them."),
    field("floats.*.drag_area_m2",  Number, "m²", Range::of(0.0, 1e6),    Default("0.0"), "drag area", "Drag coefficient times area of all of them, across the line."),
    field("floats.*.added_mass_kg", Number, "kg", Range::of(0.0, 1e9),    Default("0.0"), "added mass", "Added mass of all of them, across the line."),

    field("clumps.*.name",          Name,           "",   ANY,                  Required, "name", "Name of the body, used in channel names."),
    field("clumps.*.section",       Text,           "",   ANY,                  Required, "section", "The section it hangs on."),
    field("clumps.*.at_m",          Number,         "m",  Range::of(0.0, 1e5),  Required, "place", "Where it hangs, from the section's end nearer to A; at the node nearest to that."),
    field("clumps.*.mass_kg",       Number,         "kg", Range::of(0.0, 1e10), Required, "mass", "Mass in air."),
    field("clumps.*.wet_mass_kg",   Number,         "kg", Range::of(-1e10, 1e10), Required, "wet mass", "Weight in water, as mass; negative for a buoy."),
    field("clumps.*.drag_area_m2",  NumberOrTriple, "m²", Range::of(0.0, 1e6),  Default("0.0"), "drag area", "Drag coefficient times area: one number, or along x, y, z."),
    field("clumps.*.added_mass_kg", NumberOrTriple, "kg", Range::of(0.0, 1e10), Default("0.0"), "added mass", "Added mass: one number, or along x, y, z."),

    field("modules.*.section",             Text,   "",      ANY,                  Required,       "section", "The section they sit on."),
    field("modules.*.from_m",              Number, "m",     Range::of(0.0, 1e5),  Default("0.0"), "from", "Where the stretch begins, from the section's end nearer to A."),
    field("modules.*.to_m",                Number, "m",     Range::positive(1e5), Means("the section's end"), "to", "Where the stretch ends, from the section's end nearer to A."),
    field("modules.*.diameter_m",          Number, "m",     Range::positive(50.0), Required,      "diameter", "Outer diameter of a module."),
    field("modules.*.length_m",            Number, "m",     Range::positive(100.0), Required,     "length", "Length of a module along the line."),
    field("modules.*.pitch_m",             Number, "m",     Range::positive(1e3), Required,       "pitch", "Distance from one module to the next; at least a module's length."),
    field("modules.*.density_kg_per_m3",   Number, "kg/m³", Range::positive(2e4), Required,       "density", "Density of a module's material."),
    field("modules.*.fittings_kg",         Number, "kg",    Range::of(0.0, 1e6),  Default("0.0"), "fittings", "Mass of what holds a module in place, each."),
    field("modules.*.drag_normal",         Number, "-",     Range::of(0.0, 20.0), Default("0.0"), "normal drag", "Normal drag coefficient of a module on its diameter."),

    field("start.shape",         Choice(&["straight", "equilibrium"]), "", ANY,    Default("\"equilibrium\""), "start shape", "How the line lies at time zero: straight and unstretched, or in static equilibrium."),
    field("start.azimuth_deg",   Number, "deg", Range::of(-360.0, 360.0),          Default("0.0"), "start azimuth", "Azimuth of a straight line with a free end, from +x towards +y."),
    field("start.elevation_deg", Number, "deg", Range::of(-90.0, 90.0),            Default("0.0"), "start elevation", "Elevation of a straight line with a free end, positive up."),

    field("solver.method",               Choice(&["static", "quasi", "rk4", "alpha"]), "", ANY, Default("\"alpha\""), "method", "Static equilibrium, quasi-static march, explicit Runge-Kutta, or implicit generalized-alpha."),
    field("solver.duration_s",           Number,  "s", Range::positive(1e6),   Default("600.0"), "duration", "Simulated time."),
    field("solver.time_step_s",          Number,  "s", Range::positive(1e3),   Means("chosen by the solver"), "time step", "Constant time step. Left open it is chosen, and varies with the error for alpha; the run tells."),
    field("solver.step_tolerance",       Number,  "-", Range::positive(1.0),   Default("2e-5"), "step tolerance", "Error alpha allows in a step of varying length: in positions by the line's length L, in velocities by 2 sqrt(g L)."),
    field("solver.rho_inf",              Number,  "-", Range::of(0.0, 1.0),    Default("0.4"),  "rho infinity", "Spectral radius of generalized-alpha at infinite frequency: 0 damps most, 1 not at all."),
    field("solver.max_iterations",       Integer, "-", Range::of(1.0, 1e4),    Default("30"),   "greatest iterations", "Newton iterations a step may take before it is halved."),
    field("solver.position_tolerance_m", Number,  "m", Range::positive(1.0),   Default("1e-5"), "position tolerance", "Newton stops when no node moves by more than this."),
    field("solver.error_estimate",       Boolean, "",  ANY,                    Default("true"), "error estimate", "Whether companion runs estimate the time and mesh error of every result."),

    field("output.interval_s",       Number, "s", Range::positive(1e5), Default("0.5"), "history interval", "Interval of the time history."),
    field("output.shape_interval_s", Number, "s", Range::positive(1e6), Default("5.0"), "shape interval", "Interval of the stored line shapes."),

    field("marks.*.status", STANDINGS, "", ANY, Required, "standing", "Where the number stands, from best to worst: published, derived, calibrated, assumed."),
    field("marks.*.reason", Text,      "", ANY, Required, "reason", "Why this value."),

    field("study.*.name",   Name, "", ANY, Required, "name", "Name of the study, referred to by published values and trends."),
    field("study.*.key",    Text, "", ANY, Required, "key", "The key path that is varied, such as current.speed_m_per_s."),
    field("study.*.values", List, "", ANY, Required, "values", "Its values, in the unit of the key."),
    field("study.*.title",  Text, "", ANY, Default("\"\""), "title", "What the study shows, in one line."),

    field("published.*.name",          Text,       "",  ANY,     Required, "name", "What the value is, in words."),
    field("published.*.channel",       Text,       "",  ANY,     Required, "channel", "Channel of the history, such as tension_n[wire|payload], or of the whole line, such as tension_n."),
    field("published.*.statistic",     STATISTICS, "",  ANY,     Required, "statistic", "What is taken of the channel."),
    field("published.*.window_s",      Pair,       "s", ZERO_UP, WHOLE_RUN, "window", "Window of time for the statistic."),
    field("published.*.value",         Number,     "",  ANY,     Required, "value", "The published value, in the unit of the channel; seconds for times."),
    field("published.*.tolerance_rel", Number,     "-", Range::positive(10.0), NOT_USED, "relative tolerance", "Tolerance relative to the value."),
    field("published.*.tolerance_abs", Number,     "",  Range::positive(f64::INFINITY), NOT_USED, "absolute tolerance", "Tolerance in the unit of the value."),
    field("published.*.source",        Text,       "",  ANY,     Required, "source", "Where it is printed."),
    field("published.*.inputs",        STANDINGS,  "",  ANY,     Required, "inputs", "Standing of the inputs behind the computed value, at worst."),
    field("published.*.fitted",        Boolean,    "",  ANY,     Default("false"), "fitted", "True when an input was fitted to this very number: agreement is then no evidence."),
    field("published.*.out_of_reach",  Text,       "",  ANY,     NOT_USED, "out of reach", "Why the number cannot be reached; the row then reads DIFFERS instead of FAIL."),
    field("published.*.at.study",      Text,       "",  ANY,     Required, "study", "Name of the study."),
    field("published.*.at.value",      Number,     "",  ANY,     Required, "value", "Value of its key."),

    field("trend.*.name",         Text,       "",  ANY,     Required, "name", "The statement, in words."),
    field("trend.*.study",        Text,       "",  ANY,     Required, "study", "The study it is checked along."),
    field("trend.*.channel",      Text,       "",  ANY,     Required, "channel", "Channel of the history, or quantity of the whole line."),
    field("trend.*.statistic",    STATISTICS, "",  ANY,     Required, "statistic", "What is taken of the channel."),
    field("trend.*.window_s",     Pair,       "s", ZERO_UP, WHOLE_RUN, "window", "Window of time for the statistic."),
    field("trend.*.expect",       Choice(&["rises", "falls"]), "", ANY, Required, "expect", "What the statistic does as the study's values grow."),
    field("trend.*.source",       Text,       "",  ANY,     Required, "source", "Where it is printed."),
    field("trend.*.out_of_reach", Text,       "",  ANY,     NOT_USED, "out of reach", "Why the statement cannot be reached; the row then reads DIFFERS instead of FAIL."),
];

const fn table(
    path: &'static str,
    shape: super::TableShape,
    required: bool,
    help: &'static str,
) -> Table {
    Table {
        path,
        shape,
        required,
        help,
    }
}

const fn field(
    path: &'static str,
    kind: Kind,
    unit: &'static str,
    range: Range,
    absent: Absent,
    label: &'static str,
    help: &'static str,
) -> Field {
    Field {
        path,
        label,
        kind,
        unit,
        range,
        absent,
        help,
        only_if: None,
    }
}

/// A dimension of a payload's shape, needed by shapes of one kind and unknown to the others.
const fn shape(
    path: &'static str,
    kind: &'static str,
    label: &'static str,
    help: &'static str,
) -> Field {
    let mut dimension = field(
        path,
        Number,
        "m",
        Range::positive(1e3),
        Required,
        label,
        help,
    );
    dimension.only_if = Some(("kind", kind));
    dimension
}
