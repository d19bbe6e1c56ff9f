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

use nalgebra::{Matrix6, Vector6};
use serde::{Deserialize, Serialize};

use super::body_damping::damped_velocities;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::system::network::Network;
use crate::system::potential_flow::retardation::{PAIRS, Retardation};
use crate::system::potential_flow::wave_loads::WaveLoads;

/// Rows that a history has room for at the start.
const ROOM: usize = 4096;

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

/// The loads of the flow in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FlowLoad {
    /// Force \[N\] and moment about the origin \[N m\] of the waves, in the earth's directions.
    pub waves: Vector6<f64>,
    /// Load of the memory at no velocity, along the axes that damping acts in \[N, N m\].
    pub memory: Vector6<f64>,
    /// Damping of the memory, along the same axes \[N s/m, N s, N m s\].
    pub damping: Matrix6<f64>,
}

/// Velocities of a body along the axes that damping acts in at the accepted times, as far back as its memory goes.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct VelocityHistory {
    rows: Vec<(f64, Vector6<f64>)>,
}

impl Default for VelocityHistory {
    fn default() -> Self {
        Self {
            rows: Vec::with_capacity(ROOM),
        }
    }
}

impl Clone for VelocityHistory {
    fn clone(&self) -> Self {
        let mut made = Self::default();
        made.rows.extend_from_slice(&self.rows);
        made
    }

    fn clone_from(&mut self, other: &Self) {
        self.rows.clone_from(&other.rows);
    }
}

impl VelocityHistory {
    /// Adds the velocity at an accepted time \[s\], and forgets what is older than the memory.
    fn push(&mut self, t: f64, velocity: Vector6<f64>, memory: f64) {
        if let Some(last) = self.rows.last_mut().filter(|last| last.0 >= t) {
            *last = (t, velocity);
            return;
        }
        self.rows.push((t, velocity));
        let old = self.rows.iter().take_while(|row| row.0 < t - memory);
        let old = old.count().saturating_sub(1);
        // Seldom, since what is left has to be moved.
        if old > ROOM / 4 {
            self.rows.drain(..old);
        }
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
            retardation: flow.radiation.as_ref().map(Retardation::new),
            waves: sea.map(|sea| WaveLoads::new(flow, sea, &given.pose)),
        })
    };
    bodies.filter_map(flow).collect()
}

/// Works the loads at time t \[s\] out, from what is known before the step.
pub fn prepare(system: &MovingSystem, t: f64, state: &mut SystemState) {
    let parts = system.flows.iter().zip(&mut state.flow_loads);
    for ((flow, load), history) in parts.zip(&state.velocities) {
        *load = FlowLoad::default();
        if let Some(waves) = &flow.waves {
            load.waves = waves.at(t);
        }
        if let Some(retardation) = &flow.retardation {
            remember(retardation, &history.rows, t, load);
        }
    }
}

/// Adds the velocities of an accepted state at time t \[s\] to the histories.
pub fn commit(system: &MovingSystem, t: f64, state: &mut SystemState) {
    for (number, flow) in system.flows.iter().enumerate() {
        if let Some(retardation) = &flow.retardation {
            let body = &system.network.bodies[flow.body];
            let velocity = damped_velocities(body, &system.body(state, flow.body));
            state.velocities[number].push(t, velocity, retardation.duration());
        }
    }
}

/// The memory at time t \[s\] of these velocities.
fn remember(retardation: &Retardation, rows: &[(f64, Vector6<f64>)], t: f64, load: &mut FlowLoad) {
    // What is older than the memory is forgotten: its convolution ends where the first row that counts begins.
    let old = rows.partition_point(|row| t - row.0 > retardation.duration());
    let rows = &rows[old.saturating_sub(1)..];
    let (Some((first, v0)), Some((last, now))) = (rows.first(), rows.last()) else {
        return;
    };
    let mut before = [0.0; PAIRS];
    retardation.first_integrals(t - first, &mut before);
    for ((i, j), g) in retardation.pairs().zip(&before) {
        load.memory[i] -= g * v0[j];
    }
    let mut sum = [0.0; PAIRS];
    retardation.convolve(rows, t, &mut sum);
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
