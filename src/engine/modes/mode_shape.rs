//! Mode shapes: share of motion in the plane of the line, out of it and along the line, and half waves.

use std::ops::Range;

use nalgebra::{DMatrix, SymmetricEigen};

use super::{Eigenpair, ModePencil};
use crate::numerics::{M3, V3};

/// Relative distance below which eigenvalues count as equal, with arbitrary combinations of their vectors.
const SAME: f64 = 1e-6;
/// Share of the kinetic energy from which a mode is of a kind.
const MOSTLY: f64 = 0.9;
/// Displacements below this fraction of the greatest count as zero.
const FAINT: f64 = 0.02;
/// Displacements of lines below this share of those of what hangs on them are none.
const RESTS: f64 = 1e-9;

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

/// The inertia of what vibrates.
pub trait Inertia {
    /// `x' M y` of two displacements \[m\], \[rad\] \[kg m²\].
    fn mass_product(&self, x: &[V3], y: &[V3]) -> f64;

    /// The greatest ratio of stiffness to mass on the diagonal \[rad²/s²\]: of the order of the highest eigenvalue.
    fn highest(&self) -> f64;
}

impl Inertia for ModePencil {
    fn mass_product(&self, x: &[V3], y: &[V3]) -> f64 {
        Self::mass_product(self, x, y)
    }

    fn highest(&self) -> f64 {
        Self::highest(self)
    }
}

/// By what the kinds of modes are told apart: displacements are those of the nodes of lines, one line after the other, and then those of what
/// they hang on.
#[derive(Debug, Clone)]
pub struct ModeFrame {
    /// The plane nearest to the nodes of all lines.
    plane: LinePlane,
    /// The nodes of each line.
    lines: Vec<Range<usize>>,
    /// Unit vectors along the lines; zero where there is no one direction.
    tangents: Vec<V3>,
    /// The normal of the plane in the axes of what is a rotation.
    rotations: Vec<Option<V3>>,
}

impl ModeFrame {
    /// Of lines whose nodes rest at these places.
    #[must_use]
    pub fn of_lines(lines: &[&[V3]]) -> Self {
        let mut begin = 0;
        let ranges = lines.iter().map(|points| {
            let range = begin..begin + points.len();
            begin = range.end;
            range
        });
        let ranges = ranges.collect();
        Self {
            plane: LinePlane::nearest_to(&lines.concat()),
            lines: ranges,
            tangents: lines.iter().flat_map(|points| tangents(points)).collect(),
            rotations: vec![None; begin],
        }
    }

    /// Adds a displacement of what lines hang on, or a rotation of it along axes that are turned so from those of the earth; of one that
    /// moves along a line with the direction there.
    pub fn push(&mut self, axes: Option<M3>, along: Option<V3>) {
        self.tangents.push(along.unwrap_or_default());
        let normal = axes.map(|axes| axes.transpose() * self.plane.normal);
        self.rotations.push(normal);
    }

    /// Unit vector along a line at one of its nodes.
    #[must_use]
    pub fn tangent(&self, node: usize) -> V3 {
        self.tangents[node]
    }

    /// Nodes of all lines.
    fn nodes(&self) -> usize {
        self.lines.last().map_or(0, |last| last.end)
    }

    /// The part of a displacement across the plane; of a rotation that about axes in it, which moves what turns across it.
    fn out_of_plane(&self, place: usize, x: &V3) -> V3 {
        match &self.rotations[place] {
            Some(normal) => x - part(x, normal),
            None => part(x, &self.plane.normal),
        }
    }

    /// The part of a displacement along its line.
    fn along(&self, place: usize, x: &V3) -> V3 {
        part(x, &self.tangents[place])
    }

    /// Stretches of one sign of the line that a mode moves most.
    fn half_waves(&self, profile: &[f64]) -> usize {
        let lines = self.lines.iter().map(|line| &profile[line.clone()]);
        let most = lines.max_by(|a, b| greatest(a).total_cmp(&greatest(b)));
        most.map_or(0, half_waves)
    }
}

/// The greatest number by size.
fn greatest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, |m: f64, v| m.max(v.abs()))
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

/// A natural mode of a line, or of several with what they hang on.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// omega² \[rad²/s²\]; negative if the equilibrium is unstable, 0 without restoring force.
    pub eigenvalue: f64,
    /// Displacements of the nodes of the lines, one line after the other, the greatest of length 1; then of what they hang on \[m\], \[rad\].
    pub shape: Vec<V3>,
    /// The displacement of each node across its line, or along it for a mode along the line, signed: in the plane of the line, or out of
    /// it, whichever the mode does.
    pub profile: Vec<f64>,
    /// Share of the kinetic energy in motion out of the line's plane, 0 to 1.
    pub out_of_plane: f64,
    /// Share of the kinetic energy in motion along the line, 0 to 1.
    pub along: f64,
    /// Its predominant motion.
    pub kind: ModeKind,
    /// Number of half waves between nodes of the mode, on the line that it moves most.
    pub half_waves: usize,
}

