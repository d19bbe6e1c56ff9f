//! Airy waves: velocity and acceleration of the water, and how both change with the place.
//!
//! A component of amplitude a runs along the unit vector d with `theta = omega t - k d.x + phase`; the surface is at
//! `eta = a cos theta`, the water moves at `a omega C cos theta` along d and `-a omega S sin theta` up, with
//! `C = cosh k(z+h)/sinh kh` and `S = sinh k(z+h)/sinh kh` (Airy's linear theory, DNV-RP-C205 section 3.3.2). The
//! acceleration is the local one, by time at a fixed place, as belongs to a linear theory.
//!
//! # Cost
//! Two short series and a few multiplications a component and node, four components at a time, some 3.4 ns each on the machines at hand
//! (`component_sums.rs`). So a line takes the water once a step, not in every iteration ([`WaterMotion`] goes on from there to first order), the
//! readings of the accepted state at its end are extrapolated from there ([`WaterMotion::extrapolated`]), and components that do not reach down to a node are
//! left out.

use super::component_lanes::ComponentLanes;
use super::component_sums::ComponentSums;
use super::decay::DepthDecay;
use super::phasors::{Anchored, ComputedPhasors, TimePhasors};
use super::stretching::{StretchedHeight, Stretching};
use super::{Component, wave_number};
use crate::numerics::{M3, V3};
use crate::ramp::smooth_ramp;

/// Long-crested waves.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveField {
    /// Components as they pass the origin, frequencies rising; the surface is their sum.
    components: Vec<Component>,
    /// Wave numbers \[1/m\], rising.
    numbers: Vec<f64>,
    /// The same side by side.
    lanes: ComponentLanes,
    /// Where they run to, a unit vector in plan.
    direction: V3,
    /// Depth of the sea \[m\], infinite where it is deep.
    depth: f64,
    stretching: Stretching,
    decay: DepthDecay,
    /// They grow from nothing over this time \[s\].
    ramp: f64,
    load: WaveLoading,
}

/// What of the water's motion reaches the line.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum WaveLoading {
    /// Velocity and acceleration: Morison's load, drag by the speed relative to the moving water.
    #[default]
    Morison,
    /// The acceleration alone; drag as if the waves left the water still. No law of nature, but how models that prescribe
    /// the load of the waves by its inertia treat it.
    Inertia,
}

/// How waves are carried up to the surface and down to the bed, and how they begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveSettings {
    /// Direction they run to, from +x towards +y \[rad\].
    pub direction: f64,
    /// Depth of the sea \[m\], infinite where it is deep.
    pub depth: f64,
    /// Acceleration of gravity \[m/s²\].
    pub gravity: f64,
    /// Near the surface.
    pub stretching: Stretching,
    /// With depth.
    pub decay: DepthDecay,
    /// They grow from nothing over this time \[s\].
    pub ramp: f64,
    /// What of the water's motion reaches the line.
    pub load: WaveLoading,
}

/// What waves make of the water around a place, to first order in the distance from it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct WaterMotion {
    /// The place \[m\].
    pub place: V3,
    /// Velocity \[m/s\].
    pub velocity: V3,
    /// Its derivative by the place \[1/s\].
    pub gradient: M3,
    /// Acceleration \[m/s²\].
    pub acceleration: V3,
    /// Its derivative by the place \[1/s²\].
    pub acceleration_gradient: M3,
    /// Rate of the acceleration at the place \[m/s³\].
    pub jerk: V3,
    /// Height of the surface above still water \[m\].
    pub elevation: f64,
    /// Its derivative by the place \[-\].
    pub slope: V3,
    /// Its rate at the place \[m/s\].
    pub elevation_rate: f64,
}

