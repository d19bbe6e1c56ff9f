//! What is recorded of a system in motion.

use super::bed_reach::may_reach;
use super::body_equation::MovingBody;
use super::broken_names;
use super::channel_values::ChannelValues;
use super::foot::Foot;
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::point_loads::bears;
use super::system_state::SystemState;
use crate::case::{ChannelId, ChannelQuantity, DynamicStiffness, FrictionLaw, Material};
use crate::system::SolvedSystem;
use crate::system::network::{Body, Held, Line, Network, ReleaseCondition};
use crate::system::parts::parts as parts_of;

/// Place of the channel of the height of the waves.
pub(in crate::system) const GAUGE: &str = "gauge";

/// Place of the channel of the energy.
pub const WHOLE: &str = "system";

/// What a channel reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Source {
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
    /// A component of the force of the lines on a joint.
    Force(usize, usize),
    /// Speed of a joint.
    Speed(usize),
    /// A coordinate of the end A or B of a line, wherever that is.
    EndPlace((usize, usize), usize),
    /// Speed of the end A or B of a line.
    EndSpeed(usize, usize),
    /// Force of the bed on what bears at a joint.
    BedForce(usize),
    /// Greatest speed at which what bears on the bed has landed, by its number among that.
    Landing(usize),
    /// A quantity of a body on a line, by its number among those of the line.
    OnLine(usize, usize, ChannelQuantity),
    /// A quantity of dynamic stiffness at the first or last node of a section of a line, by its number.
    Rope(usize, (usize, bool), ChannelQuantity),
    /// Curvature or bending moment of a line at its end A or B.
    Bending(usize, bool, ChannelQuantity),
    /// Tension of the wall of a pipe there.
    Wall(usize, (usize, bool)),
    /// Length of a line on the bed; of one that may break in both of its parts.
    OnBed(usize, Option<usize>),
    /// Length of a line that slides over it, by the same numbers.
    Sliding(usize, Option<usize>),
    /// Height of the waves over the gauge.
    Elevation,
    /// Unstretched length of a line that is paid out, by its number among those.
    Length(usize),
    /// Energy of all of it.
    Energy,
}

/// The channels of a system and where they are read.
#[derive(Debug, Clone)]
pub struct Channels {
    /// Their names.
    pub ids: Vec<ChannelId>,
    sources: Vec<Source>,
}

impl Channels {
    /// Tensions at both ends of every line, places of the points that move and speeds of those that are free, places and speeds of the ends that
    /// are let go, poses of the bodies that move,
    /// force of the bed on what bears on it and the speed at which that landed, length on the bed of the lines that may reach it, height of the
    /// waves, energy where the file asks for it, curvature and bending moment at clamped ends, dynamic stiffness of ropes and tension of the wall of pipes at both ends of their
    /// sections.
    #[must_use]
    pub fn of_system(system: &MovingSystem) -> Self {
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
        channels.points(system);
        channels.released_ends(system);
        channels.bodies(system);
        if system.network.records_uplift {
            channels.uplift(system);
        }
        if system.network.records_forces {
            channels.forces(system);
        }
        channels.bearing(system);
        for line in 0..system.network.lines.len() {
            channels.bodies_on(system, line);
        }
        channels.on_bed(system);
        if system.network.sea.is_some() {
            let id = ChannelQuantity::WaveElevation.at(GAUGE);
            channels.add(id, Source::Elevation);
        }
        for (number, paid) in system.paid.iter().enumerate() {
            let name = system.network.lines[paid.line].name.as_str();
            channels.add(ChannelQuantity::Length.at(name), Source::Length(number));
        }
        if system.network.records_energy {
            channels.add(ChannelQuantity::Energy.at(WHOLE), Source::Energy);
        }
        for line in 0..system.network.lines.len() {
            channels.bending(system, line);
            channels.sections(system, line);
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
            let id = ChannelQuantity::WaveElevation.at(GAUGE);
            channels.add(id, Source::Elevation);
        }
        channels
    }

