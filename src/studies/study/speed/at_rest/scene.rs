//! What a study at rest solves in several ways: a line by itself, or a system of lines.

use std::sync::atomic::AtomicBool;

use super::answer::{RestAnswer, RestResult};
use crate::background::cpu_time;
use crate::case::{Case, ChannelId, ChannelQuantity, Method};
use crate::numerics::V3;
use crate::run::accuracy::searchable::Searchable;
use crate::run::computation::Computation;
use crate::run::{Profile, RunState};
use crate::scene;
use crate::study::timed::Timed;
use crate::system::at_rest::{SystemAtRest, readings};
use crate::system::network::Line;
use crate::system::solved::LineForms;

/// Stretches of a line of closed form between whose ends its places are compared.
const PLACES: u32 = 32;

/// How a scene at rest is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// By the closed forms of all lines.
    ClosedForm,
    /// By closed forms where these are known, the other lines in segments.
    ClosedWhereKnown,
    /// All lines in segments.
    Segments,
}

impl Way {
    /// Its name.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::ClosedWhereKnown => "closed form where known",
            Self::Segments => "segments",
        }
    }
}

/// A scene that is solved at rest in several ways.
pub trait SceneAtRest: Searchable {
    /// The ways that apply to it.
    fn ways(&self) -> Vec<Way>;

    /// Whether lines have segments in a way.
    fn has_mesh(&self, way: Way) -> bool {
        way != Way::ClosedForm
    }

    /// Ways that do not apply, and why.
    fn left_out(&self) -> Vec<String>;

    /// Whether it has a sea bed.
    fn has_bed(&self) -> bool;

    /// The same with all lines in segments.
    fn divided(&self) -> Self;

    /// Its answer in a way, with these segments of the lines that have any.
    ///
    /// # Errors
    /// Why there is none.
    fn answer(
        &self,
        way: Way,
        segments: &[usize],
        cancel: &AtomicBool,
    ) -> Result<RestAnswer, String>;
}

impl SceneAtRest for Case {
    fn ways(&self) -> Vec<Way> {
        match closed_form(self) {
            Ok(_) => vec![Way::ClosedForm, Way::Segments],
            Err(_) => vec![Way::Segments],
        }
    }

    fn left_out(&self) -> Vec<String> {
        let refused = closed_form(self).err();
        let words = refused.map(|why| format!("{}: {why}", Way::ClosedForm.words()));
        words.into_iter().collect()
    }

    fn has_bed(&self) -> bool {
        self.seabed.is_some()
    }

    fn divided(&self) -> Self {
        let mut case = self.estimating(false);
        case.solver.method = Method::Static;
        case
    }

    fn answer(
        &self,
        way: Way,
        segments: &[usize],
        cancel: &AtomicBool,
    ) -> Result<RestAnswer, String> {
        if way == Way::ClosedForm {
            return closed_form(self);
        }
        let case = self.divided().with_segments(segments)?;
        let run = case.compute(None, cancel, None);
        if run.outcome.state != RunState::Done {
            return Err(run.outcome.failure.unwrap_or_else(|| "stopped".to_owned()));
        }
        let profile = run.record.profiles.first().ok_or("it has no line")?;
        let channels = run.record.history.channels.iter();
        let results = channels.filter_map(|channel| {
            let value = *channel.values.last()?;
            result(&channel.id, value)
        });
        let work = run.outcome.work.iterations;
        let count = profile.nodes.len().saturating_sub(1);
        Ok(RestAnswer {
            results: results.collect(),
            length_m: length_of(profile),
            lines: vec![nodes_of(profile)],
            cpu_s: run.cost.cpu_s,
            steps: work,
            solutions: 1,
            work: work * count as u64,
            segments: count,
        })
    }
}

