//! The results of a file, at rest or in motion.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::AtomicBool;

use super::results::{Results, Stated, StatedPlace, Which};
use crate::case::{ChannelQuantity, kind};
use crate::numerics::V3;
use crate::system::motion::run::{ChannelResult, MotionRun, run};
use crate::system::network::Held;
use crate::system::quantities::{error, value};
use crate::system::stability::Stability;
use crate::system::{SolvedSystem, SystemFile};

/// Numbers of a record, in the order of its summary.
const NUMBERS: [Which; 4] = ["least", "greatest", "mean", "last"];

/// The results of a file.
///
/// # Errors
/// Why there are none.
pub(super) fn computed(text: &str, moves: bool) -> Result<Results, String> {
    let found = catch_unwind(AssertUnwindSafe(|| {
        let solved = solved(text)?;
        match moves {
            false => Ok(at_rest(&solved)),
            true => in_motion(&solved),
        }
    }));
    found.unwrap_or_else(|_| Err("it panicked".to_owned()))
}

fn solved(text: &str) -> Result<SolvedSystem, String> {
    kind::parse_stored::<SystemFile>(text, "random.toml").map_err(|wrong| {
        let problems = wrong.iter().map(|one| one.problem.clone());
        problems.collect::<Vec<_>>().join("; ")
    })
}

fn at_rest(solved: &SolvedSystem) -> Results {
    const ONLY: Which = "";
    let mut results = Results::default();
    for line in &solved.network.lines {
        for end in ['a', 'b'] {
            let name = format!("tension_n[{}|{end}]", line.name);
            if let Ok(tension) = value(solved, &name) {
                let stated = Stated {
                    value: tension,
                    error: error(solved, &name),
                };
                results
                    .tensions
                    .insert(((line.name.clone(), end), ONLY), stated);
            }
        }
    }
    // Along the way on which it is neutral a system rests anywhere.
    if !matches!(solved.stability, Stability::Stable) {
        return results;
    }
    let placement = &solved.rest.placement;
    for (point, place) in solved.network.points.iter().zip(&placement.points) {
        if matches!(point.held, Held::At(_)) {
            continue;
        }
        let axes = ["x_m", "y_m", "z_m"].map(|axis| format!("{axis}[{}]", point.name));
        let stated = StatedPlace {
            place: *place,
            error: axes.map(|name| error(solved, &name)),
        };
        results.places.insert((point.name.clone(), ONLY), stated);
    }
    results
}

fn in_motion(solved: &SolvedSystem) -> Result<Results, String> {
    // From anywhere along the way on which it is neutral, each motion is another one.
    if !matches!(solved.stability, Stability::Stable) {
        return Err("it has no one place of rest to begin from".to_owned());
    }
    let given = solved.file.in_time().ok_or("no [solver]")?;
    let run = run(solved, given, &AtomicBool::new(false), &mut |_| {});
    let run = run.map_err(|why| why.problem)?;
    match &run.failure {
        Some(why) => Err(why.clone()),
        None => Ok(of_run(&run)),
    }
}

fn of_run(run: &MotionRun) -> Results {
    let mut results = Results::default();
    let mut last: Vec<(String, V3, [Option<f64>; 3])> = Vec::new();
    for channel in &run.channels {
        let place = &channel.id.place;
        if channel.id.quantity == ChannelQuantity::Tension {
            let Some((line, end)) = place.rsplit_once('|') else {
                continue;
            };
            let Some(end) = end.chars().next().filter(|end| matches!(end, 'a' | 'b')) else {
                continue;
            };
            for (k, which) in NUMBERS.into_iter().enumerate() {
                let key = ((line.to_owned(), end), which);
                results.tensions.insert(key, stated(channel, k));
            }
            continue;
        }
        let axis = ChannelQuantity::POSITION
            .iter()
            .position(|quantity| *quantity == channel.id.quantity);
        let Some(axis) = axis else { continue };
        if axis == 2 {
            for (k, which) in NUMBERS.into_iter().enumerate() {
                results
                    .heights
                    .insert((place.clone(), which), stated(channel, k));
            }
        }
        if last.last().is_none_or(|(name, ..)| name != place) {
            last.push((place.clone(), V3::zeros(), [None; 3]));
        }
        if let Some((_, at, errors)) = last.last_mut() {
            let here = stated(channel, 3);
            at[axis] = here.value;
            errors[axis] = here.error;
        }
    }
    for (name, place, error) in last {
        results
            .places
            .insert((name, "last"), StatedPlace { place, error });
    }
    results
}

/// A number of a channel with its errors by steps and mesh.
fn stated(channel: &ChannelResult, number: usize) -> Stated {
    let errors = channel.time_error.zip(channel.mesh_error);
    Stated {
        value: channel.summary.numbers()[number],
        error: errors.map(|(time, mesh)| time[number].abs() + mesh[number].abs()),
    }
}
