//! Published curves of mooring components.
//!
//! The numbers are those that public sources repeat from the standards; `confirmed` says which. Standards change: check a
//! curve against your edition before it decides anything.

use super::component::{FatigueComponent, Measure, chain_area, rope_area};
use super::curve::{CurveError, Law};

/// What the range of a published curve is related to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveKind {
    /// Range of tension over the reference strength (T-N).
    Tension,
    /// Range of nominal stress in MPa (S-N), over the area of both bars of a link.
    ChainStress,
    /// Range of nominal stress in MPa (S-N), over the area of the circle about a rope or of a bar.
    RopeStress,
}

/// A published curve. All are for double amplitudes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedCurve {
    /// Name in files.
    pub id: &'static str,
    /// Name on the screen.
    pub title: &'static str,
    /// What its range is related to.
    pub kind: CurveKind,
    /// Exponent and constant.
    pub law: Law,
    /// What the reference strength is.
    pub strength: &'static str,
    /// Standard and clause.
    pub source: &'static str,
    /// Where its numbers were compared, or that they were not; always to be checked against your edition.
    pub confirmed: &'static str,
}

const API: &str = "API RP 2SK, 3rd edition (2005), table 3; check against your edition";
const DNV: &str = "DNV-OS-E301, Ch.2 Sec.2, fatigue limit state, S-N curve parameters; check against your edition";
const C203: &str = "DNV-RP-C203, S-N curves in seawater with cathodic protection, curve B1; check against your edition";
const ORQ: &str =
    "breaking strength of ORQ common chain of the same diameter, for grade R3 and higher too";
const ROPE: &str = "breaking strength of the rope";
const NO_STRENGTH: &str = "none: the range is a stress";
const TWO: &str = "two independent public repetitions agree";
const ONE: &str = "one public repetition agrees";
const NONE: &str = "no public repetition was found; take it from the standard";

/// Log10 of 316, 1000 and 178, and of the constants in MPa.
const LOG_316: f64 = 2.499_687_082_618_404;
const LOG_178: f64 = 2.250_420_002_308_894;
const LOG_6E10: f64 = 10.778_151_250_383_644;
const LOG_1_2E11: f64 = 11.079_181_246_047_625;
const LOG_3_4E14: f64 = 14.531_478_917_042_255;
const LOG_1_7E17: f64 = 17.230_448_921_378_272;
const LOG_0_259: f64 = -0.586_700_235_918_748_2;

/// The published curves.
pub const PUBLISHED: [PublishedCurve; 11] = [
    PublishedCurve {
        id: "api-studlink-chain",
        title: "Common studlink chain, API RP 2SK",
        kind: CurveKind::Tension,
        law: Law::new(3.0, 3.0),
        strength: ORQ,
        source: API,
        confirmed: ONE,
    },
    PublishedCurve {
        id: "api-studless-chain",
        title: "Common studless chain, API RP 2SK",
        kind: CurveKind::Tension,
        law: Law::new(3.0, LOG_316),
        strength: ORQ,
        source: API,
        confirmed: ONE,
    },
    PublishedCurve {
        id: "api-connecting-link",
        title: "Baldt and Kenter connecting links, API RP 2SK",
        kind: CurveKind::Tension,
        law: Law::new(3.0, LOG_178),
        strength: ORQ,
        source: API,
        confirmed: NONE,
    },
    PublishedCurve {
        id: "api-six-strand-rope",
        title: "Six- and multi-strand wire rope, corrosion-protected, API RP 2SK",
        kind: CurveKind::Tension,
        law: Law::new(4.09, 3.20).falling_with_mean(2.79),
        strength: ROPE,
        source: API,
        confirmed: ONE,
    },
    PublishedCurve {
        id: "api-spiral-strand-rope",
        title: "Spiral strand wire rope, corrosion-protected, API RP 2SK",
        kind: CurveKind::Tension,
        law: Law::new(5.05, 3.25).falling_with_mean(3.43),
        strength: ROPE,
        source: API,
        confirmed: ONE,
    },
    PublishedCurve {
        id: "dnv-stud-chain",
        title: "Stud chain, DNV-OS-E301",
        kind: CurveKind::ChainStress,
        law: Law::new(3.0, LOG_1_2E11),
        strength: NO_STRENGTH,
        source: DNV,
        confirmed: ONE,
    },
    PublishedCurve {
        id: "dnv-studless-chain",
        title: "Studless chain (open link), DNV-OS-E301",
        kind: CurveKind::ChainStress,
        law: Law::new(3.0, LOG_6E10),
        strength: NO_STRENGTH,
        source: DNV,
        confirmed: TWO,
    },
    PublishedCurve {
        id: "dnv-six-strand-rope",
        title: "Six-strand wire rope, DNV-OS-E301",
        kind: CurveKind::RopeStress,
        law: Law::new(4.0, LOG_3_4E14),
        strength: NO_STRENGTH,
        source: DNV,
        confirmed: NONE,
    },
    PublishedCurve {
        id: "dnv-spiral-strand-rope",
        title: "Spiral strand wire rope, DNV-OS-E301",
        kind: CurveKind::RopeStress,
        law: Law::new(4.8, LOG_1_7E17),
        strength: NO_STRENGTH,
        source: DNV,
        confirmed: NONE,
    },
    PublishedCurve {
        id: "dnv-b1-seawater-cp",
        title: "Base material without welds (class B1) in seawater, cathodic protection, DNV-RP-C203",
        kind: CurveKind::RopeStress,
        law: Law::new(4.0, 14.917).with_knee(1e6, 5.0),
        strength: NO_STRENGTH,
        source: C203,
        confirmed: NONE,
    },
    PublishedCurve {
        id: "dnv-polyester-rope",
        title: "Polyester rope, DNV-OS-E301",
        kind: CurveKind::Tension,
        law: Law::new(13.46, LOG_0_259),
        strength: "characteristic strength of the rope",
        source: DNV,
        confirmed: NONE,
    },
];

