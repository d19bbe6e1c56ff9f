//! Loads of potential flow on a body.

use nalgebra::{Matrix6, Vector6};

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