impl Mode {
    /// Frequency \[Hz\]; of a mode that is not stable, minus its rate of growth by 2 pi.
    #[must_use]
    pub fn frequency_hz(&self) -> f64 {
        self.eigenvalue.abs().sqrt().copysign(self.eigenvalue) / std::f64::consts::TAU
    }
}

/// Describes eigenpairs.
#[must_use]
pub fn modes_of(inertia: &impl Inertia, frame: &ModeFrame, mut pairs: Vec<Eigenpair>) -> Vec<Mode> {
    let mut from = 0;
    while from < pairs.len() {
        let value = pairs[from].value;
        let same = |p: &&Eigenpair| p.value - value <= SAME * value.abs();
        let to = from + pairs[from..].iter().take_while(same).count();
        separate(inertia, frame, &mut pairs[from..to]);
        from = to;
    }
    // Slack line has no stiffness but rounding errors.
    let rounding = f64::EPSILON * inertia.highest();
    for pair in pairs.iter_mut().filter(|p| p.value.abs() < rounding) {
        pair.value = 0.0;
    }
    let describe = |pair| describe(inertia, frame, pair);
    pairs.into_iter().map(describe).collect()
}

/// Turns the vectors of one eigenvalue so that they lie in the plane or out of it, as far as they can.
fn separate(inertia: &impl Inertia, frame: &ModeFrame, pairs: &mut [Eigenpair]) {
    if pairs.len() < 2 {
        return;
    }
    let across = |v: &[V3]| -> Vec<V3> {
        let all = v.iter().enumerate();
        all.map(|(i, x)| frame.out_of_plane(i, x)).collect()
    };
    let parts: Vec<Vec<V3>> = pairs.iter().map(|p| across(&p.vector)).collect();
    let n = pairs.len();
    let out = DMatrix::from_fn(n, n, |a, b| inertia.mass_product(&parts[a], &parts[b]));
    let eigen = SymmetricEigen::new(out);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let places = pairs[0].vector.len();
    let turned: Vec<Vec<V3>> = order
        .iter()
        .map(|k| {
            let weights = eigen.eigenvectors.column(*k);
            let at = |i: usize| {
                let all = pairs.iter().zip(weights.iter());
                all.map(|(p, w)| p.vector[i] * *w).sum()
            };
            (0..places).map(at).collect()
        })
        .collect();
    for (pair, vector) in pairs.iter_mut().zip(turned) {
        pair.vector = vector;
    }
}

fn describe(inertia: &impl Inertia, frame: &ModeFrame, pair: Eigenpair) -> Mode {
    let whole = inertia.mass_product(&pair.vector, &pair.vector);
    let share = |part_of: &dyn Fn(usize, &V3) -> V3| {
        let all = pair.vector.iter().enumerate();
        let some: Vec<V3> = all.map(|(i, x)| part_of(i, x)).collect();
        inertia.mass_product(&some, &some) / whole
    };
    let out_of_plane = share(&|i, x| frame.out_of_plane(i, x));
    let along = share(&|i, x| frame.along(i, x));
    let kind = if out_of_plane > MOSTLY {
        ModeKind::OutOfPlane
    } else if along > MOSTLY {
        ModeKind::Along
    } else if out_of_plane < 1.0 - MOSTLY {
        ModeKind::InPlane
    } else {
        ModeKind::Mixed
    };
    let normal = frame.plane.normal;
    let across = |i: usize| match kind {
        ModeKind::OutOfPlane => normal,
        ModeKind::Along => frame.tangents[i],
        ModeKind::InPlane => normal.cross(&frame.tangents[i]),
        ModeKind::Mixed if out_of_plane > 0.5 => normal,
        ModeKind::Mixed => normal.cross(&frame.tangents[i]),
    };
    let mut shape = pair.vector;
    let of_nodes = &shape[..frame.nodes()];
    let size = |some: &[V3]| some.iter().map(V3::norm).fold(0.0, f64::max);
    // Where the lines rest, what hangs on them is the measure.
    let greatest = match size(of_nodes) {
        little if little < RESTS * size(&shape) => size(&shape),
        greatest => greatest,
    };
    let profile = of_nodes.iter().enumerate();
    let mut profile: Vec<f64> = profile.map(|(i, x)| x.dot(&across(i))).collect();
    // The same way up every time: what moves first from end A moves to the positive side.
    let strong = self::greatest(&profile);
    let first = profile.iter().find(|v| v.abs() > 0.5 * strong);
    let scale = first.map_or(1.0, |v| v.signum()) / greatest.max(f64::MIN_POSITIVE);
    shape.iter_mut().for_each(|x| *x *= scale);
    profile.iter_mut().for_each(|v| *v *= scale);
    Mode {
        eigenvalue: pair.value,
        half_waves: frame.half_waves(&profile),
        shape,
        profile,
        out_of_plane,
        along,
        kind,
    }
}

/// Stretches of one sign.
fn half_waves(profile: &[f64]) -> usize {
    let faint = FAINT * greatest(profile);
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
