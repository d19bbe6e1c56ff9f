//! A case file as types: one struct a table, one field a key, each declared once with unit, range, default and help.
//!
//! A key has the unit in which its name ends. Ranges are wide: they catch slips (millimetres typed as metres, a lost minus
//! sign), not unusual cables. Optional keys are `Option` where "not given" means something, and have a default otherwise.
//! `scene` turns a [`Case`] into numbers for the solvers.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use crate::case::fields::ValueType::NumberOrList;
use crate::case::fields::{Field, POSITION, Schema, of, positive};
use crate::case::schema::{schema_of, table};
pub use one_or_many::OneOrMany;

mod checks;
mod construct;
mod ends;
mod line;
mod load_cases;
mod one_or_many;
mod sea;
mod settings;
mod validation_data;

pub use checks::{
    CheckAnalysis, CheckCondition, CheckInputs, CheckKind, GreatestMethod, RuleSet, RuleSetInfo,
    StatisticsInputs, UnitSlip,
};
pub(crate) use checks::{CheckKeys, RuleSetKeys};
pub use construct::OnSection;
pub use ends::{
    Attachment, BoxShape, End, EndKind, Ends, MotionInterpolation, MotionName, Payload,
    PayloadShape, Rotation, SphereAndCylinder,
};
pub(crate) use ends::{EndKeys, PayloadKeys, RotationKeys, ShapeKeys};
pub use line::{
    Bore, BoreKeys, Clump, ClumpKeys, CreepModel, DragCoefficient, DragLawName, DragWidth,
    DynamicStiffness, Floats, FloatsKeys, Material, MaterialKeys, Modules, ModulesKeys, Section,
    StiffnessScope, TensionInterpolation, Traveller, WorkingCurveShape,
};
pub use load_cases::LoadCaseInputs;
pub(crate) use load_cases::LoadCaseKeys;
pub(crate) use sea::WavesKeys;
pub use sea::{
    DecayName, DragLength, SpectrumName, StretchingName, WaterSurface, WaveKind, WaveLoadName,
    Waves,
};
pub use settings::{
    BedInterpolation, FrictionLaw, Method, Modes, Output, Seabed, SeabedKeys, Solver, Start,
    StartKeys, StartShape,
};
pub(crate) use validation_data::{
    AtKeys, PublishedCurveKeys, PublishedKeys, StudyKeys, TrendKeys, TrialKeys,
};
pub use validation_data::{
    Direction, Evidence, Mark, Provenance, Published, PublishedCurve, Statistic, Study, StudyPoint,
    StudyValue, Trend, Trial,
};

/// The case file.
pub static CASE: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a case has at least [case], [materials.<name>], [[line]] and [ends.a], [ends.b]";
    schema_of::<Case>("case", least)
        .with_example("name a key as in `materials.<name>.ea_n`, `line.<section>.length_m`, `ends.b.position_m`")
        .with_parameters()
        .with_coordinates("ends.*.position_m", POSITION.0, POSITION.1)
        .with_coordinates(
            "ends.*.amplitude_m",
            ["surge amplitude", "sway amplitude", "heave amplitude"],
            "Amplitude of the prescribed motion along one axis.",
        )
});

/// The field of a key path given as its parts, if there is one; `ends.b.position_m.x` is a number of its own.
#[must_use]
pub fn field_at<S: AsRef<str>>(path: &[S]) -> Option<&'static Field> {
    CASE.fields_at(path).next()
}

