//! The values of the channels of a system in a state.

use super::body_equation::MovingBody;
use super::channels::Source;
use super::energy::stored;
use super::moving_system::MovingSystem;
use super::pins::pin_force;
use super::system_state::SystemState;
use crate::case::ChannelQuantity;
use crate::numerics::V3;

/// A state from which channels are read in their order.
pub(super) struct ChannelValues<'a> {
    system: &'a MovingSystem,
    /// The bodies that turn, with their mass.
    bodies: &'a [MovingBody],
    time: f64,
    state: &'a SystemState,
    /// Tensions of all nodes of the lines \[N\], one line after the other, where they are known.
    tensions: Option<&'a [f64]>,
    first: FirstNode,
    /// The force whose three components are read one after the other.
    force: V3,
}

impl<'a> ChannelValues<'a> {
    /// Of a system at a time \[s\].
    pub(super) fn new(
        (system, bodies): (&'a MovingSystem, &'a [MovingBody]),
        (time, state): (f64, &'a SystemState),
        tensions: Option<&'a [f64]>,
    ) -> Self {
        Self {
            system,
            bodies,
            time,
            state,
            tensions,
            first: FirstNode::default(),
            force: V3::zeros(),
        }
    }

    /// The value of a channel, in the unit of its quantity.
    pub(super) fn read(&mut self, source: Source) -> f64 {
        let (system, state) = (self.system, self.state);
        match source {
            Source::Tension(line, end) => self.tension(line, end * (state.lines[line].x.len() - 1)),
            Source::Between(line, meeting) => {
                let joint = system.scene(line, state).labels.joints.get(meeting);
                joint.map_or(f64::NAN, |joint| self.tension(line, joint.node))
            }
            Source::At(line, node) => self.tension(line, node),
            Source::Place(joint, axis) => state.joints.x[joint][axis],
            Source::Pin(body, axis) => {
                self.component(axis, |own| pin_force(system, own.bodies, state, body))
            }
            Source::Uplift(joint) => self.pull(joint).z,
            Source::Force(joint, axis) => self.component(axis, |own| own.pull(joint)),
            Source::Speed(joint) => state.joints.v[joint].norm(),
            Source::EndPlace((line, end), axis) => state.joints.x[state.attached[line][end]][axis],
            Source::EndSpeed(line, end) => state.joints.v[state.attached[line][end]].norm(),
            Source::BedForce(joint) => system.bed_force(joint, state),
            Source::Landing(number) => {
                let landed = state.joints.memory.bodies.get(number);
                landed.map_or(0.0, |body| body.landing_speed)
            }
            Source::OnLine(line, number, quantity) => self.body_on((line, number), quantity),
            Source::Rope(..) | Source::Wall(..) => self.in_section(source),
            Source::Bending(line, at_b, quantity) => {
                let bent = system
                    .scene(line, state)
                    .bending_at_end(at_b, &state.lines[line]);
                if quantity == ChannelQuantity::Moment {
                    bent.1
                } else {
                    bent.0
                }
            }
            Source::OnBed(line, second) => {
                let parts = [Some(line), second].into_iter().flatten();
                let on_bed =
                    |part: usize| system.scene(part, state).length_on_bed(&state.lines[part]);
                parts.filter_map(on_bed).sum()
            }
            Source::Sliding(line, second) => {
                let parts = [Some(line), second].into_iter().flatten();
                let sliding =
                    |part: usize| system.scene(part, state).sliding_length(&state.lines[part]);
                parts.filter_map(sliding).fold(0.0, |all, part| all + part)
            }
            Source::Energy => stored(system, self.bodies, state),
            Source::Elevation => {
                let (sea, gauge) = (system.network.sea.as_ref(), &system.network.gauge);
                sea.map_or(0.0, |sea| sea.elevation(self.time, gauge))
            }
            Source::Length(number) => self.unstretched(number),
            Source::Angle(body, axis) => system.body(state, body).pose.angles()[axis].to_degrees(),
        }
    }

    /// Unstretched length of a line that is paid out \[m\].
    fn unstretched(&self, number: usize) -> f64 {
        let segments = self.state.paid[number].line.segments.iter();
        let meshed: f64 = segments.map(|segment| segment.axial.length).sum();
        let left = [0, 1].map(|end| self.system.surplus((number, end), self.state)[0]);
        meshed - left[0] - left[1]
    }

    fn tension(&mut self, line: usize, node: usize) -> f64 {
        let state = self.state;
        let first = &mut self.first;
        let known = self
            .tensions
            .and_then(|all| all.get(first.of_line(line, state) + node));
        known.copied().unwrap_or_else(|| {
            let scene = self.system.scene(line, state);
            scene.tension_at(node, &state.lines[line])
        })
    }

    /// A component of a force, which is computed once for all three.
    fn component(&mut self, axis: usize, force: impl FnOnce(&Self) -> V3) -> f64 {
        if axis == 0 {
            self.force = force(self);
        }
        self.force[axis]
    }

    /// What is read at the first or last node of a section of a line.
    fn in_section(&self, source: Source) -> f64 {
        let (system, state) = (self.system, self.state);
        let value = match source {
            Source::Rope(line, (section, at_end), quantity) => {
                let scene = system.scene(line, state);
                let rope = scene.rope_at_end(section, at_end, &state.lines[line]);
                rope.value(quantity)
            }
            Source::Wall(line, (section, at_end)) => {
                let scene = system.scene(line, state);
                scene.wall_tension(section, at_end, &state.lines[line])
            }
            _ => None,
        };
        value.unwrap_or(f64::NAN)
    }

    /// A quantity of a body on a line.
    fn body_on(&self, (line, number): (usize, usize), quantity: ChannelQuantity) -> f64 {
        let (scene, state) = (self.system.scene(line, self.state), &self.state.lines[line]);
        match quantity {
            ChannelQuantity::BedForce => scene.bed_force_on_body(number, state),
            ChannelQuantity::LandingSpeed => {
                let body = state.memory.bodies.get(number);
                body.map_or(0.0, |body| body.landing_speed)
            }
            _ => {
                let mut axes = ChannelQuantity::POSITION.iter();
                let axis = axes.position(|axis| *axis == quantity);
                let node = scene.labels.clumps.get(number);
                let place = node.and_then(|node| state.x.get(*node)).zip(axis);
                place.map_or(f64::NAN, |(place, axis)| place[axis])
            }
        }
    }

    /// The force of all lines on a joint \[N\].
    fn pull(&self, joint: usize) -> V3 {
        let (system, state) = (self.system, self.state);
        let mut sum = V3::zeros();
        for (number, ends) in state.attached.iter().enumerate() {
            let (scene, line) = (system.scene(number, state), &state.lines[number]);
            for (end, at) in ends.iter().enumerate() {
                if *at == joint {
                    sum += scene.end_force(end * (line.x.len() - 1), line);
                }
            }
        }
        sum
    }
}

/// The first node of a line among those of all. Lines are asked for in their order.
#[derive(Default)]
struct FirstNode {
    line: usize,
    node: usize,
}

impl FirstNode {
    fn of_line(&mut self, line: usize, state: &SystemState) -> usize {
        if line < self.line {
            *self = Self::default();
        }
        let passed = &state.lines[self.line..line];
        self.node += passed.iter().map(|line| line.x.len()).sum::<usize>();
        self.line = line;
        self.node
    }
}
