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

/// Share of the surface's motion at a height, across (as `cosh`) and up (as `sinh`), with derivatives by z.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct DecayFactors {
    pub(super) across: f64,
    pub(super) up: f64,
    /// \[1/m\]
    pub(super) across_by_z: f64,
    /// \[1/m\]
    pub(super) up_by_z: f64,
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

    /// For a wave of number k \[1/m\] over this depth \[m\], at height z \[m\].
    #[inline]
    pub(super) fn share(&self, k: f64, depth: f64, z: f64) -> DecayFactors {
        match *self {
            Self::Airy => airy(k, depth, z),
            Self::AiryAbove(limit) => fade(airy(k, depth, z), limit, z),
            Self::Logarithmic(limit) => logarithmic(limit, z),
        }
    }
}

/// `cosh k(z+h) / sinh kh` and `sinh k(z+h) / sinh kh`, in exponentials that do not overflow.
#[inline]
fn airy(k: f64, depth: f64, z: f64) -> DecayFactors {
    let falling = (k * z).exp();
    let kh = k * depth;
    if kh > 20.0 {
        return DecayFactors {
            across: falling,
            up: falling,
            across_by_z: k * falling,
            up_by_z: k * falling,
        };
    }
    let back = (-k * z - 2.0 * kh).exp();
    let whole = 1.0 / -(-2.0 * kh).exp_m1();
    let (across, up) = ((falling + back) * whole, (falling - back) * whole);
    DecayFactors {
        across,
        up,
        across_by_z: k * up,
        up_by_z: k * across,
    }
}

/// The share times a cubic that rises from 0 to 1 over the last tenth above the limit.
fn fade(s: DecayFactors, limit: f64, z: f64) -> DecayFactors {
    let layer = FADE * limit;
    let x = (z + limit) / layer;
    if x >= 1.0 {
        return s;
    }
    if x <= 0.0 {
        return DecayFactors::default();
    }
    let (f, f_z) = (x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / layer);
    DecayFactors {
        across: s.across * f,
        up: s.up * f,
        across_by_z: s.across_by_z * f + s.across * f_z,
        up_by_z: s.up_by_z * f + s.up * f_z,
    }
}

fn logarithmic(limit: f64, z: f64) -> DecayFactors {
    let c = (std::f64::consts::E - 1.0) / limit;
    let (f, f_z) = if z >= 0.0 {
        (1.0, 0.0)
    } else if z <= -limit {
        (0.0, 0.0)
    } else {
        (1.0 - (c * -z).ln_1p(), c / (1.0 - c * z))
    };
    DecayFactors {
        across: f,
        up: f,
        across_by_z: f_z,
        up_by_z: f_z,
    }
}

#[cfg(test)]
mod tests {
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
                        law.share(k, depth, z - h),
                        law.share(k, depth, z),
                        law.share(k, depth, z + h),
                    );
                    let across = (high.across - low.across) / (2.0 * h);
                    let up = (high.up - low.up) / (2.0 * h);
                    assert!((across - at.across_by_z).abs() < 1e-8, "{law:?} {z}");
                    assert!((up - at.up_by_z).abs() < 1e-8, "{law:?} {z}");
                }
            }
            for z in [-50.0, -45.0, 0.0] {
                let (low, high) = (law.share(0.05, 300.0, z - 1e-9), law.share(0.05, 300.0, z));
                assert!((low.across - high.across).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn the_bed_lets_nothing_through_and_the_literal_law_ends_at_its_depth() {
        assert!(DepthDecay::Airy.share(0.1, 30.0, -30.0).up.abs() < 1e-16);
        let shallow = DepthDecay::Airy.share(0.1, 30.0, 0.0);
        assert!((shallow.up - 1.0).abs() < 1e-14);
        assert!((shallow.across - 1.0 / 3.0_f64.tanh()).abs() < 1e-14);
        assert!(
            DepthDecay::Logarithmic(200.0)
                .share(0.1, 1e3, -200.0)
                .across
                .abs()
                < 1e-15
        );
        let half = DepthDecay::Logarithmic(200.0)
            .share(0.1, 1e3, -100.0)
            .across;
        assert!((half - 0.379_885).abs() < 1e-6);
    }
}
