//! Tension with its derivative and strain energy.

/// Elastic tension of a rope, and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticTension {
    /// Tension \[N\]; negative where the rope, were it a rod, would push.
    pub tension: f64,
    /// Derivative by strain \[N\].
    pub by_strain: f64,
}
