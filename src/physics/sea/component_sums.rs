//! The sums over the components of a sea, four components side by side.
//!
//! A line in a random sea spends its steps here: a hundred components at every node. A component is the product of a phasor by time, of one by
//! place along the waves and of its decay with depth ([`Phasors`]); the last two are taken at the nearest anchor of a lattice, and carried from
//! there to the place by short series. So a reader that keeps them ([`PlacePhasors`](super::phasors::PlacePhasors)) works sines and
//! exponentials out anew only where a node passes to another cell of the lattice. What is read depends on time and place alone, to the last
//! digit, whether anything was kept or not: a step that is rejected, a run that is resumed or another length of step change nothing.
//!
//! The sums have four partial sums whatever the processor; on one with wide vectors the same code is compiled for them
//! ([`ARCH`]), without fused products, so that the bits are the same on all.

use pulp::{Simd, WithSimd};

use super::component_lanes::{ComponentLanes, Four};
use super::decay::DepthDecay;
use super::phasors::{Anchored, Decay, Phasor, Phasors, PowerSeries};
use super::stretching::StretchedHeight;
use crate::numerics::processor::{ARCH, LANES, Lanes};

/// Sums over the components: `c`, `s` stand for cosine and sine of theta, `k` for another wave number in the sum.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ComponentSums {
    // Weighted by a omega, then by a omega².
    pub(super) across: [f64; 2],
    pub(super) up: [f64; 2],
    pub(super) across_k: [f64; 2],
    pub(super) up_k: [f64; 2],
    pub(super) across_z: [f64; 2],
    pub(super) up_z: [f64; 2],
    /// Across and up, weighted by a omega³.
    pub(super) jerk: [f64; 2],
}

/// Height of the surface, its slope along the waves and its rate.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SurfaceSums {
    /// \[m\]
    pub(super) elevation: f64,
    /// \[-\]
    pub(super) slope: f64,
    /// \[m/s\]
    pub(super) rate: f64,
}

impl ComponentLanes {
    /// The surface at a distance along the waves \[m\].
    pub(super) fn surface(&self, along: f64, phasors: &mut impl Anchored) -> SurfaceSums {
        phasors.move_along(self, along);
        let ahead = along - phasors.along();
        ARCH.dispatch(SurfaceLoop {
            fours: self.fours(),
            ahead,
            phasors,
        })
    }

    /// The motion under the surface, read at a height; components that do not reach down there are left out, where they decay.
    pub(super) fn motion(
        &self,
        along: f64,
        reading: &StretchedHeight,
        decay: &DepthDecay,
        phasors: &mut impl Anchored,
    ) -> ComponentSums {
        let fading = decay.fading(reading.z);
        let (share, by_z) = (fading.share, fading.by_z);
        phasors.move_along(self, along);
        let ahead = along - phasors.along();
        if !fading.decays {
            let place = MotionPlace {
                ahead,
                above: 0.0,
                z: 0.0,
            };
            let sums = self.sums::<false>(&place, 0.0, &Undecayed(phasors));
            return sums.shared(share + by_z * reading.beyond.max(0.0), by_z, 0.0);
        }
        phasors.move_up(self, reading.z);
        let place = MotionPlace {
            ahead,
            above: reading.z - phasors.z(),
            z: reading.z,
        };
        let sums = self
            .sums::<false>(&place, 0.0, phasors)
            .shared(share, by_z, 1.0);
        if reading.beyond <= 0.0 {
            return sums;
        }
        let beyond = self.sums::<true>(&place, reading.beyond, phasors);
        ComponentSums {
            across_z: sums.across_z,
            up_z: sums.up_z,
            ..beyond.shared(share, by_z, 1.0)
        }
    }

