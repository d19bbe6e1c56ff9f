//! Loads of the water on a floating body by the coefficients of a potential-flow code in the frequency domain.
//!
//! Files in the form of WAMIT are read by [`wamit`]: added mass and damping over frequency (`.1`), loads of the first order
//! (`.3`), mean drift (`.8`, `.9`, or the diagonal of `.12d`). In time the radiated waves are a memory of past velocities
//! ([`retardation`], Cummins 1962; Ogilvie 1964), the loads of the first order a sum of harmonics, and slow drift follows from the mean
//! drift by Newman's approximation ([`wave_loads`]).
//!
//! Coefficients are about the origin of the body, along its axes at the pose given, with time as `exp(i omega t)` and headings towards
//! which waves run, from the bow towards port.

mod coefficients;
pub mod responses;
pub mod retardation;
pub mod wamit;
pub mod wave_loads;

pub use coefficients::{DriftTable, ExcitationTable, RadiationTable};

use std::sync::Arc;

use crate::case::Diagnostic;
use crate::system::model::{BodyInputs, SystemFile};

/// The coefficients that a body names.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PotentialFlow {
    /// Added mass and damping.
    pub radiation: Option<Arc<RadiationTable>>,
    /// Loads of the first order.
    pub excitation: Option<Arc<ExcitationTable>>,
    /// Mean drift.
    pub drift: Option<Arc<DriftTable>>,
}

/// Water density \[kg/m³\], gravity \[m/s²\] and the length by which the numbers of a file are scaled \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Density \[kg/m³\].
    pub density: f64,
    /// Gravity \[m/s²\].
    pub gravity: f64,
    /// Length \[m\].
    pub length: f64,
}

impl PotentialFlow {
    /// What the files of a body say, which its system carries; nothing for a body without any.
    ///
    /// # Errors
    /// What is wrong with a file, with line and column.
    pub fn of_body(file: &SystemFile, body: &BodyInputs) -> Result<Option<Self>, Diagnostic> {
        let scales = Scales {
            density: file.environment.water_density_kg_per_m3,
            gravity: file.environment.gravity_m_per_s2,
            length: body.wamit_length_m,
        };
        let carried = |name: &Option<String>| {
            let name = name.as_ref()?;
            Some((&file.files.get(name)?.text, name.clone()))
        };
        let names = [
            &body.radiation_file,
            &body.excitation_file,
            &body.drift_file,
        ];
        let files = names.map(carried);
        if files.iter().all(Option::is_none) {
            return Ok(None);
        }
        let [radiation, excitation, drift] = files;
        let radiation = radiation
            .map(|(text, name)| text.parsed(scales, |text| wamit::radiation(text, &name, &scales)));
        let excitation = excitation.map(|(text, name)| {
            text.parsed(scales, |text| wamit::excitation(text, &name, &scales))
        });
        let drift = drift
            .map(|(text, name)| text.parsed(scales, |text| wamit::drift(text, &name, &scales)));
        Ok(Some(Self {
            radiation: radiation.transpose()?,
            excitation: excitation.transpose()?,
            drift: drift.transpose()?,
        }))
    }
}
