//! A system of lines as the user words it: one struct a table of the file, one field a key.

mod ageing;
mod construct;
mod motion;

use std::collections::BTreeMap;

pub use ageing::{AgeingInputs, CorrosionInputs, GrowthInputs};
pub(crate) use ageing::{AgeingKeys, CorrosionKeys};
pub use motion::{PayoutInputs, SlidingInputs, StartPlacement, SystemStart, WhichEnd};
pub(crate) use motion::{PayoutKeys, SlidingKeys};

use crate::case::fields::ValueType::{Name, NumberOrTriple};
use crate::case::fields::{Conditions, of, positive};
use crate::case::schema::{table, words};
use crate::case::{
    Attachment, CaseInfo, CheckInputs, Clump, Current, Environment, Floats, LoadCaseInputs, Mark,
    Material, Modes, Modules, MotionInterpolation, OneOrMany, Output, PayloadShape, PublishedCurve,
    Seabed, Solver, Start, StatisticsInputs, Study, Trial, WaterSurface, Waves,
};
use crate::reference::{PublishedNumber, PublishedTrend};
use crate::scene::{Hydrodynamics, shape_form};

const BEARING: Conditions = &[("kind", &["free", "body"])];
const ON_BODY: Conditions = &[("kind", &["body"])];
const FREE: Conditions = &[("kind", &["free"])];
const MOVED: Conditions = &[("kind", &["moved"])];

table! {
    /// Everything a system file says.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SystemFile => SystemKeys {}
    tables {
        /// What the system is, for people.
        about: CaseInfo as "system";
        /// Water and gravity.
        environment: Environment, optional;
        /// A current on lines, points and bodies.
        current: Option<Current>;
        /// Waves that run together, in motion.
        waves: Vec<Waves>;
        /// A wind on bodies that state their loads by it.
        wind: Option<SystemWind>;
        /// The sea bed; absent means that none is in reach.
        seabed: Option<Seabed>;
        /// What the lines are made of, by name.
        materials: BTreeMap<String, Material>;
        /// The bodies that points are on, by name.
        bodies: BTreeMap<String, BodyInputs>;
        /// Rigid rods, by name; lines end at their points NAME-a and NAME-b.
        rods: BTreeMap<String, RodInputs>;
        /// The ends of the lines, by name.
        points: BTreeMap<String, PointInputs>;
        /// The lines, from one point to another; none where bodies float or turn by themselves.
        lines: Vec<LineInputs>;
        /// Lines that are paid out or hauled in, in motion.
        payouts: Vec<PayoutInputs>;
        /// Points that slide along lines, in motion.
        sliding_points: Vec<SlidingInputs>;
        /// Offset curves to work out with the system.
        offset_curves: Vec<OffsetCurveInputs>;
        /// Watch circles to work out with the system.
        watch_circles: Vec<WatchCircleInputs>;
        /// Wanted results, and the inputs that are to give them.
        goals: Vec<GoalInputs>;
        /// Marine growth and corrosion of the lines; absent leaves them new.
        ageing: Option<AgeingInputs>;
        /// What is broken; absent leaves the system intact.
        damage: Damage, optional;
        /// Where the run in time begins.
        start: SystemStart, optional;
        /// How the system is computed; at rest where it is absent.
        solver: Option<Solver>;
        /// What is recorded and how often.
        output: Output, optional;
        /// Natural modes about the rest of the system, reported with the results of a run.
        modes: Option<Modes>;
        /// Files that the system names, carried with it, by their names.
        files: BTreeMap<String, Attachment>;
        /// Where an input comes from when the source does not print it, by key path.
        marks: BTreeMap<String, Mark>;
        /// One key varied over a list of values.
        study: Vec<Study>;
        /// Load cases that `seacable sweep` computes, in all combinations.
        load_cases: Vec<LoadCaseInputs>;
        /// How `seacable sweep` sums up the results of load cases.
        statistics: StatisticsInputs, optional;
        /// A limit that the results of load cases are held to.
        checks: Vec<CheckInputs>;
        /// A published value the system is held against.
        published: Vec<PublishedNumber>;
        /// A published curve over time that the run is held against.
        published_curve: Vec<PublishedCurve>;
        /// A published statement of trend, checked along a study.
        trend: Vec<PublishedTrend>;
        /// One way in which a hard case is computed, and what must come of it.
        trial: Vec<Trial>;
    }
}

impl SystemFile {
    /// How a run of the system is computed, in time or of its rest on the mesh; nothing of one whose rest alone is worked out.
    #[must_use]
    pub const fn as_run(&self) -> Option<&Solver> {
        self.solver.as_ref()
    }

    /// Whether its run is of its rest on the mesh.
    #[must_use]
    pub fn is_run_at_rest(&self) -> bool {
        self.as_run().is_some_and(|solver| !solver.is_in_time())
    }

    /// How the system is computed in time; nothing of one at rest.
    #[must_use]
    pub fn in_time(&self) -> Option<&Solver> {
        self.solver.as_ref().filter(|solver| solver.is_in_time())
    }

