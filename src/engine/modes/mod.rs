//! Natural frequencies and mode shapes of a line about its static shape.
//!
//! Small motions u about rest obey `M u'' + K u = 0` with K the exact tangent of the line's forces at rest and M its mass
//! with added mass; `u = x cos(omega t)` gives the eigenproblem `K x = omega² M x` (Irvine 1981, ch. 3, for cables by
//! hand). Drag is left out, of which the damping that goes with the speed squared has no linear part in still water
//! anyway; in a current, what drag changes with the line's direction and speed is left out too, while the shape
//! about which the line moves is the one in that current. What is left is symmetric: all modes are real.
//!
//! * [`ModePencil`]: K and M of a scene at rest.
//! * [`lowest`]: their lowest eigenpairs, by a shift-invert block Lanczos method with a count that none is missing.
//! * [`Mode`]: an eigenpair with its kind: share of motion out of the plane of the line and along the line, half waves.
//! * [`WkbMedium`]: local wave numbers, amplitudes and frequencies by WKB theory.
//! * [`ModeFrame`], [`Inertia`]: by what modes of several lines with what they hang on are described alike.
//! * [`of_case`]: all of it for a case, errors estimated from half the mesh.

mod lanczos;
mod line_modes;
mod mode_shape;
mod pencil;
mod wkb;

pub use lanczos::{EigenError, Eigenpair, lowest};
pub use line_modes::{LineModes, ModeLine, ModesError, NamedMode, of_case, of_scene_at_rest};
pub use line_modes::{MORE, named, touchdown_share};
pub use mode_shape::{Inertia, LinePlane, Mode, ModeFrame, ModeKind, modes_of};
pub use pencil::ModePencil;
pub use wkb::{WkbMedium, WkbWave, wave_number};