impl WaterMotion {
    /// The same with all that moves times a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            place: self.place,
            velocity: self.velocity * factor,
            gradient: self.gradient * factor,
            acceleration: self.acceleration * factor,
            acceleration_gradient: self.acceleration_gradient * factor,
            jerk: self.jerk * factor,
            elevation: self.elevation * factor,
            slope: self.slope * factor,
            elevation_rate: self.elevation_rate * factor,
        }
    }

    /// The motion under the surface a time \[s\] later at a place nearby. What is left out are `(omega time)³ / 6` and `(k distance)² / 2` of the
    /// velocity, and an order less of the acceleration. The height of the surface stays.
    #[must_use]
    pub fn extrapolated(&self, time: f64, place: &V3) -> Self {
        let moved = place - self.place;
        let by_place = self.acceleration_gradient * time;
        let gradient = self.gradient + by_place;
        let half_way = self.acceleration + self.jerk * (0.5 * time);
        Self {
            place: *place,
            velocity: self.velocity + gradient * moved + half_way * time,
            gradient,
            acceleration: self.acceleration_at(place) + self.jerk * time,
            ..*self
        }
    }

    /// Velocity \[m/s\] at a place nearby.
    #[inline]
    #[must_use]
    pub fn velocity_at(&self, x: &V3) -> V3 {
        self.velocity + self.gradient * (x - self.place)
    }

    /// Acceleration \[m/s²\] at a place nearby.
    #[inline]
    #[must_use]
    pub fn acceleration_at(&self, x: &V3) -> V3 {
        self.acceleration + self.acceleration_gradient * (x - self.place)
    }

    /// Height of the surface \[m\] at a place nearby.
    #[inline]
    #[must_use]
    pub fn elevation_at(&self, x: &V3) -> f64 {
        self.elevation + self.slope.dot(&(x - self.place))
    }
}

/// The surface of the water over a place.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Surface {
    /// Height above still water \[m\].
    pub(super) elevation: f64,
    /// Its derivative by the place \[-\].
    pub(super) slope: V3,
    /// Its rate \[m/s\].
    pub(super) rate: f64,
}

impl Surface {
    /// Adds that of other waves.
    pub(super) fn add(&mut self, other: &Self) {
        self.elevation += other.elevation;
        self.slope += other.slope;
        self.rate += other.rate;
    }

    /// A motion with this surface.
    pub(super) fn over(&self, motion: WaterMotion) -> WaterMotion {
        WaterMotion {
            elevation: self.elevation,
            slope: self.slope,
            elevation_rate: self.rate,
            ..motion
        }
    }
}

impl WaveField {
    /// Waves of these components, as they pass the origin, frequencies rising.
    #[must_use]
    pub fn new(components: Vec<Component>, setting: &WaveSettings) -> Self {
        let numbers = components
            .iter()
            .map(|c| wave_number(c.omega, setting.gravity, setting.depth));
        let numbers: Vec<f64> = numbers.collect();
        let (sin, cos) = setting.direction.sin_cos();
        Self {
            lanes: ComponentLanes::new(&components, &numbers, setting.depth),
            numbers,
            components,
            direction: V3::new(cos, sin, 0.0),
            depth: setting.depth,
            stretching: setting.stretching,
            decay: setting.decay,
            ramp: setting.ramp,
            load: setting.load,
        }
    }

    /// One of the components alone with another amplitude \[m\], in full height at all times; nothing beyond the last.
    #[must_use]
    pub fn alone(&self, component: usize, amplitude: f64) -> Option<Self> {
        let number = *self.numbers.get(component)?;
        let component = Component {
            amplitude,
            ..self.components[component]
        };
        let (components, numbers) = (vec![component], vec![number]);
        Some(Self {
            lanes: ComponentLanes::new(&components, &numbers, self.depth),
            numbers,
            components,
            ramp: 0.0,
            ..*self
        })
    }

    /// Where they run to, from +x towards +y \[rad\].
    #[must_use]
    pub fn direction(&self) -> f64 {
        self.direction.y.atan2(self.direction.x)
    }

    /// How far the waves have grown at time t \[s\], 0 to 1.
    #[must_use]
    pub fn growth(&self, t: f64) -> f64 {
        smooth_ramp(t, self.ramp).0
    }

