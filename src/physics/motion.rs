//! Prescribed motion of an end about its position, with a smooth start.

use std::f64::consts::TAU;

use super::ramp::smooth_ramp;
use super::sea::{Harmonic, Harmonics};
use crate::numerics::V3;
use crate::numerics::piecewise::PiecewiseCubic;
use crate::numerics::spline::{POINTS_A_PERIOD, Spline};

/// Motion of a held end.
#[derive(Debug, Clone, PartialEq)]
pub struct EndMotion {
    /// The position it moves about \[m\].
    pub position: V3,
    /// How it moves about it.
    pub course: MotionPath,
    /// The motion grows from zero over this time \[s\].
    pub ramp: f64,
}

/// How an end moves about its position.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionPath {
    /// Not at all.
    Still,
    /// In harmonics of one period.
    Harmonic(HarmonicMotion),
    /// Along a table of places over time.
    Table(Spline),
    /// The same with kinks at the rows, where velocity or acceleration jumps.
    Piecewise(PiecewiseCubic),
    /// In a sum of harmonics: an irregular motion, or that of a vessel in waves.
    Sum(Harmonics),
}

/// Harmonic motion along each axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicMotion {
    /// Amplitudes along x, y, z \[m\].
    pub amplitude: V3,
    /// Angular frequency \[rad/s\].
    pub omega: f64,
    /// Phases along x, y, z \[rad\].
    pub phase: V3,
}

impl EndMotion {
    /// Held still.
    #[must_use]
    pub fn still(position: V3) -> Self {
        Self {
            position,
            course: MotionPath::Still,
            ramp: 0.0,
        }
    }

    /// Position \[m\], velocity \[m/s\] and acceleration \[m/s²\] at time t \[s\]: `x0 + r(t) d(t)`, d the course and r
    /// rising from 0 to 1 as a quintic with no kink in acceleration. At a kink they are those after it.
    #[must_use]
    pub fn at(&self, t: f64) -> (V3, V3, V3) {
        self.after_kinks(t, t)
    }

    /// The same on the piece of the course after the kinks up to a time `passed` \[s\], at any time t \[s\].
    #[must_use]
    pub fn after_kinks(&self, passed: f64, t: f64) -> (V3, V3, V3) {
        self.on_piece(self.piece_at(passed), t)
    }

    /// The piece of the course at time t \[s\]; at a kink the piece after it.
    #[must_use]
    pub fn piece_at(&self, t: f64) -> usize {
        match &self.course {
            MotionPath::Piecewise(path) => path.piece_at(t),
            _ => 0,
        }
    }

    /// The same on a piece of the course between two kinks, the first of which is 0.
    #[must_use]
    pub fn on_piece(&self, piece: usize, t: f64) -> (V3, V3, V3) {
        let (d, v, a) = match &self.course {
            MotionPath::Still => return (self.position, V3::zeros(), V3::zeros()),
            MotionPath::Harmonic(swing) => swing.at(t),
            MotionPath::Table(spline) => spline.at(t),
            MotionPath::Piecewise(path) => path.on_piece(piece, t),
            MotionPath::Sum(harmonics) => harmonics.at(t),
        };
        let (r, r1, r2) = smooth_ramp(t, self.ramp);
        (
            self.position + d * r,
            v * r + d * r1,
            a * r + v * (2.0 * r1) + d * r2,
        )
    }

    /// The shortest period that matters in it \[s\], or the time that steps have to resolve; nothing for an end that stands
    /// still. Of a sum of harmonics the one that half of the acceleration lies below.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        match &self.course {
            MotionPath::Still => None,
            MotionPath::Harmonic(swing) => (swing.omega > 0.0).then(|| TAU / swing.omega),
            MotionPath::Table(spline) => {
                let period = POINTS_A_PERIOD * spline.resolving_interval();
                Some(period.min(2.0 * (spline.span().1 - spline.span().0)))
            }
            MotionPath::Piecewise(path) => Some(2.0 * path.finest()),
            MotionPath::Sum(harmonics) => harmonics.middle_of_acceleration().map(|w| TAU / w),
        }
    }
}

impl EndMotion {
    /// The longest step that sees its course \[s\]: `steps` a period, or the interval that resolves a table, whose error the step
    /// control knows; where steps end at kinks half of a usual piece, so that a companion of twice the step differs; nothing for an end that stands still.
    #[must_use]
    pub fn longest_step(&self, steps: f64) -> Option<f64> {
        match &self.course {
            MotionPath::Table(spline) => Some(spline.resolving_interval()),
            MotionPath::Piecewise(path) => Some(0.5 * path.median_piece()),
            _ => self.period().map(|period| period / steps),
        }
    }

