//! A system in motion: its lines as scenes, its joints, and what is prescribed of them.

use std::ops::Range;

use super::super::{members::STATIONS, network::Body};
use super::body_equation::BodyWater;
use super::body_flow::{self, BodyFlow};
use super::foot::{Foot, feet};
use super::joints::{Joints, Role};
use super::paid_line::PaidLine;
use super::payout::PaidEnd;
use super::point_loads::{anchor, drag_anchor};
use super::pose_motion::BodyMotion;
use super::system_state::SystemState;
use crate::numerics::V3;
use crate::physics::sea::Sea;
use crate::physics::{CurrentProfile, FrictionAnchor};
use crate::scene::{EndCondition, Scene};
use crate::solve::{Kinematics, State};
use crate::system::network::{FreePoint, Held, Line, Network};

/// A system in motion.
#[derive(Debug, Clone)]
pub struct MovingSystem {
    /// Points, bodies and lines in SI.
    pub network: Network,
    /// Waves, with the current where that changes with time.
    pub water: Option<Sea>,
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
    /// What of each body bears on the bed.
    pub feet: Vec<Vec<Foot>>,
    /// The number of what bears on the bed at each joint, in the order of their histories.
    pub bearing_numbers: Vec<Option<usize>>,
    /// The lines that are paid out.
    pub paid: Vec<PaidLine>,
    /// What passes their ends, in the order of the network's.
    pub payouts: Vec<MovingPayout>,
}

