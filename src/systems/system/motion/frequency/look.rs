//! The quick look itself: mean position, excitations, drag and responses in turns, channels.

use nalgebra::Matrix6;

use super::Complex;
use super::channel::{ChannelReader, QuickChannel};
use super::drag::DragAverager;
use super::excitation::{Excitation, ExcitationReader};
use super::linear_system::{Amplitudes, LinearSystem};
use super::mean::mean_position;
use super::single_line;
use super::spread::Spread;
use crate::case::{Case, ChannelQuantity};
use crate::numerics::SingularBlock;
use crate::physics::motion::MotionPath;
use crate::scene;
use crate::solve::PartedSystem;
use crate::system::SolvedSystem;
use crate::system::loads_without_effect::loads_without_effect;
use crate::system::motion::border::Border;
use crate::system::motion::channels::Channels;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::start::{Start, start};
use crate::system::network::ReleaseCondition;
use crate::system::rest::UnsolvedSystem;

/// Turns of drag and response at most, and the change of velocities at which they end \[-\].
const MOST_TURNS: usize = 40;
const FOUND: f64 = 1e-3;
/// With more excitations than these the first turns take one of a few, which stands for its neighbours, until the velocities change by less.
const MANY: usize = 40;
const STRIDE: usize = 4;
const ROUGH: f64 = 1e-2;
/// Share of the way to the velocities just found that each turn goes: at a resonance held by drag alone the whole way overshoots by half.
const SHARE: f64 = 0.75;
/// Deviations below the mean at which a tension that is not positive is said to go slack.
const SLACK: f64 = 3.0;

/// What a quick look finds.
#[derive(Debug, Clone, PartialEq)]
pub struct QuickLook {
    /// The channels, as a run in time records them.
    pub channels: Vec<QuickChannel>,
    /// Frequencies of the excitations \[rad/s\].
    pub omegas: Vec<f64>,
    /// Turns of drag and response.
    pub turns: usize,
    /// Nodes of the lines.
    pub nodes: usize,
    /// What the linear look cannot see.
    pub warnings: Vec<String>,
}

/// Looks at a system in its waves.
///
/// # Errors
/// What has no quick look, or does not come to rest.
pub fn quick_look(solved: &SolvedSystem, coarsening: usize) -> Result<QuickLook, UnsolvedSystem> {
    let begun = start(solved, coarsening as f64)?;
    let mut found = look(&begun, Channels::of_system(&begun.system))?;
    found.warnings.extend(loads_without_effect(solved));
    Ok(found)
}

/// Looks at a line between two ends in its waves.
///
/// # Errors
/// What has no quick look, or does not come to rest.
pub fn quick_look_at_line(case: &Case, coarsening: usize) -> Result<QuickLook, UnsolvedSystem> {
    let begun = single_line::of_case(case, coarsening)?;
    let mut found = look(&begun, Channels::of_single_line(&begun.system))?;
    found.warnings.extend(scene::loads_without_effect(case));
    Ok(found)
}

fn look(begun: &Start, channels: Channels) -> Result<QuickLook, UnsolvedSystem> {
    refuse(&begun.system)?;
    let system = &begun.system;
    let mean = mean_position(begun).map_err(|why| {
        let node = system.node_name(why.node());
        unsolved(
            format!("the mean position is not found: {node} does not come to rest"),
            "run it in time, or with lower waves",
        )
    })?;
    let mut border = Border::new(system, &mean);
    let excitations = ExcitationReader::new(system, &mean, &mut border).all();
    let mut linear = LinearSystem::new(&mut border, system, &mean);
    let (responses, turns, missed) = respond(&mut border, &mut linear, &excitations)?;
    let mut reader = ChannelReader::new(channels, system, border.bodies().to_vec(), &mean);
    let amplitudes: Vec<_> = excitations
        .iter()
        .zip(&responses)
        .map(|(excitation, response)| reader.amplitudes(excitation, response))
        .collect();
    let values = [&begun.state, &mean].map(|state| reader.values_in(state));
    let values: Vec<(f64, f64)> = std::iter::zip(&values[0], &values[1])
        .map(|(start, mean)| (*start, *mean))
        .collect();
    let ids = reader.ids().iter().zip(values).enumerate();
    let channels: Vec<QuickChannel> = ids
        .map(|(number, (id, values))| {
            let terms: Vec<_> = excitations
                .iter()
                .zip(&amplitudes)
                .map(|(excitation, values)| (excitation.omega, values[number]))
                .collect();
            QuickChannel::new(id.clone(), values, &terms)
        })
        .collect();
    Ok(QuickLook {
        warnings: warnings(&channels, missed),
        channels,
        omegas: excitations.iter().map(|one| one.omega).collect(),
        turns,
        nodes: mean.lines.iter().map(|line| line.x.len()).sum(),
    })
}

/// What drag and responses are found with.
struct Turns<'a, 'b> {
    averager: DragAverager<'a>,
    linear: &'a mut LinearSystem<'b>,
    excitations: &'a [Excitation],
    radiation: Vec<Vec<Matrix6<Complex>>>,
    spread: Spread,
    made: usize,
    /// The change of velocities in the turn made last \[-\].
    changed: f64,
}

