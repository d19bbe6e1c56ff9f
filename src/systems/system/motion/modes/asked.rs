//! The numbers of natural modes that a file asks for by its table `[modes]`.

use super::whole::lowest_at_rest;
use crate::case::schema::Key;
use crate::case::{Finding, QuantityId, Subject};
use crate::run::Quantity;
use crate::run::natural_modes::{numbers, wanted};
use crate::system::SolvedSystem;
use crate::system::model::SystemKeys;

impl SolvedSystem {
    /// Frequencies of its natural modes in and out of its plane \[Hz\], and the numbers of those nearest to a frequency, as its file asks for
    /// them; none where it does not.
    ///
    /// # Errors
    /// Why there are none, in words.
    pub fn asked_modes(&self) -> Result<&[Quantity], &str> {
        self.modes.found(|| {
            let Some(asked) = &self.file.modes else {
                return Ok(Vec::new());
            };
            let found = lowest_at_rest(self, 1.0, wanted(asked));
            let found = found.map_err(|why| format!("{}; {}", why.problem, why.remedy))?;
            Ok(numbers(asked, &found.modes))
        })
    }

    /// A number of its natural modes by its name, such as `in_plane_hz[2]`; nothing for other results.
    #[must_use]
    pub fn asked_mode(&self, name: &str) -> Option<Result<f64, String>> {
        let id = id_of_mode(name)?;
        let why = |why: &str| format!("There are no natural modes: {why}.");
        let found = self.asked_modes().map_err(why);
        let value = |numbers: &[Quantity]| {
            let number = numbers.iter().find(|number| number.id == id);
            let value = number.map(|number| number.value);
            value.ok_or_else(|| format!("There is no natural mode `{name}` among those found."))
        };
        Some(found.and_then(value))
    }
}

/// The number of natural modes of this name, `in_plane_hz[2]` or as in the summary of a run; nothing of another result.
#[must_use]
pub fn id_of_mode(name: &str) -> Option<QuantityId> {
    let id = match name.parse::<Subject>() {
        Ok(subject) => QuantityId::single(subject),
        Err(_) => name.parse().ok()?,
    };
    let is_of_mode = matches!(
        id.parts().0,
        Subject::ModeFrequency(..) | Subject::NearestMode(_)
    );
    is_of_mode.then_some(id)
}

/// A number of natural modes that a file does not ask for; nothing of one that it does, or of another result.
pub(in crate::system) fn not_asked(
    key: &Key<'_, String>,
    keys: &SystemKeys<'_>,
) -> Option<Finding> {
    let id = id_of_mode(key.get()?)?;
    let modes = keys.modes.as_ref();
    let asked = modes.and_then(|modes| {
        let near = modes.near_hz.get().is_some();
        Some(Subject::of_modes(modes.count.value()?, near))
    });
    let mut asked = asked.unwrap_or_default().into_iter();
    let is_asked = asked.any(|subject| QuantityId::single(subject) == id);
    (!is_asked).then(|| {
        key.finding(
            "is of a natural mode that the file does not ask for",
            "add [modes], with a `count` of as many and `near_hz` for the numbers of modes near a frequency",
        )
    })
}