/// A payout in motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingPayout {
    /// The length that passes, a joint of one coordinate.
    pub joint: usize,
    /// The force that holds it at rest \[N\]; nothing while the system is brought to rest.
    pub holding: Option<f64>,
    /// Height of its end at time zero \[m\].
    height: f64,
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
                || matches!(joints.roles[joints.points[point]], Role::OnBody(body, _) if network.bodies[body].turns())
        };
        for (line, scene) in network.lines.iter().zip(&mut scenes) {
            // An end that other lines and bodies move is no support of this one.
            for (end, point) in [line.from, line.to].into_iter().enumerate() {
                if moves(point) {
                    scene.line.ends[end] = EndCondition::Free;
                }
            }
            put_into_water(&network, network.sea.as_ref(), line, scene);
        }
        let paid = paid_lines(&network);
        for line in &paid {
            for end in (0..2).filter(|end| line.ends[*end].is_some()) {
                scenes[line.line].feed(end);
            }
        }
        let mut arms = vec![1.0_f64; network.bodies.len()];
        for role in &joints.roles {
            if let Role::OnBody(body, at) = role {
                arms[*body] = arms[*body].max(at.norm());
            }
        }
        let mut system = Self {
            stations: ranges(
                &network.bodies,
                network.sea.is_some() || network.current_over_time.is_some(),
            ),
            water: network.sea.clone(),
            feet: feet(&network, &joints),
            flows,
            paid,
            payouts: Vec::new(),
            bearing_numbers: Vec::new(),
            network,
            scenes,
            joints,
            arms,
        };
        system.payouts = system.moving_payouts();
        let mut numbers = vec![None; system.joints.roles.len()];
        for (number, foot) in system.landing().enumerate() {
            numbers[foot.joint] = Some(number);
        }
        system.bearing_numbers = numbers;
        system
    }

    /// Lets the current change with time, once everything is at rest in that of time zero: from now on it is read with the waves.
    pub fn release_current(&mut self, state: &mut SystemState) {
        let Some(current) = self.network.current_over_time.clone() else {
            return;
        };
        let waves = self
            .network
            .sea
            .clone()
            .unwrap_or_else(|| Sea::new(Vec::new()));
        self.water = Some(waves.with_current(current));
        self.network.current = None;
        let water = self.water.as_ref();
        for (line, scene) in self.network.lines.iter().zip(&mut self.scenes) {
            put_into_water(&self.network, water, line, scene);
        }
        for (paid, scene) in self.paid.iter().zip(&mut state.paid) {
            put_into_water(&self.network, water, &self.network.lines[paid.line], scene);
        }
    }

    /// The payouts, not yet held.
    fn moving_payouts(&self) -> Vec<MovingPayout> {
        let payouts = self.network.payouts.iter().enumerate();
        let moving = payouts.map(|(number, payout)| MovingPayout {
            joint: self.joints.payouts[number],
            holding: None,
            height: payout
                .ends
                .first()
                .map_or(0.0, |paid| self.place_at_start(paid.line, paid.end).z),
        });
        moving.collect()
    }

    /// Place of a prescribed end of a line at time zero \[m\].
    fn place_at_start(&self, line: usize, end: usize) -> V3 {
        let line = &self.network.lines[line];
        let point = &self.network.points[[line.from, line.to][end]];
        match point.held {
            Held::At(place) => point
                .motion
                .as_ref()
                .map_or(place, |motion| motion.at(0.0).0),
            Held::On(body, at) => {
                let body = &self.network.bodies[body];
                let pose = body
                    .motion
                    .as_ref()
                    .map_or(body.pose, |motion| motion.at(0.0).pose);
                pose.origin + pose.arm(&at)
            }
            Held::Free(_) => V3::zeros(),
        }
    }

    /// A line as it is in a state.
    #[must_use]
    pub fn scene<'a>(&'a self, line: usize, state: &'a SystemState) -> &'a Scene {
        self.scene_among(line, &state.paid)
    }

    /// A line as it is among those of a state that are paid out.
    #[must_use]
    pub fn scene_among<'a>(&'a self, line: usize, paid: &'a [Scene]) -> &'a Scene {
        let known = self.paid.iter().position(|paid| paid.line == line);
        known
            .and_then(|number| paid.get(number))
            .unwrap_or(&self.scenes[line])
    }

    /// All lines as they are in a state.
    pub fn lines<'a>(
        &'a self,
        state: &'a SystemState,
    ) -> impl Iterator<Item = (&'a Scene, &'a State)> {
        let lines = state.lines.iter().enumerate();
        lines.map(move |(number, line)| (self.scene(number, state), line))
    }

    /// By what lengths the free joints count: 1 for displacements, the arm of its body for a rotation \[m/rad\].
    #[must_use]
    pub fn scale_of_joint(&self, joint: usize) -> f64 {
        match self.joints.roles[joint] {
            Role::Rotation(body) => self.arms[body],
            _ => 1.0,
        }
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
            Some(Role::Payout(number)) => self.payout_name(*number),
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
        let passed = state.kinks_passed_s;
        for (number, body) in self.network.bodies.iter().enumerate() {
            let Some(motion) = body.motion.as_ref().filter(|_| !body.free) else {
                continue;
            };
            match body.pinned {
                true => state.set_pin(&self.joints, number, &motion.after_kinks(passed, t)),
                false => state.set_body(&self.joints, number, &motion.after_kinks(passed, t)),
            }
        }
        for joint in 0..self.joints.free.start {
            if let Role::Prescribed(point) = self.joints.roles[joint]
                && let Some(motion) = &self.network.points[point].motion
            {
                set(&mut state.joints, joint, motion.after_kinks(passed, t));
            }
        }
        self.follow_prescribed(state);
        self.prescribe_payouts(t, state);
    }

    /// Sets what follows bodies that are prescribed: pins, points and clamps on them.
    pub(super) fn follow_prescribed(&self, state: &mut SystemState) {
        self.carry(state, false);
        for joint in 0..self.joints.free.start {
            if let Role::OnBody(body, at) = self.joints.roles[joint]
                && !self.network.bodies[body].turns()
            {
                let motion = state.body(&self.joints, body);
                set(&mut state.joints, joint, motion.motion_of(&at));
            }
        }
        self.turn_clamps(state, false);
    }

    /// Sets the lengths that are prescribed, after the ends whose heave they may follow.
    fn prescribe_payouts(&self, t: f64, state: &mut SystemState) {
        for (payout, moving) in self.network.payouts.iter().zip(&self.payouts) {
            let (Some(mut now), Some(paid)) = (payout.drive.prescribed(t), payout.ends.first())
            else {
                continue;
            };
            let joints = &mut state.joints;
            if payout.heave != 0.0 {
                let end = state.attached[paid.line][paid.end];
                let rise = joints.x[end].z - moving.height;
                let heave = [rise, joints.v[end].z, joints.a[end].z];
                now = std::array::from_fn(|k| now[k] + payout.heave * heave[k]);
            }
            let [x, v, a] = now.map(|value| V3::new(value, 0.0, 0.0));
            set(joints, moving.joint, (x, v, a));
        }
    }

    /// What a payout is called.
    #[must_use]
    pub fn payout_name(&self, number: usize) -> String {
        let ends = self.network.payouts[number].ends.iter();
        let lines = ends.map(|paid| self.network.lines[paid.line].name.as_str());
        format!("payout of {}", lines.collect::<Vec<_>>().join(" and "))
    }

    /// Sets the origins of bodies that are pinned to others: to those that turn, or to those that do not.
    fn carry(&self, state: &mut SystemState, that_turn: bool) {
        for (number, body) in self.network.bodies.iter().enumerate() {
            if let Some((carrier, at)) = &body.carrier
                && self.network.bodies[*carrier].turns() == that_turn
            {
                let motion = state.body(&self.joints, *carrier);
                let origin = self.joints.bodies[number];
                set(&mut state.joints, origin, motion.motion_of(at));
            }
        }
    }

    /// Sets what follows the unknowns: points, pins and clamps on bodies that turn, and the ends of the lines.
    pub fn follow(&self, state: &mut SystemState) {
        self.carry(state, true);
        for joint in 0..self.joints.free.start {
            if let Role::OnBody(body, at) = self.joints.roles[joint]
                && self.network.bodies[body].turns()
            {
                let motion = state.body(&self.joints, body);
                set(&mut state.joints, joint, motion.motion_of(&at));
            }
        }
        self.turn_clamps(state, true);
        for (line, [a, b]) in state.lines.iter_mut().zip(&state.attached) {
            let last = line.x.len() - 1;
            for (node, joint) in [(0, *a), (last, *b)] {
                line.x[node] = state.joints.x[joint];
                line.v[node] = state.joints.v[joint];
                line.a[node] = state.joints.a[joint];
            }
        }
        self.pay_out(state);
    }

    /// Whether the ends of a line are prescribed and the length of it too, so that it borders on no unknown.
    #[must_use]
    pub fn is_plain(&self, state: &SystemState, line: usize) -> bool {
        let ends = state.attached[line];
        ends.into_iter()
            .all(|joint| self.joints.follows(joint) == super::joints::Follows::Nothing)
            && !self.is_driven(line)
    }

    /// Whether the length of a line is an unknown.
    fn is_driven(&self, line: usize) -> bool {
        let free = self
            .network
            .payouts
            .iter()
            .filter(|payout| payout.drive.is_free());
        free.flat_map(|payout| &payout.ends)
            .any(|paid| paid.line == line)
    }

    /// The free points, with their joints.
    pub(super) fn free_points(&self) -> impl Iterator<Item = (usize, &FreePoint)> {
        self.joints
            .free
            .clone()
            .filter_map(|joint| match self.joints.roles[joint] {
                Role::Free(number) => match &self.network.points[number].held {
                    Held::Free(point) => Some((joint, point)),
                    _ => None,
                },
                _ => None,
            })
    }

    /// What may bear on the bed: free points, and the feet of bodies that turn.
    pub(super) fn bearing(&self) -> impl Iterator<Item = Foot> {
        let points = self.free_points().map(|(joint, point)| Foot {
            joint,
            at: V3::zeros(),
            below: point.below,
            point: *point,
        });
        points.chain(self.feet.iter().flatten().copied())
    }

    /// Anchors of the friction on the bed, one a joint; none where nothing has friction.
    #[must_use]
    pub fn anchors(&self, joints: &State) -> Vec<FrictionAnchor> {
        if self.bearing().all(|foot| foot.point.friction == 0.0) {
            return Vec::new();
        }
        let mut all = vec![anchor(&FreePoint::default(), &V3::zeros()); joints.x.len()];
        for foot in self.bearing() {
            all[foot.joint] = anchor(&foot.point, &foot.place(&joints.x[foot.joint]));
        }
        all
    }

    /// Drags the anchors of what slides on the bed.
    fn drag_anchors(&self, state: &mut SystemState) {
        let State { x, v, memory, .. } = &mut state.joints;
        if memory.grips.is_empty() {
            return;
        }
        for foot in self.bearing() {
            let joint = foot.joint;
            drag_anchor(
                &self.network,
                &foot.point,
                (&foot.place(&x[joint]), &v[joint]),
                &mut memory.grips[joint],
            );
        }
    }

    /// The water around a body, and the bed under it.
    #[must_use]
    pub fn water_around<'a>(&'a self, state: &'a SystemState, body: usize) -> BodyWater<'a> {
        let stations = self.stations[body].clone();
        let flow = self.flows.iter().position(|flow| flow.body == body);
        BodyWater {
            waves: state.body_flow.get(stations).unwrap_or_default(),
            flow: flow.and_then(|number| state.flow_loads.get(number)),
            feet: &self.feet[body],
            holds: self.holds(&state.joints),
        }
    }

    /// Writes the rates of the mean strains of ropes that creep, for a method that integrates these.
    pub(super) fn write_creep_rates(&self, t: f64, state: &mut SystemState) {
        let SystemState { lines, paid, .. } = state;
        for (number, line) in lines.iter_mut().enumerate() {
            self.scene_among(number, paid)
                .line
                .write_creep_rates(t, line);
        }
    }

    /// Updates the history of points and bodies by an accepted state at time t \[s\]; the rotation vectors of the bodies count from here.
    pub(super) fn commit_joints(&self, t: f64, state: &mut SystemState) {
        if self.network.current_over_time.is_some() {
            state.joints.memory.time = t;
        }
        self.drag_anchors(state);
        self.note_landings(&mut state.joints);
        turn_bases(self, state);
        body_flow::commit(self, t, state);
    }

    /// A body in motion.
    #[must_use]
    pub fn body(&self, state: &SystemState, body: usize) -> BodyMotion {
        state.body(&self.joints, body)
    }
}

