//! What the status line says.

/// A message to the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StatusMessage {
    /// How much it matters.
    pub level: Severity,
    /// Full sentences.
    pub text: String,
}

/// How much a message matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// Goes away with the next key.
    Info,
    /// Stays until the next message.
    Warning,
    /// Stays, and is an obstacle.
    Error,
}
