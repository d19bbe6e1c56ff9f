//! Added mass of half a segment, or of a body aligned with its line: the water that goes with it, mostly across.
//!
//! Jia et al. 2019, eqs (2) and (3), their second terms, for a body accelerating in water that does
//! not: `M a = m_n (a - t (t.a)) + m_t t (t.a)`.

use nalgebra::Vector3;

use crate::numerics::lanes::{Number, Two, dot};
use crate::numerics::{M3, V3};

/// Added mass of half a segment, of both halves side by side, or of a body aligned with the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AddedMass<T = f64> {
    /// Across \[kg\].
    pub normal: T,
    /// Along \[kg\].
    pub tangential: T,
}

impl<T: Number> AddedMass<T> {
    /// A share of it.
    #[inline(always)]
    #[must_use]
    pub fn scaled(&self, share: T) -> Self {
        Self {
            normal: self.normal * share,
            tangential: self.tangential * share,
        }
    }

    /// Force that the acceleration a \[m/s²\] needs \[N\], at tangent t.
    #[inline(always)]
    #[must_use]
    pub fn force(&self, t: &Vector3<T>, a: &Vector3<T>) -> Vector3<T> {
        a * self.normal + t * ((self.tangential - self.normal) * dot(t, a))
    }

    /// Derivative of that force by the chord, in the form `s I + t p'`, the numbers (s, p):
    /// `(m_t - m_n) [ (t.a) (I - tt') + t ((I - tt') a)' ] / l`.
    #[inline(always)]
    #[must_use]
    pub fn by_chord(&self, t: &Vector3<T>, a: &Vector3<T>, inverse_chord: T) -> (T, Vector3<T>) {
        let k = (self.tangential - self.normal) * inverse_chord;
        let s = k * dot(t, a);
        (s, a * k - t * (s + s))
    }
}

impl AddedMass {
    /// `(m_n + mass) I + (m_t - m_n) tt'` \[kg\], with a mass that is the same along all axes on top, at tangent t.
    #[must_use]
    pub fn matrix(&self, t: &V3, mass: f64) -> M3 {
        let along = t * ((self.tangential - self.normal) * t).transpose();
        M3::from_diagonal_element(self.normal + mass) + along
    }
}

impl AddedMass<Two> {
    /// Both halves.
    #[inline(always)]
    #[must_use]
    pub fn of_halves([first, second]: [AddedMass; 2]) -> Self {
        Self {
            normal: Two::new([first.normal, second.normal]),
            tangential: Two::new([first.tangential, second.tangential]),
        }
    }
}