    /// The products that all sums are made of; `BEYOND` a distance \[m\] along the straight line that touches the decay at the height.
    fn sums<const BEYOND: bool>(
        &self,
        place: &MotionPlace,
        beyond: f64,
        phasors: &impl Phasors,
    ) -> Products {
        ARCH.dispatch(MotionLoop::<_, BEYOND> {
            fours: &self.fours()[..self.reaching(place.z)],
            place,
            beyond,
            phasors,
        })
    }
}

/// The loop over all components at the surface, as code that is compiled for several processors.
struct SurfaceLoop<'a, P> {
    fours: &'a [Four],
    ahead: f64,
    phasors: &'a P,
}

impl<P: Phasors> WithSimd for SurfaceLoop<'_, P> {
    type Output = SurfaceSums;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> SurfaceSums {
        let mut sums = [[0.0; LANES]; 3];
        for (number, four) in self.fours.iter().enumerate() {
            add_surface(&mut sums, (number, four), self.ahead, self.phasors);
        }
        SurfaceSums {
            elevation: total(sums[0]),
            slope: total(sums[1]),
            rate: total(sums[2]),
        }
    }
}

/// The same under the surface.
struct MotionLoop<'a, P, const BEYOND: bool> {
    fours: &'a [Four],
    place: &'a MotionPlace,
    beyond: f64,
    phasors: &'a P,
}

impl<P: Phasors, const BEYOND: bool> WithSimd for MotionLoop<'_, P, BEYOND> {
    type Output = Products;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Products {
        let furthest = self.place.ahead.abs().max(self.place.above.abs());
        let at = (self.place, self.beyond);
        let mut sums = [[0.0; LANES]; 10];
        for (number, four) in self.fours.iter().enumerate() {
            let numbered = (number, four);
            if four.most_k * furthest < PowerSeries::SHORT {
                add::<BEYOND>(&mut sums, numbered, PowerSeries::short(), at, self.phasors);
            } else {
                add::<BEYOND>(&mut sums, numbered, PowerSeries::long(), at, self.phasors);
            }
        }
        let mut products = [0.0; 10];
        for (product, lanes) in products.iter_mut().zip(sums) {
            *product = total(lanes);
        }
        Products(products)
    }
}

/// Where a motion is read: from the anchor along the waves and upwards, and at which height \[m\].
struct MotionPlace {
    ahead: f64,
    above: f64,
    z: f64,
}

/// The phasors of a law without a decay of its own for each component: all move as at the surface of deep water.
struct Undecayed<'a, P>(&'a P);

impl<P: Phasors> Phasors for Undecayed<'_, P> {
    #[inline(always)]
    fn time(&self, number: usize, four: &Four) -> Phasor {
        self.0.time(number, four)
    }

    #[inline(always)]
    fn place(&self, number: usize, four: &Four) -> Phasor {
        self.0.place(number, four)
    }

    #[inline(always)]
    fn decay(&self, _: usize, four: &Four) -> Decay {
        Decay {
            falling: four.omega,
            back: [0.0; LANES],
        }
    }
}

