//! Lengths of lines that are unknowns: of a winch, or of a point that slides. Each is one number more beside the rows of the joints.
//!
//! With the system without them factored, `M y = r` and the column `M Y = b` of each, the lengths are those of
//! `(s - c' Y) p = r_p - c' y`, and what is left `y - Y p`.

use super::joints::Role;
use super::line_ends::LineEnds;
use super::moving_system::MovingSystem;
use super::payout::{Drive, PaidEnd, Payout, PointFriction};
use super::system_state::SystemState;
use crate::numerics::{BlockBand, BlockEnvelope, Condensation, V3};
use crate::scene::DrumPull;
use crate::scene::EnergyRates;
use crate::solve::Factors;

/// A length of line that is an unknown, and its work arrays.
#[derive(Debug, Clone)]
pub(super) struct DrivenPayout {
    number: usize,
    joint: usize,
    /// What the system makes of a unit of it: of the lines and the joints.
    lines: Vec<Vec<V3>>,
    joints: Vec<V3>,
    equation: Equation,
    /// Row of the small system: coefficients, and right-hand side.
    row: Vec<f64>,
    right: f64,
    /// Whether the displacement was cut short.
    cut: bool,
}

/// The equation of the length, linearised.
#[derive(Debug, Clone, Copy, Default)]
struct Equation {
    residual: f64,
    by_length: f64,
    /// Derivatives by the end node and its neighbour, of one line or of the two at a point.
    by_nodes: [[V3; 2]; 2],
    /// Derivatives of the residuals of these nodes by the length.
    of_nodes: [[V3; 2]; 2],
    /// Friction, and the force of the drive of a winch \[N\].
    friction: f64,
    drive: f64,
    /// Friction of full sliding \[N\].
    full: f64,
    /// The rate \[m/s\] at which these are, and their slope by it \[N s/m\].
    rate: f64,
    slope: f64,
    /// Stiffness of the segments beside it \[N/m\].
    stiffness: f64,
}

/// No derivatives.
const FORCES: Factors = Factors {
    mass: 0.0,
    damping: 0.0,
    stiffness: 0.0,
};

/// The factored lines and joints.
pub(super) struct BorderedLines<'a> {
    pub(super) tangents: &'a [BlockBand],
    pub(super) condensations: &'a mut [Condensation],
    pub(super) matrix: &'a BlockEnvelope,
    /// Storage of the rows.
    pub(super) rows: &'a mut [V3],
}

/// The unknown lengths of a system.
pub(super) fn driven(system: &MovingSystem, state: &SystemState) -> Vec<DrivenPayout> {
    let payouts = system.network.payouts.iter().enumerate();
    let free: Vec<usize> = payouts
        .filter_map(|(number, payout)| payout.drive.is_free().then_some(number))
        .collect();
    let nodes = || {
        state
            .lines
            .iter()
            .map(|line| vec![V3::zeros(); line.x.len()])
    };
    let of = |number: &usize| DrivenPayout {
        number: *number,
        joint: system.joints.payouts[*number],
        lines: nodes().collect(),
        joints: vec![V3::zeros(); state.joints.x.len()],
        equation: Equation::default(),
        row: vec![0.0; free.len()],
        right: 0.0,
        cut: false,
    };
    free.iter().map(of).collect()
}