    /// Coefficients of friction of the bed under a line, along it and across \[-\]: its own, those of the bed, 0 along; across as along.
    #[must_use]
    pub fn friction_under(&self, line: &LineInputs) -> [f64; 2] {
        let bed = self.seabed.as_ref();
        let along = line.friction.or(bed.and_then(|bed| bed.friction));
        let along = along.unwrap_or(0.0);
        let across = line.friction_lateral;
        let across = across.or(bed.and_then(|bed| bed.friction_lateral));
        [along, across.unwrap_or(along)]
    }
}

/// The word for no line in [`Damage::lost_line`].
pub const NO_LINE: &str = "none";

table! {
    /// The damaged condition of a system: what is broken from the start.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Damage => DamageKeys {
        /// The line that is lost, by its name in the results, such as mooring@120 for a copy; none leaves the system intact.
        lost_line: String = NO_LINE, "lost line";
    }
}

table! {
    /// A steady wind.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SystemWind => SystemWindKeys {
        /// Speed, at the height that the loads of the bodies refer to.
        speed_m_per_s: f64, "wind speed", range of(0.0, 100.0);
        /// Direction towards which it blows, from +x towards +y.
        direction_deg: f64 = 0.0, "wind direction", range of(-360.0, 360.0);
    }
}

words! {
    /// What holds a point.
    pub enum PointKind {
        /// Held at its position: an anchor.
        Fixed = "fixed",
        /// Free: where lines meet, a clump weight, a buoy.
        Free = "free",
        /// On a body, at a place in its frame: a fairlead.
        Body = "body",
        /// Follows a prescribed motion about its position; held there at rest.
        Moved = "moved",
    }
}

table! {
    /// A point that lines end at.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PointInputs => PointKeys {
        /// What holds it.
        kind: PointKind, "kind";
        /// Fixed: the place, z up from still water. On a body: the place in its frame. Free: where the search begins.
        position_m: Option<[f64; 3]>, "position", range of(-1e6, 1e6), absent "among its neighbours, or at the end of a line that begins straight";
        /// The body that the point is on.
        body: Option<String>, "body", kind Name, absent "needed for kind body", matters ON_BODY;
        /// Mass in air.
        mass_kg: f64 = 0.0, "mass", range of(0.0, 1e10), matters FREE;
        /// Displaced volume.
        volume_m3: Option<f64>, "volume", range of(0.0, 1e7), absent "by its wet mass or shape, or none", matters FREE;
        /// Mass that weighs as much as it does in the water, in the place of its volume; in air what it weighs by gravity.
        wet_mass_kg: Option<f64>, "wet mass", range of(-1e10, 1e10), absent "by its volume", matters FREE;
        /// Whether it leaves the water and floats at its surface; else it counts as under water at any height, as lines do.
        water_surface: WaterSurface = WaterSurface::Crossed, "water surface", matters FREE;
        /// Added mass: one number, or along x, y, z; for natural periods and in motion.
        added_mass_kg: Option<OneOrMany>, "added mass", kind NumberOrTriple, range of(0.0, 1e10), absent "by its shape, or none", matters FREE;
        /// Drag coefficient times area: one number, or along x, y, z.
        drag_area_m2: Option<OneOrMany>, "drag area", kind NumberOrTriple, range of(0.0, 1e6), absent "by its shape, or none", matters FREE;
        /// Steady load on it, along x, y, z.
        load_n: [f64; 3] = [0.0, 0.0, 0.0], "steady load", range of(-1e12, 1e12), matters FREE;
        /// Friction on the bed, by the push of the bed; in motion.
        bed_friction: f64 = 0.0, "friction on the bed", range of(0.0, 10.0), matters BEARING;
        /// Area that bears on the bed, by the stiffness and damping of the bed; it then sinks into it. On a body that tips it.
        bed_area_m2: Option<f64>, "area on the bed", range of(0.0, 1e6), absent "a free point by its weight: it lies on the bed at rest", matters BEARING;
        /// From the point down to what bears on the bed.
        bottom_m: f64 = 0.0, "bottom", range of(0.0, 1e3), matters FREE;
        /// Greatest pull by which the bed holds it back in motion once it has borne on it.
        breakout_n: f64 = 0.0, "breakout force", range of(0.0, 1e10), matters BEARING;
        /// Distance off the bed at which it is free of that pull.
        breakout_distance_m: f64 = 0.1, "breakout distance", range positive(100.0), matters BEARING;
        /// Displacement at time zero from where it rests, or is placed by the table start, along x, y, z: it is let go there.
        start_offset_m: [f64; 3] = [0.0, 0.0, 0.0], "start offset", range of(-1e4, 1e4), matters FREE;
        /// Velocity at time zero along x, y, z.
        start_velocity_m_per_s: [f64; 3] = [0.0, 0.0, 0.0], "start velocity", range of(-1e3, 1e3), matters FREE;
        /// Amplitudes of its motion along x, y, z.
        amplitude_m: [f64; 3] = [0.0, 0.0, 0.0], "motion amplitude", range of(-1e4, 1e4), matters MOVED;
        /// Period of its motion: one, or one along each of x, y, z.
        period_s: Option<OneOrMany>, "motion period", kind NumberOrTriple, range positive(1e5), absent "it stays", matters MOVED;
        /// Phases of its motion, A sin(2 pi t / T + phase).
        phase_deg: [f64; 3] = [0.0, 0.0, 0.0], "motion phase", range of(-360.0, 360.0), matters MOVED;
        /// Times of a motion by table, in the place of harmonics: from 0 or before to the end of the run.
        table_time_s: Vec<f64>, "times of the table", range of(-1e6, 1e6), absent "no table", matters MOVED;
        /// x from its position at these times.
        table_x_m: Vec<f64>, "x of the table", range of(-1e5, 1e5), absent "0", matters MOVED;
        /// y from its position at these times.
        table_y_m: Vec<f64>, "y of the table", range of(-1e5, 1e5), absent "0", matters MOVED;
        /// z from its position at these times.
        table_z_m: Vec<f64>, "z of the table", range of(-1e5, 1e5), absent "0", matters MOVED;
        /// CSV file beside the system, time_s,x_m,y_m,z_m, with the rows of its table.
        motion_file: Option<String>, "motion file", absent "no file", matters MOVED;
        /// How its table is interpolated: a spline is smooth, the others end steps at the kinks of their rows.
        table_interpolation: MotionInterpolation = MotionInterpolation::Spline, "table interpolation", matters MOVED;
        /// Root mean square of an irregular motion along x, y, z, in the place of harmonics.
        rms_m: [f64; 3] = [0.0, 0.0, 0.0], "motion rms", range of(0.0, 1e3), matters MOVED;
        /// Period of the peak of the spectrum of an irregular motion.
        peak_period_s: Option<f64>, "motion peak period", range positive(1e5), absent "no irregular motion", matters MOVED;
        /// Gamma of the JONSWAP spectrum of an irregular motion.
        gamma: f64 = 3.3, "motion peak enhancement", range of(1.0, 20.0), matters MOVED;
        /// Harmonics that an irregular motion is made of along each axis.
        components: usize = 100, "motion components", range of(1.0, 1e4), matters MOVED;
        /// Of an irregular motion: the same seed, the same motion.
        seed: u64 = 1, "motion seed", range of(0.0, 9e15), matters MOVED;
        /// Its motion grows smoothly from nothing over this time.
        ramp_s: f64 = 0.0, "motion ramp", range of(0.0, 1e6), matters MOVED;
    }
    tables {
        /// The form of what is at a free point, for volume, drag area and added mass that its other keys leave out.
        shape: Option<PayloadShape>;
    }
}

