//! What checks need to know of a scene besides its runs: strengths, diameters, depth, what is broken, whether its sea is random.

use std::collections::BTreeMap;

use crate::case::{
    Case, ChannelLocation, ChannelQuantity, CheckCondition, Method, Section, WaveKind, Waves,
    channels, nearest,
};
use crate::checks::resolved::Check;
use crate::system::model::NO_LINE;
use crate::system::network::{Held, Line};
use crate::system::section_materials::diameter;
use crate::system::{SolvedSystem, SystemFile};

/// What checks need to know of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CheckedScene {
    /// Breaking load \[N\] at the places of tensions, where it is stated.
    pub strengths: BTreeMap<String, f64>,
    /// Diameter of the line \[m\] at the same places.
    pub diameters: BTreeMap<String, f64>,
    /// The places of tensions of a system.
    pub tensions: Vec<String>,
    /// The bodies of a system.
    pub bodies: Vec<String>,
    /// The lines by name; empty that of a line by itself.
    pub lines: Vec<String>,
    /// Names of lines, points, bodies and ends that a check may hold.
    pub subjects: Vec<String>,
    /// Depth of a level sea bed \[m\].
    pub depth: Option<f64>,
    /// Points and ends that are fixed.
    pub anchors: Vec<String>,
    /// Whether waves are drawn at random.
    pub is_random: bool,
    /// Whether lines are in motion.
    pub is_dynamic: bool,
    /// What is broken in the file itself.
    pub condition: CheckCondition,
}

impl CheckedScene {
    /// Whether a name is that of a line, or of its copies NAME@ANGLE.
    #[must_use]
    pub fn is_line(&self, name: &str) -> bool {
        let mut lines = self.lines.iter();
        lines.any(|line| line == name || line.split('@').next() == Some(name))
    }

    /// A name that a check holds and the scene has not, with the nearest that it has.
    #[must_use]
    pub fn unknown(&self, check: &Check) -> Option<(String, Option<String>)> {
        let stems = self
            .subjects
            .iter()
            .map(|name| super::subject::subject(name));
        let known: Vec<&str> = stems.collect();
        let is_known = |name: &&String| {
            let is =
                |known: &&str| *known == name.as_str() || known.split('@').next() == Some(name);
            known.iter().any(is) || self.subjects.contains(name)
        };
        let name = check
            .inputs
            .of
            .iter()
            .flatten()
            .find(|name| !is_known(name))?;
        let near = nearest(name, known.iter().copied());
        Some((name.clone(), near.map(str::to_owned)))
    }

    /// Of a line.
    #[must_use]
    pub fn of_case(case: &Case) -> Self {
        let (mut strengths, mut diameters) = (BTreeMap::new(), BTreeMap::new());
        for channel in channels(case) {
            let (ChannelQuantity::Tension, ChannelLocation::Joint(joint)) =
                (channel.id.quantity, channel.site)
            else {
                continue;
            };
            let beside = beside(case, joint);
            let materials = beside.filter_map(|section| case.materials.get(&section.material));
            for material in materials {
                let place = channel.id.place.clone();
                if let Some(load) = material.break_load_n {
                    let known = strengths.entry(place.clone()).or_insert(load);
                    *known = f64::min(*known, load);
                }
                let known = diameters.entry(place).or_insert(material.diameter_m);
                *known = f64::min(*known, material.diameter_m);
            }
        }
        let ends = [&case.ends.a, &case.ends.b];
        Self {
            strengths,
            diameters,
            tensions: Vec::new(),
            bodies: Vec::new(),
            lines: vec![String::new()],
            subjects: channels(case)
                .into_iter()
                .map(|spec| spec.id.place)
                .collect(),
            depth: level_depth(case),
            anchors: ends.map(|end| end.name.clone()).to_vec(),
            is_random: case.waves.as_ref().is_some_and(is_random),
            is_dynamic: !matches!(case.solver.method, Method::Static | Method::Quasi),
            condition: CheckCondition::Intact,
        }
    }