    /// Places of the points that move, and speeds of those that are free.
    fn points(&mut self, system: &MovingSystem) {
        for (point, &joint) in system.network.points.iter().zip(&system.joints.points) {
            let moves = match system.joints.roles[joint] {
                Role::Prescribed(_) => point.motion.is_some(),
                Role::OnBody(body, _) => moves(system, body),
                _ => !broken_names::is_between(&point.name),
            };
            if moves {
                self.place(&point.name, joint);
            }
            if moves && matches!(point.held, Held::Free(_)) {
                let id = ChannelQuantity::Speed.at(point.name.as_str());
                self.add(id, Source::Speed(joint));
            }
        }
    }

    /// Places and speeds of the ends of lines that are let go, by the names of the ends: of what they are at, and then of themselves.
    fn released_ends(&mut self, system: &MovingSystem) {
        for (line, given) in system.network.lines.iter().enumerate() {
            for (end, word) in ["a", "b"].into_iter().enumerate() {
                let name = broken_names::name_of_end(system, line, end);
                let Some(name) = name.filter(|_| given.releases[end].is_given()) else {
                    continue;
                };
                let name = format!("{name}|{word}");
                for (axis, quantity) in ChannelQuantity::POSITION.into_iter().enumerate() {
                    self.add(
                        quantity.at(name.as_str()),
                        Source::EndPlace((line, end), axis),
                    );
                }
                self.add(ChannelQuantity::Speed.at(name), Source::EndSpeed(line, end));
            }
        }
    }

    /// Poses of the bodies that move, and forces of pins.
    fn bodies(&mut self, system: &MovingSystem) {
        for (number, body) in system.network.bodies.iter().enumerate() {
            if moves(system, number) {
                self.place(&body.name, system.joints.bodies[number]);
                for (axis, quantity) in ChannelQuantity::ANGLES.into_iter().enumerate() {
                    self.add(quantity.at(body.name.as_str()), Source::Angle(number, axis));
                }
            }
            if body.pinned {
                for (axis, quantity) in ChannelQuantity::PIN_FORCE.into_iter().enumerate() {
                    self.add(quantity.at(body.name.as_str()), Source::Pin(number, axis));
                }
            }
        }
    }

    /// What bears on the bed: the force of the bed, and how fast it landed.
    fn bearing(&mut self, system: &MovingSystem) {
        for (number, Foot { joint, .. }) in system.landing().enumerate() {
            let name = system.name_of_bearing(joint);
            self.add(ChannelQuantity::BedForce.at(name), Source::BedForce(joint));
            let landing = ChannelQuantity::LandingSpeed.at(name);
            self.add(landing, Source::Landing(number));
        }
    }

    /// Places of the bodies with names on a line, and where there is a bed its force on them and the speed at which they landed; not of lines that
    /// may break.
    fn bodies_on(&mut self, system: &MovingSystem, line: usize) {
        let given = &system.network.lines[line];
        if may_break(&system.network, given) {
            return;
        }
        let of_bed = [ChannelQuantity::BedForce, ChannelQuantity::LandingSpeed];
        let has_bed = system.network.bed.is_some() && given.bed_contact;
        for (number, body) in given.bodies.iter().enumerate() {
            let Some(name) = &body.name else { continue };
            let place = format!("{}|{name}", given.name);
            let of_bed = of_bed.into_iter().filter(|_| has_bed);
            for quantity in ChannelQuantity::POSITION.into_iter().chain(of_bed) {
                let id = quantity.at(place.as_str());
                self.add(id, Source::OnLine(line, number, quantity));
            }
        }
    }

    fn place(&mut self, name: &str, joint: usize) {
        for (axis, quantity) in ChannelQuantity::POSITION.into_iter().enumerate() {
            self.add(quantity.at(name), Source::Place(joint, axis));
        }
    }

    /// Tensions where the sections of a line meet, by their names or number from end A; not of lines that may break, whose parts change.
    fn between(&mut self, system: &MovingSystem, line: usize) {
        let given = &system.network.lines[line];
        if may_break(&system.network, given) {
            return;
        }
        for (before, meeting) in given.meetings().enumerate() {
            let id = ChannelQuantity::Tension.at(format!("{}|{meeting}", given.name));
            self.add(id, Source::Between(line, before + 1));
        }
    }

