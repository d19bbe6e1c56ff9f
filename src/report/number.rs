//! One wording for numbers: digits that the error estimate supports, and the unit.