/// Drag and responses in turns: first with a part of the excitations, then with all. The responses, the turns, and by how much the
/// velocities still change after the most of them.
fn respond(
    border: &mut Border,
    linear: &mut LinearSystem<'_>,
    excitations: &[Excitation],
) -> Result<(Vec<Amplitudes>, usize, Option<f64>), UnsolvedSystem> {
    let (system, mean) = (linear.system, linear.mean);
    let radiation = excitations.iter();
    let radiation = radiation.map(|excitation| linear.radiation(excitation.omega));
    let mut turns = Turns {
        averager: DragAverager::new(system, mean, border, excitations.len()),
        radiation: radiation.collect(),
        spread: Spread::of_excitations(
            system,
            mean,
            excitations.iter().map(|one| (one, None)),
            1.0,
        ),
        linear,
        excitations,
        made: 0,
        changed: 0.0,
    };
    if excitations.len() > MANY {
        turns.until(ROUGH, STRIDE)?;
    }
    let responses = turns.until(FOUND, 1)?;
    let missed = (turns.changed > FOUND).then_some(turns.changed);
    Ok((responses, turns.made, missed))
}

impl Turns<'_, '_> {
    /// Turns until the velocities change by less, each with the excitations of a stride; their responses.
    fn until(&mut self, change: f64, stride: usize) -> Result<Vec<Amplitudes>, UnsolvedSystem> {
        let (system, mean) = (self.linear.system, self.linear.mean);
        let mut left = MOST_TURNS;
        loop {
            left -= 1;
            let responses = self.turn(stride)?;
            let moved = responses.iter().map(Some);
            let taken = self.excitations.iter().skip(stride / 2).step_by(stride);
            let found = Spread::of_excitations(system, mean, taken.zip(moved), stride as f64);
            self.changed = found.change(&self.spread);
            match self.made {
                // At first only the water moved.
                1 => self.spread = found,
                _ => self.spread.go_towards(&found, SHARE),
            }
            if self.changed < change || left == 0 {
                return Ok(responses);
            }
        }
    }

    /// The responses with the drag of the velocities known.
    fn turn(&mut self, stride: usize) -> Result<Vec<Amplitudes>, UnsolvedSystem> {
        self.made += 1;
        let (system, mean) = (self.linear.system, self.linear.mean);
        let drag = self.averager.average(&self.spread);
        let taken = self.excitations.iter().skip(stride / 2).step_by(stride);
        let taken: Vec<&Excitation> = taken.collect();
        let at_stations = self.averager.at_stations(&self.spread, &taken);
        self.linear.damping = drag.damping.clone();
        let radiation = self.radiation.iter().skip(stride / 2).step_by(stride);
        let all = taken.iter().zip(radiation).zip(&at_stations);
        let responses = all.map(|((excitation, radiation), bodies)| {
            let mut loads = excitation.loads.clone();
            drag.add_loads(system, mean, excitation, &mut loads);
            self.linear.add_body_loads(bodies, &mut loads);
            let at = (excitation.omega, radiation.as_slice());
            self.linear.solve(at, &loads, Some(&excitation.given))
        });
        let responses: Result<Vec<Amplitudes>, _> = responses.collect();
        responses.map_err(|why| not_held(system, why))
    }
}

/// What has no quick look.
fn refuse(system: &MovingSystem) -> Result<(), UnsolvedSystem> {
    let network = &system.network;
    let points = network.points.iter();
    let points = points.filter_map(|point| Some((&point.name, point.motion.as_ref()?)));
    let bodies = network.bodies.iter().filter(|body| !body.free);
    let bodies = bodies.filter_map(|body| Some((&body.name, body.motion.as_ref()?)));
    let bodies = bodies.flat_map(|(name, motion)| [(name, &motion.place), (name, &motion.angles)]);
    let mut tables = points.chain(bodies).filter(|(_, motion)| {
        matches!(
            motion.course,
            MotionPath::Table(_) | MotionPath::Piecewise(_)
        )
    });
    let what = if let Some((name, _)) = tables.next() {
        format!("{name} is moved by a table")
    } else if !network.payouts.is_empty() {
        "a line is paid out".to_owned()
    } else if network.current_over_time.is_some() {
        "the current changes with time".to_owned()
    } else if network
        .lines
        .iter()
        .any(|line| line.releases.iter().any(ReleaseCondition::is_given))
    {
        "a line breaks or is let go".to_owned()
    } else {
        return Ok(());
    };
    Err(unsolved(
        format!("a quick look in the frequency domain takes steady waves alone, but {what}"),
        "run it in time",
    ))
}

pub(super) fn unsolved(problem: String, remedy: &str) -> UnsolvedSystem {
    UnsolvedSystem {
        problem,
        remedy: remedy.to_owned(),
        line: None,
        part: None,
    }
}

fn not_held(system: &MovingSystem, (part, singular): (usize, SingularBlock)) -> UnsolvedSystem {
    let node = system.node_name(system.offset(part.min(system.scenes.len())) + singular.node);
    unsolved(
        format!("the linear equations of motion have no solution: nothing holds {node}"),
        "run it in time",
    )
}

/// What a linear look cannot see in what it found.
fn warnings(channels: &[QuickChannel], missed: Option<f64>) -> Vec<String> {
    let tensions = channels
        .iter()
        .filter(|channel| channel.id.quantity == ChannelQuantity::Tension);
    let slack = tensions
        .filter(|channel| channel.deviation() > 0.0 && channel.mean < SLACK * channel.deviation());
    let slack = slack.map(|channel| {
            format!(
                "{} goes slack, which no linear look has: its mean of {:.4e} N is less than {SLACK} deviations of {:.4e} N",
                channel.id,
                channel.mean,
                channel.deviation(),
            )
        });
    let missed = missed.map(|by| {
        format!("drag and motion were not found together: after {MOST_TURNS} turns velocities still change by {:.1} %", 100.0 * by)
    });
    slack.chain(missed).collect()
}