/// Puts a line into waves, and into the current where the waves have it.
pub(super) fn put_into_water(
    network: &Network,
    water: Option<&Sea>,
    line: &Line,
    scene: &mut Scene,
) {
    let Some(sea) = water.filter(|_| !line.still_water) else {
        return;
    };
    if sea.has_current() {
        scene.line.current = CurrentProfile::Uniform(V3::zeros());
    }
    scene
        .line
        .put_into_waves(sea, (network.density, network.gravity));
}

/// The lines of a network that are paid out, as they are at rest.
fn paid_lines(network: &Network) -> Vec<PaidLine> {
    let mut paid: Vec<PaidLine> = Vec::new();
    for (number, payout) in network.payouts.iter().enumerate() {
        for PaidEnd { line, end, sign } in &payout.ends {
            let known = paid.iter().position(|paid| paid.line == *line);
            let case = network.lines[*line]
                .discretised
                .as_ref()
                .map(|line| line.case());
            let Some(case) = case else {
                continue;
            };
            let known = known.unwrap_or_else(|| {
                paid.push(PaidLine {
                    line: *line,
                    ends: [None, None],
                    case: case.clone(),
                });
                paid.len() - 1
            });
            paid[known].ends[*end] = Some((number, *sign));
        }
    }
    paid
}

