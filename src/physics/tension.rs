//! Tension of a segment: linear elastic with axial damping; no compression unless the line is a rod.
//!
//! `T = EA e + C de/dt` in tension and 0 when slack (Jia et al. 2019, sec. 1.3: bushing forces of an
//! axial stiffness; the line carries no push). The damping part is held between -EA e and EA e, so
//! that the tension grows from zero, without a jump, when a slack segment comes taut at speed. A material may have
//! another elastic part than `EA e`: see [`super::rope`].

use super::rope::ElasticTension;
use crate::numerics::V3;

/// Axial constants of a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialConstants {
    /// Unstretched length \[m\].
    pub length: f64,
    /// Stiffness EA \[N\]; where the material has a law of its own, a slope that its tension does not exceed.
    pub ea: f64,
    /// Damping C \[N s\], tension per strain rate.
    pub damping: f64,
    /// 1 / length \[1/m\], kept because a division costs more than all the rest of a tension.
    inverse: f64,
    /// Whether it bears compression: a line with bending stiffness does, a rope does not.
    pub rod: bool,
    /// The law its elastic tension follows, by its number among those of the line; absent: EA times strain.
    pub law: Option<u16>,
    /// Rate of the unstretched length by that length \[1/s\]: of a segment that is paid out.
    pub growth: f64,
}

/// Where a segment is and how it moves.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Chord {
    /// Unit tangent from its first to its second node.
    pub tangent: V3,
    /// Length \[m\], at least a millionth of the unstretched one.
    pub length: f64,
    /// 1 / length \[1/m\].
    pub inverse: f64,
    /// Velocity of the second node less that of the first \[m/s\].
    pub opening: V3,
}

impl Chord {
    /// From the positions and velocities of both nodes. Nodes that coincide have no direction: the
    /// tangent is then shorter than one, and zero in the limit, so that nothing is ever divided by zero.
    #[inline(always)]
    #[must_use]
    pub fn new(x: (&V3, &V3), v: (&V3, &V3), unstretched: f64) -> Self {
        let d = x.1 - x.0;
        let length = d.norm().max(1e-6 * unstretched);
        let inverse = 1.0 / length;
        Self {
            tangent: d * inverse,
            length,
            inverse,
            opening: v.1 - v.0,
        }
    }
}

/// Tension and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tension {
    /// Tension \[N\]; negative only in a rod.
    pub value: f64,
    /// Derivative by length \[N/m\], at fixed direction and speed.
    pub by_length: f64,
    /// Derivative by the speed at which the segment opens \[N s/m\].
    pub by_speed: f64,
}

impl Tension {
    /// Of a slack segment.
    pub const NONE: Self = Self {
        value: 0.0,
        by_length: 0.0,
        by_speed: 0.0,
    };
}

impl AxialConstants {
    /// From unstretched length \[m\], stiffness \[N\] and damping \[N s\].
    #[must_use]
    pub fn new(length: f64, ea: f64, damping: f64) -> Self {
        Self {
            length,
            ea,
            damping,
            inverse: 1.0 / length,
            rod: false,
            law: None,
            growth: 0.0,
        }
    }

    /// The same with another unstretched length \[m\], which grows at a rate \[m/s\].
    #[must_use]
    pub fn of_length(self, length: f64, rate: f64) -> Self {
        let inverse = 1.0 / length;
        Self {
            length,
            inverse,
            growth: rate * inverse,
            ..self
        }
    }

    /// The same, bearing compression or not.
    #[must_use]
    pub fn bearing_compression(self, rod: bool) -> Self {
        Self { rod, ..self }
    }

    /// The same, its elastic tension following a law.
    #[must_use]
    pub fn with_law(self, law: Option<u16>) -> Self {
        Self { law, ..self }
    }

    /// Stiffness of the segment EA / length \[N/m\].
    #[inline(always)]
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.ea * self.inverse
    }

    /// 1 / unstretched length \[1/m\].
    #[inline(always)]
    #[must_use]
    pub fn inverse_length(&self) -> f64 {
        self.inverse
    }

    /// Strain of a segment of this length \[-\].
    #[inline(always)]
    #[must_use]
    pub fn strain(&self, length: f64) -> f64 {
        (length - self.length) * self.inverse
    }

    /// The tension of a segment that has no law of its own.
    #[inline(always)]
    #[must_use]
    pub fn tension(&self, chord: &Chord) -> Tension {
        let stretch = chord.length - self.length;
        if stretch <= 0.0 && !self.rod {
            return Tension::NONE;
        }
        let stiffness = self.ea * self.inverse;
        self.damped(chord, stiffness * stretch, stiffness)
    }

    /// The tension of a segment whose elastic part is given.
    #[must_use]
    pub fn tension_from(&self, chord: &Chord, elastic: ElasticTension) -> Tension {
        if elastic.tension <= 0.0 && !self.rod {
            return Tension::NONE;
        }
        self.damped(chord, elastic.tension, elastic.by_strain * self.inverse)
    }

    /// Elastic tension \[N\] of this slope by length \[N/m\], and axial damping.
    #[inline(always)]
    fn damped(&self, chord: &Chord, elastic: f64, stiffness: f64) -> Tension {
        let c = self.damping * self.inverse;
        let viscous = c * chord.tangent.dot(&chord.opening);
        if self.rod {
            return Tension {
                value: elastic + viscous,
                by_length: stiffness,
                by_speed: c,
            };
        }
        if viscous > elastic {
            Tension {
                value: 2.0 * elastic,
                by_length: 2.0 * stiffness,
                by_speed: 0.0,
            }
        } else if viscous < -elastic {
            Tension::NONE
        } else {
            Tension {
                value: elastic + viscous,
                by_length: stiffness,
                by_speed: c,
            }
        }
    }
}