/// Solves for them, and takes what follows from the displacements of lines and joints.
pub(super) fn solve(
    at: (&MovingSystem, &SystemState),
    (t, c): (f64, Factors),
    driven: &mut [DrivenPayout],
    mut work: BorderedLines<'_>,
    (lines, joints): (&mut [Vec<V3>], &mut [V3]),
) {
    if driven.is_empty() || at.0.payouts.iter().any(|payout| payout.holding.is_none()) {
        return;
    }
    for one in driven.iter_mut() {
        one.equation = Equation::of_payout(at, one.number, (t, c));
        one.respond(at, c.stiffness, &mut work);
    }
    for k in 0..driven.len() {
        for l in 0..driven.len() {
            driven[k].row[l] = -driven[k].along(at, &driven[l].lines);
        }
        driven[k].row[k] += driven[k].equation.by_length;
        driven[k].right = driven[k].equation.residual - driven[k].along(at, lines);
    }
    eliminate(driven);
    for one in driven.iter_mut() {
        one.stop_at_corner(at.0, c);
    }
    for one in driven.iter() {
        let p = one.right;
        let mine = one.lines.iter().chain(std::iter::once(&one.joints));
        let all = lines
            .iter_mut()
            .map(Vec::as_mut_slice)
            .chain(std::iter::once(&mut *joints));
        for (found, mine) in all.zip(mine) {
            for (d, y) in found.iter_mut().zip(mine) {
                *d -= y * p;
            }
        }
    }
    for one in driven.iter() {
        joints[one.joint] = V3::new(one.right, 0.0, 0.0);
    }
}

/// The pull of each payout at rest, which is what holds it there \[N\]; none of those that are prescribed.
pub(super) fn holding(system: &MovingSystem, state: &SystemState) -> Vec<f64> {
    let payouts = system.network.payouts.iter().enumerate();
    let pull = |(number, payout): (usize, &Payout)| match payout.drive.is_free() {
        true => Equation::of_payout((system, state), number, (0.0, FORCES)).residual,
        false => 0.0,
    };
    payouts.map(pull).collect()
}

/// Energy and powers of winches and of points that slide; the lines are apart.
pub(super) fn drives(
    system: &MovingSystem,
    t: f64,
    state: &SystemState,
) -> impl Iterator<Item = EnergyRates> {
    let payouts = system.network.payouts.iter().enumerate();
    let free = payouts.filter(|(_, payout)| payout.drive.is_free());
    free.map(move |(number, payout)| {
        let equation = Equation::of_payout((system, state), number, (t, FORCES));
        let joint = system.joints.payouts[number];
        let q = state.joints.v[joint].x;
        let ends = payout.ends.iter().map(|PaidEnd { line, end, sign }| {
            let scene = system.scene(*line, state);
            sign * scene.drum_now(*end, t, &state.lines[*line])
        });
        let of_lines: f64 = ends.sum();
        let held = system.payouts[number].holding.unwrap_or(0.0) * payout.drive.held(t);
        let force = equation.force() - state.drive_excess[number];
        let (mass, drive, friction) = match &payout.drive {
            Drive::Winch(winch) => (winch.mass, force, 0.0),
            _ => (0.0, 0.0, force),
        };
        EnergyRates {
            energy: 0.5 * mass * q * q,
            kinetic: 0.5 * mass * q * q,
            // The drum and what drives it, which the equation leaves of the pull of the line.
            supplied: q * (held - drive - of_lines),
            dissipated: q * friction,
            ..EnergyRates::default()
        }
    })
}

/// Finds by how much the forces of drives and friction at the end of a step exceed those that mix with the ones before to what the
/// balance between had: they are steep, and the rate at the end is off that of the balance by a share of its change.
pub(super) fn correct_drives(
    system: &MovingSystem,
    share: f64,
    (before, between): (&SystemState, &SystemState),
    end: &mut SystemState,
) {
    for (number, payout) in system.network.payouts.iter().enumerate() {
        if payout.drive.is_free() {
            let law = |state| Equation::of_payout((system, state), number, (0.0, FORCES)).force();
            let known = law(before) - before.drive_excess[number];
            let carried = (law(between) - share * known) / (1.0 - share);
            end.drive_excess[number] = law(end) - carried;
        }
    }
}

