//! The numbers of natural modes of a system, once they were found.

use std::sync::OnceLock;

use crate::run::Quantity;

/// What was found of a system; a copy, whose file may be changed, begins anew.
#[derive(Debug, Default)]
pub struct AskedModes(OnceLock<Result<Vec<Quantity>, String>>);

impl AskedModes {
    /// What was found, or is now.
    ///
    /// # Errors
    /// Why there are none, in words.
    pub(super) fn found(
        &self,
        find: impl FnOnce() -> Result<Vec<Quantity>, String>,
    ) -> Result<&[Quantity], &str> {
        let found = self.0.get_or_init(find);
        found.as_deref().map_err(String::as_str)
    }
}

impl Clone for AskedModes {
    fn clone(&self) -> Self {
        Self::default()
    }
}