impl PointInputs {
    /// The volume that it displaces in water of a density \[kg/m³\], by its wet mass where that is given, or by its shape \[m³\]; in air by a
    /// wet mass none.
    #[must_use]
    pub fn displaced_m3(&self, density: f64) -> f64 {
        match self.wet_mass_kg {
            None => {
                let by_shape = || self.shape.as_ref().map(|shape| shape_form(shape).volume);
                self.volume_m3.or_else(by_shape).unwrap_or(0.0)
            }
            Some(wet) if density > 0.0 => (self.mass_kg - wet) / density,
            Some(_) => 0.0,
        }
    }

    /// Drag area \[m²\] and added mass \[kg\] of it in water of a density \[kg/m³\].
    #[must_use]
    pub fn hydrodynamics(&self, density: f64) -> Hydrodynamics {
        let given = [&self.drag_area_m2, &self.added_mass_kg];
        Hydrodynamics::new(self.shape.as_ref(), given, density)
    }

    /// The steady load on it \[N\], and in air what by its wet mass lifts it against this gravity \[m/s²\].
    #[must_use]
    pub fn load_with_lift(&self, density: f64, gravity: f64) -> [f64; 3] {
        let [x, y, z] = self.load_n;
        let in_air = self.wet_mass_kg.filter(|_| density <= 0.0);
        let lift = in_air.map_or(0.0, |wet| (self.mass_kg - wet) * gravity);
        [x, y, z + lift]
    }

    /// A point of a kind that states nothing else.
    #[must_use]
    pub fn of(kind: PointKind) -> Self {
        Self {
            kind,
            position_m: None,
            body: None,
            mass_kg: 0.0,
            volume_m3: None,
            wet_mass_kg: None,
            water_surface: WaterSurface::Crossed,
            added_mass_kg: None,
            drag_area_m2: None,
            shape: None,
            load_n: [0.0; 3],
            bed_friction: 0.0,
            bed_area_m2: None,
            bottom_m: 0.0,
            breakout_n: 0.0,
            breakout_distance_m: 0.1,
            start_offset_m: [0.0; 3],
            start_velocity_m_per_s: [0.0; 3],
            amplitude_m: [0.0; 3],
            period_s: None,
            phase_deg: [0.0; 3],
            table_time_s: Vec::new(),
            table_x_m: Vec::new(),
            table_y_m: Vec::new(),
            table_z_m: Vec::new(),
            motion_file: None,
            table_interpolation: MotionInterpolation::Spline,
            rms_m: [0.0; 3],
            peak_period_s: None,
            gamma: 3.3,
            components: 100,
            seed: 1,
            ramp_s: 0.0,
        }
    }
}