    /// Time of the kink at the end of a piece of the course \[s\]; infinite where there is none.
    #[must_use]
    pub fn next_kink(&self, piece: usize) -> f64 {
        match &self.course {
            MotionPath::Piecewise(path) => path.next_kink(piece),
            _ => f64::INFINITY,
        }
    }

    /// Whether the velocity jumps at the end of a piece of the course.
    #[must_use]
    pub fn velocity_jumps(&self, piece: usize) -> bool {
        matches!(&self.course, MotionPath::Piecewise(path) if path.velocity_jumps(piece))
    }

    /// How far it goes from its position \[m\], and its greatest speed \[m/s\], sampled over this duration \[s\].
    #[must_use]
    pub fn extent(&self, duration: f64) -> (f64, f64) {
        const SAMPLES: usize = 200;
        let (mut far, mut fast) = (0.0_f64, 0.0_f64);
        for k in 0..=SAMPLES {
            let (x, v, _) = self.at(duration * k as f64 / SAMPLES as f64);
            far = far.max((x - self.position).norm());
            fast = fast.max(v.norm());
        }
        (far, fast)
    }

    /// The same whatever part of it a run sees: of harmonics of one period by their amplitude, of a table over all of it, of a sum
    /// of harmonics of several periods `sqrt(8 m0)` and `sqrt(8 m2)` by its spectral moments.
    #[must_use]
    pub fn scale(&self) -> (f64, f64) {
        match &self.course {
            MotionPath::Still => (0.0, 0.0),
            MotionPath::Harmonic(swing) => {
                let far = swing.amplitude.norm();
                (far, swing.omega * far)
            }
            MotionPath::Table(spline) => self.extent(spline.span().1),
            MotionPath::Piecewise(path) => self.extent(path.span().1),
            MotionPath::Sum(harmonics) => {
                let moments = harmonics.moments();
                let by = if harmonics.has_one_period() { 2.0 } else { 8.0 };
                ((by * moments.m0).sqrt(), (by * moments.m2).sqrt())
            }
        }
    }
}

impl HarmonicMotion {
    /// The same as one harmonic.
    #[must_use]
    pub fn harmonic(&self) -> Harmonic {
        Harmonic {
            omega: self.omega,
            cosine: self.amplitude.component_mul(&self.phase.map(f64::sin)),
            sine: self.amplitude.component_mul(&self.phase.map(f64::cos)),
        }
    }

    /// `A sin(omega t + phase)` and its derivatives.
    fn at(&self, t: f64) -> (V3, V3, V3) {
        let w = self.omega;
        let angle = self.phase.map(|p| w * t + p);
        let s = angle.map(f64::sin).component_mul(&self.amplitude);
        let c = angle.map(f64::cos).component_mul(&self.amplitude) * w;
        (s, c, s * (-w * w))
    }
}

/// Angular frequency \[rad/s\] of a period \[s\].
#[must_use]
pub fn omega(period: f64) -> f64 {
    TAU / period
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sea::{Spectrum, synthesise};

    #[test]
    fn velocity_and_acceleration_are_derivatives() {
        let swing = HarmonicMotion {
            amplitude: V3::new(1.0, 0.5, 2.0),
            omega: 0.7,
            phase: V3::new(0.0, 1.0, 2.0),
        };
        let record = synthesise(&Spectrum::of_rms(0.5, 9.0, 3.3), 20, 1, 0);
        let sum = Harmonics::along_axes(&[record, Vec::new(), Vec::new()]);
        let points: Vec<_> = (0..9_i32)
            .map(|i| (f64::from(i), V3::new(0.0, f64::from(i * i % 7), 1.0)))
            .collect();
        let spline = Spline::through(&points).unwrap();
        let monotone = PiecewiseCubic::monotone(&points).unwrap();
        for course in [
            MotionPath::Harmonic(swing),
            MotionPath::Sum(sum),
            MotionPath::Table(spline),
            MotionPath::Piecewise(monotone),
        ] {
            let motion = EndMotion {
                position: V3::new(1.0, 2.0, 3.0),
                course,
                ramp: 5.0,
            };
            for t in [0.5, 2.2, 4.9, 7.3] {
                let h = 1e-4;
                let (before, now, after) = (motion.at(t - h), motion.at(t), motion.at(t + h));
                assert!(((after.0 - before.0) / (2.0 * h) - now.1).norm() < 1e-6);
                assert!(((after.1 - before.1) / (2.0 * h) - now.2).norm() < 1e-5);
            }
        }
    }
}