/// Writes position, velocity and acceleration of a joint.
fn set(joints: &mut State, joint: usize, (x, v, a): (V3, V3, V3)) {
    (joints.x[joint], joints.v[joint], joints.a[joint]) = (x, v, a);
}

/// Turns the bases of the bodies that turn by their rotation vectors, which start anew.
pub(super) fn turn_bases(system: &MovingSystem, state: &mut SystemState) {
    for (number, body) in system.network.bodies.iter().enumerate() {
        if body.turns() {
            let mut rotation = system.body(state, number).pose.rotation;
            rotation.renormalize();
            state.bases[number] = rotation;
            state.joints.x[system.joints.rotations[number]] = V3::zeros();
        }
    }
}

/// The stations of each body among those of all: its own, those of its members, then the strips of its drag; none in still water.
#[must_use]
pub(super) fn ranges(bodies: &[Body], waves: bool) -> Vec<Range<usize>> {
    let mut next = 0;
    let range = |body: &Body| {
        // Only drag, members and added mass that has a centre feel the water itself.
        let by_itself = body.drag_area != V3::zeros() || body.centre_of_added_mass.is_some();
        let feels = waves && body.turns() && (by_itself || !body.members.is_empty());
        let count = if feels {
            1 + STATIONS * body.members.len() + body.strips_in_waves()
        } else {
            0
        };
        next += count;
        next - count..next
    };
    bodies.iter().map(range).collect()
}
