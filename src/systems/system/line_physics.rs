//! Which part of the physics of the lines counts.

/// Which part of the physics of the lines counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinePhysics {
    /// Weight and stretch, as in the first search.
    Plain,
    /// Friction of the bed, current, wind and bending as well.
    Full,
}