words! {
    /// What holds a body.
    pub enum BodyKind {
        /// Held at its pose.
        Held = "held",
        /// Free in all six directions.
        Free = "free",
        /// Free to turn about its origin, of a rod its end A, which is held or follows a prescribed motion.
        Pinned = "pinned",
        /// Follows a prescribed motion about its pose; held there at rest.
        Moved = "moved",
    }
}

const FLOATING: Conditions = &[("kind", &["free"])];
const TURNING: Conditions = &[("kind", &["free", "pinned"])];
const PINNED: Conditions = &[("kind", &["pinned"])];
const CARRIED: Conditions = &[("kind", &["moved", "pinned"])];
const IN_WAVES: Conditions = &[("kind", &["free", "moved"])];

table! {
    /// A rigid body. Its frame is the earth's where its angles are zero: x forward, y to port, z up.
    #[derive(Debug, Clone, PartialEq)]
    pub struct BodyInputs => BodyKeys {
        /// What holds it.
        kind: BodyKind, "kind";
        /// The body that its origin is pinned to; its position and angles are then those in the frame of that body.
        pinned_to: Option<String>, "pinned to", kind Name, absent "the earth", matters PINNED;
        /// Place of its origin; of a free body the place that its hydrostatics refer to, where the search begins.
        position_m: Option<[f64; 3]>, "position", range of(-1e6, 1e6), absent "0, or of a free body at the end of a line that begins straight";
        /// Turn about x, after the two others.
        roll_deg: f64 = 0.0, "roll", range of(-180.0, 180.0);
        /// Turn about y, after that about z.
        pitch_deg: f64 = 0.0, "pitch", range of(-90.0, 90.0);
        /// Turn about z, first.
        yaw_deg: f64 = 0.0, "yaw", range of(-360.0, 360.0);
        /// Mass in air, ballast included; a free body needs it.
        mass_kg: Option<f64>, "mass", range positive(1e12), absent "not used while it is held";
        /// Centre of gravity in its frame.
        centre_of_gravity_m: [f64; 3] = [0.0, 0.0, 0.0], "centre of gravity", range of(-1e3, 1e3);
        /// About axes through the centre of gravity: Ixx, Iyy, Izz, or these and Ixy, Ixz, Iyz.
        inertia_kg_m2: Vec<f64>, "moments of inertia", range of(-1e18, 1e18), absent "none";
        /// Displaced volume at the pose given.
        volume_m3: f64 = 0.0, "volume", range of(0.0, 1e9);
        /// Centre of buoyancy in its frame, at the pose given.
        centre_of_buoyancy_m: [f64; 3] = [0.0, 0.0, 0.0], "centre of buoyancy", range of(-1e3, 1e3);
        /// Of its water-plane alone, about its origin, along its axes: 36 numbers row by row, or the diagonal; for small tilts.
        waterplane_stiffness: Vec<f64>, "water-plane stiffness", unit "N/m, N, N m", range of(-1e15, 1e15), absent "none";
        /// Added mass about its origin, along its axes: 36 numbers row by row, or the diagonal; for natural periods.
        added_mass: Vec<f64>, "added mass", unit "kg, kg m, kg m2", range of(-1e18, 1e18), absent "none";
        /// Place about which its added mass is given; current and waves then act on that and on its volume, as far as a ball of the volume about the centre of buoyancy is in the water.
        centre_of_added_mass_m: Option<[f64; 3]>, "centre of added mass", range of(-1e3, 1e3), absent "its origin; current and waves act on members alone", matters TURNING;
        /// Damping about its origin, along its axes, in motion: 36 numbers row by row, or the diagonal.
        damping: Vec<f64>, "damping", unit "N s/m, N s, N m s", range of(-1e18, 1e18), absent "none", matters TURNING;
        /// The same by the squares of the six velocities, each with its sign.
        quadratic_damping: Vec<f64>, "quadratic damping", unit "N s2/m2, N s2, N m s2", range of(-1e18, 1e18), absent "none", matters TURNING;
        /// Steady load at its origin along x, y, z, in the earth's directions.
        load_n: [f64; 3] = [0.0, 0.0, 0.0], "steady load", range of(-1e12, 1e12), matters TURNING;
        /// Steady moment about its origin, in the earth's directions.
        moment_n_m: [f64; 3] = [0.0, 0.0, 0.0], "steady moment", unit "N m", range of(-1e15, 1e15), matters TURNING;
        /// From its origin down to what bears on the bed.
        bottom_m: Option<f64>, "bottom", range of(-1e3, 1e3), absent "it does not touch the bed", matters FLOATING;
        /// Friction on the bed, by the push of the bed; in motion. It acts at its origin, as that push does: a body on the bed does not tip.
        bed_friction: f64 = 0.0, "friction on the bed", range of(0.0, 10.0), matters FLOATING;
        /// WAMIT .1 file: added mass and damping over period, about its origin, in the place of added_mass.
        radiation_file: Option<String>, "radiation", absent "added_mass and damping as they are given", matters FLOATING;
        /// WAMIT .3 file: loads of the first order in waves by period and heading.
        excitation_file: Option<String>, "excitation", absent "waves act on its members alone", matters FLOATING;
        /// WAMIT .8, .9 or .12d file: mean drift, and slow drift by Newman's approximation.
        drift_file: Option<String>, "wave drift", absent "none", matters FLOATING;
        /// Length by which the numbers of these files are scaled (ULEN).
        wamit_length_m: f64 = 1.0, "length of the files", range positive(1e4), matters FLOATING;
        /// Drag coefficient times area along its x, y and z, at its centre of drag.
        drag_area_m2: [f64; 3] = [0.0, 0.0, 0.0], "drag area", range of(0.0, 1e7), matters TURNING;
        /// Where its drag area acts, in its frame.
        centre_of_drag_m: [f64; 3] = [0.0, 0.0, 0.0], "centre of drag", range of(-1e3, 1e3), matters TURNING;
        /// Length along its z, about the centre of drag, that its drag area is spread over: it then resists turning too.
        drag_length_m: f64 = 0.0, "length of drag", range of(0.0, 1e3), matters TURNING;
        /// Amplitudes of its motion: surge, sway, heave along x, y, z of the earth.
        amplitude_m: [f64; 3] = [0.0, 0.0, 0.0], "motion amplitude", range of(-1e4, 1e4), matters CARRIED;
        /// Amplitudes of its roll, pitch and yaw.
        amplitude_deg: [f64; 3] = [0.0, 0.0, 0.0], "motion angles", range of(-180.0, 180.0), matters MOVED;
        /// Periods of its six motions: one for all, or six.
        period_s: Vec<f64>, "motion periods", range positive(1e5), absent "it stays", matters CARRIED;
        /// Phases of its six motions, A sin(2 pi t / T + phase): six numbers.
        phase_deg: Vec<f64>, "motion phases", range of(-360.0, 360.0), absent "0", matters CARRIED;
        /// Times of a motion by table, in the place of harmonics: from 0 or before to the end of the run.
        table_time_s: Vec<f64>, "times of the table", range of(-1e6, 1e6), absent "no table", matters CARRIED;
        /// x from its position at these times.
        table_x_m: Vec<f64>, "x of the table", range of(-1e5, 1e5), absent "0", matters CARRIED;
        /// y from its position at these times.
        table_y_m: Vec<f64>, "y of the table", range of(-1e5, 1e5), absent "0", matters CARRIED;
        /// z from its position at these times.
        table_z_m: Vec<f64>, "z of the table", range of(-1e5, 1e5), absent "0", matters CARRIED;
        /// Roll from that of its pose at these times.
        table_roll_deg: Vec<f64>, "roll of the table", range of(-360.0, 360.0), absent "0", matters MOVED;
        /// Pitch from that of its pose at these times.
        table_pitch_deg: Vec<f64>, "pitch of the table", range of(-90.0, 90.0), absent "0", matters MOVED;
        /// Yaw from that of its pose at these times.
        table_yaw_deg: Vec<f64>, "yaw of the table", range of(-1e5, 1e5), absent "0", matters MOVED;
        /// How its table is interpolated: a spline is smooth, the others end steps at the kinks of their rows.
        table_interpolation: MotionInterpolation = MotionInterpolation::Spline, "table interpolation", matters CARRIED;
        /// Its motion grows smoothly from nothing over this time.
        ramp_s: f64 = 0.0, "motion ramp", range of(0.0, 1e6), matters CARRIED;
        /// CSV file of its responses over period_s and heading_deg (optional): how a moved body follows waves, a free one would without lines.
        response_file: Option<String>, "responses", absent "none", matters IN_WAVES;
        /// Where in its frame these responses are those of a moved body; its origin follows from them by its arm, for small angles.
        response_at_m: [f64; 3] = [0.0, 0.0, 0.0], "place of the responses", range of(-1e3, 1e3), matters MOVED;
        /// Displacement at time zero from where it rests, or is placed by the table start, along x, y, z of the earth: it is let go there.
        start_offset_m: [f64; 3] = [0.0, 0.0, 0.0], "start offset", range of(-1e4, 1e4), matters FLOATING;
        /// Roll, pitch and yaw at time zero beyond those there.
        start_offset_deg: [f64; 3] = [0.0, 0.0, 0.0], "start angles", range of(-360.0, 360.0), matters TURNING;
        /// Velocity of its origin at time zero along x, y, z of the earth.
        start_velocity_m_per_s: [f64; 3] = [0.0, 0.0, 0.0], "start velocity", range of(-1e3, 1e3), matters FLOATING;
        /// Angular velocity at time zero about the directions x, y, z of the earth.
        start_angular_velocity_deg_per_s: [f64; 3] = [0.0, 0.0, 0.0], "start angular velocity", range of(-1e5, 1e5), matters TURNING;
        /// Direction towards which the waves of its mean drift run, from +x towards +y.
        drift_towards_deg: f64 = 0.0, "drift direction", range of(-360.0, 360.0), matters FLOATING;
    }
    tables {
        /// Round members in the water, whose buoyancy counts as far as they are immersed.
        members: Vec<MemberInputs>;
        /// Loads of the wind by its heading.
        wind_loads: Vec<HeadingLoadInputs>;
        /// Loads of the current at the surface by its heading.
        current_loads: Vec<HeadingLoadInputs>;
        /// Mean drift of the waves by their heading, a steady load, at rest too.
        drift_loads: Vec<DriftLoadInputs>;
    }
}