/// The sum of the partial sums, always in this order.
#[inline(always)]
fn total(lanes: Lanes) -> f64 {
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// Adds four components to the height of the surface, its slope and its rate.
#[expect(clippy::needless_range_loop, reason = "a lane of many arrays at once")]
#[inline(always)]
fn add_surface(
    sums: &mut [Lanes; 3],
    (number, four): (usize, &Four),
    ahead: f64,
    phasors: &impl Phasors,
) {
    let time = phasors.time(number, four);
    let anchor = phasors.place(number, four);
    for lane in 0..LANES {
        let turn = PowerSeries::long().turn(four.k[lane] * ahead);
        let theta = time.at(lane) / (anchor.at(lane) * turn);
        sums[0][lane] += theta.cos;
        sums[1][lane] += four.k[lane] * theta.sin;
        sums[2][lane] -= four.omega[lane] * theta.sin;
    }
}

/// Adds four components to the products.
#[expect(clippy::needless_range_loop, reason = "a lane of many arrays at once")]
#[inline(always)]
fn add<const BEYOND: bool>(
    sums: &mut [Lanes; 10],
    (number, four): (usize, &Four),
    series: PowerSeries,
    (place, beyond): (&MotionPlace, f64),
    phasors: &impl Phasors,
) {
    let time = phasors.time(number, four);
    let anchor = phasors.place(number, four);
    let decay = phasors.decay(number, four);
    for lane in 0..LANES {
        let (k, omega) = (four.k[lane], four.omega[lane]);
        let theta = time.at(lane) / (anchor.at(lane) * series.turn(k * place.ahead));
        let (cos, sin) = (theta.cos, theta.sin);
        let (falling, back) = series.carry(k * place.above);
        let (falling, back) = (decay.falling[lane] * falling, decay.back[lane] * back);
        let (mut across, mut up) = (falling + back, falling - back);
        if BEYOND {
            (across, up) = (across + k * up * beyond, up + k * across * beyond);
        }
        let (across_cos, across_sin) = (across * cos, across * sin);
        let (up_cos, up_sin) = (up * cos, up * sin);
        sums[0][lane] += across_cos;
        sums[1][lane] += up_sin;
        sums[2][lane] += k * across_sin;
        sums[3][lane] += k * up_cos;
        sums[4][lane] += omega * across_sin;
        sums[5][lane] += omega * up_cos;
        sums[6][lane] += omega * (k * across_cos);
        sums[7][lane] += omega * (k * up_sin);
        sums[8][lane] += omega * (omega * across_cos);
        sums[9][lane] += omega * (omega * up_sin);
    }
}

/// Sums of `a omega` times `C cos`, `S sin`, `k C sin`, `k S cos`, of these with another omega: `C sin`, `S cos`, `k C cos`, `k S sin`, and of the
/// first two with omega², with the shares C across and S up of the surface's motion.
struct Products([f64; 10]);

impl Products {
    /// The sums of velocity and acceleration where a law leaves a share of the motion that changes with height; `decays` is 1 where the
    /// components themselves change with height, else 0.
    ///
    /// Velocity goes with (C cos, -S sin), acceleration by time with (-C sin, -S cos) omega, both by place with `d theta / d along = -k`;
    /// the derivative of C by z is `k S`, and that of S is `k C`.
    fn shared(&self, share: f64, by_z: f64, decays: f64) -> ComponentSums {
        let [
            c_cos,
            s_sin,
            kc_sin,
            ks_cos,
            c_sin,
            s_cos,
            kc_cos,
            ks_sin,
            c_cos_twice,
            s_sin_twice,
        ] = self.0;
        let (across, up) = ([c_cos, -c_sin], [-s_sin, -s_cos]);
        let (across_k, up_k) = ([kc_sin, kc_cos], [ks_cos, -ks_sin]);
        let both = |of: &dyn Fn(usize) -> f64| [of(0), of(1)];
        ComponentSums {
            across: both(&|w| share * across[w]),
            up: both(&|w| share * up[w]),
            across_k: both(&|w| share * across_k[w]),
            up_k: both(&|w| share * up_k[w]),
            across_z: both(&|w| decays * share * up_k[w] + by_z * across[w]),
            up_z: both(&|w| by_z * up[w] - decays * share * across_k[w]),
            jerk: [-share * c_cos_twice, share * s_sin_twice],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;
    use crate::sea::decay::plain::share;
    use crate::sea::phasors::{ComputedPhasors, Kept, PlacePhasors, TimePhasors};
    use crate::sea::{Component, wave_number};

    /// A hundred components over 200 m of water.
    fn hundred() -> (Vec<Component>, Vec<f64>, ComponentLanes) {
        let mut random = Random::new(22, 0);
        let components: Vec<Component> = (0..100)
            .map(|number| Component {
                omega: 0.3 + 0.022 * (f64::from(number) + random.uniform()),
                amplitude: 0.2,
                phase: 6.0 * random.uniform(),
            })
            .collect();
        let numbers = components.iter().map(|c| wave_number(c.omega, 9.81, 200.0));
        let numbers: Vec<f64> = numbers.collect();
        let lanes = ComponentLanes::new(&components, &numbers, 200.0);
        (components, numbers, lanes)
    }

    /// A fairlead that moves by 3 m in 12 s, for 3 h in steps of several lengths: what was kept never drifts from what is exact.
    #[test]
    fn kept_phasors_do_not_drift() {
        let (components, numbers, lanes) = hundred();
        for step in [0.05, 0.12, 0.5] {
            let (mut time, mut place) = (TimePhasors::default(), PlacePhasors::default());
            let mut worst = 0.0_f64;
            for number in 0..3_000_u32 {
                // Ten steps every 36 s.
                let t = 36.0 * f64::from(number / 10) + step * f64::from(number % 10);
                let swing = std::f64::consts::TAU * t / 12.0;
                let (along, z) = (-58.0 + 1.5 * swing.sin(), -14.0 + 1.5 * swing.cos());
                let reading = StretchedHeight {
                    z,
                    beyond: 0.0,
                    by_z: 1.0,
                    by_elevation: 0.0,
                };
                time.move_to(&lanes, t);
                let mut kept = Kept {
                    time: &time,
                    place: &mut place,
                };
                let found = lanes.motion(along, &reading, &DepthDecay::Airy, &mut kept);
                let fresh = lanes.motion(
                    along,
                    &reading,
                    &DepthDecay::Airy,
                    &mut ComputedPhasors::at(t),
                );
                assert_eq!(format!("{found:?}"), format!("{fresh:?}"), "{t}");
                let scene = (&components[..], &numbers[..], 200.0);
                let plain = one_by_one(scene, (t, along), &reading, DepthDecay::Airy);
                for w in 0..2 {
                    worst = worst.max((found.across[w] - plain.across[w]).abs());
                    worst = worst.max((found.up[w] - plain.up[w]).abs());
                }
            }
            // Of amplitudes that add up to 20 m.
            assert!(worst < 1e-12 * 20.0, "{step} {worst:e}");
        }
    }

    /// The loop as it is compiled for this processor and for any.
    #[test]
    fn wide_vectors_have_the_same_bits() {
        let (_, _, lanes) = hundred();
        let mut random = Random::new(23, 0);
        for _ in 0..300 {
            let mut phasors = ComputedPhasors::at(1e4 * random.uniform());
            let (along, z) = (800.0 * random.uniform(), -60.0 * random.uniform());
            phasors.move_along(&lanes, along);
            phasors.move_up(&lanes, z);
            let place = MotionPlace {
                ahead: along - phasors.along(),
                above: z - phasors.z(),
                z,
            };
            let made = || MotionLoop::<_, true> {
                fours: lanes.fours(),
                place: &place,
                beyond: 0.3,
                phasors: &phasors,
            };
            assert_eq!(
                ARCH.dispatch(made()).0,
                made().with_simd(pulp::Scalar::new()).0
            );
        }
    }

    /// The same sums, one component after the other by the standard library.
    fn one_by_one(
        (components, numbers, depth): (&[Component], &[f64], f64),
        (t, along): (f64, f64),
        reading: &StretchedHeight,
        decay: DepthDecay,
    ) -> ComponentSums {
        let mut sums = ComponentSums::default();
        for (c, k) in components.iter().zip(numbers) {
            let share = share(decay, *k, depth, reading.z);
            let above = reading.beyond.max(0.0);
            let across_share = share.across + share.across_by_z * above;
            let up_share = share.up + share.up_by_z * above;
            let (sin, cos) = (c.omega * t - k * along + c.phase).sin_cos();
            let v = c.amplitude * c.omega;
            let parts = [
                (v, cos, -sin, k * sin, k * cos),
                (v * c.omega, -sin, -cos, k * cos, -k * sin),
            ];
            for (which, (size, across, up, across_k, up_k)) in parts.into_iter().enumerate() {
                sums.across[which] += size * across_share * across;
                sums.up[which] += size * up_share * up;
                sums.across_k[which] += size * across_share * across_k;
                sums.up_k[which] += size * up_share * up_k;
                sums.across_z[which] += size * share.across_by_z * across;
                sums.up_z[which] += size * share.up_by_z * up;
            }
        }
        sums
    }

    #[test]
    fn lanes_are_the_components_one_by_one() {
        let mut random = Random::new(21, 0);
        let laws = [
            DepthDecay::Airy,
            DepthDecay::AiryAbove(40.0),
            DepthDecay::Logarithmic(40.0),
        ];
        for (count, depth) in [(1, 50.0), (3, f64::INFINITY), (4, 20.0), (99, 200.0)] {
            let mut components: Vec<Component> = (0..count)
                .map(|_| Component {
                    omega: 0.3 + 1.5 * random.uniform(),
                    amplitude: random.uniform(),
                    phase: 6.0 * random.uniform(),
                })
                .collect();
            components.sort_by(|a, b| a.omega.total_cmp(&b.omega));
            let numbers: Vec<f64> = components
                .iter()
                .map(|c| wave_number(c.omega, 9.81, depth))
                .collect();
            let lanes = ComponentLanes::new(&components, &numbers, depth);
            for (decay, z) in laws
                .into_iter()
                .flat_map(|law| [0.0, -3.0, -19.0].map(|z| (law, z)))
            {
                for beyond in [0.0, 2.0] {
                    let reading = StretchedHeight {
                        z,
                        beyond,
                        by_z: 1.0,
                        by_elevation: 0.0,
                    };
                    let at = (700.0 * random.uniform(), 300.0 * random.uniform());
                    let found =
                        lanes.motion(at.1, &reading, &decay, &mut ComputedPhasors::at(at.0));
                    let plain = one_by_one((&components, &numbers, depth), at, &reading, decay);
                    let pairs = [
                        (found.across, plain.across),
                        (found.up, plain.up),
                        (found.across_k, plain.across_k),
                        (found.up_k, plain.up_k),
                        (found.across_z, plain.across_z),
                        (found.up_z, plain.up_z),
                    ];
                    for (found, plain) in pairs {
                        for (found, plain) in found.into_iter().zip(plain) {
                            let size = 1.0 + count as f64;
                            assert!(
                                (found - plain).abs() < 1e-13 * size,
                                "{decay:?} {z} {beyond}"
                            );
                        }
                    }
                    let surface = lanes.surface(at.1, &mut ComputedPhasors::at(at.0));
                    let height: f64 = components
                        .iter()
                        .zip(&numbers)
                        .map(|(c, k)| c.amplitude * (c.omega * at.0 - k * at.1 + c.phase).cos())
                        .sum();
                    assert!((surface.elevation - height).abs() < 1e-13 * (1.0 + count as f64));
                }
            }
        }
    }

    /// A stage of a step that diverges.
    #[test]
    fn a_place_that_is_no_number_ends_no_run() {
        let (_, _, lanes) = hundred();
        let (mut time, mut place) = (TimePhasors::default(), PlacePhasors::default());
        time.move_to(&lanes, 3.0);
        for (along, z) in [
            (f64::NAN, f64::NAN),
            (f64::NAN, -5.0),
            (f64::INFINITY, -5.0),
            (3.0, f64::NAN),
            (1e300, -1e300),
        ] {
            let reading = StretchedHeight {
                z,
                beyond: 0.0,
                by_z: 1.0,
                by_elevation: 0.0,
            };
            let mut kept = Kept {
                time: &time,
                place: &mut place,
            };
            lanes.motion(along, &reading, &DepthDecay::Airy, &mut kept);
            assert!(lanes.surface(3.0, &mut kept).elevation.is_finite());
        }
    }
}
