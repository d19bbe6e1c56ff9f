//! A body that travels along the line: a cargo hauled over a ropeway, a trolley, a crawler.
//!
//! Its place along the line is prescribed; it lies on the straight segment between two nodes, `X = (1 - s) x_i + s x_j`,
//! and its mass, weight and inertia go to them by these shares. What a moving mass adds to the acceleration of a fixed one,
//! `A = (1 - s) a_i + s a_j + 2 s' (v_j - v_i) + s'' (x_j - x_i)`, is counted: these are Lagrange's equations within a
//! segment. Left out is the turn of its own path from one segment to the next, m v² / R where the line bends to a radius R:
//! v²/gR of its weight, one part in a thousand at 1 m/s on 100 m.

use super::{End, Scene};
use crate::linalg::{BlockBand, M3, V3};
use crate::solve::{Factors, State};

/// A body that travels along the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Traveller {
    /// Mass \[kg\].
    pub mass: f64,
    /// Weight \[N\], positive down.
    pub weight: f64,
    /// Unstretched arc length at which it begins \[m\].
    pub from: f64,
    /// Unstretched arc length at which it stays \[m\].
    pub to: f64,
    /// Speed along the unstretched line \[m/s\], positive.
    pub speed: f64,
    /// Time at which it sets out \[s\].
    pub start: f64,
    /// Time in which it comes to its speed \[s\].
    pub ramp: f64,
}

/// Where a traveller sits: segment, share of the segment behind it, and the share's first two derivatives by time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seat {
    segment: usize,
    share: f64,
    rate: f64,
    gain: f64,
}

impl Traveller {
    /// Unstretched arc length \[m\], its rate \[m/s\] and the rate's \[m/s²\] at time t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> (f64, f64, f64) {
        let way = self.to - self.from;
        let since = t - self.start;
        if since <= 0.0 {
            return (self.from, 0.0, 0.0);
        }
        let (gone, speed, gain) = if since < self.ramp {
            // The speed rises as 3 u² - 2 u³.
            let u = since / self.ramp;
            (
                self.speed * self.ramp * u * u * u * (1.0 - 0.5 * u),
                self.speed * u * u * (3.0 - 2.0 * u),
                self.speed / self.ramp * 6.0 * u * (1.0 - u),
            )
        } else {
            (self.speed * (since - 0.5 * self.ramp), self.speed, 0.0)
        };
        if gone >= way.abs() {
            return (self.to, 0.0, 0.0);
        }
        let sign = 1.0_f64.copysign(way);
        (self.from + sign * gone, sign * speed, sign * gain)
    }
}

impl Scene {
    /// Where the traveller sits at time t.
    fn seat(&self, traveller: &Traveller, t: f64) -> Seat {
        let (arc, rate, gain) = traveller.at(t);
        let last = self.segments.len() - 1;
        let segment = self.arc[1..last + 1].partition_point(|end| *end <= arc);
        let length = self.arc[segment + 1] - self.arc[segment];
        Seat {
            segment,
            share: ((arc - self.arc[segment]) / length).clamp(0.0, 1.0),
            rate: rate / length,
            gain: gain / length,
        }
    }

    /// Unstretched arc length of the traveller at time t \[m\]; absent: there is none.
    #[must_use]
    pub fn traveller_arc(&self, t: f64) -> Option<f64> {
        self.traveller.as_ref().map(|traveller| traveller.at(t).0)
    }

    /// Position \[m\] and velocity \[m/s\] of the traveller at time t; absent: there is none.
    #[must_use]
    pub fn traveller_at(&self, t: f64, state: &State) -> Option<(V3, V3)> {
        let seat = self.seat(self.traveller.as_ref()?, t);
        let (i, j, s) = (seat.segment, seat.segment + 1, seat.share);
        let place = state.x[i] * (1.0 - s) + state.x[j] * s;
        let drift = (state.x[j] - state.x[i]) * seat.rate;
        Some((place, state.v[i] * (1.0 - s) + state.v[j] * s + drift))
    }

    /// Tension of the segment that the traveller is on \[N\]; absent: there is none.
    #[must_use]
    pub fn traveller_tension(&self, t: f64, state: &State) -> Option<f64> {
        let seat = self.seat(self.traveller.as_ref()?, t);
        let chord = self.chord(seat.segment, state);
        Some(self.pull(seat.segment, &chord, t, state).value)
    }

    /// Kinetic and potential energy of the traveller \[J\], and the power that its drive puts into the line \[W\].
    #[must_use]
    pub fn traveller_energy(&self, t: f64, state: &State) -> Option<(f64, f64)> {
        let traveller = self.traveller.as_ref()?;
        let (place, velocity) = self.traveller_at(t, state)?;
        let seat = self.seat(traveller, t);
        let along = (state.x[seat.segment + 1] - state.x[seat.segment]) * seat.rate;
        let power = traveller.force(&seat, state).dot(&along);
        let energy = 0.5 * traveller.mass * velocity.norm_squared() + traveller.weight * place.z;
        Some((energy, power))
    }