table! {
    /// A rigid rod: a slender body whose mass lies evenly along it. It spins about its axis without resistance.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RodInputs => RodKeys {
        /// What holds it.
        kind: BodyKind, "kind";
        /// The body that its end A is pinned to; its ends are then places in the frame of that body.
        pinned_to: Option<String>, "pinned to", kind Name, absent "the earth", matters PINNED;
        /// Its end A; of a free rod where the search begins.
        end_a_m: [f64; 3], "end A", range of(-1e6, 1e6);
        /// Its end B.
        end_b_m: [f64; 3], "end B", range of(-1e6, 1e6);
        /// Mass in air.
        mass_kg: f64, "mass", range positive(1e9);
        /// Outer diameter, by which it displaces water.
        diameter_m: f64, "diameter", range positive(1e2);
        /// Drag coefficient across it, on the diameter, in a current.
        drag_normal: f64 = 0.0, "normal drag", range of(0.0, 100.0);
        /// Added mass coefficient across it, on the displaced volume in the water; for natural periods and in motion.
        added_mass_normal: f64 = 1.0, "normal added mass", range of(0.0, 100.0);
        /// Drag coefficient of each of its ends in the water, along it, on the area of the end.
        drag_end: f64 = 0.0, "drag of the ends", range of(0.0, 100.0);
        /// Added mass coefficient of each of its ends in the water, along it, on 2/3 pi r^3, the half ball over the end.
        added_mass_end: f64 = 0.0, "added mass of the ends", range of(0.0, 100.0);
        /// Steady load at its middle, along x, y, z; not of a rod that is pinned.
        load_n: [f64; 3] = [0.0, 0.0, 0.0], "steady load", range of(-1e12, 1e12), matters FLOATING;
        /// Displacement at time zero from where it rests, or is placed by the table start, along x, y, z: it is let go there.
        start_offset_m: [f64; 3] = [0.0, 0.0, 0.0], "start offset", range of(-1e4, 1e4), matters FLOATING;
        /// Turns at time zero from there about the directions x, then y, then z of the earth: about its middle, or its end A where that is pinned.
        start_turn_deg: [f64; 3] = [0.0, 0.0, 0.0], "start turn", range of(-360.0, 360.0), matters TURNING;
        /// Velocity of its middle at time zero along x, y, z.
        start_velocity_m_per_s: [f64; 3] = [0.0, 0.0, 0.0], "start velocity", range of(-1e3, 1e3), matters FLOATING;
        /// Angular velocity at time zero about the directions x, y, z of the earth.
        start_angular_velocity_deg_per_s: [f64; 3] = [0.0, 0.0, 0.0], "start angular velocity", range of(-1e5, 1e5), matters TURNING;
    }
}

