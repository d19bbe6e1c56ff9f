//! The table of fields and the table of tables. Ranges are wide: they catch slips (millimetres
//! typed as metres, a lost minus sign), not unusual cables.

use super::Absent::{Default, Means, Required, RequiredWithout};
use super::Kind::{
    Boolean, Choice, Integer, List, Name, Number, NumberOrChoice, NumberOrList, NumberOrText,
    NumberOrTriple, NumbersOrWords, Pair, Text, Triple, Words,
};
use super::TableShape::{ByName, List as ListOf, One};
use super::{Absent, Field, Kind, Range, Table, field};

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
    "mean_peak",
    "mean_trough",
    "arc_of_max",
    "arc_of_min",
    "greatest_fall",
    "turns",
    "peaks",
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
    table("waves", One, false, "Waves; absent means a calm sea."),
    table(
        "seabed",
        One,
        false,
        "The sea bed under the line, level or sloping.",
    ),
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
        "payload.rotation",
        One,
        false,
        "How the payload turns about the end of the line; absent means that it is a point.",
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
        "files",
        ByName,
        false,
        "Files that the case names, carried with it, by their names.",
    ),
    table(
        "traveller",
        One,
        false,
        "A body that travels along the line at a given speed.",
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
        "modes",
        One,
        false,
        "Natural modes about the static shape, told beside the results of a run.",
    ),
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
        "published.*.change_from",
        One,
        false,
        "The point of a study from which this row's value is the change.",
    ),
    table(
        "published.*.ratio_to",
        One,
        false,
        "The point of a study by which this row's value is divided.",
    ),
    table(
        "published_curve",
        ListOf,
        false,
        "A published curve over time that a channel is held against.",
    ),
    table(
        "published_curve.*.at",
        One,
        false,
        "The point of a study this curve belongs to.",
    ),
    table(
        "trend",
        ListOf,
        false,
        "A published statement of trend, checked along a study.",
    ),
    table(
        "trial",
        ListOf,
        false,
        "One way in which a hard case is computed, and what must come of it.",
    ),
];

