//! What is recorded of a system in motion.

use super::body_equation::MovingBody;
use super::broken_names;
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::pins::pin_force;
use super::system_state::SystemState;
use crate::case::{ChannelId, ChannelQuantity};
use crate::numerics::V3;
use crate::system::network::{Body, Held, Network};

/// What a channel reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Source {
    /// Tension of a line at its end A or B.
    Tension(usize, usize),
    /// Tension of a line where its sections of these numbers meet.
    Between(usize, usize),
    /// Tension of a line at a node.
    At(usize, usize),
    /// A coordinate of a joint.
    Place(usize, usize),
    /// Roll, pitch or yaw of a body.
    Angle(usize, usize),
    /// A component of the force of the pin of a body.
    Pin(usize, usize),
    /// Upward pull of the lines on a joint.
    Uplift(usize),
    /// Height of the waves over the gauge.
    Elevation,
    /// Unstretched length of a line that is paid out, by its number among those.
    Length(usize),
}

/// The channels of a system and where they are read.
#[derive(Debug, Clone)]
pub struct Channels {
    /// Their names.
    pub ids: Vec<ChannelId>,
    sources: Vec<Source>,
}

impl Channels {
    /// Tensions at both ends of every line, places of the points that move, poses of the bodies that move, height of the waves.
    #[must_use]
    pub fn of(system: &MovingSystem) -> Self {
        let mut channels = Self {
            ids: Vec::new(),
            sources: Vec::new(),
        };
        for number in 0..system.network.lines.len() {
            for (end, word) in ["a", "b"].into_iter().enumerate() {
                if let Some(name) = broken_names::name_of_end(system, number, end) {
                    let id = ChannelQuantity::Tension.at(format!("{name}|{word}"));
                    channels.add(id, Source::Tension(number, end));
                }
            }
            channels.between(system, number);
        }
        for (point, &joint) in system.network.points.iter().zip(&system.joints.points) {
            let moves = match system.joints.roles[joint] {
                Role::Prescribed(_) => point.motion.is_some(),
                Role::OnBody(body, _) => moves(system, body),
                _ => !broken_names::is_between(&point.name),
            };
            if moves {
                channels.place(&point.name, joint);
            }
        }
        for (number, body) in system.network.bodies.iter().enumerate() {
            if moves(system, number) {
                channels.place(&body.name, system.joints.bodies[number]);
                for (axis, quantity) in ChannelQuantity::ANGLES.into_iter().enumerate() {
                    channels.add(quantity.at(body.name.as_str()), Source::Angle(number, axis));
                }
            }
            if body.pinned {
                for (axis, quantity) in ChannelQuantity::PIN_FORCE.into_iter().enumerate() {
                    channels.add(quantity.at(body.name.as_str()), Source::Pin(number, axis));
                }
            }
        }
        if system.network.records_uplift {
            channels.uplift(system);
        }
        if system.network.sea.is_some() {
            let id = ChannelQuantity::WaveElevation.at("gauge");
            channels.add(id, Source::Elevation);
        }
        for (number, paid) in system.paid.iter().enumerate() {
            let name = system.network.lines[paid.line].name.as_str();
            channels.add(ChannelQuantity::Length.at(name), Source::Length(number));
        }
        channels
    }

    /// Of a line between two ends, by the names of its case: tensions where its sections meet and at its ends, places of its ends, height
    /// of the waves.
    #[must_use]
    pub(super) fn of_single_line(system: &MovingSystem) -> Self {
        let mut channels = Self {
            ids: Vec::new(),
            sources: Vec::new(),
        };
        let labels = system.scenes.first().map(|scene| &scene.labels);
        for joint in labels.iter().flat_map(|labels| &labels.joints) {
            let id = ChannelQuantity::Tension.at(joint.name.as_str());
            channels.add(id, Source::At(0, joint.node));
        }
        for (point, &joint) in system.network.points.iter().zip(&system.joints.points) {
            channels.place(&point.name, joint);
        }
        if system.network.sea.is_some() {
            let id = ChannelQuantity::WaveElevation.at("gauge");
            channels.add(id, Source::Elevation);
        }
        channels
    }

    fn place(&mut self, name: &str, joint: usize) {
        for (axis, quantity) in ChannelQuantity::POSITION.into_iter().enumerate() {
            self.add(quantity.at(name), Source::Place(joint, axis));
        }
    }

    /// Tensions where the sections of a line meet, by their number from end A; not of lines that may break, whose parts change.
    fn between(&mut self, system: &MovingSystem, line: usize) {
        let given = &system.network.lines[line];
        let ends = [given.from, given.to];
        if ends
            .iter()
            .any(|end| broken_names::is_between(&system.network.points[*end].name))
        {
            return;
        }
        for meeting in 1..given.sections.len() {
            let id = ChannelQuantity::Tension.at(format!("{}|{meeting}", given.name));
            self.add(id, Source::Between(line, meeting));
        }
    }

