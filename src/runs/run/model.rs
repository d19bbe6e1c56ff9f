//! A run as plain data, complete in itself: the case text it came from, every setting used, results
//! with units and estimated errors, work and cost. Screen, command line and report only read it.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::along::FatigueSpot;
use super::{QuantityId, SearchProgress};
use crate::case::{ChannelId, ChannelQuantity};
use crate::numerics::richardson::OBSERVED;
use crate::published::ComputedNumber;

pub use seacable_base::VERSION;

/// The results of one execution of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What was computed and how: everything of `run.toml`.
    pub info: RunInfo,
    /// The exact text of the case, with every override applied, and with the files it names.
    pub case_text: String,
    /// Channels against time; of a long run some of the output times, see [`DecimatedRecord`](super::DecimatedRecord).
    pub history: History,
    /// Shapes of the lines at chosen instants, oldest first; decimated likewise.
    pub shapes: Vec<LineShape>,
    /// The lines at the end of the run, node by node, with envelopes over time.
    pub profiles: Vec<Profile>,
    /// Single numbers with their estimated numerical errors.
    pub summary: Vec<Quantity>,
    /// The damage along the line, where checks count it.
    pub fatigue: Vec<FatigueSpot>,
}

impl Run {
    /// The single number of this name: `tension_n[wire|payload].max`.
    #[must_use]
    pub fn quantity(&self, name: &str) -> Option<&Quantity> {
        let id = name.parse::<QuantityId>().ok()?;
        self.summary.iter().find(|q| q.id == id)
    }

    /// The first line node by node; one without nodes where there is none.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        static NONE: LazyLock<Profile> = LazyLock::new(Profile::default);
        self.profiles.first().unwrap_or(&NONE)
    }

    /// Number of output times, those included that the history leaves out.
    #[must_use]
    pub fn output_times(&self) -> usize {
        let kept = self.history.time.len();
        let interval = self.info.settings.output_interval_s;
        match self.history.time.last() {
            Some(last) if interval > 0.0 => kept.max((last / interval).round() as usize + 1),
            _ => kept,
        }
    }
}

/// What was computed and how.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunInfo {
    /// Name of the run; also the name of its directory.
    pub id: String,
    /// Title of the case.
    pub title: String,
    /// File name of the case, without directories.
    pub case_file: String,
    /// The state of the run.
    pub state: RunState,
    /// Version of the program.
    pub version: String,
    /// When it began, RFC 3339 in UTC.
    pub started: String,
    /// Keys that were set on top of the case file, as `key=value`.
    pub overrides: Vec<String>,
    /// Reason, when it failed.
    pub failure: Option<String>,
    /// What the user should know before trusting the numbers.
    pub warnings: Vec<String>,
    /// What happened to the lines of a system, in words: ends let go, breaks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub happened: Vec<String>,
    /// Settings used, also those chosen automatically.
    pub settings: Settings,
    /// Machine-independent work of the run itself, without its companions.
    pub work: Work,
    /// What it took.
    pub cost: Cost,
}

/// The state of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RunState {
    /// Being computed, or the program was killed while it computed it: see
    /// [`is_locked`](super::store::is_locked).
    Partial,
    /// Complete.
    Done,
    /// The solver failed; the results before are kept.
    Failed,
    /// Stopped by the user; the results before are kept.
    Cancelled,
}

impl RunState {
    /// Whether it was stopped, by a signal, a kill or the user.
    #[must_use]
    pub const fn was_stopped(self) -> bool {
        matches!(self, Self::Partial | Self::Cancelled)
    }
}

/// Settings used by the solver.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// `static`, `quasi`, `rk4` or `alpha`.
    pub method: String,
    /// Simulated time \[s\].
    pub duration_s: f64,
    /// Time step \[s\]; the longest where steps vary.
    pub time_step_s: f64,
    /// Error allowed in a step of varying length \[-\]; absent where steps are constant.
    #[serde(default)]
    pub step_tolerance: Option<f64>,
    /// True when the solver chose the step.
    pub time_step_automatic: bool,
    /// Spectral radius of generalized-alpha; absent for other methods.
    pub rho_inf: Option<f64>,
    /// Damping ratio that generalized-alpha adds by itself at the period below, in steps of the mean length taken; absent
    /// for other methods.
    #[serde(default)]
    pub numerical_damping: Option<f64>,
    /// That period \[s\]: of the motion of an end, or of the line bouncing along itself.
    #[serde(default)]
    pub numerical_damping_period_s: Option<f64>,
    /// Why this method, where the case leaves the choice to the program.
    #[serde(default)]
    pub method_reason: Option<String>,
    /// The accuracy asked for, and what was reached by which settings, in words.
    #[serde(default)]
    pub accuracy: Option<String>,
    /// Stability limit of explicit methods \[s\].
    pub stability_limit_s: Option<f64>,
    /// Where that limit comes from ("segment 57, wire").
    pub stability_limit_at: Option<String>,
    /// Newton's tolerance on positions \[m\].
    pub position_tolerance_m: Option<f64>,
    /// Number of nodes, both ends counted.
    pub nodes: usize,
    /// Output interval \[s\].
    pub output_interval_s: f64,
    /// How the numerical errors were estimated, in words.
    pub error_method: String,
}

