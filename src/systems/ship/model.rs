//! A ship at a single-point mooring as its file gives it: one struct a table of the file, one field a key.

mod loads;
mod motion;

use std::collections::BTreeMap;

pub(crate) use loads::CoefficientKeys;
pub use loads::{CurrentLoad, DriftLoad, Interpolation, LoadCoefficients, WindLoad};
pub(crate) use motion::MotionKeys;
pub use motion::{MotionSettings, MotionSource, SpectrumKind};

use crate::case::Mark;
use crate::case::fields::{of, positive};
use crate::case::schema::{table, words};
use crate::published::PublishedNumber;

table! {
    /// A ship file.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Ship => ShipKeys {}
    tables {
        /// The ship, water, air and gravity.
        ship: Particulars;
        /// The wind, and the ship's coefficients in it.
        wind: Option<WindLoad>;
        /// The current, and the ship's coefficients in it.
        current: Option<CurrentLoad>;
        /// Mean wave drift, and the ship's coefficients for it.
        drift: Option<DriftLoad>;
        /// The mooring line at the bow, from an anchor on a flat seabed.
        mooring: Option<Mooring>;
        /// Mass, added mass, damping and restoring; matrices in SI units, six numbers for a diagonal or thirty-six by rows.
        hull: Option<Hull>;
        /// The ship's motion in waves, by the statistics of each degree of freedom or by its RAOs.
        motion: Option<MotionSettings>;
        /// The coupled analysis of the ship as a rigid body and its anchor line in the time domain.
        coupled: Option<CoupledSettings>;
        /// The rope to a platform that follows the motion.
        rope: Option<PlatformRope>;
        /// Published results of the motion.
        published: Vec<PublishedNumber>;
        /// Where an input comes from when the source does not print it, by key path.
        marks: BTreeMap<String, Mark>;
    }
}

table! {
    /// The ship, water, air and gravity.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Particulars => ParticularsKeys {
        /// What the ship is, in one line.
        title: String, "title";
        /// Where the data come from.
        source: String = "", "source";
        /// What is missing in the source, what was decided.
        notes: String = "", "notes";
        /// Why the tolerances of the published values are what they are, where a value states no reason of its own.
        tolerance_reason: Option<String>, "reason of the tolerances", absent "none stated";
        /// Length over all.
        length_m: f64, "length", range positive(1000.0);
        /// Draught.
        draft_m: f64, "draught", range positive(100.0);
        /// Mooring point forward of the ship's centre, as a fraction of the length.
        arm_fraction: f64 = 0.48, "arm", range of(-1.0, 1.0);
        /// Density of the water.
        water_density_kg_per_m3: f64 = 1025.0, "water density", range of(0.0, 3000.0);
        /// Density of the air.
        air_density_kg_per_m3: f64 = 1.225, "air density", range of(0.0, 100.0);
        /// Gravity.
        gravity_m_per_s2: f64 = 9.80665, "gravity", range of(0.0, 100.0);
    }
}

impl Particulars {
    /// From the ship's centre forward to the mooring point \[m\]: ARM of eq. (2).
    #[must_use]
    pub fn arm(&self) -> f64 {
        self.arm_fraction * self.length_m
    }
}

table! {
    /// The mooring line at the bow, from an anchor on a flat seabed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Mooring => MooringKeys {
        /// Unstretched length of the line.
        length_m: f64, "length", range positive(1e5);
        /// Weight in water, as mass.
        wet_weight_kg_per_m: f64, "wet weight", range positive(1e5);
        /// Axial stiffness EA of the line.
        ea_n: f64, "axial stiffness", range positive(1e13);
        /// Depth of the flat seabed below still water.
        depth_m: f64, "depth", range positive(1e4);
        /// Height of the fairlead above still water.
        fairlead_z_m: f64 = 0.0, "fairlead height", range of(-100.0, 100.0);
    }
}

table! {
    /// Mass, added mass, damping and restoring about the ship's reference point: amidships, on the centre line, in the still water
    /// line. Matrices are in SI units, in the order surge, sway, heave, roll, pitch, yaw: six numbers are the diagonal,
    /// thirty-six the rows.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Hull => HullKeys {
        /// Mass of the ship.
        mass_kg: f64, "mass", range positive(1e10);
        /// Radii of gyration in roll, pitch and yaw about the centre of gravity.
        gyration_m: [f64; 3], "radii of gyration", range positive(1000.0);
        /// Centre of gravity from the reference point: forward, to port, up.
        centre_m: [f64; 3] = [0.0, 0.0, 0.0], "centre of gravity", range of(-1000.0, 1000.0);
        /// Added mass in SI units, surge to yaw: six numbers for the diagonal, or thirty-six by rows.
        added_mass_si: Vec<f64>, "added mass", unit "", absent "none";
        /// Damping in SI units, without that of wind and current on the moving ship: six numbers, or thirty-six by rows.
        damping_si: Vec<f64>, "damping", unit "", absent "none";
        /// Hydrostatic restoring in SI units, without the mooring: six numbers, or thirty-six by rows.
        restoring_si: Vec<f64>, "restoring", unit "", absent "none";
    }
}

table! {
    /// The coupled analysis of the ship and its anchor line in the time domain.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CoupledSettings => CoupledSettingsKeys {
        /// Simulated time.
        duration_s: f64 = 1800.0, "duration", range positive(1e5);
        /// Time step.
        step_s: f64 = 0.1, "step", range of(0.001, 10.0);
        /// Segments of the anchor line; an even number, because half of them give the mesh error.
        segments: usize = 40, "segments", range of(8.0, 1000.0);
        /// Time over which the waves grow from zero.
        ramp_s: f64 = 60.0, "ramp", range of(0.0, 1e5);
        /// Time from which statistics count.
        from_s: f64 = 300.0, "statistics from", range of(0.0, 1e5);
        /// Initial yaw angle about the fairlead, bow to port.
        start_yaw_deg: f64 = 0.0, "initial yaw", range of(-30.0, 30.0);
        /// Mass of the anchor line in air.
        line_mass_kg_per_m: f64, "line mass", range positive(1e5);
        /// Diameter of the anchor line, for drag and added mass.
        line_diameter_m: f64, "line diameter", range positive(10.0);
        /// Normal drag coefficient of the line.
        drag_normal: f64 = 0.0, "normal drag", range of(0.0, 100.0);
        /// Tangential drag coefficient of the line.
        drag_tangential: f64 = 0.0, "tangential drag", range of(0.0, 100.0);
        /// Normal added mass coefficient of the line.
        added_mass_normal: f64 = 1.0, "normal added mass", range of(0.0, 100.0);
    }
}

table! {
    /// The rope to a platform that follows the motion.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PlatformRope => RopeKeys {
        /// The ropeway's file, relative to the folder of this one.
        ropeway: String, "ropeway";
        /// Bearing of the platform from the hang-off point, from the bow to port: 0 ahead, 90 abeam to port.
        bearing_deg: f64, "bearing", range of(-360.0, 360.0);
        /// Motion that the rope's end follows: that of `[motion]`, or that of the coupled analysis.
        follows: Follows = Follows::Motion, "follows";
        /// Records, of as many seeds, for the expected maximum tension.
        records: usize = 10, "records", range of(2.0, 1000.0);
    }
}

words! {
    /// Motion that the rope's end follows.
    #[derive(Default)]
    pub enum Follows {
        /// That of `[motion]`.
        #[default]
        Motion = "motion",
        /// That of the coupled analysis.
        Coupled = "coupled",
    }
}
