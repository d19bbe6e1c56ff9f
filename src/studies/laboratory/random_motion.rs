//! Random systems in motion: whether each runs to its end or is refused with time, node and reason, and whether its energy balances.
//!
//! Kinds: webs of free points with ends that move; moorings of a body that moves; of a body that floats, pushed by a line; clumps
//! lowered to the bed; ends that are let go; lines that break; lines between a body that moves and one that floats; slack lines that snap;
//! lines that are paid out at a rate, against heave, by winches, also on a body; loads that slide along lines.
//! They are drawn as text, as a user writes them.

mod paid_out;

use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use self::paid_out::RandomDrive;
use crate::case::{ChannelQuantity, kind};
use crate::numerics::random::Random;
use crate::system::motion::payout::Payout;
use crate::system::motion::payout_inputs;
use crate::system::motion::run::{MotionRun, run};
use crate::system::{SolvedSystem, SystemFile};

/// The kinds of random systems, in turn.
pub const KINDS: [&str; 14] = [
    "web with moved ends",
    "moved body",
    "floating body",
    "lowered clump",
    "end let go",
    "line that breaks",
    "line between bodies",
    "slack lines that snap",
    "line paid out",
    "heave compensated",
    "winch that keeps a tension",
    "winch that gives way",
    "load that slides along a line",
    "winches on a body",
];

/// Kinds that were there first: each draws what it drew before the others came.
const FIRST_KINDS: usize = 8;

/// Simulated time of each \[s\].
const DURATION_S: f64 = 8.0;
/// Share of the energy that may be missing; beyond it the run must warn.
pub const DRIFT: f64 = 0.02;
/// Share of the length of lines that rounding may lose.
const LENGTH_ERROR: f64 = 1e-9;

/// What came of a random system.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomMotion {
    /// Number of its kind.
    pub kind: usize,
    /// The system, as a file.
    pub text: String,
    /// What its run came to.
    pub end: MotionEnd,
    /// Wall time.
    pub time: Duration,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionEnd {
    /// At its time.
    Ran {
        /// Share of the energy that is not accounted for.
        drift: f64,
        /// Steps.
        steps: u64,
        /// Whether the run warns that its energy does not balance.
        warned: bool,
    },
    /// A number of its history is not finite, and nothing was said.
    NotFinite,
    /// Its lines are longer at the end than they were and than what was paid out, by this share of their length.
    WrongLength(f64),
    /// Earlier, and why: with the time and the node.
    Early(String),
    /// It did not begin: there is no equilibrium, or the file is wrong.
    Refused(String),
    /// It panicked.
    Panicked,
}

impl MotionEnd {
    /// Whether it is what a user may expect: a balance within its bound or a warning, or a reason.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        match self {
            Self::Ran { drift, warned, .. } => *drift <= DRIFT || *warned,
            Self::Early(why) => why.starts_with("at t = "),
            Self::Refused(why) => !why.is_empty(),
            Self::NotFinite | Self::WrongLength(_) | Self::Panicked => false,
        }
    }
}

/// Computes so many random systems of a seed, on all cores.
#[must_use]
pub fn run_all(count: usize, seed: u64) -> Vec<RandomMotion> {
    let one = |index: usize| {
        let kind = index % KINDS.len();
        let text = text(kind, &mut Random::new(seed, stream(index)));
        let begun = Instant::now();
        let end = catch_unwind(AssertUnwindSafe(|| compute(&text)));
        RandomMotion {
            kind,
            end: end.unwrap_or(MotionEnd::Panicked),
            time: begun.elapsed(),
            text,
        }
    };
    (0..count).into_par_iter().map(one).collect()
}

/// Stream of the random numbers of a system.
fn stream(index: usize) -> u64 {
    let (round, kind) = (index / KINDS.len(), index % KINDS.len());
    match kind < FIRST_KINDS {
        true => (round * FIRST_KINDS + kind) as u64,
        false => u64::MAX - index as u64,
    }
}

