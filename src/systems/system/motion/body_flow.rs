//! Potential flow around the free bodies of a system in motion: the memory of radiated waves, and the loads of incident ones.
//!
//! Between accepted steps velocities are straight lines, for which the convolution with the retardation functions is exact: with H the second
//! integral of K and m the slopes of the velocity, the memory at time t is
//!
//! ```text
//! G(t - t0) v0 + sum m_k (H(t - t_k) - H(t - t_k+1)) + (v - v_n) H(h)/h
//! ```
//!
//! over the accepted times t_k and the step h under way. The last term is a damping of the step, in the tangent too.

use super::body_damping::damped_velocities;
use super::flow_load::FlowLoad;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use super::velocity_history::VelocityHistory;
use crate::system::network::Network;
use crate::system::potential_flow::retardation::{PAIRS, Retardation};
use crate::system::potential_flow::wave_loads::WaveLoads;

/// The flow around a body.
#[derive(Debug, Clone)]
pub struct BodyFlow {
    /// The body.
    pub body: usize,
    /// Its retardation functions.
    pub retardation: Option<Retardation>,
    /// Loads of the waves.
    pub(super) waves: Option<WaveLoads>,
}

impl BodyFlow {
    /// Whether waves load the body.
    #[must_use]
    pub fn has_waves(&self) -> bool {
        self.waves.is_some()
    }
}

/// The flows around the bodies that have coefficients.
#[must_use]
pub fn flows(network: &Network) -> Vec<BodyFlow> {
    let bodies = network.bodies.iter().enumerate();
    let flow = |(body, given): (usize, &crate::system::network::Body)| {
        let flow = given.potential_flow.as_ref().filter(|_| given.free)?;
        let feels = flow.excitation.is_some() || flow.drift.is_some();
        let sea = network.sea.as_ref().filter(|_| feels);
        Some(BodyFlow {
            body,
            retardation: flow.radiation.as_deref().map(Retardation::new),
            waves: sea.map(|sea| WaveLoads::new(flow, sea, &given.pose)),
        })
    };
    bodies.filter_map(flow).collect()
}

/// Works the loads at time t \[s\] out, from what is known before the step.
pub fn prepare(system: &MovingSystem, t: f64, state: &mut SystemState) {
    let parts = system.flows.iter().zip(&mut state.flow_loads);
    for ((flow, load), history) in parts.zip(&mut state.velocities) {
        *load = FlowLoad::default();
        if let Some(waves) = &flow.waves {
            load.waves = waves.at(t);
        }
        if let Some(retardation) = &flow.retardation {
            history.complete(retardation);
            remember(retardation, history, t, load);
        }
    }
}

/// Adds the velocities of an accepted state at time t \[s\] to the histories.
pub fn commit(system: &MovingSystem, t: f64, state: &mut SystemState) {
    for (number, flow) in system.flows.iter().enumerate() {
        if let Some(retardation) = &flow.retardation {
            let body = &system.network.bodies[flow.body];
            let velocity = damped_velocities(body, &system.body(state, flow.body));
            state.velocities[number].push(t, velocity, retardation);
        }
    }
}

/// The memory at time t \[s\] of these velocities.
fn remember(retardation: &Retardation, history: &VelocityHistory, t: f64, load: &mut FlowLoad) {
    // What is older than the memory is forgotten: its convolution ends where the first row that counts begins.
    let (rows, slopes) = history.since(t - retardation.duration(), retardation);
    let (Some((first, v0)), Some((last, now))) = (rows.first(), rows.last()) else {
        return;
    };
    let mut before = [0.0; PAIRS];
    retardation.first_integrals(t - first, &mut before);
    for ((i, j), g) in retardation.pairs().zip(&before) {
        load.memory[i] -= g * v0[j];
    }
    let mut sum = [0.0; PAIRS];
    retardation.convolve((rows, slopes), t, &mut sum);
    for ((i, _), sum) in retardation.pairs().zip(&sum) {
        load.memory[i] -= sum;
    }
    let h = t - last;
    if h > 0.0 {
        retardation.second_integrals(h, &mut before);
        for ((i, j), second) in retardation.pairs().zip(&before) {
            load.damping[(i, j)] = second / h;
            load.memory[i] += second / h * now[j];
        }
    }
}