table! {
    /// Everything a case file says.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Case => CaseKeys {}
    tables {
        /// What the case is, for people.
        case: CaseInfo;
        /// Water and gravity.
        environment: Environment, optional;
        /// The current; absent means still water.
        current: Option<Current>;
        /// Waves; absent means a calm sea.
        waves: Option<Waves>;
        /// The sea bed under the line, level or sloping.
        seabed: Option<Seabed>;
        /// What the sections of the line are made of, by name.
        materials: BTreeMap<String, Material>, required;
        /// The sections of the line, from end A to end B.
        line: Vec<Section>, required;
        /// The two ends of the line.
        ends: Ends;
        /// The body hung on an end of kind payload.
        payload: Option<Payload>;
        /// Floats spread evenly over a stretch of a section.
        floats: Vec<Floats>;
        /// A body hung on the line at one place: a clump weight, or a buoy.
        clumps: Vec<Clump>;
        /// A body that travels along the line at a given speed.
        traveller: Option<Traveller>;
        /// Buoyancy modules clamped on a stretch of a section, one a pitch.
        modules: Vec<Modules>;
        /// Files that the case names, carried with it, by their names.
        files: BTreeMap<String, Attachment>;
        /// Where the line is at time zero, at rest.
        start: Start, optional;
        /// Which solver, and its settings.
        solver: Solver, optional;
        /// What is recorded and how often.
        output: Output, optional;
        /// Natural modes about the static shape, reported with the results of a run.
        modes: Option<Modes>;
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
        /// A published value the case is held against.
        published: Vec<Published>;
        /// A published curve over time that a channel is held against.
        published_curve: Vec<PublishedCurve>;
        /// A published statement of trend, checked along a study.
        trend: Vec<Trend>;
        /// One way in which a hard case is computed, and what must come of it.
        trial: Vec<Trial>;
    }
}

impl<'a> CaseKeys<'a> {
    /// The ends that the case has, end A first.
    pub(crate) fn each_end(&self) -> impl Iterator<Item = &EndKeys<'a>> {
        let both = self.ends.iter().flat_map(|ends| [&ends.a, &ends.b]);
        both.flatten()
    }
}

table! {
    /// What a case is, for people.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CaseInfo => AboutKeys {
        /// One line that says what the case is.
        title: String, "title";
        /// Where the data come from.
        source: String = "", "source";
        /// The scene, what the source leaves out, what was decided.
        notes: String = "", "notes";
        /// Names of other case files whose stored runs are listed here too, to be laid over this case's.
        beside: Option<Vec<String>>, "beside", absent "none";
        /// Why the tolerances of the published values are what they are, where a value states no reason of its own.
        tolerance_reason: Option<String>, "reason of the tolerances", absent "none stated";
    }
}

table! {
    /// Water and gravity.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Environment => EnvironmentKeys {
        /// Acceleration of gravity, downwards.
        gravity_m_per_s2: f64 = 9.80665, "gravity", range of(0.0, 100.0);
        /// Density of the water; it sets buoyancy, drag and added mass.
        water_density_kg_per_m3: f64 = 1025.0, "water density", range of(0.0, 2e4);
        /// Kinematic viscosity of the water, for Reynolds numbers.
        kinematic_viscosity_m2_per_s: f64 = 1.19e-6, "kinematic viscosity", range positive(1.0);
        /// Whether the line leaves the water: with ignored all of it counts as under water, at any height.
        water_surface: WaterSurface = WaterSurface::Ignored, "water surface";
        /// Length of a taut line that drag acts on; slack parts have their unstretched length. MoorDyn takes the unstretched one.
        drag_length: DragLength = DragLength::Stretched, "length for drag";
    }
}

table! {
    /// A current: uniform (`speed_m_per_s` one number), a table over depth (lists of equal length), or a file.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Current => CurrentKeys {
        /// Speed of the current: one number, or one for each depth.
        speed_m_per_s: Option<OneOrMany>, "current speed", kind NumberOrList, range of(-20.0, 20.0), absent "from the file";
        /// Where the water flows to, from +x towards +y: one number, or one for each depth.
        direction_deg: OneOrMany = 0.0, "current direction", kind NumberOrList, range of(-360.0, 360.0);
        /// Depths below still water, increasing; linear in between, constant beyond.
        depth_m: Option<Vec<f64>>, "current depths", range of(0.0, 2e4), absent "the same at every depth";
        /// Of a system: a file of the current over time and place, `t_s,x_m,y_m,z_m,u_m_per_s,v_m_per_s`, or of MoorDyn.
        file: Option<String>, "current file", absent "none";
    }
}