/// Gaussian elimination with pivots by size; the right-hand sides become the solution.
fn eliminate(rows: &mut [DrivenPayout]) {
    let n = rows.len();
    for k in 0..n {
        let size = |row: &DrivenPayout| row.row[k].abs();
        let best = (k..n).max_by(|a, b| size(&rows[*a]).total_cmp(&size(&rows[*b])));
        if let Some(best) = best.filter(|best| *best != k) {
            let (upper, lower) = rows.split_at_mut(best);
            std::mem::swap(&mut upper[k].row, &mut lower[0].row);
            std::mem::swap(&mut upper[k].right, &mut lower[0].right);
        }
        let (upper, lower) = rows.split_at_mut(k + 1);
        let pivot = &upper[k];
        for row in lower {
            let factor = row.row[k] / pivot.row[k];
            for (entry, by) in row.row.iter_mut().zip(&pivot.row).skip(k) {
                *entry -= factor * by;
            }
            row.right -= factor * pivot.right;
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|l| rows[k].row[l] * rows[l].right).sum();
        rows[k].right = (rows[k].right - known) / rows[k].row[k];
    }
}

impl Equation {
    /// Force of drive and friction \[N\].
    fn force(&self) -> f64 {
        self.drive + self.friction
    }

    /// The pulls of its ends, and what drives it.
    fn of_payout(
        (system, state): (&MovingSystem, &SystemState),
        number: usize,
        (t, c): (f64, Factors),
    ) -> Self {
        let payout = &system.network.payouts[number];
        let mut equation = Self::default();
        let mut across = [DrumPull::default(); 2];
        for (k, PaidEnd { line, end, sign }) in payout.ends.iter().enumerate() {
            let scene = system.scene(*line, state);
            let Some((drum, of_nodes)) = scene.drum(*end, t, &state.lines[*line], c) else {
                continue;
            };
            let segments = &scene.line.segments;
            equation.stiffness += segments[end * (segments.len() - 1)].axial.stiffness();
            equation.residual += sign * drum.residual;
            equation.by_length += drum.by_length;
            equation.by_nodes[k] = [drum.by_end, drum.by_neighbour].map(|by| by * *sign);
            equation.of_nodes[k] = of_nodes.map(|of| of * *sign);
            across[k] = DrumPull {
                pull_by_length: drum.pull_by_length * *sign,
                ..drum
            };
        }
        let joint = system.joints.payouts[number];
        let (rate, acceleration) = (state.joints.v[joint].x, state.joints.a[joint].x);
        equation.rate = rate;
        match &payout.drive {
            Drive::Winch(winch) => {
                let (force, slope) = winch.force(rate);
                (equation.drive, equation.slope) = (force, slope);
                equation.residual += winch.mass * acceleration + force;
                equation.by_length += winch.mass * c.mass + slope * c.damping;
            }
            Drive::Slide(friction) => equation.rub(friction, rate, &across, c),
            Drive::Rate(_) | Drive::Table(_) => {}
        }
        let held = system.payouts[number].holding.unwrap_or(0.0);
        equation.residual -= held * payout.drive.held(t);
        equation
    }

    /// Adds the friction on a point that slides between these pulls.
    fn rub(&mut self, friction: &PointFriction, rate: f64, pulls: &[DrumPull; 2], c: Factors) {
        let force = pulls[0].pull + pulls[1].pull;
        let (size, coefficient) = (force.norm(), friction.coefficient);
        let (share, slope) = PointFriction::share(rate);
        let full = friction.constant + coefficient * size;
        (self.full, self.slope) = (full, full * slope);
        self.friction = full * share;
        self.residual += self.friction;
        self.by_length += full * slope * c.damping;
        if size > 0.0 && coefficient > 0.0 {
            let by = force * (coefficient * share / size);
            for (pull, [end, neighbour]) in pulls.iter().zip(&mut self.by_nodes) {
                self.by_length += by.dot(&pull.pull_by_length);
                let change = pull.pull_by_neighbour.transpose() * by;
                *end -= change;
                *neighbour += change;
            }
        }
    }
}

