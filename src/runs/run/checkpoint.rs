//! The state of a computation after an accepted step, complete enough to be resumed to the same bits.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::outlook::Cheaper;
use super::recorder_state::RecorderState;
use super::step_envelope;
use crate::case::{self, Case, Method};
use crate::dynamics::{MarchProgress, MethodState};
use crate::scene::Scene;
use crate::solve::{Kinematics, State};

/// The state of a computation after an accepted step, of a line or, with states X, of a system. Written as `checkpoint.toml`.
///
/// What has tables comes last: values behind a table are inserted into the text before it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint<X = State> {
    /// Digests of the case by its tables ([`digests`](case::digests)), which name what was changed.
    pub case: BTreeMap<String, String>,
    /// Length of a whole step \[s\].
    pub whole_step_s: f64,
    /// Changes so far that are counted: events of a line.
    pub phase: usize,
    /// Newton iterations of the search for the start.
    pub start_iterations: u64,
    /// Warnings of the start.
    pub warnings: Vec<String>,
    /// What happened to the lines so far, in words.
    pub happened: Vec<String>,
    /// Position of the time march.
    pub place: MarchProgress,
    /// State of the time integration method.
    pub method: MethodState,
    /// What is recorded so far.
    pub recorded: RecorderState,
    /// The state of the line, or of the lines, points and bodies.
    pub state: X,
}

impl<X> Checkpoint<X> {
    /// Time of the state \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.recorded.time().unwrap_or(self.place.time)
    }
}

impl Checkpoint {
    /// Checks that it is one of this case.
    ///
    /// # Errors
    /// Which tables of the case differ, in words.
    pub(super) fn check_case(&self, case: &Case) -> Result<(), String> {
        let here = case::digests(case);
        let differs = |name: &&String| self.case.get(*name) != here.get(*name);
        let names: BTreeSet<&String> = self.case.keys().chain(here.keys()).collect();
        let changed: Vec<String> = names
            .into_iter()
            .filter(differs)
            .map(|name| format!("[{name}]"))
            .collect();
        if changed.is_empty() {
            return Ok(());
        }
        let changed = changed.join(", ");
        Err(format!(
            "the case was changed in {changed} since it was written; undo the change, or compute the case anew"
        ))
    }

    /// The method by which it was written, of a case that leaves the choice to the program.
    pub(super) fn chosen_method(&self, case: &Case) -> Cheaper {
        let mut by_rk4 = case.clone();
        by_rk4.solver.method = Method::Rk4;
        match self.check_case(&by_rk4) {
            Ok(()) => Cheaper::Rk4,
            Err(_) => Cheaper::Alpha,
        }
    }

    /// Checks that it belongs to this line and these channels: sizes agree, and all numbers are finite.
    ///
    /// # Errors
    /// What does not agree, in words.
    pub(super) fn check(&self, scene: &Scene, channels: usize) -> Result<(), String> {
        self.check_lists(scene)?;
        self.recorded
            .check(channels, &[step_envelope::profile(scene)])?;
        self.check_parts(scene)?;
        let state = &self.state;
        let vectors = [&state.x, &state.v, &state.a];
        let mut numbers = vectors.into_iter().flatten().flat_map(|v| v.iter());
        let step = self.whole_step_s;
        if numbers.all(|number| number.is_finite()) && step.is_finite() && step > 0.0 {
            Ok(())
        } else {
            Err("it holds numbers that are not finite".to_owned())
        }
    }

    /// Checks every list with an entry a node, segment or channel.
    fn check_lists(&self, scene: &Scene) -> Result<(), String> {
        let (nodes, segments) = (scene.nodes(), scene.nodes() - 1);
        let (state, memory) = (&self.state, &self.state.memory);
        let needed = [
            ("positions", state.x.len(), nodes),
            ("velocities", state.v.len(), nodes),
            ("accelerations", state.a.len(), nodes),
        ];
        let optional = [
            ("friction springs", memory.grips.len(), nodes),
            (
                "drag coefficients",
                memory.drag_coefficients.len(),
                segments,
            ),
            ("ropes", memory.ropes.len(), segments),
            ("ropes that creep", memory.creep.len(), segments),
            (
                "extrapolated tensions",
                state.extrapolated_tension.len(),
                segments,
            ),
            ("chord corrections", state.chord_correction.len(), segments),
        ];
        let needed = needed.into_iter().filter(|(_, found, size)| found != size);
        let optional = optional
            .into_iter()
            .filter(|(_, found, size)| *found != 0 && found != size);
        match needed.chain(optional).next() {
            Some((what, found, size)) => Err(format!("it has {found} {what} instead of {size}")),
            None => Ok(()),
        }
    }

    /// Checks what the bodies and the march left of it.
    fn check_parts(&self, scene: &Scene) -> Result<(), String> {
        let bodies = scene.elements.body_contact.as_ref();
        let bodies = bodies.map_or(0, |contact| contact.bodies.len());
        let known = self.state.memory.bodies.len();
        let parts = [
            ("place in the march", self.place.is_possible()),
            ("method", self.method.fits(&[scene.nodes()])),
            // A body that was released keeps its history.
            ("bodies on the bed", known == 0 || known >= bodies),
        ];
        match parts.into_iter().find(|(_, fits)| !fits) {
            Some((what, _)) => Err(format!("its {what} cannot be that of this line")),
            None => Ok(()),
        }
    }
}

/// A stored run of a line to be resumed.
pub type ResumedRun = Resumed<State>;

/// A stored run to be resumed.
#[derive(Debug, Clone, PartialEq)]
pub struct Resumed<X> {
    /// Its state.
    pub checkpoint: Checkpoint<X>,
    /// The run directory, with the record up to there and perhaps beyond.
    pub dir: PathBuf,
}
