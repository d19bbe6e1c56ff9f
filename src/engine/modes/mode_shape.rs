//! Mode shapes: share of motion in the plane of the line, out of it and along the line, and half waves.

use nalgebra::{DMatrix, SymmetricEigen};

use super::{Eigenpair, ModePencil};
use crate::numerics::{M3, V3};

/// Relative distance below which eigenvalues count as equal, with arbitrary combinations of their vectors.
const SAME: f64 = 1e-6;
/// Share of the kinetic energy from which a mode is of a kind.
const MOSTLY: f64 = 0.9;
/// Displacements below this fraction of the greatest count as zero.
const FAINT: f64 = 0.02;

/// The plane of a line at rest, or the nearest to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePlane {
    /// Its unit normal.
    pub normal: V3,
}

impl LinePlane {
    /// The plane nearest to these points; of a straight line the upright one, of an upright line that of x and z.
    #[must_use]
    pub fn nearest_to(points: &[V3]) -> Self {
        let middle = points.iter().sum::<V3>() / points.len().max(1) as f64;
        let spread: M3 = points
            .iter()
            .map(|p| (p - middle) * (p - middle).transpose())
            .sum();
        let eigen = SymmetricEigen::new(spread);
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        let [least, second, most] = order;
        let column = |i: usize| eigen.eigenvectors.column(i).into_owned();
        // Spreads are squares: 1e-14 is a bow of 1e-7 of the length.
        if eigen.eigenvalues[second] > 1e-14 * eigen.eigenvalues[most] {
            let normal = column(least);
            // One of the two signs, the same every time.
            let positive = normal[normal.iamax()] > 0.0;
            return Self {
                normal: if positive { normal } else { -normal },
            };
        }
        let across = column(most).cross(&V3::z());
        Self {
            normal: across.try_normalize(1e-6).unwrap_or_else(V3::y),
        }
    }
}

impl LinePlane {
    /// Unit vectors across a line through these points, in the plane.
    #[must_use]
    pub fn across(&self, points: &[V3]) -> Vec<V3> {
        let across = |t: V3| self.normal.cross(&t).try_normalize(0.0).unwrap_or_default();
        tangents(points).into_iter().map(across).collect()
    }
}

/// The kind of a mode, by its predominant motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModeKind {
    /// Moves across the line in its plane.
    InPlane,
    /// Moves across the plane of the line.
    OutOfPlane,
    /// Stretches the line along itself.
    Along,
    /// Several of these.
    Mixed,
}

impl ModeKind {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::InPlane => "in plane",
            Self::OutOfPlane => "out of plane",
            Self::Along => "along the line",
            Self::Mixed => "mixed",
        }
    }
}

/// A natural mode of a line.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// omega² \[rad²/s²\]; negative if the equilibrium is unstable, 0 without restoring force.
    pub eigenvalue: f64,
    /// Displacements of the nodes, the greatest of length 1.
    pub shape: Vec<V3>,
    /// The displacement across the line, or along it for a mode along the line, signed: in the plane of the line, or out of
    /// it, whichever the mode does.
    pub profile: Vec<f64>,
    /// Share of the kinetic energy in motion out of the line's plane, 0 to 1.
    pub out_of_plane: f64,
    /// Share of the kinetic energy in motion along the line, 0 to 1.
    pub along: f64,
    /// Its predominant motion.
    pub kind: ModeKind,
    /// Number of half waves between nodes of the mode.
    pub half_waves: usize,
}

impl Mode {
    /// Frequency \[Hz\]; of a mode that is not stable, minus its rate of growth by 2 pi.
    #[must_use]
    pub fn frequency_hz(&self) -> f64 {
        self.eigenvalue.abs().sqrt().copysign(self.eigenvalue) / std::f64::consts::TAU
    }
}

/// Describes eigenpairs of a line whose nodes lie at these points.
#[must_use]
pub fn modes_of(pencil: &ModePencil, points: &[V3], mut pairs: Vec<Eigenpair>) -> Vec<Mode> {
    let plane = LinePlane::nearest_to(points);
    let tangents = tangents(points);
    let mut from = 0;
    while from < pairs.len() {
        let value = pairs[from].value;
        let same = |p: &&Eigenpair| p.value - value <= SAME * value.abs();
        let to = from + pairs[from..].iter().take_while(same).count();
        separate(pencil, &plane, &mut pairs[from..to]);
        from = to;
    }
    // Slack line has no stiffness but rounding errors.
    let rounding = f64::EPSILON * pencil.highest();
    for pair in pairs.iter_mut().filter(|p| p.value.abs() < rounding) {
        pair.value = 0.0;
    }
    let describe = |pair| describe(pencil, &plane, &tangents, pair);
    pairs.into_iter().map(describe).collect()
}

