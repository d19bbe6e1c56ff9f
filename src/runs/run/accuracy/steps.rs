//! Steps in time, as searches and studies change them.

use crate::case::Method;

/// A method with its steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps {
    /// The method.
    pub method: Method,
    /// Length of constant steps \[s\]; none where they vary.
    pub length: Option<f64>,
    /// The longest of those that vary \[s\]; chosen by the program where it is none.
    pub longest: Option<f64>,
    /// Error allowed in a step that varies.
    pub tolerance: f64,
    /// Spectral radius.
    pub rho: f64,
}

impl Steps {
    /// Whether they vary with their error.
    #[must_use]
    pub fn vary(&self) -> bool {
        self.method == Method::Alpha && self.length.is_none()
    }

    /// The keys in which they are set, with their values.
    pub(super) fn keys(&self) -> impl Iterator<Item = (String, String)> {
        let numbers = [
            (
                "solver.step_tolerance",
                self.vary().then_some(self.tolerance),
            ),
            ("solver.time_step_s", self.length),
            ("solver.longest_step_s", self.longest),
        ];
        let numbers = numbers.into_iter();
        numbers.filter_map(|(key, value)| Some((key.to_owned(), format!("{:?}", value?))))
    }
}