    /// Curvature and bending moment of a line at its clamped ends.
    fn bending(&mut self, system: &MovingSystem, line: usize) {
        for (end, word) in ["a", "b"].into_iter().enumerate() {
            let name = broken_names::name_of_end(system, line, end);
            let is_clamped = is_clamped(&system.network.lines[line], end);
            let Some(name) = name.filter(|_| is_clamped) else {
                continue;
            };
            for quantity in ChannelQuantity::BENDING {
                let id = quantity.at(format!("{name}|{word}"));
                self.add(id, Source::Bending(line, end == 1, quantity));
            }
        }
    }

    /// Dynamic stiffness of ropes and tension of the wall of pipes at both ends of the sections of a line, by their names or number from end A; not of
    /// lines that may break.
    fn sections(&mut self, system: &MovingSystem, line: usize) {
        let given = &system.network.lines[line];
        if may_break(&system.network, given) {
            return;
        }
        let materials: Vec<&Material> = materials(given).collect();
        for (section, [first, last]) in given.named_sections() {
            let Some(material) = materials.get(first) else {
                continue;
            };
            let ends = [("a", (first, false)), ("b", (last, true))];
            let name = |end: &str| format!("{}|{section}.{end}", given.name);
            if is_dynamic(material) {
                for quantity in ChannelQuantity::ROPE {
                    for (end, place) in ends {
                        self.add(quantity.at(name(end)), Source::Rope(line, place, quantity));
                    }
                }
            }
            if material.bore.is_some() {
                for (end, place) in ends {
                    let id = ChannelQuantity::WallTension.at(name(end));
                    self.add(id, Source::Wall(line, place));
                }
            }
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

    fn forces(&mut self, system: &MovingSystem) {
        for (point, &joint) in system.network.points.iter().zip(&system.joints.points) {
            if matches!(point.held, Held::At(_)) && !broken_names::is_between(&point.name) {
                for (axis, quantity) in ChannelQuantity::FORCE.into_iter().enumerate() {
                    self.add(quantity.at(point.name.as_str()), Source::Force(joint, axis));
                }
            }
        }
    }

    fn on_bed(&mut self, system: &MovingSystem) {
        let lines = 0..system.network.lines.len();
        for number in lines.clone() {
            let Some(name) = broken_names::name_of_end(system, number, 0) else {
                continue;
            };
            let is_second = |other: &usize| {
                let end = broken_names::name_of_end(system, *other, 1);
                *other != number && end.as_ref() == Some(&name)
            };
            let breaks = broken_names::name_of_end(system, number, 1).is_none();
            let second = lines.clone().find(|other| breaks && is_second(other));
            let mut parts = second.into_iter().chain([number]);
            if parts.any(|part| may_reach(&system.network, part)) {
                let id = ChannelQuantity::OnBed.at(name.as_str());
                self.add(id, Source::OnBed(number, second));
                let mut parts = second.into_iter().chain([number]);
                if parts.any(|part| system.scenes[part].has_grips()) {
                    let id = ChannelQuantity::Sliding.at(name);
                    self.add(id, Source::Sliding(number, second));
                }
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
        system: (&MovingSystem, &[MovingBody]),
        at: (f64, &SystemState),
        tensions: Option<&[f64]>,
        values: &mut [f64],
    ) {
        let mut reading = ChannelValues::new(system, at, tensions);
        for (value, source) in values.iter_mut().zip(&self.sources) {
            *value = reading.read(*source);
        }
    }
}

fn moves(system: &MovingSystem, body: usize) -> bool {
    is_moving(&system.network.bodies[body])
}

fn is_moving(body: &Body) -> bool {
    body.turns() || body.motion.is_some()
}

/// Whether a line is part of one that may break.
fn may_break(network: &Network, line: &Line) -> bool {
    let ends = [line.from, line.to].into_iter();
    ends.map(|end| &network.points[end].name)
        .any(|name| broken_names::is_between(name))
}

/// The materials of the sections of a divided line.
fn materials(line: &Line) -> impl Iterator<Item = &Material> {
    let cases = line.discretised.iter().map(|line| line.case());
    cases.flat_map(|case| {
        let sections = case.line.iter();
        sections.filter_map(|section| case.materials.get(&section.material))
    })
}

/// Whether a divided line bends at its end A or B, where its direction is held.
fn is_clamped(line: &Line, end: usize) -> bool {
    let Some(case) = line.discretised.as_ref().map(|line| line.case()) else {
        return false;
    };
    let clamps = [&case.ends.a, &case.ends.b].map(|end| end.clamp_elevation_deg.is_some());
    let mut materials = materials(line);
    let material = if end == 0 {
        materials.next()
    } else {
        materials.last()
    };
    clamps[end] && material.is_some_and(|material| material.ei_n_m2 > 0.0)
}

fn is_dynamic(material: &Material) -> bool {
    material.dynamic_stiffness != DynamicStiffness::None
}

/// The quantities that runs of a system record.
#[must_use]
pub fn quantities(solved: &SolvedSystem) -> Vec<ChannelQuantity> {
    let network = &solved.network;
    let mut all = vec![ChannelQuantity::Tension];
    all.extend(of_what_moves(network));
    let on_lines = of_bodies_on_lines(network).filter(|one| !all.contains(one));
    let on_lines: Vec<ChannelQuantity> = on_lines.collect();
    all.extend(on_lines);
    if network.bodies.iter().any(|body| body.pinned) {
        all.extend(ChannelQuantity::PIN_FORCE);
    }
    all.extend(along_bed(solved));
    let waves = network.sea.is_some();
    all.extend(waves.then_some(ChannelQuantity::WaveElevation));
    all.extend((!network.payouts.is_empty()).then_some(ChannelQuantity::Length));
    all.extend(network.records_energy.then_some(ChannelQuantity::Energy));
    let mut lines = network.lines.iter();
    if lines.any(|line| [0, 1].iter().any(|end| is_clamped(line, *end))) {
        all.extend(ChannelQuantity::BENDING);
    }
    let parts = solved.file.lines.iter();
    let parts: Vec<_> = parts
        .flat_map(|line| parts_of(&solved.file, line))
        .collect();
    if parts.iter().any(|part| is_dynamic(&part.material)) {
        all.extend(ChannelQuantity::ROPE);
    }
    let is_pipe = parts.iter().any(|part| part.material.bore.is_some());
    all.extend(is_pipe.then_some(ChannelQuantity::WallTension));
    all
}

/// Those of points and bodies that move.
fn of_what_moves(network: &Network) -> Vec<ChannelQuantity> {
    let mut all = Vec::new();
    let bodies_move = network.bodies.iter().any(is_moving);
    let mut points = network.points.iter();
    let points_move =
        points.any(|point| point.motion.is_some() || matches!(point.held, Held::Free(_)));
    let mut lines = network.lines.iter();
    let is_let_go = lines.any(|line| line.releases.iter().any(ReleaseCondition::is_given));
    if bodies_move || points_move || is_let_go {
        all.extend(ChannelQuantity::POSITION);
    }
    if bodies_move {
        all.extend(ChannelQuantity::ANGLES);
    }
    let free = network.free_points().count() > 0;
    all.extend((free || is_let_go).then_some(ChannelQuantity::Speed));
    let feet = network
        .bodies
        .iter()
        .any(|body| body.free && body.bottom.is_some() || !body.feet.is_empty());
    if network.bed.is_some() && (feet || network.free_points().any(bears)) {
        all.push(ChannelQuantity::BedForce);
    }
    all
}

/// Those of bodies with names that are attached to lines.
fn of_bodies_on_lines(network: &Network) -> impl Iterator<Item = ChannelQuantity> {
    let mut bodies = network.lines.iter().flat_map(|line| &line.bodies);
    let is_named = bodies.any(|body| body.name.is_some());
    let of_bed = network.bed.is_some().then_some(ChannelQuantity::BedForce);
    let all = ChannelQuantity::POSITION.into_iter().chain(of_bed);
    all.filter(move |_| is_named)
}

/// Those of lines that may lie and slide on the bed.
fn along_bed(solved: &SolvedSystem) -> impl Iterator<Item = ChannelQuantity> {
    let network = &solved.network;
    let reaches = (0..network.lines.len()).any(|line| may_reach(network, line));
    let bed = solved.file.seabed.as_ref();
    let by_grip = bed.is_some_and(|bed| bed.friction_law == FrictionLaw::Grip);
    let mut lines = network.lines.iter().enumerate();
    let slides = lines.any(|(number, line)| line.is_rough() && may_reach(network, number));
    let lies = reaches.then_some(ChannelQuantity::OnBed);
    let slides = (by_grip && slides).then_some(ChannelQuantity::Sliding);
    lies.into_iter().chain(slides)
}