/// Work that does not depend on the machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Work {
    /// Accepted time steps.
    pub steps: u64,
    /// Steps rejected and halved.
    pub rejections: u64,
    /// Newton iterations (assemblies with tangent and block solves).
    pub iterations: u64,
    /// Evaluations of the force without tangent.
    pub evaluations: u64,
}

/// Time that a run took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// CPU time of the run itself \[s\].
    pub cpu_s: f64,
    /// Wall time of the run itself \[s\].
    pub wall_s: f64,
    /// Wall time of the companion runs that estimate errors \[s\].
    pub companions_wall_s: f64,
}

/// Channels against time; every channel has as many values as there are times.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// Times \[s\], increasing.
    pub time: Vec<f64>,
    /// The channels, in the order of the file.
    pub channels: Vec<Channel>,
}

impl History {
    /// The channel of this name: `tension_n[wire|payload]`.
    #[must_use]
    pub fn channel(&self, name: &str) -> Option<&Channel> {
        let id = name.parse::<ChannelId>().ok()?;
        self.channels.iter().find(|c| c.id == id)
    }

    /// The channel of a quantity at a place.
    #[must_use]
    pub fn at(&self, quantity: ChannelQuantity, place: &str) -> Option<&Channel> {
        let mut of_quantity = self.channels.iter().filter(|c| c.id.quantity == quantity);
        of_quantity.find(|c| c.id.place == place)
    }
}

/// One quantity against time, at one place.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// What identifies it; its text is the name in `history.csv`.
    pub id: ChannelId,
    /// Values at the output times.
    pub values: Vec<f64>,
    /// Greatest value over every step of the solver, and its time \[s\].
    pub peak: (f64, f64),
    /// Smallest value over every step of the solver, and its time \[s\].
    pub trough: (f64, f64),
}

impl Channel {
    /// A channel without values yet.
    #[must_use]
    pub const fn new(id: ChannelId) -> Self {
        Self {
            id,
            values: Vec::new(),
            peak: (f64::NEG_INFINITY, 0.0),
            trough: (f64::INFINITY, 0.0),
        }
    }

    /// Name as in `history.csv`: `tension_n[wire|payload]`.
    #[must_use]
    pub fn name(&self) -> String {
        self.id.to_string()
    }

    /// Unit as shown ("N", "m").
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        self.id.quantity.unit()
    }
}

/// A line at one instant.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LineShape {
    /// Time \[s\].
    pub time: f64,
    /// Number of the line, from 0.
    pub line: usize,
    /// Positions of the nodes \[m\], from A to B.
    pub nodes: Vec<[f64; 3]>,
    /// Tensions at the nodes \[N\]: the mean of the segments that meet there; at an end, its segment's.
    pub tension: Vec<f64>,
    /// Curvatures \[1/m\]; empty where nothing bends, or they are not known.
    pub curvature: Vec<f64>,
    /// Heights above the bed, normal to it \[m\]; empty without a bed, or where they are not known.
    pub height: Vec<f64>,
}