impl DrivenPayout {
    /// Cuts the displacement short where the force of the drive has a corner on its way.
    fn stop_at_corner(&mut self, system: &MovingSystem, c: Factors) {
        let (from, wanted) = (self.equation.rate, self.right);
        let to = from - wanted * c.damping;
        let reached = system.network.payouts[self.number].drive.towards(from, to);
        self.cut = reached != to;
        if self.cut {
            self.right = wanted * (reached - from) / (to - from);
        }
    }

    /// Stretch of the segments beside it \[m\] by the force of drive or friction that the displacement just made did not count with: a
    /// brake, and friction about rest, change by all they have over a rate that is a small displacement in a step. Infinite where it was cut
    /// short.
    pub(super) fn missed(&self, system: &MovingSystem, c: Factors) -> f64 {
        if self.cut {
            return f64::INFINITY;
        }
        let by = &self.equation;
        let change = -self.right * c.damping;
        let force = match &system.network.payouts[self.number].drive {
            Drive::Winch(winch) => winch.force(by.rate + change).0,
            Drive::Slide(_) => by.full * PointFriction::share(by.rate + change).0,
            Drive::Rate(_) | Drive::Table(_) => 0.0,
        };
        (force - by.force() - by.slope * change).abs() / by.stiffness
    }

    /// What the lines and joints make of a unit of this length.
    fn respond(
        &mut self,
        at: (&MovingSystem, &SystemState),
        stiffness: f64,
        work: &mut BorderedLines<'_>,
    ) {
        let (system, state) = at;
        let payout = &system.network.payouts[self.number];
        work.rows.fill(V3::zeros());
        for line in &mut self.lines {
            line.fill(V3::zeros());
        }
        for (k, paid) in payout.ends.iter().enumerate() {
            for (node, of) in nodes(paid, self.lines[paid.line].len())
                .into_iter()
                .zip(self.equation.of_nodes[k])
            {
                self.lines[paid.line][node] += of;
            }
        }
        let own = |line: usize| payout.ends.iter().any(|paid| paid.line == line);
        for (line, load) in self.lines.iter().enumerate().filter(|(line, _)| own(*line)) {
            // It was condensed a moment ago, with another load.
            let ends = LineEnds::of_line(system, state, line);
            let couplings = ends.couplings(stiffness);
            let band = &work.tangents[line];
            let condensed =
                work.condensations[line].condense_beside(band, load, couplings.as_ref());
            if let Ok(condensed) = condensed {
                ends.add(&condensed.left, work.rows);
            }
        }
        work.matrix.solve_again(work.rows);
        for (joint, out) in self.joints.iter_mut().enumerate() {
            let row = system.joints.row(joint);
            let row = row.filter(|_| !matches!(system.joints.roles[joint], Role::Payout(_)));
            *out = row.map_or_else(V3::zeros, |row| work.rows[row]);
        }
        for (line, x) in self.lines.iter_mut().enumerate() {
            if system.is_plain(state, line) {
                continue;
            }
            let ends = LineEnds::of_line(system, state, line);
            ends.respond(work.rows, &work.condensations[line], x, own(line));
        }
    }

    /// The change of its equation with displacements of the lines.
    fn along(&self, (system, _): (&MovingSystem, &SystemState), lines: &[Vec<V3>]) -> f64 {
        let ends = system.network.payouts[self.number].ends.iter();
        ends.zip(&self.equation.by_nodes)
            .map(|(paid, by)| {
                let d = &lines[paid.line];
                let nodes = nodes(paid, d.len());
                by[0].dot(&d[nodes[0]]) + by[1].dot(&d[nodes[1]])
            })
            .sum()
    }
}

/// The end node of a line of so many nodes that is paid out, and its neighbour.
fn nodes(paid: &PaidEnd, count: usize) -> [usize; 2] {
    [[0, 1], [count - 1, count - 2]][paid.end]
}