table! {
    /// A round member of a body: a cylinder, or a cone.
    #[derive(Debug, Clone, PartialEq)]
    pub struct MemberInputs => MemberKeys {
        /// One end in the frame of the body.
        from_m: [f64; 3], "from", range of(-1e4, 1e4);
        /// Its other end.
        to_m: [f64; 3], "to", range of(-1e4, 1e4);
        /// Outer diameter.
        diameter_m: f64, "diameter", range positive(1e3);
        /// Outer diameter at its other end.
        to_diameter_m: Option<f64>, "diameter at the other end", range of(0.0, 1e3), absent "the same";
        /// Drag coefficient across it, on the diameter, in a current.
        drag_normal: f64 = 0.0, "normal drag", range of(0.0, 100.0);
        /// Added mass coefficient across it, on the displaced volume in the water; for natural periods and in motion.
        added_mass_normal: f64 = 0.0, "normal added mass", range of(0.0, 100.0);
        /// Drag coefficient of each of its ends in the water, along it, on the area of the end.
        drag_end: f64 = 0.0, "drag of the ends", range of(0.0, 100.0);
        /// The same of its other end, as where another member goes on there: 0.
        to_drag_end: Option<f64>, "drag of the other end", range of(0.0, 100.0), absent "the same";
        /// Added mass coefficient of each of its ends in the water, along it, on 2/3 pi r^3, the half ball over the end.
        added_mass_end: f64 = 0.0, "added mass of the ends", range of(0.0, 100.0);
        /// The same of its other end, as where another member goes on there: 0.
        to_added_mass_end: Option<f64>, "added mass of the other end", range of(0.0, 100.0), absent "the same";
        /// It has drag alone: what it displaces is in the volume of its body, or in coefficients.
        drag_only: bool = false, "drag alone";
        /// Copies turned about the z axis of the body by these angles.
        repeat_at_deg: Vec<f64>, "repeats", range of(-360.0, 360.0), absent "once";
    }
}

