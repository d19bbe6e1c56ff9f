//! A part of the screen that is asked for.

use super::{document_content::DocumentContent, parts::PartKey};

/// A part that is asked for.
#[derive(Debug, Clone)]
pub struct PartRequest {
    /// The part.
    pub key: PartKey,
    /// The model that it is of; absent for a part of a run.
    pub model: Option<DocumentContent>,
}