    fn uplift(&mut self, system: &MovingSystem) {
        for (point, &joint) in system.network.points.iter().zip(&system.joints.points) {
            if matches!(point.held, Held::At(_)) && !broken_names::is_between(&point.name) {
                let id = ChannelQuantity::Uplift.at(point.name.as_str());
                self.add(id, Source::Uplift(joint));
            }
        }
    }

    fn add(&mut self, id: ChannelId, source: Source) {
        self.ids.push(id);
        self.sources.push(source);
    }

    /// Their values at time t \[s\], in order; `bodies` are those that turn, with their mass, `tensions` those of all nodes of the lines \[N\],
    /// one line after the other, where they are known.
    pub fn read(
        &self,
        (system, bodies): (&MovingSystem, &[MovingBody]),
        (t, state): (f64, &SystemState),
        tensions: Option<&[f64]>,
        values: &mut [f64],
    ) {
        let network = &system.network;
        // Its three components come one after the other.
        let mut pin = V3::zeros();
        let mut first = FirstNode::default();
        let mut tension = |line: usize, node: usize| {
            let known = tensions.and_then(|all| all.get(first.of(line, state) + node));
            known.copied().unwrap_or_else(|| {
                let scene = system.scene(line, state);
                scene.tension_at(node, &state.lines[line])
            })
        };
        let read = self.sources.iter().map(|source| match *source {
            Source::Tension(line, end) => tension(line, end * (state.lines[line].x.len() - 1)),
            Source::Between(line, meeting) => {
                let joint = system.scene(line, state).labels.joints.get(meeting);
                joint.map_or(f64::NAN, |joint| tension(line, joint.node))
            }
            Source::At(line, node) => tension(line, node),
            Source::Place(joint, axis) => state.joints.x[joint][axis],
            Source::Pin(body, axis) => {
                if axis == 0 {
                    pin = pin_force(system, bodies, state, body);
                }
                pin[axis]
            }
            Source::Uplift(joint) => uplift(system, state, joint),
            Source::Elevation => {
                let sea = network.sea.as_ref();
                sea.map_or(0.0, |sea| sea.elevation(t, &network.gauge))
            }
            Source::Length(number) => {
                let segments = state.paid[number].line.segments.iter();
                let meshed: f64 = segments.map(|segment| segment.axial.length).sum();
                let left = [0, 1].map(|end| system.surplus((number, end), state)[0]);
                meshed - left[0] - left[1]
            }
            Source::Angle(body, axis) => system.body(state, body).pose.angles()[axis].to_degrees(),
        });
        for (value, read) in values.iter_mut().zip(read) {
            *value = read;
        }
    }
}

/// The first node of a line among those of all. Lines are asked for in their order.
#[derive(Default)]
struct FirstNode {
    line: usize,
    node: usize,
}

impl FirstNode {
    fn of(&mut self, line: usize, state: &SystemState) -> usize {
        if line < self.line {
            *self = Self::default();
        }
        let passed = &state.lines[self.line..line];
        self.node += passed.iter().map(|line| line.x.len()).sum::<usize>();
        self.line = line;
        self.node
    }
}

/// The upward pull of all lines on a joint \[N\].
fn uplift(system: &MovingSystem, state: &SystemState, joint: usize) -> f64 {
    let mut sum = 0.0;
    for (number, ends) in state.attached.iter().enumerate() {
        let (scene, line) = (system.scene(number, state), &state.lines[number]);
        for (end, at) in ends.iter().enumerate() {
            if *at == joint {
                sum += scene.end_force(end * (line.x.len() - 1), line).z;
            }
        }
    }
    sum
}

fn moves(system: &MovingSystem, body: usize) -> bool {
    is_moving(&system.network.bodies[body])
}

fn is_moving(body: &Body) -> bool {
    body.turns() || body.motion.is_some()
}

/// The quantities that runs of a system record.
#[must_use]
pub fn quantities(network: &Network) -> Vec<ChannelQuantity> {
    let mut all = vec![ChannelQuantity::Tension];
    let bodies_move = network.bodies.iter().any(is_moving);
    let points = &network.points;
    let points_move = points
        .iter()
        .any(|point| point.motion.is_some() || matches!(point.held, Held::Free(_)));
    if bodies_move || points_move {
        all.extend(ChannelQuantity::POSITION);
    }
    if bodies_move {
        all.extend(ChannelQuantity::ANGLES);
    }
    if network.bodies.iter().any(|body| body.pinned) {
        all.extend(ChannelQuantity::PIN_FORCE);
    }
    all.extend(
        network
            .sea
            .is_some()
            .then_some(ChannelQuantity::WaveElevation),
    );
    all.extend((!network.payouts.is_empty()).then_some(ChannelQuantity::Length));
    all
}
