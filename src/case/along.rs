//! Quantities along the whole line, which published values, trends and the summary may name beside the
//! channels: they have no place in brackets, and their statistics go over arc length.

use super::Case;

/// A quantity that every node of the line has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AlongLine {
    /// Tension \[N\].
    Tension,
    /// Height above still water \[m\].
    Height,
    /// Curvature \[1/m\].
    Curvature,
    /// Radius of the bend, 1 / curvature \[m\].
    BendRadius,
    /// Bending moment \[N m\].
    Moment,
    /// Mean of the past tension of ropes with dynamic stiffness, in percent of the breaking load.
    MeanLoad,
    /// Stiffness EA by breaking load of such ropes \[-\].
    Stiffness,
    /// Root mean square displacement about the mean \[m\].
    RmsDisplacement,
    /// The same by the diameter of the line \[-\].
    RmsDiameters,
    /// Share of the motion at the driving period that travels, 1 towards end A, -1 towards end B, 0 standing \[-\].
    Travelling,
    /// Standing wave ratio of the motion at the driving period, 1 where all of it travels \[-\].
    StandingWaveRatio,
    /// Local wavelength of the motion at the driving period \[m\].
    Wavelength,
    /// The same by WKB theory of the line at rest \[m\].
    WkbWavelength,
}

/// The name under which a run tells from when on its response is steady, where a channel would stand.
pub const STEADY: &str = "response_steady_s";

impl AlongLine {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Tension,
        Self::Height,
        Self::Curvature,
        Self::BendRadius,
        Self::Moment,
        Self::MeanLoad,
        Self::Stiffness,
        Self::RmsDisplacement,
        Self::RmsDiameters,
        Self::Travelling,
        Self::StandingWaveRatio,
        Self::Wavelength,
        Self::WkbWavelength,
    ];

    /// Its name, where a channel would stand: `tension_n` in `tension_n.max`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tension => "tension_n",
            Self::Height => "z_m",
            Self::Curvature => "curvature_per_m",
            Self::BendRadius => "bend_radius_m",
            Self::Moment => "moment_nm",
            Self::MeanLoad => "mean_load_percent",
            Self::Stiffness => "stiffness_k",
            Self::RmsDisplacement => "rms_displacement_m",
            Self::RmsDiameters => "rms_displacement_d",
            Self::Travelling => "travelling",
            Self::StandingWaveRatio => "standing_wave_ratio",
            Self::Wavelength => "wavelength_m",
            Self::WkbWavelength => "wkb_wavelength_m",
        }
    }

    /// Its unit as shown.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Tension => "N",
            Self::Height
            | Self::BendRadius
            | Self::RmsDisplacement
            | Self::Wavelength
            | Self::WkbWavelength => "m",
            Self::RmsDiameters | Self::Travelling | Self::StandingWaveRatio => "-",
            Self::Curvature => "1/m",
            Self::Moment => "N m",
            Self::MeanLoad => "%",
            Self::Stiffness => "-",
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
        matches!(self, Self::MeanLoad | Self::Stiffness)
    }

    /// The quantity of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|quantity| quantity.name() == name)
    }
}

/// Whether any section of the case has a bending stiffness.
#[must_use]
pub fn bends(case: &Case) -> bool {
    case.line.iter().any(|section| {
        let material = case.materials.get(&section.material);
        material.is_some_and(|material| material.ei_n_m2 > 0.0)
    })
}
