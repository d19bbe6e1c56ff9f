//! Extremes and fatigue of records and spectra; no cable.

use seacable_base::files;
use seacable_numerics as numerics;

pub mod extremes;
pub mod fatigue;