table! {
    /// The load of a flow on a body at one heading, over its speed squared; cubics in between.
    #[derive(Debug, Clone, PartialEq)]
    pub struct HeadingLoadInputs => HeadingLoadKeys {
        /// Towards which the flow runs, from the bow towards port: 0 from astern, 180 from ahead.
        heading_deg: f64, "heading", range of(-360.0, 360.0);
        /// Forwards.
        surge_n_s2_per_m2: f64 = 0.0, "surge load", unit "N s2/m2", range of(-1e9, 1e9);
        /// To port.
        sway_n_s2_per_m2: f64 = 0.0, "sway load", unit "N s2/m2", range of(-1e9, 1e9);
        /// Bow to port, about the origin.
        yaw_n_s2_per_m: f64 = 0.0, "yaw load", unit "N s2/m", range of(-1e12, 1e12);
    }
}

table! {
    /// The mean drift of waves at one heading; cubics in between.
    #[derive(Debug, Clone, PartialEq)]
    pub struct DriftLoadInputs => DriftLoadKeys {
        /// Towards which the waves run, from the bow towards port: 0 from astern, 180 from ahead.
        heading_deg: f64, "heading", range of(-360.0, 360.0);
        /// Forwards.
        surge_n: f64 = 0.0, "surge drift", range of(-1e9, 1e9);
        /// To port.
        sway_n: f64 = 0.0, "sway drift", range of(-1e9, 1e9);
        /// Bow to port, about the origin.
        yaw_n_m: f64 = 0.0, "yaw drift", unit "N m", range of(-1e12, 1e12);
    }
}

table! {
    /// A line from one point to another, of one material or of sections.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LineInputs => LineKeys {
        /// Name of the line.
        name: String, "name", kind Name;
        /// The point at its end A.
        from: String, "from", kind Name;
        /// The point at its end B.
        to: String, "to", kind Name;
        /// Material of a line of one section.
        material: Option<String>, "material", kind Name, absent "by its sections";
        /// Unstretched length of a line of one section.
        length_m: Option<f64>, "length", range positive(1e5), absent "by its sections";
        /// Copies turned about a vertical axis by these angles: of the line and of its points off that axis.
        repeat_at_deg: Vec<f64>, "repeats", range of(-360.0, 360.0), absent "once";
        /// The axis of the copies: x and y. Points on a body turn about the z axis of their body.
        repeat_about_m: [f64; 2] = [0.0, 0.0], "axis of repeats", range of(-1e6, 1e6);
        /// Segments of the line where it has no closed form: in a current, or with bending stiffness.
        segments: Option<usize>, "segments", range of(2.0, 1e4), absent "sections or 100";
        /// Neither current nor waves act on it: as where they matter little, which is cheaper, or in a place that is sheltered.
        still_water: bool = false, "in still water";
        /// Whether the bed bears it; without, it hangs through the bed: as OMIT_CONTACT of MAP++.
        bed_contact: bool = true, "contact with the bed";
        /// Angle above the horizontal of the line at its end A, towards B, where that end is clamped and the line bends; on a body as the file puts it, turning with it.
        clamp_a_elevation_deg: Option<f64>, "clamp elevation of end A", range of(-90.0, 90.0), absent "hinged";
        /// Direction of the clamped line at its end A, from +x towards +y.
        clamp_a_azimuth_deg: f64 = 0.0, "clamp azimuth of end A", range of(-360.0, 360.0);
        /// Angle above the horizontal of the line at its end B, as it comes from A, where that end is clamped and the line bends; on a body as the file puts it, turning with it.
        clamp_b_elevation_deg: Option<f64>, "clamp elevation of end B", range of(-90.0, 90.0), absent "hinged";
        /// Direction of the clamped line at its end B, from +x towards +y.
        clamp_b_azimuth_deg: f64 = 0.0, "clamp azimuth of end B", range of(-360.0, 360.0);
        /// Friction under this line in the place of the bed's.
        friction: Option<f64>, "friction", range of(0.0, 10.0), absent "that of the bed";
        /// Friction across this line in the place of the bed's.
        friction_lateral: Option<f64>, "friction across", range of(0.0, 10.0), absent "that of the bed";
        /// In motion its end A is let go at this time.
        release_a_s: Option<f64>, "release of end A", range of(0.0, 1e6), absent "never";
        /// In motion its end B is let go at this time.
        release_b_s: Option<f64>, "release of end B", range of(0.0, 1e6), absent "never";
        /// In motion its end A is let go where the tension there comes to this.
        release_a_n: Option<f64>, "release tension of end A", range positive(1e12), absent "never";
        /// In motion its end B is let go where the tension there comes to this.
        release_b_n: Option<f64>, "release tension of end B", range positive(1e12), absent "never";
        /// Where the line may break in motion, from its end A.
        break_at_m: Option<f64>, "place of the break", range positive(1e5), absent "it does not break";
        /// It breaks there at this time.
        break_s: Option<f64>, "time of the break", range of(0.0, 1e6), absent "not by time";
        /// It breaks where the tension at that place comes to this.
        break_n: Option<f64>, "tension of the break", range positive(1e12), absent "not by tension";
    }
    tables {
        /// The sections of the line, from its end A to its end B.
        sections: Vec<LineSection>;
        /// Floats spread evenly over a stretch of a section.
        floats: Vec<Floats>;
        /// Buoyancy modules clamped on a stretch of a section, one a pitch.
        modules: Vec<Modules>;
        /// A body hung on the line at one place: a clump weight, or a buoy.
        clumps: Vec<Clump>;
        /// How the line lies between its ends at time zero, or where the search for its equilibrium begins, and its velocity.
        start: Option<Start>;
    }
}