fn compute(text: &str) -> MotionEnd {
    let solved: SolvedSystem = match kind::parse::<SystemFile>(text, "random.toml") {
        Ok(solved) => solved,
        Err(wrong) => {
            let problems = wrong.iter().map(|one| one.problem.clone());
            return MotionEnd::Refused(problems.collect::<Vec<_>>().join("; "));
        }
    };
    let Some(given) = solved.file.in_time() else {
        return MotionEnd::Refused("no [solver]".to_owned());
    };
    match run(&solved, given, &AtomicBool::new(false), &mut |_| {}) {
        Err(why) => MotionEnd::Refused(why.problem),
        Ok(run) => ended(&solved, &run),
    }
}

fn ended(solved: &SolvedSystem, run: &MotionRun) -> MotionEnd {
    if let Some(why) = &run.failure {
        return MotionEnd::Early(why.clone());
    }
    let mut values = run
        .history
        .channels
        .iter()
        .flat_map(|channel| &channel.values);
    let drift = run.balance.relative_drift();
    if !drift.is_finite() || values.any(|value| !value.is_finite()) {
        return MotionEnd::NotFinite;
    }
    let wrong = wrong_length(solved, run);
    if wrong > LENGTH_ERROR {
        return MotionEnd::WrongLength(wrong);
    }
    MotionEnd::Ran {
        drift,
        steps: run.work.steps,
        warned: run
            .warnings
            .iter()
            .any(|warning| warning.contains("energy")),
    }
}

/// By how much the lines are longer at the end of a run than at its start and than what was paid out, as a share; 0 where a winch decides.
fn wrong_length(solved: &SolvedSystem, run: &MotionRun) -> f64 {
    let lengths = run.channels.iter().zip(&run.history.channels);
    let lengths = lengths.filter(|(channel, _)| channel.id.quantity == ChannelQuantity::Length);
    let (mut change, mut whole) = (0.0, 0.0);
    for (channel, history) in lengths {
        let first = history.values.first().copied().unwrap_or_default();
        change += channel.summary.last - first;
        whole += first;
    }
    let prescribed = |payout: &Payout| match payout.drive.is_free() {
        // What one line loses the other gains.
        _ if payout.ends.len() > 1 => Some(0.0),
        _ if payout.heave != 0.0 => None,
        _ => payout.drive.prescribed(run.reached).map(|out| out[0]),
    };
    let payouts = payout_inputs::payouts(&solved.file, &solved.network);
    let out: Option<f64> = payouts.iter().map(prescribed).sum();
    out.map_or(0.0, |out| (change - out).abs() / f64::max(whole, 1.0))
}

/// A random system of a kind, as a file.
#[must_use]
pub fn text(kind: usize, random: &mut Random) -> String {
    let mut maker = MovingSystemWriter {
        random,
        text: String::new(),
        depth: 0.0,
        lines: 0,
        wet_weights: Vec::new(),
    };
    maker.head(kind);
    match kind {
        0 => maker.web(),
        1 => maker.body("moved"),
        2 => maker.body("free"),
        3 => maker.lowered(),
        4 => maker.hung("release"),
        5 => maker.hung("break"),
        6 => maker.shared(),
        7 => maker.slack(),
        8 => maker.paid_out(RandomDrive::Rate),
        9 => maker.paid_out(RandomDrive::Heave),
        10 => maker.paid_out(RandomDrive::Tension),
        11 => maker.paid_out(RandomDrive::GivesWay),
        12 => maker.bead(),
        _ => maker.winches_on_body(),
    }
    maker.text
}

struct MovingSystemWriter<'a> {
    random: &'a mut Random,
    text: String,
    depth: f64,
    lines: usize,
    /// Weights of the materials in water \[N/m\].
    wet_weights: Vec<f64>,
}

