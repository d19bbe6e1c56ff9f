//! The cross-sections that checks name, as far as cases know them.

use std::sync::Arc;

use super::diagnostic::Diagnostic;

/// A carried text that is a cross-section. The room of cross-sections, which stands on this one, says what its design is.
pub trait SectionText {
    /// What is worked out of it.
    type Design;

    /// The design, which is worked out once.
    ///
    /// # Errors
    /// Everything that is wrong with it, in the order of the lines.
    fn design(&self, file: &str) -> Result<Arc<Self::Design>, Vec<Diagnostic>>;
}
