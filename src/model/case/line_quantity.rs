//! Quantities along the whole line, which published values, trends and the summary may name beside the
//! channels: they have no place in brackets, and their statistics go over arc length.

use super::schema::words;

words! {
    /// A quantity along the whole line; its word stands in the place of a channel: `tension_n` in `tension_n.max`.
    #[derive(Hash)]
    pub enum LineQuantity {
        /// Tension \[N\].
        Tension = "tension_n",
        /// How far the tension swings over time: greatest less smallest \[N\].
        TensionSwing = "tension_swing_n",
        /// Height above still water \[m\].
        Height = "z_m",
        /// Height above the sea bed, normal to a plane, vertical over a grid \[m\].
        BedClearance = "bed_clearance_m",
        /// Curvature \[1/m\].
        Curvature = "curvature_per_m",
        /// Radius of the bend, 1 / curvature \[m\].
        BendRadius = "bend_radius_m",
        /// Bending moment \[N m\].
        Moment = "moment_nm",
        /// Mean of the past tension of ropes with dynamic stiffness, in percent of the breaking load.
        MeanLoad = "mean_load_percent",
        /// Stiffness EA by breaking load of such ropes \[-\].
        Stiffness = "stiffness_k",
        /// How far that stiffness swings over time: greatest less smallest \[-\].
        StiffnessSwing = "stiffness_swing_k",
        /// Root mean square displacement about the mean \[m\].
        RmsDisplacement = "rms_displacement_m",
        /// The same by the diameter of the line \[-\].
        RmsDiameters = "rms_displacement_d",
        /// Root mean square displacement along z alone by the diameter of the line \[-\].
        RmsVertical = "rms_vertical_d",
        /// The same in the plane of x and y.
        RmsHorizontal = "rms_horizontal_d",
        /// Share of the motion at the driving period that travels, 1 towards end A, -1 towards end B, 0 standing \[-\].
        Travelling = "travelling",
        /// Standing wave ratio of the motion at the driving period, 1 where all of it travels \[-\].
        StandingWaveRatio = "standing_wave_ratio",
        /// Local wavelength of the motion at the driving period \[m\].
        Wavelength = "wavelength_m",
        /// The same by WKB theory of the line at rest \[m\].
        WkbWavelength = "wkb_wavelength_m",
    }
}

words! {
    /// A term of the energy balance of a dynamic run.
    #[derive(Hash)]
    pub enum EnergyQuantity {
        /// Work of ends, waves, current and traveller \[J\].
        Supplied = "energy_in_j",
        /// Dissipated by drag, axial and mass damping, ropes and the bed \[J\].
        Dissipated = "energy_dissipated_j",
        /// Change of kinetic, potential and elastic energy \[J\].
        Stored = "energy_stored_j",
        /// What does not add up \[J\]: stored and dissipated less put in, and less the growth of the added mass.
        Drift = "energy_drift_j",
        /// The same in percent of all that passed through: work and dissipation without their signs, the greatest kinetic
        /// energy, and a millionth of the greatest energy.
        DriftShare = "energy_drift_percent",
    }
}

impl EnergyQuantity {
    /// Its unit as shown.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Supplied | Self::Dissipated | Self::Stored | Self::Drift => "J",
            Self::DriftShare => "%",
        }
    }

    /// The quantity of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.name() == name)
    }
}

/// The name of the time from which on the response of a run is steady, in the place of a channel.
pub const STEADY: &str = "response_steady_s";

impl LineQuantity {
    /// Its unit as shown.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Tension | Self::TensionSwing => "N",
            Self::Height
            | Self::BedClearance
            | Self::BendRadius
            | Self::RmsDisplacement
            | Self::Wavelength
            | Self::WkbWavelength => "m",
            Self::RmsDiameters
            | Self::RmsVertical
            | Self::RmsHorizontal
            | Self::Travelling
            | Self::StandingWaveRatio
            | Self::Stiffness
            | Self::StiffnessSwing => "-",
            Self::Curvature => "1/m",
            Self::Moment => "N m",
            Self::MeanLoad => "%",
        }
    }

    /// True for what only a line with bending stiffness has.
    #[must_use]
    pub const fn of_bending(self) -> bool {
        matches!(self, Self::Curvature | Self::BendRadius | Self::Moment)
    }

    /// True for what only ropes with dynamic stiffness have.
    #[must_use]
    pub const fn of_ropes(self) -> bool {
        matches!(
            self,
            Self::MeanLoad | Self::Stiffness | Self::StiffnessSwing
        )
    }

    /// The quantity of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|quantity| quantity.name() == name)
    }
}
