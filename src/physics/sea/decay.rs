//! Decay of the water's motion with depth.

/// The law of decay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DepthDecay {
    /// Airy's linear theory at the depth of the sea.
    Airy,
    /// The same, and nothing below this depth \[m\]. Over the last tenth above it the motion fades, so that no
    /// force jumps.
    AiryAbove(f64),
    /// `1 - ln(1 + (e - 1) d / D)` at the depth d, nothing below D \[m\], and the same as at the surface above it: a
    /// literal reading of "decays logarithmically with depth, down to 200 m" (double-stepped cable, see the cases).
    /// Both components alike; this is no flow that keeps its volume.
    Logarithmic(f64),
}

/// What a law makes of a motion at a height, alike for all components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fading {
    /// Whether components decay as in Airy's theory, times this; otherwise this is all.
    pub(super) decays: bool,
    /// The factor.
    pub(super) share: f64,
    /// Its derivative by z \[1/m\].
    pub(super) by_z: f64,
}

/// Part of the depth over which a cut-off motion fades.
const FADE: f64 = 0.1;

impl DepthDecay {
    /// The height \[m\] below which nothing moves.
    pub(super) fn reach(&self) -> f64 {
        match *self {
            Self::Airy => f64::NEG_INFINITY,
            Self::AiryAbove(depth) | Self::Logarithmic(depth) => -depth,
        }
    }

    /// What it makes of a motion at height z \[m\].
    pub(super) fn fading(&self, z: f64) -> Fading {
        let (decays, (share, by_z)) = match *self {
            Self::Airy => (true, (1.0, 0.0)),
            Self::AiryAbove(limit) => (true, faded(limit, z)),
            Self::Logarithmic(limit) => (false, logarithmic(limit, z)),
        };
        Fading {
            decays,
            share,
            by_z,
        }
    }
}

/// A cubic that rises from 0 to 1 over the last tenth above the limit, and its derivative.
fn faded(limit: f64, z: f64) -> (f64, f64) {
    let layer = FADE * limit;
    let x = ((z + limit) / layer).clamp(0.0, 1.0);
    (x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / layer)
}

/// The literal law, and its derivative.
fn logarithmic(limit: f64, z: f64) -> (f64, f64) {
    let c = (std::f64::consts::E - 1.0) / limit;
    if z >= 0.0 {
        (1.0, 0.0)
    } else if z <= -limit {
        (0.0, 0.0)
    } else {
        (1.0 - (c * -z).ln_1p(), c / (1.0 - c * z))
    }
}

/// The shares of one component in plain formulas, which the lanes are held against.
#[cfg(test)]
pub(super) mod plain {
    use super::DepthDecay;

    /// Share of the surface's motion at a height, across (as `cosh`) and up (as `sinh`), with derivatives by z.
    #[derive(Debug, Clone, Copy)]
    pub(in super::super) struct DecayFactors {
        pub(in super::super) across: f64,
        pub(in super::super) up: f64,
        /// \[1/m\]
        pub(in super::super) across_by_z: f64,
        /// \[1/m\]
        pub(in super::super) up_by_z: f64,
    }

    /// For a wave of number k \[1/m\] over this depth \[m\], at height z \[m\].
    pub(in super::super) fn share(law: DepthDecay, k: f64, depth: f64, z: f64) -> DecayFactors {
        let fading = law.fading(z);
        let (f, f_z) = (fading.share, fading.by_z);
        let (across, up, k) = match fading.decays {
            true if k * depth > 300.0 => ((k * z).exp(), (k * z).exp(), k),
            true => {
                let whole = (k * depth).sinh();
                let height = k * (z + depth);
                (height.cosh() / whole, height.sinh() / whole, k)
            }
            false => (1.0, 1.0, 0.0),
        };
        DecayFactors {
            across: across * f,
            up: up * f,
            across_by_z: k * up * f + across * f_z,
            up_by_z: k * across * f + up * f_z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::plain::share;
    use super::*;

    #[test]
    fn slopes_are_derivatives_and_nothing_jumps() {
        let laws = [
            DepthDecay::Airy,
            DepthDecay::AiryAbove(50.0),
            DepthDecay::Logarithmic(50.0),
        ];
        for law in laws {
            for (k, depth) in [(0.05, 30.0), (0.05, 100.0), (0.3, 500.0)] {
                for z in [-0.5, -10.3, -29.0, -46.2, -48.9] {
                    let h = 1e-5;
                    let (low, at, high) = (
                        share(law, k, depth, z - h),
                        share(law, k, depth, z),
                        share(law, k, depth, z + h),
                    );
                    let across = (high.across - low.across) / (2.0 * h);
                    let up = (high.up - low.up) / (2.0 * h);
                    assert!((across - at.across_by_z).abs() < 1e-8, "{law:?} {z}");
                    assert!((up - at.up_by_z).abs() < 1e-8, "{law:?} {z}");
                }
            }
            for z in [-50.0, -45.0, 0.0] {
                let (low, high) = (
                    share(law, 0.05, 300.0, z - 1e-9),
                    share(law, 0.05, 300.0, z),
                );
                assert!((low.across - high.across).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn the_bed_lets_nothing_through_and_the_literal_law_ends_at_its_depth() {
        assert!(share(DepthDecay::Airy, 0.1, 30.0, -30.0).up.abs() < 1e-16);
        let shallow = share(DepthDecay::Airy, 0.1, 30.0, 0.0);
        assert!((shallow.up - 1.0).abs() < 1e-14);
        assert!((shallow.across - 1.0 / 3.0_f64.tanh()).abs() < 1e-14);
        assert!(
            share(DepthDecay::Logarithmic(200.0), 0.1, 1e3, -200.0)
                .across
                .abs()
                < 1e-15
        );
        let half = share(DepthDecay::Logarithmic(200.0), 0.1, 1e3, -100.0).across;
        assert!((half - 0.379_885).abs() < 1e-6);
    }
}
