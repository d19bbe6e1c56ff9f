//! The sea: spectra, irregular records made from them, waves at finite depth, and the response of a vessel.
//!
//! * [`Spectrum`]: JONSWAP and Pierson-Moskowitz, by significant height or by root mean square.
//! * [`synthesise`]: a spectrum into regular [`Component`]s, the same for the same seed.
//! * [`spread`]: the directions of short-crested waves.
//! * [`wave_number`]: dispersion at any depth.
//! * [`WaveField`]: velocity and acceleration of the water, with their gradients; [`Sea`]: several of them together.
//! * [`Rao`]: the response of a vessel to a regular wave in six degrees of freedom.
//! * [`Harmonics`]: a motion in space as a sum of harmonics, the form in which motions of ends are computed.
//!
//! Conventions: angular frequencies omega \[rad/s\]; a component is `a cos(omega t + phase)`, so a phase is a
//! lead; a wave that runs along the unit vector d is `a cos(omega t - k d.x + phase)` at the place x. A wave field is
//! long-crested; [`spread`] makes a short-crested sea of several.

mod component;
mod component_lanes;
mod component_sums;
mod decay;
mod dispersion;
mod harmonics;
mod kept_waves;
mod phasors;
mod rao;
mod sea_state;
mod spectrum;
mod spreading;
mod stretching;
mod synthesis;
mod waves;

pub use component::{Component, Moments};
pub use decay::DepthDecay;
pub use dispersion::wave_number;
pub use harmonics::{Harmonic, Harmonics};
pub use kept_waves::{KeptPlaces, KeptWaves, SeaClock, SeaReader};
pub use rao::{DEGREES, Rao, RaoError, RaoResponse};
pub use sea_state::Sea;
pub use spectrum::Spectrum;
pub use spreading::spread;
pub use stretching::Stretching;
pub use synthesis::synthesise;
pub use waves::{WaterMotion, WaveField, WaveLoading as WaveLoad, WaveSettings};
