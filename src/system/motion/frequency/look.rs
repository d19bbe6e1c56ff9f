//! The quick look itself: mean position, excitations, drag and responses in turns, channels.

use std::time::Instant;

use super::channel::{ChannelReader, QuickChannel};
use super::drag::{DragAverager, Spread};
use super::excitation::{Excitation, Reader};
use super::linear_system::{Amplitudes, LinearSystem};
use super::mean::mean_position;
use crate::case::ChannelQuantity;
use crate::numerics::SingularBlock;
use crate::physics::motion::MotionPath;
use crate::system::SolvedSystem;
use crate::system::motion::border::Border;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::start::start;
use crate::system::rest::UnsolvedSystem;

/// Turns of drag and response at most, and the change of velocities at which they end \[-\].
const MOST_TURNS: usize = 40;
const FOUND: f64 = 1e-3;
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
    /// Time to bring it to rest, and for the rest \[s\].
    pub cost_s: [f64; 2],
    /// What the linear look cannot see.
    pub warnings: Vec<String>,
}

/// Looks at a system in its waves.
///
/// # Errors
/// What has no quick look, or does not come to rest.
pub fn quick_look(solved: &SolvedSystem, coarsening: usize) -> Result<QuickLook, UnsolvedSystem> {
    let clock = Instant::now();
    let begun = start(solved, coarsening)?;
    refuse(&begun.system)?;
    let system = &begun.system;
    let mean = mean_position(&begun).map_err(|why| {
        let node = system.node_name(why.node());
        unsolved(
            format!("the mean position is not found: {node} does not come to rest"),
            "run it in time, or with lower waves",
        )
    })?;
    let at_rest = clock.elapsed().as_secs_f64();
    let mut border = Border::new(system, &mean);
    let excitations = Reader::new(system, &mean, &mut border).all();
    let mut linear = LinearSystem::new(&mut border, system, &mean);
    let (responses, turns) = respond(&mut border, &mut linear, &excitations)?;
    let mut reader = ChannelReader::new(system, border.bodies().to_vec(), &mean);
    let amplitudes: Vec<_> = excitations
        .iter()
        .zip(&responses)
        .map(|(excitation, response)| reader.amplitudes(excitation, response))
        .collect();
    let ids = reader.ids().iter().zip(reader.means()).enumerate();
    let channels: Vec<QuickChannel> = ids
        .map(|(number, (id, mean))| {
            let terms: Vec<_> = excitations
                .iter()
                .zip(&amplitudes)
                .map(|(excitation, values)| (excitation.omega, values[number]))
                .collect();
            QuickChannel::new(id.clone(), mean, &terms)
        })
        .collect();
    Ok(QuickLook {
        warnings: warnings(&channels),
        channels,
        omegas: excitations.iter().map(|one| one.omega).collect(),
        turns,
        nodes: mean.lines.iter().map(|line| line.x.len()).sum(),
        cost_s: [at_rest, clock.elapsed().as_secs_f64() - at_rest],
    })
}

/// Drag and responses in turns.
fn respond(
    border: &mut Border,
    linear: &mut LinearSystem<'_>,
    excitations: &[Excitation],
) -> Result<(Vec<Amplitudes>, usize), UnsolvedSystem> {
    let (system, mean) = (linear.system, linear.mean);
    let mut averager = DragAverager::new(system, mean, border);
    let mut spread = Spread::of(system, mean, excitations, &[]);
    let radiation = excitations.iter();
    let radiation: Vec<_> = radiation
        .map(|excitation| linear.radiation(excitation.omega))
        .collect();
    let mut turns = 0;
    loop {
        turns += 1;
        let drag = averager.average(&spread);
        let at_stations = averager.at_stations(&spread, excitations);
        linear.damping = drag.damping.clone();
        let responses = excitations.iter().zip(&radiation).zip(&at_stations);
        let responses: Result<Vec<Amplitudes>, _> = responses
            .map(|((excitation, radiation), bodies)| {
                let mut loads = excitation.loads.clone();
                drag.add_loads(system, mean, excitation, &mut loads);
                linear.add_body_loads(bodies, &mut loads);
                linear.solve(
                    (excitation.omega, radiation),
                    &loads,
                    Some(&excitation.given),
                )
            })
            .collect();
        let responses = responses.map_err(|why| not_held(system, why))?;
        let found = Spread::of(system, mean, excitations, &responses);
        let change = found.change(&spread);
        match turns {
            // At first only the water moved.
            1 => spread = found,
            _ => spread.go_towards(&found, SHARE),
        }
        if change < FOUND || turns == MOST_TURNS {
            return Ok((responses, turns));
        }
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
        .any(|line| line.releases.iter().any(|release| release.is_given()))
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

fn unsolved(problem: String, remedy: &str) -> UnsolvedSystem {
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
fn warnings(channels: &[QuickChannel]) -> Vec<String> {
    let tensions = channels
        .iter()
        .filter(|channel| channel.id.quantity == ChannelQuantity::Tension);
    let slack = tensions
        .filter(|channel| channel.deviation() > 0.0 && channel.mean < SLACK * channel.deviation());
    slack
        .map(|channel| {
            format!(
                "{} goes slack, which no linear look has: its mean of {:.4e} N is less than {SLACK} deviations of {:.4e} N",
                channel.id,
                channel.mean,
                channel.deviation(),
            )
        })
        .collect()
}
