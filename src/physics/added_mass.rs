//! Added mass of half a segment: the water that goes with it, mostly across.
//!
//! Jia et al. 2019, eqs (2) and (3), their second terms, for a body accelerating in water that does
//! not: `M a = m_n (a - t (t.a)) + m_t t (t.a)`.

use crate::linalg::V3;

/// Added mass of half a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AddedMass {
    /// Across \[kg\].
    pub normal: f64,
    /// Along \[kg\].
    pub tangential: f64,
}

impl AddedMass {
    /// A share of it.
    #[inline(always)]
    #[must_use]
    pub fn scaled(&self, share: f64) -> Self {
        Self {
            normal: self.normal * share,
            tangential: self.tangential * share,
        }
    }

    /// Force that the acceleration a \[m/s²\] needs \[N\], at tangent t.
    #[inline(always)]
    #[must_use]
    pub fn force(&self, t: &V3, a: &V3) -> V3 {
        a * self.normal + t * ((self.tangential - self.normal) * t.dot(a))
    }

    /// Derivative of that force by the chord, in the form `s I + t p'`, the numbers (s, p):
    /// `(m_t - m_n) [ (t.a) (I - tt') + t ((I - tt') a)' ] / l`.
    #[inline(always)]
    #[must_use]
    pub fn by_chord(&self, t: &V3, a: &V3, inverse_chord: f64) -> (f64, V3) {
        let k = (self.tangential - self.normal) * inverse_chord;
        let along = t.dot(a);
        let s = k * along;
        (s, (a - t * along) * k - t * s)
    }
}