/// The line node by node: its state at the end of the run, and envelopes over every step.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// Name of the line; empty of a line by itself.
    #[serde(default)]
    pub line: String,
    /// Unstretched arc length from A \[m\].
    pub arc: Vec<f64>,
    /// Positions \[m\].
    pub nodes: Vec<[f64; 3]>,
    /// Tensions \[N\].
    pub tension: Vec<f64>,
    /// Smallest tensions \[N\].
    pub tension_min: Vec<f64>,
    /// Greatest tensions \[N\].
    pub tension_max: Vec<f64>,
    /// Lowest heights \[m\].
    pub z_min: Vec<f64>,
    /// Greatest heights \[m\].
    pub z_max: Vec<f64>,
    /// Heights above the bed, normal to a plane, vertical over a grid \[m\]; empty without a bed.
    #[serde(default)]
    pub bed_clearance: Vec<f64>,
    /// Least heights above the bed \[m\]; likewise.
    #[serde(default)]
    pub bed_clearance_min: Vec<f64>,
    /// Curvatures \[1/m\]; empty where nothing bends, zero at hinges.
    pub curvature: Vec<f64>,
    /// Greatest curvatures \[1/m\]; likewise.
    pub curvature_max: Vec<f64>,
    /// Bending moments \[N m\]; likewise.
    pub moment: Vec<f64>,
    /// Greatest bending moments \[N m\]; likewise.
    pub moment_max: Vec<f64>,
    /// Ropes with dynamic stiffness; empty where there are none.
    pub ropes: RopeProfile,
    /// Root mean square displacements about the mean \[m\]; empty where the case does not ask for them.
    pub rms: Vec<f64>,
    /// The same by the diameter \[-\]; likewise.
    pub rms_diameters: Vec<f64>,
    /// Root mean square displacements along z alone by the diameter \[-\]; likewise.
    #[serde(default)]
    pub rms_vertical: Vec<f64>,
    /// The same in the plane of x and y \[-\]; likewise.
    #[serde(default)]
    pub rms_horizontal: Vec<f64>,
    /// Displacement across the line at the driving period, `Re((cos + i sin) e^(i omega t))` \[m\]: its real part; likewise.
    pub wave_cos: Vec<f64>,
    /// Its imaginary part \[m\]; likewise.
    pub wave_sin: Vec<f64>,
    /// Numerical error of the root mean squares \[m\]; empty where it was not estimated.
    #[serde(default)]
    pub rms_error: Vec<f64>,
    /// Local wave number of the motion at the driving period \[1/m\]; empty where nothing drives the line at one.
    #[serde(default)]
    pub wave_number: Vec<f64>,
    /// The same by WKB theory of the line at rest \[1/m\]; likewise.
    #[serde(default)]
    pub wkb_number: Vec<f64>,
    /// Amplitude of a wave by WKB theory, without drag, the greatest 1 \[-\]; likewise.
    #[serde(default)]
    pub wkb_amplitude: Vec<f64>,
    /// Amplitude of what runs towards end A at the driving period \[m\]; likewise.
    #[serde(default)]
    pub towards_a: Vec<f64>,
    /// Amplitude of what runs towards end B \[m\]; likewise.
    #[serde(default)]
    pub towards_b: Vec<f64>,
}

impl Profile {
    /// Whether all that every step widens has as many entries as in another profile.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let sizes = |p: &Self| {
            [
                p.arc.len(),
                p.nodes.len(),
                p.tension.len(),
                p.tension_min.len(),
                p.tension_max.len(),
                p.z_min.len(),
                p.z_max.len(),
                p.bed_clearance_min.len(),
                p.curvature_max.len(),
                p.moment_max.len(),
            ]
        };
        let ropes = &self.ropes;
        let of_ropes = [
            &ropes.mean_load,
            &ropes.deviation_min,
            &ropes.deviation_max,
            &ropes.stiffness,
            &ropes.stiffness_min,
            &ropes.stiffness_max,
        ];
        let alike = |list: &&Vec<f64>| list.len() == ropes.arc.len();
        sizes(self) == sizes(other) && of_ropes.iter().all(alike)
    }

    /// True when the line bends: curvatures and moments are then as many as nodes.
    #[must_use]
    pub fn bends(&self) -> bool {
        !self.moment.is_empty()
    }

    /// Diameters of the nodes \[m\], from the root mean square displacements; of a node at rest, that of its neighbour.
    #[must_use]
    pub fn diameters(&self) -> Option<Vec<f64>> {
        let pairs = self.rms.iter().zip(&self.rms_diameters);
        let known: Vec<Option<f64>> = pairs
            .map(|(rms, by)| (*by > 0.0).then(|| rms / by))
            .collect();
        let mut last = known.iter().copied().flatten().next()?;
        let of = |here: Option<f64>| {
            last = here.unwrap_or(last);
            last
        };
        Some(known.into_iter().map(of).collect())
    }
}