impl MovingSystemWriter<'_> {
    fn put(&mut self, words: std::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.text.write_fmt(words);
    }

    /// Water, bed, three materials, settings.
    fn head(&mut self, kind: usize) {
        self.depth = self.random.between(40.0, 400.0);
        self.put(format_args!("[system]\ntitle = \"random\"\n[solver]\nduration_s = {DURATION_S:?}\nerror_estimate = false\n"));
        if kind == 3 || self.random.uniform() < 0.6 {
            let (depth, damping) = (self.depth, self.random.power(3.0, 5.0));
            self.put(format_args!(
                "[seabed]\ndepth_m = {depth:?}\ndamping_n_s_per_m3 = {damping:?}\n"
            ));
        }
        if self.random.uniform() < 0.3 {
            let (speed, towards) = (
                self.random.between(0.1, 1.5),
                self.random.between(0.0, 360.0),
            );
            self.put(format_args!(
                "[current]\nspeed_m_per_s = {speed:?}\ndirection_deg = {towards:?}\n"
            ));
        }
        for name in ["one", "two", "three"] {
            let diameter = self.random.power(-2.0, -0.6);
            // From a floating rope to chain.
            let mass = 805.0 * diameter * diameter * self.random.between(0.7, 8.0);
            let (ea, normal, along) = (
                self.random.power(5.5, 9.0),
                self.random.between(0.3, 2.4),
                self.random.between(0.0, 0.5),
            );
            let damping = self.random.between(0.0, 0.5);
            self.wet_weights
                .push(9.8 * (mass - 805.0 * diameter * diameter));
            self.put(format_args!(
                "[materials.{name}]\ndiameter_m = {diameter:?}\nmass_kg_per_m = {mass:?}\nea_n = {ea:?}\n\
                 drag_normal = {normal:?}\ndrag_tangential = {along:?}\naxial_damping_ratio = {damping:?}\n"
            ));
        }
    }

    fn fixed(&mut self, name: &str, [x, y, z]: [f64; 3]) {
        self.put(format_args!(
            "[points.{name}]\nkind = \"fixed\"\nposition_m = [{x:?}, {y:?}, {z:?}]\n"
        ));
    }

    /// The keys of a motion in harmonics of up to this amplitude \[m\].
    fn motion(&mut self, most: f64) {
        let [a, b, c] = [(); 3].map(|()| self.random.between(-most, most));
        let (period, ramp) = (
            self.random.between(3.0, 15.0),
            self.random.between(0.0, 6.0),
        );
        let ramp = if ramp < 1.0 { 0.0 } else { ramp };
        self.put(format_args!(
            "amplitude_m = [{a:?}, {b:?}, {c:?}]\nramp_s = {ramp:?}\nperiod_s = "
        ));
        self.put(format_args!("{period:?}\n"));
    }

    fn moved(&mut self, name: &str, [x, y, z]: [f64; 3], most: f64) {
        self.put(format_args!(
            "[points.{name}]\nkind = \"moved\"\nposition_m = [{x:?}, {y:?}, {z:?}]\n"
        ));
        self.motion(most);
    }

    /// A junction, a clump or a buoy.
    fn free(&mut self, name: &str) {
        self.put(format_args!("[points.{name}]\nkind = \"free\"\n"));
        let draw = self.random.uniform();
        if draw < 0.3 {
            return;
        }
        let mass = self.random.power(1.0, 4.5);
        let volume = mass / 1025.0
            * if draw < 0.7 {
                0.2
            } else {
                self.random.between(1.2, 4.0)
            };
        let (added, area) = (
            500.0 * volume,
            self.random.between(0.0, 3.0) * volume.powf(2.0 / 3.0),
        );
        self.put(format_args!("mass_kg = {mass:?}\nvolume_m3 = {volume:?}\nadded_mass_kg = {added:?}\ndrag_area_m2 = {area:?}\n"));
    }

    /// A line between points that are so far apart, with more keys.
    fn line(&mut self, from: &str, to: &str, apart: f64, slack: f64, more: &str) {
        let material = ["one", "two", "three"][self.lines % 3];
        let (name, length) = (self.lines, (apart * slack).max(1.0));
        self.lines += 1;
        self.put(format_args!(
            "[[lines]]\nname = \"l{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"{material}\"\nlength_m = {length:?}\nsegments = 12\n{more}"
        ));
    }

    fn web(&mut self) {
        let depth = self.depth;
        let anchors = [[-0.6, -0.3, -0.9], [0.7, -0.2, -0.8], [0.0, 0.6, -0.95]];
        for (k, at) in anchors.into_iter().enumerate() {
            self.fixed(&format!("a{k}"), at.map(|c| c * depth));
        }
        self.moved("top", [0.0, 0.0, -0.05 * depth], 2.5);
        for name in ["f0", "f1"] {
            self.free(name);
        }
        let reach = 0.55 * depth;
        for (from, to, apart) in [
            ("a0", "f0", 1.2 * reach),
            ("a1", "f0", 1.2 * reach),
            ("a2", "f1", 1.3 * reach),
            ("f0", "f1", 0.5 * reach),
            ("f1", "top", reach),
        ] {
            let slack = self.random.between(0.98, 1.25);
            self.line(from, to, apart, slack, "");
        }
    }

    /// A body on three lines; a free one floats and has a fourth, to a point that moves.
    fn body(&mut self, kind: &str) {
        let depth = self.depth;
        self.body_of("hull", kind, 0.0);
        for k in 0..3 {
            let angle = std::f64::consts::TAU * k as f64 / 3.0;
            let (sin, cos) = angle.sin_cos();
            let far = self.random.between(1.0, 2.5) * depth;
            self.fixed(&format!("a{k}"), [far * cos, far * sin, -depth]);
            self.on(&format!("b{k}"), "hull", [8.0 * cos, 8.0 * sin, -5.0]);
            let slack = self.random.between(0.995, 1.1);
            self.line(
                &format!("a{k}"),
                &format!("b{k}"),
                (far - 8.0).hypot(depth - 5.0),
                slack,
                "",
            );
        }
        if kind == "free" {
            self.on("bow", "hull", [10.0, 0.0, -2.0]);
            self.moved("tug", [90.0, 5.0, -3.0], 3.0);
            let slack = self.random.between(0.99, 1.2);
            self.line("bow", "tug", 80.0, slack, "");
        }
    }

    fn on(&mut self, name: &str, body: &str, [x, y, z]: [f64; 3]) {
        self.put(format_args!("[points.{name}]\nkind = \"body\"\nbody = \"{body}\"\nposition_m = [{x:?}, {y:?}, {z:?}]\n"));
    }

    fn body_of(&mut self, name: &str, kind: &str, x: f64) {
        self.put(format_args!(
            "[bodies.{name}]\nkind = \"{kind}\"\nposition_m = [{x:?}, 0.0, 0.0]\n"
        ));
        if kind == "moved" {
            let [a, b, c] = [(); 3].map(|()| self.random.between(-6.0, 6.0));
            self.put(format_args!("amplitude_deg = [{a:?}, {b:?}, {c:?}]\n"));
            let [a, b, c] = [(); 3].map(|()| self.random.between(-2.5, 2.5));
            let period = self.random.between(4.0, 15.0);
            self.put(format_args!(
                "amplitude_m = [{a:?}, {b:?}, {c:?}]\nperiod_s = [{period:?}]\nramp_s = 4.0\n"
            ));
            return;
        }
        let mass = self.random.power(5.0, 7.0);
        let volume = mass / 1025.0 * self.random.between(1.0, 1.1);
        let spring = 1025.0 * 9.8 * (volume / 5.0);
        let (roll, inertia, damping) = (spring * 40.0, mass * 60.0, 0.1 * mass);
        self.put(format_args!(
            "mass_kg = {mass:?}\ninertia_kg_m2 = [{inertia:?}, {inertia:?}, {inertia:?}]\nvolume_m3 = {volume:?}\n\
             centre_of_gravity_m = [0.0, 0.0, -2.0]\ncentre_of_buoyancy_m = [0.0, 0.0, -2.5]\n\
             waterplane_stiffness = [0.0, 0.0, {spring:?}, {roll:?}, {roll:?}, 0.0]\n\
             added_mass = [{mass:?}, {mass:?}, {mass:?}, {inertia:?}, {inertia:?}, {inertia:?}]\n\
             damping = [{damping:?}, {damping:?}, {damping:?}, {inertia:?}, {inertia:?}, {inertia:?}]\n"
        ));
    }

    /// A clump on a wire that comes down along a table, with or without a tail.
    fn lowered(&mut self) {
        let depth = self.depth;
        let (length, speed) = (0.5 * depth, self.random.between(0.2, 3.0));
        let gap = self.random.between(0.0, 0.7 * speed * DURATION_S);
        let (top, low) = (length + gap - depth, -speed * DURATION_S);
        let (near, middle) = (0.1 * low, 0.5 * low);
        self.put(format_args!(
            "[points.crane]\nkind = \"moved\"\nposition_m = [0.0, 0.0, {top:?}]\ntable_time_s = [0.0, 2.0, 4.0, {DURATION_S:?}]\n\
             table_z_m = [0.0, {near:?}, {middle:?}, {low:?}]\nramp_s = 2.0\n"
        ));
        let (mass, tail) = (self.random.power(2.0, 4.5), self.random.uniform() < 0.5);
        let volume = 0.3 * mass / 1025.0;
        self.put(format_args!("[points.clump]\nkind = \"free\"\nmass_kg = {mass:?}\nvolume_m3 = {volume:?}\ndrag_area_m2 = 1.0\n"));
        self.line("clump", "crane", length, 1.0, "");
        if tail {
            self.put(format_args!("[points.tail]\nkind = \"free\"\n"));
            self.line("tail", "clump", 0.2 * depth, 1.0, "");
        }
    }

    /// A buoy or clump between an anchor and a moved top, with a side line that is let go or breaks.
    fn hung(&mut self, how: &str) {
        let depth = self.depth;
        self.moved("top", [0.0, 0.0, -5.0], 1.0);
        self.free("middle");
        self.fixed("low", [0.3 * depth, 0.0, -depth]);
        self.fixed("side", [-0.4 * depth, 0.1 * depth, -0.8 * depth]);
        let slack = self.random.between(0.97, 1.15);
        self.line("middle", "top", 0.5 * depth, slack, "");
        let slack = self.random.between(0.97, 1.15);
        self.line("low", "middle", 0.58 * depth, slack, "");
        let (end, when, share) = (
            self.random.uniform() < 0.5,
            self.random.between(0.5, 3.0),
            self.random.between(0.1, 0.9),
        );
        let more = match (how, end) {
            ("release", true) => format!("release_a_s = {when:?}\n"),
            ("release", false) => format!("release_b_n = {:?}\n", self.random.power(3.0, 5.0)),
            (_, true) => format!(
                "break_at_m = {:?}\nbreak_s = {when:?}\n",
                share * 0.5 * depth
            ),
            (_, false) => format!(
                "break_at_m = {:?}\nbreak_n = {:?}\n",
                share * 0.5 * depth,
                self.random.power(3.0, 5.0)
            ),
        };
        let slack = self.random.between(1.0, 1.3);
        self.line("side", "middle", 0.52 * depth, slack, &more);
    }

    fn shared(&mut self) {
        let (depth, apart) = (self.depth, self.random.between(60.0, 300.0));
        for (name, kind, side) in [("west", "moved", -1.0), ("east", "free", 1.0)] {
            self.body_of(name, kind, 0.5 * side * apart);
            for across in [-1.0, 1.0] {
                let word = if across < 0.0 { "s" } else { "n" };
                let (anchor, on) = (format!("{name}-a{word}"), format!("{name}-b{word}"));
                let x = 0.5 * side * apart;
                self.fixed(&anchor, [x + side * depth, across * depth, -depth]);
                self.on(&on, name, [6.0 * side, 6.0 * across, -5.0]);
                let slack = self.random.between(0.99, 1.1);
                self.line(
                    &anchor,
                    &on,
                    1.414_f64.mul_add(depth - 6.0, 0.0).hypot(depth - 5.0),
                    slack,
                    "",
                );
            }
            self.on(&format!("{name}-in"), name, [-6.0 * side, 0.0, -5.0]);
        }
        let slack = self.random.between(0.99, 1.2);
        self.line("west-in", "east-in", apart - 12.0, slack, "");
    }

    /// Two lines with a point between, slack enough to come taut with a snap.
    fn slack(&mut self) {
        let (x, z) = (
            self.random.between(5.0, 60.0),
            -self.random.between(10.0, 0.9 * self.depth),
        );
        self.moved("top", [x, 0.0, -5.0], 4.0);
        self.fixed("low", [0.0, 0.0, z]);
        self.free("middle");
        let apart = 0.5 * x.hypot(z + 5.0);
        for (from, to) in [("low", "middle"), ("middle", "top")] {
            let slack = self.random.between(1.0, 1.4);
            self.line(from, to, apart, slack, "");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Documents and findings name systems by seed and index.
    #[test]
    fn the_first_kinds_draw_what_they_drew() {
        let first = (0..2 * KINDS.len()).filter(|index| index % KINDS.len() < FIRST_KINDS);
        let streams: Vec<u64> = first.map(stream).collect();
        assert_eq!(streams, (0..16).collect::<Vec<u64>>());
    }
}