    /// The components as they pass a place \[m\].
    #[must_use]
    pub fn at_point(&self, place: &V3) -> Vec<Component> {
        let along = self.direction.dot(place);
        let pairs = self.components.iter().zip(&self.numbers);
        pairs
            .map(|(c, k)| Component {
                phase: c.phase - k * along,
                ..*c
            })
            .collect()
    }

    /// Height of the surface above still water \[m\] at time t \[s\] over a place.
    #[must_use]
    pub fn elevation(&self, t: f64, place: &V3) -> f64 {
        let along = self.direction.dot(place);
        smooth_ramp(t, self.ramp).0
            * self
                .lanes
                .surface(along, &mut ComputedPhasors::at(t))
                .elevation
    }

    /// Moves phasors of it to a time \[s\].
    pub(super) fn move_to(&self, t: f64, phasors: &mut TimePhasors) {
        phasors.move_to(&self.lanes, t);
    }

    /// Whether the height of the surface matters to the stretching.
    #[must_use]
    pub(super) fn needs_elevation(&self) -> bool {
        self.stretching.needs_elevation()
    }

    /// Whether what they make of the water under the surface can be [extrapolated](WaterMotion::extrapolated): acceleration and jerk are the
    /// derivatives of the velocity.
    pub(super) fn can_be_extrapolated(&self) -> bool {
        !self.needs_elevation() && self.load == WaveLoading::Morison
    }

    /// Greatest height that the surface can have \[m\].
    pub(super) fn crest(&self) -> f64 {
        self.components.iter().map(|c| c.amplitude.abs()).sum()
    }

    /// The surface over a place at time t \[s\].
    #[must_use]
    pub(super) fn surface_at(&self, t: f64, place: &V3, phasors: &mut impl Anchored) -> Surface {
        let (r, r1, _) = smooth_ramp(t, self.ramp);
        let sums = self.lanes.surface(self.direction.dot(place), phasors);
        Surface {
            elevation: r * sums.elevation,
            slope: self.direction * (r * sums.slope),
            rate: r * sums.rate + r1 * sums.elevation,
        }
    }

    /// What they make of the water at a place at time t \[s\], where they are alone.
    #[must_use]
    pub fn flow(&self, t: f64, place: &V3) -> WaterMotion {
        let mut phasors = ComputedPhasors::at(t);
        let surface = self.surface_at(t, place, &mut phasors);
        surface.over(self.flow_under(t, place, &surface, &mut phasors))
    }

    /// Velocity and acceleration at a place at time t \[s\] under a surface that may be that of other waves too.
    #[must_use]
    pub(super) fn flow_under(
        &self,
        t: f64,
        place: &V3,
        surface: &Surface,
        phasors: &mut impl Anchored,
    ) -> WaterMotion {
        let (r, r1, r2) = smooth_ramp(t, self.ramp);
        let along = self.direction.dot(place);
        let mut flow = WaterMotion {
            place: *place,
            ..WaterMotion::default()
        };
        let reading = self.stretching.read(place.z, surface.elevation, self.depth);
        if reading.z <= self.decay.reach() {
            return flow;
        }
        let sums = self.lanes.motion(along, &reading, &self.decay, phasors);
        let (velocity, gradient) = self.turned(&sums, &reading, &surface.slope, 0);
        let (acceleration, its_gradient) = self.turned(&sums, &reading, &surface.slope, 1);
        if self.load == WaveLoading::Morison {
            flow.velocity = velocity * r;
            flow.gradient = gradient * r;
        }
        // The growing of the waves is an acceleration as well.
        flow.acceleration = acceleration * r + velocity * r1;
        let jerk = self.direction * sums.jerk[0] + V3::z() * sums.jerk[1];
        flow.jerk = jerk * r + acceleration * (2.0 * r1) + velocity * r2;
        flow.acceleration_gradient = its_gradient * r + gradient * r1;
        flow
    }