/// A line by its closed form, on a bed that does not yield.
fn closed_form(case: &Case) -> Result<RestAnswer, String> {
    let begun = cpu_time();
    let scene = scene::build(case, 1).map_err(|error| error.to_string())?;
    let found = scene.closed_form()?;
    let cpu_s = cpu_time() - begun;
    let joints = scene.labels.joints.iter().filter_map(|joint| {
        let id = ChannelQuantity::Tension.at(joint.name.as_str());
        result(&id, *found.tension.get(joint.node)?)
    });
    let arc = &scene.line.arc;
    let length_m = arc.last().copied().unwrap_or_default();
    let nodes = arc.iter().map(|s| s / length_m).zip(found.nodes);
    Ok(RestAnswer {
        results: joints.collect(),
        lines: vec![nodes.collect()],
        length_m,
        cpu_s,
        steps: 0,
        solutions: 1,
        work: 0,
        segments: 0,
    })
}

/// Forces and places are results; a length on the bed is known to half a segment, whatever the forces are.
fn result(id: &ChannelId, value: f64) -> Option<RestResult> {
    let unit = id.quantity.unit();
    let is_result = matches!(unit, "N" | "m") && id.quantity != ChannelQuantity::OnBed;
    is_result.then(|| RestResult {
        name: id.to_string(),
        unit,
        value,
    })
}

fn length_of(profile: &Profile) -> f64 {
    profile.arc.last().copied().unwrap_or_default()
}

fn nodes_of(profile: &Profile) -> Vec<(f64, V3)> {
    let length = length_of(profile);
    let nodes = profile.arc.iter().zip(&profile.nodes);
    nodes
        .map(|(arc, place)| (arc / length, V3::from(*place)))
        .collect()
}

impl SceneAtRest for SystemAtRest {
    fn ways(&self) -> Vec<Way> {
        match (self.segments().len(), self.divided().segments().len()) {
            (0, _) => vec![Way::ClosedForm, Way::Segments],
            (meshed, all) if meshed == all => vec![Way::Segments],
            _ => vec![Way::ClosedWhereKnown, Way::Segments],
        }
    }

    fn left_out(&self) -> Vec<String> {
        let all = self.segments().len() == self.divided().segments().len();
        let why = "closed form: every line lies in a current, bends or has a tension-strain table";
        all.then(|| why.to_owned()).into_iter().collect()
    }

    fn has_bed(&self) -> bool {
        self.file.seabed.is_some()
    }

    fn divided(&self) -> Self {
        self.in_forms(LineForms::Divided)
    }

    fn answer(&self, way: Way, segments: &[usize], _: &AtomicBool) -> Result<RestAnswer, String> {
        let divided = match way {
            Way::ClosedForm => self.clone(),
            _ => self.divided().with_segments(segments)?,
        };
        let scene = match way {
            Way::Segments => divided,
            _ => divided.in_forms(LineForms::ClosedWhereKnown),
        };
        let begun = cpu_time();
        let solved = scene.solve().map_err(|why| why.problem)?;
        let cpu_s = cpu_time() - begun;
        let (network, rest) = (&solved.network, &solved.rest);
        let results = readings(&solved);
        let results = results.iter().filter_map(|(id, value)| result(id, *value));
        let closed: Vec<f64> = (0..=PLACES)
            .map(|k| f64::from(k) / f64::from(PLACES))
            .collect();
        let places = |line: &Line| [line.from, line.to].map(|end| rest.placement.points[end]);
        let lines = network.lines.iter().zip(&rest.balance.lines);
        let lines = lines.map(|(line, at_rest)| {
            let [a, b] = places(line);
            let divided = at_rest.discretised.as_ref();
            let shares = divided.map_or(closed.as_slice(), |line| line.shares());
            let at = |share: &f64| (*share, at_rest.at(*share, [&a, &b]).0);
            shares.iter().map(at).collect()
        });
        let divided = rest.balance.lines.iter();
        let divided = divided.filter_map(|line| line.discretised.as_ref());
        Ok(RestAnswer {
            results: results.collect(),
            lines: lines.collect(),
            length_m: network.lines.iter().map(Line::length).fold(0.0, f64::max),
            cpu_s,
            steps: rest.steps as u64,
            solutions: (rest.evaluations * network.lines.len()) as u64,
            work: rest.work,
            segments: divided.map(|line| line.shares().len() - 1).sum(),
        })
    }
}
