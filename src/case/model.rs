//! A case as the user words it: one struct a table of the file, one field a key.
//!
//! Units stand in the field names, exactly as in the file. Nothing here computes; `scene` turns a
//! [`Case`] into numbers for the solvers. Optional keys are `Option` where "not given" means
//! something, and carry their default otherwise.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

mod claims;
mod construct;
mod ends;
mod line;
mod sea;
mod settings;

pub use claims::{
    At, Direction, Mark, Published, PublishedCurve, Standing, Statistic, Study, StudyValue, Trend,
    Trial,
};
pub use ends::{Carried, End, EndKind, Ends, MotionName, Payload, Rotation, Shape};
pub use line::{
    Clump, DragLaw, DragLawName, DragWidth, DynamicStiffness, Floats, Material, Modules, Section,
    Traveller,
};
pub use sea::{
    DecayName, SpectrumName, StretchingName, WaterSurface, WaveKind, WaveLoadName, Waves,
};
pub use settings::{
    EnvelopeOf, FrictionLaw, Method, Modes, Output, Seabed, Solver, Start, StartShape,
};

/// Everything a case file says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// What the case is, for people.
    pub case: About,
    /// Water and gravity.
    #[serde(default)]
    pub environment: Environment,
    /// The current; absent means still water.
    pub current: Option<Current>,
    /// Waves; absent means a calm sea.
    pub waves: Option<Waves>,
    /// The sea bed; absent means water without end.
    pub seabed: Option<Seabed>,
    /// Materials by name, referred to by the sections of the line.
    pub materials: BTreeMap<String, Material>,
    /// Sections of the line, from end A to end B.
    pub line: Vec<Section>,
    /// The two ends.
    pub ends: Ends,
    /// The body hung on an end of kind `payload`.
    pub payload: Option<Payload>,
    /// Floats spread over stretches of the line.
    #[serde(default)]
    pub floats: Vec<Floats>,
    /// Bodies hung on the line, each at one place.
    #[serde(default)]
    pub clumps: Vec<Clump>,
    /// A body that travels along the line; absent: there is none.
    pub traveller: Option<Traveller>,
    /// Buoyancy modules clamped on stretches of the line.
    #[serde(default)]
    pub modules: Vec<Modules>,
    /// Files that the case names, by their names, so that it needs nothing else.
    #[serde(default)]
    pub files: BTreeMap<String, Carried>,
    /// Where the line is at time zero.
    #[serde(default)]
    pub start: Start,
    /// Which solver, and its settings.
    #[serde(default)]
    pub solver: Solver,
    /// What is recorded and how often.
    #[serde(default)]
    pub output: Output,
    /// Natural modes that a run tells beside its results; absent: none.
    pub modes: Option<Modes>,
    /// Where inputs come from, by key path (`"payload.drag_area_m2"`): published inputs need no mark.
    #[serde(default)]
    pub marks: BTreeMap<String, Mark>,
    /// Studies: one key varied over a list of values.
    #[serde(default)]
    pub study: Vec<Study>,
    /// Published values the case is held against.
    #[serde(default)]
    pub published: Vec<Published>,
    /// Published curves over time that channels are held against.
    #[serde(default)]
    pub published_curve: Vec<PublishedCurve>,
    /// Published statements of trend, checked along a study.
    #[serde(default)]
    pub trend: Vec<Trend>,
    /// Ways in which a hard case is computed, for `seacable study hard-cases`.
    #[serde(default)]
    pub trial: Vec<Trial>,
}

impl Case {
    /// A case of this title with these ends, without materials and sections; all else as in a file that leaves it out.
    #[must_use]
    pub fn new(title: &str, ends: Ends) -> Self {
        Self {
            case: About {
                title: title.to_owned(),
                source: String::new(),
                notes: String::new(),
                beside: None,
            },
            environment: Environment::default(),
            current: None,
            waves: None,
            seabed: None,
            materials: BTreeMap::new(),
            line: Vec::new(),
            ends,
            payload: None,
            floats: Vec::new(),
            clumps: Vec::new(),
            traveller: None,
            modules: Vec::new(),
            files: BTreeMap::new(),
            start: Start::default(),
            solver: Solver::default(),
            output: Output::default(),
            modes: None,
            marks: BTreeMap::new(),
            study: Vec::new(),
            published: Vec::new(),
            published_curve: Vec::new(),
            trend: Vec::new(),
            trial: Vec::new(),
        }
    }
}

/// What a case is, for people.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// One line.
    pub title: String,
    /// Where the data come from.
    #[serde(default)]
    pub source: String,
    /// A few sentences: the scene, what is missing in the source, what was decided.
    #[serde(default)]
    pub notes: String,
    /// Names of other case files whose stored runs are listed with those of this one.
    pub beside: Option<Vec<String>>,
}

/// Water and gravity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Gravity \[m/s²\].
    pub gravity_m_per_s2: f64,
    /// Density of the water \[kg/m³\].
    pub water_density_kg_per_m3: f64,
    /// Kinematic viscosity of the water \[m²/s\], for Reynolds numbers.
    pub kinematic_viscosity_m2_per_s: f64,
    /// Whether the line leaves the water where it is above the surface.
    pub water_surface: WaterSurface,
}

impl Default for Environment {
    fn default() -> Self {
        Self {
            gravity_m_per_s2: 9.80665,
            water_density_kg_per_m3: 1025.0,
            kinematic_viscosity_m2_per_s: 1.19e-6,
            water_surface: WaterSurface::Ignored,
        }
    }
}

/// A current: uniform (`speed_m_per_s` one number) or a table over depth (lists of equal length).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Current {
    /// Speed \[m/s\]: one number, or one for each depth.
    pub speed_m_per_s: OneOrMany,
    /// Direction the water flows to, from +x towards +y \[deg\]: one number, or one for each depth.
    #[serde(default = "zero")]
    pub direction_deg: OneOrMany,
    /// Depths below still water \[m\], increasing; needed when speed or direction is a list. Linear
    /// in between (by components), constant above the first and below the last.
    pub depth_m: Option<Vec<f64>>,
}

fn zero() -> OneOrMany {
    OneOrMany::One(0.0)
}

/// One number, or a list of numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum OneOrMany {
    /// One number.
    One(f64),
    /// A list.
    Many(Vec<f64>),
}
