//! Studies of cases, and runs compared.

pub mod comparison;
pub mod study;