    /// Of a system of lines.
    #[must_use]
    pub fn of_system(solved: &SolvedSystem) -> Self {
        let (mut strengths, mut diameters) = (BTreeMap::new(), BTreeMap::new());
        let mut tensions = Vec::new();
        for line in &solved.network.lines {
            let stem = line.name.split('@').next().unwrap_or(&line.name);
            for (place, beside) in places(line) {
                let place = format!("{}|{place}", line.name);
                tensions.push(place.clone());
                // Where sections meet both must bear it.
                let loads = beside.clone().map(|section| line.parts[section].break_load);
                let stated: Option<Vec<f64>> = loads.collect();
                if let Some(load) = stated.and_then(|loads| loads.into_iter().reduce(f64::min)) {
                    strengths.insert(place.clone(), load);
                }
                let widths = beside.filter_map(|section| diameter(&solved.file, stem, section));
                if let Some(width) = widths.reduce(f64::min) {
                    diameters.insert(place, width);
                }
            }
        }
        let fixed = solved.network.points.iter();
        let fixed = fixed.filter(|point| matches!(point.held, Held::At(_)));
        let bed = solved.file.seabed.as_ref();
        Self {
            strengths,
            diameters,
            tensions,
            bodies: solved.file.bodies.keys().cloned().collect(),
            lines: lines(solved),
            subjects: subjects(solved),
            depth: bed
                .filter(|bed| bed.depth_file.is_none())
                .map(|bed| bed.depth_m),
            anchors: fixed.map(|point| point.name.clone()).collect(),
            is_random: solved.file.waves.iter().any(is_random),
            is_dynamic: solved.file.in_time().is_some(),
            condition: condition(&solved.file),
        }
    }
}

/// The sections on both sides of a joint.
fn beside(case: &Case, joint: usize) -> impl Iterator<Item = &Section> {
    let before = joint.checked_sub(1).and_then(|index| case.line.get(index));
    before.into_iter().chain(case.line.get(joint))
}

fn level_depth(case: &Case) -> Option<f64> {
    let bed = case.seabed.as_ref()?;
    let level = bed.slope_deg == 0.0 && bed.depths().0.is_none();
    level.then_some(bed.depth_m)
}

fn is_random(waves: &Waves) -> bool {
    waves.kind == WaveKind::Irregular
}

/// The places of a line at which its tension is known, and the sections beside each.
fn places(line: &Line) -> Vec<(String, std::ops::Range<usize>)> {
    let sections = line.parts.len();
    let last = sections.saturating_sub(1);
    let mut places = vec![("a".to_owned(), 0..sections.min(1))];
    let meetings = line.meetings().enumerate();
    places.extend(meetings.map(|(before, place)| (place, before..before + 2)));
    places.push(("b".to_owned(), last..sections));
    places
}

/// Names of the lines, points and bodies of a system.
fn subjects(solved: &SolvedSystem) -> Vec<String> {
    let network = &solved.network;
    let points = network.points.iter().map(|point| point.name.clone());
    let bodies = network.bodies.iter().map(|body| body.name.clone());
    lines(solved)
        .into_iter()
        .chain(points)
        .chain(bodies)
        .collect()
}

fn lines(solved: &SolvedSystem) -> Vec<String> {
    let lines = solved.network.lines.iter();
    lines.map(|line| line.name.clone()).collect()
}

/// What is broken in a system as its file stands.
fn condition(file: &SystemFile) -> CheckCondition {
    let breaks =
        |line: &crate::system::model::LineInputs| line.break_s.is_some() || line.break_n.is_some();
    match () {
        () if file.damage.lost_line != NO_LINE => CheckCondition::LineLost,
        () if file.lines.iter().any(breaks) => CheckCondition::Transient,
        () => CheckCondition::Intact,
    }
}
