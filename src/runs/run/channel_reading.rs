//! The values of channels read off a state of the line.

use crate::case::{ChannelLocation, ChannelQuantity, LineEnd};
use crate::numerics::V3;
use crate::scene::Scene;
use crate::solve::{Kinematics, State};

/// A state from which channels are read; the force on an end is computed once for its three components.
pub(super) struct ChannelReading<'a> {
    scene: &'a Scene,
    time: f64,
    state: &'a State,
    /// Tension of the nodes of the line \[N\].
    tensions: &'a [f64],
    end_forces: [Option<V3>; 2],
}

impl<'a> ChannelReading<'a> {
    /// Of a line at a time \[s\], with the tensions of its nodes \[N\].
    pub(super) fn new(scene: &'a Scene, time: f64, state: &'a State, tensions: &'a [f64]) -> Self {
        Self {
            scene,
            time,
            state,
            tensions,
            end_forces: [None; 2],
        }
    }

    /// The value of a channel, in the unit of its quantity; `None` where there is nothing to read.
    pub(super) fn channel(
        &mut self,
        quantity: ChannelQuantity,
        site: ChannelLocation,
    ) -> Option<f64> {
        use ChannelQuantity as Q;
        let (scene, state) = (self.scene, self.state);
        match quantity {
            Q::Tension => self.tension(site),
            Q::WallTension => self.wall_tension(site),
            Q::X => self.position(site).map(|x| x[0]),
            Q::Y => self.position(site).map(|x| x[1]),
            Q::Z => self.position(site).map(|x| x[2]),
            Q::Speed => match site {
                ChannelLocation::End(LineEnd::A) => Some(state.v[0].norm()),
                _ => Some(scene.end_b_velocity(state).norm()),
            },
            Q::Tilt => Some(scene.tilt(state).to_degrees()),
            Q::Roll | Q::Pitch | Q::Yaw | Q::Length => None,
            Q::PinForceX | Q::PinForceY | Q::PinForceZ => None,
            Q::Arc => scene.traveller_arc(self.time, state),
            Q::ForceX => self.end_force(site).map(|f| f[0]),
            Q::ForceY => self.end_force(site).map(|f| f[1]),
            Q::Uplift | Q::ForceZ => self.end_force(site).map(|f| f[2]),
            Q::BedForce => self.bed_force(site),
            Q::LandingSpeed => self.landing_speed(site),
            Q::Curvature => self.bending(site).map(|(curvature, _)| curvature),
            Q::Moment => self.bending(site).map(|(_, moment)| moment),
            Q::OnBed => scene.length_on_bed(state),
            Q::Sliding => scene.sliding_length(state),
            Q::WaveElevation => Some(scene.line.elevation(self.time)),
            Q::Energy => {
                let traveller = scene.traveller_energy(self.time, state);
                Some(scene.energy(state) + traveller.map_or(0.0, |(energy, _)| energy))
            }
            Q::MeanLoad | Q::LoadDeviation | Q::Stiffness => self.rope(quantity, site),
        }
    }

    fn tension(&self, site: ChannelLocation) -> Option<f64> {
        match site {
            ChannelLocation::Joint(joint) => {
                let node = self.scene.labels.joints[joint].node;
                self.tensions.get(node).copied()
            }
            ChannelLocation::Traveller => self.scene.traveller_tension(self.time, self.state),
            _ => None,
        }
    }

    fn wall_tension(&self, site: ChannelLocation) -> Option<f64> {
        let ChannelLocation::Section(section, end) = site else {
            return None;
        };
        self.scene
            .wall_tension(section, end == LineEnd::B, self.state)
    }

    fn position(&self, site: ChannelLocation) -> Option<V3> {
        match site {
            ChannelLocation::End(LineEnd::A) => Some(self.state.x[0]),
            ChannelLocation::End(LineEnd::B) => Some(self.scene.end_b_position(self.state)),
            ChannelLocation::Body(body) => Some(self.state.x[self.scene.labels.clumps[body]]),
            ChannelLocation::Traveller => {
                let at = self.scene.traveller_at(self.time, self.state);
                at.map(|(place, _)| place)
            }
            _ => None,
        }
    }

    fn end_force(&mut self, site: ChannelLocation) -> Option<V3> {
        let ChannelLocation::End(end) = site else {
            return None;
        };
        let (known, node) = match end {
            LineEnd::A => (&mut self.end_forces[0], 0),
            LineEnd::B => (&mut self.end_forces[1], self.scene.nodes() - 1),
        };
        let force = || {
            self.scene.end_force(node, self.state)
                + self.scene.traveller_force_on(node, self.time, self.state)
        };
        Some(*known.get_or_insert_with(force))
    }

    /// Number of the body at a place among those that bear on the bed.
    fn bearing(&self, site: ChannelLocation) -> Option<usize> {
        match site {
            ChannelLocation::Body(body) => Some(body),
            ChannelLocation::End(LineEnd::B) => Some(self.scene.labels.clumps.len()),
            _ => None,
        }
    }

    fn bed_force(&self, site: ChannelLocation) -> Option<f64> {
        let (scene, state) = (self.scene, self.state);
        match site {
            ChannelLocation::End(LineEnd::A) => Some(scene.bed_force_at(0, state)),
            ChannelLocation::End(LineEnd::B) => {
                Some(scene.bed_force_at(scene.line_nodes() - 1, state))
            }
            ChannelLocation::Body(body) => Some(scene.bed_force_on_body(body, state)),
            _ => None,
        }
    }

    /// Curvature \[1/m\] and bending moment \[N m\] at an end.
    fn bending(&self, site: ChannelLocation) -> Option<(f64, f64)> {
        let ChannelLocation::End(end) = site else {
            return None;
        };
        Some(self.scene.bending_at_end(end == LineEnd::B, self.state))
    }

    fn landing_speed(&self, site: ChannelLocation) -> Option<f64> {
        let bodies = &self.state.memory.bodies;
        Some(
            bodies
                .get(self.bearing(site)?)
                .map_or(0.0, |body| body.landing_speed),
        )
    }

    fn rope(&self, quantity: ChannelQuantity, site: ChannelLocation) -> Option<f64> {
        let ChannelLocation::Section(section, end) = site else {
            return None;
        };
        let rope = self
            .scene
            .rope_at_end(section, end == LineEnd::B, self.state);
        rope.value(quantity)
    }
}
