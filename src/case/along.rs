//! Quantities along the whole line, which published values, trends and the summary may name beside the
//! channels: they have no place in brackets, and their statistics go over arc length.

use super::Case;

/// A quantity that every node of the line has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
}

impl AlongLine {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Tension,
        Self::Height,
        Self::Curvature,
        Self::BendRadius,
        Self::Moment,
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
        }
    }

    /// Its unit as shown.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Tension => "N",
            Self::Height | Self::BendRadius => "m",
            Self::Curvature => "1/m",
            Self::Moment => "N m",
        }
    }

    /// True for what only a line with bending stiffness has.
    #[must_use]
    pub const fn of_bending(self) -> bool {
        matches!(self, Self::Curvature | Self::BendRadius | Self::Moment)
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
