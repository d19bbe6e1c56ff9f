//! Every table and field of a ship file: unit, range, default, help.

use crate::case::fields::Absent::{self, Default, Means, Required};
use crate::case::fields::Kind::{Boolean, Choice, Integer, List, Number, Text, Triple};
use crate::case::fields::{Field, Range, STANDINGS, Schema, Table, TableShape, field, table};

/// The ship file.
pub static SHIP: Schema = Schema {
    what: "ship",
    least: "a ship has at least [ship] with a title, length_m and draft_m, and one of [wind], [current], [drift]",
    fields: std::borrow::Cow::Borrowed(FIELDS),
    parts: std::borrow::Cow::Borrowed(&[]),
    tables: std::borrow::Cow::Borrowed(TABLES),
};

const ANY: Range = Range::ANY;
const ANGLE: Range = Range::of(-360.0, 360.0);
const AREA: Range = Range::of(0.0, 1e6);
const COEFFICIENT: Range = Range::of(-100.0, 100.0);
const SHIFT: Range = Range::of(-1000.0, 1000.0);
const TURN: Range = Range::of(-90.0, 90.0);
const SIZE: Range = Range::of(0.0, 1000.0);
const TABLE: Absent = Means("Fourier series are given instead");
const SERIES: Absent = Means("a table is given instead");

#[rustfmt::skip] // one table a line
static TABLES: &[Table] = &[
    table("ship", TableShape::One, true, "The ship, and what holds for it as a whole."),
    table("wind", TableShape::One, false, "The wind, and the ship's coefficients in it."),
    table("current", TableShape::One, false, "The current, and the ship's coefficients in it."),
    table("drift", TableShape::One, false, "The waves' mean drift, and the ship's coefficients for it."),
    table("mooring", TableShape::One, false, "The line that holds the ship at its bow, from an anchor on a flat bed."),
    table("hull", TableShape::One, false, "The ship's mass and what the water adds to it; matrices in SI units, six numbers for a diagonal or thirty-six by rows."),
    table("motion", TableShape::One, false, "The ship's motion in its sea, by the statistics of each degree of freedom or by its responses to waves."),
    table("coupled", TableShape::One, false, "The ship as a rigid body and its anchor line in time, solved together."),
    table("rope", TableShape::One, false, "The rope to a platform that follows the motion."),
    table("published", TableShape::List, false, "What the source printed of the motion."),
    table("marks", TableShape::ByName, false, "Where an input comes from when the source does not print it, by key path."),
];

