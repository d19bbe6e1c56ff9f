//! Fatigue of chains, wire ropes and fibre ropes from tension histories.
//!
//! ```text
//! tensions ──▶ turning points ──▶ cycles ──▶ damage by a T-N or S-N curve ──▶ rate, life
//!              reversals          rainflow   Miner's sum
//! ```
//!
//! * [`turning_points`]: reversals of a series, value by value or of a slice.
//! * [`rainflow`]: three-point counting (ASTM E1049-85, 5.4.4), which tests hold against four-point counting (ISO 12110-2).
//! * [`histogram`]: cycles by range and mean in fixed memory.
//! * [`curve`]: T-N and S-N curves; [`component`]: a curve with strength or area; [`curve_library`]: those of API RP 2SK and DNV-OS-E301; [`curve_file`]: a user's own.
//! * [`mean_stress`]: ranges corrected to zero mean.
//! * [`damage`]: Miner's sum, its slope to the tension; [`scatter`]: sea states by their share, life.
//! * [`closed_form`]: narrow-band damage; [`spectral`]: Dirlik's and Tovo-Benasciutti's method.
//! * [`study`]: rainflow damage of random records against the closed form.
//!
//! Ranges are double amplitudes, from trough to crest. Tensions are in N, stresses in MPa, times in s.

pub mod closed_form;
pub mod component;
pub mod curve;
pub mod curve_file;
pub mod curve_library;
pub mod damage;
pub mod histogram;
pub mod mean_stress;
pub mod rainflow;
pub mod scatter;
pub mod spectral;
pub mod spot;
pub mod study;
pub mod turning_points;

#[cfg(test)]
mod classes;
#[cfg(test)]
mod fixtures;
#[cfg(test)]
mod four_point;