    /// What the traveller adds to the pull on a held end while it is on the segment there \[N\].
    #[must_use]
    pub fn traveller_on(&self, node: usize, t: f64, state: &State) -> V3 {
        let Some(traveller) = &self.traveller else {
            return V3::zeros();
        };
        let seat = self.seat(traveller, t);
        let share = match node.checked_sub(seat.segment) {
            Some(0) => 1.0 - seat.share,
            Some(1) => seat.share,
            _ => return V3::zeros(),
        };
        -traveller.force(&seat, state) * share
    }

    /// Adds the traveller's weight and inertia to the residual.
    pub(super) fn add_traveller(&self, t: f64, state: &State, r: &mut [V3]) {
        if let Some(traveller) = &self.traveller {
            let seat = self.seat(traveller, t);
            let force = traveller.force(&seat, state);
            r[seat.segment] += force * (1.0 - seat.share);
            r[seat.segment + 1] += force * seat.share;
        }
    }

    /// Adds the derivatives of that.
    pub(super) fn add_traveller_tangent(&self, t: f64, c: Factors, tangent: &mut BlockBand) {
        if let Some(traveller) = &self.traveller {
            let seat = self.seat(traveller, t);
            let (i, s) = (seat.segment, seat.share);
            let turn = 2.0 * seat.rate * c.damping + seat.gain * c.stiffness;
            let by_first = traveller.mass * ((1.0 - s) * c.mass - turn);
            let by_second = traveller.mass * (s * c.mass + turn);
            tangent.diag[i] += M3::from_diagonal_element((1.0 - s) * by_first);
            tangent.upper[i] += M3::from_diagonal_element((1.0 - s) * by_second);
            tangent.lower[i + 1] += M3::from_diagonal_element(s * by_first);
            tangent.diag[i + 1] += M3::from_diagonal_element(s * by_second);
        }
    }

    /// Corrects the accelerations that the line would have without the traveller: its mass couples two nodes.
    pub(super) fn accelerate_traveller(&self, t: f64, state: &mut State) {
        let Some(traveller) = &self.traveller else {
            return;
        };
        let seat = self.seat(traveller, t);
        let (first, second) = (seat.segment, seat.segment + 1);
        let held = |node: usize| {
            (node == 0 && matches!(self.ends[0], End::Held(_)))
                || (node == self.segments.len() && matches!(self.ends[1], End::Held(_)))
        };
        let lightness = |node: usize| {
            if held(node) {
                M3::zeros()
            } else {
                self.lightness(node, state)
            }
        };
        let shares = [(first, 1.0 - seat.share), (second, seat.share)];
        let light = shares.map(|(node, _)| lightness(node));
        let [a, b] = shares;
        let give = light[0] * (a.1 * a.1) + light[1] * (b.1 * b.1);
        let system = M3::identity() + give * traveller.mass;
        let Some(force) = system.lu().solve(&traveller.force(&seat, state)) else {
            return;
        };
        for ((node, share), light) in shares.into_iter().zip(light) {
            state.a[node] -= light * force * share;
        }
    }
}

impl Traveller {
    /// Its weight and inertia at a seat, as a residual: m A and the weight, which pulls down \[N\].
    fn force(&self, seat: &Seat, state: &State) -> V3 {
        let (i, j, s) = (seat.segment, seat.segment + 1, seat.share);
        let acceleration = state.a[i] * (1.0 - s)
            + state.a[j] * s
            + (state.v[j] - state.v[i]) * (2.0 * seat.rate)
            + (state.x[j] - state.x[i]) * seat.gain;
        acceleration * self.mass + V3::z() * self.weight
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_derivatives_and_it_stays_where_it_should() {
        for (from, to) in [(3.0, 20.0), (20.0, 3.0)] {
            let traveller = Traveller {
                mass: 1.0,
                weight: 1.0,
                from,
                to,
                speed: 1.5,
                start: 2.0,
                ramp: 3.0,
            };
            for t in [1.0, 2.5, 4.9, 5.1, 9.0] {
                let h = 1e-5;
                let (before, now, after) =
                    (traveller.at(t - h), traveller.at(t), traveller.at(t + h));
                assert!(((after.0 - before.0) / (2.0 * h) - now.1).abs() < 1e-8);
                assert!(((after.1 - before.1) / (2.0 * h) - now.2).abs() < 1e-4);
            }
            assert_eq!(traveller.at(100.0), (to, 0.0, 0.0));
            assert_eq!(traveller.at(0.0), (from, 0.0, 0.0));
        }
    }
}
