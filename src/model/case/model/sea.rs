//! Waves, and the surface of the water.

use crate::case::fields::ValueType::Name;
use crate::case::fields::{of, positive};
use crate::case::schema::{table, words};

table! {
    /// Waves by Airy's linear theory: regular, irregular, or of given components.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Waves => WavesKeys {
        /// Regular waves, irregular ones from a spectrum, or the sum of given regular ones.
        kind: WaveKind, "waves";
        /// Height of regular waves from trough to crest.
        height_m: Option<f64>, "wave height", range of(0.0, 100.0), only kind "regular";
        /// Period of regular waves.
        period_s: Option<f64>, "wave period", range of(0.1, 1e3), only kind "regular";
        /// Lead of the crest over x = y = 0 at time zero.
        phase_deg: f64 = 0.0, "wave phase", range of(-360.0, 360.0), only kind "regular";
        /// Periods of the components, of a record of waves for example.
        periods_s: Option<Vec<f64>>, "periods", range positive(1e6), only kind "components";
        /// Heights of the components from trough to crest, as many.
        heights_m: Option<Vec<f64>>, "heights", range of(0.0, 100.0), only kind "components";
        /// Leads of the components' crests over x = y = 0 at time zero, as many.
        phases_deg: Option<Vec<f64>>, "phases", range of(-360.0, 360.0), absent "0 each", only kind "components";
        /// Four times the root mean square elevation.
        significant_height_m: Option<f64>, "significant height", range of(0.0, 50.0), only kind "irregular";
        /// Period of the spectrum's peak.
        peak_period_s: Option<f64>, "peak period", range of(0.1, 1e3), only kind "irregular";
        /// How the energy of irregular waves is spread over frequency.
        spectrum: SpectrumName = SpectrumName::Jonswap, "spectrum", only kind "irregular";
        /// Gamma of a JONSWAP spectrum; 1 is Pierson-Moskowitz.
        gamma: f64 = 3.3, "peak enhancement", range of(1.0, 20.0), only kind "irregular";
        /// Regular components that irregular waves are made of, of equal energy.
        components: usize = 100, "components", range of(1.0, 1e4), only kind "irregular";
        /// Of the random frequencies and phases: the same seed, the same waves.
        seed: u64 = 1, "seed", range of(0.0, 9e15), only kind "irregular";
        /// Where the waves run to, from +x towards +y.
        direction_deg: f64 = 0.0, "wave direction", range of(-360.0, 360.0);
        /// Exponent n of a spread in direction by cos^n about it.
        spreading_exponent: Option<f64>, "spreading", range of(1.0, 1e3), absent "long-crested", only kind "irregular";
        /// Depth that the waves feel, where there is no `[seabed]`.
        depth_m: Option<f64>, "sea depth", range positive(2e4), absent "that of the sea bed, or deep water";
        /// The waves grow smoothly from nothing over this time.
        ramp_s: f64 = 0.0, "wave ramp", range of(0.0, 1e6);
        /// Above still water: the formula as it stands, as at still water, still water moved to the surface (Wheeler), or a straight line.
        stretching: StretchingName = StretchingName::Vertical, "stretching";
        /// Airy's theory, the same ending at decay_depth_m, or 1 - ln(1 + (e - 1) d / decay_depth_m).
        decay: DecayName = DecayName::Airy, "decay with depth";
        /// Depth below which nothing moves, where the decay is not airy.
        decay_depth_m: f64 = 200.0, "decay depth", range positive(2e4);
        /// Where the height of the waves is recorded, x and y.
        gauge_m: Option<[f64; 2]>, "gauge", range of(-1e6, 1e6), absent "over end B where it has a position, else over end A; of a system over x = y = 0";
        /// The end of the line, or the fixed or moved point of the system, over which it is recorded, in the place of gauge_m.
        gauge_over: Option<String>, "gauge over", kind Name, absent "by gauge_m";
        /// Of the water's motion: velocity and acceleration, or the acceleration alone, with drag as in water that the waves leave still.
        load: WaveLoadName = WaveLoadName::Morison, "load";
    }
}

words! {
    /// Length of a taut line that drag acts on.
    #[derive(Default)]
    pub enum DragLength {
        /// As it is stretched.
        #[default]
        Stretched = "stretched",
        /// As it would be without tension.
        Unstretched = "unstretched",
    }
}

words! {
    /// The kinds of waves.
    pub enum WaveKind {
        /// One component.
        Regular = "regular",
        /// Many, from a spectrum.
        Irregular = "irregular",
        /// Many, each given.
        Components = "components",
    }
}

words! {
    /// The spectra known by name.
    #[derive(Default)]
    pub enum SpectrumName {
        /// JONSWAP (Hasselmann et al. 1973).
        #[default]
        Jonswap = "jonswap",
        /// Pierson and Moskowitz 1964.
        PiersonMoskowitz = "pierson-moskowitz",
    }
}

words! {
    /// How kinematics is carried up to the surface.
    #[derive(Default)]
    pub enum StretchingName {
        /// The formula as it stands.
        None = "none",
        /// Above still water as at it.
        #[default]
        Vertical = "vertical",
        /// Still water moved to the surface (Wheeler 1970).
        Wheeler = "wheeler",
        /// Above still water in a straight line.
        Linear = "linear",
    }
}

words! {
    /// How the motion of the water falls with depth.
    #[derive(Default)]
    pub enum DecayName {
        /// Airy's theory.
        #[default]
        Airy = "airy",
        /// The same down to a depth, nothing below.
        AiryCut = "airy-cut",
        /// The logarithm that ends at a depth.
        Logarithmic = "logarithmic",
    }
}

words! {
    /// What of the water's motion reaches the line.
    #[derive(Default)]
    pub enum WaveLoadName {
        /// Velocity and acceleration.
        #[default]
        Morison = "morison",
        /// The acceleration alone.
        Inertia = "inertia",
    }
}

words! {
    /// Whether the line leaves the water.
    #[derive(Default)]
    pub enum WaterSurface {
        /// All of the line counts as under water, at any height.
        #[default]
        Ignored = "ignored",
        /// Above the surface the line has its weight in air, and no drag nor added mass.
        Crossed = "crossed",
    }
}
