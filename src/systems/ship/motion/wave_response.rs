//! First-order response of a ship to irregular waves by its response amplitude operators (RAOs).

use crate::visible;
use std::f64::consts::TAU;
use std::path::Path;

use super::DegreeOfFreedom;
use crate::case::Diagnostic;
use crate::files::root;
use crate::physics::sea::{Component, Rao, RaoResponse, Spectrum, synthesise};
use crate::scene::rao_file;
use crate::ship::model::{MotionSettings, SpectrumKind};
use crate::ship::motion::spectral_band::MotionRms;

/// Response of a ship to a sea state at one relative wave direction.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveResponse {
    /// RAO at this direction.
    pub rao: Rao,
    /// The file of RAOs.
    pub table: String,
    /// Wave spectrum.
    pub spectrum: Spectrum,
    /// Direction that the waves go to, from the bow \[rad\].
    pub relative_direction: f64,
    /// Heading of the bow, from +x towards +y \[rad\].
    pub heading: f64,
    /// Fraction of the wave energy at periods outside the RAO.
    pub energy_outside: f64,
}

impl WaveResponse {
    /// Reads the RAO file of the settings, from `folder`, for a ship at a heading \[rad\].
    ///
    /// # Errors
    /// What is wrong with the file, with line and column.
    pub fn read(
        settings: &MotionSettings,
        heading: f64,
        folder: &Path,
    ) -> Result<Self, Diagnostic> {
        let name = settings.responses.as_deref().unwrap_or_default();
        let file = visible::path(&folder.join(name));
        let place = root::place(folder, name);
        let is_outside = place.as_ref().is_ok_and(|place| place.is_outside);
        let text = place.and_then(|place| place.text()).map_err(|error| {
            Diagnostic::whole_file(
                &file,
                format!("the RAOs cannot be read: {error}"),
                "name a CSV file in motion.responses, relative to the folder of the ship's file",
            )
        })?;
        let raos = rao_file::read(&text, &file).map_err(|found| match is_outside {
            true => found.without_contents(),
            false => found,
        })?;
        let direction = settings.waves_towards_deg.unwrap_or_default();
        let relative_direction = (direction.to_radians() - heading).rem_euclid(TAU);
        let rao = rao_file::at_angle(&raos, relative_direction, &file)?;
        let spectrum = spectrum(settings);
        let (low, high) = rao.span();
        let outside = |omega: f64| f64::from(u8::from(omega < low || omega > high));
        let [energy_outside] = spectrum.integrals(|omega| [outside(omega)]);
        Ok(Self {
            rao,
            table: text,
            spectrum,
            relative_direction,
            heading,
            energy_outside: energy_outside / spectrum.variance.max(f64::MIN_POSITIVE),
        })
    }

    /// The waves of a seed at the ship's reference point.
    #[must_use]
    pub fn waves(&self, count: usize, seed: u64) -> Vec<Component> {
        synthesise(&self.spectrum, count, seed, 0)
    }

    /// The six motions in these waves.
    #[must_use]
    pub fn degrees(&self, waves: &[Component]) -> Vec<DegreeOfFreedom> {
        let each: Vec<RaoResponse> = waves.iter().map(|c| self.rao.response(c.omega)).collect();
        let degree = |i: usize| {
            let component = |(wave, response): (&Component, &RaoResponse)| Component {
                omega: wave.omega,
                amplitude: wave.amplitude * response[i].norm(),
                phase: wave.phase + response[i].arg(),
            };
            DegreeOfFreedom {
                mean: 0.0,
                target: self.rms(i),
                bands: Vec::new(),
                components: waves.iter().zip(&each).map(component).collect(),
            }
        };
        (0..6).map(degree).collect()
    }

    /// Root mean squares of a motion: moments of the wave spectrum times the squared RAO.
    fn rms(&self, degree: usize) -> MotionRms {
        let [m0, m2, m4] = self.spectrum.integrals(|omega| {
            let square = self.rao.response(omega)[degree].norm_sqr();
            let w2 = omega * omega;
            [square, square * w2, square * w2 * w2]
        });
        MotionRms {
            displacement: m0.sqrt(),
            velocity: m2.sqrt(),
            acceleration: m4.sqrt(),
        }
    }
}

fn spectrum(settings: &MotionSettings) -> Spectrum {
    let gamma = match settings.spectrum {
        SpectrumKind::Jonswap => settings.gamma,
        SpectrumKind::PiersonMoskowitz => 1.0,
    };
    let height = settings.significant_height_m.unwrap_or_default();
    Spectrum::jonswap(height, settings.peak_period_s.unwrap_or_default(), gamma)
}
