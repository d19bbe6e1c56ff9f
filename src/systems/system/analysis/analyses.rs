//! All that is shown of a system beside its forces: other equilibria, periods, clearances, and the offset curves, watch circles
//! and goals that its file asks for. Searches that only want a result do without it.

use rayon::prelude::*;
use toml_edit::DocumentMut;

use super::super::equilibrium::SystemEquilibrium;
use super::super::model::{GoalInputs, SystemFile};
use super::super::network::Network;
use super::super::solved::SolvedSystem;
use super::super::stability::{Stability, stability};
use super::clearance::{LineDistances, distances};
use super::equilibria;
use super::offset::{HeldAway, OffsetPoint, curve};
use super::periods::{NaturalModes, periods};
use super::seek::{Sought, seek};
use super::watch_circle::{WatchCircle, watch_circle};
use crate::case::schema::{TableType, WrittenKeys};

/// The analyses of a system.
#[derive(Debug, Clone)]
pub struct Analyses {
    /// Equilibria that searches from other poses of the free bodies find, and how they rest.
    pub others: Vec<(SystemEquilibrium, Stability)>,
    /// Natural modes, or why there are none.
    pub periods: Result<NaturalModes, String>,
    /// Distances of each line from others, from bodies, bed and surface.
    pub clearances: Vec<LineDistances>,
    /// Offset curves.
    pub offsets: Vec<OffsetCurve>,
    /// Watch circles, with the numbers of their bodies.
    pub circles: Vec<(usize, WatchCircle)>,
    /// Goals, each with the input that meets it, or why none does.
    pub goals: Vec<(GoalInputs, Result<Sought, String>)>,
}

/// A body held away from where it rests, step by step.
#[derive(Debug, Clone, PartialEq)]
pub struct OffsetCurve {
    /// The body.
    pub body: usize,
    /// Direction of the offset \[deg\], from +x towards +y.
    pub heading_deg: f64,
    /// The offsets that have an equilibrium, from none.
    pub points: Vec<OffsetPoint>,
    /// Offset at which there was none \[m\].
    pub ends_before_m: Option<f64>,
}

impl Analyses {
    /// Works them out.
    #[must_use]
    pub fn of_system(solved: &SolvedSystem) -> Self {
        let (file, network, rest) = (&solved.file, &solved.network, &solved.rest);
        Self {
            periods: periods(network, rest),
            clearances: distances(network, rest),
            offsets: offset_curves(file, network, rest),
            circles: watch_circles(file, network, rest),
            ..Self::of_object(solved)
        }
    }

    /// Other equilibria and goals alone, which a system as an object of JSON has.
    #[must_use]
    pub fn of_object(solved: &SolvedSystem) -> Self {
        let (file, network, rest) = (&solved.file, &solved.network, &solved.rest);
        // What is neutral and on no line rests wherever it is put.
        let drifts = network.lines.is_empty() && matches!(solved.stability, Stability::Neutral(_));
        let others = match drifts {
            true => equilibria::left(rest),
            false => equilibria::others(network, rest),
        };
        let others = others.into_iter();
        let others = others.map(|other| {
            let how = stability(network, &other);
            (other, how)
        });
        Self {
            others: others.collect(),
            periods: Ok(NaturalModes::default()),
            clearances: Vec::new(),
            offsets: Vec::new(),
            circles: Vec::new(),
            goals: goals(file),
        }
    }
}

/// The body of an analysis: the one named, or the only one.
fn body(network: &Network, name: Option<&String>) -> Option<usize> {
    match name {
        Some(name) => network.body(name),
        None => (!network.bodies.is_empty()).then_some(0),
    }
}

fn offset_curves(
    file: &SystemFile,
    network: &Network,
    rest: &SystemEquilibrium,
) -> Vec<OffsetCurve> {
    let asked = file.offset_curves.iter().filter_map(|asked| {
        let body = body(network, asked.body.as_ref())?;
        let mut held = HeldAway::new(network, rest, body);
        let steps = u32::try_from(asked.steps).unwrap_or(u32::MAX);
        let points = curve(&mut held, asked.heading_deg.to_radians(), asked.to_m, steps);
        let next = asked.to_m * points.len() as f64 / asked.steps as f64;
        Some(OffsetCurve {
            body,
            heading_deg: asked.heading_deg,
            ends_before_m: (points.len() <= asked.steps).then_some(next),
            points,
        })
    });
    asked.collect()
}

fn watch_circles(
    file: &SystemFile,
    network: &Network,
    rest: &SystemEquilibrium,
) -> Vec<(usize, WatchCircle)> {
    let asked = file.watch_circles.iter().filter_map(|asked| {
        let body = body(network, asked.body.as_ref())?;
        let each = std::f64::consts::TAU / asked.headings as f64;
        let headings = (0..asked.headings).map(|k| each * k as f64).collect();
        let circle = watch_circle(network, rest, body, asked.load_n, headings);
        Some((body, circle))
    });
    asked.collect()
}

/// The goals, sought in the file.
fn goals(file: &SystemFile) -> Vec<(GoalInputs, Result<Sought, String>)> {
    if file.goals.is_empty() {
        return Vec::new();
    }
    let text = DocumentMut::from(file.write(WrittenKeys::WithoutDefaults)).to_string();
    let found = |goal: &GoalInputs| {
        let [low, high] = goal.between;
        let sought = seek(&text, &goal.vary, (low, high), &goal.result, goal.value);
        (goal.clone(), sought)
    };
    file.goals.par_iter().map(found).collect()
}
