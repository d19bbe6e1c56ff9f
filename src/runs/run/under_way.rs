//! What a run moves through time: a line by itself, or lines, points and bodies together.

use std::collections::BTreeMap;

use serde::Serialize;

use super::checkpoint::Checkpoint;
use super::observer::NodeChange;
use super::recorded::Recorded;
use crate::dynamics::{March, Method, MethodState};
use crate::scene::EnergyRates;
use crate::solve::{Integrated, Iterated, NewtonError, PartedSystem};

/// The states of what is under way.
pub type StateOf<T> = <<T as UnderWay>::System as PartedSystem>::State;

/// Its methods.
pub type MethodOf<T> = Method<StateOf<T>, <<T as UnderWay>::System as Iterated>::Work>;

/// A system on its way through time, with what is recorded of it and what changes it.
pub trait UnderWay {
    /// What the methods move.
    type System: Integrated<State: Serialize>;

    /// What changes it at an instant: an end that is let go, a node that comes or goes.
    type Change: Copy;

    /// The system as it is now.
    fn system(&self) -> &Self::System;

    /// What is recorded of it.
    fn recorded(&self) -> impl Recorded<State = StateOf<Self>>;

    /// The method, from a state.
    fn method(&self, state: &StateOf<Self>) -> MethodOf<Self>;

    /// Whether the forces at the start are not those of its rest once its history is taken in.
    fn begins_off_rest(&self) -> bool;

    /// The energy at the start with the ends in motion, which are pulled along at once: their own kinetic energy is no work of a force.
    fn energy_in_motion(&self, _state: &StateOf<Self>) -> Option<EnergyRates> {
        None
    }

    /// The next time at which it changes \[s\]; infinite where there is none.
    fn next_change(&self) -> f64;

    /// The next change whose time has come.
    fn due(
        &mut self,
        has_come: &dyn Fn(f64) -> bool,
        state: &StateOf<Self>,
    ) -> Option<Self::Change>;

    /// What the state after an accepted step, at this time \[s\], changes.
    fn by_state(&self, _time: f64, _state: &StateOf<Self>) -> Option<Self::Change> {
        None
    }

    /// Changes it at a time \[s\]. A node that comes or goes changes the state of the method too.
    ///
    /// # Errors
    /// Why it cannot go on, in words.
    fn change(
        &mut self,
        change: Self::Change,
        time: f64,
        state: &mut StateOf<Self>,
        method: &mut MethodState,
    ) -> Result<Option<NodeChange>, String>;

    /// What happened to the lines so far, in words.
    fn happened(&self) -> &[String] {
        &[]
    }

    /// Digests of its file by tables, for a checkpoint; none where the text as a whole has one.
    fn digests(&self) -> BTreeMap<String, String> {
        BTreeMap::new()
    }

    /// Changes so far that a checkpoint counts.
    fn phase(&self) -> usize {
        0
    }

    /// Goes to where a checkpoint of a march with so many channels is, and takes its state.
    ///
    /// # Errors
    /// Why it does not belong to it, in words.
    fn resume(
        &mut self,
        from: &Checkpoint<StateOf<Self>>,
        state: &mut StateOf<Self>,
        channels: usize,
        march: March,
    ) -> Result<(), String>;

    /// Why the forces at a time \[s\] are not solved for, and what to try; `step`: the shortest step tried \[s\].
    fn in_words(&self, time: f64, step: Option<f64>, why: &NewtonError) -> String;
}

/// That steps of several lengths were tried, in words.
#[must_use]
pub fn halved(step: Option<f64>) -> String {
    step.map_or_else(String::new, |step| {
        format!(" (the step was halved down to {step:.3e} s)")
    })
}