/// Every field of the case file, in the order in which people read it.
#[rustfmt::skip] // one field a line: this is a table to be read down its columns
pub static FIELDS: &[Field] = &[
    field("case.title",  Text, "", ANY, Required,    "title", "One line that says what the case is."),
    field("case.source", Text, "", ANY, Default("\"\""), "source", "Where the data come from."),
    field("case.notes",  Text, "", ANY, Default("\"\""), "notes", "The scene, what the source leaves out, what was decided."),
    field("case.beside", Words, "", ANY, Means("none"), "beside", "Names of other case files whose stored runs are listed here too, to be laid over this case's."),

    field("environment.gravity_m_per_s2",             Number, "m/s²",  Range::of(0.0, 100.0),    Default("9.80665"), "gravity", "Acceleration of gravity, downwards."),
    field("environment.water_density_kg_per_m3",      Number, "kg/m³", Range::of(0.0, 2e4),      Default("1025.0"),  "water density", "Density of the water; it sets buoyancy, drag and added mass."),
    field("environment.kinematic_viscosity_m2_per_s", Number, "m²/s",  Range::positive(1.0),     Default("1.19e-6"), "kinematic viscosity", "Kinematic viscosity of the water, for Reynolds numbers."),

    field("environment.water_surface", Choice(&["ignored", "crossed"]), "", ANY, Default("\"ignored\""), "water surface", "Whether the line leaves the water: with ignored all of it counts as under water, at any height."),

    field("current.speed_m_per_s", NumberOrList, "m/s", Range::of(-20.0, 20.0),    Required,       "current speed", "Speed of the current: one number, or one for each depth."),
    field("current.direction_deg", NumberOrList, "deg", Range::of(-360.0, 360.0),  Default("0.0"), "current direction", "Where the water flows to, from +x towards +y: one number, or one for each depth."),
    field("current.depth_m",       List,         "m",   Range::of(0.0, 2e4),       Means("the same at every depth"), "current depths", "Depths below still water, increasing; linear in between, constant beyond."),

    field("waves.kind",            Choice(&["regular", "irregular"]), "", ANY, Required, "waves", "Regular waves, or irregular ones from a spectrum."),
    only("kind", "regular",   field("waves.height_m",             Number,  "m",   Range::of(0.0, 100.0),    Required,       "wave height", "Height of regular waves from trough to crest.")),
    only("kind", "regular",   field("waves.period_s",             Number,  "s",   Range::of(0.1, 1e3),      Required,       "wave period", "Period of regular waves.")),
    only("kind", "regular",   field("waves.phase_deg",            Number,  "deg", Range::of(-360.0, 360.0), Default("0.0"), "wave phase", "Lead of the crest over x = y = 0 at time zero.")),
    only("kind", "irregular", field("waves.significant_height_m", Number,  "m",   Range::of(0.0, 50.0),     Required,       "significant height", "Four times the root mean square elevation.")),
    only("kind", "irregular", field("waves.peak_period_s",        Number,  "s",   Range::of(0.1, 1e3),      Required,       "peak period", "Period of the spectrum's peak.")),
    only("kind", "irregular", field("waves.spectrum", Choice(&["jonswap", "pierson-moskowitz"]), "", ANY,   Default("\"jonswap\""), "spectrum", "How the energy of irregular waves is spread over frequency.")),
    only("kind", "irregular", field("waves.gamma",                Number,  "-",   Range::of(1.0, 20.0),     Default("3.3"), "peak enhancement", "Gamma of a JONSWAP spectrum; 1 is Pierson-Moskowitz.")),
    only("kind", "irregular", field("waves.components",           Integer, "-",   Range::of(1.0, 1e4),      Default("100"), "components", "Regular components that irregular waves are made of, of equal energy.")),
    only("kind", "irregular", field("waves.seed",                 Integer, "-",   Range::of(0.0, 9e15),     Default("1"),   "seed", "Of the random frequencies and phases: the same seed, the same waves.")),
    field("waves.direction_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"), "wave direction", "Where the waves run to, from +x towards +y."),
    field("waves.depth_m",         Number, "m",   Range::positive(2e4),     Means("that of the sea bed, or deep water"), "sea depth", "Depth that the waves feel, where there is no [seabed]."),
    field("waves.ramp_s",          Number, "s",   Range::of(0.0, 1e6),      Default("0.0"), "wave ramp", "The waves grow smoothly from nothing over this time."),
    field("waves.stretching",      Choice(&["none", "vertical", "wheeler", "linear"]), "", ANY, Default("\"vertical\""), "stretching", "Above still water: the formula as it stands, as at still water, still water moved to the surface (Wheeler), or a straight line."),
    field("waves.decay",           Choice(&["airy", "airy-cut", "logarithmic"]), "", ANY, Default("\"airy\""), "decay with depth", "Airy's theory, the same ending at decay_depth_m, or 1 - ln(1 + (e - 1) d / decay_depth_m)."),
    field("waves.decay_depth_m",   Number, "m",   Range::positive(2e4),     Default("200.0"), "decay depth", "Depth below which nothing moves, where the decay is not airy."),
    field("waves.gauge_m",         Pair,   "m",   Range::of(-1e6, 1e6),    Means("over end B where it has a position, else over end A"), "gauge", "Where the height of the waves is recorded, x and y."),
    field("waves.load",            Choice(&["morison", "inertia"]), "", ANY, Default("\"morison\""), "load", "Of the water's motion: velocity and acceleration, or the acceleration alone, with drag as in water that the waves leave still."),

    field("seabed.depth_m",               Number, "m",      Range::of(0.0, 2e4),   Required,       "depth", "Depth of the bed below still water, at depth_at_m where it slopes."),
    field("seabed.depth_at_m",            Pair,   "m",      Range::of(-1e6, 1e6),  Default("[0.0, 0.0]"), "place of the depth", "Where the bed has that depth, x and y; matters on a slope."),
    field("seabed.slope_deg",             Number, "deg",    Range::of(-80.0, 80.0), Default("0.0"), "slope", "How steeply the bed rises towards slope_azimuth_deg; negative where it falls."),
    field("seabed.slope_azimuth_deg",     Number, "deg",    Range::of(-360.0, 360.0), Default("0.0"), "slope azimuth", "Direction in which the bed rises, from +x towards +y."),
    field("seabed.stiffness_n_per_m3",    Number, "N/m³",   Range::positive(1e12), Default("1.0e5"), "stiffness", "Push of the bed per area and depth below it."),
    field("seabed.damping_n_s_per_m3",    Number, "N s/m³", Range::of(0.0, 1e12),  Default("0.0"), "damping", "Push of the bed per area and speed into it; with friction, along the bed as well."),
    field("seabed.friction",              Number, "-",      Range::of(0.0, 10.0),  Means("no friction"), "friction", "Coefficient of friction along the line, and across it unless friction_lateral is given."),
    field("seabed.friction_lateral",      Number, "-",      Range::of(0.0, 10.0),  Means("as along the line"), "friction across", "Coefficient of friction across the line."),
    field("seabed.friction_law",          Choice(&["grip", "zhu-2017"]), "", ANY,  Default("\"grip\""), "friction law", "grip holds at rest and slides beyond; zhu-2017 goes with the velocity and holds nothing."),
    field("seabed.grip_stiffness_n_per_m3", Number, "N/m³", Range::positive(1e12), Means("as the stiffness"), "grip stiffness", "Friction per area and distance pulled, before it slides."),
    field("seabed.slip_speed_m_per_s",    Number, "m/s",    Range::positive(10.0), Default("0.01"), "slip speed", "Below it friction by zhu-2017 is in proportion to the speed."),

    field("materials.*.diameter_m",               Number,          "m",    Range::positive(10.0),     Required, "diameter", "Outer diameter, which drag, buoyancy and added mass refer to."),
    field("materials.*.mass_kg_per_m",            Number,          "kg/m", Range::positive(1e6),      Required, "mass", "Mass in air per unstretched length."),
    field("materials.*.wet_weight_kg_per_m",      Number,          "kg/m", Range::of(-1e6, 1e6),      Means("mass less displaced water"), "wet weight", "Weight in water, as mass per unstretched length; negative floats."),
    field("materials.*.ea_n",                     Number,          "N",    Range::positive(1e13),     RequiredWithout("strain"), "axial stiffness EA", "Tension per strain."),
    field("materials.*.strain",                   List,            "-",    Range::of(0.0, 10.0),      Means("tension is EA times strain"), "table of strains", "Strains of a table in the place of ea_n, rising from 0; smooth in between, straight on beyond the last."),
    field("materials.*.tension_n",                List,            "N",    Range::of(0.0, 1e13),      Means("tension is EA times strain"), "table of tensions", "Tensions at those strains, rising from 0."),
    field("materials.*.dynamic_stiffness",        Choice(&["none", "secant", "about-the-mean"]), "", ANY, Default("\"none\""), "dynamic stiffness", "Stiffness of a fibre rope that goes with its past tension: through the origin, or about the mean state."),
    field("materials.*.dynamic_alpha",            Number,          "-",    Range::positive(1e4),      NOT_USED, "alpha", "alpha of EA by breaking load = alpha + beta Lm - gamma La, in motion."),
    field("materials.*.dynamic_beta",             Number,          "-",    Range::of(0.0, 1e3),       Default("0.0"), "beta", "beta, by the mean of the past tension Lm in percent of the breaking load."),
    field("materials.*.dynamic_gamma",            Number,          "-",    Range::of(0.0, 1e3),       Default("0.0"), "gamma", "gamma, by the deviation La of the tension from its mean in percent of the breaking load."),
    field("materials.*.mean_window_s",            Number,          "s",    Range::positive(1e6),      Means("all of the past"), "window of the mean", "Time over which the past tension is averaged."),
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
    field("ends.a.release_s",   Number,    "s",   Range::of(0.0, 1e6),       Means("never"), "release", "A held end is let go at this time."),
    field("ends.a.motion", Choice(&["harmonic", "table", "irregular", "vessel"]), "", ANY, Default("\"harmonic\""), "motion", "How a moving end moves: in harmonics, along a table, irregularly, or as a vessel in the waves."),
    field("ends.a.motion_file", Text, "", ANY,                                     NOT_USED, "motion file", "CSV file beside the case: time_s,x_m,y_m,z_m from the position, or a vessel's responses over period_s."),
    field("ends.a.rms_m",         Triple, "m", Range::of(0.0, 1e3),     NOT_USED, "motion rms", "Root mean square of an irregular motion along x, y, z."),
    field("ends.a.peak_period_s", Number, "s", Range::positive(1e5),    NOT_USED, "motion peak period", "Period of the peak of an irregular motion's spectrum."),
    field("ends.a.gamma",         Number, "-", Range::of(1.0, 20.0),    Default("3.3"), "motion peak enhancement", "Gamma of an irregular motion's JONSWAP spectrum."),
    field("ends.a.components",    Integer, "-", Range::of(1.0, 1e4),    Default("100"), "motion components", "Harmonics an irregular motion is made of along each axis."),
    field("ends.a.seed",          Integer, "-", Range::of(0.0, 9e15),   Default("1"),   "motion seed", "Of an irregular motion: the same seed, the same motion."),
    field("ends.a.heading_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"), "vessel heading", "Where the vessel points, from +x towards +y."),
    field("ends.a.hang_point_m",  Triple, "m", Range::of(-1e3, 1e3),    Default("[0.0, 0.0, 0.0]"), "hang point", "Where the line hangs from the vessel's reference point: forward, to port, up."),
    field("ends.a.clamp_elevation_deg", Number, "deg", Range::of(-90.0, 90.0),   Means("hinged"), "clamp elevation", "Clamps the end: angle of the line there above the horizontal, going from A to B."),
    field("ends.a.clamp_azimuth_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"),  "clamp azimuth", "Direction of a clamped end in plan, from +x towards +y, going from A to B."),
    field("ends.b.name",        Name,      "",    ANY,                       Required, "name", "Name of the end, used in channel names."),
    field("ends.b.kind",        END_KINDS, "",    ANY,                       Required, "kind", "What holds the end."),
    field("ends.b.position_m",  Triple,    "m",   Range::of(-1e6, 1e6),      Means("given by the start shape"), "position", "Position, z up from still water; held ends need it."),
    field("ends.b.amplitude_m", Triple,    "m",   Range::of(-1e4, 1e4),      Default("[0.0, 0.0, 0.0]"), "motion amplitude", "Amplitude of the prescribed motion of a moving end."),
    field("ends.b.period_s",    Number,    "s",   Range::positive(1e5),      Means("no motion"), "motion period", "Period of the prescribed motion; a moving end needs it."),
    field("ends.b.phase_deg",   Triple,    "deg", Range::of(-360.0, 360.0),  Default("[0.0, 0.0, 0.0]"), "motion phase", "Phase of the prescribed motion."),
    field("ends.b.ramp_s",      Number,    "s",   Range::of(0.0, 1e6),       Default("0.0"), "motion ramp", "The prescribed motion grows smoothly from nothing over this time."),
    field("ends.b.release_s",   Number,    "s",   Range::of(0.0, 1e6),       Means("never"), "release", "A held end is let go at this time."),
    field("ends.b.motion", Choice(&["harmonic", "table", "irregular", "vessel"]), "", ANY, Default("\"harmonic\""), "motion", "How a moving end moves: in harmonics, along a table, irregularly, or as a vessel in the waves."),
    field("ends.b.motion_file", Text, "", ANY,                                     NOT_USED, "motion file", "CSV file beside the case: time_s,x_m,y_m,z_m from the position, or a vessel's responses over period_s."),
    field("ends.b.rms_m",         Triple, "m", Range::of(0.0, 1e3),     NOT_USED, "motion rms", "Root mean square of an irregular motion along x, y, z."),
    field("ends.b.peak_period_s", Number, "s", Range::positive(1e5),    NOT_USED, "motion peak period", "Period of the peak of an irregular motion's spectrum."),
    field("ends.b.gamma",         Number, "-", Range::of(1.0, 20.0),    Default("3.3"), "motion peak enhancement", "Gamma of an irregular motion's JONSWAP spectrum."),
    field("ends.b.components",    Integer, "-", Range::of(1.0, 1e4),    Default("100"), "motion components", "Harmonics an irregular motion is made of along each axis."),
    field("ends.b.seed",          Integer, "-", Range::of(0.0, 9e15),   Default("1"),   "motion seed", "Of an irregular motion: the same seed, the same motion."),
    field("ends.b.heading_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"), "vessel heading", "Where the vessel points, from +x towards +y."),
    field("ends.b.hang_point_m",  Triple, "m", Range::of(-1e3, 1e3),    Default("[0.0, 0.0, 0.0]"), "hang point", "Where the line hangs from the vessel's reference point: forward, to port, up."),
    field("ends.b.clamp_elevation_deg", Number, "deg", Range::of(-90.0, 90.0),   Means("hinged"), "clamp elevation", "Clamps the end: angle of the line there above the horizontal, going from A to B."),
    field("ends.b.clamp_azimuth_deg",   Number, "deg", Range::of(-360.0, 360.0), Default("0.0"),  "clamp azimuth", "Direction of a clamped end in plan, from +x towards +y, going from A to B."),

    field("payload.dry_mass_kg",   Number,         "kg", Range::positive(1e10),   Required, "dry mass", "Mass in air."),
    field("payload.wet_mass_kg",   Number,         "kg", Range::of(-1e10, 1e10),  Means("from the volume"), "wet mass", "Weight in water, as mass. Give this or volume_m3."),
    field("payload.volume_m3",     Number,         "m³", Range::of(0.0, 1e7),     Means("from the wet mass or the shape"), "volume", "Displaced volume. Give this or wet_mass_kg."),
    field("payload.drag_area_m2",  NumberOrTriple, "m²", Range::of(0.0, 1e6),     Means("from the shape"), "drag area", "Drag coefficient times area: one number, or along x, y, z."),
    field("payload.added_mass_kg", NumberOrTriple, "kg", Range::of(0.0, 1e10),    Means("from the shape"), "added mass", "Added mass: one number, or along x, y, z."),
    field("payload.release_s",     Number,         "s",  Range::of(0.0, 1e6),     Means("never"), "release", "The payload is cut off the line at this time."),
    field("payload.shape.kind",    Choice(&["box", "sphere-and-cylinder"]), "", ANY, Required, "shape", "Form of the payload."),
    shape("payload.shape.length_m",            "box", "box length", "Length, along x."),
    shape("payload.shape.breadth_m",           "box", "box breadth", "Breadth, along y."),
    shape("payload.shape.height_m",            "box", "box height", "Height, along z."),
    shape("payload.shape.sphere_diameter_m",   "sphere-and-cylinder", "sphere diameter", "Diameter of the sphere."),
    shape("payload.shape.cylinder_diameter_m", "sphere-and-cylinder", "cylinder diameter", "Diameter of the upright cylinder."),
    shape("payload.shape.cylinder_length_m",   "sphere-and-cylinder", "cylinder length", "Length of the upright cylinder."),

    field("payload.rotation.centre_of_gravity_m",  Number, "m", Range::positive(1e3), Required, "centre of gravity", "From the hang point down the axis of the body, about which it is symmetric."),
    field("payload.rotation.inertia_kg_m2",        Number, "kg m²", Range::of(0.0, 1e14), Required, "moment of inertia", "About an axis across, through the centre of gravity."),
    field("payload.rotation.centre_of_buoyancy_m", Number, "m", Range::of(0.0, 1e3), Means("at the centre of gravity"), "centre of buoyancy", "From the hang point down the axis; the added mass sits there too."),
    field("payload.rotation.centre_of_drag_m",     Number, "m", Range::of(0.0, 1e3), Means("at the centre of buoyancy"), "centre of drag", "From the hang point down the axis."),
    field("payload.rotation.added_inertia_kg_m2",  Number, "kg m²", Range::of(0.0, 1e14), Default("0.0"), "added moment of inertia", "Of the water, about an axis across, through the centre of buoyancy."),
    field("payload.rotation.start_tilt_deg",       Number, "deg", Range::of(-180.0, 180.0), Default("0.0"), "start tilt", "Angle of the axis from straight down at time zero, unless the start is an equilibrium."),
    field("payload.rotation.start_azimuth_deg",    Number, "deg", Range::of(-360.0, 360.0), Default("0.0"), "start azimuth", "Which way it is tilted, from +x towards +y."),

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

    field("traveller.name",          Name,   "",    ANY,                     Required, "name", "Name of the body, used in channel names."),
    field("traveller.mass_kg",       Number, "kg",  Range::of(0.0, 1e10),    Required, "mass", "Mass in air."),
    field("traveller.wet_mass_kg",   Number, "kg",  Range::of(-1e10, 1e10),  Required, "wet mass", "Weight in water, as mass."),
    field("traveller.from_m",        Number, "m",   Range::of(0.0, 1e5),     Default("0.0"), "from", "Unstretched length from end A at which it begins."),
    field("traveller.to_m",          Number, "m",   Range::of(0.0, 1e5),     Means("end B"), "to", "Unstretched length from end A at which it stays."),
    field("traveller.speed_m_per_s", Number, "m/s", Range::of(0.0, 1e3),     Required, "speed", "Speed along the unstretched line."),
    field("traveller.start_s",       Number, "s",   Range::of(0.0, 1e7),     Default("0.0"), "start", "Time at which it sets out."),
    field("traveller.ramp_s",        Number, "s",   Range::of(0.0, 1e7),     Default("0.0"), "ramp", "Time in which it comes to its speed."),

    field("modules.*.section",             Text,   "",      ANY,                  Required,       "section", "The section they sit on."),
    field("modules.*.from_m",              Number, "m",     Range::of(0.0, 1e5),  Default("0.0"), "from", "Where the stretch begins, from the section's end nearer to A."),
    field("modules.*.to_m",                Number, "m",     Range::positive(1e5), Means("the section's end"), "to", "Where the stretch ends, from the section's end nearer to A."),
    field("modules.*.diameter_m",          Number, "m",     Range::positive(50.0), Required,      "diameter", "Outer diameter of a module."),
    field("modules.*.length_m",            Number, "m",     Range::positive(100.0), Required,     "length", "Length of a module along the line."),
    field("modules.*.pitch_m",             Number, "m",     Range::positive(1e3), Required,       "pitch", "Distance from one module to the next; at least a module's length."),
    field("modules.*.density_kg_per_m3",   Number, "kg/m³", Range::positive(2e4), Required,       "density", "Density of a module's material."),
    field("modules.*.fittings_kg",         Number, "kg",    Range::of(0.0, 1e6),  Default("0.0"), "fittings", "Mass of what holds a module in place, each."),
    field("modules.*.drag_normal",         Number, "-",     Range::of(0.0, 20.0), Default("0.0"), "normal drag", "Normal drag coefficient of a module on its diameter."),

    field("files.*.text", Text, "", ANY, Required, "carried file", "The text of a file that the case names."),

    field("start.shape",         Choice(&["straight", "equilibrium", "given"]), "", ANY, Default("\"equilibrium\""), "start shape", "How the line lies at time zero: straight and unstretched, in static equilibrium, or as given by the keys below."),
    field("start.azimuth_deg",   Number, "deg", Range::of(-360.0, 360.0),          Default("0.0"), "start azimuth", "Azimuth of a straight line with a free end, from +x towards +y."),
    field("start.elevation_deg", Number, "deg", Range::of(-90.0, 90.0),            Default("0.0"), "start elevation", "Elevation of a straight line with a free end, positive up."),
    field("start.arc_m",         List,   "m",   Range::of(0.0, 1e6),               NOT_USED,       "start arc lengths", "Arc lengths from end A at which a shape is given, from 0 to the whole line; also where the search for an equilibrium begins."),
    field("start.x_m",           List,   "m",   Range::of(-1e6, 1e6),              NOT_USED,       "start x", "x of the line at the arc lengths given; straight in between."),
    field("start.y_m",           List,   "m",   Range::of(-1e6, 1e6),              Means("0 everywhere"), "start y", "y of the line at the arc lengths given."),
    field("start.z_m",           List,   "m",   Range::of(-1e6, 1e6),              NOT_USED,       "start z", "z of the line at the arc lengths given."),
    field("start.from_run",      Text,   "",    ANY,                               NOT_USED,       "start from run", "Directory of a stored run of the same line: its shape, its motion and what it remembers are the start."),
    field("start.velocity_m_per_s", Triple, "m/s", Range::of(-1e3, 1e3),           Default("[0.0, 0.0, 0.0]"), "start velocity", "Velocity of the whole line at time zero, but for ends that are held."),

    field("solver.method",               Choice(&["static", "quasi", "rk4", "alpha", "auto"]), "", ANY, Default("\"alpha\""), "method", "Static equilibrium, quasi-static march, explicit Runge-Kutta, implicit generalized-alpha, or the cheaper of the last two."),
    field("solver.duration_s",           Number,  "s", Range::positive(1e6),   Default("600.0"), "duration", "Simulated time."),
    field("solver.time_step_s",          Number,  "s", Range::positive(1e3),   Means("chosen by the solver"), "time step", "Constant time step. Left open it is chosen, and varies with the error for alpha; the run tells."),
    field("solver.step_tolerance",       Number,  "-", Range::positive(1.0),   Default("2e-5"), "step tolerance", "Error alpha allows in a step of varying length: in positions by the line's length L, in velocities by 2 sqrt(g L)."),
    field("solver.rho_inf",              Number,  "-", Range::of(0.0, 1.0),    Default("0.4"),  "rho infinity", "Spectral radius of generalized-alpha at infinite frequency: 0 damps most, 1 not at all."),
    field("solver.max_iterations",       Integer, "-", Range::of(1.0, 1e4),    Default("30"),   "greatest iterations", "Newton iterations a step may take before it is halved."),
    field("solver.position_tolerance_m", Number,  "m", Range::positive(1.0),   Default("1e-5"), "position tolerance", "Newton stops when no node moves by more than this."),
    field("solver.error_estimate",       Boolean, "",  ANY,                    Default("true"), "error estimate", "Whether companion runs estimate the time and mesh error of every result."),

    field("output.interval_s",       Number, "s", Range::positive(1e5), Default("0.5"), "history interval", "Interval of the time history."),
    field("output.shape_interval_s", Number, "s", Range::positive(1e6), Default("5.0"), "shape interval", "Interval of the stored line shapes."),
    field("output.energy",           Boolean, "", ANY, Default("false"), "energy", "Whether the energy of the line is recorded: kinetic, of position and of stretch, bending and bed."),
    field("output.envelope",         Choice(&["outputs", "steps"]), "", ANY, Default("\"outputs\""), "envelope", "Envelopes along the line at output times or at every step; limits and published extremes ask for every step."),
    field("output.response_from_s",  Number, "s", Range::of(0.0, 1e6), NOT_USED, "response from", "From this time on root mean square displacements along the line are taken, about the mean."),

    field("modes.count",   Integer, "-",  Range::of(1.0, 1000.0), Default("10"), "modes", "How many natural modes, the lowest first."),
    field("modes.near_hz", Number,  "Hz", Range::positive(1e3), NOT_USED, "near", "A frequency, such as that of the waves: the run tells which mode lies nearest."),

    field("marks.*.status", STANDINGS, "", ANY, Required, "standing", "Where the number stands, from best to worst: published, derived, calibrated, assumed."),
    field("marks.*.reason", Text,      "", ANY, Required, "reason", "Why this value."),

    field("study.*.name",   Name, "", ANY, Required, "name", "Name of the study, referred to by published values and trends."),
    field("study.*.key",    Text, "", ANY, Required, "key", "The key path that is varied, such as current.speed_m_per_s."),
    field("study.*.values", NumbersOrWords, "", ANY, Required, "values", "Its values, in the unit of the key, or words that the key takes."),
    field("study.*.title",  Text, "", ANY, Default("\"\""), "title", "What the study shows, in one line."),

    field("published.*.name",          Text,       "",  ANY,     Required, "name", "What the value is, in words."),
    field("published.*.channel",       Text,       "",  ANY,     Required, "channel", "Channel of the history, such as tension_n[wire|payload], or of the whole line, such as tension_n."),
    field("published.*.statistic",     STATISTICS, "",  ANY,     Required, "statistic", "What is taken of the channel."),
    field("published.*.window_s",      Pair,       "s", ZERO_UP, WHOLE_RUN, "window", "Window of time for the statistic."),
    field("published.*.stretch_m",     Pair,       "m", ZERO_UP, Means("the whole line"), "stretch", "Stretch of the line, arc length from end A, for a quantity of the whole line."),
    field("published.*.by_stretch_m",  Pair,       "m", ZERO_UP, NOT_USED, "by the stretch", "The value is that of stretch_m by that of this stretch of the same line."),
    field("published.*.value",         Number,     "",  ANY,     Required, "value", "The published value, in the unit of the channel; seconds for times."),
    field("published.*.tolerance_rel", Number,     "-", Range::positive(10.0), NOT_USED, "relative tolerance", "Tolerance relative to the value."),
    field("published.*.tolerance_abs", Number,     "",  Range::positive(f64::INFINITY), NOT_USED, "absolute tolerance", "Tolerance in the unit of the value."),
    field("published.*.source",        Text,       "",  ANY,     Required, "source", "Where it is printed."),
    field("published.*.inputs",        STANDINGS,  "",  ANY,     Required, "inputs", "Standing of the inputs behind the computed value, at worst."),
    field("published.*.fitted",        Boolean,    "",  ANY,     Default("false"), "fitted", "True when an input was fitted to this very number: agreement is then no evidence."),
    field("published.*.out_of_reach",  Text,       "",  ANY,     NOT_USED, "out of reach", "Why the number cannot be reached; the row then reads DIFFERS instead of FAIL."),
    field("published.*.at.study",      Text,       "",  ANY,     Required, "study", "Name of the study."),
    field("published.*.at.value",      NumberOrText, "",  ANY,     Required, "value", "Value of its key."),
    field("published.*.change_from.study", Text,   "",  ANY,     Required, "study", "Name of the study."),
    field("published.*.change_from.value", NumberOrText, "",  ANY, Required, "value", "Value of its key."),
    field("published.*.ratio_to.study",    Text,         "",  ANY, Required, "study", "Name of the study."),
    field("published.*.ratio_to.value",    NumberOrText, "",  ANY, Required, "value", "Value of its key."),

    field("published_curve.*.name",         Text,       "",  ANY,     Required, "name", "What the curve is, in words."),
    field("published_curve.*.channel",      Text,       "",  ANY,     Required, "channel", "Channel of the history, such as tension_n[wire|payload]."),
    field("published_curve.*.time_s",       List,       "s", ANY,     Required, "times", "Times of the curve's points, increasing."),
    field("published_curve.*.value",        List,       "",  ANY,     Required, "values", "Values there, in the unit of the channel."),
    field("published_curve.*.period_s",     Number,     "s", Range::positive(1e6), NOT_USED, "period", "The curve repeats after this time, and the shift that fits best counts."),
    field("published_curve.*.window_s",     Pair,       "s", ZERO_UP, WHOLE_RUN, "window", "Window of time of the run."),
    field("published_curve.*.tolerance_percent", Number, "", Range::positive(100.0), Required, "tolerance", "Greatest root mean square of the differences, in percent of the curve's greatest size."),
    field("published_curve.*.source",       Text,       "",  ANY,     Required, "source", "Where it is printed."),
    field("published_curve.*.inputs",       STANDINGS,  "",  ANY,     Required, "inputs", "Standing of the inputs behind the computed curve, at worst."),
    field("published_curve.*.out_of_reach", Text,       "",  ANY,     NOT_USED, "out of reach", "Why the curve cannot be reached; the row then reads DIFFERS instead of FAIL."),
    field("published_curve.*.at.study",     Text,       "",  ANY,     Required, "study", "Name of the study."),
    field("published_curve.*.at.value",     NumberOrText, "", ANY,    Required, "value", "Value of its key."),

    field("trend.*.name",         Text,       "",  ANY,     Required, "name", "The statement, in words."),
    field("trend.*.study",        Text,       "",  ANY,     Required, "study", "The study it is checked along."),
    field("trend.*.channel",      Text,       "",  ANY,     Required, "channel", "Channel of the history, or quantity of the whole line."),
    field("trend.*.statistic",    STATISTICS, "",  ANY,     Required, "statistic", "What is taken of the channel."),
    field("trend.*.window_s",     Pair,       "s", ZERO_UP, WHOLE_RUN, "window", "Window of time for the statistic."),
    field("trend.*.stretch_m",    Pair,       "m", ZERO_UP, Means("the whole line"), "stretch", "Stretch of the line, arc length from end A, for a quantity of the whole line."),
    field("trend.*.expect",       Choice(&["rises", "falls"]), "", ANY, Required, "expect", "What the statistic does as the study's values grow."),
    field("trend.*.source",       Text,       "",  ANY,     Required, "source", "Where it is printed."),
    field("trend.*.out_of_reach", Text,       "",  ANY,     NOT_USED, "out of reach", "Why the statement cannot be reached; the row then reads DIFFERS instead of FAIL."),

    field("trial.*.name",     Text,   "",  ANY, Required, "name", "What the trial is, in words."),
    field("trial.*.set",      Words,  "",  ANY, Means("the case as it stands"), "set", "Keys set on top of the case, each as key=value."),
    field("trial.*.rows",     Words,  "",  ANY, Means("all published values"), "rows", "Names of the published values the trial is held against."),
    field("trial.*.refused",  Text,   "",  ANY, Means("it must be computed"), "refused", "Words of the reason for which the trial must be refused."),
    field("trial.*.told",     Text,   "",  ANY, NOT_USED, "told", "Words of a warning that the trial must give."),
    field("trial.*.same_as",  Text,   "",  ANY, NOT_USED, "same as", "A trial further up whose numbers must come out again."),
    field("trial.*.same_rel", Number, "-", Range::positive(1.0), NOT_USED, "same within", "How far they may be apart, relative to the number."),
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

/// The same field, known only to tables whose key has this value.
const fn only(key: &'static str, value: &'static str, mut field: Field) -> Field {
    field.only_if = Some((key, value));
    field
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