table! {
    /// A section of a line.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LineSection => LineSectionKeys {
        /// Name of the section, used in channel names and key paths; of all sections of a line or of none.
        name: Option<String>, "name", kind Name, absent "its number from end A";
        /// What it is made of.
        material: String, "material", kind Name;
        /// Unstretched length.
        length_m: f64, "length", range positive(1e5);
        /// Segments that it is divided into, of all sections or of none; where the line states its own, these are in this ratio.
        segments: Option<usize>, "segments", range of(1.0, 1e4), absent "by its length";
        /// Weight in water of a body at its end towards B, as mass; negative floats. Not on the last section.
        clump_kg: f64 = 0.0, "clump", range of(-1e10, 1e10);
        /// Mass in air of that body.
        clump_mass_kg: Option<f64>, "mass of the clump", range of(0.0, 1e10), absent "as its weight in water, whichever way that acts";
        /// Drag coefficient times area of that body: one number, or along x, y, z.
        clump_drag_area_m2: OneOrMany = 0.0, "drag area of the clump", kind NumberOrTriple, range of(0.0, 1e6);
        /// Drag coefficient times area of that body across the line, of a module around it and what else is aligned with it; in place of its drag area.
        clump_drag_area_normal_m2: f64 = 0.0, "drag area of the clump across the line", range of(0.0, 1e6);
        /// The same along the line, that of a module by its length or of its ends.
        clump_drag_area_tangential_m2: f64 = 0.0, "drag area of the clump along the line", range of(0.0, 1e6);
        /// Added mass of that body: one number, or along x, y, z.
        clump_added_mass_kg: OneOrMany = 0.0, "added mass of the clump", kind NumberOrTriple, range of(0.0, 1e10);
        /// Added mass of that body across the line, of a module around it and what else is aligned with it; in place of its added mass.
        clump_added_mass_normal_kg: f64 = 0.0, "added mass of the clump across the line", range of(0.0, 1e10);
        /// The same along the line, that of a module by its ends.
        clump_added_mass_tangential_kg: f64 = 0.0, "added mass of the clump along the line", range of(0.0, 1e10);
        /// Area of that body that bears on the bed, on lines divided into segments.
        clump_bed_area_m2: Option<f64>, "area of the clump on the bed", range of(0.0, 1e6), absent "the bottom of a cube of its volume";
        /// From the line down to what of that body bears on the bed.
        clump_bottom_m: f64 = 0.0, "bottom of the clump", range of(0.0, 1e3);
        /// Greatest pull by which the bed holds that body back once it has borne on it.
        clump_breakout_n: f64 = 0.0, "breakout force of the clump", range of(0.0, 1e10);
        /// Distance off the bed at which it is free of that pull.
        clump_breakout_distance_m: f64 = 0.1, "breakout distance of the clump", range positive(100.0);
    }
}

table! {
    /// A body pushed aside: restoring force and tensions against its offset.
    #[derive(Debug, Clone, PartialEq)]
    pub struct OffsetCurveInputs => OffsetCurveKeys {
        /// The body.
        body: Option<String>, "body", kind Name, absent "the only one";
        /// Direction of the offset, from +x towards +y.
        heading_deg: f64 = 0.0, "heading", range of(-360.0, 360.0);
        /// Greatest offset.
        to_m: f64, "greatest offset", range positive(1e5);
        /// Steps to it.
        steps: usize = 20, "steps", range of(1.0, 1e4);
    }
}

table! {
    /// Where a steady load from all sides moves a body, with all lines and with each lost in turn.
    #[derive(Debug, Clone, PartialEq)]
    pub struct WatchCircleInputs => WatchCircleKeys {
        /// The body.
        body: Option<String>, "body", kind Name, absent "the only one";
        /// The steady horizontal load.
        load_n: f64, "load", range positive(1e12);
        /// Headings, evenly around.
        headings: usize = 24, "headings", range of(1.0, 3600.0);
    }
}

table! {
    /// A wanted result: which value of an input gives it, all else as it stands. The system itself stays as it is.
    #[derive(Debug, Clone, PartialEq)]
    pub struct GoalInputs => GoalKeys {
        /// The input to vary, such as lines.mooring.length_m.
        vary: String, "input to vary";
        /// The values to search between, in its unit.
        between: [f64; 2], "between", range of(-1e15, 1e15);
        /// The result wanted, such as tension_n[mooring|b].
        result: String, "result";
        /// Its wanted value, in its unit.
        value: f64, "wanted value", range of(-1e15, 1e15);
    }
}
