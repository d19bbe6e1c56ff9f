//! What bounds the steps of a system in time.

use std::f64::consts::TAU;

use nalgebra::{Matrix6, SMatrix};

use super::body_equation::MovingBody;
use super::line_start;
use super::mesh_of_ends::SHORTEST;
use super::moving_system::MovingSystem;
use crate::numerics::V3;
use crate::physics::EndMotion;
use crate::physics::motion::MotionPath;
use crate::physics::sea::Harmonics;
use crate::run::line_bounds::bounce_period;
use crate::run::settings::{STEPS_A_PERIOD, SceneBounds, motion_scale};
use crate::scene::{EndCondition, Scene};
use crate::solve::StaticSearch;
use crate::system::network::{Body, Held, Line, Network, ReleaseCondition};
use crate::system::pose::cross;

/// What bounds the steps of a system.
pub(super) fn bounds(system: &MovingSystem) -> SceneBounds {
    let own = |scene: &Scene| scene.position_tolerance(1e-4);
    SceneBounds {
        longest_step: longest_step(system),
        forced_period: forced_period(system),
        stability: stability_limit(system),
        explicit_limit: explicit_limit(system),
        position_tolerance: system.scenes.iter().map(own).fold(f64::INFINITY, f64::min),
        nodes: system.scenes.iter().map(Scene::line_nodes).sum(),
    }
}

/// The surface over the origin, where there are waves.
fn surface(system: &MovingSystem) -> Option<EndMotion> {
    let sea = system.network.sea.as_ref()?;
    let heave = sea.at_point(&V3::zeros());
    Some(EndMotion {
        position: V3::zeros(),
        course: MotionPath::Sum(Harmonics::along_axes(&[Vec::new(), Vec::new(), heave])),
        ramp: 0.0,
    })
}

/// Stability limit of RK4 on the imaginary axis, by the frequency.
const RK4_LIMIT: f64 = 2.785;
/// The stability limit of explicit steps \[s\], and what sets it: a segment of a line, or what lands on the bed by itself.
fn stability_limit(system: &MovingSystem) -> Option<(f64, String)> {
    let of_lines = limit_of_lines(system);
    let limits = of_lines
        .map(|(limit, at)| (with_clamps(system, limit), at))
        .into_iter()
        .chain(system.landing_limits());
    limits.min_by(|one, other| one.0.total_cmp(&other.0))
}

/// A stability limit \[s\] of lines with that of their clamps on bodies that turn: the squares of the frequencies add up at most.
fn with_clamps(system: &MovingSystem, limit: f64) -> f64 {
    let square = system.frequency_squared_of_clamps();
    match square > 0.0 {
        true => (limit.powi(-2) + square / RK4_LIMIT.powi(2)).powf(-0.5),
        false => limit,
    }
}

/// The stability limit that lines set \[s\], and the segment that does. The greatest frequency of a system is at most that of its
/// segments each by itself, with its own share of the masses at its ends (Fried, J. Sound Vib. 22 (1972) 407): half of that of a node
/// within a line.
fn limit_of_lines(system: &MovingSystem) -> Option<(f64, String)> {
    let lines = system.network.lines.iter().zip(&system.scenes).enumerate();
    let limits = lines.map(|(number, (line, scene))| {
        let ends = [0, 1].map(|end| match scene.line.ends[end] {
            EndCondition::Prescribed(_) => f64::INFINITY,
            EndCondition::Free => {
                let own = scene.line.mass[end * scene.line.segments.len()];
                2.0 * (own + share_of_mass(system, number, end))
            }
        });
        let (limit, segment) = scene.explicit_limit_between(ends);
        (limit, segment, line)
    });
    let (limit, segment, line) = limits.min_by(|one, other| one.0.total_cmp(&other.0))?;
    Some((limit, format!("segment {segment} of line {}", line.name)))
}

/// The share that an end of a line has of the mass of the point or body that it is at \[kg\]; none of an end that may be let go.
fn share_of_mass(system: &MovingSystem, line: usize, end: usize) -> f64 {
    let network = &system.network;
    let point_of = |line: &Line, end: usize| [line.from, line.to][end];
    let owner = |point: usize| match network.points[point].held {
        Held::On(body, _) => (Some(body), 0),
        Held::At(_) | Held::Free(_) => (None, point),
    };
    let at = point_of(&network.lines[line], end);
    if network.lines[line].releases[end].is_given() {
        return 0.0;
    }
    let ends = network.lines.iter().flat_map(|line| [line.from, line.to]);
    let count = ends.filter(|point| owner(*point) == owner(at)).count() as f64;
    let mass = match &network.points[at].held {
        // Above the surface it has its own mass alone.
        Held::Free(free) if network.crossed && !free.always_wet => free.mass(0.0).min(),
        Held::Free(free) => free.moving_mass.min(),
        Held::On(body, place) => mass_at(network, *body, place),
        Held::At(_) => 0.0,
    };
    mass / count
}

/// The least mass that a body has at a place of it, as a force in any direction there finds it \[kg\].
fn mass_at(network: &Network, number: usize, place: &V3) -> f64 {
    let body = &network.bodies[number];
    let mass = MovingBody::new(network, number, &body.pose).mass;
    let mobility = match body.pinned {
        true => {
            let turning = mass.fixed_view::<3, 3>(3, 3).try_inverse();
            turning.map(|turning| {
                let mut all = Matrix6::zeros();
                all.fixed_view_mut::<3, 3>(3, 3).copy_from(&turning);
                all
            })
        }
        false => mass.try_inverse(),
    };
    let Some(mobility) = mobility else { return 0.0 };
    let mut by = SMatrix::<f64, 3, 6>::zeros();
    by.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
    by.fixed_view_mut::<3, 3>(0, 3).copy_from(&-cross(place));
    // The sum of its eigenvalues is at least the greatest.
    1.0 / (by * mobility * by.transpose()).trace()
}