/// The segments of rope that have dynamic stiffness, from A to B, at the end of the run, and envelopes over every
/// step; empty where there are none.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct RopeProfile {
    /// Unstretched arc length from A to the middles of the segments \[m\].
    pub arc: Vec<f64>,
    /// Lm at the end: mean of the past tension, in percent of the breaking load.
    pub mean_load: Vec<f64>,
    /// Smallest La: deviation of the tension from the mean, in percent of the breaking load.
    pub deviation_min: Vec<f64>,
    /// Greatest La, likewise.
    pub deviation_max: Vec<f64>,
    /// k at the end: stiffness EA by breaking load \[-\].
    pub stiffness: Vec<f64>,
    /// Smallest k \[-\].
    pub stiffness_min: Vec<f64>,
    /// Greatest k \[-\].
    pub stiffness_max: Vec<f64>,
}

impl RopeProfile {
    /// True where no rope has dynamic stiffness.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.arc.is_empty()
    }
}

/// A single number with its estimated numerical errors. Model error is not in it: that is what the
/// validation table shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// What identifies it; its text is the name in `summary.csv`.
    pub id: QuantityId,
    /// Value, in the unit of the quantity.
    pub value: f64,
    /// Estimated error from the time step; absent when not estimated.
    pub time_error: Option<f64>,
    /// Estimated error from the mesh; absent when not estimated.
    pub mesh_error: Option<f64>,
    /// The range in which the number lies where the run and its companions do not approach each other, so that no error can be
    /// derived from their differences: "not settled".
    pub unsettled: Option<[f64; 2]>,
}

impl Quantity {
    /// A value whose errors are not estimated.
    #[must_use]
    pub const fn new(id: QuantityId, value: f64) -> Self {
        Self {
            id,
            value,
            time_error: None,
            mesh_error: None,
            unsettled: None,
        }
    }

    /// Name as in `summary.csv`: `tension_n[wire|payload].max`.
    #[must_use]
    pub fn name(&self) -> String {
        self.id.to_string()
    }

    /// Unit as shown.
    #[must_use]
    pub fn unit(&self) -> String {
        self.id.unit()
    }

    /// Time and mesh error together; absent unless at least one was estimated. Of a number that is not settled the distance to
    /// the farther end of its range.
    #[must_use]
    pub fn error_estimate(&self) -> Option<f64> {
        if let Some([least, greatest]) = self.unsettled {
            return Some((self.value - least).max(greatest - self.value));
        }
        match (self.time_error, self.mesh_error) {
            (None, None) => None,
            (t, m) => Some(t.unwrap_or(0.0) + m.unwrap_or(0.0)),
        }
    }

    /// It as a number that is held against a published one.
    #[must_use]
    pub fn computed(&self) -> ComputedNumber {
        let parts = [self.time_error, self.mesh_error];
        ComputedNumber::new(self.value, self.error_estimate(), parts)
    }

    /// The error to be expected: the bar without the factor of safety, by which nearly every single one lies inside.
    #[must_use]
    pub fn expected_error(&self) -> Option<f64> {
        let safety = if self.unsettled.is_some() {
            1.0
        } else {
            OBSERVED
        };
        Some(self.error_estimate()? / safety)
    }
}

/// How far a running job is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// Simulated time \[s\].
    pub time: f64,
    /// Simulated time at the end \[s\].
    pub duration: f64,
    /// Steps taken.
    pub steps: u64,
    /// Wall time so far \[s\].
    pub wall_s: f64,
    /// True once the run itself is complete and its companions estimate errors.
    pub estimating: bool,
    /// How far the search for its mesh and steps is, while it lasts.
    pub search: Option<SearchProgress>,
}

impl Progress {
    /// Fraction done, 0 to 1.
    #[must_use]
    pub fn fraction(&self) -> f64 {
        if self.duration > 0.0 {
            (self.time / self.duration).clamp(0.0, 1.0)
        } else {
            1.0
        }
    }

    /// Estimated wall time remaining \[s\]; absent before anything is done.
    #[must_use]
    pub fn remaining_s(&self) -> Option<f64> {
        let done = self.fraction();
        (done > 0.0).then(|| self.wall_s * (1.0 - done) / done)
    }
}

/// One output instant of a running job.
#[derive(Debug, Clone, PartialEq)]
pub struct OutputFrame {
    /// Time \[s\].
    pub time: f64,
    /// Values of all channels, in their order.
    pub values: Vec<f64>,
    /// The shapes of the lines, at the instants at which shapes are stored.
    pub shapes: Vec<LineShape>,
    /// How far the job is.
    pub progress: Progress,
}
