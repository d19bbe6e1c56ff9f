//! Stretching: the kinematics of linear waves, defined up to z = 0, carried to the instantaneous surface.

/// How kinematics is carried up to the surface.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Stretching {
    /// The formula extrapolated to the surface; above it as at the surface. Overestimates the speed of short waves on
    /// long ones.
    None,
    /// Above still water as at still water.
    #[default]
    Vertical,
    /// Wheeler 1970: still water is moved to the surface, the bed stays, `z' = h (z + h)/(h + eta) - h`.
    Wheeler,
    /// Above still water along the straight line that touches the formula there.
    Linear,
}

/// The height at which the formula is read, and what the place of a node does to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StretchedHeight {
    /// Height at which the formula is read \[m\].
    pub(super) z: f64,
    /// Its change with the node's height \[-\].
    pub(super) by_z: f64,
    /// Its change with the height of the surface \[-\].
    pub(super) by_elevation: f64,
    /// Distance over which the formula goes on in a straight line \[m\].
    pub(super) beyond: f64,
}

impl StretchedHeight {
    fn plain(z: f64) -> Self {
        Self {
            z,
            by_z: 1.0,
            by_elevation: 0.0,
            beyond: 0.0,
        }
    }

    fn fixed(z: f64, by_elevation: f64) -> Self {
        Self {
            z,
            by_z: 0.0,
            by_elevation,
            beyond: 0.0,
        }
    }
}

impl Stretching {
    /// Whether the height of the surface matters.
    pub(super) fn needs_elevation(self) -> bool {
        matches!(self, Self::None | Self::Wheeler)
    }

    /// For a node at height z \[m\] where the surface is at `eta` over this depth \[m\].
    pub(super) fn read(self, z: f64, eta: f64, depth: f64) -> StretchedHeight {
        match self {
            Self::None if z > eta => StretchedHeight::fixed(eta, 1.0),
            Self::None => StretchedHeight::plain(z),
            Self::Vertical if z > 0.0 => StretchedHeight::fixed(0.0, 0.0),
            Self::Linear if z > 0.0 => StretchedHeight {
                beyond: z,
                ..StretchedHeight::fixed(0.0, 0.0)
            },
            Self::Vertical | Self::Linear => StretchedHeight::plain(z),
            Self::Wheeler => wheeler(z, eta, depth),
        }
    }
}

fn wheeler(z: f64, eta: f64, depth: f64) -> StretchedHeight {
    if z > eta {
        return StretchedHeight::fixed(0.0, 0.0);
    }
    // A trough that reaches the bed leaves no water to be stretched.
    if depth.is_infinite() || depth + eta <= 0.0 {
        return StretchedHeight {
            by_elevation: -1.0,
            ..StretchedHeight::plain(z - eta)
        };
    }
    let ratio = depth / (depth + eta);
    StretchedHeight {
        z: ratio * (z + depth) - depth,
        by_z: ratio,
        by_elevation: -ratio * (z + depth) / (depth + eta),
        beyond: 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wheeler_takes_the_surface_to_still_water_and_leaves_the_bed() {
        let read = |z: f64| Stretching::Wheeler.read(z, 3.0, 40.0);
        assert!(read(3.0).z.abs() < 1e-13);
        assert!((read(-40.0).z + 40.0).abs() < 1e-13);
        assert_eq!(Stretching::Wheeler.read(-5.0, 2.0, f64::INFINITY).z, -7.0);
    }

    #[test]
    fn without_a_law_the_water_ends_at_the_surface() {
        let read = |z: f64| Stretching::None.read(z, 2.0, 40.0);
        assert_eq!((read(-5.0).z, read(-5.0).by_z), (-5.0, 1.0));
        assert_eq!((read(1.5).z, read(1.5).by_z), (1.5, 1.0));
        assert_eq!((read(3.0).z, read(3.0).by_elevation), (2.0, 1.0));
    }

    #[test]
    fn slopes_are_derivatives_and_readings_are_continuous() {
        let laws = [
            Stretching::None,
            Stretching::Vertical,
            Stretching::Wheeler,
            Stretching::Linear,
        ];
        let h = 1e-6;
        for law in laws {
            for z in [-7.0, 1.0, 5.0] {
                let read = |z: f64, eta: f64| law.read(z, eta, 40.0).z;
                let at = law.read(z, 2.0, 40.0);
                let by_z = (read(z + h, 2.0) - read(z - h, 2.0)) / (2.0 * h);
                let by_eta = (read(z, 2.0 + h) - read(z, 2.0 - h)) / (2.0 * h);
                assert!((by_z - at.by_z).abs() < 1e-8, "{law:?} {z}");
                assert!((by_eta - at.by_elevation).abs() < 1e-8, "{law:?} {z}");
            }
            for edge in [0.0, 2.0] {
                let (low, high) = (
                    law.read(edge - 1e-12, 2.0, 40.0),
                    law.read(edge + 1e-12, 2.0, 40.0),
                );
                assert!(
                    (low.z + low.beyond - high.z - high.beyond).abs() < 1e-9,
                    "{law:?}"
                );
            }
        }
    }
}
