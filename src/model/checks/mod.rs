//! Checks of results against the limits of standards, as data: rules with their clauses, and how much of a limit a load uses.
//!
//! A check is a table [`CheckInputs`](crate::case::CheckInputs) of a case, a system or a [set of rules](crate::case::rule_sets); [`resolved`] puts
//! the rules of the sets in the place of their names. [`Utilisation`](utilisation::Utilisation) carries both errors of its load: the
//! numerical one and that of the sample. What runs say of a check is `study::seas`.

pub mod along;
pub mod resolved;
pub mod utilisation;