/// Turns the vectors of one eigenvalue so that they lie in the plane or out of it, as far as they can.
fn separate(pencil: &ModePencil, plane: &LinePlane, pairs: &mut [Eigenpair]) {
    if pairs.len() < 2 {
        return;
    }
    let across = |v: &[V3]| -> Vec<V3> { v.iter().map(|x| part(x, &plane.normal)).collect() };
    let parts: Vec<Vec<V3>> = pairs.iter().map(|p| across(&p.vector)).collect();
    let n = pairs.len();
    let out = DMatrix::from_fn(n, n, |a, b| pencil.mass_product(&parts[a], &parts[b]));
    let eigen = SymmetricEigen::new(out);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let nodes = pencil.nodes();
    let turned: Vec<Vec<V3>> = order
        .iter()
        .map(|k| {
            let weights = eigen.eigenvectors.column(*k);
            let at = |i: usize| {
                let all = pairs.iter().zip(weights.iter());
                all.map(|(p, w)| p.vector[i] * *w).sum()
            };
            (0..nodes).map(at).collect()
        })
        .collect();
    for (pair, vector) in pairs.iter_mut().zip(turned) {
        pair.vector = vector;
    }
}

fn describe(pencil: &ModePencil, plane: &LinePlane, tangents: &[V3], pair: Eigenpair) -> Mode {
    let whole = pencil.mass_product(&pair.vector, &pair.vector);
    let share = |directions: &dyn Fn(usize) -> V3| {
        let vector = &pair.vector;
        let some: Vec<V3> = (0..vector.len())
            .map(|i| part(&vector[i], &directions(i)))
            .collect();
        pencil.mass_product(&some, &some) / whole
    };
    let out_of_plane = share(&|_| plane.normal);
    let along = share(&|i| tangents[i]);
    let kind = if out_of_plane > MOSTLY {
        ModeKind::OutOfPlane
    } else if along > MOSTLY {
        ModeKind::Along
    } else if out_of_plane < 1.0 - MOSTLY {
        ModeKind::InPlane
    } else {
        ModeKind::Mixed
    };
    let across = |i: usize| match kind {
        ModeKind::OutOfPlane => plane.normal,
        ModeKind::Along => tangents[i],
        ModeKind::InPlane => plane.normal.cross(&tangents[i]),
        ModeKind::Mixed if out_of_plane > 0.5 => plane.normal,
        ModeKind::Mixed => plane.normal.cross(&tangents[i]),
    };
    let greatest = pair.vector.iter().map(V3::norm).fold(0.0, f64::max);
    let mut shape = pair.vector;
    let mut profile: Vec<f64> = shape
        .iter()
        .enumerate()
        .map(|(i, x)| x.dot(&across(i)))
        .collect();
    // The same way up every time: what moves first from end A moves to the positive side.
    let strong = profile
        .iter()
        .copied()
        .fold(0.0, |m: f64, v| m.max(v.abs()));
    let first = profile.iter().find(|v| v.abs() > 0.5 * strong);
    let scale = first.map_or(1.0, |v| v.signum()) / greatest.max(f64::MIN_POSITIVE);
    shape.iter_mut().for_each(|x| *x *= scale);
    profile.iter_mut().for_each(|v| *v *= scale);
    Mode {
        eigenvalue: pair.value,
        half_waves: half_waves(&profile),
        shape,
        profile,
        out_of_plane,
        along,
        kind,
    }
}

/// Stretches of one sign.
fn half_waves(profile: &[f64]) -> usize {
    let faint = FAINT
        * profile
            .iter()
            .copied()
            .fold(0.0, |m: f64, v| m.max(v.abs()));
    let mut signs = profile.iter().filter(|v| v.abs() > faint).map(|v| *v > 0.0);
    let Some(mut now) = signs.next() else {
        return 0;
    };
    let mut count = 1;
    for sign in signs {
        count += usize::from(sign != now);
        now = sign;
    }
    count
}

/// The part of a vector along a unit one.
fn part(x: &V3, direction: &V3) -> V3 {
    direction * direction.dot(x)
}

/// Unit tangents at the nodes: of the chord between both neighbours, or to the one there is.
fn tangents(points: &[V3]) -> Vec<V3> {
    let last = points.len().saturating_sub(1);
    let at = |i: usize| {
        let chord = points[(i + 1).min(last)] - points[i.saturating_sub(1)];
        chord.try_normalize(0.0).unwrap_or_else(V3::z)
    };
    (0..points.len()).map(at).collect()
}
