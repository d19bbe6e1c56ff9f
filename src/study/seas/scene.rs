//! What checks need to know of a scene besides its runs: strengths, diameters, depth, what is broken, whether its sea is random.

use std::collections::BTreeMap;

use crate::case::{
    Case, ChannelLocation, ChannelQuantity, CheckCondition, Method, Section, WaveKind, Waves,
    channels,
};
use crate::system::model::NO_LINE;
use crate::system::network::Held;
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
            let sections = [line.break_loads.first(), line.break_loads.last()];
            let stem = line.name.split('@').next().unwrap_or(&line.name);
            for (end, strength) in ["a", "b"].into_iter().zip(sections) {
                let place = format!("{}|{end}", line.name);
                tensions.push(place.clone());
                if let Some(load) = strength.copied().flatten() {
                    strengths.insert(place.clone(), load);
                }
                if let Some(diameter) = diameter(&solved.file, stem, end == "b") {
                    diameters.insert(place, diameter);
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
            depth: bed
                .filter(|bed| bed.depth_file.is_none())
                .map(|bed| bed.depth_m),
            anchors: fixed.map(|point| point.name.clone()).collect(),
            is_random: solved.file.waves.iter().any(is_random),
            is_dynamic: solved.file.solver.is_some(),
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

/// The diameter of a line at one of its ends, by the name that its copies share.
fn diameter(file: &SystemFile, line: &str, at_b: bool) -> Option<f64> {
    let line = file.lines.iter().find(|known| known.name == line)?;
    let section = if at_b {
        line.sections.last()
    } else {
        line.sections.first()
    };
    let material = section
        .map(|section| &section.material)
        .or(line.material.as_ref())?;
    file.materials
        .get(material)
        .map(|material| material.diameter_m)
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
