//! Settings of a ship's motion.

use crate::case::fields::{of, positive};
use crate::case::schema::{table, words};
use crate::ship::motion::spectral_band::MotionRms;

table! {
    /// The ship's motion in waves: by published statistics, or by its RAOs.
    #[derive(Debug, Clone, PartialEq)]
    pub struct MotionSettings => MotionKeys {
        /// Whether the motion has published statistics, or is the ship's response to a sea by its RAOs.
        by: MotionSource = MotionSource::Statistics, "made from";
        /// Seed of the records: the same seed gives the same record.
        seed: u32 = 1, "seed", range of(0.0, 4_294_967_295.0);
        /// Length of a record.
        duration_s: f64 = 10800.0, "duration", range positive(1e5);
        /// Time step of a record.
        step_s: f64 = 0.25, "step", range of(0.01, 100.0);
        /// Regular components: of each band of frequencies, or of the sea.
        components: usize = 100, "components", range of(10.0, 2000.0);
        /// Hang-off point of the rope from the ship's reference point: forward, to port, up.
        hang_point_m: [f64; 3] = [0.0, 0.0, 0.0], "hang-off point", range of(-1000.0, 1000.0);
        /// Period of the slow-drift motion at the mooring, where the statistics need one.
        slow_period_s: f64 = 100.0, "slow period", range positive(1e4), only by "statistics";
        /// Mean of surge, sway, heave.
        translation_mean_m: [f64; 3] = [0.0, 0.0, 0.0], "mean translation", range of(-1000.0, 1000.0), only by "statistics";
        /// Mean of roll, pitch, yaw.
        rotation_mean_deg: [f64; 3] = [0.0, 0.0, 0.0], "mean rotation", range of(-90.0, 90.0), only by "statistics";
        /// Root mean square of surge, sway, heave about zero, the mean included.
        translation_rms_m: Option<[f64; 3]>, "translation, rms", range of(0.0, 1000.0), only by "statistics";
        /// Root mean square of roll, pitch, yaw about zero, the mean included.
        rotation_rms_deg: Option<[f64; 3]>, "rotation, rms", range of(0.0, 1000.0), only by "statistics";
        /// Root mean square velocity of surge, sway, heave.
        translation_velocity_rms_m_per_s: Option<[f64; 3]>, "velocity, rms", range of(0.0, 1000.0), only by "statistics";
        /// Root mean square velocity of roll, pitch, yaw.
        rotation_velocity_rms_deg_per_s: Option<[f64; 3]>, "angular velocity, rms", range of(0.0, 1000.0), only by "statistics";
        /// Root mean square acceleration of surge, sway, heave.
        translation_acceleration_rms_m_per_s2: Option<[f64; 3]>, "acceleration, rms", range of(0.0, 1000.0), only by "statistics";
        /// Root mean square acceleration of roll, pitch, yaw.
        rotation_acceleration_rms_deg_per_s2: Option<[f64; 3]>, "angular acceleration, rms", range of(0.0, 1000.0), only by "statistics";
        /// CSV file of RAOs, relative to the folder of this one: heading_deg (optional), period_s, surge_m_per_m, surge_phase_deg and so on.
        responses: Option<String>, "RAOs", only by "responses";
        /// Spectrum of the waves.
        spectrum: SpectrumKind = SpectrumKind::Jonswap, "spectrum", only by "responses";
        /// Significant wave height.
        significant_height_m: Option<f64>, "significant height", range of(0.0, 30.0), only by "responses";
        /// Peak period of the waves.
        peak_period_s: Option<f64>, "peak period", range of(0.5, 60.0), only by "responses";
        /// Peak enhancement of a JONSWAP spectrum; a Pierson-Moskowitz spectrum has 1.
        gamma: f64 = 3.3, "peak enhancement", range of(1.0, 20.0), only by "responses";
        /// Direction that the waves run to, from +x towards +y.
        waves_towards_deg: Option<f64>, "waves towards", range of(-360.0, 360.0), only by "responses";
        /// Heading of the bow, from +x towards +y.
        heading_deg: Option<f64>, "heading", range of(-360.0, 360.0), absent "the governing equilibrium heading", only by "responses";
    }
}

words! {
    /// What the motion is made from.
    #[derive(Default)]
    pub enum MotionSource {
        /// Root mean squares of each degree of freedom.
        #[default]
        Statistics = "statistics",
        /// RAOs and a sea.
        Responses = "responses",
    }
}

words! {
    /// Wave spectra.
    #[derive(Default)]
    pub enum SpectrumKind {
        /// JONSWAP.
        #[default]
        Jonswap = "jonswap",
        /// Pierson-Moskowitz.
        PiersonMoskowitz = "pierson-moskowitz",
    }
}

impl MotionSettings {
    /// The seed as the generator takes it.
    #[must_use]
    pub fn seed(&self) -> u64 {
        u64::from(self.seed)
    }

    /// Instants of a record, one a step; the next is the first again.
    #[must_use]
    pub fn instants(&self) -> usize {
        (self.duration_s / self.step_s).round().max(1.0) as usize
    }

    /// Target mean and root mean squares of a degree of freedom, 0 to 5 \[m or rad\].
    #[must_use]
    pub fn target(&self, degree: usize) -> (f64, MotionRms) {
        let i = degree % 3;
        let of = |values: Option<[f64; 3]>| values.unwrap_or_default()[i];
        let translation = MotionRms {
            displacement: of(self.translation_rms_m),
            velocity: of(self.translation_velocity_rms_m_per_s),
            acceleration: of(self.translation_acceleration_rms_m_per_s2),
        };
        let rotation = MotionRms {
            displacement: of(self.rotation_rms_deg).to_radians(),
            velocity: of(self.rotation_velocity_rms_deg_per_s).to_radians(),
            acceleration: of(self.rotation_acceleration_rms_deg_per_s2).to_radians(),
        };
        if degree < 3 {
            (self.translation_mean_m[i], translation)
        } else {
            (self.rotation_mean_deg[i].to_radians(), rotation)
        }
    }
}
