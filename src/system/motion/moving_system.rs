//! A system in motion: its lines as scenes, its joints, and what is prescribed of them.

use std::ops::Range;

use super::body_equation::BodyWater;
use super::body_flow::{self, BodyFlow};
use super::joints::{Joints, Role};
use super::pose_motion::BodyMotion;
use super::start::turn_bases;
use super::system_state::SystemState;
use super::wave_stations;
use crate::numerics::V3;
use crate::scene::{EndCondition, Scene};
use crate::solve::{Hysteresis, Kinematics, Marched, State};
use crate::system::network::Network;

/// A system in motion.
#[derive(Debug, Clone)]
pub struct MovingSystem {
    /// Points, bodies and lines in SI.
    pub network: Network,
    /// The lines with their inner forces.
    pub scenes: Vec<Scene>,
    /// Points and bodies as nodes.
    pub joints: Joints,
    /// Length by which the turns of each body count \[m\]: the longest arm of what is on it.
    pub arms: Vec<f64>,
    /// The stations of each body at which waves are read, among those of all.
    pub stations: Vec<Range<usize>>,
    /// Potential flow around the bodies that have coefficients.
    pub flows: Vec<BodyFlow>,
}

impl MovingSystem {
    /// A system of these lines, in the order of the network's.
    #[must_use]
    pub fn new(mut network: Network, mut scenes: Vec<Scene>) -> Self {
        let flows = body_flow::flows(&network);
        for flow in &flows {
            if let Some(retardation) = &flow.retardation {
                network.bodies[flow.body].added_mass = retardation.at_infinity;
            }
        }
        let joints = Joints::new(&network);
        let moves = |point: usize| {
            joints.row(joints.points[point]).is_some()
                || matches!(joints.roles[joints.points[point]], Role::OnBody(body, _) if network.bodies[body].free)
        };
        for (line, scene) in network.lines.iter().zip(&mut scenes) {
            // An end that other lines and bodies move is no support of this one.
            for (end, point) in [line.from, line.to].into_iter().enumerate() {
                if moves(point) {
                    scene.line.ends[end] = EndCondition::Free;
                }
            }
            if let Some(sea) = &network.sea {
                let water = (network.density, network.gravity);
                scene.line.put_into_waves(sea, water);
            }
        }
        let mut arms = vec![1.0_f64; network.bodies.len()];
        for role in &joints.roles {
            if let Role::OnBody(body, at) = role {
                arms[*body] = arms[*body].max(at.norm());
            }
        }
        Self {
            stations: wave_stations::ranges(&network.bodies, network.sea.is_some()),
            flows,
            network,
            scenes,
            joints,
            arms,
        }
    }

    /// The nodes of a part that follow the equation of motion; the parts are the lines, then the joints.
    #[must_use]
    pub fn free(&self, part: usize) -> Range<usize> {
        match self.scenes.get(part) {
            Some(scene) => 1..scene.nodes() - 1,
            None => self.joints.free.clone(),
        }
    }

    /// By what lengths the free joints count: 1 for displacements, the arm of its body for a rotation \[m/rad\].
    #[must_use]
    pub fn scale(&self, joint: usize) -> f64 {
        match self.joints.roles[joint] {
            Role::Rotation(body) => self.arms[body],
            _ => 1.0,
        }
    }

    /// Number of the first node of a part, where all nodes are numbered one after the other.
    #[must_use]
    pub fn offset(&self, part: usize) -> usize {
        self.scenes[..part].iter().map(Scene::nodes).sum()
    }

    /// What a node is, by its number among all of them.
    #[must_use]
    pub fn node_name(&self, node: usize) -> String {
        let mut rest = node;
        for (line, scene) in self.network.lines.iter().zip(&self.scenes) {
            if rest < scene.nodes() {
                return format!("node {rest} of line {}", line.name);
            }
            rest -= scene.nodes();
        }
        match self.joints.roles.get(rest) {
            Some(Role::Origin(body)) => format!("body {}", self.network.bodies[*body].name),
            Some(Role::Rotation(body)) => {
                format!("rotation of body {}", self.network.bodies[*body].name)
            }
            Some(Role::Released(line, end)) => {
                let end = ["A", "B"][*end];
                format!("end {end} of line {}", self.network.lines[*line].name)
            }
            _ => {
                let point = self.joints.points.iter().position(|joint| *joint == rest);
                point.map_or_else(String::new, |point| {
                    format!("point {}", self.network.points[point].name)
                })
            }
        }
    }

