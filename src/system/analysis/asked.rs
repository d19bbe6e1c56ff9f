//! The analyses that a system file asks for: offset curves, watch circles and goals, worked out with the system.

use rayon::prelude::*;
use toml_edit::DocumentMut;

use super::super::equilibrium::Equilibrium;
use super::super::model::{GoalInputs, SystemFile};
use super::super::network::Network;
use super::offset::{HeldAway, OffsetPoint, curve};
use super::seek::{Sought, seek};
use super::watch_circle::{WatchCircle, watch_circle};
use crate::case::schema::{TableType, WrittenKeys};

/// What a file asks for beside the equilibrium.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Analyses {
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

/// Works out what a file asks for.
#[must_use]
pub fn analyses(file: &SystemFile, network: &Network, rest: &Equilibrium) -> Analyses {
    let body = |name: &Option<String>| match name {
        Some(name) => network.body(name),
        None => (!network.bodies.is_empty()).then_some(0),
    };
    let offsets = file.offset_curves.iter().filter_map(|asked| {
        let body = body(&asked.body)?;
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
    let circles = file.watch_circles.iter().filter_map(|asked| {
        let body = body(&asked.body)?;
        let each = std::f64::consts::TAU / asked.headings as f64;
        let headings = (0..asked.headings).map(|k| each * k as f64).collect();
        Some((
            body,
            watch_circle(network, rest, body, asked.load_n, headings),
        ))
    });
    Analyses {
        offsets: offsets.collect(),
        circles: circles.collect(),
        goals: goals(file),
    }
}

/// The goals, sought in the file without its own analyses.
fn goals(file: &SystemFile) -> Vec<(GoalInputs, Result<Sought, String>)> {
    if file.goals.is_empty() {
        return Vec::new();
    }
    let bare = SystemFile {
        offset_curves: Vec::new(),
        watch_circles: Vec::new(),
        goals: Vec::new(),
        published: Vec::new(),
        ..file.clone()
    };
    let text = DocumentMut::from(bare.write(WrittenKeys::WithoutDefaults)).to_string();
    let found = |goal: &GoalInputs| {
        let [low, high] = goal.between;
        let sought = seek(&text, &goal.vary, (low, high), &goal.result, goal.value);
        (goal.clone(), sought)
    };
    file.goals.par_iter().map(found).collect()
}
