//! How far a steady load moves a body in every direction, with all lines and with each of them lost in turn.
//!
//! The body keeps its height and its angles; its place in plan is where the lines hold the load. Newton's method on two unknowns, with the
//! stiffness of the lines on the body condensed from that of the system, halved where it overshoots.

use nalgebra::{Matrix2, Vector2};
use rayon::prelude::*;

use super::super::connected::loose;
use super::super::equilibrium::SystemEquilibrium;
use super::super::network::Network;
use super::offset::{HeldAway, OffsetPoint};

/// The watch circle of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct WatchCircle {
    /// The load \[N\].
    pub load_n: f64,
    /// Headings of the load \[rad\], from +x towards +y.
    pub headings: Vec<f64>,
    /// With all lines: the body at each heading, or why not.
    pub intact: Vec<Result<OffsetPoint, String>>,
    /// With a line lost: which line, and the body at each heading.
    pub damaged: Vec<(usize, Vec<Result<OffsetPoint, String>>)>,
}

impl OffsetPoint {
    /// Distance in plan from where the body rests with all lines \[m\].
    #[must_use]
    pub fn distance_m(&self) -> f64 {
        self.offset_m[0].hypot(self.offset_m[1])
    }
}

/// The watch circle of a body under a load \[N\] along each heading \[rad\], on all cores.
#[must_use]
pub fn watch_circle(
    network: &Network,
    rest: &SystemEquilibrium,
    body: usize,
    load_n: f64,
    headings: Vec<f64>,
) -> WatchCircle {
    let held = HeldAway::new(network, rest, body);
    let round = |held: &HeldAway| -> Vec<Result<OffsetPoint, String>> {
        let mut held = held.clone();
        let mut from = [0.0; 2];
        let mut found = Vec::with_capacity(headings.len());
        for heading in &headings {
            let point = under(&mut held, load_n, *heading, from);
            // The next heading begins where this one ends.
            from = point.as_ref().map_or([0.0; 2], |point| point.offset_m);
            found.push(point);
        }
        found
    };
    let intact = round(&held);
    let damaged = (0..network.lines.len()).into_par_iter().map(|line| {
        let lost = held.without(line);
        let found = match loose(lost.network()) {
            None => round(&lost),
            Some(_) => {
                let why = "nothing holds a part of the system without this line".to_owned();
                vec![Err(why); headings.len()]
            }
        };
        let found = found
            .into_iter()
            .map(|point| point.map(|point| renumbered(point, line)));
        (line, found.collect())
    });
    let damaged = damaged.collect();
    WatchCircle {
        load_n,
        intact,
        damaged,
        headings,
    }
}

/// Lines counted as in the system that has them all.
fn renumbered(mut point: OffsetPoint, lost: usize) -> OffsetPoint {
    let number = |line: &mut usize| *line += usize::from(*line >= lost);
    number(&mut point.greatest.0);
    if let Some((line, _)) = &mut point.weakest {
        number(line);
    }
    if let Some((line, _)) = &mut point.uplift {
        number(line);
    }
    point.tensions.insert(lost, [0.0; 2]);
    point
}

/// Steps that the search for a place may take.
const MOST_STEPS: usize = 60;

/// The body where its lines hold a load \[N\] along a heading \[rad\], searched from an offset \[m\].
///
/// # Errors
/// Why there is no such place, in words.
pub fn under(
    held: &mut HeldAway,
    load_n: f64,
    heading: f64,
    from: [f64; 2],
) -> Result<OffsetPoint, String> {
    let load = Vector2::new(heading.cos(), heading.sin()) * load_n;
    let unsolved = |_| "the lines have no equilibrium on the way".to_owned();
    let mut place = Vector2::from(from);
    let mut here = held.at(from).map_err(unsolved)?;
    let size = load_n.abs().max(here.greatest.1);
    for _ in 0..MOST_STEPS {
        let force = load + here.force_n.xy();
        if force.norm() <= 1e-10 * size {
            return Ok(here);
        }
        let step = descent(&held.stiffness(), &force, 0.2 * held.reach());
        let mut share = 1.0;
        loop {
            let next = place + step * share;
            let found = held.at(next.into());
            match found {
                // As far as the force still points along the step, or not much against it.
                Ok(point) if (load + point.force_n.xy()).dot(&step) >= -0.5 * force.dot(&step) => {
                    (place, here) = (next, point);
                    break;
                }
                Ok(_) | Err(_) if share > 1e-9 => share *= 0.5,
                _ => return Err("the lines do not hold this load".to_owned()),
            }
        }
    }
    let force = load + here.force_n.xy();
    if force.norm() <= 1e-8 * size {
        return Ok(here);
    }
    Err("the lines do not hold this load".to_owned())
}

/// Newton's step where the stiffness holds, else along the force; no longer than a bound \[m\].
fn descent(stiffness: &Matrix2<f64>, force: &Vector2<f64>, most: f64) -> Vector2<f64> {
    let symmetric = 0.5 * (stiffness + stiffness.transpose());
    let holds = symmetric[(0, 0)] > 0.0 && symmetric.determinant() > 0.0;
    let newton = stiffness
        .try_inverse()
        .filter(|_| holds)
        .map(|inverse| inverse * force);
    let step = newton
        .filter(|step| step.dot(force) > 0.0)
        .unwrap_or_else(|| force.normalize() * most);
    let length = step.norm();
    if length > most {
        step * (most / length)
    } else {
        step
    }
}
