//! The normal reaction of the sea bed on a node.

/// Force of the bed on a node along its normal, with derivatives.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BedReaction {
    /// Force \[N\].
    pub force: f64,
    /// Derivative by the height above the bed, along its normal \[N/m\].
    pub by_height: f64,
    /// Derivative by the speed away from the bed \[N s/m\].
    pub by_speed: f64,
}