    /// Sets what is prescribed at time t \[s\]: points, bodies, and points on such bodies.
    pub fn prescribe(&self, t: f64, state: &mut SystemState) {
        for (number, body) in self.network.bodies.iter().enumerate() {
            if let (false, Some(motion)) = (body.free, &body.motion) {
                state.set_body(&self.joints, number, &motion.at(t));
            }
        }
        for joint in 0..self.joints.free.start {
            match self.joints.roles[joint] {
                Role::Prescribed(point) => {
                    if let Some(motion) = &self.network.points[point].motion {
                        set(&mut state.joints, joint, motion.at(t));
                    }
                }
                Role::OnBody(body, at) if !self.network.bodies[body].free => {
                    let motion = state.body(&self.joints, body);
                    set(&mut state.joints, joint, motion.of(&at));
                }
                _ => {}
            }
        }
    }

    /// Sets what follows the unknowns: points on free bodies, and the ends of the lines.
    pub fn follow(&self, state: &mut SystemState) {
        for joint in 0..self.joints.free.start {
            if let Role::OnBody(body, at) = self.joints.roles[joint]
                && self.network.bodies[body].free
            {
                let motion = state.body(&self.joints, body);
                set(&mut state.joints, joint, motion.of(&at));
            }
        }
        for (line, [a, b]) in state.lines.iter_mut().zip(&state.attached) {
            let last = line.x.len() - 1;
            for (node, joint) in [(0, *a), (last, *b)] {
                line.x[node] = state.joints.x[joint];
                line.v[node] = state.joints.v[joint];
                line.a[node] = state.joints.a[joint];
            }
        }
    }

    /// Whether an end of a line is prescribed, so that it borders on no unknown.
    #[must_use]
    pub fn is_plain(&self, state: &SystemState, line: usize) -> bool {
        let ends = state.attached[line];
        ends.into_iter()
            .all(|joint| self.joints.follows(joint) == super::joints::Follows::Nothing)
    }

    /// The water around a body.
    #[must_use]
    pub fn water_around<'a>(&self, state: &'a SystemState, body: usize) -> BodyWater<'a> {
        let stations = self.stations[body].clone();
        let flow = self.flows.iter().position(|flow| flow.body == body);
        BodyWater {
            waves: state.body_flow.get(stations).unwrap_or_default(),
            flow: flow.and_then(|number| state.flow_loads.get(number)),
        }
    }

    /// A body in motion.
    #[must_use]
    pub fn body(&self, state: &SystemState, body: usize) -> BodyMotion {
        state.body(&self.joints, body)
    }
}

/// Writes position, velocity and acceleration of a joint.
fn set(joints: &mut State, joint: usize, (x, v, a): (V3, V3, V3)) {
    (joints.x[joint], joints.v[joint], joints.a[joint]) = (x, v, a);
}

impl Marched<SystemState> for MovingSystem {
    fn next_kink(&self, _state: &SystemState) -> f64 {
        f64::INFINITY
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut SystemState) {
        for (scene, line) in self.scenes.iter().zip(&mut state.lines) {
            Kinematics::update_wave_kinematics(scene, t, line);
        }
        if let Some(sea) = &self.network.sea {
            wave_stations::read(self, sea, t, state);
        }
        body_flow::prepare(self, t, state);
    }

    /// The rotation vectors of the bodies count from here.
    fn commit(&self, t: f64, dt: f64, state: &mut SystemState) {
        for (scene, line) in self.scenes.iter().zip(&mut state.lines) {
            Hysteresis::commit(scene, t, dt, line);
        }
        turn_bases(self, state);
        body_flow::commit(self, t, state);
    }
}