/// The longest stable step of the lines by themselves, which what is at their ends makes longer, and of what lands on the bed \[s\].
fn explicit_limit(system: &MovingSystem) -> f64 {
    let lines = system.scenes.iter().map(|scene| scene.explicit_limit().0);
    let landing = system.landing_limits().map(|(limit, _)| limit);
    let limit = lines.chain(landing).fold(f64::INFINITY, f64::min);
    let limit = with_clamps(system, limit);
    match system.paid.is_empty() {
        true => limit,
        // The segment at an end becomes shorter than those of the mesh.
        false => SHORTEST * limit.min(explicit_limit_of_drives(system)),
    }
}

/// The same of winches, and of points that slide: as oscillators on the segments beside them, and by the slope of drive and friction.
fn explicit_limit_of_drives(system: &MovingSystem) -> f64 {
    let mut limit = f64::INFINITY;
    for payout in &system.network.payouts {
        let segments = payout.ends.iter().map(|paid| {
            let segments = &system.scenes[paid.line].line.segments;
            &segments[paid.end * (segments.len() - 1)]
        });
        let (mass, stiffness) = segments.fold((0.0, 0.0), |(mass, stiffness), segment| {
            (
                mass + segment.half_mass,
                stiffness + segment.axial.stiffness(),
            )
        });
        if let Some((own, slope)) = payout.drive.mass_and_slope() {
            let mass = mass + own;
            limit = limit.min((mass / stiffness).sqrt()).min(mass / slope);
        }
    }
    limit
}

/// The shortest period that the system forces \[s\]: of prescribed motion, or of its longest line bouncing along itself.
fn forced_period(system: &MovingSystem) -> f64 {
    let prescribed = system.motions().filter_map(EndMotion::period);
    prescribed.fold(own_period(system), f64::min)
}

/// Period of the longest line bouncing along itself \[s\]; where there are none, that of the smallest body as a pendulum.
fn own_period(system: &MovingSystem) -> f64 {
    let bounce = system.scenes.iter().map(bounce_period);
    match system.scenes.is_empty() {
        true => swing_period(&system.network),
        false => bounce.fold(0.0, f64::max).max(f64::MIN_POSITIVE),
    }
}

/// The longest step that sees what is prescribed; error control shortens it where it must.
fn longest_step(system: &MovingSystem) -> f64 {
    let own = own_period(system);
    let surface = surface(system);
    let prescribed = system.motions().chain(&surface);
    let prescribed = prescribed.filter_map(|motion| motion.longest_step(STEPS_A_PERIOD));
    prescribed.fold(own / STEPS_A_PERIOD, f64::min)
}

/// Period of a pendulum as long as the smallest body, where there are no lines \[s\].
fn swing_period(network: &Network) -> f64 {
    let sizes = network.bodies.iter().map(Body::size);
    let smallest = sizes
        .filter(|size| *size > 0.0)
        .fold(f64::INFINITY, f64::min);
    let length = if smallest.is_finite() { smallest } else { 1.0 };
    TAU * (length / network.gravity.max(1.0)).sqrt()
}

/// Distance and speed of the waves by the spectral moments of their surface: of a regular wave its height, twice the amplitude.
fn wave_scale(system: &MovingSystem) -> Option<(f64, f64)> {
    let height = surface(system)?;
    let MotionPath::Sum(harmonics) = &height.course else {
        return None;
    };
    let moments = harmonics.moments();
    Some(((8.0 * moments.m0).sqrt(), (8.0 * moments.m2).sqrt()))
}

/// Distance \[m\] and speed \[m/s\] that the errors of a step are measured by: of the longest line and its fall by its own length or, where
/// nothing but prescribed motion, waves and a start off the equilibrium disturb a system at rest, of these. It is the
/// same for every duration, so that a run resumed up to a later end takes the steps of one that is as long.
pub(super) fn scale_of_motion(system: &MovingSystem) -> (f64, f64) {
    let network = &system.network;
    let lengths = network.lines.iter().map(Line::length);
    let length = lengths.fold(1.0, f64::max);
    let speed = (network.gravity * length).sqrt();
    let has_release = |line: &Line| line.releases.iter().any(ReleaseCondition::is_given);
    if line_start::is_off_rest(network) || network.lines.iter().any(has_release) {
        return (length, speed);
    }
    let scale = |motion: &EndMotion, arm: f64| {
        let (far, fast) = motion.scale();
        (far * arm, fast * arm)
    };
    let points = network
        .points
        .iter()
        .filter_map(|point| point.motion.as_ref());
    let turns = network.bodies.iter().zip(&system.arms);
    let turns = turns.filter_map(|(body, arm)| Some((body.motion.as_ref()?, *arm)));
    let moved = points
        .map(|motion| scale(motion, 1.0))
        .chain(wave_scale(system));
    let turned =
        turns.flat_map(|(motion, arm)| [scale(&motion.place, 1.0), scale(&motion.angles, arm)]);
    let bodies = network.initial_of_bodies();
    let bodies = bodies.map(|(number, initial)| initial.scale(system.arms[number]));
    let points = network.free_points().map(|point| point.initial.scale());
    // A velocity goes as far as in the time of that fall, an offset as fast as it falls by itself.
    let off_rest = bodies.chain(points).map(|(far, fast)| {
        let fall = (network.gravity * far).sqrt();
        (
            far + fast * length / speed.max(f64::MIN_POSITIVE),
            fast + fall,
        )
    });
    let moved = moved
        .chain(turned)
        .chain(off_rest)
        .fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    motion_scale((length, speed), moved)
}
