//! Every table and field of a ship file: unit, range, default, help.

use crate::case::fields::Absent::{self, Default, Means, Required};
use crate::case::fields::Kind::{self, Boolean, Choice, Integer, List, Number, Text, Triple};
use crate::case::fields::{Field, Range, Schema, Table, TableShape};

/// The ship file.
pub static SHIP: Schema = Schema {
    what: "ship",
    least: "a ship has at least [ship] with a title, length_m and draft_m, and one of [wind], [current], [drift]",
    fields: FIELDS,
    parts: &[],
    tables: TABLES,
};

const ANY: Range = Range::ANY;
const ANGLE: Range = Range::of(-360.0, 360.0);
const AREA: Range = Range::of(0.0, 1e6);
const COEFFICIENT: Range = Range::of(-100.0, 100.0);
const SHIFT: Range = Range::of(-1000.0, 1000.0);
const TURN: Range = Range::of(-90.0, 90.0);
const SIZE: Range = Range::of(0.0, 1000.0);
const STANDINGS: Kind = Choice(&["published", "derived", "calibrated", "assumed"]);
const TABLE: Absent = Means("Fourier series are given instead");
const SERIES: Absent = Means("a table is given instead");

const fn one(path: &'static str, required: bool, help: &'static str) -> Table {
    Table {
        path,
        shape: TableShape::One,
        required,
        help,
    }
}

static TABLES: &[Table] = &[
    one("ship", true, "The ship, and what holds for it as a whole."),
    one(
        "wind",
        false,
        "The wind, and the ship's coefficients in it.",
    ),
    one(
        "current",
        false,
        "The current, and the ship's coefficients in it.",
    ),
    one(
        "drift",
        false,
        "The waves' mean drift, and the ship's coefficients for it.",
    ),
    one(
        "mooring",
        false,
        "The line that holds the ship at its bow, from an anchor on a flat bed.",
    ),
    one(
        "motion",
        false,
        "The ship's motion in its sea, by the statistics of each degree of freedom.",
    ),
    one(
        "rope",
        false,
        "The rope to a platform that follows the motion.",
    ),
    Table {
        path: "published",
        shape: TableShape::List,
        required: false,
        help: "What the source printed of the motion.",
    },
    Table {
        path: "marks",
        shape: TableShape::ByName,
        required: false,
        help: "Where an input comes from when the source does not print it, by key path.",
    },
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

    field("motion.seed", Integer, "-", Range::of(0.0, 4_294_967_295.0), Default("1"), "seed", "Seed of the records: the same seed gives the same record."),
    field("motion.duration_s", Number, "s", Range::positive(1e5), Default("10800.0"), "duration", "Length of a record."),
    field("motion.step_s", Number, "s", Range::of(0.01, 100.0), Default("0.25"), "step", "Step of a record."),
    field("motion.components", Integer, "-", Range::of(10.0, 2000.0), Default("100"), "components", "Regular components of each band of frequencies."),
    field("motion.slow_period_s", Number, "s", Range::positive(1e4), Default("100.0"), "slow period", "Period of the slow motion at the mooring, where the statistics need one."),
    field("motion.hang_point_m", Triple, "m", Range::of(-1000.0, 1000.0), Default("[0.0, 0.0, 0.0]"), "hang point", "The point that the rope hangs from: forward, to port, up of the ship's reference point."),
    field("motion.translation_mean_m", Triple, "m", SHIFT, Default("[0.0, 0.0, 0.0]"), "mean shift", "Mean of surge, sway, heave."),
    field("motion.rotation_mean_deg", Triple, "deg", TURN, Default("[0.0, 0.0, 0.0]"), "mean turn", "Mean of roll, pitch, yaw."),
    field("motion.translation_rms_m", Triple, "m", SIZE, Required, "shift, rms", "Root mean square of surge, sway, heave about nothing, the mean counted in."),
    field("motion.rotation_rms_deg", Triple, "deg", SIZE, Required, "turn, rms", "Root mean square of roll, pitch, yaw about nothing, the mean counted in."),
    field("motion.translation_velocity_rms_m_per_s", Triple, "m/s", SIZE, Required, "velocity, rms", "Root mean square velocity of surge, sway, heave."),
    field("motion.rotation_velocity_rms_deg_per_s", Triple, "deg/s", SIZE, Required, "turning velocity, rms", "Root mean square velocity of roll, pitch, yaw."),
    field("motion.translation_acceleration_rms_m_per_s2", Triple, "m/s²", SIZE, Required, "acceleration, rms", "Root mean square acceleration of surge, sway, heave."),
    field("motion.rotation_acceleration_rms_deg_per_s2", Triple, "deg/s²", SIZE, Required, "turning acceleration, rms", "Root mean square acceleration of roll, pitch, yaw."),

    field("rope.ropeway", Text, "", ANY, Required, "ropeway", "The ropeway's file, from the folder of this one."),
    field("rope.bearing_deg", Number, "deg", ANGLE, Required, "bearing", "Where the platform lies from the hang point, from the bow to port: 0 ahead, 90 abeam to port."),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::fields::unit_suffix;

    #[test]
    fn every_unit_stands_in_its_key() {
        for field in FIELDS {
            match unit_suffix(field.unit) {
                Some(suffix) => assert!(field.key().ends_with(suffix), "{}", field.path),
                None => assert!(matches!(field.unit, "" | "-"), "{}", field.path),
            }
        }
    }
}