    /// Velocity (`which` 0) or acceleration (1) along the axes of the case, and its derivative by the place.
    fn turned(
        &self,
        sums: &ComponentSums,
        reading: &StretchedHeight,
        slope: &V3,
        which: usize,
    ) -> (V3, M3) {
        let d = &self.direction;
        let (across, up) = (sums.across[which], sums.up[which]);
        // Through theta by the distance along the waves, and through the height of the surface by the place.
        let shift = slope * reading.by_elevation;
        let steep = if reading.beyond > 0.0 {
            1.0
        } else {
            reading.by_z
        };
        let (across_z, up_z) = (sums.across_z[which] * steep, sums.up_z[which] * steep);
        let e = V3::z();
        let by_place = |k: f64, by_height: f64, steep: f64| d * k + shift * by_height + e * steep;
        let gradient = d * by_place(sums.across_k[which], sums.across_z[which], across_z)
            .transpose()
            + e * by_place(sums.up_k[which], sums.up_z[which], up_z).transpose();
        (d * across + e * up, gradient)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sea::{Spectrum, synthesise};

    fn setting(depth: f64) -> WaveSettings {
        WaveSettings {
            direction: 0.6,
            depth,
            gravity: 9.81,
            stretching: Stretching::Vertical,
            decay: DepthDecay::Airy,
            ramp: 0.0,
            load: WaveLoading::Morison,
        }
    }

    fn irregular(setting: &WaveSettings) -> WaveField {
        let spectrum = Spectrum::jonswap(4.0, 9.0, 3.3);
        WaveField::new(synthesise(&spectrum, 30, 3, 0), setting)
    }

    /// Every derivative against central differences.
    fn differences(waves: &WaveField, t: f64, place: &V3) {
        let h = 1e-5;
        let at = waves.flow(t, place);
        for axis in 0..3 {
            let mut step = V3::zeros();
            step[axis] = h;
            let (low, high) = (
                waves.flow(t, &(place - step)),
                waves.flow(t, &(place + step)),
            );
            let velocity = (high.velocity - low.velocity) / (2.0 * h);
            let acceleration = (high.acceleration - low.acceleration) / (2.0 * h);
            let slope = (high.elevation - low.elevation) / (2.0 * h);
            assert!(
                (velocity - at.gradient.column(axis)).norm() < 1e-7,
                "{waves:?}"
            );
            assert!((acceleration - at.acceleration_gradient.column(axis)).norm() < 1e-7);
            assert!((slope - at.slope[axis]).abs() < 1e-7);
        }
    }

    #[test]
    fn an_extrapolated_motion_is_as_close_as_its_orders() {
        let field = irregular(&WaveSettings {
            ramp: 10.0,
            ..setting(60.0)
        });
        let place = V3::new(12.0, -7.0, -14.0);
        // While they grow, too.
        for t in [3.0, 61.0] {
            let here = field.flow(t, &place);
            let off = |time: f64, far: f64| {
                let there = place + V3::new(0.6, 0.3, -0.5) * far;
                let (found, exact) = (
                    here.extrapolated(time, &there),
                    field.flow(t + time, &there),
                );
                let velocity = (found.velocity - exact.velocity).norm();
                [
                    velocity,
                    (found.acceleration - exact.acceleration).norm(),
                    (found.gradient - exact.gradient).norm(),
                ]
            };
            let orders = |coarse: [f64; 3], fine: [f64; 3]| {
                std::array::from_fn::<_, 3, _>(|i| (coarse[i] / fine[i]).log2())
            };
            let by_time = orders(off(0.02, 0.0), off(0.01, 0.0));
            let by_place = orders(off(0.0, 0.2), off(0.0, 0.1));
            for (found, order) in by_time.into_iter().zip([3.0, 2.0, 2.0]) {
                assert!((found - order).abs() < 0.1, "{by_time:?} at {t}");
            }
            for (found, order) in by_place.into_iter().zip([2.0, 2.0, 1.0]) {
                assert!((found - order).abs() < 0.1, "{by_place:?} at {t}");
            }
            assert!(off(0.03, 0.03)[0] < 1e-4 * here.velocity.norm());
        }
    }

    #[test]
    fn the_load_of_inertia_leaves_out_the_speed_alone() {
        let whole = irregular(&setting(300.0));
        let part = irregular(&WaveSettings {
            load: WaveLoading::Inertia,
            ..setting(300.0)
        });
        let place = V3::new(13.0, 0.0, -7.0);
        let (whole, part) = (whole.flow(5.0, &place), part.flow(5.0, &place));
        assert!(whole.velocity.norm() > 0.1);
        let expected = WaterMotion {
            velocity: V3::zeros(),
            gradient: M3::zeros(),
            ..whole
        };
        assert_eq!(part, expected);
    }

    #[test]
    fn derivatives_by_place_are_those_of_every_law() {
        let decays = [
            DepthDecay::Airy,
            DepthDecay::AiryAbove(30.0),
            DepthDecay::Logarithmic(30.0),
        ];
        let stretchings = [
            Stretching::None,
            Stretching::Vertical,
            Stretching::Wheeler,
            Stretching::Linear,
        ];
        for depth in [40.0, f64::INFINITY] {
            for decay in decays {
                for stretching in stretchings {
                    let ramp = 20.0;
                    let waves = irregular(&WaveSettings {
                        stretching,
                        decay,
                        ramp,
                        ..setting(depth)
                    });
                    for z in [-28.5, -12.0, -0.7, 5.0] {
                        differences(&waves, 13.0, &V3::new(12.0, -3.0, z));
                        differences(&waves, 31.0, &V3::new(-40.0, 8.0, z));
                    }
                }
            }
        }
    }

    #[test]
    fn a_potential_flow_that_follows_the_surface_and_not_the_bed() {
        let waves = irregular(&setting(40.0));
        let (t, h) = (17.0, 1e-5);
        for z in [-39.0, -12.0, -0.1] {
            let place = V3::new(5.0, 7.0, z);
            let flow = waves.flow(t, &place);
            let (g, size) = (&flow.gradient, flow.gradient.norm());
            assert!(g.trace().abs() < 1e-13 * size, "divergence");
            assert!((g - g.transpose()).norm() < 1e-13 * size, "rotation");
            let rate = (waves.flow(t + h, &place).velocity - waves.flow(t - h, &place).velocity)
                / (2.0 * h);
            assert!((rate - flow.acceleration).norm() < 1e-8);
        }
        // Linear conditions at still water: w = d eta/dt, and du/dt = -g d eta/dx (dispersion).
        let place = V3::new(5.0, 7.0, 0.0);
        let flow = waves.flow(t, &place);
        let rate = (waves.elevation(t + h, &place) - waves.elevation(t - h, &place)) / (2.0 * h);
        assert!((flow.velocity.z - rate).abs() < 1e-8);
        assert!((flow.elevation_rate - rate).abs() < 1e-8);
        let level = V3::new(flow.acceleration.x, flow.acceleration.y, 0.0);
        assert!((level + flow.slope * 9.81).norm() < 1e-12);
        let bed = waves.flow(t, &V3::new(5.0, 7.0, -40.0));
        assert!(bed.velocity.z.abs() < 1e-14);
    }

    #[test]
    fn growing_waves_have_the_acceleration_of_their_growth() {
        let waves = irregular(&WaveSettings {
            ramp: 30.0,
            ..setting(40.0)
        });
        let (place, h) = (V3::new(5.0, 7.0, -3.0), 1e-5);
        assert_eq!(waves.flow(0.0, &place).velocity, V3::zeros());
        for t in [4.0, 17.0, 29.0, 31.0] {
            let rate = (waves.flow(t + h, &place).velocity - waves.flow(t - h, &place).velocity)
                / (2.0 * h);
            assert!((rate - waves.flow(t, &place).acceleration).norm() < 1e-8);
        }
    }

    #[test]
    fn what_passes_a_place_is_its_surface() {
        let waves = irregular(&setting(40.0));
        let place = V3::new(30.0, -20.0, 0.0);
        let passing: f64 = waves.at_point(&place).iter().map(|c| c.at(8.0)).sum();
        assert!((passing - waves.elevation(8.0, &place)).abs() < 1e-12);
    }
}