#[rustfmt::skip]
static FIELDS: &[Field] = &[
    field("ship.title",  Text, "", ANY, Required, "title", "What the ship is, in one line."),
    field("ship.source", Text, "", ANY, Default("\"\""), "source", "Where the data come from."),
    field("ship.notes",  Text, "", ANY, Default("\"\""), "notes", "What is missing in the source, what was decided."),
    field("ship.length_m", Number, "m", Range::positive(1000.0), Required, "length", "Length over all."),
    field("ship.draft_m", Number, "m", Range::positive(100.0), Required, "draught", "Draught."),
    field("ship.arm_fraction", Number, "-", Range::of(-1.0, 1.0), Default("0.48"), "arm", "Where the mooring holds the ship, forward of its centre, in shares of the length."),
    field("ship.water_density_kg_per_m3", Number, "kg/m³", Range::of(0.0, 3000.0), Default("1025.0"), "water density", "Density of the water."),
    field("ship.air_density_kg_per_m3", Number, "kg/m³", Range::of(0.0, 100.0), Default("1.225"), "air density", "Density of the air."),
    field("ship.gravity_m_per_s2", Number, "m/s²", Range::of(0.0, 100.0), Default("9.80665"), "gravity", "Gravity."),

    field("wind.speed_m_per_s", Number, "m/s", Range::of(0.0, 150.0), Required, "speed", "Speed of the wind."),
    field("wind.towards_deg", Number, "deg", ANGLE, Required, "towards", "Where the wind blows to, from +x towards +y."),
    field("wind.frontal_area_m2", Number, "m²", AREA, Required, "frontal area", "Area above water seen from ahead."),
    field("wind.lateral_area_m2", Number, "m²", AREA, Required, "lateral area", "Area above water seen from the side."),
    list("wind.angle_deg", "deg", Range::of(0.0, 360.0), TABLE, "angles", "Angles of the table, from the bow to where the wind goes, rising from 0 to 180 or to below 360."),
    list("wind.surge", "-", COEFFICIENT, TABLE, "forward", "Coefficients of the force forward, on the frontal area."),
    list("wind.sway", "-", COEFFICIENT, TABLE, "to port", "Coefficients of the force to port, on the lateral area."),
    list("wind.yaw", "-", COEFFICIENT, TABLE, "yaw", "Coefficients of the yaw moment, bow to port, on the lateral area and the length."),
    between("wind.interpolation"),
    list("wind.surge_cosines", "-", COEFFICIENT, SERIES, "forward, cosines", "Amplitudes of cos(0), cos(a), cos(2a), ... of the force forward."),
    list("wind.sway_sines", "-", COEFFICIENT, SERIES, "to port, sines", "Amplitudes of sin(a), sin(2a), ... of the force to port."),
    list("wind.yaw_sines", "-", COEFFICIENT, SERIES, "yaw, sines", "Amplitudes of sin(a), sin(2a), ... of the yaw moment."),

    field("current.speed_m_per_s", Number, "m/s", Range::of(0.0, 20.0), Required, "speed", "Speed of the current over the draught."),
    field("current.towards_deg", Number, "deg", ANGLE, Required, "towards", "Where the current runs to, from +x towards +y."),
    list("current.angle_deg", "deg", Range::of(0.0, 360.0), TABLE, "angles", "Angles of the table, from the bow to where the current goes, rising from 0 to 180 or to below 360."),
    list("current.surge", "-", COEFFICIENT, TABLE, "forward", "Coefficients of the force forward, on length times draught."),
    list("current.sway", "-", COEFFICIENT, TABLE, "to port", "Coefficients of the force to port, on length times draught."),
    list("current.yaw", "-", COEFFICIENT, TABLE, "yaw", "Coefficients of the yaw moment, bow to port, on length squared times draught."),
    between("current.interpolation"),
    list("current.surge_cosines", "-", COEFFICIENT, SERIES, "forward, cosines", "Amplitudes of cos(0), cos(a), cos(2a), ... of the force forward."),
    list("current.sway_sines", "-", COEFFICIENT, SERIES, "to port, sines", "Amplitudes of sin(a), sin(2a), ... of the force to port."),
    list("current.yaw_sines", "-", COEFFICIENT, SERIES, "yaw, sines", "Amplitudes of sin(a), sin(2a), ... of the yaw moment."),

    field("drift.significant_height_m", Number, "m", Range::of(0.0, 30.0), Required, "significant height", "Significant height of the waves."),
    field("drift.towards_deg", Number, "deg", ANGLE, Required, "towards", "Where the waves run to, from +x towards +y."),
    list("drift.angle_deg", "deg", Range::of(0.0, 360.0), TABLE, "angles", "Angles of the table, from the bow to where the waves go, rising from 0 to 180 or to below 360."),
    list("drift.surge", "-", COEFFICIENT, TABLE, "forward", "Coefficients of the force forward, on rho g L Hs²/16."),
    list("drift.sway", "-", COEFFICIENT, TABLE, "to port", "Coefficients of the force to port, on rho g L Hs²/16."),
    list("drift.yaw", "-", COEFFICIENT, TABLE, "yaw", "Coefficients of the yaw moment, bow to port, on rho g L² Hs²/16."),
    between("drift.interpolation"),
    list("drift.surge_cosines", "-", COEFFICIENT, SERIES, "forward, cosines", "Amplitudes of cos(0), cos(a), cos(2a), ... of the force forward."),
    list("drift.sway_sines", "-", COEFFICIENT, SERIES, "to port, sines", "Amplitudes of sin(a), sin(2a), ... of the force to port."),
    list("drift.yaw_sines", "-", COEFFICIENT, SERIES, "yaw, sines", "Amplitudes of sin(a), sin(2a), ... of the yaw moment."),

    field("mooring.length_m", Number, "m", Range::positive(1e5), Required, "length", "Length of the line, unstretched."),
    field("mooring.wet_weight_kg_per_m", Number, "kg/m", Range::positive(1e5), Required, "wet weight", "Weight in water, as mass."),
    field("mooring.ea_n", Number, "N", Range::positive(1e13), Required, "axial stiffness", "EA of the line."),
    field("mooring.depth_m", Number, "m", Range::positive(1e4), Required, "depth", "Depth of the flat bed below still water."),
    field("mooring.fairlead_z_m", Number, "m", Range::of(-100.0, 100.0), Default("0.0"), "fairlead height", "Height above still water of the point that the ship holds the line by."),

    field("hull.mass_kg", Number, "kg", Range::positive(1e10), Required, "mass", "Mass of the ship."),
    field("hull.gyration_m", Triple, "m", Range::positive(1000.0), Required, "radii of gyration", "Radii of gyration in roll, pitch and yaw about the centre of gravity."),
    field("hull.centre_m", Triple, "m", Range::of(-1000.0, 1000.0), Default("[0.0, 0.0, 0.0]"), "centre of gravity", "Centre of gravity from the reference point: forward, to port, up."),
    list("hull.added_mass_si", "", ANY, Means("none"), "added mass", "Added mass in SI units, surge to yaw: six numbers for the diagonal, or thirty-six by rows."),
    list("hull.damping_si", "", ANY, Means("none"), "damping", "Damping in SI units, beside that of wind and current on the moving ship: six numbers, or thirty-six by rows."),
    list("hull.restoring_si", "", ANY, Means("none"), "restoring", "Restoring by water and weight in SI units, without the mooring: six numbers, or thirty-six by rows."),

    field("motion.by", Choice(&["statistics", "responses"]), "", ANY, Default("\"statistics\""), "made from", "Whether the motion is made to published statistics, or is the ship's response to a sea."),
    field("motion.seed", Integer, "-", Range::of(0.0, 4_294_967_295.0), Default("1"), "seed", "Seed of the records: the same seed gives the same record."),
    field("motion.duration_s", Number, "s", Range::positive(1e5), Default("10800.0"), "duration", "Length of a record."),
    field("motion.step_s", Number, "s", Range::of(0.01, 100.0), Default("0.25"), "step", "Step of a record."),
    field("motion.components", Integer, "-", Range::of(10.0, 2000.0), Default("100"), "components", "Regular components: of each band of frequencies, or of the sea."),
    field("motion.hang_point_m", Triple, "m", Range::of(-1000.0, 1000.0), Default("[0.0, 0.0, 0.0]"), "hang point", "The point that the rope hangs from: forward, to port, up of the ship's reference point."),
    by("statistics", field("motion.slow_period_s", Number, "s", Range::positive(1e4), Default("100.0"), "slow period", "Period of the slow motion at the mooring, where the statistics need one.")),
    by("statistics", field("motion.translation_mean_m", Triple, "m", SHIFT, Default("[0.0, 0.0, 0.0]"), "mean shift", "Mean of surge, sway, heave.")),
    by("statistics", field("motion.rotation_mean_deg", Triple, "deg", TURN, Default("[0.0, 0.0, 0.0]"), "mean turn", "Mean of roll, pitch, yaw.")),
    by("statistics", field("motion.translation_rms_m", Triple, "m", SIZE, Required, "shift, rms", "Root mean square of surge, sway, heave about nothing, the mean counted in.")),
    by("statistics", field("motion.rotation_rms_deg", Triple, "deg", SIZE, Required, "turn, rms", "Root mean square of roll, pitch, yaw about nothing, the mean counted in.")),
    by("statistics", field("motion.translation_velocity_rms_m_per_s", Triple, "m/s", SIZE, Required, "velocity, rms", "Root mean square velocity of surge, sway, heave.")),
    by("statistics", field("motion.rotation_velocity_rms_deg_per_s", Triple, "deg/s", SIZE, Required, "turning velocity, rms", "Root mean square velocity of roll, pitch, yaw.")),
    by("statistics", field("motion.translation_acceleration_rms_m_per_s2", Triple, "m/s²", SIZE, Required, "acceleration, rms", "Root mean square acceleration of surge, sway, heave.")),
    by("statistics", field("motion.rotation_acceleration_rms_deg_per_s2", Triple, "deg/s²", SIZE, Required, "turning acceleration, rms", "Root mean square acceleration of roll, pitch, yaw.")),
    by("responses", field("motion.responses", Text, "", ANY, Required, "responses", "CSV file of responses, from the folder of this one: heading_deg (may be left out), period_s, surge_m_per_m, surge_phase_deg and so on.")),
    by("responses", field("motion.spectrum", Choice(&["jonswap", "pierson-moskowitz"]), "", ANY, Default("\"jonswap\""), "spectrum", "Spectrum of the waves.")),
    by("responses", field("motion.significant_height_m", Number, "m", Range::of(0.0, 30.0), Required, "significant height", "Significant height of the waves.")),
    by("responses", field("motion.peak_period_s", Number, "s", Range::of(0.5, 60.0), Required, "peak period", "Peak period of the waves.")),
    by("responses", field("motion.gamma", Number, "-", Range::of(1.0, 20.0), Default("3.3"), "peak enhancement", "Peak enhancement of a JONSWAP spectrum; a Pierson-Moskowitz spectrum has 1.")),
    by("responses", field("motion.waves_towards_deg", Number, "deg", ANGLE, Required, "waves towards", "Where the waves run to, from +x towards +y.")),
    by("responses", field("motion.heading_deg", Number, "deg", ANGLE, Means("the heading at which the ship rests"), "heading", "Where the bow points, from +x towards +y.")),

    field("coupled.duration_s", Number, "s", Range::positive(1e5), Default("1800.0"), "duration", "Time that is followed."),
    field("coupled.step_s", Number, "s", Range::of(0.001, 10.0), Default("0.1"), "step", "Step of the march."),
    field("coupled.segments", Integer, "-", Range::of(8.0, 1000.0), Default("40"), "segments", "Segments of the anchor line; an even number, as half of them tell the error of the mesh."),
    field("coupled.ramp_s", Number, "s", Range::of(0.0, 1e5), Default("60.0"), "ramp", "The waves grow smoothly from nothing over this time."),
    field("coupled.from_s", Number, "s", Range::of(0.0, 1e5), Default("300.0"), "statistics from", "Statistics count from here on."),
    field("coupled.start_yaw_deg", Number, "deg", Range::of(-30.0, 30.0), Default("0.0"), "start turned", "The ship is let go turned by this about its fairlead, bow to port."),
    field("coupled.line_mass_kg_per_m", Number, "kg/m", Range::positive(1e5), Required, "line mass", "Mass of the anchor line in air."),
    field("coupled.line_diameter_m", Number, "m", Range::positive(10.0), Required, "line diameter", "Diameter of the anchor line, for drag and added mass."),
    field("coupled.drag_normal", Number, "-", Range::of(0.0, 100.0), Default("0.0"), "normal drag", "Drag coefficient across the line."),
    field("coupled.drag_tangential", Number, "-", Range::of(0.0, 100.0), Default("0.0"), "tangential drag", "Drag coefficient along the line."),
    field("coupled.added_mass_normal", Number, "-", Range::of(0.0, 100.0), Default("1.0"), "normal added mass", "Added mass coefficient across the line."),

    field("rope.ropeway", Text, "", ANY, Required, "ropeway", "The ropeway's file, from the folder of this one."),
    field("rope.bearing_deg", Number, "deg", ANGLE, Required, "bearing", "Where the platform lies from the hang point, from the bow to port: 0 ahead, 90 abeam to port."),
    field("rope.follows", Choice(&["motion", "coupled"]), "", ANY, Default("\"motion\""), "follows", "Which motion the rope's end follows: that of [motion], or that of the ship coupled with its anchor line."),
    field("rope.records", Integer, "-", Range::of(2.0, 1000.0), Default("10"), "records", "Records, of as many seeds, for the greatest tension to expect."),

    field("published.*.name", Text, "", ANY, Required, "name", "What it is, in words."),
    field("published.*.quantity", Text, "", ANY, Required, "quantity", "Degree of freedom, displacement or rate, and statistic, such as pitch.velocity.rms."),
    field("published.*.value", Number, "", ANY, Required, "value", "The published value, in the unit of the quantity."),
    field("published.*.tolerance_rel", Number, "-", Range::of(0.0, 10.0), Means("no relative tolerance"), "tolerance", "Tolerance relative to the value."),
    field("published.*.tolerance_abs", Number, "", Range::of(0.0, 1e9), Means("no absolute tolerance"), "tolerance", "Tolerance in the unit of the value."),
    field("published.*.source", Text, "", ANY, Required, "source", "Where it is printed."),
    field("published.*.inputs", STANDINGS, "", ANY, Required, "inputs", "Standing of the inputs behind the computed value, at worst."),
    field("published.*.fitted", Boolean, "", ANY, Default("false"), "fitted", "True when an input was fitted to this very number."),
    field("published.*.out_of_reach", Text, "", ANY, Means("within reach"), "out of reach", "Why the number is out of reach."),

    field("marks.*.status", STANDINGS, "", ANY, Required, "standing", "Where the number stands, from best to worst: published, derived, calibrated, assumed."),
    field("marks.*.reason", Text, "", ANY, Required, "reason", "Why this value."),
];

/// A field of motions made from one source only.
const fn by(source: &'static str, mut field: Field) -> Field {
    field.only_if = Some(("by", source));
    field
}

const fn list(
    path: &'static str,
    unit: &'static str,
    range: Range,
    absent: Absent,
    label: &'static str,
    help: &'static str,
) -> Field {
    field(path, List, unit, range, absent, label, help)
}

const fn between(path: &'static str) -> Field {
    field(
        path,
        Choice(&["linear", "cubic"]),
        "",
        ANY,
        Default("\"cubic\""),
        "interpolation",
        "What lies between the points of the table: straight lines, or the periodic cubic spline.",
    )
}