/// The published curve of a name.
#[must_use]
pub fn published(id: &str) -> Option<&'static PublishedCurve> {
    PUBLISHED.iter().find(|curve| curve.id == id)
}

impl PublishedCurve {
    /// For a component of a nominal diameter in m and a reference strength in N; each is needed only where
    /// [`kind`](Self::kind) relates the range to it.
    ///
    /// # Errors
    /// A strength or diameter that is needed and missing or out of bounds.
    pub fn component(
        &self,
        diameter: Option<f64>,
        strength: Option<f64>,
    ) -> Result<FatigueComponent, CurveError> {
        let diameter = diameter.unwrap_or(0.0);
        let measure = match self.kind {
            CurveKind::Tension => Measure::TensionRatio,
            CurveKind::ChainStress => Measure::Stress {
                nominal_area: chain_area(diameter),
            },
            CurveKind::RopeStress => Measure::Stress {
                nominal_area: rope_area(diameter),
            },
        };
        FatigueComponent::new(self.title, self.law, measure, strength)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycles(id: &str, range: f64, mean: f64) -> f64 {
        let component = published(id)
            .unwrap()
            .component(Some(0.1), Some(1e7))
            .unwrap();
        component.cycles_to_failure(range, mean).unwrap()
    }

    fn is(found: f64, expected: f64) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }

    /// N of a tenth of the strength, from K as the standard prints it.
    #[test]
    fn tension_curves() {
        is(cycles("api-studlink-chain", 1e6, 0.0), 1000.0 * 1e3);
        is(cycles("api-studless-chain", 1e6, 0.0), 316.0 * 1e3);
        is(cycles("api-connecting-link", 1e6, 0.0), 178.0 * 1e3);
        is(
            cycles("api-six-strand-rope", 1e6, 3e6),
            10.0_f64.powf(3.20 - 0.837 + 4.09),
        );
        is(
            cycles("api-spiral-strand-rope", 1e6, 3e6),
            10.0_f64.powf(3.25 - 1.029 + 5.05),
        );
        is(
            cycles("dnv-polyester-rope", 1e6, 3e6),
            0.259 * 10.0_f64.powf(13.46),
        );
    }

    /// N of 100 MPa, from a_D as the standard prints it.
    #[test]
    fn stress_curves() {
        let (chain, rope) = (100e6 * chain_area(0.1), 100e6 * rope_area(0.1));
        is(cycles("dnv-stud-chain", chain, 0.0), 1.2e11 / 1e6);
        is(cycles("dnv-studless-chain", chain, 0.0), 6.0e10 / 1e6);
        is(cycles("dnv-six-strand-rope", rope, 0.0), 3.4e14 / 1e8);
        is(
            cycles("dnv-spiral-strand-rope", rope, 0.0),
            1.7e17 / 100.0_f64.powf(4.8),
        );
    }

    #[test]
    fn every_curve_is_sound_and_named_once() {
        for (i, curve) in PUBLISHED.iter().enumerate() {
            assert!(
                curve.law.checked().is_ok() && curve.source.contains("check against your edition")
            );
            assert!(
                PUBLISHED
                    .iter()
                    .skip(i + 1)
                    .all(|other| other.id != curve.id)
            );
            let both = curve.component(Some(0.1), Some(1e7)).unwrap();
            // A lower range lasts longer, by the exponent.
            let n = |range: f64| both.cycles_to_failure(range, 2e6).unwrap();
            let exponent = curve
                .law
                .knee
                .map_or(curve.law.exponent, |knee| knee.exponent);
            assert!((n(5e5) / n(1e6) / 2.0_f64.powf(exponent) - 1.0).abs() < 1e-9);
            assert!(curve.component(None, None).is_err());
        }
        assert!(published("unknown").is_none());
    }
}
