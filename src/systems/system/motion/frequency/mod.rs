//! A quick look in the frequency domain: the equations of motion of a system, linear about its mean position, component by component of
//! its waves.
//!
//! With X the complex amplitudes of all displacements, `x = x0 + Re X exp(i omega t)`,
//!
//! ```text
//! (-omega² M + i omega C + K) X = F(omega)
//! ```
//!
//! M, C and K are the exact tangents that the steps in time use, read at the mean position; F are the loads of a wave of that frequency,
//! by differences of the same residual. So every force of the model takes part without a second description of it.
//!
//! * The mean position is that at rest under current, wind and the mean drift of the waves (`mean.rs`).
//! * Drag is linear by statistics: C has the mean of its tangent over the normally distributed velocities of the water past each place,
//!   which the solution gives, so that both are found in turns (`drag.rs`; Borgman 1969, doi 10.1061/TACEAT.0008647 is the one-dimensional
//!   case, `sqrt(8/pi) sigma`). Of quadratic damping of bodies the same.
//! * Radiation is that of the retardation functions at each frequency; slow drift is Newman's, in bands of the difference of frequencies
//!   (`excitation.rs`).
//! * Results are moments of spectra, and extremes of normal processes (`channel.rs`).
//!
//! What it cannot have: slack lines and snaps, lines that lift off the bed and lie down on it, tensions that grow faster than the offset,
//! the mean load of drag in waves, extremes of slow drift beyond those of a normal process. How far that matters is measured beside runs in time.

mod channel;
mod drag;
mod excitation;
mod linear_system;
mod look;
mod mean;
mod perturbed;
mod prescribed;
mod single_line;
mod spread;

pub use channel::QuickChannel;
pub use look::{QuickLook, quick_look, quick_look_at_line};

/// A complex number.
type Complex = nalgebra::Complex<f64>;
/// Complex amplitudes along x, y, z.
type Amplitude = nalgebra::Vector3<Complex>;
